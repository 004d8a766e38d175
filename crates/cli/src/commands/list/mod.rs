//! The command `list`: scenes and machines with their figures, or the datasheet of one machine or core.

mod core;
mod datasheet;
mod ports;
mod text;

use anyhow::Result;
use fpga_flow::Figures;
use photoncube_render::Scene;
use photoncube_spec::{MACHINES, Machine, PHOTON_FORMATS, PhotonFormat, Widths, find_machine};
use serde::Serialize;

use crate::args::ListArgs;
use crate::cores::{self, MeasuredCore};
use crate::measured::{self, Measured};
use crate::measured_fits::{FitRow, fit_rows};
use crate::output;

pub use self::ports::{clocks, widths};
pub use self::text::{proofs, speed};

#[derive(Serialize)]
struct Report {
    scenes: Vec<SceneRow>,
    machines: Vec<MachineRow>,
    measured_cores: Vec<CoreRow>,
    formats: Vec<FormatRow>,
    fits: Vec<FitRow>,
}

/// A core whose clock is measured, with the area of its modules on ECP5.
#[derive(Serialize)]
struct CoreRow {
    core: String,
    machine: &'static str,
    chains: u32,
    chain_engines: usize,
    fmax_mhz: f64,
    speed_grade: Option<u32>,
    seeds: usize,
    #[serde(flatten)]
    area: Figures,
    verilog_sha256: String,
}

/// A photon format, with the machines that are built for it.
#[derive(Serialize)]
struct FormatRow {
    format: String,
    summary: String,
    bits_per_photon: u32,
    position_bits: u32,
    query_extra_bits: u32,
    radius_bits: u32,
    channels: u32,
    mantissa_bits: u32,
    exponent_bits: u32,
    exponent_range: u32,
    max_photons: u64,
    sum_bits: u32,
}

#[derive(Serialize)]
struct SceneRow {
    scene: &'static str,
    surfaces: usize,
}

/// A machine with its figures.
#[derive(Serialize)]
pub struct MachineRow {
    machine: &'static str,
    summary: &'static str,
    format: Option<String>,
    cells: usize,
    coordinate_bits: u32,
    position_bits: u32,
    power_bits: u32,
    radius_sq_bits: u32,
    work_bits: u32,
    sum_bits: u32,
    bits_per_photon: u32,
    max_photons: u64,
    squarer: &'static str,
    photons_per_iteration: usize,
    queries_at_once: usize,
    initiation_interval: f64,
    photon_tests_per_clock: f64,
    #[serde(flatten)]
    /// What was measured of it.
    pub measured: Measured,
}

/// Lists all scenes, machines and formats, or prints the datasheet of one machine or core.
pub fn execute(args: &ListArgs, json: bool) -> Result<()> {
    if let Some(name) = &args.machine {
        return match self::core::named(name) {
            Some(core) => self::core::print(&core?, args.wide, json),
            None => datasheet::print(find_machine(name)?, args.wide, json),
        };
    }
    let report = report()?;
    let fmax_source = measured::fmax_source()?;
    output::print(json, &report, || match args.wide.wide {
        true => text::wide(&report, &fmax_source),
        false => text::narrow(&report, &fmax_source),
    })?;
    measured::refuse_stale()
}

fn report() -> Result<Report> {
    let scenes = Scene::names().map(|scene| {
        let surfaces = Scene::built_in(scene)?.surfaces().len();
        Ok(SceneRow { scene, surfaces })
    });
    Ok(Report {
        scenes: scenes.collect::<Result<_>>()?,
        machines: MACHINES.iter().map(machine_row).collect::<Result<_>>()?,
        measured_cores: cores::measured()?.into_iter().map(core_row).collect(),
        formats: PHOTON_FORMATS.iter().map(format_row).collect(),
        fits: fit_rows()?,
    })
}

fn core_row(measured: MeasuredCore) -> CoreRow {
    let (core, clock) = (measured.core, measured.clock);
    CoreRow {
        core: core.name(),
        machine: core.machine.name,
        chains: core.chains,
        chain_engines: core.engines(),
        fmax_mhz: clock.fmax_mhz,
        speed_grade: clock.speed_grade,
        seeds: clock.seeds,
        area: measured.area.figures,
        verilog_sha256: measured.verilog_sha256,
    }
}

fn format_row(format: &PhotonFormat) -> FormatRow {
    let widths = Widths::of_format(format);
    FormatRow {
        format: format.name(),
        summary: format.summary(),
        bits_per_photon: widths.bits_per_photon,
        position_bits: format.position_bits,
        query_extra_bits: format.query_extra_bits,
        radius_bits: format.radius_bits(),
        channels: format.power.channels.count(),
        mantissa_bits: format.power.mantissa_bits,
        exponent_bits: format.power.exponent.bits(),
        exponent_range: format.power.exponent_range(),
        max_photons: format.max_photons,
        sum_bits: widths.sum,
    }
}

/// The figures of a machine.
pub fn machine_row(machine: &Machine) -> Result<MachineRow> {
    let widths = Widths::of(machine);
    Ok(MachineRow {
        machine: machine.name,
        summary: machine.summary,
        format: machine.format().map(PhotonFormat::name),
        cells: machine.hypercube().nodes(),
        coordinate_bits: widths.coordinate,
        position_bits: machine.position_bits(),
        power_bits: widths.power,
        radius_sq_bits: widths.radius_sq,
        work_bits: widths.work,
        sum_bits: widths.sum,
        bits_per_photon: machine.bits_per_photon(),
        max_photons: machine.max_photons(),
        squarer: machine.squarer.name(),
        photons_per_iteration: machine.photons_per_iteration(),
        queries_at_once: machine.queries_at_once(),
        initiation_interval: machine.rate().interval(),
        photon_tests_per_clock: machine.photon_tests_per_clock(),
        measured: Measured::of(machine)?,
    })
}
