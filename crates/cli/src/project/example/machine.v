// SPDX-License-Identifier: MIT
// An example of how to drive @NAME@: two sets of photons and @RESULTS@ queries, @BATCH@ at once.
// Written by photoncube @VERSION@, `@COMMAND@`; do not edit.
//
//   iverilog -g2005 -o example @TOP@.v @TOP@_tb.v
//   vvp example
//
// The head of @TOP@.v has the rules of the ports. The golden model computed the expected results.

module @TOP@_tb;
    reg [@QUERY_HIGH@:0] queries [0:@LAST_QUERY@];
    reg [@GROUP_HIGH@:0] groups [0:@LAST_GROUP@];
    reg [@RESULT_HIGH@:0] results [0:@LAST_RESULT@];
    initial begin
@QUERY_NAMES@
@QUERY_WORDS@
@GROUP_NAMES@
@GROUP_WORDS@
@RESULT_NAMES@
@RESULT_WORDS@    end

    reg clock = 1'b0;
    reg reset = 1'b1;
    integer clocks = 0, query = 0, group = 0, result = 0, wrong = 0, quiet = 0;
    always #5 clock = ~clock;

@WIRES@
    // A word is on the pins, and does not change, while valid is 1. It moves at a rising edge at which ready is 1 too.
    assign query_valid = !reset && query < @QUERIES@;
    assign group_valid = !reset && group < @GROUPS@;
    // The testbench is slow to take results, so the machine must keep them.
    assign result_ready = !reset && clocks % 4 == 3;
    assign {@QUERY_PINS@}
        = query_valid ? queries[query] : @QUERY_BITS@'d0;
    assign {@GROUP_PINS@}
        = group_valid ? groups[group] : @GROUP_BITS@'d0;
    wire [@RESULT_HIGH@:0] found = {@RESULT_PINS@};

    @TOP@ machine(
@CONNECTIONS@);

    always @(posedge clock) begin
        clocks <= clocks + 1;
        reset <= clocks < 3;
        if (query_valid && query_ready) query <= query + 1;
        if (group_valid && group_ready) group <= group + 1;
        if (result_valid && result_ready) begin
            result <= result + 1;
            if (found !== results[result]) begin
                wrong <= wrong + 1;
                $display("result %0d is %h, expected %h", result, found, results[result]);
            end
        end
        // The end is behind many clocks in which no word moves.
        if (query_valid && query_ready || group_valid && group_ready || result_valid && result_ready) quiet <= 0;
        else quiet <= quiet + 1;
        if (quiet == 300) begin
            if (result == @RESULTS@ && wrong == 0) $display("PASSED: %0d results", result);
            else $display("FAILED: %0d of @RESULTS@ results came, %0d of them wrong", result, wrong);
            $finish;
        end
    end
endmodule
