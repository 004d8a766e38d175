//! Measured figures that are committed as data: `docs/measured/`, written by `scripts/measure.sh`.
//!
//! They are read here and nowhere typed in: `list` and the README's table show them.

use std::collections::BTreeMap;

use anyhow::{Context, Result};
use photoncube_spec::Machine;
use serde::{Deserialize, Serialize};

/// Area on ECP5, by Yosys's `synth_ecp5`.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Area {
    /// The options of `synth_ecp5`.
    pub options: String,
    /// LUTs with four inputs.
    pub lut4: u64,
    /// Carry cells, each two LUTs wide.
    pub ccu2c: u64,
    /// `lut4 + 2 ccu2c`.
    pub lut4_equivalents: u64,
    /// Flip-flops.
    pub ff: u64,
    /// Multipliers, MULT18X18D.
    pub dsp: u64,
}

/// The highest clock of the routed machine.
#[derive(Clone, Debug, Serialize)]
pub struct Fmax {
    /// Median over the seeds of placement.
    pub fmax_mhz: Option<f64>,
    /// The FPGA that it was routed in.
    pub device: Option<String>,
    /// Of that FPGA.
    pub speed_grade: Option<u32>,
}

/// What was measured of a machine; `None` where nothing was.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// Area where DSP blocks are forbidden.
    pub area_without_dsp: Option<Area>,
    /// Area where DSP blocks may be used.
    pub area_with_dsp: Option<Area>,
    /// Speed where DSP blocks are forbidden.
    #[serde(flatten)]
    pub fmax: Fmax,
    /// Golden model's picture against the f64 reference's, on `cornell` or on the scene that the
    /// machine is fitted to.
    pub rms_relative_error: Option<f64>,
    /// Clocks in which all registers were compared, on the emitted Verilog.
    pub vectors_compared: Option<u64>,
    /// The simulators that were found equal to the golden model.
    pub verified_against: String,
}

const SYNTHESIS: &str = include_str!("../../../docs/measured/synthesis.json");
const PLACEMENT: &str = include_str!("../../../docs/measured/place.json");

macro_rules! runs {
    ($($machine:literal),+ $(,)?) => {
        &[$(($machine, include_str!(concat!("../../../docs/measured/run-", $machine, ".json")))),+]
    };
}

/// The summary of `photoncube run --machine M`, by machine.
const RUNS: &[(&str, &str)] = runs![
    "paper",
    "paper-dsp",
    "paper-12",
    "paper-5d",
    "local",
    "local-half",
    "fit-cornell",
    "fit-ring",
    "fit-range",
];

#[derive(Deserialize)]
struct Synthesis {
    rows: Vec<SynthesisRow>,
}

#[derive(Deserialize)]
struct SynthesisRow {
    machine: String,
    flow: String,
    #[serde(flatten)]
    area: Area,
}

/// What `scripts/yosys/place.sh` writes.
#[derive(Deserialize)]
struct Placement {
    device: String,
    speed_grade: u32,
    seeds: Vec<u32>,
    tool_versions: BTreeMap<String, String>,
    rows: Vec<PlacementRow>,
}

#[derive(Deserialize)]
struct PlacementRow {
    machine: String,
    fmax_mhz: f64,
}

#[derive(Deserialize)]
struct Run {
    rms_relative_error: f64,
    vectors_compared: u64,
    mismatches: u64,
    devices: Vec<Device>,
}

#[derive(Deserialize)]
struct Device {
    device: String,
    vectors_compared: u64,
}

impl Measured {
    /// What was measured of that machine.
    pub fn of(machine: &Machine) -> Result<Self> {
        let synthesis: Synthesis =
            serde_json::from_str(SYNTHESIS).context("docs/measured/synthesis.json")?;
        // The smallest of the mappings that were tried.
        let area = |may_use_dsp: bool| {
            let rows = synthesis.rows.iter().filter(|row| {
                let forbids_dsp = row.area.options.split_whitespace().any(|o| o == "-nodsp");
                let is_ours = row.machine == machine.name && row.flow == "synth_ecp5";
                is_ours && forbids_dsp != may_use_dsp
            });
            let smallest = rows.min_by_key(|row| row.area.lut4_equivalents);
            smallest.map(|row| row.area.clone())
        };
        let run = run(machine)?;
        Ok(Self {
            area_without_dsp: area(false),
            area_with_dsp: area(true),
            fmax: placement()?.fmax(machine.name),
            rms_relative_error: run.as_ref().map(|run| run.rms_relative_error),
            vectors_compared: run.as_ref().map(|run| run.vectors_compared),
            verified_against: run.map_or("not measured".to_owned(), |run| run.verified()),
        })
    }
}

/// How the clocks were measured, in one sentence.
pub fn fmax_source() -> Result<String> {
    placement()?.source()
}

fn placement() -> Result<Placement> {
    serde_json::from_str(PLACEMENT).context("docs/measured/place.json")
}

impl Placement {
    fn fmax(&self, machine: &str) -> Fmax {
        let rows = self.rows.iter().filter(|row| row.machine == machine);
        let fmax_mhz = median(rows.map(|row| row.fmax_mhz).collect());
        Fmax {
            fmax_mhz,
            device: fmax_mhz.map(|_| self.device.clone()),
            speed_grade: fmax_mhz.map(|_| self.speed_grade),
        }
    }

    fn source(&self) -> Result<String> {
        let tool = "nextpnr-ecp5";
        let version = self.tool_versions.get(tool);
        let version = version.with_context(|| format!("found no version of {tool}"))?;
        Ok(format!(
            "Fmax by {tool} {version}, {}, speed grade {}, no DSP, post-route, median of {} seeds.",
            self.device,
            self.speed_grade,
            self.seeds.len()
        ))
    }
}

/// Of an even number of values, the mean of the two in the middle; of none, nothing.
fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let (&low, &high) = (
        values.get(values.len().checked_sub(1)? / 2)?,
        values.get(values.len() / 2)?,
    );
    Some(f64::midpoint(low, high))
}

fn run(machine: &Machine) -> Result<Option<Run>> {
    let Some((name, text)) = RUNS.iter().find(|(name, _)| *name == machine.name) else {
        return Ok(None);
    };
    let run = serde_json::from_str(text);
    run.with_context(|| format!("docs/measured/run-{name}.json"))
        .map(Some)
}

impl Run {
    fn verified(&self) -> String {
        let devices: Vec<_> = self.devices.iter().map(|d| d.device.as_str()).collect();
        let clocks: u64 = self.devices.iter().map(|d| d.vectors_compared).sum();
        format!(
            "{}: {clocks} clocks, {} mismatches",
            devices.join(", "),
            self.mismatches
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO_MACHINES: &str = r#"{
        "command": "scripts/yosys/place.sh --seeds 3",
        "device": "LFE5U-85F",
        "package": "CABGA756",
        "speed_grade": 6,
        "seeds": [1, 2, 3],
        "tool_versions": {"nextpnr-ecp5": "0.11.1", "yosys": "0.70"},
        "verilog_sha256": {"one": "00", "two": "01"},
        "rows": [
            {"machine": "one", "seed": 1, "fmax_mhz": 90.5},
            {"machine": "one", "seed": 2, "fmax_mhz": 70.25},
            {"machine": "one", "seed": 3, "fmax_mhz": 80.0},
            {"machine": "two", "seed": 1, "fmax_mhz": 50.0}
        ]
    }"#;

    fn two_machines() -> Placement {
        serde_json::from_str(TWO_MACHINES).unwrap()
    }

    #[test]
    fn the_clock_is_the_median_over_the_seeds_of_that_machine() {
        let fmax = two_machines().fmax("one");
        assert_eq!(fmax.fmax_mhz, Some(80.0));
        assert_eq!(fmax.device.as_deref(), Some("LFE5U-85F"));
        assert_eq!(fmax.speed_grade, Some(6));
        assert_eq!(two_machines().fmax("two").fmax_mhz, Some(50.0));
    }

    #[test]
    fn a_machine_that_was_not_placed_has_no_clock() {
        let fmax = two_machines().fmax("three");
        assert_eq!(fmax.fmax_mhz, None);
        assert_eq!(fmax.device, None);
        assert_eq!(fmax.speed_grade, None);
    }

    #[test]
    fn the_source_names_tool_device_and_seeds() {
        let source = two_machines().source().unwrap();
        assert_eq!(
            source,
            "Fmax by nextpnr-ecp5 0.11.1, LFE5U-85F, speed grade 6, no DSP, post-route, median of 3 seeds."
        );
        let mut unnamed = two_machines();
        unnamed.tool_versions.remove("nextpnr-ecp5");
        assert!(unnamed.source().is_err());
    }

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median(vec![]), None);
        assert_eq!(median(vec![3.0]), Some(3.0));
        assert_eq!(median(vec![4.0, 1.0]), Some(2.5));
        assert_eq!(median(vec![9.0, 1.0, 2.0]), Some(2.0));
    }

    #[test]
    fn the_committed_figures_are_clocks() {
        let placement = placement().unwrap();
        assert!(placement.rows.iter().all(|row| row.fmax_mhz > 0.0));
        assert!(!placement.rows.is_empty());
    }
}
