"""Writes a small Verilog testbench for a core, which checks itself: `python testbench.py STREAMS.json FILE.v`.

Each chain is given one set and one batch. The expected results come from the reference of testbenches/cocotb."""

from __future__ import annotations

import sys
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "testbenches" / "cocotb"))

from reference import Beat, Reference  # noqa: E402
from shape import Shape, read_shape  # noqa: E402
from traffic import Sizes, Traffic  # noqa: E402

TEXT = """\
// Written by scripts/core/testbench.py: one set of photons and one batch of queries for each chain of
// @TOP@, and their results.
module @TOP@_tb;
    reg clock = 1'b0;
    reg [9:0] clocks = 10'd0;
    reg aresetn = 1'b0;
    always #5 clock = ~clock;

    // A word of an input stream: tlast, tdest, tdata.
    reg [@PHOTON_HIGH@:0] photons [0:@PHOTONS@];
    reg [@QUERY_HIGH@:0] queries [0:@QUERIES@];
    // A word of the results: tuser, tlast, tdata. Those of a chain are side by side.
    reg [@RESULT_HIGH@:0] results [0:@RESULTS@];
    reg [15:0] firsts [0:@CHAINS@];
    reg [15:0] ends [0:@CHAINS@];
    initial begin
@WORDS@
    end

    reg [15:0] photon = 16'd0;
    reg [15:0] query = 16'd0;
    reg [15:0] received = 16'd0;
    reg failed = 1'b0;
    wire photon_valid = aresetn & (photon < @PHOTONS@);
    wire query_valid = aresetn & (query < @QUERIES@);
    wire photon_ready, query_ready, result_valid, result_last, result_user;
    wire [@ID_HIGH@:0] result_chain;
    wire [@DATA_HIGH@:0] result;
    // Results wait for some clocks before they are taken.
    wire result_ready = &clocks[1:0];
    wire [@PHOTON_HIGH@:0] photon_word = photons[photon];
    wire [@QUERY_HIGH@:0] query_word = queries[query];
    @TOP@ core(.aclk(clock), .aresetn(aresetn),
        .s_axis_photons_tdata(photon_word[@PHOTON_DATA@:0]), .s_axis_photons_tvalid(photon_valid), .s_axis_photons_tready(photon_ready),
        .s_axis_photons_tlast(photon_word[@PHOTON_HIGH@]), .s_axis_photons_tdest(photon_word[@PHOTON_HIGH@ - 1:@PHOTON_DATA@ + 1]),
        .s_axis_queries_tdata(query_word[@QUERY_DATA@:0]), .s_axis_queries_tvalid(query_valid), .s_axis_queries_tready(query_ready),
        .s_axis_queries_tlast(query_word[@QUERY_HIGH@]), .s_axis_queries_tdest(query_word[@QUERY_HIGH@ - 1:@QUERY_DATA@ + 1]),
        .m_axis_results_tdata(result), .m_axis_results_tvalid(result_valid), .m_axis_results_tready(result_ready),
        .m_axis_results_tlast(result_last), .m_axis_results_tid(result_chain), .m_axis_results_tuser(result_user),
        .s_axi_awaddr(9'd0), .s_axi_awprot(3'd0), .s_axi_awvalid(1'b0), .s_axi_awready(),
        .s_axi_wdata(32'd0), .s_axi_wstrb(4'd0), .s_axi_wvalid(1'b0), .s_axi_wready(),
        .s_axi_bresp(), .s_axi_bvalid(), .s_axi_bready(1'b1),
        .s_axi_araddr(9'd0), .s_axi_arprot(3'd0), .s_axi_arvalid(1'b0), .s_axi_arready(),
        .s_axi_rdata(), .s_axi_rresp(), .s_axi_rvalid(), .s_axi_rready(1'b1), .irq());

    always @(posedge clock) begin
        clocks <= clocks + 10'd1;
        aresetn <= aresetn | (clocks == 10'd4);
        if (photon_valid & photon_ready) photon <= photon + 16'd1;
        if (query_valid & query_ready) query <= query + 16'd1;
        if (aresetn & result_valid & result_ready) begin
            received <= received + 16'd1;
            firsts[result_chain] <= firsts[result_chain] + 16'd1;
            if (firsts[result_chain] >= ends[result_chain]
                || {result_user, result_last, result} !== results[firsts[result_chain]]) begin
                $display("FAILED: result %0d of chain %0d is %h", received, result_chain, {result_user, result_last, result});
                failed <= 1'b1;
            end
        end
        if (&clocks) begin
            if (received != @RESULTS@) $display("FAILED: %0d of @RESULTS@ results came", received);
            else if (!failed) $display("PASSED: @RESULTS@ results");
            $finish;
        end
    end
endmodule
"""


def packed(beat: Beat, bits: int, chain_bits: int) -> tuple[int, int]:
    """A word of an input stream with its tdest and tlast, and its bits."""
    return beat.word | beat.chain << bits | int(beat.last) << (bits + chain_bits), bits + chain_bits + 1


def traffic_in_range(shape: Shape) -> tuple[list[Beat], list[Beat], Reference]:
    """Words of which each chain's first query has photons in range: sums of 0 could be of a chain that does nothing."""
    count = shape.results.fields["count"]
    for seed in range(10000):
        photons, queries = Traffic(shape, Random(seed)).round(Sizes(leaves=(2, 2), batches=(1, 1)))
        reference = Reference(shape)
        for beat in photons:
            reference.take_leaf(beat)
        for beat in queries:
            reference.take_query(beat)
        if all(chain.results[0].word >> count.low & count.most for chain in reference.chains):
            return photons, queries, reference
    raise AssertionError("found no traffic with photons in range")


def testbench(shape: Shape) -> str:
    """The text of the testbench."""
    photons, queries, reference = traffic_in_range(shape)
    chain_bits = max(1, (shape.chains - 1).bit_length())
    words: list[str] = []

    def word(memory: str, place: int, value: int, bits: int) -> None:
        words.append(f"        {memory}[{place}] = {bits}'h{value:x};")

    # The word behind the last is on the pins while there is none.
    for memory, beats, bits in (("photons", photons, shape.photons.bits), ("queries", queries, shape.queries.bits)):
        for place, beat in enumerate(beats):
            word(memory, place, *packed(beat, bits, chain_bits))
        word(memory, len(beats), 0, bits + chain_bits + 1)
    place = 0
    for number, chain in enumerate(reference.chains):
        word("firsts", number, place, 16)
        for owed in chain.results:
            value = owed.word | int(owed.last) << shape.results.bits | int(owed.user) << (shape.results.bits + 1)
            word("results", place, value, shape.results.bits + 2)
            place += 1
        word("ends", number, place, 16)
    values = {
        "TOP": shape.top,
        "PHOTON_HIGH": shape.photons.bits + chain_bits,
        "PHOTON_DATA": shape.photons.bits - 1,
        "QUERY_HIGH": shape.queries.bits + chain_bits,
        "QUERY_DATA": shape.queries.bits - 1,
        "RESULT_HIGH": shape.results.bits + 1,
        "DATA_HIGH": shape.results.bits - 1,
        "ID_HIGH": chain_bits - 1,
        "PHOTONS": len(photons),
        "QUERIES": len(queries),
        "RESULTS": place,
        "CHAINS": (1 << chain_bits) - 1,
        "WORDS": "\n".join(words),
    }
    text = TEXT
    for name, value in values.items():
        text = text.replace(f"@{name}@", str(value))
    return text


def main() -> int:
    """Writes the testbench."""
    Path(sys.argv[2]).write_text(testbench(read_shape(Path(sys.argv[1]))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
