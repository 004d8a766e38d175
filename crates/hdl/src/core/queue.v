// A queue in front of a chain. It has no ready: a word comes only where a place is left, which the link of its stream knows.
module @TOP@_queue(clock, reset, in_valid, in_word, out_valid, out_ready, out_word);
    parameter WIDTH = 1;
    // The queue has 2^PLACE places.
    parameter PLACE = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    input wire [WIDTH - 1:0] in_word;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    // No word is read in the clock in which its place is written.
    (* no_rw_check *) reg [WIDTH - 1:0] words [0:(1 << PLACE) - 1];
    // The word that is given, which has left the memory: a register, so that a memory may be a block RAM and no path leads through it.
    reg [WIDTH - 1:0] front;
    reg has_front;
    // The places of the next word to write, of the newest, and of the next to read; whether there is one.
    reg [PLACE - 1:0] write;
    reg [PLACE - 1:0] newest;
    reg [PLACE - 1:0] read;
    reg has_word;
    initial has_front = 1'b0;
    initial write = {PLACE{1'b0}};
    initial newest = {PLACE{1'b0}};
    initial read = {PLACE{1'b0}};
    initial has_word = 1'b0;
    wire reads = has_word & (~has_front | out_ready);
    // From registers alone, since the ready comes late.
    (* keep *) wire is_newest;
    assign is_newest = read == newest;
    assign out_valid = has_front;
    assign out_word = front;
    always @(posedge clock) begin
        if (in_valid) begin
            words[write] <= in_word;
            newest <= write;
            write <= write + 1'b1;
        end
        if (reads) begin
            front <= words[read];
            read <= read + 1'b1;
        end
        has_word <= in_valid | (has_word & ~(reads & is_newest));
        has_front <= reads | (has_front & ~out_ready);
        if (reset) begin
            write <= {PLACE{1'b0}};
            newest <= {PLACE{1'b0}};
            read <= {PLACE{1'b0}};
            has_word <= 1'b0;
            has_front <= 1'b0;
        end
    end
endmodule
