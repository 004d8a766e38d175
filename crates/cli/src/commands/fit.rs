//! The command `fit`: the smallest photon format and machine that a scene needs, with the evidence.

mod comparison;
mod left_out;
mod text;

use std::time::Instant;

use anyhow::Result;
use photoncube_render::{
    Engine, FieldNeed, Fit, FitOptions, Measurement, Removal, Scene, SceneFacts, ViewOptions,
    view_queries,
};
use serde::Serialize;

use self::comparison::Compared;
use self::left_out::LeftOut;
use crate::args::FitArgs;
use crate::chains::{self, ChainsChoice};
use crate::failure::CheckFailed;
use crate::fitted::{self, Choices, FormatRow, MachineChoice};
use crate::hardware::PictureTime;
use crate::{machines, output, outputs, project, scenes, sight};

#[derive(Serialize)]
struct Report {
    scene: String,
    seed: u64,
    noise_ratio: f64,
    photons: u64,
    in_range: f64,
    photons_in_range_mean: f64,
    query_points: u64,
    maps: u64,
    pilot_maps: u64,
    noise_relative: f64,
    #[serde(flatten)]
    light: SceneFacts,
    candidates: u64,
    pilot_figures: u64,
    /// Formats that were predicted below the bound and measured above it.
    broken: Vec<FormatRow>,
    fitted: Option<FormatRow>,
    removals: Vec<RemovalRow>,
    left_out: Vec<LeftOut>,
    /// The fitted format, its machine, and the machines that they are compared with.
    comparison: Vec<Compared>,
    /// The smallest machine for the format.
    machine: Option<MachineRow>,
    /// The fastest machine within the bound.
    fastest: Option<MachineRow>,
    /// The cores for the scene, with the one that does the most queries a clock.
    cores: Option<ChainsChoice>,
    /// The files of the smallest machine that were written; empty without `--emit`.
    emitted: Vec<String>,
    /// The command that runs the chosen machine.
    next: Option<String>,
    seconds: f64,
}

/// The fitted format with one bit, or one degree of freedom, less.
#[derive(Serialize)]
struct RemovalRow {
    less: &'static str,
    #[serde(flatten)]
    row: FormatRow,
}

#[derive(Serialize)]
struct MachineRow {
    machine: &'static str,
    format: String,
    bits_per_photon: u32,
    measurement: Measurement,
    wider_than_needed: Vec<FieldNeed>,
    /// The time for the queries at which the formats were measured, on one of the maps.
    #[serde(flatten)]
    time: PictureTime,
}

/// Fits a scene. The exit code is 1 where no format or no machine meets the ratio.
pub fn execute(args: &FitArgs, json: bool) -> Result<()> {
    let start = Instant::now();
    let options = args.options();
    let scene = scenes::load(&args.scene)?;
    // A wrong folder is reported before the work.
    if let Some(out) = &args.emit {
        outputs::check_folder("--emit", out)?;
    }
    sight::check(&scene, &options.bench.view)?;
    let fit = fitted::fit_with_bar(&scene, &options);
    let fit = sight::explained(fit, &scene, &options.bench.view)?;
    let choices = match &fit.chosen {
        Some(chosen) => fitted::choose(&fit, &options, chosen)?,
        None => None,
    };
    let mut report = report(args, &options, &fit, choices.as_ref())?;
    report.cores = cores(&scene, &options, &fit)?;
    if let (Some(out), Some(choices)) = (&args.emit, &choices) {
        machines::prepare(choices.smallest.machine)?;
        report.emitted = project::write(choices.smallest.machine, "--emit", out, scene.files())?;
    }
    report.seconds = start.elapsed().as_secs_f64();
    output::print_tables(json, args.wide, &report, || text::text(&report))?;
    match (&fit.chosen, &choices) {
        (None, _) => Err(CheckFailed(fitted::no_format(&fit, &options)).into()),
        (Some(chosen), None) => Err(CheckFailed(fitted::no_machine(&chosen.format)).into()),
        (Some(_), Some(_)) => Ok(()),
    }
}

fn report(
    args: &FitArgs,
    options: &FitOptions,
    fit: &Fit,
    choices: Option<&Choices>,
) -> Result<Report> {
    let chosen = fit.chosen.as_ref();
    let smallest = choices.map(|choices| &choices.smallest);
    let fastest = choices.map(|choices| &choices.fastest);
    Ok(Report {
        scene: args.scene.to_string(),
        seed: args.seed,
        noise_ratio: options.noise_ratio,
        photons: args.photons,
        in_range: args.in_range,
        maps: args.maps,
        pilot_maps: fit.pilot_maps,
        noise_relative: fit.noise_relative,
        light: fit.facts,
        candidates: fit.candidates,
        pilot_figures: fit.parts,
        broken: fit.broken.iter().map(FormatRow::of).collect(),
        fitted: chosen.map(FormatRow::of),
        removals: fit.removals.iter().map(RemovalRow::of).collect(),
        left_out: chosen.map_or_else(Vec::new, |c| left_out::left_out(c, &fit.facts)),
        comparison: match chosen {
            Some(chosen) => comparison::comparison(&chosen.format, choices)?,
            None => Vec::new(),
        },
        machine: smallest.map(MachineRow::of),
        fastest: fastest.map(MachineRow::of),
        cores: None,
        photons_in_range_mean: photons_in_range_mean(fit)?,
        query_points: fit.bench.queries().len() as u64,
        emitted: Vec::new(),
        next: smallest.map(|choice| next(args, choice)),
        seconds: 0.0,
    })
}

/// The cores for the scene. A picture has more queries for each photon than a fit has, as many to a pixel as by default.
fn cores(scene: &Scene, options: &FitOptions, fit: &Fit) -> Result<Option<ChainsChoice>> {
    let view = ViewOptions {
        samples_per_axis: ViewOptions::default().samples_per_axis,
        ..options.bench.view
    };
    let (map, queries) = (&fit.bench.maps()[0], view_queries(scene, &view)?);
    chains::choose(fit, options.noise_ratio, map, &queries)
}

/// The mean number of photons in range by the reference, over all queries and maps.
fn photons_in_range_mean(fit: &Fit) -> Result<f64> {
    let estimates = fit.bench.queries().len() * fit.bench.maps().len();
    let reference = fit.bench.measure(Engine::F64)?;
    Ok(reference.photons_in_range as f64 / estimates.max(1) as f64)
}

/// The command that runs the scene on that machine, with the photons and the picture for which its sums are sized.
fn next(args: &FitArgs, choice: &MachineChoice) -> String {
    format!(
        "photoncube run {} --machine {} --photons {} --size {} --in-range {}",
        args.scene, choice.machine.name, args.photons, args.size, args.in_range
    )
}

impl RemovalRow {
    fn of(removal: &Removal) -> Self {
        Self {
            less: removal.less,
            row: FormatRow::of(&removal.trial),
        }
    }
}

impl MachineRow {
    fn of(choice: &MachineChoice) -> Self {
        Self {
            machine: choice.machine.name,
            format: choice.format.name(),
            bits_per_photon: choice.machine.bits_per_photon(),
            measurement: choice.measurement,
            wider_than_needed: choice.wider.clone(),
            time: choice.time.clone(),
        }
    }
}
