//! Compares every visible signal of a device with the golden model in every clock, and describes the first
//! difference.

use std::fmt;

use photoncube_spec::{
    EngineRegister, Inputs, Instances, Machine, Pins, Register, SEQUENTIAL, SignalPlace, Step,
};

use crate::device::Observed;
use crate::stimulus::Block;

/// A value that a device shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Actual {
    /// A value whose bits are all 0 or 1.
    Known(u64),
    /// A value with bits that are neither 0 nor 1, in hexadecimal with the digits x and z.
    Unknown(String),
}

/// The activity of the machine in a clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Activity {
    /// No activity, because there was no clock before.
    PowerUp,
    /// The machine did a step.
    Step(Step),
    /// The machine waited for a stream before it could do a step.
    WaitsFor(Step),
    /// The machine held its result, which was taken or not.
    HasResult,
    /// All cells did the work that they do in every clock, in a machine without a program.
    Flows,
}

/// The first difference between a device and the golden model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Divergence {
    /// The name of the machine.
    pub machine: &'static str,
    /// The name of the device.
    pub device: String,
    /// The seed of the chunk. A run with this seed begins with the chunk.
    pub seed: u64,
    /// The index of the chunk in this run.
    pub chunk: u64,
    /// The clock, counted from the chunk's start.
    pub clock: u64,
    /// The signal's name, as in [`Pins`]. Where several signals differ, a register is named before an output.
    pub signal: String,
    /// The signal's place in the machine.
    pub place: SignalPlace,
    /// The name in listings of a register of a cell.
    pub register: Option<&'static str>,
    /// The value of the golden model.
    pub expected: u64,
    /// The value of the device.
    pub actual: Actual,
    /// The number of signals that differ in this clock.
    pub differing: usize,
    /// The machine's activity in the clock before, at whose end registers stored these values.
    pub activity: Activity,
    /// The values, in the clock before, of the registers and pins that this signal depends on; `n` is the
    /// neighbour's `v`.
    pub operands: Vec<(String, u64)>,
    /// The number of clocks before this one, all of which were equal.
    pub vectors_compared: u64,
    /// A command that reproduces the difference.
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
        if let (SignalPlace::Cell { node, .. }, Some(register)) = (self.place, self.register) {
            write!(f, ", node {node}, register {register}")?;
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

/// A comparison of successive blocks.
pub(crate) struct Comparer<'a> {
    machine: &'a Machine,
    pins: Pins,
    /// The program's steps; empty where there is no program.
    steps: Vec<Step>,
    visible: usize,
    /// The last clock before the block: its row of inputs and its row of signals.
    before: Option<(Vec<u64>, Vec<u64>)>,
    /// The number of clocks compared so far, all equal.
    pub vectors: u64,
}

impl<'a> Comparer<'a> {
    pub fn new(machine: &'a Machine, visible: usize) -> Self {
        Self::of_pins(machine, Pins::of(machine), visible)
    }

    /// A comparison for a machine, or for a part of it that has these pins.
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

    /// Whether the device returned as many rows as there are clocks.
    pub fn is_complete(&self, block: &Block, observed: &Observed) -> bool {
        observed.values.len() == block.clocks * self.visible
    }

    /// Returns the first difference of a block; `device` and `repeat` are copied into its description.
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
        // The control block causes differences in the cells, and both cause differences in the outputs.
        let rank = |&column: &usize| match self.pins.observed[column].place {
            SignalPlace::Control(_)
            | SignalPlace::Head { .. }
            | SignalPlace::Memory { .. }
            | SignalPlace::Leaf { .. } => 0,
            SignalPlace::Cell { .. } | SignalPlace::Engine { .. } => 1,
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
            register: mnemonic(self.machine, pin.place),
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
        for row in SEQUENTIAL.registers {
            let register = row.register;
            add(row.mnemonic, value(SignalPlace::Cell { node, register }));
        }
        let cube = self.machine.hypercube();
        if let Some(axis) = step.axis {
            let node = cube.neighbour(node, axis);
            let register = Register::Work;
            add("n", value(SignalPlace::Cell { node, register }));
        }
        let lane = format!("_{}", cube.photon(node));
        let row = SEQUENTIAL.op(step.op);
        for (pin, &value) in self.pins.inputs.iter().zip(inputs) {
            let name = pin.name.as_str();
            if (row.reads_query() && name.starts_with("query_"))
                || (row.reads_group() && name.starts_with("photon_") && name.ends_with(&lane))
            {
                add(name, value);
            }
        }
        (activity, operands)
    }
}

/// The name in listings of a register of a cell.
pub(crate) fn mnemonic(machine: &Machine, place: SignalPlace) -> Option<&'static str> {
    let SignalPlace::Cell { register, .. } = place else {
        return None;
    };
    Some(machine.cell()?.register(register).mnemonic)
}

/// Whether one register of a machine without single steps may feed another. It may if both are in the control
/// block or head, or both in one cell, or both in one engine and, where they belong to lanes, in one lane.
fn is_near(machine: &Machine, place: SignalPlace, other: SignalPlace) -> bool {
    let channels = machine.channels().names().len();
    let lane = |register: EngineRegister, index| match register.row().instances {
        Instances::Lanes => Some(index),
        Instances::Coordinates => Some(index / 3),
        Instances::LaneChannels => Some(index / channels),
        _ => None,
    };
    match (place, other) {
        (SignalPlace::Control(_), SignalPlace::Control(_)) => true,
        (SignalPlace::Cell { node, .. }, SignalPlace::Cell { node: other, .. }) => node == other,
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

/// The activity of a sequential machine whose control block is at this step.
pub(crate) fn activity(step: Step, done: bool, inputs: &Inputs) -> Activity {
    let row = SEQUENTIAL.op(step.op);
    if done {
        return Activity::HasResult;
    }
    if (row.reads_query() && !inputs.query_valid) || (row.reads_group() && !inputs.group_valid) {
        return Activity::WaitsFor(step);
    }
    Activity::Step(step)
}
