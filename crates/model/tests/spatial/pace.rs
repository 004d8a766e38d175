//! Tests of timing: latency, no bubbles, the clocks of short batches, and the stop at a full queue.

use photoncube_spec::{Cuts, HeadSizes, Machine, Pace, SharedGroups};

use crate::driver::{Driver, Moved, Waits, expected};
use crate::machines::{SQUARERS, all_cuts, all_named, named, with_cuts};
use crate::words::Noise;

/// Runs `batches` batches of `groups` groups without waiting. Returns the movements of each clock until all
/// results have come.
fn moves(machine: &Machine, batches: usize, groups: usize) -> Vec<Moved> {
    let batches = Noise::new(machine).batches(batches, groups);
    let mut driver = Driver::new(machine);
    driver.give(&batches);
    let results = batches.len() * machine.queries_at_once();
    let mut moves = Vec::new();
    while driver.results.len() < results {
        moves.push(driver.tick(Waits::default()));
        assert!(moves.len() < 100_000, "the machine hangs");
    }
    assert_eq!(driver.results, expected(machine, &batches));
    moves
}

/// The clocks in which `moved` is true.
fn clocks(moves: &[Moved], moved: impl Fn(&Moved) -> bool) -> Vec<u32> {
    let clocks = moves.iter().enumerate().filter(|(_, m)| moved(m));
    clocks.map(|(clock, _)| clock as u32).collect()
}

/// The clocks from the last group taken to each result.
fn latencies(machine: &Machine, groups: usize) -> Vec<u32> {
    let moves = moves(machine, 1, groups);
    let last = clocks(&moves, |m| m.last)[0];
    let results = clocks(&moves, |m| m.result);
    results.into_iter().map(|clock| clock - last).collect()
}

#[test]
fn results_come_after_the_latency_and_two_clocks_apart() {
    // A memory delays a set until it is complete.
    for machine in all_named().filter(|machine| !machine.has_memory()) {
        let first = machine.spatial().unwrap().latency_clocks();
        let expected: Vec<_> = (0..machine.queries_at_once() as u32)
            .map(|engine| first + 2 * engine)
            .collect();
        for groups in [1, 5] {
            assert_eq!(latencies(machine, groups), expected, "{}", machine.name);
        }
    }
    let latency = |name| named(name).spatial().unwrap().latency_clocks();
    assert_eq!((latency("stream"), latency("tile-10")), (16, 14));
}

#[test]
fn the_latency_follows_from_the_cuts() {
    for squarer in SQUARERS {
        for cuts in all_cuts(squarer) {
            let machine = Machine {
                squarer,
                ..named("stream")
            };
            let machine = with_cuts(&machine, cuts);
            let expected = machine.spatial().unwrap().latency_clocks();
            assert_eq!(latencies(&machine, 1), [expected], "{cuts:?}");
        }
    }
}

/// Queries of one group each: no clock is lost at a change of the query, whatever the pipeline.
#[test]
fn stream_takes_a_group_and_gives_a_result_every_clock() {
    let cuts_of = |name| named(name).spatial().unwrap().cuts;
    let all = Cuts::of(&photoncube_spec::Cut::ALL);
    for cuts in [cuts_of("stream"), cuts_of("tile-5"), all] {
        let machine = with_cuts(&named("stream"), cuts);
        let moves = moves(&machine, 200, 1);
        let latency = machine.spatial().unwrap().latency_clocks();
        // The first query is taken one clock before its group.
        assert_eq!(clocks(&moves, |m| m.query), (0..200).collect::<Vec<_>>());
        assert_eq!(clocks(&moves, |m| m.group), (1..201).collect::<Vec<_>>());
        let results = 1 + latency..201 + latency;
        assert_eq!(clocks(&moves, |m| m.result), results.collect::<Vec<_>>());
    }
}

/// From batches of 2 N - 1 groups on, a chain of N engines never waits, and all queries of the next batch are
/// taken before the batch ends.
#[test]
fn a_tile_takes_a_group_every_clock() {
    for name in ["tile-5", "tile-6", "tile-7", "tile-8"] {
        let machine = named(name);
        let engines = machine.queries_at_once();
        for groups in [2 * engines - 1, 2 * engines, 2 * engines + 3, 5 * engines] {
            let batches = 12;
            let moves = moves(&machine, batches, groups);
            let first = engines as u32;
            let taken = first..first + (batches * groups) as u32;
            assert_eq!(
                clocks(&moves, |m| m.group),
                taken.collect::<Vec<_>>(),
                "{name} with batches of {groups}"
            );
            let queries = clocks(&moves, |m| m.query);
            let lasts = clocks(&moves, |m| m.last);
            for (batch, queries) in queries.chunks(engines).enumerate().skip(1) {
                let begun = (engines + (batch - 1) * groups) as u32;
                let expected: Vec<_> = (begun..begun + first).collect();
                assert_eq!(queries, expected);
                assert!(expected[engines - 1] < lasts[batch - 1]);
            }
        }
    }
}

/// A shorter batch takes as many clocks as one of 2 N - 1 groups, since results of two batches must not
/// collide on the chain: two last groups are 2 N - 1 clocks apart.
#[test]
fn a_short_batch_costs_the_spacing_and_no_more() {
    for name in ["tile-5", "tile-6", "tile-7", "tile-8"] {
        let machine = named(name);
        let engines = machine.queries_at_once();
        let spacing = HeadSizes::of(machine.spatial().unwrap()).spacing;
        for groups in [1, engines - 1, engines, 2 * engines - 2] {
            let lasts = clocks(&moves(&machine, 12, groups.max(1)), |m| m.last);
            for pair in lasts.windows(2) {
                assert_eq!(pair[1] - pair[0], spacing, "{name}, batches of {groups}");
            }
        }
    }
}

/// While no result is taken, groups are taken up to the last group whose results would have no room. No word
/// is lost.
#[test]
fn a_full_queue_stops_at_the_last_group_that_has_no_room() {
    for name in ["stream", "tile-5", "tile-6", "tile-7"] {
        let machine = named(name);
        let engines = machine.queries_at_once();
        let queue = HeadSizes::of(machine.spatial().unwrap()).queue;
        // One result is on the pins. With one engine that result is a batch, which needs no place in the
        // queue.
        let (groups, fitting) = (5, queue / engines + 1 / engines);
        let batches = Noise::new(&machine).batches(fitting + 3, groups);
        let mut driver = Driver::new(&machine);
        driver.give(&batches);
        let stopped = Waits {
            result: true,
            ..Waits::default()
        };
        for _ in 0..1000 {
            driver.tick(stopped);
        }
        assert!(driver.results.is_empty());
        // All groups but the last of the batch that does not fit are taken, and the queries of the next
        // batch.
        assert_eq!(driver.groups_left(), 3 * groups - (groups - 1), "{name}");
        assert_eq!(driver.queries_left(), engines, "{name}");
        // Room for the results of one batch lets one more last group in. The batch's last result is read when
        // the result before it is taken; with several engines the room is free one clock later.
        let mut lasts = 0;
        for taken in 1..=engines {
            lasts += usize::from(driver.tick(Waits::default()).last);
            assert_eq!(driver.results.len(), taken);
            assert_eq!(lasts, 0);
        }
        for _ in 0..2 {
            lasts += usize::from(driver.tick(stopped).last);
            assert_eq!(lasts, 1, "{name}");
        }
        driver.finish(batches.len() * engines);
        assert_eq!(driver.results, expected(&machine, &batches));
    }
}

/// The forecast covers the clocks from the one after the first query to the last result, for batches longer
/// and shorter than the spacing.
#[test]
fn the_forecast_is_the_clocks_that_the_machine_takes() {
    for machine in all_named().filter(|machine| machine.queries_at_once() <= 16) {
        let engines = machine.queries_at_once();
        for (batches, groups) in [(1, 5), (12, 5 * engines), (12, 1)] {
            let list = SharedGroups {
                queries: engines as u64,
                groups: groups as u64,
            };
            let forecast = Pace::of(machine).unwrap().clocks(vec![list; batches]);
            let taken = moves(machine, batches, groups).len() as u64 - 1;
            // The clocks of a memory before it plays the first set: one for each group, and some registers on
            // the way.
            let filled = match machine.has_memory() {
                true => groups as u64 + 12,
                false => 0,
            };
            // After the last batch, nothing waits for the spacing.
            let spacing = u64::from(HeadSizes::of(machine.spatial().unwrap()).spacing);
            assert!(
                forecast < taken + spacing && taken <= forecast + filled,
                "{}: {batches} batches of {groups}: {taken} clocks, forecast {forecast}",
                machine.name
            );
        }
    }
}
