//! The command `progressive`: a picture that improves pass by pass.

use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Result, ensure};
use photoncube_render::{
    ErrorEstimate, Estimator, Image, Progressive, ProgressiveOptions, Scene, ViewOptions,
    error_map, luminance,
};
use serde::Serialize;

use crate::args::{EngineReport, LightingReport, ProgressiveArgs, short};
use crate::core::CoreReport;
use crate::failure::CheckFailed;
use crate::interrupt::Interrupt;
use crate::outputs::{self, Output};
use crate::plots::{Curve, Reached, convergence_plot};
use crate::stages::{Distance, write_picture};
use crate::table::markdown;
use crate::{files, output, progress, scenes, sight};

/// The figures after some passes.
#[derive(Clone, Debug, Serialize)]
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
    alpha: f64,
    confidence: f64,
    error_target: Option<f64>,
    query_points: u64,
    photon_tests: u64,
    /// The files beside the picture: snapshots, plot, error map.
    files: Vec<String>,
    /// Whether a signal ended the run before its passes were made.
    interrupted: bool,
    progress: Vec<Row>,
    /// Student's quantile of the last pass; `None` after one pass.
    #[serde(skip)]
    quantile: Option<f64>,
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
    let lighting = args.light.lighting();
    lighting.check(&scene, &Estimator::FixedRadius)?;
    let (view, options) = (view(args), options(args));
    check_outputs(args, &scene)?;
    sight::check(&scene, &view)?;
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
    let mut work = Work {
        args,
        progressive,
        reference,
        start: Instant::now(),
        rows: Vec::new(),
        files: Vec::new(),
    };
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
        core: chosen.core_report(stats.estimates),
        light: LightingReport::of(&lighting),
        output: args.output.display().to_string(),
        seed: args.seed,
        alpha: args.alpha,
        confidence: args.confidence,
        error_target: args.error_target,
        query_points: stats.query_points,
        photon_tests: stats.photon_tests,
        files: work.files,
        interrupted: end == End::Interrupted,
        progress: work.rows,
        quantile: error.map(|error| error.quantile),
    };
    output::print(json, &report, || text(&report))?;
    let (output, all) = (&report.output, args.passes);
    match (end, args.error_target) {
        (End::Interrupted, _) => Err(CheckFailed(format!(
            "interrupted after {passes} of {all} passes; {output} is their mean"
        ))
        .into()),
        (End::Passes, Some(target)) => Err(CheckFailed(format!(
            "the error target {} is not reached in {all} passes: give more --passes",
            short(target)
        ))
        .into()),
        _ => Ok(()),
    }
}

/// Checks all files that may be written against all that are read.
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
    /// The rows after 1, 2, 4, 8, ... passes and after the last.
    rows: Vec<Row>,
    /// The files that were written.
    files: Vec<String>,
}

impl Work<'_> {
    /// Makes the passes, at least one.
    fn run(&mut self, interrupt: &Interrupt) -> Result<End> {
        let bar = progress::bar("passes", self.args.passes);
        let end = loop {
            self.progressive.pass()?;
            let passes = self.progressive.passes();
            bar.set_position(passes);
            let error = self.progressive.error(self.args.confidence);
            let end = self.end(error.as_ref(), interrupt);
            if passes.is_power_of_two() || end.is_some() {
                self.push_row(error.as_ref())?;
            }
            if let Some(end) = end {
                break end;
            }
        };
        bar.finish_and_clear();
        Ok(end)
    }

    fn end(&self, error: Option<&ErrorEstimate>, interrupt: &Interrupt) -> Option<End> {
        let below = |target| error.is_some_and(|error| error.bound() <= target);
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
            seconds: self.start.elapsed().as_secs_f64(),
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

/// A column of the table.
struct Column {
    name: &'static str,
    needs_reference: bool,
    of: fn(&Row) -> String,
}

const COLUMNS: [Column; 9] = [
    column("passes", |row| row.passes.to_string()),
    column("photons", |row| row.photons.to_string()),
    column("radius", |row| format!("{:.5}", row.search_radius)),
    column("noise", |row| percent(row.estimated_noise)),
    column("bias", |row| percent(row.estimated_bias)),
    column("bound", |row| percent(row.error_bound)),
    column("relMSE", |row| {
        row.rel_mse.map_or("-".to_owned(), |e| format!("{e:.2e}"))
    })
    .against_reference(),
    column("in bounds", |row| percent(row.bounded_share)).against_reference(),
    column("seconds", |row| format!("{:.1}", row.seconds)),
];

const fn column(name: &'static str, of: fn(&Row) -> String) -> Column {
    Column {
        name,
        needs_reference: false,
        of,
    }
}

impl Column {
    const fn against_reference(self) -> Self {
        Self {
            needs_reference: true,
            ..self
        }
    }
}

fn percent(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |value| format!("{:.2} %", 100.0 * value))
}

fn text(report: &Report) -> String {
    let has_reference = report.progress.iter().any(|row| row.rel_mse.is_some());
    let columns = COLUMNS.iter();
    let columns: Vec<_> = columns
        .filter(|column| has_reference || !column.needs_reference)
        .collect();
    let header: Vec<_> = columns.iter().map(|column| column.name).collect();
    let cells = |row: &Row| columns.iter().map(|column| (column.of)(row)).collect();
    let table = markdown(
        &header,
        &report.progress.iter().map(cells).collect::<Vec<_>>(),
    );
    let mut text = format!("{table}{}\n{}\n", bound_line(report), report.output);
    text.extend(report.files.iter().map(|file| format!("{file}\n")));
    text
}

/// A line that states why the bound is larger than noise and bias together.
fn bound_line(report: &Report) -> String {
    let confidence = 100.0 * report.confidence;
    let Some(quantile) = report.quantile else {
        return "One pass tells nothing of its error.\n".to_owned();
    };
    format!(
        "noise, bias, bound: root mean squares over the pixels, each as a part of the pixel's luminance.\n\
         A pixel's error is not above its bound, with {confidence:.0} % confidence. Its bound is |bias| + t s / sqrt n, with\n\
         n the passes, t = {quantile:.2} Student's factor for them, and s the spread over the passes of the pixel less its\n\
         bias, which is sqrt 5 times that of the pixel where light is even. The bias of one pixel is noisy. The column\n\
         `bias` is without that noise, so `bound` is more than `bias` and t times `noise` together.\n"
    )
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::args::{Args, Command};

    #[test]
    fn snapshots_are_named_by_their_passes() {
        let name = snapshot(Path::new("out/box.png"), 8);
        assert_eq!(name, Path::new("out/box-0008.png"));
    }

    fn report(rel_mse: Option<f64>) -> Report {
        let row = Row {
            passes: 2,
            photons: 10,
            search_radius: 0.1,
            error_bound: Some(0.2),
            estimated_bias: Some(0.05),
            estimated_noise: Some(0.05),
            rel_mse,
            bounded_share: rel_mse,
            seconds: 1.0,
        };
        let args = ["photoncube", "progressive", "cornell", "-o", "o.png"];
        let Command::Progressive(args) = Args::parse_from(args).command else {
            unreachable!("that is the command");
        };
        let light = LightingReport::of(&args.light.lighting());
        Report {
            scene: "cornell".to_owned(),
            engine: EngineReport::of(args.engine.find().unwrap().engine()),
            core: None,
            light,
            output: "o.png".to_owned(),
            seed: 1,
            alpha: 0.5,
            confidence: 0.9,
            error_target: None,
            query_points: 1,
            photon_tests: 1,
            files: vec!["plot.svg".to_owned()],
            interrupted: false,
            progress: vec![row],
            quantile: Some(6.31),
        }
    }

    #[test]
    fn columns_of_a_reference_are_there_with_one_and_the_bound_is_explained() {
        let without = text(&report(None));
        assert!(
            !without.contains("relMSE") && !without.contains("in bounds"),
            "{without}"
        );
        assert!(
            without.contains("t = 6.31 Student's")
                && without.contains("bound is |bias| + t s / sqrt n")
                && without.contains("90 % confidence"),
            "{without}"
        );
        assert!(without.ends_with("o.png\nplot.svg\n"), "{without}");
        let with = text(&report(Some(0.01)));
        assert!(
            with.contains("relMSE") && with.contains("in bounds"),
            "{with}"
        );
    }
}
