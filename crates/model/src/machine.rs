//! The step-exact machine: all registers of all cells and of the control block, every clock.
//!
//! It executes decoded [`Step`]s and knows nothing of control words, so that encoding (spec) and
//! its use (HDL) are tested by the comparison too.

use photoncube_spec::{Hypercube, Inputs, Lane, Machine, Op, Outputs, Role, Step, Sums, Widths};

/// The registers of one cell.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct CellState {
    /// `q`: the query point's coordinate.
    pub query: u32,
    /// `r`: the squared search radius.
    pub radius_sq: u32,
    /// `p`: the photon's coordinate.
    pub photon: u32,
    /// `w`: the photon's power in the cell's channel.
    pub power: u32,
    /// `v`: square, distance, gated power.
    pub work: u32,
    /// `s`: the sum of the query.
    pub sum: u64,
}

/// The registers of the control block.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct ControlState {
    /// The next step, as an index into the program: the query phase, then the iteration.
    pub address: usize,
    /// The group at work is the query's last.
    pub last: bool,
    /// The result waits to be taken.
    pub done: bool,
}

/// A machine with its state; starts as after power-up, all registers 0.
#[derive(Clone, Debug)]
pub struct StepMachine {
    cube: Hypercube,
    widths: Widths,
    steps: Vec<Step>,
    /// The address of the iteration's first step.
    iteration: usize,
    /// The address of the last step that reads the group, which takes it.
    taker: usize,
    control: ControlState,
    cells: Vec<CellState>,
    /// The cells before the clock edge: what neighbours send.
    before: Vec<CellState>,
}

impl StepMachine {
    /// A machine in its power-up state.
    pub fn new(machine: &Machine) -> Self {
        let program = machine.microprogram();
        let steps = program.steps();
        let reads_group = |step: &Step| matches!(step.op, Op::LoadPhoton | Op::LoadPower);
        let cells = vec![CellState::default(); machine.hypercube().nodes()];
        Self {
            cube: machine.hypercube(),
            widths: Widths::of(machine),
            iteration: program.query_clocks() as usize,
            taker: steps.iter().rposition(reads_group).unwrap_or(0),
            steps,
            control: ControlState::default(),
            before: cells.clone(),
            cells,
        }
    }

    /// The control block's registers.
    pub fn control(&self) -> ControlState {
        self.control
    }

    /// The cells, by node index.
    pub fn cells(&self) -> &[CellState] {
        &self.cells
    }

    /// The step that this clock will do, if nothing makes it wait.
    pub fn step(&self) -> Step {
        self.steps[self.control.address]
    }

    /// The output pins in this clock; they do not depend on the inputs.
    pub fn outputs(&self) -> Outputs {
        let ready = |wanted| !self.control.done && wanted;
        let sum = |role| self.cells[self.cube.result_node(role)].sum;
        Outputs {
            query_ready: ready(self.step().op == Op::LoadQuery),
            group_ready: ready(self.control.address == self.taker),
            result_valid: self.control.done,
            result: Sums {
                power: [sum(Role::X), sum(Role::Y), sum(Role::Z)],
                count: sum(Role::D),
            },
        }
    }

    /// Appends the output pins and all registers to a row, in the order of
    /// [`photoncube_spec::Pins::observed`].
    pub fn observe(&self, row: &mut Vec<u64>) {
        row.extend(photoncube_spec::Pins::output_row(&self.outputs()));
        row.push(self.control.address as u64);
        row.push(u64::from(self.control.last));
        row.push(u64::from(self.control.done));
        for cell in &self.cells {
            row.extend([
                u64::from(cell.query),
                u64::from(cell.radius_sq),
                u64::from(cell.photon),
                u64::from(cell.power),
                u64::from(cell.work),
                cell.sum,
            ]);
        }
    }

    /// One rising clock edge with these inputs. Inputs must fit the machine's widths.
    pub fn clock(&mut self, inputs: &Inputs) {
        let step = self.step();
        let waits = match step.op {
            Op::LoadQuery => !inputs.query_valid,
            Op::LoadPhoton | Op::LoadPower => !inputs.group_valid,
            _ => false,
        };
        let runs = !self.control.done && !waits;
        if runs {
            self.execute(step, inputs);
        }
        self.control = if inputs.reset {
            ControlState::default()
        } else {
            self.next_control(runs, inputs)
        };
    }

    fn next_control(&self, runs: bool, inputs: &Inputs) -> ControlState {
        let mut next = self.control;
        if self.control.done {
            next.done = !inputs.result_ready;
            return next;
        }
        if !runs {
            return next;
        }
        if self.control.address == self.taker {
            next.last = inputs.group.last;
        }
        if self.control.address + 1 < self.steps.len() {
            next.address += 1;
        } else if self.control.last {
            next.address = 0;
            next.done = true;
        } else {
            next.address = self.iteration;
        }
        next
    }

    fn execute(&mut self, step: Step, inputs: &Inputs) {
        self.before.copy_from_slice(&self.cells);
        let work_mask = u32::MAX >> (u32::BITS - self.widths.work);
        let sum_mask = u64::MAX >> (u64::BITS - self.widths.sum);
        for (node, cell) in self.cells.iter_mut().enumerate() {
            let role = self.cube.role(node);
            let lane = || inputs.group.lanes[self.cube.photon(node)];
            match step.op {
                Op::Nop => {}
                Op::LoadQuery => {
                    cell.query = coordinate(role, inputs.query.position);
                    cell.radius_sq = inputs.query.radius_sq;
                    cell.sum = 0;
                }
                Op::LoadPhoton => {
                    cell.photon = coordinate(role, lane().photon.position);
                }
                Op::LoadPower => cell.power = power(role, &lane()),
                Op::SquareDifference => cell.work = cell.query.abs_diff(cell.photon).pow(2),
                Op::ExchangeAdd => {
                    let axis = step.axis.expect("a checked program names the axis");
                    let sent = self.before[self.cube.neighbour(node, axis)].work;
                    cell.work = cell.work.wrapping_add(sent) & work_mask;
                }
                Op::Gate => {
                    let out_of_range = cell.work > cell.radius_sq;
                    cell.work = if out_of_range { 0 } else { cell.power };
                }
                Op::Accumulate => {
                    cell.sum = cell.sum.wrapping_add(u64::from(cell.work)) & sum_mask;
                }
            }
        }
    }
}

fn coordinate(role: Role, position: [u32; 3]) -> u32 {
    role.coordinate().map_or(0, |index| position[index])
}

/// The power in the role's channel; a distance cell counts the photon. An absent one has none.
fn power(role: Role, lane: &Lane) -> u32 {
    if !lane.present {
        return 0;
    }
    role.coordinate()
        .map_or(1, |index| lane.photon.power[index])
}
