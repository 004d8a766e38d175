use super::*;
use crate::overlap::graph::{FIXED, Graph, ROTATED};
use crate::overlap::schedule::schedule_at;

fn program() -> Program {
    Program::rotated().unwrap()
}

#[test]
fn the_schedulers_programs_are_accepted() {
    for adders in [ROTATED, FIXED] {
        let graph = Graph::new(adders);
        let shortest = 3 - u32::from(graph.groups == 1);
        for interval in shortest..8 {
            let schedule = schedule_at(&graph, interval).unwrap();
            let verdict = check_program(&Program::new(&graph, &schedule));
            assert_eq!(verdict, Ok(()), "{interval}");
        }
    }
}

#[test]
fn no_op_can_be_left_out_done_twice_or_done_by_another_cell() {
    let program = program();
    for index in 0..program.kernel.len() {
        let mut wrong = program.clone();
        let op = wrong.kernel.remove(index);
        assert!(check_program(&wrong).is_err(), "without {op:?}");
        wrong.kernel.extend([op, op]);
        assert!(check_program(&wrong).is_err(), "twice {op:?}");
        let mut wrong = program.clone();
        wrong.kernel[index].role = op.role.across(Axis::Z);
        assert!(check_program(&wrong).is_err(), "elsewhere {op:?}");
        let mut wrong = program.clone();
        wrong.kernel[index].stage += 1;
        assert!(check_program(&wrong).is_err(), "a pass late {op:?}");
        let mut wrong = program.clone();
        wrong.kernel[index].group ^= 1;
        assert!(check_program(&wrong).is_err(), "the other group {op:?}");
    }
    for index in 0..program.epilogue.len() {
        let mut wrong = program.clone();
        wrong.epilogue.remove(index);
        assert!(check_program(&wrong).is_err(), "epilogue {index}");
    }
}

/// The checker's error for the program after `change` is applied to its ops.
fn message(change: impl Fn(&mut KernelOp)) -> String {
    let mut wrong = program();
    wrong.kernel.iter_mut().for_each(change);
    check_program(&wrong).unwrap_err().to_string()
}

fn later(op: &mut KernelOp, clocks: u32) {
    let time = op.stage * 3 + op.clock + clocks;
    (op.stage, op.clock) = (time / 3, time % 3);
}

#[test]
fn an_op_too_late_is_named_with_what_it_finds() {
    let said = message(|op| {
        if (op.role, op.step, op.group) == (Role::D, Step::new(Op::Keep), 0) {
            later(op, 3);
        }
    });
    let expected = "kernel pass 3 clock 0, node 12: `cmp` reads t of node 12, which holds nothing \
                    that may be read; expected x^2 + y^2 + z^2 of group 0";
    assert_eq!(said, expected);
}

#[test]
fn two_ops_on_one_unit_are_named() {
    let said = message(|op| {
        if (op.role, op.step.op, op.group) == (Role::X, Op::Accumulate, 0) {
            later(op, 1);
        }
    });
    let expected = "both need the add unit";
    assert!(
        said.contains("node 0: `acc`") || said.contains("node 0: `add`"),
        "{said}"
    );
    assert!(said.contains(expected), "{said}");
}

#[test]
fn a_word_that_is_overwritten_is_named_with_what_came_over_it() {
    let said = message(|op| {
        if (op.role, op.step.op, op.group) == (Role::X, Op::SquareDifference, 0) {
            later(op, 2);
        }
    });
    let expected = "kernel pass 1 clock 0, node 0: `sqd` reads p of node 0, which holds x of group 1; \
                    expected x of group 0";
    assert_eq!(said, expected);
}

#[test]
fn a_group_that_some_node_does_not_take_is_named() {
    let said = message(|op| {
        if (op.role, op.step.op, op.group) == (Role::Y, Op::LoadPower, 1) {
            op.clock = 2;
        }
    });
    assert_eq!(
        said,
        "clock 1 of the kernel takes no group in node 4; expected that all nodes do"
    );
}

#[test]
fn a_link_with_two_words_is_named() {
    let mut wrong = program();
    let relay = wrong.kernel.iter().position(|op| op.step.op == Op::Relay);
    let KernelOp { role, .. } = wrong.kernel[relay.unwrap()];
    let keep = KernelOp {
        step: Step::across(Op::Keep, Axis::W),
        ..wrong.kernel[relay.unwrap()]
    };
    wrong.kernel.push(keep);
    let said = check_program(&wrong).unwrap_err().to_string();
    let link = format!("node {}: `keep w` needs a on axis w", node(role));
    assert!(
        said.contains(&link) && said.contains("which sends t then"),
        "{said}"
    );
}

#[test]
fn a_drain_that_is_too_short_loses_a_group() {
    let mut wrong = program();
    wrong.drain_clocks -= 1;
    let said = check_program(&wrong).unwrap_err().to_string();
    assert!(said.starts_with("after a query of "), "{said}");
    assert!(
        said.contains("expected the sum of the groups {0, 1, "),
        "{said}"
    );
}

#[test]
fn a_clock_that_the_kernel_does_not_have_is_refused() {
    let mut wrong = program();
    wrong.kernel[0].clock = 3;
    let said = check_program(&wrong).unwrap_err().to_string();
    assert!(
        said.contains("is in clock 3 of a kernel of 3 clocks"),
        "{said}"
    );
}
