//! The comparison: every visible signal in every clock, and a full account of the first
//! difference.

use std::fmt;

use photoncube_spec::{
    EngineRegister, Inputs, Instances, Machine, Pins, REGISTERS, SignalPlace, Step,
};

use crate::device::Observed;
use crate::stimulus::Block;

/// What a device showed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Actual {
    /// A number.
    Known(u64),
    /// A value with bits that are neither 0 nor 1, in hexadecimal with x and z.
    Unknown(String),
}

/// What the machine was about in a clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Activity {
    /// Nothing yet: there was no clock before.
    PowerUp,
    /// It did a step.
    Step(Step),
    /// It waited for a stream to do a step.
    WaitsFor(Step),
    /// It held its result, which was taken or not.
    HasResult,
    /// Every cell did what it does in every clock.
    Flows,
}

/// The first difference between a device and the golden model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Divergence {
    /// The machine.
    pub machine: &'static str,
    /// The device.
    pub device: String,
    /// The seed of the chunk; with it, the chunk is the first of a run.
    pub seed: u64,
    /// The chunk in this run.
    pub chunk: u64,
    /// The clock, counted from the chunk's start.
    pub clock: u64,
    /// The signal's name, as in [`Pins`]; where several differ, a register before an output.
    pub signal: String,
    /// Where the signal is.
    pub place: SignalPlace,
    /// What the golden model shows.
    pub expected: u64,
    /// What the device shows.
    pub actual: Actual,
    /// How many signals differ in this clock.
    pub differing: usize,
    /// What was done in the clock before, at whose end registers took these values.
    pub activity: Activity,
    /// What the clock before had in the registers and on the pins that matter for this signal; `n`
    /// is the neighbour's `v`.
    pub operands: Vec<(String, u64)>,
    /// Clocks that were equal before.
    pub vectors_compared: u64,
    /// The command that repeats it.
    pub repeat: String,
}

impl fmt::Display for Activity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::PowerUp => f.write_str("none, power-up"),
            Self::Step(step) => write!(f, "{step}"),
            Self::WaitsFor(step) => write!(f, "none, waits for its stream to do {step}"),
            Self::HasResult => f.write_str("none, has a result"),
            Self::Flows => f.write_str("all, as in every clock"),
        }
    }
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} differs from the golden model of `{}`, after {} equal clocks",
            self.device, self.machine, self.vectors_compared
        )?;
        writeln!(
            f,
            "  where     clock {} of chunk {} (seed {})",
            self.clock, self.chunk, self.seed
        )?;
        write!(f, "  signal    {}", self.signal)?;
        if let SignalPlace::Cell { node, register } = self.place {
            write!(f, ", node {node}, register {}", register.row().mnemonic)?;
        }
        match self.differing {
            1 => writeln!(f)?,
            more => writeln!(f, "; {} more differ in this clock", more - 1)?,
        }
        writeln!(f, "  step      {}", self.activity)?;
        if !self.operands.is_empty() {
            f.write_str("  operands ")?;
            for (name, value) in &self.operands {
                write!(f, " {name}={value}")?;
            }
            writeln!(f)?;
        }
        writeln!(f, "  expected  {0} ({0:#x})", self.expected)?;
        match &self.actual {
            Actual::Known(value) => writeln!(f, "  actual    {value} ({value:#x})")?,
            Actual::Unknown(text) => {
                writeln!(f, "  actual    {text} in hexadecimal, unknown bits")?
            }
        }
        write!(f, "  repeat    {}", self.repeat)
    }
}

/// Compares blocks in their order.
pub(crate) struct Comparer<'a> {
    machine: &'a Machine,
    pins: Pins,
    /// The program's steps; none where there is no program.
    steps: Vec<Step>,
    visible: usize,
    /// The clock before the block: its row of inputs and its row of signals.
    before: Option<(Vec<u64>, Vec<u64>)>,
    /// Clocks compared, all equal.
    pub vectors: u64,
}

impl<'a> Comparer<'a> {
    pub fn new(machine: &'a Machine, visible: usize) -> Self {
        Self::of_pins(machine, Pins::of(machine), visible)
    }

    /// Of the machine, or of a part of it that has these pins.
    pub fn of_pins(machine: &'a Machine, pins: Pins, visible: usize) -> Self {
        Self {
            machine,
            pins,
            steps: machine.microprogram().map_or(Vec::new(), |p| p.steps()),
            visible,
            before: None,
            vectors: 0,
        }
    }

    /// Whether there are as many rows as clocks.
    pub fn is_complete(&self, block: &Block, observed: &Observed) -> bool {
        observed.values.len() == block.clocks * self.visible
    }

    /// The first difference; `device` and `repeat` only go into its account.
    pub fn compare(
        &mut self,
        block: &Block,
        observed: &Observed,
        device: &str,
        repeat: impl FnOnce() -> String,
    ) -> Result<(), Box<Divergence>> {
        if let Some(row) = self.first_difference(block, observed) {
            let mut divergence = self.account(block, observed, row);
            divergence.device = device.to_owned();
            divergence.repeat = repeat();
            return Err(Box::new(divergence));
        }
        self.vectors += block.clocks as u64;
        if let Some(last) = block.clocks.checked_sub(1) {
            self.before = Some(self.rows(block, last));
        }
        Ok(())
    }

    fn first_difference(&self, block: &Block, observed: &Observed) -> Option<usize> {
        let all = self.pins.observed.len();
        if observed.unknown.is_empty() && self.visible == all && observed.values == block.expected {
            return None;
        }
        let expected = block.expected.chunks_exact(all);
        let mut rows = expected.zip(observed.values.chunks_exact(self.visible));
        let known = rows.position(|(expected, actual)| expected[..self.visible] != *actual);
        let unknown = observed.unknown.first().map(|x| x.index / self.visible);
        known.into_iter().chain(unknown).min()
    }

    fn rows(&self, block: &Block, row: usize) -> (Vec<u64>, Vec<u64>) {
        let cut = |values: &[u64], columns| values[row * columns..][..columns].to_vec();
        (
            cut(&block.inputs, self.pins.inputs.len()),
            cut(&block.expected, self.pins.observed.len()),
        )
    }

    fn account(&self, block: &Block, observed: &Observed, row: usize) -> Divergence {
        let (_, expected) = self.rows(block, row);
        let first = row * self.visible;
        let actual = |column: usize| observed.at(first + column);
        let differs = |&column: &usize| actual(column) != Actual::Known(expected[column]);
        let differing = (0..self.visible).filter(differs);
        // The control block leads the cells, and both lead the outputs.
        let rank = |&column: &usize| match self.pins.observed[column].place {
            SignalPlace::Control(_)
            | SignalPlace::OverlapControl(_)
            | SignalPlace::Head { .. }
            | SignalPlace::Memory { .. } => 0,
            SignalPlace::Cell { .. }
            | SignalPlace::OverlapCell { .. }
            | SignalPlace::Engine { .. } => 1,
            SignalPlace::Top => 2,
        };
        let column = differing.clone().min_by_key(rank);
        let column = column.expect("a row that differs has a signal that differs");
        let pin = &self.pins.observed[column];
        let before = match row.checked_sub(1) {
            Some(before) => Some(self.rows(block, before)),
            None => self.before.clone(),
        };
        let (activity, operands) = match &before {
            Some((inputs, registers)) => self.clock_before(inputs, registers, pin.place),
            None => (Activity::PowerUp, Vec::new()),
        };
        Divergence {
            machine: self.machine.name,
            device: String::new(),
            seed: block.seed,
            chunk: block.chunk,
            clock: block.first_clock + row as u64,
            signal: pin.name.clone(),
            place: pin.place,
            expected: expected[column],
            actual: actual(column),
            differing: differing.count(),
            activity,
            operands,
            vectors_compared: self.vectors + row as u64,
            repeat: String::new(),
        }
    }

    fn clock_before(
        &self,
        inputs: &[u64],
        registers: &[u64],
        place: SignalPlace,
    ) -> (Activity, Vec<(String, u64)>) {
        if self.steps.is_empty() {
            let near = |other| is_near(self.machine, place, other);
            let registers = self.pins.observed.iter().zip(registers);
            let near = registers.filter(|(pin, _)| near(pin.place));
            let operands = near.map(|(pin, &value)| (pin.name.clone(), value));
            return (Activity::Flows, operands.collect());
        }
        let value = |wanted: SignalPlace| {
            let mut places = self.pins.observed.iter().map(|pin| pin.place);
            let column = places.position(|place| place == wanted);
            registers[column.expect("every register is observed")]
        };
        let [address, last, done] = [0, 1, 2].map(|index| value(SignalPlace::Control(index)));
        let step = self.steps[address as usize];
        let activity = activity(step, done != 0, &Pins::inputs_of(self.machine, inputs));
        let mut operands = Vec::new();
        let mut add = |name: &str, value| operands.push((name.to_owned(), value));
        let SignalPlace::Cell { node, .. } = place else {
            add("address", address);
            add("last", last);
            add("done", done);
            for (pin, &value) in self.pins.inputs.iter().zip(inputs) {
                if pin.width == 1 && !pin.name.starts_with("photon_") {
                    add(&pin.name, value);
                }
            }
            return (activity, operands);
        };
        for row in REGISTERS {
            let register = row.register;
            add(row.mnemonic, value(SignalPlace::Cell { node, register }));
        }
        let cube = self.machine.hypercube();
        if let Some(axis) = step.axis {
            let node = cube.neighbour(node, axis);
            let register = photoncube_spec::Register::Work;
            add("n", value(SignalPlace::Cell { node, register }));
        }
        let lane = format!("_{}", cube.photon(node));
        let row = step.op.row();
        for (pin, &value) in self.pins.inputs.iter().zip(inputs) {
            let name = pin.name.as_str();
            if (row.reads_query && name.starts_with("query_"))
                || (row.reads_group && name.starts_with("photon_") && name.ends_with(&lane))
            {
                add(name, value);
            }
        }
        (activity, operands)
    }
}

/// Whether one register of a machine without a program of single steps may feed another: both in
/// control or head, or both in one cell, or in one engine and of one lane, if they are of a lane.
fn is_near(machine: &Machine, place: SignalPlace, other: SignalPlace) -> bool {
    let channels = machine.channels().names().len();
    let lane = |register: EngineRegister, index| match register.row().instances {
        Instances::Lanes => Some(index),
        Instances::Coordinates => Some(index / 3),
        Instances::LaneChannels => Some(index / channels),
        _ => None,
    };
    match (place, other) {
        (SignalPlace::OverlapControl(_), SignalPlace::OverlapControl(_)) => true,
        (SignalPlace::OverlapCell { node, .. }, SignalPlace::OverlapCell { node: other, .. }) => {
            node == other
        }
        (SignalPlace::Head { .. }, SignalPlace::Head { index, .. }) => index == 0,
        (SignalPlace::Memory { .. }, SignalPlace::Memory { .. } | SignalPlace::Head { .. }) => true,
        (
            SignalPlace::Engine {
                engine,
                register,
                index,
            },
            SignalPlace::Engine {
                engine: e,
                register: r,
                index: i,
            },
        ) => engine == e && (lane(r, i).is_none() || lane(r, i) == lane(register, index)),
        _ => false,
    }
}

fn activity(step: Step, done: bool, inputs: &Inputs) -> Activity {
    let row = step.op.row();
    if done {
        return Activity::HasResult;
    }
    if (row.reads_query && !inputs.query_valid) || (row.reads_group && !inputs.group_valid) {
        return Activity::WaitsFor(step);
    }
    Activity::Step(step)
}
