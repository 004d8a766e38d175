// Checks the counters of sectors.v against a plain count: 40 queries of 100 groups, then a few empty groups.
module sectors_tb;
    parameter FULL = 1;
    parameter RINGS = 2;
    localparam SECTORS = 4 * RINGS;
    localparam WIDTH = FULL ? 15 : 8;
    reg clock = 0;
    reg [71:0] distance = 0;
    reg [3:0] far = 0;
    reg [15:0] radius_sq = 0;
    reg [11:0] signs = 0;
    reg [1:0] axes = 0;
    reg [3:0] in_range = 0;
    reg first = 0;
    reg done = 0;
    wire [SECTORS * WIDTH - 1:0] counts;
    sectors #(.FULL(FULL), .RINGS(RINGS)) dut(.clock(clock), .distance(distance), .far(far), .radius_sq(radius_sq), .signs(signs), .axes(axes),
        .in_range(in_range), .first(first), .done(done), .counts(counts));

    // The signs of the groups under way: those of a group come four clocks before its distances.
    reg [11:0] ahead [0:4];
    reg [3:0] flags;
    integer expected [0:7];
    integer query, group, lane, i, sector, wrong;
    reg [17:0] d;
    reg [2:0] sign;

    initial begin
        wrong = 0;
        for (query = 0; query < 40; query = query + 1) begin
            axes = query % 3;
            radius_sq = 1000 + $urandom % 60000;
            for (i = 0; i < SECTORS; i = i + 1) expected[i] = 0;
            for (i = 0; i < 5; i = i + 1) ahead[i] = $urandom;
            // Groups below 0 only bring the signs of the first ones; from 100 on, groups are empty.
            for (group = -4; group < 110; group = group + 1) begin
                signs = ahead[4];
                flags = 0;
                for (lane = 0; lane < 4; lane = lane + 1) begin
                    d = $urandom % (2 * radius_sq);
                    // On the borders, too.
                    if (group % 10 == 3) d = radius_sq / 2;
                    if (group % 10 == 4) d = radius_sq / 2 + 1;
                    far[lane] = $urandom % 8 == 0;
                    distance[18 * lane +: 18] = d;
                    sign = ahead[0] >> 3 * lane;
                    flags[lane] = group >= 0 && group < 100 && d <= radius_sq && !far[lane];
                    // Counters of 8 bits hold no more.
                    if (!FULL && group > 60) flags[lane] = 0;
                    if (flags[lane]) begin
                        sector = (RINGS == 2 && d > radius_sq / 2 ? 4 : 0) + (axes == 0 ? 2 * sign[1] : 2 * sign[0])
                            + (axes == 2 ? sign[1] : sign[2]);
                        expected[sector] = expected[sector] + 1;
                    end
                end
                // The first group is added three clocks after its distances.
                first = group == 3;
                done = group == 108;
                @(posedge clock);
                #1 in_range = flags;
                for (i = 0; i < 4; i = i + 1) ahead[i] = ahead[i + 1];
                ahead[4] = $urandom;
            end
            for (i = 0; i < SECTORS; i = i + 1)
                if (counts[WIDTH * i +: WIDTH] !== expected[i]) begin
                    $display("query %0d, sector %0d: found %0d, expected %0d", query, i, counts[WIDTH * i +: WIDTH], expected[i]);
                    wrong = wrong + 1;
                end
        end
        if (wrong == 0) $display("right: %0d queries", query);
        $finish;
    end

    always #5 clock = ~clock;
endmodule
