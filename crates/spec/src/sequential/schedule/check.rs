//! The schedule checker: it follows the contents of every register of every node, clock by clock.

use super::content::Content;
use super::error::ScheduleError;
use super::streams::check_takers;
use crate::hypercube::{Axis, Hypercube};
use crate::sequential::{Microprogram, Op, REGISTERS, Register, ScheduledStep};

pub(super) const QUERY: &str = "query";
pub(super) const ITERATION: &str = "iteration";

/// Checks a microprogram for a cube. The cells share one instruction, so each clock has one op. Each register
/// has one writer and each link one word in a clock. Every operand is complete before it is read. At the end
/// of every iteration every node holds the sum of all groups so far.
///
/// # Errors
/// The first violation, with its clock and node.
pub fn check_schedule(program: &Microprogram, cube: Hypercube) -> Result<(), ScheduleError> {
    check_structure(program, cube)?;
    let mut cells = vec![[Content::Stale; REGISTERS.len()]; cube.nodes()];
    run_phase(QUERY, &program.query, cube, &mut cells)?;
    expect_all(QUERY, program.query_clocks(), &cells, Content::SumOf(0))?;
    // Two iterations, because the second must not depend on values that the first left behind.
    for groups in 1..=2 {
        run_phase(ITERATION, &program.iteration, cube, &mut cells)?;
        let clocks = program.initiation_interval();
        expect_all(ITERATION, clocks, &cells, Content::SumOf(groups))?;
        for cell in &mut cells {
            for register in [Register::Photon, Register::Power, Register::Work] {
                cell[register as usize] = Content::Stale;
            }
        }
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
                node: 0,
                axis,
                dimension: cube.dimension(),
            });
        }
        let same_clock = |earlier: &&ScheduledStep| earlier.clock == later.clock;
        if let Some(earlier) = steps[..index].iter().find(same_clock) {
            return Err(ScheduleError::Conflict {
                phase,
                clock: later.clock,
                node: 0,
                first: earlier.step.to_string(),
                second: later.step.to_string(),
                what: shared_resource(earlier, later),
            });
        }
    }
    Ok(())
}

/// Names the resource that two steps of one clock compete for: the one instruction, if nothing else.
fn shared_resource(first: &ScheduledStep, second: &ScheduledStep) -> String {
    let (a, b) = (first.step.op.row(), second.step.op.row());
    if let (Some(unit), true) = (a.unit, a.unit == b.unit) {
        return format!("need the {unit} unit");
    }
    match a.writes.iter().find(|register| b.writes.contains(register)) {
        Some(register) => format!("write register {}", register.row().mnemonic),
        None => "need the one instruction that all cells share".to_owned(),
    }
}

type Cell = [Content; REGISTERS.len()];

fn run_phase(
    phase: &'static str,
    steps: &[ScheduledStep],
    cube: Hypercube,
    cells: &mut Vec<Cell>,
) -> Result<(), ScheduleError> {
    let mut steps = steps.to_vec();
    steps.sort_by_key(|step| step.clock);
    for scheduled in steps {
        let before = cells.clone();
        for (node, cell) in cells.iter_mut().enumerate() {
            let at = Place {
                phase,
                scheduled,
                cube,
                cells: &before,
                node,
            };
            at.execute(cell)?;
        }
    }
    Ok(())
}

/// One node at one clock, with the contents of all cells before that clock.
struct Place<'a> {
    phase: &'static str,
    scheduled: ScheduledStep,
    cube: Hypercube,
    cells: &'a [Cell],
    node: usize,
}

impl Place<'_> {
    fn execute(&self, cell: &mut Cell) -> Result<(), ScheduleError> {
        let (register, content) = match self.scheduled.step.op {
            Op::Nop => return Ok(()),
            Op::LoadQuery => return self.load_query(cell),
            op if self.phase == QUERY => return Err(self.wrong_phase(op)),
            Op::LoadPhoton => (Register::Photon, Content::Loaded),
            Op::LoadPower => (Register::Power, Content::Loaded),
            Op::SquareDifference => {
                self.expect(Register::Query, Content::Loaded)?;
                self.expect(Register::Photon, Content::Loaded)?;
                (Register::Work, Content::Distance(0))
            }
            Op::ExchangeAdd => (Register::Work, self.exchange_add()?),
            Op::Gate => {
                let complete = axis_set(self.cube.role_axes());
                self.expect(Register::Work, Content::Distance(complete))?;
                self.expect(Register::RadiusSq, Content::Loaded)?;
                self.expect(Register::Power, Content::Loaded)?;
                (Register::Work, Content::Gated(0))
            }
            Op::Accumulate => {
                let complete = axis_set(self.cube.photon_axes());
                self.expect(Register::Work, Content::Gated(complete))?;
                (Register::Sum, self.one_group_more()?)
            }
        };
        cell[register as usize] = content;
        Ok(())
    }

    fn load_query(&self, cell: &mut Cell) -> Result<(), ScheduleError> {
        if self.phase != QUERY {
            return Err(self.wrong_phase(Op::LoadQuery));
        }
        cell[Register::Query as usize] = Content::Loaded;
        cell[Register::RadiusSq as usize] = Content::Loaded;
        cell[Register::Sum as usize] = Content::SumOf(0);
        Ok(())
    }

    /// Checks an exchange-add: the neighbour must hold the same kind of value, and the axis must not be in it
    /// already.
    fn exchange_add(&self) -> Result<Content, ScheduleError> {
        let Some(axis) = self.scheduled.step.axis else {
            return Err(self.wrong_phase(Op::ExchangeAdd));
        };
        let own = self.cells[self.node][Register::Work as usize];
        let bit = 1 << axis.bit();
        let role_axes = axis_set(self.cube.role_axes());
        let sum = match own {
            Content::Distance(axes) if axes & bit == 0 && bit & role_axes != 0 => {
                Content::Distance(axes | bit)
            }
            Content::Gated(axes) if axes & bit == 0 && bit & role_axes == 0 => {
                Content::Gated(axes | bit)
            }
            _ => {
                let expected = format!(
                    "{} not yet summed across {axis}",
                    if bit & role_axes == 0 {
                        "gated powers"
                    } else {
                        "squares"
                    }
                );
                return Err(self.precedence(Register::Work, self.node, expected));
            }
        };
        let neighbour = self.cube.neighbour(self.node, axis);
        if self.cells[neighbour][Register::Work as usize] != own {
            return Err(self.precedence(Register::Work, neighbour, own.to_string()));
        }
        Ok(sum)
    }

    fn one_group_more(&self) -> Result<Content, ScheduleError> {
        match self.cells[self.node][Register::Sum as usize] {
            Content::SumOf(groups) => Ok(Content::SumOf(groups + 1)),
            _ => Err(self.precedence(Register::Sum, self.node, "a cleared sum".to_owned())),
        }
    }

    fn expect(&self, register: Register, expected: Content) -> Result<(), ScheduleError> {
        if self.cells[self.node][register as usize] == expected {
            return Ok(());
        }
        Err(self.precedence(register, self.node, expected.to_string()))
    }

    fn precedence(&self, register: Register, holder: usize, expected: String) -> ScheduleError {
        ScheduleError::Precedence {
            phase: self.phase,
            clock: self.scheduled.clock,
            node: self.node,
            step: self.scheduled.step.to_string(),
            register: register.row().mnemonic,
            holder,
            found: self.cells[holder][register as usize],
            expected,
        }
    }

    fn wrong_phase(&self, op: Op) -> ScheduleError {
        ScheduleError::WrongPhase {
            phase: self.phase,
            clock: self.scheduled.clock,
            node: self.node,
            step: op.row().mnemonic.to_owned(),
        }
    }
}

fn axis_set(axes: impl Iterator<Item = Axis>) -> u32 {
    axes.map(|axis| 1 << axis.bit()).sum()
}

fn expect_all(
    phase: &'static str,
    clocks: u32,
    cells: &[Cell],
    expected: Content,
) -> Result<(), ScheduleError> {
    for (node, cell) in cells.iter().enumerate() {
        let found = cell[Register::Sum as usize];
        if found != expected {
            return Err(ScheduleError::Incomplete {
                phase,
                clock: clocks - 1,
                node,
                register: Register::Sum.row().mnemonic,
                found,
                expected: expected.to_string(),
            });
        }
    }
    Ok(())
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
