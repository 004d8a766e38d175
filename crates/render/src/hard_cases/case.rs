//! A row of the table.

use std::fmt;

use photoncube_model::{GatherError, LocalError, PackError};
use photoncube_spec::{FormatError, PhotonFormat};
use thiserror::Error;

use super::grid::Grid;
use super::setting::Setting;
use crate::format_map::FormatMapError;
use crate::photon_map::MapError;
use crate::render::RenderError;
use crate::scene::SceneError;

/// A hard case.
#[derive(Debug, Clone, Copy)]
pub struct HardCase {
    /// Its name on the command line and in the table.
    pub name: &'static str,
    /// What could break.
    pub breaks: &'static str,
    /// What the result is of, as it reads after the number.
    pub result: &'static str,
    /// What the result must be.
    pub bound: Bound,
    /// Why that.
    pub why: &'static str,
    /// What some other arithmetic makes of it.
    pub contrast: Contrast,
    /// Whether it says anything about a format.
    pub applies: fn(&PhotonFormat) -> bool,
    /// The photons and queries, on a grid of its own for each format or machine; none where the case
    /// is about what never reaches a machine.
    pub settings: fn(&Grid) -> Result<Vec<Setting>, HardCaseError>,
    /// The result in a format.
    pub measure: fn(&PhotonFormat) -> Result<Outcome, HardCaseError>,
}

/// What a result must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Exactly 0.
    Zero,
    /// At most this.
    AtMost(f64),
}

impl Bound {
    /// Whether a result is within; a NaN never is.
    #[must_use]
    pub fn holds(self, result: f64) -> bool {
        match self {
            Self::Zero => result == 0.0,
            Self::AtMost(largest) => result <= largest,
        }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Zero => f.write_str("= 0"),
            Self::AtMost(largest) if *largest < 1e-3 => write!(f, "<= {largest:e}"),
            Self::AtMost(largest) => write!(f, "<= {largest}"),
        }
    }
}

/// What an arithmetic that is known to fail gives on the same input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contrast {
    /// What is counted in which arithmetic, as it reads after the number.
    pub what: &'static str,
    /// How bad it must at least be, in the worst format, for the case to be hard.
    pub at_least: f64,
}

/// What a case found in one format.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Decisions, photons or sums that were looked at.
    pub looked_at: u64,
    /// The result.
    pub result: f64,
    /// The contrast.
    pub contrast: f64,
}

impl Outcome {
    /// Of decisions, some wrong ones; the contrast in per cent of all of them.
    pub(super) fn wrong(wrong: u64, naively_wrong: u64, looked_at: u64) -> Self {
        Self {
            looked_at,
            result: wrong as f64,
            contrast: percent(naively_wrong, looked_at),
        }
    }
}

/// `part` in per cent of `all`.
pub(super) fn percent(part: u64, all: u64) -> f64 {
    100.0 * part as f64 / all as f64
}

/// For cases that say something about every format.
pub(super) fn every_format(_: &PhotonFormat) -> bool {
    true
}

/// Why a case has no outcome.
#[derive(Debug, Error)]
pub enum HardCaseError {
    /// Its room is no scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// Its photons make no map.
    #[error(transparent)]
    Map(#[from] MapError),
    /// The format is not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// The format cannot have the map.
    #[error(transparent)]
    FormatMap(#[from] FormatMapError),
    /// The format refuses a query.
    #[error(transparent)]
    Gather(#[from] LocalError),
    /// A machine refuses a query.
    #[error(transparent)]
    Machine(#[from] GatherError),
    /// A machine's numbers do not fit.
    #[error(transparent)]
    Numbers(#[from] RenderError),
    /// A record is none.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// Nothing was looked at, so nothing was shown.
    #[error("case `{case}` looked at nothing in format `{format}`")]
    Nothing {
        /// The case.
        case: &'static str,
        /// The format.
        format: String,
    },
}
