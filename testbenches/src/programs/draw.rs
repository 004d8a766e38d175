//! Legal programs from the op table, by steps that the checker lets stand.

use photoncube_spec::{
    Axis, Hypercube, MOST_OWN_STEPS, Microprogram, OPS, Op, ScheduleError, ScheduledStep, Step,
    check_schedule,
};
use rand::RngExt;
use rand_pcg::Pcg64;

/// Programs that come to no end are this many for each that does, or something is wrong with the drawing.
const MOST_DRAWN_EACH: u64 = 10_000;
/// The most nops before and after a query's load.
const MOST_QUERY_NOPS: u32 = 2;

/// So many different legal programs, and how many were drawn for them.
///
/// # Panics
/// Nearly all that is drawn is not legal.
pub(super) fn different(rng: &mut Pcg64, cube: Hypercube, wanted: u64) -> (Vec<Microprogram>, u64) {
    let mut programs: Vec<Microprogram> = Vec::new();
    let mut drawn = 0;
    while (programs.len() as u64) < wanted {
        drawn += 1;
        assert!(
            drawn < wanted.saturating_mul(MOST_DRAWN_EACH),
            "{} of {drawn} programs were legal",
            programs.len()
        );
        let program = draw_program(rng, cube);
        programs.extend(program.filter(|program| !programs.contains(program)));
    }
    (programs, drawn)
}

/// A legal program of steps that are drawn one after the other from all ops and axes, each if the checker finds
/// nothing wrong so far but that the sum is not complete; none if it is not complete after
/// [`MOST_OWN_STEPS`] steps.
pub fn draw_program(rng: &mut Pcg64, cube: Hypercube) -> Option<Microprogram> {
    let before = rng.random_range(0..=MOST_QUERY_NOPS);
    let mut program = Microprogram {
        query: vec![ScheduledStep {
            clock: before,
            step: Step::new(Op::LoadQuery),
        }],
        iteration: Vec::new(),
    };
    pad(&mut program.query, rng.random_range(0..=MOST_QUERY_NOPS));
    let most = MOST_OWN_STEPS - program.steps().len();
    let length = rng.random_range(1..=most);
    let steps = all_steps(cube);
    let mut complete = None;
    while program.iteration.len() < most {
        let step = steps[rng.random_range(0..steps.len())];
        let clock = program.iteration.len() as u32;
        program.iteration.push(ScheduledStep { clock, step });
        match check_schedule(&program, cube) {
            Ok(()) => complete = Some(program.clone()),
            // A step that takes the group may be followed by others.
            Err(ScheduleError::Incomplete { .. } | ScheduleError::TakenLate { .. }) => {}
            Err(_) => drop(program.iteration.pop()),
        }
        if complete.is_some() && program.iteration.len() >= length {
            break;
        }
    }
    complete
}

/// Nops behind a phase.
fn pad(phase: &mut Vec<ScheduledStep>, nops: u32) {
    for _ in 0..nops {
        let clock = phase.last().map_or(0, |last| last.clock + 1);
        let step = Step::new(Op::Nop);
        phase.push(ScheduledStep { clock, step });
    }
}

/// Each op, with each axis if it uses one.
fn all_steps(cube: Hypercube) -> Vec<Step> {
    let mut steps = Vec::new();
    for row in OPS {
        let axes: Vec<Option<Axis>> = match row.uses_link {
            true => cube.axes().map(Some).collect(),
            false => vec![None],
        };
        steps.extend(axes.into_iter().map(|axis| Step { op: row.op, axis }));
    }
    steps
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use rand::SeedableRng;

    use super::*;

    #[test]
    fn programs_are_legal_different_and_of_every_step_and_many_lengths() {
        for dimension in [4, 5] {
            let cube = Hypercube::new(dimension);
            let rng = &mut Pcg64::seed_from_u64(1);
            let (programs, drawn) = different(rng, cube, 100);
            assert!(drawn >= 100);
            let mut seen = HashSet::new();
            let mut lengths = HashSet::new();
            for program in &programs {
                assert_eq!(check_schedule(program, cube), Ok(()));
                assert!(program.steps().len() <= MOST_OWN_STEPS);
                seen.extend(program.steps());
                lengths.insert(program.steps().len());
            }
            assert_eq!(seen.len(), all_steps(cube).len());
            assert!(lengths.len() >= 4, "{lengths:?}");
            let orders: HashSet<_> = programs.iter().map(Microprogram::steps).collect();
            assert_eq!(orders.len(), 100);
        }
    }
}
