// Merges the results of a chain with those that pass it. Where both have one, they take turns. A word has five bits at least, as in a slice.
module @TOP@_merge(clock, reset, own_valid, own_ready, own_word, passing_valid, passing_ready, passing_word,
    out_valid, out_ready, out_word);
    parameter WIDTH = 5;
    input wire clock;
    input wire reset;
    input wire own_valid;
    output wire own_ready;
    input wire [WIDTH - 1:0] own_word;
    input wire passing_valid;
    output wire passing_ready;
    input wire [WIDTH - 1:0] passing_word;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    // The last word was the chain's own.
    reg was_own;
    initial was_own = 1'b0;
    wire is_own = own_valid & ~(passing_valid & was_own);
    wire ready;
    assign own_ready = ready & is_own;
    assign passing_ready = ready & ~is_own;
    @TOP@_slice #(.WIDTH(WIDTH)) slice(.clock(clock), .reset(reset), .in_valid(own_valid | passing_valid), .in_ready(ready),
        .in_word(is_own ? own_word : passing_word), .out_valid(out_valid), .out_ready(out_ready), .out_word(out_word));
    always @(posedge clock) begin
        if (ready & (own_valid | passing_valid)) was_own <= is_own;
        if (reset) was_own <= 1'b0;
    end
endmodule
