//! What a second thread gives: `scripts/bench.sh threads`.
//!
//! On a machine that others share, speed changes within seconds, and a ratio of measurements a minute apart is
//! mostly that. So each contestant gathers on one thread and on two in turn, and each round has a ratio of its own.
//! What a second thread *can* give is measured the same way, by work that touches no memory.

use std::hint::black_box;
use std::time::Instant;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::contest::contestants;
use crate::data::{Data, Light, Workload};
use crate::format;

/// Rounds of one gather on one thread and one on two. Odd, so that the median is one of them.
const ROUNDS: usize = 41;

/// Pieces of the work that touches no memory, as many as the largest contestant's tiles, and steps of each: a
/// tenth of a second in all.
const PIECES: u64 = 1024;
const STEPS: u64 = 100_000;

/// Prints a table: how many times faster two threads are than one.
pub fn measure() {
    let pools = [1, 2].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads")
    });
    println!(
        "| photons, in range | work | rounds | two threads to one, median | first quartile | third quartile |\n\
         | --- | --- | --- | --- | --- | --- |"
    );
    line("-", "arithmetic in registers", &ratios(&pools, arithmetic));
    for photons in [100_000, 1_000_000] {
        let workload = Workload {
            title: Light::Uniform.name(),
            light: Light::Uniform,
            photons,
            in_range: 200.0,
        };
        let format = format();
        let data = Data::new(&format, &workload);
        for contestant in contestants(&format, &data) {
            let gather = || {
                black_box(contestant.gather(contestant.every()));
            };
            line(&workload.name(), contestant.name(), &ratios(&pools, gather));
        }
    }
}

/// Two to one thread, of each round, in order of size.
fn ratios(pools: &[ThreadPool; 2], work: impl Fn() + Sync) -> Vec<f64> {
    let seconds = |pool: &ThreadPool| {
        pool.install(|| {
            let started = Instant::now();
            work();
            started.elapsed().as_secs_f64()
        })
    };
    // Caches and clocks as they are later.
    pools.iter().for_each(|pool| {
        seconds(pool);
    });
    let mut ratios: Vec<_> = (0..ROUNDS)
        .map(|_| {
            let [one, two] = [0, 1].map(|index| seconds(&pools[index]));
            one / two
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios
}

fn line(data: &str, work: &str, ratios: &[f64]) {
    println!(
        "| {data} | {work} | {} | {:.2} | {:.2} | {:.2} |",
        ratios.len(),
        ratios[ratios.len() / 2],
        ratios[ratios.len() / 4],
        ratios[ratios.len() * 3 / 4],
    );
}

/// A generator of random numbers, each step waiting for the one before, on all pieces in parallel.
fn arithmetic() {
    let piece = |seed: u64| {
        (0..STEPS).fold(seed, |x, _| {
            x.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1)
        })
    };
    let all = (0..PIECES).into_par_iter().map(piece);
    black_box(all.reduce(|| 0, |a, b| a ^ b));
}
