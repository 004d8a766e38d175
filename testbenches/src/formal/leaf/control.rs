//! The properties of the control blocks, from the sets that are read in to the tags of the results.

use photoncube_spec::{Leaf, LeafSizes};

use crate::formal::property::{Fault, Method, Open, Property, at, of_logic};

pub(super) fn fill(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/fill.sv"),
            &[("PLACES", places), ("FACING", Leaf::FACING_BITS)],
        )
    }
}

pub(super) fn control(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/control.sv"),
            &[("P", sizes.place), ("FACING", Leaf::FACING_BITS)],
        )
    }
}

pub(super) fn former(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/former.sv"),
            &[("ENGINES", sizes.engines), ("FACINGS", Leaf::FACINGS)],
        )
    }
}

pub(super) fn scan(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/scan.sv"),
            &[
                ("K", sizes.pair),
                ("FACINGS", Leaf::FACINGS),
                ("QUEUE", sizes.queue()),
            ],
        )
    }
}

pub(super) fn queue(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/queue.sv"),
            &[("K", sizes.pair), ("QUEUE", sizes.queue())],
        )
    }
}

pub(super) fn player(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/player.sv"),
            &[
                ("K", sizes.pair),
                ("SPACING", sizes.spacing),
                ("SPACED", spaced),
                ("MOST", sizes.most_outstanding),
            ],
        )
    }
}

pub(super) fn tags(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/tags.sv"),
            &[
                ("PLACES", 1 << sizes.tag_place),
                ("TAG", Leaf::TAG_BITS),
                ("RESULT", sizes.result),
                ("ENGINES", sizes.engines),
            ],
        )
    }
}
