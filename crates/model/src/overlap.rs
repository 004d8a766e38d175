//! The step-exact machine whose units work at the same time: all registers, every clock.
//!
//! It does the program's ops and knows control words only to show those that stand in the control
//! block, so that encoding (spec) and its use (HDL) are tested by the comparison too.

use photoncube_spec::overlap::{Op, Program, drain_bits};
use photoncube_spec::{
    Group, Hypercube, Inputs, Machine, Outputs, Photon, Pins, Role, Sums, Widths,
};

use crate::golden::GoldenMachine;
use crate::overlap_cell::{CellPorts, OverlapCell};

/// The registers of the control block.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
struct OverlapControl {
    /// The address of the words at work: a clock of the kernel or of the epilogue; none while they
    /// are 0.
    at_work: Option<u32>,
    /// The address of the words that come next.
    address: u32,
    /// A query is in the machine, at work or with its result.
    occupied: bool,
    /// Its last group is taken.
    last: bool,
    /// Clocks since then.
    drain: u32,
    /// The result waits to be taken.
    done: bool,
}

/// A machine with its state; starts as after power-up, all registers 0.
#[derive(Clone, Debug)]
pub struct OverlapMachine {
    machine: Machine,
    widths: Widths,
    cube: Hypercube,
    program: Program,
    /// The ops of each role that write in the clock of each address.
    steps: Vec<[Vec<Op>; 4]>,
    /// The words of each role, by address.
    words: [Vec<u32>; 4],
    drain_bits: u32,
    control: OverlapControl,
    cells: Vec<OverlapCell>,
    /// The cells before the clock edge: what neighbours send.
    before: Vec<OverlapCell>,
}

impl OverlapMachine {
    /// A machine in its power-up state.
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

    /// All roles take a group in the same clocks.
    fn takes_group(&self) -> bool {
        let takes =
            |address| self.steps[address as usize][Role::X as usize].contains(&Op::LoadPower);
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

/// What stands at a cell's ports; D has the coordinate z, as Z has, and counts photons.
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

/// An op's result appears at the end of its last clock; the kernel's clocks go round.
fn steps(program: &Program) -> Vec<[Vec<Op>; 4]> {
    let mut steps = vec![[const { Vec::new() }; 4]; program.end_address() as usize];
    for op in &program.kernel {
        let last = (op.clock + op.op.row().latency - 1) % program.interval;
        steps[last as usize][op.role as usize].push(op.op);
    }
    for op in &program.epilogue {
        let address = (program.epilogue_address() + op.clock) as usize;
        for ops in &mut steps[address] {
            ops.push(op.op);
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
                power: [Role::X, Role::Y, Role::Z].map(sum),
                count: sum(Role::D),
            },
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

    /// A kernel never waits: a group that is not there leaves a gap, and its clock counts.
    fn works(&self, _inputs: &Inputs) -> bool {
        true
    }
}
