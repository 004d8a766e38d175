//! The format and the machine that a scene needs, for `fit` and for `run`.

use anyhow::Result;
use photoncube_render::{
    FieldNeed, Fit, FitOptions, Measurement, Prediction, Scene, Trial, covering, field_needs, fit,
};
use photoncube_spec::{FormatWidths, MACHINES, Machine, PhotonFormat};
use serde::Serialize;

use crate::failure::CheckFailed;
use crate::measured::Measured;
use crate::progress;

/// A format with what was predicted and what was measured of it.
#[derive(Clone, Debug, Serialize)]
pub struct FormatRow {
    /// Its name.
    pub format: String,
    /// Bits of a stored photon.
    pub bits_per_photon: u32,
    /// From the pilot.
    pub prediction: Prediction,
    /// On maps of its own.
    pub measurement: Measurement,
    /// Below the bound, with channels for the scene's colours.
    pub holds: bool,
}

impl FormatRow {
    /// The row of a trial.
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

/// A machine that is wide enough.
#[derive(Clone, Debug)]
pub struct MachineChoice {
    /// The machine.
    pub machine: &'static Machine,
    /// Its own format.
    pub format: PhotonFormat,
    /// The error of its own format.
    pub measurement: Measurement,
    /// What it has more of than the scene needs.
    pub wider: Vec<FieldNeed>,
}

/// Fits a scene, with a bar whose end is a guess: how many formats are to be measured shows on the way.
pub fn fit_with_bar(scene: &Scene, options: &FitOptions) -> Result<Fit> {
    let bar = progress::bar("fitting the format", 0);
    let found = fit(scene, options, &|progress| {
        bar.set_length(progress.expected);
        bar.set_position(progress.done);
    })?;
    bar.finish_and_clear();
    Ok(found)
}

/// The smallest machine that is nowhere narrower than the format and whose own format is measured
/// below the bound; none where no machine is.
pub fn choose(fit: &Fit, options: &FitOptions, needed: &Trial) -> Result<Option<MachineChoice>> {
    for (machine, format) in by_size(covering(MACHINES, &needed.format).collect())? {
        let measurement = match *format == needed.format {
            true => needed.measured,
            false => fit.measure(format)?,
        };
        if measurement.error_over_noise <= options.noise_ratio {
            let needs = field_needs(format, &needed.format).into_iter();
            return Ok(Some(MachineChoice {
                machine,
                format: *format,
                measurement,
                wider: needs.filter(|need| need.found > need.needed).collect(),
            }));
        }
    }
    Ok(None)
}

type Covering = (&'static Machine, &'static PhotonFormat);

/// The smallest first: by area where that is measured of all of them, else by memory, then by the
/// widths of squarer and adders.
fn by_size(machines: Vec<Covering>) -> Result<Vec<Covering>> {
    let mut rows = Vec::new();
    for (machine, format) in machines {
        let area = Measured::of(machine)?.area_without_dsp;
        rows.push((area.map(|area| area.lut4_equivalents), machine, format));
    }
    let all_measured = rows.iter().all(|(area, ..)| area.is_some());
    rows.sort_by_key(|(area, _, format)| {
        let widths = FormatWidths::of(format);
        let area = area.filter(|_| all_measured);
        (
            area,
            widths.bits_per_photon,
            widths.difference,
            widths.power,
        )
    });
    Ok(rows
        .into_iter()
        .map(|(_, machine, format)| (machine, format))
        .collect())
}

/// The same where there must be both; what is missing is a failed check.
pub fn format_and_machine(fit: &Fit, options: &FitOptions) -> Result<(Trial, MachineChoice)> {
    let Some(trial) = &fit.chosen else {
        return Err(CheckFailed(no_format(options)).into());
    };
    match choose(fit, options, trial)? {
        Some(choice) => Ok((trial.clone(), choice)),
        None => Err(CheckFailed(no_machine(&trial.format)).into()),
    }
}

/// Why there is no format.
pub fn no_format(options: &FitOptions) -> String {
    format!(
        "no photon format's error is below {} of the scene's noise; expected a larger --noise-ratio",
        options.noise_ratio
    )
}

/// Why there is no machine, and how to have one.
pub fn no_machine(format: &PhotonFormat) -> String {
    format!(
        "no machine is wide enough for {format}; to have one, {}",
        row_to_add(format)
    )
}

/// What to write where for a machine of exactly this format.
pub fn row_to_add(format: &PhotonFormat) -> String {
    format!(
        "add a row to MACHINES in crates/spec/src/machine.rs with\n    \
         numbers: Numbers::Local({format:?})\nand, where its widths are new, a row to the table in \
         crates/hdl/src/build.rs"
    )
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_photon_format;

    use super::*;

    #[test]
    fn the_smallest_machine_is_first_and_the_row_to_add_is_a_format() {
        let needed = find_photon_format("local4-mono1-n1").unwrap();
        let machines = by_size(covering(MACHINES, &needed).collect()).unwrap();
        assert!(machines.len() > 1);
        assert!(
            machines
                .iter()
                .all(|(machine, _)| machine.plain().is_none())
        );
        let row = row_to_add(&needed);
        assert!(
            row.contains("position_bits: 4") && row.contains("channels: Mono"),
            "{row}"
        );
    }
}
