//! The modulo scheduler of overlapped programs.
//!
//! One iteration of the kernel is scheduled such that it can start again every `interval` clocks. A bundle's
//! start consists of a *row*, its clock modulo the interval, and a stage. Units, links and write ports are
//! occupied by rows alone. Once all rows are chosen, the starts follow: they are the longest paths of the
//! dependence graph, rounded up to the rows. So the scheduler searches the rows, bundles of the most wanted
//! resources first, and backtracks as soon as no start is left.
//!
//! Rau's iterative modulo scheduling (MICRO-27, 1994), which evicts one bundle to place another, was tried
//! first. At this kernel's interval, where every adder works in every clock, it found nothing in 400
//! placements for each bundle. The search needs some 90 choices. Where it ends without a schedule, no
//! schedule has starts up to [`LATEST`].

use std::cmp::Reverse;
use std::collections::BTreeSet;

use thiserror::Error;

use super::bound::{
    Resource, Use, bundle_uses, earliest_starts, heights, recurrence_bound, resource_bound,
    resource_counts,
};
use super::graph::Graph;

/// The number of choices after which the search gives an interval up.
const PATIENCE: usize = 100_000;

/// The latest start that is tried. It is far past any useful latency and bounds the search.
const LATEST: i64 = 64;

/// The number of intervals above the bound that are tried.
const INTERVALS: u32 = 8;

/// The reason why the scheduler finds no schedule.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SchedulerError {
    /// A unit, link or write port is used more often than the interval has clocks.
    #[error(
        "an iteration of {interval} clocks is too short: a unit, a link or a register's write \
         port is needed in {bound}"
    )]
    Resources {
        /// The interval that was given.
        interval: u32,
        /// The smallest interval that the resources allow.
        bound: u32,
    },
    /// A register would be overwritten before its last reader.
    #[error(
        "an iteration of {interval} clocks is too short: registers whose words are still to be \
         read are written again after {bound} at the earliest"
    )]
    Registers {
        /// The interval that was given.
        interval: u32,
        /// The smallest interval that the registers allow.
        bound: u32,
    },
    /// No schedule exists with starts up to `LATEST`; all were tried.
    #[error("there is no schedule of {interval} clocks; all were tried, in {tries} choices")]
    None {
        /// The interval that was tried.
        interval: u32,
        /// The number of choices made.
        tries: usize,
    },
    /// The search was given up; a schedule may exist.
    #[error("no schedule of {interval} clocks was found in {tries} choices")]
    GaveUp {
        /// The interval that was tried.
        interval: u32,
        /// The number of choices made.
        tries: usize,
    },
}

/// The start of each bundle of a graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Schedule {
    /// Clocks from one iteration to the next.
    pub interval: u32,
    /// The start of each bundle, in clocks; the first is 0.
    pub starts: Vec<u32>,
}

/// Finds the schedule of the smallest interval, from the larger of the two bounds upwards.
///
/// # Errors
/// The error of the last interval that was tried.
pub fn schedule(graph: &Graph) -> Result<Schedule, SchedulerError> {
    let bound = resource_bound(graph).max(recurrence_bound(graph));
    let mut found = schedule_at(graph, bound);
    for interval in bound + 1..bound + INTERVALS {
        if found.is_ok() {
            break;
        }
        found = schedule_at(graph, interval);
    }
    found
}

/// Finds a schedule of that interval.
///
/// # Errors
/// The interval is below a bound, or the search finds no schedule.
pub fn schedule_at(graph: &Graph, interval: u32) -> Result<Schedule, SchedulerError> {
    let bound = resource_bound(graph);
    if interval < bound {
        return Err(SchedulerError::Resources { interval, bound });
    }
    let Some(earliest) = earliest_starts(graph, interval) else {
        let bound = recurrence_bound(graph);
        return Err(SchedulerError::Registers { interval, bound });
    };
    let mut search = Search::new(graph, interval);
    match search.place(0, &earliest) {
        Some(starts) => Ok(Schedule {
            interval,
            starts: starts.iter().map(|&start| start as u32).collect(),
        }),
        None => Err(search.failure()),
    }
}

/// A search for rows.
struct Search<'a> {
    graph: &'a Graph,
    interval: i64,
    /// The bundles in the order in which they get their rows.
    order: Vec<usize>,
    uses: Vec<Vec<Use>>,
    /// The row of each bundle; `None` for a bundle without one yet.
    rows: Vec<Option<i64>>,
    /// The resources that are occupied, by row.
    taken: BTreeSet<(Resource, i64)>,
    tries: usize,
}

impl<'a> Search<'a> {
    fn new(graph: &'a Graph, interval: u32) -> Self {
        let uses: Vec<_> = graph.bundles.iter().map(bundle_uses).collect();
        Self {
            graph,
            interval: i64::from(interval),
            order: order(graph, &uses, interval),
            uses,
            rows: vec![None; graph.bundles.len()],
            taken: BTreeSet::new(),
            tries: 0,
        }
    }

    /// Chooses rows for the bundles from `place` on in the order. Returns the starts, if all bundles get a
    /// row.
    fn place(&mut self, place: usize, starts: &[i64]) -> Option<Vec<i64>> {
        let Some(&bundle) = self.order.get(place) else {
            return Some(starts.to_vec());
        };
        for start in starts[bundle]..starts[bundle] + self.interval {
            if self.tries == PATIENCE {
                return None;
            }
            self.tries += 1;
            let resources = self.resources(bundle, start);
            if resources.iter().any(|taken| self.taken.contains(taken)) {
                continue;
            }
            self.rows[bundle] = Some(start % self.interval);
            if let Some(starts) = self.earliest(starts) {
                self.taken.extend(&resources);
                let found = self.place(place + 1, &starts);
                if found.is_some() {
                    return found;
                }
                for resource in &resources {
                    self.taken.remove(resource);
                }
            }
            self.rows[bundle] = None;
        }
        None
    }

    fn resources(&self, bundle: usize, start: i64) -> Vec<(Resource, i64)> {
        let uses = self.uses[bundle].iter();
        uses.map(|&(resource, clock)| (resource, (start + i64::from(clock)) % self.interval))
            .collect()
    }

    /// The earliest starts, none before `starts`, that keep all edges and all rows chosen so far.
    fn earliest(&self, starts: &[i64]) -> Option<Vec<i64>> {
        let rows = starts.iter().zip(&self.rows);
        let mut starts: Vec<_> = rows.map(|(&start, &row)| self.in_row(start, row)).collect();
        loop {
            let mut settled = true;
            for edge in &self.graph.edges {
                let after = starts[edge.from] + edge.delay - edge.distance * self.interval;
                if after > LATEST {
                    return None;
                }
                if after > starts[edge.to] {
                    starts[edge.to] = self.in_row(after, self.rows[edge.to]);
                    settled = false;
                }
            }
            if settled {
                return Some(starts);
            }
        }
    }

    fn in_row(&self, start: i64, row: Option<i64>) -> i64 {
        row.map_or(start, |row| start + (row - start).rem_euclid(self.interval))
    }

    fn failure(&self) -> SchedulerError {
        let (interval, tries) = (self.interval as u32, self.tries);
        if tries == PATIENCE {
            SchedulerError::GaveUp { interval, tries }
        } else {
            SchedulerError::None { interval, tries }
        }
    }
}

/// The order in which bundles get their rows. Bundles of the most wanted resources go first; of equals, the
/// one with the longest path to the end of the iteration.
fn order(graph: &Graph, uses: &[Vec<Use>], interval: u32) -> Vec<usize> {
    let counts = resource_counts(graph);
    let heights = heights(graph, interval).unwrap_or_default();
    let mut order: Vec<_> = (0..graph.bundles.len()).collect();
    order.sort_by_key(|&bundle| {
        let wanted = uses[bundle].iter().map(|(resource, _)| counts[resource]);
        (Reverse(wanted.max()), Reverse(heights[bundle]), bundle)
    });
    order
}

#[cfg(test)]
mod tests {
    use super::super::graph::{FIXED, ROTATED};
    use super::*;

    #[test]
    fn two_groups_take_three_clocks_which_is_the_bound() {
        let graph = Graph::new(ROTATED);
        assert_eq!(resource_bound(&graph), 3);
        assert_eq!(recurrence_bound(&graph), 3);
        assert_eq!(schedule(&graph).map(|found| found.interval), Ok(3));
    }

    #[test]
    fn without_rotation_one_group_takes_two_clocks() {
        let graph = Graph::new(FIXED);
        assert_eq!(resource_bound(&graph), 2);
        assert_eq!(schedule(&graph).map(|found| found.interval), Ok(2));
    }

    #[test]
    fn an_interval_below_a_bound_is_refused_with_the_bound() {
        let graph = Graph::new(ROTATED);
        for interval in [1, 2] {
            let error = SchedulerError::Resources { interval, bound: 3 };
            assert_eq!(schedule_at(&graph, interval), Err(error));
        }
        // A square that is read 2 clocks after it is written, and is written again every clock.
        let mut graph = Graph::new(FIXED);
        for edge in &mut graph.edges {
            if edge.distance == 1 {
                edge.delay += 3;
            }
        }
        assert!(matches!(
            schedule_at(&graph, 2),
            Err(SchedulerError::Registers { interval: 2, .. })
        ));
    }

    #[test]
    fn every_start_keeps_every_edge_and_no_resource_is_taken_twice() {
        for adders in [ROTATED, FIXED] {
            let graph = Graph::new(adders);
            for interval in resource_bound(&graph)..8 {
                let found = schedule_at(&graph, interval).unwrap();
                let start = |bundle: usize| i64::from(found.starts[bundle]);
                for edge in &graph.edges {
                    let next = start(edge.to) + edge.distance * i64::from(interval);
                    assert!(next >= start(edge.from) + edge.delay, "{interval} {edge:?}");
                }
                let mut taken = BTreeSet::new();
                for (bundle, uses) in graph.bundles.iter().map(bundle_uses).enumerate() {
                    for (resource, clock) in uses {
                        let row = (found.starts[bundle] + clock) % interval;
                        assert!(taken.insert((resource, row)), "{interval} {resource:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_same_graph_has_the_same_schedule() {
        let graph = Graph::new(ROTATED);
        assert_eq!(schedule(&graph), schedule(&graph));
    }
}
