//! `progressive`: a picture that gets better pass by pass.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Result, ensure};
use photoncube_render::{
    ErrorEstimate, Estimator, Image, Progressive, ProgressiveOptions, Scene, ViewOptions,
    error_map, luminance,
};
use serde::Serialize;

use super::compare::Distance;
use super::render::write_picture;
use crate::args::{EngineReport, LightingReport, ProgressiveArgs};
use crate::convergence::{Curve, Reached, convergence_plot};
use crate::failure::CheckFailed;
use crate::outputs::{self, Output};
use crate::table::markdown;
use crate::{files, output, progress, scenes};

/// What is known after some passes.
#[derive(Clone, Debug, Serialize)]
struct Row {
    passes: u64,
    photons: u64,
    search_radius: f64,
    /// None after one pass, which tells nothing of its error.
    error_bound: Option<f64>,
    estimated_bias: Option<f64>,
    estimated_noise: Option<f64>,
    /// Against the reference, if one is given.
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
    #[serde(flatten)]
    light: LightingReport,
    output: String,
    seed: u64,
    alpha: f64,
    confidence: f64,
    error_target: Option<f64>,
    query_points: u64,
    photon_tests: u64,
    progress: Vec<Row>,
}

/// Renders until the error is as small as asked for, or the passes are made.
pub fn execute(args: &ProgressiveArgs, json: bool) -> Result<()> {
    let found = args.engine.find()?;
    let scene = scenes::load(&args.scene)?;
    let lighting = args.light.lighting();
    lighting.check(&scene, Estimator::FixedRadius)?;
    let (view, options) = (view(args), options(args));
    check_outputs(args, &scene)?;
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
    let progressive = Progressive::new(&scene, found.engine(), lighting, view, options)?;
    let mut work = Work {
        args,
        progressive,
        reference,
        start: Instant::now(),
        rows: Vec::new(),
    };
    let reached = work.run()?;
    write_picture(&work.progressive.image(), &args.output)?;
    work.write_plot()?;
    work.write_error_map()?;
    let stats = work.progressive.stats();
    let report = Report {
        scene: args.scene.clone(),
        engine: found.report(),
        light: LightingReport::of(&lighting),
        output: args.output.display().to_string(),
        seed: args.seed,
        alpha: args.alpha,
        confidence: args.confidence,
        error_target: args.error_target,
        query_points: stats.query_points,
        photon_tests: stats.photon_tests,
        progress: work.rows,
    };
    output::print(json, &report, || text(&report))?;
    match args.error_target {
        Some(target) if !reached => Err(CheckFailed(format!(
            "the error target {target} is not reached in {} passes: give more --passes",
            args.passes
        ))
        .into()),
        _ => Ok(()),
    }
}

/// All that may be written, against all that is read.
fn check_outputs(args: &ProgressiveArgs, scene: &Scene) -> Result<()> {
    let mut outputs = vec![Output::picture("-o", &args.output)];
    outputs.extend(args.plot.iter().map(|path| Output::plot("--plot", path)));
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

fn view(args: &ProgressiveArgs) -> ViewOptions {
    ViewOptions {
        width: args.size.width,
        height: args.size.height,
        samples_per_axis: args.samples,
        seed: args.seed,
    }
}

fn options(args: &ProgressiveArgs) -> ProgressiveOptions {
    ProgressiveOptions {
        photons: args.photons,
        in_range: args.in_range,
        alpha: args.alpha,
        seed: args.seed,
    }
}

struct Work<'a> {
    args: &'a ProgressiveArgs,
    progressive: Progressive<'a>,
    reference: Option<Image>,
    start: Instant,
    /// After 1, 2, 4, 8, ... passes and after the last.
    rows: Vec<Row>,
}

impl Work<'_> {
    /// Makes the passes; whether the target is reached, which it is not where there is none.
    fn run(&mut self) -> Result<bool> {
        let bar = progress::bar("passes", self.args.passes);
        let mut reached = false;
        while !reached && self.progressive.passes() < self.args.passes {
            self.progressive.pass()?;
            let passes = self.progressive.passes();
            bar.set_position(passes);
            let error = self.progressive.error(self.args.confidence);
            let below = |target| error.as_ref().is_some_and(|e| e.bound() <= target);
            reached = self.args.error_target.is_some_and(below);
            if passes.is_power_of_two() || reached || passes == self.args.passes {
                self.push_row(error.as_ref())?;
            }
        }
        bar.finish_and_clear();
        Ok(reached)
    }

    fn push_row(&mut self, error: Option<&ErrorEstimate>) -> Result<()> {
        let (passes, image) = (self.progressive.passes(), self.progressive.image());
        if self.args.snapshots {
            write_picture(&image, &snapshot(&self.args.output, passes))?;
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
            seconds: self.start.elapsed().as_secs_f64(),
        });
        Ok(())
    }

    fn write_plot(&self) -> Result<()> {
        let Some(path) = &self.args.plot else {
            return Ok(());
        };
        let curve = |name, of: fn(&Row) -> Option<f64>| Curve {
            name,
            points: self
                .rows
                .iter()
                .filter_map(|row| Some(row.reached(of(row)?)))
                // A logarithm of 0 has no place.
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
        let title = format!("{}: error against passes and photons", self.args.scene);
        files::write(path, convergence_plot(&title, &curves)?.as_bytes())
    }

    fn write_error_map(&self) -> Result<()> {
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
            "bound of the relative error, {:.0} % confidence: {}",
            100.0 * error.confidence,
            self.args.scene
        );
        files::write(
            path,
            error_map(&title, self.args.size.width, &bounds).as_bytes(),
        )
    }
}

/// `box.png` after 8 passes is `box-0008.png`.
fn snapshot(output: &Path, passes: u64) -> PathBuf {
    let stem = output.file_stem().unwrap_or_default().to_string_lossy();
    let ending = output.extension().unwrap_or_default().to_string_lossy();
    output.with_file_name(format!("{stem}-{passes:04}.{ending}"))
}

fn text(report: &Report) -> String {
    let percent = |value: Option<f64>| match value {
        Some(value) => format!("{:.2} %", 100.0 * value),
        None => "-".to_owned(),
    };
    let rows = report.progress.iter().map(|row| {
        vec![
            row.passes.to_string(),
            row.photons.to_string(),
            format!("{:.5}", row.search_radius),
            percent(row.estimated_noise),
            percent(row.estimated_bias),
            percent(row.error_bound),
            row.rel_mse.map_or("-".to_owned(), |e| format!("{e:.2e}")),
            percent(row.bounded_share),
            format!("{:.1}", row.seconds),
        ]
    });
    let header = [
        "passes",
        "photons",
        "radius",
        "noise",
        "bias",
        "bound",
        "relMSE",
        "in bounds",
        "seconds",
    ];
    let table = markdown(&header, &rows.collect::<Vec<_>>());
    format!(
        "{table}\n{}: bounds hold for a pixel with {:.0} % confidence\n",
        report.output,
        100.0 * report.confidence
    )
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
