//! Measures the gather beside its strongest peer and the limit of the processor: `scripts/bench.sh peers`.
//!
//! As in `threads.rs`, they are measured in turn, and each round has its own ratios, because the speed of a
//! shared computer changes within seconds.

use std::hint::black_box;
use std::time::Instant;

use rayon::ThreadPoolBuilder;

use crate::contest::{Contestant, contestants};
use crate::data::{Data, Workload};
use crate::limit::Limit;
use crate::threads::quartiles;
use crate::{format, side_by_side};

/// The number of rounds of one gather by each. It is odd, so that the median is one of them.
const ROUNDS: usize = 61;

/// Prints a table of the ratios of queries a second, of the workloads whose names contain `filter`, on one thread.
pub fn measure(filter: &str) {
    let pool = ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("threads");
    println!(
        "| photons, in range | gather | rounds | M queries/s | G tests/s | queries/s to the f32 grid, median \
         | first quartile | third quartile | G tests/s that the ports allow | share |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    );
    let workloads = side_by_side();
    let named = workloads.iter().filter(|one| one.name().contains(filter));
    for workload in named {
        pool.install(|| measure_one(workload));
    }
}

fn measure_one(workload: &Workload) {
    let format = format();
    let data = Data::new(&format, workload);
    let all = contestants(&format, &data);
    let Some(grid) = all.iter().find(|one| one.name() == "f32 grid") else {
        return;
    };
    for one in all.iter().filter(|one| one.name().starts_with("fixed")) {
        let line = line(one.as_ref(), grid.as_ref());
        println!("| {} | {} | {ROUNDS} {line} |", workload.name(), one.name());
    }
}

/// The figures of one contestant.
fn line(one: &dyn Contestant, grid: &dyn Contestant) -> String {
    let found = one.gather(1);
    let limit = Limit::of(one.name());
    let rounds: Vec<_> = (0..ROUNDS)
        .map(|_| {
            let limit = limit.as_ref().map(Limit::photons_per_second);
            (seconds(one), seconds(grid), limit)
        })
        .collect();
    let [_, each, _] = quartiles(rounds.iter().map(|(one, ..)| *one));
    let [first, median, third] = quartiles(rounds.iter().map(|(one, grid, _)| grid / one));
    let tests = found.tests as f64;
    let mut line = format!(
        "| {:.2} | {:.2} | {median:.2} | {first:.2} | {third:.2} | ",
        found.queries as f64 / each / 1e6,
        tests / each / 1e9,
    );
    if limit.is_none() {
        return line + "- | -";
    }
    let limits = || {
        let limit = |(one, _, limit): &(f64, f64, Option<f64>)| Some((*one, (*limit)?));
        rounds.iter().filter_map(limit)
    };
    let [_, allowed, _] = quartiles(limits().map(|(_, limit)| limit));
    let [_, share, _] = quartiles(limits().map(|(one, limit)| tests / one / limit));
    line += &format!("{:.1} | {:.0} %", allowed / 1e9, 100.0 * share);
    line
}

/// The time of one gather of all queries.
fn seconds(contestant: &dyn Contestant) -> f64 {
    let started = Instant::now();
    black_box(contestant.gather(1));
    started.elapsed().as_secs_f64()
}
