//! When the sides of the streams are ready or valid, and when a reset comes.

use rand::RngExt;
use rand_pcg::Pcg64;

/// How often a side of a stream is ready or valid.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Pace {
    Always,
    Mostly,
    Half,
    Rarely,
    /// `high` clocks yes, `low` clocks no, and again; it begins `phase` clocks late in that.
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

    /// Whether it is, in a clock of the batch.
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
    /// A reset comes in that clock of the batch.
    pub reset_at: Option<u64>,
    /// A result is taken only when nothing else has moved for a while: all that can wait for it fills up.
    pub late_results: bool,
    /// Words that are not asked for are random, not the next ones.
    pub garbage: bool,
}

impl Traffic {
    /// No waiting, no reset, no garbage: the machine's own pace.
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

/// What the stimulus did to the streams and the reset so far.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Pressure {
    /// Clocks in which the machine waited for query, group, or the taking of a result, and the stimulus had it and held
    /// it back.
    pub withheld: [u64; 3],
    /// The longest run of clocks in which the stimulus held each back.
    pub longest: [u64; 3],
    /// The run that lasts.
    run: [u64; 3],
    /// Clocks with a reset.
    pub resets: u64,
}

impl Pressure {
    /// One clock: which streams were held back, for which the machine waited, and whether there was a reset.
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
