//! Measures the gain of a second thread: `scripts/bench.sh threads`.
//!
//! On a shared computer the speed changes within seconds, and the ratio of measurements a minute apart shows
//! mostly these changes. So each contestant gathers alternately on one thread and on two, and each round has
//! its own ratio. The largest possible gain is measured in this way too, by work that uses no memory.

use std::hint::black_box;
use std::time::Instant;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::contest::contestants;
use crate::data::{Data, Light, Workload};
use crate::format;

/// The number of rounds of one gather on one thread and one on two. It is odd, so that the median is one of
/// them.
const ROUNDS: usize = 41;

/// The pieces of the work that uses no memory, as many as the largest contestant's tiles, and the steps of
/// each: a tenth of a second in all.
const PIECES: u64 = 1024;
const STEPS: u64 = 100_000;

/// Prints a table of the speedups by two threads.
pub fn measure() {
    let pools = [1, 2].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("threads")
    });
    println!(
        "| photons, in range | work | rounds | two threads to one, median | first quartile | third quartile |\n\
         | --- | --- | --- | --- | --- | --- |"
    );
    line("-", "arithmetic in registers", ratios(&pools, arithmetic));
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
            line(&workload.name(), contestant.name(), ratios(&pools, gather));
        }
    }
}

/// The quartiles of the ratios of two threads to one, over all rounds.
fn ratios(pools: &[ThreadPool; 2], work: impl Fn() + Sync) -> [f64; 3] {
    let seconds = |pool: &ThreadPool| {
        pool.install(|| {
            let started = Instant::now();
            work();
            started.elapsed().as_secs_f64()
        })
    };
    // A warm-up brings caches and clocks to their later state.
    pools.iter().for_each(|pool| {
        seconds(pool);
    });
    let ratios = (0..ROUNDS).map(|_| {
        let [one, two] = [0, 1].map(|index| seconds(&pools[index]));
        one / two
    });
    quartiles(ratios)
}

/// The first quartile, the median and the third quartile.
pub fn quartiles(values: impl Iterator<Item = f64>) -> [f64; 3] {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| values[values.len() * quarter / 4])
}

fn line(data: &str, work: &str, [first, median, third]: [f64; 3]) {
    println!("| {data} | {work} | {ROUNDS} | {median:.2} | {first:.2} | {third:.2} |");
}

/// A generator of random numbers, in which each step depends on the one before, on all pieces in parallel.
fn arithmetic() {
    let piece = |seed: u64| {
        (0..STEPS).fold(seed, |x, _| {
            x.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1)
        })
    };
    let all = (0..PIECES).into_par_iter().map(piece);
    black_box(all.reduce(|| 0, |a, b| a ^ b));
}
