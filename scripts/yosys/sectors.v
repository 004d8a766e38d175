// The counters of the chi-square rule, for a measurement of their area: scripts/yosys/sectors.sh.
// Photons of `stream` in range of a query are counted in 8 sectors. A sector is 4 ring + 2 u + v: ring is 0 where d^2 is at most half of the
// squared radius or where there is one ring, u and v are the signs of the differences along the two axes that `axes` selects.

// Delays two signs by the clocks from a difference to its photon's squared distance: two in the squarer, one for each sum.
module sectors_signs(clock, signs, axes, delayed);
    input wire clock;
    input wire [2:0] signs;
    input wire [1:0] axes;
    output wire [1:0] delayed;
    parameter CLOCKS = 4;
    reg [2 * CLOCKS - 1:0] held;
    wire u = axes == 2'd0 ? signs[1] : signs[0];
    wire v = axes == 2'd2 ? signs[1] : signs[2];
    always @(posedge clock) held <= {held[2 * CLOCKS - 3:0], u, v};
    assign delayed = held[2 * CLOCKS - 1:2 * CLOCKS - 2];
endmodule

// The flags of one photon, a clock after its squared distance: its sector, one of eight bits.
module sectors_photon(clock, distance, far, radius_sq, signs, axes, sector);
    parameter RINGS = 2;
    input wire clock;
    input wire [17:0] distance;
    input wire far;
    input wire [15:0] radius_sq;
    input wire [2:0] signs;
    input wire [1:0] axes;
    output wire [7:0] sector;
    wire near;
    wire [1:0] quadrant_d;
    reg ring;
    reg [1:0] quadrant;
    generate
        if (RINGS == 2) begin : rings
            photoncube_stream_range_of_query half(.distance(distance), .far(far), .largest({1'b0, radius_sq[15:1]}), .in_range(near));
        end else begin : disc
            assign near = 1'b1;
        end
    endgenerate
    sectors_signs signs_of(.clock(clock), .signs(signs), .axes(axes), .delayed(quadrant_d));
    always @(posedge clock) begin
        ring <= ~near;
        quadrant <= quadrant_d;
    end
    assign sector = 8'd1 << {ring, quadrant};
endmodule

// Counts the photons of one sector. `first` says that the group that is added begins a query; `done` takes a whole count into the
// result, where there is one.
module sectors_counter(clock, sector, in_range, first, done, count);
    parameter FULL = 1;
    localparam WIDTH = FULL ? 15 : 8;
    input wire clock;
    input wire [3:0] sector;
    input wire [3:0] in_range;
    input wire first;
    input wire done;
    output wire [WIDTH - 1:0] count;
    wire [1:0] pair_a_d, pair_b_d;
    wire [2:0] group_d;
    wire [WIDTH - 1:0] next;
    reg [1:0] pair_a, pair_b;
    reg [2:0] group;
    reg [WIDTH - 1:0] sum;
    photoncube_stream_gated_sum_2 gated_a(.a(sector[0]), .b(sector[1]), .a_in_range(in_range[0]), .b_in_range(in_range[1]),
        .sum(pair_a_d));
    photoncube_stream_gated_sum_2 gated_b(.a(sector[2]), .b(sector[3]), .a_in_range(in_range[2]), .b_in_range(in_range[3]),
        .sum(pair_b_d));
    photoncube_stream_group_sum_2 both(.a(pair_a), .b(pair_b), .sum(group_d));
    always @(posedge clock) begin
        pair_a <= pair_a_d;
        pair_b <= pair_b_d;
        group <= group_d;
        sum <= next;
    end
    generate
        if (FULL) begin : full
            reg [WIDTH - 1:0] result;
            wire [WIDTH - 1:0] result_d;
            photoncube_stream_accumulate_2 accumulate(.group(group), .sum(sum), .first(first), .next_sum(next));
            photoncube_stream_result_link_2 link(.done(done), .own(sum), .further(result), .result(result_d));
            always @(posedge clock) result <= result_d;
            assign count = result;
        end else begin : least
            assign next = (first ? 8'd0 : sum) + group;
            assign count = sum;
        end
    endgenerate
endmodule

// `in_range` is the machine's own, a clock after the distances. `first` and `done` come when the counters need them.
module sectors(clock, distance, far, radius_sq, signs, axes, in_range, first, done, counts);
    parameter FULL = 1;
    parameter RINGS = 2;
    localparam SECTORS = 4 * RINGS;
    localparam WIDTH = FULL ? 15 : 8;
    input wire clock;
    input wire [4 * 18 - 1:0] distance;
    input wire [3:0] far;
    input wire [15:0] radius_sq;
    input wire [4 * 3 - 1:0] signs;
    input wire [1:0] axes;
    input wire [3:0] in_range;
    input wire first;
    input wire done;
    output wire [SECTORS * WIDTH - 1:0] counts;
    wire [4 * 8 - 1:0] sector;
    genvar i;
    generate
        for (i = 0; i < 4; i = i + 1) begin : photon
            sectors_photon #(.RINGS(RINGS)) flags(.clock(clock), .distance(distance[18 * i +: 18]), .far(far[i]), .radius_sq(radius_sq),
                .signs(signs[3 * i +: 3]), .axes(axes), .sector(sector[8 * i +: 8]));
        end
        for (i = 0; i < SECTORS; i = i + 1) begin : counter
            sectors_counter #(.FULL(FULL)) sum(.clock(clock), .sector({sector[24 + i], sector[16 + i], sector[8 + i], sector[i]}),
                .in_range(in_range), .first(first), .done(done), .count(counts[WIDTH * i +: WIDTH]));
        end
    endgenerate
endmodule
