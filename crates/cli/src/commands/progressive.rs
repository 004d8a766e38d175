//! The command `progressive`: a picture that improves pass by pass.

mod kept;
mod setup;
mod shard;
mod text;
mod work;

use std::time::Instant;

use anyhow::{Context, Result, ensure};
use photoncube_render::{ErrorEstimate, Image, ball_errors};
use serde::{Deserialize, Serialize};

use crate::args::{EngineReport, LightingReport, ProgressiveArgs, short};
use crate::core::CoreReport;
use crate::failure::CheckFailed;
use crate::interrupt::Interrupt;
use crate::narrow::narrow;
use crate::plots::Reached;
use crate::shards::{Header, Shard};
use crate::stages::write_picture;
use crate::{output, sight};

pub use self::kept::{merge, passes};

use self::kept::Keeper;
use self::setup::Setup;
use self::text::text;
use self::work::Work;

/// The name of the command, in state files.
pub const NAME: &str = "progressive";

/// The figures after some passes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Row {
    passes: u64,
    photons: u64,
    search_radius: f64,
    /// The bound of the error; `None` after one pass, which gives no estimate.
    error_bound: Option<f64>,
    estimated_bias: Option<f64>,
    estimated_noise: Option<f64>,
    /// The relMSE against the reference; `None` without a reference.
    rel_mse: Option<f64>,
    bounded_share: Option<f64>,
    seconds: f64,
}

impl Row {
    fn reached(&self, error: f64) -> Reached {
        Reached {
            passes: self.passes as f64,
            photons: self.photons as f64,
            error,
        }
    }
}

#[derive(Serialize)]
struct Report {
    scene: String,
    #[serde(flatten)]
    engine: EngineReport,
    core: Option<CoreReport>,
    #[serde(flatten)]
    light: LightingReport,
    output: String,
    seed: u64,
    photons_per_pass: u64,
    samples_per_axis: u32,
    alpha: f64,
    radius_rule: String,
    /// `None` by the schedule.
    halvings_mean: Option<f64>,
    confidence: f64,
    error_target: Option<f64>,
    query_points: u64,
    photon_tests: u64,
    photons_without_power: u64,
    /// The files beside the picture: snapshots, plot, error map.
    files: Vec<String>,
    /// The file with the state after the last pass.
    state: Option<String>,
    /// The passes that were in the state at the start.
    resumed_passes: u64,
    /// Whether a signal ended the run before its passes were made.
    interrupted: bool,
    progress: Vec<Row>,
    /// Student's quantile of the last pass; `None` after one pass.
    #[serde(skip)]
    quantile: Option<f64>,
    #[serde(skip)]
    is_ruled_by_bias: bool,
    /// What is said of balls, by the radius of the last pass.
    #[serde(skip)]
    balls: String,
}

/// The reason why no more passes are made.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum End {
    /// The error is as small as requested.
    Reached,
    /// All passes are made.
    Passes,
    /// A signal asked to stop.
    Interrupted,
}

/// Renders until the error is as small as requested, or the passes are made.
pub fn execute(args: &ProgressiveArgs, json: bool) -> Result<()> {
    let chosen = args.engine.find()?;
    let setup = Setup::new(args, chosen.engine())?;
    if let Some(shard) = args.shard {
        return shard::execute(args, &setup, shard, json);
    }
    let Setup {
        scene,
        engine,
        lighting,
        view,
        options,
        balance,
    } = &setup;
    let output = args.output().context("a picture has a file")?;
    let reference = args.reference.as_deref().map(Image::read_exr).transpose()?;
    if let (Some(reference), Some(path)) = (&reference, &args.reference) {
        let size = (reference.width(), reference.height());
        ensure!(
            size == (view.width, view.height),
            "{}: found {}x{} pixels, expected {} as the picture; give --size",
            path.display(),
            size.0,
            size.1,
            args.size
        );
    }
    let keeper = args.state.clone().map(|path| {
        let header = Header::new(NAME, setup.settings(args), None, Shard::WHOLE);
        Keeper::new(path, header)
    });
    let mut work = Work {
        args,
        output,
        progressive: setup.picture()?,
        reference,
        start: Instant::now(),
        seconds_before: 0.0,
        rows: Vec::new(),
        files: Vec::new(),
        keeper,
    };
    work.resume()?;
    let before = work.progressive.stats().estimates;
    let resumed_passes = work.progressive.passes();
    let end = work.run(&Interrupt::watch()?)?;
    let (image, stats) = (work.progressive.image(), work.progressive.stats());
    sight::check_light(&image, scene, view, stats)?;
    write_picture(&image, output)?;
    work.write_plot(scene.name())?;
    work.write_error_map(scene.name())?;
    let error = work.progressive.error(args.confidence);
    let passes = work.progressive.passes();
    let report = Report {
        scene: args.scene.to_string(),
        engine: EngineReport::of(*engine),
        core: chosen.core_report(stats.estimates - before),
        light: LightingReport::of(lighting),
        output: output.display().to_string(),
        seed: args.seed,
        photons_per_pass: balance.photons,
        samples_per_axis: balance.samples_per_axis,
        alpha: args.alpha,
        radius_rule: options.rule.to_string(),
        halvings_mean: work.progressive.halvings_mean(),
        confidence: args.confidence,
        error_target: args.error_target,
        query_points: stats.query_points,
        photon_tests: stats.photon_tests,
        photons_without_power: stats.photons_without_power,
        files: work.files,
        state: args.state.as_ref().map(|path| path.display().to_string()),
        resumed_passes,
        interrupted: end == End::Interrupted,
        progress: work.rows,
        balls: sight::balls(&ball_errors(
            scene,
            lighting,
            work.progressive.radius().unwrap_or_default(),
        )),
        is_ruled_by_bias: error.as_ref().is_some_and(ErrorEstimate::is_ruled_by_bias),
        quantile: error.map(|error| error.quantile),
    };
    output::print(json, &report, || narrow(&text(&report)))?;
    let (output, all) = (&report.output, args.passes);
    match (end, args.error_target) {
        (End::Interrupted, _) => Err(CheckFailed(format!(
            "interrupted after {passes} of {all} passes; {output} is their mean{}",
            match args.state {
                Some(_) => "; the same command with --resume goes on",
                None => "",
            }
        ))
        .into()),
        (End::Passes, Some(target)) => Err(CheckFailed(format!(
            "the error target {} is not reached in {all} passes: give more --passes{}",
            short(target),
            match report.is_ruled_by_bias {
                true => {
                    ", and a smaller --in-range: bias rules, so the error may be above the bound"
                }
                false => "",
            }
        ))
        .into()),
        _ => Ok(()),
    }
}
