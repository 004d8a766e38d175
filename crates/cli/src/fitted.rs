//! Finds the format and the machine that a scene needs, for `fit` and for `run`.

use anyhow::Result;
use photoncube_render::{
    FieldNeed, Fit, FitOptions, Measurement, Prediction, Scene, Trial, covering, fed, field_needs,
    fit,
};
use photoncube_spec::{
    CustomError, CustomOrganisation, MACHINES, Machine, PhotonFormat, Pipeline, Widths,
    custom_machine,
};
use serde::Serialize;

use crate::args::short;
use crate::failure::CheckFailed;
use crate::hardware::PictureTime;
use crate::measured::Measured;
use crate::progress;

/// A format with its predicted and its measured error.
#[derive(Clone, Debug, Serialize)]
pub struct FormatRow {
    /// The name of the format.
    pub format: String,
    /// Bits of a stored photon.
    pub bits_per_photon: u32,
    /// The prediction of the pilot.
    pub prediction: Prediction,
    /// The measurement on other maps.
    pub measurement: Measurement,
    /// Whether the error is below the bound and the channels represent the scene's colours.
    pub holds: bool,
}

impl FormatRow {
    /// Makes the row of a trial.
    pub fn of(trial: &Trial) -> Self {
        Self {
            format: trial.format.name(),
            bits_per_photon: trial.bits_per_photon(),
            prediction: trial.predicted,
            measurement: trial.measured,
            holds: trial.holds,
        }
    }
}

/// A machine that is wide enough for a scene.
#[derive(Clone, Debug)]
pub struct MachineChoice {
    /// The chosen machine.
    pub machine: &'static Machine,
    /// The format of the photons that it is fed: its own widths, with the rounding of the fitted format.
    pub format: PhotonFormat,
    /// The error of that format.
    pub measurement: Measurement,
    /// The fields in which the machine is wider than the scene needs.
    pub wider: Vec<FieldNeed>,
    /// The time of the fit's queries on one of its maps.
    pub time: PictureTime,
}

/// The machines for a scene. Both cover the fitted format and are measured below the bound. They may be one
/// machine.
#[derive(Clone, Debug)]
pub struct Choices {
    /// The smallest machine of exactly the fitted format; where there is none, the one with the fewest bits
    /// of a stored photon. Of several machines it is the one with the least area.
    pub smallest: MachineChoice,
    /// The machine with the fewest seconds for the picture of the fit's queries, at its measured clock.
    pub fastest: MachineChoice,
}

/// Fits a scene and shows a progress bar. The end of the bar is an estimate, because the number of formats to
/// measure becomes known only during the fit.
pub fn fit_with_bar(scene: &Scene, options: &FitOptions) -> Result<Fit> {
    let bar = progress::bar("fitting the format", 0);
    let found = fit(scene, options, &|progress| {
        bar.set_length(progress.expected);
        bar.set_position(progress.done);
    })?;
    bar.finish_and_clear();
    Ok(found)
}

/// The machines for the needed format; `None` where no machine covers it and is below the bound.
pub fn choose(fit: &Fit, options: &FitOptions, needed: &Trial) -> Result<Option<Choices>> {
    let candidates = candidates(fit, needed)?;
    let below_bound = |candidates: Vec<Candidate>| -> Result<Option<MachineChoice>> {
        for candidate in candidates {
            let choice = candidate.measured(fit, needed)?;
            if choice.measurement.error_over_noise <= options.noise_ratio {
                return Ok(Some(choice));
            }
        }
        Ok(None)
    };
    let smallest = below_bound(by_size(candidates.clone(), &needed.format))?;
    let fastest = below_bound(by_speed(candidates))?;
    Ok(smallest
        .zip(fastest)
        .map(|(smallest, fastest)| Choices { smallest, fastest }))
}

/// A machine that covers the needed format, with the criteria of the choice.
#[derive(Clone, Debug)]
struct Candidate {
    machine: &'static Machine,
    format: PhotonFormat,
    lut4_equivalents: Option<u64>,
    time: PictureTime,
}

impl Candidate {
    /// Measures the error of the photons that the machine is fed.
    fn measured(self, fit: &Fit, needed: &Trial) -> Result<MachineChoice> {
        let format = fed(&self.format, &needed.format);
        let measurement = match format == needed.format {
            true => needed.measured,
            false => fit.measure(&format)?,
        };
        let needs = field_needs(&self.format, &needed.format).into_iter();
        Ok(MachineChoice {
            machine: self.machine,
            format,
            measurement,
            wider: needs.filter(|need| need.found > need.needed).collect(),
            time: self.time,
        })
    }
}

fn candidates(fit: &Fit, needed: &Trial) -> Result<Vec<Candidate>> {
    let (map, queries) = (&fit.bench.maps()[0], fit.bench.queries());
    let covering = covering(MACHINES, &needed.format);
    let custom = custom_candidate(&needed.format);
    let custom = custom.and_then(|machine| Some((machine, machine.format()?)));
    let candidate = |(machine, format): (&'static Machine, &PhotonFormat)| {
        let area = Measured::of(machine)?.area_without_dsp;
        Ok(Candidate {
            machine,
            format: *format,
            lut4_equivalents: area.map(|area| area.lut4_equivalents),
            time: PictureTime::of(machine, map, queries)?,
        })
    };
    covering.chain(custom).map(candidate).collect()
}

/// The custom machine of the format, where no named machine has exactly this format.
fn custom_candidate(format: &PhotonFormat) -> Option<&'static Machine> {
    let is_named = MACHINES
        .iter()
        .any(|machine| machine.format() == Some(format));
    custom(format).ok().filter(|_| !is_named)
}

/// The machine that a format gets which no named machine has: one engine takes fewer LUTs than the paper's cells, and
/// tests a group in every clock.
fn custom(format: &PhotonFormat) -> Result<&'static Machine, CustomError> {
    custom_machine(
        CustomOrganisation::Stream {
            pipeline: Pipeline::Deep,
        },
        format,
    )
}

/// Sorts machines by size: first those of exactly the format, then by the bits of a stored photon, then by
/// area. A machine without a measured area counts as larger.
fn by_size(mut candidates: Vec<Candidate>, needed: &PhotonFormat) -> Vec<Candidate> {
    candidates.sort_by_key(|candidate| {
        (
            candidate.format != *needed,
            Widths::of_format(&candidate.format).bits_per_photon,
            candidate.lut4_equivalents.unwrap_or(u64::MAX),
        )
    });
    candidates
}

/// Sorts machines by speed, the fastest first. A machine without a measured clock counts as slower.
fn by_speed(mut candidates: Vec<Candidate>) -> Vec<Candidate> {
    let seconds =
        |candidate: &Candidate| candidate.time.seconds_per_picture.unwrap_or(f64::INFINITY);
    candidates.sort_by(|a, b| seconds(a).total_cmp(&seconds(b)));
    candidates
}

/// The fitted format and its machines. It is a failed check where either is missing.
pub fn format_and_machines(fit: &Fit, options: &FitOptions) -> Result<(Trial, Choices)> {
    let Some(trial) = &fit.chosen else {
        return Err(CheckFailed(no_format(fit, options)).into());
    };
    match choose(fit, options, trial)? {
        Some(choices) => Ok((trial.clone(), choices)),
        None => Err(CheckFailed(no_machine(&trial.format)).into()),
    }
}

/// A message that states why there is no format, and what the error can come down to.
pub fn no_format(fit: &Fit, options: &FitOptions) -> String {
    let bound = short(options.noise_ratio);
    let widest = match &fit.widest {
        Some(trial) => format!(
            ", at least {:.2e}: the widest, {}, is measured there",
            rounded_up(trial.measured.error_over_noise),
            trial.format
        ),
        None => String::new(),
    };
    format!(
        "no photon format's error is below {bound} of the scene's noise; expected a larger --noise-ratio{widest}"
    )
}

/// The number of three digits that is not below `error`, so that a bound of it holds.
fn rounded_up(error: f64) -> f64 {
    let step = 10_f64.powf(error.log10().floor() - 2.0);
    (error / step).ceil() * step
}

/// A message that states why there is no machine.
pub fn no_machine(format: &PhotonFormat) -> String {
    let why = match custom(format) {
        Err(error) => error.to_string(),
        Ok(machine) => format!("the error of {} is measured above the bound", machine.name),
    };
    format!("no machine is wide enough for {format}: {why}")
}

/// Options for a fit of a second, for tests in which any format that is found will do.
#[cfg(test)]
pub fn quick_options() -> FitOptions {
    use photoncube_render::{BenchOptions, ViewOptions};

    let options = FitOptions::default();
    let view = ViewOptions {
        width: 8,
        height: 8,
        ..options.bench.view
    };
    FitOptions {
        noise_ratio: 0.3,
        bench: BenchOptions {
            photons: 5_000,
            maps: 3,
            view,
            ..options.bench
        },
        ..options
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{find_machine, find_photon_format};

    use super::*;

    fn candidate(name: &str) -> Candidate {
        let machine = find_machine(name).unwrap();
        Candidate {
            machine,
            format: *machine.format().unwrap(),
            lut4_equivalents: Some(1),
            time: time(Some(2.0)),
        }
    }

    fn time(seconds_per_picture: Option<f64>) -> PictureTime {
        PictureTime {
            seconds_per_picture,
            ..PictureTime::default()
        }
    }

    fn names(candidates: &[Candidate]) -> Vec<&str> {
        candidates.iter().map(|c| c.machine.name).collect()
    }

    #[test]
    fn a_bound_that_is_named_is_not_below_the_error() {
        for error in [0.012_941, 0.012_999, 0.013, 1.234_5e-5, 2.0] {
            let named: f64 = format!("{:.2e}", rounded_up(error)).parse().unwrap();
            assert!(error <= named && named < 1.011 * error, "{error}: {named}");
        }
    }

    #[test]
    fn a_machine_of_exactly_the_format_is_smaller_than_any_other() {
        let needed = *find_machine("fit-cornell").unwrap().format().unwrap();
        let exact = Candidate {
            lut4_equivalents: Some(9999),
            ..candidate("fit-cornell")
        };
        let stream = candidate("stream");
        assert_eq!(
            names(&by_size(vec![stream, exact], &needed)),
            ["fit-cornell", "stream"]
        );
    }

    #[test]
    fn without_an_exact_machine_bits_decide_before_area() {
        let needed = find_photon_format("local4-mono1-n1").unwrap();
        let stream = candidate("stream");
        let tile = Candidate {
            lut4_equivalents: Some(2),
            ..candidate("tile-4")
        };
        let unmeasured = Candidate {
            lut4_equivalents: None,
            ..candidate("tile-5")
        };
        let sorted = by_size(vec![stream, unmeasured, tile], &needed);
        assert_eq!(names(&sorted), ["tile-4", "tile-5", "stream"]);
    }

    #[test]
    fn a_machine_without_a_clock_is_the_slowest() {
        let slow = candidate("tile-4");
        let fast = Candidate {
            time: time(Some(1.0)),
            ..candidate("stream")
        };
        let unmeasured = Candidate {
            time: time(None),
            ..candidate("tile-5")
        };
        let sorted = by_speed(vec![unmeasured, slow, fast]);
        assert_eq!(names(&sorted), ["stream", "tile-4", "tile-5"]);
    }

    fn small_fit() -> Fit {
        let scene = Scene::built_in("cornell").unwrap();
        fit(&scene, &quick_options(), &|_| ()).unwrap()
    }

    /// Rounded to nearest, a machine's own powers may be too coarse where dithered ones are not.
    #[test]
    fn a_machine_is_measured_with_the_rounding_of_the_fit() {
        let format = |name| find_photon_format(name).unwrap();
        let fit = small_fit();
        let needed = Trial {
            format: format("local6-rgb4d-n4096"),
            ..fit.chosen.clone().unwrap()
        };
        let error = |name| fit.measure(&format(name)).unwrap().error_over_noise;
        let local = candidate("local").measured(&fit, &needed).unwrap();
        assert_eq!(local.format, format("local8-rgb8e5d"));
        let found = local.measurement.error_over_noise;
        assert_eq!(found.to_bits(), error("local8-rgb8e5d").to_bits());
        assert_ne!(found.to_bits(), error("local8-rgb8e5").to_bits());
    }

    #[test]
    fn a_format_without_a_named_machine_has_one_of_its_own() {
        let named = find_machine("fit-cornell").unwrap().format().unwrap();
        assert!(custom_candidate(named).is_none());
        let format = find_photon_format("local6x1-rgb4b5d-n5000").unwrap();
        let machine = custom_candidate(&format).unwrap();
        assert_eq!(machine.name, "stream-local6x1-rgb4b5d-n5000");
        let too_wide = find_photon_format("local6-rgb16e8-n4294967296").unwrap();
        assert!(custom_candidate(&too_wide).is_none());
        assert!(
            no_machine(&too_wide).contains("bits of a sum is 72"),
            "{}",
            no_machine(&too_wide)
        );
    }
}
