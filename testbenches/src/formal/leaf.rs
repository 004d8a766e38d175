//! The properties of leaf machines: the boxes around groups and batches, the comparison that decides which groups are
//! played, and the control blocks from the sets that are read in to the tags of the results. The units and sums of the
//! chain of engines are those of [`super::spatial`].

use photoncube_spec::{Cut, Leaf, LeafSizes, Machine, Spatial, Widths};

use super::property::{Fault, Method, Open, Property, at, of_logic};
use super::spatial::{BIT, Unit, line};

const AXES: usize = 3;

/// All properties.
pub(super) fn properties(machine: &Machine) -> Vec<Property> {
    let leaf = machine.leaf().expect("it is a leaf machine");
    let widths = Widths::of(machine);
    let sizes = LeafSizes::of(leaf);
    let units = UNITS.iter().map(|unit| unit.property(machine));
    let mut properties: Vec<_> = units.collect();
    let groups = 0..Leaf::PAIR_GROUPS;
    properties.extend(groups.map(|group| culler(machine, leaf, &widths, &sizes, group)));
    properties.extend([
        borders(&widths),
        query_border(&widths),
        gathers(&sizes),
        fill(&sizes),
        control(&sizes),
        former(&sizes),
        scan(&sizes),
        queue(&sizes),
        player(&sizes),
        tags(&sizes),
    ]);
    properties
}

/// The units of a leaf machine that its chain does not have.
const UNITS: [Unit; 2] = [
    Unit {
        name: "units::token_place",
        module: "token_place",
        claim: "token = filler, in a filler; else query",
        inputs: &[
            ("fills", BIT),
            ("query", |w| w.coordinate),
            ("filler", |w| w.coordinate),
        ],
        output: ("token", |w| w.coordinate),
        second: None,
        claims: "if (fills) assert (result == filler); else assert (result == query);",
        covers: ["fills & result != query", "~fills & result != filler"],
        fault: ("token = filler", "token = query"),
    },
    Unit {
        name: "units::unless_blank",
        module: "unless_blank",
        claim: "present = 0 in a blank group; else word",
        inputs: &[("blank", BIT), ("word", BIT)],
        output: ("present", BIT),
        second: None,
        claims: "if (blank) assert (result == 0); else assert (result == word);",
        covers: ["blank & word", "result"],
        fault: ("if (blank)", "if (~blank)"),
    },
];

/// The ports of that name with a number, as slices of the harness's word of that name.
fn slices(name: &str, count: usize, width: &str) -> String {
    let port = |index| format!(".{name}_{index}({name}[{index}*{width}+:{width}]), ");
    (0..count).map(port).collect()
}

fn borders(widths: &Widths) -> Property {
    let lanes = |name, width| slices(name, Spatial::LANES, width);
    let axes = ["x", "y", "z"].map(|axis| lanes(axis, "`H"));
    Property {
        macros: vec![
            ("H", widths.photon.to_string()),
            (
                "BORDERS",
                ["low", "high"]
                    .map(|name| slices(name, AXES * Leaf::GROUPS, "`H"))
                    .concat(),
            ),
            (
                "LANES",
                (lanes("present", "1") + &axes.concat())
                    .trim_end_matches(", ")
                    .to_owned(),
            ),
        ],
        // The photon passes two registers before it is in the box.
        method: Method::Induction(4),
        faults: vec![
            Fault::new("borders", "half_3_place_b = x_3;", "half_3_place_b = x_2;"),
            Fault::new("half", "place_b > place_a", "place_b < place_a"),
            Fault::new("both", "low_b < low_a", "low_b > low_a"),
            Fault::new(
                "borders",
                "held_low_0_takes = first_comes;",
                "held_low_0_takes = comes;",
            ),
        ],
        fault_clocks: 6,
        covers: at([("cover_kept", 6), ("cover_wide", 6)]),
        ..of_logic(
            "leaves::borders",
            "borders",
            "each photon of a group that is present is in the box around the group",
            include_str!("harness/leaf/borders.sv"),
            &[],
        )
    }
}

fn query_border(widths: &Widths) -> Property {
    let module = "query_border";
    Property {
        method: Method::Induction(1),
        faults: vec![
            Fault::new(module, "low_in < low_q", "low_in > low_q"),
            Fault::new(module, "high_in > high_q", "high_in < high_q"),
        ],
        fault_clocks: 4,
        covers: at([("cover_kept", 4), ("cover_wide", 4)]),
        ..of_logic(
            "leaves::query_border",
            module,
            "the borders are around all intervals since the first",
            include_str!("harness/leaf/border.sv"),
            &[("W", widths.coordinate)],
        )
    }
}

/// For each group of a pair, the squares of its gaps, and which of them are far.
const SQUARES: [&[&str]; Leaf::PAIR_GROUPS] = [
    &[
        "square_stage_0_q",
        "square_stage_1_q",
        "square_stage_2_q",
        "far_stage_0_q",
        "far_stage_1_q",
        "far_stage_2_q",
    ],
    &[
        "square_stage_3_q",
        "square_stage_4_q",
        "square_stage_5_q",
        "far_stage_3_q",
        "far_stage_4_q",
        "far_stage_5_q",
    ],
    &[
        "square_stage_6_q",
        "square_stage_7_q",
        "square_stage_8_q",
        "far_stage_6_q",
        "far_stage_7_q",
        "far_stage_8_q",
    ],
    &[
        "square_stage_9_q",
        "square_stage_10_q",
        "square_stage_11_q",
        "far_stage_9_q",
        "far_stage_10_q",
        "far_stage_11_q",
    ],
];

/// The property of a group; each group of a pair has gaps and a lane of its own.
fn culler(
    machine: &Machine,
    leaf: &Leaf,
    widths: &Widths,
    sizes: &LeafSizes,
    group: usize,
) -> Property {
    let format = machine
        .format()
        .expect("a leaf machine has a photon format");
    let query = ["query_low", "query_high"].map(|name| slices(name, AXES, "`C"));
    let borders =
        ["group_low", "group_high"].map(|name| slices(name, AXES * Leaf::PAIR_GROUPS, "`H"));
    let last = AXES * group + AXES - 1;
    let clocks = sizes.cull_clocks;
    let to_square = Cut::ALL.into_iter().filter(|&cut| cut <= Cut::Square);
    let to_square = to_square.filter(|&cut| leaf.culler.cuts.has(cut)).count();
    let (squares, far) = SQUARES[group].split_at(AXES);
    let square = |(index, name)| format!(".{name}(group_square[{index}*2*`R+:2*`R]), ");
    let is_far = |(index, name)| format!(".{name}(group_far[{index}]), ");
    Property {
        macros: vec![
            ("C", widths.coordinate.to_string()),
            ("H", widths.photon.to_string()),
            ("R", widths.difference.to_string()),
            ("LINE", line(format.query_extra_bits)),
            ("HALF", u32::from(format.half_steps()).to_string()),
            ("LIMIT", format.largest_in_range().to_string()),
            ("GROUP", group.to_string()),
            ("CLOCKS", clocks.to_string()),
            ("SQUARE", to_square.to_string()),
            ("BORDERS", query.concat() + &borders.concat()),
            (
                "SQUARES",
                squares
                    .iter()
                    .enumerate()
                    .map(square)
                    .chain(far.iter().enumerate().map(is_far))
                    .collect(),
            ),
        ],
        open: Open::Signals(SQUARES[group]),
        method: Method::Induction(clocks + 1),
        faults: vec![
            Fault::new("nearest", "difference = above", "difference = below"),
            Fault::new(
                "culler",
                format!("gap_{last}_group_low = group_low_{last};"),
                format!("gap_{last}_group_low = group_high_{last};"),
            ),
        ],
        fault_clocks: clocks + 2,
        covers: at([("cover_far", clocks + 2), ("cover_near", clocks + 2)]),
        ..of_logic(
            [
                "leaves::culler_0",
                "leaves::culler_1",
                "leaves::culler_2",
                "leaves::culler_3",
            ][group],
            "culler",
            "a group with a photon in range of a query of the batch is in range, wherever in their boxes the two are",
            include_str!("harness/leaf/culler.sv"),
            &[],
        )
    }
}

fn gathers(sizes: &LeafSizes) -> Property {
    let clocks = sizes.cull_clocks;
    Property {
        method: Method::Induction(clocks + 1),
        faults: vec![Fault::new("leaf", "if (is_there)", "if (~is_there)")],
        fault_clocks: clocks + 2,
        covers: at([("cover_both", clocks + 2), ("cover_one", clocks + 2)]),
        ..of_logic(
            "leaves::gathers",
            "gathers",
            "the bit of the leaf's facing, when the boxes are compared",
            include_str!("harness/leaf/gathers.sv"),
            &[
                ("FACINGS", Leaf::FACINGS),
                ("FACING", Leaf::FACING_BITS),
                ("CLOCKS", clocks),
            ],
        )
    }
}

fn fill(sizes: &LeafSizes) -> Property {
    let places = 1 << sizes.place;
    Property {
        open: Open::Signals(&[
            "fill_bank_q",
            "fill_place_q",
            "fill_ready_q",
            "filled_0_q",
            "filled_1_q",
        ]),
        method: Method::Induction(1),
        faults: vec![
            Fault::new("fill", "~is_filled & ~is_last", "~is_filled"),
            Fault::new(
                "fill",
                "write_facing_d = group_facing",
                "write_facing_d = write_facing_q",
            ),
            Fault::new("fill", "filled_1_d = 1'b1", "filled_1_d = 1'b0"),
        ],
        fault_clocks: 8,
        covers: at([("cover_full", 6), ("cover_freed", 9)]),
        ..of_logic(
            "leaves::fill",
            "fill",
            "a set ends with a last group or at its bank's last place, and no bank with a whole set is filled; each group \
             is written once, at its place; assumed: only a whole set is freed",
            include_str!("harness/leaf/fill.sv"),
            &[("PLACES", places), ("FACING", Leaf::FACING_BITS)],
        )
    }
}

fn control(sizes: &LeafSizes) -> Property {
    Property {
        method: Method::Induction(4),
        faults: vec![
            Fault::new("control", "is_second | group_last_q", "is_second"),
            Fault::new(
                "control",
                "box_valid_q & box_last_q",
                "group_valid_q & group_last_q",
            ),
            Fault::new(
                "control",
                "box_short_0_d = ~is_second",
                "box_short_0_d = is_second",
            ),
            Fault::new("control", "group_valid_q & ~is_of_second", "group_valid_q"),
        ],
        fault_clocks: 8,
        covers: at([("cover_full", 9), ("cover_short", 8)]),
        ..of_logic(
            "leaves::control",
            "control",
            "the boxes of each leaf are written once, when its last group is in them; a bank is full from the clock after its \
             last box until it is freed; assumed: only a full bank is freed",
            include_str!("harness/leaf/control.sv"),
            &[("P", sizes.place), ("FACING", Leaf::FACING_BITS)],
        )
    }
}

fn former(sizes: &LeafSizes) -> Property {
    let clocks = sizes.engines + 4;
    let of = |find: &str, put: &str| Fault::new("former", find, put);
    let mut faults = vec![
        of("query_last | is_last_place", "query_last"),
        of("chain_ready & ~closed_q", "chain_ready"),
    ];
    let mut covers = at([("cover_second", 2 * clocks)]);
    // A batch of one query has no second query and no filler.
    if sizes.engines > 1 {
        faults.push(of("query_last | is_last_place", "is_last_place"));
        faults.push(of("is_offered & is_first", "is_offered"));
        covers.extend(at([("cover_filled", 2 * clocks)]));
    }
    Property {
        open: Open::Signals(&["loaded_q", "closed_q"]),
        method: Method::Induction(1),
        faults,
        fault_clocks: clocks,
        covers,
        ..of_logic(
            "leaves::former",
            "former",
            "no query is dropped or repeated; a batch ends with its last query or when each engine has one, and fillers \
             make it complete; it gathers the facings of its first query; assumed: it starts when it is complete",
            include_str!("harness/leaf/former.sv"),
            &[("ENGINES", sizes.engines), ("FACINGS", Leaf::FACINGS)],
        )
    }
}

fn scan(sizes: &LeafSizes) -> Property {
    // A batch of a whole bank fills the queue: one clock for each place, after those before the batch's first pair.
    let clocks_to_full = sizes.queue() + 8;
    Property {
        open: Open::Signals(&[
            "starting_q",
            "started_q",
            "scanning_q",
            "scan_bank_q",
            "scan_pair_q",
            "scan_end_q",
            "scan_release_q",
            "used_q",
            "returned_q",
        ]),
        method: Method::Induction(3),
        faults: vec![
            Fault::new("scan", "scan_pair_q + 32'h1", "scan_pair_q + 32'h2"),
            Fault::new(
                "scan",
                "complete & is_full & ~starting_q",
                "complete & ~starting_q",
            ),
            Fault::new("scan", "~is_last | scan_end_q[32'h0]", "~is_last"),
            Fault::new("scan", "scanning_q & scan_release_q", "scan_release_q"),
        ],
        fault_clocks: 12,
        covers: at([
            ("cover_second", 12),
            ("cover_bank", 12),
            ("cover_full", clocks_to_full),
        ]),
        ..of_logic(
            "leaves::scan",
            "scan",
            "each pair of a batch's set is found once, in order, beside the facings of the batch, from a full bank; no more \
             pairs are under way than the queue has places; assumed: what the other control blocks are shown to do",
            include_str!("harness/leaf/scan.sv"),
            &[
                ("K", sizes.pair),
                ("FACINGS", Leaf::FACINGS),
                ("QUEUE", sizes.queue()),
            ],
        )
    }
}

fn queue(sizes: &LeafSizes) -> Property {
    Property {
        open: Open::Cells(
            &["queue_write_q", "queue_read_q", "queue_count_q"],
            &["pair_ram", "mask_ram", "flag_ram"],
        ),
        method: Method::Induction(1),
        faults: vec![
            Fault::new("queue_2", "wanted_0 | wanted_1 | ends", "wanted_0 | ends"),
            Fault::new("queue_2", "in_range_3 & ~short_1", "in_range_3"),
            Fault::new("queue_2", "mask = mask | 32'h4", "mask = 32'h4"),
            Fault::new("queue_2", "queue_read_q + 32'h1", "queue_read_q + 32'h2"),
        ],
        fault_clocks: 8,
        covers: at([("cover_watched", 8), ("cover_full", sizes.queue() + 2)]),
        ..of_logic(
            "leaves::queue",
            "queue_2",
            "a pair with a wanted group, or that ends its batch, comes out once, in order, with its wanted groups; others are \
             dropped; assumed: none is queued in a full queue or taken from an empty one",
            include_str!("harness/leaf/queue.sv"),
            &[("K", sizes.pair), ("QUEUE", sizes.queue())],
        )
    }
}

fn player(sizes: &LeafSizes) -> Property {
    // One of the clocks between two last groups is that in which the second is allowed.
    let spaced = sizes.least_spacing.max(2);
    let clocks_to_most = spaced * (sizes.most_outstanding + 2);
    let of = |find: &str, put: &str| Fault::new("player", find, put);
    let mut faults = vec![
        of("rest = entry_mask_q & less", "rest = less"),
        of("is_spaced & has_room & ~ends", "is_spaced & ~ends"),
        of("ends & entry_release_q", "is_played & entry_release_q"),
    ];
    if spaced > 2 {
        faults.push(of("is_spaced & has_room", "has_room"));
    }
    Property {
        open: Open::Signals(&[
            "entry_valid_q",
            "entry_mask_q",
            "entry_last_q",
            "entry_pair_q",
            "entry_bank_q",
            "entry_end_q",
            "entry_release_q",
            "spacing_q",
            "may_end_q",
            "outstanding_q",
        ]),
        method: Method::Induction(3),
        faults,
        fault_clocks: clocks_to_most,
        covers: at([
            ("cover_four", 12),
            ("cover_blank", 6),
            ("cover_most", clocks_to_most),
        ]),
        ..of_logic(
            "leaves::player",
            "player",
            "each wanted group of a pair is played once, in order; only the last group of a batch waits, for the spacing and \
             for room; the set is freed with it; assumed: no batch leaves that did not end",
            include_str!("harness/leaf/player.sv"),
            &[
                ("K", sizes.pair),
                ("SPACING", sizes.spacing),
                ("SPACED", spaced),
                ("MOST", sizes.most_outstanding),
            ],
        )
    }
}

fn tags(sizes: &LeafSizes) -> Property {
    Property {
        open: Open::Cells(
            &[
                "tag_write_q",
                "tag_read_q",
                "has_oldest_q",
                "oldest_q",
                "tag_result_q",
            ],
            &["tag_ram"],
        ),
        method: Method::Induction(1),
        faults: vec![
            Fault::new("tags", "result_ready | ~is_query", "result_ready"),
            Fault::new("tags", "chain_valid & is_query", "chain_valid"),
            Fault::new("tags", "takes & is_last", "chain_valid & is_last"),
        ],
        // The last result of a batch is that of its last engine.
        fault_clocks: sizes.engines + 6,
        covers: at([("cover_query", 8), ("cover_filler", 8)]),
        ..of_logic(
            "leaves::tags",
            "tags",
            "each result has the tag of its query, and fillers have no result; assumed: the chain gives one result for each \
             token, in order, at the earliest two clocks after it took the token",
            include_str!("harness/leaf/tags.sv"),
            &[
                ("PLACES", 1 << sizes.tag_place),
                ("TAG", Leaf::TAG_BITS),
                ("RESULT", sizes.result),
                ("ENGINES", sizes.engines),
            ],
        )
    }
}
