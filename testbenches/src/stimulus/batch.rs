//! The state of a batch of cases that is being driven.

use std::collections::VecDeque;

use photoncube_spec::Query;

use super::case::Case;
use super::traffic::Traffic;

/// A batch of cases that is being driven.
pub(super) struct Batch<'a> {
    pub(super) cases: &'a [Case],
    pub(super) traffic: Traffic,
    /// The queries whose results have not come, each by its case and its index in the case.
    pub(super) in_flight: VecDeque<(usize, usize)>,
    /// The first query that has not been taken, by its case and its index in the case.
    pub(super) next_query: (usize, usize),
    /// The next group to be offered, by its case and its index in the case.
    pub(super) next_group: (usize, usize),
    /// The next group is on the pins and stays until it is taken.
    pub(super) offered: bool,
    /// A query of the case whose queries are taken next has released its photons.
    pub(super) released: bool,
    /// The clocks since a query or a group was taken.
    pub(super) still: u32,
    /// The clocks since the batch began.
    pub(super) clocks: u64,
    /// The clocks of the query's program, including those up to the one that takes the query, without clocks
    /// spent waiting.
    pub(super) occupied: u64,
}

impl<'a> Batch<'a> {
    pub(super) fn new(cases: &'a [Case], traffic: Traffic) -> Self {
        Self {
            cases,
            traffic,
            in_flight: VecDeque::new(),
            next_query: (0, 0),
            next_group: (0, 0),
            offered: false,
            released: false,
            still: 0,
            clocks: 0,
            occupied: 0,
        }
    }

    pub(super) fn is_done(&self) -> bool {
        self.in_flight.is_empty() && self.next_query.0 >= self.cases.len()
    }

    pub(super) fn query(&self) -> Option<Query> {
        let (case, index) = self.next_query;
        self.cases.get(case).map(|case| case.queries[index])
    }

    /// Drops all queries and groups in the machine, and the rest of a case that is partly in.
    pub(super) fn reset(&mut self) {
        let (case, index) = self.next_query;
        let next = case + usize::from(index > 0);
        self.next_query = (next, 0);
        self.next_group = (next, 0);
        self.in_flight.clear();
        self.offered = false;
        self.released = false;
    }

    /// Records that a query is taken. `clocks` are the program's clocks up to the one that takes it;
    /// `releases` is that it releases its photons.
    pub(super) fn take_query(&mut self, clocks: u64, releases: bool) {
        let (case, index) = self.next_query;
        self.in_flight.push_back(self.next_query);
        self.released |= releases;
        self.next_query = if index + 1 < self.cases[case].queries.len() {
            (case, index + 1)
        } else {
            self.released = false;
            (case + 1, 0)
        };
        self.occupied = clocks;
        self.still = 0;
    }

    pub(super) fn take_group(&mut self) {
        self.still = 0;
        let (case, index) = self.next_group;
        self.next_group = if index + 1 < self.cases[case].groups.len() {
            (case, index + 1)
        } else {
            // Groups that the memory keeps are not sent again.
            let kept = self.cases[case..]
                .iter()
                .take_while(|case| case.keeps_photons);
            (case + 1 + kept.count(), 0)
        };
        self.offered = false;
    }
}
