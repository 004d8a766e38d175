// The registers of the core, behind AXI4-Lite, and its counters.
module @TOP@_registers(clock, aresetn, reset,
    s_axi_awaddr, s_axi_awvalid, s_axi_awready, s_axi_wdata, s_axi_wstrb, s_axi_wvalid, s_axi_wready,
    s_axi_bresp, s_axi_bvalid, s_axi_bready, s_axi_araddr, s_axi_arvalid, s_axi_arready,
    s_axi_rdata, s_axi_rresp, s_axi_rvalid, s_axi_rready, irq,
    photon_moves, photon_waits, query_moves, query_waits, result_moves, result_waits, result_photons,
    leaf_given, leaf_refused, leaf_malformed, set_too_long, query_given, query_refused, query_outside,
    chain_unknown, compared, wanted, played@ROUND_PORTS@);
    input wire clock;
    input wire aresetn;
    output reg reset;
    input wire [@ADDRESS_HIGH@:0] s_axi_awaddr;
    input wire s_axi_awvalid;
    output wire s_axi_awready;
    input wire [31:0] s_axi_wdata;
    input wire [3:0] s_axi_wstrb;
    input wire s_axi_wvalid;
    output wire s_axi_wready;
    output reg [1:0] s_axi_bresp;
    output reg s_axi_bvalid;
    input wire s_axi_bready;
    input wire [@ADDRESS_HIGH@:0] s_axi_araddr;
    input wire s_axi_arvalid;
    output wire s_axi_arready;
    output reg [31:0] s_axi_rdata;
    output reg [1:0] s_axi_rresp;
    output reg s_axi_rvalid;
    input wire s_axi_rready;
    output wire irq;
    // What happens in this clock.
    input wire photon_moves;
    input wire photon_waits;
    input wire query_moves;
    input wire query_waits;
    input wire result_moves;
    input wire result_waits;
    input wire [@COUNT_HIGH@:0] result_photons;
    input wire leaf_given;
    input wire leaf_refused;
    input wire leaf_malformed;
    input wire set_too_long;
    input wire query_given;
    input wire query_refused;
    input wire query_outside;
    input wire chain_unknown;
    input wire [@LEAVES_HIGH@:0] compared;
    input wire [@LEAVES_HIGH@:0] wanted;
    input wire [@GROUPS_HIGH@:0] played;@ROUND_DECLARATIONS@
    // The addresses, in bytes.
@ADDRESSES@
    localparam OKAY = 2'b00;
    localparam SLVERR = 2'b10;
@COUNTERS@
    reg [@EVENT_HIGH@:0] events;
    reg [@EVENT_HIGH@:0] interrupt_enable;
    reg [31:0] stall_limit;
    reg [@UNDER_WAY_HIGH@:0] under_way;
    // Whether a query was given and a last result left in the clock before: the ways to the number of queries under way are too far for one clock.
    reg query_came;
    reg result_went;
    // Whether the clock before was silent, and the number of silent clocks up to the one before that.
    reg seen_silent;
    reg [31:0] silent_clocks;
    // Whether a read was taken in the clock before, and which register has its address.
    reg reading;
    reg [@SELECTED_HIGH@:0] selected;
    initial reading = 1'b0;
    // Whether the answer to a read was found in the clock before: whether there is the register, and its word in @PARTS@ parts of which all
    // but one are 0. The way from all registers to the answer is too far for one clock.
    reg found;
    reg found_known;
@FOUND_DECLARATIONS@
    initial found = 1'b0;
    // The high bits of the counter whose low word was read last.
    reg [@COUNTER_HIGH@ - 32:0] counter_high;
    // What happened in the clock before: the way to the counters is too far for the clock in which it happens.
@SEEN@
    // Whether a write and a read were answered in the clock before.
    reg seen_write;
    reg seen_read;
    initial seen_write = 1'b0;
    initial seen_read = 1'b0;
    initial s_axi_bvalid = 1'b0;
    initial s_axi_rvalid = 1'b0;
    initial events = {(@EVENT_HIGH@ + 1){1'b0}};
    initial interrupt_enable = {(@EVENT_HIGH@ + 1){1'b0}};
    initial stall_limit = @STALL_LIMIT@;
    initial under_way = @UNDER_WAY_BITS@'d0;
    initial query_came = 1'b0;
    initial result_went = 1'b0;
    initial seen_silent = 1'b0;
    initial silent_clocks = 32'd0;
    initial counter_high = {(@COUNTER_HIGH@ - 31){1'b0}};
    initial reset = 1'b0;
    wire busy = |under_way;
    // The next numbers of queries under way.
    (* keep *) wire [@UNDER_WAY_HIGH@:0] one_more;
    assign one_more = under_way + @UNDER_WAY_BITS@'d1;
    (* keep *) wire [@UNDER_WAY_HIGH@:0] one_less;
    assign one_less = under_way - @UNDER_WAY_BITS@'d1;

    // An access is taken where its answer has a place.
    wire writes = s_axi_awvalid & s_axi_wvalid & ~s_axi_bvalid & aresetn;
    assign s_axi_awready = writes;
    assign s_axi_wready = writes;
    assign s_axi_arready = ~s_axi_rvalid & ~reading & ~found & aresetn;
    wire [31:0] write_mask = {{8{s_axi_wstrb[3]}}, {8{s_axi_wstrb[2]}}, {8{s_axi_wstrb[1]}}, {8{s_axi_wstrb[0]}}};
    wire [31:0] write_word = s_axi_wdata & write_mask;
    // The two low bits are not looked at: the strobes name the bytes.
    wire [@ADDRESS_HIGH@:0] write_address = {s_axi_awaddr[@ADDRESS_HIGH@:2], 2'b00};
    wire [@ADDRESS_HIGH@:0] read_address = {s_axi_araddr[@ADDRESS_HIGH@:2], 2'b00};
    reg write_known;
    always @(*) begin
        write_known = 1'b0;
        case (write_address)
@WRITABLE@
            default: write_known = 1'b0;
        endcase
    end
    wire reads_low = 1'b0
@READS_LOW@;
    wire [@COUNTER_HIGH@ - 32:0] counter_high_next = {(@COUNTER_HIGH@ - 31){1'b0}}
@HIGH_COPIES@;
    wire write_refused = seen_write & (s_axi_bresp != OKAY);
    wire read_refused = seen_read & (s_axi_rresp != OKAY);
    wire [1:0] seen_refused = write_refused + read_refused;
    wire writes_control = writes & (write_address == ADDRESS_CONTROL);
    wire clears_counters = writes_control & write_word[@CLEAR_COUNTERS@];
    wire writes_events = writes & (write_address == ADDRESS_EVENTS);
    wire writes_enable = writes & (write_address == ADDRESS_INTERRUPT_ENABLE);
    wire writes_limit = writes & (write_address == ADDRESS_STALL_LIMIT);

    wire ends = result_went & ~query_came & (under_way == @UNDER_WAY_BITS@'d1);
    wire silent = (busy | photon_waits | query_waits) & ~(photon_moves | query_moves | result_moves) & ~result_waits@NOT_PLAYED@;
    wire stalls = (|stall_limit) & (silent_clocks == stall_limit);
    wire [@EVENT_HIGH@:0] occurred;
@EVENTS@
    wire [@EVENT_HIGH@:0] cleared = writes_events ? write_word[@EVENT_HIGH@:0] : {(@EVENT_HIGH@ + 1){1'b0}};
    assign irq = |(events & interrupt_enable);

    always @(posedge clock) begin
        if (writes) begin
            s_axi_bvalid <= 1'b1;
            s_axi_bresp <= write_known ? OKAY : SLVERR;
        end else if (s_axi_bready) s_axi_bvalid <= 1'b0;
        reading <= s_axi_arvalid & s_axi_arready;
@SELECTS@
        found <= reading & aresetn;
        found_known <= |selected;
@FINDS@
        if (reading & reads_low) counter_high <= counter_high_next;
        if (found) begin
            s_axi_rvalid <= 1'b1;
            s_axi_rresp <= found_known ? OKAY : SLVERR;
            s_axi_rdata <= @FOUND_WORD@;
        end else if (s_axi_rready) s_axi_rvalid <= 1'b0;
        // A register, since the way to every chain is too far for the clock in which it is decided.
        reset <= ~aresetn | (writes_control & write_word[@RESTART@]);
        events <= (events & ~cleared) | occurred;
        if (writes_enable) begin
            interrupt_enable <= (interrupt_enable & ~write_mask[@EVENT_HIGH@:0]) | write_word[@EVENT_HIGH@:0];
        end
        if (writes_limit) stall_limit <= (stall_limit & ~write_mask) | write_word;@ROUND_WRITES@
        query_came <= query_given;
        result_went <= @LAST_RESULT@;
        if (query_came & ~result_went) under_way <= one_more;
        if (result_went & ~query_came) under_way <= one_less;
        seen_silent <= silent;
        silent_clocks <= seen_silent ? silent_clocks + 32'd1 : 32'd0;
        if (reset | ~aresetn) begin
            under_way <= @UNDER_WAY_BITS@'d0;
            query_came <= 1'b0;
            result_went <= 1'b0;
            seen_silent <= 1'b0;
            silent_clocks <= 32'd0;
        end
        seen_write <= writes;
        seen_read <= found & aresetn;
@SEES@
        if (clears_counters | ~aresetn) begin
@COUNTER_CLEARS@
        end else begin
@COUNTER_ADDS@
        end
        if (~aresetn) begin
            s_axi_bvalid <= 1'b0;
            s_axi_rvalid <= 1'b0;
            events <= {(@EVENT_HIGH@ + 1){1'b0}};
            interrupt_enable <= {(@EVENT_HIGH@ + 1){1'b0}};
            stall_limit <= @STALL_LIMIT@;
            counter_high <= {(@COUNTER_HIGH@ - 31){1'b0}};@ROUND_RESETS@
@FORGETS@
        end
    end
endmodule
