// SPDX-License-Identifier: MIT
// An example of how to drive core-3-leaf-5-local7-rgb6d-n64.
// Each chain is given a set of photons and two batches of queries. Then registers are read.
// Written by photoncube 0.2.0, `photoncube generate --machine leaf-5-local7-rgb6d-n64 --chains 3`; do not edit.
//
//   iverilog -g2005 -o example photoncube_core_3_leaf_5_local7_rgb6d_n64.v photoncube_core_3_leaf_5_local7_rgb6d_n64_tb.v
//   vvp example
//
// The head of photoncube_core_3_leaf_5_local7_rgb6d_n64.v has the fields of the words.
// The golden model computed the expected results.

module photoncube_core_3_leaf_5_local7_rgb6d_n64_tb;
    reg [514:0] photons [0:5];
    reg [130:0] queries [0:8];
    // Those of a chain side by side.
    reg [65:0] results [0:8];
    // An address and the word that is read there.
    reg [40:0] reads [0:2];
    // The results that each chain has given.
    reg [31:0] given [0:2];
    integer chain;
    initial begin
        for (chain = 0; chain < 3; chain = chain + 1) given[chain] = 0;
        // tlast, tdest, bits without a field, facing, and of the photons from the last to the first:
        //   blue, green, red, z, y, x, present
        photons[0] = {1'd0, 2'd0, 139'd0, 5'd0,
            6'd51, 6'd29, 6'd46, 9'd312, 9'd161, 9'd288, 1'd1,
            6'd60, 6'd7, 6'd41, 9'd139, 9'd328, 9'd306, 1'd1,
            6'd61, 6'd0, 6'd3, 9'd152, 9'd148, 9'd364, 1'd1,
            6'd11, 6'd54, 6'd21, 9'd299, 9'd329, 9'd172, 1'd1,
            6'd42, 6'd37, 6'd16, 9'd272, 9'd280, 9'd169, 1'd1,
            6'd18, 6'd39, 6'd33, 9'd323, 9'd247, 9'd295, 1'd1,
            6'd45, 6'd35, 6'd25, 9'd301, 9'd270, 9'd248, 1'd1,
            6'd25, 6'd9, 6'd43, 9'd239, 9'd362, 9'd192, 1'd1};
        photons[1] = {1'd1, 2'd0, 139'd0, 5'd0,
            322'd0,
            6'd62, 6'd59, 6'd30, 9'd297, 9'd312, 9'd210, 1'd1};
        photons[2] = {1'd0, 2'd1, 139'd0, 5'd0,
            6'd49, 6'd46, 6'd53, 9'd237, 9'd175, 9'd144, 1'd1,
            6'd26, 6'd19, 6'd5, 9'd243, 9'd337, 9'd198, 1'd1,
            6'd26, 6'd34, 6'd53, 9'd128, 9'd219, 9'd375, 1'd1,
            6'd5, 6'd49, 6'd8, 9'd178, 9'd254, 9'd179, 1'd1,
            6'd54, 6'd44, 6'd46, 9'd345, 9'd308, 9'd311, 1'd1,
            6'd62, 6'd7, 6'd58, 9'd224, 9'd261, 9'd291, 1'd1,
            6'd11, 6'd58, 6'd30, 9'd361, 9'd177, 9'd287, 1'd1,
            6'd12, 6'd57, 6'd13, 9'd209, 9'd286, 9'd378, 1'd1};
        photons[3] = {1'd1, 2'd1, 139'd0, 5'd0,
            322'd0,
            6'd41, 6'd36, 6'd31, 9'd297, 9'd352, 9'd346, 1'd1};
        photons[4] = {1'd0, 2'd2, 139'd0, 5'd0,
            6'd63, 6'd17, 6'd17, 9'd243, 9'd381, 9'd340, 1'd1,
            6'd59, 6'd58, 6'd44, 9'd373, 9'd354, 9'd346, 1'd1,
            6'd4, 6'd52, 6'd1, 9'd198, 9'd358, 9'd302, 1'd1,
            6'd39, 6'd46, 6'd62, 9'd311, 9'd128, 9'd240, 1'd1,
            6'd2, 6'd45, 6'd36, 9'd216, 9'd287, 9'd310, 1'd1,
            6'd33, 6'd53, 6'd4, 9'd288, 9'd188, 9'd219, 1'd1,
            6'd49, 6'd47, 6'd7, 9'd252, 9'd217, 9'd213, 1'd1,
            6'd37, 6'd26, 6'd26, 9'd233, 9'd206, 9'd353, 1'd1};
        photons[5] = {1'd1, 2'd2, 139'd0, 5'd0,
            322'd0,
            6'd57, 6'd26, 6'd23, 9'd335, 9'd276, 9'd373, 1'd1};

        // tlast, tdest, and from the highest bit down with the bits without a field:
        //   release, facings, tag, z, y, x
        queries[0] = {1'd1, 2'd0, 31'd0, 1'd0, 32'd1, 16'd0, 7'd0, 9'd232, 7'd0, 9'd287, 7'd0, 9'd274};
        queries[1] = {1'd0, 2'd0, 31'd0, 1'd1, 32'd1, 16'd1, 7'd0, 9'd286, 7'd0, 9'd234, 7'd0, 9'd274};
        queries[2] = {1'd1, 2'd0, 31'd0, 1'd1, 32'd1, 16'd2, 7'd0, 9'd238, 7'd0, 9'd234, 7'd0, 9'd234};
        queries[3] = {1'd1, 2'd1, 31'd0, 1'd0, 32'd1, 16'd3, 7'd0, 9'd251, 7'd0, 9'd275, 7'd0, 9'd237};
        queries[4] = {1'd0, 2'd1, 31'd0, 1'd1, 32'd1, 16'd4, 7'd0, 9'd253, 7'd0, 9'd246, 7'd0, 9'd236};
        queries[5] = {1'd1, 2'd1, 31'd0, 1'd1, 32'd1, 16'd5, 7'd0, 9'd267, 7'd0, 9'd235, 7'd0, 9'd228};
        queries[6] = {1'd1, 2'd2, 31'd0, 1'd0, 32'd1, 16'd6, 7'd0, 9'd236, 7'd0, 9'd258, 7'd0, 9'd251};
        queries[7] = {1'd0, 2'd2, 31'd0, 1'd1, 32'd1, 16'd7, 7'd0, 9'd231, 7'd0, 9'd253, 7'd0, 9'd270};
        queries[8] = {1'd1, 2'd2, 31'd0, 1'd1, 32'd1, 16'd8, 7'd0, 9'd258, 7'd0, 9'd282, 7'd0, 9'd241};

        // tuser, tlast, and from the highest bit down with the bits without a field:
        //   tag, count, blue, green, red
        results[0] = {1'd0, 1'd1, 5'd0, 16'd0, 7'd6, 12'd252, 12'd186, 12'd188};
        results[1] = {1'd0, 1'd0, 5'd0, 16'd1, 7'd5, 12'd218, 12'd199, 12'd150};
        results[2] = {1'd0, 1'd1, 5'd0, 16'd2, 7'd5, 12'd218, 12'd199, 12'd150};
        results[3] = {1'd0, 1'd1, 5'd0, 16'd3, 7'd4, 12'd147, 12'd119, 12'd117};
        results[4] = {1'd0, 1'd0, 5'd0, 16'd4, 7'd4, 12'd142, 12'd121, 12'd124};
        results[5] = {1'd0, 1'd1, 5'd0, 16'd5, 7'd5, 12'd153, 12'd179, 12'd154};
        results[6] = {1'd0, 1'd1, 5'd0, 16'd6, 7'd5, 12'd125, 12'd223, 12'd74};
        results[7] = {1'd0, 1'd0, 5'd0, 16'd7, 7'd5, 12'd125, 12'd223, 12'd74};
        results[8] = {1'd0, 1'd1, 5'd0, 16'd8, 7'd4, 12'd88, 12'd197, 12'd48};

        // Registers:
        reads[0] = {9'h000, 32'h50435542};  // identity
        reads[1] = {9'h060, 32'h00000009};  // results_low
        reads[2] = {9'h080, 32'h0000002b};  // photons_in_range_low
    end

    reg aclk = 1'b0;
    reg aresetn = 1'b0;
    reg asked = 1'b0;
    integer clocks = 0, photon = 0, query = 0, result = 0, read = 0, wrong = 0, quiet = 0;
    always #5 aclk = ~aclk;

    wire [511:0] s_axis_photons_tdata;
    wire s_axis_photons_tvalid, s_axis_photons_tready, s_axis_photons_tlast;
    wire [1:0] s_axis_photons_tdest;
    wire [127:0] s_axis_queries_tdata;
    wire s_axis_queries_tvalid, s_axis_queries_tready, s_axis_queries_tlast;
    wire [1:0] s_axis_queries_tdest;
    wire [63:0] m_axis_results_tdata;
    wire m_axis_results_tvalid, m_axis_results_tready, m_axis_results_tlast;
    wire [1:0] m_axis_results_tid;
    wire m_axis_results_tuser;
    wire [8:0] s_axi_araddr;
    wire [2:0] s_axi_arprot;
    wire s_axi_arvalid, s_axi_arready;
    wire [31:0] s_axi_rdata;
    wire [1:0] s_axi_rresp;
    wire s_axi_rvalid, s_axi_rready, irq;

    // A word is on the pins, and does not change, while tvalid is 1. It moves at a rising edge at which tready is 1 too.
    assign s_axis_photons_tvalid = aresetn && photon < 6;
    assign {s_axis_photons_tlast, s_axis_photons_tdest, s_axis_photons_tdata}
        = s_axis_photons_tvalid ? photons[photon] : 515'd0;
    assign s_axis_queries_tvalid = aresetn && query < 9;
    assign {s_axis_queries_tlast, s_axis_queries_tdest, s_axis_queries_tdata}
        = s_axis_queries_tvalid ? queries[query] : 131'd0;
    // The testbench is slow to take results, so the core must keep them. Those of one chain come in the order of its queries.
    assign m_axis_results_tready = aresetn && clocks % 4 == 3;
    wire [65:0] found = {m_axis_results_tuser, m_axis_results_tlast, m_axis_results_tdata};
    wire [65:0] expected = results[m_axis_results_tid * 3 + given[m_axis_results_tid]];
    // Behind the last result, the registers are read one after the other. None is written.
    assign s_axi_arvalid = aresetn && result == 9 && read < 3 && !asked;
    assign s_axi_araddr = s_axi_arvalid ? reads[read][40:32] : 9'd0;
    assign s_axi_rready = 1'b1;
    assign s_axi_arprot = 3'd0;
    wire photon_moves = s_axis_photons_tvalid && s_axis_photons_tready;
    wire query_moves = s_axis_queries_tvalid && s_axis_queries_tready;
    wire result_moves = m_axis_results_tvalid && m_axis_results_tready;

    photoncube_core_3_leaf_5_local7_rgb6d_n64 core(
        .aclk(aclk), .aresetn(aresetn), .s_axis_photons_tdata(s_axis_photons_tdata),
        .s_axis_photons_tvalid(s_axis_photons_tvalid), .s_axis_photons_tready(s_axis_photons_tready),
        .s_axis_photons_tlast(s_axis_photons_tlast), .s_axis_photons_tdest(s_axis_photons_tdest),
        .s_axis_queries_tdata(s_axis_queries_tdata), .s_axis_queries_tvalid(s_axis_queries_tvalid),
        .s_axis_queries_tready(s_axis_queries_tready), .s_axis_queries_tlast(s_axis_queries_tlast),
        .s_axis_queries_tdest(s_axis_queries_tdest), .m_axis_results_tdata(m_axis_results_tdata),
        .m_axis_results_tvalid(m_axis_results_tvalid), .m_axis_results_tready(m_axis_results_tready),
        .m_axis_results_tlast(m_axis_results_tlast), .m_axis_results_tid(m_axis_results_tid),
        .m_axis_results_tuser(m_axis_results_tuser), .s_axi_araddr(s_axi_araddr), .s_axi_arprot(s_axi_arprot),
        .s_axi_arvalid(s_axi_arvalid), .s_axi_arready(s_axi_arready), .s_axi_rdata(s_axi_rdata),
        .s_axi_rresp(s_axi_rresp), .s_axi_rvalid(s_axi_rvalid), .s_axi_rready(s_axi_rready), .irq(irq),
        .s_axi_awaddr(9'd0), .s_axi_awprot(3'd0), .s_axi_awvalid(1'd0), .s_axi_awready(), .s_axi_wdata(32'd0),
        .s_axi_wstrb(4'd0), .s_axi_wvalid(1'd0), .s_axi_wready(), .s_axi_bresp(), .s_axi_bvalid(), .s_axi_bready(1'd0));

    always @(posedge aclk) begin
        clocks <= clocks + 1;
        aresetn <= aresetn || clocks > 2;
        if (photon_moves) photon <= photon + 1;
        if (query_moves) query <= query + 1;
        if (result_moves) begin
            result <= result + 1;
            given[m_axis_results_tid] <= given[m_axis_results_tid] + 1;
            if (found !== expected || given[m_axis_results_tid] >= 3) begin
                wrong <= wrong + 1;
                $display("result of chain %0d is %h, expected %h", m_axis_results_tid, found, expected);
            end
        end
        if (s_axi_arvalid && s_axi_arready) asked <= 1'b1;
        if (s_axi_rvalid) begin
            asked <= 1'b0;
            read <= read + 1;
            if (s_axi_rresp != 2'd0 || s_axi_rdata !== reads[read][31:0]) begin
                wrong <= wrong + 1;
                $display("register %0d is %h, expected %h", read, s_axi_rdata, reads[read][31:0]);
            end
        end
        // The end is behind many clocks in which no word moves.
        quiet <= photon_moves || query_moves || result_moves || s_axi_rvalid ? 0 : quiet + 1;
        if (quiet == 300) begin
            if (result == 9 && read == 3 && wrong == 0) $display("PASSED: %0d results, %0d registers", result, read);
            else $display("FAILED: %0d of 9 results and %0d of 3 registers came, %0d wrong", result, read, wrong);
            $finish;
        end
    end
endmodule
