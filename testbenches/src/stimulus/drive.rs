//! Drives cases through the golden model, clock by clock, and records the inputs and all signals.

use std::ops::ControlFlow;

use photoncube_model::{GoldenMachine, gather, golden_machine};
use photoncube_spec::{
    BatchPins, Group, HeadSizes, Inputs, Lane, Leaf, Machine, Microprogram, Organisation, Outputs,
    Pins, Query, check_schedule,
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::batch::Batch;
use super::case::Case;
use super::cases::Cases;
use super::traffic::{Pressure, Traffic};
use super::{Block, StimulusError};

/// The clocks without a query or group after which results count as late.
const LATE_CLOCKS: u32 = 4;

/// A block is passed on when it has about this many signals, 4 MiB, which fits the caches.
const BLOCK_SIGNALS: usize = 1 << 19;
/// The fewest clocks of a block, because each block has an overhead.
const FEWEST_BLOCK_CLOCKS: usize = 32;

/// The receiver of the blocks; `Break` ends the generation.
pub(crate) type Sink<'a> = dyn FnMut(Block) -> ControlFlow<()> + 'a;

/// Drives the golden model, chunk by chunk.
pub(crate) struct Driver<'a> {
    machine: &'a Machine,
    /// The program that determines the clocks of a query; `None` for machines without one.
    program: Option<Microprogram>,
    /// Whether results are those of a gather. The results of other programs are compared only between devices
    /// and model.
    gathers: bool,
    model: Box<dyn GoldenMachine>,
    rng: Pcg64,
    block: Block,
    /// The number of clocks of a block.
    block_clocks: usize,
    /// A chunk has begun, and the block holds all of it so far.
    scrubs: bool,
    sink: &'a mut Sink<'a>,
    /// Statistics over all chunks so far.
    pressure: Pressure,
    /// The clocks of the chunk so far.
    clocks: u64,
    /// The iterations of the chunk so far.
    iterations: u64,
}

impl<'a> Driver<'a> {
    pub fn new(machine: &'a Machine, sink: &'a mut Sink<'a>) -> Self {
        let signals = Pins::of(machine).observed.len();
        Self {
            machine,
            gathers: gathers(machine),
            program: machine.microprogram(),
            model: golden_machine(machine),
            rng: Pcg64::seed_from_u64(0),
            block: Block::default(),
            scrubs: false,
            block_clocks: FEWEST_BLOCK_CLOCKS.max(BLOCK_SIGNALS / signals),
            sink,
            pressure: Pressure::default(),
            clocks: 0,
            iterations: 0,
        }
    }

    /// The iterations since the chunk began.
    pub fn iterations(&self) -> u64 {
        self.iterations
    }

    /// The clocks since the chunk began.
    pub fn clocks(&self) -> u64 {
        self.clocks
    }

    /// The random numbers of the chunk.
    pub fn rng(&mut self) -> &mut Pcg64 {
        &mut self.rng
    }

    /// Begins a chunk. Sets every register to a value that does not depend on its past, so that the chunk
    /// does not depend on earlier chunks.
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
        let reset = Inputs {
            reset: true,
            ..self.idle_inputs()
        };
        let (cases, flushing) = self.scrubbing();
        self.scrubs = true;
        if self.step(&reset).is_break()
            || self.run(&cases, Traffic::STREAMING)?.is_break()
            || self.flush_pipeline(flushing).is_break()
            || self.step(&reset).is_break()
            || self.flush_pipeline(flushing).is_break()
        {
            return Ok(ControlFlow::Break(()));
        }
        let idle = self.idle_inputs();
        let (mut scrubbed, mut fresh) = (Vec::new(), Vec::new());
        self.model.observe(&idle, &mut scrubbed);
        let after = self.after_the_same(&self.block.inputs);
        after.observe(&idle, &mut fresh);
        if scrubbed != fresh {
            return Err(StimulusError::NotScrubbed {
                machine: self.machine.name,
            });
        }
        self.scrubs = false;
        // The rows that begin a chunk do not count as requested iterations.
        self.iterations = 0;
        (self.block.iterations, self.block.results) = (0, 0);
        Ok(ControlFlow::Continue(()))
    }

    /// Begins the first chunk in the power-up state, without a reset.
    pub fn begin_at_power_up(&mut self, seed: u64) {
        self.rng = Pcg64::seed_from_u64(seed);
        self.block.seed = seed;
    }

    /// One clock with the reset set and zeros on all other pins.
    pub fn reset(&mut self) -> ControlFlow<()> {
        self.pressure.clock([false; 3], [false; 3], true);
        let idle = self.idle_inputs();
        self.step(&Inputs {
            reset: true,
            ..idle
        })
    }

    /// Cases without photons that set every word which holds a sum, and the number of clocks in which the
    /// pipeline then empties.
    fn scrubbing(&self) -> (Vec<Case>, usize) {
        let Some(spatial) = self.machine.spatial() else {
            return (vec![Case::empty(self.machine)], 0);
        };
        let cases = HeadSizes::of(spatial).queue / spatial.engines();
        let pipeline = (spatial.latency() + spatial.cuts.power_latency()) as usize;
        let clocks = 2 * spatial.engines() + 2 * pipeline;
        (vec![Case::empty(self.machine); cases], clocks)
    }

    /// `clocks` clocks with zeros on all pins.
    fn flush_pipeline(&mut self, clocks: usize) -> ControlFlow<()> {
        let idle = self.idle_inputs();
        (0..clocks).try_for_each(|_| self.step(&idle))
    }

    /// The machine after these rows of inputs from power-up on.
    fn after_the_same(&self, rows: &[u64]) -> Box<dyn GoldenMachine> {
        let mut fresh = golden_machine(self.machine);
        let columns = Pins::of(self.machine).inputs.len();
        for row in rows.chunks_exact(columns) {
            fresh.clock(&Pins::inputs_of(self.machine, row));
        }
        fresh
    }

    /// `clocks` clocks without a query or a group.
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
        let mut batch = Batch::new(cases, traffic);
        let mut inputs = self.idle_inputs();
        while !batch.is_done() {
            let at_random = traffic.resets && self.rng.random_ratio(1, 100);
            inputs.reset = at_random || traffic.reset_at == Some(batch.clocks);
            inputs.result_ready = match traffic.late_results {
                true => batch.still >= LATE_CLOCKS,
                false => traffic.result.draw(&mut self.rng, batch.clocks),
            };
            self.offer_group(&mut inputs, &mut batch);
            // No output depends on the query's word, so the query may depend on the outputs.
            let outputs = self.model.outputs(&inputs);
            self.offer_query(&mut inputs, outputs, &batch);
            let works = self.model.works(&inputs);
            self.press(&inputs, outputs, works, &batch);
            if self.step(&inputs).is_break() {
                return Ok(ControlFlow::Break(()));
            }
            batch.clocks += 1;
            if inputs.reset {
                batch.reset();
            } else {
                batch.occupied += u64::from(works);
                self.transfer(&inputs, outputs, &mut batch)?;
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// Records the streams that the stimulus holds back in this clock.
    fn press(&mut self, inputs: &Inputs, outputs: Outputs, works: bool, batch: &Batch<'_>) {
        let group_is_there = batch.next_group.0 < batch.cases.len();
        let held = [
            batch.query().is_some() && !inputs.query_valid,
            group_is_there && !inputs.group_valid,
            outputs.result_valid && !inputs.result_ready,
        ];
        // A machine that reads a group in several clocks is ready only in the last of them.
        let stands = !works && !outputs.query_ready && !outputs.result_valid;
        let waits = [
            outputs.query_ready,
            outputs.group_ready || stands,
            outputs.result_valid,
        ];
        self.pressure.clock(held, waits, inputs.reset);
    }

    /// Drives the query pins. A query may be withdrawn until it is taken, and other words may precede it.
    fn offer_query(&mut self, inputs: &mut Inputs, outputs: Outputs, batch: &Batch<'_>) {
        let traffic = batch.traffic;
        let next = batch.query();
        let feint = traffic.garbage && !outputs.query_ready;
        inputs.query_valid =
            traffic.query.draw(&mut self.rng, batch.clocks) && (next.is_some() || feint);
        let wanted = inputs.query_valid && outputs.query_ready;
        let (case, index) = batch.next_query;
        inputs.query_release = match batch.cases.get(case) {
            Some(case) if wanted => self.releases(case, index, batch),
            _ => traffic.garbage && self.rng.random(),
        };
        inputs.batch = match batch.cases.get(case) {
            Some(case) if wanted => self.batch_pins(case, batch.next_query),
            _ if traffic.garbage => Cases::new(self.machine, &mut self.rng).garbage_batch(),
            _ => BatchPins::default(),
        };
        inputs.query = match next {
            Some(query) if wanted || !traffic.garbage => query,
            _ if traffic.garbage => Cases::new(self.machine, &mut self.rng).garbage_query(),
            _ => self.idle_inputs().query,
        };
    }

    /// The words that go with a query of a case. The facings of the batch are those of its first query, and what ends with as
    /// many queries as the machine tests at once needs no mark.
    fn batch_pins(&mut self, case: &Case, next: (usize, usize)) -> BatchPins {
        let noise = Cases::new(self.machine, &mut self.rng).garbage_batch();
        if self.machine.leaf().is_none() {
            return noise;
        }
        let (_, index) = next;
        let is_last = index + 1 == case.queries.len();
        let is_full = index + 1 == self.machine.queries_at_once();
        BatchPins {
            last: is_last && (!is_full || noise.last),
            facings: if index == 0 {
                case.facings
            } else {
                noise.facings
            },
            tag: tag(next),
        }
    }

    /// Whether a query releases the photons of its batch. One query of the batch is enough. All of them
    /// release; with garbage some do, and the last one if no other has.
    fn releases(&mut self, case: &Case, index: usize, batch: &Batch<'_>) -> bool {
        let is_last = index + 1 == case.queries.len();
        let must = !batch.traffic.garbage || (is_last && !batch.released);
        !case.keeps_photons && (must || self.rng.random())
    }

    fn offer_group(&mut self, inputs: &mut Inputs, batch: &mut Batch<'_>) {
        let (case, index) = batch.next_group;
        let there = case < batch.cases.len();
        let pace = batch.traffic.group;
        if !batch.offered && there && pace.draw(&mut self.rng, batch.clocks) {
            inputs.group.clone_from(&batch.cases[case].groups[index]);
            batch.offered = true;
        }
        inputs.group_valid = batch.offered;
        if !batch.offered && batch.traffic.garbage {
            Cases::new(self.machine, &mut self.rng).garbage_group(&mut inputs.group);
        }
    }

    fn transfer(
        &mut self,
        inputs: &Inputs,
        outputs: Outputs,
        batch: &mut Batch<'_>,
    ) -> Result<(), StimulusError> {
        batch.still += 1;
        if outputs.query_ready && inputs.query_valid {
            let program = self.program.as_ref();
            let clocks = program.map_or(1, Microprogram::clocks_up_to_the_query);
            batch.take_query(clocks, inputs.query_release);
        }
        if outputs.group_ready && inputs.group_valid {
            batch.take_group();
        }
        if outputs.result_valid && inputs.result_ready {
            let taken = batch.in_flight.pop_front();
            let (number, index) = taken.expect("a result is only of a query that was taken");
            let case = &batch.cases[number];
            self.block.results += 1;
            self.check_result(case, case.queries[index], outputs, batch.occupied)?;
            self.check_tag((number, index), outputs)?;
            if index + 1 == case.queries.len() {
                self.iterations += case.groups.len() as u64;
                self.block.iterations += case.groups.len() as u64;
            }
        }
        Ok(())
    }

    /// Compares the step-exact machine's result with the direct gather, and its clocks with the program's.
    fn check_result(
        &self,
        case: &Case,
        query: Query,
        outputs: Outputs,
        machine_clocks: u64,
    ) -> Result<(), StimulusError> {
        if !self.gathers {
            return Ok(());
        }
        let gathered = gather(self.machine, &query, case.gathered(self.machine))?;
        let groups = case.groups.len() as u64;
        let program = self.program.as_ref();
        let program_clocks = program.map_or(machine_clocks, |p| p.occupied_clocks(groups));
        if outputs.result == gathered && machine_clocks == program_clocks {
            return Ok(());
        }
        Err(StimulusError::ModelsDiffer {
            machine: self.machine.name,
            seed: self.block.seed,
            clock: self.clocks,
            sums: Box::new([outputs.result, gathered]),
            machine_clocks,
            program_clocks,
        })
    }

    /// Compares the tag of a result with that of its query.
    fn check_tag(&self, taken: (usize, usize), outputs: Outputs) -> Result<(), StimulusError> {
        let expected = match self.machine.leaf() {
            Some(_) => tag(taken),
            None => 0,
        };
        match outputs.result_tag == expected {
            true => Ok(()),
            false => Err(StimulusError::Tag {
                machine: self.machine.name,
                seed: self.block.seed,
                clock: self.clocks,
                found: outputs.result_tag,
                expected,
            }),
        }
    }

    fn idle_inputs(&self) -> Inputs {
        Inputs {
            group: Group {
                lanes: vec![Lane::default(); self.machine.photons_per_iteration()],
                ..Group::default()
            },
            query: Query {
                radius_sq: self.machine.fixed_radius_sq().unwrap_or(0),
                ..Query::default()
            },
            ..Inputs::default()
        }
    }

    /// One clock: records the inputs and the machine's signals, then applies the rising edge.
    fn step(&mut self, inputs: &Inputs) -> ControlFlow<()> {
        // The block is checked before the clock, because what is taken in a clock counts in that clock's
        // block.
        let is_whole = self.block.clocks >= self.block_clocks && !self.scrubs;
        if is_whole && self.flush().is_break() {
            return ControlFlow::Break(());
        }
        self.block
            .inputs
            .extend(Pins::input_row(self.machine, inputs));
        self.model.observe(inputs, &mut self.block.expected);
        self.model.clock(inputs);
        self.clocks += 1;
        self.block.clocks += 1;
        ControlFlow::Continue(())
    }

    /// Passes on the block, if it is not empty.
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
        let mut block = std::mem::replace(&mut self.block, next);
        block.pressure = self.pressure;
        if block.clocks == 0 {
            return ControlFlow::Continue(());
        }
        (self.sink)(block)
    }
}

/// The tag of a query, by its case and its index in the case.
fn tag((case, index): (usize, usize)) -> u32 {
    let number = (case << 6 | index) as u32;
    // A multiplicative hash (Knuth, The Art of Computer Programming, 6.4): its high bits differ between neighbours, and each of them is
    // 0 and 1 also where every case has a single query.
    number.wrapping_mul(0x9E37_79B1) >> (u32::BITS - Leaf::TAG_BITS)
}

/// Whether the machine computes a gather: all machines do, except those with a user's program that the
/// schedule checker refuses.
fn gathers(machine: &Machine) -> bool {
    match &machine.organisation {
        Organisation::Programmed(own) => {
            check_schedule(&own.microprogram(), machine.hypercube()).is_ok()
        }
        _ => true,
    }
}
