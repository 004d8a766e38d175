// SPDX-License-Identifier: MIT
// core-3-leaf-5-local7-rgb6d-n64: 3 chains behind AXI4-Stream and AXI4-Lite; each is the machine
// leaf-5-local7-rgb6d-n64: 2 engines in a chain behind a memory of leaves, the photon format local7-rgb6d-n64.
// Written by photoncube 0.2.0, `photoncube generate --machine leaf-5-local7-rgb6d-n64 --chains 3`; do not edit.
//
// numbers        photon format local7-rgb6d-n64, 39 bits a stored photon
// power unit     the photon map's own: its largest power in any channel is the largest word
// frame          4 x 4 x 4 blocks; a block's edge is at least the search radius; a query has its
//                place in the inner 2 x 2 x 2 blocks, so that all photons in range are in the frame
// search radius  fixed, 126 of a block edge's 128 steps: in range where d^2 <= 15876
// most photons   64 a query
//
// Ports of photoncube_core_3_leaf_5_local7_rgb6d_n64:
//   input           aclk                   every register changes at its rising edge
//   input           aresetn                synchronous, active low; one clock is enough
//   input  [511:0]  s_axis_photons_tdata   a leaf of up to 8 photons
//   input           s_axis_photons_tvalid
//   output          s_axis_photons_tready
//   input           s_axis_photons_tlast   the leaf is the last of its set
//   input  [1:0]    s_axis_photons_tdest   the chain that the leaf is for
//   input  [127:0]  s_axis_queries_tdata   a query
//   input           s_axis_queries_tvalid
//   output          s_axis_queries_tready
//   input           s_axis_queries_tlast   the query is the last of its batch
//   input  [1:0]    s_axis_queries_tdest   the chain that the query is for
//   output [63:0]   m_axis_results_tdata   the result of a query
//   output          m_axis_results_tvalid
//   input           m_axis_results_tready
//   output          m_axis_results_tlast   the tlast of the query
//   output [1:0]    m_axis_results_tid     the chain that the result is from
//   output          m_axis_results_tuser   a coordinate of the query is too large for the frame; the sums are 0
//   input  [8:0]    s_axi_awaddr           in bytes; the two low bits are not looked at
//   input  [2:0]    s_axi_awprot           not looked at
//   input           s_axi_awvalid
//   output          s_axi_awready
//   input  [31:0]   s_axi_wdata
//   input  [3:0]    s_axi_wstrb
//   input           s_axi_wvalid
//   output          s_axi_wready
//   output [1:0]    s_axi_bresp            0 OKAY, 2 SLVERR
//   output          s_axi_bvalid
//   input           s_axi_bready
//   input  [8:0]    s_axi_araddr           in bytes; the two low bits are not looked at
//   input  [2:0]    s_axi_arprot           not looked at
//   input           s_axi_arvalid
//   output          s_axi_arready
//   output [31:0]   s_axi_rdata
//   output [1:0]    s_axi_rresp            0 OKAY, 2 SLVERR
//   output          s_axi_rvalid
//   input           s_axi_rready
//   output          irq                    1 while an event that is enabled is set
//
// Fields of s_axis_photons_tdata, highest and lowest bit:
//   present_0 0:0, x_0 9:1, y_0 18:10, z_0 27:19, red_0 33:28, green_0 39:34, blue_0 45:40,
//   present_1 46:46, x_1 55:47, y_1 64:56, z_1 73:65, red_1 79:74, green_1 85:80, blue_1 91:86,
//   present_2 92:92, x_2 101:93, y_2 110:102, z_2 119:111, red_2 125:120, green_2 131:126,
//   blue_2 137:132, present_3 138:138, x_3 147:139, y_3 156:148, z_3 165:157, red_3 171:166,
//   green_3 177:172, blue_3 183:178, present_4 184:184, x_4 193:185, y_4 202:194, z_4 211:203,
//   red_4 217:212, green_4 223:218, blue_4 229:224, present_5 230:230, x_5 239:231, y_5 248:240,
//   z_5 257:249, red_5 263:258, green_5 269:264, blue_5 275:270, present_6 276:276, x_6 285:277,
//   y_6 294:286, z_6 303:295, red_6 309:304, green_6 315:310, blue_6 321:316, present_7 322:322,
//   x_7 331:323, y_7 340:332, z_7 349:341, red_7 355:350, green_7 361:356, blue_7 367:362,
//   facing 372:368
//     present_0   the leaf has this photon; where it is 0, the photon's other fields are not looked
//                 at; no photon is behind an absent one
//     x_0         unsigned; cell i of 2^-7 block edge, in a frame of 4 block edges; stands for the
//                 cell's middle
//     y_0         unsigned; cell i of 2^-7 block edge, in a frame of 4 block edges; stands for the
//                 cell's middle
//     z_0         unsigned; cell i of 2^-7 block edge, in a frame of 4 block edges; stands for the
//                 cell's middle
//     red_0       unsigned; power units
//     green_0     unsigned; power units
//     blue_0      unsigned; power units
//     facing      any number; batches with bit i of facings gather the leaves of facing i
//
// Fields of s_axis_queries_tdata, highest and lowest bit:
//   x 8:0, y 24:16, z 40:32, tag 63:48, facings 95:64, release 96:96
//     x           unsigned; cell i of 2^-7 block edge, in a frame of 4 block edges; stands for the
//                 cell's middle
//     y           unsigned; cell i of 2^-7 block edge, in a frame of 4 block edges; stands for the
//                 cell's middle
//     z           unsigned; cell i of 2^-7 block edge, in a frame of 4 block edges; stands for the
//                 cell's middle
//     tag         any number; the query's result has it
//     facings     the facings that the batch gathers, bit i for facing i; those of its first query
//                 count
//     release     any query of a batch may set it: the set of photons is given up behind that batch
//
// Fields of m_axis_results_tdata, highest and lowest bit:
//   red 11:0, green 23:12, blue 35:24, count 42:36, tag 58:43
//     red         sum of the powers in range, in power units
//     green       sum of the powers in range, in power units
//     blue        sum of the powers in range, in power units
//     count       photons in range
//     tag         the tag of the query
//
// Registers, by their addresses in bytes:
//   000 identity
//   004 version
//   008 digest_low
//   00c digest_high
//   010 shape
//   014 control
//   018 status
//   01c events
//   020 interrupt_enable
//   024 stall_limit
//   028 under_way
//   040 clocks_low
//   044 clocks_high
//   048 busy_clocks_low
//   04c busy_clocks_high
//   050 leaves_read_low
//   054 leaves_read_high
//   058 queries_read_low
//   05c queries_read_high
//   060 results_low
//   064 results_high
//   068 leaves_compared_low
//   06c leaves_compared_high
//   070 leaves_wanted_low
//   074 leaves_wanted_high
//   078 groups_played_low
//   07c groups_played_high
//   080 photons_in_range_low
//   084 photons_in_range_high
//   088 photon_stalls_low
//   08c photon_stalls_high
//   090 query_stalls_low
//   094 query_stalls_high
//   098 result_stalls_low
//   09c result_stalls_high
//   0a0 leaves_malformed_low
//   0a4 leaves_malformed_high
//   0a8 leaves_refused_low
//   0ac leaves_refused_high
//   0b0 queries_outside_low
//   0b4 queries_outside_high
//   0b8 queries_refused_low
//   0bc queries_refused_high
//   0c0 accesses_refused_low
//   0c4 accesses_refused_high

// Blocks that compute several signals look like loops to Verilator; bit by bit there is none.
// verilator lint_off UNOPTFLAT
module photoncube_core_3_leaf_5_local7_rgb6d_n64(aclk, aresetn, s_axis_photons_tdata, s_axis_photons_tvalid,
    s_axis_photons_tready, s_axis_photons_tlast, s_axis_photons_tdest, s_axis_queries_tdata,
    s_axis_queries_tvalid, s_axis_queries_tready, s_axis_queries_tlast, s_axis_queries_tdest,
    m_axis_results_tdata, m_axis_results_tvalid, m_axis_results_tready, m_axis_results_tlast,
    m_axis_results_tid, m_axis_results_tuser, s_axi_awaddr, s_axi_awprot,
    s_axi_awvalid, s_axi_awready, s_axi_wdata, s_axi_wstrb,
    s_axi_wvalid, s_axi_wready, s_axi_bresp, s_axi_bvalid,
    s_axi_bready, s_axi_araddr, s_axi_arprot, s_axi_arvalid,
    s_axi_arready, s_axi_rdata, s_axi_rresp, s_axi_rvalid,
    s_axi_rready, irq);
    input wire aclk;
    input wire aresetn;
    input wire [511:0] s_axis_photons_tdata;
    input wire s_axis_photons_tvalid;
    output wire s_axis_photons_tready;
    input wire s_axis_photons_tlast;
    input wire [1:0] s_axis_photons_tdest;
    input wire [127:0] s_axis_queries_tdata;
    input wire s_axis_queries_tvalid;
    output wire s_axis_queries_tready;
    input wire s_axis_queries_tlast;
    input wire [1:0] s_axis_queries_tdest;
    output wire [63:0] m_axis_results_tdata;
    output wire m_axis_results_tvalid;
    input wire m_axis_results_tready;
    output wire m_axis_results_tlast;
    output wire [1:0] m_axis_results_tid;
    output wire m_axis_results_tuser;
    input wire [8:0] s_axi_awaddr;
    input wire [2:0] s_axi_awprot;
    input wire s_axi_awvalid;
    output wire s_axi_awready;
    input wire [31:0] s_axi_wdata;
    input wire [3:0] s_axi_wstrb;
    input wire s_axi_wvalid;
    output wire s_axi_wready;
    output wire [1:0] s_axi_bresp;
    output wire s_axi_bvalid;
    input wire s_axi_bready;
    input wire [8:0] s_axi_araddr;
    input wire [2:0] s_axi_arprot;
    input wire s_axi_arvalid;
    output wire s_axi_arready;
    output wire [31:0] s_axi_rdata;
    output wire [1:0] s_axi_rresp;
    output wire s_axi_rvalid;
    input wire s_axi_rready;
    output wire irq;
    wire reset;

    // Leaves: a slice, then to the chain of their number.
    wire [378:0] leaf_word;
    wire leaf_valid;
    wire leaf_ready;
    wire photon_slice_ready;
    // No word is taken in the clock of a reset.
    assign s_axis_photons_tready = photon_slice_ready & ~reset;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice #(.WIDTH(379), .HEAD(6)) photon_slice(.clock(aclk), .reset(reset),
        .in_valid(s_axis_photons_tvalid), .in_ready(photon_slice_ready), .in_word({{s_axis_photons_tdest == 2'd2, s_axis_photons_tdest == 2'd1, s_axis_photons_tdest == 2'd0}, s_axis_photons_tdest, s_axis_photons_tlast, s_axis_photons_tdata[372:0]}),
        .out_valid(leaf_valid), .out_ready(leaf_ready), .out_word(leaf_word));
    wire leaf_last = leaf_word[373];
    wire [1:0] leaf_chain = leaf_word[375:374];
    wire [7:0] leaf_present = {leaf_word[322], leaf_word[276], leaf_word[230], leaf_word[184], leaf_word[138], leaf_word[92], leaf_word[46], leaf_word[0]};
    wire leaf_has_second = |leaf_present[7:4];
    // A photon behind an absent one.
    wire leaf_has_gap = |(leaf_present[7:1] & ~leaf_present[6:0]);
    // Which chain it is for, if there is that chain.
    wire [2:0] leaf_is_for = leaf_word[378:376];
    wire [2:0] leaf_readies;
    wire [2:0] leaves_given;
    wire [2:0] leaves_refused;
    wire [2:0] sets_too_long;
    wire leaf_taken_0;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_port #(.NUMBER(3), .PLACE(3), .STAGES(1)) photon_port_0(.clock(aclk), .reset(reset),
        .leaf_valid(leaf_valid & leaf_is_for[0]), .leaf_last(leaf_last), .leaf_ready(leaf_readies[0]),
        .leaf_given(leaves_given[0]), .leaf_refused(leaves_refused[0]), .set_too_long(sets_too_long[0]),
        .leaf_taken(leaf_taken_0));
    wire leaf_taken_1;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_port #(.NUMBER(3), .PLACE(3), .STAGES(2)) photon_port_1(.clock(aclk), .reset(reset),
        .leaf_valid(leaf_valid & leaf_is_for[1]), .leaf_last(leaf_last), .leaf_ready(leaf_readies[1]),
        .leaf_given(leaves_given[1]), .leaf_refused(leaves_refused[1]), .set_too_long(sets_too_long[1]),
        .leaf_taken(leaf_taken_1));
    wire leaf_taken_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_port #(.NUMBER(3), .PLACE(3), .STAGES(3)) photon_port_2(.clock(aclk), .reset(reset),
        .leaf_valid(leaf_valid & leaf_is_for[2]), .leaf_last(leaf_last), .leaf_ready(leaf_readies[2]),
        .leaf_given(leaves_given[2]), .leaf_refused(leaves_refused[2]), .set_too_long(sets_too_long[2]),
        .leaf_taken(leaf_taken_2));
    assign leaf_ready = ~(|leaf_is_for) | (|(leaf_is_for & leaf_readies));
    wire leaf_given = |leaves_given;
    wire leaf_unknown = leaf_valid & ~(|leaf_is_for);
    wire leaf_refused = leaf_unknown | (|leaves_refused);
    wire set_too_long = |sets_too_long;
    // The second group follows the first by a clock.
    reg [183:0] second_group;
    always @(posedge aclk) second_group <= leaf_word[367:184];
    wire [376:0] leaf_out = {leaf_chain, leaf_has_second, leaf_last, leaf_word[372:368],
        second_group, leaf_word[183:0]};

    // Queries: a slice, then to the chain of their number.
    wire [103:0] query_word;
    wire query_valid;
    wire query_ready;
    wire query_slice_ready;
    assign s_axis_queries_tready = query_slice_ready & ~reset;
    // A bit that no field has is 1: the coordinate is too large for the frame.
    wire query_in_outside = |{s_axis_queries_tdata[15:9], s_axis_queries_tdata[31:25], s_axis_queries_tdata[47:41], s_axis_queries_tdata[127:97]};
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice #(.WIDTH(104), .HEAD(7)) query_slice(.clock(aclk), .reset(reset),
        .in_valid(s_axis_queries_tvalid), .in_ready(query_slice_ready), .in_word({{s_axis_queries_tdest == 2'd2, s_axis_queries_tdest == 2'd1, s_axis_queries_tdest == 2'd0}, s_axis_queries_tdest, query_in_outside, s_axis_queries_tlast, s_axis_queries_tdata[96:0]}),
        .out_valid(query_valid), .out_ready(query_ready), .out_word(query_word));
    wire [2:0] query_readies;
    wire [2:0] queries_given;
    wire query_is_outside = query_word[98];
    wire [2:0] query_is_for = query_word[103:101];
    assign query_ready = ~(|query_is_for) | (|(query_is_for & query_readies));
    wire query_given = |queries_given;
    wire query_refused = query_valid & ~(|query_is_for);
    wire query_outside = query_given & query_is_outside;
    wire query_taken_0;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_link #(.BITS(5), .STAGES(1)) query_link_0(.clock(aclk), .reset(reset),
        .in_valid(query_valid & query_is_for[0]), .in_ready(query_readies[0]),
        .moves(queries_given[0]), .taken(query_taken_0));
    wire query_taken_1;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_link #(.BITS(5), .STAGES(2)) query_link_1(.clock(aclk), .reset(reset),
        .in_valid(query_valid & query_is_for[1]), .in_ready(query_readies[1]),
        .moves(queries_given[1]), .taken(query_taken_1));
    wire query_taken_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_link #(.BITS(5), .STAGES(3)) query_link_2(.clock(aclk), .reset(reset),
        .in_valid(query_valid & query_is_for[2]), .in_ready(query_readies[2]),
        .moves(queries_given[2]), .taken(query_taken_2));

    // Chain 0.
    wire group_valid_0;
    wire group_ready_0;
    wire group_last_0;
    wire [4:0] group_facing_0;
    wire [183:0] group_0;
    wire result_valid_0;
    wire result_ready_0;
    wire [42:0] result_sums_0;
    wire [17:0] result_tag_0;
    wire chain_query_valid_0;
    wire chain_query_ready_0;
    wire [98:0] query_0;
    wire chain_result_valid_0;
    wire chain_result_ready_0;
    wire [42:0] chain_sums_0;
    wire [17:0] chain_tag_0;
    wire [1:0] compared_0;
    wire [1:0] wanted_0;
    wire played_0;
    reg [1:0] compared_before_0;
    reg [1:0] wanted_before_0;
    reg played_before_0;
    initial compared_before_0 = 2'd0;
    initial wanted_before_0 = 2'd0;
    initial played_before_0 = 1'b0;
    always @(posedge aclk) begin
        compared_before_0 <= reset ? 2'd0 : compared_0;
        wanted_before_0 <= reset ? 2'd0 : wanted_0;
        played_before_0 <= reset ? 1'b0 : played_0;
    end
    wire leaf_passes_0;
    wire [376:0] leaf_stage_0;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_stage #(.WIDTH(377)) leaf_stage_0_register(.clock(aclk), .reset(reset),
        .in_valid(leaf_given), .in_word(leaf_out), .out_valid(leaf_passes_0), .out_word(leaf_stage_0));
    photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_queue #(.GROUP(184), .FACING(5), .PLACE(4)) photon_queue_0(.clock(aclk), .reset(reset),
        .leaf_valid(leaf_passes_0 & (leaf_stage_0[376:375] == 2'd0)), .leaf_has_second(leaf_stage_0[374]),
        .leaf_last(leaf_stage_0[373]), .leaf_facing(leaf_stage_0[372:368]), .first(leaf_stage_0[183:0]), .second(leaf_stage_0[367:184]),
        .leaf_taken(leaf_taken_0), .group_valid(group_valid_0), .group_ready(group_ready_0),
        .group_last(group_last_0), .group_facing(group_facing_0), .group(group_0));
    wire query_passes_0;
    wire [100:0] query_stage_0;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_stage #(.WIDTH(101)) query_stage_0_register(.clock(aclk), .reset(reset),
        .in_valid(query_given), .in_word(query_word[100:0]), .out_valid(query_passes_0), .out_word(query_stage_0));
    wire queued_valid_0;
    wire queued_ready_0;
    wire [98:0] queued_0;
    assign query_taken_0 = queued_valid_0 & queued_ready_0;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_queue #(.WIDTH(99), .PLACE(4)) query_queue_0(.clock(aclk), .reset(reset),
        .in_valid(query_passes_0 & (query_stage_0[100:99] == 2'd0)), .in_word(query_stage_0[98:0]),
        .out_valid(queued_valid_0), .out_ready(queued_ready_0), .out_word(queued_0));
    assign chain_query_valid_0 = queued_valid_0;
    assign queued_ready_0 = chain_query_ready_0;
    assign query_0 = queued_0;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_place #(.WIDTH(61)) result_place_0(.clock(aclk), .reset(reset),
        .in_valid(chain_result_valid_0), .in_ready(chain_result_ready_0),
        .in_word({chain_tag_0, chain_sums_0}), .out_valid(result_valid_0),
        .out_ready(result_ready_0), .out_word({result_tag_0, result_sums_0}));
    photoncube_leaf_5_local7_rgb6d_n64 chain_0(.clock(aclk), .reset(reset),
        .query_valid(chain_query_valid_0), .query_ready(chain_query_ready_0), .query_last(query_0[97]),
        .query_tag({query_0[98:97], query_0[63:48]}),
        .query_x(query_0[8:0]),
        .query_y(query_0[24:16]),
        .query_z(query_0[40:32]),
        .query_facings(query_0[95:64]),
        .query_release(query_0[96]),
        .group_valid(group_valid_0), .group_ready(group_ready_0), .group_last(group_last_0), .group_facing(group_facing_0),
        .photon_present_0(group_0[0]),
        .photon_x_0(group_0[9:1]),
        .photon_y_0(group_0[18:10]),
        .photon_z_0(group_0[27:19]),
        .photon_red_0(group_0[33:28]),
        .photon_green_0(group_0[39:34]),
        .photon_blue_0(group_0[45:40]),
        .photon_present_1(group_0[46]),
        .photon_x_1(group_0[55:47]),
        .photon_y_1(group_0[64:56]),
        .photon_z_1(group_0[73:65]),
        .photon_red_1(group_0[79:74]),
        .photon_green_1(group_0[85:80]),
        .photon_blue_1(group_0[91:86]),
        .photon_present_2(group_0[92]),
        .photon_x_2(group_0[101:93]),
        .photon_y_2(group_0[110:102]),
        .photon_z_2(group_0[119:111]),
        .photon_red_2(group_0[125:120]),
        .photon_green_2(group_0[131:126]),
        .photon_blue_2(group_0[137:132]),
        .photon_present_3(group_0[138]),
        .photon_x_3(group_0[147:139]),
        .photon_y_3(group_0[156:148]),
        .photon_z_3(group_0[165:157]),
        .photon_red_3(group_0[171:166]),
        .photon_green_3(group_0[177:172]),
        .photon_blue_3(group_0[183:178]),
        .result_red(chain_sums_0[11:0]),
        .result_green(chain_sums_0[23:12]),
        .result_blue(chain_sums_0[35:24]),
        .result_count(chain_sums_0[42:36]),
        .result_valid(chain_result_valid_0), .result_ready(chain_result_ready_0), .result_tag(chain_tag_0),
        .compared(compared_0), .wanted(wanted_0), .played(played_0));

    // Chain 1.
    wire group_valid_1;
    wire group_ready_1;
    wire group_last_1;
    wire [4:0] group_facing_1;
    wire [183:0] group_1;
    wire result_valid_1;
    wire result_ready_1;
    wire [42:0] result_sums_1;
    wire [17:0] result_tag_1;
    wire chain_query_valid_1;
    wire chain_query_ready_1;
    wire [98:0] query_1;
    wire chain_result_valid_1;
    wire chain_result_ready_1;
    wire [42:0] chain_sums_1;
    wire [17:0] chain_tag_1;
    wire [1:0] compared_1;
    wire [1:0] wanted_1;
    wire played_1;
    reg [1:0] compared_before_1;
    reg [1:0] wanted_before_1;
    reg played_before_1;
    initial compared_before_1 = 2'd0;
    initial wanted_before_1 = 2'd0;
    initial played_before_1 = 1'b0;
    always @(posedge aclk) begin
        compared_before_1 <= reset ? 2'd0 : compared_1;
        wanted_before_1 <= reset ? 2'd0 : wanted_1;
        played_before_1 <= reset ? 1'b0 : played_1;
    end
    wire leaf_passes_1;
    wire [376:0] leaf_stage_1;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_stage #(.WIDTH(377)) leaf_stage_1_register(.clock(aclk), .reset(reset),
        .in_valid(leaf_passes_0), .in_word(leaf_stage_0), .out_valid(leaf_passes_1), .out_word(leaf_stage_1));
    photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_queue #(.GROUP(184), .FACING(5), .PLACE(4)) photon_queue_1(.clock(aclk), .reset(reset),
        .leaf_valid(leaf_passes_1 & (leaf_stage_1[376:375] == 2'd1)), .leaf_has_second(leaf_stage_1[374]),
        .leaf_last(leaf_stage_1[373]), .leaf_facing(leaf_stage_1[372:368]), .first(leaf_stage_1[183:0]), .second(leaf_stage_1[367:184]),
        .leaf_taken(leaf_taken_1), .group_valid(group_valid_1), .group_ready(group_ready_1),
        .group_last(group_last_1), .group_facing(group_facing_1), .group(group_1));
    wire query_passes_1;
    wire [100:0] query_stage_1;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_stage #(.WIDTH(101)) query_stage_1_register(.clock(aclk), .reset(reset),
        .in_valid(query_passes_0), .in_word(query_stage_0), .out_valid(query_passes_1), .out_word(query_stage_1));
    wire queued_valid_1;
    wire queued_ready_1;
    wire [98:0] queued_1;
    assign query_taken_1 = queued_valid_1 & queued_ready_1;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_queue #(.WIDTH(99), .PLACE(4)) query_queue_1(.clock(aclk), .reset(reset),
        .in_valid(query_passes_1 & (query_stage_1[100:99] == 2'd1)), .in_word(query_stage_1[98:0]),
        .out_valid(queued_valid_1), .out_ready(queued_ready_1), .out_word(queued_1));
    assign chain_query_valid_1 = queued_valid_1;
    assign queued_ready_1 = chain_query_ready_1;
    assign query_1 = queued_1;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_place #(.WIDTH(61)) result_place_1(.clock(aclk), .reset(reset),
        .in_valid(chain_result_valid_1), .in_ready(chain_result_ready_1),
        .in_word({chain_tag_1, chain_sums_1}), .out_valid(result_valid_1),
        .out_ready(result_ready_1), .out_word({result_tag_1, result_sums_1}));
    photoncube_leaf_5_local7_rgb6d_n64 chain_1(.clock(aclk), .reset(reset),
        .query_valid(chain_query_valid_1), .query_ready(chain_query_ready_1), .query_last(query_1[97]),
        .query_tag({query_1[98:97], query_1[63:48]}),
        .query_x(query_1[8:0]),
        .query_y(query_1[24:16]),
        .query_z(query_1[40:32]),
        .query_facings(query_1[95:64]),
        .query_release(query_1[96]),
        .group_valid(group_valid_1), .group_ready(group_ready_1), .group_last(group_last_1), .group_facing(group_facing_1),
        .photon_present_0(group_1[0]),
        .photon_x_0(group_1[9:1]),
        .photon_y_0(group_1[18:10]),
        .photon_z_0(group_1[27:19]),
        .photon_red_0(group_1[33:28]),
        .photon_green_0(group_1[39:34]),
        .photon_blue_0(group_1[45:40]),
        .photon_present_1(group_1[46]),
        .photon_x_1(group_1[55:47]),
        .photon_y_1(group_1[64:56]),
        .photon_z_1(group_1[73:65]),
        .photon_red_1(group_1[79:74]),
        .photon_green_1(group_1[85:80]),
        .photon_blue_1(group_1[91:86]),
        .photon_present_2(group_1[92]),
        .photon_x_2(group_1[101:93]),
        .photon_y_2(group_1[110:102]),
        .photon_z_2(group_1[119:111]),
        .photon_red_2(group_1[125:120]),
        .photon_green_2(group_1[131:126]),
        .photon_blue_2(group_1[137:132]),
        .photon_present_3(group_1[138]),
        .photon_x_3(group_1[147:139]),
        .photon_y_3(group_1[156:148]),
        .photon_z_3(group_1[165:157]),
        .photon_red_3(group_1[171:166]),
        .photon_green_3(group_1[177:172]),
        .photon_blue_3(group_1[183:178]),
        .result_red(chain_sums_1[11:0]),
        .result_green(chain_sums_1[23:12]),
        .result_blue(chain_sums_1[35:24]),
        .result_count(chain_sums_1[42:36]),
        .result_valid(chain_result_valid_1), .result_ready(chain_result_ready_1), .result_tag(chain_tag_1),
        .compared(compared_1), .wanted(wanted_1), .played(played_1));

    // Chain 2.
    wire group_valid_2;
    wire group_ready_2;
    wire group_last_2;
    wire [4:0] group_facing_2;
    wire [183:0] group_2;
    wire result_valid_2;
    wire result_ready_2;
    wire [42:0] result_sums_2;
    wire [17:0] result_tag_2;
    wire chain_query_valid_2;
    wire chain_query_ready_2;
    wire [98:0] query_2;
    wire chain_result_valid_2;
    wire chain_result_ready_2;
    wire [42:0] chain_sums_2;
    wire [17:0] chain_tag_2;
    wire [1:0] compared_2;
    wire [1:0] wanted_2;
    wire played_2;
    reg [1:0] compared_before_2;
    reg [1:0] wanted_before_2;
    reg played_before_2;
    initial compared_before_2 = 2'd0;
    initial wanted_before_2 = 2'd0;
    initial played_before_2 = 1'b0;
    always @(posedge aclk) begin
        compared_before_2 <= reset ? 2'd0 : compared_2;
        wanted_before_2 <= reset ? 2'd0 : wanted_2;
        played_before_2 <= reset ? 1'b0 : played_2;
    end
    wire leaf_passes_2;
    wire [376:0] leaf_stage_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_stage #(.WIDTH(377)) leaf_stage_2_register(.clock(aclk), .reset(reset),
        .in_valid(leaf_passes_1), .in_word(leaf_stage_1), .out_valid(leaf_passes_2), .out_word(leaf_stage_2));
    photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_queue #(.GROUP(184), .FACING(5), .PLACE(4)) photon_queue_2(.clock(aclk), .reset(reset),
        .leaf_valid(leaf_passes_2 & (leaf_stage_2[376:375] == 2'd2)), .leaf_has_second(leaf_stage_2[374]),
        .leaf_last(leaf_stage_2[373]), .leaf_facing(leaf_stage_2[372:368]), .first(leaf_stage_2[183:0]), .second(leaf_stage_2[367:184]),
        .leaf_taken(leaf_taken_2), .group_valid(group_valid_2), .group_ready(group_ready_2),
        .group_last(group_last_2), .group_facing(group_facing_2), .group(group_2));
    wire query_passes_2;
    wire [100:0] query_stage_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_stage #(.WIDTH(101)) query_stage_2_register(.clock(aclk), .reset(reset),
        .in_valid(query_passes_1), .in_word(query_stage_1), .out_valid(query_passes_2), .out_word(query_stage_2));
    wire queued_valid_2;
    wire queued_ready_2;
    wire [98:0] queued_2;
    assign query_taken_2 = queued_valid_2 & queued_ready_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_queue #(.WIDTH(99), .PLACE(4)) query_queue_2(.clock(aclk), .reset(reset),
        .in_valid(query_passes_2 & (query_stage_2[100:99] == 2'd2)), .in_word(query_stage_2[98:0]),
        .out_valid(queued_valid_2), .out_ready(queued_ready_2), .out_word(queued_2));
    assign chain_query_valid_2 = queued_valid_2;
    assign queued_ready_2 = chain_query_ready_2;
    assign query_2 = queued_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_place #(.WIDTH(61)) result_place_2(.clock(aclk), .reset(reset),
        .in_valid(chain_result_valid_2), .in_ready(chain_result_ready_2),
        .in_word({chain_tag_2, chain_sums_2}), .out_valid(result_valid_2),
        .out_ready(result_ready_2), .out_word({result_tag_2, result_sums_2}));
    photoncube_leaf_5_local7_rgb6d_n64 chain_2(.clock(aclk), .reset(reset),
        .query_valid(chain_query_valid_2), .query_ready(chain_query_ready_2), .query_last(query_2[97]),
        .query_tag({query_2[98:97], query_2[63:48]}),
        .query_x(query_2[8:0]),
        .query_y(query_2[24:16]),
        .query_z(query_2[40:32]),
        .query_facings(query_2[95:64]),
        .query_release(query_2[96]),
        .group_valid(group_valid_2), .group_ready(group_ready_2), .group_last(group_last_2), .group_facing(group_facing_2),
        .photon_present_0(group_2[0]),
        .photon_x_0(group_2[9:1]),
        .photon_y_0(group_2[18:10]),
        .photon_z_0(group_2[27:19]),
        .photon_red_0(group_2[33:28]),
        .photon_green_0(group_2[39:34]),
        .photon_blue_0(group_2[45:40]),
        .photon_present_1(group_2[46]),
        .photon_x_1(group_2[55:47]),
        .photon_y_1(group_2[64:56]),
        .photon_z_1(group_2[73:65]),
        .photon_red_1(group_2[79:74]),
        .photon_green_1(group_2[85:80]),
        .photon_blue_1(group_2[91:86]),
        .photon_present_2(group_2[92]),
        .photon_x_2(group_2[101:93]),
        .photon_y_2(group_2[110:102]),
        .photon_z_2(group_2[119:111]),
        .photon_red_2(group_2[125:120]),
        .photon_green_2(group_2[131:126]),
        .photon_blue_2(group_2[137:132]),
        .photon_present_3(group_2[138]),
        .photon_x_3(group_2[147:139]),
        .photon_y_3(group_2[156:148]),
        .photon_z_3(group_2[165:157]),
        .photon_red_3(group_2[171:166]),
        .photon_green_3(group_2[177:172]),
        .photon_blue_3(group_2[183:178]),
        .result_red(chain_sums_2[11:0]),
        .result_green(chain_sums_2[23:12]),
        .result_blue(chain_sums_2[35:24]),
        .result_count(chain_sums_2[42:36]),
        .result_valid(chain_result_valid_2), .result_ready(chain_result_ready_2), .result_tag(chain_tag_2),
        .compared(compared_2), .wanted(wanted_2), .played(played_2));

    // Results: each chain's are merged with those of the chains behind it, then a slice.
    wire unused_ready;
    wire result_comes_2;
    wire result_goes_2;
    wire [62:0] result_merged_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_merge #(.WIDTH(63)) merge_2(.clock(aclk), .reset(reset),
        .own_valid(result_valid_2), .own_ready(result_ready_2),
        .own_word({2'd2, result_tag_2[17], result_tag_2[16], result_tag_2[15:0], result_sums_2}),
        .passing_valid(1'b0), .passing_ready(unused_ready), .passing_word(63'd0),
        .out_valid(result_comes_2), .out_ready(result_goes_2), .out_word(result_merged_2));
    wire result_comes_1;
    wire result_goes_1;
    wire [62:0] result_merged_1;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_merge #(.WIDTH(63)) merge_1(.clock(aclk), .reset(reset),
        .own_valid(result_valid_1), .own_ready(result_ready_1),
        .own_word({2'd1, result_tag_1[17], result_tag_1[16], result_tag_1[15:0], result_sums_1}),
        .passing_valid(result_comes_2), .passing_ready(result_goes_2), .passing_word(result_merged_2),
        .out_valid(result_comes_1), .out_ready(result_goes_1), .out_word(result_merged_1));
    wire result_comes_0;
    wire result_goes_0;
    wire [62:0] result_merged_0;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_merge #(.WIDTH(63)) merge_0(.clock(aclk), .reset(reset),
        .own_valid(result_valid_0), .own_ready(result_ready_0),
        .own_word({2'd0, result_tag_0[17], result_tag_0[16], result_tag_0[15:0], result_sums_0}),
        .passing_valid(result_comes_1), .passing_ready(result_goes_1), .passing_word(result_merged_1),
        .out_valid(result_comes_0), .out_ready(result_goes_0), .out_word(result_merged_0));
    // The sums of a query outside of its frame are 0.
    wire result_outside = result_merged_0[60];
    wire [42:0] result_seen = result_outside ? {43{1'b0}} : result_merged_0[42:0];
    wire result_waits;
    wire [62:0] result_word;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice #(.WIDTH(63), .HEAD(4)) result_slice(.clock(aclk), .reset(reset),
        .in_valid(result_comes_0), .in_ready(result_goes_0), .in_word({result_merged_0[62:43], result_seen}),
        .out_valid(result_waits), .out_ready(m_axis_results_tready), .out_word(result_word));
    // A result of before a reset is not given in the clock of the reset.
    assign m_axis_results_tvalid = result_waits & ~reset;
    assign m_axis_results_tdata = {5'd0, result_word[58:0]};
    assign m_axis_results_tlast = result_word[59];
    assign m_axis_results_tuser = result_word[60];
    assign m_axis_results_tid = result_word[62:61];
    wire result_moves = m_axis_results_tvalid & m_axis_results_tready;
    wire [6:0] result_photons = result_moves ? result_word[42:36] : 7'd0;

    // What the chains did in the clock before, for the counters.
    wire [2:0] compared = reset ? 3'd0 : compared_before_0 + compared_before_1 + compared_before_2;
    wire [2:0] wanted = reset ? 3'd0 : wanted_before_0 + wanted_before_1 + wanted_before_2;
    wire [1:0] played = reset ? 2'd0 : played_before_0 + played_before_1 + played_before_2;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_registers registers(
        .aresetn(aresetn),
        .s_axi_awaddr(s_axi_awaddr),
        .s_axi_awvalid(s_axi_awvalid),
        .s_axi_awready(s_axi_awready),
        .s_axi_wdata(s_axi_wdata),
        .s_axi_wstrb(s_axi_wstrb),
        .s_axi_wvalid(s_axi_wvalid),
        .s_axi_wready(s_axi_wready),
        .s_axi_bresp(s_axi_bresp),
        .s_axi_bvalid(s_axi_bvalid),
        .s_axi_bready(s_axi_bready),
        .s_axi_araddr(s_axi_araddr),
        .s_axi_arvalid(s_axi_arvalid),
        .s_axi_arready(s_axi_arready),
        .s_axi_rdata(s_axi_rdata),
        .s_axi_rresp(s_axi_rresp),
        .s_axi_rvalid(s_axi_rvalid),
        .s_axi_rready(s_axi_rready),
        .irq(irq),
        .reset(reset),
        .result_moves(result_moves),
        .result_photons(result_photons),
        .leaf_given(leaf_given),
        .leaf_refused(leaf_refused),
        .set_too_long(set_too_long),
        .query_given(query_given),
        .query_refused(query_refused),
        .query_outside(query_outside),
        .compared(compared),
        .wanted(wanted),
        .played(played),
        .clock(aclk),
        .photon_moves(s_axis_photons_tvalid & s_axis_photons_tready),
        .photon_waits(s_axis_photons_tvalid & ~s_axis_photons_tready),
        .query_moves(s_axis_queries_tvalid & s_axis_queries_tready),
        .query_waits(s_axis_queries_tvalid & ~s_axis_queries_tready),
        .result_waits(m_axis_results_tvalid & ~m_axis_results_tready),
        .leaf_malformed(leaf_given & leaf_has_gap),
        .chain_unknown(leaf_unknown | query_refused));
endmodule

// The registers of the core, behind AXI4-Lite, and its counters.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_registers(clock, aresetn, reset,
    s_axi_awaddr, s_axi_awvalid, s_axi_awready, s_axi_wdata, s_axi_wstrb, s_axi_wvalid, s_axi_wready,
    s_axi_bresp, s_axi_bvalid, s_axi_bready, s_axi_araddr, s_axi_arvalid, s_axi_arready,
    s_axi_rdata, s_axi_rresp, s_axi_rvalid, s_axi_rready, irq,
    photon_moves, photon_waits, query_moves, query_waits, result_moves, result_waits, result_photons,
    leaf_given, leaf_refused, leaf_malformed, set_too_long, query_given, query_refused, query_outside,
    chain_unknown, compared, wanted, played);
    input wire clock;
    input wire aresetn;
    output reg reset;
    input wire [8:0] s_axi_awaddr;
    input wire s_axi_awvalid;
    output wire s_axi_awready;
    input wire [31:0] s_axi_wdata;
    input wire [3:0] s_axi_wstrb;
    input wire s_axi_wvalid;
    output wire s_axi_wready;
    output reg [1:0] s_axi_bresp;
    output reg s_axi_bvalid;
    input wire s_axi_bready;
    input wire [8:0] s_axi_araddr;
    input wire s_axi_arvalid;
    output wire s_axi_arready;
    output reg [31:0] s_axi_rdata;
    output reg [1:0] s_axi_rresp;
    output reg s_axi_rvalid;
    input wire s_axi_rready;
    output wire irq;
    // What happens in this clock.
    input wire photon_moves;
    input wire photon_waits;
    input wire query_moves;
    input wire query_waits;
    input wire result_moves;
    input wire result_waits;
    input wire [6:0] result_photons;
    input wire leaf_given;
    input wire leaf_refused;
    input wire leaf_malformed;
    input wire set_too_long;
    input wire query_given;
    input wire query_refused;
    input wire query_outside;
    input wire chain_unknown;
    input wire [2:0] compared;
    input wire [2:0] wanted;
    input wire [1:0] played;
    // The addresses, in bytes.
    localparam ADDRESS_IDENTITY = 9'h000;
    localparam ADDRESS_VERSION = 9'h004;
    localparam ADDRESS_DIGEST_LOW = 9'h008;
    localparam ADDRESS_DIGEST_HIGH = 9'h00c;
    localparam ADDRESS_SHAPE = 9'h010;
    localparam ADDRESS_CONTROL = 9'h014;
    localparam ADDRESS_STATUS = 9'h018;
    localparam ADDRESS_EVENTS = 9'h01c;
    localparam ADDRESS_INTERRUPT_ENABLE = 9'h020;
    localparam ADDRESS_STALL_LIMIT = 9'h024;
    localparam ADDRESS_UNDER_WAY = 9'h028;
    localparam ADDRESS_CLOCKS_LOW = 9'h040;
    localparam ADDRESS_CLOCKS_HIGH = 9'h044;
    localparam ADDRESS_BUSY_CLOCKS_LOW = 9'h048;
    localparam ADDRESS_BUSY_CLOCKS_HIGH = 9'h04c;
    localparam ADDRESS_LEAVES_READ_LOW = 9'h050;
    localparam ADDRESS_LEAVES_READ_HIGH = 9'h054;
    localparam ADDRESS_QUERIES_READ_LOW = 9'h058;
    localparam ADDRESS_QUERIES_READ_HIGH = 9'h05c;
    localparam ADDRESS_RESULTS_LOW = 9'h060;
    localparam ADDRESS_RESULTS_HIGH = 9'h064;
    localparam ADDRESS_LEAVES_COMPARED_LOW = 9'h068;
    localparam ADDRESS_LEAVES_COMPARED_HIGH = 9'h06c;
    localparam ADDRESS_LEAVES_WANTED_LOW = 9'h070;
    localparam ADDRESS_LEAVES_WANTED_HIGH = 9'h074;
    localparam ADDRESS_GROUPS_PLAYED_LOW = 9'h078;
    localparam ADDRESS_GROUPS_PLAYED_HIGH = 9'h07c;
    localparam ADDRESS_PHOTONS_IN_RANGE_LOW = 9'h080;
    localparam ADDRESS_PHOTONS_IN_RANGE_HIGH = 9'h084;
    localparam ADDRESS_PHOTON_STALLS_LOW = 9'h088;
    localparam ADDRESS_PHOTON_STALLS_HIGH = 9'h08c;
    localparam ADDRESS_QUERY_STALLS_LOW = 9'h090;
    localparam ADDRESS_QUERY_STALLS_HIGH = 9'h094;
    localparam ADDRESS_RESULT_STALLS_LOW = 9'h098;
    localparam ADDRESS_RESULT_STALLS_HIGH = 9'h09c;
    localparam ADDRESS_LEAVES_MALFORMED_LOW = 9'h0a0;
    localparam ADDRESS_LEAVES_MALFORMED_HIGH = 9'h0a4;
    localparam ADDRESS_LEAVES_REFUSED_LOW = 9'h0a8;
    localparam ADDRESS_LEAVES_REFUSED_HIGH = 9'h0ac;
    localparam ADDRESS_QUERIES_OUTSIDE_LOW = 9'h0b0;
    localparam ADDRESS_QUERIES_OUTSIDE_HIGH = 9'h0b4;
    localparam ADDRESS_QUERIES_REFUSED_LOW = 9'h0b8;
    localparam ADDRESS_QUERIES_REFUSED_HIGH = 9'h0bc;
    localparam ADDRESS_ACCESSES_REFUSED_LOW = 9'h0c0;
    localparam ADDRESS_ACCESSES_REFUSED_HIGH = 9'h0c4;
    localparam OKAY = 2'b00;
    localparam SLVERR = 2'b10;
    reg [47:0] counter_clocks;
    initial counter_clocks = 48'd0;
    reg [47:0] counter_busy_clocks;
    initial counter_busy_clocks = 48'd0;
    reg [47:0] counter_leaves_read;
    initial counter_leaves_read = 48'd0;
    reg [47:0] counter_queries_read;
    initial counter_queries_read = 48'd0;
    reg [47:0] counter_results;
    initial counter_results = 48'd0;
    reg [47:0] counter_leaves_compared;
    initial counter_leaves_compared = 48'd0;
    reg [47:0] counter_leaves_wanted;
    initial counter_leaves_wanted = 48'd0;
    reg [47:0] counter_groups_played;
    initial counter_groups_played = 48'd0;
    reg [47:0] counter_photons_in_range;
    initial counter_photons_in_range = 48'd0;
    reg [47:0] counter_photon_stalls;
    initial counter_photon_stalls = 48'd0;
    reg [47:0] counter_query_stalls;
    initial counter_query_stalls = 48'd0;
    reg [47:0] counter_result_stalls;
    initial counter_result_stalls = 48'd0;
    reg [47:0] counter_leaves_malformed;
    initial counter_leaves_malformed = 48'd0;
    reg [47:0] counter_leaves_refused;
    initial counter_leaves_refused = 48'd0;
    reg [47:0] counter_queries_outside;
    initial counter_queries_outside = 48'd0;
    reg [47:0] counter_queries_refused;
    initial counter_queries_refused = 48'd0;
    reg [47:0] counter_accesses_refused;
    initial counter_accesses_refused = 48'd0;
    reg [6:0] events;
    reg [6:0] interrupt_enable;
    reg [31:0] stall_limit;
    reg [15:0] under_way;
    // Whether a query was given and a last result left in the clock before: the ways to the number of queries under way are too far for one clock.
    reg query_came;
    reg result_went;
    // Whether the clock before was silent, and the number of silent clocks up to the one before that.
    reg seen_silent;
    reg [31:0] silent_clocks;
    // Whether a read was taken in the clock before, and which register has its address.
    reg reading;
    reg [44:0] selected;
    initial reading = 1'b0;
    // Whether the answer to a read was found in the clock before: whether there is the register, and its word in 4 parts of which all
    // but one are 0. The way from all registers to the answer is too far for one clock.
    reg found;
    reg found_known;
    reg [31:0] found_0;
    reg [31:0] found_1;
    reg [31:0] found_2;
    reg [31:0] found_3;
    initial found = 1'b0;
    // The high bits of the counter whose low word was read last.
    reg [47 - 32:0] counter_high;
    // What happened in the clock before: the way to the counters is too far for the clock in which it happens.
    reg seen_busy;
    initial seen_busy = 1'd0;
    reg seen_leaf_given;
    initial seen_leaf_given = 1'd0;
    reg seen_query_given;
    initial seen_query_given = 1'd0;
    reg seen_result_moves;
    initial seen_result_moves = 1'd0;
    reg [2:0] seen_compared;
    initial seen_compared = 3'd0;
    reg [2:0] seen_wanted;
    initial seen_wanted = 3'd0;
    reg [1:0] seen_played;
    initial seen_played = 2'd0;
    reg [6:0] seen_result_photons;
    initial seen_result_photons = 7'd0;
    reg seen_photon_waits;
    initial seen_photon_waits = 1'd0;
    reg seen_query_waits;
    initial seen_query_waits = 1'd0;
    reg seen_result_waits;
    initial seen_result_waits = 1'd0;
    reg seen_leaf_malformed;
    initial seen_leaf_malformed = 1'd0;
    reg seen_leaf_refused;
    initial seen_leaf_refused = 1'd0;
    reg seen_query_outside;
    initial seen_query_outside = 1'd0;
    reg seen_query_refused;
    initial seen_query_refused = 1'd0;
    reg seen_ends;
    initial seen_ends = 1'd0;
    reg seen_set_too_long;
    initial seen_set_too_long = 1'd0;
    reg seen_chain_unknown;
    initial seen_chain_unknown = 1'd0;
    reg seen_stalls;
    initial seen_stalls = 1'd0;
    // Whether a write and a read were answered in the clock before.
    reg seen_write;
    reg seen_read;
    initial seen_write = 1'b0;
    initial seen_read = 1'b0;
    initial s_axi_bvalid = 1'b0;
    initial s_axi_rvalid = 1'b0;
    initial events = {(6 + 1){1'b0}};
    initial interrupt_enable = {(6 + 1){1'b0}};
    initial stall_limit = 32'h00020000;
    initial under_way = 16'd0;
    initial query_came = 1'b0;
    initial result_went = 1'b0;
    initial seen_silent = 1'b0;
    initial silent_clocks = 32'd0;
    initial counter_high = {(47 - 31){1'b0}};
    initial reset = 1'b0;
    wire busy = |under_way;
    // The next numbers of queries under way.
    (* keep *) wire [15:0] one_more;
    assign one_more = under_way + 16'd1;
    (* keep *) wire [15:0] one_less;
    assign one_less = under_way - 16'd1;

    // An access is taken where its answer has a place.
    wire writes = s_axi_awvalid & s_axi_wvalid & ~s_axi_bvalid & aresetn;
    assign s_axi_awready = writes;
    assign s_axi_wready = writes;
    assign s_axi_arready = ~s_axi_rvalid & ~reading & ~found & aresetn;
    wire [31:0] write_mask = {{8{s_axi_wstrb[3]}}, {8{s_axi_wstrb[2]}}, {8{s_axi_wstrb[1]}}, {8{s_axi_wstrb[0]}}};
    wire [31:0] write_word = s_axi_wdata & write_mask;
    // The two low bits are not looked at: the strobes name the bytes.
    wire [8:0] write_address = {s_axi_awaddr[8:2], 2'b00};
    wire [8:0] read_address = {s_axi_araddr[8:2], 2'b00};
    reg write_known;
    always @(*) begin
        write_known = 1'b0;
        case (write_address)
            ADDRESS_CONTROL: write_known = 1'b1;
            ADDRESS_EVENTS: write_known = 1'b1;
            ADDRESS_INTERRUPT_ENABLE: write_known = 1'b1;
            ADDRESS_STALL_LIMIT: write_known = 1'b1;
            default: write_known = 1'b0;
        endcase
    end
    wire reads_low = 1'b0
        | selected[11]
        | selected[13]
        | selected[15]
        | selected[17]
        | selected[19]
        | selected[21]
        | selected[23]
        | selected[25]
        | selected[27]
        | selected[29]
        | selected[31]
        | selected[33]
        | selected[35]
        | selected[37]
        | selected[39]
        | selected[41]
        | selected[43];
    wire [47 - 32:0] counter_high_next = {(47 - 31){1'b0}}
        | ({16{selected[11]}} & counter_clocks[47:32])
        | ({16{selected[13]}} & counter_busy_clocks[47:32])
        | ({16{selected[15]}} & counter_leaves_read[47:32])
        | ({16{selected[17]}} & counter_queries_read[47:32])
        | ({16{selected[19]}} & counter_results[47:32])
        | ({16{selected[21]}} & counter_leaves_compared[47:32])
        | ({16{selected[23]}} & counter_leaves_wanted[47:32])
        | ({16{selected[25]}} & counter_groups_played[47:32])
        | ({16{selected[27]}} & counter_photons_in_range[47:32])
        | ({16{selected[29]}} & counter_photon_stalls[47:32])
        | ({16{selected[31]}} & counter_query_stalls[47:32])
        | ({16{selected[33]}} & counter_result_stalls[47:32])
        | ({16{selected[35]}} & counter_leaves_malformed[47:32])
        | ({16{selected[37]}} & counter_leaves_refused[47:32])
        | ({16{selected[39]}} & counter_queries_outside[47:32])
        | ({16{selected[41]}} & counter_queries_refused[47:32])
        | ({16{selected[43]}} & counter_accesses_refused[47:32]);
    wire write_refused = seen_write & (s_axi_bresp != OKAY);
    wire read_refused = seen_read & (s_axi_rresp != OKAY);
    wire [1:0] seen_refused = write_refused + read_refused;
    wire writes_control = writes & (write_address == ADDRESS_CONTROL);
    wire clears_counters = writes_control & write_word[1];
    wire writes_events = writes & (write_address == ADDRESS_EVENTS);
    wire writes_enable = writes & (write_address == ADDRESS_INTERRUPT_ENABLE);
    wire writes_limit = writes & (write_address == ADDRESS_STALL_LIMIT);

    wire ends = result_went & ~query_came & (under_way == 16'd1);
    wire silent = (busy | photon_waits | query_waits) & ~(photon_moves | query_moves | result_moves) & ~result_waits;
    wire stalls = (|stall_limit) & (silent_clocks == stall_limit);
    wire [6:0] occurred;
    assign occurred[0] = |seen_ends;
    assign occurred[1] = |seen_leaf_malformed;
    assign occurred[2] = |seen_set_too_long;
    assign occurred[3] = |seen_query_outside;
    assign occurred[4] = |seen_chain_unknown;
    assign occurred[5] = |seen_refused;
    assign occurred[6] = |seen_stalls;
    wire [6:0] cleared = writes_events ? write_word[6:0] : {(6 + 1){1'b0}};
    assign irq = |(events & interrupt_enable);

    always @(posedge clock) begin
        if (writes) begin
            s_axi_bvalid <= 1'b1;
            s_axi_bresp <= write_known ? OKAY : SLVERR;
        end else if (s_axi_bready) s_axi_bvalid <= 1'b0;
        reading <= s_axi_arvalid & s_axi_arready;
        selected[0] <= read_address == ADDRESS_IDENTITY;
        selected[1] <= read_address == ADDRESS_VERSION;
        selected[2] <= read_address == ADDRESS_DIGEST_LOW;
        selected[3] <= read_address == ADDRESS_DIGEST_HIGH;
        selected[4] <= read_address == ADDRESS_SHAPE;
        selected[5] <= read_address == ADDRESS_CONTROL;
        selected[6] <= read_address == ADDRESS_STATUS;
        selected[7] <= read_address == ADDRESS_EVENTS;
        selected[8] <= read_address == ADDRESS_INTERRUPT_ENABLE;
        selected[9] <= read_address == ADDRESS_STALL_LIMIT;
        selected[10] <= read_address == ADDRESS_UNDER_WAY;
        selected[11] <= read_address == ADDRESS_CLOCKS_LOW;
        selected[12] <= read_address == ADDRESS_CLOCKS_HIGH;
        selected[13] <= read_address == ADDRESS_BUSY_CLOCKS_LOW;
        selected[14] <= read_address == ADDRESS_BUSY_CLOCKS_HIGH;
        selected[15] <= read_address == ADDRESS_LEAVES_READ_LOW;
        selected[16] <= read_address == ADDRESS_LEAVES_READ_HIGH;
        selected[17] <= read_address == ADDRESS_QUERIES_READ_LOW;
        selected[18] <= read_address == ADDRESS_QUERIES_READ_HIGH;
        selected[19] <= read_address == ADDRESS_RESULTS_LOW;
        selected[20] <= read_address == ADDRESS_RESULTS_HIGH;
        selected[21] <= read_address == ADDRESS_LEAVES_COMPARED_LOW;
        selected[22] <= read_address == ADDRESS_LEAVES_COMPARED_HIGH;
        selected[23] <= read_address == ADDRESS_LEAVES_WANTED_LOW;
        selected[24] <= read_address == ADDRESS_LEAVES_WANTED_HIGH;
        selected[25] <= read_address == ADDRESS_GROUPS_PLAYED_LOW;
        selected[26] <= read_address == ADDRESS_GROUPS_PLAYED_HIGH;
        selected[27] <= read_address == ADDRESS_PHOTONS_IN_RANGE_LOW;
        selected[28] <= read_address == ADDRESS_PHOTONS_IN_RANGE_HIGH;
        selected[29] <= read_address == ADDRESS_PHOTON_STALLS_LOW;
        selected[30] <= read_address == ADDRESS_PHOTON_STALLS_HIGH;
        selected[31] <= read_address == ADDRESS_QUERY_STALLS_LOW;
        selected[32] <= read_address == ADDRESS_QUERY_STALLS_HIGH;
        selected[33] <= read_address == ADDRESS_RESULT_STALLS_LOW;
        selected[34] <= read_address == ADDRESS_RESULT_STALLS_HIGH;
        selected[35] <= read_address == ADDRESS_LEAVES_MALFORMED_LOW;
        selected[36] <= read_address == ADDRESS_LEAVES_MALFORMED_HIGH;
        selected[37] <= read_address == ADDRESS_LEAVES_REFUSED_LOW;
        selected[38] <= read_address == ADDRESS_LEAVES_REFUSED_HIGH;
        selected[39] <= read_address == ADDRESS_QUERIES_OUTSIDE_LOW;
        selected[40] <= read_address == ADDRESS_QUERIES_OUTSIDE_HIGH;
        selected[41] <= read_address == ADDRESS_QUERIES_REFUSED_LOW;
        selected[42] <= read_address == ADDRESS_QUERIES_REFUSED_HIGH;
        selected[43] <= read_address == ADDRESS_ACCESSES_REFUSED_LOW;
        selected[44] <= read_address == ADDRESS_ACCESSES_REFUSED_HIGH;
        found <= reading & aresetn;
        found_known <= |selected;
        found_0 <= 32'd0
            | ({32{selected[0]}} & 32'h50435542)
            | ({32{selected[1]}} & 32'h00000001)
            | ({32{selected[2]}} & 32'hd727f457)
            | ({32{selected[3]}} & 32'hcb0b1e2f)
            | ({32{selected[4]}} & 32'h00080203)
            | ({32{selected[5]}} & 32'd0)
            | ({32{selected[6]}} & {28'd0, result_waits, query_waits, photon_waits, busy})
            | ({32{selected[7]}} & {25'd0, events})
            | ({32{selected[8]}} & {25'd0, interrupt_enable})
            | ({32{selected[9]}} & stall_limit)
            | ({32{selected[10]}} & {16'd0, under_way})
            | ({32{selected[11]}} & counter_clocks[31:0]);
        found_1 <= 32'd0
            | ({32{selected[12]}} & {16'd0, counter_high})
            | ({32{selected[13]}} & counter_busy_clocks[31:0])
            | ({32{selected[14]}} & {16'd0, counter_high})
            | ({32{selected[15]}} & counter_leaves_read[31:0])
            | ({32{selected[16]}} & {16'd0, counter_high})
            | ({32{selected[17]}} & counter_queries_read[31:0])
            | ({32{selected[18]}} & {16'd0, counter_high})
            | ({32{selected[19]}} & counter_results[31:0])
            | ({32{selected[20]}} & {16'd0, counter_high})
            | ({32{selected[21]}} & counter_leaves_compared[31:0])
            | ({32{selected[22]}} & {16'd0, counter_high})
            | ({32{selected[23]}} & counter_leaves_wanted[31:0]);
        found_2 <= 32'd0
            | ({32{selected[24]}} & {16'd0, counter_high})
            | ({32{selected[25]}} & counter_groups_played[31:0])
            | ({32{selected[26]}} & {16'd0, counter_high})
            | ({32{selected[27]}} & counter_photons_in_range[31:0])
            | ({32{selected[28]}} & {16'd0, counter_high})
            | ({32{selected[29]}} & counter_photon_stalls[31:0])
            | ({32{selected[30]}} & {16'd0, counter_high})
            | ({32{selected[31]}} & counter_query_stalls[31:0])
            | ({32{selected[32]}} & {16'd0, counter_high})
            | ({32{selected[33]}} & counter_result_stalls[31:0])
            | ({32{selected[34]}} & {16'd0, counter_high})
            | ({32{selected[35]}} & counter_leaves_malformed[31:0]);
        found_3 <= 32'd0
            | ({32{selected[36]}} & {16'd0, counter_high})
            | ({32{selected[37]}} & counter_leaves_refused[31:0])
            | ({32{selected[38]}} & {16'd0, counter_high})
            | ({32{selected[39]}} & counter_queries_outside[31:0])
            | ({32{selected[40]}} & {16'd0, counter_high})
            | ({32{selected[41]}} & counter_queries_refused[31:0])
            | ({32{selected[42]}} & {16'd0, counter_high})
            | ({32{selected[43]}} & counter_accesses_refused[31:0])
            | ({32{selected[44]}} & {16'd0, counter_high});
        if (reading & reads_low) counter_high <= counter_high_next;
        if (found) begin
            s_axi_rvalid <= 1'b1;
            s_axi_rresp <= found_known ? OKAY : SLVERR;
            s_axi_rdata <= found_0 | found_1 | found_2 | found_3;
        end else if (s_axi_rready) s_axi_rvalid <= 1'b0;
        // A register, since the way to every chain is too far for the clock in which it is decided.
        reset <= ~aresetn | (writes_control & write_word[0]);
        events <= (events & ~cleared) | occurred;
        if (writes_enable) begin
            interrupt_enable <= (interrupt_enable & ~write_mask[6:0]) | write_word[6:0];
        end
        if (writes_limit) stall_limit <= (stall_limit & ~write_mask) | write_word;
        query_came <= query_given;
        result_went <= result_moves;
        if (query_came & ~result_went) under_way <= one_more;
        if (result_went & ~query_came) under_way <= one_less;
        seen_silent <= silent;
        silent_clocks <= seen_silent ? silent_clocks + 32'd1 : 32'd0;
        if (reset | ~aresetn) begin
            under_way <= 16'd0;
            query_came <= 1'b0;
            result_went <= 1'b0;
            seen_silent <= 1'b0;
            silent_clocks <= 32'd0;
        end
        seen_write <= writes;
        seen_read <= found & aresetn;
        seen_busy <= busy;
        seen_leaf_given <= leaf_given;
        seen_query_given <= query_given;
        seen_result_moves <= result_moves;
        seen_compared <= compared;
        seen_wanted <= wanted;
        seen_played <= played;
        seen_result_photons <= result_photons;
        seen_photon_waits <= photon_waits;
        seen_query_waits <= query_waits;
        seen_result_waits <= result_waits;
        seen_leaf_malformed <= leaf_malformed;
        seen_leaf_refused <= leaf_refused;
        seen_query_outside <= query_outside;
        seen_query_refused <= query_refused;
        seen_ends <= ends;
        seen_set_too_long <= set_too_long;
        seen_chain_unknown <= chain_unknown;
        seen_stalls <= stalls;
        if (clears_counters | ~aresetn) begin
            counter_clocks <= 48'd0;
            counter_busy_clocks <= 48'd0;
            counter_leaves_read <= 48'd0;
            counter_queries_read <= 48'd0;
            counter_results <= 48'd0;
            counter_leaves_compared <= 48'd0;
            counter_leaves_wanted <= 48'd0;
            counter_groups_played <= 48'd0;
            counter_photons_in_range <= 48'd0;
            counter_photon_stalls <= 48'd0;
            counter_query_stalls <= 48'd0;
            counter_result_stalls <= 48'd0;
            counter_leaves_malformed <= 48'd0;
            counter_leaves_refused <= 48'd0;
            counter_queries_outside <= 48'd0;
            counter_queries_refused <= 48'd0;
            counter_accesses_refused <= 48'd0;
        end else begin
            counter_clocks <= counter_clocks + 1'b1;
            counter_busy_clocks <= counter_busy_clocks + seen_busy;
            counter_leaves_read <= counter_leaves_read + seen_leaf_given;
            counter_queries_read <= counter_queries_read + seen_query_given;
            counter_results <= counter_results + seen_result_moves;
            counter_leaves_compared <= counter_leaves_compared + seen_compared;
            counter_leaves_wanted <= counter_leaves_wanted + seen_wanted;
            counter_groups_played <= counter_groups_played + seen_played;
            counter_photons_in_range <= counter_photons_in_range + seen_result_photons;
            counter_photon_stalls <= counter_photon_stalls + seen_photon_waits;
            counter_query_stalls <= counter_query_stalls + seen_query_waits;
            counter_result_stalls <= counter_result_stalls + seen_result_waits;
            counter_leaves_malformed <= counter_leaves_malformed + seen_leaf_malformed;
            counter_leaves_refused <= counter_leaves_refused + seen_leaf_refused;
            counter_queries_outside <= counter_queries_outside + seen_query_outside;
            counter_queries_refused <= counter_queries_refused + seen_query_refused;
            counter_accesses_refused <= counter_accesses_refused + seen_refused;
        end
        if (~aresetn) begin
            s_axi_bvalid <= 1'b0;
            s_axi_rvalid <= 1'b0;
            events <= {(6 + 1){1'b0}};
            interrupt_enable <= {(6 + 1){1'b0}};
            stall_limit <= 32'h00020000;
            counter_high <= {(47 - 31){1'b0}};
            seen_busy <= 1'd0;
            seen_leaf_given <= 1'd0;
            seen_query_given <= 1'd0;
            seen_result_moves <= 1'd0;
            seen_compared <= 3'd0;
            seen_wanted <= 3'd0;
            seen_played <= 2'd0;
            seen_result_photons <= 7'd0;
            seen_photon_waits <= 1'd0;
            seen_query_waits <= 1'd0;
            seen_result_waits <= 1'd0;
            seen_leaf_malformed <= 1'd0;
            seen_leaf_refused <= 1'd0;
            seen_query_outside <= 1'd0;
            seen_query_refused <= 1'd0;
            seen_ends <= 1'd0;
            seen_set_too_long <= 1'd0;
            seen_chain_unknown <= 1'd0;
            seen_stalls <= 1'd0;
        end
    end
endmodule


// A slice of a stream. It has two places, so that no ready passes through it. A word stays in its place until it goes, and only its
// HEAD highest bits move to the first place.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_slice(clock, reset, in_valid, in_ready, in_word, out_valid, out_ready, out_word);
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
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice_part #(.WIDTH(PART)) part_0(.clock(clock), .even_next(even_next), .odd_next(odd_next), .goes_odd_next(goes_odd_next),
        .in_word(in_word[PART - 1:0]), .out_word(out_word[PART - 1:0]));
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice_part #(.WIDTH(PART)) part_1(.clock(clock), .even_next(even_next), .odd_next(odd_next), .goes_odd_next(goes_odd_next),
        .in_word(in_word[2 * PART - 1:PART]), .out_word(out_word[2 * PART - 1:PART]));
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice_part #(.WIDTH(PART)) part_2(.clock(clock), .even_next(even_next), .odd_next(odd_next), .goes_odd_next(goes_odd_next),
        .in_word(in_word[3 * PART - 1:2 * PART]), .out_word(out_word[3 * PART - 1:2 * PART]));
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice_part #(.WIDTH(BODY - 3 * PART)) part_3(.clock(clock), .even_next(even_next), .odd_next(odd_next),
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

// A part of the words of a slice, with two places. Its flags stand beside it: `keep` on the statements keeps synthesis from merging them
// with those of other parts.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_slice_part(clock, even_next, odd_next, goes_odd_next, in_word, out_word);
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

// A place for one word. Its ready depends on its own state alone, so no path leads through it.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_place(clock, reset, in_valid, in_ready, in_word, out_valid, out_ready, out_word);
    parameter WIDTH = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    input wire [WIDTH - 1:0] in_word;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    reg full;
    reg [WIDTH - 1:0] word;
    initial full = 1'b0;
    assign in_ready = ~full;
    assign out_valid = full;
    assign out_word = word;
    always @(posedge clock) begin
        full <= ~reset & (full ? ~out_ready : in_valid);
        if (~full) word <= in_word;
    end
endmodule

// Flow control by credits, between a stream and the queue for its words at a chain. A word that moves is on its way to the queue for as many
// clocks as it has stages to pass, and so is the credit that comes back. So no path leads from the chain to the stream.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_link(clock, reset, in_valid, in_ready, moves, taken);
    // The queue has 2^(BITS - 1) places.
    parameter BITS = 1;
    parameter STAGES = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    // The word leaves the stream.
    output wire moves;
    // A word leaves the queue.
    input wire taken;
    reg [STAGES - 1:0] returning;
    wire [STAGES:0] come_back = {returning, taken};
    // The credits: the places that are left, less one. So the sign says that there is none.
    reg [BITS - 1:0] left;
    localparam [BITS - 1:0] ALL_LEFT = {BITS{1'b1}} >> 1;
    initial returning = {STAGES{1'b0}};
    initial left = ALL_LEFT;
    assign in_ready = ~left[BITS - 1];
    assign moves = in_valid & in_ready & ~reset;
    always @(posedge clock) begin
        returning <= reset ? {STAGES{1'b0}} : come_back[STAGES - 1:0];
        left <= reset ? ALL_LEFT : left - moves + returning[STAGES - 1];
    end
endmodule

// A stage of the way from a stream to the chains. It gives each word on after a clock.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_stage(clock, reset, in_valid, in_word, out_valid, out_word);
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

// Says which leaves of the photon slice go to a chain, and drops those for which the chain's bank has no room.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_port(clock, reset, leaf_valid, leaf_last, leaf_ready, leaf_given, leaf_refused, set_too_long, leaf_taken);
    parameter NUMBER = 1;
    // The queue has 2^PLACE places for leaves.
    parameter PLACE = 1;
    parameter STAGES = 1;
    input wire clock;
    input wire reset;
    input wire leaf_valid;
    input wire leaf_last;
    // A register, since it leads through all chains' to every place of the slice.
    output reg leaf_ready;
    output wire leaf_given;
    output wire leaf_refused;
    output wire set_too_long;
    // A leaf leaves the queue.
    input wire leaf_taken;
    // The number of the next leaf in its set.
    reg [NUMBER - 1:0] number;
    reg drops;
    initial number = {NUMBER{1'b0}};
    initial drops = 1'b0;
    initial leaf_ready = 1'b1;
    wire has_place;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_link #(.BITS(PLACE + 1), .STAGES(STAGES)) link(.clock(clock), .reset(reset), .in_valid(leaf_valid & leaf_ready & ~drops),
        .in_ready(has_place), .moves(leaf_given), .taken(leaf_taken));
    assign leaf_refused = leaf_valid & drops;
    assign set_too_long = leaf_given & ~leaf_last & (&number);
    wire drops_next = set_too_long | (drops & ~(leaf_valid & leaf_last));
    always @(posedge clock) begin
        if (leaf_given) number <= leaf_last ? {NUMBER{1'b0}} : number + 1'b1;
        drops <= drops_next;
        // In the clock behind a leaf its second group comes, so no other leaf may.
        leaf_ready <= drops_next | (has_place & ~leaf_given);
        if (reset) begin
            number <= {NUMBER{1'b0}};
            drops <= 1'b0;
            leaf_ready <= 1'b1;
        end
    end
endmodule

// A queue in front of a chain. It has no ready: a word comes only where a place is left, which the link of its stream knows.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_queue(clock, reset, in_valid, in_word, out_valid, out_ready, out_word);
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

// The queue of leaves in front of a chain, as groups. The second group of a leaf comes a clock after its first.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_photon_queue(clock, reset, leaf_valid, leaf_has_second, leaf_last, leaf_facing, first, second, leaf_taken,
    group_valid, group_ready, group_last, group_facing, group);
    parameter GROUP = 1;
    parameter FACING = 1;
    // The queue has 2^PLACE places for groups.
    parameter PLACE = 1;
    input wire clock;
    input wire reset;
    input wire leaf_valid;
    input wire leaf_has_second;
    input wire leaf_last;
    input wire [FACING - 1:0] leaf_facing;
    input wire [GROUP - 1:0] first;
    // The second group of the leaf that came in the clock before.
    input wire [GROUP - 1:0] second;
    output wire leaf_taken;
    output wire group_valid;
    input wire group_ready;
    output wire group_last;
    output wire [FACING - 1:0] group_facing;
    output wire [GROUP - 1:0] group;
    reg second_comes;
    reg second_last;
    reg [FACING - 1:0] second_facing;
    initial second_comes = 1'b0;
    // Only the last leaf of a set may have a single group.
    wire has_two = leaf_has_second | ~leaf_last;
    // From the highest bit: whether it is the last of its leaf, and of its set; the facing; the photons.
    wire [GROUP + FACING + 1:0] first_in = {~has_two, leaf_last & ~has_two, leaf_facing, first};
    wire [GROUP + FACING + 1:0] second_in = {1'b1, second_last, second_facing, second};
    wire ends;
    photoncube_core_3_leaf_5_local7_rgb6d_n64_queue #(.WIDTH(GROUP + FACING + 2), .PLACE(PLACE)) queue(.clock(clock), .reset(reset),
        .in_valid(leaf_valid | second_comes), .in_word(second_comes ? second_in : first_in),
        .out_valid(group_valid), .out_ready(group_ready), .out_word({ends, group_last, group_facing, group}));
    assign leaf_taken = group_valid & group_ready & ends;
    always @(posedge clock) begin
        second_comes <= leaf_valid & has_two & ~reset;
        second_last <= leaf_last;
        second_facing <= leaf_facing;
    end
endmodule

// Merges the results of a chain with those that pass it. Where both have one, they take turns. A word has five bits at least, as in a slice.
module photoncube_core_3_leaf_5_local7_rgb6d_n64_merge(clock, reset, own_valid, own_ready, own_word, passing_valid, passing_ready, passing_word,
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
    photoncube_core_3_leaf_5_local7_rgb6d_n64_slice #(.WIDTH(WIDTH)) slice(.clock(clock), .reset(reset), .in_valid(own_valid | passing_valid), .in_ready(ready),
        .in_word(is_own ? own_word : passing_word), .out_valid(out_valid), .out_ready(out_ready), .out_word(out_word));
    always @(posedge clock) begin
        if (ready & (own_valid | passing_valid)) was_own <= is_own;
        if (reset) was_own <= 1'b0;
    end
endmodule

// SPDX-License-Identifier: MIT
// leaf-5-local7-rgb6d-n64: 2 engines in a chain behind a memory of leaves, the photon format
// local7-rgb6d-n64.
// Written by photoncube 0.2.0, `photoncube generate --machine leaf-5-local7-rgb6d-n64`; do not edit.
//
// cells          32
// numbers        photon format local7-rgb6d-n64, 39 bits a stored photon
// power unit     the photon map's own: its largest power in any channel is the largest word
// frame          4 x 4 x 4 blocks; a block's edge is at least the search radius; a query has its
//                place in the inner 2 x 2 x 2 blocks, so that all photons in range are in the frame
// search radius  fixed, 126 of a block edge's 128 steps: in range where d^2 <= 15876
// most photons   64 a query
// squarers       digits in 1, product in 1 of 2 engines
// clocks         1 for a group of 4 photons; at least 3 a batch
// latency        12 clocks from a batch's last group to its first result, 2 more to each further
//                one
//
// Ports of photoncube_leaf_5_local7_rgb6d_n64; bit 0 is the lowest:
//   input          clock                every register changes at its rising edge
//   input          reset                synchronous, active high; one clock is enough, and what is
//                                       taken in it is lost
//   input          query_valid          a query is on the query_ pins
//   input [8:0]    query_x              unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    query_y              unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    query_z              unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input          query_release        any query of a batch may set it: the set of photons is
//                                       given up behind that batch
//   input          query_last           the query is the last of its batch, which may have fewer
//                                       queries than the machine has engines
//   input [31:0]   query_facings        the facings that the batch gathers, bit i for facing i;
//                                       those of its first query count
//   input [17:0]   query_tag            any number; the query's result has it
//   input          group_valid          a group is on the group_ and photon_ pins
//   input          group_last           this group ends its set
//   input [4:0]    group_facing         the facing of the leaf's photons; that with its last group
//                                       counts
//   input          photon_present_0..3  the lane has a photon; where it is 0, the lane's other pins
//                                       are not looked at
//   input [8:0]    photon_x_0..3        unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    photon_y_0..3        unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    photon_z_0..3        unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [5:0]    photon_red_0..3      unsigned; power units
//   input [5:0]    photon_green_0..3    unsigned; power units
//   input [5:0]    photon_blue_0..3     unsigned; power units
//   input          result_ready         the result is taken at this edge, if it is valid
//   output         query_ready          the query is taken at this edge, if it is valid
//   output         group_ready          the group is taken at this edge, if it is valid
//   output         result_valid         a result is on the result_ pins; it stays until it is taken
//   output [11:0]  result_red           sum of the powers in range, in power units
//   output [11:0]  result_green         sum of the powers in range, in power units
//   output [11:0]  result_blue          sum of the powers in range, in power units
//   output [6:0]   result_count         photons in range
//   output [17:0]  result_tag           the tag of the result's query; 0 where there is no result
//   output [1:0]   compared             leaves whose boxes are compared in this clock, for a
//                                       counter
//   output [1:0]   wanted               leaves that a comparison finds wanted in this clock, for a
//                                       counter
//   output         played               the engines are given a group in this clock, for a counter
//
// Protocol:
//   - A word is taken at a rising edge with valid and ready. A query may change until it is taken;
//     a group, once valid, must stay as it is until it is taken.
//   - A batch is the queries up to one with query_last, at most 2; those after query_last begin the
//     next. Each query gives one result, with its query_tag, in the order of the queries: the sums
//     over the photons of the set in range whose facing the batch gathers.
//   - A set of groups, up to group_last, is read in once and played to batch after batch, until a
//     batch with query_release. Two sets fit: one is read in while the other is played. A set holds
//     at most 16 groups; group 16 ends it with or without group_last, and what follows begins the
//     next set.
//   - A leaf is two groups of a set that follow each other, the first two and so on. All its
//     photons have one facing, and their order means nothing. A group is skipped where the box
//     around its photons is out of range of the box around the batch's queries, so photons of a
//     group should be close together, and so should queries of a batch. A facing is any number: a
//     leaf of facing i is gathered by the batches with bit i of query_facings, and the machine does
//     nothing else with it.
//   - Ready and valid pins are registers, or depend on registers alone.
//   - Reset needs one clock. No ready pin looks at it, so what is taken in that clock is lost; what
//     was under way is forgotten.
//   - No input is checked: with more than 64 photons for a query, results are undefined.

module photoncube_leaf_5_local7_rgb6d_n64(clock, reset, query_valid, query_ready, query_x, query_y,
    query_z, query_release, query_last, query_facings, query_tag, group_valid, group_ready,
    group_last, group_facing, photon_present_0, photon_present_1, photon_present_2,
    photon_present_3, photon_x_0, photon_x_1, photon_x_2, photon_x_3, photon_y_0, photon_y_1,
    photon_y_2, photon_y_3, photon_z_0, photon_z_1, photon_z_2, photon_z_3, photon_red_0,
    photon_red_1, photon_red_2, photon_red_3, photon_green_0, photon_green_1, photon_green_2,
    photon_green_3, photon_blue_0, photon_blue_1, photon_blue_2, photon_blue_3, result_valid,
    result_ready, result_red, result_green, result_blue, result_count, result_tag, compared,
    wanted, played);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    output reg query_ready;
    input wire [8:0] query_x;
    input wire [8:0] query_y;
    input wire [8:0] query_z;
    input wire query_release;
    input wire query_last;
    input wire [31:0] query_facings;
    input wire [17:0] query_tag;
    input wire group_valid;
    output reg group_ready;
    input wire group_last;
    input wire [4:0] group_facing;
    input wire photon_present_0;
    input wire photon_present_1;
    input wire photon_present_2;
    input wire photon_present_3;
    input wire [8:0] photon_x_0;
    input wire [8:0] photon_x_1;
    input wire [8:0] photon_x_2;
    input wire [8:0] photon_x_3;
    input wire [8:0] photon_y_0;
    input wire [8:0] photon_y_1;
    input wire [8:0] photon_y_2;
    input wire [8:0] photon_y_3;
    input wire [8:0] photon_z_0;
    input wire [8:0] photon_z_1;
    input wire [8:0] photon_z_2;
    input wire [8:0] photon_z_3;
    input wire [5:0] photon_red_0;
    input wire [5:0] photon_red_1;
    input wire [5:0] photon_red_2;
    input wire [5:0] photon_red_3;
    input wire [5:0] photon_green_0;
    input wire [5:0] photon_green_1;
    input wire [5:0] photon_green_2;
    input wire [5:0] photon_green_3;
    input wire [5:0] photon_blue_0;
    input wire [5:0] photon_blue_1;
    input wire [5:0] photon_blue_2;
    input wire [5:0] photon_blue_3;
    output reg result_valid;
    input wire result_ready;
    output reg [11:0] result_red;
    output reg [11:0] result_green;
    output reg [11:0] result_blue;
    output reg [6:0] result_count;
    output reg [17:0] result_tag;
    output reg [1:0] compared;
    output reg [1:0] wanted;
    output reg played;
    // Stub signals
    reg fill_clock;
    reg fill_reset;
    reg fill_group_valid;
    reg fill_group_last;
    reg [4:0] fill_group_facing;
    reg fill_frees;
    reg fill_freed_bank;
    wire fill_group_ready;
    wire fill_write_valid_out;
    wire fill_write_bank_out;
    wire [3:0] fill_write_place_out;
    wire fill_write_last_out;
    wire [4:0] fill_write_facing_out;
    reg group_words_clock;
    reg group_words_present_0;
    reg group_words_present_1;
    reg group_words_present_2;
    reg group_words_present_3;
    reg [8:0] group_words_x_0;
    reg [8:0] group_words_x_1;
    reg [8:0] group_words_x_2;
    reg [8:0] group_words_x_3;
    reg [8:0] group_words_y_0;
    reg [8:0] group_words_y_1;
    reg [8:0] group_words_y_2;
    reg [8:0] group_words_y_3;
    reg [8:0] group_words_z_0;
    reg [8:0] group_words_z_1;
    reg [8:0] group_words_z_2;
    reg [8:0] group_words_z_3;
    reg [5:0] group_words_red_0;
    reg [5:0] group_words_red_1;
    reg [5:0] group_words_red_2;
    reg [5:0] group_words_red_3;
    reg [5:0] group_words_green_0;
    reg [5:0] group_words_green_1;
    reg [5:0] group_words_green_2;
    reg [5:0] group_words_green_3;
    reg [5:0] group_words_blue_0;
    reg [5:0] group_words_blue_1;
    reg [5:0] group_words_blue_2;
    reg [5:0] group_words_blue_3;
    reg group_words_write;
    reg group_words_write_bank;
    reg [3:0] group_words_write_place;
    reg group_words_read;
    reg group_words_read_bank;
    reg [3:0] group_words_read_place;
    wire group_words_write_present_0;
    wire group_words_write_present_1;
    wire group_words_write_present_2;
    wire group_words_write_present_3;
    wire [8:0] group_words_write_x_0;
    wire [8:0] group_words_write_x_1;
    wire [8:0] group_words_write_x_2;
    wire [8:0] group_words_write_x_3;
    wire [8:0] group_words_write_y_0;
    wire [8:0] group_words_write_y_1;
    wire [8:0] group_words_write_y_2;
    wire [8:0] group_words_write_y_3;
    wire [8:0] group_words_write_z_0;
    wire [8:0] group_words_write_z_1;
    wire [8:0] group_words_write_z_2;
    wire [8:0] group_words_write_z_3;
    wire group_words_word_present_0;
    wire group_words_word_present_1;
    wire group_words_word_present_2;
    wire group_words_word_present_3;
    wire [8:0] group_words_word_x_0;
    wire [8:0] group_words_word_x_1;
    wire [8:0] group_words_word_x_2;
    wire [8:0] group_words_word_x_3;
    wire [8:0] group_words_word_y_0;
    wire [8:0] group_words_word_y_1;
    wire [8:0] group_words_word_y_2;
    wire [8:0] group_words_word_y_3;
    wire [8:0] group_words_word_z_0;
    wire [8:0] group_words_word_z_1;
    wire [8:0] group_words_word_z_2;
    wire [8:0] group_words_word_z_3;
    wire [5:0] group_words_word_red_0;
    wire [5:0] group_words_word_red_1;
    wire [5:0] group_words_word_red_2;
    wire [5:0] group_words_word_red_3;
    wire [5:0] group_words_word_green_0;
    wire [5:0] group_words_word_green_1;
    wire [5:0] group_words_word_green_2;
    wire [5:0] group_words_word_green_3;
    wire [5:0] group_words_word_blue_0;
    wire [5:0] group_words_word_blue_1;
    wire [5:0] group_words_word_blue_2;
    wire [5:0] group_words_word_blue_3;
    reg borders_clock;
    reg borders_present_0;
    reg borders_present_1;
    reg borders_present_2;
    reg borders_present_3;
    reg [8:0] borders_x_0;
    reg [8:0] borders_x_1;
    reg [8:0] borders_x_2;
    reg [8:0] borders_x_3;
    reg [8:0] borders_y_0;
    reg [8:0] borders_y_1;
    reg [8:0] borders_y_2;
    reg [8:0] borders_y_3;
    reg [8:0] borders_z_0;
    reg [8:0] borders_z_1;
    reg [8:0] borders_z_2;
    reg [8:0] borders_z_3;
    reg borders_comes;
    reg borders_first_comes;
    wire [8:0] borders_low_0;
    wire [8:0] borders_low_1;
    wire [8:0] borders_low_2;
    wire [8:0] borders_low_3;
    wire [8:0] borders_low_4;
    wire [8:0] borders_low_5;
    wire [8:0] borders_high_0;
    wire [8:0] borders_high_1;
    wire [8:0] borders_high_2;
    wire [8:0] borders_high_3;
    wire [8:0] borders_high_4;
    wire [8:0] borders_high_5;
    reg control_clock;
    reg control_reset;
    reg control_write_valid;
    reg control_write_bank;
    reg [3:0] control_write_place;
    reg control_write_last;
    reg [4:0] control_write_facing;
    reg control_frees;
    reg control_freed_bank;
    wire control_comes;
    wire control_first_comes;
    wire control_box_valid_out;
    wire control_box_bank_out;
    wire [2:0] control_box_leaf_out;
    wire control_box_short_out_0;
    wire control_box_short_out_1;
    wire [4:0] control_box_facing_out_0;
    wire [4:0] control_box_facing_out_1;
    wire control_full_0_out;
    wire control_full_1_out;
    wire [2:0] control_end_0_out;
    wire [2:0] control_end_1_out;
    reg box_words_clock;
    reg [8:0] box_words_low_0;
    reg [8:0] box_words_low_1;
    reg [8:0] box_words_low_2;
    reg [8:0] box_words_low_3;
    reg [8:0] box_words_low_4;
    reg [8:0] box_words_low_5;
    reg [8:0] box_words_high_0;
    reg [8:0] box_words_high_1;
    reg [8:0] box_words_high_2;
    reg [8:0] box_words_high_3;
    reg [8:0] box_words_high_4;
    reg [8:0] box_words_high_5;
    reg [4:0] box_words_facing_0;
    reg [4:0] box_words_facing_1;
    reg box_words_short_0;
    reg box_words_short_1;
    reg box_words_write;
    reg box_words_write_bank;
    reg [2:0] box_words_write_leaf;
    reg box_words_read;
    reg box_words_read_bank;
    reg [1:0] box_words_read_pair;
    wire [8:0] box_words_found_low_0;
    wire [8:0] box_words_found_low_1;
    wire [8:0] box_words_found_low_2;
    wire [8:0] box_words_found_low_3;
    wire [8:0] box_words_found_low_4;
    wire [8:0] box_words_found_low_5;
    wire [8:0] box_words_found_low_6;
    wire [8:0] box_words_found_low_7;
    wire [8:0] box_words_found_low_8;
    wire [8:0] box_words_found_low_9;
    wire [8:0] box_words_found_low_10;
    wire [8:0] box_words_found_low_11;
    wire [8:0] box_words_found_high_0;
    wire [8:0] box_words_found_high_1;
    wire [8:0] box_words_found_high_2;
    wire [8:0] box_words_found_high_3;
    wire [8:0] box_words_found_high_4;
    wire [8:0] box_words_found_high_5;
    wire [8:0] box_words_found_high_6;
    wire [8:0] box_words_found_high_7;
    wire [8:0] box_words_found_high_8;
    wire [8:0] box_words_found_high_9;
    wire [8:0] box_words_found_high_10;
    wire [8:0] box_words_found_high_11;
    wire [4:0] box_words_found_facing_0;
    wire [4:0] box_words_found_facing_1;
    wire box_words_found_short_0;
    wire box_words_found_short_1;
    reg former_clock;
    reg former_reset;
    reg former_query_valid;
    reg former_query_last;
    reg former_query_release;
    reg [31:0] former_query_facings;
    reg former_chain_ready;
    reg former_starts;
    wire former_query_ready;
    wire former_token_valid;
    wire former_takes_token;
    wire former_takes_query;
    wire former_first;
    wire former_offers_query;
    wire former_fills;
    wire former_complete;
    wire former_release_out;
    wire [31:0] former_facings_out;
    reg query_border_0_clock;
    reg query_border_0_comes;
    reg query_border_0_first;
    reg [8:0] query_border_0_low_in;
    reg [8:0] query_border_0_high_in;
    wire [8:0] query_border_0_low_out;
    wire [8:0] query_border_0_high_out;
    reg query_border_1_clock;
    reg query_border_1_comes;
    reg query_border_1_first;
    reg [8:0] query_border_1_low_in;
    reg [8:0] query_border_1_high_in;
    wire [8:0] query_border_1_low_out;
    wire [8:0] query_border_1_high_out;
    reg query_border_2_clock;
    reg query_border_2_comes;
    reg query_border_2_first;
    reg [8:0] query_border_2_low_in;
    reg [8:0] query_border_2_high_in;
    wire [8:0] query_border_2_low_out;
    wire [8:0] query_border_2_high_out;
    reg token_place_0_fills;
    reg [8:0] token_place_0_query;
    reg [8:0] token_place_0_filler;
    wire [8:0] token_place_0_token;
    reg token_place_1_fills;
    reg [8:0] token_place_1_query;
    reg [8:0] token_place_1_filler;
    wire [8:0] token_place_1_token;
    reg token_place_2_fills;
    reg [8:0] token_place_2_query;
    reg [8:0] token_place_2_filler;
    wire [8:0] token_place_2_token;
    reg scan_clock;
    reg scan_reset;
    reg scan_complete;
    reg scan_releases;
    reg [31:0] scan_facings;
    reg scan_full_0;
    reg scan_full_1;
    reg [2:0] scan_end_0;
    reg [2:0] scan_end_1;
    reg scan_drops;
    reg scan_takes_pair;
    wire scan_starts;
    wire scan_takes_box;
    wire scan_issues;
    wire scan_issue_bank;
    wire [1:0] scan_issue_pair;
    wire [31:0] scan_facings_out;
    wire scan_found_valid_out;
    wire [1:0] scan_found_pair_out;
    wire scan_found_bank_out;
    wire scan_found_end_out;
    wire scan_found_release_out;
    wire scan_found_second_out;
    wire [1:0] scan_compared;
    reg scan_low_0_clock;
    reg scan_low_0_takes;
    reg [8:0] scan_low_0_d;
    wire [8:0] scan_low_0_q;
    reg scan_low_1_clock;
    reg scan_low_1_takes;
    reg [8:0] scan_low_1_d;
    wire [8:0] scan_low_1_q;
    reg scan_low_2_clock;
    reg scan_low_2_takes;
    reg [8:0] scan_low_2_d;
    wire [8:0] scan_low_2_q;
    reg scan_high_0_clock;
    reg scan_high_0_takes;
    reg [8:0] scan_high_0_d;
    wire [8:0] scan_high_0_q;
    reg scan_high_1_clock;
    reg scan_high_1_takes;
    reg [8:0] scan_high_1_d;
    wire [8:0] scan_high_1_q;
    reg scan_high_2_clock;
    reg scan_high_2_takes;
    reg [8:0] scan_high_2_d;
    wire [8:0] scan_high_2_q;
    reg gathers_clock;
    reg [31:0] gathers_facings;
    reg [4:0] gathers_facing_0;
    reg [4:0] gathers_facing_1;
    reg gathers_is_there_0;
    reg gathers_is_there_1;
    wire gathers_gathered_0;
    wire gathers_gathered_1;
    reg culler_clock;
    reg [8:0] culler_query_low_0;
    reg [8:0] culler_query_low_1;
    reg [8:0] culler_query_low_2;
    reg [8:0] culler_query_high_0;
    reg [8:0] culler_query_high_1;
    reg [8:0] culler_query_high_2;
    reg [8:0] culler_group_low_0;
    reg [8:0] culler_group_low_1;
    reg [8:0] culler_group_low_2;
    reg [8:0] culler_group_low_3;
    reg [8:0] culler_group_low_4;
    reg [8:0] culler_group_low_5;
    reg [8:0] culler_group_low_6;
    reg [8:0] culler_group_low_7;
    reg [8:0] culler_group_low_8;
    reg [8:0] culler_group_low_9;
    reg [8:0] culler_group_low_10;
    reg [8:0] culler_group_low_11;
    reg [8:0] culler_group_high_0;
    reg [8:0] culler_group_high_1;
    reg [8:0] culler_group_high_2;
    reg [8:0] culler_group_high_3;
    reg [8:0] culler_group_high_4;
    reg [8:0] culler_group_high_5;
    reg [8:0] culler_group_high_6;
    reg [8:0] culler_group_high_7;
    reg [8:0] culler_group_high_8;
    reg [8:0] culler_group_high_9;
    reg [8:0] culler_group_high_10;
    reg [8:0] culler_group_high_11;
    wire culler_in_range_0;
    wire culler_in_range_1;
    wire culler_in_range_2;
    wire culler_in_range_3;
    reg cull_0_clock;
    reg cull_0_reset;
    reg cull_0_valid_in;
    reg [1:0] cull_0_pair_in;
    reg cull_0_bank_in;
    reg cull_0_end_in;
    reg cull_0_release_in;
    reg cull_0_short_in_0;
    reg cull_0_short_in_1;
    wire cull_0_valid_out;
    wire [1:0] cull_0_pair_out;
    wire cull_0_bank_out;
    wire cull_0_end_out;
    wire cull_0_release_out;
    wire cull_0_short_out_0;
    wire cull_0_short_out_1;
    reg cull_1_clock;
    reg cull_1_reset;
    reg cull_1_valid_in;
    reg [1:0] cull_1_pair_in;
    reg cull_1_bank_in;
    reg cull_1_end_in;
    reg cull_1_release_in;
    reg cull_1_short_in_0;
    reg cull_1_short_in_1;
    wire cull_1_valid_out;
    wire [1:0] cull_1_pair_out;
    wire cull_1_bank_out;
    wire cull_1_end_out;
    wire cull_1_release_out;
    wire cull_1_short_out_0;
    wire cull_1_short_out_1;
    reg cull_2_clock;
    reg cull_2_reset;
    reg cull_2_valid_in;
    reg [1:0] cull_2_pair_in;
    reg cull_2_bank_in;
    reg cull_2_end_in;
    reg cull_2_release_in;
    reg cull_2_short_in_0;
    reg cull_2_short_in_1;
    wire cull_2_valid_out;
    wire [1:0] cull_2_pair_out;
    wire cull_2_bank_out;
    wire cull_2_end_out;
    wire cull_2_release_out;
    wire cull_2_short_out_0;
    wire cull_2_short_out_1;
    reg cull_3_clock;
    reg cull_3_reset;
    reg cull_3_valid_in;
    reg [1:0] cull_3_pair_in;
    reg cull_3_bank_in;
    reg cull_3_end_in;
    reg cull_3_release_in;
    reg cull_3_short_in_0;
    reg cull_3_short_in_1;
    wire cull_3_valid_out;
    wire [1:0] cull_3_pair_out;
    wire cull_3_bank_out;
    wire cull_3_end_out;
    wire cull_3_release_out;
    wire cull_3_short_out_0;
    wire cull_3_short_out_1;
    reg cull_4_clock;
    reg cull_4_reset;
    reg cull_4_valid_in;
    reg [1:0] cull_4_pair_in;
    reg cull_4_bank_in;
    reg cull_4_end_in;
    reg cull_4_release_in;
    reg cull_4_short_in_0;
    reg cull_4_short_in_1;
    wire cull_4_valid_out;
    wire [1:0] cull_4_pair_out;
    wire cull_4_bank_out;
    wire cull_4_end_out;
    wire cull_4_release_out;
    wire cull_4_short_out_0;
    wire cull_4_short_out_1;
    reg queue_clock;
    reg queue_reset;
    reg queue_valid;
    reg [1:0] queue_pair;
    reg queue_bank;
    reg queue_ends;
    reg queue_releases;
    reg queue_in_range_0;
    reg queue_in_range_1;
    reg queue_in_range_2;
    reg queue_in_range_3;
    reg queue_gathered_0;
    reg queue_gathered_1;
    reg queue_short_0;
    reg queue_short_1;
    reg queue_takes_pair;
    wire queue_drops;
    wire queue_has_pair;
    wire [1:0] queue_oldest_pair;
    wire [3:0] queue_oldest_mask;
    wire [2:0] queue_oldest_flags;
    wire [1:0] queue_wanted;
    reg player_clock;
    reg player_reset;
    reg player_has_pair;
    reg [1:0] player_pair;
    reg [3:0] player_mask;
    reg [2:0] player_flags;
    reg player_batch_leaves;
    wire player_takes_pair;
    wire player_plays;
    wire player_play_bank;
    wire [3:0] player_play_place;
    wire player_frees;
    wire player_word_valid_out;
    wire player_word_last_out;
    wire player_word_blank_out;
    reg tags_clock;
    reg tags_reset;
    reg tags_takes_token;
    reg tags_takes_query;
    reg [17:0] tags_query_tag;
    reg tags_chain_valid;
    reg tags_result_ready;
    wire tags_chain_ready;
    wire tags_result_valid;
    wire [17:0] tags_result_tag;
    wire tags_batch_leaves;
    reg unless_blank_0_blank;
    reg unless_blank_0_word;
    wire unless_blank_0_present;
    reg unless_blank_1_blank;
    reg unless_blank_1_word;
    wire unless_blank_1_present;
    reg unless_blank_2_blank;
    reg unless_blank_2_word;
    wire unless_blank_2_present;
    reg unless_blank_3_blank;
    reg unless_blank_3_word;
    wire unless_blank_3_present;
    reg chain_clock;
    reg chain_reset;
    reg chain_query_valid;
    wire chain_query_ready;
    reg [8:0] chain_query_x;
    reg [8:0] chain_query_y;
    reg [8:0] chain_query_z;
    reg chain_group_valid;
    wire chain_group_ready;
    reg chain_group_last;
    reg chain_photon_present_0;
    reg chain_photon_present_1;
    reg chain_photon_present_2;
    reg chain_photon_present_3;
    reg [8:0] chain_photon_x_0;
    reg [8:0] chain_photon_x_1;
    reg [8:0] chain_photon_x_2;
    reg [8:0] chain_photon_x_3;
    reg [8:0] chain_photon_y_0;
    reg [8:0] chain_photon_y_1;
    reg [8:0] chain_photon_y_2;
    reg [8:0] chain_photon_y_3;
    reg [8:0] chain_photon_z_0;
    reg [8:0] chain_photon_z_1;
    reg [8:0] chain_photon_z_2;
    reg [8:0] chain_photon_z_3;
    reg [5:0] chain_photon_red_0;
    reg [5:0] chain_photon_red_1;
    reg [5:0] chain_photon_red_2;
    reg [5:0] chain_photon_red_3;
    reg [5:0] chain_photon_green_0;
    reg [5:0] chain_photon_green_1;
    reg [5:0] chain_photon_green_2;
    reg [5:0] chain_photon_green_3;
    reg [5:0] chain_photon_blue_0;
    reg [5:0] chain_photon_blue_1;
    reg [5:0] chain_photon_blue_2;
    reg [5:0] chain_photon_blue_3;
    wire chain_result_valid;
    reg chain_result_ready;
    wire [11:0] chain_result_red;
    wire [11:0] chain_result_green;
    wire [11:0] chain_result_blue;
    wire [6:0] chain_result_count;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_fill fill(
        .clock(fill_clock),
        .reset(fill_reset),
        .group_valid(fill_group_valid),
        .group_last(fill_group_last),
        .group_facing(fill_group_facing),
        .frees(fill_frees),
        .freed_bank(fill_freed_bank),
        .group_ready(fill_group_ready),
        .write_valid_out(fill_write_valid_out),
        .write_bank_out(fill_write_bank_out),
        .write_place_out(fill_write_place_out),
        .write_last_out(fill_write_last_out),
        .write_facing_out(fill_write_facing_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_words group_words(
        .clock(group_words_clock),
        .present_0(group_words_present_0),
        .present_1(group_words_present_1),
        .present_2(group_words_present_2),
        .present_3(group_words_present_3),
        .x_0(group_words_x_0),
        .x_1(group_words_x_1),
        .x_2(group_words_x_2),
        .x_3(group_words_x_3),
        .y_0(group_words_y_0),
        .y_1(group_words_y_1),
        .y_2(group_words_y_2),
        .y_3(group_words_y_3),
        .z_0(group_words_z_0),
        .z_1(group_words_z_1),
        .z_2(group_words_z_2),
        .z_3(group_words_z_3),
        .red_0(group_words_red_0),
        .red_1(group_words_red_1),
        .red_2(group_words_red_2),
        .red_3(group_words_red_3),
        .green_0(group_words_green_0),
        .green_1(group_words_green_1),
        .green_2(group_words_green_2),
        .green_3(group_words_green_3),
        .blue_0(group_words_blue_0),
        .blue_1(group_words_blue_1),
        .blue_2(group_words_blue_2),
        .blue_3(group_words_blue_3),
        .write(group_words_write),
        .write_bank(group_words_write_bank),
        .write_place(group_words_write_place),
        .read(group_words_read),
        .read_bank(group_words_read_bank),
        .read_place(group_words_read_place),
        .write_present_0(group_words_write_present_0),
        .write_present_1(group_words_write_present_1),
        .write_present_2(group_words_write_present_2),
        .write_present_3(group_words_write_present_3),
        .write_x_0(group_words_write_x_0),
        .write_x_1(group_words_write_x_1),
        .write_x_2(group_words_write_x_2),
        .write_x_3(group_words_write_x_3),
        .write_y_0(group_words_write_y_0),
        .write_y_1(group_words_write_y_1),
        .write_y_2(group_words_write_y_2),
        .write_y_3(group_words_write_y_3),
        .write_z_0(group_words_write_z_0),
        .write_z_1(group_words_write_z_1),
        .write_z_2(group_words_write_z_2),
        .write_z_3(group_words_write_z_3),
        .word_present_0(group_words_word_present_0),
        .word_present_1(group_words_word_present_1),
        .word_present_2(group_words_word_present_2),
        .word_present_3(group_words_word_present_3),
        .word_x_0(group_words_word_x_0),
        .word_x_1(group_words_word_x_1),
        .word_x_2(group_words_word_x_2),
        .word_x_3(group_words_word_x_3),
        .word_y_0(group_words_word_y_0),
        .word_y_1(group_words_word_y_1),
        .word_y_2(group_words_word_y_2),
        .word_y_3(group_words_word_y_3),
        .word_z_0(group_words_word_z_0),
        .word_z_1(group_words_word_z_1),
        .word_z_2(group_words_word_z_2),
        .word_z_3(group_words_word_z_3),
        .word_red_0(group_words_word_red_0),
        .word_red_1(group_words_word_red_1),
        .word_red_2(group_words_word_red_2),
        .word_red_3(group_words_word_red_3),
        .word_green_0(group_words_word_green_0),
        .word_green_1(group_words_word_green_1),
        .word_green_2(group_words_word_green_2),
        .word_green_3(group_words_word_green_3),
        .word_blue_0(group_words_word_blue_0),
        .word_blue_1(group_words_word_blue_1),
        .word_blue_2(group_words_word_blue_2),
        .word_blue_3(group_words_word_blue_3)
    );
    photoncube_leaf_5_local7_rgb6d_n64_borders borders(
        .clock(borders_clock),
        .present_0(borders_present_0),
        .present_1(borders_present_1),
        .present_2(borders_present_2),
        .present_3(borders_present_3),
        .x_0(borders_x_0),
        .x_1(borders_x_1),
        .x_2(borders_x_2),
        .x_3(borders_x_3),
        .y_0(borders_y_0),
        .y_1(borders_y_1),
        .y_2(borders_y_2),
        .y_3(borders_y_3),
        .z_0(borders_z_0),
        .z_1(borders_z_1),
        .z_2(borders_z_2),
        .z_3(borders_z_3),
        .comes(borders_comes),
        .first_comes(borders_first_comes),
        .low_0(borders_low_0),
        .low_1(borders_low_1),
        .low_2(borders_low_2),
        .low_3(borders_low_3),
        .low_4(borders_low_4),
        .low_5(borders_low_5),
        .high_0(borders_high_0),
        .high_1(borders_high_1),
        .high_2(borders_high_2),
        .high_3(borders_high_3),
        .high_4(borders_high_4),
        .high_5(borders_high_5)
    );
    photoncube_leaf_5_local7_rgb6d_n64_control control(
        .clock(control_clock),
        .reset(control_reset),
        .write_valid(control_write_valid),
        .write_bank(control_write_bank),
        .write_place(control_write_place),
        .write_last(control_write_last),
        .write_facing(control_write_facing),
        .frees(control_frees),
        .freed_bank(control_freed_bank),
        .comes(control_comes),
        .first_comes(control_first_comes),
        .box_valid_out(control_box_valid_out),
        .box_bank_out(control_box_bank_out),
        .box_leaf_out(control_box_leaf_out),
        .box_short_out_0(control_box_short_out_0),
        .box_short_out_1(control_box_short_out_1),
        .box_facing_out_0(control_box_facing_out_0),
        .box_facing_out_1(control_box_facing_out_1),
        .full_0_out(control_full_0_out),
        .full_1_out(control_full_1_out),
        .end_0_out(control_end_0_out),
        .end_1_out(control_end_1_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_box_words box_words(
        .clock(box_words_clock),
        .low_0(box_words_low_0),
        .low_1(box_words_low_1),
        .low_2(box_words_low_2),
        .low_3(box_words_low_3),
        .low_4(box_words_low_4),
        .low_5(box_words_low_5),
        .high_0(box_words_high_0),
        .high_1(box_words_high_1),
        .high_2(box_words_high_2),
        .high_3(box_words_high_3),
        .high_4(box_words_high_4),
        .high_5(box_words_high_5),
        .facing_0(box_words_facing_0),
        .facing_1(box_words_facing_1),
        .short_0(box_words_short_0),
        .short_1(box_words_short_1),
        .write(box_words_write),
        .write_bank(box_words_write_bank),
        .write_leaf(box_words_write_leaf),
        .read(box_words_read),
        .read_bank(box_words_read_bank),
        .read_pair(box_words_read_pair),
        .found_low_0(box_words_found_low_0),
        .found_low_1(box_words_found_low_1),
        .found_low_2(box_words_found_low_2),
        .found_low_3(box_words_found_low_3),
        .found_low_4(box_words_found_low_4),
        .found_low_5(box_words_found_low_5),
        .found_low_6(box_words_found_low_6),
        .found_low_7(box_words_found_low_7),
        .found_low_8(box_words_found_low_8),
        .found_low_9(box_words_found_low_9),
        .found_low_10(box_words_found_low_10),
        .found_low_11(box_words_found_low_11),
        .found_high_0(box_words_found_high_0),
        .found_high_1(box_words_found_high_1),
        .found_high_2(box_words_found_high_2),
        .found_high_3(box_words_found_high_3),
        .found_high_4(box_words_found_high_4),
        .found_high_5(box_words_found_high_5),
        .found_high_6(box_words_found_high_6),
        .found_high_7(box_words_found_high_7),
        .found_high_8(box_words_found_high_8),
        .found_high_9(box_words_found_high_9),
        .found_high_10(box_words_found_high_10),
        .found_high_11(box_words_found_high_11),
        .found_facing_0(box_words_found_facing_0),
        .found_facing_1(box_words_found_facing_1),
        .found_short_0(box_words_found_short_0),
        .found_short_1(box_words_found_short_1)
    );
    photoncube_leaf_5_local7_rgb6d_n64_former former(
        .clock(former_clock),
        .reset(former_reset),
        .query_valid(former_query_valid),
        .query_last(former_query_last),
        .query_release(former_query_release),
        .query_facings(former_query_facings),
        .chain_ready(former_chain_ready),
        .starts(former_starts),
        .query_ready(former_query_ready),
        .token_valid(former_token_valid),
        .takes_token(former_takes_token),
        .takes_query(former_takes_query),
        .first(former_first),
        .offers_query(former_offers_query),
        .fills(former_fills),
        .complete(former_complete),
        .release_out(former_release_out),
        .facings_out(former_facings_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query_border query_border_0(
        .clock(query_border_0_clock),
        .comes(query_border_0_comes),
        .first(query_border_0_first),
        .low_in(query_border_0_low_in),
        .high_in(query_border_0_high_in),
        .low_out(query_border_0_low_out),
        .high_out(query_border_0_high_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query_border query_border_1(
        .clock(query_border_1_clock),
        .comes(query_border_1_comes),
        .first(query_border_1_first),
        .low_in(query_border_1_low_in),
        .high_in(query_border_1_high_in),
        .low_out(query_border_1_low_out),
        .high_out(query_border_1_high_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query_border query_border_2(
        .clock(query_border_2_clock),
        .comes(query_border_2_comes),
        .first(query_border_2_first),
        .low_in(query_border_2_low_in),
        .high_in(query_border_2_high_in),
        .low_out(query_border_2_low_out),
        .high_out(query_border_2_high_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_token_place token_place_0(
        .fills(token_place_0_fills),
        .query(token_place_0_query),
        .filler(token_place_0_filler),
        .token(token_place_0_token)
    );
    photoncube_leaf_5_local7_rgb6d_n64_token_place token_place_1(
        .fills(token_place_1_fills),
        .query(token_place_1_query),
        .filler(token_place_1_filler),
        .token(token_place_1_token)
    );
    photoncube_leaf_5_local7_rgb6d_n64_token_place token_place_2(
        .fills(token_place_2_fills),
        .query(token_place_2_query),
        .filler(token_place_2_filler),
        .token(token_place_2_token)
    );
    photoncube_leaf_5_local7_rgb6d_n64_scan scan(
        .clock(scan_clock),
        .reset(scan_reset),
        .complete(scan_complete),
        .releases(scan_releases),
        .facings(scan_facings),
        .full_0(scan_full_0),
        .full_1(scan_full_1),
        .end_0(scan_end_0),
        .end_1(scan_end_1),
        .drops(scan_drops),
        .takes_pair(scan_takes_pair),
        .starts(scan_starts),
        .takes_box(scan_takes_box),
        .issues(scan_issues),
        .issue_bank(scan_issue_bank),
        .issue_pair(scan_issue_pair),
        .facings_out(scan_facings_out),
        .found_valid_out(scan_found_valid_out),
        .found_pair_out(scan_found_pair_out),
        .found_bank_out(scan_found_bank_out),
        .found_end_out(scan_found_end_out),
        .found_release_out(scan_found_release_out),
        .found_second_out(scan_found_second_out),
        .compared(scan_compared)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high scan_low_0(
        .clock(scan_low_0_clock),
        .takes(scan_low_0_takes),
        .d(scan_low_0_d),
        .q(scan_low_0_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high scan_low_1(
        .clock(scan_low_1_clock),
        .takes(scan_low_1_takes),
        .d(scan_low_1_d),
        .q(scan_low_1_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high scan_low_2(
        .clock(scan_low_2_clock),
        .takes(scan_low_2_takes),
        .d(scan_low_2_d),
        .q(scan_low_2_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high scan_high_0(
        .clock(scan_high_0_clock),
        .takes(scan_high_0_takes),
        .d(scan_high_0_d),
        .q(scan_high_0_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high scan_high_1(
        .clock(scan_high_1_clock),
        .takes(scan_high_1_takes),
        .d(scan_high_1_d),
        .q(scan_high_1_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high scan_high_2(
        .clock(scan_high_2_clock),
        .takes(scan_high_2_takes),
        .d(scan_high_2_d),
        .q(scan_high_2_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gathers gathers(
        .clock(gathers_clock),
        .facings(gathers_facings),
        .facing_0(gathers_facing_0),
        .facing_1(gathers_facing_1),
        .is_there_0(gathers_is_there_0),
        .is_there_1(gathers_is_there_1),
        .gathered_0(gathers_gathered_0),
        .gathered_1(gathers_gathered_1)
    );
    photoncube_leaf_5_local7_rgb6d_n64_culler culler(
        .clock(culler_clock),
        .query_low_0(culler_query_low_0),
        .query_low_1(culler_query_low_1),
        .query_low_2(culler_query_low_2),
        .query_high_0(culler_query_high_0),
        .query_high_1(culler_query_high_1),
        .query_high_2(culler_query_high_2),
        .group_low_0(culler_group_low_0),
        .group_low_1(culler_group_low_1),
        .group_low_2(culler_group_low_2),
        .group_low_3(culler_group_low_3),
        .group_low_4(culler_group_low_4),
        .group_low_5(culler_group_low_5),
        .group_low_6(culler_group_low_6),
        .group_low_7(culler_group_low_7),
        .group_low_8(culler_group_low_8),
        .group_low_9(culler_group_low_9),
        .group_low_10(culler_group_low_10),
        .group_low_11(culler_group_low_11),
        .group_high_0(culler_group_high_0),
        .group_high_1(culler_group_high_1),
        .group_high_2(culler_group_high_2),
        .group_high_3(culler_group_high_3),
        .group_high_4(culler_group_high_4),
        .group_high_5(culler_group_high_5),
        .group_high_6(culler_group_high_6),
        .group_high_7(culler_group_high_7),
        .group_high_8(culler_group_high_8),
        .group_high_9(culler_group_high_9),
        .group_high_10(culler_group_high_10),
        .group_high_11(culler_group_high_11),
        .in_range_0(culler_in_range_0),
        .in_range_1(culler_in_range_1),
        .in_range_2(culler_in_range_2),
        .in_range_3(culler_in_range_3)
    );
    photoncube_leaf_5_local7_rgb6d_n64_cull cull_0(
        .clock(cull_0_clock),
        .reset(cull_0_reset),
        .valid_in(cull_0_valid_in),
        .pair_in(cull_0_pair_in),
        .bank_in(cull_0_bank_in),
        .end_in(cull_0_end_in),
        .release_in(cull_0_release_in),
        .short_in_0(cull_0_short_in_0),
        .short_in_1(cull_0_short_in_1),
        .valid_out(cull_0_valid_out),
        .pair_out(cull_0_pair_out),
        .bank_out(cull_0_bank_out),
        .end_out(cull_0_end_out),
        .release_out(cull_0_release_out),
        .short_out_0(cull_0_short_out_0),
        .short_out_1(cull_0_short_out_1)
    );
    photoncube_leaf_5_local7_rgb6d_n64_cull cull_1(
        .clock(cull_1_clock),
        .reset(cull_1_reset),
        .valid_in(cull_1_valid_in),
        .pair_in(cull_1_pair_in),
        .bank_in(cull_1_bank_in),
        .end_in(cull_1_end_in),
        .release_in(cull_1_release_in),
        .short_in_0(cull_1_short_in_0),
        .short_in_1(cull_1_short_in_1),
        .valid_out(cull_1_valid_out),
        .pair_out(cull_1_pair_out),
        .bank_out(cull_1_bank_out),
        .end_out(cull_1_end_out),
        .release_out(cull_1_release_out),
        .short_out_0(cull_1_short_out_0),
        .short_out_1(cull_1_short_out_1)
    );
    photoncube_leaf_5_local7_rgb6d_n64_cull cull_2(
        .clock(cull_2_clock),
        .reset(cull_2_reset),
        .valid_in(cull_2_valid_in),
        .pair_in(cull_2_pair_in),
        .bank_in(cull_2_bank_in),
        .end_in(cull_2_end_in),
        .release_in(cull_2_release_in),
        .short_in_0(cull_2_short_in_0),
        .short_in_1(cull_2_short_in_1),
        .valid_out(cull_2_valid_out),
        .pair_out(cull_2_pair_out),
        .bank_out(cull_2_bank_out),
        .end_out(cull_2_end_out),
        .release_out(cull_2_release_out),
        .short_out_0(cull_2_short_out_0),
        .short_out_1(cull_2_short_out_1)
    );
    photoncube_leaf_5_local7_rgb6d_n64_cull cull_3(
        .clock(cull_3_clock),
        .reset(cull_3_reset),
        .valid_in(cull_3_valid_in),
        .pair_in(cull_3_pair_in),
        .bank_in(cull_3_bank_in),
        .end_in(cull_3_end_in),
        .release_in(cull_3_release_in),
        .short_in_0(cull_3_short_in_0),
        .short_in_1(cull_3_short_in_1),
        .valid_out(cull_3_valid_out),
        .pair_out(cull_3_pair_out),
        .bank_out(cull_3_bank_out),
        .end_out(cull_3_end_out),
        .release_out(cull_3_release_out),
        .short_out_0(cull_3_short_out_0),
        .short_out_1(cull_3_short_out_1)
    );
    photoncube_leaf_5_local7_rgb6d_n64_cull cull_4(
        .clock(cull_4_clock),
        .reset(cull_4_reset),
        .valid_in(cull_4_valid_in),
        .pair_in(cull_4_pair_in),
        .bank_in(cull_4_bank_in),
        .end_in(cull_4_end_in),
        .release_in(cull_4_release_in),
        .short_in_0(cull_4_short_in_0),
        .short_in_1(cull_4_short_in_1),
        .valid_out(cull_4_valid_out),
        .pair_out(cull_4_pair_out),
        .bank_out(cull_4_bank_out),
        .end_out(cull_4_end_out),
        .release_out(cull_4_release_out),
        .short_out_0(cull_4_short_out_0),
        .short_out_1(cull_4_short_out_1)
    );
    photoncube_leaf_5_local7_rgb6d_n64_queue_2 queue(
        .clock(queue_clock),
        .reset(queue_reset),
        .valid(queue_valid),
        .pair(queue_pair),
        .bank(queue_bank),
        .ends(queue_ends),
        .releases(queue_releases),
        .in_range_0(queue_in_range_0),
        .in_range_1(queue_in_range_1),
        .in_range_2(queue_in_range_2),
        .in_range_3(queue_in_range_3),
        .gathered_0(queue_gathered_0),
        .gathered_1(queue_gathered_1),
        .short_0(queue_short_0),
        .short_1(queue_short_1),
        .takes_pair(queue_takes_pair),
        .drops(queue_drops),
        .has_pair(queue_has_pair),
        .oldest_pair(queue_oldest_pair),
        .oldest_mask(queue_oldest_mask),
        .oldest_flags(queue_oldest_flags),
        .wanted(queue_wanted)
    );
    photoncube_leaf_5_local7_rgb6d_n64_player player(
        .clock(player_clock),
        .reset(player_reset),
        .has_pair(player_has_pair),
        .pair(player_pair),
        .mask(player_mask),
        .flags(player_flags),
        .batch_leaves(player_batch_leaves),
        .takes_pair(player_takes_pair),
        .plays(player_plays),
        .play_bank(player_play_bank),
        .play_place(player_play_place),
        .frees(player_frees),
        .word_valid_out(player_word_valid_out),
        .word_last_out(player_word_last_out),
        .word_blank_out(player_word_blank_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_tags tags(
        .clock(tags_clock),
        .reset(tags_reset),
        .takes_token(tags_takes_token),
        .takes_query(tags_takes_query),
        .query_tag(tags_query_tag),
        .chain_valid(tags_chain_valid),
        .result_ready(tags_result_ready),
        .chain_ready(tags_chain_ready),
        .result_valid(tags_result_valid),
        .result_tag(tags_result_tag),
        .batch_leaves(tags_batch_leaves)
    );
    photoncube_leaf_5_local7_rgb6d_n64_unless_blank unless_blank_0(
        .blank(unless_blank_0_blank),
        .word(unless_blank_0_word),
        .present(unless_blank_0_present)
    );
    photoncube_leaf_5_local7_rgb6d_n64_unless_blank unless_blank_1(
        .blank(unless_blank_1_blank),
        .word(unless_blank_1_word),
        .present(unless_blank_1_present)
    );
    photoncube_leaf_5_local7_rgb6d_n64_unless_blank unless_blank_2(
        .blank(unless_blank_2_blank),
        .word(unless_blank_2_word),
        .present(unless_blank_2_present)
    );
    photoncube_leaf_5_local7_rgb6d_n64_unless_blank unless_blank_3(
        .blank(unless_blank_3_blank),
        .word(unless_blank_3_word),
        .present(unless_blank_3_present)
    );
    photoncube_leaf_5_local7_rgb6d_n64_chain chain(
        .clock(chain_clock),
        .reset(chain_reset),
        .query_valid(chain_query_valid),
        .query_ready(chain_query_ready),
        .query_x(chain_query_x),
        .query_y(chain_query_y),
        .query_z(chain_query_z),
        .group_valid(chain_group_valid),
        .group_ready(chain_group_ready),
        .group_last(chain_group_last),
        .photon_present_0(chain_photon_present_0),
        .photon_present_1(chain_photon_present_1),
        .photon_present_2(chain_photon_present_2),
        .photon_present_3(chain_photon_present_3),
        .photon_x_0(chain_photon_x_0),
        .photon_x_1(chain_photon_x_1),
        .photon_x_2(chain_photon_x_2),
        .photon_x_3(chain_photon_x_3),
        .photon_y_0(chain_photon_y_0),
        .photon_y_1(chain_photon_y_1),
        .photon_y_2(chain_photon_y_2),
        .photon_y_3(chain_photon_y_3),
        .photon_z_0(chain_photon_z_0),
        .photon_z_1(chain_photon_z_1),
        .photon_z_2(chain_photon_z_2),
        .photon_z_3(chain_photon_z_3),
        .photon_red_0(chain_photon_red_0),
        .photon_red_1(chain_photon_red_1),
        .photon_red_2(chain_photon_red_2),
        .photon_red_3(chain_photon_red_3),
        .photon_green_0(chain_photon_green_0),
        .photon_green_1(chain_photon_green_1),
        .photon_green_2(chain_photon_green_2),
        .photon_green_3(chain_photon_green_3),
        .photon_blue_0(chain_photon_blue_0),
        .photon_blue_1(chain_photon_blue_1),
        .photon_blue_2(chain_photon_blue_2),
        .photon_blue_3(chain_photon_blue_3),
        .result_valid(chain_result_valid),
        .result_ready(chain_result_ready),
        .result_red(chain_result_red),
        .result_green(chain_result_green),
        .result_blue(chain_result_blue),
        .result_count(chain_result_count)
    );
    // Update code
    always @(*) begin
        fill_clock = clock;
        fill_reset = reset;
        fill_group_valid = group_valid;
        fill_group_last = group_last;
        fill_group_facing = group_facing;
        fill_frees = player_frees;
        fill_freed_bank = player_play_bank;
        group_ready = fill_group_ready;
        group_words_clock = clock;
        group_words_write = fill_write_valid_out;
        group_words_write_bank = fill_write_bank_out;
        group_words_write_place = fill_write_place_out;
        group_words_read = player_plays;
        group_words_read_bank = player_play_bank;
        group_words_read_place = player_play_place;
        group_words_present_0 = photon_present_0;
        group_words_x_0 = photon_x_0;
        group_words_y_0 = photon_y_0;
        group_words_z_0 = photon_z_0;
        group_words_present_1 = photon_present_1;
        group_words_x_1 = photon_x_1;
        group_words_y_1 = photon_y_1;
        group_words_z_1 = photon_z_1;
        group_words_present_2 = photon_present_2;
        group_words_x_2 = photon_x_2;
        group_words_y_2 = photon_y_2;
        group_words_z_2 = photon_z_2;
        group_words_present_3 = photon_present_3;
        group_words_x_3 = photon_x_3;
        group_words_y_3 = photon_y_3;
        group_words_z_3 = photon_z_3;
        group_words_red_0 = photon_red_0;
        group_words_red_1 = photon_red_1;
        group_words_red_2 = photon_red_2;
        group_words_red_3 = photon_red_3;
        group_words_green_0 = photon_green_0;
        group_words_green_1 = photon_green_1;
        group_words_green_2 = photon_green_2;
        group_words_green_3 = photon_green_3;
        group_words_blue_0 = photon_blue_0;
        group_words_blue_1 = photon_blue_1;
        group_words_blue_2 = photon_blue_2;
        group_words_blue_3 = photon_blue_3;
        borders_clock = clock;
        borders_comes = control_comes;
        borders_first_comes = control_first_comes;
        control_clock = clock;
        control_reset = reset;
        control_write_valid = fill_write_valid_out;
        control_write_bank = fill_write_bank_out;
        control_write_place = fill_write_place_out;
        control_write_last = fill_write_last_out;
        control_write_facing = fill_write_facing_out;
        control_frees = player_frees;
        control_freed_bank = player_play_bank;
        box_words_clock = clock;
        box_words_write = control_box_valid_out;
        box_words_write_bank = control_box_bank_out;
        box_words_write_leaf = control_box_leaf_out;
        box_words_read = scan_issues;
        box_words_read_bank = scan_issue_bank;
        box_words_read_pair = scan_issue_pair;
        box_words_facing_0 = control_box_facing_out_0;
        box_words_short_0 = control_box_short_out_0;
        box_words_facing_1 = control_box_facing_out_1;
        box_words_short_1 = control_box_short_out_1;
        borders_present_0 = group_words_write_present_0;
        borders_x_0 = group_words_write_x_0;
        borders_y_0 = group_words_write_y_0;
        borders_z_0 = group_words_write_z_0;
        borders_present_1 = group_words_write_present_1;
        borders_x_1 = group_words_write_x_1;
        borders_y_1 = group_words_write_y_1;
        borders_z_1 = group_words_write_z_1;
        borders_present_2 = group_words_write_present_2;
        borders_x_2 = group_words_write_x_2;
        borders_y_2 = group_words_write_y_2;
        borders_z_2 = group_words_write_z_2;
        borders_present_3 = group_words_write_present_3;
        borders_x_3 = group_words_write_x_3;
        borders_y_3 = group_words_write_y_3;
        borders_z_3 = group_words_write_z_3;
        box_words_low_0 = borders_low_0;
        box_words_high_0 = borders_high_0;
        box_words_low_1 = borders_low_1;
        box_words_high_1 = borders_high_1;
        box_words_low_2 = borders_low_2;
        box_words_high_2 = borders_high_2;
        box_words_low_3 = borders_low_3;
        box_words_high_3 = borders_high_3;
        box_words_low_4 = borders_low_4;
        box_words_high_4 = borders_high_4;
        box_words_low_5 = borders_low_5;
        box_words_high_5 = borders_high_5;
        former_clock = clock;
        former_reset = reset;
        former_query_valid = query_valid;
        former_query_last = query_last;
        former_query_release = query_release;
        former_query_facings = query_facings;
        former_chain_ready = chain_query_ready;
        former_starts = scan_starts;
        query_ready = former_query_ready;
        token_place_0_query = query_x;
        token_place_1_query = query_y;
        token_place_2_query = query_z;
        query_border_0_low_in = query_x;
        query_border_0_high_in = query_x;
        query_border_1_low_in = query_y;
        query_border_1_high_in = query_y;
        query_border_2_low_in = query_z;
        query_border_2_high_in = query_z;
        query_border_0_clock = clock;
        query_border_0_comes = former_offers_query;
        query_border_0_first = former_first;
        token_place_0_fills = former_fills;
        token_place_0_filler = query_border_0_low_out;
        query_border_1_clock = clock;
        query_border_1_comes = former_offers_query;
        query_border_1_first = former_first;
        token_place_1_fills = former_fills;
        token_place_1_filler = query_border_1_low_out;
        query_border_2_clock = clock;
        query_border_2_comes = former_offers_query;
        query_border_2_first = former_first;
        token_place_2_fills = former_fills;
        token_place_2_filler = query_border_2_low_out;
        scan_clock = clock;
        scan_reset = reset;
        scan_complete = former_complete;
        scan_releases = former_release_out;
        scan_facings = former_facings_out;
        scan_full_0 = control_full_0_out;
        scan_full_1 = control_full_1_out;
        scan_end_0 = control_end_0_out;
        scan_end_1 = control_end_1_out;
        scan_drops = queue_drops;
        scan_takes_pair = player_takes_pair;
        gathers_clock = clock;
        gathers_facings = scan_facings_out;
        gathers_is_there_0 = scan_found_valid_out;
        gathers_is_there_1 = scan_found_second_out;
        culler_clock = clock;
        scan_low_0_clock = clock;
        scan_low_0_takes = scan_takes_box;
        scan_low_0_d = query_border_0_low_out;
        scan_high_0_clock = clock;
        scan_high_0_takes = scan_takes_box;
        scan_high_0_d = query_border_0_high_out;
        culler_query_low_0 = scan_low_0_q;
        culler_query_high_0 = scan_high_0_q;
        scan_low_1_clock = clock;
        scan_low_1_takes = scan_takes_box;
        scan_low_1_d = query_border_1_low_out;
        scan_high_1_clock = clock;
        scan_high_1_takes = scan_takes_box;
        scan_high_1_d = query_border_1_high_out;
        culler_query_low_1 = scan_low_1_q;
        culler_query_high_1 = scan_high_1_q;
        scan_low_2_clock = clock;
        scan_low_2_takes = scan_takes_box;
        scan_low_2_d = query_border_2_low_out;
        scan_high_2_clock = clock;
        scan_high_2_takes = scan_takes_box;
        scan_high_2_d = query_border_2_high_out;
        culler_query_low_2 = scan_low_2_q;
        culler_query_high_2 = scan_high_2_q;
        culler_group_low_0 = box_words_found_low_0;
        culler_group_high_0 = box_words_found_high_0;
        culler_group_low_1 = box_words_found_low_1;
        culler_group_high_1 = box_words_found_high_1;
        culler_group_low_2 = box_words_found_low_2;
        culler_group_high_2 = box_words_found_high_2;
        culler_group_low_3 = box_words_found_low_3;
        culler_group_high_3 = box_words_found_high_3;
        culler_group_low_4 = box_words_found_low_4;
        culler_group_high_4 = box_words_found_high_4;
        culler_group_low_5 = box_words_found_low_5;
        culler_group_high_5 = box_words_found_high_5;
        culler_group_low_6 = box_words_found_low_6;
        culler_group_high_6 = box_words_found_high_6;
        culler_group_low_7 = box_words_found_low_7;
        culler_group_high_7 = box_words_found_high_7;
        culler_group_low_8 = box_words_found_low_8;
        culler_group_high_8 = box_words_found_high_8;
        culler_group_low_9 = box_words_found_low_9;
        culler_group_high_9 = box_words_found_high_9;
        culler_group_low_10 = box_words_found_low_10;
        culler_group_high_10 = box_words_found_high_10;
        culler_group_low_11 = box_words_found_low_11;
        culler_group_high_11 = box_words_found_high_11;
        cull_0_valid_in = scan_found_valid_out;
        cull_0_pair_in = scan_found_pair_out;
        cull_0_bank_in = scan_found_bank_out;
        cull_0_end_in = scan_found_end_out;
        cull_0_release_in = scan_found_release_out;
        gathers_facing_0 = box_words_found_facing_0;
        cull_0_short_in_0 = box_words_found_short_0;
        gathers_facing_1 = box_words_found_facing_1;
        cull_0_short_in_1 = box_words_found_short_1;
        cull_0_clock = clock;
        cull_0_reset = reset;
        cull_1_clock = clock;
        cull_1_reset = reset;
        cull_2_clock = clock;
        cull_2_reset = reset;
        cull_3_clock = clock;
        cull_3_reset = reset;
        cull_4_clock = clock;
        cull_4_reset = reset;
        cull_1_valid_in = cull_0_valid_out;
        cull_1_pair_in = cull_0_pair_out;
        cull_1_bank_in = cull_0_bank_out;
        cull_1_end_in = cull_0_end_out;
        cull_1_release_in = cull_0_release_out;
        cull_1_short_in_0 = cull_0_short_out_0;
        cull_1_short_in_1 = cull_0_short_out_1;
        cull_2_valid_in = cull_1_valid_out;
        cull_2_pair_in = cull_1_pair_out;
        cull_2_bank_in = cull_1_bank_out;
        cull_2_end_in = cull_1_end_out;
        cull_2_release_in = cull_1_release_out;
        cull_2_short_in_0 = cull_1_short_out_0;
        cull_2_short_in_1 = cull_1_short_out_1;
        cull_3_valid_in = cull_2_valid_out;
        cull_3_pair_in = cull_2_pair_out;
        cull_3_bank_in = cull_2_bank_out;
        cull_3_end_in = cull_2_end_out;
        cull_3_release_in = cull_2_release_out;
        cull_3_short_in_0 = cull_2_short_out_0;
        cull_3_short_in_1 = cull_2_short_out_1;
        cull_4_valid_in = cull_3_valid_out;
        cull_4_pair_in = cull_3_pair_out;
        cull_4_bank_in = cull_3_bank_out;
        cull_4_end_in = cull_3_end_out;
        cull_4_release_in = cull_3_release_out;
        cull_4_short_in_0 = cull_3_short_out_0;
        cull_4_short_in_1 = cull_3_short_out_1;
        queue_clock = clock;
        queue_reset = reset;
        queue_valid = cull_4_valid_out;
        queue_pair = cull_4_pair_out;
        queue_bank = cull_4_bank_out;
        queue_ends = cull_4_end_out;
        queue_releases = cull_4_release_out;
        queue_takes_pair = player_takes_pair;
        queue_in_range_0 = culler_in_range_0;
        queue_in_range_1 = culler_in_range_1;
        queue_in_range_2 = culler_in_range_2;
        queue_in_range_3 = culler_in_range_3;
        queue_gathered_0 = gathers_gathered_0;
        queue_short_0 = cull_4_short_out_0;
        queue_gathered_1 = gathers_gathered_1;
        queue_short_1 = cull_4_short_out_1;
        player_clock = clock;
        player_reset = reset;
        player_has_pair = queue_has_pair;
        player_pair = queue_oldest_pair;
        player_mask = queue_oldest_mask;
        player_flags = queue_oldest_flags;
        player_batch_leaves = tags_batch_leaves;
        tags_clock = clock;
        tags_reset = reset;
        tags_takes_token = former_takes_token;
        tags_takes_query = former_takes_query;
        tags_query_tag = query_tag;
        tags_chain_valid = chain_result_valid;
        tags_result_ready = result_ready;
        result_valid = tags_result_valid;
        result_tag = tags_result_tag;
        result_count = chain_result_count;
        compared = scan_compared;
        wanted = queue_wanted;
        played = player_word_valid_out;
        result_red = chain_result_red;
        result_green = chain_result_green;
        result_blue = chain_result_blue;
        chain_clock = clock;
        chain_reset = reset;
        chain_query_valid = former_token_valid;
        chain_query_x = token_place_0_token;
        chain_query_y = token_place_1_token;
        chain_query_z = token_place_2_token;
        chain_group_valid = player_word_valid_out;
        chain_group_last = player_word_last_out;
        chain_result_ready = tags_chain_ready;
        unless_blank_0_blank = player_word_blank_out;
        unless_blank_0_word = group_words_word_present_0;
        chain_photon_present_0 = unless_blank_0_present;
        chain_photon_x_0 = group_words_word_x_0;
        chain_photon_y_0 = group_words_word_y_0;
        chain_photon_z_0 = group_words_word_z_0;
        unless_blank_1_blank = player_word_blank_out;
        unless_blank_1_word = group_words_word_present_1;
        chain_photon_present_1 = unless_blank_1_present;
        chain_photon_x_1 = group_words_word_x_1;
        chain_photon_y_1 = group_words_word_y_1;
        chain_photon_z_1 = group_words_word_z_1;
        unless_blank_2_blank = player_word_blank_out;
        unless_blank_2_word = group_words_word_present_2;
        chain_photon_present_2 = unless_blank_2_present;
        chain_photon_x_2 = group_words_word_x_2;
        chain_photon_y_2 = group_words_word_y_2;
        chain_photon_z_2 = group_words_word_z_2;
        unless_blank_3_blank = player_word_blank_out;
        unless_blank_3_word = group_words_word_present_3;
        chain_photon_present_3 = unless_blank_3_present;
        chain_photon_x_3 = group_words_word_x_3;
        chain_photon_y_3 = group_words_word_y_3;
        chain_photon_z_3 = group_words_word_z_3;
        chain_photon_red_0 = group_words_word_red_0;
        chain_photon_red_1 = group_words_word_red_1;
        chain_photon_red_2 = group_words_word_red_2;
        chain_photon_red_3 = group_words_word_red_3;
        chain_photon_green_0 = group_words_word_green_0;
        chain_photon_green_1 = group_words_word_green_1;
        chain_photon_green_2 = group_words_word_green_2;
        chain_photon_green_3 = group_words_word_green_3;
        chain_photon_blue_0 = group_words_word_blue_0;
        chain_photon_blue_1 = group_words_word_blue_1;
        chain_photon_blue_2 = group_words_word_blue_2;
        chain_photon_blue_3 = group_words_word_blue_3;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_tags(clock, reset, takes_token, takes_query, query_tag,
    chain_valid, result_ready, chain_ready, result_valid, result_tag, batch_leaves);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire takes_token;
    input wire takes_query;
    input wire [17:0] query_tag;
    input wire chain_valid;
    input wire result_ready;
    output reg chain_ready;
    output reg result_valid;
    output reg [17:0] result_tag;
    output reg batch_leaves;
    // Constant declarations
    localparam last_result = 1'b1;
    // Stub signals
    reg [4:0] tag_write_d;
    wire [4:0] tag_write_q;
    reg tag_write_clock;
    reg [4:0] tag_read_d;
    wire [4:0] tag_read_q;
    reg tag_read_clock;
    reg has_oldest_d;
    wire has_oldest_q;
    reg has_oldest_clock;
    reg [18:0] oldest_d;
    wire [18:0] oldest_q;
    reg oldest_clock;
    reg tag_result_d;
    wire tag_result_q;
    reg tag_result_clock;
    reg tag_ram_clock;
    reg tag_ram_write;
    reg [4:0] tag_ram_write_place;
    reg [18:0] tag_ram_write_word;
    reg [4:0] tag_ram_read_place;
    wire [18:0] tag_ram_read_word;
    // Local signals
    reg [18:0] tag_in;
    reg [18:0] kind_in;
    reg is_query;
    reg valid;
    reg ready;
    reg takes;
    reg has_more;
    reg loads;
    reg is_last;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_5 tag_write(
        .d(tag_write_d),
        .q(tag_write_q),
        .clock(tag_write_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_5 tag_read(
        .d(tag_read_d),
        .q(tag_read_q),
        .clock(tag_read_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 has_oldest(
        .d(has_oldest_d),
        .q(has_oldest_q),
        .clock(has_oldest_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_19 oldest(
        .d(oldest_d),
        .q(oldest_q),
        .clock(oldest_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 tag_result(
        .d(tag_result_d),
        .q(tag_result_q),
        .clock(tag_result_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_tag_ram tag_ram(
        .clock(tag_ram_clock),
        .write(tag_ram_write),
        .write_place(tag_ram_write_place),
        .write_word(tag_ram_write_word),
        .read_place(tag_ram_read_place),
        .read_word(tag_ram_read_word)
    );
    // Update code
    always @(*) begin
        tag_write_clock = clock;
        tag_read_clock = clock;
        has_oldest_clock = clock;
        oldest_clock = clock;
        tag_result_clock = clock;
        tag_write_d = tag_write_q;
        tag_read_d = tag_read_q;
        has_oldest_d = has_oldest_q;
        oldest_d = oldest_q;
        tag_result_d = tag_result_q;
        tag_ram_clock = clock;
        tag_in = ((query_tag) & 19'h7ffff) << 32'h1;
        kind_in = 32'h0;
        if (takes_query) begin
            kind_in = 32'h1;
        end
        tag_ram_write = takes_token;
        tag_ram_write_place = tag_write_q;
        tag_ram_write_word = tag_in | kind_in;
        tag_ram_read_place = tag_read_q;
        is_query = oldest_q[32'h0];
        valid = chain_valid & is_query;
        ready = result_ready | ~is_query;
        takes = chain_valid & ready;
        is_last = tag_result_q == last_result;
        if (takes_token) begin
            tag_write_d = tag_write_q + 32'h1;
        end
        has_more = tag_read_q != tag_write_q;
        loads = has_more & (takes | ~has_oldest_q);
        has_oldest_d = loads | (has_oldest_q & ~takes);
        if (loads) begin
            tag_read_d = tag_read_q + 32'h1;
            oldest_d = tag_ram_read_word;
        end
        if (takes) begin
            tag_result_d = tag_result_q + 32'h1;
            if (is_last) begin
                tag_result_d = 32'h0;
            end
        end
        if (reset) begin
            tag_write_d = 32'h0;
            tag_read_d = 32'h0;
            has_oldest_d = 1'b0;
            tag_result_d = 32'h0;
        end
        chain_ready = ready;
        result_valid = valid;
        result_tag = 32'h0;
        if (valid) begin
            result_tag = oldest_q[(32'h1)+:(18)];
        end
        batch_leaves = takes & is_last;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_scan(clock, reset, complete, releases, facings, full_0, full_1,
    end_0, end_1, drops, takes_pair, starts, takes_box, issues, issue_bank, issue_pair,
    facings_out, found_valid_out, found_pair_out, found_bank_out, found_end_out,
    found_release_out, found_second_out, compared);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire complete;
    input wire releases;
    input wire [31:0] facings;
    input wire full_0;
    input wire full_1;
    input wire [2:0] end_0;
    input wire [2:0] end_1;
    input wire drops;
    input wire takes_pair;
    output reg starts;
    output reg takes_box;
    output reg issues;
    output reg issue_bank;
    output reg [1:0] issue_pair;
    output reg [31:0] facings_out;
    output reg found_valid_out;
    output reg [1:0] found_pair_out;
    output reg found_bank_out;
    output reg found_end_out;
    output reg found_release_out;
    output reg found_second_out;
    output reg [1:0] compared;
    // Constant declarations
    localparam most_used = 3'b100;
    // Stub signals
    reg starting_d;
    wire starting_q;
    reg starting_clock;
    reg started_d;
    wire started_q;
    reg started_clock;
    reg scanning_d;
    wire scanning_q;
    reg scanning_clock;
    reg scan_bank_d;
    wire scan_bank_q;
    reg scan_bank_clock;
    reg [1:0] scan_pair_d;
    wire [1:0] scan_pair_q;
    reg scan_pair_clock;
    reg [2:0] scan_end_d;
    wire [2:0] scan_end_q;
    reg scan_end_clock;
    reg scan_release_d;
    wire scan_release_q;
    reg scan_release_clock;
    reg [31:0] scan_facings_d;
    wire [31:0] scan_facings_q;
    reg scan_facings_clock;
    reg [2:0] used_d;
    wire [2:0] used_q;
    reg used_clock;
    reg [1:0] returned_d;
    wire [1:0] returned_q;
    reg returned_clock;
    reg look_valid_d;
    wire look_valid_q;
    reg look_valid_clock;
    reg [1:0] look_pair_d;
    wire [1:0] look_pair_q;
    reg look_pair_clock;
    reg look_bank_d;
    wire look_bank_q;
    reg look_bank_clock;
    reg look_end_d;
    wire look_end_q;
    reg look_end_clock;
    reg look_release_d;
    wire look_release_q;
    reg look_release_clock;
    reg look_second_d;
    wire look_second_q;
    reg look_second_clock;
    reg found_valid_d;
    wire found_valid_q;
    reg found_valid_clock;
    reg [1:0] found_pair_d;
    wire [1:0] found_pair_q;
    reg found_pair_clock;
    reg found_bank_d;
    wire found_bank_q;
    reg found_bank_clock;
    reg found_end_d;
    wire found_end_q;
    reg found_end_clock;
    reg found_release_d;
    wire found_release_q;
    reg found_release_clock;
    reg found_second_d;
    wire found_second_q;
    reg found_second_clock;
    // Local signals
    reg is_full;
    reg [2:0] end_leaf;
    reg [1:0] end_pair;
    reg next_bank;
    reg is_free;
    reg may_start;
    reg start;
    reg has_place;
    reg issue;
    reg is_last;
    reg [2:0] issued;
    reg [2:0] used_more;
    reg [2:0] used_less;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 starting(
        .d(starting_d),
        .q(starting_q),
        .clock(starting_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 started(
        .d(started_d),
        .q(started_q),
        .clock(started_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 scanning(
        .d(scanning_d),
        .q(scanning_q),
        .clock(scanning_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 scan_bank(
        .d(scan_bank_d),
        .q(scan_bank_q),
        .clock(scan_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 scan_pair(
        .d(scan_pair_d),
        .q(scan_pair_q),
        .clock(scan_pair_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_3 scan_end(
        .d(scan_end_d),
        .q(scan_end_q),
        .clock(scan_end_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 scan_release(
        .d(scan_release_d),
        .q(scan_release_q),
        .clock(scan_release_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_32 scan_facings(
        .d(scan_facings_d),
        .q(scan_facings_q),
        .clock(scan_facings_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_3 used(
        .d(used_d),
        .q(used_q),
        .clock(used_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 returned(
        .d(returned_d),
        .q(returned_q),
        .clock(returned_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 look_valid(
        .d(look_valid_d),
        .q(look_valid_q),
        .clock(look_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 look_pair(
        .d(look_pair_d),
        .q(look_pair_q),
        .clock(look_pair_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 look_bank(
        .d(look_bank_d),
        .q(look_bank_q),
        .clock(look_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 look_end(
        .d(look_end_d),
        .q(look_end_q),
        .clock(look_end_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 look_release(
        .d(look_release_d),
        .q(look_release_q),
        .clock(look_release_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 look_second(
        .d(look_second_d),
        .q(look_second_q),
        .clock(look_second_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 found_valid(
        .d(found_valid_d),
        .q(found_valid_q),
        .clock(found_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 found_pair(
        .d(found_pair_d),
        .q(found_pair_q),
        .clock(found_pair_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 found_bank(
        .d(found_bank_d),
        .q(found_bank_q),
        .clock(found_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 found_end(
        .d(found_end_d),
        .q(found_end_q),
        .clock(found_end_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 found_release(
        .d(found_release_d),
        .q(found_release_q),
        .clock(found_release_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 found_second(
        .d(found_second_d),
        .q(found_second_q),
        .clock(found_second_clock)
    );
    // Update code
    always @(*) begin
        starting_clock = clock;
        started_clock = clock;
        scanning_clock = clock;
        scan_bank_clock = clock;
        scan_pair_clock = clock;
        scan_end_clock = clock;
        scan_release_clock = clock;
        scan_facings_clock = clock;
        used_clock = clock;
        returned_clock = clock;
        look_valid_clock = clock;
        look_pair_clock = clock;
        look_bank_clock = clock;
        look_end_clock = clock;
        look_release_clock = clock;
        look_second_clock = clock;
        found_valid_clock = clock;
        found_pair_clock = clock;
        found_bank_clock = clock;
        found_end_clock = clock;
        found_release_clock = clock;
        found_second_clock = clock;
        starting_d = starting_q;
        started_d = started_q;
        scanning_d = scanning_q;
        scan_bank_d = scan_bank_q;
        scan_pair_d = scan_pair_q;
        scan_end_d = scan_end_q;
        scan_release_d = scan_release_q;
        scan_facings_d = scan_facings_q;
        used_d = used_q;
        returned_d = returned_q;
        look_valid_d = look_valid_q;
        look_pair_d = look_pair_q;
        look_bank_d = look_bank_q;
        look_end_d = look_end_q;
        look_release_d = look_release_q;
        look_second_d = look_second_q;
        found_valid_d = found_valid_q;
        found_pair_d = found_pair_q;
        found_bank_d = found_bank_q;
        found_end_d = found_end_q;
        found_release_d = found_release_q;
        found_second_d = found_second_q;
        has_place = used_q != most_used;
        issue = scanning_q & has_place;
        end_pair = scan_end_q[(32'h1)+:(2)];
        is_last = scan_pair_q == end_pair;
        end_leaf = end_0;
        if (scan_bank_q) begin
            end_leaf = end_1;
        end
        next_bank = scan_bank_q ^ (scanning_q & scan_release_q);
        is_full = full_0;
        if (next_bank) begin
            is_full = full_1;
        end
        is_free = ~scanning_q | (has_place & is_last);
        may_start = complete & is_full & ~starting_q;
        starting_d = may_start & is_free;
        started_d = starting_q;
        start = starting_q;
        look_valid_d = issue;
        look_pair_d = scan_pair_q;
        look_bank_d = scan_bank_q;
        look_end_d = is_last;
        look_release_d = scan_release_q;
        look_second_d = ~is_last | scan_end_q[32'h0];
        if (issue) begin
            scan_pair_d = scan_pair_q + 32'h1;
            if (is_last) begin
                scanning_d = 1'b0;
                if (scan_release_q) begin
                    scan_bank_d = ~scan_bank_q;
                end
            end
        end
        if (start) begin
            scanning_d = 1'b1;
            scan_pair_d = 32'h0;
            scan_end_d = end_leaf;
            scan_release_d = releases;
        end
        if (started_q) begin
            scan_facings_d = facings;
        end
        issued = 32'h0;
        if (issue) begin
            issued = 32'h1;
        end
        used_more = used_q + issued;
        used_less = ((returned_q) & 3'h7);
        used_d = used_more - used_less;
        returned_d = 32'h0;
        if (drops | takes_pair) begin
            returned_d = 32'h1;
        end
        if (drops & takes_pair) begin
            returned_d = 32'h2;
        end
        found_valid_d = look_valid_q;
        found_pair_d = look_pair_q;
        found_bank_d = look_bank_q;
        found_end_d = look_end_q;
        found_release_d = look_release_q;
        found_second_d = look_second_q;
        if (reset) begin
            starting_d = 1'b0;
            started_d = 1'b0;
            scanning_d = 1'b0;
            scan_bank_d = 1'b0;
            used_d = 32'h0;
            returned_d = 32'h0;
            look_valid_d = 1'b0;
            found_valid_d = 1'b0;
        end
        starts = start;
        takes_box = started_q;
        issues = issue;
        issue_bank = scan_bank_q;
        issue_pair = scan_pair_q;
        facings_out = scan_facings_q;
        found_valid_out = found_valid_q;
        found_pair_out = found_pair_q;
        found_bank_out = found_bank_q;
        found_end_out = found_end_q;
        found_release_out = found_release_q;
        found_second_out = found_second_q;
        compared = 32'h0;
        if (found_valid_q) begin
            compared = 32'h1;
            if (found_second_q) begin
                compared = 32'h2;
            end
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_fill(clock, reset, group_valid, group_last, group_facing, frees,
    freed_bank, group_ready, write_valid_out, write_bank_out, write_place_out, write_last_out,
    write_facing_out);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire group_valid;
    input wire group_last;
    input wire [4:0] group_facing;
    input wire frees;
    input wire freed_bank;
    output reg group_ready;
    output reg write_valid_out;
    output reg write_bank_out;
    output reg [3:0] write_place_out;
    output reg write_last_out;
    output reg [4:0] write_facing_out;
    // Stub signals
    reg fill_bank_d;
    wire fill_bank_q;
    reg fill_bank_clock;
    reg [3:0] fill_place_d;
    wire [3:0] fill_place_q;
    reg fill_place_clock;
    reg fill_ready_d;
    wire fill_ready_q;
    reg fill_ready_clock;
    reg filled_0_d;
    wire filled_0_q;
    reg filled_0_clock;
    reg filled_1_d;
    wire filled_1_q;
    reg filled_1_clock;
    reg write_valid_d;
    wire write_valid_q;
    reg write_valid_clock;
    reg write_bank_d;
    wire write_bank_q;
    reg write_bank_clock;
    reg [3:0] write_place_d;
    wire [3:0] write_place_q;
    reg write_place_clock;
    reg write_last_d;
    wire write_last_q;
    reg write_last_clock;
    reg [4:0] write_facing_d;
    wire [4:0] write_facing_q;
    reg write_facing_clock;
    // Local signals
    reg takes;
    reg at_end;
    reg is_last;
    reg is_filled;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 fill_bank(
        .d(fill_bank_d),
        .q(fill_bank_q),
        .clock(fill_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_4 fill_place(
        .d(fill_place_d),
        .q(fill_place_q),
        .clock(fill_place_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 fill_ready(
        .d(fill_ready_d),
        .q(fill_ready_q),
        .clock(fill_ready_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 filled_0(
        .d(filled_0_d),
        .q(filled_0_q),
        .clock(filled_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 filled_1(
        .d(filled_1_d),
        .q(filled_1_q),
        .clock(filled_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 write_valid(
        .d(write_valid_d),
        .q(write_valid_q),
        .clock(write_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 write_bank(
        .d(write_bank_d),
        .q(write_bank_q),
        .clock(write_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_4 write_place(
        .d(write_place_d),
        .q(write_place_q),
        .clock(write_place_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 write_last(
        .d(write_last_d),
        .q(write_last_q),
        .clock(write_last_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_5 write_facing(
        .d(write_facing_d),
        .q(write_facing_q),
        .clock(write_facing_clock)
    );
    // Update code
    always @(*) begin
        fill_bank_clock = clock;
        fill_place_clock = clock;
        fill_ready_clock = clock;
        filled_0_clock = clock;
        filled_1_clock = clock;
        write_valid_clock = clock;
        write_bank_clock = clock;
        write_place_clock = clock;
        write_last_clock = clock;
        write_facing_clock = clock;
        fill_bank_d = fill_bank_q;
        fill_place_d = fill_place_q;
        fill_ready_d = fill_ready_q;
        filled_0_d = filled_0_q;
        filled_1_d = filled_1_q;
        write_valid_d = write_valid_q;
        write_bank_d = write_bank_q;
        write_place_d = write_place_q;
        write_last_d = write_last_q;
        write_facing_d = write_facing_q;
        takes = group_valid & fill_ready_q;
        at_end = &fill_place_q;
        is_last = takes & (group_last | at_end);
        is_filled = filled_0_q;
        if (fill_bank_q) begin
            is_filled = filled_1_q;
        end
        fill_ready_d = ~is_filled & ~is_last;
        if (takes) begin
            fill_place_d = fill_place_q + 32'h1;
        end
        if (is_last) begin
            fill_place_d = 32'h0;
            fill_bank_d = ~fill_bank_q;
            if (fill_bank_q) begin
                filled_1_d = 1'b1;
            end
            else begin
                filled_0_d = 1'b1;
            end
        end
        if (frees) begin
            if (freed_bank) begin
                filled_1_d = 1'b0;
            end
            else begin
                filled_0_d = 1'b0;
            end
        end
        write_valid_d = takes;
        write_bank_d = fill_bank_q;
        write_place_d = fill_place_q;
        write_last_d = is_last;
        write_facing_d = group_facing;
        if (reset) begin
            fill_bank_d = 1'b0;
            fill_place_d = 32'h0;
            fill_ready_d = 1'b0;
            filled_0_d = 1'b0;
            filled_1_d = 1'b0;
            write_valid_d = 1'b0;
        end
        group_ready = fill_ready_q;
        write_valid_out = write_valid_q;
        write_bank_out = write_bank_q;
        write_place_out = write_place_q;
        write_last_out = write_last_q;
        write_facing_out = write_facing_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_queue_2(clock, reset, valid, pair, bank, ends, releases, in_range_0,
    in_range_1, in_range_2, in_range_3, gathered_0, gathered_1, short_0, short_1, takes_pair,
    drops, has_pair, oldest_pair, oldest_mask, oldest_flags, wanted);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire valid;
    input wire [1:0] pair;
    input wire bank;
    input wire ends;
    input wire releases;
    input wire in_range_0;
    input wire in_range_1;
    input wire in_range_2;
    input wire in_range_3;
    input wire gathered_0;
    input wire gathered_1;
    input wire short_0;
    input wire short_1;
    input wire takes_pair;
    output reg drops;
    output reg has_pair;
    output reg [1:0] oldest_pair;
    output reg [3:0] oldest_mask;
    output reg [2:0] oldest_flags;
    output reg [1:0] wanted;
    // Stub signals
    reg [1:0] queue_write_d;
    wire [1:0] queue_write_q;
    reg queue_write_clock;
    reg [1:0] queue_read_d;
    wire [1:0] queue_read_q;
    reg queue_read_clock;
    reg [2:0] queue_count_d;
    wire [2:0] queue_count_q;
    reg queue_count_clock;
    reg pair_ram_clock;
    reg pair_ram_write;
    reg [1:0] pair_ram_write_place;
    reg [1:0] pair_ram_write_word;
    reg [1:0] pair_ram_read_place;
    wire [1:0] pair_ram_read_word;
    reg mask_ram_clock;
    reg mask_ram_write;
    reg [1:0] mask_ram_write_place;
    reg [3:0] mask_ram_write_word;
    reg [1:0] mask_ram_read_place;
    wire [3:0] mask_ram_read_word;
    reg flag_ram_clock;
    reg flag_ram_write;
    reg [1:0] flag_ram_write_place;
    reg [2:0] flag_ram_write_word;
    reg [1:0] flag_ram_read_place;
    wire [2:0] flag_ram_read_word;
    // Local signals
    reg second_0;
    reg second_1;
    reg near_0;
    reg near_1;
    reg wanted_0;
    reg wanted_1;
    reg some;
    reg queues;
    reg [3:0] mask;
    reg [2:0] flags;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_2 queue_write(
        .d(queue_write_d),
        .q(queue_write_q),
        .clock(queue_write_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 queue_read(
        .d(queue_read_d),
        .q(queue_read_q),
        .clock(queue_read_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_3 queue_count(
        .d(queue_count_d),
        .q(queue_count_q),
        .clock(queue_count_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_pair_ram pair_ram(
        .clock(pair_ram_clock),
        .write(pair_ram_write),
        .write_place(pair_ram_write_place),
        .write_word(pair_ram_write_word),
        .read_place(pair_ram_read_place),
        .read_word(pair_ram_read_word)
    );
    photoncube_leaf_5_local7_rgb6d_n64_mask_ram mask_ram(
        .clock(mask_ram_clock),
        .write(mask_ram_write),
        .write_place(mask_ram_write_place),
        .write_word(mask_ram_write_word),
        .read_place(mask_ram_read_place),
        .read_word(mask_ram_read_word)
    );
    photoncube_leaf_5_local7_rgb6d_n64_flag_ram flag_ram(
        .clock(flag_ram_clock),
        .write(flag_ram_write),
        .write_place(flag_ram_write_place),
        .write_word(flag_ram_write_word),
        .read_place(flag_ram_read_place),
        .read_word(flag_ram_read_word)
    );
    // Update code
    always @(*) begin
        queue_write_clock = clock;
        queue_read_clock = clock;
        queue_count_clock = clock;
        queue_write_d = queue_write_q;
        queue_read_d = queue_read_q;
        queue_count_d = queue_count_q;
        pair_ram_clock = clock;
        mask_ram_clock = clock;
        flag_ram_clock = clock;
        second_0 = in_range_1 & ~short_0;
        second_1 = in_range_3 & ~short_1;
        near_0 = in_range_0 | second_0;
        near_1 = in_range_2 | second_1;
        wanted_0 = near_0 & gathered_0;
        wanted_1 = near_1 & gathered_1;
        some = wanted_0 | wanted_1 | ends;
        queues = valid & some;
        drops = valid & ~some;
        mask = 32'h0;
        if (in_range_0 & gathered_0) begin
            mask = mask | 32'h1;
        end
        if (second_0 & gathered_0) begin
            mask = mask | 32'h2;
        end
        if (in_range_2 & gathered_1) begin
            mask = mask | 32'h4;
        end
        if (second_1 & gathered_1) begin
            mask = mask | 32'h8;
        end
        wanted = 32'h0;
        if (valid & (wanted_0 | wanted_1)) begin
            wanted = 32'h1;
            if (wanted_0 & wanted_1) begin
                wanted = 32'h2;
            end
        end
        flags = 32'h0;
        if (bank) begin
            flags = flags | 32'h1;
        end
        if (ends) begin
            flags = flags | 32'h2;
        end
        if (releases) begin
            flags = flags | 32'h4;
        end
        pair_ram_write = queues;
        pair_ram_write_place = queue_write_q;
        pair_ram_write_word = pair;
        pair_ram_read_place = queue_read_q;
        mask_ram_write = queues;
        mask_ram_write_place = queue_write_q;
        mask_ram_write_word = mask;
        mask_ram_read_place = queue_read_q;
        flag_ram_write = queues;
        flag_ram_write_place = queue_write_q;
        flag_ram_write_word = flags;
        flag_ram_read_place = queue_read_q;
        if (queues) begin
            queue_write_d = queue_write_q + 32'h1;
        end
        if (takes_pair) begin
            queue_read_d = queue_read_q + 32'h1;
        end
        if (queues & ~takes_pair) begin
            queue_count_d = queue_count_q + 32'h1;
        end
        if (takes_pair & ~queues) begin
            queue_count_d = queue_count_q - 32'h1;
        end
        if (reset) begin
            queue_write_d = 32'h0;
            queue_read_d = 32'h0;
            queue_count_d = 32'h0;
        end
        has_pair = |queue_count_q;
        oldest_pair = pair_ram_read_word;
        oldest_mask = mask_ram_read_word;
        oldest_flags = flag_ram_read_word;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_chain(clock, reset, query_valid, query_ready, query_x, query_y,
    query_z, group_valid, group_ready, group_last, photon_present_0, photon_present_1,
    photon_present_2, photon_present_3, photon_x_0, photon_x_1, photon_x_2, photon_x_3,
    photon_y_0, photon_y_1, photon_y_2, photon_y_3, photon_z_0, photon_z_1, photon_z_2,
    photon_z_3, photon_red_0, photon_red_1, photon_red_2, photon_red_3, photon_green_0,
    photon_green_1, photon_green_2, photon_green_3, photon_blue_0, photon_blue_1, photon_blue_2,
    photon_blue_3, result_valid, result_ready, result_red, result_green, result_blue,
    result_count);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    output reg query_ready;
    input wire [8:0] query_x;
    input wire [8:0] query_y;
    input wire [8:0] query_z;
    input wire group_valid;
    output reg group_ready;
    input wire group_last;
    input wire photon_present_0;
    input wire photon_present_1;
    input wire photon_present_2;
    input wire photon_present_3;
    input wire [8:0] photon_x_0;
    input wire [8:0] photon_x_1;
    input wire [8:0] photon_x_2;
    input wire [8:0] photon_x_3;
    input wire [8:0] photon_y_0;
    input wire [8:0] photon_y_1;
    input wire [8:0] photon_y_2;
    input wire [8:0] photon_y_3;
    input wire [8:0] photon_z_0;
    input wire [8:0] photon_z_1;
    input wire [8:0] photon_z_2;
    input wire [8:0] photon_z_3;
    input wire [5:0] photon_red_0;
    input wire [5:0] photon_red_1;
    input wire [5:0] photon_red_2;
    input wire [5:0] photon_red_3;
    input wire [5:0] photon_green_0;
    input wire [5:0] photon_green_1;
    input wire [5:0] photon_green_2;
    input wire [5:0] photon_green_3;
    input wire [5:0] photon_blue_0;
    input wire [5:0] photon_blue_1;
    input wire [5:0] photon_blue_2;
    input wire [5:0] photon_blue_3;
    output reg result_valid;
    input wire result_ready;
    output reg [11:0] result_red;
    output reg [11:0] result_green;
    output reg [11:0] result_blue;
    output reg [6:0] result_count;
    // Stub signals
    reg entry_token_valid_clock;
    reg entry_token_valid_clear;
    reg entry_token_valid_d;
    wire entry_token_valid_q;
    reg [8:0] entry_token_0_d;
    wire [8:0] entry_token_0_q;
    reg entry_token_0_clock;
    reg [8:0] entry_token_1_d;
    wire [8:0] entry_token_1_q;
    reg entry_token_1_clock;
    reg [8:0] entry_token_2_d;
    wire [8:0] entry_token_2_q;
    reg entry_token_2_clock;
    reg [8:0] entry_photon_0_d;
    wire [8:0] entry_photon_0_q;
    reg entry_photon_0_clock;
    reg [8:0] entry_photon_1_d;
    wire [8:0] entry_photon_1_q;
    reg entry_photon_1_clock;
    reg [8:0] entry_photon_2_d;
    wire [8:0] entry_photon_2_q;
    reg entry_photon_2_clock;
    reg [8:0] entry_photon_3_d;
    wire [8:0] entry_photon_3_q;
    reg entry_photon_3_clock;
    reg [8:0] entry_photon_4_d;
    wire [8:0] entry_photon_4_q;
    reg entry_photon_4_clock;
    reg [8:0] entry_photon_5_d;
    wire [8:0] entry_photon_5_q;
    reg entry_photon_5_clock;
    reg [8:0] entry_photon_6_d;
    wire [8:0] entry_photon_6_q;
    reg entry_photon_6_clock;
    reg [8:0] entry_photon_7_d;
    wire [8:0] entry_photon_7_q;
    reg entry_photon_7_clock;
    reg [8:0] entry_photon_8_d;
    wire [8:0] entry_photon_8_q;
    reg entry_photon_8_clock;
    reg [8:0] entry_photon_9_d;
    wire [8:0] entry_photon_9_q;
    reg entry_photon_9_clock;
    reg [8:0] entry_photon_10_d;
    wire [8:0] entry_photon_10_q;
    reg entry_photon_10_clock;
    reg [8:0] entry_photon_11_d;
    wire [8:0] entry_photon_11_q;
    reg entry_photon_11_clock;
    reg [5:0] entry_mantissa_0_d;
    wire [5:0] entry_mantissa_0_q;
    reg entry_mantissa_0_clock;
    reg [5:0] entry_mantissa_1_d;
    wire [5:0] entry_mantissa_1_q;
    reg entry_mantissa_1_clock;
    reg [5:0] entry_mantissa_2_d;
    wire [5:0] entry_mantissa_2_q;
    reg entry_mantissa_2_clock;
    reg [5:0] entry_mantissa_3_d;
    wire [5:0] entry_mantissa_3_q;
    reg entry_mantissa_3_clock;
    reg [5:0] entry_mantissa_4_d;
    wire [5:0] entry_mantissa_4_q;
    reg entry_mantissa_4_clock;
    reg [5:0] entry_mantissa_5_d;
    wire [5:0] entry_mantissa_5_q;
    reg entry_mantissa_5_clock;
    reg [5:0] entry_mantissa_6_d;
    wire [5:0] entry_mantissa_6_q;
    reg entry_mantissa_6_clock;
    reg [5:0] entry_mantissa_7_d;
    wire [5:0] entry_mantissa_7_q;
    reg entry_mantissa_7_clock;
    reg [5:0] entry_mantissa_8_d;
    wire [5:0] entry_mantissa_8_q;
    reg entry_mantissa_8_clock;
    reg [5:0] entry_mantissa_9_d;
    wire [5:0] entry_mantissa_9_q;
    reg entry_mantissa_9_clock;
    reg [5:0] entry_mantissa_10_d;
    wire [5:0] entry_mantissa_10_q;
    reg entry_mantissa_10_clock;
    reg [5:0] entry_mantissa_11_d;
    wire [5:0] entry_mantissa_11_q;
    reg entry_mantissa_11_clock;
    reg entry_present_0_d;
    wire entry_present_0_q;
    reg entry_present_0_clock;
    reg entry_present_1_d;
    wire entry_present_1_q;
    reg entry_present_1_clock;
    reg entry_present_2_d;
    wire entry_present_2_q;
    reg entry_present_2_clock;
    reg entry_present_3_d;
    wire entry_present_3_q;
    reg entry_present_3_clock;
    reg entry_taken_d;
    wire entry_taken_q;
    reg entry_taken_clock;
    reg entry_first_clock;
    reg entry_first_clear;
    reg entry_first_d;
    wire entry_first_q;
    reg entry_last_clock;
    reg entry_last_clear;
    reg entry_last_d;
    wire entry_last_q;
    reg head_clock;
    reg head_reset;
    reg head_query_valid;
    wire head_query_ready;
    reg head_group_valid;
    reg head_group_last;
    wire head_group_ready;
    wire head_taken;
    wire head_first_taken;
    wire head_last_taken;
    reg [5:0] head_red_0;
    reg [5:0] head_red_1;
    reg [5:0] head_red_2;
    reg [5:0] head_red_3;
    reg [5:0] head_green_0;
    reg [5:0] head_green_1;
    reg [5:0] head_green_2;
    reg [5:0] head_green_3;
    reg [5:0] head_blue_0;
    reg [5:0] head_blue_1;
    reg [5:0] head_blue_2;
    reg [5:0] head_blue_3;
    reg head_present_0;
    reg head_present_1;
    reg head_present_2;
    reg head_present_3;
    reg head_taken_in;
    reg head_first_in;
    reg head_last_in;
    wire head_result_valid;
    wire [11:0] head_result_red;
    wire [11:0] head_result_green;
    wire [11:0] head_result_blue;
    wire [6:0] head_result_count;
    reg head_result_ready;
    wire head_token_valid;
    wire head_is_full;
    wire head_has_room;
    wire [15:0] head_clocks_to_last;
    wire [5:0] head_power_0;
    wire [5:0] head_power_1;
    wire [5:0] head_power_2;
    wire [5:0] head_power_3;
    wire [5:0] head_power_4;
    wire [5:0] head_power_5;
    wire [5:0] head_power_6;
    wire [5:0] head_power_7;
    wire [5:0] head_power_8;
    wire [5:0] head_power_9;
    wire [5:0] head_power_10;
    wire [5:0] head_power_11;
    wire head_power_present_0;
    wire head_power_present_1;
    wire head_power_present_2;
    wire head_power_present_3;
    wire head_first;
    wire head_last;
    reg head_result_valid_in;
    reg [11:0] head_result_in_0;
    reg [11:0] head_result_in_1;
    reg [11:0] head_result_in_2;
    reg [6:0] head_result_count_in;
    reg engine_0_clock;
    reg engine_0_reset_in;
    reg engine_0_token_valid_in;
    reg [8:0] engine_0_token_in_0;
    reg [8:0] engine_0_token_in_1;
    reg [8:0] engine_0_token_in_2;
    reg engine_0_swap_in;
    reg [8:0] engine_0_photon_in_0;
    reg [8:0] engine_0_photon_in_1;
    reg [8:0] engine_0_photon_in_2;
    reg [8:0] engine_0_photon_in_3;
    reg [8:0] engine_0_photon_in_4;
    reg [8:0] engine_0_photon_in_5;
    reg [8:0] engine_0_photon_in_6;
    reg [8:0] engine_0_photon_in_7;
    reg [8:0] engine_0_photon_in_8;
    reg [8:0] engine_0_photon_in_9;
    reg [8:0] engine_0_photon_in_10;
    reg [8:0] engine_0_photon_in_11;
    reg [5:0] engine_0_power_in_0;
    reg [5:0] engine_0_power_in_1;
    reg [5:0] engine_0_power_in_2;
    reg [5:0] engine_0_power_in_3;
    reg [5:0] engine_0_power_in_4;
    reg [5:0] engine_0_power_in_5;
    reg [5:0] engine_0_power_in_6;
    reg [5:0] engine_0_power_in_7;
    reg [5:0] engine_0_power_in_8;
    reg [5:0] engine_0_power_in_9;
    reg [5:0] engine_0_power_in_10;
    reg [5:0] engine_0_power_in_11;
    reg engine_0_present_in_0;
    reg engine_0_present_in_1;
    reg engine_0_present_in_2;
    reg engine_0_present_in_3;
    reg engine_0_first_in;
    reg engine_0_last_in;
    reg engine_0_result_valid_in;
    reg [11:0] engine_0_result_in_0;
    reg [11:0] engine_0_result_in_1;
    reg [11:0] engine_0_result_in_2;
    reg [6:0] engine_0_result_count_in;
    wire engine_0_reset_out;
    wire engine_0_token_valid_out;
    wire [8:0] engine_0_token_out_0;
    wire [8:0] engine_0_token_out_1;
    wire [8:0] engine_0_token_out_2;
    wire engine_0_swap_out;
    wire [8:0] engine_0_photon_out_0;
    wire [8:0] engine_0_photon_out_1;
    wire [8:0] engine_0_photon_out_2;
    wire [8:0] engine_0_photon_out_3;
    wire [8:0] engine_0_photon_out_4;
    wire [8:0] engine_0_photon_out_5;
    wire [8:0] engine_0_photon_out_6;
    wire [8:0] engine_0_photon_out_7;
    wire [8:0] engine_0_photon_out_8;
    wire [8:0] engine_0_photon_out_9;
    wire [8:0] engine_0_photon_out_10;
    wire [8:0] engine_0_photon_out_11;
    wire [5:0] engine_0_power_out_0;
    wire [5:0] engine_0_power_out_1;
    wire [5:0] engine_0_power_out_2;
    wire [5:0] engine_0_power_out_3;
    wire [5:0] engine_0_power_out_4;
    wire [5:0] engine_0_power_out_5;
    wire [5:0] engine_0_power_out_6;
    wire [5:0] engine_0_power_out_7;
    wire [5:0] engine_0_power_out_8;
    wire [5:0] engine_0_power_out_9;
    wire [5:0] engine_0_power_out_10;
    wire [5:0] engine_0_power_out_11;
    wire engine_0_present_out_0;
    wire engine_0_present_out_1;
    wire engine_0_present_out_2;
    wire engine_0_present_out_3;
    wire engine_0_first_out;
    wire engine_0_last_out;
    wire engine_0_result_valid_out;
    wire [11:0] engine_0_result_out_0;
    wire [11:0] engine_0_result_out_1;
    wire [11:0] engine_0_result_out_2;
    wire [6:0] engine_0_result_count_out;
    reg engine_1_clock;
    reg engine_1_reset_in;
    reg engine_1_token_valid_in;
    reg [8:0] engine_1_token_in_0;
    reg [8:0] engine_1_token_in_1;
    reg [8:0] engine_1_token_in_2;
    reg engine_1_swap_in;
    reg [8:0] engine_1_photon_in_0;
    reg [8:0] engine_1_photon_in_1;
    reg [8:0] engine_1_photon_in_2;
    reg [8:0] engine_1_photon_in_3;
    reg [8:0] engine_1_photon_in_4;
    reg [8:0] engine_1_photon_in_5;
    reg [8:0] engine_1_photon_in_6;
    reg [8:0] engine_1_photon_in_7;
    reg [8:0] engine_1_photon_in_8;
    reg [8:0] engine_1_photon_in_9;
    reg [8:0] engine_1_photon_in_10;
    reg [8:0] engine_1_photon_in_11;
    reg [5:0] engine_1_power_in_0;
    reg [5:0] engine_1_power_in_1;
    reg [5:0] engine_1_power_in_2;
    reg [5:0] engine_1_power_in_3;
    reg [5:0] engine_1_power_in_4;
    reg [5:0] engine_1_power_in_5;
    reg [5:0] engine_1_power_in_6;
    reg [5:0] engine_1_power_in_7;
    reg [5:0] engine_1_power_in_8;
    reg [5:0] engine_1_power_in_9;
    reg [5:0] engine_1_power_in_10;
    reg [5:0] engine_1_power_in_11;
    reg engine_1_present_in_0;
    reg engine_1_present_in_1;
    reg engine_1_present_in_2;
    reg engine_1_present_in_3;
    reg engine_1_first_in;
    reg engine_1_last_in;
    reg engine_1_result_valid_in;
    reg [11:0] engine_1_result_in_0;
    reg [11:0] engine_1_result_in_1;
    reg [11:0] engine_1_result_in_2;
    reg [6:0] engine_1_result_count_in;
    wire engine_1_reset_out;
    wire engine_1_token_valid_out;
    wire [8:0] engine_1_token_out_0;
    wire [8:0] engine_1_token_out_1;
    wire [8:0] engine_1_token_out_2;
    wire engine_1_swap_out;
    wire [8:0] engine_1_photon_out_0;
    wire [8:0] engine_1_photon_out_1;
    wire [8:0] engine_1_photon_out_2;
    wire [8:0] engine_1_photon_out_3;
    wire [8:0] engine_1_photon_out_4;
    wire [8:0] engine_1_photon_out_5;
    wire [8:0] engine_1_photon_out_6;
    wire [8:0] engine_1_photon_out_7;
    wire [8:0] engine_1_photon_out_8;
    wire [8:0] engine_1_photon_out_9;
    wire [8:0] engine_1_photon_out_10;
    wire [8:0] engine_1_photon_out_11;
    wire [5:0] engine_1_power_out_0;
    wire [5:0] engine_1_power_out_1;
    wire [5:0] engine_1_power_out_2;
    wire [5:0] engine_1_power_out_3;
    wire [5:0] engine_1_power_out_4;
    wire [5:0] engine_1_power_out_5;
    wire [5:0] engine_1_power_out_6;
    wire [5:0] engine_1_power_out_7;
    wire [5:0] engine_1_power_out_8;
    wire [5:0] engine_1_power_out_9;
    wire [5:0] engine_1_power_out_10;
    wire [5:0] engine_1_power_out_11;
    wire engine_1_present_out_0;
    wire engine_1_present_out_1;
    wire engine_1_present_out_2;
    wire engine_1_present_out_3;
    wire engine_1_first_out;
    wire engine_1_last_out;
    wire engine_1_result_valid_out;
    wire [11:0] engine_1_result_out_0;
    wire [11:0] engine_1_result_out_1;
    wire [11:0] engine_1_result_out_2;
    wire [6:0] engine_1_result_count_out;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_group_first entry_token_valid(
        .clock(entry_token_valid_clock),
        .clear(entry_token_valid_clear),
        .d(entry_token_valid_d),
        .q(entry_token_valid_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_token_0(
        .d(entry_token_0_d),
        .q(entry_token_0_q),
        .clock(entry_token_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_token_1(
        .d(entry_token_1_d),
        .q(entry_token_1_q),
        .clock(entry_token_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_token_2(
        .d(entry_token_2_d),
        .q(entry_token_2_q),
        .clock(entry_token_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_0(
        .d(entry_photon_0_d),
        .q(entry_photon_0_q),
        .clock(entry_photon_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_1(
        .d(entry_photon_1_d),
        .q(entry_photon_1_q),
        .clock(entry_photon_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_2(
        .d(entry_photon_2_d),
        .q(entry_photon_2_q),
        .clock(entry_photon_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_3(
        .d(entry_photon_3_d),
        .q(entry_photon_3_q),
        .clock(entry_photon_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_4(
        .d(entry_photon_4_d),
        .q(entry_photon_4_q),
        .clock(entry_photon_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_5(
        .d(entry_photon_5_d),
        .q(entry_photon_5_q),
        .clock(entry_photon_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_6(
        .d(entry_photon_6_d),
        .q(entry_photon_6_q),
        .clock(entry_photon_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_7(
        .d(entry_photon_7_d),
        .q(entry_photon_7_q),
        .clock(entry_photon_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_8(
        .d(entry_photon_8_d),
        .q(entry_photon_8_q),
        .clock(entry_photon_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_9(
        .d(entry_photon_9_d),
        .q(entry_photon_9_q),
        .clock(entry_photon_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_10(
        .d(entry_photon_10_d),
        .q(entry_photon_10_q),
        .clock(entry_photon_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 entry_photon_11(
        .d(entry_photon_11_d),
        .q(entry_photon_11_q),
        .clock(entry_photon_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_0(
        .d(entry_mantissa_0_d),
        .q(entry_mantissa_0_q),
        .clock(entry_mantissa_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_1(
        .d(entry_mantissa_1_d),
        .q(entry_mantissa_1_q),
        .clock(entry_mantissa_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_2(
        .d(entry_mantissa_2_d),
        .q(entry_mantissa_2_q),
        .clock(entry_mantissa_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_3(
        .d(entry_mantissa_3_d),
        .q(entry_mantissa_3_q),
        .clock(entry_mantissa_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_4(
        .d(entry_mantissa_4_d),
        .q(entry_mantissa_4_q),
        .clock(entry_mantissa_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_5(
        .d(entry_mantissa_5_d),
        .q(entry_mantissa_5_q),
        .clock(entry_mantissa_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_6(
        .d(entry_mantissa_6_d),
        .q(entry_mantissa_6_q),
        .clock(entry_mantissa_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_7(
        .d(entry_mantissa_7_d),
        .q(entry_mantissa_7_q),
        .clock(entry_mantissa_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_8(
        .d(entry_mantissa_8_d),
        .q(entry_mantissa_8_q),
        .clock(entry_mantissa_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_9(
        .d(entry_mantissa_9_d),
        .q(entry_mantissa_9_q),
        .clock(entry_mantissa_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_10(
        .d(entry_mantissa_10_d),
        .q(entry_mantissa_10_q),
        .clock(entry_mantissa_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 entry_mantissa_11(
        .d(entry_mantissa_11_d),
        .q(entry_mantissa_11_q),
        .clock(entry_mantissa_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_present_0(
        .d(entry_present_0_d),
        .q(entry_present_0_q),
        .clock(entry_present_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_present_1(
        .d(entry_present_1_d),
        .q(entry_present_1_q),
        .clock(entry_present_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_present_2(
        .d(entry_present_2_d),
        .q(entry_present_2_q),
        .clock(entry_present_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_present_3(
        .d(entry_present_3_d),
        .q(entry_present_3_q),
        .clock(entry_present_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_taken(
        .d(entry_taken_d),
        .q(entry_taken_q),
        .clock(entry_taken_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first entry_first(
        .clock(entry_first_clock),
        .clear(entry_first_clear),
        .d(entry_first_d),
        .q(entry_first_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first entry_last(
        .clock(entry_last_clock),
        .clear(entry_last_clear),
        .d(entry_last_d),
        .q(entry_last_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_head head(
        .clock(head_clock),
        .reset(head_reset),
        .query_valid(head_query_valid),
        .query_ready(head_query_ready),
        .group_valid(head_group_valid),
        .group_last(head_group_last),
        .group_ready(head_group_ready),
        .taken(head_taken),
        .first_taken(head_first_taken),
        .last_taken(head_last_taken),
        .red_0(head_red_0),
        .red_1(head_red_1),
        .red_2(head_red_2),
        .red_3(head_red_3),
        .green_0(head_green_0),
        .green_1(head_green_1),
        .green_2(head_green_2),
        .green_3(head_green_3),
        .blue_0(head_blue_0),
        .blue_1(head_blue_1),
        .blue_2(head_blue_2),
        .blue_3(head_blue_3),
        .present_0(head_present_0),
        .present_1(head_present_1),
        .present_2(head_present_2),
        .present_3(head_present_3),
        .taken_in(head_taken_in),
        .first_in(head_first_in),
        .last_in(head_last_in),
        .result_valid(head_result_valid),
        .result_red(head_result_red),
        .result_green(head_result_green),
        .result_blue(head_result_blue),
        .result_count(head_result_count),
        .result_ready(head_result_ready),
        .token_valid(head_token_valid),
        .is_full(head_is_full),
        .has_room(head_has_room),
        .clocks_to_last(head_clocks_to_last),
        .power_0(head_power_0),
        .power_1(head_power_1),
        .power_2(head_power_2),
        .power_3(head_power_3),
        .power_4(head_power_4),
        .power_5(head_power_5),
        .power_6(head_power_6),
        .power_7(head_power_7),
        .power_8(head_power_8),
        .power_9(head_power_9),
        .power_10(head_power_10),
        .power_11(head_power_11),
        .power_present_0(head_power_present_0),
        .power_present_1(head_power_present_1),
        .power_present_2(head_power_present_2),
        .power_present_3(head_power_present_3),
        .first(head_first),
        .last(head_last),
        .result_valid_in(head_result_valid_in),
        .result_in_0(head_result_in_0),
        .result_in_1(head_result_in_1),
        .result_in_2(head_result_in_2),
        .result_count_in(head_result_count_in)
    );
    photoncube_leaf_5_local7_rgb6d_n64_engine engine_0(
        .clock(engine_0_clock),
        .reset_in(engine_0_reset_in),
        .token_valid_in(engine_0_token_valid_in),
        .token_in_0(engine_0_token_in_0),
        .token_in_1(engine_0_token_in_1),
        .token_in_2(engine_0_token_in_2),
        .swap_in(engine_0_swap_in),
        .photon_in_0(engine_0_photon_in_0),
        .photon_in_1(engine_0_photon_in_1),
        .photon_in_2(engine_0_photon_in_2),
        .photon_in_3(engine_0_photon_in_3),
        .photon_in_4(engine_0_photon_in_4),
        .photon_in_5(engine_0_photon_in_5),
        .photon_in_6(engine_0_photon_in_6),
        .photon_in_7(engine_0_photon_in_7),
        .photon_in_8(engine_0_photon_in_8),
        .photon_in_9(engine_0_photon_in_9),
        .photon_in_10(engine_0_photon_in_10),
        .photon_in_11(engine_0_photon_in_11),
        .power_in_0(engine_0_power_in_0),
        .power_in_1(engine_0_power_in_1),
        .power_in_2(engine_0_power_in_2),
        .power_in_3(engine_0_power_in_3),
        .power_in_4(engine_0_power_in_4),
        .power_in_5(engine_0_power_in_5),
        .power_in_6(engine_0_power_in_6),
        .power_in_7(engine_0_power_in_7),
        .power_in_8(engine_0_power_in_8),
        .power_in_9(engine_0_power_in_9),
        .power_in_10(engine_0_power_in_10),
        .power_in_11(engine_0_power_in_11),
        .present_in_0(engine_0_present_in_0),
        .present_in_1(engine_0_present_in_1),
        .present_in_2(engine_0_present_in_2),
        .present_in_3(engine_0_present_in_3),
        .first_in(engine_0_first_in),
        .last_in(engine_0_last_in),
        .result_valid_in(engine_0_result_valid_in),
        .result_in_0(engine_0_result_in_0),
        .result_in_1(engine_0_result_in_1),
        .result_in_2(engine_0_result_in_2),
        .result_count_in(engine_0_result_count_in),
        .reset_out(engine_0_reset_out),
        .token_valid_out(engine_0_token_valid_out),
        .token_out_0(engine_0_token_out_0),
        .token_out_1(engine_0_token_out_1),
        .token_out_2(engine_0_token_out_2),
        .swap_out(engine_0_swap_out),
        .photon_out_0(engine_0_photon_out_0),
        .photon_out_1(engine_0_photon_out_1),
        .photon_out_2(engine_0_photon_out_2),
        .photon_out_3(engine_0_photon_out_3),
        .photon_out_4(engine_0_photon_out_4),
        .photon_out_5(engine_0_photon_out_5),
        .photon_out_6(engine_0_photon_out_6),
        .photon_out_7(engine_0_photon_out_7),
        .photon_out_8(engine_0_photon_out_8),
        .photon_out_9(engine_0_photon_out_9),
        .photon_out_10(engine_0_photon_out_10),
        .photon_out_11(engine_0_photon_out_11),
        .power_out_0(engine_0_power_out_0),
        .power_out_1(engine_0_power_out_1),
        .power_out_2(engine_0_power_out_2),
        .power_out_3(engine_0_power_out_3),
        .power_out_4(engine_0_power_out_4),
        .power_out_5(engine_0_power_out_5),
        .power_out_6(engine_0_power_out_6),
        .power_out_7(engine_0_power_out_7),
        .power_out_8(engine_0_power_out_8),
        .power_out_9(engine_0_power_out_9),
        .power_out_10(engine_0_power_out_10),
        .power_out_11(engine_0_power_out_11),
        .present_out_0(engine_0_present_out_0),
        .present_out_1(engine_0_present_out_1),
        .present_out_2(engine_0_present_out_2),
        .present_out_3(engine_0_present_out_3),
        .first_out(engine_0_first_out),
        .last_out(engine_0_last_out),
        .result_valid_out(engine_0_result_valid_out),
        .result_out_0(engine_0_result_out_0),
        .result_out_1(engine_0_result_out_1),
        .result_out_2(engine_0_result_out_2),
        .result_count_out(engine_0_result_count_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_engine_2 engine_1(
        .clock(engine_1_clock),
        .reset_in(engine_1_reset_in),
        .token_valid_in(engine_1_token_valid_in),
        .token_in_0(engine_1_token_in_0),
        .token_in_1(engine_1_token_in_1),
        .token_in_2(engine_1_token_in_2),
        .swap_in(engine_1_swap_in),
        .photon_in_0(engine_1_photon_in_0),
        .photon_in_1(engine_1_photon_in_1),
        .photon_in_2(engine_1_photon_in_2),
        .photon_in_3(engine_1_photon_in_3),
        .photon_in_4(engine_1_photon_in_4),
        .photon_in_5(engine_1_photon_in_5),
        .photon_in_6(engine_1_photon_in_6),
        .photon_in_7(engine_1_photon_in_7),
        .photon_in_8(engine_1_photon_in_8),
        .photon_in_9(engine_1_photon_in_9),
        .photon_in_10(engine_1_photon_in_10),
        .photon_in_11(engine_1_photon_in_11),
        .power_in_0(engine_1_power_in_0),
        .power_in_1(engine_1_power_in_1),
        .power_in_2(engine_1_power_in_2),
        .power_in_3(engine_1_power_in_3),
        .power_in_4(engine_1_power_in_4),
        .power_in_5(engine_1_power_in_5),
        .power_in_6(engine_1_power_in_6),
        .power_in_7(engine_1_power_in_7),
        .power_in_8(engine_1_power_in_8),
        .power_in_9(engine_1_power_in_9),
        .power_in_10(engine_1_power_in_10),
        .power_in_11(engine_1_power_in_11),
        .present_in_0(engine_1_present_in_0),
        .present_in_1(engine_1_present_in_1),
        .present_in_2(engine_1_present_in_2),
        .present_in_3(engine_1_present_in_3),
        .first_in(engine_1_first_in),
        .last_in(engine_1_last_in),
        .result_valid_in(engine_1_result_valid_in),
        .result_in_0(engine_1_result_in_0),
        .result_in_1(engine_1_result_in_1),
        .result_in_2(engine_1_result_in_2),
        .result_count_in(engine_1_result_count_in),
        .reset_out(engine_1_reset_out),
        .token_valid_out(engine_1_token_valid_out),
        .token_out_0(engine_1_token_out_0),
        .token_out_1(engine_1_token_out_1),
        .token_out_2(engine_1_token_out_2),
        .swap_out(engine_1_swap_out),
        .photon_out_0(engine_1_photon_out_0),
        .photon_out_1(engine_1_photon_out_1),
        .photon_out_2(engine_1_photon_out_2),
        .photon_out_3(engine_1_photon_out_3),
        .photon_out_4(engine_1_photon_out_4),
        .photon_out_5(engine_1_photon_out_5),
        .photon_out_6(engine_1_photon_out_6),
        .photon_out_7(engine_1_photon_out_7),
        .photon_out_8(engine_1_photon_out_8),
        .photon_out_9(engine_1_photon_out_9),
        .photon_out_10(engine_1_photon_out_10),
        .photon_out_11(engine_1_photon_out_11),
        .power_out_0(engine_1_power_out_0),
        .power_out_1(engine_1_power_out_1),
        .power_out_2(engine_1_power_out_2),
        .power_out_3(engine_1_power_out_3),
        .power_out_4(engine_1_power_out_4),
        .power_out_5(engine_1_power_out_5),
        .power_out_6(engine_1_power_out_6),
        .power_out_7(engine_1_power_out_7),
        .power_out_8(engine_1_power_out_8),
        .power_out_9(engine_1_power_out_9),
        .power_out_10(engine_1_power_out_10),
        .power_out_11(engine_1_power_out_11),
        .present_out_0(engine_1_present_out_0),
        .present_out_1(engine_1_present_out_1),
        .present_out_2(engine_1_present_out_2),
        .present_out_3(engine_1_present_out_3),
        .first_out(engine_1_first_out),
        .last_out(engine_1_last_out),
        .result_valid_out(engine_1_result_valid_out),
        .result_out_0(engine_1_result_out_0),
        .result_out_1(engine_1_result_out_1),
        .result_out_2(engine_1_result_out_2),
        .result_count_out(engine_1_result_count_out)
    );
    // Update code
    always @(*) begin
        head_clock = clock;
        head_reset = reset;
        head_query_valid = query_valid;
        query_ready = head_query_ready;
        head_result_ready = result_ready;
        result_valid = head_result_valid;
        result_count = head_result_count;
        head_result_valid_in = engine_0_result_valid_out;
        head_result_count_in = engine_0_result_count_out;
        head_result_in_0 = engine_0_result_out_0;
        result_red = head_result_red;
        head_result_in_1 = engine_0_result_out_1;
        result_green = head_result_green;
        head_result_in_2 = engine_0_result_out_2;
        result_blue = head_result_blue;
        head_group_valid = group_valid;
        head_group_last = group_last;
        group_ready = head_group_ready;
        entry_present_0_d = photon_present_0;
        entry_photon_0_d = photon_x_0;
        entry_photon_1_d = photon_y_0;
        entry_photon_2_d = photon_z_0;
        entry_present_1_d = photon_present_1;
        entry_photon_3_d = photon_x_1;
        entry_photon_4_d = photon_y_1;
        entry_photon_5_d = photon_z_1;
        entry_present_2_d = photon_present_2;
        entry_photon_6_d = photon_x_2;
        entry_photon_7_d = photon_y_2;
        entry_photon_8_d = photon_z_2;
        entry_present_3_d = photon_present_3;
        entry_photon_9_d = photon_x_3;
        entry_photon_10_d = photon_y_3;
        entry_photon_11_d = photon_z_3;
        entry_mantissa_0_d = photon_red_0;
        entry_mantissa_1_d = photon_red_1;
        entry_mantissa_2_d = photon_red_2;
        entry_mantissa_3_d = photon_red_3;
        entry_mantissa_4_d = photon_green_0;
        entry_mantissa_5_d = photon_green_1;
        entry_mantissa_6_d = photon_green_2;
        entry_mantissa_7_d = photon_green_3;
        entry_mantissa_8_d = photon_blue_0;
        entry_mantissa_9_d = photon_blue_1;
        entry_mantissa_10_d = photon_blue_2;
        entry_mantissa_11_d = photon_blue_3;
        entry_token_valid_clock = clock;
        entry_token_valid_clear = reset;
        entry_token_valid_d = head_token_valid;
        entry_token_0_d = query_x;
        entry_token_1_d = query_y;
        entry_token_2_d = query_z;
        entry_first_clock = clock;
        entry_first_clear = reset;
        entry_first_d = head_first_taken;
        entry_last_clock = clock;
        entry_last_clear = reset;
        entry_last_d = head_last_taken;
        entry_taken_clock = clock;
        entry_taken_d = head_taken;
        head_taken_in = entry_taken_q;
        head_first_in = entry_first_q;
        head_last_in = entry_last_q;
        entry_token_0_clock = clock;
        entry_token_1_clock = clock;
        entry_token_2_clock = clock;
        entry_photon_0_clock = clock;
        entry_photon_1_clock = clock;
        entry_photon_2_clock = clock;
        entry_photon_3_clock = clock;
        entry_photon_4_clock = clock;
        entry_photon_5_clock = clock;
        entry_photon_6_clock = clock;
        entry_photon_7_clock = clock;
        entry_photon_8_clock = clock;
        entry_photon_9_clock = clock;
        entry_photon_10_clock = clock;
        entry_photon_11_clock = clock;
        entry_mantissa_0_clock = clock;
        head_red_0 = entry_mantissa_0_q;
        entry_mantissa_1_clock = clock;
        head_red_1 = entry_mantissa_1_q;
        entry_mantissa_2_clock = clock;
        head_red_2 = entry_mantissa_2_q;
        entry_mantissa_3_clock = clock;
        head_red_3 = entry_mantissa_3_q;
        entry_mantissa_4_clock = clock;
        head_green_0 = entry_mantissa_4_q;
        entry_mantissa_5_clock = clock;
        head_green_1 = entry_mantissa_5_q;
        entry_mantissa_6_clock = clock;
        head_green_2 = entry_mantissa_6_q;
        entry_mantissa_7_clock = clock;
        head_green_3 = entry_mantissa_7_q;
        entry_mantissa_8_clock = clock;
        head_blue_0 = entry_mantissa_8_q;
        entry_mantissa_9_clock = clock;
        head_blue_1 = entry_mantissa_9_q;
        entry_mantissa_10_clock = clock;
        head_blue_2 = entry_mantissa_10_q;
        entry_mantissa_11_clock = clock;
        head_blue_3 = entry_mantissa_11_q;
        entry_present_0_clock = clock;
        head_present_0 = entry_present_0_q;
        entry_present_1_clock = clock;
        head_present_1 = entry_present_1_q;
        entry_present_2_clock = clock;
        head_present_2 = entry_present_2_q;
        entry_present_3_clock = clock;
        head_present_3 = entry_present_3_q;
        engine_0_clock = clock;
        engine_0_reset_in = reset;
        engine_0_token_valid_in = entry_token_valid_q;
        engine_0_swap_in = entry_first_q;
        engine_0_first_in = head_first;
        engine_0_last_in = head_last;
        engine_0_token_in_0 = entry_token_0_q;
        engine_0_token_in_1 = entry_token_1_q;
        engine_0_token_in_2 = entry_token_2_q;
        engine_0_photon_in_0 = entry_photon_0_q;
        engine_0_photon_in_1 = entry_photon_1_q;
        engine_0_photon_in_2 = entry_photon_2_q;
        engine_0_photon_in_3 = entry_photon_3_q;
        engine_0_photon_in_4 = entry_photon_4_q;
        engine_0_photon_in_5 = entry_photon_5_q;
        engine_0_photon_in_6 = entry_photon_6_q;
        engine_0_photon_in_7 = entry_photon_7_q;
        engine_0_photon_in_8 = entry_photon_8_q;
        engine_0_photon_in_9 = entry_photon_9_q;
        engine_0_photon_in_10 = entry_photon_10_q;
        engine_0_photon_in_11 = entry_photon_11_q;
        engine_0_present_in_0 = head_power_present_0;
        engine_0_present_in_1 = head_power_present_1;
        engine_0_present_in_2 = head_power_present_2;
        engine_0_present_in_3 = head_power_present_3;
        engine_0_power_in_0 = head_power_0;
        engine_0_power_in_1 = head_power_1;
        engine_0_power_in_2 = head_power_2;
        engine_0_power_in_3 = head_power_3;
        engine_0_power_in_4 = head_power_4;
        engine_0_power_in_5 = head_power_5;
        engine_0_power_in_6 = head_power_6;
        engine_0_power_in_7 = head_power_7;
        engine_0_power_in_8 = head_power_8;
        engine_0_power_in_9 = head_power_9;
        engine_0_power_in_10 = head_power_10;
        engine_0_power_in_11 = head_power_11;
        engine_1_clock = clock;
        engine_1_reset_in = engine_0_reset_out;
        engine_1_token_valid_in = engine_0_token_valid_out;
        engine_1_swap_in = engine_0_swap_out;
        engine_1_first_in = engine_0_first_out;
        engine_1_last_in = engine_0_last_out;
        engine_0_result_valid_in = engine_1_result_valid_out;
        engine_0_result_count_in = engine_1_result_count_out;
        engine_1_token_in_0 = engine_0_token_out_0;
        engine_1_token_in_1 = engine_0_token_out_1;
        engine_1_token_in_2 = engine_0_token_out_2;
        engine_1_photon_in_0 = engine_0_photon_out_0;
        engine_1_photon_in_1 = engine_0_photon_out_1;
        engine_1_photon_in_2 = engine_0_photon_out_2;
        engine_1_photon_in_3 = engine_0_photon_out_3;
        engine_1_photon_in_4 = engine_0_photon_out_4;
        engine_1_photon_in_5 = engine_0_photon_out_5;
        engine_1_photon_in_6 = engine_0_photon_out_6;
        engine_1_photon_in_7 = engine_0_photon_out_7;
        engine_1_photon_in_8 = engine_0_photon_out_8;
        engine_1_photon_in_9 = engine_0_photon_out_9;
        engine_1_photon_in_10 = engine_0_photon_out_10;
        engine_1_photon_in_11 = engine_0_photon_out_11;
        engine_1_power_in_0 = engine_0_power_out_0;
        engine_1_power_in_1 = engine_0_power_out_1;
        engine_1_power_in_2 = engine_0_power_out_2;
        engine_1_power_in_3 = engine_0_power_out_3;
        engine_1_power_in_4 = engine_0_power_out_4;
        engine_1_power_in_5 = engine_0_power_out_5;
        engine_1_power_in_6 = engine_0_power_out_6;
        engine_1_power_in_7 = engine_0_power_out_7;
        engine_1_power_in_8 = engine_0_power_out_8;
        engine_1_power_in_9 = engine_0_power_out_9;
        engine_1_power_in_10 = engine_0_power_out_10;
        engine_1_power_in_11 = engine_0_power_out_11;
        engine_1_present_in_0 = engine_0_present_out_0;
        engine_1_present_in_1 = engine_0_present_out_1;
        engine_1_present_in_2 = engine_0_present_out_2;
        engine_1_present_in_3 = engine_0_present_out_3;
        engine_0_result_in_0 = engine_1_result_out_0;
        engine_0_result_in_1 = engine_1_result_out_1;
        engine_0_result_in_2 = engine_1_result_out_2;
        engine_1_result_valid_in = 1'b0;
        engine_1_result_count_in = 7'b0;
        engine_1_result_in_0 = 12'h0;
        engine_1_result_in_1 = 12'h0;
        engine_1_result_in_2 = 12'h0;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_player(clock, reset, has_pair, pair, mask, flags, batch_leaves,
    takes_pair, plays, play_bank, play_place, frees, word_valid_out, word_last_out,
    word_blank_out);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire has_pair;
    input wire [1:0] pair;
    input wire [3:0] mask;
    input wire [2:0] flags;
    input wire batch_leaves;
    output reg takes_pair;
    output reg plays;
    output reg play_bank;
    output reg [3:0] play_place;
    output reg frees;
    output reg word_valid_out;
    output reg word_last_out;
    output reg word_blank_out;
    // Constant declarations
    localparam spaced = 2'b1;
    localparam most = 4'h8;
    // Stub signals
    reg entry_valid_d;
    wire entry_valid_q;
    reg entry_valid_clock;
    reg [3:0] entry_mask_d;
    wire [3:0] entry_mask_q;
    reg entry_mask_clock;
    reg entry_last_d;
    wire entry_last_q;
    reg entry_last_clock;
    reg [1:0] entry_pair_d;
    wire [1:0] entry_pair_q;
    reg entry_pair_clock;
    reg entry_bank_d;
    wire entry_bank_q;
    reg entry_bank_clock;
    reg entry_end_d;
    wire entry_end_q;
    reg entry_end_clock;
    reg entry_release_d;
    wire entry_release_q;
    reg entry_release_clock;
    reg [1:0] spacing_d;
    wire [1:0] spacing_q;
    reg spacing_clock;
    reg may_end_d;
    wire may_end_q;
    reg may_end_clock;
    reg [3:0] outstanding_d;
    wire [3:0] outstanding_q;
    reg outstanding_clock;
    reg read_valid_d;
    wire read_valid_q;
    reg read_valid_clock;
    reg read_last_d;
    wire read_last_q;
    reg read_last_clock;
    reg read_blank_d;
    wire read_blank_q;
    reg read_blank_clock;
    reg word_valid_d;
    wire word_valid_q;
    reg word_valid_clock;
    reg word_last_d;
    wire word_last_q;
    reg word_last_clock;
    reg word_blank_d;
    wire word_blank_q;
    reg word_blank_clock;
    // Local signals
    reg [3:0] less;
    reg [3:0] rest;
    reg [3:0] rest_less;
    reg [3:0] rest_but_one;
    reg [3:0] mask_less;
    reg [3:0] mask_but_one;
    reg is_end;
    reg is_spaced;
    reg has_room;
    reg is_played;
    reg ends;
    reg takes;
    reg [1:0] group;
    reg [3:0] high;
    reg [3:0] low;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_valid(
        .d(entry_valid_d),
        .q(entry_valid_q),
        .clock(entry_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_4 entry_mask(
        .d(entry_mask_d),
        .q(entry_mask_q),
        .clock(entry_mask_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_last(
        .d(entry_last_d),
        .q(entry_last_q),
        .clock(entry_last_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 entry_pair(
        .d(entry_pair_d),
        .q(entry_pair_q),
        .clock(entry_pair_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_bank(
        .d(entry_bank_d),
        .q(entry_bank_q),
        .clock(entry_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_end(
        .d(entry_end_d),
        .q(entry_end_q),
        .clock(entry_end_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 entry_release(
        .d(entry_release_d),
        .q(entry_release_q),
        .clock(entry_release_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 spacing(
        .d(spacing_d),
        .q(spacing_q),
        .clock(spacing_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 may_end(
        .d(may_end_d),
        .q(may_end_q),
        .clock(may_end_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_4 outstanding(
        .d(outstanding_d),
        .q(outstanding_q),
        .clock(outstanding_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 read_valid(
        .d(read_valid_d),
        .q(read_valid_q),
        .clock(read_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 read_last(
        .d(read_last_d),
        .q(read_last_q),
        .clock(read_last_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 read_blank(
        .d(read_blank_d),
        .q(read_blank_q),
        .clock(read_blank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 word_valid(
        .d(word_valid_d),
        .q(word_valid_q),
        .clock(word_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 word_last(
        .d(word_last_d),
        .q(word_last_q),
        .clock(word_last_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 word_blank(
        .d(word_blank_d),
        .q(word_blank_q),
        .clock(word_blank_clock)
    );
    // Update code
    always @(*) begin
        entry_valid_clock = clock;
        entry_mask_clock = clock;
        entry_last_clock = clock;
        entry_pair_clock = clock;
        entry_bank_clock = clock;
        entry_end_clock = clock;
        entry_release_clock = clock;
        spacing_clock = clock;
        may_end_clock = clock;
        outstanding_clock = clock;
        read_valid_clock = clock;
        read_last_clock = clock;
        read_blank_clock = clock;
        word_valid_clock = clock;
        word_last_clock = clock;
        word_blank_clock = clock;
        entry_valid_d = entry_valid_q;
        entry_mask_d = entry_mask_q;
        entry_last_d = entry_last_q;
        entry_pair_d = entry_pair_q;
        entry_bank_d = entry_bank_q;
        entry_end_d = entry_end_q;
        entry_release_d = entry_release_q;
        spacing_d = spacing_q;
        may_end_d = may_end_q;
        outstanding_d = outstanding_q;
        read_valid_d = read_valid_q;
        read_last_d = read_last_q;
        read_blank_d = read_blank_q;
        word_valid_d = word_valid_q;
        word_last_d = word_last_q;
        word_blank_d = word_blank_q;
        less = entry_mask_q - 32'h1;
        rest = entry_mask_q & less;
        rest_less = rest - 32'h1;
        rest_but_one = rest & rest_less;
        mask_less = mask - 32'h1;
        mask_but_one = mask & mask_less;
        is_end = entry_end_q & entry_last_q;
        is_spaced = ~|spacing_q;
        has_room = outstanding_q != most;
        is_played = entry_valid_q & (may_end_q | ~is_end);
        ends = is_played & is_end;
        may_end_d = is_spaced & has_room & ~ends;
        takes = has_pair & (~entry_valid_q | (is_played & entry_last_q));
        if (is_played) begin
            entry_mask_d = rest;
            entry_last_d = ~|rest_but_one;
            entry_valid_d = ~entry_last_q;
        end
        if (takes) begin
            entry_valid_d = 1'b1;
            entry_mask_d = mask;
            entry_last_d = ~|mask_but_one;
            entry_pair_d = pair;
            entry_bank_d = flags[32'h0];
            entry_end_d = flags[32'h1];
            entry_release_d = flags[32'h2];
        end
        if (~is_spaced) begin
            spacing_d = spacing_q - 32'h1;
        end
        if (ends) begin
            spacing_d = spaced;
        end
        if (ends & ~batch_leaves) begin
            outstanding_d = outstanding_q + 32'h1;
        end
        if (batch_leaves & ~ends) begin
            outstanding_d = outstanding_q - 32'h1;
        end
        group = 32'h3;
        if (entry_mask_q[32'h2]) begin
            group = 32'h2;
        end
        if (entry_mask_q[32'h1]) begin
            group = 32'h1;
        end
        if (entry_mask_q[32'h0] | ~|entry_mask_q) begin
            group = 32'h0;
        end
        high = ((entry_pair_q) & 4'hf) << 32'h2;
        low = ((group) & 4'hf);
        play_place = high | low;
        play_bank = entry_bank_q;
        plays = is_played;
        takes_pair = takes;
        frees = ends & entry_release_q;
        read_valid_d = is_played;
        read_last_d = ends;
        read_blank_d = ~|entry_mask_q;
        word_valid_d = read_valid_q;
        word_last_d = read_last_q;
        word_blank_d = read_blank_q;
        if (reset) begin
            entry_valid_d = 1'b0;
            spacing_d = 32'h0;
            may_end_d = 1'b0;
            outstanding_d = 32'h0;
            read_valid_d = 1'b0;
            word_valid_d = 1'b0;
        end
        word_valid_out = word_valid_q;
        word_last_out = word_last_q;
        word_blank_out = word_blank_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_former(clock, reset, query_valid, query_last, query_release,
    query_facings, chain_ready, starts, query_ready, token_valid, takes_token, takes_query,
    first, offers_query, fills, complete, release_out, facings_out);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    input wire query_last;
    input wire query_release;
    input wire [31:0] query_facings;
    input wire chain_ready;
    input wire starts;
    output reg query_ready;
    output reg token_valid;
    output reg takes_token;
    output reg takes_query;
    output reg first;
    output reg offers_query;
    output reg fills;
    output reg complete;
    output reg release_out;
    output reg [31:0] facings_out;
    // Constant declarations
    localparam engines = 2'b10;
    localparam one_less = 2'b1;
    // Stub signals
    reg [1:0] loaded_d;
    wire [1:0] loaded_q;
    reg loaded_clock;
    reg closed_d;
    wire closed_q;
    reg closed_clock;
    reg releases_d;
    wire releases_q;
    reg releases_clock;
    reg [31:0] facings_d;
    wire [31:0] facings_q;
    reg facings_clock;
    // Local signals
    reg is_full;
    reg is_first;
    reg is_last_place;
    reg valid;
    reg takes;
    reg is_query;
    reg is_offered;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_2 loaded(
        .d(loaded_d),
        .q(loaded_q),
        .clock(loaded_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 closed(
        .d(closed_d),
        .q(closed_q),
        .clock(closed_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 releases(
        .d(releases_d),
        .q(releases_q),
        .clock(releases_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_32 facings(
        .d(facings_d),
        .q(facings_q),
        .clock(facings_clock)
    );
    // Update code
    always @(*) begin
        loaded_clock = clock;
        closed_clock = clock;
        releases_clock = clock;
        facings_clock = clock;
        loaded_d = loaded_q;
        closed_d = closed_q;
        releases_d = releases_q;
        facings_d = facings_q;
        is_full = loaded_q == engines;
        is_last_place = loaded_q == one_less;
        is_first = ~|loaded_q;
        valid = query_valid;
        if (closed_q) begin
            valid = ~is_full;
        end
        takes = valid & chain_ready;
        is_query = takes & ~closed_q;
        if (takes) begin
            loaded_d = loaded_q + 32'h1;
        end
        if (is_query) begin
            closed_d = query_last | is_last_place;
            releases_d = query_release | (releases_q & ~is_first);
        end
        is_offered = query_valid & ~closed_q;
        if (is_offered & is_first) begin
            facings_d = query_facings;
        end
        if (starts) begin
            loaded_d = 32'h0;
            closed_d = 1'b0;
        end
        if (reset) begin
            loaded_d = 32'h0;
            closed_d = 1'b0;
        end
        query_ready = chain_ready & ~closed_q;
        token_valid = valid;
        takes_token = takes;
        takes_query = is_query;
        first = is_first;
        offers_query = is_offered;
        fills = closed_q;
        complete = closed_q & is_full;
        release_out = releases_q;
        facings_out = facings_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_culler(clock, query_low_0, query_low_1, query_low_2, query_high_0,
    query_high_1, query_high_2, group_low_0, group_low_1, group_low_2, group_low_3, group_low_4,
    group_low_5, group_low_6, group_low_7, group_low_8, group_low_9, group_low_10, group_low_11,
    group_high_0, group_high_1, group_high_2, group_high_3, group_high_4, group_high_5,
    group_high_6, group_high_7, group_high_8, group_high_9, group_high_10, group_high_11,
    in_range_0, in_range_1, in_range_2, in_range_3);
    // Module arguments
    input wire clock;
    input wire [8:0] query_low_0;
    input wire [8:0] query_low_1;
    input wire [8:0] query_low_2;
    input wire [8:0] query_high_0;
    input wire [8:0] query_high_1;
    input wire [8:0] query_high_2;
    input wire [8:0] group_low_0;
    input wire [8:0] group_low_1;
    input wire [8:0] group_low_2;
    input wire [8:0] group_low_3;
    input wire [8:0] group_low_4;
    input wire [8:0] group_low_5;
    input wire [8:0] group_low_6;
    input wire [8:0] group_low_7;
    input wire [8:0] group_low_8;
    input wire [8:0] group_low_9;
    input wire [8:0] group_low_10;
    input wire [8:0] group_low_11;
    input wire [8:0] group_high_0;
    input wire [8:0] group_high_1;
    input wire [8:0] group_high_2;
    input wire [8:0] group_high_3;
    input wire [8:0] group_high_4;
    input wire [8:0] group_high_5;
    input wire [8:0] group_high_6;
    input wire [8:0] group_high_7;
    input wire [8:0] group_high_8;
    input wire [8:0] group_high_9;
    input wire [8:0] group_high_10;
    input wire [8:0] group_high_11;
    output reg in_range_0;
    output reg in_range_1;
    output reg in_range_2;
    output reg in_range_3;
    // Stub signals
    reg [8:0] gap_0_query_low;
    reg [8:0] gap_0_query_high;
    reg [8:0] gap_0_group_low;
    reg [8:0] gap_0_group_high;
    wire [9:0] gap_0_difference;
    reg [8:0] gap_1_query_low;
    reg [8:0] gap_1_query_high;
    reg [8:0] gap_1_group_low;
    reg [8:0] gap_1_group_high;
    wire [9:0] gap_1_difference;
    reg [8:0] gap_2_query_low;
    reg [8:0] gap_2_query_high;
    reg [8:0] gap_2_group_low;
    reg [8:0] gap_2_group_high;
    wire [9:0] gap_2_difference;
    reg [8:0] gap_3_query_low;
    reg [8:0] gap_3_query_high;
    reg [8:0] gap_3_group_low;
    reg [8:0] gap_3_group_high;
    wire [9:0] gap_3_difference;
    reg [8:0] gap_4_query_low;
    reg [8:0] gap_4_query_high;
    reg [8:0] gap_4_group_low;
    reg [8:0] gap_4_group_high;
    wire [9:0] gap_4_difference;
    reg [8:0] gap_5_query_low;
    reg [8:0] gap_5_query_high;
    reg [8:0] gap_5_group_low;
    reg [8:0] gap_5_group_high;
    wire [9:0] gap_5_difference;
    reg [8:0] gap_6_query_low;
    reg [8:0] gap_6_query_high;
    reg [8:0] gap_6_group_low;
    reg [8:0] gap_6_group_high;
    wire [9:0] gap_6_difference;
    reg [8:0] gap_7_query_low;
    reg [8:0] gap_7_query_high;
    reg [8:0] gap_7_group_low;
    reg [8:0] gap_7_group_high;
    wire [9:0] gap_7_difference;
    reg [8:0] gap_8_query_low;
    reg [8:0] gap_8_query_high;
    reg [8:0] gap_8_group_low;
    reg [8:0] gap_8_group_high;
    wire [9:0] gap_8_difference;
    reg [8:0] gap_9_query_low;
    reg [8:0] gap_9_query_high;
    reg [8:0] gap_9_group_low;
    reg [8:0] gap_9_group_high;
    wire [9:0] gap_9_difference;
    reg [8:0] gap_10_query_low;
    reg [8:0] gap_10_query_high;
    reg [8:0] gap_10_group_low;
    reg [8:0] gap_10_group_high;
    wire [9:0] gap_10_difference;
    reg [8:0] gap_11_query_low;
    reg [8:0] gap_11_query_high;
    reg [8:0] gap_11_group_low;
    reg [8:0] gap_11_group_high;
    wire [9:0] gap_11_difference;
    reg [9:0] difference_0_d;
    wire [9:0] difference_0_q;
    reg difference_0_clock;
    reg [9:0] difference_1_d;
    wire [9:0] difference_1_q;
    reg difference_1_clock;
    reg [9:0] difference_2_d;
    wire [9:0] difference_2_q;
    reg difference_2_clock;
    reg [9:0] difference_3_d;
    wire [9:0] difference_3_q;
    reg difference_3_clock;
    reg [9:0] difference_4_d;
    wire [9:0] difference_4_q;
    reg difference_4_clock;
    reg [9:0] difference_5_d;
    wire [9:0] difference_5_q;
    reg difference_5_clock;
    reg [9:0] difference_6_d;
    wire [9:0] difference_6_q;
    reg difference_6_clock;
    reg [9:0] difference_7_d;
    wire [9:0] difference_7_q;
    reg difference_7_clock;
    reg [9:0] difference_8_d;
    wire [9:0] difference_8_q;
    reg difference_8_clock;
    reg [9:0] difference_9_d;
    wire [9:0] difference_9_q;
    reg difference_9_clock;
    reg [9:0] difference_10_d;
    wire [9:0] difference_10_q;
    reg difference_10_clock;
    reg [9:0] difference_11_d;
    wire [9:0] difference_11_q;
    reg difference_11_clock;
    reg product_0_clock;
    reg [9:0] product_0_difference;
    wire [13:0] product_0_square;
    wire product_0_far;
    reg product_1_clock;
    reg [9:0] product_1_difference;
    wire [13:0] product_1_square;
    wire product_1_far;
    reg product_2_clock;
    reg [9:0] product_2_difference;
    wire [13:0] product_2_square;
    wire product_2_far;
    reg product_3_clock;
    reg [9:0] product_3_difference;
    wire [13:0] product_3_square;
    wire product_3_far;
    reg product_4_clock;
    reg [9:0] product_4_difference;
    wire [13:0] product_4_square;
    wire product_4_far;
    reg product_5_clock;
    reg [9:0] product_5_difference;
    wire [13:0] product_5_square;
    wire product_5_far;
    reg product_6_clock;
    reg [9:0] product_6_difference;
    wire [13:0] product_6_square;
    wire product_6_far;
    reg product_7_clock;
    reg [9:0] product_7_difference;
    wire [13:0] product_7_square;
    wire product_7_far;
    reg product_8_clock;
    reg [9:0] product_8_difference;
    wire [13:0] product_8_square;
    wire product_8_far;
    reg product_9_clock;
    reg [9:0] product_9_difference;
    wire [13:0] product_9_square;
    wire product_9_far;
    reg product_10_clock;
    reg [9:0] product_10_difference;
    wire [13:0] product_10_square;
    wire product_10_far;
    reg product_11_clock;
    reg [9:0] product_11_difference;
    wire [13:0] product_11_square;
    wire product_11_far;
    reg [13:0] square_stage_0_d;
    wire [13:0] square_stage_0_q;
    reg square_stage_0_clock;
    reg [13:0] square_stage_1_d;
    wire [13:0] square_stage_1_q;
    reg square_stage_1_clock;
    reg [13:0] square_stage_2_d;
    wire [13:0] square_stage_2_q;
    reg square_stage_2_clock;
    reg [13:0] square_stage_3_d;
    wire [13:0] square_stage_3_q;
    reg square_stage_3_clock;
    reg [13:0] square_stage_4_d;
    wire [13:0] square_stage_4_q;
    reg square_stage_4_clock;
    reg [13:0] square_stage_5_d;
    wire [13:0] square_stage_5_q;
    reg square_stage_5_clock;
    reg [13:0] square_stage_6_d;
    wire [13:0] square_stage_6_q;
    reg square_stage_6_clock;
    reg [13:0] square_stage_7_d;
    wire [13:0] square_stage_7_q;
    reg square_stage_7_clock;
    reg [13:0] square_stage_8_d;
    wire [13:0] square_stage_8_q;
    reg square_stage_8_clock;
    reg [13:0] square_stage_9_d;
    wire [13:0] square_stage_9_q;
    reg square_stage_9_clock;
    reg [13:0] square_stage_10_d;
    wire [13:0] square_stage_10_q;
    reg square_stage_10_clock;
    reg [13:0] square_stage_11_d;
    wire [13:0] square_stage_11_q;
    reg square_stage_11_clock;
    reg far_stage_0_d;
    wire far_stage_0_q;
    reg far_stage_0_clock;
    reg far_stage_1_d;
    wire far_stage_1_q;
    reg far_stage_1_clock;
    reg far_stage_2_d;
    wire far_stage_2_q;
    reg far_stage_2_clock;
    reg far_stage_3_d;
    wire far_stage_3_q;
    reg far_stage_3_clock;
    reg far_stage_4_d;
    wire far_stage_4_q;
    reg far_stage_4_clock;
    reg far_stage_5_d;
    wire far_stage_5_q;
    reg far_stage_5_clock;
    reg far_stage_6_d;
    wire far_stage_6_q;
    reg far_stage_6_clock;
    reg far_stage_7_d;
    wire far_stage_7_q;
    reg far_stage_7_clock;
    reg far_stage_8_d;
    wire far_stage_8_q;
    reg far_stage_8_clock;
    reg far_stage_9_d;
    wire far_stage_9_q;
    reg far_stage_9_clock;
    reg far_stage_10_d;
    wire far_stage_10_q;
    reg far_stage_10_clock;
    reg far_stage_11_d;
    wire far_stage_11_q;
    reg far_stage_11_clock;
    reg lane_0_clock;
    reg [13:0] lane_0_axis_square_0;
    reg [13:0] lane_0_axis_square_1;
    reg [13:0] lane_0_axis_square_2;
    reg lane_0_axis_far_0;
    reg lane_0_axis_far_1;
    reg lane_0_axis_far_2;
    wire lane_0_photon_in_range;
    reg lane_1_clock;
    reg [13:0] lane_1_axis_square_0;
    reg [13:0] lane_1_axis_square_1;
    reg [13:0] lane_1_axis_square_2;
    reg lane_1_axis_far_0;
    reg lane_1_axis_far_1;
    reg lane_1_axis_far_2;
    wire lane_1_photon_in_range;
    reg lane_2_clock;
    reg [13:0] lane_2_axis_square_0;
    reg [13:0] lane_2_axis_square_1;
    reg [13:0] lane_2_axis_square_2;
    reg lane_2_axis_far_0;
    reg lane_2_axis_far_1;
    reg lane_2_axis_far_2;
    wire lane_2_photon_in_range;
    reg lane_3_clock;
    reg [13:0] lane_3_axis_square_0;
    reg [13:0] lane_3_axis_square_1;
    reg [13:0] lane_3_axis_square_2;
    reg lane_3_axis_far_0;
    reg lane_3_axis_far_1;
    reg lane_3_axis_far_2;
    wire lane_3_photon_in_range;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_0(
        .query_low(gap_0_query_low),
        .query_high(gap_0_query_high),
        .group_low(gap_0_group_low),
        .group_high(gap_0_group_high),
        .difference(gap_0_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_1(
        .query_low(gap_1_query_low),
        .query_high(gap_1_query_high),
        .group_low(gap_1_group_low),
        .group_high(gap_1_group_high),
        .difference(gap_1_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_2(
        .query_low(gap_2_query_low),
        .query_high(gap_2_query_high),
        .group_low(gap_2_group_low),
        .group_high(gap_2_group_high),
        .difference(gap_2_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_3(
        .query_low(gap_3_query_low),
        .query_high(gap_3_query_high),
        .group_low(gap_3_group_low),
        .group_high(gap_3_group_high),
        .difference(gap_3_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_4(
        .query_low(gap_4_query_low),
        .query_high(gap_4_query_high),
        .group_low(gap_4_group_low),
        .group_high(gap_4_group_high),
        .difference(gap_4_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_5(
        .query_low(gap_5_query_low),
        .query_high(gap_5_query_high),
        .group_low(gap_5_group_low),
        .group_high(gap_5_group_high),
        .difference(gap_5_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_6(
        .query_low(gap_6_query_low),
        .query_high(gap_6_query_high),
        .group_low(gap_6_group_low),
        .group_high(gap_6_group_high),
        .difference(gap_6_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_7(
        .query_low(gap_7_query_low),
        .query_high(gap_7_query_high),
        .group_low(gap_7_group_low),
        .group_high(gap_7_group_high),
        .difference(gap_7_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_8(
        .query_low(gap_8_query_low),
        .query_high(gap_8_query_high),
        .group_low(gap_8_group_low),
        .group_high(gap_8_group_high),
        .difference(gap_8_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_9(
        .query_low(gap_9_query_low),
        .query_high(gap_9_query_high),
        .group_low(gap_9_group_low),
        .group_high(gap_9_group_high),
        .difference(gap_9_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_10(
        .query_low(gap_10_query_low),
        .query_high(gap_10_query_high),
        .group_low(gap_10_group_low),
        .group_high(gap_10_group_high),
        .difference(gap_10_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gap gap_11(
        .query_low(gap_11_query_low),
        .query_high(gap_11_query_high),
        .group_low(gap_11_group_low),
        .group_high(gap_11_group_high),
        .difference(gap_11_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_0(
        .d(difference_0_d),
        .q(difference_0_q),
        .clock(difference_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_1(
        .d(difference_1_d),
        .q(difference_1_q),
        .clock(difference_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_2(
        .d(difference_2_d),
        .q(difference_2_q),
        .clock(difference_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_3(
        .d(difference_3_d),
        .q(difference_3_q),
        .clock(difference_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_4(
        .d(difference_4_d),
        .q(difference_4_q),
        .clock(difference_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_5(
        .d(difference_5_d),
        .q(difference_5_q),
        .clock(difference_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_6(
        .d(difference_6_d),
        .q(difference_6_q),
        .clock(difference_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_7(
        .d(difference_7_d),
        .q(difference_7_q),
        .clock(difference_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_8(
        .d(difference_8_d),
        .q(difference_8_q),
        .clock(difference_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_9(
        .d(difference_9_d),
        .q(difference_9_q),
        .clock(difference_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_10(
        .d(difference_10_d),
        .q(difference_10_q),
        .clock(difference_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_11(
        .d(difference_11_d),
        .q(difference_11_q),
        .clock(difference_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_0(
        .clock(product_0_clock),
        .difference(product_0_difference),
        .square(product_0_square),
        .far(product_0_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_1(
        .clock(product_1_clock),
        .difference(product_1_difference),
        .square(product_1_square),
        .far(product_1_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_2(
        .clock(product_2_clock),
        .difference(product_2_difference),
        .square(product_2_square),
        .far(product_2_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_3(
        .clock(product_3_clock),
        .difference(product_3_difference),
        .square(product_3_square),
        .far(product_3_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_4(
        .clock(product_4_clock),
        .difference(product_4_difference),
        .square(product_4_square),
        .far(product_4_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_5(
        .clock(product_5_clock),
        .difference(product_5_difference),
        .square(product_5_square),
        .far(product_5_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_6(
        .clock(product_6_clock),
        .difference(product_6_difference),
        .square(product_6_square),
        .far(product_6_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_7(
        .clock(product_7_clock),
        .difference(product_7_difference),
        .square(product_7_square),
        .far(product_7_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_8(
        .clock(product_8_clock),
        .difference(product_8_difference),
        .square(product_8_square),
        .far(product_8_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_9(
        .clock(product_9_clock),
        .difference(product_9_difference),
        .square(product_9_square),
        .far(product_9_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_10(
        .clock(product_10_clock),
        .difference(product_10_difference),
        .square(product_10_square),
        .far(product_10_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_11(
        .clock(product_11_clock),
        .difference(product_11_difference),
        .square(product_11_square),
        .far(product_11_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_0(
        .d(square_stage_0_d),
        .q(square_stage_0_q),
        .clock(square_stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_1(
        .d(square_stage_1_d),
        .q(square_stage_1_q),
        .clock(square_stage_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_2(
        .d(square_stage_2_d),
        .q(square_stage_2_q),
        .clock(square_stage_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_3(
        .d(square_stage_3_d),
        .q(square_stage_3_q),
        .clock(square_stage_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_4(
        .d(square_stage_4_d),
        .q(square_stage_4_q),
        .clock(square_stage_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_5(
        .d(square_stage_5_d),
        .q(square_stage_5_q),
        .clock(square_stage_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_6(
        .d(square_stage_6_d),
        .q(square_stage_6_q),
        .clock(square_stage_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_7(
        .d(square_stage_7_d),
        .q(square_stage_7_q),
        .clock(square_stage_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_8(
        .d(square_stage_8_d),
        .q(square_stage_8_q),
        .clock(square_stage_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_9(
        .d(square_stage_9_d),
        .q(square_stage_9_q),
        .clock(square_stage_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_10(
        .d(square_stage_10_d),
        .q(square_stage_10_q),
        .clock(square_stage_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_11(
        .d(square_stage_11_d),
        .q(square_stage_11_q),
        .clock(square_stage_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_0(
        .d(far_stage_0_d),
        .q(far_stage_0_q),
        .clock(far_stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_1(
        .d(far_stage_1_d),
        .q(far_stage_1_q),
        .clock(far_stage_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_2(
        .d(far_stage_2_d),
        .q(far_stage_2_q),
        .clock(far_stage_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_3(
        .d(far_stage_3_d),
        .q(far_stage_3_q),
        .clock(far_stage_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_4(
        .d(far_stage_4_d),
        .q(far_stage_4_q),
        .clock(far_stage_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_5(
        .d(far_stage_5_d),
        .q(far_stage_5_q),
        .clock(far_stage_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_6(
        .d(far_stage_6_d),
        .q(far_stage_6_q),
        .clock(far_stage_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_7(
        .d(far_stage_7_d),
        .q(far_stage_7_q),
        .clock(far_stage_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_8(
        .d(far_stage_8_d),
        .q(far_stage_8_q),
        .clock(far_stage_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_9(
        .d(far_stage_9_d),
        .q(far_stage_9_q),
        .clock(far_stage_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_10(
        .d(far_stage_10_d),
        .q(far_stage_10_q),
        .clock(far_stage_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_11(
        .d(far_stage_11_d),
        .q(far_stage_11_q),
        .clock(far_stage_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_0(
        .clock(lane_0_clock),
        .axis_square_0(lane_0_axis_square_0),
        .axis_square_1(lane_0_axis_square_1),
        .axis_square_2(lane_0_axis_square_2),
        .axis_far_0(lane_0_axis_far_0),
        .axis_far_1(lane_0_axis_far_1),
        .axis_far_2(lane_0_axis_far_2),
        .photon_in_range(lane_0_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_1(
        .clock(lane_1_clock),
        .axis_square_0(lane_1_axis_square_0),
        .axis_square_1(lane_1_axis_square_1),
        .axis_square_2(lane_1_axis_square_2),
        .axis_far_0(lane_1_axis_far_0),
        .axis_far_1(lane_1_axis_far_1),
        .axis_far_2(lane_1_axis_far_2),
        .photon_in_range(lane_1_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_2(
        .clock(lane_2_clock),
        .axis_square_0(lane_2_axis_square_0),
        .axis_square_1(lane_2_axis_square_1),
        .axis_square_2(lane_2_axis_square_2),
        .axis_far_0(lane_2_axis_far_0),
        .axis_far_1(lane_2_axis_far_1),
        .axis_far_2(lane_2_axis_far_2),
        .photon_in_range(lane_2_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_3(
        .clock(lane_3_clock),
        .axis_square_0(lane_3_axis_square_0),
        .axis_square_1(lane_3_axis_square_1),
        .axis_square_2(lane_3_axis_square_2),
        .axis_far_0(lane_3_axis_far_0),
        .axis_far_1(lane_3_axis_far_1),
        .axis_far_2(lane_3_axis_far_2),
        .photon_in_range(lane_3_photon_in_range)
    );
    // Update code
    always @(*) begin
        gap_0_query_low = query_low_0;
        gap_0_query_high = query_high_0;
        gap_0_group_low = group_low_0;
        gap_0_group_high = group_high_0;
        difference_0_clock = clock;
        difference_0_d = gap_0_difference;
        square_stage_0_clock = clock;
        far_stage_0_clock = clock;
        lane_0_axis_square_0 = square_stage_0_q;
        lane_0_axis_far_0 = far_stage_0_q;
        gap_1_query_low = query_low_1;
        gap_1_query_high = query_high_1;
        gap_1_group_low = group_low_1;
        gap_1_group_high = group_high_1;
        difference_1_clock = clock;
        difference_1_d = gap_1_difference;
        square_stage_1_clock = clock;
        far_stage_1_clock = clock;
        lane_0_axis_square_1 = square_stage_1_q;
        lane_0_axis_far_1 = far_stage_1_q;
        gap_2_query_low = query_low_2;
        gap_2_query_high = query_high_2;
        gap_2_group_low = group_low_2;
        gap_2_group_high = group_high_2;
        difference_2_clock = clock;
        difference_2_d = gap_2_difference;
        square_stage_2_clock = clock;
        far_stage_2_clock = clock;
        lane_0_axis_square_2 = square_stage_2_q;
        lane_0_axis_far_2 = far_stage_2_q;
        gap_3_query_low = query_low_0;
        gap_3_query_high = query_high_0;
        gap_3_group_low = group_low_3;
        gap_3_group_high = group_high_3;
        difference_3_clock = clock;
        difference_3_d = gap_3_difference;
        square_stage_3_clock = clock;
        far_stage_3_clock = clock;
        lane_1_axis_square_0 = square_stage_3_q;
        lane_1_axis_far_0 = far_stage_3_q;
        gap_4_query_low = query_low_1;
        gap_4_query_high = query_high_1;
        gap_4_group_low = group_low_4;
        gap_4_group_high = group_high_4;
        difference_4_clock = clock;
        difference_4_d = gap_4_difference;
        square_stage_4_clock = clock;
        far_stage_4_clock = clock;
        lane_1_axis_square_1 = square_stage_4_q;
        lane_1_axis_far_1 = far_stage_4_q;
        gap_5_query_low = query_low_2;
        gap_5_query_high = query_high_2;
        gap_5_group_low = group_low_5;
        gap_5_group_high = group_high_5;
        difference_5_clock = clock;
        difference_5_d = gap_5_difference;
        square_stage_5_clock = clock;
        far_stage_5_clock = clock;
        lane_1_axis_square_2 = square_stage_5_q;
        lane_1_axis_far_2 = far_stage_5_q;
        gap_6_query_low = query_low_0;
        gap_6_query_high = query_high_0;
        gap_6_group_low = group_low_6;
        gap_6_group_high = group_high_6;
        difference_6_clock = clock;
        difference_6_d = gap_6_difference;
        square_stage_6_clock = clock;
        far_stage_6_clock = clock;
        lane_2_axis_square_0 = square_stage_6_q;
        lane_2_axis_far_0 = far_stage_6_q;
        gap_7_query_low = query_low_1;
        gap_7_query_high = query_high_1;
        gap_7_group_low = group_low_7;
        gap_7_group_high = group_high_7;
        difference_7_clock = clock;
        difference_7_d = gap_7_difference;
        square_stage_7_clock = clock;
        far_stage_7_clock = clock;
        lane_2_axis_square_1 = square_stage_7_q;
        lane_2_axis_far_1 = far_stage_7_q;
        gap_8_query_low = query_low_2;
        gap_8_query_high = query_high_2;
        gap_8_group_low = group_low_8;
        gap_8_group_high = group_high_8;
        difference_8_clock = clock;
        difference_8_d = gap_8_difference;
        square_stage_8_clock = clock;
        far_stage_8_clock = clock;
        lane_2_axis_square_2 = square_stage_8_q;
        lane_2_axis_far_2 = far_stage_8_q;
        gap_9_query_low = query_low_0;
        gap_9_query_high = query_high_0;
        gap_9_group_low = group_low_9;
        gap_9_group_high = group_high_9;
        difference_9_clock = clock;
        difference_9_d = gap_9_difference;
        square_stage_9_clock = clock;
        far_stage_9_clock = clock;
        lane_3_axis_square_0 = square_stage_9_q;
        lane_3_axis_far_0 = far_stage_9_q;
        gap_10_query_low = query_low_1;
        gap_10_query_high = query_high_1;
        gap_10_group_low = group_low_10;
        gap_10_group_high = group_high_10;
        difference_10_clock = clock;
        difference_10_d = gap_10_difference;
        square_stage_10_clock = clock;
        far_stage_10_clock = clock;
        lane_3_axis_square_1 = square_stage_10_q;
        lane_3_axis_far_1 = far_stage_10_q;
        gap_11_query_low = query_low_2;
        gap_11_query_high = query_high_2;
        gap_11_group_low = group_low_11;
        gap_11_group_high = group_high_11;
        difference_11_clock = clock;
        difference_11_d = gap_11_difference;
        square_stage_11_clock = clock;
        far_stage_11_clock = clock;
        lane_3_axis_square_2 = square_stage_11_q;
        lane_3_axis_far_2 = far_stage_11_q;
        product_0_clock = clock;
        product_0_difference = difference_0_q;
        square_stage_0_d = product_0_square;
        far_stage_0_d = product_0_far;
        product_1_clock = clock;
        product_1_difference = difference_1_q;
        square_stage_1_d = product_1_square;
        far_stage_1_d = product_1_far;
        product_2_clock = clock;
        product_2_difference = difference_2_q;
        square_stage_2_d = product_2_square;
        far_stage_2_d = product_2_far;
        product_3_clock = clock;
        product_3_difference = difference_3_q;
        square_stage_3_d = product_3_square;
        far_stage_3_d = product_3_far;
        product_4_clock = clock;
        product_4_difference = difference_4_q;
        square_stage_4_d = product_4_square;
        far_stage_4_d = product_4_far;
        product_5_clock = clock;
        product_5_difference = difference_5_q;
        square_stage_5_d = product_5_square;
        far_stage_5_d = product_5_far;
        product_6_clock = clock;
        product_6_difference = difference_6_q;
        square_stage_6_d = product_6_square;
        far_stage_6_d = product_6_far;
        product_7_clock = clock;
        product_7_difference = difference_7_q;
        square_stage_7_d = product_7_square;
        far_stage_7_d = product_7_far;
        product_8_clock = clock;
        product_8_difference = difference_8_q;
        square_stage_8_d = product_8_square;
        far_stage_8_d = product_8_far;
        product_9_clock = clock;
        product_9_difference = difference_9_q;
        square_stage_9_d = product_9_square;
        far_stage_9_d = product_9_far;
        product_10_clock = clock;
        product_10_difference = difference_10_q;
        square_stage_10_d = product_10_square;
        far_stage_10_d = product_10_far;
        product_11_clock = clock;
        product_11_difference = difference_11_q;
        square_stage_11_d = product_11_square;
        far_stage_11_d = product_11_far;
        lane_0_clock = clock;
        in_range_0 = lane_0_photon_in_range;
        lane_1_clock = clock;
        in_range_1 = lane_1_photon_in_range;
        lane_2_clock = clock;
        in_range_2 = lane_2_photon_in_range;
        lane_3_clock = clock;
        in_range_3 = lane_3_photon_in_range;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_cull(clock, reset, valid_in, pair_in, bank_in, end_in,
    release_in, short_in_0, short_in_1, valid_out, pair_out, bank_out, end_out, release_out,
    short_out_0, short_out_1);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire valid_in;
    input wire [1:0] pair_in;
    input wire bank_in;
    input wire end_in;
    input wire release_in;
    input wire short_in_0;
    input wire short_in_1;
    output reg valid_out;
    output reg [1:0] pair_out;
    output reg bank_out;
    output reg end_out;
    output reg release_out;
    output reg short_out_0;
    output reg short_out_1;
    // Stub signals
    reg valid_d;
    wire valid_q;
    reg valid_clock;
    reg [1:0] pair_d;
    wire [1:0] pair_q;
    reg pair_clock;
    reg bank_d;
    wire bank_q;
    reg bank_clock;
    reg end_of_set_d;
    wire end_of_set_q;
    reg end_of_set_clock;
    reg releases_d;
    wire releases_q;
    reg releases_clock;
    reg short_0_d;
    wire short_0_q;
    reg short_0_clock;
    reg short_1_d;
    wire short_1_q;
    reg short_1_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 valid(
        .d(valid_d),
        .q(valid_q),
        .clock(valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 pair(
        .d(pair_d),
        .q(pair_q),
        .clock(pair_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 bank(
        .d(bank_d),
        .q(bank_q),
        .clock(bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 end_of_set(
        .d(end_of_set_d),
        .q(end_of_set_q),
        .clock(end_of_set_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 releases(
        .d(releases_d),
        .q(releases_q),
        .clock(releases_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 short_0(
        .d(short_0_d),
        .q(short_0_q),
        .clock(short_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 short_1(
        .d(short_1_d),
        .q(short_1_q),
        .clock(short_1_clock)
    );
    // Update code
    always @(*) begin
        valid_clock = clock;
        pair_clock = clock;
        bank_clock = clock;
        end_of_set_clock = clock;
        releases_clock = clock;
        valid_d = valid_q;
        pair_d = pair_q;
        bank_d = bank_q;
        end_of_set_d = end_of_set_q;
        releases_d = releases_q;
        valid_d = valid_in & ~reset;
        pair_d = pair_in;
        bank_d = bank_in;
        end_of_set_d = end_in;
        releases_d = release_in;
        valid_out = valid_q;
        pair_out = pair_q;
        bank_out = bank_q;
        end_out = end_of_set_q;
        release_out = releases_q;
        short_0_clock = clock;
        short_0_d = short_in_0;
        short_out_0 = short_0_q;
        short_1_clock = clock;
        short_1_d = short_in_1;
        short_out_1 = short_1_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_gathers(clock, facings, facing_0, facing_1, is_there_0, is_there_1,
    gathered_0, gathered_1);
    // Module arguments
    input wire clock;
    input wire [31:0] facings;
    input wire [4:0] facing_0;
    input wire [4:0] facing_1;
    input wire is_there_0;
    input wire is_there_1;
    output reg gathered_0;
    output reg gathered_1;
    // Stub signals
    reg leaf_0_clock;
    reg [31:0] leaf_0_facings;
    reg [4:0] leaf_0_facing;
    reg leaf_0_is_there;
    wire leaf_0_gathered;
    reg leaf_1_clock;
    reg [31:0] leaf_1_facings;
    reg [4:0] leaf_1_facing;
    reg leaf_1_is_there;
    wire leaf_1_gathered;
    reg stage_0_d;
    wire stage_0_q;
    reg stage_0_clock;
    reg stage_1_d;
    wire stage_1_q;
    reg stage_1_clock;
    reg stage_2_d;
    wire stage_2_q;
    reg stage_2_clock;
    reg stage_3_d;
    wire stage_3_q;
    reg stage_3_clock;
    reg stage_4_d;
    wire stage_4_q;
    reg stage_4_clock;
    reg stage_5_d;
    wire stage_5_q;
    reg stage_5_clock;
    reg stage_6_d;
    wire stage_6_q;
    reg stage_6_clock;
    reg stage_7_d;
    wire stage_7_q;
    reg stage_7_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_leaf leaf_0(
        .clock(leaf_0_clock),
        .facings(leaf_0_facings),
        .facing(leaf_0_facing),
        .is_there(leaf_0_is_there),
        .gathered(leaf_0_gathered)
    );
    photoncube_leaf_5_local7_rgb6d_n64_leaf leaf_1(
        .clock(leaf_1_clock),
        .facings(leaf_1_facings),
        .facing(leaf_1_facing),
        .is_there(leaf_1_is_there),
        .gathered(leaf_1_gathered)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_0(
        .d(stage_0_d),
        .q(stage_0_q),
        .clock(stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_1(
        .d(stage_1_d),
        .q(stage_1_q),
        .clock(stage_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_2(
        .d(stage_2_d),
        .q(stage_2_q),
        .clock(stage_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_3(
        .d(stage_3_d),
        .q(stage_3_q),
        .clock(stage_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_4(
        .d(stage_4_d),
        .q(stage_4_q),
        .clock(stage_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_5(
        .d(stage_5_d),
        .q(stage_5_q),
        .clock(stage_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_6(
        .d(stage_6_d),
        .q(stage_6_q),
        .clock(stage_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_7(
        .d(stage_7_d),
        .q(stage_7_q),
        .clock(stage_7_clock)
    );
    // Update code
    always @(*) begin
        leaf_0_clock = clock;
        leaf_0_facings = facings;
        leaf_0_facing = facing_0;
        leaf_0_is_there = is_there_0;
        stage_0_d = leaf_0_gathered;
        leaf_1_clock = clock;
        leaf_1_facings = facings;
        leaf_1_facing = facing_1;
        leaf_1_is_there = is_there_1;
        stage_1_d = leaf_1_gathered;
        stage_0_clock = clock;
        stage_1_clock = clock;
        stage_2_clock = clock;
        stage_2_d = stage_0_q;
        stage_3_clock = clock;
        stage_3_d = stage_1_q;
        stage_4_clock = clock;
        stage_4_d = stage_2_q;
        stage_5_clock = clock;
        stage_5_d = stage_3_q;
        stage_6_clock = clock;
        stage_6_d = stage_4_q;
        stage_7_clock = clock;
        stage_7_d = stage_5_q;
        gathered_0 = stage_6_q;
        gathered_1 = stage_7_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_control(clock, reset, write_valid, write_bank, write_place,
    write_last, write_facing, frees, freed_bank, comes, first_comes, box_valid_out, box_bank_out,
    box_leaf_out, box_short_out_0, box_short_out_1, box_facing_out_0, box_facing_out_1,
    full_0_out, full_1_out, end_0_out, end_1_out);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire write_valid;
    input wire write_bank;
    input wire [3:0] write_place;
    input wire write_last;
    input wire [4:0] write_facing;
    input wire frees;
    input wire freed_bank;
    output reg comes;
    output reg first_comes;
    output reg box_valid_out;
    output reg box_bank_out;
    output reg [2:0] box_leaf_out;
    output reg box_short_out_0;
    output reg box_short_out_1;
    output reg [4:0] box_facing_out_0;
    output reg [4:0] box_facing_out_1;
    output reg full_0_out;
    output reg full_1_out;
    output reg [2:0] end_0_out;
    output reg [2:0] end_1_out;
    // Stub signals
    reg half_valid_d;
    wire half_valid_q;
    reg half_valid_clock;
    reg half_bank_d;
    wire half_bank_q;
    reg half_bank_clock;
    reg [3:0] half_place_d;
    wire [3:0] half_place_q;
    reg half_place_clock;
    reg half_last_d;
    wire half_last_q;
    reg half_last_clock;
    reg [4:0] half_facing_d;
    wire [4:0] half_facing_q;
    reg half_facing_clock;
    reg group_valid_d;
    wire group_valid_q;
    reg group_valid_clock;
    reg group_bank_d;
    wire group_bank_q;
    reg group_bank_clock;
    reg [3:0] group_place_d;
    wire [3:0] group_place_q;
    reg group_place_clock;
    reg group_last_d;
    wire group_last_q;
    reg group_last_clock;
    reg [4:0] group_facing_d;
    wire [4:0] group_facing_q;
    reg group_facing_clock;
    reg box_valid_d;
    wire box_valid_q;
    reg box_valid_clock;
    reg box_bank_d;
    wire box_bank_q;
    reg box_bank_clock;
    reg [2:0] box_leaf_d;
    wire [2:0] box_leaf_q;
    reg box_leaf_clock;
    reg box_last_d;
    wire box_last_q;
    reg box_last_clock;
    reg box_short_0_d;
    wire box_short_0_q;
    reg box_short_0_clock;
    reg box_short_1_d;
    wire box_short_1_q;
    reg box_short_1_clock;
    reg [4:0] box_facing_0_d;
    wire [4:0] box_facing_0_q;
    reg box_facing_0_clock;
    reg [4:0] box_facing_1_d;
    wire [4:0] box_facing_1_q;
    reg box_facing_1_clock;
    reg full_0_d;
    wire full_0_q;
    reg full_0_clock;
    reg full_1_d;
    wire full_1_q;
    reg full_1_clock;
    reg [2:0] end_0_d;
    wire [2:0] end_0_q;
    reg end_0_clock;
    reg [2:0] end_1_d;
    wire [2:0] end_1_q;
    reg end_1_clock;
    // Local signals
    reg is_second;
    reg is_of_second;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 half_valid(
        .d(half_valid_d),
        .q(half_valid_q),
        .clock(half_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 half_bank(
        .d(half_bank_d),
        .q(half_bank_q),
        .clock(half_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_4 half_place(
        .d(half_place_d),
        .q(half_place_q),
        .clock(half_place_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 half_last(
        .d(half_last_d),
        .q(half_last_q),
        .clock(half_last_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_5 half_facing(
        .d(half_facing_d),
        .q(half_facing_q),
        .clock(half_facing_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 group_valid(
        .d(group_valid_d),
        .q(group_valid_q),
        .clock(group_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 group_bank(
        .d(group_bank_d),
        .q(group_bank_q),
        .clock(group_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_4 group_place(
        .d(group_place_d),
        .q(group_place_q),
        .clock(group_place_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 group_last(
        .d(group_last_d),
        .q(group_last_q),
        .clock(group_last_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_5 group_facing(
        .d(group_facing_d),
        .q(group_facing_q),
        .clock(group_facing_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 box_valid(
        .d(box_valid_d),
        .q(box_valid_q),
        .clock(box_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 box_bank(
        .d(box_bank_d),
        .q(box_bank_q),
        .clock(box_bank_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_3 box_leaf(
        .d(box_leaf_d),
        .q(box_leaf_q),
        .clock(box_leaf_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 box_last(
        .d(box_last_d),
        .q(box_last_q),
        .clock(box_last_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 box_short_0(
        .d(box_short_0_d),
        .q(box_short_0_q),
        .clock(box_short_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 box_short_1(
        .d(box_short_1_d),
        .q(box_short_1_q),
        .clock(box_short_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_5 box_facing_0(
        .d(box_facing_0_d),
        .q(box_facing_0_q),
        .clock(box_facing_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_5 box_facing_1(
        .d(box_facing_1_d),
        .q(box_facing_1_q),
        .clock(box_facing_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 full_0(
        .d(full_0_d),
        .q(full_0_q),
        .clock(full_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 full_1(
        .d(full_1_d),
        .q(full_1_q),
        .clock(full_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_3 end_0(
        .d(end_0_d),
        .q(end_0_q),
        .clock(end_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_3 end_1(
        .d(end_1_d),
        .q(end_1_q),
        .clock(end_1_clock)
    );
    // Update code
    always @(*) begin
        half_valid_clock = clock;
        half_bank_clock = clock;
        half_place_clock = clock;
        half_last_clock = clock;
        half_facing_clock = clock;
        group_valid_clock = clock;
        group_bank_clock = clock;
        group_place_clock = clock;
        group_last_clock = clock;
        group_facing_clock = clock;
        box_valid_clock = clock;
        box_bank_clock = clock;
        box_leaf_clock = clock;
        box_last_clock = clock;
        box_short_0_clock = clock;
        box_short_1_clock = clock;
        box_facing_0_clock = clock;
        box_facing_1_clock = clock;
        full_0_clock = clock;
        full_1_clock = clock;
        end_0_clock = clock;
        end_1_clock = clock;
        half_valid_d = half_valid_q;
        half_bank_d = half_bank_q;
        half_place_d = half_place_q;
        half_last_d = half_last_q;
        half_facing_d = half_facing_q;
        group_valid_d = group_valid_q;
        group_bank_d = group_bank_q;
        group_place_d = group_place_q;
        group_last_d = group_last_q;
        group_facing_d = group_facing_q;
        box_valid_d = box_valid_q;
        box_bank_d = box_bank_q;
        box_leaf_d = box_leaf_q;
        box_last_d = box_last_q;
        box_short_0_d = box_short_0_q;
        box_short_1_d = box_short_1_q;
        box_facing_0_d = box_facing_0_q;
        box_facing_1_d = box_facing_1_q;
        full_0_d = full_0_q;
        full_1_d = full_1_q;
        end_0_d = end_0_q;
        end_1_d = end_1_q;
        half_valid_d = write_valid;
        half_bank_d = write_bank;
        half_place_d = write_place;
        half_last_d = write_last;
        half_facing_d = write_facing;
        group_valid_d = half_valid_q;
        group_bank_d = half_bank_q;
        group_place_d = half_place_q;
        group_last_d = half_last_q;
        group_facing_d = half_facing_q;
        is_second = group_place_q[32'h0];
        is_of_second = group_place_q[32'h1];
        comes = group_valid_q;
        first_comes = group_valid_q & ~is_second;
        box_valid_d = group_valid_q & (is_second | group_last_q);
        box_bank_d = group_bank_q;
        box_leaf_d = group_place_q[(32'h1)+:(3)];
        box_last_d = group_last_q;
        if (group_valid_q) begin
            box_short_1_d = ~is_second;
            box_facing_1_d = group_facing_q;
        end
        if (group_valid_q & ~is_of_second) begin
            box_short_0_d = ~is_second;
            box_facing_0_d = group_facing_q;
        end
        if (box_valid_q & box_last_q) begin
            if (box_bank_q) begin
                full_1_d = 1'b1;
                end_1_d = box_leaf_q;
            end
            else begin
                full_0_d = 1'b1;
                end_0_d = box_leaf_q;
            end
        end
        if (frees) begin
            if (freed_bank) begin
                full_1_d = 1'b0;
            end
            else begin
                full_0_d = 1'b0;
            end
        end
        if (reset) begin
            half_valid_d = 1'b0;
            group_valid_d = 1'b0;
            box_valid_d = 1'b0;
            full_0_d = 1'b0;
            full_1_d = 1'b0;
        end
        box_valid_out = box_valid_q;
        box_bank_out = box_bank_q;
        box_leaf_out = box_leaf_q;
        box_short_out_0 = box_short_0_q;
        box_short_out_1 = box_short_1_q;
        box_facing_out_0 = box_facing_0_q;
        box_facing_out_1 = box_facing_1_q;
        full_0_out = full_0_q;
        full_1_out = full_1_q;
        end_0_out = end_0_q;
        end_1_out = end_1_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_borders(clock, present_0, present_1, present_2, present_3, x_0, x_1,
    x_2, x_3, y_0, y_1, y_2, y_3, z_0, z_1, z_2, z_3, comes, first_comes, low_0, low_1, low_2,
    low_3, low_4, low_5, high_0, high_1, high_2, high_3, high_4, high_5);
    // Module arguments
    input wire clock;
    input wire present_0;
    input wire present_1;
    input wire present_2;
    input wire present_3;
    input wire [8:0] x_0;
    input wire [8:0] x_1;
    input wire [8:0] x_2;
    input wire [8:0] x_3;
    input wire [8:0] y_0;
    input wire [8:0] y_1;
    input wire [8:0] y_2;
    input wire [8:0] y_3;
    input wire [8:0] z_0;
    input wire [8:0] z_1;
    input wire [8:0] z_2;
    input wire [8:0] z_3;
    input wire comes;
    input wire first_comes;
    output reg [8:0] low_0;
    output reg [8:0] low_1;
    output reg [8:0] low_2;
    output reg [8:0] low_3;
    output reg [8:0] low_4;
    output reg [8:0] low_5;
    output reg [8:0] high_0;
    output reg [8:0] high_1;
    output reg [8:0] high_2;
    output reg [8:0] high_3;
    output reg [8:0] high_4;
    output reg [8:0] high_5;
    // Stub signals
    reg half_0_present_a;
    reg half_0_present_b;
    reg [8:0] half_0_place_a;
    reg [8:0] half_0_place_b;
    wire [8:0] half_0_low;
    wire [8:0] half_0_high;
    reg half_1_present_a;
    reg half_1_present_b;
    reg [8:0] half_1_place_a;
    reg [8:0] half_1_place_b;
    wire [8:0] half_1_low;
    wire [8:0] half_1_high;
    reg half_2_present_a;
    reg half_2_present_b;
    reg [8:0] half_2_place_a;
    reg [8:0] half_2_place_b;
    wire [8:0] half_2_low;
    wire [8:0] half_2_high;
    reg half_3_present_a;
    reg half_3_present_b;
    reg [8:0] half_3_place_a;
    reg [8:0] half_3_place_b;
    wire [8:0] half_3_low;
    wire [8:0] half_3_high;
    reg half_4_present_a;
    reg half_4_present_b;
    reg [8:0] half_4_place_a;
    reg [8:0] half_4_place_b;
    wire [8:0] half_4_low;
    wire [8:0] half_4_high;
    reg half_5_present_a;
    reg half_5_present_b;
    reg [8:0] half_5_place_a;
    reg [8:0] half_5_place_b;
    wire [8:0] half_5_low;
    wire [8:0] half_5_high;
    reg [8:0] half_low_0_d;
    wire [8:0] half_low_0_q;
    reg half_low_0_clock;
    reg [8:0] half_low_1_d;
    wire [8:0] half_low_1_q;
    reg half_low_1_clock;
    reg [8:0] half_low_2_d;
    wire [8:0] half_low_2_q;
    reg half_low_2_clock;
    reg [8:0] half_low_3_d;
    wire [8:0] half_low_3_q;
    reg half_low_3_clock;
    reg [8:0] half_low_4_d;
    wire [8:0] half_low_4_q;
    reg half_low_4_clock;
    reg [8:0] half_low_5_d;
    wire [8:0] half_low_5_q;
    reg half_low_5_clock;
    reg [8:0] half_high_0_d;
    wire [8:0] half_high_0_q;
    reg half_high_0_clock;
    reg [8:0] half_high_1_d;
    wire [8:0] half_high_1_q;
    reg half_high_1_clock;
    reg [8:0] half_high_2_d;
    wire [8:0] half_high_2_q;
    reg half_high_2_clock;
    reg [8:0] half_high_3_d;
    wire [8:0] half_high_3_q;
    reg half_high_3_clock;
    reg [8:0] half_high_4_d;
    wire [8:0] half_high_4_q;
    reg half_high_4_clock;
    reg [8:0] half_high_5_d;
    wire [8:0] half_high_5_q;
    reg half_high_5_clock;
    reg [8:0] both_0_low_a;
    reg [8:0] both_0_low_b;
    reg [8:0] both_0_high_a;
    reg [8:0] both_0_high_b;
    wire [8:0] both_0_low;
    wire [8:0] both_0_high;
    reg [8:0] both_1_low_a;
    reg [8:0] both_1_low_b;
    reg [8:0] both_1_high_a;
    reg [8:0] both_1_high_b;
    wire [8:0] both_1_low;
    wire [8:0] both_1_high;
    reg [8:0] both_2_low_a;
    reg [8:0] both_2_low_b;
    reg [8:0] both_2_high_a;
    reg [8:0] both_2_high_b;
    wire [8:0] both_2_low;
    wire [8:0] both_2_high;
    reg [8:0] group_low_0_d;
    wire [8:0] group_low_0_q;
    reg group_low_0_clock;
    reg [8:0] group_low_1_d;
    wire [8:0] group_low_1_q;
    reg group_low_1_clock;
    reg [8:0] group_low_2_d;
    wire [8:0] group_low_2_q;
    reg group_low_2_clock;
    reg [8:0] group_high_0_d;
    wire [8:0] group_high_0_q;
    reg group_high_0_clock;
    reg [8:0] group_high_1_d;
    wire [8:0] group_high_1_q;
    reg group_high_1_clock;
    reg [8:0] group_high_2_d;
    wire [8:0] group_high_2_q;
    reg group_high_2_clock;
    reg held_low_0_clock;
    reg held_low_0_takes;
    reg [8:0] held_low_0_d;
    wire [8:0] held_low_0_q;
    reg held_low_1_clock;
    reg held_low_1_takes;
    reg [8:0] held_low_1_d;
    wire [8:0] held_low_1_q;
    reg held_low_2_clock;
    reg held_low_2_takes;
    reg [8:0] held_low_2_d;
    wire [8:0] held_low_2_q;
    reg held_low_3_clock;
    reg held_low_3_takes;
    reg [8:0] held_low_3_d;
    wire [8:0] held_low_3_q;
    reg held_low_4_clock;
    reg held_low_4_takes;
    reg [8:0] held_low_4_d;
    wire [8:0] held_low_4_q;
    reg held_low_5_clock;
    reg held_low_5_takes;
    reg [8:0] held_low_5_d;
    wire [8:0] held_low_5_q;
    reg held_high_0_clock;
    reg held_high_0_takes;
    reg [8:0] held_high_0_d;
    wire [8:0] held_high_0_q;
    reg held_high_1_clock;
    reg held_high_1_takes;
    reg [8:0] held_high_1_d;
    wire [8:0] held_high_1_q;
    reg held_high_2_clock;
    reg held_high_2_takes;
    reg [8:0] held_high_2_d;
    wire [8:0] held_high_2_q;
    reg held_high_3_clock;
    reg held_high_3_takes;
    reg [8:0] held_high_3_d;
    wire [8:0] held_high_3_q;
    reg held_high_4_clock;
    reg held_high_4_takes;
    reg [8:0] held_high_4_d;
    wire [8:0] held_high_4_q;
    reg held_high_5_clock;
    reg held_high_5_takes;
    reg [8:0] held_high_5_d;
    wire [8:0] held_high_5_q;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_half half_0(
        .present_a(half_0_present_a),
        .present_b(half_0_present_b),
        .place_a(half_0_place_a),
        .place_b(half_0_place_b),
        .low(half_0_low),
        .high(half_0_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_half half_1(
        .present_a(half_1_present_a),
        .present_b(half_1_present_b),
        .place_a(half_1_place_a),
        .place_b(half_1_place_b),
        .low(half_1_low),
        .high(half_1_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_half half_2(
        .present_a(half_2_present_a),
        .present_b(half_2_present_b),
        .place_a(half_2_place_a),
        .place_b(half_2_place_b),
        .low(half_2_low),
        .high(half_2_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_half half_3(
        .present_a(half_3_present_a),
        .present_b(half_3_present_b),
        .place_a(half_3_place_a),
        .place_b(half_3_place_b),
        .low(half_3_low),
        .high(half_3_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_half half_4(
        .present_a(half_4_present_a),
        .present_b(half_4_present_b),
        .place_a(half_4_place_a),
        .place_b(half_4_place_b),
        .low(half_4_low),
        .high(half_4_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_half half_5(
        .present_a(half_5_present_a),
        .present_b(half_5_present_b),
        .place_a(half_5_place_a),
        .place_b(half_5_place_b),
        .low(half_5_low),
        .high(half_5_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_low_0(
        .d(half_low_0_d),
        .q(half_low_0_q),
        .clock(half_low_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_low_1(
        .d(half_low_1_d),
        .q(half_low_1_q),
        .clock(half_low_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_low_2(
        .d(half_low_2_d),
        .q(half_low_2_q),
        .clock(half_low_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_low_3(
        .d(half_low_3_d),
        .q(half_low_3_q),
        .clock(half_low_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_low_4(
        .d(half_low_4_d),
        .q(half_low_4_q),
        .clock(half_low_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_low_5(
        .d(half_low_5_d),
        .q(half_low_5_q),
        .clock(half_low_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_high_0(
        .d(half_high_0_d),
        .q(half_high_0_q),
        .clock(half_high_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_high_1(
        .d(half_high_1_d),
        .q(half_high_1_q),
        .clock(half_high_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_high_2(
        .d(half_high_2_d),
        .q(half_high_2_q),
        .clock(half_high_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_high_3(
        .d(half_high_3_d),
        .q(half_high_3_q),
        .clock(half_high_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_high_4(
        .d(half_high_4_d),
        .q(half_high_4_q),
        .clock(half_high_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 half_high_5(
        .d(half_high_5_d),
        .q(half_high_5_q),
        .clock(half_high_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_both both_0(
        .low_a(both_0_low_a),
        .low_b(both_0_low_b),
        .high_a(both_0_high_a),
        .high_b(both_0_high_b),
        .low(both_0_low),
        .high(both_0_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_both both_1(
        .low_a(both_1_low_a),
        .low_b(both_1_low_b),
        .high_a(both_1_high_a),
        .high_b(both_1_high_b),
        .low(both_1_low),
        .high(both_1_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_both both_2(
        .low_a(both_2_low_a),
        .low_b(both_2_low_b),
        .high_a(both_2_high_a),
        .high_b(both_2_high_b),
        .low(both_2_low),
        .high(both_2_high)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 group_low_0(
        .d(group_low_0_d),
        .q(group_low_0_q),
        .clock(group_low_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 group_low_1(
        .d(group_low_1_d),
        .q(group_low_1_q),
        .clock(group_low_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 group_low_2(
        .d(group_low_2_d),
        .q(group_low_2_q),
        .clock(group_low_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 group_high_0(
        .d(group_high_0_d),
        .q(group_high_0_q),
        .clock(group_high_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 group_high_1(
        .d(group_high_1_d),
        .q(group_high_1_q),
        .clock(group_high_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 group_high_2(
        .d(group_high_2_d),
        .q(group_high_2_q),
        .clock(group_high_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_low_0(
        .clock(held_low_0_clock),
        .takes(held_low_0_takes),
        .d(held_low_0_d),
        .q(held_low_0_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_low_1(
        .clock(held_low_1_clock),
        .takes(held_low_1_takes),
        .d(held_low_1_d),
        .q(held_low_1_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_low_2(
        .clock(held_low_2_clock),
        .takes(held_low_2_takes),
        .d(held_low_2_d),
        .q(held_low_2_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_low_3(
        .clock(held_low_3_clock),
        .takes(held_low_3_takes),
        .d(held_low_3_d),
        .q(held_low_3_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_low_4(
        .clock(held_low_4_clock),
        .takes(held_low_4_takes),
        .d(held_low_4_d),
        .q(held_low_4_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_low_5(
        .clock(held_low_5_clock),
        .takes(held_low_5_takes),
        .d(held_low_5_d),
        .q(held_low_5_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_high_0(
        .clock(held_high_0_clock),
        .takes(held_high_0_takes),
        .d(held_high_0_d),
        .q(held_high_0_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_high_1(
        .clock(held_high_1_clock),
        .takes(held_high_1_takes),
        .d(held_high_1_d),
        .q(held_high_1_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_high_2(
        .clock(held_high_2_clock),
        .takes(held_high_2_takes),
        .d(held_high_2_d),
        .q(held_high_2_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_high_3(
        .clock(held_high_3_clock),
        .takes(held_high_3_takes),
        .d(held_high_3_d),
        .q(held_high_3_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_high_4(
        .clock(held_high_4_clock),
        .takes(held_high_4_takes),
        .d(held_high_4_d),
        .q(held_high_4_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_held_high held_high_5(
        .clock(held_high_5_clock),
        .takes(held_high_5_takes),
        .d(held_high_5_d),
        .q(held_high_5_q)
    );
    // Update code
    always @(*) begin
        half_0_place_a = x_0;
        half_0_place_b = x_1;
        half_1_place_a = y_0;
        half_1_place_b = y_1;
        half_2_place_a = z_0;
        half_2_place_b = z_1;
        half_3_place_a = x_2;
        half_3_place_b = x_3;
        half_4_place_a = y_2;
        half_4_place_b = y_3;
        half_5_place_a = z_2;
        half_5_place_b = z_3;
        half_0_present_a = present_0;
        half_0_present_b = present_1;
        half_low_0_clock = clock;
        half_low_0_d = half_0_low;
        half_high_0_clock = clock;
        half_high_0_d = half_0_high;
        half_1_present_a = present_0;
        half_1_present_b = present_1;
        half_low_1_clock = clock;
        half_low_1_d = half_1_low;
        half_high_1_clock = clock;
        half_high_1_d = half_1_high;
        half_2_present_a = present_0;
        half_2_present_b = present_1;
        half_low_2_clock = clock;
        half_low_2_d = half_2_low;
        half_high_2_clock = clock;
        half_high_2_d = half_2_high;
        half_3_present_a = present_2;
        half_3_present_b = present_3;
        half_low_3_clock = clock;
        half_low_3_d = half_3_low;
        half_high_3_clock = clock;
        half_high_3_d = half_3_high;
        half_4_present_a = present_2;
        half_4_present_b = present_3;
        half_low_4_clock = clock;
        half_low_4_d = half_4_low;
        half_high_4_clock = clock;
        half_high_4_d = half_4_high;
        half_5_present_a = present_2;
        half_5_present_b = present_3;
        half_low_5_clock = clock;
        half_low_5_d = half_5_low;
        half_high_5_clock = clock;
        half_high_5_d = half_5_high;
        both_0_low_a = half_low_0_q;
        both_0_low_b = half_low_3_q;
        both_0_high_a = half_high_0_q;
        both_0_high_b = half_high_3_q;
        group_low_0_clock = clock;
        group_low_0_d = both_0_low;
        group_high_0_clock = clock;
        group_high_0_d = both_0_high;
        held_low_0_takes = first_comes;
        held_high_0_takes = first_comes;
        held_low_3_takes = comes;
        held_high_3_takes = comes;
        both_1_low_a = half_low_1_q;
        both_1_low_b = half_low_4_q;
        both_1_high_a = half_high_1_q;
        both_1_high_b = half_high_4_q;
        group_low_1_clock = clock;
        group_low_1_d = both_1_low;
        group_high_1_clock = clock;
        group_high_1_d = both_1_high;
        held_low_1_takes = first_comes;
        held_high_1_takes = first_comes;
        held_low_4_takes = comes;
        held_high_4_takes = comes;
        both_2_low_a = half_low_2_q;
        both_2_low_b = half_low_5_q;
        both_2_high_a = half_high_2_q;
        both_2_high_b = half_high_5_q;
        group_low_2_clock = clock;
        group_low_2_d = both_2_low;
        group_high_2_clock = clock;
        group_high_2_d = both_2_high;
        held_low_2_takes = first_comes;
        held_high_2_takes = first_comes;
        held_low_5_takes = comes;
        held_high_5_takes = comes;
        held_low_0_clock = clock;
        held_low_0_d = group_low_0_q;
        held_high_0_clock = clock;
        held_high_0_d = group_high_0_q;
        low_0 = held_low_0_q;
        high_0 = held_high_0_q;
        held_low_1_clock = clock;
        held_low_1_d = group_low_1_q;
        held_high_1_clock = clock;
        held_high_1_d = group_high_1_q;
        low_1 = held_low_1_q;
        high_1 = held_high_1_q;
        held_low_2_clock = clock;
        held_low_2_d = group_low_2_q;
        held_high_2_clock = clock;
        held_high_2_d = group_high_2_q;
        low_2 = held_low_2_q;
        high_2 = held_high_2_q;
        held_low_3_clock = clock;
        held_low_3_d = group_low_0_q;
        held_high_3_clock = clock;
        held_high_3_d = group_high_0_q;
        low_3 = held_low_3_q;
        high_3 = held_high_3_q;
        held_low_4_clock = clock;
        held_low_4_d = group_low_1_q;
        held_high_4_clock = clock;
        held_high_4_d = group_high_1_q;
        low_4 = held_low_4_q;
        high_4 = held_high_4_q;
        held_low_5_clock = clock;
        held_low_5_d = group_low_2_q;
        held_high_5_clock = clock;
        held_high_5_d = group_high_2_q;
        low_5 = held_low_5_q;
        high_5 = held_high_5_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_box_words(clock, low_0, low_1, low_2, low_3, low_4, low_5, high_0,
    high_1, high_2, high_3, high_4, high_5, facing_0, facing_1, short_0, short_1, write,
    write_bank, write_leaf, read, read_bank, read_pair, found_low_0, found_low_1, found_low_2,
    found_low_3, found_low_4, found_low_5, found_low_6, found_low_7, found_low_8, found_low_9,
    found_low_10, found_low_11, found_high_0, found_high_1, found_high_2, found_high_3,
    found_high_4, found_high_5, found_high_6, found_high_7, found_high_8, found_high_9,
    found_high_10, found_high_11, found_facing_0, found_facing_1, found_short_0, found_short_1);
    // Module arguments
    input wire clock;
    input wire [8:0] low_0;
    input wire [8:0] low_1;
    input wire [8:0] low_2;
    input wire [8:0] low_3;
    input wire [8:0] low_4;
    input wire [8:0] low_5;
    input wire [8:0] high_0;
    input wire [8:0] high_1;
    input wire [8:0] high_2;
    input wire [8:0] high_3;
    input wire [8:0] high_4;
    input wire [8:0] high_5;
    input wire [4:0] facing_0;
    input wire [4:0] facing_1;
    input wire short_0;
    input wire short_1;
    input wire write;
    input wire write_bank;
    input wire [2:0] write_leaf;
    input wire read;
    input wire read_bank;
    input wire [1:0] read_pair;
    output reg [8:0] found_low_0;
    output reg [8:0] found_low_1;
    output reg [8:0] found_low_2;
    output reg [8:0] found_low_3;
    output reg [8:0] found_low_4;
    output reg [8:0] found_low_5;
    output reg [8:0] found_low_6;
    output reg [8:0] found_low_7;
    output reg [8:0] found_low_8;
    output reg [8:0] found_low_9;
    output reg [8:0] found_low_10;
    output reg [8:0] found_low_11;
    output reg [8:0] found_high_0;
    output reg [8:0] found_high_1;
    output reg [8:0] found_high_2;
    output reg [8:0] found_high_3;
    output reg [8:0] found_high_4;
    output reg [8:0] found_high_5;
    output reg [8:0] found_high_6;
    output reg [8:0] found_high_7;
    output reg [8:0] found_high_8;
    output reg [8:0] found_high_9;
    output reg [8:0] found_high_10;
    output reg [8:0] found_high_11;
    output reg [4:0] found_facing_0;
    output reg [4:0] found_facing_1;
    output reg found_short_0;
    output reg found_short_1;
    // Update code (custom)
    (* no_rw_check *) reg [107:0] boxes_0 [0:7];
    reg [107:0] look_0 = 108'd0;
    reg [107:0] found_0 = 108'd0;
    (* no_rw_check *) reg [107:0] boxes_1 [0:7];
    reg [107:0] look_1 = 108'd0;
    reg [107:0] found_1 = 108'd0;
    (* no_rw_check *) reg [11:0] notes [0:7];
    reg [11:0] look_2 = 12'd0;
    reg [11:0] found_2 = 12'd0;
    wire [107:0] box = {high_5, high_4, high_3, high_2, high_1, high_0, low_5, low_4, low_3, low_2, low_1, low_0};
    wire [11:0] note = {short_1, short_0, facing_1, facing_0};
    wire [2:0] write_address = {write_bank, write_leaf[2:1]};
    wire [2:0] read_address = {read_bank, read_pair};
    always @(posedge clock) begin
      if (read) look_0 <= boxes_0[read_address];
      found_0 <= look_0;
      if (write & ~write_leaf[0]) boxes_0[write_address] <= box;
      if (read) look_1 <= boxes_1[read_address];
      found_1 <= look_1;
      if (write) boxes_1[write_address] <= box;
      if (read) look_2 <= notes[read_address];
      found_2 <= look_2;
      if (write) notes[write_address] <= note;
    end
    wire [8:0] of_look_low_0 = look_0[8:0];
    wire [8:0] of_found_low_0 = found_0[8:0];
    always @(*) found_low_0 = of_found_low_0;
    wire [8:0] of_look_low_1 = look_0[17:9];
    wire [8:0] of_found_low_1 = found_0[17:9];
    always @(*) found_low_1 = of_found_low_1;
    wire [8:0] of_look_low_2 = look_0[26:18];
    wire [8:0] of_found_low_2 = found_0[26:18];
    always @(*) found_low_2 = of_found_low_2;
    wire [8:0] of_look_low_3 = look_0[35:27];
    wire [8:0] of_found_low_3 = found_0[35:27];
    always @(*) found_low_3 = of_found_low_3;
    wire [8:0] of_look_low_4 = look_0[44:36];
    wire [8:0] of_found_low_4 = found_0[44:36];
    always @(*) found_low_4 = of_found_low_4;
    wire [8:0] of_look_low_5 = look_0[53:45];
    wire [8:0] of_found_low_5 = found_0[53:45];
    always @(*) found_low_5 = of_found_low_5;
    wire [8:0] of_look_high_0 = look_0[62:54];
    wire [8:0] of_found_high_0 = found_0[62:54];
    always @(*) found_high_0 = of_found_high_0;
    wire [8:0] of_look_high_1 = look_0[71:63];
    wire [8:0] of_found_high_1 = found_0[71:63];
    always @(*) found_high_1 = of_found_high_1;
    wire [8:0] of_look_high_2 = look_0[80:72];
    wire [8:0] of_found_high_2 = found_0[80:72];
    always @(*) found_high_2 = of_found_high_2;
    wire [8:0] of_look_high_3 = look_0[89:81];
    wire [8:0] of_found_high_3 = found_0[89:81];
    always @(*) found_high_3 = of_found_high_3;
    wire [8:0] of_look_high_4 = look_0[98:90];
    wire [8:0] of_found_high_4 = found_0[98:90];
    always @(*) found_high_4 = of_found_high_4;
    wire [8:0] of_look_high_5 = look_0[107:99];
    wire [8:0] of_found_high_5 = found_0[107:99];
    always @(*) found_high_5 = of_found_high_5;
    wire [8:0] of_look_low_6 = look_1[8:0];
    wire [8:0] of_found_low_6 = found_1[8:0];
    always @(*) found_low_6 = of_found_low_6;
    wire [8:0] of_look_low_7 = look_1[17:9];
    wire [8:0] of_found_low_7 = found_1[17:9];
    always @(*) found_low_7 = of_found_low_7;
    wire [8:0] of_look_low_8 = look_1[26:18];
    wire [8:0] of_found_low_8 = found_1[26:18];
    always @(*) found_low_8 = of_found_low_8;
    wire [8:0] of_look_low_9 = look_1[35:27];
    wire [8:0] of_found_low_9 = found_1[35:27];
    always @(*) found_low_9 = of_found_low_9;
    wire [8:0] of_look_low_10 = look_1[44:36];
    wire [8:0] of_found_low_10 = found_1[44:36];
    always @(*) found_low_10 = of_found_low_10;
    wire [8:0] of_look_low_11 = look_1[53:45];
    wire [8:0] of_found_low_11 = found_1[53:45];
    always @(*) found_low_11 = of_found_low_11;
    wire [8:0] of_look_high_6 = look_1[62:54];
    wire [8:0] of_found_high_6 = found_1[62:54];
    always @(*) found_high_6 = of_found_high_6;
    wire [8:0] of_look_high_7 = look_1[71:63];
    wire [8:0] of_found_high_7 = found_1[71:63];
    always @(*) found_high_7 = of_found_high_7;
    wire [8:0] of_look_high_8 = look_1[80:72];
    wire [8:0] of_found_high_8 = found_1[80:72];
    always @(*) found_high_8 = of_found_high_8;
    wire [8:0] of_look_high_9 = look_1[89:81];
    wire [8:0] of_found_high_9 = found_1[89:81];
    always @(*) found_high_9 = of_found_high_9;
    wire [8:0] of_look_high_10 = look_1[98:90];
    wire [8:0] of_found_high_10 = found_1[98:90];
    always @(*) found_high_10 = of_found_high_10;
    wire [8:0] of_look_high_11 = look_1[107:99];
    wire [8:0] of_found_high_11 = found_1[107:99];
    always @(*) found_high_11 = of_found_high_11;
    wire [4:0] of_look_facing_0 = look_2[4:0];
    wire [4:0] of_found_facing_0 = found_2[4:0];
    always @(*) found_facing_0 = of_found_facing_0;
    wire [4:0] of_look_facing_1 = look_2[9:5];
    wire [4:0] of_found_facing_1 = found_2[9:5];
    always @(*) found_facing_1 = of_found_facing_1;
    wire [0:0] of_look_short_0 = look_2[10:10];
    wire [0:0] of_found_short_0 = found_2[10:10];
    always @(*) found_short_0 = of_found_short_0;
    wire [0:0] of_look_short_1 = look_2[11:11];
    wire [0:0] of_found_short_1 = found_2[11:11];
    always @(*) found_short_1 = of_found_short_1;
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_head(clock, reset, query_valid, query_ready, group_valid,
    group_last, group_ready, taken, first_taken, last_taken, red_0, red_1, red_2, red_3, green_0,
    green_1, green_2, green_3, blue_0, blue_1, blue_2, blue_3, present_0, present_1, present_2,
    present_3, taken_in, first_in, last_in, result_valid, result_red, result_green, result_blue,
    result_count, result_ready, token_valid, is_full, has_room, clocks_to_last, power_0, power_1,
    power_2, power_3, power_4, power_5, power_6, power_7, power_8, power_9, power_10, power_11,
    power_present_0, power_present_1, power_present_2, power_present_3, first, last,
    result_valid_in, result_in_0, result_in_1, result_in_2, result_count_in);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    output reg query_ready;
    input wire group_valid;
    input wire group_last;
    output reg group_ready;
    output reg taken;
    output reg first_taken;
    output reg last_taken;
    input wire [5:0] red_0;
    input wire [5:0] red_1;
    input wire [5:0] red_2;
    input wire [5:0] red_3;
    input wire [5:0] green_0;
    input wire [5:0] green_1;
    input wire [5:0] green_2;
    input wire [5:0] green_3;
    input wire [5:0] blue_0;
    input wire [5:0] blue_1;
    input wire [5:0] blue_2;
    input wire [5:0] blue_3;
    input wire present_0;
    input wire present_1;
    input wire present_2;
    input wire present_3;
    input wire taken_in;
    input wire first_in;
    input wire last_in;
    output reg result_valid;
    output reg [11:0] result_red;
    output reg [11:0] result_green;
    output reg [11:0] result_blue;
    output reg [6:0] result_count;
    input wire result_ready;
    output reg token_valid;
    output reg is_full;
    output reg has_room;
    output reg [15:0] clocks_to_last;
    output reg [5:0] power_0;
    output reg [5:0] power_1;
    output reg [5:0] power_2;
    output reg [5:0] power_3;
    output reg [5:0] power_4;
    output reg [5:0] power_5;
    output reg [5:0] power_6;
    output reg [5:0] power_7;
    output reg [5:0] power_8;
    output reg [5:0] power_9;
    output reg [5:0] power_10;
    output reg [5:0] power_11;
    output reg power_present_0;
    output reg power_present_1;
    output reg power_present_2;
    output reg power_present_3;
    output reg first;
    output reg last;
    input wire result_valid_in;
    input wire [11:0] result_in_0;
    input wire [11:0] result_in_1;
    input wire [11:0] result_in_2;
    input wire [6:0] result_count_in;
    // Stub signals
    reg admission_clock;
    reg admission_reset;
    reg admission_query_valid;
    reg admission_group_valid;
    reg admission_group_last;
    reg admission_batch_read;
    wire admission_query_ready;
    wire admission_group_ready;
    wire admission_taken;
    wire admission_first_taken;
    wire admission_last_taken;
    wire admission_token_valid;
    wire admission_is_full;
    wire admission_has_room;
    wire [15:0] admission_clocks_to_last;
    reg [5:0] power_decoder_0_mantissa;
    wire [5:0] power_decoder_0_power;
    reg [5:0] power_decoder_1_mantissa;
    wire [5:0] power_decoder_1_power;
    reg [5:0] power_decoder_2_mantissa;
    wire [5:0] power_decoder_2_power;
    reg [5:0] power_decoder_3_mantissa;
    wire [5:0] power_decoder_3_power;
    reg [5:0] power_decoder_4_mantissa;
    wire [5:0] power_decoder_4_power;
    reg [5:0] power_decoder_5_mantissa;
    wire [5:0] power_decoder_5_power;
    reg [5:0] power_decoder_6_mantissa;
    wire [5:0] power_decoder_6_power;
    reg [5:0] power_decoder_7_mantissa;
    wire [5:0] power_decoder_7_power;
    reg [5:0] power_decoder_8_mantissa;
    wire [5:0] power_decoder_8_power;
    reg [5:0] power_decoder_9_mantissa;
    wire [5:0] power_decoder_9_power;
    reg [5:0] power_decoder_10_mantissa;
    wire [5:0] power_decoder_10_power;
    reg [5:0] power_decoder_11_mantissa;
    wire [5:0] power_decoder_11_power;
    reg [5:0] decoded_0_d;
    wire [5:0] decoded_0_q;
    reg decoded_0_clock;
    reg [5:0] decoded_1_d;
    wire [5:0] decoded_1_q;
    reg decoded_1_clock;
    reg [5:0] decoded_2_d;
    wire [5:0] decoded_2_q;
    reg decoded_2_clock;
    reg [5:0] decoded_3_d;
    wire [5:0] decoded_3_q;
    reg decoded_3_clock;
    reg [5:0] decoded_4_d;
    wire [5:0] decoded_4_q;
    reg decoded_4_clock;
    reg [5:0] decoded_5_d;
    wire [5:0] decoded_5_q;
    reg decoded_5_clock;
    reg [5:0] decoded_6_d;
    wire [5:0] decoded_6_q;
    reg decoded_6_clock;
    reg [5:0] decoded_7_d;
    wire [5:0] decoded_7_q;
    reg decoded_7_clock;
    reg [5:0] decoded_8_d;
    wire [5:0] decoded_8_q;
    reg decoded_8_clock;
    reg [5:0] decoded_9_d;
    wire [5:0] decoded_9_q;
    reg decoded_9_clock;
    reg [5:0] decoded_10_d;
    wire [5:0] decoded_10_q;
    reg decoded_10_clock;
    reg [5:0] decoded_11_d;
    wire [5:0] decoded_11_q;
    reg decoded_11_clock;
    reg presence_0_clock;
    reg presence_0_taken;
    reg presence_0_photon_present;
    wire presence_0_present;
    wire presence_0_absent;
    reg presence_1_clock;
    reg presence_1_taken;
    reg presence_1_photon_present;
    wire presence_1_present;
    wire presence_1_absent;
    reg presence_2_clock;
    reg presence_2_taken;
    reg presence_2_photon_present;
    wire presence_2_present;
    wire presence_2_absent;
    reg presence_3_clock;
    reg presence_3_taken;
    reg presence_3_photon_present;
    wire presence_3_present;
    wire presence_3_absent;
    reg power_of_present_0_absent;
    reg [5:0] power_of_present_0_word;
    wire [5:0] power_of_present_0_power;
    reg power_of_present_1_absent;
    reg [5:0] power_of_present_1_word;
    wire [5:0] power_of_present_1_power;
    reg power_of_present_2_absent;
    reg [5:0] power_of_present_2_word;
    wire [5:0] power_of_present_2_power;
    reg power_of_present_3_absent;
    reg [5:0] power_of_present_3_word;
    wire [5:0] power_of_present_3_power;
    reg power_of_present_4_absent;
    reg [5:0] power_of_present_4_word;
    wire [5:0] power_of_present_4_power;
    reg power_of_present_5_absent;
    reg [5:0] power_of_present_5_word;
    wire [5:0] power_of_present_5_power;
    reg power_of_present_6_absent;
    reg [5:0] power_of_present_6_word;
    wire [5:0] power_of_present_6_power;
    reg power_of_present_7_absent;
    reg [5:0] power_of_present_7_word;
    wire [5:0] power_of_present_7_power;
    reg power_of_present_8_absent;
    reg [5:0] power_of_present_8_word;
    wire [5:0] power_of_present_8_power;
    reg power_of_present_9_absent;
    reg [5:0] power_of_present_9_word;
    wire [5:0] power_of_present_9_power;
    reg power_of_present_10_absent;
    reg [5:0] power_of_present_10_word;
    wire [5:0] power_of_present_10_power;
    reg power_of_present_11_absent;
    reg [5:0] power_of_present_11_word;
    wire [5:0] power_of_present_11_power;
    reg power_delay_0_clock;
    reg [5:0] power_delay_0_word;
    wire [5:0] power_delay_0_delayed;
    reg power_delay_1_clock;
    reg [5:0] power_delay_1_word;
    wire [5:0] power_delay_1_delayed;
    reg power_delay_2_clock;
    reg [5:0] power_delay_2_word;
    wire [5:0] power_delay_2_delayed;
    reg power_delay_3_clock;
    reg [5:0] power_delay_3_word;
    wire [5:0] power_delay_3_delayed;
    reg power_delay_4_clock;
    reg [5:0] power_delay_4_word;
    wire [5:0] power_delay_4_delayed;
    reg power_delay_5_clock;
    reg [5:0] power_delay_5_word;
    wire [5:0] power_delay_5_delayed;
    reg power_delay_6_clock;
    reg [5:0] power_delay_6_word;
    wire [5:0] power_delay_6_delayed;
    reg power_delay_7_clock;
    reg [5:0] power_delay_7_word;
    wire [5:0] power_delay_7_delayed;
    reg power_delay_8_clock;
    reg [5:0] power_delay_8_word;
    wire [5:0] power_delay_8_delayed;
    reg power_delay_9_clock;
    reg [5:0] power_delay_9_word;
    wire [5:0] power_delay_9_delayed;
    reg power_delay_10_clock;
    reg [5:0] power_delay_10_word;
    wire [5:0] power_delay_10_delayed;
    reg power_delay_11_clock;
    reg [5:0] power_delay_11_word;
    wire [5:0] power_delay_11_delayed;
    reg present_delay_0_clock;
    reg present_delay_0_word;
    wire present_delay_0_delayed;
    reg present_delay_1_clock;
    reg present_delay_1_word;
    wire present_delay_1_delayed;
    reg present_delay_2_clock;
    reg present_delay_2_word;
    wire present_delay_2_delayed;
    reg present_delay_3_clock;
    reg present_delay_3_word;
    wire present_delay_3_delayed;
    reg first_delay_clock;
    reg first_delay_clear;
    reg first_delay_flag;
    wire first_delay_delayed;
    reg last_delay_clock;
    reg last_delay_clear;
    reg last_delay_flag;
    wire last_delay_delayed;
    reg queue_clock;
    reg queue_reset;
    reg queue_result_valid_in;
    reg [11:0] queue_result_in_0;
    reg [11:0] queue_result_in_1;
    reg [11:0] queue_result_in_2;
    reg [6:0] queue_result_count_in;
    reg queue_result_ready;
    wire queue_result_valid;
    wire [11:0] queue_result_red;
    wire [11:0] queue_result_green;
    wire [11:0] queue_result_blue;
    wire [6:0] queue_result_count;
    wire queue_batch_read;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_admission admission(
        .clock(admission_clock),
        .reset(admission_reset),
        .query_valid(admission_query_valid),
        .group_valid(admission_group_valid),
        .group_last(admission_group_last),
        .batch_read(admission_batch_read),
        .query_ready(admission_query_ready),
        .group_ready(admission_group_ready),
        .taken(admission_taken),
        .first_taken(admission_first_taken),
        .last_taken(admission_last_taken),
        .token_valid(admission_token_valid),
        .is_full(admission_is_full),
        .has_room(admission_has_room),
        .clocks_to_last(admission_clocks_to_last)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_0(
        .mantissa(power_decoder_0_mantissa),
        .power(power_decoder_0_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_1(
        .mantissa(power_decoder_1_mantissa),
        .power(power_decoder_1_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_2(
        .mantissa(power_decoder_2_mantissa),
        .power(power_decoder_2_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_3(
        .mantissa(power_decoder_3_mantissa),
        .power(power_decoder_3_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_4(
        .mantissa(power_decoder_4_mantissa),
        .power(power_decoder_4_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_5(
        .mantissa(power_decoder_5_mantissa),
        .power(power_decoder_5_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_6(
        .mantissa(power_decoder_6_mantissa),
        .power(power_decoder_6_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_7(
        .mantissa(power_decoder_7_mantissa),
        .power(power_decoder_7_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_8(
        .mantissa(power_decoder_8_mantissa),
        .power(power_decoder_8_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_9(
        .mantissa(power_decoder_9_mantissa),
        .power(power_decoder_9_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_10(
        .mantissa(power_decoder_10_mantissa),
        .power(power_decoder_10_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_decoder power_decoder_11(
        .mantissa(power_decoder_11_mantissa),
        .power(power_decoder_11_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_0(
        .d(decoded_0_d),
        .q(decoded_0_q),
        .clock(decoded_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_1(
        .d(decoded_1_d),
        .q(decoded_1_q),
        .clock(decoded_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_2(
        .d(decoded_2_d),
        .q(decoded_2_q),
        .clock(decoded_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_3(
        .d(decoded_3_d),
        .q(decoded_3_q),
        .clock(decoded_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_4(
        .d(decoded_4_d),
        .q(decoded_4_q),
        .clock(decoded_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_5(
        .d(decoded_5_d),
        .q(decoded_5_q),
        .clock(decoded_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_6(
        .d(decoded_6_d),
        .q(decoded_6_q),
        .clock(decoded_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_7(
        .d(decoded_7_d),
        .q(decoded_7_q),
        .clock(decoded_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_8(
        .d(decoded_8_d),
        .q(decoded_8_q),
        .clock(decoded_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_9(
        .d(decoded_9_d),
        .q(decoded_9_q),
        .clock(decoded_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_10(
        .d(decoded_10_d),
        .q(decoded_10_q),
        .clock(decoded_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 decoded_11(
        .d(decoded_11_d),
        .q(decoded_11_q),
        .clock(decoded_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_presence presence_0(
        .clock(presence_0_clock),
        .taken(presence_0_taken),
        .photon_present(presence_0_photon_present),
        .present(presence_0_present),
        .absent(presence_0_absent)
    );
    photoncube_leaf_5_local7_rgb6d_n64_presence presence_1(
        .clock(presence_1_clock),
        .taken(presence_1_taken),
        .photon_present(presence_1_photon_present),
        .present(presence_1_present),
        .absent(presence_1_absent)
    );
    photoncube_leaf_5_local7_rgb6d_n64_presence presence_2(
        .clock(presence_2_clock),
        .taken(presence_2_taken),
        .photon_present(presence_2_photon_present),
        .present(presence_2_present),
        .absent(presence_2_absent)
    );
    photoncube_leaf_5_local7_rgb6d_n64_presence presence_3(
        .clock(presence_3_clock),
        .taken(presence_3_taken),
        .photon_present(presence_3_photon_present),
        .present(presence_3_present),
        .absent(presence_3_absent)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_0(
        .absent(power_of_present_0_absent),
        .word(power_of_present_0_word),
        .power(power_of_present_0_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_1(
        .absent(power_of_present_1_absent),
        .word(power_of_present_1_word),
        .power(power_of_present_1_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_2(
        .absent(power_of_present_2_absent),
        .word(power_of_present_2_word),
        .power(power_of_present_2_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_3(
        .absent(power_of_present_3_absent),
        .word(power_of_present_3_word),
        .power(power_of_present_3_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_4(
        .absent(power_of_present_4_absent),
        .word(power_of_present_4_word),
        .power(power_of_present_4_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_5(
        .absent(power_of_present_5_absent),
        .word(power_of_present_5_word),
        .power(power_of_present_5_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_6(
        .absent(power_of_present_6_absent),
        .word(power_of_present_6_word),
        .power(power_of_present_6_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_7(
        .absent(power_of_present_7_absent),
        .word(power_of_present_7_word),
        .power(power_of_present_7_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_8(
        .absent(power_of_present_8_absent),
        .word(power_of_present_8_word),
        .power(power_of_present_8_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_9(
        .absent(power_of_present_9_absent),
        .word(power_of_present_9_word),
        .power(power_of_present_9_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_10(
        .absent(power_of_present_10_absent),
        .word(power_of_present_10_word),
        .power(power_of_present_10_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_of_present power_of_present_11(
        .absent(power_of_present_11_absent),
        .word(power_of_present_11_word),
        .power(power_of_present_11_power)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_0(
        .clock(power_delay_0_clock),
        .word(power_delay_0_word),
        .delayed(power_delay_0_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_1(
        .clock(power_delay_1_clock),
        .word(power_delay_1_word),
        .delayed(power_delay_1_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_2(
        .clock(power_delay_2_clock),
        .word(power_delay_2_word),
        .delayed(power_delay_2_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_3(
        .clock(power_delay_3_clock),
        .word(power_delay_3_word),
        .delayed(power_delay_3_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_4(
        .clock(power_delay_4_clock),
        .word(power_delay_4_word),
        .delayed(power_delay_4_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_5(
        .clock(power_delay_5_clock),
        .word(power_delay_5_word),
        .delayed(power_delay_5_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_6(
        .clock(power_delay_6_clock),
        .word(power_delay_6_word),
        .delayed(power_delay_6_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_7(
        .clock(power_delay_7_clock),
        .word(power_delay_7_word),
        .delayed(power_delay_7_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_8(
        .clock(power_delay_8_clock),
        .word(power_delay_8_word),
        .delayed(power_delay_8_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_9(
        .clock(power_delay_9_clock),
        .word(power_delay_9_word),
        .delayed(power_delay_9_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_10(
        .clock(power_delay_10_clock),
        .word(power_delay_10_word),
        .delayed(power_delay_10_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_power_delay power_delay_11(
        .clock(power_delay_11_clock),
        .word(power_delay_11_word),
        .delayed(power_delay_11_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_present_delay present_delay_0(
        .clock(present_delay_0_clock),
        .word(present_delay_0_word),
        .delayed(present_delay_0_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_present_delay present_delay_1(
        .clock(present_delay_1_clock),
        .word(present_delay_1_word),
        .delayed(present_delay_1_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_present_delay present_delay_2(
        .clock(present_delay_2_clock),
        .word(present_delay_2_word),
        .delayed(present_delay_2_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_present_delay present_delay_3(
        .clock(present_delay_3_clock),
        .word(present_delay_3_word),
        .delayed(present_delay_3_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_first_delay first_delay(
        .clock(first_delay_clock),
        .clear(first_delay_clear),
        .flag(first_delay_flag),
        .delayed(first_delay_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_first_delay last_delay(
        .clock(last_delay_clock),
        .clear(last_delay_clear),
        .flag(last_delay_flag),
        .delayed(last_delay_delayed)
    );
    photoncube_leaf_5_local7_rgb6d_n64_queue queue(
        .clock(queue_clock),
        .reset(queue_reset),
        .result_valid_in(queue_result_valid_in),
        .result_in_0(queue_result_in_0),
        .result_in_1(queue_result_in_1),
        .result_in_2(queue_result_in_2),
        .result_count_in(queue_result_count_in),
        .result_ready(queue_result_ready),
        .result_valid(queue_result_valid),
        .result_red(queue_result_red),
        .result_green(queue_result_green),
        .result_blue(queue_result_blue),
        .result_count(queue_result_count),
        .batch_read(queue_batch_read)
    );
    // Update code
    always @(*) begin
        admission_clock = clock;
        admission_reset = reset;
        admission_query_valid = query_valid;
        admission_group_valid = group_valid;
        admission_group_last = group_last;
        admission_batch_read = queue_batch_read;
        query_ready = admission_query_ready;
        group_ready = admission_group_ready;
        token_valid = admission_token_valid;
        taken = admission_taken;
        first_taken = admission_first_taken;
        last_taken = admission_last_taken;
        is_full = admission_is_full;
        has_room = admission_has_room;
        clocks_to_last = admission_clocks_to_last;
        queue_clock = clock;
        queue_reset = reset;
        queue_result_ready = result_ready;
        queue_result_valid_in = result_valid_in;
        queue_result_count_in = result_count_in;
        result_valid = queue_result_valid;
        result_count = queue_result_count;
        queue_result_in_0 = result_in_0;
        result_red = queue_result_red;
        queue_result_in_1 = result_in_1;
        result_green = queue_result_green;
        queue_result_in_2 = result_in_2;
        result_blue = queue_result_blue;
        presence_0_clock = clock;
        presence_0_photon_present = present_0;
        presence_0_taken = taken_in;
        present_delay_0_clock = clock;
        present_delay_0_word = presence_0_present;
        power_present_0 = present_delay_0_delayed;
        power_decoder_0_mantissa = red_0;
        decoded_0_clock = clock;
        decoded_0_d = power_decoder_0_power;
        power_of_present_0_absent = presence_0_absent;
        power_of_present_0_word = decoded_0_q;
        power_delay_0_clock = clock;
        power_delay_0_word = power_of_present_0_power;
        power_0 = power_delay_0_delayed;
        power_decoder_1_mantissa = green_0;
        decoded_1_clock = clock;
        decoded_1_d = power_decoder_1_power;
        power_of_present_1_absent = presence_0_absent;
        power_of_present_1_word = decoded_1_q;
        power_delay_1_clock = clock;
        power_delay_1_word = power_of_present_1_power;
        power_1 = power_delay_1_delayed;
        power_decoder_2_mantissa = blue_0;
        decoded_2_clock = clock;
        decoded_2_d = power_decoder_2_power;
        power_of_present_2_absent = presence_0_absent;
        power_of_present_2_word = decoded_2_q;
        power_delay_2_clock = clock;
        power_delay_2_word = power_of_present_2_power;
        power_2 = power_delay_2_delayed;
        presence_1_clock = clock;
        presence_1_photon_present = present_1;
        presence_1_taken = taken_in;
        present_delay_1_clock = clock;
        present_delay_1_word = presence_1_present;
        power_present_1 = present_delay_1_delayed;
        power_decoder_3_mantissa = red_1;
        decoded_3_clock = clock;
        decoded_3_d = power_decoder_3_power;
        power_of_present_3_absent = presence_1_absent;
        power_of_present_3_word = decoded_3_q;
        power_delay_3_clock = clock;
        power_delay_3_word = power_of_present_3_power;
        power_3 = power_delay_3_delayed;
        power_decoder_4_mantissa = green_1;
        decoded_4_clock = clock;
        decoded_4_d = power_decoder_4_power;
        power_of_present_4_absent = presence_1_absent;
        power_of_present_4_word = decoded_4_q;
        power_delay_4_clock = clock;
        power_delay_4_word = power_of_present_4_power;
        power_4 = power_delay_4_delayed;
        power_decoder_5_mantissa = blue_1;
        decoded_5_clock = clock;
        decoded_5_d = power_decoder_5_power;
        power_of_present_5_absent = presence_1_absent;
        power_of_present_5_word = decoded_5_q;
        power_delay_5_clock = clock;
        power_delay_5_word = power_of_present_5_power;
        power_5 = power_delay_5_delayed;
        presence_2_clock = clock;
        presence_2_photon_present = present_2;
        presence_2_taken = taken_in;
        present_delay_2_clock = clock;
        present_delay_2_word = presence_2_present;
        power_present_2 = present_delay_2_delayed;
        power_decoder_6_mantissa = red_2;
        decoded_6_clock = clock;
        decoded_6_d = power_decoder_6_power;
        power_of_present_6_absent = presence_2_absent;
        power_of_present_6_word = decoded_6_q;
        power_delay_6_clock = clock;
        power_delay_6_word = power_of_present_6_power;
        power_6 = power_delay_6_delayed;
        power_decoder_7_mantissa = green_2;
        decoded_7_clock = clock;
        decoded_7_d = power_decoder_7_power;
        power_of_present_7_absent = presence_2_absent;
        power_of_present_7_word = decoded_7_q;
        power_delay_7_clock = clock;
        power_delay_7_word = power_of_present_7_power;
        power_7 = power_delay_7_delayed;
        power_decoder_8_mantissa = blue_2;
        decoded_8_clock = clock;
        decoded_8_d = power_decoder_8_power;
        power_of_present_8_absent = presence_2_absent;
        power_of_present_8_word = decoded_8_q;
        power_delay_8_clock = clock;
        power_delay_8_word = power_of_present_8_power;
        power_8 = power_delay_8_delayed;
        presence_3_clock = clock;
        presence_3_photon_present = present_3;
        presence_3_taken = taken_in;
        present_delay_3_clock = clock;
        present_delay_3_word = presence_3_present;
        power_present_3 = present_delay_3_delayed;
        power_decoder_9_mantissa = red_3;
        decoded_9_clock = clock;
        decoded_9_d = power_decoder_9_power;
        power_of_present_9_absent = presence_3_absent;
        power_of_present_9_word = decoded_9_q;
        power_delay_9_clock = clock;
        power_delay_9_word = power_of_present_9_power;
        power_9 = power_delay_9_delayed;
        power_decoder_10_mantissa = green_3;
        decoded_10_clock = clock;
        decoded_10_d = power_decoder_10_power;
        power_of_present_10_absent = presence_3_absent;
        power_of_present_10_word = decoded_10_q;
        power_delay_10_clock = clock;
        power_delay_10_word = power_of_present_10_power;
        power_10 = power_delay_10_delayed;
        power_decoder_11_mantissa = blue_3;
        decoded_11_clock = clock;
        decoded_11_d = power_decoder_11_power;
        power_of_present_11_absent = presence_3_absent;
        power_of_present_11_word = decoded_11_q;
        power_delay_11_clock = clock;
        power_delay_11_word = power_of_present_11_power;
        power_11 = power_delay_11_delayed;
        first_delay_clock = clock;
        first_delay_clear = reset;
        first_delay_flag = first_in;
        first = first_delay_delayed;
        last_delay_clock = clock;
        last_delay_clear = reset;
        last_delay_flag = last_in;
        last = last_delay_delayed;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_19(d, q, clock);
    // Module arguments
    input wire [18:0] d;
    output reg [18:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 19'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_group_words(clock, present_0, present_1, present_2, present_3, x_0, x_1,
    x_2, x_3, y_0, y_1, y_2, y_3, z_0, z_1, z_2, z_3, red_0, red_1, red_2, red_3, green_0,
    green_1, green_2, green_3, blue_0, blue_1, blue_2, blue_3, write, write_bank, write_place,
    read, read_bank, read_place, write_present_0, write_present_1, write_present_2,
    write_present_3, write_x_0, write_x_1, write_x_2, write_x_3, write_y_0, write_y_1, write_y_2,
    write_y_3, write_z_0, write_z_1, write_z_2, write_z_3, word_present_0, word_present_1,
    word_present_2, word_present_3, word_x_0, word_x_1, word_x_2, word_x_3, word_y_0, word_y_1,
    word_y_2, word_y_3, word_z_0, word_z_1, word_z_2, word_z_3, word_red_0, word_red_1,
    word_red_2, word_red_3, word_green_0, word_green_1, word_green_2, word_green_3, word_blue_0,
    word_blue_1, word_blue_2, word_blue_3);
    // Module arguments
    input wire clock;
    input wire present_0;
    input wire present_1;
    input wire present_2;
    input wire present_3;
    input wire [8:0] x_0;
    input wire [8:0] x_1;
    input wire [8:0] x_2;
    input wire [8:0] x_3;
    input wire [8:0] y_0;
    input wire [8:0] y_1;
    input wire [8:0] y_2;
    input wire [8:0] y_3;
    input wire [8:0] z_0;
    input wire [8:0] z_1;
    input wire [8:0] z_2;
    input wire [8:0] z_3;
    input wire [5:0] red_0;
    input wire [5:0] red_1;
    input wire [5:0] red_2;
    input wire [5:0] red_3;
    input wire [5:0] green_0;
    input wire [5:0] green_1;
    input wire [5:0] green_2;
    input wire [5:0] green_3;
    input wire [5:0] blue_0;
    input wire [5:0] blue_1;
    input wire [5:0] blue_2;
    input wire [5:0] blue_3;
    input wire write;
    input wire write_bank;
    input wire [3:0] write_place;
    input wire read;
    input wire read_bank;
    input wire [3:0] read_place;
    output reg write_present_0;
    output reg write_present_1;
    output reg write_present_2;
    output reg write_present_3;
    output reg [8:0] write_x_0;
    output reg [8:0] write_x_1;
    output reg [8:0] write_x_2;
    output reg [8:0] write_x_3;
    output reg [8:0] write_y_0;
    output reg [8:0] write_y_1;
    output reg [8:0] write_y_2;
    output reg [8:0] write_y_3;
    output reg [8:0] write_z_0;
    output reg [8:0] write_z_1;
    output reg [8:0] write_z_2;
    output reg [8:0] write_z_3;
    output reg word_present_0;
    output reg word_present_1;
    output reg word_present_2;
    output reg word_present_3;
    output reg [8:0] word_x_0;
    output reg [8:0] word_x_1;
    output reg [8:0] word_x_2;
    output reg [8:0] word_x_3;
    output reg [8:0] word_y_0;
    output reg [8:0] word_y_1;
    output reg [8:0] word_y_2;
    output reg [8:0] word_y_3;
    output reg [8:0] word_z_0;
    output reg [8:0] word_z_1;
    output reg [8:0] word_z_2;
    output reg [8:0] word_z_3;
    output reg [5:0] word_red_0;
    output reg [5:0] word_red_1;
    output reg [5:0] word_red_2;
    output reg [5:0] word_red_3;
    output reg [5:0] word_green_0;
    output reg [5:0] word_green_1;
    output reg [5:0] word_green_2;
    output reg [5:0] word_green_3;
    output reg [5:0] word_blue_0;
    output reg [5:0] word_blue_1;
    output reg [5:0] word_blue_2;
    output reg [5:0] word_blue_3;
    // Update code (custom)
    (* no_rw_check *) reg [183:0] groups [0:31];
    reg [183:0] write_word = 184'd0;
    reg [183:0] read_word = 184'd0;
    reg [183:0] word = 184'd0;
    wire [183:0] group = {blue_3, green_3, red_3, z_3, y_3, x_3, present_3, blue_2, green_2, red_2, z_2, y_2, x_2, present_2, blue_1, green_1, red_1, z_1, y_1, x_1, present_1, blue_0, green_0, red_0, z_0, y_0, x_0, present_0};
    wire [4:0] write_address = {write_bank, write_place};
    wire [4:0] read_address = {read_bank, read_place};
    always @(posedge clock) begin
      if (read) read_word <= groups[read_address];
      word <= read_word;
      write_word <= group;
      if (write) groups[write_address] <= write_word;
    end
    wire [0:0] of_write_present_0 = write_word[0:0];
    wire [0:0] of_read_present_0 = read_word[0:0];
    wire [0:0] of_word_present_0 = word[0:0];
    always @(*) word_present_0 = of_word_present_0;
    always @(*) write_present_0 = of_write_present_0;
    wire [8:0] of_write_x_0 = write_word[9:1];
    wire [8:0] of_read_x_0 = read_word[9:1];
    wire [8:0] of_word_x_0 = word[9:1];
    always @(*) word_x_0 = of_word_x_0;
    always @(*) write_x_0 = of_write_x_0;
    wire [8:0] of_write_y_0 = write_word[18:10];
    wire [8:0] of_read_y_0 = read_word[18:10];
    wire [8:0] of_word_y_0 = word[18:10];
    always @(*) word_y_0 = of_word_y_0;
    always @(*) write_y_0 = of_write_y_0;
    wire [8:0] of_write_z_0 = write_word[27:19];
    wire [8:0] of_read_z_0 = read_word[27:19];
    wire [8:0] of_word_z_0 = word[27:19];
    always @(*) word_z_0 = of_word_z_0;
    always @(*) write_z_0 = of_write_z_0;
    wire [5:0] of_write_red_0 = write_word[33:28];
    wire [5:0] of_read_red_0 = read_word[33:28];
    wire [5:0] of_word_red_0 = word[33:28];
    always @(*) word_red_0 = of_word_red_0;
    wire [5:0] of_write_green_0 = write_word[39:34];
    wire [5:0] of_read_green_0 = read_word[39:34];
    wire [5:0] of_word_green_0 = word[39:34];
    always @(*) word_green_0 = of_word_green_0;
    wire [5:0] of_write_blue_0 = write_word[45:40];
    wire [5:0] of_read_blue_0 = read_word[45:40];
    wire [5:0] of_word_blue_0 = word[45:40];
    always @(*) word_blue_0 = of_word_blue_0;
    wire [0:0] of_write_present_1 = write_word[46:46];
    wire [0:0] of_read_present_1 = read_word[46:46];
    wire [0:0] of_word_present_1 = word[46:46];
    always @(*) word_present_1 = of_word_present_1;
    always @(*) write_present_1 = of_write_present_1;
    wire [8:0] of_write_x_1 = write_word[55:47];
    wire [8:0] of_read_x_1 = read_word[55:47];
    wire [8:0] of_word_x_1 = word[55:47];
    always @(*) word_x_1 = of_word_x_1;
    always @(*) write_x_1 = of_write_x_1;
    wire [8:0] of_write_y_1 = write_word[64:56];
    wire [8:0] of_read_y_1 = read_word[64:56];
    wire [8:0] of_word_y_1 = word[64:56];
    always @(*) word_y_1 = of_word_y_1;
    always @(*) write_y_1 = of_write_y_1;
    wire [8:0] of_write_z_1 = write_word[73:65];
    wire [8:0] of_read_z_1 = read_word[73:65];
    wire [8:0] of_word_z_1 = word[73:65];
    always @(*) word_z_1 = of_word_z_1;
    always @(*) write_z_1 = of_write_z_1;
    wire [5:0] of_write_red_1 = write_word[79:74];
    wire [5:0] of_read_red_1 = read_word[79:74];
    wire [5:0] of_word_red_1 = word[79:74];
    always @(*) word_red_1 = of_word_red_1;
    wire [5:0] of_write_green_1 = write_word[85:80];
    wire [5:0] of_read_green_1 = read_word[85:80];
    wire [5:0] of_word_green_1 = word[85:80];
    always @(*) word_green_1 = of_word_green_1;
    wire [5:0] of_write_blue_1 = write_word[91:86];
    wire [5:0] of_read_blue_1 = read_word[91:86];
    wire [5:0] of_word_blue_1 = word[91:86];
    always @(*) word_blue_1 = of_word_blue_1;
    wire [0:0] of_write_present_2 = write_word[92:92];
    wire [0:0] of_read_present_2 = read_word[92:92];
    wire [0:0] of_word_present_2 = word[92:92];
    always @(*) word_present_2 = of_word_present_2;
    always @(*) write_present_2 = of_write_present_2;
    wire [8:0] of_write_x_2 = write_word[101:93];
    wire [8:0] of_read_x_2 = read_word[101:93];
    wire [8:0] of_word_x_2 = word[101:93];
    always @(*) word_x_2 = of_word_x_2;
    always @(*) write_x_2 = of_write_x_2;
    wire [8:0] of_write_y_2 = write_word[110:102];
    wire [8:0] of_read_y_2 = read_word[110:102];
    wire [8:0] of_word_y_2 = word[110:102];
    always @(*) word_y_2 = of_word_y_2;
    always @(*) write_y_2 = of_write_y_2;
    wire [8:0] of_write_z_2 = write_word[119:111];
    wire [8:0] of_read_z_2 = read_word[119:111];
    wire [8:0] of_word_z_2 = word[119:111];
    always @(*) word_z_2 = of_word_z_2;
    always @(*) write_z_2 = of_write_z_2;
    wire [5:0] of_write_red_2 = write_word[125:120];
    wire [5:0] of_read_red_2 = read_word[125:120];
    wire [5:0] of_word_red_2 = word[125:120];
    always @(*) word_red_2 = of_word_red_2;
    wire [5:0] of_write_green_2 = write_word[131:126];
    wire [5:0] of_read_green_2 = read_word[131:126];
    wire [5:0] of_word_green_2 = word[131:126];
    always @(*) word_green_2 = of_word_green_2;
    wire [5:0] of_write_blue_2 = write_word[137:132];
    wire [5:0] of_read_blue_2 = read_word[137:132];
    wire [5:0] of_word_blue_2 = word[137:132];
    always @(*) word_blue_2 = of_word_blue_2;
    wire [0:0] of_write_present_3 = write_word[138:138];
    wire [0:0] of_read_present_3 = read_word[138:138];
    wire [0:0] of_word_present_3 = word[138:138];
    always @(*) word_present_3 = of_word_present_3;
    always @(*) write_present_3 = of_write_present_3;
    wire [8:0] of_write_x_3 = write_word[147:139];
    wire [8:0] of_read_x_3 = read_word[147:139];
    wire [8:0] of_word_x_3 = word[147:139];
    always @(*) word_x_3 = of_word_x_3;
    always @(*) write_x_3 = of_write_x_3;
    wire [8:0] of_write_y_3 = write_word[156:148];
    wire [8:0] of_read_y_3 = read_word[156:148];
    wire [8:0] of_word_y_3 = word[156:148];
    always @(*) word_y_3 = of_word_y_3;
    always @(*) write_y_3 = of_write_y_3;
    wire [8:0] of_write_z_3 = write_word[165:157];
    wire [8:0] of_read_z_3 = read_word[165:157];
    wire [8:0] of_word_z_3 = word[165:157];
    always @(*) word_z_3 = of_word_z_3;
    always @(*) write_z_3 = of_write_z_3;
    wire [5:0] of_write_red_3 = write_word[171:166];
    wire [5:0] of_read_red_3 = read_word[171:166];
    wire [5:0] of_word_red_3 = word[171:166];
    always @(*) word_red_3 = of_word_red_3;
    wire [5:0] of_write_green_3 = write_word[177:172];
    wire [5:0] of_read_green_3 = read_word[177:172];
    wire [5:0] of_word_green_3 = word[177:172];
    always @(*) word_green_3 = of_word_green_3;
    wire [5:0] of_write_blue_3 = write_word[183:178];
    wire [5:0] of_read_blue_3 = read_word[183:178];
    wire [5:0] of_word_blue_3 = word[183:178];
    always @(*) word_blue_3 = of_word_blue_3;
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_tag_ram(clock, write, write_place, write_word, read_place,
    read_word);
    // Module arguments
    input wire clock;
    input wire write;
    input wire [4:0] write_place;
    input wire [18:0] write_word;
    input wire [4:0] read_place;
    output reg [18:0] read_word;
    // Update code (custom)
    reg [18:0] words [0:31];
    integer place;
    initial for (place = 0; place <= 31; place = place + 1) words[place] = 19'd0;
    wire [18:0] read = words[read_place];
    always @(*) read_word = read;
    always @(posedge clock) if (write) words[write_place] <= write_word;
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_token_place(fills, query, filler, token);
    // Module arguments
    input wire fills;
    input wire [8:0] query;
    input wire [8:0] filler;
    output reg [8:0] token;
    // Update code
    always @(*) begin
        token = query;
        if (fills) begin
            token = filler;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_gap(query_low, query_high, group_low, group_high, difference);
    // Module arguments
    input wire [8:0] query_low;
    input wire [8:0] query_high;
    input wire [8:0] group_low;
    input wire [8:0] group_high;
    output reg [9:0] difference;
    // Stub signals
    reg [8:0] subtract_0_a;
    reg [8:0] subtract_0_b;
    wire [9:0] subtract_0_difference;
    reg [8:0] subtract_1_a;
    reg [8:0] subtract_1_b;
    wire [9:0] subtract_1_difference;
    reg [9:0] nearest_above;
    reg [9:0] nearest_below;
    wire [9:0] nearest_difference;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_subtract subtract_0(
        .a(subtract_0_a),
        .b(subtract_0_b),
        .difference(subtract_0_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_subtract subtract_1(
        .a(subtract_1_a),
        .b(subtract_1_b),
        .difference(subtract_1_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_nearest nearest(
        .above(nearest_above),
        .below(nearest_below),
        .difference(nearest_difference)
    );
    // Update code
    always @(*) begin
        subtract_0_a = query_high;
        subtract_0_b = group_low;
        subtract_1_a = query_low;
        subtract_1_b = group_high;
        nearest_above = subtract_0_difference;
        nearest_below = subtract_1_difference;
        difference = nearest_difference;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_unless_blank(blank, word, present);
    // Module arguments
    input wire blank;
    input wire word;
    output reg present;
    // Update code
    always @(*) begin
        present = word;
        if (blank) begin
            present = 32'h0;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_pair_ram(clock, write, write_place, write_word, read_place,
    read_word);
    // Module arguments
    input wire clock;
    input wire write;
    input wire [1:0] write_place;
    input wire [1:0] write_word;
    input wire [1:0] read_place;
    output reg [1:0] read_word;
    // Update code (custom)
    reg [1:0] words [0:3];
    integer place;
    initial for (place = 0; place <= 3; place = place + 1) words[place] = 2'd0;
    wire [1:0] read = words[read_place];
    always @(*) read_word = read;
    always @(posedge clock) if (write) words[write_place] <= write_word;
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_mask_ram(clock, write, write_place, write_word, read_place,
    read_word);
    // Module arguments
    input wire clock;
    input wire write;
    input wire [1:0] write_place;
    input wire [3:0] write_word;
    input wire [1:0] read_place;
    output reg [3:0] read_word;
    // Update code (custom)
    reg [3:0] words [0:3];
    integer place;
    initial for (place = 0; place <= 3; place = place + 1) words[place] = 4'd0;
    wire [3:0] read = words[read_place];
    always @(*) read_word = read;
    always @(posedge clock) if (write) words[write_place] <= write_word;
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_flag_ram(clock, write, write_place, write_word, read_place,
    read_word);
    // Module arguments
    input wire clock;
    input wire write;
    input wire [1:0] write_place;
    input wire [2:0] write_word;
    input wire [1:0] read_place;
    output reg [2:0] read_word;
    // Update code (custom)
    reg [2:0] words [0:3];
    integer place;
    initial for (place = 0; place <= 3; place = place + 1) words[place] = 3'd0;
    wire [2:0] read = words[read_place];
    always @(*) read_word = read;
    always @(posedge clock) if (write) words[write_place] <= write_word;
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_query_border(clock, comes, first, low_in, high_in, low_out, high_out);
    // Module arguments
    input wire clock;
    input wire comes;
    input wire first;
    input wire [8:0] low_in;
    input wire [8:0] high_in;
    output reg [8:0] low_out;
    output reg [8:0] high_out;
    // Stub signals
    reg [8:0] low_d;
    wire [8:0] low_q;
    reg low_clock;
    reg [8:0] high_d;
    wire [8:0] high_q;
    reg high_clock;
    // Local signals
    reg is_lower;
    reg is_higher;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_9 low(
        .d(low_d),
        .q(low_q),
        .clock(low_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 high(
        .d(high_d),
        .q(high_q),
        .clock(high_clock)
    );
    // Update code
    always @(*) begin
        low_clock = clock;
        high_clock = clock;
        low_d = low_q;
        high_d = high_q;
        is_lower = low_in < low_q;
        is_higher = high_in > high_q;
        if (comes & (first | is_lower)) begin
            low_d = low_in;
        end
        if (comes & (first | is_higher)) begin
            high_d = high_in;
        end
        low_out = low_q;
        high_out = high_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_leaf(clock, facings, facing, is_there, gathered);
    // Module arguments
    input wire clock;
    input wire [31:0] facings;
    input wire [4:0] facing;
    input wire is_there;
    output reg gathered;
    // Constant declarations
    localparam first_bits = 5'b11100;
    // Stub signals
    reg [3:0] near_d;
    wire [3:0] near_q;
    reg near_clock;
    reg [1:0] number_d;
    wire [1:0] number_q;
    reg number_clock;
    // Local signals
    reg [4:0] first;
    reg [31:0] from_first;
    reg [3:0] from_own;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_4 near(
        .d(near_d),
        .q(near_q),
        .clock(near_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_2 number(
        .d(number_d),
        .q(number_q),
        .clock(number_clock)
    );
    // Update code
    always @(*) begin
        near_clock = clock;
        number_clock = clock;
        near_d = near_q;
        number_d = number_q;
        first = facing & first_bits;
        from_first = facings >> first;
        near_d = 32'h0;
        if (is_there) begin
            near_d = from_first[(32'h0)+:(4)];
        end
        number_d = facing[(32'h0)+:(2)];
        from_own = near_q >> number_q;
        gathered = from_own[32'h0];
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_engine_2(clock, reset_in, token_valid_in, token_in_0, token_in_1,
    token_in_2, swap_in, photon_in_0, photon_in_1, photon_in_2, photon_in_3, photon_in_4,
    photon_in_5, photon_in_6, photon_in_7, photon_in_8, photon_in_9, photon_in_10, photon_in_11,
    power_in_0, power_in_1, power_in_2, power_in_3, power_in_4, power_in_5, power_in_6,
    power_in_7, power_in_8, power_in_9, power_in_10, power_in_11, present_in_0, present_in_1,
    present_in_2, present_in_3, first_in, last_in, result_valid_in, result_in_0, result_in_1,
    result_in_2, result_count_in, reset_out, token_valid_out, token_out_0, token_out_1,
    token_out_2, swap_out, photon_out_0, photon_out_1, photon_out_2, photon_out_3, photon_out_4,
    photon_out_5, photon_out_6, photon_out_7, photon_out_8, photon_out_9, photon_out_10,
    photon_out_11, power_out_0, power_out_1, power_out_2, power_out_3, power_out_4, power_out_5,
    power_out_6, power_out_7, power_out_8, power_out_9, power_out_10, power_out_11,
    present_out_0, present_out_1, present_out_2, present_out_3, first_out, last_out,
    result_valid_out, result_out_0, result_out_1, result_out_2, result_count_out);
    // Module arguments
    input wire clock;
    input wire reset_in;
    input wire token_valid_in;
    input wire [8:0] token_in_0;
    input wire [8:0] token_in_1;
    input wire [8:0] token_in_2;
    input wire swap_in;
    input wire [8:0] photon_in_0;
    input wire [8:0] photon_in_1;
    input wire [8:0] photon_in_2;
    input wire [8:0] photon_in_3;
    input wire [8:0] photon_in_4;
    input wire [8:0] photon_in_5;
    input wire [8:0] photon_in_6;
    input wire [8:0] photon_in_7;
    input wire [8:0] photon_in_8;
    input wire [8:0] photon_in_9;
    input wire [8:0] photon_in_10;
    input wire [8:0] photon_in_11;
    input wire [5:0] power_in_0;
    input wire [5:0] power_in_1;
    input wire [5:0] power_in_2;
    input wire [5:0] power_in_3;
    input wire [5:0] power_in_4;
    input wire [5:0] power_in_5;
    input wire [5:0] power_in_6;
    input wire [5:0] power_in_7;
    input wire [5:0] power_in_8;
    input wire [5:0] power_in_9;
    input wire [5:0] power_in_10;
    input wire [5:0] power_in_11;
    input wire present_in_0;
    input wire present_in_1;
    input wire present_in_2;
    input wire present_in_3;
    input wire first_in;
    input wire last_in;
    input wire result_valid_in;
    input wire [11:0] result_in_0;
    input wire [11:0] result_in_1;
    input wire [11:0] result_in_2;
    input wire [6:0] result_count_in;
    output reg reset_out;
    output reg token_valid_out;
    output reg [8:0] token_out_0;
    output reg [8:0] token_out_1;
    output reg [8:0] token_out_2;
    output reg swap_out;
    output reg [8:0] photon_out_0;
    output reg [8:0] photon_out_1;
    output reg [8:0] photon_out_2;
    output reg [8:0] photon_out_3;
    output reg [8:0] photon_out_4;
    output reg [8:0] photon_out_5;
    output reg [8:0] photon_out_6;
    output reg [8:0] photon_out_7;
    output reg [8:0] photon_out_8;
    output reg [8:0] photon_out_9;
    output reg [8:0] photon_out_10;
    output reg [8:0] photon_out_11;
    output reg [5:0] power_out_0;
    output reg [5:0] power_out_1;
    output reg [5:0] power_out_2;
    output reg [5:0] power_out_3;
    output reg [5:0] power_out_4;
    output reg [5:0] power_out_5;
    output reg [5:0] power_out_6;
    output reg [5:0] power_out_7;
    output reg [5:0] power_out_8;
    output reg [5:0] power_out_9;
    output reg [5:0] power_out_10;
    output reg [5:0] power_out_11;
    output reg present_out_0;
    output reg present_out_1;
    output reg present_out_2;
    output reg present_out_3;
    output reg first_out;
    output reg last_out;
    output reg result_valid_out;
    output reg [11:0] result_out_0;
    output reg [11:0] result_out_1;
    output reg [11:0] result_out_2;
    output reg [6:0] result_count_out;
    // Stub signals
    reg query_flags_clock;
    reg query_flags_reset_in;
    reg query_flags_token_valid_in;
    reg query_flags_swap_in;
    wire query_flags_keeps;
    wire query_flags_reset_out;
    wire query_flags_token_valid_out;
    wire query_flags_swap_out;
    reg query_0_clock;
    reg [8:0] query_0_token_in;
    reg query_0_keeps;
    reg query_0_swap_in;
    wire [8:0] query_0_token_out;
    wire [8:0] query_0_query_out;
    reg query_1_clock;
    reg [8:0] query_1_token_in;
    reg query_1_keeps;
    reg query_1_swap_in;
    wire [8:0] query_1_token_out;
    wire [8:0] query_1_query_out;
    reg query_2_clock;
    reg [8:0] query_2_token_in;
    reg query_2_keeps;
    reg query_2_swap_in;
    wire [8:0] query_2_token_out;
    wire [8:0] query_2_query_out;
    reg [8:0] photon_0_d;
    wire [8:0] photon_0_q;
    reg photon_0_clock;
    reg [8:0] photon_1_d;
    wire [8:0] photon_1_q;
    reg photon_1_clock;
    reg [8:0] photon_2_d;
    wire [8:0] photon_2_q;
    reg photon_2_clock;
    reg [8:0] photon_3_d;
    wire [8:0] photon_3_q;
    reg photon_3_clock;
    reg [8:0] photon_4_d;
    wire [8:0] photon_4_q;
    reg photon_4_clock;
    reg [8:0] photon_5_d;
    wire [8:0] photon_5_q;
    reg photon_5_clock;
    reg [8:0] photon_6_d;
    wire [8:0] photon_6_q;
    reg photon_6_clock;
    reg [8:0] photon_7_d;
    wire [8:0] photon_7_q;
    reg photon_7_clock;
    reg [8:0] photon_8_d;
    wire [8:0] photon_8_q;
    reg photon_8_clock;
    reg [8:0] photon_9_d;
    wire [8:0] photon_9_q;
    reg photon_9_clock;
    reg [8:0] photon_10_d;
    wire [8:0] photon_10_q;
    reg photon_10_clock;
    reg [8:0] photon_11_d;
    wire [8:0] photon_11_q;
    reg photon_11_clock;
    reg square_pair_0_clock;
    reg [8:0] square_pair_0_query;
    reg [8:0] square_pair_0_photon_a;
    reg [8:0] square_pair_0_photon_b;
    wire [13:0] square_pair_0_square_a;
    wire [13:0] square_pair_0_square_b;
    wire square_pair_0_far_a;
    wire square_pair_0_far_b;
    reg square_pair_1_clock;
    reg [8:0] square_pair_1_query;
    reg [8:0] square_pair_1_photon_a;
    reg [8:0] square_pair_1_photon_b;
    wire [13:0] square_pair_1_square_a;
    wire [13:0] square_pair_1_square_b;
    wire square_pair_1_far_a;
    wire square_pair_1_far_b;
    reg square_pair_2_clock;
    reg [8:0] square_pair_2_query;
    reg [8:0] square_pair_2_photon_a;
    reg [8:0] square_pair_2_photon_b;
    wire [13:0] square_pair_2_square_a;
    wire [13:0] square_pair_2_square_b;
    wire square_pair_2_far_a;
    wire square_pair_2_far_b;
    reg square_pair_3_clock;
    reg [8:0] square_pair_3_query;
    reg [8:0] square_pair_3_photon_a;
    reg [8:0] square_pair_3_photon_b;
    wire [13:0] square_pair_3_square_a;
    wire [13:0] square_pair_3_square_b;
    wire square_pair_3_far_a;
    wire square_pair_3_far_b;
    reg square_pair_4_clock;
    reg [8:0] square_pair_4_query;
    reg [8:0] square_pair_4_photon_a;
    reg [8:0] square_pair_4_photon_b;
    wire [13:0] square_pair_4_square_a;
    wire [13:0] square_pair_4_square_b;
    wire square_pair_4_far_a;
    wire square_pair_4_far_b;
    reg square_pair_5_clock;
    reg [8:0] square_pair_5_query;
    reg [8:0] square_pair_5_photon_a;
    reg [8:0] square_pair_5_photon_b;
    wire [13:0] square_pair_5_square_a;
    wire [13:0] square_pair_5_square_b;
    wire square_pair_5_far_a;
    wire square_pair_5_far_b;
    reg lane_0_clock;
    reg [13:0] lane_0_axis_square_0;
    reg [13:0] lane_0_axis_square_1;
    reg [13:0] lane_0_axis_square_2;
    reg lane_0_axis_far_0;
    reg lane_0_axis_far_1;
    reg lane_0_axis_far_2;
    wire lane_0_photon_in_range;
    reg lane_1_clock;
    reg [13:0] lane_1_axis_square_0;
    reg [13:0] lane_1_axis_square_1;
    reg [13:0] lane_1_axis_square_2;
    reg lane_1_axis_far_0;
    reg lane_1_axis_far_1;
    reg lane_1_axis_far_2;
    wire lane_1_photon_in_range;
    reg lane_2_clock;
    reg [13:0] lane_2_axis_square_0;
    reg [13:0] lane_2_axis_square_1;
    reg [13:0] lane_2_axis_square_2;
    reg lane_2_axis_far_0;
    reg lane_2_axis_far_1;
    reg lane_2_axis_far_2;
    wire lane_2_photon_in_range;
    reg lane_3_clock;
    reg [13:0] lane_3_axis_square_0;
    reg [13:0] lane_3_axis_square_1;
    reg [13:0] lane_3_axis_square_2;
    reg lane_3_axis_far_0;
    reg lane_3_axis_far_1;
    reg lane_3_axis_far_2;
    wire lane_3_photon_in_range;
    reg group_flags_clock;
    reg group_flags_reset_in;
    reg group_flags_reset;
    reg group_flags_first_in;
    reg group_flags_last_in;
    reg group_flags_result_valid_in;
    wire group_flags_first_out;
    wire group_flags_last_out;
    wire group_flags_replace;
    wire group_flags_sums_done;
    wire group_flags_result_valid_out;
    reg channel_sum_0_clock;
    reg [5:0] channel_sum_0_power_in_0;
    reg [5:0] channel_sum_0_power_in_1;
    reg [5:0] channel_sum_0_power_in_2;
    reg [5:0] channel_sum_0_power_in_3;
    wire [5:0] channel_sum_0_power_0;
    wire [5:0] channel_sum_0_power_1;
    wire [5:0] channel_sum_0_power_2;
    wire [5:0] channel_sum_0_power_3;
    reg channel_sum_0_in_range_0;
    reg channel_sum_0_in_range_1;
    reg channel_sum_0_in_range_2;
    reg channel_sum_0_in_range_3;
    reg channel_sum_0_first;
    reg channel_sum_0_done;
    reg [11:0] channel_sum_0_result_in;
    wire [11:0] channel_sum_0_result_out;
    reg channel_sum_1_clock;
    reg [5:0] channel_sum_1_power_in_0;
    reg [5:0] channel_sum_1_power_in_1;
    reg [5:0] channel_sum_1_power_in_2;
    reg [5:0] channel_sum_1_power_in_3;
    wire [5:0] channel_sum_1_power_0;
    wire [5:0] channel_sum_1_power_1;
    wire [5:0] channel_sum_1_power_2;
    wire [5:0] channel_sum_1_power_3;
    reg channel_sum_1_in_range_0;
    reg channel_sum_1_in_range_1;
    reg channel_sum_1_in_range_2;
    reg channel_sum_1_in_range_3;
    reg channel_sum_1_first;
    reg channel_sum_1_done;
    reg [11:0] channel_sum_1_result_in;
    wire [11:0] channel_sum_1_result_out;
    reg channel_sum_2_clock;
    reg [5:0] channel_sum_2_power_in_0;
    reg [5:0] channel_sum_2_power_in_1;
    reg [5:0] channel_sum_2_power_in_2;
    reg [5:0] channel_sum_2_power_in_3;
    wire [5:0] channel_sum_2_power_0;
    wire [5:0] channel_sum_2_power_1;
    wire [5:0] channel_sum_2_power_2;
    wire [5:0] channel_sum_2_power_3;
    reg channel_sum_2_in_range_0;
    reg channel_sum_2_in_range_1;
    reg channel_sum_2_in_range_2;
    reg channel_sum_2_in_range_3;
    reg channel_sum_2_first;
    reg channel_sum_2_done;
    reg [11:0] channel_sum_2_result_in;
    wire [11:0] channel_sum_2_result_out;
    reg count_sum_clock;
    reg count_sum_power_in_0;
    reg count_sum_power_in_1;
    reg count_sum_power_in_2;
    reg count_sum_power_in_3;
    wire count_sum_power_0;
    wire count_sum_power_1;
    wire count_sum_power_2;
    wire count_sum_power_3;
    reg count_sum_in_range_0;
    reg count_sum_in_range_1;
    reg count_sum_in_range_2;
    reg count_sum_in_range_3;
    reg count_sum_first;
    reg count_sum_done;
    reg [6:0] count_sum_result_in;
    wire [6:0] count_sum_result_out;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_query_flags query_flags(
        .clock(query_flags_clock),
        .reset_in(query_flags_reset_in),
        .token_valid_in(query_flags_token_valid_in),
        .swap_in(query_flags_swap_in),
        .keeps(query_flags_keeps),
        .reset_out(query_flags_reset_out),
        .token_valid_out(query_flags_token_valid_out),
        .swap_out(query_flags_swap_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query query_0(
        .clock(query_0_clock),
        .token_in(query_0_token_in),
        .keeps(query_0_keeps),
        .swap_in(query_0_swap_in),
        .token_out(query_0_token_out),
        .query_out(query_0_query_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query query_1(
        .clock(query_1_clock),
        .token_in(query_1_token_in),
        .keeps(query_1_keeps),
        .swap_in(query_1_swap_in),
        .token_out(query_1_token_out),
        .query_out(query_1_query_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query query_2(
        .clock(query_2_clock),
        .token_in(query_2_token_in),
        .keeps(query_2_keeps),
        .swap_in(query_2_swap_in),
        .token_out(query_2_token_out),
        .query_out(query_2_query_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_0(
        .d(photon_0_d),
        .q(photon_0_q),
        .clock(photon_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_1(
        .d(photon_1_d),
        .q(photon_1_q),
        .clock(photon_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_2(
        .d(photon_2_d),
        .q(photon_2_q),
        .clock(photon_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_3(
        .d(photon_3_d),
        .q(photon_3_q),
        .clock(photon_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_4(
        .d(photon_4_d),
        .q(photon_4_q),
        .clock(photon_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_5(
        .d(photon_5_d),
        .q(photon_5_q),
        .clock(photon_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_6(
        .d(photon_6_d),
        .q(photon_6_q),
        .clock(photon_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_7(
        .d(photon_7_d),
        .q(photon_7_q),
        .clock(photon_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_8(
        .d(photon_8_d),
        .q(photon_8_q),
        .clock(photon_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_9(
        .d(photon_9_d),
        .q(photon_9_q),
        .clock(photon_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_10(
        .d(photon_10_d),
        .q(photon_10_q),
        .clock(photon_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_11(
        .d(photon_11_d),
        .q(photon_11_q),
        .clock(photon_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair_2 square_pair_0(
        .clock(square_pair_0_clock),
        .query(square_pair_0_query),
        .photon_a(square_pair_0_photon_a),
        .photon_b(square_pair_0_photon_b),
        .square_a(square_pair_0_square_a),
        .square_b(square_pair_0_square_b),
        .far_a(square_pair_0_far_a),
        .far_b(square_pair_0_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair_2 square_pair_1(
        .clock(square_pair_1_clock),
        .query(square_pair_1_query),
        .photon_a(square_pair_1_photon_a),
        .photon_b(square_pair_1_photon_b),
        .square_a(square_pair_1_square_a),
        .square_b(square_pair_1_square_b),
        .far_a(square_pair_1_far_a),
        .far_b(square_pair_1_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair_2 square_pair_2(
        .clock(square_pair_2_clock),
        .query(square_pair_2_query),
        .photon_a(square_pair_2_photon_a),
        .photon_b(square_pair_2_photon_b),
        .square_a(square_pair_2_square_a),
        .square_b(square_pair_2_square_b),
        .far_a(square_pair_2_far_a),
        .far_b(square_pair_2_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair_2 square_pair_3(
        .clock(square_pair_3_clock),
        .query(square_pair_3_query),
        .photon_a(square_pair_3_photon_a),
        .photon_b(square_pair_3_photon_b),
        .square_a(square_pair_3_square_a),
        .square_b(square_pair_3_square_b),
        .far_a(square_pair_3_far_a),
        .far_b(square_pair_3_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair_2 square_pair_4(
        .clock(square_pair_4_clock),
        .query(square_pair_4_query),
        .photon_a(square_pair_4_photon_a),
        .photon_b(square_pair_4_photon_b),
        .square_a(square_pair_4_square_a),
        .square_b(square_pair_4_square_b),
        .far_a(square_pair_4_far_a),
        .far_b(square_pair_4_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair_2 square_pair_5(
        .clock(square_pair_5_clock),
        .query(square_pair_5_query),
        .photon_a(square_pair_5_photon_a),
        .photon_b(square_pair_5_photon_b),
        .square_a(square_pair_5_square_a),
        .square_b(square_pair_5_square_b),
        .far_a(square_pair_5_far_a),
        .far_b(square_pair_5_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane_2 lane_0(
        .clock(lane_0_clock),
        .axis_square_0(lane_0_axis_square_0),
        .axis_square_1(lane_0_axis_square_1),
        .axis_square_2(lane_0_axis_square_2),
        .axis_far_0(lane_0_axis_far_0),
        .axis_far_1(lane_0_axis_far_1),
        .axis_far_2(lane_0_axis_far_2),
        .photon_in_range(lane_0_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane_2 lane_1(
        .clock(lane_1_clock),
        .axis_square_0(lane_1_axis_square_0),
        .axis_square_1(lane_1_axis_square_1),
        .axis_square_2(lane_1_axis_square_2),
        .axis_far_0(lane_1_axis_far_0),
        .axis_far_1(lane_1_axis_far_1),
        .axis_far_2(lane_1_axis_far_2),
        .photon_in_range(lane_1_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane_2 lane_2(
        .clock(lane_2_clock),
        .axis_square_0(lane_2_axis_square_0),
        .axis_square_1(lane_2_axis_square_1),
        .axis_square_2(lane_2_axis_square_2),
        .axis_far_0(lane_2_axis_far_0),
        .axis_far_1(lane_2_axis_far_1),
        .axis_far_2(lane_2_axis_far_2),
        .photon_in_range(lane_2_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane_2 lane_3(
        .clock(lane_3_clock),
        .axis_square_0(lane_3_axis_square_0),
        .axis_square_1(lane_3_axis_square_1),
        .axis_square_2(lane_3_axis_square_2),
        .axis_far_0(lane_3_axis_far_0),
        .axis_far_1(lane_3_axis_far_1),
        .axis_far_2(lane_3_axis_far_2),
        .photon_in_range(lane_3_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_flags group_flags(
        .clock(group_flags_clock),
        .reset_in(group_flags_reset_in),
        .reset(group_flags_reset),
        .first_in(group_flags_first_in),
        .last_in(group_flags_last_in),
        .result_valid_in(group_flags_result_valid_in),
        .first_out(group_flags_first_out),
        .last_out(group_flags_last_out),
        .replace(group_flags_replace),
        .sums_done(group_flags_sums_done),
        .result_valid_out(group_flags_result_valid_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_channel_sum channel_sum_0(
        .clock(channel_sum_0_clock),
        .power_in_0(channel_sum_0_power_in_0),
        .power_in_1(channel_sum_0_power_in_1),
        .power_in_2(channel_sum_0_power_in_2),
        .power_in_3(channel_sum_0_power_in_3),
        .power_0(channel_sum_0_power_0),
        .power_1(channel_sum_0_power_1),
        .power_2(channel_sum_0_power_2),
        .power_3(channel_sum_0_power_3),
        .in_range_0(channel_sum_0_in_range_0),
        .in_range_1(channel_sum_0_in_range_1),
        .in_range_2(channel_sum_0_in_range_2),
        .in_range_3(channel_sum_0_in_range_3),
        .first(channel_sum_0_first),
        .done(channel_sum_0_done),
        .result_in(channel_sum_0_result_in),
        .result_out(channel_sum_0_result_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_channel_sum channel_sum_1(
        .clock(channel_sum_1_clock),
        .power_in_0(channel_sum_1_power_in_0),
        .power_in_1(channel_sum_1_power_in_1),
        .power_in_2(channel_sum_1_power_in_2),
        .power_in_3(channel_sum_1_power_in_3),
        .power_0(channel_sum_1_power_0),
        .power_1(channel_sum_1_power_1),
        .power_2(channel_sum_1_power_2),
        .power_3(channel_sum_1_power_3),
        .in_range_0(channel_sum_1_in_range_0),
        .in_range_1(channel_sum_1_in_range_1),
        .in_range_2(channel_sum_1_in_range_2),
        .in_range_3(channel_sum_1_in_range_3),
        .first(channel_sum_1_first),
        .done(channel_sum_1_done),
        .result_in(channel_sum_1_result_in),
        .result_out(channel_sum_1_result_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_channel_sum channel_sum_2(
        .clock(channel_sum_2_clock),
        .power_in_0(channel_sum_2_power_in_0),
        .power_in_1(channel_sum_2_power_in_1),
        .power_in_2(channel_sum_2_power_in_2),
        .power_in_3(channel_sum_2_power_in_3),
        .power_0(channel_sum_2_power_0),
        .power_1(channel_sum_2_power_1),
        .power_2(channel_sum_2_power_2),
        .power_3(channel_sum_2_power_3),
        .in_range_0(channel_sum_2_in_range_0),
        .in_range_1(channel_sum_2_in_range_1),
        .in_range_2(channel_sum_2_in_range_2),
        .in_range_3(channel_sum_2_in_range_3),
        .first(channel_sum_2_first),
        .done(channel_sum_2_done),
        .result_in(channel_sum_2_result_in),
        .result_out(channel_sum_2_result_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_count_sum count_sum(
        .clock(count_sum_clock),
        .power_in_0(count_sum_power_in_0),
        .power_in_1(count_sum_power_in_1),
        .power_in_2(count_sum_power_in_2),
        .power_in_3(count_sum_power_in_3),
        .power_0(count_sum_power_0),
        .power_1(count_sum_power_1),
        .power_2(count_sum_power_2),
        .power_3(count_sum_power_3),
        .in_range_0(count_sum_in_range_0),
        .in_range_1(count_sum_in_range_1),
        .in_range_2(count_sum_in_range_2),
        .in_range_3(count_sum_in_range_3),
        .first(count_sum_first),
        .done(count_sum_done),
        .result_in(count_sum_result_in),
        .result_out(count_sum_result_out)
    );
    // Update code
    always @(*) begin
        query_flags_clock = clock;
        query_flags_reset_in = reset_in;
        query_flags_token_valid_in = token_valid_in;
        query_flags_swap_in = swap_in;
        reset_out = query_flags_reset_out;
        token_valid_out = query_flags_token_valid_out;
        swap_out = query_flags_swap_out;
        query_0_clock = clock;
        query_0_keeps = query_flags_keeps;
        query_0_swap_in = swap_in;
        query_0_token_in = token_in_0;
        token_out_0 = query_0_token_out;
        query_1_clock = clock;
        query_1_keeps = query_flags_keeps;
        query_1_swap_in = swap_in;
        query_1_token_in = token_in_1;
        token_out_1 = query_1_token_out;
        query_2_clock = clock;
        query_2_keeps = query_flags_keeps;
        query_2_swap_in = swap_in;
        query_2_token_in = token_in_2;
        token_out_2 = query_2_token_out;
        photon_0_clock = clock;
        photon_0_d = photon_in_0;
        photon_out_0 = photon_0_q;
        photon_1_clock = clock;
        photon_1_d = photon_in_1;
        photon_out_1 = photon_1_q;
        photon_2_clock = clock;
        photon_2_d = photon_in_2;
        photon_out_2 = photon_2_q;
        photon_3_clock = clock;
        photon_3_d = photon_in_3;
        photon_out_3 = photon_3_q;
        photon_4_clock = clock;
        photon_4_d = photon_in_4;
        photon_out_4 = photon_4_q;
        photon_5_clock = clock;
        photon_5_d = photon_in_5;
        photon_out_5 = photon_5_q;
        photon_6_clock = clock;
        photon_6_d = photon_in_6;
        photon_out_6 = photon_6_q;
        photon_7_clock = clock;
        photon_7_d = photon_in_7;
        photon_out_7 = photon_7_q;
        photon_8_clock = clock;
        photon_8_d = photon_in_8;
        photon_out_8 = photon_8_q;
        photon_9_clock = clock;
        photon_9_d = photon_in_9;
        photon_out_9 = photon_9_q;
        photon_10_clock = clock;
        photon_10_d = photon_in_10;
        photon_out_10 = photon_10_q;
        photon_11_clock = clock;
        photon_11_d = photon_in_11;
        photon_out_11 = photon_11_q;
        square_pair_0_clock = clock;
        square_pair_0_query = query_0_query_out;
        square_pair_0_photon_a = photon_0_q;
        square_pair_0_photon_b = photon_3_q;
        lane_0_axis_square_0 = square_pair_0_square_a;
        lane_1_axis_square_0 = square_pair_0_square_b;
        lane_0_axis_far_0 = square_pair_0_far_a;
        lane_1_axis_far_0 = square_pair_0_far_b;
        square_pair_1_clock = clock;
        square_pair_1_query = query_1_query_out;
        square_pair_1_photon_a = photon_1_q;
        square_pair_1_photon_b = photon_4_q;
        lane_0_axis_square_1 = square_pair_1_square_a;
        lane_1_axis_square_1 = square_pair_1_square_b;
        lane_0_axis_far_1 = square_pair_1_far_a;
        lane_1_axis_far_1 = square_pair_1_far_b;
        square_pair_2_clock = clock;
        square_pair_2_query = query_2_query_out;
        square_pair_2_photon_a = photon_2_q;
        square_pair_2_photon_b = photon_5_q;
        lane_0_axis_square_2 = square_pair_2_square_a;
        lane_1_axis_square_2 = square_pair_2_square_b;
        lane_0_axis_far_2 = square_pair_2_far_a;
        lane_1_axis_far_2 = square_pair_2_far_b;
        square_pair_3_clock = clock;
        square_pair_3_query = query_0_query_out;
        square_pair_3_photon_a = photon_6_q;
        square_pair_3_photon_b = photon_9_q;
        lane_2_axis_square_0 = square_pair_3_square_a;
        lane_3_axis_square_0 = square_pair_3_square_b;
        lane_2_axis_far_0 = square_pair_3_far_a;
        lane_3_axis_far_0 = square_pair_3_far_b;
        square_pair_4_clock = clock;
        square_pair_4_query = query_1_query_out;
        square_pair_4_photon_a = photon_7_q;
        square_pair_4_photon_b = photon_10_q;
        lane_2_axis_square_1 = square_pair_4_square_a;
        lane_3_axis_square_1 = square_pair_4_square_b;
        lane_2_axis_far_1 = square_pair_4_far_a;
        lane_3_axis_far_1 = square_pair_4_far_b;
        square_pair_5_clock = clock;
        square_pair_5_query = query_2_query_out;
        square_pair_5_photon_a = photon_8_q;
        square_pair_5_photon_b = photon_11_q;
        lane_2_axis_square_2 = square_pair_5_square_a;
        lane_3_axis_square_2 = square_pair_5_square_b;
        lane_2_axis_far_2 = square_pair_5_far_a;
        lane_3_axis_far_2 = square_pair_5_far_b;
        lane_0_clock = clock;
        lane_1_clock = clock;
        lane_2_clock = clock;
        lane_3_clock = clock;
        group_flags_clock = clock;
        group_flags_reset_in = reset_in;
        group_flags_reset = query_flags_reset_out;
        group_flags_first_in = first_in;
        group_flags_last_in = last_in;
        group_flags_result_valid_in = result_valid_in;
        first_out = group_flags_first_out;
        last_out = group_flags_last_out;
        result_valid_out = group_flags_result_valid_out;
        count_sum_clock = clock;
        count_sum_first = group_flags_replace;
        count_sum_done = group_flags_sums_done;
        count_sum_result_in = result_count_in;
        result_count_out = count_sum_result_out;
        count_sum_power_in_0 = present_in_0;
        count_sum_in_range_0 = lane_0_photon_in_range;
        present_out_0 = count_sum_power_0;
        count_sum_power_in_1 = present_in_1;
        count_sum_in_range_1 = lane_1_photon_in_range;
        present_out_1 = count_sum_power_1;
        count_sum_power_in_2 = present_in_2;
        count_sum_in_range_2 = lane_2_photon_in_range;
        present_out_2 = count_sum_power_2;
        count_sum_power_in_3 = present_in_3;
        count_sum_in_range_3 = lane_3_photon_in_range;
        present_out_3 = count_sum_power_3;
        channel_sum_0_clock = clock;
        channel_sum_0_first = group_flags_replace;
        channel_sum_0_done = group_flags_sums_done;
        channel_sum_0_result_in = result_in_0;
        result_out_0 = channel_sum_0_result_out;
        channel_sum_0_power_in_0 = power_in_0;
        channel_sum_0_in_range_0 = lane_0_photon_in_range;
        power_out_0 = channel_sum_0_power_0;
        channel_sum_0_power_in_1 = power_in_3;
        channel_sum_0_in_range_1 = lane_1_photon_in_range;
        power_out_3 = channel_sum_0_power_1;
        channel_sum_0_power_in_2 = power_in_6;
        channel_sum_0_in_range_2 = lane_2_photon_in_range;
        power_out_6 = channel_sum_0_power_2;
        channel_sum_0_power_in_3 = power_in_9;
        channel_sum_0_in_range_3 = lane_3_photon_in_range;
        power_out_9 = channel_sum_0_power_3;
        channel_sum_1_clock = clock;
        channel_sum_1_first = group_flags_replace;
        channel_sum_1_done = group_flags_sums_done;
        channel_sum_1_result_in = result_in_1;
        result_out_1 = channel_sum_1_result_out;
        channel_sum_1_power_in_0 = power_in_1;
        channel_sum_1_in_range_0 = lane_0_photon_in_range;
        power_out_1 = channel_sum_1_power_0;
        channel_sum_1_power_in_1 = power_in_4;
        channel_sum_1_in_range_1 = lane_1_photon_in_range;
        power_out_4 = channel_sum_1_power_1;
        channel_sum_1_power_in_2 = power_in_7;
        channel_sum_1_in_range_2 = lane_2_photon_in_range;
        power_out_7 = channel_sum_1_power_2;
        channel_sum_1_power_in_3 = power_in_10;
        channel_sum_1_in_range_3 = lane_3_photon_in_range;
        power_out_10 = channel_sum_1_power_3;
        channel_sum_2_clock = clock;
        channel_sum_2_first = group_flags_replace;
        channel_sum_2_done = group_flags_sums_done;
        channel_sum_2_result_in = result_in_2;
        result_out_2 = channel_sum_2_result_out;
        channel_sum_2_power_in_0 = power_in_2;
        channel_sum_2_in_range_0 = lane_0_photon_in_range;
        power_out_2 = channel_sum_2_power_0;
        channel_sum_2_power_in_1 = power_in_5;
        channel_sum_2_in_range_1 = lane_1_photon_in_range;
        power_out_5 = channel_sum_2_power_1;
        channel_sum_2_power_in_2 = power_in_8;
        channel_sum_2_in_range_2 = lane_2_photon_in_range;
        power_out_8 = channel_sum_2_power_2;
        channel_sum_2_power_in_3 = power_in_11;
        channel_sum_2_in_range_3 = lane_3_photon_in_range;
        power_out_11 = channel_sum_2_power_3;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_engine(clock, reset_in, token_valid_in, token_in_0, token_in_1,
    token_in_2, swap_in, photon_in_0, photon_in_1, photon_in_2, photon_in_3, photon_in_4,
    photon_in_5, photon_in_6, photon_in_7, photon_in_8, photon_in_9, photon_in_10, photon_in_11,
    power_in_0, power_in_1, power_in_2, power_in_3, power_in_4, power_in_5, power_in_6,
    power_in_7, power_in_8, power_in_9, power_in_10, power_in_11, present_in_0, present_in_1,
    present_in_2, present_in_3, first_in, last_in, result_valid_in, result_in_0, result_in_1,
    result_in_2, result_count_in, reset_out, token_valid_out, token_out_0, token_out_1,
    token_out_2, swap_out, photon_out_0, photon_out_1, photon_out_2, photon_out_3, photon_out_4,
    photon_out_5, photon_out_6, photon_out_7, photon_out_8, photon_out_9, photon_out_10,
    photon_out_11, power_out_0, power_out_1, power_out_2, power_out_3, power_out_4, power_out_5,
    power_out_6, power_out_7, power_out_8, power_out_9, power_out_10, power_out_11,
    present_out_0, present_out_1, present_out_2, present_out_3, first_out, last_out,
    result_valid_out, result_out_0, result_out_1, result_out_2, result_count_out);
    // Module arguments
    input wire clock;
    input wire reset_in;
    input wire token_valid_in;
    input wire [8:0] token_in_0;
    input wire [8:0] token_in_1;
    input wire [8:0] token_in_2;
    input wire swap_in;
    input wire [8:0] photon_in_0;
    input wire [8:0] photon_in_1;
    input wire [8:0] photon_in_2;
    input wire [8:0] photon_in_3;
    input wire [8:0] photon_in_4;
    input wire [8:0] photon_in_5;
    input wire [8:0] photon_in_6;
    input wire [8:0] photon_in_7;
    input wire [8:0] photon_in_8;
    input wire [8:0] photon_in_9;
    input wire [8:0] photon_in_10;
    input wire [8:0] photon_in_11;
    input wire [5:0] power_in_0;
    input wire [5:0] power_in_1;
    input wire [5:0] power_in_2;
    input wire [5:0] power_in_3;
    input wire [5:0] power_in_4;
    input wire [5:0] power_in_5;
    input wire [5:0] power_in_6;
    input wire [5:0] power_in_7;
    input wire [5:0] power_in_8;
    input wire [5:0] power_in_9;
    input wire [5:0] power_in_10;
    input wire [5:0] power_in_11;
    input wire present_in_0;
    input wire present_in_1;
    input wire present_in_2;
    input wire present_in_3;
    input wire first_in;
    input wire last_in;
    input wire result_valid_in;
    input wire [11:0] result_in_0;
    input wire [11:0] result_in_1;
    input wire [11:0] result_in_2;
    input wire [6:0] result_count_in;
    output reg reset_out;
    output reg token_valid_out;
    output reg [8:0] token_out_0;
    output reg [8:0] token_out_1;
    output reg [8:0] token_out_2;
    output reg swap_out;
    output reg [8:0] photon_out_0;
    output reg [8:0] photon_out_1;
    output reg [8:0] photon_out_2;
    output reg [8:0] photon_out_3;
    output reg [8:0] photon_out_4;
    output reg [8:0] photon_out_5;
    output reg [8:0] photon_out_6;
    output reg [8:0] photon_out_7;
    output reg [8:0] photon_out_8;
    output reg [8:0] photon_out_9;
    output reg [8:0] photon_out_10;
    output reg [8:0] photon_out_11;
    output reg [5:0] power_out_0;
    output reg [5:0] power_out_1;
    output reg [5:0] power_out_2;
    output reg [5:0] power_out_3;
    output reg [5:0] power_out_4;
    output reg [5:0] power_out_5;
    output reg [5:0] power_out_6;
    output reg [5:0] power_out_7;
    output reg [5:0] power_out_8;
    output reg [5:0] power_out_9;
    output reg [5:0] power_out_10;
    output reg [5:0] power_out_11;
    output reg present_out_0;
    output reg present_out_1;
    output reg present_out_2;
    output reg present_out_3;
    output reg first_out;
    output reg last_out;
    output reg result_valid_out;
    output reg [11:0] result_out_0;
    output reg [11:0] result_out_1;
    output reg [11:0] result_out_2;
    output reg [6:0] result_count_out;
    // Stub signals
    reg query_flags_clock;
    reg query_flags_reset_in;
    reg query_flags_token_valid_in;
    reg query_flags_swap_in;
    wire query_flags_keeps;
    wire query_flags_reset_out;
    wire query_flags_token_valid_out;
    wire query_flags_swap_out;
    reg query_0_clock;
    reg [8:0] query_0_token_in;
    reg query_0_keeps;
    reg query_0_swap_in;
    wire [8:0] query_0_token_out;
    wire [8:0] query_0_query_out;
    reg query_1_clock;
    reg [8:0] query_1_token_in;
    reg query_1_keeps;
    reg query_1_swap_in;
    wire [8:0] query_1_token_out;
    wire [8:0] query_1_query_out;
    reg query_2_clock;
    reg [8:0] query_2_token_in;
    reg query_2_keeps;
    reg query_2_swap_in;
    wire [8:0] query_2_token_out;
    wire [8:0] query_2_query_out;
    reg [8:0] photon_0_d;
    wire [8:0] photon_0_q;
    reg photon_0_clock;
    reg [8:0] photon_1_d;
    wire [8:0] photon_1_q;
    reg photon_1_clock;
    reg [8:0] photon_2_d;
    wire [8:0] photon_2_q;
    reg photon_2_clock;
    reg [8:0] photon_3_d;
    wire [8:0] photon_3_q;
    reg photon_3_clock;
    reg [8:0] photon_4_d;
    wire [8:0] photon_4_q;
    reg photon_4_clock;
    reg [8:0] photon_5_d;
    wire [8:0] photon_5_q;
    reg photon_5_clock;
    reg [8:0] photon_6_d;
    wire [8:0] photon_6_q;
    reg photon_6_clock;
    reg [8:0] photon_7_d;
    wire [8:0] photon_7_q;
    reg photon_7_clock;
    reg [8:0] photon_8_d;
    wire [8:0] photon_8_q;
    reg photon_8_clock;
    reg [8:0] photon_9_d;
    wire [8:0] photon_9_q;
    reg photon_9_clock;
    reg [8:0] photon_10_d;
    wire [8:0] photon_10_q;
    reg photon_10_clock;
    reg [8:0] photon_11_d;
    wire [8:0] photon_11_q;
    reg photon_11_clock;
    reg square_pair_0_clock;
    reg [8:0] square_pair_0_query;
    reg [8:0] square_pair_0_photon_a;
    reg [8:0] square_pair_0_photon_b;
    wire [13:0] square_pair_0_square_a;
    wire [13:0] square_pair_0_square_b;
    wire square_pair_0_far_a;
    wire square_pair_0_far_b;
    reg square_pair_1_clock;
    reg [8:0] square_pair_1_query;
    reg [8:0] square_pair_1_photon_a;
    reg [8:0] square_pair_1_photon_b;
    wire [13:0] square_pair_1_square_a;
    wire [13:0] square_pair_1_square_b;
    wire square_pair_1_far_a;
    wire square_pair_1_far_b;
    reg square_pair_2_clock;
    reg [8:0] square_pair_2_query;
    reg [8:0] square_pair_2_photon_a;
    reg [8:0] square_pair_2_photon_b;
    wire [13:0] square_pair_2_square_a;
    wire [13:0] square_pair_2_square_b;
    wire square_pair_2_far_a;
    wire square_pair_2_far_b;
    reg square_pair_3_clock;
    reg [8:0] square_pair_3_query;
    reg [8:0] square_pair_3_photon_a;
    reg [8:0] square_pair_3_photon_b;
    wire [13:0] square_pair_3_square_a;
    wire [13:0] square_pair_3_square_b;
    wire square_pair_3_far_a;
    wire square_pair_3_far_b;
    reg square_pair_4_clock;
    reg [8:0] square_pair_4_query;
    reg [8:0] square_pair_4_photon_a;
    reg [8:0] square_pair_4_photon_b;
    wire [13:0] square_pair_4_square_a;
    wire [13:0] square_pair_4_square_b;
    wire square_pair_4_far_a;
    wire square_pair_4_far_b;
    reg square_pair_5_clock;
    reg [8:0] square_pair_5_query;
    reg [8:0] square_pair_5_photon_a;
    reg [8:0] square_pair_5_photon_b;
    wire [13:0] square_pair_5_square_a;
    wire [13:0] square_pair_5_square_b;
    wire square_pair_5_far_a;
    wire square_pair_5_far_b;
    reg lane_0_clock;
    reg [13:0] lane_0_axis_square_0;
    reg [13:0] lane_0_axis_square_1;
    reg [13:0] lane_0_axis_square_2;
    reg lane_0_axis_far_0;
    reg lane_0_axis_far_1;
    reg lane_0_axis_far_2;
    wire lane_0_photon_in_range;
    reg lane_1_clock;
    reg [13:0] lane_1_axis_square_0;
    reg [13:0] lane_1_axis_square_1;
    reg [13:0] lane_1_axis_square_2;
    reg lane_1_axis_far_0;
    reg lane_1_axis_far_1;
    reg lane_1_axis_far_2;
    wire lane_1_photon_in_range;
    reg lane_2_clock;
    reg [13:0] lane_2_axis_square_0;
    reg [13:0] lane_2_axis_square_1;
    reg [13:0] lane_2_axis_square_2;
    reg lane_2_axis_far_0;
    reg lane_2_axis_far_1;
    reg lane_2_axis_far_2;
    wire lane_2_photon_in_range;
    reg lane_3_clock;
    reg [13:0] lane_3_axis_square_0;
    reg [13:0] lane_3_axis_square_1;
    reg [13:0] lane_3_axis_square_2;
    reg lane_3_axis_far_0;
    reg lane_3_axis_far_1;
    reg lane_3_axis_far_2;
    wire lane_3_photon_in_range;
    reg group_flags_clock;
    reg group_flags_reset_in;
    reg group_flags_reset;
    reg group_flags_first_in;
    reg group_flags_last_in;
    reg group_flags_result_valid_in;
    wire group_flags_first_out;
    wire group_flags_last_out;
    wire group_flags_replace;
    wire group_flags_sums_done;
    wire group_flags_result_valid_out;
    reg channel_sum_0_clock;
    reg [5:0] channel_sum_0_power_in_0;
    reg [5:0] channel_sum_0_power_in_1;
    reg [5:0] channel_sum_0_power_in_2;
    reg [5:0] channel_sum_0_power_in_3;
    wire [5:0] channel_sum_0_power_0;
    wire [5:0] channel_sum_0_power_1;
    wire [5:0] channel_sum_0_power_2;
    wire [5:0] channel_sum_0_power_3;
    reg channel_sum_0_in_range_0;
    reg channel_sum_0_in_range_1;
    reg channel_sum_0_in_range_2;
    reg channel_sum_0_in_range_3;
    reg channel_sum_0_first;
    reg channel_sum_0_done;
    reg [11:0] channel_sum_0_result_in;
    wire [11:0] channel_sum_0_result_out;
    reg channel_sum_1_clock;
    reg [5:0] channel_sum_1_power_in_0;
    reg [5:0] channel_sum_1_power_in_1;
    reg [5:0] channel_sum_1_power_in_2;
    reg [5:0] channel_sum_1_power_in_3;
    wire [5:0] channel_sum_1_power_0;
    wire [5:0] channel_sum_1_power_1;
    wire [5:0] channel_sum_1_power_2;
    wire [5:0] channel_sum_1_power_3;
    reg channel_sum_1_in_range_0;
    reg channel_sum_1_in_range_1;
    reg channel_sum_1_in_range_2;
    reg channel_sum_1_in_range_3;
    reg channel_sum_1_first;
    reg channel_sum_1_done;
    reg [11:0] channel_sum_1_result_in;
    wire [11:0] channel_sum_1_result_out;
    reg channel_sum_2_clock;
    reg [5:0] channel_sum_2_power_in_0;
    reg [5:0] channel_sum_2_power_in_1;
    reg [5:0] channel_sum_2_power_in_2;
    reg [5:0] channel_sum_2_power_in_3;
    wire [5:0] channel_sum_2_power_0;
    wire [5:0] channel_sum_2_power_1;
    wire [5:0] channel_sum_2_power_2;
    wire [5:0] channel_sum_2_power_3;
    reg channel_sum_2_in_range_0;
    reg channel_sum_2_in_range_1;
    reg channel_sum_2_in_range_2;
    reg channel_sum_2_in_range_3;
    reg channel_sum_2_first;
    reg channel_sum_2_done;
    reg [11:0] channel_sum_2_result_in;
    wire [11:0] channel_sum_2_result_out;
    reg count_sum_clock;
    reg count_sum_power_in_0;
    reg count_sum_power_in_1;
    reg count_sum_power_in_2;
    reg count_sum_power_in_3;
    wire count_sum_power_0;
    wire count_sum_power_1;
    wire count_sum_power_2;
    wire count_sum_power_3;
    reg count_sum_in_range_0;
    reg count_sum_in_range_1;
    reg count_sum_in_range_2;
    reg count_sum_in_range_3;
    reg count_sum_first;
    reg count_sum_done;
    reg [6:0] count_sum_result_in;
    wire [6:0] count_sum_result_out;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_query_flags query_flags(
        .clock(query_flags_clock),
        .reset_in(query_flags_reset_in),
        .token_valid_in(query_flags_token_valid_in),
        .swap_in(query_flags_swap_in),
        .keeps(query_flags_keeps),
        .reset_out(query_flags_reset_out),
        .token_valid_out(query_flags_token_valid_out),
        .swap_out(query_flags_swap_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query query_0(
        .clock(query_0_clock),
        .token_in(query_0_token_in),
        .keeps(query_0_keeps),
        .swap_in(query_0_swap_in),
        .token_out(query_0_token_out),
        .query_out(query_0_query_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query query_1(
        .clock(query_1_clock),
        .token_in(query_1_token_in),
        .keeps(query_1_keeps),
        .swap_in(query_1_swap_in),
        .token_out(query_1_token_out),
        .query_out(query_1_query_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_query query_2(
        .clock(query_2_clock),
        .token_in(query_2_token_in),
        .keeps(query_2_keeps),
        .swap_in(query_2_swap_in),
        .token_out(query_2_token_out),
        .query_out(query_2_query_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_0(
        .d(photon_0_d),
        .q(photon_0_q),
        .clock(photon_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_1(
        .d(photon_1_d),
        .q(photon_1_q),
        .clock(photon_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_2(
        .d(photon_2_d),
        .q(photon_2_q),
        .clock(photon_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_3(
        .d(photon_3_d),
        .q(photon_3_q),
        .clock(photon_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_4(
        .d(photon_4_d),
        .q(photon_4_q),
        .clock(photon_4_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_5(
        .d(photon_5_d),
        .q(photon_5_q),
        .clock(photon_5_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_6(
        .d(photon_6_d),
        .q(photon_6_q),
        .clock(photon_6_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_7(
        .d(photon_7_d),
        .q(photon_7_q),
        .clock(photon_7_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_8(
        .d(photon_8_d),
        .q(photon_8_q),
        .clock(photon_8_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_9(
        .d(photon_9_d),
        .q(photon_9_q),
        .clock(photon_9_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_10(
        .d(photon_10_d),
        .q(photon_10_q),
        .clock(photon_10_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 photon_11(
        .d(photon_11_d),
        .q(photon_11_q),
        .clock(photon_11_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair square_pair_0(
        .clock(square_pair_0_clock),
        .query(square_pair_0_query),
        .photon_a(square_pair_0_photon_a),
        .photon_b(square_pair_0_photon_b),
        .square_a(square_pair_0_square_a),
        .square_b(square_pair_0_square_b),
        .far_a(square_pair_0_far_a),
        .far_b(square_pair_0_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair square_pair_1(
        .clock(square_pair_1_clock),
        .query(square_pair_1_query),
        .photon_a(square_pair_1_photon_a),
        .photon_b(square_pair_1_photon_b),
        .square_a(square_pair_1_square_a),
        .square_b(square_pair_1_square_b),
        .far_a(square_pair_1_far_a),
        .far_b(square_pair_1_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair square_pair_2(
        .clock(square_pair_2_clock),
        .query(square_pair_2_query),
        .photon_a(square_pair_2_photon_a),
        .photon_b(square_pair_2_photon_b),
        .square_a(square_pair_2_square_a),
        .square_b(square_pair_2_square_b),
        .far_a(square_pair_2_far_a),
        .far_b(square_pair_2_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair square_pair_3(
        .clock(square_pair_3_clock),
        .query(square_pair_3_query),
        .photon_a(square_pair_3_photon_a),
        .photon_b(square_pair_3_photon_b),
        .square_a(square_pair_3_square_a),
        .square_b(square_pair_3_square_b),
        .far_a(square_pair_3_far_a),
        .far_b(square_pair_3_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair square_pair_4(
        .clock(square_pair_4_clock),
        .query(square_pair_4_query),
        .photon_a(square_pair_4_photon_a),
        .photon_b(square_pair_4_photon_b),
        .square_a(square_pair_4_square_a),
        .square_b(square_pair_4_square_b),
        .far_a(square_pair_4_far_a),
        .far_b(square_pair_4_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_pair square_pair_5(
        .clock(square_pair_5_clock),
        .query(square_pair_5_query),
        .photon_a(square_pair_5_photon_a),
        .photon_b(square_pair_5_photon_b),
        .square_a(square_pair_5_square_a),
        .square_b(square_pair_5_square_b),
        .far_a(square_pair_5_far_a),
        .far_b(square_pair_5_far_b)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_0(
        .clock(lane_0_clock),
        .axis_square_0(lane_0_axis_square_0),
        .axis_square_1(lane_0_axis_square_1),
        .axis_square_2(lane_0_axis_square_2),
        .axis_far_0(lane_0_axis_far_0),
        .axis_far_1(lane_0_axis_far_1),
        .axis_far_2(lane_0_axis_far_2),
        .photon_in_range(lane_0_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_1(
        .clock(lane_1_clock),
        .axis_square_0(lane_1_axis_square_0),
        .axis_square_1(lane_1_axis_square_1),
        .axis_square_2(lane_1_axis_square_2),
        .axis_far_0(lane_1_axis_far_0),
        .axis_far_1(lane_1_axis_far_1),
        .axis_far_2(lane_1_axis_far_2),
        .photon_in_range(lane_1_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_2(
        .clock(lane_2_clock),
        .axis_square_0(lane_2_axis_square_0),
        .axis_square_1(lane_2_axis_square_1),
        .axis_square_2(lane_2_axis_square_2),
        .axis_far_0(lane_2_axis_far_0),
        .axis_far_1(lane_2_axis_far_1),
        .axis_far_2(lane_2_axis_far_2),
        .photon_in_range(lane_2_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_lane lane_3(
        .clock(lane_3_clock),
        .axis_square_0(lane_3_axis_square_0),
        .axis_square_1(lane_3_axis_square_1),
        .axis_square_2(lane_3_axis_square_2),
        .axis_far_0(lane_3_axis_far_0),
        .axis_far_1(lane_3_axis_far_1),
        .axis_far_2(lane_3_axis_far_2),
        .photon_in_range(lane_3_photon_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_flags group_flags(
        .clock(group_flags_clock),
        .reset_in(group_flags_reset_in),
        .reset(group_flags_reset),
        .first_in(group_flags_first_in),
        .last_in(group_flags_last_in),
        .result_valid_in(group_flags_result_valid_in),
        .first_out(group_flags_first_out),
        .last_out(group_flags_last_out),
        .replace(group_flags_replace),
        .sums_done(group_flags_sums_done),
        .result_valid_out(group_flags_result_valid_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_channel_sum channel_sum_0(
        .clock(channel_sum_0_clock),
        .power_in_0(channel_sum_0_power_in_0),
        .power_in_1(channel_sum_0_power_in_1),
        .power_in_2(channel_sum_0_power_in_2),
        .power_in_3(channel_sum_0_power_in_3),
        .power_0(channel_sum_0_power_0),
        .power_1(channel_sum_0_power_1),
        .power_2(channel_sum_0_power_2),
        .power_3(channel_sum_0_power_3),
        .in_range_0(channel_sum_0_in_range_0),
        .in_range_1(channel_sum_0_in_range_1),
        .in_range_2(channel_sum_0_in_range_2),
        .in_range_3(channel_sum_0_in_range_3),
        .first(channel_sum_0_first),
        .done(channel_sum_0_done),
        .result_in(channel_sum_0_result_in),
        .result_out(channel_sum_0_result_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_channel_sum channel_sum_1(
        .clock(channel_sum_1_clock),
        .power_in_0(channel_sum_1_power_in_0),
        .power_in_1(channel_sum_1_power_in_1),
        .power_in_2(channel_sum_1_power_in_2),
        .power_in_3(channel_sum_1_power_in_3),
        .power_0(channel_sum_1_power_0),
        .power_1(channel_sum_1_power_1),
        .power_2(channel_sum_1_power_2),
        .power_3(channel_sum_1_power_3),
        .in_range_0(channel_sum_1_in_range_0),
        .in_range_1(channel_sum_1_in_range_1),
        .in_range_2(channel_sum_1_in_range_2),
        .in_range_3(channel_sum_1_in_range_3),
        .first(channel_sum_1_first),
        .done(channel_sum_1_done),
        .result_in(channel_sum_1_result_in),
        .result_out(channel_sum_1_result_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_channel_sum channel_sum_2(
        .clock(channel_sum_2_clock),
        .power_in_0(channel_sum_2_power_in_0),
        .power_in_1(channel_sum_2_power_in_1),
        .power_in_2(channel_sum_2_power_in_2),
        .power_in_3(channel_sum_2_power_in_3),
        .power_0(channel_sum_2_power_0),
        .power_1(channel_sum_2_power_1),
        .power_2(channel_sum_2_power_2),
        .power_3(channel_sum_2_power_3),
        .in_range_0(channel_sum_2_in_range_0),
        .in_range_1(channel_sum_2_in_range_1),
        .in_range_2(channel_sum_2_in_range_2),
        .in_range_3(channel_sum_2_in_range_3),
        .first(channel_sum_2_first),
        .done(channel_sum_2_done),
        .result_in(channel_sum_2_result_in),
        .result_out(channel_sum_2_result_out)
    );
    photoncube_leaf_5_local7_rgb6d_n64_count_sum count_sum(
        .clock(count_sum_clock),
        .power_in_0(count_sum_power_in_0),
        .power_in_1(count_sum_power_in_1),
        .power_in_2(count_sum_power_in_2),
        .power_in_3(count_sum_power_in_3),
        .power_0(count_sum_power_0),
        .power_1(count_sum_power_1),
        .power_2(count_sum_power_2),
        .power_3(count_sum_power_3),
        .in_range_0(count_sum_in_range_0),
        .in_range_1(count_sum_in_range_1),
        .in_range_2(count_sum_in_range_2),
        .in_range_3(count_sum_in_range_3),
        .first(count_sum_first),
        .done(count_sum_done),
        .result_in(count_sum_result_in),
        .result_out(count_sum_result_out)
    );
    // Update code
    always @(*) begin
        query_flags_clock = clock;
        query_flags_reset_in = reset_in;
        query_flags_token_valid_in = token_valid_in;
        query_flags_swap_in = swap_in;
        reset_out = query_flags_reset_out;
        token_valid_out = query_flags_token_valid_out;
        swap_out = query_flags_swap_out;
        query_0_clock = clock;
        query_0_keeps = query_flags_keeps;
        query_0_swap_in = swap_in;
        query_0_token_in = token_in_0;
        token_out_0 = query_0_token_out;
        query_1_clock = clock;
        query_1_keeps = query_flags_keeps;
        query_1_swap_in = swap_in;
        query_1_token_in = token_in_1;
        token_out_1 = query_1_token_out;
        query_2_clock = clock;
        query_2_keeps = query_flags_keeps;
        query_2_swap_in = swap_in;
        query_2_token_in = token_in_2;
        token_out_2 = query_2_token_out;
        photon_0_clock = clock;
        photon_0_d = photon_in_0;
        photon_out_0 = photon_0_q;
        photon_1_clock = clock;
        photon_1_d = photon_in_1;
        photon_out_1 = photon_1_q;
        photon_2_clock = clock;
        photon_2_d = photon_in_2;
        photon_out_2 = photon_2_q;
        photon_3_clock = clock;
        photon_3_d = photon_in_3;
        photon_out_3 = photon_3_q;
        photon_4_clock = clock;
        photon_4_d = photon_in_4;
        photon_out_4 = photon_4_q;
        photon_5_clock = clock;
        photon_5_d = photon_in_5;
        photon_out_5 = photon_5_q;
        photon_6_clock = clock;
        photon_6_d = photon_in_6;
        photon_out_6 = photon_6_q;
        photon_7_clock = clock;
        photon_7_d = photon_in_7;
        photon_out_7 = photon_7_q;
        photon_8_clock = clock;
        photon_8_d = photon_in_8;
        photon_out_8 = photon_8_q;
        photon_9_clock = clock;
        photon_9_d = photon_in_9;
        photon_out_9 = photon_9_q;
        photon_10_clock = clock;
        photon_10_d = photon_in_10;
        photon_out_10 = photon_10_q;
        photon_11_clock = clock;
        photon_11_d = photon_in_11;
        photon_out_11 = photon_11_q;
        square_pair_0_clock = clock;
        square_pair_0_query = query_0_query_out;
        square_pair_0_photon_a = photon_0_q;
        square_pair_0_photon_b = photon_3_q;
        lane_0_axis_square_0 = square_pair_0_square_a;
        lane_1_axis_square_0 = square_pair_0_square_b;
        lane_0_axis_far_0 = square_pair_0_far_a;
        lane_1_axis_far_0 = square_pair_0_far_b;
        square_pair_1_clock = clock;
        square_pair_1_query = query_1_query_out;
        square_pair_1_photon_a = photon_1_q;
        square_pair_1_photon_b = photon_4_q;
        lane_0_axis_square_1 = square_pair_1_square_a;
        lane_1_axis_square_1 = square_pair_1_square_b;
        lane_0_axis_far_1 = square_pair_1_far_a;
        lane_1_axis_far_1 = square_pair_1_far_b;
        square_pair_2_clock = clock;
        square_pair_2_query = query_2_query_out;
        square_pair_2_photon_a = photon_2_q;
        square_pair_2_photon_b = photon_5_q;
        lane_0_axis_square_2 = square_pair_2_square_a;
        lane_1_axis_square_2 = square_pair_2_square_b;
        lane_0_axis_far_2 = square_pair_2_far_a;
        lane_1_axis_far_2 = square_pair_2_far_b;
        square_pair_3_clock = clock;
        square_pair_3_query = query_0_query_out;
        square_pair_3_photon_a = photon_6_q;
        square_pair_3_photon_b = photon_9_q;
        lane_2_axis_square_0 = square_pair_3_square_a;
        lane_3_axis_square_0 = square_pair_3_square_b;
        lane_2_axis_far_0 = square_pair_3_far_a;
        lane_3_axis_far_0 = square_pair_3_far_b;
        square_pair_4_clock = clock;
        square_pair_4_query = query_1_query_out;
        square_pair_4_photon_a = photon_7_q;
        square_pair_4_photon_b = photon_10_q;
        lane_2_axis_square_1 = square_pair_4_square_a;
        lane_3_axis_square_1 = square_pair_4_square_b;
        lane_2_axis_far_1 = square_pair_4_far_a;
        lane_3_axis_far_1 = square_pair_4_far_b;
        square_pair_5_clock = clock;
        square_pair_5_query = query_2_query_out;
        square_pair_5_photon_a = photon_8_q;
        square_pair_5_photon_b = photon_11_q;
        lane_2_axis_square_2 = square_pair_5_square_a;
        lane_3_axis_square_2 = square_pair_5_square_b;
        lane_2_axis_far_2 = square_pair_5_far_a;
        lane_3_axis_far_2 = square_pair_5_far_b;
        lane_0_clock = clock;
        lane_1_clock = clock;
        lane_2_clock = clock;
        lane_3_clock = clock;
        group_flags_clock = clock;
        group_flags_reset_in = reset_in;
        group_flags_reset = query_flags_reset_out;
        group_flags_first_in = first_in;
        group_flags_last_in = last_in;
        group_flags_result_valid_in = result_valid_in;
        first_out = group_flags_first_out;
        last_out = group_flags_last_out;
        result_valid_out = group_flags_result_valid_out;
        count_sum_clock = clock;
        count_sum_first = group_flags_replace;
        count_sum_done = group_flags_sums_done;
        count_sum_result_in = result_count_in;
        result_count_out = count_sum_result_out;
        count_sum_power_in_0 = present_in_0;
        count_sum_in_range_0 = lane_0_photon_in_range;
        present_out_0 = count_sum_power_0;
        count_sum_power_in_1 = present_in_1;
        count_sum_in_range_1 = lane_1_photon_in_range;
        present_out_1 = count_sum_power_1;
        count_sum_power_in_2 = present_in_2;
        count_sum_in_range_2 = lane_2_photon_in_range;
        present_out_2 = count_sum_power_2;
        count_sum_power_in_3 = present_in_3;
        count_sum_in_range_3 = lane_3_photon_in_range;
        present_out_3 = count_sum_power_3;
        channel_sum_0_clock = clock;
        channel_sum_0_first = group_flags_replace;
        channel_sum_0_done = group_flags_sums_done;
        channel_sum_0_result_in = result_in_0;
        result_out_0 = channel_sum_0_result_out;
        channel_sum_0_power_in_0 = power_in_0;
        channel_sum_0_in_range_0 = lane_0_photon_in_range;
        power_out_0 = channel_sum_0_power_0;
        channel_sum_0_power_in_1 = power_in_3;
        channel_sum_0_in_range_1 = lane_1_photon_in_range;
        power_out_3 = channel_sum_0_power_1;
        channel_sum_0_power_in_2 = power_in_6;
        channel_sum_0_in_range_2 = lane_2_photon_in_range;
        power_out_6 = channel_sum_0_power_2;
        channel_sum_0_power_in_3 = power_in_9;
        channel_sum_0_in_range_3 = lane_3_photon_in_range;
        power_out_9 = channel_sum_0_power_3;
        channel_sum_1_clock = clock;
        channel_sum_1_first = group_flags_replace;
        channel_sum_1_done = group_flags_sums_done;
        channel_sum_1_result_in = result_in_1;
        result_out_1 = channel_sum_1_result_out;
        channel_sum_1_power_in_0 = power_in_1;
        channel_sum_1_in_range_0 = lane_0_photon_in_range;
        power_out_1 = channel_sum_1_power_0;
        channel_sum_1_power_in_1 = power_in_4;
        channel_sum_1_in_range_1 = lane_1_photon_in_range;
        power_out_4 = channel_sum_1_power_1;
        channel_sum_1_power_in_2 = power_in_7;
        channel_sum_1_in_range_2 = lane_2_photon_in_range;
        power_out_7 = channel_sum_1_power_2;
        channel_sum_1_power_in_3 = power_in_10;
        channel_sum_1_in_range_3 = lane_3_photon_in_range;
        power_out_10 = channel_sum_1_power_3;
        channel_sum_2_clock = clock;
        channel_sum_2_first = group_flags_replace;
        channel_sum_2_done = group_flags_sums_done;
        channel_sum_2_result_in = result_in_2;
        result_out_2 = channel_sum_2_result_out;
        channel_sum_2_power_in_0 = power_in_2;
        channel_sum_2_in_range_0 = lane_0_photon_in_range;
        power_out_2 = channel_sum_2_power_0;
        channel_sum_2_power_in_1 = power_in_5;
        channel_sum_2_in_range_1 = lane_1_photon_in_range;
        power_out_5 = channel_sum_2_power_1;
        channel_sum_2_power_in_2 = power_in_8;
        channel_sum_2_in_range_2 = lane_2_photon_in_range;
        power_out_8 = channel_sum_2_power_2;
        channel_sum_2_power_in_3 = power_in_11;
        channel_sum_2_in_range_3 = lane_3_photon_in_range;
        power_out_11 = channel_sum_2_power_3;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_half(present_a, present_b, place_a, place_b, low, high);
    // Module arguments
    input wire present_a;
    input wire present_b;
    input wire [8:0] place_a;
    input wire [8:0] place_b;
    output reg [8:0] low;
    output reg [8:0] high;
    // Local signals
    reg has_a;
    reg has_b;
    reg is_lower;
    reg is_higher;
    reg [8:0] zero;
    // Update code
    always @(*) begin
        zero = 32'h0;
        has_a = |present_a;
        has_b = |present_b;
        is_lower = place_b < place_a;
        is_higher = place_b > place_a;
        low = place_a;
        high = place_a;
        if (has_b & (is_lower | ~has_a)) begin
            low = place_b;
        end
        if (has_b & (is_higher | ~has_a)) begin
            high = place_b;
        end
        if (~has_a & ~has_b) begin
            low = ~zero;
            high = 32'h0;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_both(low_a, low_b, high_a, high_b, low, high);
    // Module arguments
    input wire [8:0] low_a;
    input wire [8:0] low_b;
    input wire [8:0] high_a;
    input wire [8:0] high_b;
    output reg [8:0] low;
    output reg [8:0] high;
    // Local signals
    reg is_lower;
    reg is_higher;
    // Update code
    always @(*) begin
        is_lower = low_b < low_a;
        is_higher = high_b > high_a;
        low = low_a;
        high = high_a;
        if (is_lower) begin
            low = low_b;
        end
        if (is_higher) begin
            high = high_b;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_queue(clock, reset, result_valid_in, result_in_0, result_in_1,
    result_in_2, result_count_in, result_ready, result_valid, result_red, result_green,
    result_blue, result_count, batch_read);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire result_valid_in;
    input wire [11:0] result_in_0;
    input wire [11:0] result_in_1;
    input wire [11:0] result_in_2;
    input wire [6:0] result_count_in;
    input wire result_ready;
    output reg result_valid;
    output reg [11:0] result_red;
    output reg [11:0] result_green;
    output reg [11:0] result_blue;
    output reg [6:0] result_count;
    output reg batch_read;
    // Update code (custom)
    (* no_rw_check *) reg [42:0] results [0:15];
    reg [42:0] word = 43'd0;
    reg [3:0] write_place = 4'd0;
    reg [3:0] newest_place = 4'd0;
    reg [3:0] read_place = 4'd0;
    reg has_waiting = 1'd0;
    reg has_result = 1'd0;
    integer place;
    initial for (place = 0; place <= 15; place = place + 1) results[place] = 43'd0;
    wire reads = has_waiting & (~has_result | result_ready);
    (* keep *) wire is_newest;
    assign is_newest = read_place == newest_place;
    wire reads_newest = reads & is_newest;
    always @(*) result_valid = has_result;
    always @(*) batch_read = reads & (&read_place[0:0]);
    always @(*) result_red = word[11:0];
    always @(*) result_green = word[23:12];
    always @(*) result_blue = word[35:24];
    always @(*) result_count = word[42:36];
    always @(posedge clock) begin
      if (result_valid_in) begin
        results[write_place] <= {result_count_in, result_in_2, result_in_1, result_in_0};
        newest_place <= write_place;
        write_place <= write_place + 4'd1;
      end
      if (reads) begin
        word <= results[read_place];
        read_place <= read_place + 4'd1;
      end
      has_waiting <= result_valid_in | (has_waiting & ~reads_newest);
      has_result <= reads | (has_result & ~result_ready);
      if (reset) begin
        write_place <= 4'd0;
        newest_place <= 4'd0;
        read_place <= 4'd0;
        has_waiting <= 1'd0;
        has_result <= 1'd0;
      end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_32(d, q, clock);
    // Module arguments
    input wire [31:0] d;
    output reg [31:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 32'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_4(d, q, clock);
    // Module arguments
    input wire [3:0] d;
    output reg [3:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 4'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_held_high(clock, takes, d, q);
    // Module arguments
    input wire clock;
    input wire takes;
    input wire [8:0] d;
    output reg [8:0] q;
    // Stub signals
    reg [8:0] held_d;
    wire [8:0] held_q;
    reg held_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_9 held(
        .d(held_d),
        .q(held_q),
        .clock(held_clock)
    );
    // Update code
    always @(*) begin
        held_clock = clock;
        held_d = held_q;
        if (takes) begin
            held_d = d;
        end
        q = held_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_5(d, q, clock);
    // Module arguments
    input wire [4:0] d;
    output reg [4:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 5'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_admission(clock, reset, query_valid, group_valid, group_last,
    batch_read, query_ready, group_ready, taken, first_taken, last_taken, token_valid, is_full,
    has_room, clocks_to_last);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    input wire group_valid;
    input wire group_last;
    input wire batch_read;
    output reg query_ready;
    output reg group_ready;
    output reg taken;
    output reg first_taken;
    output reg last_taken;
    output reg token_valid;
    output reg is_full;
    output reg has_room;
    output reg [15:0] clocks_to_last;
    // Update code (custom)
    reg [1:0] loaded = 2'd0;
    reg open = 1'd0;
    reg one = 1'd1;
    wire full = loaded[1];
    wire takes_first = group_valid & ~open;
    wire takes_last = group_valid & group_last;
    wire admits_query = ~full | takes_first;
    always @(*) query_ready = admits_query;
    always @(*) group_ready = one;
    always @(*) taken = group_valid;
    always @(*) first_taken = takes_first;
    always @(*) last_taken = takes_last;
    always @(*) token_valid = query_valid & admits_query & ~reset;
    always @(*) is_full = full;
    always @(*) has_room = one;
    always @(*) clocks_to_last = {16{~one}};
    always @(posedge clock) begin
      one <= 1'd1;
      loaded <= takes_first ? {1'd0, query_valid} : loaded + {1'd0, query_valid & ~full};
      if (group_valid) open <= ~group_last;
      if (reset) begin
        loaded <= 2'd0;
        open <= 1'd0;
      end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_2(d, q, clock);
    // Module arguments
    input wire [1:0] d;
    output reg [1:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 2'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_nearest(above, below, difference);
    // Module arguments
    input wire [9:0] above;
    input wire [9:0] below;
    output reg [9:0] difference;
    // Constant declarations
    localparam negative = 10'b1000000000;
    // Local signals
    reg is_above;
    reg is_not_below;
    // Update code
    always @(*) begin
        is_above = above >= negative;
        is_not_below = below >= negative;
        difference = below;
        if (is_not_below) begin
            difference = 32'h0;
        end
        if (is_above) begin
            difference = above;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_presence(clock, taken, photon_present, present, absent);
    // Module arguments
    input wire clock;
    input wire taken;
    input wire photon_present;
    output reg present;
    output reg absent;
    // Stub signals
    reg is_present_d;
    wire is_present_q;
    reg is_present_clock;
    reg is_absent_d;
    wire is_absent_q;
    reg is_absent_clock;
    // Local signals
    reg is_photon;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 is_present(
        .d(is_present_d),
        .q(is_present_q),
        .clock(is_present_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 is_absent(
        .d(is_absent_d),
        .q(is_absent_q),
        .clock(is_absent_clock)
    );
    // Update code
    always @(*) begin
        is_present_clock = clock;
        is_absent_clock = clock;
        is_present_d = is_present_q;
        is_absent_d = is_absent_q;
        is_photon = taken & |photon_present;
        is_absent_d = ~is_photon;
        is_present_d = 32'h0;
        if (is_photon) begin
            is_present_d = 32'h1;
        end
        present = is_present_q;
        absent = is_absent_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_lane_2(clock, axis_square_0, axis_square_1, axis_square_2,
    axis_far_0, axis_far_1, axis_far_2, photon_in_range);
    // Module arguments
    input wire clock;
    input wire [13:0] axis_square_0;
    input wire [13:0] axis_square_1;
    input wire [13:0] axis_square_2;
    input wire axis_far_0;
    input wire axis_far_1;
    input wire axis_far_2;
    output reg photon_in_range;
    // Stub signals
    reg any_far_x;
    reg any_far_y;
    reg any_far_z;
    wire any_far_any;
    reg [13:0] pair_sum_a;
    reg [13:0] pair_sum_b;
    wire [14:0] pair_sum_sum;
    reg [14:0] pair_square_d;
    wire [14:0] pair_square_q;
    reg pair_square_clock;
    reg [13:0] pair_z_d;
    wire [13:0] pair_z_q;
    reg pair_z_clock;
    reg pair_far_d;
    wire pair_far_q;
    reg pair_far_clock;
    reg [14:0] distance_sum_a;
    reg [13:0] distance_sum_b;
    wire [15:0] distance_sum_sum;
    reg [15:0] distance_d;
    wire [15:0] distance_q;
    reg distance_clock;
    reg distance_far_d;
    wire distance_far_q;
    reg distance_far_clock;
    reg [15:0] range_of_format_0_distance;
    reg range_of_format_0_far;
    wire range_of_format_0_in_range;
    reg in_range_d;
    wire in_range_q;
    reg in_range_clock;
    reg range_wait_0_d;
    wire range_wait_0_q;
    reg range_wait_0_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_any_far any_far(
        .x(any_far_x),
        .y(any_far_y),
        .z(any_far_z),
        .any(any_far_any)
    );
    photoncube_leaf_5_local7_rgb6d_n64_pair_sum pair_sum(
        .a(pair_sum_a),
        .b(pair_sum_b),
        .sum(pair_sum_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_15 pair_square(
        .d(pair_square_d),
        .q(pair_square_q),
        .clock(pair_square_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_14 pair_z(
        .d(pair_z_d),
        .q(pair_z_q),
        .clock(pair_z_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 pair_far(
        .d(pair_far_d),
        .q(pair_far_q),
        .clock(pair_far_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_distance_sum distance_sum(
        .a(distance_sum_a),
        .b(distance_sum_b),
        .sum(distance_sum_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_distance distance(
        .d(distance_d),
        .q(distance_q),
        .clock(distance_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far distance_far(
        .d(distance_far_d),
        .q(distance_far_q),
        .clock(distance_far_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_range_of_format range_of_format_0(
        .distance(range_of_format_0_distance),
        .far(range_of_format_0_far),
        .in_range(range_of_format_0_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 in_range(
        .d(in_range_d),
        .q(in_range_q),
        .clock(in_range_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 range_wait_0(
        .d(range_wait_0_d),
        .q(range_wait_0_q),
        .clock(range_wait_0_clock)
    );
    // Update code
    always @(*) begin
        pair_square_clock = clock;
        pair_z_clock = clock;
        pair_far_clock = clock;
        distance_clock = clock;
        distance_far_clock = clock;
        in_range_clock = clock;
        any_far_x = axis_far_0;
        any_far_y = axis_far_1;
        any_far_z = axis_far_2;
        pair_sum_a = axis_square_0;
        pair_sum_b = axis_square_1;
        pair_square_d = pair_sum_sum;
        pair_z_d = axis_square_2;
        pair_far_d = any_far_any;
        distance_sum_a = pair_square_q;
        distance_sum_b = pair_z_q;
        distance_d = distance_sum_sum;
        distance_far_d = pair_far_q;
        range_of_format_0_distance = distance_q;
        range_of_format_0_far = distance_far_q;
        in_range_d = range_of_format_0_in_range;
        range_wait_0_clock = clock;
        range_wait_0_d = in_range_q;
        photon_in_range = range_wait_0_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_lane(clock, axis_square_0, axis_square_1, axis_square_2,
    axis_far_0, axis_far_1, axis_far_2, photon_in_range);
    // Module arguments
    input wire clock;
    input wire [13:0] axis_square_0;
    input wire [13:0] axis_square_1;
    input wire [13:0] axis_square_2;
    input wire axis_far_0;
    input wire axis_far_1;
    input wire axis_far_2;
    output reg photon_in_range;
    // Stub signals
    reg any_far_x;
    reg any_far_y;
    reg any_far_z;
    wire any_far_any;
    reg [13:0] pair_sum_a;
    reg [13:0] pair_sum_b;
    wire [14:0] pair_sum_sum;
    reg [14:0] pair_square_d;
    wire [14:0] pair_square_q;
    reg pair_square_clock;
    reg [13:0] pair_z_d;
    wire [13:0] pair_z_q;
    reg pair_z_clock;
    reg pair_far_d;
    wire pair_far_q;
    reg pair_far_clock;
    reg [14:0] distance_sum_a;
    reg [13:0] distance_sum_b;
    wire [15:0] distance_sum_sum;
    reg [15:0] distance_d;
    wire [15:0] distance_q;
    reg distance_clock;
    reg distance_far_d;
    wire distance_far_q;
    reg distance_far_clock;
    reg [15:0] range_of_format_0_distance;
    reg range_of_format_0_far;
    wire range_of_format_0_in_range;
    reg in_range_d;
    wire in_range_q;
    reg in_range_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_any_far any_far(
        .x(any_far_x),
        .y(any_far_y),
        .z(any_far_z),
        .any(any_far_any)
    );
    photoncube_leaf_5_local7_rgb6d_n64_pair_sum pair_sum(
        .a(pair_sum_a),
        .b(pair_sum_b),
        .sum(pair_sum_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_15 pair_square(
        .d(pair_square_d),
        .q(pair_square_q),
        .clock(pair_square_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_14 pair_z(
        .d(pair_z_d),
        .q(pair_z_q),
        .clock(pair_z_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 pair_far(
        .d(pair_far_d),
        .q(pair_far_q),
        .clock(pair_far_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_distance_sum distance_sum(
        .a(distance_sum_a),
        .b(distance_sum_b),
        .sum(distance_sum_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_distance distance(
        .d(distance_d),
        .q(distance_q),
        .clock(distance_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far distance_far(
        .d(distance_far_d),
        .q(distance_far_q),
        .clock(distance_far_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_range_of_format range_of_format_0(
        .distance(range_of_format_0_distance),
        .far(range_of_format_0_far),
        .in_range(range_of_format_0_in_range)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 in_range(
        .d(in_range_d),
        .q(in_range_q),
        .clock(in_range_clock)
    );
    // Update code
    always @(*) begin
        pair_square_clock = clock;
        pair_z_clock = clock;
        pair_far_clock = clock;
        distance_clock = clock;
        distance_far_clock = clock;
        in_range_clock = clock;
        any_far_x = axis_far_0;
        any_far_y = axis_far_1;
        any_far_z = axis_far_2;
        pair_sum_a = axis_square_0;
        pair_sum_b = axis_square_1;
        pair_square_d = pair_sum_sum;
        pair_z_d = axis_square_2;
        pair_far_d = any_far_any;
        distance_sum_a = pair_square_q;
        distance_sum_b = pair_z_q;
        distance_d = distance_sum_sum;
        distance_far_d = pair_far_q;
        range_of_format_0_distance = distance_q;
        range_of_format_0_far = distance_far_q;
        in_range_d = range_of_format_0_in_range;
        photon_in_range = in_range_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_first_delay(clock, clear, flag, delayed);
    // Module arguments
    input wire clock;
    input wire clear;
    input wire flag;
    output reg delayed;
    // Stub signals
    reg stage_0_clock;
    reg stage_0_clear;
    reg stage_0_d;
    wire stage_0_q;
    reg stage_1_clock;
    reg stage_1_clear;
    reg stage_1_d;
    wire stage_1_q;
    reg stage_2_clock;
    reg stage_2_clear;
    reg stage_2_d;
    wire stage_2_q;
    reg stage_3_clock;
    reg stage_3_clear;
    reg stage_3_d;
    wire stage_3_q;
    reg stage_4_clock;
    reg stage_4_clear;
    reg stage_4_d;
    wire stage_4_q;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_group_first stage_0(
        .clock(stage_0_clock),
        .clear(stage_0_clear),
        .d(stage_0_d),
        .q(stage_0_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first stage_1(
        .clock(stage_1_clock),
        .clear(stage_1_clear),
        .d(stage_1_d),
        .q(stage_1_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first stage_2(
        .clock(stage_2_clock),
        .clear(stage_2_clear),
        .d(stage_2_d),
        .q(stage_2_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first stage_3(
        .clock(stage_3_clock),
        .clear(stage_3_clear),
        .d(stage_3_d),
        .q(stage_3_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first stage_4(
        .clock(stage_4_clock),
        .clear(stage_4_clear),
        .d(stage_4_d),
        .q(stage_4_q)
    );
    // Update code
    always @(*) begin
        stage_0_d = flag;
        stage_1_d = stage_0_q;
        stage_2_d = stage_1_q;
        stage_3_d = stage_2_q;
        stage_4_d = stage_3_q;
        stage_0_clock = clock;
        stage_0_clear = clear;
        stage_1_clock = clock;
        stage_1_clear = clear;
        stage_2_clock = clock;
        stage_2_clear = clear;
        stage_3_clock = clock;
        stage_3_clear = clear;
        stage_4_clock = clock;
        stage_4_clear = clear;
        delayed = stage_4_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_query(clock, token_in, keeps, swap_in, token_out, query_out);
    // Module arguments
    input wire clock;
    input wire [8:0] token_in;
    input wire keeps;
    input wire swap_in;
    output reg [8:0] token_out;
    output reg [8:0] query_out;
    // Stub signals
    reg [8:0] token_d;
    wire [8:0] token_q;
    reg token_clock;
    reg [8:0] waiting_d;
    wire [8:0] waiting_q;
    reg waiting_clock;
    reg [8:0] query_d;
    wire [8:0] query_q;
    reg query_clock;
    // Local signals
    reg [8:0] newest;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_9 token(
        .d(token_d),
        .q(token_q),
        .clock(token_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 waiting(
        .d(waiting_d),
        .q(waiting_q),
        .clock(waiting_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 query(
        .d(query_d),
        .q(query_q),
        .clock(query_clock)
    );
    // Update code
    always @(*) begin
        token_clock = clock;
        waiting_clock = clock;
        query_clock = clock;
        token_d = token_q;
        waiting_d = waiting_q;
        query_d = query_q;
        token_d = token_in;
        newest = waiting_q;
        if (keeps) begin
            newest = token_q;
            waiting_d = token_q;
        end
        if (swap_in) begin
            query_d = newest;
        end
        token_out = token_q;
        query_out = query_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_count_sum(clock, power_in_0, power_in_1, power_in_2, power_in_3,
    power_0, power_1, power_2, power_3, in_range_0, in_range_1, in_range_2, in_range_3, first,
    done, result_in, result_out);
    // Module arguments
    input wire clock;
    input wire power_in_0;
    input wire power_in_1;
    input wire power_in_2;
    input wire power_in_3;
    output reg power_0;
    output reg power_1;
    output reg power_2;
    output reg power_3;
    input wire in_range_0;
    input wire in_range_1;
    input wire in_range_2;
    input wire in_range_3;
    input wire first;
    input wire done;
    input wire [6:0] result_in;
    output reg [6:0] result_out;
    // Stub signals
    reg hop_0_d;
    wire hop_0_q;
    reg hop_0_clock;
    reg hop_1_d;
    wire hop_1_q;
    reg hop_1_clock;
    reg hop_2_d;
    wire hop_2_q;
    reg hop_2_clock;
    reg hop_3_d;
    wire hop_3_q;
    reg hop_3_clock;
    reg gated_sum_0_a;
    reg gated_sum_0_b;
    reg gated_sum_0_a_in_range;
    reg gated_sum_0_b_in_range;
    wire [1:0] gated_sum_0_sum;
    reg gated_sum_1_a;
    reg gated_sum_1_b;
    reg gated_sum_1_a_in_range;
    reg gated_sum_1_b_in_range;
    wire [1:0] gated_sum_1_sum;
    reg [1:0] pair_0_d;
    wire [1:0] pair_0_q;
    reg pair_0_clock;
    reg [1:0] pair_1_d;
    wire [1:0] pair_1_q;
    reg pair_1_clock;
    reg [1:0] group_sum_a;
    reg [1:0] group_sum_b;
    wire [2:0] group_sum_sum;
    reg [2:0] group_d;
    wire [2:0] group_q;
    reg group_clock;
    reg [2:0] accumulate_group;
    reg [6:0] accumulate_sum;
    reg accumulate_first;
    wire [6:0] accumulate_next_sum;
    reg [6:0] sum_d;
    wire [6:0] sum_q;
    reg sum_clock;
    reg result_link_done;
    reg [6:0] result_link_own;
    reg [6:0] result_link_further;
    wire [6:0] result_link_result;
    reg [6:0] result_d;
    wire [6:0] result_q;
    reg result_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 hop_0(
        .d(hop_0_d),
        .q(hop_0_q),
        .clock(hop_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 hop_1(
        .d(hop_1_d),
        .q(hop_1_q),
        .clock(hop_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 hop_2(
        .d(hop_2_d),
        .q(hop_2_q),
        .clock(hop_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 hop_3(
        .d(hop_3_d),
        .q(hop_3_q),
        .clock(hop_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gated_sum_2 gated_sum_0(
        .a(gated_sum_0_a),
        .b(gated_sum_0_b),
        .a_in_range(gated_sum_0_a_in_range),
        .b_in_range(gated_sum_0_b_in_range),
        .sum(gated_sum_0_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gated_sum_2 gated_sum_1(
        .a(gated_sum_1_a),
        .b(gated_sum_1_b),
        .a_in_range(gated_sum_1_a_in_range),
        .b_in_range(gated_sum_1_b_in_range),
        .sum(gated_sum_1_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_pair pair_0(
        .d(pair_0_d),
        .q(pair_0_q),
        .clock(pair_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_pair pair_1(
        .d(pair_1_d),
        .q(pair_1_q),
        .clock(pair_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_sum_2 group_sum(
        .a(group_sum_a),
        .b(group_sum_b),
        .sum(group_sum_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_3 group(
        .d(group_d),
        .q(group_q),
        .clock(group_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_accumulate_2 accumulate(
        .group(accumulate_group),
        .sum(accumulate_sum),
        .first(accumulate_first),
        .next_sum(accumulate_next_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_7 sum(
        .d(sum_d),
        .q(sum_q),
        .clock(sum_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_result_link_2 result_link(
        .done(result_link_done),
        .own(result_link_own),
        .further(result_link_further),
        .result(result_link_result)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_7 result(
        .d(result_d),
        .q(result_q),
        .clock(result_clock)
    );
    // Update code
    always @(*) begin
        hop_0_clock = clock;
        hop_0_d = power_in_0;
        power_0 = hop_0_q;
        hop_1_clock = clock;
        hop_1_d = power_in_1;
        power_1 = hop_1_q;
        hop_2_clock = clock;
        hop_2_d = power_in_2;
        power_2 = hop_2_q;
        hop_3_clock = clock;
        hop_3_d = power_in_3;
        power_3 = hop_3_q;
        gated_sum_0_a = hop_0_q;
        gated_sum_0_b = hop_1_q;
        gated_sum_0_a_in_range = in_range_0;
        gated_sum_0_b_in_range = in_range_1;
        pair_0_d = gated_sum_0_sum;
        gated_sum_1_a = hop_2_q;
        gated_sum_1_b = hop_3_q;
        gated_sum_1_a_in_range = in_range_2;
        gated_sum_1_b_in_range = in_range_3;
        pair_1_d = gated_sum_1_sum;
        pair_0_clock = clock;
        pair_1_clock = clock;
        group_sum_a = pair_0_q;
        group_sum_b = pair_1_q;
        group_clock = clock;
        group_d = group_sum_sum;
        accumulate_group = group_q;
        accumulate_sum = sum_q;
        accumulate_first = first;
        sum_clock = clock;
        sum_d = accumulate_next_sum;
        result_link_done = done;
        result_link_own = sum_q;
        result_link_further = result_in;
        result_clock = clock;
        result_d = result_link_result;
        result_out = result_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_power_delay(clock, word, delayed);
    // Module arguments
    input wire clock;
    input wire [5:0] word;
    output reg [5:0] delayed;
    // Stub signals
    reg [5:0] stage_0_d;
    wire [5:0] stage_0_q;
    reg stage_0_clock;
    reg [5:0] stage_1_d;
    wire [5:0] stage_1_q;
    reg stage_1_clock;
    reg [5:0] stage_2_d;
    wire [5:0] stage_2_q;
    reg stage_2_clock;
    reg [5:0] stage_3_d;
    wire [5:0] stage_3_q;
    reg stage_3_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_6 stage_0(
        .d(stage_0_d),
        .q(stage_0_q),
        .clock(stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 stage_1(
        .d(stage_1_d),
        .q(stage_1_q),
        .clock(stage_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 stage_2(
        .d(stage_2_d),
        .q(stage_2_q),
        .clock(stage_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 stage_3(
        .d(stage_3_d),
        .q(stage_3_q),
        .clock(stage_3_clock)
    );
    // Update code
    always @(*) begin
        stage_0_clock = clock;
        stage_0_d = word;
        stage_1_clock = clock;
        stage_1_d = stage_0_q;
        stage_2_clock = clock;
        stage_2_d = stage_1_q;
        stage_3_clock = clock;
        stage_3_d = stage_2_q;
        delayed = stage_3_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_present_delay(clock, word, delayed);
    // Module arguments
    input wire clock;
    input wire word;
    output reg delayed;
    // Stub signals
    reg stage_0_d;
    wire stage_0_q;
    reg stage_0_clock;
    reg stage_1_d;
    wire stage_1_q;
    reg stage_1_clock;
    reg stage_2_d;
    wire stage_2_q;
    reg stage_2_clock;
    reg stage_3_d;
    wire stage_3_q;
    reg stage_3_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_0(
        .d(stage_0_d),
        .q(stage_0_q),
        .clock(stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_1(
        .d(stage_1_d),
        .q(stage_1_q),
        .clock(stage_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_2(
        .d(stage_2_d),
        .q(stage_2_q),
        .clock(stage_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 stage_3(
        .d(stage_3_d),
        .q(stage_3_q),
        .clock(stage_3_clock)
    );
    // Update code
    always @(*) begin
        stage_0_clock = clock;
        stage_0_d = word;
        stage_1_clock = clock;
        stage_1_d = stage_0_q;
        stage_2_clock = clock;
        stage_2_d = stage_1_q;
        stage_3_clock = clock;
        stage_3_d = stage_2_q;
        delayed = stage_3_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_query_flags(clock, reset_in, token_valid_in, swap_in, keeps, reset_out,
    token_valid_out, swap_out);
    // Module arguments
    input wire clock;
    input wire reset_in;
    input wire token_valid_in;
    input wire swap_in;
    output reg keeps;
    output reg reset_out;
    output reg token_valid_out;
    output reg swap_out;
    // Stub signals
    reg reset_d;
    wire reset_q;
    reg reset_clock;
    reg token_valid_d;
    wire token_valid_q;
    reg token_valid_clock;
    reg next_valid_d;
    wire next_valid_q;
    reg next_valid_clock;
    reg keep_d;
    wire keep_q;
    reg keep_clock;
    reg swap_d;
    wire swap_q;
    reg swap_clock;
    // Local signals
    reg is_free;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 reset(
        .d(reset_d),
        .q(reset_q),
        .clock(reset_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 token_valid(
        .d(token_valid_d),
        .q(token_valid_q),
        .clock(token_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 next_valid(
        .d(next_valid_d),
        .q(next_valid_q),
        .clock(next_valid_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 keep(
        .d(keep_d),
        .q(keep_q),
        .clock(keep_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 swap(
        .d(swap_d),
        .q(swap_q),
        .clock(swap_clock)
    );
    // Update code
    always @(*) begin
        reset_clock = clock;
        token_valid_clock = clock;
        next_valid_clock = clock;
        keep_clock = clock;
        swap_clock = clock;
        reset_d = reset_q;
        token_valid_d = token_valid_q;
        next_valid_d = next_valid_q;
        keep_d = keep_q;
        swap_d = swap_q;
        is_free = ~next_valid_q | swap_in;
        keep_d = token_valid_in & is_free;
        keeps = keep_q;
        reset_d = reset_in;
        token_valid_d = token_valid_in & ~is_free;
        next_valid_d = ~is_free | token_valid_in;
        swap_d = swap_in;
        if (reset_in) begin
            token_valid_d = 1'b0;
            next_valid_d = 1'b0;
            swap_d = 1'b0;
        end
        reset_out = reset_q;
        token_valid_out = token_valid_q;
        swap_out = swap_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_group_flags(clock, reset_in, reset, first_in, last_in, result_valid_in,
    first_out, last_out, replace, sums_done, result_valid_out);
    // Module arguments
    input wire clock;
    input wire reset_in;
    input wire reset;
    input wire first_in;
    input wire last_in;
    input wire result_valid_in;
    output reg first_out;
    output reg last_out;
    output reg replace;
    output reg sums_done;
    output reg result_valid_out;
    // Stub signals
    reg first_clock;
    reg first_clear;
    reg first_d;
    wire first_q;
    reg last_clock;
    reg last_clear;
    reg last_d;
    wire last_q;
    reg gate_first_clock;
    reg gate_first_clear;
    reg gate_first_d;
    wire gate_first_q;
    reg gate_last_clock;
    reg gate_last_clear;
    reg gate_last_d;
    wire gate_last_q;
    reg pair_first_clock;
    reg pair_first_clear;
    reg pair_first_d;
    wire pair_first_q;
    reg pair_last_clock;
    reg pair_last_clear;
    reg pair_last_d;
    wire pair_last_q;
    reg group_first_clock;
    reg group_first_clear;
    reg group_first_d;
    wire group_first_q;
    reg group_last_clock;
    reg group_last_clear;
    reg group_last_d;
    wire group_last_q;
    reg done_d;
    wire done_q;
    reg done_clock;
    reg result_valid_d;
    wire result_valid_q;
    reg result_valid_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_group_first first(
        .clock(first_clock),
        .clear(first_clear),
        .d(first_d),
        .q(first_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first last(
        .clock(last_clock),
        .clear(last_clear),
        .d(last_d),
        .q(last_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gate_first gate_first(
        .clock(gate_first_clock),
        .clear(gate_first_clear),
        .d(gate_first_d),
        .q(gate_first_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gate_first gate_last(
        .clock(gate_last_clock),
        .clear(gate_last_clear),
        .d(gate_last_d),
        .q(gate_last_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gate_first pair_first(
        .clock(pair_first_clock),
        .clear(pair_first_clear),
        .d(pair_first_d),
        .q(pair_first_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gate_first pair_last(
        .clock(pair_last_clock),
        .clear(pair_last_clear),
        .d(pair_last_d),
        .q(pair_last_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first group_first(
        .clock(group_first_clock),
        .clear(group_first_clear),
        .d(group_first_d),
        .q(group_first_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_first group_last(
        .clock(group_last_clock),
        .clear(group_last_clear),
        .d(group_last_d),
        .q(group_last_q)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 done(
        .d(done_d),
        .q(done_q),
        .clock(done_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 result_valid(
        .d(result_valid_d),
        .q(result_valid_q),
        .clock(result_valid_clock)
    );
    // Update code
    always @(*) begin
        done_clock = clock;
        result_valid_clock = clock;
        done_d = done_q;
        result_valid_d = result_valid_q;
        first_clock = clock;
        last_clock = clock;
        gate_first_clock = clock;
        gate_last_clock = clock;
        pair_first_clock = clock;
        pair_last_clock = clock;
        group_first_clock = clock;
        group_last_clock = clock;
        first_clear = reset_in;
        last_clear = reset_in;
        gate_first_clear = reset_in;
        gate_last_clear = reset_in;
        pair_first_clear = reset_in;
        pair_last_clear = reset_in;
        group_first_clear = reset_in;
        group_last_clear = reset_in;
        first_d = first_in;
        last_d = last_in;
        first_out = first_q;
        last_out = last_q;
        gate_first_d = first_q;
        gate_last_d = last_q;
        pair_first_d = gate_first_q;
        pair_last_d = gate_last_q;
        group_first_d = pair_first_q;
        group_last_d = pair_last_q;
        replace = group_first_q;
        done_d = group_last_q & ~reset_in;
        sums_done = done_q;
        result_valid_d = done_q | result_valid_in;
        if (reset_in | reset) begin
            result_valid_d = 1'b0;
        end
        result_valid_out = result_valid_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_power_decoder(mantissa, power);
    // Module arguments
    input wire [5:0] mantissa;
    output reg [5:0] power;
    // Local signals
    reg [5:0] decoded;
    // Update code
    always @(*) begin
        decoded = ((mantissa) & 6'h3f);
        power = decoded;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_square_pair_2(clock, query, photon_a, photon_b, square_a, square_b, far_a,
    far_b);
    // Module arguments
    input wire clock;
    input wire [8:0] query;
    input wire [8:0] photon_a;
    input wire [8:0] photon_b;
    output reg [13:0] square_a;
    output reg [13:0] square_b;
    output reg far_a;
    output reg far_b;
    // Stub signals
    reg [8:0] subtract_0_a;
    reg [8:0] subtract_0_b;
    wire [9:0] subtract_0_difference;
    reg [8:0] subtract_1_a;
    reg [8:0] subtract_1_b;
    wire [9:0] subtract_1_difference;
    reg [9:0] difference_0_d;
    wire [9:0] difference_0_q;
    reg difference_0_clock;
    reg [9:0] difference_1_d;
    wire [9:0] difference_1_q;
    reg difference_1_clock;
    reg digits_0_clock;
    reg [9:0] digits_0_difference;
    wire [13:0] digits_0_square;
    wire digits_0_far;
    reg digits_1_clock;
    reg [9:0] digits_1_difference;
    wire [13:0] digits_1_square;
    wire digits_1_far;
    reg [13:0] square_stage_0_d;
    wire [13:0] square_stage_0_q;
    reg square_stage_0_clock;
    reg [13:0] square_stage_1_d;
    wire [13:0] square_stage_1_q;
    reg square_stage_1_clock;
    reg far_stage_0_d;
    wire far_stage_0_q;
    reg far_stage_0_clock;
    reg far_stage_1_d;
    wire far_stage_1_q;
    reg far_stage_1_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_subtract subtract_0(
        .a(subtract_0_a),
        .b(subtract_0_b),
        .difference(subtract_0_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_subtract subtract_1(
        .a(subtract_1_a),
        .b(subtract_1_b),
        .difference(subtract_1_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_magnitude_delay difference_0(
        .d(difference_0_d),
        .q(difference_0_q),
        .clock(difference_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_magnitude_delay difference_1(
        .d(difference_1_d),
        .q(difference_1_q),
        .clock(difference_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_digits digits_0(
        .clock(digits_0_clock),
        .difference(digits_0_difference),
        .square(digits_0_square),
        .far(digits_0_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_digits digits_1(
        .clock(digits_1_clock),
        .difference(digits_1_difference),
        .square(digits_1_square),
        .far(digits_1_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_0(
        .d(square_stage_0_d),
        .q(square_stage_0_q),
        .clock(square_stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_1(
        .d(square_stage_1_d),
        .q(square_stage_1_q),
        .clock(square_stage_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_0(
        .d(far_stage_0_d),
        .q(far_stage_0_q),
        .clock(far_stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_1(
        .d(far_stage_1_d),
        .q(far_stage_1_q),
        .clock(far_stage_1_clock)
    );
    // Update code
    always @(*) begin
        subtract_0_b = photon_a;
        subtract_1_b = photon_b;
        subtract_0_a = query;
        difference_0_clock = clock;
        difference_0_d = subtract_0_difference;
        square_stage_0_clock = clock;
        far_stage_0_clock = clock;
        subtract_1_a = query;
        difference_1_clock = clock;
        difference_1_d = subtract_1_difference;
        square_stage_1_clock = clock;
        far_stage_1_clock = clock;
        digits_0_clock = clock;
        digits_0_difference = difference_0_q;
        square_stage_0_d = digits_0_square;
        far_stage_0_d = digits_0_far;
        digits_1_clock = clock;
        digits_1_difference = difference_1_q;
        square_stage_1_d = digits_1_square;
        far_stage_1_d = digits_1_far;
        square_a = square_stage_0_q;
        square_b = square_stage_1_q;
        far_a = far_stage_0_q;
        far_b = far_stage_1_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_square_pair(clock, query, photon_a, photon_b, square_a, square_b, far_a,
    far_b);
    // Module arguments
    input wire clock;
    input wire [8:0] query;
    input wire [8:0] photon_a;
    input wire [8:0] photon_b;
    output reg [13:0] square_a;
    output reg [13:0] square_b;
    output reg far_a;
    output reg far_b;
    // Stub signals
    reg [8:0] subtract_0_a;
    reg [8:0] subtract_0_b;
    wire [9:0] subtract_0_difference;
    reg [8:0] subtract_1_a;
    reg [8:0] subtract_1_b;
    wire [9:0] subtract_1_difference;
    reg [9:0] difference_0_d;
    wire [9:0] difference_0_q;
    reg difference_0_clock;
    reg [9:0] difference_1_d;
    wire [9:0] difference_1_q;
    reg difference_1_clock;
    reg product_0_clock;
    reg [9:0] product_0_difference;
    wire [13:0] product_0_square;
    wire product_0_far;
    reg product_1_clock;
    reg [9:0] product_1_difference;
    wire [13:0] product_1_square;
    wire product_1_far;
    reg [13:0] square_stage_0_d;
    wire [13:0] square_stage_0_q;
    reg square_stage_0_clock;
    reg [13:0] square_stage_1_d;
    wire [13:0] square_stage_1_q;
    reg square_stage_1_clock;
    reg far_stage_0_d;
    wire far_stage_0_q;
    reg far_stage_0_clock;
    reg far_stage_1_d;
    wire far_stage_1_q;
    reg far_stage_1_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_subtract subtract_0(
        .a(subtract_0_a),
        .b(subtract_0_b),
        .difference(subtract_0_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_subtract subtract_1(
        .a(subtract_1_a),
        .b(subtract_1_b),
        .difference(subtract_1_difference)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_0(
        .d(difference_0_d),
        .q(difference_0_q),
        .clock(difference_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 difference_1(
        .d(difference_1_d),
        .q(difference_1_q),
        .clock(difference_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_0(
        .clock(product_0_clock),
        .difference(product_0_difference),
        .square(product_0_square),
        .far(product_0_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_product product_1(
        .clock(product_1_clock),
        .difference(product_1_difference),
        .square(product_1_square),
        .far(product_1_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_0(
        .d(square_stage_0_d),
        .q(square_stage_0_q),
        .clock(square_stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_stage square_stage_1(
        .d(square_stage_1_d),
        .q(square_stage_1_q),
        .clock(square_stage_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_0(
        .d(far_stage_0_d),
        .q(far_stage_0_q),
        .clock(far_stage_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far far_stage_1(
        .d(far_stage_1_d),
        .q(far_stage_1_q),
        .clock(far_stage_1_clock)
    );
    // Update code
    always @(*) begin
        subtract_0_b = photon_a;
        subtract_1_b = photon_b;
        subtract_0_a = query;
        difference_0_clock = clock;
        difference_0_d = subtract_0_difference;
        square_stage_0_clock = clock;
        far_stage_0_clock = clock;
        subtract_1_a = query;
        difference_1_clock = clock;
        difference_1_d = subtract_1_difference;
        square_stage_1_clock = clock;
        far_stage_1_clock = clock;
        product_0_clock = clock;
        product_0_difference = difference_0_q;
        square_stage_0_d = product_0_square;
        far_stage_0_d = product_0_far;
        product_1_clock = clock;
        product_1_difference = difference_1_q;
        square_stage_1_d = product_1_square;
        far_stage_1_d = product_1_far;
        square_a = square_stage_0_q;
        square_b = square_stage_1_q;
        far_a = far_stage_0_q;
        far_b = far_stage_1_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_14(d, q, clock);
    // Module arguments
    input wire [13:0] d;
    output reg [13:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 14'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_channel_sum(clock, power_in_0, power_in_1, power_in_2, power_in_3,
    power_0, power_1, power_2, power_3, in_range_0, in_range_1, in_range_2, in_range_3, first,
    done, result_in, result_out);
    // Module arguments
    input wire clock;
    input wire [5:0] power_in_0;
    input wire [5:0] power_in_1;
    input wire [5:0] power_in_2;
    input wire [5:0] power_in_3;
    output reg [5:0] power_0;
    output reg [5:0] power_1;
    output reg [5:0] power_2;
    output reg [5:0] power_3;
    input wire in_range_0;
    input wire in_range_1;
    input wire in_range_2;
    input wire in_range_3;
    input wire first;
    input wire done;
    input wire [11:0] result_in;
    output reg [11:0] result_out;
    // Stub signals
    reg [5:0] hop_0_d;
    wire [5:0] hop_0_q;
    reg hop_0_clock;
    reg [5:0] hop_1_d;
    wire [5:0] hop_1_q;
    reg hop_1_clock;
    reg [5:0] hop_2_d;
    wire [5:0] hop_2_q;
    reg hop_2_clock;
    reg [5:0] hop_3_d;
    wire [5:0] hop_3_q;
    reg hop_3_clock;
    reg [5:0] gated_sum_0_a;
    reg [5:0] gated_sum_0_b;
    reg gated_sum_0_a_in_range;
    reg gated_sum_0_b_in_range;
    wire [6:0] gated_sum_0_sum;
    reg [5:0] gated_sum_1_a;
    reg [5:0] gated_sum_1_b;
    reg gated_sum_1_a_in_range;
    reg gated_sum_1_b_in_range;
    wire [6:0] gated_sum_1_sum;
    reg [6:0] pair_0_d;
    wire [6:0] pair_0_q;
    reg pair_0_clock;
    reg [6:0] pair_1_d;
    wire [6:0] pair_1_q;
    reg pair_1_clock;
    reg [6:0] group_sum_a;
    reg [6:0] group_sum_b;
    wire [7:0] group_sum_sum;
    reg [7:0] group_d;
    wire [7:0] group_q;
    reg group_clock;
    reg [7:0] accumulate_group;
    reg [11:0] accumulate_sum;
    reg accumulate_first;
    wire [11:0] accumulate_next_sum;
    reg [11:0] sum_d;
    wire [11:0] sum_q;
    reg sum_clock;
    reg result_link_done;
    reg [11:0] result_link_own;
    reg [11:0] result_link_further;
    wire [11:0] result_link_result;
    reg [11:0] result_d;
    wire [11:0] result_q;
    reg result_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_6 hop_0(
        .d(hop_0_d),
        .q(hop_0_q),
        .clock(hop_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 hop_1(
        .d(hop_1_d),
        .q(hop_1_q),
        .clock(hop_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 hop_2(
        .d(hop_2_d),
        .q(hop_2_q),
        .clock(hop_2_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_6 hop_3(
        .d(hop_3_d),
        .q(hop_3_q),
        .clock(hop_3_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gated_sum gated_sum_0(
        .a(gated_sum_0_a),
        .b(gated_sum_0_b),
        .a_in_range(gated_sum_0_a_in_range),
        .b_in_range(gated_sum_0_b_in_range),
        .sum(gated_sum_0_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_gated_sum gated_sum_1(
        .a(gated_sum_1_a),
        .b(gated_sum_1_b),
        .a_in_range(gated_sum_1_a_in_range),
        .b_in_range(gated_sum_1_b_in_range),
        .sum(gated_sum_1_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_magnitude pair_0(
        .d(pair_0_d),
        .q(pair_0_q),
        .clock(pair_0_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_magnitude pair_1(
        .d(pair_1_d),
        .q(pair_1_q),
        .clock(pair_1_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_group_sum group_sum(
        .a(group_sum_a),
        .b(group_sum_b),
        .sum(group_sum_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_8 group(
        .d(group_d),
        .q(group_q),
        .clock(group_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_accumulate accumulate(
        .group(accumulate_group),
        .sum(accumulate_sum),
        .first(accumulate_first),
        .next_sum(accumulate_next_sum)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_12 sum(
        .d(sum_d),
        .q(sum_q),
        .clock(sum_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_result_link result_link(
        .done(result_link_done),
        .own(result_link_own),
        .further(result_link_further),
        .result(result_link_result)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_12 result(
        .d(result_d),
        .q(result_q),
        .clock(result_clock)
    );
    // Update code
    always @(*) begin
        hop_0_clock = clock;
        hop_0_d = power_in_0;
        power_0 = hop_0_q;
        hop_1_clock = clock;
        hop_1_d = power_in_1;
        power_1 = hop_1_q;
        hop_2_clock = clock;
        hop_2_d = power_in_2;
        power_2 = hop_2_q;
        hop_3_clock = clock;
        hop_3_d = power_in_3;
        power_3 = hop_3_q;
        gated_sum_0_a = hop_0_q;
        gated_sum_0_b = hop_1_q;
        gated_sum_0_a_in_range = in_range_0;
        gated_sum_0_b_in_range = in_range_1;
        pair_0_d = gated_sum_0_sum;
        gated_sum_1_a = hop_2_q;
        gated_sum_1_b = hop_3_q;
        gated_sum_1_a_in_range = in_range_2;
        gated_sum_1_b_in_range = in_range_3;
        pair_1_d = gated_sum_1_sum;
        pair_0_clock = clock;
        pair_1_clock = clock;
        group_sum_a = pair_0_q;
        group_sum_b = pair_1_q;
        group_clock = clock;
        group_d = group_sum_sum;
        accumulate_group = group_q;
        accumulate_sum = sum_q;
        accumulate_first = first;
        sum_clock = clock;
        sum_d = accumulate_next_sum;
        result_link_done = done;
        result_link_own = sum_q;
        result_link_further = result_in;
        result_clock = clock;
        result_d = result_link_result;
        result_out = result_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_any_far(x, y, z, any);
    // Module arguments
    input wire x;
    input wire y;
    input wire z;
    output reg any;
    // Update code
    always @(*) begin
        any = x | y | z;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_power_of_present(absent, word, power);
    // Module arguments
    input wire absent;
    input wire [5:0] word;
    output reg [5:0] power;
    // Update code
    always @(*) begin
        power = word;
        if (absent) begin
            power = 32'h0;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_pair_sum(a, b, sum);
    // Module arguments
    input wire [13:0] a;
    input wire [13:0] b;
    output reg [14:0] sum;
    // Local signals
    reg [14:0] wide_a;
    reg [14:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 15'h7fff);
        wide_b = ((b) & 15'h7fff);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_distance(d, q, clock);
    // Module arguments
    input wire [15:0] d;
    output reg [15:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_3(d, q, clock);
    // Module arguments
    input wire [2:0] d;
    output reg [2:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 3'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_pair(d, q, clock);
    // Module arguments
    input wire [1:0] d;
    output reg [1:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_15(d, q, clock);
    // Module arguments
    input wire [14:0] d;
    output reg [14:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 15'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_distance_sum(a, b, sum);
    // Module arguments
    input wire [14:0] a;
    input wire [13:0] b;
    output reg [15:0] sum;
    // Local signals
    reg [15:0] wide_a;
    reg [15:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 16'hffff);
        wide_b = ((b) & 16'hffff);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_group_sum_2(a, b, sum);
    // Module arguments
    input wire [1:0] a;
    input wire [1:0] b;
    output reg [2:0] sum;
    // Local signals
    reg [2:0] wide_a;
    reg [2:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 3'h7);
        wide_b = ((b) & 3'h7);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_6(d, q, clock);
    // Module arguments
    input wire [5:0] d;
    output reg [5:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 6'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_8(d, q, clock);
    // Module arguments
    input wire [7:0] d;
    output reg [7:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 8'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_accumulate_2(group, sum, first, next_sum);
    // Module arguments
    input wire [2:0] group;
    input wire [6:0] sum;
    input wire first;
    output reg [6:0] next_sum;
    // Local signals
    reg [6:0] wide_group;
    reg [6:0] kept;
    // Update code
    always @(*) begin
        wide_group = ((group) & 7'h7f);
        kept = sum;
        if (first) begin
            kept = 32'h0;
        end
        next_sum = kept + wide_group;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_12(d, q, clock);
    // Module arguments
    input wire [11:0] d;
    output reg [11:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 12'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_result_link_2(done, own, further, result);
    // Module arguments
    input wire done;
    input wire [6:0] own;
    input wire [6:0] further;
    output reg [6:0] result;
    // Update code
    always @(*) begin
        result = further;
        if (done) begin
            result = own;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_gated_sum_2(a, b, a_in_range, b_in_range, sum);
    // Module arguments
    input wire a;
    input wire b;
    input wire a_in_range;
    input wire b_in_range;
    output reg [1:0] sum;
    // Local signals
    reg [1:0] gated_a;
    reg [1:0] gated_b;
    // Update code
    always @(*) begin
        gated_a = 32'h0;
        gated_b = 32'h0;
        if (a_in_range) begin
            gated_a = ((a) & 2'h3);
        end
        if (b_in_range) begin
            gated_b = ((b) & 2'h3);
        end
        sum = gated_a + gated_b;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_digits(clock, difference, square, far);
    // Module arguments
    input wire clock;
    input wire [9:0] difference;
    output reg [13:0] square;
    output reg far;
    // Stub signals
    reg [9:0] magnitude_of_difference;
    wire [8:0] magnitude_of_magnitude;
    reg [8:0] magnitude_d;
    wire [8:0] magnitude_q;
    reg magnitude_clock;
    reg [8:0] split_magnitude_magnitude;
    wire [6:0] split_magnitude_counted;
    wire split_magnitude_far;
    reg [6:0] digit_products_magnitude;
    wire [5:0] digit_products_low_product;
    wire [3:0] digit_products_high_product;
    reg [6:0] products_magnitude_d;
    wire [6:0] products_magnitude_q;
    reg products_magnitude_clock;
    reg [5:0] low_product_d;
    wire [5:0] low_product_q;
    reg low_product_clock;
    reg [3:0] high_product_d;
    wire [3:0] high_product_q;
    reg high_product_clock;
    reg products_far_d;
    wire products_far_q;
    reg products_far_clock;
    reg [5:0] cross_sum_low_product;
    reg [3:0] cross_sum_high_product;
    wire [6:0] cross_sum_cross_product;
    reg [6:0] cross_magnitude_d;
    wire [6:0] cross_magnitude_q;
    reg cross_magnitude_clock;
    reg [6:0] cross_product_d;
    wire [6:0] cross_product_q;
    reg cross_product_clock;
    reg cross_far_d;
    wire cross_far_q;
    reg cross_far_clock;
    reg [6:0] square_sum_magnitude;
    reg [6:0] square_sum_cross_product;
    wire [13:0] square_sum_square;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_magnitude_of magnitude_of(
        .difference(magnitude_of_difference),
        .magnitude(magnitude_of_magnitude)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_9 magnitude(
        .d(magnitude_d),
        .q(magnitude_q),
        .clock(magnitude_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_split_magnitude split_magnitude(
        .magnitude(split_magnitude_magnitude),
        .counted(split_magnitude_counted),
        .far(split_magnitude_far)
    );
    photoncube_leaf_5_local7_rgb6d_n64_digit_products digit_products(
        .magnitude(digit_products_magnitude),
        .low_product(digit_products_low_product),
        .high_product(digit_products_high_product)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_magnitude products_magnitude(
        .d(products_magnitude_d),
        .q(products_magnitude_q),
        .clock(products_magnitude_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_low_product low_product(
        .d(low_product_d),
        .q(low_product_q),
        .clock(low_product_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_high_product high_product(
        .d(high_product_d),
        .q(high_product_q),
        .clock(high_product_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_products_far products_far(
        .d(products_far_d),
        .q(products_far_q),
        .clock(products_far_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_cross_sum cross_sum(
        .low_product(cross_sum_low_product),
        .high_product(cross_sum_high_product),
        .cross_product(cross_sum_cross_product)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_7 cross_magnitude(
        .d(cross_magnitude_d),
        .q(cross_magnitude_q),
        .clock(cross_magnitude_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_7 cross_product(
        .d(cross_product_d),
        .q(cross_product_q),
        .clock(cross_product_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_1 cross_far(
        .d(cross_far_d),
        .q(cross_far_q),
        .clock(cross_far_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_square_sum square_sum(
        .magnitude(square_sum_magnitude),
        .cross_product(square_sum_cross_product),
        .square(square_sum_square)
    );
    // Update code
    always @(*) begin
        magnitude_clock = clock;
        products_magnitude_clock = clock;
        low_product_clock = clock;
        high_product_clock = clock;
        products_far_clock = clock;
        cross_magnitude_clock = clock;
        cross_product_clock = clock;
        cross_far_clock = clock;
        magnitude_of_difference = difference;
        magnitude_d = magnitude_of_magnitude;
        split_magnitude_magnitude = magnitude_q;
        digit_products_magnitude = split_magnitude_counted;
        products_magnitude_d = split_magnitude_counted;
        low_product_d = digit_products_low_product;
        high_product_d = digit_products_high_product;
        products_far_d = split_magnitude_far;
        cross_sum_low_product = low_product_q;
        cross_sum_high_product = high_product_q;
        cross_magnitude_d = products_magnitude_q;
        cross_product_d = cross_sum_cross_product;
        cross_far_d = products_far_q;
        square_sum_magnitude = cross_magnitude_q;
        square_sum_cross_product = cross_product_q;
        square = square_sum_square;
        far = cross_far_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_gate_first(clock, clear, d, q);
    // Module arguments
    input wire clock;
    input wire clear;
    input wire d;
    output reg q;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_product(clock, difference, square, far);
    // Module arguments
    input wire clock;
    input wire [9:0] difference;
    output reg [13:0] square;
    output reg far;
    // Stub signals
    reg [9:0] magnitude_delay_d;
    wire [9:0] magnitude_delay_q;
    reg magnitude_delay_clock;
    reg [9:0] products_delay_d;
    wire [9:0] products_delay_q;
    reg products_delay_clock;
    reg [9:0] difference_product_difference;
    wire [17:0] difference_product_product;
    reg [17:0] product_d;
    wire [17:0] product_q;
    reg product_clock;
    reg [17:0] split_product_product;
    wire [13:0] split_product_square;
    wire split_product_far;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_magnitude_delay magnitude_delay(
        .d(magnitude_delay_d),
        .q(magnitude_delay_q),
        .clock(magnitude_delay_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_10 products_delay(
        .d(products_delay_d),
        .q(products_delay_q),
        .clock(products_delay_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_difference_product difference_product(
        .difference(difference_product_difference),
        .product(difference_product_product)
    );
    photoncube_leaf_5_local7_rgb6d_n64_register_18 product(
        .d(product_d),
        .q(product_q),
        .clock(product_clock)
    );
    photoncube_leaf_5_local7_rgb6d_n64_split_product split_product(
        .product(split_product_product),
        .square(split_product_square),
        .far(split_product_far)
    );
    // Update code
    always @(*) begin
        magnitude_delay_clock = clock;
        products_delay_clock = clock;
        product_clock = clock;
        magnitude_delay_d = difference;
        products_delay_d = magnitude_delay_q;
        difference_product_difference = products_delay_q;
        product_d = difference_product_product;
        split_product_product = product_q;
        square = split_product_square;
        far = split_product_far;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_group_first(clock, clear, d, q);
    // Module arguments
    input wire clock;
    input wire clear;
    input wire d;
    output reg q;
    // Stub signals
    reg flag_0_d;
    wire flag_0_q;
    reg flag_0_clock;
    // Sub module instances
    photoncube_leaf_5_local7_rgb6d_n64_register_1 flag_0(
        .d(flag_0_d),
        .q(flag_0_q),
        .clock(flag_0_clock)
    );
    // Update code
    always @(*) begin
        q = d;
        flag_0_clock = clock;
        flag_0_d = d & ~clear;
        q = flag_0_q;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_group_sum(a, b, sum);
    // Module arguments
    input wire [6:0] a;
    input wire [6:0] b;
    output reg [7:0] sum;
    // Local signals
    reg [7:0] wide_a;
    reg [7:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 8'hff);
        wide_b = ((b) & 8'hff);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_subtract(a, b, difference);
    // Module arguments
    input wire [8:0] a;
    input wire [8:0] b;
    output reg [9:0] difference;
    // Local signals
    reg [9:0] wide_a;
    reg [9:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 10'h3ff);
        wide_b = ((b) & 10'h3ff);
        difference = wide_a - wide_b;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_range_of_format(distance, far, in_range);
    // Module arguments
    input wire [15:0] distance;
    input wire far;
    output reg in_range;
    // Constant declarations
    localparam limit = 16'h3e04;
    // Local signals
    reg near;
    // Update code
    always @(*) begin
        near = distance <= limit;
        in_range = near & ~far;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_accumulate(group, sum, first, next_sum);
    // Module arguments
    input wire [7:0] group;
    input wire [11:0] sum;
    input wire first;
    output reg [11:0] next_sum;
    // Local signals
    reg [11:0] wide_group;
    reg [11:0] kept;
    // Update code
    always @(*) begin
        wide_group = ((group) & 12'hfff);
        kept = sum;
        if (first) begin
            kept = 32'h0;
        end
        next_sum = kept + wide_group;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_result_link(done, own, further, result);
    // Module arguments
    input wire done;
    input wire [11:0] own;
    input wire [11:0] further;
    output reg [11:0] result;
    // Update code
    always @(*) begin
        result = further;
        if (done) begin
            result = own;
        end
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_gated_sum(a, b, a_in_range, b_in_range, sum);
    // Module arguments
    input wire [5:0] a;
    input wire [5:0] b;
    input wire a_in_range;
    input wire b_in_range;
    output reg [6:0] sum;
    // Local signals
    reg [6:0] gated_a;
    reg [6:0] gated_b;
    // Update code
    always @(*) begin
        gated_a = 32'h0;
        gated_b = 32'h0;
        if (a_in_range) begin
            gated_a = ((a) & 7'h7f);
        end
        if (b_in_range) begin
            gated_b = ((b) & 7'h7f);
        end
        sum = gated_a + gated_b;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_square_stage(d, q, clock);
    // Module arguments
    input wire [13:0] d;
    output reg [13:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_18(d, q, clock);
    // Module arguments
    input wire [17:0] d;
    output reg [17:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 18'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_9(d, q, clock);
    // Module arguments
    input wire [8:0] d;
    output reg [8:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 9'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_cross_sum(low_product, high_product, cross_product);
    // Module arguments
    input wire [5:0] low_product;
    input wire [3:0] high_product;
    output reg [6:0] cross_product;
    // Update code (custom)
    wire [4:0] upper = low_product[5:2] + high_product;
    always @(*) cross_product = {upper, low_product[1:0]};
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_1(d, q, clock);
    // Module arguments
    input wire d;
    output reg q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 1'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_square_sum(magnitude, cross_product, square);
    // Module arguments
    input wire [6:0] magnitude;
    input wire [6:0] cross_product;
    output reg [13:0] square;
    // Update code (custom)
    function [7:0] high_square;
      input [3:0] digit;
      case (digit)
        4'd0: high_square = 8'd0;
        4'd1: high_square = 8'd1;
        4'd2: high_square = 8'd4;
        4'd3: high_square = 8'd9;
        4'd4: high_square = 8'd16;
        4'd5: high_square = 8'd25;
        4'd6: high_square = 8'd36;
        4'd7: high_square = 8'd49;
        4'd8: high_square = 8'd64;
        4'd9: high_square = 8'd81;
        4'd10: high_square = 8'd100;
        4'd11: high_square = 8'd121;
        4'd12: high_square = 8'd144;
        4'd13: high_square = 8'd169;
        4'd14: high_square = 8'd196;
        default: high_square = 8'd225;
      endcase
    endfunction
    function [5:0] low_square;
      input [2:0] digit;
      case (digit)
        3'd0: low_square = 6'd0;
        3'd1: low_square = 6'd1;
        3'd2: low_square = 6'd4;
        3'd3: low_square = 6'd9;
        3'd4: low_square = 6'd16;
        3'd5: low_square = 6'd25;
        3'd6: low_square = 6'd36;
        default: low_square = 6'd49;
      endcase
    endfunction
    wire [13:0] squares = {high_square(magnitude[6:3]), low_square(magnitude[2:0])};
    wire [9:0] upper = squares[13:4] + {3'd0, cross_product};
    always @(*) square = {upper, squares[3:0]};
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_low_product(d, q, clock);
    // Module arguments
    input wire [5:0] d;
    output reg [5:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_products_far(d, q, clock);
    // Module arguments
    input wire d;
    output reg q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_magnitude_of(difference, magnitude);
    // Module arguments
    input wire [9:0] difference;
    output reg [8:0] magnitude;
    // Update code (custom)
    wire negative = difference[9];
    wire [8:0] inverted = difference[8:0] ^ {9{negative}};
    always @(*) magnitude = inverted + {8'd0, negative};
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_high_product(d, q, clock);
    // Module arguments
    input wire [3:0] d;
    output reg [3:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_digit_products(magnitude, low_product, high_product);
    // Module arguments
    input wire [6:0] magnitude;
    output reg [5:0] low_product;
    output reg [3:0] high_product;
    // Update code (custom)
    wire [3:0] high = magnitude[6:3];
    always @(*) low_product = {2'd0, high & {4{magnitude[0]}}} + {1'd0, high & {4{magnitude[1]}}, 1'd0};
    always @(*) high_product = {high & {4{magnitude[2]}}};
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_split_product(product, square, far);
    // Module arguments
    input wire [17:0] product;
    output reg [13:0] square;
    output reg far;
    // Update code (custom)
    always @(*) square = product[13:0];
    always @(*) far = |product[17:14];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_split_magnitude(magnitude, counted, far);
    // Module arguments
    input wire [8:0] magnitude;
    output reg [6:0] counted;
    output reg far;
    // Update code (custom)
    always @(*) counted = magnitude[6:0];
    always @(*) far = |magnitude[8:7];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_7(d, q, clock);
    // Module arguments
    input wire [6:0] d;
    output reg [6:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 7'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_register_10(d, q, clock);
    // Module arguments
    input wire [9:0] d;
    output reg [9:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 10'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_magnitude_delay(d, q, clock);
    // Module arguments
    input wire [9:0] d;
    output reg [9:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_products_magnitude(d, q, clock);
    // Module arguments
    input wire [6:0] d;
    output reg [6:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_difference_product(difference, product);
    // Module arguments
    input wire [9:0] difference;
    output reg [17:0] product;
    // Update code (custom)
    wire signed [9:0] d = difference;
    wire signed [19:0] squared = d * d;
    always @(*) product = squared[17:0];
endmodule
