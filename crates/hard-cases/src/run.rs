//! Runs a case in several formats and keeps the worst outcome.

use photoncube_spec::{MACHINES, Machine, PHOTON_FORMATS, PhotonFormat, find_photon_format};
use rayon::prelude::*;
use serde::Serialize;

use super::case::{HardCase, HardCaseError, Outcome};

/// Two formats of kinds that no listed format has: one channel, and dithered.
const UNLISTED: [&str; 2] = ["local7x1-mono8e3", "local8-rgb8e5d"];

/// The formats that the cases run in: the listed ones, those of the machines, one with one channel, one with
/// dithering.
///
/// # Panics
/// Never: the names are those of legal formats, as a test shows.
#[must_use]
pub fn hard_case_formats() -> Vec<PhotonFormat> {
    let unlisted = UNLISTED.map(|name| find_photon_format(name).expect("a legal format"));
    let of_machines = MACHINES.iter().filter_map(Machine::format).copied();
    let mut formats = PHOTON_FORMATS.to_vec();
    for format in of_machines.chain(unlisted) {
        if !formats.contains(&format) {
            formats.push(format);
        }
    }
    formats
}

/// The report of a case: the worst of its formats.
#[derive(Debug, Clone, Serialize)]
pub struct HardCaseReport {
    /// The name of the case.
    pub case: &'static str,
    /// The failure that the case provokes.
    pub breaks: &'static str,
    /// The unit of the result, as it reads after the number.
    pub measures: &'static str,
    /// The worst result.
    pub result: f64,
    /// The format of the worst result.
    pub worst_format: String,
    /// The bound of the result.
    pub bound: String,
    /// The reason for the bound.
    pub why: &'static str,
    /// The unit of the contrast, as it reads after the number.
    pub contrast_of: &'static str,
    /// The worst contrast.
    pub contrast: f64,
    /// The least contrast at which the case counts as hard.
    pub contrast_at_least: f64,
    /// The number of formats that the case ran in.
    pub formats_run: usize,
    /// The number of decisions, photons or sums examined, over all formats.
    pub looked_at: u64,
    /// Whether the result satisfies its bound in every format.
    pub holds: bool,
    /// Whether the contrast is bad enough in at least one format.
    pub is_hard: bool,
    /// The error that ended the case without a result, in the first such format.
    pub refusal: Option<String>,
}

/// Runs a case in the formats that it applies to; `None` if it applies to none.
///
/// Every error in a case gives a row that does not hold.
#[must_use]
pub fn run_hard_case(case: &HardCase, formats: &[PhotonFormat]) -> Option<HardCaseReport> {
    let formats: Vec<_> = formats
        .iter()
        .filter(|format| (case.applies)(format))
        .collect();
    let outcomes: Vec<_> = formats
        .par_iter()
        .map(|format| outcome(case, format))
        .collect();
    let mut report = empty(case);
    for (format, outcome) in formats.iter().zip(outcomes) {
        match outcome {
            Ok(outcome) => report.add(case, format, &outcome),
            Err(error) => {
                report.refusal.get_or_insert(format!("{format}: {error}"));
            }
        }
    }
    report.is_hard = report.contrast >= case.contrast.at_least;
    report.holds &= report.refusal.is_none();
    (!formats.is_empty()).then_some(report)
}

fn outcome(case: &HardCase, format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let outcome = (case.measure)(format)?;
    if outcome.looked_at == 0 {
        return Err(HardCaseError::Nothing {
            case: case.name,
            format: format.name(),
        });
    }
    Ok(outcome)
}

fn empty(case: &HardCase) -> HardCaseReport {
    HardCaseReport {
        case: case.name,
        breaks: case.breaks,
        measures: case.result,
        result: 0.0,
        worst_format: String::new(),
        bound: case.bound.to_string(),
        why: case.why,
        contrast_of: case.contrast.what,
        contrast: 0.0,
        contrast_at_least: case.contrast.at_least,
        formats_run: 0,
        looked_at: 0,
        holds: true,
        is_hard: false,
        refusal: None,
    }
}

impl HardCaseReport {
    fn add(&mut self, case: &HardCase, format: &PhotonFormat, outcome: &Outcome) {
        // A NaN counts as worse than any number.
        let is_worse = self.formats_run == 0 || outcome.result > self.result;
        if is_worse || outcome.result.is_nan() {
            self.result = outcome.result;
            self.worst_format = format.name();
        }
        self.contrast = self.contrast.max(outcome.contrast);
        self.holds &= case.bound.holds(outcome.result);
        self.looked_at += outcome.looked_at;
        self.formats_run += 1;
    }
}
