//! The measured figures, which are committed as data in `docs/measured/` and written by `scripts/measure.sh`.
//!
//! `list`, the README and docs/machines.md show them; no figure is typed into the source.

use anyhow::{Context, Result};
use fpga_flow::Figure;
use photoncube_spec::{MACHINES, Machine};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::digests::{self, Digests};
use crate::failure::CheckFailed;
use crate::synth::clock::{Clock, clocks};
use crate::synth::figures::{AreaRow, Figured, PlaceRow, Row};
use crate::synth::{DEFAULT_DEVICE, DEFAULT_GRADES};

/// The area on ECP5, by Yosys's `synth_ecp5`.
#[derive(Clone, Debug, Serialize)]
pub struct Area {
    /// The options of `synth_ecp5`.
    pub options: String,
    /// The number of LUTs with four inputs.
    pub lut4: u64,
    /// The number of carry cells, each two LUTs wide.
    pub ccu2c: u64,
    /// The number of LUTs and of cells in their place, counted as LUTs.
    pub lut4_equivalents: u64,
    /// The number of flip-flops.
    pub ff: u64,
    /// The number of multipliers, MULT18X18D.
    pub dsp: u64,
    /// The number of block RAMs, DP16KD.
    pub block_ram: u64,
    /// The number of RAMs of 16 x 4 in LUTs, TRELLIS_DPR16X4.
    pub lut_ram: u64,
}

/// The flows of ECP5.
const WITH_DSP: &str = "ecp5";
const WITHOUT_DSP: &str = "ecp5-nodsp";

/// The speed grade of the clocks in `list` and in the tables of the pages: the slowest.
const SPEED_GRADE: u32 = DEFAULT_GRADES[0];

/// The highest clock of the routed machine.
#[derive(Clone, Debug, Serialize)]
pub struct Fmax {
    /// The median over the seeds of placement, in MHz.
    pub fmax_mhz: Option<f64>,
    /// The FPGA in which it was routed.
    pub device: Option<String>,
    /// The speed grade of that FPGA.
    pub speed_grade: Option<u32>,
}

/// The measured figures of a machine; `None` where a figure was not measured.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// The area where DSP blocks are forbidden.
    pub area_without_dsp: Option<Area>,
    /// The area where DSP blocks may be used.
    pub area_with_dsp: Option<Area>,
    /// The clock in the slowest speed grade.
    #[serde(flatten)]
    pub fmax: Fmax,
    /// The area in every flow.
    pub areas: Vec<AreaRow>,
    /// The clock in every speed grade, with its critical path.
    pub fmax_by_grade: Vec<Clock>,
    /// The error of the golden model's picture against the f64 reference's, on `cornell` or on the scene that
    /// the machine is fitted to.
    pub rms_relative_error: Option<f64>,
    /// The number of clocks in which all registers of the emitted Verilog were compared.
    pub vectors_compared: Option<u64>,
    /// The simulators whose results equalled the golden model's.
    pub verified_against: String,
    /// The files in `docs/measured` whose figures of this machine are about other Verilog than today's. These
    /// figures are left out here.
    pub stale: Vec<String>,
}

const SYNTHESIS: &str = include_str!("../../../docs/measured/synthesis.json");
const PLACEMENT: &str = include_str!("../../../docs/measured/place.json");

macro_rules! of_machines {
    ($kind:literal: $($machine:literal),+ $(,)?) => {
        &[$((
            $machine,
            include_str!(concat!("../../../docs/measured/", $kind, "-", $machine, ".json"))
        )),+]
    };
}

/// By machine, the summary of `photoncube run --machine M`.
const RUNS: &[(&str, &str)] = of_machines![
    "run":
    "paper",
    "paper-dsp",
    "paper-12",
    "paper-5d",
    "local",
    "local-half",
    "fit-cornell",
    "fit-ring",
    "fit-range",
    "stream",
    "overlap",
    "tile-6",
];

/// By machine, the report of `photoncube verify --machine M` on a million random groups.
const VERIFICATIONS: &[(&str, &str)] = of_machines![
    "verify":
    "stream",
    "overlap",
    "tile-4",
    "tile-5",
    "tile-6",
    "tile-7",
    "tile-8",
    "tile-9",
    "tile-10",
    "chip-mixed",
    "tile-6-mixed",
    "chip-lut",
];

#[derive(Deserialize)]
struct Run {
    rms_relative_error: f64,
    #[serde(flatten)]
    proof: Proof,
}

/// The comparisons of a run or a verification.
#[derive(Deserialize)]
struct Proof {
    vectors_compared: u64,
    mismatches: u64,
    devices: Vec<Device>,
}

#[derive(Deserialize)]
struct Device {
    device: String,
    verilog_sha256: Option<String>,
    iterations: u64,
    signals_per_vector: usize,
    vectors_compared: u64,
}

impl Measured {
    /// The committed figures of that machine.
    pub fn of(machine: &Machine) -> Result<Self> {
        Self::about(machine, digests::committed()?.get(machine.name))
    }

    /// The committed figures of that machine that are about the Verilog of these digests.
    fn about(machine: &Machine, today: Option<&Digests>) -> Result<Self> {
        let mut stale = Vec::new();
        let areas = rows_about(synthesis()?, machine, today).unwrap_or_else(|| {
            stale.push("synthesis.json".to_owned());
            Vec::new()
        });
        let placed = rows_about(placement()?, machine, today).unwrap_or_else(|| {
            stale.push("place.json".to_owned());
            Vec::new()
        });
        let run: Option<Run> = of_machine("run", RUNS, machine)?;
        let random: Option<Proof> = of_machine("verify", VERIFICATIONS, machine)?;
        let mut proofs = vec![
            (
                "run",
                "groups of a scene",
                run.as_ref().map(|run| &run.proof),
            ),
            ("verify", "random groups", random.as_ref()),
        ];
        proofs.retain(|(kind, _, proof)| match proof {
            Some(proof) if !proof.is_about(today) => {
                stale.push(format!("{kind}-{}.json", machine.name));
                false
            }
            _ => true,
        });
        let proofs: Vec<_> = proofs
            .into_iter()
            .filter_map(|(_, what, proof)| Some((what, proof?)))
            .collect();
        let fmax_by_grade = clocks(&placed);
        Ok(Self {
            area_without_dsp: Area::of(&areas, WITHOUT_DSP),
            area_with_dsp: Area::of(&areas, WITH_DSP),
            fmax: Fmax::of(&fmax_by_grade),
            areas,
            fmax_by_grade,
            rms_relative_error: rms_relative_error(machine)?,
            vectors_compared: (!proofs.is_empty())
                .then(|| proofs.iter().map(|(_, proof)| proof.vectors_compared).sum()),
            verified_against: match &proofs[..] {
                [] => "not measured".to_owned(),
                some => some
                    .iter()
                    .map(|(what, proof)| proof.text(what))
                    .collect::<Vec<_>>()
                    .join("; "),
            },
            stale,
        })
    }
}

/// The rows about a machine; `None` where the rows are about other Verilog.
fn rows_about<R: Row>(
    file: Figured<R>,
    machine: &Machine,
    today: Option<&Digests>,
) -> Option<Vec<R>> {
    let digest = file.verilog_sha256.get(machine.name);
    let rows = file.rows.into_iter();
    let rows: Vec<_> = rows
        .filter(|row| row.group().machine == machine.name)
        .collect();
    let is_fresh = digest == today.map(|digests| &digests.ecp5_sha256);
    (rows.is_empty() || is_fresh).then_some(rows)
}

/// Fails where a committed figure is about other Verilog than today's, and names the files.
///
/// # Errors
/// Some committed figure is about other Verilog.
pub fn refuse_stale() -> Result<()> {
    let mut stale = Vec::new();
    for machine in MACHINES {
        let files = Measured::of(machine)?.stale.into_iter();
        stale.extend(files.map(|file| format!("{} in docs/measured/{file}", machine.name)));
    }
    if stale.is_empty() {
        return Ok(());
    }
    Err(CheckFailed(format!(
        "these figures are about other Verilog than that in hdl-out and are left out; scripts/measure.sh measures \
         them anew: {}",
        stale.join(", ")
    ))
    .into())
}

impl Measured {
    /// The clock in the fastest speed grade that was measured.
    pub fn fastest(&self) -> Option<&Clock> {
        self.fmax_by_grade
            .iter()
            .max_by_key(|clock| clock.speed_grade)
    }

    /// The clocks in the speed grades of the committed figures, in their order.
    pub fn in_default_grades(&self) -> [Option<f64>; DEFAULT_GRADES.len()] {
        DEFAULT_GRADES.map(|grade| {
            let mut clocks = self.fmax_by_grade.iter();
            let clock = clocks.find(|clock| clock.speed_grade == Some(grade));
            clock.map(|clock| clock.fmax_mhz)
        })
    }
}

impl Area {
    fn of(rows: &[AreaRow], flow: &str) -> Option<Self> {
        let row = rows.iter().find(|row| row.flow.name == flow)?;
        let figure = |figure| row.figures.get(&figure).copied();
        Some(Self {
            options: match flow {
                WITHOUT_DSP => "-nodsp".to_owned(),
                _ => String::new(),
            },
            lut4: figure(Figure::Lut4)?,
            ccu2c: figure(Figure::Ccu2c)?,
            lut4_equivalents: figure(Figure::Lut4Equivalents)?,
            ff: figure(Figure::Ff)?,
            dsp: figure(Figure::Dsp)?,
            block_ram: figure(Figure::BlockRam)?,
            lut_ram: figure(Figure::LutRam)?,
        })
    }
}

impl Fmax {
    fn of(clocks: &[Clock]) -> Self {
        let clock = clocks
            .iter()
            .find(|clock| clock.speed_grade == Some(SPEED_GRADE));
        Self {
            fmax_mhz: clock.map(|clock| clock.fmax_mhz),
            device: clock.map(|_| DEFAULT_DEVICE.to_owned()),
            speed_grade: clock.and_then(|clock| clock.speed_grade),
        }
    }
}

/// The method of the clock measurements, in one sentence.
pub fn fmax_source() -> Result<String> {
    source(&placement()?)
}

/// The number of LUTs and of cells in their place on ECP5 without DSP blocks; `None` if not measured. It may
/// be about other Verilog, because it only serves to plan work.
pub fn lut4_equivalents(machine: &str) -> Result<Option<u64>> {
    let rows = synthesis()?.rows;
    let row = rows
        .iter()
        .find(|row| row.machine == machine && row.flow.name == WITHOUT_DSP);
    Ok(row.and_then(|row| row.figures.get(&Figure::Lut4Equivalents).copied()))
}

fn synthesis() -> Result<Figured<AreaRow>> {
    serde_json::from_str(SYNTHESIS).context("docs/measured/synthesis.json")
}

fn placement() -> Result<Figured<PlaceRow>> {
    serde_json::from_str(PLACEMENT).context("docs/measured/place.json")
}

fn source(placement: &Figured<PlaceRow>) -> Result<String> {
    let tool = "nextpnr-ecp5";
    let setting = &placement.setting;
    let version = setting.tool_versions.get(tool);
    let version = version.with_context(|| format!("found no version of {tool}"))?;
    let clocks = clocks(&placement.rows);
    let seeds = || clocks.iter().map(|clock| clock.seeds);
    let [fewest, most] = [seeds().min(), seeds().max()].map(|seeds| seeds.unwrap_or(0));
    let grades = DEFAULT_GRADES.map(|grade| grade.to_string()).join(" and ");
    Ok(format!(
        "Fmax by {tool} {version}, {}, speed grades {grades}, post-route, median of {fewest} to {most} \
         seeds; tests/s in the faster grade; DSP only where the squarer is a product.",
        setting.device,
    ))
}

/// The committed data of a machine; `None` if there is none.
fn of_machine<T: DeserializeOwned>(
    kind: &str,
    files: &[(&str, &'static str)],
    machine: &Machine,
) -> Result<Option<T>> {
    let Some((name, text)) = files.iter().find(|(name, _)| *name == machine.name) else {
        return Ok(None);
    };
    let read = serde_json::from_str(text);
    read.with_context(|| format!("docs/measured/{kind}-{name}.json"))
        .map(Some)
}

/// The error of a picture by the golden model, whose integers depend only on the number format: from the
/// machine's own run, or from the run of a machine with an equal format.
fn rms_relative_error(machine: &Machine) -> Result<Option<f64>> {
    let same_numbers = MACHINES
        .iter()
        .filter(|other| other.numbers == machine.numbers);
    for machine in [machine].into_iter().chain(same_numbers) {
        if let Some(run) = of_machine::<Run>("run", RUNS, machine)? {
            return Ok(Some(run.rms_relative_error));
        }
    }
    Ok(None)
}

impl Proof {
    /// Whether every device simulated the Verilog of these digests.
    fn is_about(&self, today: Option<&Digests>) -> bool {
        let today = today.map(|digests| &digests.verilog_sha256);
        let mut devices = self.devices.iter();
        today.is_some() && devices.all(|device| device.verilog_sha256.as_ref() == today)
    }

    /// A description of the comparison: the groups, the amount, the devices and the result.
    fn text(&self, groups: &str) -> String {
        let devices: Vec<_> = self.devices.iter().map(|d| d.device.as_str()).collect();
        let iterations: u64 = self.devices.iter().map(|d| d.iterations).sum();
        let clocks: u64 = self.devices.iter().map(|d| d.vectors_compared).sum();
        let signals = self.devices.iter().map(|d| d.signals_per_vector).max();
        format!(
            "{}: {iterations} {groups}, {clocks} clocks of {} signals, {} wrong",
            devices.join(", "),
            signals.unwrap_or(0),
            self.mismatches
        )
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Pins, find_machine};

    use super::*;

    #[test]
    fn the_source_names_tool_device_and_seeds() {
        let mut placement = placement().unwrap();
        let tool = "nextpnr-ecp5".to_owned();
        placement
            .setting
            .tool_versions
            .insert(tool, "0.11.1".to_owned());
        let seeds = |grade| if grade == Some(8) { 1 } else { 2 };
        placement
            .rows
            .retain(|row| row.machine == "paper" && row.seed <= seeds(row.speed_grade));
        assert_eq!(
            source(&placement).unwrap(),
            "Fmax by nextpnr-ecp5 0.11.1, LFE5U-85F, speed grades 6 and 8, post-route, median of 1 to \
             2 seeds; tests/s in the faster grade; DSP only where the squarer is a product."
        );
        placement.setting.tool_versions.clear();
        assert!(source(&placement).is_err());
    }

    #[test]
    fn a_machine_that_was_not_placed_has_no_clock() {
        let fmax = Fmax::of(&[]);
        assert_eq!(fmax.fmax_mhz, None);
        assert_eq!(fmax.device, None);
        assert_eq!(fmax.speed_grade, None);
        assert_eq!(lut4_equivalents("pentium").unwrap(), None);
    }

    /// The number of signals is the machine's today, so that a verification of another machine is noticed.
    #[test]
    fn a_verification_is_of_a_million_groups_and_all_signals() {
        for (name, text) in VERIFICATIONS {
            let machine = MACHINES.iter().find(|machine| machine.name == *name);
            let signals = Pins::of(machine.unwrap()).observed.len();
            let proof: Proof = serde_json::from_str(text).unwrap();
            assert_eq!(proof.mismatches, 0, "{name}");
            assert!(!proof.devices.is_empty(), "{name}");
            for device in proof.devices {
                assert!(device.iterations >= 1_000_000, "{name}");
                assert_eq!(device.signals_per_vector, signals, "{name}");
            }
        }
    }

    #[test]
    fn figures_about_other_verilog_are_left_out_and_named() {
        let machine = find_machine("stream").unwrap();
        let today = &digests::committed().unwrap()["stream"];
        let fresh = Measured::about(machine, Some(today)).unwrap();
        assert_eq!(fresh.stale, [""; 0]);
        assert!(fresh.fmax.fmax_mhz.is_some() && !fresh.areas.is_empty());
        assert!(fresh.vectors_compared.is_some());
        let other = Digests {
            verilog_sha256: "00".to_owned(),
            ecp5_sha256: "00".to_owned(),
        };
        for today in [Some(&other), None] {
            let stale = Measured::about(machine, today).unwrap();
            let files = [
                "synthesis.json",
                "place.json",
                "run-stream.json",
                "verify-stream.json",
            ];
            assert_eq!(stale.stale, files);
            assert_eq!(stale.fmax.fmax_mhz, None);
            assert!(stale.areas.is_empty() && stale.area_without_dsp.is_none());
            assert_eq!(stale.vectors_compared, None);
            assert_eq!(stale.verified_against, "not measured");
        }
    }

    #[test]
    fn no_committed_figure_is_stale() {
        refuse_stale().unwrap();
    }

    #[test]
    fn the_committed_figures_are_clocks() {
        let placement = placement().unwrap();
        assert!(placement.rows.iter().all(|row| row.fmax_mhz > 0.0));
        assert!(!placement.rows.is_empty());
    }
}
