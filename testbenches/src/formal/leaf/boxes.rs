//! The properties of the boxes around groups and batches, and of the comparison that decides which groups are played.

use photoncube_spec::{Cut, Leaf, LeafSizes, Machine, Spatial, Widths};

use crate::formal::property::{Fault, Method, Open, Property, at, of_logic};
use crate::formal::spatial::line;

const AXES: usize = 3;

/// The ports of that name with a number, as slices of the harness's word of that name.
fn slices(name: &str, count: usize, width: &str) -> String {
    let port = |index| format!(".{name}_{index}({name}[{index}*{width}+:{width}]), ");
    (0..count).map(port).collect()
}

pub(super) fn borders(widths: &Widths) -> Property {
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
            include_str!("../harness/leaf/borders.sv"),
            &[],
        )
    }
}

pub(super) fn query_border(widths: &Widths) -> Property {
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
            include_str!("../harness/leaf/border.sv"),
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
pub(super) fn culler(
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
            include_str!("../harness/leaf/culler.sv"),
            &[],
        )
    }
}

pub(super) fn gathers(sizes: &LeafSizes) -> Property {
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
            include_str!("../harness/leaf/gathers.sv"),
            &[
                ("FACINGS", Leaf::FACINGS),
                ("FACING", Leaf::FACING_BITS),
                ("CLOCKS", clocks),
            ],
        )
    }
}
