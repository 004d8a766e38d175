//! The command `plan`: how many photon tests a scene's queries need, by the size of leaves, chains and batches.

use anyhow::{Result, anyhow};
use photoncube_render::{
    BatchOptions, Batches, Cost, Leaves, Lighting, QuantisedMap, cost, view_queries,
};
use photoncube_spec::{Numbers, find_photon_format};
use serde::Serialize;

use crate::args::PlanArgs;
use crate::stages::{trace_scene, view};
use crate::table::{grouped, markdown, significant};
use crate::{output, progress, scenes, sight};

#[derive(Serialize)]
struct Report {
    scene: String,
    format: String,
    seed: u64,
    photons: usize,
    photons_asked: u64,
    in_range: f64,
    query_points: usize,
    photons_in_range_mean: f64,
    engines: u32,
    cull: &'static str,
    facings: &'static str,
    schedules: Vec<Schedule>,
}

/// A schedule, with its cost.
#[derive(Serialize)]
struct Schedule {
    leaf_photons: u32,
    chain_engines: u32,
    chains: u32,
    #[serde(flatten)]
    cost: Cost,
    /// Photon tests for each photon in range.
    tests_per_photon_in_range: f64,
    /// The part of the engines that hold a query while photons are read.
    engines_with_query: f64,
    /// The part of the clocks in which photons are read.
    reading: f64,
    /// Queries of all chains for each clock.
    queries_per_clock: f64,
}

/// Plans a scene.
pub fn execute(args: &PlanArgs, json: bool) -> Result<()> {
    let format = find_photon_format(&args.format)?;
    let chains = chains(args);
    if let Some(longer) = chains.iter().find(|chain| **chain > args.engines) {
        return Err(anyhow!(
            "--chain {longer}: found a chain longer than the {} engines of the chip; give a shorter one, or more --engines",
            args.engines
        ));
    }
    let scene = scenes::load(&args.scene)?;
    let view = view(&args.picture);
    sight::check(&scene, &view)?;
    let traced = trace_scene(scene, &args.picture, &Lighting::default())?;
    let queries = view_queries(&traced.scene, &view)?;
    let map = QuantisedMap::new(traced.map(), &Numbers::Local(format))?;
    let found = map.gather_all(&queries, map.radius_sq());
    let found = found.map_err(|error| anyhow!("{error}: give a format with more photons (-n)"))?;
    let in_range: u64 = found.iter().map(|query| query.sums.count).sum();
    if in_range == 0 {
        return Err(anyhow!(
            "no query has a photon in range, expected one: give a larger --in-range"
        ));
    }
    let count = args.leaf.len() * chains.len();
    let bar = progress::bar("planning", count as u64);
    let mut schedules = Vec::with_capacity(count);
    for &engines_of_chain in &chains {
        let options = BatchOptions {
            queries: engines_of_chain,
            facings: args.facings,
        };
        let batches = Batches::new(&map, &queries, &options);
        for &leaf in &args.leaf {
            let cost = cost(&map, &Leaves::new(&map, leaf), &batches, args.cull);
            schedules.push(schedule(leaf, options, cost, args.engines, in_range));
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    let report = Report {
        scene: args.scene.to_string(),
        format: format.name(),
        seed: args.picture.seed,
        photons: traced.map().photons().len(),
        photons_asked: args.picture.photons,
        in_range: args.picture.in_range,
        query_points: queries.len(),
        photons_in_range_mean: in_range as f64 / queries.len() as f64,
        engines: args.engines,
        cull: args.cull.name(),
        facings: args.facings.name(),
        schedules,
    };
    output::print_tables(json, args.wide, &report, || text(&report))
}

/// The engines of chains, as given; else the usual ones, of which the chip has no longer ones than it has engines.
fn chains(args: &PlanArgs) -> Vec<u32> {
    if !args.chain.is_empty() {
        return args.chain.clone();
    }
    let usual = [8, 16, 64]
        .into_iter()
        .filter(|chain| *chain <= args.engines);
    let usual: Vec<_> = usual.collect();
    match usual.is_empty() {
        true => vec![args.engines],
        false => usual,
    }
}

fn schedule(leaf: u32, options: BatchOptions, cost: Cost, engines: u32, in_range: u64) -> Schedule {
    let chains = engines / options.queries;
    let held = cost.queries as f64 / (cost.batches * u64::from(options.queries)) as f64;
    Schedule {
        leaf_photons: leaf,
        chain_engines: options.queries,
        chains,
        tests_per_photon_in_range: cost.photon_tests as f64 / in_range as f64,
        engines_with_query: held,
        reading: cost.reading_clocks as f64 / cost.clocks as f64,
        queries_per_clock: f64::from(chains) * cost.queries as f64 / cost.clocks as f64,
        cost,
    }
}

fn text(report: &Report) -> String {
    let header = [
        "leaf",
        "engines a chain",
        "chains",
        "tests/in range",
        "with a query",
        "reading",
        "queries/clock",
    ];
    let percent = |part: f64| format!("{:.0} %", 100.0 * part);
    let row = |row: &Schedule| {
        vec![
            row.leaf_photons.to_string(),
            row.chain_engines.to_string(),
            row.chains.to_string(),
            significant(row.tests_per_photon_in_range, 3),
            percent(row.engines_with_query),
            percent(row.reading),
            significant(row.queries_per_clock, 3),
        ]
    };
    let rows: Vec<_> = report.schedules.iter().map(row).collect();
    format!(
        "{}: {} photons, {} queries, {:.0} photons in range of one; {} engines; format {}; culled by {}; facings by {}\n\n{}",
        report.scene,
        grouped(report.photons as u64),
        grouped(report.query_points as u64),
        report.photons_in_range_mean,
        report.engines,
        report.format,
        report.cull,
        report.facings,
        markdown(&header, &rows)
    )
}
