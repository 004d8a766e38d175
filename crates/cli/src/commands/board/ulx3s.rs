//! `board ulx3s`: the sources of a core on a ULX3S, and its bitstream.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow};
use fpga_flow::{
    Design, Device, PackStep, Packed, Pinned, ReachedClock, Resource, bitstream, devices::ecp5,
    packer,
};
use photoncube_hdl::{Ulx3s, Ulx3sFiles};
use photoncube_spec::Core;
use photoncube_testbench::pinned_tools;
use serde::Serialize;

use crate::args::Ulx3sArgs;
use crate::core::chains_said;
use crate::failure::CheckFailed;
use crate::outputs::{self, Output};
use crate::project::ABC9_TARGET_PS;
use crate::synth::{self, flow_to_place};
use crate::{files, output, progress};

/// The FPGA of the board.
const DEVICE: &str = "LFE5U-85F";
/// Its package on the board.
const PACKAGE: &str = "CABGA381";
/// Its speed grade.
const GRADE: u32 = 6;

#[derive(Serialize)]
struct Report {
    core: String,
    chains: u32,
    engines: usize,
    photons_held: u64,
    clock_mhz: u32,
    baud: u32,
    clocks_per_bit: u32,
    device: &'static str,
    package: &'static str,
    speed_grade: u32,
    seed: u32,
    fmax_by_clock: Vec<ReachedClock>,
    resources: Vec<Resource>,
    bitstream: Option<String>,
    bitstream_bytes: Option<usize>,
    tool_versions: BTreeMap<String, String>,
    files: Vec<String>,
}

/// The tools of a build.
struct Tools {
    tools: fpga_flow::Tools,
    packer: PathBuf,
}

impl Tools {
    fn find(folder: Option<&Path>) -> Result<Self> {
        let tools = synth::tools(folder, Some(&ecp5::FAMILY))?;
        let packer = packer(folder.or(pinned_tools()));
        let packer =
            packer.map_err(|error| anyhow!("{error}; `{}` installs it", synth::INSTALL))?;
        Ok(Self { tools, packer })
    }
}

/// Writes the sources, and makes the bitstream.
pub fn execute(args: &Ulx3sArgs, json: bool) -> Result<()> {
    let board = args.on_board.board(args.mhz, args.baud)?;
    // What is missing is said before the work, which takes minutes.
    let tools = match args.no_build {
        true => None,
        false => Some(Tools::find(args.tools.as_deref())?),
    };
    let sources = board.files()?;
    let named = named(&sources);
    let path = |name: &str| args.out.join(name);
    let bit = path(&format!("{}.bit", sources.top));
    let outputs = named
        .iter()
        .map(|(name, _)| path(name))
        .chain([bit.clone()]);
    let outputs: Vec<_> = outputs.map(|path| Output::within("--out", path)).collect();
    outputs::check(&outputs, &[])?;
    files::write_all(
        named
            .iter()
            .map(|(name, text)| (path(name), text.as_bytes())),
    )?;
    let written = named
        .iter()
        .map(|(name, _)| path(name).display().to_string());
    let mut report = report(&board, args, written.collect());
    let Some(tools) = tools else {
        return output::print(json, &report, || text(&report));
    };
    match build(&board, &sources, args.seed, &tools, &mut report)? {
        Packed::TooLarge(resources) => report.resources = resources,
        Packed::Done {
            bytes,
            clocks,
            resources,
        } => {
            report.fmax_by_clock = clocks;
            report.resources = resources;
            if report.slow().is_none() {
                files::write(&bit, &bytes)?;
                report.bitstream = Some(bit.display().to_string());
                report.bitstream_bytes = Some(bytes.len());
            }
        }
    }
    output::print(json, &report, || text(&report))?;
    conclusion(&report)
}

/// The files by their names.
fn named(sources: &Ulx3sFiles) -> Vec<(String, &str)> {
    let Ulx3sFiles { top, core, .. } = sources;
    let of_core = core.machine.ecp5_text.as_deref();
    let of_core = of_core.map(|text| (format!("{}_ecp5.v", core.top), text));
    [
        (format!("{top}.v"), sources.board.as_str()),
        (format!("{top}_pll.v"), &sources.pll),
        (format!("{top}_pll_model.v"), &sources.pll_model),
        (format!("{top}.lpf"), &sources.lpf),
        (format!("{}.v", core.top), &core.text),
    ]
    .into_iter()
    .chain(of_core)
    .collect()
}

fn report(board: &Ulx3s, args: &Ulx3sArgs, files: Vec<String>) -> Report {
    let core = board.core();
    Report {
        core: core.name(),
        chains: core.chains,
        engines: core.engines(),
        photons_held: photons_held(core),
        clock_mhz: args.mhz,
        baud: args.baud,
        clocks_per_bit: board.clocks_of_bit(),
        device: DEVICE,
        package: PACKAGE,
        speed_grade: GRADE,
        seed: args.seed,
        fmax_by_clock: Vec::new(),
        resources: Vec::new(),
        bitstream: None,
        bitstream_bytes: None,
        tool_versions: BTreeMap::new(),
        files,
    }
}

/// The photons that the two banks of all chains hold.
fn photons_held(core: &Core) -> u64 {
    const BANKS: u64 = 2;
    let leaves = u64::from(core.set_leaves()) * u64::from(core.chains);
    BANKS * leaves * Core::LEAF_PHOTONS as u64
}

fn build(
    board: &Ulx3s,
    sources: &Ulx3sFiles,
    seed: u32,
    tools: &Tools,
    report: &mut Report,
) -> Result<Packed> {
    // The tools run in a sandbox that sees the current folder and below.
    let scratch = tempfile::tempdir().context("cannot make a scratch folder")?;
    report.tool_versions = tools.tools.versions(scratch.path())?;
    let ecp5_text = sources.core.machine.ecp5_text.iter();
    let design = Design {
        top: sources.top.clone(),
        verilog: [&sources.board, &sources.pll, &sources.core.text]
            .map(String::as_str)
            .join("\n"),
        overrides: ecp5_text
            .map(|text| (ecp5::FAMILY.name, text.clone()))
            .collect(),
    };
    design.write(scratch.path())?;
    let device = Device::find(DEVICE)?;
    let pinned = Pinned {
        design: &design,
        device,
        package: PACKAGE,
        grade: GRADE,
        flow: flow_to_place(board.core().machine, device),
        abc9_target_ps: ABC9_TARGET_PS,
        lpf: &sources.lpf,
        seed,
    };
    let bar = progress::spinner("making the bitstream:");
    bar.enable_steady_tick(progress::TICK);
    let begins = |step| {
        bar.set_message(match step {
            PackStep::Map => "Yosys maps the core; step 1 of 3, now at",
            PackStep::Place => "nextpnr places and routes it; step 2 of 3, now at",
            PackStep::Pack => "ecppack writes the bitstream; step 3 of 3, now at",
        });
    };
    let packed = bitstream(
        &tools.tools,
        &tools.packer,
        scratch.path(),
        &pinned,
        &begins,
    );
    bar.finish_and_clear();
    Ok(packed?)
}

impl Report {
    /// A clock that is not reached.
    fn slow(&self) -> Option<&ReachedClock> {
        let mut clocks = self.fmax_by_clock.iter();
        clocks.find(|clock| clock.fmax_mhz < clock.needed_mhz)
    }
}

/// Fails where the device cannot hold the core, or the clock is not reached.
fn conclusion(report: &Report) -> Result<()> {
    let lacking: Vec<_> = report
        .resources
        .iter()
        .filter(|resource| resource.is_lacking())
        .map(|r| format!("{} of {} {}", r.needed, r.available, r.resource))
        .collect();
    if !lacking.is_empty() {
        return Err(CheckFailed(format!(
            "{} does not fit in {DEVICE}: it needs {}; give a smaller machine or fewer --chains",
            report.core,
            lacking.join(", ")
        ))
        .into());
    }
    match report.slow() {
        None => Ok(()),
        Some(slow) => Err(CheckFailed(format!(
            "the clock {} reaches {:.1} MHz, expected {:.1}; give a slower --mhz ({:?}) or another --seed",
            slow.net.trim_start_matches("$glbnet$"),
            slow.fmax_mhz,
            slow.needed_mhz,
            Ulx3s::clocks()
        ))
        .into()),
    }
}

fn text(report: &Report) -> String {
    let mut text = format!(
        "{} on a ULX3S: {}, {} photons in its banks; {} MHz, a serial line of {} bits a second\n",
        report.core,
        chains_said(report.chains, report.engines),
        report.photons_held,
        report.clock_mhz,
        report.baud
    );
    for r in &report.resources {
        text += &format!("{:>20} {:>6} of {}\n", r.resource, r.needed, r.available);
    }
    for clock in &report.fmax_by_clock {
        text += &format!(
            "{}: reaches {:.1} MHz, needs {:.1}\n",
            clock.net.trim_start_matches("$glbnet$"),
            clock.fmax_mhz,
            clock.needed_mhz
        );
    }
    if let (Some(path), Some(bytes)) = (&report.bitstream, report.bitstream_bytes) {
        text += &format!("{path}: {bytes} bytes; never tried on a board, see docs/board.md\n");
    }
    text + &format!("Wrote {}.\n", report.files.join(", "))
}
