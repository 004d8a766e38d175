//! Benchmarks the gather beside its competitors, on equal photons and queries, in one run:
//! `scripts/bench.sh`.

use std::alloc::System;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, SystemTime};

use cap::Cap;
use criterion::{BenchmarkId, Criterion, SamplingMode, Throughput};
use photoncube_spec::{PhotonFormat, find_photon_format};
use rayon::ThreadPoolBuilder;

use crate::contest::{SOME, contestants};
use crate::data::{Data, Light, Workload};
use crate::table::{Row, print};

mod build;
mod contest;
mod data;
mod found;
#[cfg(target_arch = "x86_64")]
mod grid;
#[cfg(target_arch = "x86_64")]
mod limit;
#[cfg(target_arch = "x86_64")]
mod peers;
mod table;
mod threads;
mod tree;

/// The project's default format: RGBE8 powers and 8 bits per radius.
const FORMAT: &str = "local8-rgb8e5";

/// The numbers of threads that are measured.
const THREADS: [usize; 2] = [1, 2];

/// The argument that measures the growth of time and memory with the number of photons, and the measurements
/// made then.
const SCALING: &str = "scaling";

/// The argument that measures how photons are traced, sorted and put in planes. Numbers of photons may follow.
const BUILD: &str = "build";

/// The argument that measures the gain of a second thread.
const SECOND_THREAD: &str = "threads";

/// Counts the memory that building takes. The gathers allocate only a list of results for each tile.
#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// The argument that measures the gather beside its strongest peer in turn; a filter may follow.
#[cfg(target_arch = "x86_64")]
const BESIDE_PEERS: &str = "peers";

fn main() {
    #[cfg(target_arch = "x86_64")]
    if let Some(at) = std::env::args().position(|argument| argument == BESIDE_PEERS) {
        let filter = std::env::args().nth(at + 1).unwrap_or_default();
        peers::measure(filter.trim_start_matches("--bench"));
        return;
    }
    let arguments: Vec<_> = std::env::args().collect();
    if let Some(place) = arguments.iter().position(|argument| argument == BUILD) {
        build::measure(&arguments[place + 1..]);
        return;
    }
    if std::env::args().any(|argument| argument == SECOND_THREAD) {
        threads::measure();
        return;
    }
    let started = SystemTime::now();
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(2))
        .configure_from_args();
    let format = format();
    let scales = std::env::args().any(|argument| argument.starts_with(SCALING));
    let (workloads, threads) = if scales {
        (scaling(), &THREADS[..1])
    } else {
        (side_by_side(), &THREADS[..])
    };
    let mut rows = Vec::new();
    for workload in &workloads {
        rows.extend(measure(&mut criterion, &format, workload, threads));
    }
    criterion.final_summary();
    match std::env::var_os("CRITERION_HOME") {
        Some(home) => print(Path::new(&home), started, &rows),
        None => println!("scripts/bench.sh prints a table of the ratios"),
    }
}

/// The format of the gather.
fn format() -> PhotonFormat {
    find_photon_format(FORMAT).expect("a listed format")
}

/// All distributions in two sizes and densities; the tilted floor only in the largest.
fn side_by_side() -> Vec<Workload> {
    let mut workloads = Vec::new();
    for light in [Light::Uniform, Light::Caustic] {
        for photons in [100_000, 1_000_000] {
            for in_range in [50.0, 200.0] {
                workloads.push(Workload {
                    title: light.name(),
                    light,
                    photons,
                    in_range,
                });
            }
        }
    }
    workloads.push(Workload {
        title: Light::Tilted.name(),
        light: Light::Tilted,
        photons: 1_000_000,
        in_range: 200.0,
    });
    workloads
}

/// A hundred times the photons: with as many in range, and with the radius of the middle size.
fn scaling() -> Vec<Workload> {
    let sizes = [
        (100_000, 200.0),
        (1_000_000, 200.0),
        (10_000_000, 200.0),
        (100_000, 20.0),
        (10_000_000, 2000.0),
    ];
    let workload = |(photons, in_range)| Workload {
        title: SCALING,
        light: Light::Uniform,
        photons,
        in_range,
    };
    sizes.map(workload).into()
}

/// All contestants on one set of photons and queries.
fn measure(
    criterion: &mut Criterion,
    format: &PhotonFormat,
    workload: &Workload,
    threads: &[usize],
) -> Vec<Row> {
    let mut rows = Vec::new();
    let data = Data::new(format, workload);
    let contestants = contestants(format, &data);
    let expected = contestants[0].gather(SOME);
    for &threads in threads {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("threads");
        let mut group = criterion.benchmark_group(workload.name());
        group.sampling_mode(SamplingMode::Flat);
        for contestant in &contestants {
            let some = contestant.gather(SOME);
            assert!(
                some.is_near(&expected),
                "{}: {some:?}, {expected:?}",
                contestant.name()
            );
            let every = contestant.every();
            let found = contestant.gather(every);
            let id = format!("{} x{threads}", contestant.name());
            group.throughput(Throughput::Elements(found.tests));
            group.bench_function(BenchmarkId::from_parameter(&id), |bencher| {
                pool.install(|| bencher.iter(|| black_box(contestant.gather(every))));
            });
            rows.push(Row {
                data: workload.name(),
                contestant: contestant.name(),
                threads,
                id,
                found,
                bytes_per_photon: contestant.bytes() as f64 / data.map.photons().len() as f64,
            });
        }
        group.finish();
    }
    rows
}
