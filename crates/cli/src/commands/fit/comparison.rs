//! Compares the widths, area and clocks of the fitted format with those of other machines.

use anyhow::Result;
use photoncube_spec::{MACHINES, Machine, Numbers, PHOTON_FORMATS, PhotonFormat, Widths};
use serde::Serialize;

use crate::fitted::Choices;
use crate::measured::Measured;

/// A machine, existing or possible.
#[derive(Serialize)]
pub struct Compared {
    /// The name of the machine, or a word for a possible one.
    pub name: String,
    /// The photon format; `None` in plain numbers.
    pub format: Option<String>,
    /// Bits of a stored photon.
    pub bits_per_photon: u32,
    /// The bits of a photon that the fitted format saves compared with this machine.
    pub bits_per_photon_saved: i64,
    /// Bits of the difference that is squared.
    pub radius_bits: u32,
    /// Bits of a decoded power.
    pub power_bits: u32,
    /// Bits of the work register and of the links.
    pub work_bits: u32,
    /// Bits of the sums.
    pub sum_bits: u32,
    /// LUT4 equivalents without DSP blocks; `None` if not measured.
    pub lut4_equivalents: Option<u64>,
    /// The number of flip-flops; `None` if not measured.
    pub ff: Option<u64>,
    /// The highest clock in MHz; `None` if not measured.
    pub fmax_mhz: Option<f64>,
    /// The number of clocks for one group of photons.
    pub initiation_interval: f64,
    /// The number of photons in a group.
    pub photons_per_iteration: usize,
}

/// The rows of the fitted format, of the chosen machines where these have other formats, of the default
/// format's machine and of the paper's.
pub fn comparison(fitted: &PhotonFormat, choices: Option<&Choices>) -> Result<Vec<Compared>> {
    let paper = &MACHINES[0];
    let default = (MACHINES.iter()).find(|machine| machine.format() == Some(&PHOTON_FORMATS[0]));
    let exact = MACHINES
        .iter()
        .find(|machine| machine.format() == Some(fitted));
    let own = Machine {
        name: "fitted",
        numbers: Numbers::Local(*fitted),
        ..*exact.unwrap_or(paper)
    };
    let mut rows = vec![Compared {
        name: exact.map_or("fitted", |machine| machine.name).to_owned(),
        ..compared(&own, exact, fitted)?
    }];
    let taken = choices.map(|choices| [choices.smallest.machine, choices.fastest.machine]);
    let others = taken.into_iter().flatten().map(Some);
    let others = others.chain([default, Some(paper)]);
    for machine in others.flatten() {
        if rows.iter().all(|row| row.name != machine.name) {
            rows.push(compared(machine, Some(machine), fitted)?);
        }
    }
    Ok(rows)
}

/// The row of a machine, with the figures of `measured`.
fn compared(
    machine: &Machine,
    measured: Option<&Machine>,
    fitted: &PhotonFormat,
) -> Result<Compared> {
    let widths = Widths::of(machine);
    let figures = measured.map(Measured::of).transpose()?;
    let area = figures.as_ref().and_then(|f| f.area_without_dsp.as_ref());
    let own = Widths::of_format(fitted).bits_per_photon;
    Ok(Compared {
        name: machine.name.to_owned(),
        format: machine.format().map(PhotonFormat::name),
        bits_per_photon: machine.bits_per_photon(),
        bits_per_photon_saved: i64::from(machine.bits_per_photon()) - i64::from(own),
        radius_bits: widths.difference,
        power_bits: widths.power,
        work_bits: widths.work,
        sum_bits: widths.sum,
        lut4_equivalents: area.map(|area| area.lut4_equivalents),
        ff: area.map(|area| area.ff),
        fmax_mhz: figures.as_ref().and_then(|f| f.fmax.fmax_mhz),
        initiation_interval: machine.rate().interval(),
        photons_per_iteration: machine.photons_per_iteration(),
    })
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_photon_format;

    use super::*;

    #[test]
    fn a_format_without_a_machine_has_widths_and_no_area() {
        let format = find_photon_format("local6-rgb5-n4096").unwrap();
        let rows = comparison(&format, None).unwrap();
        let names: Vec<_> = rows.iter().map(|row| row.name.as_str()).collect();
        assert_eq!(names, ["fitted", "local", "paper"]);
        assert_eq!(
            (rows[0].bits_per_photon, rows[0].bits_per_photon_saved),
            (33, 0)
        );
        assert_eq!(rows[1].bits_per_photon_saved, 20);
        assert_eq!(rows[0].sum_bits, 17);
        assert!(rows[0].lut4_equivalents.is_none() && rows[2].lut4_equivalents.is_some());
        let rows = comparison(&PHOTON_FORMATS[0], None).unwrap();
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].name, "local");
    }
}
