//! Lower bounds of the kernel's interval, set by the units and by the registers.

use std::collections::BTreeMap;

use super::graph::{Bundle, Edge, Graph, Part};
use super::op::Unit;
use super::register::Register;
use crate::hypercube::{Axis, Role};

/// A resource that an op occupies alone for one clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Resource {
    /// A unit of a cell, in the clock in which it starts an op.
    Unit(Role, Unit),
    /// The link of a cell on an axis, as the sender.
    Link(Role, Axis),
    /// The write port of a cell's register.
    WritePort(Role, Register),
}

/// A resource with the clock, counted from a bundle's start, in which it is taken.
pub(super) type Use = (Resource, u32);

/// The resources that an op occupies, with their clocks.
pub(super) fn part_uses(part: &Part) -> Vec<Use> {
    let (role, op, at) = (part.role, part.op, part.offset);
    let row = op.row();
    let written = at + row.latency - 1;
    let mut uses = vec![(Resource::WritePort(role, op.write()), written)];
    uses.extend(row.unit.map(|unit| (Resource::Unit(role, unit), at)));
    let link = |axis| (Resource::Link(role.across(axis), axis), at);
    uses.extend(op.axis().map(link));
    uses
}

pub(super) fn bundle_uses(bundle: &Bundle) -> Vec<Use> {
    bundle.parts.iter().flat_map(part_uses).collect()
}

/// How often a unit works in one iteration.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct UnitBound {
    /// The unit that is counted.
    pub unit: Unit,
    /// The number of ops in one iteration, in the four cells of a quad together.
    pub uses: u32,
    /// The number of ops in the cell that has most of them. No iteration is shorter than so many clocks.
    pub clocks: u32,
}

/// The bound that each unit sets, in the order of [`Unit::ALL`].
pub fn unit_bounds(graph: &Graph) -> Vec<UnitBound> {
    let counts = resource_counts(graph);
    let of = |unit| {
        let of_unit = counts.iter().filter_map(move |(resource, &count)| {
            matches!(resource, Resource::Unit(_, u) if *u == unit).then_some(count)
        });
        UnitBound {
            unit,
            uses: of_unit.clone().sum(),
            clocks: of_unit.max().unwrap_or(0),
        }
    };
    Unit::ALL.into_iter().map(of).collect()
}

/// The fewest clocks of an iteration that the resources allow: the uses of the resource that is used most.
pub fn resource_bound(graph: &Graph) -> u32 {
    resource_counts(graph).into_values().max().unwrap_or(1)
}

pub(super) fn resource_counts(graph: &Graph) -> BTreeMap<Resource, u32> {
    let mut counts = BTreeMap::new();
    for (resource, _) in graph.bundles.iter().flat_map(bundle_uses) {
        *counts.entry(resource).or_insert(0) += 1;
    }
    counts
}

/// The fewest clocks of an iteration that the registers allow. A register is written again only after its
/// word has been read. The bound is the longest cycle of dependences, divided by the iterations that it
/// spans.
pub fn recurrence_bound(graph: &Graph) -> u32 {
    // Every delay is a few clocks, so the sum of all delays exceeds any bound.
    let all: i64 = graph.edges.iter().map(|edge| edge.delay.max(0)).sum();
    let largest = u32::try_from(all).unwrap_or(u32::MAX).max(1);
    let mut range = 1..=largest;
    range
        .find(|&interval| earliest_starts(graph, interval).is_some())
        .unwrap_or(largest)
}

/// The earliest start of each bundle with unlimited resources; `None` where a cycle of dependences does not
/// fit the interval.
pub(super) fn earliest_starts(graph: &Graph, interval: u32) -> Option<Vec<i64>> {
    longest_paths(graph, interval, |edge| (edge.from, edge.to))
}

/// The longest path from each bundle to the end of the iteration, in clocks.
pub(super) fn heights(graph: &Graph, interval: u32) -> Option<Vec<i64>> {
    longest_paths(graph, interval, |edge| (edge.to, edge.from))
}

/// Bellman and Ford: after as many rounds as bundles, only a path with a cycle still grows.
fn longest_paths(
    graph: &Graph,
    interval: u32,
    direction: impl Fn(&Edge) -> (usize, usize),
) -> Option<Vec<i64>> {
    let mut lengths = vec![0_i64; graph.bundles.len()];
    for _ in 0..=graph.bundles.len() {
        let mut settled = true;
        for edge in &graph.edges {
            let (from, to) = direction(edge);
            let length = lengths[from] + edge.delay - edge.distance * i64::from(interval);
            if length > lengths[to] {
                lengths[to] = length;
                settled = false;
            }
        }
        if settled {
            return Some(lengths);
        }
    }
    None
}
