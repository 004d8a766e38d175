//! The serial wrapper in which a design is placed.
//!
//! A design has more ports than a package has pins. A shift register drives all its inputs, reset included.
//! A register stores all its outputs, which are folded into a second shift register. Each path of the design
//! then begins and ends at registers, and counts; no pin is on any of them.

use crate::error::{Result, ensure, unexpected};
use crate::netlist::{Netlist, Port};

/// The module of the wrapper, which has three pins.
pub const TOP: &str = "serial";
/// The name of the wrapper's file, with which Yosys's `src` attribute of its cells begins.
pub const FILE: &str = "serial.v";
/// The input of the wrapper's first register.
pub const SERIAL_IN: &str = "serial_in";
/// The shift register into which the design's outputs are folded.
pub const FOLDED: &str = "folded";
/// The instance of the design in the wrapper.
pub const INSTANCE: &str = "machine";
/// The clock of the wrapper and of the design.
pub const CLOCK: &str = "clock";

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

/// The ports of a design without its clock, in the order of its text, from its netlist as `read_verilog -lib;
/// write_json` writes it. They are in the order of their bits in the wrapper's registers, the lowest first. The
/// order affects the placer's result for a seed.
///
/// # Errors
/// The netlist is of another design, or has no clock.
pub fn ports(top: &str, netlist: &Netlist) -> Result<Vec<Port>> {
    let mut ports = netlist.module(top)?.ports();
    let is_clock =
        |port: &Port| port.name == CLOCK && port.direction == "input" && port.width() == 1;
    let Some(clock) = ports.iter().position(is_clock) else {
        return Err(unexpected(format!(
            "found no input {CLOCK} of one bit in {top}, expected one that clocks the design"
        )));
    };
    ports.remove(clock);
    for port in &ports {
        ensure(
            ["input", "output"].contains(&port.direction.as_str()),
            || {
                let Port {
                    name, direction, ..
                } = port;
                format!("found the {direction} {name} in {top}, expected inputs and outputs")
            },
        )?;
    }
    Ok(ports)
}

/// The wrapper of a design with these ports, as Verilog.
///
/// # Errors
/// The design has no inputs, or no outputs.
pub fn around(top: &str, ports: &[Port]) -> Result<String> {
    let (mut driven, mut shown) = (Bus::default(), Bus::default());
    for port in ports {
        match port.is_input() {
            true => driven.connect(&port.name, "driven", port.width()),
            false => shown.connect(&port.name, "shown", port.width()),
        }
    }
    ensure(driven.width > 0 && shown.width > 0, || {
        format!("found no inputs or no outputs in {top}, expected both")
    })?;
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

    fn of(netlist: &str) -> Result<Vec<Port>> {
        ports("the_top", &Netlist::parse(netlist)?)
    }

    #[test]
    fn each_port_has_bits_of_its_own() {
        let text = around("the_top", &of(NETLIST).unwrap()).unwrap();
        let instance = "the_top machine(.clock(clock), .reset(driven[0:0]), .power(driven[4:1]), .sum(shown[4:0]));";
        assert!(text.contains(instance), "{text}");
        assert!(text.contains("reg [4:0] driven;") && text.contains("reg [4:0] taken;"));
    }

    #[test]
    fn a_design_without_a_clock_is_refused() {
        let error = |netlist: &str| of(netlist).unwrap_err().to_string();
        assert!(error(&NETLIST.replace("clock", "clk")).contains("no input clock"));
        assert!(error(&NETLIST.replace("the_top", "other")).contains("no module the_top"));
        assert!(error(&NETLIST.replace("output", "inout")).contains("found the inout sum"));
    }
}
