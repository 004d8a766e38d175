//! The machine's pins and registers in one fixed order.
//!
//! Stimulus, golden model, rust-hdl's simulation, Icarus and Verilator all speak in *rows*: one
//! unsigned number for each signal, in the order given here. One table, so that a comparison
//! compares the same things, and a mismatch has a name.

use crate::format::{Widths, bits_for};
use crate::hypercube::{Channel, Role};
use crate::machine::Machine;
use crate::register::{REGISTERS, Register};
use crate::stream::{Group, Inputs, Lane, Outputs, Photon, Query, Sums};

/// A signal: its Verilog name at the top level (or in the trace module) and its width.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pin {
    /// Its name.
    pub name: String,
    /// Its width in bits.
    pub width: u32,
    /// Where it is in the machine.
    pub place: SignalPlace,
}

/// Where a signal is.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum SignalPlace {
    /// A pin of the top module.
    Top,
    /// A register of the control block, by its index in [`CONTROL_REGISTERS`].
    Control(usize),
    /// A register of a cell.
    Cell {
        /// The cell's node index.
        node: usize,
        /// The register.
        register: Register,
    },
}

/// The control block's registers: program counter; "the group at work is the query's last"; "the
/// result waits to be taken".
pub const CONTROL_REGISTERS: [&str; 3] = ["address", "last", "done"];

const PHOTON_COORDINATES: [&str; 3] = ["x", "y", "z"];
const RESULT_CHANNELS: [Channel; 4] = [Channel::Red, Channel::Green, Channel::Blue, Channel::Count];

/// All signals of a machine, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pins {
    /// Input pins, without the clock.
    pub inputs: Vec<Pin>,
    /// Output pins, then the registers of the control block and of each cell.
    pub observed: Vec<Pin>,
    /// How many of `observed` are output pins.
    pub outputs: usize,
}

impl Pins {
    /// The signals of a machine.
    pub fn of(machine: &Machine) -> Self {
        let widths = Widths::of(machine);
        let mut observed = output_pins(&widths);
        let outputs = observed.len();
        observed.extend(control_pins(machine));
        observed.extend(cell_pins(machine, &widths));
        Self {
            inputs: input_pins(machine, &widths),
            observed,
            outputs,
        }
    }

    /// Puts one clock's inputs into a row of [`Self::inputs`].
    pub fn input_row(inputs: &Inputs) -> Vec<u64> {
        let mut row = vec![
            u64::from(inputs.reset),
            u64::from(inputs.query_valid),
            u64::from(inputs.query.position[0]),
            u64::from(inputs.query.position[1]),
            u64::from(inputs.query.position[2]),
            u64::from(inputs.query.radius_sq),
            u64::from(inputs.group_valid),
            u64::from(inputs.group.last),
        ];
        for lane in &inputs.group.lanes {
            row.push(u64::from(lane.present));
            row.extend(lane.photon.position.map(u64::from));
            row.extend(lane.photon.power.map(u64::from));
        }
        row.push(u64::from(inputs.result_ready));
        row
    }

    /// Reads a row of [`Self::inputs`] back. `lanes` is [`Machine::photons_per_iteration`].
    ///
    /// # Panics
    /// Where the row is not of that length.
    pub fn inputs_of(row: &[u64], lanes: usize) -> Inputs {
        let mut values = row.iter().copied();
        let mut next = || values.next().expect("a row has a value for each pin");
        let reset = next() != 0;
        let query_valid = next() != 0;
        let query = Query {
            position: [next() as u32, next() as u32, next() as u32],
            radius_sq: next() as u32,
        };
        let group_valid = next() != 0;
        let last = next() != 0;
        let lanes = (0..lanes)
            .map(|_| Lane {
                present: next() != 0,
                photon: Photon {
                    position: [next() as u32, next() as u32, next() as u32],
                    power: [next() as u32, next() as u32, next() as u32],
                },
            })
            .collect();
        Inputs {
            reset,
            query_valid,
            query,
            group_valid,
            group: Group { lanes, last },
            result_ready: next() != 0,
        }
    }

    /// Puts one clock's outputs into the first values of a row of [`Self::observed`].
    pub fn output_row(outputs: &Outputs) -> [u64; 7] {
        let [red, green, blue] = outputs.result.power;
        [
            u64::from(outputs.query_ready),
            u64::from(outputs.group_ready),
            u64::from(outputs.result_valid),
            red,
            green,
            blue,
            outputs.result.count,
        ]
    }

    /// Reads the output pins of a row of [`Self::observed`] back.
    pub fn outputs_of(row: &[u64]) -> Outputs {
        Outputs {
            query_ready: row[0] != 0,
            group_ready: row[1] != 0,
            result_valid: row[2] != 0,
            result: Sums {
                power: [row[3], row[4], row[5]],
                count: row[6],
            },
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
    pins.push(top("query_radius_sq", widths.distance));
    pins.push(top("group_valid", 1));
    pins.push(top("group_last", 1));
    for lane in 0..machine.photons_per_iteration() {
        pins.push(top(format!("photon_present_{lane}"), 1));
        for coordinate in PHOTON_COORDINATES {
            pins.push(top(
                format!("photon_{coordinate}_{lane}"),
                widths.coordinate,
            ));
        }
        for channel in Role::ALL.iter().filter(|role| role.coordinate().is_some()) {
            let name = channel.channel().name();
            pins.push(top(format!("photon_{name}_{lane}"), widths.power));
        }
    }
    pins.push(top("result_ready", 1));
    pins
}

fn output_pins(widths: &Widths) -> Vec<Pin> {
    let mut pins = vec![
        top("query_ready", 1),
        top("group_ready", 1),
        top("result_valid", 1),
    ];
    for channel in RESULT_CHANNELS {
        pins.push(top(format!("result_{}", channel.name()), widths.sum));
    }
    pins
}

fn control_pins(machine: &Machine) -> Vec<Pin> {
    let addresses = machine.microprogram().steps().len() as u128;
    CONTROL_REGISTERS
        .iter()
        .zip([bits_for(addresses - 1), 1, 1])
        .enumerate()
        .map(|(index, (name, width))| Pin {
            name: format!("control_{name}"),
            width,
            place: SignalPlace::Control(index),
        })
        .collect()
}

fn cell_pins(machine: &Machine, widths: &Widths) -> Vec<Pin> {
    let mut pins = Vec::new();
    for node in 0..machine.hypercube().nodes() {
        for row in REGISTERS {
            pins.push(Pin {
                name: format!("cell_{node}_{}", row.name),
                width: (row.width)(widths),
                place: SignalPlace::Cell {
                    node,
                    register: row.register,
                },
            });
        }
    }
    pins
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::MACHINES;

    #[test]
    fn rows_have_a_value_for_each_pin_and_are_read_back() {
        for machine in MACHINES {
            let pins = Pins::of(machine);
            let lanes = machine.photons_per_iteration();
            let mut values = 1..;
            let mut next = || values.next().unwrap_or(0);
            let inputs = Inputs {
                reset: true,
                query_valid: false,
                query: Query {
                    position: [next(), next(), next()],
                    radius_sq: next(),
                },
                group_valid: true,
                group: Group {
                    lanes: (0..lanes)
                        .map(|lane| Lane {
                            present: lane != 1,
                            photon: Photon {
                                position: [next(), next(), next()],
                                power: [next(), next(), next()],
                            },
                        })
                        .collect(),
                    last: true,
                },
                result_ready: true,
            };
            let row = Pins::input_row(&inputs);
            assert_eq!(row.len(), pins.inputs.len());
            assert_eq!(Pins::inputs_of(&row, lanes), inputs);
            let outputs = Outputs {
                query_ready: true,
                group_ready: false,
                result_valid: true,
                result: Sums {
                    power: [1, 2, 3],
                    count: 4,
                },
            };
            let row = Pins::output_row(&outputs);
            assert_eq!(row.len(), pins.outputs);
            assert_eq!(Pins::outputs_of(&row), outputs);
        }
    }

    #[test]
    fn names_are_unique() {
        let pins = Pins::of(&MACHINES[0]);
        let mut names: Vec<_> = pins.inputs.iter().chain(&pins.observed).collect();
        let all = names.len();
        names.sort_by(|a, b| a.name.cmp(&b.name));
        names.dedup_by(|a, b| a.name == b.name);
        assert_eq!(names.len(), all);
    }
}
