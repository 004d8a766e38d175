//! Chooses the chains of a core for a scene: how many, of how many engines, by a forecast and by measured areas.
//!
//! Chains of few engines test fewer photons in vain, but each needs a memory of leaves and a culler of its own. So what a device
//! holds decides: for each number of engines, as many chains as fit, and of these cores the one with the most queries a clock.

use anyhow::{Context, Result};
use photoncube_driver::Forecast;
use photoncube_render::{Fit, Measurement, PhotonMap, QuantisedMap, QueryPoint};
use photoncube_spec::{
    Core, CustomOrganisation, Numbers, PhotonFormat, Radius, custom_machine, find_machine,
};
use serde::{Deserialize, Serialize};

use crate::synth::figures::AreaRow;
use crate::synth::measurements::Measurements;
use crate::table;

/// The areas of chains of one format on an ECP5, as `photoncube synth --flow ecp5 --json` prints them; scripts/measure.sh
/// writes the file.
const MEASURED: &str = include_str!("../../../docs/measured/chains.json");

/// The cells of an LFE5U-85F (Lattice FPGA-DS-02012, table 1.1; the LUTs and flip-flops are those that nextpnr finds).
pub const DEVICE: Area = Area {
    lut4_equivalents: 83_640,
    ff: 83_640,
    dsp: 156,
    block_ram: 208,
};
/// The part of the LUTs that the chains may take. The rest is for the modules around them, and for the carry cells that place
/// and route adds where a carry begins or ends, a tenth of a chain.
const USABLE: f64 = 0.8;
/// The most photons that a bank holds in the cores that are compared, as in the measured chains. Larger sets become several.
const BANK_PHOTONS: u64 = 4096;
/// The bits of a photon's place in a block for which squares are made from digits, in the order in which they are tried.
const DIGIT_BITS: [u32; 2] = [7, 8];

/// What chains take of a device.
#[derive(Copy, Clone, Debug, Deserialize)]
pub struct Area {
    /// LUTs, or cells in their place.
    pub lut4_equivalents: u64,
    /// Flip-flops.
    pub ff: u64,
    /// DSP blocks.
    pub dsp: u64,
    /// Block RAMs.
    pub block_ram: u64,
}

impl Area {
    /// The number of such chains that the device holds, and what there is no more of.
    fn fitting(&self) -> (u32, &'static str) {
        let luts = (DEVICE.lut4_equivalents as f64 * USABLE) as u64;
        let by_cell = [
            (luts, self.lut4_equivalents, "LUTs"),
            (DEVICE.ff, self.ff, "flip-flops"),
            (DEVICE.dsp, self.dsp, "DSP blocks"),
            (DEVICE.block_ram, self.block_ram, "block RAMs"),
        ];
        let fitting = by_cell
            .into_iter()
            .filter(|(_, each, _)| *each > 0)
            .map(|(all, each, cell)| ((all / each) as u32, cell));
        let most = (Core::MOST_CHAINS, "chains of a core");
        fitting
            .chain([most])
            .min_by_key(|(chains, _)| *chains)
            .unwrap_or(most)
    }
}

#[derive(Deserialize)]
struct MeasuredChains {
    areas: Vec<MeasuredChain>,
}

#[derive(Deserialize)]
struct MeasuredChain {
    machine: String,
    #[serde(flatten)]
    area: Area,
}

/// The measured areas of chains, a row for each machine and flow.
///
/// # Errors
/// The committed file cannot be read.
pub fn measured_areas() -> Result<Vec<AreaRow>> {
    let read: Measurements = serde_json::from_str(MEASURED).context("docs/measured/chains.json")?;
    Ok(read.areas)
}

/// A core that the device holds.
#[derive(Clone, Debug, Serialize)]
pub struct ChainsRow {
    /// The leaf machine of each chain.
    pub machine: &'static str,
    /// Engines of a chain.
    pub chain_engines: u64,
    /// Chains of the core.
    pub chains: u32,
    /// What limits the chains: cells of the device, or the most chains of a core.
    pub limited_by: &'static str,
    /// LUT4 equivalents of all chains, by the measured chain.
    pub lut4_equivalents: u64,
    /// The forecast of the queries of a clock.
    pub queries_per_clock: f64,
}

/// The cores for a scene.
#[derive(Clone, Debug, Serialize)]
pub struct ChainsChoice {
    /// The name of the core with the most queries a clock.
    pub core: String,
    /// The format of its photons: the needed one with as many bits of place as squares from digits take.
    pub format: String,
    /// The error of that format.
    pub measurement: Measurement,
    /// Queries of the picture.
    pub query_points: usize,
    /// The cores that were compared, by the engines of a chain.
    pub compared: Vec<ChainsRow>,
}

/// Chooses the chains for a picture's queries on the photons of a map. The error of the core's format is measured by the fit, and
/// may be `noise_ratio`. `None` where no leaf machine has a format within that bound.
pub fn choose(
    fit: &Fit,
    noise_ratio: f64,
    map: &PhotonMap,
    queries: &[QueryPoint],
) -> Result<Option<ChainsChoice>> {
    let Some(needed) = &fit.chosen else {
        return Ok(None);
    };
    let measured: MeasuredChains =
        serde_json::from_str(MEASURED).context("docs/measured/chains.json")?;
    let Some((format, measurement)) = format(fit, &needed.format, noise_ratio)? else {
        return Ok(None);
    };
    let map = QuantisedMap::new(map, &Numbers::Local(format))?;
    let row = |chain: &MeasuredChain| -> Result<Option<ChainsRow>> {
        let dimension = find_machine(&chain.machine)?.dimension;
        let Ok(machine) = custom_machine(
            CustomOrganisation::Leaf {
                dimension,
                radius: Radius::Format,
            },
            &format,
        ) else {
            return Ok(None);
        };
        let (chains, limited_by) = chain.area.fitting();
        let Ok(core) = Core::new(machine, chains) else {
            return Ok(None);
        };
        let forecast = Forecast::of(&core, &map, queries);
        Ok(Some(ChainsRow {
            machine: machine.name,
            chain_engines: core.engines() as u64,
            chains,
            limited_by,
            lut4_equivalents: chain.area.lut4_equivalents * u64::from(chains),
            queries_per_clock: forecast.queries_per_clock(),
        }))
    };
    let rows: Result<Vec<_>> = measured.areas.iter().map(row).collect();
    let rows: Vec<_> = rows?.into_iter().flatten().collect();
    let fastest = rows
        .iter()
        .max_by(|a, b| a.queries_per_clock.total_cmp(&b.queries_per_clock));
    Ok(fastest.map(|fastest| ChainsChoice {
        core: format!("core-{}-{}", fastest.chains, fastest.machine),
        format: format.name(),
        query_points: queries.len(),
        measurement,
        compared: rows.clone(),
    }))
}

/// The first format whose squares are made from digits, as those of the measured chains are, and whose error is within the bound.
fn format(
    fit: &Fit,
    needed: &PhotonFormat,
    noise_ratio: f64,
) -> Result<Option<(PhotonFormat, Measurement)>> {
    let wider = DIGIT_BITS.map(|position_bits| PhotonFormat {
        position_bits,
        query_extra_bits: 0,
        ..*needed
    });
    let of_bank = |format: PhotonFormat| PhotonFormat {
        max_photons: format.max_photons.min(BANK_PHOTONS),
        ..format
    };
    for format in wider {
        let measurement = fit.measure(&format)?;
        if measurement.error_over_noise <= noise_ratio {
            return Ok(Some((of_bank(format), measurement)));
        }
    }
    Ok(None)
}

impl ChainsChoice {
    /// The choice in words, with the table of what was compared.
    pub fn text(&self) -> String {
        let header = [
            "machine of a chain",
            "chains",
            "limited by",
            "LUT4 equivalents",
            "queries a clock",
        ];
        let row = |row: &ChainsRow| {
            vec![
                row.machine.to_owned(),
                row.chains.to_string(),
                row.limited_by.to_owned(),
                table::grouped(row.lut4_equivalents),
                format!("{:.4}", row.queries_per_clock),
            ]
        };
        let rows: Vec<_> = self.compared.iter().map(row).collect();
        format!(
            "\nCores that fit an LFE5U-85F by the area of their chains alone, with a forecast for a picture of {} queries:\n{}\
             the most queries a clock, by area alone: {} (error / noise {:.4})\n\
             docs/cores.md has the cores that were placed and routed. A core takes a query of more photons in several sets, whose sums the driver adds.\n",
            table::grouped(self.query_points as u64),
            table::markdown(&header, &rows),
            self.core,
            self.measurement.error_over_noise
        )
    }
}

#[cfg(test)]
mod tests {
    use photoncube_hdl::{Level, emit};

    use super::*;

    fn measured() -> Vec<MeasuredChain> {
        serde_json::from_str::<MeasuredChains>(MEASURED)
            .unwrap()
            .areas
    }

    #[test]
    fn the_device_holds_fewer_chains_the_more_engines_they_have() {
        let fitting: Vec<_> = measured()
            .iter()
            .map(|chain| chain.area.fitting().0)
            .collect();
        assert!(
            fitting.is_sorted_by(|fewer, more| fewer >= more),
            "{fitting:?}"
        );
        let engines = |name: &str| find_machine(name).unwrap().leaf().unwrap().chain.engines();
        let engines: Vec<_> = measured()
            .iter()
            .map(|chain| engines(&chain.machine))
            .collect();
        assert_eq!(engines, [1, 2, 4, 8, 16, 32]);
    }

    /// An area of another text would choose the wrong core. One generator writes all chains, so one tells for all:
    /// to build the generators of six takes a minute and more. `scripts/measure.sh` measures the areas anew.
    #[test]
    fn the_measured_chains_are_those_that_are_emitted() {
        const CHAIN: &str = "leaf-7-local7-rgb6d-n4096";
        let measured: Measurements = serde_json::from_str(MEASURED).unwrap();
        let text = measured.machines.iter().find(|text| text.machine == CHAIN);
        let emitted = emit(find_machine(CHAIN).unwrap(), Level::Machine).unwrap();
        assert_eq!(
            emitted.ecp5_sha256(),
            text.unwrap().verilog_sha256,
            "docs/measured/chains.json has the areas of other texts"
        );
    }

    /// Each cell is the one that binds in some area.
    #[test]
    fn the_cell_that_is_used_up_first_decides() {
        let none = Area {
            lut4_equivalents: 0,
            ff: 0,
            dsp: 0,
            block_ram: 0,
        };
        assert_eq!(none.fitting(), (Core::MOST_CHAINS, "chains of a core"));
        let luts = (DEVICE.lut4_equivalents as f64 * USABLE) as u64;
        let areas = [
            (
                "LUTs",
                Area {
                    lut4_equivalents: luts / 3,
                    ..none
                },
            ),
            (
                "flip-flops",
                Area {
                    ff: DEVICE.ff / 3,
                    ..none
                },
            ),
            (
                "DSP blocks",
                Area {
                    dsp: DEVICE.dsp / 3,
                    ..none
                },
            ),
            (
                "block RAMs",
                Area {
                    block_ram: DEVICE.block_ram / 3,
                    ..none
                },
            ),
        ];
        for (cell, area) in areas {
            assert_eq!(area.fitting(), (3, cell), "{area:?}");
        }
    }
}
