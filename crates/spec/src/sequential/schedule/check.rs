//! The schedule checker: it follows the contents of a cell's registers, clock by clock.
//!
//! All cells do the same step in each clock, so they all hold the same kinds of values, and one cell stands for
//! all: its neighbour on any axis holds what it holds itself.

use super::content::{Content, Contents, Unreadable};
use super::streams::check_takers;
use crate::cell::{Op, Place, Register, SEQUENTIAL, ScheduleError, ScheduledStep};
use crate::hypercube::Hypercube;
use crate::sequential::Microprogram;

pub(super) const QUERY: &str = "query";
pub(super) const ITERATION: &str = "iteration";

/// The node that stands for all.
const NODE: usize = 0;

/// Checks a microprogram for a cube. The cells share one instruction, so each clock has one op. Each register
/// has one writer and each link one word in a clock. Every operand is complete before it is read. At the end
/// of every iteration every node holds the sum of all groups so far.
///
/// # Errors
/// The first violation, with its clock and node.
pub fn check_schedule(program: &Microprogram, cube: Hypercube) -> Result<(), ScheduleError> {
    check_structure(program, cube)?;
    let mut cell = Contents::default();
    run_phase(QUERY, &program.query, cube, &mut cell)?;
    expect_sum(QUERY, program.query_clocks(), &cell, Content::SumOf(0))?;
    // Two iterations, because the second must not depend on values that the first left behind.
    for groups in 1..=2 {
        run_phase(ITERATION, &program.iteration, cube, &mut cell)?;
        let clocks = program.initiation_interval();
        expect_sum(ITERATION, clocks, &cell, Content::SumOf(groups))?;
        cell.forget_iteration();
    }
    check_takers(program)
}

/// Checks what any control store requires: two phases, one op in each clock, links that exist.
pub(super) fn check_structure(
    program: &Microprogram,
    cube: Hypercube,
) -> Result<(), ScheduleError> {
    for (phase, steps) in [(QUERY, &program.query), (ITERATION, &program.iteration)] {
        if steps.is_empty() {
            return Err(ScheduleError::Empty { phase });
        }
        check_resources(phase, steps, cube)?;
    }
    Ok(())
}

/// Checks that each clock has one instruction for all cells, one op for each unit and one writer for each
/// register.
fn check_resources(
    phase: &'static str,
    steps: &[ScheduledStep],
    cube: Hypercube,
) -> Result<(), ScheduleError> {
    for (index, later) in steps.iter().enumerate() {
        if let Some(axis) = later.step.axis.filter(|&axis| !cube.has_axis(axis)) {
            return Err(ScheduleError::NoSuchLink {
                phase,
                clock: later.clock,
                axis,
                dimension: cube.dimension(),
            });
        }
        let same_clock = |earlier: &&ScheduledStep| earlier.clock == later.clock;
        if let Some(earlier) = steps[..index].iter().find(same_clock) {
            return Err(ScheduleError::Conflict {
                place: place(phase, *earlier),
                other: later.step.to_string(),
                what: shared_resource(earlier, later),
            });
        }
    }
    Ok(())
}

/// Names the resource that two steps of one clock compete for: the one instruction, if nothing else.
fn shared_resource(first: &ScheduledStep, second: &ScheduledStep) -> String {
    let (a, b) = (SEQUENTIAL.op(first.step.op), SEQUENTIAL.op(second.step.op));
    if let (Some(unit), true) = (a.unit, a.unit == b.unit) {
        return format!("need the {unit} unit");
    }
    match a.writes.iter().find(|register| b.writes.contains(register)) {
        Some(&register) => {
            let mnemonic = SEQUENTIAL.register(register).mnemonic;
            format!("write register {mnemonic}")
        }
        None => "need the one instruction that all cells share".to_owned(),
    }
}

/// The place of a step. All cells do it, and the first is named.
pub(super) fn place(phase: &'static str, scheduled: ScheduledStep) -> Box<Place> {
    Box::new(Place {
        phase,
        pass: None,
        clock: scheduled.clock,
        node: NODE,
        step: scheduled.step.to_string(),
    })
}

fn run_phase(
    phase: &'static str,
    steps: &[ScheduledStep],
    cube: Hypercube,
    cell: &mut Contents,
) -> Result<(), ScheduleError> {
    let mut steps = steps.to_vec();
    steps.sort_by_key(|step| step.clock);
    for scheduled in steps {
        let op = scheduled.step.op;
        let of_query = SEQUENTIAL.op(op).reads_query();
        if op != Op::Nop && of_query != (phase == QUERY) {
            let place = place(phase, scheduled);
            return Err(ScheduleError::WrongPhase { place });
        }
        *cell = cell
            .after(scheduled.step, cube)
            .map_err(
                |Unreadable { register, expected }| ScheduleError::Precedence {
                    place: place(phase, scheduled),
                    register: SEQUENTIAL.register(register).mnemonic,
                    holder: NODE,
                    found: cell.of(register).to_string(),
                    expected,
                },
            )?;
    }
    Ok(())
}

fn expect_sum(
    phase: &'static str,
    clocks: u32,
    cell: &Contents,
    expected: Content,
) -> Result<(), ScheduleError> {
    let found = cell.of(Register::Sum);
    if found == expected {
        return Ok(());
    }
    Err(ScheduleError::Incomplete {
        after: format!("{phase} clock {}", clocks - 1),
        node: NODE,
        found: found.to_string(),
        expected: expected.to_string(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequential::parse_listing;

    const PAPER: &str = "query:\n0 ldq\niteration:\n0 ldp\n1 ldw\n2 sqd\n3 add z\n4 add w\n\
                         5 gate\n6 add x\n7 add y\n8 acc\n";

    fn verdict(listing: &str, dimension: u32) -> Result<(), ScheduleError> {
        check_schedule(&parse_listing(listing).unwrap(), Hypercube::new(dimension))
    }

    #[test]
    fn the_papers_program_is_accepted() {
        assert_eq!(verdict(PAPER, 4), Ok(()));
        for dimension in 4..=10 {
            let cube = Hypercube::new(dimension);
            assert_eq!(
                check_schedule(&Microprogram::all_reduce(cube), cube),
                Ok(())
            );
        }
    }

    #[test]
    fn any_order_that_keeps_precedence_is_accepted() {
        let reordered = PAPER
            .replace("0 ldp\n1 ldw\n2 sqd", "0 ldp\n1 sqd\n2 ldw")
            .replace("3 add z\n4 add w", "3 add w\n4 add z");
        assert_eq!(verdict(&reordered, 4), Ok(()));
    }

    #[test]
    fn wrong_programs_are_rejected_with_the_clock_and_the_node() {
        let cases = [
            (
                "0 ldq",
                "0 ldq\n1 nop\n2 ldq",
                4,
                "query clock 2: `ldq` takes a second query, as clock 0 has taken one",
            ),
            (
                "8 acc",
                "8 acc\n9 ldp",
                4,
                "iteration clock 9: `ldp` takes the group in the iteration's last clock",
            ),
            (
                "5 gate",
                "5 nop",
                4,
                "iteration clock 6, node 0: `add x` reads v",
            ),
            (
                "4 add w",
                "4 nop",
                4,
                "iteration clock 5, node 0: `gate` reads v of node 0, which holds squares summed across z; expected squares summed across z, w",
            ),
            (
                "4 add w",
                "4 add z",
                4,
                "iteration clock 4, node 0: `add z`",
            ),
            (
                "0 ldp",
                "0 nop",
                4,
                "iteration clock 2, node 0: `sqd` reads p",
            ),
            (
                "1 ldw",
                "1 nop",
                4,
                "iteration clock 5, node 0: `gate` reads w",
            ),
            (
                "7 add y",
                "7 nop",
                4,
                "iteration clock 8, node 0: `acc` reads v",
            ),
            (
                "8 acc",
                "8 nop",
                4,
                "after iteration clock 8, node 0: s holds the sum of 0 groups",
            ),
            (
                "8 acc",
                "8 acc\n9 acc",
                4,
                "after iteration clock 9, node 0: s holds the sum of 2 groups",
            ),
            (
                "0 ldq",
                "0 nop",
                4,
                "after query clock 0, node 0: s holds nothing",
            ),
            (
                "1 ldw",
                "0 ldw",
                4,
                "iteration clock 0, node 0: `ldp` and `ldw` both need the port unit",
            ),
            (
                "3 add z",
                "2 add z",
                4,
                "iteration clock 2, node 0: `sqd` and `add z` both write register v",
            ),
            (
                "1 ldw",
                "2 ldw",
                4,
                "iteration clock 2, node 0: `ldw` and `sqd` both need the one instruction",
            ),
            (
                "7 add y",
                "7 add v",
                4,
                "iteration clock 7, node 0: the 4-D cube has no axis v",
            ),
            (
                "5 gate",
                "5 ldq",
                4,
                "iteration clock 5, node 0: `ldq` does not belong",
            ),
            (
                "0 ldq",
                "0 ldp",
                4,
                "query clock 0, node 0: `ldp` does not belong",
            ),
            (
                "8 acc",
                "8 acc",
                5,
                "iteration clock 8, node 0: `acc` reads v of node 0, which holds gated powers summed across x, y; expected gated powers summed across x, y, v",
            ),
        ];
        for (from, to, dimension, expected) in cases {
            let message = match verdict(&PAPER.replace(from, to), dimension) {
                Err(error) => error.to_string(),
                Ok(()) => panic!("{from} -> {to} was accepted"),
            };
            assert!(message.starts_with(expected), "{from} -> {to}: {message}");
        }
        assert!(verdict("query:\n0 ldq\n", 4).is_err());
    }
}
