//! Measured figures that are committed as data: `docs/measured/`, written by `scripts/measure.sh`.
//!
//! They are read here and nowhere typed in: `list` and the README's table show them.

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

/// What was measured of a machine; `None` where nothing was.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// Area where DSP blocks are forbidden.
    pub area_without_dsp: Option<Area>,
    /// Area where DSP blocks may be used.
    pub area_with_dsp: Option<Area>,
    /// Golden model's picture against the f64 reference's, the built-in scene.
    pub rms_relative_error: Option<f64>,
    /// Clocks in which all registers were compared, on the emitted Verilog.
    pub vectors_compared: Option<u64>,
    /// The simulators that were found equal to the golden model.
    pub verified_against: String,
}

const SYNTHESIS: &str = include_str!("../../../docs/measured/synthesis.json");

/// The summary of `photoncube run --machine M`, by machine.
const RUNS: &[(&str, &str)] = &[
    (
        "paper",
        include_str!("../../../docs/measured/run-paper.json"),
    ),
    (
        "paper-dsp",
        include_str!("../../../docs/measured/run-paper-dsp.json"),
    ),
    (
        "paper-12",
        include_str!("../../../docs/measured/run-paper-12.json"),
    ),
    (
        "paper-5d",
        include_str!("../../../docs/measured/run-paper-5d.json"),
    ),
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
            rms_relative_error: run.as_ref().map(|run| run.rms_relative_error),
            vectors_compared: run.as_ref().map(|run| run.vectors_compared),
            verified_against: run.map_or("not measured".to_owned(), |run| run.verified()),
        })
    }
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
