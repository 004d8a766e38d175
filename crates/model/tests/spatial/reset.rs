//! Tests of a reset at any clock: earlier words leave no trace in later results.

use photoncube_spec::{Cut, Cuts, Machine, Radius, Spatial};

use crate::driver::{Driver, Waits, expected};
use crate::machines::{SQUARERS, named, with_spatial};
use crate::words::Noise;

/// Clocks enough for a reset in each clock of the earlier batches and of their results' way back.
const CLOCKS: u64 = 70;

/// Resets at clock `clock` for `length` clocks, with results taken before it or not. Fresh batches follow
/// `pause` clocks later.
fn reset_at(machine: &Machine, clock: u64, length: u64, takes: bool, pause: u64) {
    let mut noise = Noise::seeded(machine, clock + 1);
    let before = noise.batches(4, 3 + clock as usize % 3);
    let fresh = noise.batches(3, 1 + clock as usize % 4);
    let mut driver = Driver::new(machine);
    driver.give(&before);
    for _ in 0..clock {
        driver.tick(Waits {
            result: !takes,
            ..Waits::default()
        });
    }
    for _ in 0..length {
        driver.reset();
    }
    driver.results.clear();
    for _ in 0..pause {
        assert!(!driver.tick(Waits::default()).result);
    }
    driver.give(&fresh);
    driver.finish(fresh.len() * machine.queries_at_once());
    assert_eq!(
        driver.results,
        expected(machine, &fresh),
        "{}: reset at {clock} for {length}, pause {pause}",
        machine.name
    );
}

#[test]
fn a_reset_in_any_clock_leaves_nothing_of_before() {
    for name in ["stream", "tile-5", "tile-6"] {
        for clock in 0..CLOCKS {
            for length in [1, 2] {
                for takes in [true, false] {
                    for pause in [0, 1, 30] {
                        reset_at(&named(name), clock, length, takes, pause);
                    }
                }
            }
        }
    }
}

/// Resets work with other pipeline registers and squarers too, and on a chain whose queries have their own
/// radii.
#[test]
fn so_it_does_in_other_pipelines() {
    for squarer in SQUARERS {
        let of = |name| named(name).spatial().unwrap().cuts;
        let few = Cuts::of(&[Cut::Cross, Cut::Range]);
        for cuts in [of("stream"), of("tile-6"), Cuts::of(&Cut::ALL), few] {
            let machine = Machine {
                squarer,
                ..named("tile-6")
            };
            let spatial = Spatial {
                radius: Radius::Query,
                cuts,
                ..*machine.spatial().unwrap()
            };
            let machine = with_spatial(&machine, spatial);
            for clock in 0..CLOCKS {
                reset_at(&machine, clock, 1, true, 0);
            }
        }
    }
}

/// Two resets so close that both are on the chain together.
#[test]
fn a_reset_may_follow_a_reset() {
    let machine = named("tile-6");
    for between in 0..10 {
        for clock in 20..50 {
            let mut noise = Noise::seeded(&machine, clock);
            let mut driver = Driver::new(&machine);
            for ticks in [clock, between] {
                driver.give(&noise.batches(3, 2));
                for _ in 0..ticks {
                    driver.tick(Waits::default());
                }
                driver.reset();
            }
            driver.results.clear();
            let fresh = noise.batches(2, 2);
            driver.give(&fresh);
            driver.finish(2 * machine.queries_at_once());
            assert_eq!(driver.results, expected(&machine, &fresh));
        }
    }
}
