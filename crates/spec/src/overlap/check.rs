//! The checker of an overlapped program. It follows the kind of value in every register of a quad, clock by
//! clock, over whole queries, with overlapping iterations as in the machine.
//!
//! It is independent of the scheduler and its graph. It checks what must have happened before each op, and it
//! is the oracle for the program that model and HDL both read.

use std::collections::{BTreeMap, BTreeSet};

use super::content::{ALL_SQUARES, Content};
use super::program::{KernelOp, Program};
use crate::cell::{
    OVERLAPPED, Op, POWER_WORDS, Place, Read, Register, ScheduleError, ScheduledStep, Step, Unit,
};
use crate::hypercube::{Axis, Hypercube, Role};

/// Checks a program. Each unit does one op, each register has one writer and each link one word in a clock.
/// Every operand belongs to the right group, is complete, and is not overwritten before it is read. At the
/// end of a query every node holds the sum of all its groups, each once, across the photon axes. The checker
/// runs queries of one group up to some more groups than the kernel has in flight, with and without gaps.
///
/// # Errors
/// The first violation, with its clock and node.
pub fn check_program(program: &Program) -> Result<(), ScheduleError> {
    check_takes(program)?;
    let in_flight = program.stages() as usize * program.groups;
    // The longest query first: a word that overwrites another is then of another group, and the error names
    // it.
    for groups in (1..=in_flight + program.groups + 1).rev() {
        // The last group is always present, so the first pass of the loop is the query without a gap.
        for missing in (0..groups).rev() {
            let is_there = |slot| slot == groups - 1 || slot != missing;
            Query::run(program, (0..groups).map(is_there).collect())?;
        }
        let every_third = |slot| (groups - 1 - slot) % 3 == 0;
        Query::run(program, (0..groups).map(every_third).collect())?;
    }
    Ok(())
}

/// Checks that a group is taken by all nodes at once, since it stands on the pins for all of them.
fn check_takes(program: &Program) -> Result<(), ScheduleError> {
    for op in &program.kernel {
        if op.clock >= program.interval {
            return Err(ScheduleError::NoSuchClock {
                place: place("kernel", Some(0), op.clock, op.role, op.step),
                clock: op.clock,
                interval: program.interval,
            });
        }
    }
    for group in 0..program.groups {
        let clock = program.take_clock(group);
        for role in Role::ALL {
            let is_take = |op: &&KernelOp| op.step.op == Op::LoadPower && op.group == group;
            let mut takes = program.kernel.iter().filter(is_take);
            if !takes.any(|op| (op.role, op.clock, op.stage) == (role, clock, 0)) {
                let node = node(role);
                return Err(ScheduleError::NotTakenByAll { clock, node });
            }
        }
    }
    Ok(())
}

fn node(role: Role) -> usize {
    Hypercube::new(Hypercube::MIN_DIMENSION).result_node(role)
}

fn place(phase: &'static str, pass: Option<u32>, clock: u32, role: Role, step: Step) -> Box<Place> {
    Box::new(Place {
        phase,
        pass,
        clock,
        node: node(role),
        step: step.to_string(),
    })
}

type Cell = BTreeMap<Register, Content>;

/// A step that starts in this clock.
#[derive(Clone)]
struct Start {
    place: Box<Place>,
    role: Role,
    step: Step,
    /// The group that the step must work on, if it is present.
    group: Option<u32>,
}

/// A result that is not yet written.
struct Arriving {
    /// The clock whose ending edge writes the result.
    clock: u32,
    start: Start,
    content: Content,
}

/// The state of a query that runs in the machine.
struct Query<'a> {
    program: &'a Program,
    /// Whether a group is present, for each clock in which one can be taken. The last group is always
    /// present.
    slots: Vec<bool>,
    /// The cells of the quad, by role.
    cells: [Cell; 4],
    results: Vec<Arriving>,
}

impl<'a> Query<'a> {
    fn run(program: &'a Program, slots: Vec<bool>) -> Result<(), ScheduleError> {
        let mut query = Self {
            program,
            slots,
            cells: [(); 4].map(|()| loaded_cell()),
            results: Vec::new(),
        };
        let last = query.slots.len() - 1;
        let pass = (last / program.groups) as u32;
        let taken = pass * program.interval + program.take_clock(last % program.groups);
        for clock in 0..taken + program.drain_clocks {
            query.clock(clock, query.kernel_starts(clock))?;
        }
        // A result that is not yet written is lost, because the control word that would write it does not
        // come.
        query.results.clear();
        for clock in 0..program.epilogue_clocks() {
            query.clock(clock, query.epilogue_starts(clock))?;
        }
        query.check_sums()
    }

    fn kernel_starts(&self, clock: u32) -> Vec<Start> {
        let (pass, clock) = (clock / self.program.interval, clock % self.program.interval);
        let ops = self.program.kernel.iter().filter(|op| op.clock == clock);
        ops.map(|op| Start {
            place: place("kernel", Some(pass), clock, op.role, op.step),
            role: op.role,
            step: op.step,
            group: self.group(pass, op),
        })
        .collect()
    }

    /// The group that an op of this pass works on, if it is present.
    fn group(&self, pass: u32, op: &KernelOp) -> Option<u32> {
        let iteration = pass.checked_sub(op.stage)?;
        let slot = iteration as usize * self.program.groups + op.group;
        let there = self.slots.get(slot).copied().unwrap_or(false);
        there.then_some(slot as u32)
    }

    fn epilogue_starts(&self, clock: u32) -> Vec<Start> {
        let ops = self.program.epilogue.iter().filter(|op| op.clock == clock);
        ops.flat_map(|&ScheduledStep { step, .. }| {
            Role::ALL.map(|role| Start {
                place: place("epilogue", None, clock, role, step),
                role,
                step,
                group: None,
            })
        })
        .collect()
    }

    fn clock(&mut self, clock: u32, starts: Vec<Start>) -> Result<(), ScheduleError> {
        check_units_and_links(&starts)?;
        for start in starts {
            let content = self.result(&start)?;
            let clock = clock + OVERLAPPED.op(start.step.op).latency - 1;
            self.results.push(Arriving {
                clock,
                start,
                content,
            });
        }
        self.write(clock)
    }

    /// Applies the clock edge: writes the results that arrive in this clock.
    fn write(&mut self, clock: u32) -> Result<(), ScheduleError> {
        for cell in &mut self.cells {
            let square = cell[&Register::Square].clone();
            cell.insert(Register::Addend, square);
            cell.insert(Register::Operand, Content::Nothing);
            cell.insert(Register::InRange, Content::Stale);
        }
        let (now, later): (Vec<_>, Vec<_>) = std::mem::take(&mut self.results)
            .into_iter()
            .partition(|result| result.clock == clock);
        self.results = later;
        let mut written = BTreeMap::new();
        for Arriving { start, content, .. } in now {
            for register in OVERLAPPED.writes(start.step) {
                if let Some(other) = written.insert((start.role, register), start.step) {
                    let what = format!("write {}", OVERLAPPED.register(register).mnemonic);
                    return Err(conflict(&start, other, what));
                }
                self.cells[start.role as usize].insert(register, content.clone());
            }
        }
        Ok(())
    }

    fn result(&self, start: &Start) -> Result<Content, ScheduleError> {
        if start.place.phase == "epilogue" {
            return self.crossing(start);
        }
        match start.step.op {
            Op::Receive if matches!(start.step.axis, Some(Axis::X | Axis::Y)) => {
                Err(ScheduleError::WrongPhase {
                    place: start.place.clone(),
                })
            }
            Op::MovePower(_) => self.moved(start),
            Op::Gate => self.gated(start),
            Op::Accumulate => self.accumulated(start),
            _ => match start.group {
                Some(group) => self.of_group(start, group),
                None if start.step.op == Op::LoadPower => Ok(Content::Nothing),
                None => Ok(Content::Stale),
            },
        }
    }

    /// The result of an op whose result alone changes no sum.
    fn of_group(&self, start: &Start, group: u32) -> Result<Content, ScheduleError> {
        let coordinate = start.role.coordinate().unwrap_or(2);
        let complete = Content::Squares(ALL_SQUARES, group);
        match start.step.op {
            Op::LoadPhoton => Ok(Content::Coordinate(coordinate, group)),
            Op::LoadPower => Ok(Content::Power(group)),
            Op::SquareDifference => {
                self.expect(start, Register::Query, None, Content::Query)?;
                let photon = Content::Coordinate(coordinate, group);
                self.expect(start, Register::Photon, None, photon)?;
                Ok(Content::Squares(1 << coordinate, group))
            }
            Op::Receive => {
                let mut set = 0;
                for Read { register, across } in OVERLAPPED.reads(start.step) {
                    set = self.squares(start, register, across, group, set)?;
                }
                Ok(Content::Squares(set, group))
            }
            Op::Add => {
                let own = self.squares(start, Register::Addend, None, group, 0)?;
                let other = self.squares(start, Register::Operand, None, group, own)?;
                Ok(Content::Squares(own | other, group))
            }
            Op::Keep => self.expect(start, Register::Work, start.step.axis, complete),
            Op::Compare => {
                self.expect(start, Register::RadiusSq, None, Content::Query)?;
                self.expect(start, Register::Distance, None, complete)?;
                Ok(Content::InRange(group))
            }
            Op::Relay => self.expect(start, Register::Distance, start.step.axis, complete),
            _ => unreachable!("has its own rule"),
        }
    }

    /// The squares of the group, if none of them is in `others` too.
    fn squares(
        &self,
        start: &Start,
        register: Register,
        across: Option<Axis>,
        group: u32,
        others: u32,
    ) -> Result<u32, ScheduleError> {
        match self.read(start, register, across) {
            (_, &Content::Squares(set, of)) if of == group && set & others == 0 => Ok(set),
            _ => {
                let expected = match others {
                    0 => format!("squares of group {group}"),
                    _ => format!("squares other than {}", Content::Squares(others, group)),
                };
                Err(self.precedence(start, register, across, expected))
            }
        }
    }

    /// The content of a power that is moved: a power, or its absence.
    fn moved(&self, start: &Start) -> Result<Content, ScheduleError> {
        let register = OVERLAPPED.reads(start.step)[0].register;
        match start.group {
            Some(group) => self.expect(start, register, None, Content::Power(group)),
            None => Ok(self.read(start, register, None).1.clone()),
        }
    }

    fn gated(&self, start: &Start) -> Result<Content, ScheduleError> {
        let power = Register::Power(POWER_WORDS - 1);
        let Some(group) = start.group else {
            return self.expect(start, power, None, Content::Nothing);
        };
        self.expect(start, power, None, Content::Power(group))?;
        self.expect(start, Register::InRange, None, Content::InRange(group))?;
        Ok(Content::Gated(group))
    }

    fn accumulated(&self, start: &Start) -> Result<Content, ScheduleError> {
        let (_, sum) = self.read(start, Register::Sum, None);
        let Some(group) = start.group else {
            self.expect(start, Register::Operand, None, Content::Nothing)?;
            return Ok(sum.clone());
        };
        self.expect(start, Register::Operand, None, Content::Gated(group))?;
        match sum {
            Content::Sum(groups, 0) if !groups.contains(&group) => {
                let mut groups = groups.clone();
                groups.insert(group);
                Ok(Content::Sum(groups, 0))
            }
            _ => {
                let expected = format!("a sum without group {group}");
                Err(self.precedence(start, Register::Sum, None, expected))
            }
        }
    }

    /// Receives a sum across a photon axis. All quads do the same, so the neighbour holds what the cell
    /// itself holds.
    fn crossing(&self, start: &Start) -> Result<Content, ScheduleError> {
        let (_, sum) = self.read(start, Register::Sum, None);
        let Content::Sum(groups, axes) = sum else {
            let expected = "the sum of the query".to_owned();
            return Err(self.precedence(start, Register::Sum, None, expected));
        };
        match (start.step.op, start.step.axis) {
            (Op::Receive, Some(axis @ (Axis::X | Axis::Y))) if axes & (1 << axis.bit()) == 0 => {
                Ok(Content::SumAcross(axis, groups.clone(), *axes))
            }
            (Op::Accumulate, _) => match self.read(start, Register::Operand, None).1 {
                Content::SumAcross(axis, g, a) if (g, a) == (groups, axes) => {
                    Ok(Content::Sum(groups.clone(), axes | (1 << axis.bit())))
                }
                _ => {
                    let expected = format!("{sum}, from a neighbour");
                    Err(self.precedence(start, Register::Operand, None, expected))
                }
            },
            _ => Err(ScheduleError::WrongPhase {
                place: start.place.clone(),
            }),
        }
    }

    /// The cell that holds a register, and the register's content.
    fn read(&self, start: &Start, register: Register, across: Option<Axis>) -> (Role, &Content) {
        let holder = across.map_or(start.role, |axis| start.role.across(axis));
        (holder, &self.cells[holder as usize][&register])
    }

    fn expect(
        &self,
        start: &Start,
        register: Register,
        across: Option<Axis>,
        expected: Content,
    ) -> Result<Content, ScheduleError> {
        if *self.read(start, register, across).1 == expected {
            return Ok(expected);
        }
        Err(self.precedence(start, register, across, expected.to_string()))
    }

    fn precedence(
        &self,
        start: &Start,
        register: Register,
        across: Option<Axis>,
        expected: String,
    ) -> ScheduleError {
        let (holder, found) = self.read(start, register, across);
        ScheduleError::Precedence {
            place: start.place.clone(),
            register: OVERLAPPED.register(register).mnemonic,
            holder: node(holder),
            found: found.to_string(),
            expected,
        }
    }

    fn check_sums(&self) -> Result<(), ScheduleError> {
        let there = (0..).zip(&self.slots).filter(|(_, there)| **there);
        let groups: BTreeSet<u32> = there.map(|(slot, _)| slot).collect();
        let axes = (1 << Axis::X.bit()) | (1 << Axis::Y.bit());
        let expected = Content::Sum(groups, axes);
        for role in Role::ALL {
            let found = &self.cells[role as usize][&Register::Sum];
            if *found != expected {
                let groups = self.slots.iter().filter(|there| **there).count();
                return Err(ScheduleError::Incomplete {
                    after: format!("a query of {groups} groups"),
                    node: node(role),
                    found: found.to_string(),
                    expected: expected.to_string(),
                });
            }
        }
        Ok(())
    }
}

/// The cell in the clock after it has taken a query.
fn loaded_cell() -> Cell {
    let content = |register| match register {
        Register::Query | Register::RadiusSq => Content::Query,
        Register::Sum => Content::Sum(BTreeSet::new(), 0),
        Register::Operand | Register::Power(_) => Content::Nothing,
        _ => Content::Stale,
    };
    let registers = OVERLAPPED.registers.iter().map(|row| row.register);
    registers
        .map(|register| (register, content(register)))
        .collect()
}

fn check_units_and_links(starts: &[Start]) -> Result<(), ScheduleError> {
    let mut units: BTreeMap<(Role, Unit), Step> = BTreeMap::new();
    let mut links: BTreeMap<(Role, Axis), Register> = BTreeMap::new();
    for start in starts {
        if let Some(unit) = OVERLAPPED.op(start.step.op).unit
            && let Some(other) = units.insert((start.role, unit), start.step)
        {
            return Err(conflict(start, other, format!("need the {unit} unit")));
        }
        let across = OVERLAPPED.reads(start.step).into_iter();
        for (read, axis) in across.filter_map(|read| Some((read, read.across?))) {
            let sender = start.role.across(axis);
            // On a photon axis the sender is the same role of another quad.
            let other = links.insert((sender, axis), read.register);
            if let Some(other) = other.filter(|other| *other != read.register) {
                return Err(ScheduleError::Link {
                    place: start.place.clone(),
                    sender: node(sender),
                    axis,
                    register: OVERLAPPED.register(read.register).mnemonic,
                    other: OVERLAPPED.register(other).mnemonic,
                });
            }
        }
    }
    Ok(())
}

fn conflict(start: &Start, other: Step, what: String) -> ScheduleError {
    ScheduleError::Conflict {
        place: start.place.clone(),
        other: other.to_string(),
        what,
    }
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;
