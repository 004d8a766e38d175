//! The form of a hard case, a row of the table.

use std::fmt;

use photoncube_model::{GatherError, PackError};
use photoncube_spec::{FormatError, PhotonFormat};
use thiserror::Error;

use super::grid::Grid;
use super::setting::Setting;
use photoncube_render::MapError;
use photoncube_render::QuantiseError;
use photoncube_render::SceneError;

/// A hard case: an input at which some arithmetic is known to fail.
#[derive(Debug, Clone, Copy)]
pub struct HardCase {
    /// The case's name on the command line and in the table.
    pub name: &'static str,
    /// The failure that the case provokes.
    pub breaks: &'static str,
    /// The unit of the result, as it reads after the number.
    pub result: &'static str,
    /// The bound that the result must satisfy.
    pub bound: Bound,
    /// The reason for the bound.
    pub why: &'static str,
    /// The result of an arithmetic that is known to fail.
    pub contrast: Contrast,
    /// Whether the case applies to a format.
    pub applies: fn(&PhotonFormat) -> bool,
    /// Makes the photons and queries on the grid of a format or machine; empty where the case is about values
    /// that never reach a machine.
    pub settings: fn(&Grid) -> Result<Vec<Setting>, HardCaseError>,
    /// Measures the result in a format.
    pub measure: fn(&PhotonFormat) -> Result<Outcome, HardCaseError>,
}

/// The bound of a result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// The result must be 0.
    Zero,
    /// The result must be at most this value.
    AtMost(f64),
}

impl Bound {
    /// Whether a result satisfies the bound; a NaN never does.
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

/// The result of an arithmetic that is known to fail, on the same input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contrast {
    /// The unit and the arithmetic, as they read after the number.
    pub what: &'static str,
    /// The least value of the contrast, in the worst format, at which the case counts as hard.
    pub at_least: f64,
}

/// The outcome of a case in one format.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// The number of decisions, photons or sums that were examined.
    pub looked_at: u64,
    /// The result, in the unit of [`HardCase::result`].
    pub result: f64,
    /// The contrast, in the unit of [`Contrast::what`].
    pub contrast: f64,
}

impl Outcome {
    /// An outcome of a number of wrong decisions; the contrast is in per cent of all decisions.
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

/// For cases that apply to every format.
pub(super) fn every_format(_: &PhotonFormat) -> bool {
    true
}

/// The reason why a case has no outcome.
#[derive(Debug, Error)]
pub enum HardCaseError {
    /// The room of the case is not a legal scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The photons of the case make no map.
    #[error(transparent)]
    Map(#[from] MapError),
    /// The format is not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// The map has no form in the numbers of the format or of a machine.
    #[error(transparent)]
    Quantise(#[from] QuantiseError),
    /// The format or a machine refuses a query.
    #[error(transparent)]
    Gather(#[from] GatherError),
    /// A packed record is not legal.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// Nothing was examined, so nothing was shown.
    #[error("case `{case}` looked at nothing in format `{format}`")]
    Nothing {
        /// The name of the case.
        case: &'static str,
        /// The name of the format.
        format: String,
    },
}
