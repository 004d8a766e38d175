//! The dependence graph of one iteration of the kernel.
//!
//! An iteration is a few groups, one after another. The module describes once what the four cells of a quad
//! do for a group; the edges follow from the registers that the ops read and write. A register holds the
//! words of successive groups in turn, so two kinds of edges connect neighbouring groups: a word is
//! overwritten only after its last reader, and words are written in the order of the groups.

use crate::cell::{OVERLAPPED, Op, POWER_WORDS, Register, Step};
use crate::hypercube::{Axis, Role};

/// The cells that add up a group's distance: `first` adds the squares of x and y, `second` adds the square of
/// z. The two are neighbours across w.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Adders {
    /// X or Y; this cell receives the other square across z.
    pub first: Role,
    /// Z or D, the neighbour of `first` across w.
    pub second: Role,
}

/// Pairs of cells that take turns. With the four accumulations of each group, two groups need three adds on
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

/// One pair of cells for every group, as in the paper.
pub const FIXED: &[Adders] = &[ROTATED[0]];

/// A step of one cell of the quad.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The role of the cell.
    pub role: Role,
    /// The step that the cell does.
    pub step: Step,
    /// Clocks from the bundle's first step to this one.
    pub offset: u32,
}

/// Ops at fixed distances in time: the loads of a group, whose words are on the pins in one clock, or an
/// operand and the add that uses it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bundle {
    /// The group's index in the iteration.
    pub group: usize,
    /// The ops of the bundle.
    pub parts: Vec<Part>,
}

/// A dependence of two bundles: `start(to) + distance * interval >= start(from) + delay`.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Edge {
    /// The bundle that starts first.
    pub from: usize,
    /// The bundle that must not start too early after `from`.
    pub to: usize,
    /// The delay in clocks; negative where an overwriting op may start before the last reader.
    pub delay: i64,
    /// The iterations from `from` to `to`.
    pub distance: i64,
}

/// The dependence graph of one iteration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// The number of groups in an iteration.
    pub groups: usize,
    /// The bundles, sorted by group.
    pub bundles: Vec<Bundle>,
    /// The dependences between bundles.
    pub edges: Vec<Edge>,
}

impl Graph {
    /// Makes the graph of an iteration with one group for each of `adders`.
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

/// All ops of a quad for one group, as bundles.
fn group_parts(adders: Adders) -> Vec<Vec<Part>> {
    let Adders { first, second } = adders;
    let part = |offset, role, step| Part { role, step, offset };
    let at = |offset, role, op| part(offset, role, Step::new(op));
    let one = |role, op| vec![at(0, role, op)];
    let across = |role, op, axis| part(0, role, Step::across(op, axis));
    let squaring = [Role::X, Role::Y, second];
    let mut bundles = Vec::new();
    let mut load: Vec<_> = Role::ALL.map(|role| at(0, role, Op::LoadPower)).into();
    load.extend(squaring.map(|role| at(0, role, Op::LoadPhoton)));
    bundles.push(load);
    bundles.extend(squaring.map(|role| one(role, Op::SquareDifference)));
    for (adder, axis) in [(first, Axis::Z), (second, Axis::W)] {
        bundles.push(vec![
            across(adder, Op::Receive, axis),
            at(1, adder, Op::Add),
        ]);
    }
    bundles.push(one(second, Op::Keep));
    bundles.push(vec![across(first, Op::Keep, Axis::W)]);
    bundles.push(vec![across(second.across(Axis::Z), Op::Keep, Axis::Z)]);
    bundles.push(vec![across(first.across(Axis::Z), Op::Relay, Axis::W)]);
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

/// Whether a register holds one word of every group (or of every other group), in the order of the groups.
/// Operands and comparisons are held for one clock, inside a bundle. Sums take groups in any order, and the
/// query stays.
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

/// The registers of a cell that are queues.
fn queues() -> impl Iterator<Item = Register> {
    let registers = OVERLAPPED.registers.iter().map(|row| row.register);
    registers.filter(|&register| is_queue(register))
}

/// A read or a write of one register.
#[derive(Copy, Clone)]
struct Access {
    bundle: usize,
    group: usize,
    /// The clock of the access after the bundle's start: the clock of a read, or the last clock of a write.
    clock: i64,
}

fn edges(bundles: &[Bundle], groups: usize) -> Vec<Edge> {
    let mut edges = Vec::new();
    for role in Role::ALL {
        for register in queues() {
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
        let writes = part.role == role
            && OVERLAPPED
                .writes(part.step)
                .any(|written| written == register);
        writes.then(|| i64::from(OVERLAPPED.op(part.step.op).latency) - 1)
    })
}

fn reads(bundles: &[Bundle], role: Role, register: Register) -> Vec<Access> {
    accesses(bundles, |part| {
        let mut reads = OVERLAPPED.reads(part.step).into_iter();
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

/// The edges of one register. `writes` has at most one write of each group; the writes follow each other
/// cyclically.
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
                for register in queues() {
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
            let count = |op: &dyn Fn(Op) -> bool| parts.iter().filter(|p| op(p.step.op)).count();
            assert_eq!(count(&|op| op == Op::SquareDifference), 3, "{group}");
            assert_eq!(count(&|op| op == Op::Add), 2, "{group}");
            assert_eq!(count(&|op| op == Op::Accumulate), 4, "{group}");
            assert_eq!(count(&|op| op == Op::Gate), 4, "{group}");
        }
    }
}
