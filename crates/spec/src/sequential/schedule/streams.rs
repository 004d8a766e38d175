//! The stream rules of a program: what the sequencer needs, whatever the cells compute.
//!
//! A query is taken by its `ldq`, a group by the last step that reads it. The sequencer knows from the clock
//! after that step whether the group was the query's last.

use super::check::{ITERATION, QUERY, check_structure, place};
use crate::cell::{OpRow, SEQUENTIAL, ScheduleError, ScheduledStep};
use crate::hypercube::Hypercube;
use crate::sequential::Microprogram;

/// Checks that every query is taken once and has one result. Each clock has one op, every link exists, the
/// query phase has one `ldq`, and groups are read only in the iteration and not in its last clock.
///
/// # Errors
/// The first violation, with its clock.
pub fn check_streams(program: &Microprogram, cube: Hypercube) -> Result<(), ScheduleError> {
    check_structure(program, cube)?;
    check_takers(program)
}

/// Checks the stream rules of a program whose structure is legal.
pub(super) fn check_takers(program: &Microprogram) -> Result<(), ScheduleError> {
    refuse_in(QUERY, &program.query, OpRow::reads_group)?;
    refuse_in(ITERATION, &program.iteration, OpRow::reads_query)?;
    let queries = clocks_of(&program.query, OpRow::reads_query);
    match queries[..] {
        [] => return Err(not_taken(QUERY, "query", "ldq")),
        [_] => {}
        [first, second, ..] => {
            return Err(ScheduleError::TakenTwice {
                clock: second.clock,
                first: first.clock,
                step: second.step.to_string(),
            });
        }
    }
    match clocks_of(&program.iteration, OpRow::reads_group).last() {
        None => Err(not_taken(ITERATION, "group", "ldp` or `ldw")),
        Some(taker) if taker.clock + 1 == program.initiation_interval() => {
            Err(ScheduleError::TakenLate {
                clock: taker.clock,
                step: taker.step.to_string(),
            })
        }
        Some(_) => Ok(()),
    }
}

fn not_taken(phase: &'static str, stream: &'static str, expected: &'static str) -> ScheduleError {
    ScheduleError::NotTaken {
        phase,
        stream,
        expected,
    }
}

/// The steps of a phase whose op satisfies `wanted`, by clock.
fn clocks_of(phase: &[ScheduledStep], wanted: fn(&OpRow) -> bool) -> Vec<ScheduledStep> {
    let found = phase.iter().filter(|s| wanted(SEQUENTIAL.op(s.step.op)));
    let mut found: Vec<_> = found.copied().collect();
    found.sort_by_key(|s| s.clock);
    found
}

fn refuse_in(
    phase: &'static str,
    steps: &[ScheduledStep],
    unwanted: fn(&OpRow) -> bool,
) -> Result<(), ScheduleError> {
    match clocks_of(steps, unwanted).first() {
        None => Ok(()),
        Some(&found) => Err(ScheduleError::WrongPhase {
            place: place(phase, found),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequential::{check_schedule, parse_listing};

    const PAPER: &str = "query:\n0 ldq\niteration:\n0 ldp\n1 ldw\n2 sqd\n3 add z\n4 add w\n\
                         5 gate\n6 add x\n7 add y\n8 acc\n";

    fn verdicts(listing: &str) -> [Result<(), ScheduleError>; 2] {
        let (program, cube) = (parse_listing(listing).unwrap(), Hypercube::new(4));
        [
            check_schedule(&program, cube),
            check_streams(&program, cube),
        ]
    }

    #[test]
    fn a_group_may_not_be_taken_in_the_last_clock() {
        let late = ScheduleError::TakenLate {
            clock: 9,
            step: "ldw".to_owned(),
        };
        for verdict in verdicts(&PAPER.replace("8 acc", "8 acc\n9 ldw")) {
            assert_eq!(verdict, Err(late.clone()));
        }
        for verdict in verdicts(&PAPER.replace("8 acc", "8 acc\n9 ldw\n10 nop")) {
            assert_eq!(verdict, Ok(()));
        }
    }

    #[test]
    fn a_query_may_not_be_taken_twice() {
        for verdict in verdicts(&PAPER.replace("0 ldq", "0 ldq\n2 ldq")) {
            let expected = ScheduleError::TakenTwice {
                clock: 2,
                first: 0,
                step: "ldq".to_owned(),
            };
            assert_eq!(verdict, Err(expected));
        }
    }

    #[test]
    fn streams_are_all_that_the_second_check_looks_at() {
        let cases = [
            ("query:\n0 ldq\niteration:\n0 ldw\n1 gate\n", None),
            ("query:\n0 acc\n1 ldq\niteration:\n0 ldp\n5 nop\n", None),
            (
                "query:\n0 nop\niteration:\n0 ldp\n1 nop\n",
                Some("query phase: no step takes a query; expected `ldq`"),
            ),
            (
                "query:\n0 ldq\niteration:\n0 gate\n1 nop\n",
                Some("iteration phase: no step takes a group; expected `ldp` or `ldw`"),
            ),
            (
                "query:\n0 ldq\niteration:\n0 ldp\n1 ldq\n2 nop\n",
                Some("iteration clock 1, node 0: `ldq` does not belong"),
            ),
            (
                "query:\n0 ldq\n1 ldw\niteration:\n0 ldp\n1 nop\n",
                Some("query clock 1, node 0: `ldw` does not belong"),
            ),
        ];
        for (listing, expected) in cases {
            let [_, verdict] = verdicts(listing);
            match (verdict, expected) {
                (Ok(()), None) => {}
                (Err(error), Some(expected)) => {
                    let message = error.to_string();
                    assert!(message.starts_with(expected), "{message}");
                }
                (found, _) => panic!("{listing}: {found:?}"),
            }
        }
    }
}
