// Holds batches of queries, and gives the chain each batch once for each of its rounds, with the radii of the round.
module @TOP@_rounds(clock, reset, nearest, rungs, radii, query_valid, query_ready, query, given_valid, given_ready, given,
    found_valid, found_ready, found, result_valid, result_ready, result);
    // Bits of a query's fields, and the place of its radius, below which is release. Above the fields are tlast and whether it is outside.
    parameter QUERY = 3;
    parameter RADIUS_LOW = 2;
    parameter RADIUS = 1;
    // Bits of a result's sums and count; the place of the count. Above them is the tag.
    parameter SUMS = 1;
    parameter COUNT_LOW = 0;
    parameter COUNT = 1;
    parameter TAG = 1;
    // Bits of a query's position in its batch, and the last position.
    parameter POSITION = 1;
    parameter LAST_POSITION = 0;
    // The largest radius, and the rounds that find the k nearest.
    parameter LARGEST = 0;
    parameter NEAREST_ROUNDS = 1;
    localparam PLACES = @PLACES@;
    localparam PLACE = @PLACE@;
    localparam ROUND = @ROUND@;
    localparam [ROUND - 1:0] MOST_RUNGS = @RUNGS@;
    localparam RELEASE = RADIUS_LOW - 1;
    input wire clock;
    input wire reset;
    input wire [COUNT - 1:0] nearest;
    input wire [@RUNGS_HIGH@:0] rungs;
    // Of the rungs, each at most the largest.
    input wire [@RUNGS@ * RADIUS - 1:0] radii;
    input wire query_valid;
    output wire query_ready;
    input wire [QUERY + 1:0] query;
    output wire given_valid;
    input wire given_ready;
    output wire [QUERY + 1:0] given;
    input wire found_valid;
    output wire found_ready;
    input wire [SUMS + TAG - 1:0] found;
    output wire result_valid;
    input wire result_ready;
    // From the highest bit: whether it is the query's last result, the radius, the tag, the sums.
    output wire [SUMS + TAG + RADIUS:0] result;
    // Each place: it has a whole batch; a round of it is under way; a round is left to give; it releases the set.
    reg [PLACES - 1:0] complete;
    reg [PLACES - 1:0] under_way;
    reg [PLACES - 1:0] has_left;
    reg [PLACES - 1:0] releases;
    reg [PLACES - 1:0] finds_nearest;
    reg [PLACES - 1:0] is_ladder;
    reg [POSITION - 1:0] ends [0:PLACES - 1];
    reg [ROUND - 1:0] all_rounds [0:PLACES - 1];
    reg [ROUND - 1:0] rounds_given [0:PLACES - 1];
    // Whether the next round is the batch's last; whether the batch was given fewer rounds than that in the place before.
    reg [PLACES - 1:0] is_last_next;
    reg [PLACES - 1:0] is_behind;
    // Whether a round was given; and in the search for the k nearest, the bit of the next round, less one.
    reg [PLACES - 1:0] is_begun;
    reg [RADIUS - 1:0] below_bit [0:PLACES - 1];
    // Each query of each place; its radius is at most the largest.
    reg [QUERY + 1:0] queries [0:(PLACES << POSITION) - 1];
    reg [RADIUS - 1:0] radius_given [0:(PLACES << POSITION) - 1];
    reg [RADIUS - 1:0] numbers [0:(PLACES << POSITION) - 1];
    reg [SUMS - 1:0] kept [0:(PLACES << POSITION) - 1];
    // The places whose results come back, in their order. A ladder is there once.
    reg [PLACE - 1:0] order [0:PLACES - 1];
    reg [PLACE - 1:0] order_write;
    reg [PLACE - 1:0] order_read;
    reg [PLACE - 1:0] fill;
    reg [POSITION - 1:0] fill_position;
    reg fill_releases;
    reg held;
    // The place of the oldest batch with a round left.
    reg [PLACE - 1:0] first;
    reg [PLACE - 1:0] turn;
    reg [POSITION - 1:0] position;
    // Whether a query was given to the chain in the clock before; its place and position; its radius.
    reg given_before;
    reg [PLACE + POSITION - 1:0] query_before;
    reg [RADIUS - 1:0] radius_before;
    // The place and position of the query whose result comes back next.
    reg [PLACE - 1:0] back;
    reg [POSITION - 1:0] back_position;
    // The round of a ladder whose results come back.
    reg [ROUND - 1:0] back_round;
    // What the store holds of that query, read in the clock before: the kind of its batch; whether the round is the batch's last, and
    // whether its results are shown; whether the query is the last of its batch; its radius, its number and the sums that were kept.
    // Nothing of this changes in the clock before the query's result comes: results come from a place for one word, hence at most in every
    // second clock, and a result comes some clocks after its query was given.
    reg back_is_ladder;
    reg back_is_nearest;
    reg back_is_last;
    reg back_shows;
    reg back_ends;
    reg [RADIUS - 1:0] back_radius;
    reg [RADIUS - 1:0] back_number;
    reg [SUMS - 1:0] back_kept;
    initial complete = {PLACES{1'b0}};
    initial under_way = {PLACES{1'b0}};
    initial has_left = {PLACES{1'b0}};
    initial order_write = {PLACE{1'b0}};
    initial order_read = {PLACE{1'b0}};
    initial fill = {PLACE{1'b0}};
    initial fill_position = {POSITION{1'b0}};
    initial held = 1'b0;
    initial first = {PLACE{1'b0}};
    initial turn = {PLACE{1'b0}};
    initial position = {POSITION{1'b0}};
    initial given_before = 1'b0;
    initial back_position = {POSITION{1'b0}};
    initial back_round = {ROUND{1'b0}};

    // A query is taken.
    assign query_ready = ~complete[fill] & ~held & ~reset;
    wire takes = query_valid & query_ready;
    wire completes = takes & (query[QUERY] | (fill_position == LAST_POSITION));
    wire releases_now = query[RELEASE] | (fill_releases & (|fill_position));
    wire [PLACE - 1:0] fill_before = fill - 1'b1;
    wire nearest_now = |nearest;
    wire [ROUND - 1:0] rungs_asked = {{(ROUND - @RUNGS_BITS@){1'b0}}, rungs};
    wire [ROUND - 1:0] ladder_rounds = (rungs_asked > MOST_RUNGS) ? MOST_RUNGS : rungs_asked;
    wire ladder_now = ~nearest_now & (|rungs);
    wire [RADIUS - 1:0] radius_taken = query[RADIUS_LOW +: RADIUS];
    wire [RADIUS - 1:0] radius_kept = (radius_taken > LARGEST) ? LARGEST : radius_taken;

    // A query is given to the chain.
    wire [ROUND - 1:0] round = rounds_given[turn];
    wire [ROUND - 1:0] next_round = round + 1'b1;
    wire is_last_round = is_last_next[turn];
    wire [PLACE - 1:0] place_before = turn - 1'b1;
    wire [PLACE - 1:0] place_behind = turn + 1'b1;
    wire follows = finds_nearest[turn] & ~is_last_round & is_behind[turn];
    assign given_valid = has_left[turn] & (is_ladder[turn] | ~under_way[turn]) & ((turn == first) | follows);
    wire [QUERY + 1:0] word = queries[{turn, position}];
    wire [RADIUS - 1:0] number = is_begun[turn] ? numbers[{turn, position}] : {RADIUS{1'b0}};
    wire [RADIUS - 1:0] below = number | below_bit[turn];
    wire [RADIUS - 1:0] nearest_radius = (below > LARGEST) ? LARGEST : below;
    wire [RADIUS - 1:0] ladder_radius = radii[round[@RUNG_HIGH@:0] * RADIUS +: RADIUS];
    wire [RADIUS - 1:0] own_radius = is_ladder[turn] ? ladder_radius : word[RADIUS_LOW +: RADIUS];
    wire [RADIUS - 1:0] radius = finds_nearest[turn] ? nearest_radius : own_radius;
    assign given = {word[QUERY + 1:RADIUS_LOW + RADIUS], radius, word[RELEASE] & is_last_round, word[RELEASE - 1:0]};
    wire gives = given_valid & given_ready;
    wire gives_last = gives & (position == ends[turn]);

    // A result of the oldest round comes back.
    wire is_last = is_ladder[back] ? (back_round + 1'b1 == all_rounds[back]) : ~has_left[back];
    wire [RADIUS - 1:0] ladder_back = radii[back_round[@RUNG_HIGH@:0] * RADIUS +: RADIUS];
    wire [SUMS - 1:0] sums = found[SUMS - 1:0];
    wire enough = sums[COUNT_LOW +: COUNT] >= nearest;
    wire [RADIUS - 1:0] number_if_fewer = back_radius + 1'b1;
    wire [RADIUS - 1:0] number_next = enough ? back_number : number_if_fewer;
    assign result_valid = found_valid & back_shows;
    assign found_ready = ~back_shows | result_ready;
    wire comes = found_valid & found_ready;
    wire comes_last = comes & back_ends;
    wire ends_round = comes_last & (~back_is_ladder | back_is_last);
    wire [PLACE - 1:0] order_read_next = order_read + ends_round;
    // A number is at most the largest radius and one more. Both radii are known before the count is compared.
    wire [RADIUS - 1:0] radius_if_enough = (back_number == LARGEST + 1) ? LARGEST : back_number;
    wire [RADIUS - 1:0] radius_if_fewer = (back_radius == LARGEST) ? LARGEST : number_if_fewer;
    wire [RADIUS - 1:0] reached = enough ? radius_if_enough : radius_if_fewer;
    wire [RADIUS - 1:0] radius_shown = back_is_nearest ? reached : back_radius;
    wire [SUMS - 1:0] sums_shown = (back_is_nearest & enough & (|back_number)) ? back_kept : sums;
    assign result = {back_is_last, radius_shown, found[SUMS + TAG - 1:SUMS], sums_shown};

    always @(posedge clock) begin
        if (takes) begin
            queries[{fill, fill_position}] <= {query[QUERY + 1:RADIUS_LOW + RADIUS], radius_kept, query[RADIUS_LOW - 1:0]};
            fill_position <= fill_position + 1'b1;
            fill_releases <= releases_now;
        end
        if (completes) begin
            complete[fill] <= 1'b1;
            has_left[fill] <= 1'b1;
            releases[fill] <= releases_now;
            finds_nearest[fill] <= nearest_now;
            is_ladder[fill] <= ladder_now;
            ends[fill] <= fill_position;
            all_rounds[fill] <= nearest_now ? NEAREST_ROUNDS : ladder_now ? ladder_rounds : 1;
            is_last_next[fill] <= ~nearest_now & (~ladder_now | (ladder_rounds == 1));
            rounds_given[fill] <= {ROUND{1'b0}};
            is_begun[fill] <= 1'b0;
            below_bit[fill] <= {(NEAREST_ROUNDS - 1){1'b1}};
            held <= releases_now;
            fill_position <= {POSITION{1'b0}};
            fill <= fill + 1'b1;
        end
        given_before <= gives;
        query_before <= {turn, position};
        radius_before <= radius;
        if (given_before) radius_given[query_before] <= radius_before;
        if (gives) position <= position + 1'b1;
        if (gives_last) begin
            under_way[turn] <= 1'b1;
            rounds_given[turn] <= next_round;
            is_last_next[turn] <= next_round + 1'b1 == all_rounds[turn];
            is_behind[turn] <= next_round < rounds_given[place_before];
            is_behind[place_behind] <= rounds_given[place_behind] < next_round;
            is_begun[turn] <= 1'b1;
            below_bit[turn] <= below_bit[turn] >> 1;
            if (~is_ladder[turn] | ~(|round)) begin
                order[order_write] <= turn;
                order_write <= order_write + 1'b1;
            end
            position <= {POSITION{1'b0}};
            if (is_last_round) begin
                has_left[turn] <= 1'b0;
                first <= first + 1'b1;
                if (releases[turn]) held <= 1'b0;
            end
        end
        // No round of the new batch was given, and the round that is given may be the first of the batch before.
        if (completes) is_behind[fill] <= is_begun[fill_before] | (gives_last & (turn == fill_before));
        if (~given_valid | (gives_last & (~is_ladder[turn] | is_last_round))) turn <= place_behind;
        order_read <= order_read_next;
        back <= order[order_read_next];
        back_is_ladder <= is_ladder[back];
        back_is_nearest <= finds_nearest[back];
        back_is_last <= is_last;
        back_shows <= ~finds_nearest[back] | is_last;
        back_ends <= back_position == ends[back];
        back_radius <= is_ladder[back] ? ladder_back : radius_given[{back, back_position}];
        back_number <= (rounds_given[back] == 1) ? {RADIUS{1'b0}} : numbers[{back, back_position}];
        back_kept <= kept[{back, back_position}];
        if (comes) begin
            numbers[{back, back_position}] <= number_next;
            if (~enough) kept[{back, back_position}] <= sums;
            back_position <= back_position + 1'b1;
        end
        if (comes_last) begin
            back_position <= {POSITION{1'b0}};
            back_round <= back_round + 1'b1;
            if (ends_round) begin
                under_way[back] <= 1'b0;
                back_round <= {ROUND{1'b0}};
            end
            if (back_is_last) complete[back] <= 1'b0;
        end
        if (reset) begin
            complete <= {PLACES{1'b0}};
            under_way <= {PLACES{1'b0}};
            has_left <= {PLACES{1'b0}};
            order_write <= {PLACE{1'b0}};
            order_read <= {PLACE{1'b0}};
            fill <= {PLACE{1'b0}};
            fill_position <= {POSITION{1'b0}};
            held <= 1'b0;
            first <= {PLACE{1'b0}};
            turn <= {PLACE{1'b0}};
            position <= {POSITION{1'b0}};
            given_before <= 1'b0;
            back_position <= {POSITION{1'b0}};
            back_round <= {ROUND{1'b0}};
        end
    end
endmodule
