//! An engine: its query, its four lanes and its sums.

use std::{array, mem};

use photoncube_spec::{Machine, Query, Spatial};

use super::lane::Lane;
use super::link::{Flags, Hop, ResultLink};
use super::rules::{CUTS_BEFORE_RANGE, Rules};
use super::sums::SumFlow;

/// An engine with its registers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Engine {
    pub(super) rules: Rules,
    pub(super) hop: Hop,
    pub(super) next_valid: bool,
    /// The token in the hop register becomes the next query.
    pub(super) keep: bool,
    pub(super) next: Query,
    pub(super) query: Query,
    pub(super) radius_delay: [u32; CUTS_BEFORE_RANGE],
    pub(super) lanes: [Lane; Spatial::LANES],
    pub(super) sums: SumFlow,
}

impl Engine {
    pub(super) fn new(machine: &Machine, spatial: &Spatial, engine: usize) -> Self {
        Self {
            rules: Rules::of(machine, spatial, engine),
            hop: Hop::default(),
            next_valid: false,
            keep: false,
            next: Query::default(),
            query: Query::default(),
            radius_delay: Default::default(),
            lanes: Default::default(),
            sums: SumFlow::default(),
        }
    }

    /// The engine's link of the result chain.
    pub(super) fn result(&self) -> ResultLink {
        self.sums.result
    }

    /// Applies one clock. The inputs come from the engine before and from the result chain of the engine
    /// after. Returns the previous values of the hop registers, for the engine after.
    pub(super) fn clock(&mut self, incoming: Hop, beyond: ResultLink) -> Hop {
        let radius_sq = self.radius_at_compare();
        let (rules, query, photons) = (&self.rules, self.query.position, self.hop.photon);
        let lanes = &mut self.lanes;
        let in_range =
            array::from_fn(|lane| lanes[lane].clock(rules, query, photons[lane], radius_sq));
        self.sums.clock(rules, self.hop.powers, in_range, beyond);

        let passed = self.take_query(&incoming);
        let before = mem::replace(&mut self.hop, incoming);
        self.hop.token_valid = passed;
        if incoming.reset {
            self.hop.token_valid = false;
            self.hop.swap = false;
            self.hop.powers.flags = Flags::default();
            self.next_valid = false;
            self.sums.clear_flags();
        }
        // A result of the next engine, which the reset reaches one clock later, is on its way back.
        if before.reset {
            self.sums.result.valid = false;
        }
        before
    }

    /// Advances the delay of the radius and returns the radius at the compare.
    fn radius_at_compare(&mut self) -> u32 {
        let delays = &mut self.radius_delay[..self.rules.radius_delays];
        let own = self.query.radius_sq;
        let delayed = match delays.last().copied() {
            None => own,
            Some(last) => {
                delays.rotate_right(1);
                delays[0] = own;
                last
            }
        };
        self.rules.fixed_radius_sq.unwrap_or(delayed)
    }

    /// Makes the next query the current one where a first group arrives, and keeps the incoming token where
    /// there is room. Returns whether the incoming token passes to the next engine.
    fn take_query(&mut self, incoming: &Hop) -> bool {
        if self.keep {
            self.next = self.hop.token;
        }
        if incoming.swap {
            self.query = self.next;
            self.next_valid = false;
        }
        self.keep = incoming.token_valid && !self.next_valid;
        self.next_valid |= self.keep;
        incoming.token_valid && !self.keep
    }
}
