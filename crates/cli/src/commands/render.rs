//! The command `render`: a picture of a scene.

use std::time::Instant;

use anyhow::Result;
use photoncube_render::{BATCH_PATHS, DirectLight, Lighting, PhotonMap, ball_errors};
use serde::Serialize;

use crate::args::{EngineReport, LightingReport, RenderArgs};
use crate::core::CoreReport;
use crate::narrow::narrow;
use crate::outputs::{self, Output};
use crate::stages::{picture_lit, trace_for, view, write_picture};
use crate::{output, scenes, sight};

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
    /// The map leaves out photons that were traced.
    #[serde(skip)]
    left_out: bool,
    in_range: f64,
    photons_in_range_mean: f64,
    query_points: u64,
    estimates: u64,
    gathers_per_query: f64,
    photon_tests: u64,
    photons_skipped: u64,
    photons_without_power: u64,
    search_radius: f64,
    caustic_radius: Option<f64>,
    seed: u64,
    /// What is said of balls.
    #[serde(skip)]
    balls: String,
    seconds: f64,
    core: Option<CoreReport>,
}

/// Renders a scene to a file.
pub fn execute(args: &RenderArgs, json: bool) -> Result<()> {
    let chosen = args.engine.find()?;
    let engine = chosen.engine();
    args.estimator.check(engine)?;
    let scene = scenes::load(&args.scene)?;
    let lighting = args.light.lighting(&Lighting::default());
    lighting.check(&scene, &args.estimator)?;
    outputs::check(&[Output::picture("-o", &args.output)], scene.files())?;
    let view = view(&args.picture);
    sight::check(&scene, &view)?;
    let start = Instant::now();
    let traced = trace_for(scene, &args.picture, &lighting, engine)?;
    let rendering = picture_lit(
        &traced,
        engine,
        &lighting,
        &args.estimator,
        &view,
        "rendering",
    )?;
    sight::check_light(&rendering.image, &traced.scene, &view, rendering.stats)?;
    write_picture(&rendering.image, &args.output)?;
    let caustic = traced.maps.caustic.as_ref();
    let report = Report {
        scene: args.scene.to_string(),
        engine: EngineReport::of(engine),
        estimator: args.estimator.to_string(),
        light: LightingReport::of(&lighting),
        output: args.output.display().to_string(),
        photons: traced.maps.photons(),
        photons_asked: args.picture.photons,
        left_out: lighting.direct != DirectLight::Map,
        in_range: args.picture.in_range,
        photons_in_range_mean: rendering.stats.photons_in_range_mean(),
        query_points: rendering.stats.query_points,
        estimates: rendering.stats.estimates,
        gathers_per_query: rendering.stats.gathers_mean(),
        photon_tests: rendering.stats.photon_tests,
        photons_skipped: rendering.stats.photons_skipped,
        photons_without_power: rendering.stats.photons_without_power,
        search_radius: traced.map().radius(),
        caustic_radius: caustic.map(PhotonMap::radius),
        seed: args.picture.seed,
        balls: sight::balls(&ball_errors(
            &traced.scene,
            &lighting,
            traced.map().radius(),
        )),
        seconds: start.elapsed().as_secs_f64(),
        core: chosen.core_report(rendering.stats.estimates),
    };
    output::print(json, &report, || narrow(&text(&report)))
}

fn text(report: &Report) -> String {
    let left_out = match report.left_out {
        true => "; the map leaves out those of direct light",
        false => "",
    };
    format!(
        "{}: {} photons (at least {} traced, in whole batches of {BATCH_PATHS} paths{left_out}), {:.0} in range of \
         an estimate (the radius aims at {}); {} query points, {} estimates, {} photon tests ({} skipped by their place) in \
         {:.1} s; estimator {}, {:.1} gathers an estimate\n",
        report.output,
        report.photons,
        report.photons_asked,
        report.photons_in_range_mean,
        report.in_range,
        report.query_points,
        report.estimates,
        report.photon_tests,
        report.photons_skipped,
        report.seconds,
        report.estimator,
        report.gathers_per_query,
    ) + &sight::without_power(report.photons_without_power)
        + &report.balls
        + &report
            .core
            .as_ref()
            .map(CoreReport::text)
            .unwrap_or_default()
}
