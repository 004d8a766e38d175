//! The pipeline of powers in an engine: gate, the group's sums, the query's sums, the result chain.

use std::mem;

use photoncube_spec::{Cut, Spatial, Sums};

use super::link::{Flags, Powers, ResultLink};
use super::rules::{Rules, ones};

/// The sums over lanes 0 and 1, and over lanes 2 and 3.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Pairs {
    pub(super) sums: [Sums; 2],
    pub(super) flags: Flags,
}

/// The sums over all lanes of a group.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Group {
    pub(super) sums: Sums,
    pub(super) flags: Flags,
}

/// The pipeline registers behind the power hop.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct SumFlow {
    pub(super) gated: Powers,
    pub(super) pairs: Pairs,
    pub(super) group: Group,
    pub(super) sum: Sums,
    pub(super) done: bool,
    pub(super) result: ResultLink,
}

impl SumFlow {
    /// Applies one clock. The inputs are the previous values of the power hop, the lanes' in-range flags
    /// beside it, and the next engine's link of the result chain.
    pub(super) fn clock(
        &mut self,
        rules: &Rules,
        powers: Powers,
        in_range: [bool; Spatial::LANES],
        beyond: ResultLink,
    ) {
        let gated = rules.cut(Cut::Gate, &mut self.gated, powers.gated(in_range));
        let pairs = rules.cut(Cut::PairPower, &mut self.pairs, gated.pairs());
        let group = rules.cut(Cut::GroupPower, &mut self.group, pairs.total());
        let before = self.sum;
        self.sum = group.added_to(rules, before);
        let done = mem::replace(&mut self.done, group.flags.last);
        self.result = ResultLink {
            valid: done || beyond.valid,
            sums: if done { before } else { beyond.sums },
        };
    }

    /// Clears the flags, after a clock in which the reset arrived.
    pub(super) fn clear_flags(&mut self) {
        self.gated.flags = Flags::default();
        self.pairs.flags = Flags::default();
        self.group.flags = Flags::default();
        self.done = false;
        self.result.valid = false;
    }
}

impl Powers {
    fn gated(mut self, in_range: [bool; Spatial::LANES]) -> Self {
        for (lane, in_range) in in_range.into_iter().enumerate() {
            if !in_range {
                self.power[lane] = [0; 3];
                self.present[lane] = false;
            }
        }
        self
    }

    fn pairs(&self) -> Pairs {
        let lane = |lane: usize| Sums {
            power: self.power[lane].map(u128::from),
            count: self.present[lane].into(),
        };
        Pairs {
            sums: [plus(lane(0), lane(1)), plus(lane(2), lane(3))],
            flags: self.flags,
        }
    }
}

impl Pairs {
    fn total(&self) -> Group {
        Group {
            sums: plus(self.sums[0], self.sums[1]),
            flags: self.flags,
        }
    }
}

impl Group {
    /// The query's sums plus the group's, modulo their widths. A sum can wrap only after a reset during a
    /// batch.
    fn added_to(&self, rules: &Rules, sums: Sums) -> Sums {
        let before = if self.flags.first {
            Sums::default()
        } else {
            sums
        };
        let Sums { power, count } = plus(before, self.sums);
        Sums {
            power: power.map(|channel| channel & u128::from(ones(rules.widths.sum))),
            count: count & ones(rules.widths.count),
        }
    }
}

fn plus(a: Sums, b: Sums) -> Sums {
    Sums {
        power: [0, 1, 2].map(|channel| a.power[channel] + b.power[channel]),
        count: a.count + b.count,
    }
}
