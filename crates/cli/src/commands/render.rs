//! The command `render`: a picture of a scene.

use std::path::Path;
use std::time::Instant;

use anyhow::Result;
use photoncube_render::{
    BATCH_PATHS, Engine, Estimator, Image, Light, Lighting, PhotonMap, PhotonMaps, Radii,
    Rendering, Scene, TraceOptions, ViewOptions, render_lit, trace,
};
use serde::Serialize;

use crate::args::{EngineReport, LightingReport, PictureArgs, RenderArgs};
use crate::outputs::{self, Output};
use crate::{files, output, progress, scenes, sight};

/// The exposure of written pictures: radiance 1 is white.
const EXPOSURE: f64 = 1.0;

#[derive(Serialize)]
struct Report {
    scene: String,
    #[serde(flatten)]
    engine: EngineReport,
    estimator: String,
    #[serde(flatten)]
    light: LightingReport,
    output: String,
    photons: usize,
    photons_asked: u64,
    in_range: f64,
    photons_in_range_mean: f64,
    query_points: u64,
    gathers_per_query: f64,
    photon_tests: u64,
    photons_skipped: u64,
    search_radius: f64,
    caustic_radius: Option<f64>,
    seed: u64,
    seconds: f64,
}

/// A scene with its photon maps.
pub struct Traced {
    /// The scene that was traced.
    pub scene: Scene,
    /// The photon maps.
    pub maps: PhotonMaps,
    /// The number of paths that were emitted for the maps.
    pub paths: u64,
}

impl Traced {
    /// The map of all light, or of all light but that of the caustics' map.
    pub fn map(&self) -> &PhotonMap {
        &self.maps.global
    }
}

/// Stages 2 and 3: traces the photons and makes the maps that the lighting needs.
pub fn trace_scene(scene: Scene, picture: &PictureArgs, lighting: &Lighting) -> Result<Traced> {
    let options = TraceOptions {
        photons: picture.photons,
        seed: picture.seed,
    };
    let bar = progress::bar("tracing photons", picture.photons);
    let traced = trace(&scene, &options, &|stored| bar.set_position(stored))?;
    bar.finish_and_clear();
    let paths = traced.paths;
    let radii = Radii::of(&scene, &traced, lighting, picture.in_range);
    let maps = PhotonMaps::new(&scene, traced, lighting, radii)?;
    Ok(Traced { scene, maps, paths })
}

/// The view of the picture's options.
pub fn view(picture: &PictureArgs) -> ViewOptions {
    ViewOptions {
        width: picture.size.width,
        height: picture.size.height,
        samples_per_axis: picture.samples,
        seed: picture.seed,
    }
}

/// Stages 4 to 6 without writing: view rays, estimates, image. The search radius is fixed and all light comes
/// from the map.
pub fn picture(
    traced: &Traced,
    engine: Engine<'_>,
    view: &ViewOptions,
    what: &'static str,
) -> Result<Rendering> {
    let (lighting, estimator) = (Lighting::default(), Estimator::FixedRadius);
    picture_lit(traced, engine, &lighting, estimator, view, what)
}

fn picture_lit(
    traced: &Traced,
    engine: Engine<'_>,
    lighting: &Lighting,
    estimator: Estimator,
    view: &ViewOptions,
    what: &'static str,
) -> Result<Rendering> {
    let pixels = u64::from(view.width) * u64::from(view.height);
    let bar = progress::bar(what, pixels);
    let light = Light {
        lighting,
        global: &traced.maps.global,
        caustic: traced.maps.caustic.as_ref(),
        estimator,
    };
    let progress = |done| bar.set_position(done);
    let rendering = render_lit(&traced.scene, light, engine, view, &progress)?;
    bar.finish_and_clear();
    Ok(rendering)
}

/// Renders a scene to a file.
pub fn execute(args: &RenderArgs, json: bool) -> Result<()> {
    let found = args.engine.find()?;
    let engine = found.engine();
    args.estimator.check(engine)?;
    let scene = scenes::load(&args.scene)?;
    let lighting = args.light.lighting();
    lighting.check(&scene, args.estimator)?;
    outputs::check(&[Output::picture("-o", &args.output)], scene.files())?;
    let view = view(&args.picture);
    sight::check(&scene, &view)?;
    let start = Instant::now();
    let traced = trace_scene(scene, &args.picture, &lighting)?;
    let rendering = picture_lit(
        &traced,
        engine,
        &lighting,
        args.estimator,
        &view,
        "rendering",
    )?;
    sight::check_light(&rendering.image, &traced.scene, &view, rendering.stats)?;
    write_picture(&rendering.image, &args.output)?;
    let caustic = traced.maps.caustic.as_ref();
    let report = Report {
        scene: args.scene.to_string(),
        engine: found.report(),
        estimator: args.estimator.to_string(),
        light: LightingReport::of(&lighting),
        output: args.output.display().to_string(),
        photons: traced.maps.photons(),
        photons_asked: args.picture.photons,
        in_range: args.picture.in_range,
        photons_in_range_mean: mean(rendering.stats.photons_in_range, rendering.stats.gathers),
        query_points: rendering.stats.query_points,
        gathers_per_query: mean(rendering.stats.gathers, rendering.stats.query_points),
        photon_tests: rendering.stats.photon_tests,
        photons_skipped: rendering.stats.photons_skipped,
        search_radius: traced.map().radius(),
        caustic_radius: caustic.map(PhotonMap::radius),
        seed: args.picture.seed,
        seconds: start.elapsed().as_secs_f64(),
    };
    output::print(json, &report, || text(&report))
}

/// Writes a picture in the format of its name's ending.
pub fn write_picture(image: &Image, path: &Path) -> Result<()> {
    files::write(path, &image.encode(path, EXPOSURE)?)
}

/// The mean; 0 where nothing was counted, as in a view without surfaces.
fn mean(total: u64, count: u64) -> f64 {
    total as f64 / count.max(1) as f64
}

fn text(report: &Report) -> String {
    format!(
        "{}: {} photons (at least {} asked for; batches of {BATCH_PATHS} paths are completed), {:.0} in range of a gather \
         ({} aimed at),\n{} query points, {} photon tests ({} skipped by their place) in {:.1} s; \
         estimator {}, {:.1} gathers a query\n",
        report.output,
        report.photons,
        report.photons_asked,
        report.photons_in_range_mean,
        report.in_range,
        report.query_points,
        report.photon_tests,
        report.photons_skipped,
        report.seconds,
        report.estimator,
        report.gathers_per_query,
    )
}
