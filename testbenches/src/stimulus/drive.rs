//! Drives cases through the golden model clock by clock and writes down what went in and what
//! every signal was.

use std::ops::ControlFlow;

use photoncube_model::{StepMachine, gather};
use photoncube_spec::{Group, Inputs, Lane, Machine, Microprogram, Op, Outputs, Pins, Query};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::cases::{Case, Cases};
use super::{Block, StimulusError};

/// How often a side of a stream is ready or valid.
#[derive(Copy, Clone, Debug)]
pub(crate) enum Pace {
    Always,
    Mostly,
    Half,
    Rarely,
}

impl Pace {
    fn any(rng: &mut Pcg64) -> Self {
        match rng.random_range(0..8) {
            0..=3 => Self::Always,
            4 | 5 => Self::Mostly,
            6 => Self::Half,
            _ => Self::Rarely,
        }
    }

    fn draw(self, rng: &mut Pcg64) -> bool {
        match self {
            Self::Always => true,
            Self::Mostly => rng.random_ratio(7, 8),
            Self::Half => rng.random(),
            Self::Rarely => rng.random_ratio(1, 12),
        }
    }
}

/// The paces of the three streams, and whether a reset may come at any time.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Traffic {
    query: Pace,
    group: Pace,
    result: Pace,
    resets: bool,
    /// Words that are not asked for are random, not the next ones.
    garbage: bool,
}

impl Traffic {
    /// No waiting, no reset, no garbage: the machine's own pace.
    pub const STREAMING: Self = Self {
        query: Pace::Always,
        group: Pace::Always,
        result: Pace::Always,
        resets: false,
        garbage: false,
    };

    pub fn any(rng: &mut Pcg64, may_reset: bool) -> Self {
        Self {
            query: Pace::any(rng),
            group: Pace::any(rng),
            result: Pace::any(rng),
            resets: may_reset && rng.random_ratio(1, 4),
            garbage: true,
        }
    }
}

/// A block is handed on when it has this many clocks: small enough for the caches.
const BLOCK_CLOCKS: usize = 2048;

/// What becomes of the blocks; `Break` ends the generation.
pub(crate) type Sink<'a> = dyn FnMut(Block) -> ControlFlow<()> + 'a;

/// Runs the golden model, a chunk at a time.
pub(crate) struct Driver<'a> {
    machine: &'a Machine,
    program: Microprogram,
    model: StepMachine,
    rng: Pcg64,
    block: Block,
    sink: &'a mut Sink<'a>,
    /// Of the chunk so far.
    clocks: u64,
    /// Of the chunk so far.
    iterations: u64,
}

/// Cases under way.
struct Batch<'a> {
    cases: &'a [Case],
    traffic: Traffic,
    /// The query that the machine works on.
    in_flight: Option<usize>,
    /// The first query that has not been taken.
    next_query: usize,
    /// The case, and the index in it, of the group to be offered next.
    next_group: (usize, usize),
    /// That group stands on the pins and stays until it is taken.
    offered: bool,
    /// Clocks since the query was taken, its own included, without those spent waiting.
    occupied: u64,
}

impl<'a> Driver<'a> {
    pub fn new(machine: &'a Machine, sink: &'a mut Sink<'a>) -> Self {
        Self {
            machine,
            program: machine.microprogram(),
            model: StepMachine::new(machine),
            rng: Pcg64::seed_from_u64(0),
            block: Block::default(),
            sink,
            clocks: 0,
            iterations: 0,
        }
    }

    /// Iterations since the chunk began.
    pub fn iterations(&self) -> u64 {
        self.iterations
    }

    /// The chunk's source of random numbers.
    pub fn rng(&mut self) -> &mut Pcg64 {
        &mut self.rng
    }

    /// Begins a chunk: brings every register to a value that does not depend on what it held, so
    /// that the chunk does not depend on the chunks before it.
    pub fn begin_chunk(&mut self, chunk: u64, seed: u64) -> Result<ControlFlow<()>, StimulusError> {
        if self.flush().is_break() {
            return Ok(ControlFlow::Break(()));
        }
        (self.clocks, self.iterations) = (0, 0);
        self.rng = Pcg64::seed_from_u64(seed);
        self.block = Block {
            chunk,
            seed,
            ..Block::default()
        };
        let zeros = Case {
            query: Query::default(),
            groups: vec![Group {
                last: true,
                ..self.idle_inputs().group
            }],
        };
        let reset = Inputs {
            reset: true,
            ..self.idle_inputs()
        };
        if self.step(&reset).is_break()
            || self.run(&[zeros], Traffic::STREAMING)?.is_break()
            || self.step(&reset).is_break()
        {
            return Ok(ControlFlow::Break(()));
        }
        let (mut scrubbed, mut fresh) = (Vec::new(), Vec::new());
        self.model.observe(&mut scrubbed);
        self.after_the_same(&self.block.inputs).observe(&mut fresh);
        if scrubbed != fresh {
            return Err(StimulusError::NotScrubbed {
                machine: self.machine.name,
            });
        }
        // None of this is what anyone asked for.
        self.iterations = 0;
        (self.block.iterations, self.block.results) = (0, 0);
        Ok(ControlFlow::Continue(()))
    }

    /// The machine after these rows of inputs from power-up on.
    fn after_the_same(&self, rows: &[u64]) -> StepMachine {
        let mut fresh = StepMachine::new(self.machine);
        let columns = Pins::of(self.machine).inputs.len();
        for row in rows.chunks_exact(columns) {
            fresh.clock(&Pins::inputs_of(self.machine, row));
        }
        fresh
    }

    /// Some clocks with nothing to do.
    pub fn idle(&mut self, clocks: u32) -> ControlFlow<()> {
        let mut inputs = self.idle_inputs();
        for _ in 0..clocks {
            let mut cases = Cases::new(self.machine, &mut self.rng);
            cases.garbage_group(&mut inputs.group);
            inputs.query = cases.garbage_query();
            inputs.result_ready = self.rng.random();
            if self.step(&inputs).is_break() {
                return ControlFlow::Break(());
            }
        }
        ControlFlow::Continue(())
    }

    /// Runs cases until all their results are taken, or lost in a reset.
    pub fn run(
        &mut self,
        cases: &[Case],
        traffic: Traffic,
    ) -> Result<ControlFlow<()>, StimulusError> {
        let mut batch = Batch {
            cases,
            traffic,
            in_flight: None,
            next_query: 0,
            next_group: (0, 0),
            offered: false,
            occupied: 0,
        };
        let mut inputs = self.idle_inputs();
        while batch.in_flight.is_some() || batch.next_query < cases.len() {
            let outputs = self.model.outputs();
            inputs.reset = traffic.resets && self.rng.random_ratio(1, 100);
            inputs.result_ready = traffic.result.draw(&mut self.rng);
            self.offer_query(&mut inputs, outputs, &batch);
            self.offer_group(&mut inputs, &mut batch);
            let works = self.works(&inputs);
            if self.step(&inputs).is_break() {
                return Ok(ControlFlow::Break(()));
            }
            if inputs.reset {
                batch.in_flight = None;
                batch.next_group = (batch.next_query, 0);
                batch.offered = false;
            } else {
                batch.occupied += u64::from(works);
                self.transfer(&inputs, outputs, &mut batch)?;
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// A query may be withdrawn until it is taken, and before that any other word may stand in
    /// its place.
    fn offer_query(&mut self, inputs: &mut Inputs, outputs: Outputs, batch: &Batch<'_>) {
        let traffic = batch.traffic;
        let next = batch.cases.get(batch.next_query);
        let feint = traffic.garbage && !outputs.query_ready;
        inputs.query_valid = traffic.query.draw(&mut self.rng) && (next.is_some() || feint);
        let wanted = inputs.query_valid && outputs.query_ready;
        inputs.query = match next {
            Some(case) if wanted || !traffic.garbage => case.query,
            _ if traffic.garbage => Cases::new(self.machine, &mut self.rng).garbage_query(),
            _ => Query::default(),
        };
    }

    fn offer_group(&mut self, inputs: &mut Inputs, batch: &mut Batch<'_>) {
        let (case, index) = batch.next_group;
        let there = case < batch.cases.len();
        if !batch.offered && there && batch.traffic.group.draw(&mut self.rng) {
            inputs.group.clone_from(&batch.cases[case].groups[index]);
            batch.offered = true;
        }
        inputs.group_valid = batch.offered;
        if !batch.offered && batch.traffic.garbage {
            Cases::new(self.machine, &mut self.rng).garbage_group(&mut inputs.group);
        }
    }

    /// Whether the machine does something with these inputs, rather than wait for a stream.
    fn works(&self, inputs: &Inputs) -> bool {
        if self.model.control().done {
            return inputs.result_ready;
        }
        let row = self.model.step().op.row();
        (!row.reads_query || inputs.query_valid) && (!row.reads_group || inputs.group_valid)
    }

    fn transfer(
        &mut self,
        inputs: &Inputs,
        outputs: Outputs,
        batch: &mut Batch<'_>,
    ) -> Result<(), StimulusError> {
        if outputs.query_ready && inputs.query_valid {
            batch.in_flight = Some(batch.next_query);
            batch.next_query += 1;
            batch.occupied = 1;
        }
        if outputs.group_ready && inputs.group_valid {
            let (case, index) = batch.next_group;
            batch.next_group = if inputs.group.last {
                (case + 1, 0)
            } else {
                (case, index + 1)
            };
            batch.offered = false;
        }
        if outputs.result_valid && inputs.result_ready {
            let taken = batch.in_flight.take();
            let taken = taken.expect("the model has a result only for a query that it took");
            self.block.results += 1;
            self.check_result(&batch.cases[taken], outputs, batch.occupied)?;
        }
        Ok(())
    }

    /// Holds the step-exact machine against the direct gather and the program's clock count.
    fn check_result(
        &self,
        case: &Case,
        outputs: Outputs,
        machine_clocks: u64,
    ) -> Result<(), StimulusError> {
        let photons = case.groups.iter().flat_map(Group::photons);
        let gathered = gather(self.machine, &case.query, photons)?;
        let program_clocks = self.program.occupied_clocks(case.groups.len() as u64);
        if outputs.result == gathered && machine_clocks == program_clocks {
            return Ok(());
        }
        Err(StimulusError::ModelsDiffer {
            machine: self.machine.name,
            seed: self.block.seed,
            clock: self.clocks,
            machine_sums: outputs.result,
            gathered,
            machine_clocks,
            program_clocks,
        })
    }

    fn idle_inputs(&self) -> Inputs {
        Inputs {
            group: Group {
                lanes: vec![Lane::default(); self.machine.photons_per_iteration()],
                last: false,
            },
            ..Inputs::default()
        }
    }

    /// One clock: writes down the inputs and what the machine shows, then the rising edge.
    fn step(&mut self, inputs: &Inputs) -> ControlFlow<()> {
        self.block
            .inputs
            .extend(Pins::input_row(self.machine, inputs));
        self.model.observe(&mut self.block.expected);
        let accumulates = self.model.step().op == Op::Accumulate && !self.model.control().done;
        self.model.clock(inputs);
        let iterations = u64::from(accumulates && !inputs.reset);
        self.clocks += 1;
        self.iterations += iterations;
        self.block.clocks += 1;
        self.block.iterations += iterations;
        if self.block.clocks < BLOCK_CLOCKS {
            return ControlFlow::Continue(());
        }
        self.flush()
    }

    /// Hands on what is in the block, if anything.
    pub fn flush(&mut self) -> ControlFlow<()> {
        let next = Block {
            chunk: self.block.chunk,
            seed: self.block.seed,
            first_clock: self.clocks,
            iterations_before: self.iterations,
            inputs: Vec::with_capacity(self.block.inputs.len()),
            expected: Vec::with_capacity(self.block.expected.len()),
            ..Block::default()
        };
        let block = std::mem::replace(&mut self.block, next);
        if block.clocks == 0 {
            return ControlFlow::Continue(());
        }
        (self.sink)(block)
    }
}
