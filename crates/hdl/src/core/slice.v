// A slice of a stream. It has two places, so that no ready passes through it. A word stays in its place until it goes, and only its
// HEAD highest bits move to the first place.
module @TOP@_slice(clock, reset, in_valid, in_ready, in_word, out_valid, out_ready, out_word);
    // At least four bits stay.
    parameter WIDTH = 5;
    parameter HEAD = 1;
    // The bits that stay have four parts, each with flags of its own: one flag for all of them would have to reach too far.
    localparam BODY = WIDTH - HEAD;
    localparam PART = BODY >> 2;
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
    // The places of the next word to come and of the next to go.
    reg comes_odd;
    reg goes_odd;
    initial first_full = 1'b0;
    initial second_full = 1'b0;
    initial comes_odd = 1'b0;
    initial goes_odd = 1'b0;
    wire [HEAD - 1:0] in_head = in_word[WIDTH - 1:BODY];
    wire first_takes = ~first_full | out_ready;
    wire comes = in_valid & in_ready;
    wire second_full_next = ~reset & ~first_takes & (second_full | comes);
    wire comes_odd_next = ~reset & (comes_odd ^ comes);
    wire goes_odd_next = ~reset & (goes_odd ^ (out_valid & out_ready));
    // The place that is written is free while a word can come.
    wire even_next = ~second_full_next & ~comes_odd_next;
    wire odd_next = ~second_full_next & comes_odd_next;
    assign in_ready = ~second_full;
    assign out_valid = first_full;
    assign out_word[WIDTH - 1:BODY] = first_head;
    @TOP@_slice_part #(.WIDTH(PART)) part_0(.clock(clock), .even_next(even_next), .odd_next(odd_next), .goes_odd_next(goes_odd_next),
        .in_word(in_word[PART - 1:0]), .out_word(out_word[PART - 1:0]));
    @TOP@_slice_part #(.WIDTH(PART)) part_1(.clock(clock), .even_next(even_next), .odd_next(odd_next), .goes_odd_next(goes_odd_next),
        .in_word(in_word[2 * PART - 1:PART]), .out_word(out_word[2 * PART - 1:PART]));
    @TOP@_slice_part #(.WIDTH(PART)) part_2(.clock(clock), .even_next(even_next), .odd_next(odd_next), .goes_odd_next(goes_odd_next),
        .in_word(in_word[3 * PART - 1:2 * PART]), .out_word(out_word[3 * PART - 1:2 * PART]));
    @TOP@_slice_part #(.WIDTH(BODY - 3 * PART)) part_3(.clock(clock), .even_next(even_next), .odd_next(odd_next),
        .goes_odd_next(goes_odd_next), .in_word(in_word[BODY - 1:3 * PART]), .out_word(out_word[BODY - 1:3 * PART]));
    always @(posedge clock) begin
        first_full <= ~reset & (first_takes ? second_full | comes : 1'b1);
        second_full <= second_full_next;
        if (first_takes) begin
            if (second_full) first_head <= second_head;
            else first_head <= in_head;
        end
        if (~second_full) second_head <= in_head;
        comes_odd <= comes_odd_next;
        goes_odd <= goes_odd_next;
    end
endmodule
