//! The serial wrapper in which a machine is placed.
//!
//! A machine has more ports than a package has pins. A shift register drives all its inputs, reset included.
//! A register stores all its outputs, which are folded into a second shift register. Each path of the machine
//! then begins and ends at registers, and counts; no pin is on any of them.

use std::collections::BTreeMap;

use anyhow::{Context, Result, bail};
use serde::Deserialize;

/// The module of the wrapper, which has three pins.
pub const TOP: &str = "serial";
/// The name of the wrapper's file, with which Yosys's `src` attribute of its cells begins.
pub const FILE: &str = "serial.v";
/// The input of the wrapper's first register.
pub const SERIAL_IN: &str = "serial_in";
/// The shift register into which the machine's outputs are folded.
pub const FOLDED: &str = "folded";
/// The instance of the machine in the wrapper.
pub const INSTANCE: &str = "machine";
/// The clock of the wrapper and of the machine.
pub const CLOCK: &str = "clock";

/// The ports in the output of Yosys's `write_json`.
#[derive(Deserialize)]
struct Netlist {
    modules: BTreeMap<String, Module>,
}

#[derive(Deserialize)]
struct Module {
    ports: BTreeMap<String, Port>,
}

#[derive(Deserialize)]
struct Port {
    direction: String,
    bits: Vec<serde_json::Value>,
}

/// Ports that share a bus, each on its own bits.
#[derive(Default)]
struct Bus {
    connections: Vec<String>,
    width: usize,
}

impl Bus {
    fn connect(&mut self, port: &str, bus: &str, width: usize) {
        let low = self.width;
        self.width += width;
        let high = self.width - 1;
        self.connections
            .push(format!(".{port}({bus}[{high}:{low}])"));
    }
}

/// A port of a machine; the clock is not among these.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MachinePort {
    /// The name of the port.
    pub name: String,
    /// Whether the wrapper drives the port; otherwise the wrapper stores its value.
    pub is_input: bool,
    /// The width of the port in bits.
    pub width: usize,
}

/// The ports of a machine, from its netlist as `read_verilog -lib; write_json` writes it. They are in the
/// order of their bits in the wrapper's registers, the lowest first.
///
/// # Errors
/// The netlist is of another machine, or has no clock.
pub fn ports(top: &str, netlist: &str) -> Result<Vec<MachinePort>> {
    let mut netlist: Netlist =
        serde_json::from_str(netlist).context("what Yosys's `write_json` writes")?;
    let module = netlist.modules.remove(top);
    let mut ports = module
        .with_context(|| format!("found no module {top}"))?
        .ports;
    match ports.remove(CLOCK) {
        Some(clock) if clock.direction == "input" && clock.bits.len() == 1 => {}
        _ => bail!(
            "found no input {CLOCK} of one bit in {top}, expected one that clocks the machine"
        ),
    }
    // The order is that of the text, in which Yosys numbers the bits. The order affects the placer's result
    // for a seed.
    let mut ports: Vec<_> = ports.into_iter().collect();
    ports.sort_by_key(|(_, port)| port.bits.first().and_then(serde_json::Value::as_u64));
    let port = |(name, port): (String, Port)| {
        let is_input = match port.direction.as_str() {
            "input" => true,
            "output" => false,
            other => bail!("found the {other} {name} in {top}, expected inputs and outputs"),
        };
        Ok(MachinePort {
            name,
            is_input,
            width: port.bits.len(),
        })
    };
    ports.into_iter().map(port).collect()
}

/// The wrapper of a machine with these ports.
///
/// # Errors
/// The machine has no inputs, or no outputs.
pub fn around(top: &str, ports: &[MachinePort]) -> Result<String> {
    let (mut driven, mut shown) = (Bus::default(), Bus::default());
    for port in ports {
        match port.is_input {
            true => driven.connect(&port.name, "driven", port.width),
            false => shown.connect(&port.name, "shown", port.width),
        }
    }
    if driven.width == 0 || shown.width == 0 {
        bail!("found no inputs or no outputs in {top}, expected both");
    }
    Ok(text(top, &driven, &shown))
}

fn text(top: &str, driven: &Bus, shown: &Bus) -> String {
    let clock = format!(".{CLOCK}({CLOCK})");
    let mut connections = vec![clock];
    connections.extend_from_slice(&driven.connections);
    connections.extend_from_slice(&shown.connections);
    let connections = connections.join(", ");
    let (driven, shown) = (driven.width - 1, shown.width - 1);
    format!(
        "module {TOP}({CLOCK}, {SERIAL_IN}, serial_out);
    input wire {CLOCK};
    input wire {SERIAL_IN};
    output wire serial_out;
    reg [{driven}:0] driven;
    wire [{shown}:0] shown;
    reg [{shown}:0] taken;
    // Each bit that was taken reaches the pin, so none may be optimised away.
    reg [{shown}:0] folded;
    {top} {INSTANCE}({connections});
    assign serial_out = folded[{shown}];
    always @(posedge {CLOCK}) begin
        driven <= {{driven, {SERIAL_IN}}};
        taken <= shown;
        folded <= {{folded, 1'b0}} ^ taken;
    end
endmodule
"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const NETLIST: &str = r#"{"modules": {"the_top": {"ports": {
        "reset": {"direction": "input", "bits": [2]},
        "clock": {"direction": "input", "bits": [3]},
        "power": {"direction": "input", "bits": [4, 5, 6, 7]},
        "sum": {"direction": "output", "bits": [8, 9, 10, 11, "0"]}
    }, "cells": {}}}}"#;

    #[test]
    fn each_port_has_bits_of_its_own() {
        let text = around("the_top", &ports("the_top", NETLIST).unwrap()).unwrap();
        let instance = "the_top machine(.clock(clock), .reset(driven[0:0]), .power(driven[4:1]), .sum(shown[4:0]));";
        assert!(text.contains(instance), "{text}");
        assert!(text.contains("reg [4:0] driven;") && text.contains("reg [4:0] taken;"));
    }

    #[test]
    fn a_machine_without_a_clock_is_refused() {
        let error = |netlist: &str| ports("the_top", netlist).unwrap_err().to_string();
        assert!(error(&NETLIST.replace("clock", "clk")).contains("no input clock"));
        assert!(error(&NETLIST.replace("the_top", "other")).contains("no module the_top"));
        assert!(error(&NETLIST.replace("output", "inout")).contains("found the inout sum"));
    }
}
