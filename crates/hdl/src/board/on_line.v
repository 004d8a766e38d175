// The core at the end of a serial line.
module @ON_LINE@(clock, reset, rx, tx, deaf, waits, interrupt);
    // Clocks of a bit on the line, at least 4.
    parameter [15:0] CLOCKS = 16'd4;
    input wire clock;
    input wire reset;
    // From the host, and to it; 1 at rest.
    input wire rx;
    output wire tx;
    // The bridge drops frames up to a sync.
    output wire deaf;
    // A word waits for the core.
    output wire waits;
    output wire interrupt;

    wire in_valid;
    wire [7:0] in_data;
    wire in_broken;
    @TOP@_uart_receiver #(.CLOCKS(CLOCKS)) receiver(.clock(clock), .line(rx),
        .byte_valid(in_valid), .byte_data(in_data), .byte_broken(in_broken));

    wire room;
    wire write;
    wire [7:0] write_data;
    wire keep;
    wire revert;
    wire sync;
    wire sync_begins;
    wire [7:0] sync_token;
    wire error;
    wire [7:0] error_cause;
    wire [7:0] expected;
    @TOP@_frames_in frames_in(.clock(clock), .reset(reset), .byte_valid(in_valid), .byte_data(in_data), .byte_broken(in_broken),
        .room(room), .write(write), .write_data(write_data), .keep(keep), .revert(revert),
        .sync(sync), .sync_begins(sync_begins), .sync_token(sync_token),
        .error(error), .error_cause(error_cause), .expected(expected), .deaf(deaf));

    // A session that begins resets all that is behind the line.
    wire clear = reset | (sync & sync_begins);
    wire read_valid;
    wire read_ready;
    wire [7:0] read_data;
    @TOP@_buffer buffer(.clock(clock), .clear(clear), .room(room), .write(write), .write_data(write_data),
        .keep(keep), .revert(revert), .read_valid(read_valid), .read_ready(read_ready), .read_data(read_data));

    wire [15:0] taken;
    wire photons_valid;
    wire photons_ready;
    wire queries_valid;
    wire queries_ready;
    wire [@IN_HIGH@:0] payload;
    wire write_valid;
    wire write_ready;
    wire write_data_ready;
    wire write_answer_valid;
    wire [1:0] write_answer;
    wire write_answer_ready;
    wire fetch_valid;
    wire fetch_ready;
    wire fetch_answer_valid;
    wire [1:0] fetch_answer;
    wire [31:0] fetch_word;
    wire fetch_answer_ready;
    wire answer_valid;
    wire answer_ready;
    wire answer_is_read;
    wire [39:0] answer;
    // The core is ready for an address and its word in the same clock.
    wire write_is_ready = write_ready & write_data_ready;
    @TOP@_dispatch dispatch(.clock(clock), .reset(clear), .read_valid(read_valid), .read_ready(read_ready), .read_data(read_data),
        .taken(taken), .photons_valid(photons_valid), .photons_ready(photons_ready),
        .queries_valid(queries_valid), .queries_ready(queries_ready), .payload(payload),
        .write_valid(write_valid), .write_ready(write_is_ready), .write_answer_valid(write_answer_valid),
        .write_answer(write_answer), .write_answer_ready(write_answer_ready),
        .fetch_valid(fetch_valid), .fetch_ready(fetch_ready), .fetch_answer_valid(fetch_answer_valid),
        .fetch_answer(fetch_answer), .fetch_word(fetch_word), .fetch_answer_ready(fetch_answer_ready),
        .answer_valid(answer_valid), .answer_ready(answer_ready), .answer_is_read(answer_is_read), .answer(answer));

    wire [@RESULT_TOP@:0] result_data;
    wire result_valid;
    wire result_ready;
    wire result_last;
    wire [@CHAIN_HIGH@:0] result_chain;
    wire result_outside;
    wire [@RESULT_HIGH@:0] result = {result_data[@RESULT_DATA@:0], @RESULT_MARK@};
    wire out_valid;
    wire out_ready;
    wire [7:0] out_data;
    @TOP@_frames_out frames_out(.clock(clock), .sync(sync), .sync_begins(sync_begins), .sync_token(sync_token),
        .error(error), .error_cause(error_cause), .expected(expected), .taken(taken),
        .answer_valid(answer_valid), .answer_ready(answer_ready), .answer_is_read(answer_is_read), .answer(answer),
        .result_valid(result_valid), .result_ready(result_ready), .result(result),
        .byte_valid(out_valid), .byte_ready(out_ready), .byte_data(out_data));
    @TOP@_uart_transmitter #(.CLOCKS(CLOCKS)) transmitter(.clock(clock), .byte_valid(out_valid), .byte_ready(out_ready),
        .byte_data(out_data), .line(tx));

    assign waits = (photons_valid & ~photons_ready) | (queries_valid & ~queries_ready);
    @TOP@ core(.aclk(clock), .aresetn(~clear),
@PHOTONS@        .s_axis_photons_tvalid(photons_valid), .s_axis_photons_tready(photons_ready),
@QUERIES@        .s_axis_queries_tvalid(queries_valid), .s_axis_queries_tready(queries_ready),
        .m_axis_results_tdata(result_data), .m_axis_results_tvalid(result_valid), .m_axis_results_tready(result_ready),
        .m_axis_results_tlast(result_last), .m_axis_results_tid(result_chain), .m_axis_results_tuser(result_outside),
        .s_axi_awaddr(@WRITE_ADDRESS@), .s_axi_awprot(3'd0), .s_axi_awvalid(write_valid), .s_axi_awready(write_ready),
        .s_axi_wdata(@WRITE_WORD@), .s_axi_wstrb(4'd15), .s_axi_wvalid(write_valid), .s_axi_wready(write_data_ready),
        .s_axi_bresp(write_answer), .s_axi_bvalid(write_answer_valid), .s_axi_bready(write_answer_ready),
        .s_axi_araddr(@READ_ADDRESS@), .s_axi_arprot(3'd0), .s_axi_arvalid(fetch_valid), .s_axi_arready(fetch_ready),
        .s_axi_rdata(fetch_word), .s_axi_rresp(fetch_answer), .s_axi_rvalid(fetch_answer_valid), .s_axi_rready(fetch_answer_ready),
        .irq(interrupt));
endmodule
