//! Blocks whose pins are driven and observed as rows of numbers.

use photoncube_spec::{Machine, Pin, Pins, SignalPlace, Widths};
use rust_hdl::core::atom::{Atom, AtomKind};
use rust_hdl::prelude::*;

use crate::emit::{BlockRam, ChannelNames};
use crate::level::Level;
use crate::registers::{Answer, Ask};

/// A block of a machine.
pub struct MachineBlock(pub(crate) Box<dyn Pinned>);

/// A block whose inputs, outputs and registers are rows of numbers.
pub(crate) trait Pinned: Block {
    /// Sets the clock pin, if the block has one.
    fn set_clock(&mut self, _level: bool) {}
    /// Drives the input pins, in the order of [`pins`].
    fn drive(&mut self, row: &[u64]);
    /// Appends the output pins and the registers, in the order of [`pins`].
    fn sample(&self, row: &mut Vec<u64>);
    /// A register's value, or its path in the top instance; `None` for blocks that hold no such register.
    fn register(&self, _place: SignalPlace, _ask: Ask) -> Option<Answer> {
        None
    }
    /// The memories of the block whose words have no initial value.
    fn block_rams(&self) -> Vec<BlockRam> {
        Vec::new()
    }
    /// Runs one pass of rust-hdl's settling loop. Returns true when nothing changed.
    fn settle(&mut self) -> bool;
}

/// Lists the pins of a block in the order of their declaration.
pub(crate) fn block_pins(block: &dyn Pinned) -> Pins {
    let mut probe = TopPins::default();
    block.accept("top", &mut probe);
    Pins {
        inputs: probe.inputs,
        outputs: probe.outputs.len(),
        observed: probe.outputs,
    }
}

/// Lists the pins of a part in the order of their declaration, then the registers of a cell or a photon
/// memory.
pub(crate) fn pins(block: &dyn Pinned, machine: &Machine, level: Level) -> Pins {
    with_registers(block_pins(block), machine, level)
}

/// Adds to the ports of a part the registers of a cell or a photon memory.
pub(crate) fn with_registers(mut pins: Pins, machine: &Machine, level: Level) -> Pins {
    if level == Level::Memory {
        let channels = ChannelNames::of(machine);
        for pin in pins.inputs.iter_mut().chain(&mut pins.observed) {
            pin.name = channels.pin(&pin.name);
        }
        let registers = Pins::of(machine).observed.into_iter();
        let of_memory = |pin: &Pin| matches!(pin.place, SignalPlace::Memory { .. });
        pins.observed.extend(registers.filter(of_memory));
        return pins;
    }
    if let (Level::Cell, Some(tables)) = (level, machine.cell()) {
        let widths = Widths::of(machine);
        pins.observed.extend(tables.registers.iter().map(|row| Pin {
            name: format!("register_{}", row.name),
            width: (row.width)(&widths),
            place: SignalPlace::Cell {
                node: 0,
                register: row.register,
            },
        }));
    }
    pins
}

/// A visitor that collects the pins of the top block, without the clock.
#[derive(Default)]
struct TopPins {
    depth: usize,
    inputs: Vec<Pin>,
    outputs: Vec<Pin>,
}

impl Probe for TopPins {
    fn visit_start_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.depth += 1;
    }

    fn visit_end_scope(&mut self, _name: &str, _node: &dyn Block) {
        self.depth -= 1;
    }

    fn visit_atom(&mut self, name: &str, signal: &dyn Atom) {
        if self.depth != 1 || name == "clock" {
            return;
        }
        let pin = Pin {
            name: name.replace('$', "_"),
            width: signal.bits() as u32,
            place: SignalPlace::Top,
        };
        match signal.kind() {
            AtomKind::InputParameter => self.inputs.push(pin),
            AtomKind::OutputParameter => self.outputs.push(pin),
            _ => {}
        }
    }
}

/// A signal's value as an unsigned number.
pub(crate) trait Word {
    fn from_number(number: u64) -> Self;
    fn number(self) -> u64;
}

impl Word for bool {
    fn from_number(number: u64) -> Self {
        number != 0
    }

    fn number(self) -> u64 {
        u64::from(self)
    }
}

impl Word for u64 {
    fn from_number(number: u64) -> Self {
        number
    }

    fn number(self) -> u64 {
        self
    }
}

impl<const N: usize> Word for Bits<N> {
    fn from_number(number: u64) -> Self {
        number.to_bits()
    }

    fn number(self) -> u64 {
        self.to_u64()
    }
}

/// Assigns a row's numbers to input signals, one after another.
pub(crate) struct Driver<'a>(std::slice::Iter<'a, u64>);

impl<'a> Driver<'a> {
    pub fn new(row: &'a [u64]) -> Self {
        Self(row.iter())
    }

    pub fn put<T: Word + Synth>(&mut self, signal: &mut Signal<In, T>) {
        let number = self.0.next().expect("a row has a number for each input");
        signal.next = T::from_number(*number);
    }
}

/// Appends the values of a machine's registers.
pub(crate) fn sample_registers(block: &impl Pinned, places: &[SignalPlace], row: &mut Vec<u64>) {
    let value = |&place| {
        let answer = block.register(place, Ask::Value);
        answer.expect("a machine holds its registers").value()
    };
    row.extend(places.iter().map(value));
}

macro_rules! drive {
    ($self:ident, $row:ident: $($signal:ident),+ $(,)?) => {
        let mut driver = $crate::pinned::Driver::new($row);
        $(driver.put(&mut $self.$signal);)+
    };
}

macro_rules! sample {
    ($self:ident, $row:ident: $($($signal:ident).+),+ $(,)?) => {
        $($row.push($self.$($signal).+.val().number());)+
    };
    ($row:ident: $($($signal:ident).+),+ $(,)?) => {
        $($row.push($($signal).+.val().number());)+
    };
}

macro_rules! settle {
    () => {
        fn settle(&mut self) -> bool {
            self.update_all();
            !self.has_changed()
        }
    };
}

/// The pins of a unit without registers: its inputs, in the order in which the op reads them, and its output.
macro_rules! unit_pins {
    ($block:ident<$($width:ident),+>: $($input:ident),+ => $output:ident) => {
        impl<$(const $width: usize),+> $crate::pinned::Pinned for $block<$($width),+> {
            fn drive(&mut self, row: &[u64]) {
                $crate::pinned::drive!(self, row: $($input),+);
            }

            fn sample(&self, row: &mut Vec<u64>) {
                use $crate::pinned::Word;
                $crate::pinned::sample!(self, row: $output);
            }

            $crate::pinned::settle!();
        }
    };
}

pub(crate) use {drive, sample, settle, unit_pins};
