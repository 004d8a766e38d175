//! The property of the photon memory. It is proven on the module as it is shipped, and on the text with banks
//! of a few groups, in which a search reaches the last place.

use photoncube_hdl::{Level, emit};
use photoncube_spec::{Machine, Organisation, Spatial, Widths};

use super::property::{Fault, Method, Open, Property, at, of_logic};

/// The number of groups in a small bank.
const FEW: u32 = 8;
/// The number of clocks in which a set of two groups is played twice, and a set of the other bank after it.
const CLOCKS: u32 = 18;

/// The signals of the module that the harness observes.
const SIGNALS: &[&str] = &[
    "fill_bank",
    "fill_place",
    "fill_ready",
    "write_valid",
    "write_bank",
    "write_place",
    "full_0",
    "full_1",
    "end_place_0",
    "end_place_1",
    "play_bank",
    "play_full",
    "play_end",
    "before_end",
    "play_place",
    "at_end",
    "may_start",
    "playing",
    "releases",
    "release_taken",
    "release_next",
    "read_valid",
    "read_last",
    "write_word",
    "read_word",
];

/// The properties of a machine with a photon memory.
pub(super) fn properties(machine: &Machine, spatial: &Spatial, widths: &Widths) -> Vec<Property> {
    if !machine.has_memory() {
        return Vec::new();
    }
    let small = Machine {
        organisation: Organisation::Spatial(Spatial {
            memory_groups: FEW,
            ..*spatial
        }),
        ..*machine
    };
    let text = emit(&small, Level::Memory).map(|design| design.text);
    let small = text.ok().map(|text| Property {
        name: "memory::few_groups",
        claim: "what `memory::sets` claims, of the text with banks of 8 groups, whose last place a search reaches",
        design: Some(text),
        ..property(machine, widths, FEW)
    });
    [property(machine, widths, spatial.memory_groups)]
        .into_iter()
        .chain(small)
        .collect()
}

fn property(machine: &Machine, widths: &Widths, groups: u32) -> Property {
    let (ports, word) = ports(machine, widths);
    let is_small = groups == FEW;
    let bits = groups.ilog2();
    let mut covers = vec![("cover_kept", CLOCKS), ("cover_second", CLOCKS)];
    let mut faults = vec![
        Fault::new("memory", " & ~(takes_group & set_ends)", ""),
        Fault::new(
            "memory",
            "write_address = {write_bank, write_place}",
            "write_address = {write_bank, fill_place}",
        ),
    ];
    if is_small {
        covers.push(("cover_full", CLOCKS + FEW));
        faults.extend(small_faults(bits));
    }
    Property {
        macros: vec![
            ("PLACES", groups.to_string()),
            ("WORD", word.to_string()),
            ("GROUP_PORTS", ports),
        ],
        open: Open::Cells(SIGNALS, &["groups"]),
        method: Method::Induction(1),
        faults,
        fault_clocks: CLOCKS,
        covers: covers.into_iter().flat_map(|cover| at([cover])).collect(),
        ..of_logic(
            "memory::sets",
            "memory",
            "a set ends with a last group or at its bank's last place, and no full bank is filled; a batch begins where its \
             bank has a whole set and the head is ready; its words are the set's, in order, as they were, the last one \
             marked; the set goes with the batch that releases it; a reset forgets all; assumed: the block RAM gives what \
             was written at the place",
            include_str!("harness/memory.sv"),
            &[],
        )
    }
}

/// Faults that a search finds early if there are few places.
fn small_faults(bits: u32) -> Vec<Fault> {
    let of = |find: &str, put: &str| Fault::new("memory", find, put);
    vec![
        of(
            "set_ends = group_last | (&fill_place)",
            "set_ends = group_last",
        ),
        of("play_full & is_full", "is_full"),
        of("is_full & has_room", "has_room"),
        of("may_start ? release_next : releases", "releases"),
        of("read_last <= reads & at_end", "read_last <= at_end"),
        of(&format!("      fill_place <= {bits}'d0;\n"), ""),
        of("release_next <= 1'd0;\n        read_valid", "read_valid"),
    ]
}

/// The ports of a group and of a word, as slices of the harness's words in the order of the block RAM's, with
/// their width.
fn ports(machine: &Machine, widths: &Widths) -> (String, u32) {
    let (mut text, mut low) = (String::new(), 0);
    let channels = machine.channels().names();
    for lane in 0..Spatial::LANES {
        let axes = ["x", "y", "z"].map(|axis| (axis, widths.coordinate));
        let powers = channels.iter().map(|&name| (name, widths.mantissa));
        let exponent = machine
            .has_exponent()
            .then_some(("exponent", widths.exponent));
        let fields = [("present", 1)].into_iter().chain(axes).chain(powers);
        for (field, width) in fields.chain(exponent) {
            text += &format!(
                ".{field}_{lane}(data[{low}+:{width}]), .word_{field}_{lane}(word[{low}+:{width}]), "
            );
            low += width;
        }
    }
    (text, low)
}
