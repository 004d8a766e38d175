//! The command `synth`: area and clock of the machines, by Yosys and nextpnr.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result, bail};
use fpga_flow::{Flow, Tools};
use photoncube_spec::{Core, MACHINES, Machine, find_machine};
use rayon::prelude::*;
use serde::Serialize;

use crate::args::SynthArgs;
use crate::failure::CheckFailed;
use crate::shards::{Header, Ledger, Settings, Shard};
use crate::synth::clock::{Clock, clocks};
use crate::synth::figures::{self, AreaRow, COMMAND, PlaceRow, Row};
use crate::synth::plan::{DeviceUse, Measured, Plan};
use crate::synth::writer::Writers;
use crate::synth::{self, DEFAULT_DEVICE, Subject, TARGET_MHZ, asic, layout, tables};
use crate::{output, progress};

#[derive(Serialize)]
struct Report {
    machines: Vec<VerilogRow>,
    device: &'static str,
    package: &'static str,
    target_mhz: u32,
    abc9_target_ps: u32,
    tool_versions: BTreeMap<String, String>,
    scripts: Vec<ScriptRow>,
    areas: Vec<AreaRow>,
    placements: Vec<PlaceRow>,
    fmax_by_grade: Vec<Clock>,
    device_use: Vec<DeviceUse>,
    files: Vec<String>,
}

/// The digest of the Verilog of a machine that was measured.
#[derive(Serialize)]
struct VerilogRow {
    machine: String,
    verilog_sha256: String,
}

/// The script of a flow.
#[derive(Serialize)]
struct ScriptRow {
    flow: &'static Flow,
    script: String,
}

#[derive(Serialize)]
struct CheckReport {
    machines: Vec<&'static str>,
    out: String,
    checked: bool,
    stale: Vec<String>,
    not_mapped: Vec<&'static str>,
    not_placed: Vec<&'static str>,
}

/// Measures the machines, or checks the recorded figures.
pub fn execute(args: &SynthArgs, json: bool) -> Result<()> {
    let machines = machines(&args.machines)?;
    // Impossible requests are reported before the machines are emitted, which takes seconds.
    if args.check {
        if !args.out.is_dir() {
            bail!("{} is no folder: nothing to check", args.out.display());
        }
        return check(args, &subjects(&machines)?, json);
    }
    if args.asic {
        return asic::execute(args, &machines, json);
    }
    args.grades
        .iter()
        .try_for_each(|&grade| args.device.check_grade(grade))?;
    if args.endpoints && !args.places() {
        bail!(
            "--endpoints: it lists paths of a placed machine, and no --flow names the placement; add `--flow place`"
        );
    }
    if args.writes() && args.device.name != DEFAULT_DEVICE {
        bail!(
            "{} is for {}; `{COMMAND} --device {}` prints, if a machine, flow or grade is named and \
             --update is not",
            PlaceRow::FILE,
            DEFAULT_DEVICE,
            args.device.name
        );
    }
    let core = match (args.chains, &machines[..]) {
        (None, _) => None,
        (Some(chains), &[machine]) => Some(Core::new(machine, chains)?),
        (Some(_), several) => bail!("--chains: found {} machines, expected one", several.len()),
    };
    let places_in = args.places().then(|| args.device.family());
    let tools = synth::tools(args.tools.as_deref(), places_in)?;
    let subjects = match core {
        None => subjects(&machines)?,
        Some(core) => vec![Subject::of_core(&core)?],
    };
    measure(args, &tools, subjects, json)
}

fn subjects(machines: &[&'static Machine]) -> Result<Vec<Subject>> {
    machines
        .par_iter()
        .map(|machine| Subject::of(machine))
        .collect()
}

/// The machines of these names, or all; each once.
fn machines(names: &[String]) -> Result<Vec<&'static Machine>> {
    if names.is_empty() {
        return Ok(MACHINES.iter().collect());
    }
    let mut machines: Vec<&Machine> = Vec::new();
    for name in names {
        let machine = find_machine(name)?;
        if machines.iter().all(|other| other.name != machine.name) {
            machines.push(machine);
        }
    }
    Ok(machines)
}

/// Compares the recorded figures with the subjects, which are all machines where `args` names none.
fn checked(args: &SynthArgs, subjects: &[Subject]) -> Result<CheckReport> {
    let all = args.machines.is_empty();
    let mut stale = figures::faults(&args.out, subjects, all)?;
    stale.extend(asic::faults(&args.out, subjects, all)?);
    stale.extend(layout::faults(&args.out, subjects)?);
    Ok(CheckReport {
        machines: subjects
            .iter()
            .map(|subject| subject.machine.name)
            .collect(),
        out: args.out.display().to_string(),
        checked: true,
        stale,
        not_mapped: figures::without::<figures::AreaRow>(&args.out, subjects)?,
        not_placed: figures::without::<PlaceRow>(&args.out, subjects)?,
    })
}

fn check(args: &SynthArgs, subjects: &[Subject], json: bool) -> Result<()> {
    let report = checked(args, subjects)?;
    output::print_tables(json, args.wide, &report, || {
        format!(
            "checked the figures of {} machines in {}: {} stale\n\
             without an area: {}\nwithout a clock: {}\n",
            report.machines.len(),
            report.out,
            report.stale.len(),
            named(&report.not_mapped),
            named(&report.not_placed),
        )
    })?;
    if report.stale.is_empty() {
        return Ok(());
    }
    Err(CheckFailed(format!(
        "the figures in {} are not of these machines: {}; `{COMMAND} --update --machine M` measures a \
         machine anew",
        report.out,
        report.stale.join("; ")
    ))
    .into())
}

fn named(machines: &[&str]) -> String {
    match machines {
        [] => "none".to_owned(),
        names => names.join(", "),
    }
}

fn measure(args: &SynthArgs, tools: &Tools, subjects: Vec<Subject>, json: bool) -> Result<()> {
    let plan = Plan::new(args, subjects);
    // The tools run in a sandbox that sees the current folder and below, so each machine has its own folder.
    let scratch = tempfile::tempdir().context("cannot make a scratch folder")?;
    let tool_versions = tools.versions(scratch.path())?;
    // The writers are made before the long work, so that work whose result cannot be written is not begun.
    let writers = Writers::new(args, &plan, &tool_versions)?;
    let found = results(args, &plan, tools, scratch.path(), &writers, &tool_versions)?;
    let (mut areas, mut placements, mut device_use) = (Vec::new(), Vec::new(), Vec::new());
    for measured in found {
        match measured {
            Measured::Area(row) => areas.push(row),
            Measured::Placed(row, used) => {
                placements.push(*row);
                device_use.push(used);
            }
            Measured::TooLarge(used) => device_use.push(used),
        }
    }
    // A machine needs as much in every speed grade and with every seed.
    device_use.dedup_by(|used, other| used.machine == other.machine);
    let report = Report {
        machines: verilog_rows(&plan),
        device: plan.device.name,
        package: plan.device.package,
        target_mhz: TARGET_MHZ,
        abc9_target_ps: args.map_for,
        tool_versions,
        scripts: script_rows(&plan, args.map_for),
        fmax_by_grade: clocks(&placements),
        areas,
        placements,
        device_use,
        files: writers.paths(),
    };
    output::print_tables(json, args.wide, &report, || text(&report))?;
    conclusion(&report)
}

/// The measurements of the shard: those of its state, and those that are made now.
fn results(
    args: &SynthArgs,
    plan: &Plan,
    tools: &Tools,
    scratch: &Path,
    writers: &Writers,
    tool_versions: &BTreeMap<String, String>,
) -> Result<Vec<Measured>> {
    let jobs = plan.measurements();
    let shard = args.shard.shard.unwrap_or(Shard::WHOLE);
    let settings = settings(args, plan, tool_versions);
    let header = Header::new("synth", settings, Some(jobs.len() as u64), shard);
    let ledger = Ledger::open(args.shard.state.as_deref(), header)?;
    for (&number, measured) in ledger.done() {
        writers.take(&jobs[number as usize], measured)?;
    }
    let to_do: Vec<_> = ledger.to_do().iter().map(|&n| jobs[n as usize]).collect();
    plan.announce(&to_do);
    plan.write_verilog(scratch)?;
    plan.map(tools, scratch, &to_do)?;
    let bar = progress::bar("measurements", 0);
    let found = ledger.work(
        plan.jobs,
        &bar,
        |&number| number,
        |number| {
            let job = &jobs[number as usize];
            let measured = plan.measure(tools, scratch, job)?;
            writers.take(job, &measured)?;
            Ok(measured)
        },
    )?;
    Ok(found.into_values().collect())
}

/// What other workers must have in common.
fn settings(args: &SynthArgs, plan: &Plan, tool_versions: &BTreeMap<String, String>) -> Settings {
    let digests = plan.subjects.iter();
    let digests = digests.map(|of| format!("{} {}", of.name, of.verilog_sha256));
    let flows = plan.flows.iter().map(ToString::to_string);
    let tries = plan.tries();
    let tries = tries
        .iter()
        .map(|what| format!("{:?} {}", what.speed_grade, what.seed));
    let own = [
        (
            "machines, their SHA-256",
            digests.collect::<Vec<_>>().join(", "),
        ),
        ("--flow", flows.collect::<Vec<_>>().join(", ")),
        ("--device", plan.device.name.to_owned()),
        ("--grade and --seeds", tries.collect::<Vec<_>>().join(", ")),
        ("--map-for", args.map_for.to_string()),
        ("--placer", args.placer.name().to_owned()),
        ("--router", args.router.name().to_owned()),
    ];
    let own = own.map(|(name, value)| (name.to_owned(), value));
    let tools = tool_versions.clone().into_iter();
    own.into_iter().chain(tools).collect()
}

/// Fails where the device cannot hold a machine.
fn conclusion(report: &Report) -> Result<()> {
    let too_large = report.device_use.iter().filter(|used| !used.fits);
    let too_large = too_large.map(|used| {
        let (machine, lacking) = (&used.machine, used.lacking());
        format!("{machine} does not fit in {}: {lacking}", report.device)
    });
    match too_large.collect::<Vec<_>>() {
        none if none.is_empty() => Ok(()),
        some => Err(CheckFailed(some.join("; ")).into()),
    }
}

fn verilog_rows(plan: &Plan) -> Vec<VerilogRow> {
    let row = |subject: &Subject| VerilogRow {
        machine: subject.name.clone(),
        verilog_sha256: subject.verilog_sha256.clone(),
    };
    plan.subjects.iter().map(row).collect()
}

fn script_rows(plan: &Plan, abc9_target_ps: u32) -> Vec<ScriptRow> {
    let row = |&flow: &&'static Flow| ScriptRow {
        flow,
        script: flow.script("TOP", abc9_target_ps),
    };
    plan.flows.iter().map(row).collect()
}

fn text(report: &Report) -> String {
    let mut text = tables::areas(&report.areas);
    if !report.fmax_by_grade.is_empty() {
        text += &format!("Clock, {}, post-route:\n", report.device);
        text += &tables::clocks(&report.fmax_by_grade);
        text += &tables::endpoints(&report.placements);
        text += "\n";
    }
    // The committed figures are of machines in a device that holds them all.
    if report.device != DEFAULT_DEVICE && !report.device_use.is_empty() {
        text += &format!("Use of {}:\n", report.device);
        text += &tables::uses(&report.device_use);
        text += "\n";
    }
    text += &tables::measured_by(&report.tool_versions);
    match report.files.as_slice() {
        [] => {
            text += " Nothing was written: `list` and `run` know only the committed figures, which a run of all machines, or \
                     --update, writes.\n"
        }
        files => text += &format!(" Wrote {}.\n", files.join(", ")),
    }
    text
}

#[cfg(test)]
mod tests;
