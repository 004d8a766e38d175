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
