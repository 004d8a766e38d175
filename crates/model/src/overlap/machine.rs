//! The step-exact model of an overlapped machine, whose units work at the same time: all registers, in every
//! clock.
//!
//! It executes the program's ops. It uses control words only to show those in the control block's registers.
//! Thus the comparison with the HDL also tests the encoding (spec) and the decoding (HDL) of control words.

use photoncube_spec::overlap::{Program, drain_bits};
use photoncube_spec::{
    Group, Hypercube, Inputs, Machine, OVERLAPPED, Op, Outputs, Photon, Pins, Role, Step, Sums,
    Widths,
};

use super::cell::{CellPorts, OverlapCell};
use crate::golden::GoldenMachine;

/// The registers of the control block.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
struct OverlapControl {
    /// The address of the current control words, a clock of the kernel or of the epilogue; `None` while the
    /// words are 0.
    at_work: Option<u32>,
    /// The address of the next control words.
    address: u32,
    /// A query is in the machine, at work or with a waiting result.
    occupied: bool,
    /// The query's last group was taken.
    last: bool,
    /// The clocks since the query's last group was taken.
    drain: u32,
    /// The result is complete and waits to be taken.
    done: bool,
}

/// An overlapped machine with its state. It starts in the power-up state, in which all registers are 0.
#[derive(Clone, Debug)]
pub struct OverlapMachine {
    machine: Machine,
    widths: Widths,
    cube: Hypercube,
    program: Program,
    /// For each address and role, the steps that write in that clock.
    steps: Vec<[Vec<Step>; 4]>,
    /// The control words of each role, by address.
    words: [Vec<u32>; 4],
    drain_bits: u32,
    control: OverlapControl,
    cells: Vec<OverlapCell>,
    /// The cells before the clock edge, whose registers the neighbours receive.
    before: Vec<OverlapCell>,
}

impl OverlapMachine {
    /// Makes a machine in its power-up state.
    pub fn new(machine: &Machine) -> Self {
        let program = machine
            .overlap_program()
            .expect("the machine's units overlap");
        let cells = vec![OverlapCell::default(); machine.hypercube().nodes()];
        Self {
            machine: *machine,
            widths: Widths::of(machine),
            cube: machine.hypercube(),
            steps: steps(&program),
            words: Role::ALL.map(|role| program.control_words(role)),
            drain_bits: drain_bits(&program),
            program,
            control: OverlapControl::default(),
            before: cells.clone(),
            cells,
        }
    }

    /// Whether a group is taken in this clock. All roles take a group in the same clocks.
    fn takes_group(&self) -> bool {
        let takes = |address| {
            self.steps[address as usize][Role::X as usize].contains(&Step::new(Op::LoadPower))
        };
        self.control.at_work.is_some_and(takes) && !self.control.last
    }

    fn next_control(
        &self,
        inputs: &Inputs,
        query_taken: bool,
        group_taken: bool,
    ) -> OverlapControl {
        let now = self.control;
        let (epilogue, end) = (self.program.epilogue_address(), self.program.end_address());
        let mut next = now;
        if now.last {
            next.drain = (now.drain + 1) % (1 << self.drain_bits);
        }
        if group_taken && inputs.group.last {
            next.last = true;
            next.drain = 0;
        }
        if now.done && inputs.result_ready {
            next.done = false;
            next.occupied = false;
        }
        next.at_work = None;
        if now.done || !(now.occupied || query_taken) {
            return next;
        }
        next.occupied = true;
        next.at_work = (now.address < end).then_some(now.address);
        if now.address == end {
            next.address = 0;
            next.last = false;
            next.done = true;
        } else if now.last && now.drain + 3 == self.program.drain_clocks {
            next.address = epilogue;
        } else if now.address + 1 == epilogue {
            next.address = 0;
        } else {
            next.address = now.address + 1;
        }
        next
    }

    fn clock_cells(&mut self, inputs: &Inputs, query_ready: bool, group_taken: bool) {
        self.before.copy_from_slice(&self.cells);
        let nothing = [const { Vec::new() }; 4];
        let at_work = self.control.at_work;
        let steps = at_work.map_or(&nothing, |address| &self.steps[address as usize]);
        for (node, cell) in self.cells.iter_mut().enumerate() {
            let role = self.cube.role(node);
            let ports = ports(inputs, role, self.cube.photon(node), group_taken);
            let neighbour = |axis| &self.before[self.cube.neighbour(node, axis)];
            cell.clock(&steps[role as usize], &ports, neighbour, &self.widths);
            if query_ready {
                cell.take_query(&ports);
            }
        }
    }
}

/// The values at a cell's ports. A D cell has the coordinate z, as a Z cell has, and counts photons.
fn ports(inputs: &Inputs, role: Role, lane: usize, group_taken: bool) -> CellPorts {
    let Group { lanes, .. } = &inputs.group;
    let lane = lanes.get(lane).copied().unwrap_or_default();
    let Photon {
        position, power, ..
    } = lane.photon;
    let coordinate = role.coordinate().unwrap_or(2);
    CellPorts {
        query: inputs.query.position[coordinate],
        radius_sq: inputs.query.radius_sq,
        photon: position[coordinate],
        power: role.coordinate().map_or(1, |channel| power[channel].into()),
        present: group_taken && lane.present,
    }
}

/// The steps by the clock in which they write, the last clock of the op. The kernel's clocks repeat cyclically.
fn steps(program: &Program) -> Vec<[Vec<Step>; 4]> {
    let mut steps = vec![[const { Vec::new() }; 4]; program.end_address() as usize];
    for op in &program.kernel {
        let last = (op.clock + OVERLAPPED.op(op.step.op).latency - 1) % program.interval;
        steps[last as usize][op.role as usize].push(op.step);
    }
    for op in &program.epilogue {
        let address = (program.epilogue_address() + op.clock) as usize;
        for ops in &mut steps[address] {
            ops.push(op.step);
        }
    }
    steps
}

impl GoldenMachine for OverlapMachine {
    fn outputs(&self, _inputs: &Inputs) -> Outputs {
        let sum = |role| self.cells[self.cube.result_node(role)].sum;
        Outputs {
            query_ready: !self.control.occupied,
            group_ready: self.takes_group(),
            result_valid: self.control.done,
            result: Sums {
                power: [Role::X, Role::Y, Role::Z].map(|role| sum(role).into()),
                count: sum(Role::D),
            },
            ..Outputs::default()
        }
    }

    fn observe(&self, inputs: &Inputs, row: &mut Vec<u64>) {
        row.extend(Pins::output_row(&self.machine, &self.outputs(inputs)));
        let OverlapControl {
            at_work,
            address,
            occupied,
            last,
            drain,
            done,
        } = self.control;
        row.push(address.into());
        row.push(occupied.into());
        row.push(last.into());
        row.push(drain.into());
        row.push(done.into());
        let word = |words: &Vec<u32>| at_work.map_or(0, |address| words[address as usize]);
        row.extend(self.words.iter().map(word).map(u64::from));
        for cell in &self.cells {
            row.extend(cell.registers());
        }
    }

    fn clock(&mut self, inputs: &Inputs) {
        let outputs = self.outputs(inputs);
        let query_taken = outputs.query_ready && inputs.query_valid;
        let group_taken = outputs.group_ready && inputs.group_valid;
        self.clock_cells(inputs, outputs.query_ready, group_taken);
        self.control = if inputs.reset {
            OverlapControl::default()
        } else {
            self.next_control(inputs, query_taken, group_taken)
        };
    }

    /// Always true: a kernel never waits. A missing group leaves a gap, and its clock counts.
    fn works(&self, _inputs: &Inputs) -> bool {
        true
    }
}
