//! `render`: a picture of a scene.

use std::path::Path;
use std::time::Instant;

use anyhow::Result;
use photoncube_render::{
    Engine, Estimator, PhotonMap, Rendering, Scene, TraceOptions, ViewOptions, render_with, trace,
};
use photoncube_spec::{Machine, find_photon_format};
use serde::Serialize;

use crate::args::{EngineName, PictureArgs, RenderArgs};
use crate::{files, output, progress, scenes};

/// The exposure of written pictures: radiance 1 is white.
pub const EXPOSURE: f64 = 1.0;

#[derive(Serialize)]
struct Report {
    scene: String,
    engine: &'static str,
    machine: Option<&'static str>,
    format: Option<String>,
    estimator: String,
    output: String,
    photons: usize,
    query_points: u64,
    gathers_per_query: f64,
    photon_tests: u64,
    photons_skipped: u64,
    search_radius: f64,
    seed: u64,
    seconds: f64,
}

/// A scene with its photons in blocks.
pub struct Traced {
    /// The scene.
    pub scene: Scene,
    /// The photon map.
    pub map: PhotonMap,
    /// Paths that were emitted for it.
    pub paths: u64,
}

/// Stages 1 to 3: the scene, its photons, the photon map.
pub fn trace_scene(name: &str, picture: &PictureArgs) -> Result<Traced> {
    let scene = scenes::load(name)?;
    let options = TraceOptions {
        photons: picture.photons,
        seed: picture.seed,
    };
    let bar = progress::bar("tracing photons", picture.photons);
    let traced = trace(&scene, &options, &|stored| bar.set_position(stored))?;
    bar.finish_and_clear();
    let stored = traced.photons.len() as u64;
    let radius = PhotonMap::radius_for(&scene, stored, picture.in_range);
    let map = PhotonMap::new(&scene, traced.photons, radius)?;
    Ok(Traced {
        scene,
        map,
        paths: traced.paths,
    })
}

/// The view that the picture's options ask for.
pub fn view(picture: &PictureArgs) -> ViewOptions {
    ViewOptions {
        width: picture.size.width,
        height: picture.size.height,
        samples_per_axis: picture.samples,
        seed: picture.seed,
    }
}

/// Stages 4 to 6 with the fixed search radius, without writing: view rays, estimates, the image.
pub fn picture(
    traced: &Traced,
    engine: Engine<'_>,
    view: &ViewOptions,
    what: &'static str,
) -> Result<Rendering> {
    picture_with(traced, engine, Estimator::FixedRadius, view, what)
}

fn picture_with(
    traced: &Traced,
    engine: Engine<'_>,
    estimator: Estimator,
    view: &ViewOptions,
    what: &'static str,
) -> Result<Rendering> {
    let pixels = u64::from(view.width) * u64::from(view.height);
    let bar = progress::bar(what, pixels);
    let progress = |done| bar.set_position(done);
    let (scene, map) = (&traced.scene, &traced.map);
    let rendering = render_with(scene, map, engine, estimator, view, &progress)?;
    bar.finish_and_clear();
    Ok(rendering)
}

/// Renders a scene to a PNG file.
pub fn execute(args: &RenderArgs, json: bool) -> Result<()> {
    let machine: &'static Machine = args.machine.find()?;
    let format = &find_photon_format(&args.format)?;
    let engine = match args.engine {
        EngineName::F64 => Engine::F64,
        EngineName::Model => Engine::Model(machine),
        EngineName::Format => Engine::Format(format),
    };
    args.estimator.check(engine)?;
    // Before the work, so that a folder that cannot be written is told at once.
    files::make_folder(args.output.parent().unwrap_or(Path::new(".")))?;
    let start = Instant::now();
    let traced = trace_scene(&args.scene, &args.picture)?;
    let view = view(&args.picture);
    let rendering = picture_with(&traced, engine, args.estimator, &view, "rendering")?;
    rendering.image.write_png(&args.output, EXPOSURE)?;
    let (engine, machine, format) = match args.engine {
        EngineName::F64 => ("f64", None, None),
        EngineName::Model => ("model", Some(machine.name), None),
        EngineName::Format => ("format", None, Some(format.name())),
    };
    let report = Report {
        scene: args.scene.clone(),
        engine,
        machine,
        format,
        estimator: args.estimator.to_string(),
        output: args.output.display().to_string(),
        photons: traced.map.photons().len(),
        query_points: rendering.stats.query_points,
        gathers_per_query: mean(rendering.stats.gathers, rendering.stats.query_points),
        photon_tests: rendering.stats.photon_tests,
        photons_skipped: rendering.stats.photons_skipped,
        search_radius: traced.map.radius(),
        seed: args.picture.seed,
        seconds: start.elapsed().as_secs_f64(),
    };
    output::print(json, &report, || text(&report))
}

/// 0 where nothing was counted, as in a view of nothing.
fn mean(total: u64, count: u64) -> f64 {
    total as f64 / count.max(1) as f64
}

fn text(report: &Report) -> String {
    format!(
        "{}: {} photons, {} query points, {} photon tests ({} skipped by their place) in {:.1} s; \
         estimator {}, {:.1} gathers a query\n",
        report.output,
        report.photons,
        report.query_points,
        report.photon_tests,
        report.photons_skipped,
        report.seconds,
        report.estimator,
        report.gathers_per_query,
    )
}
