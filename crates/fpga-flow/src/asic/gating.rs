//! Clock gates: cells of a library that pass a clock edge to registers only where these are enabled.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value, json};

use super::fanout;
use super::library::Library;
use crate::error::{Result, unexpected};
use crate::netlist::{Netlist, connections};

/// The fewest registers of one enable that get a clock gate. A gate of NanGate 45 takes the energy of the clock edges of three registers.
pub(super) const FEWEST_REGISTERS: u32 = 4;

/// The most registers of a clock gate. Behind more, the edges of the gate's smallest cell are so slow that the registers take more energy.
const MOST_REGISTERS: usize = 16;

/// The clock gate of a library.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ClockGate {
    /// The name of the cell.
    pub cell: String,
    /// The names of the pins.
    pub clock: String,
    pub enable: String,
    pub output: String,
}

/// A module of eight registers with an enable, by which the library shows its clock gate.
pub(super) const PROBE: &str = "\
module gated(input clock, input e, input [7:0] d, output reg [7:0] q); always @(posedge clock) if (e) q <= d; endmodule
";

/// The commands that map [`PROBE`] and write it to gate-probe.json.
pub(super) fn probe_script(liberty: &str) -> String {
    format!(
        "design -reset; read_liberty -lib -ignore_miss_func {liberty}; read_verilog gate-probe.v; synth -top gated; {}; \
         write_json gate-probe.json",
        script(liberty)
    )
}

/// The commands that put clock gates before the registers of a design.
pub(super) fn script(liberty: &str) -> String {
    format!(
        "dfflegalize -cell $_DFFE_PP_ 0 -cell $_DFF_P_ 0 ; opt_clean; \
         clockgate -liberty {liberty} -min_net_size {FEWEST_REGISTERS} "
    )
}

impl ClockGate {
    /// The cell between the clock and the registers of the probe; `None` where Yosys found none in the library.
    pub(super) fn of_probe(probe: &Netlist) -> Option<Self> {
        let module = &probe.json()["modules"]["gated"];
        let [clock, enable] = ["clock", "e"].map(|port| &module["ports"][port]["bits"]);
        let mut cells = module["cells"].as_object()?.values();
        cells.find_map(|cell| {
            let on = cell["connections"].as_object()?;
            let pin = |bits: &Value| Some(on.iter().find(|(_, on)| *on == bits)?.0.clone());
            let mut outputs = connections(cell).filter(|(_, is_output, _)| *is_output);
            let kind = cell["type"].as_str()?;
            (!kind.starts_with('$')).then_some(())?;
            Some(Self {
                cell: kind.to_owned(),
                clock: pin(clock)?,
                enable: pin(enable)?,
                output: outputs.next()?.0.to_owned(),
            })
        })
    }

    /// The Verilog of the cell: a latch that is open while the clock is 0, and an AND. Inputs of a test are not connected.
    pub(super) fn model(&self, module: &Value) -> String {
        let Self {
            cell,
            clock,
            enable,
            output,
        } = self;
        let ports = module["ports"].as_object().into_iter().flatten();
        let ports: Vec<_> = ports
            .map(|(port, of)| {
                let direction = of["direction"].as_str().unwrap_or("input");
                format!("{direction} {port}")
            })
            .collect();
        format!(
            "\nmodule {cell}({});\n  reg enabled;\n  always @({clock} or {enable}) if (!{clock}) enabled = {enable};\n  \
             assign {output} = {clock} & enabled;\nendmodule\n",
            ports.join(", ")
        )
    }
}

/// The nets behind the clock gates of a module: by net, the net of its enable.
pub(super) fn gated_nets(module: &Value, library: &Library) -> Result<BTreeMap<u64, u64>> {
    let Some(gate) = library.clock_gate() else {
        return Ok(BTreeMap::new());
    };
    let cells = module["cells"].as_object().into_iter().flatten();
    let gates = cells.filter(|(_, cell)| cell["type"] == *gate.cell);
    gates
        .map(|(name, cell)| {
            let net = |pin: &str| {
                cell["connections"][pin][0].as_u64().ok_or_else(|| {
                    unexpected(format!(
                        "found no net on pin {pin} of the clock gate {name}"
                    ))
                })
            };
            Ok((net(&gate.output)?, net(&gate.enable)?))
        })
        .collect()
}

/// Gives each clock gate at most [`MOST_REGISTERS`] readers, by copies of it.
pub(super) fn divide(module: &mut Value, library: &Library) -> Result<()> {
    let gated = gated_nets(module, library)?;
    let Some(gate) = library.clock_gate().filter(|_| !gated.is_empty()) else {
        return Ok(());
    };
    let mut next_net = fanout::last_net(module) + 1;
    let mut readers = fanout::readers(&module["cells"]);
    let cells = module["cells"].as_object().into_iter().flatten();
    let gates: Vec<_> = cells
        .filter(|(_, cell)| cell["type"] == *gate.cell)
        .map(|(_, cell)| cell.clone())
        .collect();
    for (number, cell) in gates.iter().enumerate() {
        let net = cell["connections"][&gate.output][0].as_u64();
        let pins = net.and_then(|net| readers.remove(&net)).unwrap_or_default();
        for (copy, pins) in pins.chunks(MOST_REGISTERS).enumerate().skip(1) {
            let mut cell = cell.clone();
            cell["connections"][&gate.output] = json!([next_net]);
            module["cells"][format!("gate_{number}_{copy}")] = cell;
            for (register, pin) in pins {
                module["cells"][register]["connections"][pin] = json!([next_net]);
            }
            next_net += 1;
        }
    }
    Ok(())
}

/// The clock of a module and the nets behind its clock gates.
pub(super) fn clocks(module: &Value, library: &Library) -> Result<BTreeSet<u64>> {
    let clock = module["ports"][super::CLOCK]["bits"][0].as_u64();
    let gated = gated_nets(module, library)?;
    Ok(gated.into_keys().chain(clock).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn library() -> Library {
        let [cell, clock, enable, output] = ["GATE", "CK", "E", "GCK"].map(str::to_owned);
        Library::small().with_clock_gate(ClockGate {
            cell,
            clock,
            enable,
            output,
        })
    }

    #[test]
    fn a_gate_of_many_registers_gets_copies_with_its_enable() {
        let mut cells = json!({"_1_": {"type": "GATE",
            "port_directions": {"CK": "input", "E": "input", "GCK": "output"},
            "connections": {"CK": [2], "E": [3], "GCK": [4]}}});
        for register in 0..40 {
            cells[format!("register_{register}")] = json!({"type": "DFF",
                "port_directions": {"CK": "input", "D": "input", "Q": "output"},
                "connections": {"CK": [4], "D": [3], "Q": [5 + register]}});
        }
        let mut module = json!({"ports": {"clock": {"direction": "input", "bits": [2]}}, "cells": cells, "netnames": {}});
        divide(&mut module, &library()).unwrap();

        let gated = gated_nets(&module, &library()).unwrap();
        assert_eq!(gated.values().collect::<Vec<_>>(), [&3; 3]);
        let readers = fanout::readers(&module["cells"]);
        let mut counts: Vec<_> = gated.keys().map(|net| readers[net].len()).collect();
        counts.sort_unstable();
        assert_eq!(counts, [8, MOST_REGISTERS, MOST_REGISTERS]);
        // The clock is read by the gates alone.
        assert_eq!(readers[&2].len(), 3);
        assert_eq!(clocks(&module, &library()).unwrap().len(), 4);
    }
}
