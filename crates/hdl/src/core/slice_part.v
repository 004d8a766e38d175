// A part of the words of a slice, with two places. Its flags stand beside it: `keep` on the statements keeps synthesis from merging them
// with those of other parts.
module @TOP@_slice_part(clock, even_next, odd_next, goes_odd_next, in_word, out_word);
    parameter WIDTH = 1;
    input wire clock;
    // In the next clock a word can come into the even place, into the odd one, and the odd one is given.
    input wire even_next;
    input wire odd_next;
    input wire goes_odd_next;
    input wire [WIDTH - 1:0] in_word;
    output wire [WIDTH - 1:0] out_word;
    reg [WIDTH - 1:0] even_word;
    reg [WIDTH - 1:0] odd_word;
    reg even;
    reg odd;
    reg goes_odd;
    initial even = 1'b1;
    initial odd = 1'b0;
    initial goes_odd = 1'b0;
    (* keep *) always @(posedge clock) even <= even_next;
    (* keep *) always @(posedge clock) odd <= odd_next;
    (* keep *) always @(posedge clock) goes_odd <= goes_odd_next;
    assign out_word = goes_odd ? odd_word : even_word;
    always @(posedge clock) begin
        if (even) even_word <= in_word;
        if (odd) odd_word <= in_word;
    end
endmodule
