// SPDX-License-Identifier: MIT
// An example of how to drive @NAME@.
// Each chain is given a set of photons and two batches of queries. Then registers are read.
// Written by photoncube @VERSION@, `photoncube generate --machine @MACHINE@ --chains @CHAINS@`; do not edit.
//
//   iverilog -g2005 -o example @TOP@.v @TOP@_tb.v
//   vvp example
//
// The head of @TOP@.v has the fields of the words.
// The golden model computed the expected results.

module @TOP@_tb;
    reg [@PHOTON_HIGH@:0] photons [0:@LAST_PHOTON@];
    reg [@QUERY_HIGH@:0] queries [0:@LAST_QUERY@];
    // Those of a chain side by side.
    reg [@RESULT_HIGH@:0] results [0:@LAST_RESULT@];
    // An address and the word that is read there.
    reg [@READ_HIGH@:0] reads [0:@LAST_READ@];
    // The results that each chain has given.
    reg [31:0] given [0:@LAST_CHAIN@];
    integer chain;
    initial begin
        for (chain = 0; chain < @CHAINS@; chain = chain + 1) given[chain] = 0;
        // tlast, tdest, bits without a field, facing, and of the photons from the last to the first:
@PHOTON_NAMES@
@PHOTON_WORDS@
        // tlast, tdest, and from the highest bit down with the bits without a field:
@QUERY_NAMES@
@QUERY_WORDS@
        // tuser, tlast, and from the highest bit down with the bits without a field:
@RESULT_NAMES@
@RESULT_WORDS@
        // Registers:
@READ_WORDS@    end

    reg aclk = 1'b0;
    reg aresetn = 1'b0;
    reg asked = 1'b0;
    integer clocks = 0, photon = 0, query = 0, result = 0, read = 0, wrong = 0, quiet = 0;
    always #5 aclk = ~aclk;

@WIRES@
    // A word is on the pins, and does not change, while tvalid is 1. It moves at a rising edge at which tready is 1 too.
    assign s_axis_photons_tvalid = aresetn && photon < @PHOTONS@;
    assign {s_axis_photons_tlast, s_axis_photons_tdest, s_axis_photons_tdata}
        = s_axis_photons_tvalid ? photons[photon] : @PHOTON_BITS@'d0;
    assign s_axis_queries_tvalid = aresetn && query < @QUERIES@;
    assign {s_axis_queries_tlast, s_axis_queries_tdest, s_axis_queries_tdata}
        = s_axis_queries_tvalid ? queries[query] : @QUERY_BITS@'d0;
    // The testbench is slow to take results, so the core must keep them. Those of one chain come in the order of its queries.
    assign m_axis_results_tready = aresetn && clocks % 4 == 3;
    wire [@RESULT_HIGH@:0] found = {m_axis_results_tuser, m_axis_results_tlast, m_axis_results_tdata};
    wire [@RESULT_HIGH@:0] expected = results[m_axis_results_tid * @OF_CHAIN@ + given[m_axis_results_tid]];
    // Behind the last result, the registers are read one after the other. None is written.
    assign s_axi_arvalid = aresetn && result == @RESULTS@ && read < @READS@ && !asked;
    assign s_axi_araddr = s_axi_arvalid ? reads[read][@READ_HIGH@:@WORD_BITS@] : @ADDRESS_BITS@'d0;
    assign s_axi_rready = 1'b1;
    assign s_axi_arprot = 3'd0;
    wire photon_moves = s_axis_photons_tvalid && s_axis_photons_tready;
    wire query_moves = s_axis_queries_tvalid && s_axis_queries_tready;
    wire result_moves = m_axis_results_tvalid && m_axis_results_tready;

    @TOP@ core(
@CONNECTIONS@);

    always @(posedge aclk) begin
        clocks <= clocks + 1;
        aresetn <= aresetn || clocks > 2;
        if (photon_moves) photon <= photon + 1;
        if (query_moves) query <= query + 1;
        if (result_moves) begin
            result <= result + 1;
            given[m_axis_results_tid] <= given[m_axis_results_tid] + 1;
            if (found !== expected || given[m_axis_results_tid] >= @OF_CHAIN@) begin
                wrong <= wrong + 1;
                $display("result of chain %0d is %h, expected %h", m_axis_results_tid, found, expected);
            end
        end
        if (s_axi_arvalid && s_axi_arready) asked <= 1'b1;
        if (s_axi_rvalid) begin
            asked <= 1'b0;
            read <= read + 1;
            if (s_axi_rresp != 2'd0 || s_axi_rdata !== reads[read][@WORD_HIGH@:0]) begin
                wrong <= wrong + 1;
                $display("register %0d is %h, expected %h", read, s_axi_rdata, reads[read][@WORD_HIGH@:0]);
            end
        end
        // The end is behind many clocks in which no word moves.
        quiet <= photon_moves || query_moves || result_moves || s_axi_rvalid ? 0 : quiet + 1;
        if (quiet == 300) begin
            if (result == @RESULTS@ && read == @READS@ && wrong == 0) $display("PASSED: %0d results, %0d registers", result, read);
            else $display("FAILED: %0d of @RESULTS@ results and %0d of @READS@ registers came, %0d wrong", result, read, wrong);
            $finish;
        end
    end
endmodule
