//! The machine's pins and registers in one fixed order.
//!
//! Stimulus, golden model, rust-hdl's simulation, Icarus and Verilator all exchange *rows*: one unsigned
//! number for each signal, in the order of [`Pins`]. With one table for all of them, each comparison is about
//! the same signals, and a mismatch has a name.

use crate::cell::{self, OVERLAPPED, Register, SEQUENTIAL};
use crate::formats::Widths;
use crate::leaf::{self, Leaf, LeafRegister};
use crate::machine::Machine;
use crate::spatial::{EngineRegister, HeadRegister, MemoryRegister, SpatialPins};
use crate::stream::{BatchPins, Group, Inputs, Lane, LeafEvents, Outputs, Photon, Query, Sums};

/// A signal with its width. Its Verilog name is that at the top level or in the trace module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pin {
    /// The signal's Verilog name.
    pub name: String,
    /// The signal's width in bits.
    pub width: u32,
    /// The signal's place in the machine.
    pub place: SignalPlace,
}

/// The place of a signal in the machine.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum SignalPlace {
    /// A pin of the top module.
    Top,
    /// A register of the control block, by its index in [`crate::CellTables::control_registers`].
    Control(usize),
    /// A register of a cell.
    Cell {
        /// The cell's node index.
        node: usize,
        /// The register of the cell.
        register: Register,
    },
    /// A register of a spatial machine's head.
    Head {
        /// The register of the head.
        register: HeadRegister,
        /// The index among several such registers; see [`HeadRegister`].
        index: usize,
    },
    /// A register of a spatial machine's photon memory.
    Memory {
        /// The register of the photon memory.
        register: MemoryRegister,
        /// The index among several such registers; see [`MemoryRegister`].
        index: usize,
    },
    /// A register of a leaf machine before its chain.
    Leaf {
        /// The register.
        register: LeafRegister,
        /// The index among several such registers; see [`LeafRegister`].
        index: usize,
    },
    /// A register of an engine of a spatial machine.
    Engine {
        /// The engine's number; engine 0 is next to the head.
        engine: usize,
        /// The register of the engine.
        register: EngineRegister,
        /// The index among several such registers; see [`crate::Instances`].
        index: usize,
    },
}

const PHOTON_COORDINATES: [&str; 3] = ["x", "y", "z"];
/// The name of the sum that counts the photons in range.
const COUNT: &str = "count";
/// Bits of a number of leaves of a pair.
const COUNT_OF_PAIR: u32 = Leaf::PAIR.ilog2() + 1;

/// All signals of a machine in their fixed order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pins {
    /// Input pins, without the clock.
    pub inputs: Vec<Pin>,
    /// Output pins, then the registers of the control block and of each cell.
    pub observed: Vec<Pin>,
    /// The number of output pins, which are the first signals of `observed`.
    pub outputs: usize,
}

impl Pins {
    /// Lists the signals of a machine.
    pub fn of(machine: &Machine) -> Self {
        let widths = Widths::of(machine);
        let mut observed = output_pins(machine, &widths);
        let outputs = observed.len();
        if let Some(program) = machine.microprogram() {
            observed.extend(cell::pins(machine, &SEQUENTIAL, &program.control_widths()));
        }
        if let Some(program) = machine.overlap_program() {
            observed.extend(cell::pins(machine, &OVERLAPPED, &program.control_widths()));
        }
        if let Some(leaf) = machine.leaf() {
            observed.extend(leaf::registers(machine, leaf));
        }
        if let Some(spatial) = machine.spatial() {
            observed.extend(SpatialPins::of(machine, spatial).registers());
        }
        Self {
            inputs: input_pins(machine, &widths),
            observed,
            outputs,
        }
    }

    /// Packs one clock's inputs into a row in the order of [`Self::inputs`].
    pub fn input_row(machine: &Machine, inputs: &Inputs) -> Vec<u64> {
        let shape = PhotonPins::of(machine);
        let mut row = vec![
            u64::from(inputs.reset),
            u64::from(inputs.query_valid),
            u64::from(inputs.query.position[0]),
            u64::from(inputs.query.position[1]),
            u64::from(inputs.query.position[2]),
        ];
        row.extend(
            shape
                .has_radius
                .then_some(u64::from(inputs.query.radius_sq)),
        );
        row.extend(shape.keeps_sets.then_some(u64::from(inputs.query_release)));
        if shape.has_leaves {
            row.extend([
                u64::from(inputs.batch.last),
                u64::from(inputs.batch.facings),
                u64::from(inputs.batch.tag),
            ]);
        }
        row.push(u64::from(inputs.group_valid));
        row.push(u64::from(inputs.group.last));
        row.extend(shape.has_leaves.then_some(u64::from(inputs.group.facing)));
        for lane in &inputs.group.lanes {
            row.push(u64::from(lane.present));
            row.extend(lane.photon.position.map(u64::from));
            row.extend(
                lane.photon.power[..shape.channels]
                    .iter()
                    .map(|&p| u64::from(p)),
            );
            row.extend(
                shape
                    .has_exponent
                    .then_some(u64::from(lane.photon.exponent)),
            );
        }
        row.push(u64::from(inputs.result_ready));
        row
    }

    /// Unpacks a row in the order of [`Self::inputs`].
    ///
    /// # Panics
    /// Where the row's length differs from the number of inputs.
    pub fn inputs_of(machine: &Machine, row: &[u64]) -> Inputs {
        let shape = PhotonPins::of(machine);
        let mut values = row.iter().copied();
        let mut next = || values.next().expect("a row has a value for each pin");
        let reset = next() != 0;
        let query_valid = next() != 0;
        let query = Query {
            position: [next() as u32, next() as u32, next() as u32],
            radius_sq: match machine.fixed_radius_sq() {
                Some(radius_sq) => radius_sq,
                None => next() as u32,
            },
        };
        let query_release = shape.keeps_sets && next() != 0;
        let batch = match shape.has_leaves {
            true => BatchPins {
                last: next() != 0,
                facings: next() as u32,
                tag: next() as u32,
            },
            false => BatchPins::default(),
        };
        let group_valid = next() != 0;
        let last = next() != 0;
        let facing = if shape.has_leaves { next() as u32 } else { 0 };
        let mut lane = || {
            let present = next() != 0;
            let mut photon = Photon {
                position: [next() as u32, next() as u32, next() as u32],
                ..Photon::default()
            };
            for power in &mut photon.power[..shape.channels] {
                *power = next() as u32;
            }
            if shape.has_exponent {
                photon.exponent = next() as u32;
            }
            Lane { present, photon }
        };
        let lanes = (0..machine.photons_per_iteration())
            .map(|_| lane())
            .collect();
        Inputs {
            reset,
            query_valid,
            query,
            query_release,
            batch,
            group_valid,
            group: Group {
                lanes,
                last,
                facing,
            },
            result_ready: next() != 0,
        }
    }

    /// Packs one clock's outputs into values in the order of the output pins of [`Self::observed`].
    pub fn output_row(machine: &Machine, outputs: &Outputs) -> Vec<u64> {
        let mut row = vec![
            u64::from(outputs.query_ready),
            u64::from(outputs.group_ready),
            u64::from(outputs.result_valid),
        ];
        // A sum has at most 64 bits.
        let powers = &outputs.result.power[..PhotonPins::of(machine).channels];
        row.extend(powers.iter().map(|&power| power as u64));
        row.push(outputs.result.count);
        if machine.leaf().is_some() {
            let events = outputs.events;
            row.extend([outputs.result_tag, events.compared, events.wanted].map(u64::from));
            row.push(u64::from(events.played));
        }
        row
    }

    /// Unpacks the output pins of a row in the order of [`Self::observed`].
    ///
    /// # Panics
    /// Where the row is shorter than the output pins.
    pub fn outputs_of(machine: &Machine, row: &[u64]) -> Outputs {
        let (ready, sums) = row.split_at(3);
        let channels = PhotonPins::of(machine).channels;
        let has_leaves = machine.leaf().is_some();
        let of_leaf = |place: usize| {
            if has_leaves {
                sums[channels + place]
            } else {
                0
            }
        };
        let power = |channel| (channel < channels).then(|| u128::from(sums[channel]));
        Outputs {
            query_ready: ready[0] != 0,
            group_ready: ready[1] != 0,
            result_valid: ready[2] != 0,
            result: Sums {
                power: std::array::from_fn(|channel| power(channel).unwrap_or(0)),
                count: sums[channels],
            },
            result_tag: of_leaf(1) as u32,
            events: LeafEvents {
                compared: of_leaf(2) as u32,
                wanted: of_leaf(3) as u32,
                played: of_leaf(4) != 0,
            },
        }
    }
}

/// The words that a photon has on a machine's pins.
#[derive(Copy, Clone)]
struct PhotonPins {
    channels: usize,
    has_exponent: bool,
    has_radius: bool,
    keeps_sets: bool,
    has_leaves: bool,
}

impl PhotonPins {
    fn of(machine: &Machine) -> Self {
        Self {
            channels: machine.channels().names().len(),
            has_exponent: Widths::of(machine).exponent > 0,
            has_radius: machine.fixed_radius_sq().is_none(),
            keeps_sets: machine.keeps_sets(),
            has_leaves: machine.leaf().is_some(),
        }
    }
}

fn top(name: impl Into<String>, width: u32) -> Pin {
    Pin {
        name: name.into(),
        width,
        place: SignalPlace::Top,
    }
}

fn input_pins(machine: &Machine, widths: &Widths) -> Vec<Pin> {
    let mut pins = vec![top("reset", 1), top("query_valid", 1)];
    for coordinate in PHOTON_COORDINATES {
        pins.push(top(format!("query_{coordinate}"), widths.coordinate));
    }
    if machine.fixed_radius_sq().is_none() {
        pins.push(top("query_radius_sq", widths.radius_sq));
    }
    if machine.keeps_sets() {
        pins.push(top("query_release", 1));
    }
    if machine.leaf().is_some() {
        pins.push(top("query_last", 1));
        pins.push(top("query_facings", Leaf::FACINGS));
        pins.push(top("query_tag", Leaf::TAG_BITS));
    }
    pins.push(top("group_valid", 1));
    pins.push(top("group_last", 1));
    if machine.leaf().is_some() {
        pins.push(top("group_facing", Leaf::FACING_BITS));
    }
    for lane in 0..machine.photons_per_iteration() {
        pins.push(top(format!("photon_present_{lane}"), 1));
        for coordinate in PHOTON_COORDINATES {
            pins.push(top(format!("photon_{coordinate}_{lane}"), widths.photon));
        }
        for channel in machine.channels().names() {
            pins.push(top(format!("photon_{channel}_{lane}"), widths.mantissa));
        }
        if widths.exponent > 0 {
            pins.push(top(format!("photon_exponent_{lane}"), widths.exponent));
        }
    }
    pins.push(top("result_ready", 1));
    pins
}

fn output_pins(machine: &Machine, widths: &Widths) -> Vec<Pin> {
    let mut pins = vec![
        top("query_ready", 1),
        top("group_ready", 1),
        top("result_valid", 1),
    ];
    for channel in machine.channels().names() {
        pins.push(top(format!("result_{channel}"), widths.sum));
    }
    pins.push(top(format!("result_{COUNT}"), widths.count));
    if machine.leaf().is_some() {
        pins.push(top("result_tag", Leaf::TAG_BITS));
        pins.push(top("compared", COUNT_OF_PAIR));
        pins.push(top("wanted", COUNT_OF_PAIR));
        pins.push(top("played", 1));
    }
    pins
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::{MACHINES, find_machine};

    /// The named machines and a leaf machine.
    fn machines() -> Vec<&'static Machine> {
        let leaf = find_machine("leaf-5-local7-rgb6d-n4096").unwrap();
        MACHINES.iter().chain([leaf]).collect()
    }

    #[test]
    fn rows_have_a_value_for_each_pin_and_are_read_back() {
        for machine in machines() {
            let pins = Pins::of(machine);
            let shape = PhotonPins::of(machine);
            let mut values = 1..;
            let mut next = || values.next().unwrap_or(0);
            let mut lane = |index| Lane {
                present: index != 1,
                photon: Photon {
                    position: [next(), next(), next()],
                    power: [0, 1, 2]
                        .map(|channel| if channel < shape.channels { next() } else { 0 }),
                    exponent: if shape.has_exponent { next() } else { 0 },
                },
            };
            let inputs = Inputs {
                reset: true,
                query_valid: false,
                query: Query {
                    position: [101, 102, 103],
                    radius_sq: machine.fixed_radius_sq().unwrap_or(104),
                },
                query_release: machine.keeps_sets(),
                batch: match machine.leaf() {
                    Some(_) => BatchPins {
                        last: true,
                        facings: 105,
                        tag: 106,
                    },
                    None => BatchPins::default(),
                },
                group_valid: true,
                group: Group {
                    lanes: (0..machine.photons_per_iteration())
                        .map(&mut lane)
                        .collect(),
                    last: true,
                    facing: if machine.leaf().is_some() { 7 } else { 0 },
                },
                result_ready: true,
            };
            let row = Pins::input_row(machine, &inputs);
            assert_eq!(row.len(), pins.inputs.len());
            assert_eq!(Pins::inputs_of(machine, &row), inputs);
            let power = [1, 2, 3].map(|value| {
                if value <= shape.channels as u128 {
                    value
                } else {
                    0
                }
            });
            let outputs = Outputs {
                query_ready: true,
                group_ready: false,
                result_valid: true,
                result: Sums { power, count: 4 },
                result_tag: if machine.leaf().is_some() { 5 } else { 0 },
                events: match machine.leaf() {
                    Some(_) => LeafEvents {
                        compared: 1,
                        wanted: 2,
                        played: true,
                    },
                    None => LeafEvents::default(),
                },
            };
            let row = Pins::output_row(machine, &outputs);
            assert_eq!(row.len(), pins.outputs);
            assert_eq!(Pins::outputs_of(machine, &row), outputs);
        }
    }

    #[test]
    fn names_are_unique() {
        for machine in machines() {
            let pins = Pins::of(machine);
            let mut names: Vec<_> = pins.inputs.iter().chain(&pins.observed).collect();
            let all = names.len();
            names.sort_by(|a, b| a.name.cmp(&b.name));
            names.dedup_by(|a, b| a.name == b.name);
            assert_eq!(names.len(), all);
        }
    }
}
