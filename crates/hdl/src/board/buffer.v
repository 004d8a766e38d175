// Holds the host's frames: a queue of bytes in block RAM. What was written can be taken back until it is kept.
module @TOP@_buffer(clock, clear, room, write, write_data, keep, revert, read_valid, read_ready, read_data);
    input wire clock;
    input wire clear;
    output wire room;
    input wire write;
    input wire [7:0] write_data;
    input wire keep;
    input wire revert;
    output reg read_valid;
    input wire read_ready;
    output reg [7:0] read_data;
    reg [7:0] memory [0:@BUFFER_LAST@];
    // Counts of bytes: written, kept, read. They have a bit more than an address.
    reg [@ADDRESS_BITS@:0] written;
    reg [@ADDRESS_BITS@:0] kept;
    reg [@ADDRESS_BITS@:0] read;
    initial written = @COUNT_BITS@'d0;
    initial kept = @COUNT_BITS@'d0;
    initial read = @COUNT_BITS@'d0;
    initial read_valid = 1'b0;
    wire [@ADDRESS_BITS@:0] held = written - read;
    assign room = ~held[@ADDRESS_BITS@];
    wire fetch = (kept != read) & (~read_valid | read_ready);
    always @(posedge clock) begin
        if (write) memory[written[@ADDRESS_HIGH@:0]] <= write_data;
        if (fetch) read_data <= memory[read[@ADDRESS_HIGH@:0]];
        if (write) written <= written + @COUNT_BITS@'d1;
        if (revert) written <= kept;
        if (keep) kept <= written;
        if (fetch) read <= read + @COUNT_BITS@'d1;
        if (fetch | read_ready) read_valid <= fetch;
        if (clear) begin
            written <= @COUNT_BITS@'d0;
            kept <= @COUNT_BITS@'d0;
            read <= @COUNT_BITS@'d0;
            read_valid <= 1'b0;
        end
    end
endmodule
