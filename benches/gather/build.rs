//! Measures tracing, the photon map and the planes, beside what the peers build: `scripts/bench.sh build`.
//!
//! Each number of photons and of threads has a process of its own, so that the most memory that was allocated is that of this row.

use std::process::Command;
use std::time::Instant;

use photoncube_model::Instructions;
use photoncube_render::{
    Engine, Lighting, PhotonMaps, PhotonTrace, QuantisedMap, QueryPoint, Radii, Scene,
    StoredPhoton, TraceOptions, ViewOptions, trace, view_queries,
};
use rayon::ThreadPoolBuilder;

use crate::contest::{Contestant, FixedPoint, PEERS};
use crate::{ALLOCATOR, THREADS, format};

/// The argument before the photons and the threads of one row's process.
const ROW: &str = "row";

/// The numbers of photons, if none are given.
const PHOTONS: [&str; 3] = ["1e5", "1e6", "1e7"];

/// The photons that all rounds of a row trace at the least, and the most rounds. Few photons take milliseconds.
const TRACED: u64 = 3_000_000;
const MOST_ROUNDS: u64 = 5;

/// The photons that a query has in range on average over the scene.
const IN_RANGE: f64 = 200.0;

/// The picture of whose view rays the queries are: four of each pixel, 2^20 but for rays that meet nothing.
const VIEW: ViewOptions = ViewOptions {
    width: 512,
    height: 512,
    samples_per_axis: 2,
    seed: 1,
};

/// Prints a table; or, in the process of one number of photons and of threads, their rows.
pub fn measure(arguments: &[String]) {
    // Cargo adds options of its own.
    let values = arguments.iter().map(String::as_str);
    let mut values: Vec<_> = values.filter(|value| !value.starts_with("--")).collect();
    if let [ROW, photons, threads] = values[..] {
        let threads = threads.parse().expect("a number of threads");
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads").install(|| rows(photons, threads));
        return;
    }
    if values.is_empty() {
        values.extend(PHOTONS);
    }
    println!(
        "| photons | threads | gather | trace s | sort s | planes or index s | M photons/s from trace | peak bytes a photon \
         | gather s | in range | build and gather s |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    );
    let program = std::env::current_exe().expect("this program");
    for (photons, threads) in values
        .iter()
        .flat_map(|v| THREADS.map(|threads| (*v, threads)))
    {
        let arguments = [crate::BUILD, ROW, photons, &threads.to_string()];
        let ended = Command::new(&program).args(arguments).status();
        assert!(ended.expect("this program runs").success(), "{photons}");
    }
}

/// Prints the rows of one number of photons and of threads: the medians of some rounds.
fn rows(asked: &str, threads: usize) {
    let setting = Setting::new(asked);
    let rounds = (TRACED / setting.options.photons).clamp(1, MOST_ROUNDS);
    let before = ALLOCATOR.allocated();
    let rounds: Vec<_> = (0..rounds).map(|_| setting.round(before)).collect();
    for (index, first) in rounds[0].iter().enumerate() {
        let median = |of: fn(&Measured) -> f64| {
            let mut values: Vec<_> = rounds.iter().map(|round| of(&round[index])).collect();
            values.sort_by(f64::total_cmp);
            values[values.len() / 2]
        };
        let [trace, sort, index, gather] = [
            median(|measured| measured.trace),
            median(|measured| measured.sort.unwrap_or_default()),
            median(|measured| measured.index),
            median(|measured| measured.gather),
        ];
        let optional = |value: Option<f64>, digits: usize| match value {
            Some(value) => format!("{value:.digits$}"),
            None => "-".to_owned(),
        };
        println!(
            "| {asked} | {threads} | {} | {trace:.3} | {} | {index:.3} | {:.2} | {} | {gather:.3} | {:.0} | {:.3} |",
            first.gather_name,
            optional(first.sort.map(|_| sort), 3),
            first.photons / (trace + sort + index) / 1e6,
            // Later rounds find what the peers took, too.
            optional(first.peak, 1),
            first.in_range,
            sort + index + gather,
        );
    }
}

/// What a row is measured on.
struct Setting {
    scene: Scene,
    options: TraceOptions,
    queries: Vec<QueryPoint>,
}

/// What one round measured of a contestant.
struct Measured {
    gather_name: &'static str,
    photons: f64,
    /// Seconds.
    trace: f64,
    /// Seconds of making the photon map; `None` where there is none.
    sort: Option<f64>,
    /// Seconds of making the planes, or what a peer has.
    index: f64,
    /// Seconds of gathering all queries.
    gather: f64,
    /// Photons in range of a query, on average.
    in_range: f64,
    /// The most bytes a photon that were allocated before the gather.
    peak: Option<f64>,
}

impl Setting {
    fn new(asked: &str) -> Self {
        let photons: f64 = asked.parse().expect("a number of photons");
        let scene = Scene::built_in("cornell").expect("a built-in scene");
        Self {
            options: TraceOptions {
                photons: photons as u64,
                seed: 1,
            },
            queries: view_queries(&scene, &VIEW).expect("a legal view"),
            scene,
        }
    }

    fn trace(&self) -> PhotonTrace {
        trace(&self.scene, &self.options, &|_| ()).expect("a scene with light")
    }

    /// Traces and builds, and measures each contestant. `before` are the bytes that were allocated before the first round.
    fn round(&self, before: usize) -> Vec<Measured> {
        let format = format();
        let lighting = Lighting::default();
        let (traced, trace) = timed(|| self.trace());
        let (maps, sort) = timed(|| {
            let radii = Radii::of(&self.scene, &traced, &lighting, IN_RANGE);
            let engine = Engine::from(&format);
            PhotonMaps::for_engine(&self.scene, traced, &lighting, radii, engine)
        });
        let map = maps.expect("a legal radius").global;
        let (quantised, index) = timed(|| QuantisedMap::new(&map, &(&format).into()));
        let photons = map.photons().len() as f64;
        let peak = (ALLOCATOR.max_allocated() - before) as f64 / photons;
        let mut queries = self.queries.clone();
        map.sort_queries(&mut queries);
        let measured = |contestant: &dyn Contestant, index, sort, peak| {
            let every = contestant.every();
            let (found, seconds) = timed(|| contestant.gather(every));
            Measured {
                gather_name: contestant.name(),
                photons,
                trace,
                sort,
                index,
                gather: seconds * queries.len() as f64 / found.queries as f64,
                in_range: found.count as f64 / found.queries as f64,
                peak,
            }
        };
        let fixed_point = FixedPoint {
            map: quantised.expect("a legal radius"),
            instructions: Instructions::fastest(),
            name: "fixed point",
            queries: &queries,
        };
        let mut all = vec![measured(&fixed_point, index, Some(sort), Some(peak))];
        drop(fixed_point);
        let radius = map.radius();
        drop(map);
        // In the order of their paths, as the map had them. They are traced again, because the map needed their memory.
        let photons = self.trace().photons;
        let photons: Vec<_> = photons.into_iter().map(StoredPhoton::from).collect();
        for peer in PEERS {
            let (peer, index) = timed(|| peer(&photons, radius, &queries));
            all.extend(peer.map(|peer| measured(&*peer, index, None, None)));
        }
        all
    }
}

/// What `work` gives, and the seconds that it takes.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let found = work();
    (found, started.elapsed().as_secs_f64())
}
