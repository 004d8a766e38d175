//! Drives a machine's three streams, clock by clock, and checks every row on the way.

use std::collections::VecDeque;

use photoncube_model::{GoldenMachine, gather, golden_machine};
use photoncube_spec::{BatchPins, Group, Inputs, Machine, Outputs, Pins, Query, SignalPlace, Sums};

use crate::words::Noise;

/// The queries of a batch and the groups that all of them are tested against.
#[derive(Clone, Debug)]
pub struct Batch {
    pub queries: Vec<Query>,
    pub groups: Vec<Group>,
}

impl Batch {
    /// The sums of the direct gather, in the order of the queries.
    pub fn expected(&self, machine: &Machine) -> Vec<Sums> {
        let photons: Vec<_> = self.groups.iter().flat_map(Group::photons).collect();
        let sums = |query| gather(machine, query, photons.iter().copied()).unwrap();
        self.queries.iter().map(sums).collect()
    }
}

/// The sums of the direct gather for successive batches.
pub fn expected(machine: &Machine, batches: &[Batch]) -> Vec<Sums> {
    let each = batches.iter().map(|batch| batch.expected(machine));
    each.collect::<Vec<_>>().concat()
}

/// The streams that do not move in a clock.
#[derive(Copy, Clone, Debug, Default)]
pub struct Waits {
    pub query: bool,
    pub group: bool,
    pub result: bool,
}

/// The words that crossed the streams in a clock.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Moved {
    pub query: bool,
    pub group: bool,
    /// The group that was taken is the last of its batch.
    pub last: bool,
    pub result: bool,
}

/// A machine, with the words that are still to be given to it.
pub struct Driver {
    machine: Machine,
    pins: Pins,
    dut: Box<dyn GoldenMachine>,
    queries: VecDeque<Query>,
    groups: VecDeque<Group>,
    /// The word on the group stream was valid and not taken, so it must stay.
    offered: bool,
    noise: Noise,
    /// The results that were taken, in order.
    pub results: Vec<Sums>,
}

impl Driver {
    pub fn new(machine: &Machine) -> Self {
        Self {
            machine: *machine,
            pins: Pins::of(machine),
            dut: golden_machine(machine),
            queries: VecDeque::new(),
            groups: VecDeque::new(),
            offered: false,
            noise: Noise::new(machine),
            results: Vec::new(),
        }
    }

    /// Appends batches to the words that are still to be given.
    pub fn give(&mut self, batches: &[Batch]) {
        for batch in batches {
            self.queries.extend(&batch.queries);
            self.groups.extend(batch.groups.iter().cloned());
        }
    }

    /// The number of queries that are still to be taken.
    pub fn queries_left(&self) -> usize {
        self.queries.len()
    }

    /// The number of groups that are still to be taken.
    pub fn groups_left(&self) -> usize {
        self.groups.len()
    }

    /// Runs one clock. The pins of a stream that is not valid carry noise.
    pub fn tick(&mut self, waits: Waits) -> Moved {
        let inputs = self.inputs(waits);
        let outputs = self.clock(&inputs);
        let moved = Moved {
            query: inputs.query_valid && outputs.query_ready,
            group: inputs.group_valid && outputs.group_ready,
            last: inputs.group_valid && outputs.group_ready && inputs.group.last,
            result: inputs.result_ready && outputs.result_valid,
        };
        if moved.query {
            self.queries.pop_front();
        }
        if moved.group {
            self.groups.pop_front();
        }
        self.offered = inputs.group_valid && !moved.group;
        if moved.result {
            self.results.push(outputs.result);
        }
        moved
    }

    /// Runs a clock with the reset pin set. The words that cross in this clock are lost, and so are all words
    /// that were still to be given.
    pub fn reset(&mut self) {
        let inputs = Inputs {
            reset: true,
            ..self.inputs(Waits::default())
        };
        self.clock(&inputs);
        self.queries.clear();
        self.groups.clear();
        self.offered = false;
    }

    /// The registers, each with its place in the machine.
    pub fn registers(&self) -> Vec<(SignalPlace, u64)> {
        let mut row = Vec::new();
        self.dut.observe(&Inputs::default(), &mut row);
        let places = self.pins.observed.iter().map(|pin| pin.place);
        places.zip(row).skip(self.pins.outputs).collect()
    }

    /// Runs without waiting until `results` results have come, and some clocks more, in which no further
    /// result may come.
    pub fn finish(&mut self, results: usize) {
        self.finish_with(results, |_| Waits::default());
    }

    /// Runs until `results` results have come, as [`Self::finish`] does, with the waiting streams of each
    /// clock from `waits`.
    pub fn finish_with(&mut self, results: usize, mut waits: impl FnMut(u64) -> Waits) {
        let words = self.queries.len() + self.groups.len() + results;
        let engines = self.machine.queries_at_once();
        let limit = 100 * (words + engines) as u64 + 1000;
        for clock in 0.. {
            if self.results.len() >= results {
                break;
            }
            assert!(clock < limit, "the machine hangs");
            self.tick(waits(clock));
        }
        for _ in 0..4 * engines + 40 {
            assert!(!self.tick(Waits::default()).result, "a result too many");
        }
    }

    fn inputs(&mut self, waits: Waits) -> Inputs {
        let query = self.queries.front().filter(|_| !waits.query);
        let group = self.groups.front();
        let group = group.filter(|_| self.offered || !waits.group);
        Inputs {
            reset: false,
            query_valid: query.is_some(),
            query: query.copied().unwrap_or_else(|| self.noise.query()),
            // Every batch has its own photons.
            query_release: self.machine.has_memory(),
            batch: BatchPins::default(),
            group_valid: group.is_some(),
            group: group.cloned().unwrap_or_else(|| self.noise.group()),
            result_ready: !waits.result,
        }
    }

    /// Runs one clock edge. Checks that the row before it has a value for each pin and that each value fits.
    fn clock(&mut self, inputs: &Inputs) -> Outputs {
        let outputs = self.dut.outputs(inputs);
        let mut row = Vec::with_capacity(self.pins.observed.len());
        self.dut.observe(inputs, &mut row);
        assert_eq!(row.len(), self.pins.observed.len());
        for (value, pin) in row.iter().zip(&self.pins.observed) {
            let fits = pin.width >= u64::BITS || value >> pin.width == 0;
            assert!(fits, "{} is {value}", pin.name);
        }
        assert_eq!(Pins::outputs_of(&self.machine, &row), outputs);
        assert!(self.dut.works(inputs));
        self.dut.clock(inputs);
        outputs
    }
}
