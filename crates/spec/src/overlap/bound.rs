//! Lower bounds of the kernel's interval, set by the units and by the registers.

use std::collections::BTreeMap;

use super::graph::{Bundle, Edge, Graph, Part};
use crate::cell::{OVERLAPPED, Register, Unit};
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
    let (role, at) = (part.role, part.offset);
    let row = OVERLAPPED.op(part.step.op);
    let written = at + row.latency - 1;
    let written = |register| (Resource::WritePort(role, register), written);
    let mut uses: Vec<_> = OVERLAPPED.writes(part.step).map(written).collect();
    uses.extend(row.unit.map(|unit| (Resource::Unit(role, unit), at)));
    let link = |axis| (Resource::Link(role.across(axis), axis), at);
    uses.extend(part.step.axis.map(link));
    uses
}

pub(super) fn bundle_uses(bundle: &Bundle) -> Vec<Use> {
    bundle.parts.iter().flat_map(part_uses).collect()
}

/// The fewest clocks of an iteration that a unit allows: its ops in the cell that has most of them.
pub(super) fn unit_bound(graph: &Graph, unit: Unit) -> u32 {
    let counts = resource_counts(graph).into_iter();
    let of_unit =
        counts.filter(|(resource, _)| matches!(resource, Resource::Unit(_, u) if *u == unit));
    of_unit.map(|(_, count)| count).max().unwrap_or(0)
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
