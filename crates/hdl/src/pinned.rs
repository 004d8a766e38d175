//! Blocks whose pins are driven and observed as rows of numbers.

use photoncube_spec::{Machine, Organisation, REGISTERS, Register, overlap};
use photoncube_spec::{Pin, Pins, SignalPlace, Widths};
use rust_hdl::core::atom::{Atom, AtomKind};
use rust_hdl::prelude::*;

use crate::cell::Cell;
use crate::emit::{BlockRam, ChannelNames};
use crate::level::Level;
use crate::network::Network;
use crate::processor::Processor;
use crate::units::{AddUnit, GateUnit, SquareUnit};

/// A block whose inputs, outputs and registers are rows of numbers.
pub(crate) trait Pinned: Block {
    /// Sets the clock pin, if the block has one.
    fn set_clock(&mut self, _level: bool) {}
    /// Drives the input pins, in the order of [`pins`].
    fn drive(&mut self, row: &[u64]);
    /// Appends the output pins and the registers, in the order of [`pins`].
    fn sample(&self, row: &mut Vec<u64>);
    /// The path of a register in the top instance; `None` for blocks that hold no such register.
    fn register_path(&self, _place: SignalPlace) -> Option<String> {
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
    let mut pins = block_pins(block);
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
    if level == Level::Cell {
        let widths = Widths::of(machine);
        if machine.organisation == Organisation::Overlapped {
            let registers = overlap::Register::all().map(|register| Pin {
                name: format!("register_{}", register.name()),
                width: register.width(&widths),
                place: SignalPlace::OverlapCell { node: 0, register },
            });
            pins.observed.extend(registers);
            return pins;
        }
        pins.observed.extend(REGISTERS.iter().map(|row| Pin {
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
}

macro_rules! settle {
    () => {
        fn settle(&mut self) -> bool {
            self.update_all();
            !self.has_changed()
        }
    };
}

pub(crate) use {drive, sample, settle};

impl<const S: usize> Pinned for AddUnit<S> {
    fn drive(&mut self, row: &[u64]) {
        drive!(self, row: a, b);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: sum);
    }

    settle!();
}

impl<const C: usize, const H: usize, const M: usize, const Q: usize> Pinned
    for SquareUnit<C, H, M, Q>
{
    fn drive(&mut self, row: &[u64]) {
        drive!(self, row: a, b);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: square);
    }

    settle!();
}

impl<const V: usize, const R: usize, const P: usize> Pinned for GateUnit<V, R, P> {
    fn drive(&mut self, row: &[u64]) {
        drive!(self, row: a, b, power);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: gated);
    }

    settle!();
}

impl<const N: usize, const V: usize, const X: usize> Pinned for Network<N, V, X> {
    fn drive(&mut self, row: &[u64]) {
        let mut driver = Driver::new(row);
        driver.put(&mut self.axis);
        for work in &mut self.work {
            driver.put(work);
        }
    }

    fn sample(&self, row: &mut Vec<u64>) {
        row.extend(self.link.iter().map(|link| link.val().number()));
    }

    settle!();
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
> Cell<C, H, M, Q, R, P, V, S>
{
    fn sample_registers(&self, row: &mut Vec<u64>) {
        for register in REGISTERS {
            row.push(match register.register {
                Register::Query => self.query.q.val().number(),
                Register::RadiusSq => self.radius_sq.q.val().number(),
                Register::Photon => self.photon.q.val().number(),
                Register::Power => self.power.q.val().number(),
                Register::Work => self.work.q.val().number(),
                Register::Sum => self.sum.q.val().number(),
            });
        }
    }
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
> Pinned for Cell<C, H, M, Q, R, P, V, S>
{
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        drive!(
            self, row: write_query, write_photon, write_power, write_work, write_sum, work_source,
            add_sum, query_in, radius_sq_in, photon_in, present_in, power_in, link_in,
        );
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: work_out, sum_out);
        self.sample_registers(row);
    }

    settle!();
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const W: usize,
    const X: usize,
    const N: usize,
    const G: usize,
> Pinned for Processor<C, H, M, Q, R, B, E, P, V, S, A, W, X, N, G>
{
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        let mut driver = Driver::new(row);
        driver.put(&mut self.reset);
        driver.put(&mut self.query_valid);
        driver.put(&mut self.query_x);
        driver.put(&mut self.query_y);
        driver.put(&mut self.query_z);
        driver.put(&mut self.query_radius_sq);
        driver.put(&mut self.group_valid);
        driver.put(&mut self.group_last);
        for lane in 0..G {
            driver.put(&mut self.photon_present[lane]);
            driver.put(&mut self.photon_x[lane]);
            driver.put(&mut self.photon_y[lane]);
            driver.put(&mut self.photon_z[lane]);
            for channel in self.photon_channel.iter_mut().skip(lane).step_by(G) {
                driver.put(channel);
            }
            if let Some(exponent) = self.photon_exponent.get_mut(lane) {
                driver.put(exponent);
            }
        }
        driver.put(&mut self.result_ready);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: query_ready, group_ready, result_valid);
        row.extend(self.result.iter().map(|result| result.val().number()));
        sample!(self, row: control.address.q, control.last.q, control.done.q);
        for cell in &self.cell {
            cell.sample_registers(row);
        }
    }

    settle!();
}
