//! Divides the clock of a netlist that is simulated.
//!
//! To compile a net, Icarus 11 takes time that grows with the square of its pins: 43 of 48 seconds for a clock with 20,000 registers. So no
//! more than [`MOST_READERS`] cells read a net of the clock.

use serde_json::json;

use super::CLOCK;
use super::fanout::{last_net, readers};
use crate::error::{Result, unexpected};
use crate::netlist::Netlist;

/// The most cells that read a net of the clock. The time to compile is the same from 64 to 1024.
const MOST_READERS: usize = 256;

/// The buffer before each part of the clock. All registers store in the nonblocking step of a time, which follows all edges of the clock at
/// that time, so the buffers change no result.
pub(super) const MODULE: &str =
    "\nmodule clock_part(input clock, output part);\n  buf (part, clock);\nendmodule\n";

/// Gives the readers of the top module's clock parts of it, each behind a `clock_part`.
///
/// # Errors
/// The module has no port `clock`.
pub(super) fn divide(netlist: &mut Netlist, top: &str) -> Result<()> {
    let module = &mut netlist.json_mut()["modules"][top];
    let clock = module["ports"][CLOCK]["bits"][0].as_u64();
    let clock =
        clock.ok_or_else(|| unexpected(format!("found no port `{CLOCK}` of the netlist {top}")))?;
    let first = last_net(module) + 1;
    let pins = readers(&module["cells"]).remove(&clock).unwrap_or_default();
    for (net, pins) in (first..).zip(pins.chunks(MOST_READERS)) {
        let name = format!("clock_part_{}", net - first);
        for (cell, pin) in pins {
            module["cells"][cell]["connections"][pin] = json!([net]);
        }
        module["cells"][&name] = json!({
            "hide_name": 0, "type": "clock_part", "parameters": {}, "attributes": {},
            "port_directions": {"clock": "input", "part": "output"},
            "connections": {"clock": [clock], "part": [net]}
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Registers on one clock, each with an input from the one before.
    fn netlist(registers: u64) -> Netlist {
        let mut cells = json!({});
        for register in 0..registers {
            cells[format!("_{register}_")] = json!({"type": "DFF",
                "port_directions": {"CLK": "input", "D": "input", "Q": "output"},
                "connections": {"CLK": [2], "D": [3 + register], "Q": [4 + register]}});
        }
        let ports = json!({"clock": {"direction": "input", "bits": [2]}});
        Netlist::from(json!({"modules": {"top": {"ports": ports, "cells": cells, "netnames": {}}}}))
    }

    #[test]
    fn no_part_of_the_clock_has_too_many_readers() {
        let mut netlist = netlist(600);
        divide(&mut netlist, "top").unwrap();
        let cells = &netlist.json()["modules"]["top"]["cells"];
        let readers = readers(cells);
        let parts: Vec<_> = readers[&2].iter().map(|(cell, _)| cell).collect();
        let behind = |part: &String| {
            let net = cells[part]["connections"]["part"][0].as_u64().unwrap();
            readers[&net].len()
        };
        assert_eq!(
            parts.into_iter().map(behind).collect::<Vec<_>>(),
            [256, 256, 88]
        );
        // All else is as it was.
        for register in 0..600 {
            let on = &cells[format!("_{register}_")]["connections"];
            assert_eq!(
                (&on["D"][0], &on["Q"][0]),
                (&json!(3 + register), &json!(4 + register))
            );
        }
    }

    #[test]
    fn a_netlist_without_a_clock_is_an_error() {
        let error = divide(&mut netlist(1), "other").unwrap_err().to_string();
        assert!(
            error.contains("no port `clock` of the netlist other"),
            "{error}"
        );
    }
}
