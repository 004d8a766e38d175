// A stage of the way from a stream to the chains. It gives each word on after a clock.
module @TOP@_stage(clock, reset, in_valid, in_word, out_valid, out_word);
    parameter WIDTH = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    input wire [WIDTH - 1:0] in_word;
    output reg out_valid;
    output reg [WIDTH - 1:0] out_word;
    initial out_valid = 1'b0;
    always @(posedge clock) begin
        out_valid <= in_valid & ~reset;
        out_word <= in_word;
    end
endmodule
