//! The search for the smallest format below the bound: predicted first, then measured, then shown to be
//! smallest.

use std::collections::HashMap;

use photoncube_spec::{Channels, PhotonFormat, Widths};
use serde::Serialize;

use super::candidates::{cost, one_bit_less};
use super::predict::{Prediction, Predictor};
use crate::metrics::{BenchError, ErrorBench, LightReport, Measure};
use crate::render::Engine;

/// A format that was predicted on the pilot and then measured on maps of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// The format of the trial.
    pub format: PhotonFormat,
    /// The prediction of the pilot.
    pub predicted: Prediction,
    /// The error measured on other maps.
    pub measured: Measurement,
    /// Whether the measured error is below the bound and the format's channels represent the scene's colours.
    pub holds: bool,
}

/// A measured error, in the measure where it is largest against its own noise.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Measurement {
    /// The measure with the largest error.
    pub measure: Measure,
    /// The error over the noise.
    pub error_over_noise: f64,
    /// The lower end of its 95 % interval, by the jackknife over the maps.
    pub error_over_noise_low: f64,
    /// The upper end of its 95 % interval.
    pub error_over_noise_high: f64,
    /// The error over the noise of luminance, for comparison.
    pub luminance_error_over_noise: f64,
    /// The noise of the measure.
    pub noise_relative: f64,
    /// Photons that only one of reference and format finds in range, per cent of those in range.
    pub misclassified_percent: f64,
}

/// A format with one bit, or one degree of freedom, less.
#[derive(Debug, Clone, PartialEq)]
pub struct Removal {
    /// The name of what is less.
    pub less: &'static str,
    /// The trial of the format without it.
    pub trial: Trial,
}

/// Predicts and measures formats against the bound.
pub(super) struct Search<'a> {
    pub predictor: Predictor,
    pub proof: &'a ErrorBench,
    pub noise_ratio: f64,
    pub measured: HashMap<PhotonFormat, Measurement>,
    pub progress: &'a dyn Fn(u64),
}

impl Search<'_> {
    /// The first of `candidates` that is predicted and then measured below the bound, with the candidates
    /// that were measured above it before; `None` where no candidate holds.
    pub fn first(
        &mut self,
        candidates: &[PhotonFormat],
    ) -> Result<(Option<Trial>, Vec<Trial>), BenchError> {
        let mut broken = Vec::new();
        for format in candidates {
            let exceeds = self.predictor.a_part_exceeds(format, self.noise_ratio)?;
            self.report_progress();
            if exceeds {
                continue;
            }
            let predicted = self.predictor.predict(format)?;
            if predicted.error_over_noise > self.noise_ratio {
                continue;
            }
            let trial = self.trial(format)?;
            if trial.holds {
                return Ok((Some(trial), broken));
            }
            broken.push(trial);
        }
        Ok((None, broken))
    }

    /// The last of `candidates`, which has the most bits.
    pub fn widest(&mut self, candidates: &[PhotonFormat]) -> Result<Option<Trial>, BenchError> {
        candidates
            .last()
            .map(|format| self.trial(format))
            .transpose()
    }

    /// Descends from a format that holds to one from which nothing can be removed. Returns it with the trial
    /// of each removal.
    pub fn descend(&mut self, from: Trial) -> Result<(Trial, Vec<Removal>), BenchError> {
        let mut chosen = from;
        loop {
            let removals = self.removals(&chosen.format)?;
            let holding = removals.iter().filter(|removal| removal.trial.holds);
            match holding.min_by_key(|removal| cost(&removal.trial.format)) {
                Some(smaller) => chosen = smaller.trial.clone(),
                None => return Ok((chosen, removals)),
            }
        }
    }

    fn removals(&mut self, format: &PhotonFormat) -> Result<Vec<Removal>, BenchError> {
        let fewer = one_bit_less(format).into_iter();
        let removal = |(less, format): (&'static str, PhotonFormat)| {
            let trial = self.trial(&format)?;
            Ok(Removal { less, trial })
        };
        fewer.map(removal).collect()
    }

    fn trial(&mut self, format: &PhotonFormat) -> Result<Trial, BenchError> {
        let predicted = self.predictor.predict(format)?;
        let measured = match self.measured.get(format) {
            Some(measured) => *measured,
            None => Measurement::of(&self.proof.measure_light(Engine::from(format))?),
        };
        self.measured.insert(*format, measured);
        self.report_progress();
        Ok(Trial {
            format: *format,
            predicted,
            measured,
            holds: measured.error_over_noise <= self.noise_ratio && self.holds_colours(format),
        })
    }

    /// Whether the format's channels represent the scene's colours. One channel has only one colour, whatever
    /// a mean error shows.
    fn holds_colours(&self, format: &PhotonFormat) -> bool {
        format.power.channels == Channels::Rgb || self.predictor.pilot().facts.one_colour
    }

    fn report_progress(&self) {
        (self.progress)(self.predictor.parts() + self.measured.len() as u64);
    }
}

impl Trial {
    /// The number of bits of a stored photon.
    #[must_use]
    pub fn bits_per_photon(&self) -> u32 {
        Widths::of_format(&self.format).bits_per_photon
    }
}

impl Measurement {
    /// The worst of a report's measures.
    #[must_use]
    pub fn of(report: &LightReport) -> Self {
        let (measure, worst) = report.worst();
        let interval = report.worst_error_over_noise();
        Self {
            measure,
            error_over_noise: worst.error_over_noise,
            error_over_noise_low: interval.low,
            error_over_noise_high: interval.high,
            luminance_error_over_noise: report.luminance().error_over_noise,
            noise_relative: worst.noise_relative,
            misclassified_percent: worst.misclassified_percent,
        }
    }
}
