//! `report --sweep`: all formats, machines and cores on several scenes, for several radii. Each is a job that can be shared out.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use anyhow::{Context, Result};
use photoncube_render::{Engine, ErrorBench, QueryPoint, Scene, view_queries};
use photoncube_spec::{MACHINES, PHOTON_FORMATS};
use serde::{Deserialize, Serialize};

use super::row::{self, Row};
use super::verdict::{Candidate, Verdict};
use super::{options, picture_view};
use crate::args::ReportArgs;
use crate::cores::{self, MeasuredCore};
use crate::hardware::digits;
use crate::outputs::{self, Output};
use crate::shards::{Header, Ledger, Settings, Shard};
use crate::{files, output, progress, scenes, sight, table};

/// The error of a format, a machine or a core on a scene, for a radius.
#[derive(Clone, Serialize, Deserialize)]
struct Point {
    scene: String,
    in_range: f64,
    name: String,
    /// `format`, `machine` or `core`.
    kind: String,
    format: Option<String>,
    bits_per_photon: u32,
    /// The reason why it cannot represent the scene; `None` where it can.
    cannot: Option<String>,
    within_bound: bool,
    error_over_noise: Option<f64>,
    error_over_noise_low: Option<f64>,
    error_over_noise_high: Option<f64>,
    noise_relative: Option<f64>,
    lut4_equivalents: Option<u64>,
    pictures_per_second: Option<f64>,
}

/// What a scene needs for a radius.
#[derive(Serialize)]
struct Need {
    scene: String,
    in_range: f64,
    #[serde(flatten)]
    verdict: Verdict,
}

#[derive(Serialize)]
struct Report {
    noise_ratio: f64,
    maps: u64,
    photons: u64,
    seed: u64,
    shard: String,
    /// The jobs of all shards.
    jobs: u64,
    /// Empty with --shard.
    needs: Vec<Need>,
    points: Vec<Point>,
    /// The file with this data; `None` with --shard.
    data: Option<String>,
}

/// A row to measure.
enum Subject<'a> {
    Engine(Engine<'a>),
    Core(&'a MeasuredCore),
}

/// The maps of a scene for a radius, and the queries of the picture.
struct Bench {
    bench: ErrorBench,
    picture: Vec<QueryPoint>,
}

/// The jobs of a sweep. Successive jobs are of successive pairs of a scene and a radius, so that a shard has the rows of few pairs where the
/// number of shards and that of pairs have a common factor: it traces the maps of its pairs alone.
struct Sweep<'a> {
    args: &'a ReportArgs,
    scenes: Vec<Scene>,
    /// Each with its name.
    subjects: Vec<(String, Subject<'a>)>,
    /// The maps of the last job, and the number of its pair. Jobs are done pair by pair.
    last: Mutex<Option<(usize, Arc<Bench>)>>,
}

/// Measures what the state of the shard lacks.
pub fn execute(args: &ReportArgs, json: bool) -> Result<()> {
    let shard = args.shard.shard.unwrap_or(Shard::WHOLE);
    let data = args.out.join("sweep.json");
    let loaded = args.scenes.iter().map(scenes::load);
    let loaded = loaded.collect::<Result<Vec<_>>>()?;
    check(args, &data, &loaded)?;
    let cores = cores::measured()?;
    let sweep = Sweep {
        args,
        scenes: loaded,
        subjects: subjects(&cores),
        last: Mutex::new(None),
    };
    let jobs = (sweep.pairs() * sweep.subjects.len()) as u64;
    let header = Header::new("report --sweep", sweep.settings(), Some(jobs), shard);
    let ledger = Ledger::open(args.shard.state.as_deref(), header)?;
    let bar = progress::bar("rows", 0);
    // A measurement takes all cores, so there is one at a time.
    let pair = |job: &u64| *job % sweep.pairs() as u64;
    let points = ledger.work(1, &bar, pair, |job| sweep.measure(job as usize))?;
    let mut points: Vec<_> = points.into_iter().collect();
    points.sort_by_key(|(job, _)| pair(job));
    let points: Vec<_> = points.into_iter().map(|(_, point)| point).collect();
    let is_whole = args.shard.shard.is_none();
    let report = Report {
        noise_ratio: args.noise_ratio,
        maps: args.maps,
        photons: args.photons,
        seed: args.seed,
        shard: shard.to_string(),
        jobs,
        needs: match is_whole {
            true => needs(&points),
            false => Vec::new(),
        },
        data: is_whole.then(|| data.display().to_string()),
        points,
    };
    if is_whole {
        let text = serde_json::to_string_pretty(&report)? + "\n";
        files::write(&data, text.as_bytes())?;
    }
    output::print_tables(json, args.wide, &report, || text(&report))
}

fn check(args: &ReportArgs, data: &std::path::Path, scenes: &[Scene]) -> Result<()> {
    let state = args.shard.state.iter();
    let state = state.map(|path| Output::within("--state", path.clone()));
    let outputs: Vec<_> = state
        .chain([Output::within("--out", data.to_owned())])
        .collect();
    let inputs: Vec<PathBuf> = scenes.iter().flat_map(Scene::files).cloned().collect();
    outputs::check(&outputs, &inputs)?;
    let view = options(args, args.in_range[0]).view;
    scenes
        .iter()
        .try_for_each(|scene| sight::check(scene, &view))
}

/// The rows of each pair of a scene and a radius, with their names.
fn subjects(cores: &[MeasuredCore]) -> Vec<(String, Subject<'_>)> {
    let formats = PHOTON_FORMATS.iter();
    let formats = formats.map(|of| (of.name(), Subject::Engine(of.into())));
    let machines = MACHINES.iter();
    let machines = machines.map(|of| (of.name.to_owned(), Subject::Engine(of.into())));
    let cores = cores.iter().map(|of| (of.core.name(), Subject::Core(of)));
    formats.chain(machines).chain(cores).collect()
}

impl Sweep<'_> {
    /// The number of pairs of a scene and a radius.
    fn pairs(&self) -> usize {
        self.scenes.len() * self.args.in_range.len()
    }

    /// What other workers must have in common.
    fn settings(&self) -> Settings {
        let list = |items: Vec<String>| items.join(", ");
        let args = self.args;
        let own = [
            (
                "scenes",
                list(args.scenes.iter().map(ToString::to_string).collect()),
            ),
            (
                "scenes, their SHA-256",
                list(self.scenes.iter().map(Scene::sha256).collect()),
            ),
            (
                "--in-range",
                list(args.in_range.iter().map(f64::to_string).collect()),
            ),
            (
                "rows",
                list(self.subjects.iter().map(|(name, _)| name.clone()).collect()),
            ),
            ("--photons", args.photons.to_string()),
            ("--maps", args.maps.to_string()),
            ("--noise-ratio", args.noise_ratio.to_string()),
            ("--size", args.size.to_string()),
            ("--picture-size", args.picture_size.to_string()),
            ("--seed", args.seed.to_string()),
        ];
        own.map(|(name, value)| (name.to_owned(), value)).into()
    }

    /// The row of a job.
    fn measure(&self, job: usize) -> Result<Point> {
        let (subject, number) = (job / self.pairs(), job % self.pairs());
        let radii = &self.args.in_range;
        let (scene, in_range) = (number / radii.len(), radii[number % radii.len()]);
        let name = self.args.scenes[scene].to_string();
        let said = || format!("{name}, {in_range} in range");
        let bench = self
            .bench(number, &self.scenes[scene], in_range)
            .with_context(said)?;
        let bound = self.args.noise_ratio;
        let row = match &self.subjects[subject].1 {
            Subject::Engine(engine) => row::row(&bench.bench, *engine, bound, &bench.picture),
            Subject::Core(core) => row::core_row(&bench.bench, core, bound, &bench.picture),
        };
        Ok(Point::of(name.clone(), in_range, &row.with_context(said)?))
    }

    fn bench(&self, number: usize, scene: &Scene, in_range: f64) -> Result<Arc<Bench>> {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((of, bench)) = &*last
            && *of == number
        {
            return Ok(bench.clone());
        }
        let options = options(self.args, in_range);
        let bench = ErrorBench::new(scene, &options)?;
        // This measurement has no error of its own: if it fails, the scene is the cause and not a format.
        let found = bench.measure(Engine::F64).map_err(Into::into);
        sight::explained(found, scene, &options.view)?;
        let picture = view_queries(scene, &picture_view(self.args))?;
        let bench = Arc::new(Bench { bench, picture });
        *last = Some((number, bench.clone()));
        Ok(bench)
    }
}

impl Point {
    fn of(scene: String, in_range: f64, row: &Row) -> Self {
        let measured = row.measurement;
        Self {
            scene,
            in_range,
            name: row.name.clone(),
            kind: row.kind.to_owned(),
            format: row.format.clone(),
            bits_per_photon: row.bits_per_photon,
            cannot: row.cannot.clone(),
            within_bound: row.within_bound,
            error_over_noise: measured.map(|m| m.error_over_noise),
            error_over_noise_low: measured.map(|m| m.error_over_noise_low),
            error_over_noise_high: measured.map(|m| m.error_over_noise_high),
            noise_relative: measured.map(|m| m.noise_relative),
            lut4_equivalents: row.lut4_equivalents(),
            pictures_per_second: row.pictures_per_second(),
        }
    }

    fn candidate(&self) -> Candidate<'_> {
        Candidate {
            name: &self.name,
            format: self.format.as_deref(),
            bits_per_photon: self.bits_per_photon,
            is_format: self.kind == "format",
            within_bound: self.within_bound,
            lut4_equivalents: self.lut4_equivalents,
            pictures_per_second: self.pictures_per_second,
        }
    }
}

/// What each scene needs for each radius, in the order of the points.
fn needs(points: &[Point]) -> Vec<Need> {
    let same = |a: &Point, b: &Point| a.scene == b.scene && a.in_range == b.in_range;
    let need = |points: &[Point]| Need {
        scene: points[0].scene.clone(),
        in_range: points[0].in_range,
        verdict: Verdict::of(points.iter().map(Point::candidate)),
    };
    points.chunk_by(same).map(need).collect()
}

fn text(report: &Report) -> String {
    let Some(data) = &report.data else {
        let (done, all) = (report.points.len(), report.jobs);
        return format!(
            "shard {}: {done} rows of {all}; `photoncube merge` puts the shards together\n",
            report.shard
        );
    };
    let header = [
        "scene",
        "in range",
        "bits/photon",
        "format",
        "smallest machine",
        "fastest machine",
        "pictures/s",
    ];
    let or_none = |text: &Option<String>| text.clone().unwrap_or_else(|| "none".to_owned());
    let cells = |need: &Need| {
        let verdict = &need.verdict;
        let bits = verdict.bits_per_photon;
        vec![
            need.scene.clone(),
            need.in_range.to_string(),
            bits.map_or("-".to_owned(), |bits| bits.to_string()),
            or_none(&verdict.format),
            or_none(&verdict.smallest_machine),
            or_none(&verdict.fastest_machine),
            verdict.pictures_per_second.map_or("-".to_owned(), digits),
        ]
    };
    format!(
        "{}\n{} rows, {} of them within {} of the noise; {data} has all\n",
        table::markdown(&header, &report.needs.iter().map(cells).collect::<Vec<_>>()),
        report.points.len(),
        report
            .points
            .iter()
            .filter(|point| point.within_bound)
            .count(),
        report.noise_ratio,
    )
}
