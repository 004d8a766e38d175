//! Runs a case in formats, and keeps the worst.

use photoncube_spec::{MACHINES, Machine, PHOTON_FORMATS, PhotonFormat, find_photon_format};
use rayon::prelude::*;
use serde::Serialize;

use super::case::{HardCase, HardCaseError, Outcome};

/// One of one channel and one that is dithered: no listed format is either.
const UNLISTED: [&str; 2] = ["local7x1-mono8e3", "local8-rgb8e5d"];

/// The formats that the cases run in: those that are listed, those of the machines, one of one channel,
/// one dithered.
///
/// # Panics
/// Never: the names are of legal formats, as a test holds.
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

/// A case's row: the worst of its formats.
#[derive(Debug, Clone, Serialize)]
pub struct HardCaseReport {
    /// The case.
    pub case: &'static str,
    /// What could break.
    pub breaks: &'static str,
    /// What the result is of, as it reads after the number.
    pub measures: &'static str,
    /// The worst result.
    pub result: f64,
    /// The format that it is of.
    pub worst_format: String,
    /// What it must be.
    pub bound: String,
    /// Why that.
    pub why: &'static str,
    /// What the contrast is of, likewise.
    pub contrast_of: &'static str,
    /// The worst contrast.
    pub contrast: f64,
    /// How bad it must at least be.
    pub contrast_at_least: f64,
    /// Formats that it ran in.
    pub formats_run: usize,
    /// What was looked at, over all formats.
    pub looked_at: u64,
    /// The result is within its bound, in every format.
    pub holds: bool,
    /// The contrast is bad enough, in one format at least.
    pub is_hard: bool,
    /// What ended it without a result, in the first format that did.
    pub refusal: Option<String>,
}

/// Runs a case in those of the formats that it says something about; `None` if it does about none.
///
/// Whatever goes wrong in a case is a row that does not hold.
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
        // A NaN is worse than any number.
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
