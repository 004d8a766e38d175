//! The pace of the streams' valid and ready, and the times of resets.

use rand::RngExt;
use rand_pcg::Pcg64;

/// The rate at which a side of a stream is ready or valid.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Pace {
    Always,
    Mostly,
    Half,
    Rarely,
    /// A cycle of `high` clocks with the signal set and `low` clocks without, which begins `phase` clocks
    /// late.
    Pattern {
        high: u64,
        low: u64,
        phase: u64,
    },
}

impl Pace {
    fn any(rng: &mut Pcg64) -> Self {
        match rng.random_range(0..8) {
            0..=3 => Self::Always,
            4 | 5 => Self::Mostly,
            6 => Self::Half,
            _ => Self::Rarely,
        }
    }

    /// Whether the signal is set in a clock of the batch.
    pub fn draw(self, rng: &mut Pcg64, clock: u64) -> bool {
        match self {
            Self::Always => true,
            Self::Mostly => rng.random_ratio(7, 8),
            Self::Half => rng.random(),
            Self::Rarely => rng.random_ratio(1, 12),
            Self::Pattern { high, low, phase } => (clock + phase) % (high + low) < high,
        }
    }
}

/// The paces of the three streams, and whether a reset may come at any time.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Traffic {
    pub query: Pace,
    pub group: Pace,
    pub result: Pace,
    pub resets: bool,
    /// The clock of the batch in which a reset comes.
    pub reset_at: Option<u64>,
    /// Results are taken only when nothing else has moved for some clocks, so that every queue fills up.
    pub late_results: bool,
    /// Words that are not valid are random instead of the next valid words.
    pub garbage: bool,
}

impl Traffic {
    /// Without waiting, resets and garbage: the machine's own pace.
    pub const STREAMING: Self = Self {
        query: Pace::Always,
        group: Pace::Always,
        result: Pace::Always,
        resets: false,
        reset_at: None,
        late_results: false,
        garbage: false,
    };

    pub fn any(rng: &mut Pcg64, may_reset: bool) -> Self {
        Self {
            query: Pace::any(rng),
            group: Pace::any(rng),
            result: Pace::any(rng),
            resets: may_reset && rng.random_ratio(1, 4),
            reset_at: None,
            late_results: rng.random_ratio(1, 8),
            garbage: true,
        }
    }
}

/// Statistics of what the stimulus did to the streams and the reset so far.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Pressure {
    /// For each of query, group and result: the clocks in which the machine waited for the stream, and the
    /// stimulus held it back although it could move.
    pub withheld: [u64; 3],
    /// For each stream, the longest run of clocks in which the stimulus held it back.
    pub longest: [u64; 3],
    /// For each stream, the current run of such clocks.
    run: [u64; 3],
    /// The number of clocks with a reset.
    pub resets: u64,
}

impl Pressure {
    /// Records one clock: the streams held back, the streams that the machine waited for, and whether there
    /// was a reset.
    pub(super) fn clock(&mut self, held: [bool; 3], waits: [bool; 3], reset: bool) {
        self.resets += u64::from(reset);
        for stream in 0..3 {
            let held = held[stream];
            self.withheld[stream] += u64::from(held && waits[stream]);
            self.run[stream] = if held { self.run[stream] + 1 } else { 0 };
            self.longest[stream] = self.longest[stream].max(self.run[stream]);
        }
    }
}
