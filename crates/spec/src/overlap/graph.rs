//! The dependence graph of one iteration of the kernel.
//!
//! An iteration is a few groups, one after the other. What the four cells of a quad do for a group
//! is written down here once; the edges follow from the registers that the ops read and write. A
//! register holds one group's word after the other's, so two kinds of edges bind neighbouring
//! groups: a word is overwritten only after its last reader, and words come in the groups' order.

use super::op::Op;
use super::register::{POWER_WORDS, Register};
use crate::hypercube::{Axis, Role};

/// Which cells add up a group's distance: `first` adds the squares of x and y, `second` adds that
/// of z. They are neighbours across w.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Adders {
    /// X or Y; it hears the other across z.
    pub first: Role,
    /// Z or D, beside it.
    pub second: Role,
}

/// The cells take turns: with the four accumulations of each group, two groups are three adds for
/// each of the four adders.
pub const ROTATED: &[Adders] = &[
    Adders {
        first: Role::Y,
        second: Role::D,
    },
    Adders {
        first: Role::X,
        second: Role::Z,
    },
];

/// The same two cells for every group, as in the paper.
pub const FIXED: &[Adders] = &[ROTATED[0]];

/// An op of one cell of the quad.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The cell.
    pub role: Role,
    /// What it does.
    pub op: Op,
    /// Clocks after the bundle's first op.
    pub offset: u32,
}

/// Ops that stand at fixed distances from each other: the loads of a group, whose words are on the
/// pins in one clock; and an operand with the add that it is for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bundle {
    /// The group in the iteration.
    pub group: usize,
    /// The ops.
    pub parts: Vec<Part>,
}

/// `start(to) + distance * interval >= start(from) + delay`.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Edge {
    /// A bundle.
    pub from: usize,
    /// The bundle that must not start too early after it.
    pub to: usize,
    /// Clocks; negative where an overwriting op may start before the last reader.
    pub delay: i64,
    /// Iterations between the two.
    pub distance: i64,
}

/// Bundles and what binds them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// Groups in an iteration.
    pub groups: usize,
    /// The bundles, by group.
    pub bundles: Vec<Bundle>,
    /// The edges.
    pub edges: Vec<Edge>,
}

impl Graph {
    /// The graph of an iteration with a group for each of `adders`.
    pub fn new(adders: &[Adders]) -> Self {
        let bundles: Vec<_> = adders
            .iter()
            .enumerate()
            .flat_map(|(group, adders)| {
                let parts = group_parts(*adders).into_iter();
                parts.map(move |parts| Bundle { group, parts })
            })
            .collect();
        Self {
            groups: adders.len(),
            edges: edges(&bundles, adders.len()),
            bundles,
        }
    }
}

/// All that a quad does for one group.
fn group_parts(adders: Adders) -> Vec<Vec<Part>> {
    let Adders { first, second } = adders;
    let at = |offset, role, op| Part { role, op, offset };
    let one = |role, op| vec![at(0, role, op)];
    let squaring = [Role::X, Role::Y, second];
    let mut bundles = Vec::new();
    let mut load: Vec<_> = Role::ALL.map(|role| at(0, role, Op::LoadPower)).into();
    load.extend(squaring.map(|role| at(0, role, Op::LoadPhoton)));
    bundles.push(load);
    bundles.extend(squaring.map(|role| one(role, Op::SquareDifference)));
    for (adder, axis) in [(first, Axis::Z), (second, Axis::W)] {
        bundles.push(vec![at(0, adder, Op::Receive(axis)), at(1, adder, Op::Add)]);
    }
    bundles.push(one(second, Op::Keep(None)));
    bundles.push(one(first, Op::Keep(Some(Axis::W))));
    bundles.push(one(second.across(Axis::Z), Op::Keep(Some(Axis::Z))));
    bundles.push(one(first.across(Axis::Z), Op::Relay));
    for role in Role::ALL {
        bundles.extend((1..POWER_WORDS).map(|place| one(role, Op::MovePower(place))));
        bundles.push(vec![
            at(0, role, Op::Compare),
            at(1, role, Op::Gate),
            at(2, role, Op::Accumulate),
        ]);
    }
    bundles
}

/// Whether a register holds one word of every group (or of every other), in the groups' order.
/// Operands and the comparison live from one clock to the next, in a bundle; sums take groups in any order; the query
/// stays.
fn is_queue(register: Register) -> bool {
    !matches!(
        register,
        Register::Addend
            | Register::Operand
            | Register::InRange
            | Register::Sum
            | Register::Query
            | Register::RadiusSq
    )
}

/// A read or a write of one register.
#[derive(Copy, Clone)]
struct Access {
    bundle: usize,
    group: usize,
    /// The clock of the access after the bundle's start: that of a read, or the last of a write.
    clock: i64,
}

fn edges(bundles: &[Bundle], groups: usize) -> Vec<Edge> {
    let mut edges = Vec::new();
    for role in Role::ALL {
        for register in Register::all().filter(|&register| is_queue(register)) {
            let writes = writes(bundles, role, register);
            let reads = reads(bundles, role, register);
            edges.extend(register_edges(&writes, &reads, groups));
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

fn writes(bundles: &[Bundle], role: Role, register: Register) -> Vec<Access> {
    accesses(bundles, |part| {
        let writes = part.role == role && part.op.write() == register;
        writes.then(|| i64::from(part.op.row().latency) - 1)
    })
}

fn reads(bundles: &[Bundle], role: Role, register: Register) -> Vec<Access> {
    accesses(bundles, |part| {
        let mut reads = part.op.reads().into_iter();
        let is_it = reads.any(|read| {
            let holder = read.across.map_or(part.role, |axis| part.role.across(axis));
            holder == role && read.register == register
        });
        is_it.then_some(0)
    })
}

fn accesses(bundles: &[Bundle], clock: impl Fn(&Part) -> Option<i64>) -> Vec<Access> {
    let all = bundles.iter().enumerate().flat_map(|(index, bundle)| {
        let parts = bundle
            .parts
            .iter()
            .map(move |part| (index, bundle.group, part));
        parts.filter_map(|(bundle, group, part)| {
            clock(part).map(|clock| Access {
                bundle,
                group,
                clock: clock + i64::from(part.offset),
            })
        })
    });
    all.collect()
}

/// `writes` has at most one write of each group; they follow each other round and round.
fn register_edges(writes: &[Access], reads: &[Access], groups: usize) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (index, write) in writes.iter().enumerate() {
        let next = &writes[(index + 1) % writes.len()];
        let distance = i64::from(index + 1 == writes.len());
        let edge = |from: &Access, to: &Access, delay, distance| Edge {
            from: from.bundle,
            to: to.bundle,
            delay: from.clock + delay - to.clock,
            distance,
        };
        edges.push(edge(write, next, 1, distance));
        for read in reads.iter().filter(|read| read.group == write.group) {
            edges.push(edge(write, read, 1, 0));
            edges.push(edge(read, next, 0, distance));
        }
    }
    debug_assert!(writes.len() <= groups);
    edges
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_that_is_read_is_written_by_the_same_group() {
        for adders in [ROTATED, FIXED] {
            let graph = Graph::new(adders);
            for role in Role::ALL {
                for register in Register::all().filter(|&register| is_queue(register)) {
                    let writes = writes(&graph.bundles, role, register);
                    for read in reads(&graph.bundles, role, register) {
                        let of_group = writes.iter().filter(|write| write.group == read.group);
                        assert_eq!(of_group.count(), 1, "{role} {register:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_group_is_six_adds_three_squares_and_four_gates() {
        for (group, adders) in ROTATED.iter().enumerate() {
            let parts: Vec<_> = group_parts(*adders).concat();
            let count = |op: &dyn Fn(Op) -> bool| parts.iter().filter(|p| op(p.op)).count();
            assert_eq!(count(&|op| op == Op::SquareDifference), 3, "{group}");
            assert_eq!(count(&|op| op == Op::Add), 2, "{group}");
            assert_eq!(count(&|op| op == Op::Accumulate), 4, "{group}");
            assert_eq!(count(&|op| op == Op::Gate), 4, "{group}");
        }
    }
}
