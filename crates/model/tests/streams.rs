//! Shows why the schedule checker has its stream rules: programs that break a rule give wrong results, and
//! programs that just keep it do not.

use photoncube_model::golden_machine;
use photoncube_spec::{
    Group, Inputs, Lane, Machine, Organisation, OwnProgram, Query, find_machine, parse_listing,
};

const PAPER: &str = "query:\n0 ldq\niteration:\n0 ldp\n1 ldw\n2 sqd\n3 add z\n4 add w\n5 gate\n\
                     6 add x\n7 add y\n8 acc\n";

fn machine(listing: &str) -> Machine {
    let program = parse_listing(listing).unwrap();
    Machine {
        organisation: Organisation::Programmed(OwnProgram::new(&program).unwrap()),
        ..*find_machine("paper").unwrap()
    }
}

/// The words that a machine took and gave.
#[derive(Debug, Default, PartialEq, Eq)]
struct Seen {
    queries: usize,
    groups: usize,
    results: usize,
    /// The count of the last result.
    photons: u64,
}

/// Runs `queries` queries of one group each, one after another, until nothing has moved for long. The first
/// query's radius is so small that no photon is in range.
fn run(machine: &Machine, queries: usize) -> Seen {
    let mut dut = golden_machine(machine);
    let mut seen = Seen::default();
    let photons = vec![
        Lane {
            present: true,
            ..Lane::default()
        };
        machine.photons_per_iteration()
    ];
    let mut still = 0;
    while still < 100 {
        let inputs = Inputs {
            query_valid: seen.queries < queries,
            query: Query {
                position: [9; 3],
                radius_sq: if seen.queries == 0 { 0 } else { 1_000 },
            },
            group_valid: seen.groups < queries,
            group: Group {
                lanes: photons.clone(),
                last: true,
                facing: 0,
            },
            result_ready: true,
            ..Inputs::default()
        };
        let outputs = dut.outputs(&inputs);
        let moves = [
            outputs.query_ready && inputs.query_valid,
            outputs.group_ready && inputs.group_valid,
            outputs.result_valid,
        ];
        seen.queries += usize::from(moves[0]);
        seen.groups += usize::from(moves[1]);
        seen.results += usize::from(moves[2]);
        if outputs.result_valid {
            seen.photons = outputs.result.count;
        }
        still = if moves.contains(&true) { 0 } else { still + 1 };
        dut.clock(&inputs);
    }
    seen
}

#[test]
fn a_query_whose_group_is_taken_in_the_last_clock_does_not_end() {
    let sound = run(&machine(PAPER), 1);
    assert_eq!((sound.groups, sound.results), (1, 1));
    let late = run(&machine(&PAPER.replace("8 acc", "8 acc\n9 ldw")), 1);
    assert_eq!((late.queries, late.groups, late.results), (1, 1, 0));
    let sooner = run(&machine(&PAPER.replace("8 acc", "8 acc\n9 ldw\n10 nop")), 1);
    assert_eq!((sooner.groups, sooner.results), (1, 1));
}

#[test]
fn of_two_queries_that_are_loaded_one_after_the_other_the_first_has_no_result() {
    let sound = run(&machine(PAPER), 2);
    assert_eq!((sound.queries, sound.results), (2, 2));
    let twice = run(&machine(&PAPER.replace("0 ldq", "0 ldq\n1 ldq")), 2);
    assert_eq!((twice.queries, twice.results, twice.photons), (2, 1, 4));
}

#[test]
fn a_program_that_takes_no_group_takes_none() {
    let seen = run(&machine("query:\n0 ldq\niteration:\n0 nop\n1 acc\n"), 1);
    assert_eq!((seen.queries, seen.groups, seen.results), (1, 0, 0));
}
