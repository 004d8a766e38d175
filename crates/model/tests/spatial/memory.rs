//! Tests of the photon memory: sets of photons are read in once and played to several batches.

use photoncube_model::golden_machine;
use photoncube_spec::{Group, Inputs, Machine, Query, Sums};

use crate::driver::{Batch, expected};
use crate::machines::named;
use crate::words::Noise;

/// A set of photons with the batches of queries that it is played to.
struct Set {
    groups: Vec<Group>,
    batches: Vec<Vec<Query>>,
}

impl Set {
    fn batches(&self) -> impl Iterator<Item = Batch> {
        self.batches.iter().map(|queries| Batch {
            queries: queries.clone(),
            groups: self.groups.clone(),
        })
    }
}

/// `count` sets of `groups` groups, for `batches` batches each.
fn sets(machine: &Machine, count: usize, batches: usize, groups: usize) -> Vec<Set> {
    let mut noise = Noise::seeded(machine, 3);
    let mut set = || {
        let drawn = noise.batches(batches, groups);
        Set {
            groups: drawn[0].groups.clone(),
            batches: drawn.into_iter().map(|batch| batch.queries).collect(),
        }
    };
    (0..count).map(|_| set()).collect()
}

/// The results, and the clocks in which the first and the last group of each set were taken.
struct Run {
    results: Vec<Sums>,
    clocks: usize,
    last_groups_taken: Vec<usize>,
    results_taken: Vec<usize>,
}

/// Runs all streams without waiting.
fn run(machine: &Machine, sets: &[Set]) -> Run {
    let mut dut = golden_machine(machine);
    let releases = sets.iter().flat_map(|set| {
        let last = set.batches.len() - 1;
        let batches = set.batches.iter().enumerate();
        batches.flat_map(move |(index, batch)| batch.iter().map(move |&q| (q, index == last)))
    });
    let mut queries = releases.peekable();
    let mut groups = sets.iter().flat_map(|set| &set.groups).peekable();
    let wanted: usize = sets.iter().flat_map(|set| &set.batches).map(Vec::len).sum();
    let mut run = Run {
        results: Vec::new(),
        clocks: 0,
        last_groups_taken: Vec::new(),
        results_taken: Vec::new(),
    };
    while run.results.len() < wanted {
        let query = queries.peek().copied();
        let group = groups.peek().copied();
        let inputs = Inputs {
            query_valid: query.is_some(),
            query: query.map_or(Query::default(), |(query, _)| query),
            query_release: query.is_some_and(|(_, release)| release),
            group_valid: group.is_some(),
            group: group.cloned().unwrap_or_default(),
            result_ready: true,
            ..Inputs::default()
        };
        let outputs = dut.outputs(&inputs);
        dut.clock(&inputs);
        if inputs.query_valid && outputs.query_ready {
            queries.next();
        }
        if inputs.group_valid && outputs.group_ready {
            groups.next();
            if inputs.group.last {
                run.last_groups_taken.push(run.clocks);
            }
        }
        if outputs.result_valid {
            run.results.push(outputs.result);
            run.results_taken.push(run.clocks);
        }
        run.clocks += 1;
        assert!(run.clocks < 100_000, "the machine hangs");
    }
    run
}

fn all_batches(sets: &[Set]) -> Vec<Batch> {
    sets.iter().flat_map(Set::batches).collect()
}

#[test]
fn a_set_is_read_in_once_and_summed_for_every_batch() {
    for name in ["tile-6-mixed", "chip-lut"] {
        let machine = named(name);
        let sets = sets(&machine, 4, 3, 40);
        let expected = expected(&machine, &all_batches(&sets));
        assert!(expected.iter().any(|sums| sums.count > 0), "{name}");
        assert_eq!(run(&machine, &sets).results, expected, "{name}");
    }
}

#[test]
fn the_next_set_is_read_in_while_this_one_is_played() {
    let machine = named("tile-6-mixed");
    let sets = sets(&machine, 2, 3, 60);
    let run = run(&machine, &sets);
    // The second set is complete before the first batch's results are out.
    assert!(run.last_groups_taken[1] < 3 * 60);
    assert!(run.results_taken.last().unwrap() > &(6 * 60));
}

/// Three clocks lie between the last group of one batch and the first of the next: the memory needs two to
/// detect the end of the batch, and the third to decide whether the next may start.
#[test]
fn a_batch_costs_three_clocks_beside_its_groups() {
    let machine = named("tile-6-mixed");
    let (batches, groups) = (20, 50);
    let sets = sets(&machine, 1, batches, groups);
    let run = run(&machine, &sets);
    let firsts: Vec<_> = run.results_taken.chunks(4).map(|batch| batch[0]).collect();
    assert_eq!(firsts.len(), batches);
    assert!(
        firsts.windows(2).all(|pair| pair[1] - pair[0]
            == groups + machine.spatial().unwrap().batch_gap_clocks() as usize)
    );
}

/// The time of a batch does not depend on whether its set was played before, where sets have one length.
#[test]
fn a_batch_costs_the_gap_and_has_a_least_length() {
    for name in ["tile-6-mixed", "chip-lut"] {
        let machine = named(name);
        let spatial = machine.spatial().unwrap();
        let (gap, least) = (spatial.batch_gap_clocks(), spatial.least_batch_clocks());
        for (count, batches) in [(12, 1), (1, 12)] {
            for groups in [1, 5, 200] {
                let run = run(&machine, &sets(&machine, count, batches, groups));
                let firsts = run.results_taken.chunks(spatial.engines());
                let firsts: Vec<_> = firsts.map(|batch| batch[0] as u32).collect();
                let expected = (groups as u32 + gap).max(least);
                assert!(
                    firsts.windows(2).all(|pair| pair[1] - pair[0] == expected),
                    "{name}: {firsts:?}"
                );
            }
        }
    }
}
