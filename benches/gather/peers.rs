//! Measures how much faster the gather is than its strongest peer: `scripts/bench.sh peers`.
//!
//! As in `threads.rs`, the two gather in turn, and each round has its own ratio, because the speed of a shared
//! computer changes within seconds.

use std::hint::black_box;
use std::time::Instant;

use rayon::ThreadPoolBuilder;

use crate::contest::{Contestant, contestants};
use crate::data::{Data, Workload};
use crate::threads::quartiles;
use crate::{format, side_by_side};

/// The number of rounds of one gather by each. It is odd, so that the median is one of them.
const ROUNDS: usize = 61;

/// Prints a table of the ratios of queries a second, of the workloads whose names contain `filter`, on one thread.
pub fn measure(filter: &str) {
    let pool = ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("threads");
    println!(
        "| photons, in range | gather | rounds | M queries/s | G tests/s | queries/s to the f32 grid, median | first quartile \
         | third quartile |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |"
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
        let found = one.gather(1);
        let rounds: Vec<_> = (0..ROUNDS)
            .map(|_| [seconds(one.as_ref()), seconds(grid.as_ref())])
            .collect();
        let [_, each, _] = quartiles(rounds.iter().map(|[one, _]| *one));
        let [first, median, third] = quartiles(rounds.iter().map(|[one, grid]| grid / one));
        println!(
            "| {} | {} | {ROUNDS} | {:.2} | {:.2} | {median:.2} | {first:.2} | {third:.2} |",
            workload.name(),
            one.name(),
            found.queries as f64 / each / 1e6,
            found.tests as f64 / each / 1e9,
        );
    }
}

/// The time of one gather of all queries.
fn seconds(contestant: &dyn Contestant) -> f64 {
    let started = Instant::now();
    black_box(contestant.gather(1));
    started.elapsed().as_secs_f64()
}
