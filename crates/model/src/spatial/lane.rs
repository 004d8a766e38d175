//! One lane of an engine: the photon's distance and its in-range flag.

use std::mem;

use photoncube_spec::Cut;

use super::axis::Axis;
use super::rules::{CUTS_BEFORE_RANGE, Rules};

/// The sum of the squares on x and y, and the square on z.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Pair {
    pub(super) square: u64,
    pub(super) z: u64,
    pub(super) far: bool,
}

/// The sum of the squares on all three axes.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Distance {
    pub(super) word: u64,
    pub(super) far: bool,
}

/// The registers of one lane.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Lane {
    pub(super) axes: [Axis; 3],
    pub(super) pair: Pair,
    pub(super) distance: Distance,
    pub(super) in_range: bool,
    pub(super) range_wait: [bool; CUTS_BEFORE_RANGE],
    pub(super) range_delay: bool,
    pub(super) decision: bool,
}

impl Lane {
    /// Applies one clock and returns the in-range flag after `Cut::Decision`. `radius_sq` is the squared
    /// radius at the compare in this clock.
    pub(super) fn clock(
        &mut self,
        rules: &Rules,
        query: [u32; 3],
        photon: [u32; 3],
        radius_sq: u32,
    ) -> bool {
        let mut square = |a: usize| self.axes[a].clock(rules, query[a], photon[a]);
        let [x, y, z] = [square(0), square(1), square(2)];
        let pair = Pair {
            square: x.word + y.word,
            z: z.word,
            far: x.far || y.far || z.far,
        };
        let pair = rules.cut(Cut::Pair, &mut self.pair, pair);
        let distance = Distance {
            word: pair.square + pair.z,
            far: pair.far,
        };
        let distance = rules.cut(Cut::Distance, &mut self.distance, distance);
        let in_range = !distance.far && distance.word <= u64::from(radius_sq);
        let in_range = rules.cut(Cut::Range, &mut self.in_range, in_range);
        let waits = &mut self.range_wait[..rules.range_waits];
        let waited = waits
            .iter_mut()
            .fold(in_range, |newer, wait| mem::replace(wait, newer));
        let delayed = rules.cut(Cut::RangeDelay, &mut self.range_delay, waited);
        rules.cut(Cut::Decision, &mut self.decision, delayed)
    }
}
