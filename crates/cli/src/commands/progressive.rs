//! The command `progressive`: a picture that improves pass by pass.

mod kept;
mod text;

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};
use photoncube_render::{
    Area, Balance, Caustics, DirectLight, ErrorEstimate, Estimator, Given, Image, Lighting,
    Progressive, ProgressiveOptions, RadiusRule, Scene, ViewOptions, ball_errors, error_map,
    luminance,
};
use serde::{Deserialize, Serialize};

use crate::args::{EngineReport, LightingReport, ProgressiveArgs, short};
use crate::core::CoreReport;
use crate::failure::CheckFailed;
use crate::interrupt::Interrupt;
use crate::narrow::narrow;
use crate::outputs::{self, Output};
use crate::plots::{Curve, Reached, convergence_plot};
use crate::stages::{Distance, write_picture};
use crate::{files, output, progress, scenes, sight};

use self::kept::{Keeper, Kept};
use self::text::text;

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
    let engine = chosen.engine();
    let scene = scenes::load(&args.scene)?;
    let lighting = args.light.lighting(&LIGHTING);
    lighting.check(&scene, &Estimator::FixedRadius)?;
    check_outputs(args, &scene)?;
    let base = ViewOptions {
        width: args.size.width,
        height: args.size.height,
        seed: args.seed,
        ..ViewOptions::default()
    };
    sight::check(&scene, &base)?;
    let balance = balance(args, &scene, &lighting, &base)?;
    let (view, options) = (
        ViewOptions {
            samples_per_axis: balance.samples_per_axis,
            ..base
        },
        ProgressiveOptions {
            photons: balance.photons,
            rule: args
                .radius_rule
                .unwrap_or_else(|| RadiusRule::of(&lighting)),
            ..options(args)
        },
    );
    let lighting = Lighting {
        direct: match lighting.direct {
            DirectLight::Map => DirectLight::Map,
            DirectLight::Rays(_) => DirectLight::Rays(balance.rays),
        },
        ..lighting
    };
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
    let progressive = Progressive::new(&scene, engine, lighting, view, options)?;
    let keeper = args.state.clone().map(|path| {
        let settings = kept::settings(args, &scene, engine, &lighting, &balance, options.rule);
        Keeper::new(path, settings)
    });
    let mut work = Work {
        args,
        progressive,
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
    sight::check_light(&image, &scene, &view, stats)?;
    write_picture(&image, &args.output)?;
    work.write_plot(scene.name())?;
    work.write_error_map(scene.name())?;
    let error = work.progressive.error(args.confidence);
    let passes = work.progressive.passes();
    let report = Report {
        scene: args.scene.to_string(),
        engine: EngineReport::of(engine),
        core: chosen.core_report(stats.estimates - before),
        light: LightingReport::of(&lighting),
        output: args.output.display().to_string(),
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
            &scene,
            &lighting,
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

/// Checks all files that may be written against all that are read.
fn check_outputs(args: &ProgressiveArgs, scene: &Scene) -> Result<()> {
    let mut outputs = vec![Output::picture("-o", &args.output)];
    outputs.extend(args.plot.iter().map(|path| Output::plot("--plot", path)));
    let state = args.state.iter();
    outputs.extend(state.map(|path| Output::within("--state", path.clone())));
    let map = args.error_map.iter();
    outputs.extend(map.map(|path| Output::plot("--error-map", path)));
    if args.snapshots {
        let powers = (0..u64::BITS).map(|power| 1 << power);
        let passes = powers.take_while(|passes| *passes <= args.passes);
        let snapshots = passes.map(|passes| snapshot(&args.output, passes));
        outputs.extend(snapshots.map(|path| Output::within("--snapshots", path)));
    }
    let mut inputs = scene.files().to_vec();
    inputs.extend(args.reference.clone());
    outputs::check(&outputs, &inputs)
}

/// The lighting that is not given: what needs the least time for an error. The pilot chooses the number of shadow rays.
const LIGHTING: Lighting = Lighting {
    direct: DirectLight::Rays(1),
    caustics: Caustics::OWN,
    final_gather: 0,
    area: Area::Covered,
};

fn options(args: &ProgressiveArgs) -> ProgressiveOptions {
    ProgressiveOptions {
        in_range: args.in_range,
        alpha: args.alpha,
        seed: args.seed,
        ..ProgressiveOptions::default()
    }
}

/// What a pass is made of: what is given, and what a pilot chooses.
fn balance(
    args: &ProgressiveArgs,
    scene: &Scene,
    lighting: &Lighting,
    view: &ViewOptions,
) -> Result<Balance> {
    let given = Given {
        photons: args.photons,
        samples_per_axis: args.samples,
        rays: match args.light.direct {
            Some(DirectLight::Rays(rays)) => Some(rays),
            _ => None,
        },
    };
    let options = options(args);
    Ok(Balance::choose(scene, lighting, view, &options, given)?)
}

/// The time between two writings of the state while the passes go on.
const KEPT_EVERY: Duration = Duration::from_secs(60);

struct Work<'a> {
    args: &'a ProgressiveArgs,
    progressive: Progressive<'a>,
    reference: Option<Image>,
    start: Instant,
    /// The time of the passes that were made before this run.
    seconds_before: f64,
    /// The rows after 1, 2, 4, 8, ... passes and after the last.
    rows: Vec<Row>,
    /// The files that were written.
    files: Vec<String>,
    keeper: Option<Keeper>,
}

impl Work<'_> {
    /// Takes over the state of an earlier run, if that is asked for.
    fn resume(&mut self) -> Result<()> {
        let Some(keeper) = &self.keeper else {
            return Ok(());
        };
        if !self.args.resume {
            return keeper.check_new();
        }
        let kept = keeper.read()?;
        let (passes, all) = (kept.state.passes(), self.args.passes);
        ensure!(
            passes <= all,
            "{}: found {passes} passes, expected at most --passes {all}",
            keeper.path().display()
        );
        self.progressive.resume(&kept.state)?;
        self.seconds_before = kept.seconds;
        self.rows = kept.rows_for(self.reference.as_ref());
        Ok(())
    }

    /// Makes passes until there are enough. A new picture gets at least one.
    fn run(&mut self, interrupt: &Interrupt) -> Result<End> {
        let bar = progress::bar("passes", self.args.passes);
        bar.set_position(self.progressive.passes());
        let mut end = None;
        if self.progressive.passes() > 0 {
            // The passes that were made before may be enough.
            end = self.ended(interrupt)?;
        }
        let mut kept = Instant::now();
        while end.is_none() {
            self.progressive.pass()?;
            bar.set_position(self.progressive.passes());
            end = self.ended(interrupt)?;
            if end.is_some() || kept.elapsed() >= KEPT_EVERY {
                self.keep()?;
                kept = Instant::now();
            }
        }
        bar.finish_and_clear();
        end.context("a picture has an end")
    }

    /// Whether the passes so far are enough. Adds their row to the table where it has a place there.
    fn ended(&mut self, interrupt: &Interrupt) -> Result<Option<End>> {
        let error = self.progressive.error(self.args.confidence);
        let end = self.end(error.as_ref(), interrupt);
        if self.progressive.passes().is_power_of_two() || end.is_some() {
            self.push_row(error.as_ref())?;
        }
        Ok(end)
    }

    /// Writes the state.
    fn keep(&self) -> Result<()> {
        let Some(keeper) = &self.keeper else {
            return Ok(());
        };
        let reference = self.reference.as_ref();
        keeper.write(&Kept {
            state: self.progressive.state(),
            rows: self.rows.clone(),
            reference: reference.map(kept::sha256_of_image),
            seconds: self.seconds(),
        })
    }

    fn seconds(&self) -> f64 {
        self.seconds_before + self.start.elapsed().as_secs_f64()
    }

    fn end(&self, error: Option<&ErrorEstimate>, interrupt: &Interrupt) -> Option<End> {
        let is_below =
            |error: &ErrorEstimate, target| error.bound() <= target && !error.is_ruled_by_bias();
        let below = |target| error.is_some_and(|error| is_below(error, target));
        if self.args.error_target.is_some_and(below) {
            Some(End::Reached)
        } else if self.progressive.passes() >= self.args.passes {
            Some(End::Passes)
        } else {
            interrupt.is_asked().then_some(End::Interrupted)
        }
    }

    fn push_row(&mut self, error: Option<&ErrorEstimate>) -> Result<()> {
        let (passes, image) = (self.progressive.passes(), self.progressive.image());
        if self.args.snapshots {
            let path = snapshot(&self.args.output, passes);
            write_picture(&image, &path)?;
            self.files.push(path.display().to_string());
        }
        let reference = self.reference.as_ref();
        let distance = reference.map(|reference| Distance::between(&image, reference));
        let bounded = reference.zip(error).and_then(|(reference, error)| {
            let truth = reference.pixels().iter().map(|rgb| luminance(*rgb));
            error.bounded(&truth.collect::<Vec<_>>())
        });
        self.rows.push(Row {
            passes,
            photons: self.progressive.photons(),
            search_radius: self.progressive.radius().unwrap_or_default(),
            error_bound: error.map(ErrorEstimate::bound),
            estimated_bias: error.map(ErrorEstimate::bias),
            estimated_noise: error.map(ErrorEstimate::noise),
            rel_mse: distance.transpose()?.map(|distance| distance.rel_mse),
            bounded_share: bounded,
            seconds: self.seconds(),
        });
        Ok(())
    }

    fn write_plot(&mut self, scene: &str) -> Result<()> {
        let Some(path) = &self.args.plot else {
            return Ok(());
        };
        let curve = |name, of: fn(&Row) -> Option<f64>| Curve {
            name,
            points: self
                .rows
                .iter()
                .filter_map(|row| Some(row.reached(of(row)?)))
                // The logarithm of 0 cannot be drawn.
                .filter(|reached| reached.error > 0.0)
                .collect(),
        };
        let curves = [
            curve("bound", |row| row.error_bound),
            curve("estimated bias", |row| row.estimated_bias),
            curve("estimated noise", |row| row.estimated_noise),
            curve("error against the reference", |row| {
                row.rel_mse.map(f64::sqrt)
            }),
        ];
        let title = format!("How the error of {scene} falls with passes and photons",);
        files::write(path, convergence_plot(&title, &curves)?.as_bytes())?;
        self.files.push(path.display().to_string());
        Ok(())
    }

    fn write_error_map(&mut self, scene: &str) -> Result<()> {
        let error = self.progressive.error(self.args.confidence);
        let (Some(path), Some(error)) = (&self.args.error_map, error) else {
            return Ok(());
        };
        let bounds: Vec<_> = error
            .pixels
            .iter()
            .map(|p| Some(p.relative_error()))
            .collect();
        let title = format!(
            "bound of the relative error, {:.0} % confidence: {scene}",
            100.0 * error.confidence,
        );
        files::write(
            path,
            error_map(&title, self.args.size.width, &bounds).as_bytes(),
        )?;
        self.files.push(path.display().to_string());
        Ok(())
    }
}

/// The name of a snapshot: `box-0008.png` for `box.png` after 8 passes.
fn snapshot(output: &Path, passes: u64) -> PathBuf {
    let stem = output.file_stem().unwrap_or_default().to_string_lossy();
    let ending = output.extension().unwrap_or_default().to_string_lossy();
    output.with_file_name(format!("{stem}-{passes:04}.{ending}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapshots_are_named_by_their_passes() {
        let name = snapshot(Path::new("out/box.png"), 8);
        assert_eq!(name, Path::new("out/box-0008.png"));
    }
}
