//! The properties of leaf machines: the boxes around groups and batches, the comparison that decides which groups are
//! played, and the control blocks from the sets that are read in to the tags of the results. The units and sums of the
//! chain of engines are those of [`super::spatial`].

mod boxes;
mod control;

use photoncube_spec::{Leaf, LeafSizes, Machine, Widths};

use boxes::{borders, culler, gathers, query_border};
use control::{control, fill, former, player, queue, scan, tags};

use super::property::Property;
use super::spatial::{BIT, Unit};

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
