//! Measures machines in standard cells: area, clock, and energy of a photon test.

mod simulated;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::thread::available_parallelism;

use anyhow::{Context, Result, anyhow};
use fpga_flow::asic::{
    CellFigures, Library, NETLIST, Options, Sta, measure, measure_simulated, simulatable,
};
use fpga_flow::{FlowError, ToolError, Tools, Yosys};
use photoncube_spec::{MACHINES, Machine, find_machine};
use photoncube_testbench::Tool;
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use self::simulated::{Simulated, Workload};
use super::{Subject, is_stale, tables};
use crate::args::SynthArgs;
use crate::{files, output, progress, synth, table};

/// The library of Debian's package `qflow-tech-osu018`: 0.18 um, typical corner, 1.8 V.
pub const LIBERTY: &str = "/usr/share/qflow/tech/osu018/osu018_stdcells.lib";
/// The transitions of a net in a clock cycle where nothing is known about it: one in five cycles changes it.
pub const ACTIVITY: f64 = 0.2;
/// The command that installs OpenSTA and the library.
const INSTALL: &str = "photoncube setup --asic";

/// A machine in standard cells.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AsicRow {
    machine: String,
    verilog_sha256: String,
    /// The area of all cells in square micrometres.
    area_um2: f64,
    /// The area in thousands of NANDs with two inputs.
    kilo_gate_equivalents: f64,
    /// The share of the registers in the area.
    register_area_share: f64,
    standard_cells: u64,
    fanout_buffers: u64,
    #[serde(default, skip_serializing_if = "is_zero")]
    clock_gates: u64,
    /// The bits of the memories that are no registers, but stay outside of the cells, as RAMs.
    #[serde(default, skip_serializing_if = "is_zero")]
    ram_bits: u64,
    fmax_mhz: f64,
    power_mw: f64,
    photon_tests_per_clock: f64,
    /// The energy of a photon test where each clock has its tests, in picojoules.
    energy_pj_per_test: f64,
    /// The share of the registers in the energy.
    register_energy_share: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    simulated: Option<Simulated>,
}

#[derive(Serialize, Deserialize)]
struct Report {
    library: String,
    library_sha256: String,
    activity: f64,
    #[serde(default, skip_serializing_if = "is_false")]
    clock_gating: bool,
    tool_versions: BTreeMap<String, String>,
    machines: Vec<AsicRow>,
}

fn is_zero(count: &u64) -> bool {
    *count == 0
}

fn is_false(flag: &bool) -> bool {
    !flag
}

impl AsicRow {
    fn of(subject: &Subject, figures: &CellFigures) -> Self {
        let tests = subject.machine.photon_tests_per_clock();
        Self {
            machine: subject.name.clone(),
            verilog_sha256: subject.verilog_sha256.clone(),
            area_um2: figures.area,
            kilo_gate_equivalents: figures.gate_equivalents / 1e3,
            register_area_share: figures.register_area / figures.area,
            standard_cells: figures.cells,
            fanout_buffers: figures.fanout_buffers,
            clock_gates: figures.clock_gates,
            ram_bits: figures.ram_bits,
            fmax_mhz: figures.fmax_mhz(),
            power_mw: 1e3 * figures.power_w(),
            photon_tests_per_clock: tests,
            energy_pj_per_test: figures.cycle_energy_pj() / tests,
            register_energy_share: figures.register_energy_pj / figures.cycle_energy_pj(),
            simulated: None,
        }
    }
}

/// Measures the machines and prints a table.
pub fn execute(args: &SynthArgs, machines: &[&'static Machine], json: bool) -> Result<()> {
    let tools = synth::tools(args.tools.as_deref(), None)?;
    let scratch = tempfile::tempdir().context("cannot make a scratch folder")?;
    let sta = Sta::find(scratch.path()).map_err(|error| match error {
        FlowError::Tool(ToolError::Missing { .. }) => anyhow!("{error}; `{INSTALL}` installs it"),
        error => error.into(),
    })?;
    let library = library(&tools, scratch.path(), &args.liberty)?;
    let mut tool_versions = tools.versions(scratch.path())?;
    tool_versions.insert("opensta".to_owned(), Sta::VERSION.to_owned());
    let flow = CellFlow {
        yosys: tools.yosys(),
        sta,
        library,
        options: Options {
            activity: args.activity,
            clock_gating: args.clock_gating,
        },
        workload: args.activity_of.as_ref().map(Workload::of).transpose()?,
    };
    if flow.workload.is_some() {
        tool_versions.insert("icarus".to_owned(), Tool::Iverilog.version()?);
    }
    let report = Report {
        library: flow.library.name().to_owned(),
        library_sha256: flow.library.sha256(),
        activity: args.activity,
        clock_gating: args.clock_gating,
        tool_versions,
        machines: rows(args, machines, |subject| {
            let folder = scratch.path().join(&subject.name);
            fs::create_dir(&folder)?;
            let row = flow.row(subject, &folder);
            let row = row.with_context(|| format!("machine {}", subject.name))?;
            if let Some(netlists) = &args.netlists {
                let netlist = fs::read(folder.join(NETLIST))?;
                files::write(&netlists.join(format!("{}.v", subject.name)), &netlist)?;
            }
            // A netlist of hundreds of engines takes hundreds of MB.
            fs::remove_dir_all(&folder)?;
            Ok(row)
        })?,
    };
    output::print_tables(json, args.wide, &report, || text(&report))
}

/// How machines are measured.
struct CellFlow<'a> {
    yosys: &'a Yosys,
    sta: Sta,
    library: Library,
    options: Options,
    /// Where the netlists are simulated, on what.
    workload: Option<Workload>,
}

impl CellFlow<'_> {
    fn row(&self, subject: &Subject, folder: &Path) -> Result<AsicRow> {
        let Self {
            yosys,
            sta,
            library,
            ..
        } = self;
        let design = &subject.design;
        design.write(folder)?;
        let figures = measure(yosys, sta, folder, design, library, &self.options)?;
        let simulated = self.workload.as_ref().map(|workload| {
            let netlist = simulatable(yosys, folder, design, library)?;
            let simulation = workload.simulate(subject, &netlist)?;
            let (measured, activities) = ((design, &figures), &simulation.activities);
            let energy = measure_simulated(yosys, sta, folder, measured, library, activities)?;
            Ok(Simulated::of(workload, &netlist, &simulation, &energy))
        });
        let simulated: Result<_> = simulated.transpose();
        Ok(AsicRow {
            simulated: simulated?,
            ..AsicRow::of(subject, &figures)
        })
    }
}

fn library(tools: &Tools, scratch: &Path, liberty: &Path) -> Result<Library> {
    if liberty == Path::new(LIBERTY) && !liberty.exists() {
        return Err(anyhow!(
            "found no {LIBERTY}; `{INSTALL}` installs it, --liberty names another library"
        ));
    }
    Ok(Library::read(tools.yosys(), scratch, liberty)?)
}

/// The rows of the machines, several at a time.
fn rows(
    args: &SynthArgs,
    machines: &[&'static Machine],
    row: impl Fn(&Subject) -> Result<AsicRow> + Sync,
) -> Result<Vec<AsicRow>> {
    let bar = progress::bar("standard cells", machines.len() as u64);
    let cores = || available_parallelism().map_or(1, usize::from);
    let jobs = args.jobs.map_or_else(cores, usize::from);
    let pool = ThreadPoolBuilder::new().num_threads(jobs).build()?;
    let rows = pool.install(|| {
        let rows = machines.par_iter().map(|machine| {
            let row = row(&Subject::of(machine)?)?;
            bar.inc(1);
            Ok(row)
        });
        rows.collect()
    });
    bar.finish_and_clear();
    rows
}

/// The files of recorded measurements: `asic-LIBRARY.json`, each what `synth --asic --json` printed.
const PREFIX: &str = "asic-";

/// What is recorded in a folder, in files PREFIX*.json.
pub fn recorded<T: DeserializeOwned>(folder: &Path, prefix: &str) -> Result<Vec<(String, T)>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().and_then(|name| name.to_str());
        let Some(name) = name.filter(|name| name.starts_with(prefix) && name.ends_with(".json"))
        else {
            continue;
        };
        let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        let report = serde_json::from_str(&text).with_context(|| path.display().to_string())?;
        files.push((name.to_owned(), report));
    }
    files.sort_by(|a, b| a.0.cmp(&b.0));
    Ok(files)
}

/// The recorded rows in a folder that are of other Verilog than the subjects'; with `all`, also than that of a custom machine, which is among
/// no subjects.
pub fn faults(folder: &Path, subjects: &[Subject], all: bool) -> Result<Vec<String>> {
    let mut faults = Vec::new();
    for (file, report) in recorded::<Report>(folder, PREFIX)? {
        let rows = report.machines.iter();
        let custom = rows
            .clone()
            .filter(|row| all && MACHINES.iter().all(|named| named.name != row.machine));
        let custom: Vec<_> = custom
            .map(|row| Subject::of(find_machine(&row.machine)?))
            .collect::<Result<_>>()?;
        let of_rows = |subjects| {
            rows.clone()
                .filter(move |row| is_stale(subjects, &row.machine, &row.verilog_sha256))
        };
        faults.extend(
            of_rows(subjects)
                .chain(of_rows(&custom))
                .map(|row| format!("{file}: {} was measured with other Verilog", row.machine)),
        );
    }
    Ok(faults)
}

fn text(report: &Report) -> String {
    let mut text = format!(
        "Standard cells of {}{}, {} transitions of a net in a clock cycle, no wires, no clock tree:\n{}\n",
        report.library,
        if report.clock_gating {
            " with clock gates"
        } else {
            ""
        },
        report.activity,
        rows_table(&report.machines),
    );
    if report.machines.iter().any(|row| row.simulated.is_some()) {
        text += &format!(
            "Simulated on photons of a scene, each net with its own transitions:\n{}\n",
            simulated::table(&report.machines)
        );
    }
    text + &tables::measured_by(&report.tool_versions) + "\n"
}

fn rows_table(rows: &[AsicRow]) -> String {
    let header = [
        "machine",
        "kGE",
        "um2",
        "MHz",
        "mW",
        "pJ a test",
        "area in registers",
        "energy in registers",
        "RAM, kbit",
    ];
    let cells = |row: &AsicRow| {
        vec![
            row.machine.clone(),
            format!("{:.1}", row.kilo_gate_equivalents),
            table::grouped(row.area_um2.round() as u64),
            format!("{:.0}", row.fmax_mhz),
            format!("{:.1}", row.power_mw),
            format!("{:.1}", row.energy_pj_per_test),
            format!("{:.0} %", 100.0 * row.register_area_share),
            format!("{:.0} %", 100.0 * row.register_energy_share),
            match row.ram_bits {
                0 => "-".to_owned(),
                bits => (bits / 1024).to_string(),
            },
        ]
    };
    table::markdown(&header, &rows.iter().map(cells).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests;
