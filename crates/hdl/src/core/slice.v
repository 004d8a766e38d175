// A slice of a stream. It has two places, so that no ready passes through it. A word stays in its place until it goes, and only its
// HEAD highest bits move to the first place.
module @TOP@_slice(clock, reset, in_valid, in_ready, in_word, out_valid, out_ready, out_word);
    parameter WIDTH = 2;
    parameter HEAD = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    input wire [WIDTH - 1:0] in_word;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    reg first_full;
    reg second_full;
    reg [HEAD - 1:0] first_head;
    reg [HEAD - 1:0] second_head;
    reg writes_odd;
    reg reads_odd;
    reg [WIDTH - HEAD - 1:0] even_body;
    reg [WIDTH - HEAD - 1:0] odd_body;
    initial first_full = 1'b0;
    initial second_full = 1'b0;
    initial writes_odd = 1'b0;
    initial reads_odd = 1'b0;
    wire [HEAD - 1:0] in_head = in_word[WIDTH - 1:WIDTH - HEAD];
    wire first_takes = ~first_full | out_ready;
    assign in_ready = ~second_full;
    assign out_valid = first_full;
    assign out_word = {first_head, reads_odd ? odd_body : even_body};
    always @(posedge clock) begin
        if (first_takes) begin
            first_full <= second_full | (in_valid & in_ready);
            second_full <= 1'b0;
            if (second_full) first_head <= second_head;
            else first_head <= in_head;
        end else if (in_valid & in_ready) second_full <= 1'b1;
        if (~second_full) second_head <= in_head;
        // The place that is written is free while a word can come.
        if (in_ready & ~writes_odd) even_body <= in_word[WIDTH - HEAD - 1:0];
        if (in_ready & writes_odd) odd_body <= in_word[WIDTH - HEAD - 1:0];
        writes_odd <= writes_odd ^ (in_valid & in_ready);
        reads_odd <= reads_odd ^ (out_valid & out_ready);
        if (reset) begin
            first_full <= 1'b0;
            second_full <= 1'b0;
            writes_odd <= 1'b0;
            reads_odd <= 1'b0;
        end
    end
endmodule
