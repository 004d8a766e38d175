//! Extracts the machine from the placed netlist, without the serial wrapper around it.
//!
//! The placed netlist has three pins, so a testbench could not drive the machine clock by clock. The wrapper
//! consists of registers: one in front of each input bit, in a chain that begins at the pin; one behind each
//! output bit; and a second chain into which these are folded. The `src` attribute marks the wrapper's cells.
//! Each is checked to be what the wrapper's text states: a plain flip-flop in its place of the chain, or an
//! exclusive or between two of them. The nets behind the first chain then become the machine's inputs, the
//! inputs of the registers behind the outputs become its outputs, and every other cell of the netlist is
//! kept. It is an error if a cell of the machine reads a removed net, or if a register of the wrapper
//! remains. So the simulation covers everything that is placed but the wrapper.

use std::collections::{HashMap, HashSet};
use std::fmt::Write;

use serde_json::Value;

use crate::error::{FlowError, Result, ensure, unexpected};
use crate::netlist::verilog::{end, instance, list};
use crate::netlist::{Netlist, Port, Readers, cells, connections, is_bookkeeping, readers, word};
use crate::wrapper::{CLOCK, FILE, FOLDED, SERIAL_IN};

/// A netlist in its wrapper.
struct Wrapped<'a> {
    module: &'a Value,
    readers: Readers,
    /// The driver of each net, a cell.
    drivers: HashMap<u64, &'a str>,
    /// The flip-flops of the wrapper.
    registers: HashSet<&'a str>,
    clock: &'a Value,
}

/// The machine's netlist as a Verilog module `name` with the machine's ports and its clock.
///
/// # Errors
/// The machine's surroundings are not its wrapper.
pub fn unwrapped(netlist: &Netlist, name: &str, ports: &[Port]) -> Result<String> {
    let wrapped = Wrapped::of(netlist.top()?)?;
    let width = |is_input| {
        let ports = ports.iter().filter(|port| port.is_input() == is_input);
        ports.map(Port::width).sum::<usize>()
    };
    let driven = wrapped.driven(width(true))?;
    let mut removed: HashSet<&str> = driven.iter().copied().collect();
    let shown = wrapped.shown(width(false), &mut removed)?;
    wrapped.check(&driven, &removed)?;
    let inputs: Vec<_> = driven.iter().map(|name| wrapped.output(name)).collect();
    text(&wrapped, &removed, name, ports, &inputs, &shown)
}

impl<'a> Wrapped<'a> {
    fn of(module: &'a Value) -> Result<Self> {
        let cells = cells(module)?;
        let mut drivers = HashMap::new();
        for (name, cell) in cells {
            for (_, _, bits) in connections(cell).filter(|(_, is_output, _)| *is_output) {
                drivers.extend(
                    bits.iter()
                        .filter_map(|bit| Some((bit.as_u64()?, name.as_str()))),
                );
            }
        }
        let is_wrappers = |cell: &Value| {
            let source = cell["attributes"]["src"].as_str();
            cell["type"] == "TRELLIS_FF" && source.is_some_and(|src| src.starts_with(FILE))
        };
        let registers = cells.iter().filter(|(_, cell)| is_wrappers(cell));
        Ok(Self {
            module,
            readers: readers(module),
            drivers,
            registers: registers.map(|(name, _)| name.as_str()).collect(),
            clock: &module["ports"][CLOCK]["bits"][0],
        })
    }

    fn cell(&self, name: &str) -> &'a Value {
        &self.module["cells"][name]
    }

    /// The input of a register.
    fn input(&self, register: &str) -> &'a Value {
        &self.cell(register)["connections"]["DI"][0]
    }

    fn output(&self, register: &str) -> &'a Value {
        &self.cell(register)["connections"]["Q"][0]
    }

    /// The wrapper's register that drives a net; `None` for other nets.
    fn register(&self, net: &Value) -> Option<&'a str> {
        let driver = self.drivers.get(&net.as_u64()?).copied()?;
        self.registers.contains(driver).then_some(driver)
    }

    /// Checks that a register stores its input in every clock, without enable, and without reset unless
    /// `may_reset`.
    fn check_register(&self, name: &str, may_reset: bool) -> Result<()> {
        let cell = self.cell(name);
        let is = |parameter, expected| word(cell, parameter) == Some(expected);
        let is_plain = is("CEMUX", "1") && is("CLKMUX", "CLK") && is("LSRMUX", "LSR");
        let ends = &cell["connections"];
        let has_no_reset = ends["LSR"][0] == "0";
        let holds = is_plain && ends["CLK"][0] == *self.clock && (may_reset || has_no_reset);
        ensure(holds, || {
            let and_reset = if may_reset { "" } else { " and reset" };
            format!(
                "found {name} of the wrapper as {cell}, expected a flip-flop without enable{and_reset}"
            )
        })
    }

    /// The registers in front of the inputs, in order. The last may be missing if nothing reads them.
    fn driven(&self, width: usize) -> Result<Vec<&'a str>> {
        let mut net = &self.module["ports"][SERIAL_IN]["bits"][0];
        let mut chain = Vec::new();
        while chain.len() < width {
            let read = net.as_u64().and_then(|net| self.readers.get(&net));
            let read = read.into_iter().flatten().filter(|(_, port)| port == "DI");
            let next: Vec<_> = read
                .filter_map(|(name, _)| self.registers.get(name.as_str()).copied())
                .collect();
            match next[..] {
                [] => break,
                [register] => {
                    self.check_register(register, false)?;
                    chain.push(register);
                    net = self.output(register);
                }
                _ => {
                    return Err(unexpected(format!(
                        "found {} behind place {} of the wrapper's chain, expected one",
                        next.join(" and "),
                        chain.len()
                    )));
                }
            }
        }
        Ok(chain)
    }

    /// The machine's output bits, in order. Adds the cells behind them to `removed`.
    fn shown(&self, width: usize, removed: &mut HashSet<&'a str>) -> Result<Vec<String>> {
        let folded = self.module["netnames"][FOLDED]["bits"].as_array();
        let folded = folded.map_or(&[][..], Vec::as_slice);
        ensure(folded.len() == width, || {
            let found = folded.len();
            format!("found {found} bits of the wrapper's register {FOLDED}, expected {width}")
        })?;
        let zero = Value::from("0");
        let mut before = &zero;
        let mut shown = Vec::new();
        for net in folded {
            let register = self.register(net);
            let register = register.ok_or_else(|| missing("register folded of", net))?;
            self.check_register(register, false)?;
            removed.insert(register);
            shown.push(match self.added(self.input(register), before, removed)? {
                Added::Constant(bit) => format!("1'b{}", u8::from(bit)),
                Added::Net(net) => self.taken(net, removed)?,
            });
            before = net;
        }
        Ok(shown)
    }

    /// The other operand, where `net` is an exclusive or with `before`.
    fn added<'b>(
        &self,
        net: &'b Value,
        before: &Value,
        removed: &mut HashSet<&'a str>,
    ) -> Result<Added<'b>>
    where
        'a: 'b,
    {
        if net == before {
            return Ok(Added::Constant(false));
        }
        if net.is_string() || self.register(net).is_some() {
            // The first place has no predecessor.
            ensure(*before == "0", || {
                format!("found {net} folded into nothing, expected {before}")
            })?;
            return Ok(match net.as_str() {
                Some(bit) => Added::Constant(bit == "1"),
                None => Added::Net(net),
            });
        }
        let driver = net.as_u64().and_then(|net| self.drivers.get(&net).copied());
        let driver = driver.filter(|driver| self.cell(driver)["type"] == "LUT4");
        let driver = driver.ok_or_else(|| missing("LUT that drives", net))?;
        removed.insert(driver);
        exclusive_or(self.cell(driver), before).ok_or_else(|| {
            unexpected(format!(
                "found {driver}, expected an exclusive or with net {before}"
            ))
        })
    }

    /// The input of the register behind an output.
    fn taken(&self, net: &Value, removed: &mut HashSet<&'a str>) -> Result<String> {
        let register = self.register(net);
        let register = register.ok_or_else(|| missing("register of", net))?;
        self.check_register(register, true)?;
        removed.insert(register);
        let taken = end(self.input(register), name_of);
        let cell = self.cell(register);
        let reset = &cell["connections"]["LSR"][0];
        if *reset == "0" {
            return Ok(taken);
        }
        let value = u8::from(word(cell, "REGSET") == Some("SET"));
        Ok(format!("{} ? 1'b{value} : {taken}", end(reset, name_of)))
    }

    /// Checks that all of the wrapper is removed, and that no other cell reads it.
    fn check(&self, driven: &[&str], removed: &HashSet<&str>) -> Result<()> {
        let mut left: Vec<_> = self
            .registers
            .iter()
            .filter(|name| !removed.contains(*name))
            .collect();
        left.sort_unstable();
        ensure(left.is_empty(), || {
            format!("found {left:?} of the wrapper in no place of it")
        })?;
        // The machine reads the outputs of the registers in front of its inputs, and no other net of the
        // wrapper.
        for name in removed.iter().filter(|name| !driven.contains(name)) {
            let outputs = connections(self.cell(name)).filter(|(_, is_output, _)| *is_output);
            let nets = outputs
                .flat_map(|(_, _, bits)| bits)
                .filter_map(Value::as_u64);
            let read = nets.filter_map(|net| self.readers.get(&net)).flatten();
            let mut others =
                read.filter(|(reader, _)| !reader.is_empty() && !removed.contains(reader.as_str()));
            if let Some((reader, port)) = others.next() {
                return Err(unexpected(format!(
                    "found {port} of {reader} on {name}, which is the wrapper's"
                )));
            }
        }
        Ok(())
    }
}

fn missing(what: &str, net: &Value) -> FlowError {
    unexpected(format!("found no {what} net {net}"))
}

/// The second operand of the exclusive or in the second chain.
enum Added<'a> {
    Constant(bool),
    Net(&'a Value),
}

/// The other operand, where a LUT is an exclusive or with the net `before`.
fn exclusive_or<'a>(lut: &'a Value, before: &Value) -> Option<Added<'a>> {
    const PINS: [&str; 4] = ["A", "B", "C", "D"];
    let bits = lut["parameters"]["INIT"]
        .as_str()
        .filter(|bits| bits.len() == 16)?;
    let ends = PINS.map(|pin| &lut["connections"][pin][0]);
    let others = ends.iter().filter(|end| end.is_u64() && **end != before);
    let others: Vec<_> = others.copied().collect();
    if !ends.contains(&before) || others.windows(2).any(|pair| pair[0] != pair[1]) {
        return None;
    }
    let value = |old: bool, new: bool| {
        let pin = |place: usize| match ends[place] {
            end if end == before => old,
            end if end.is_u64() => new,
            end => *end == "1",
        };
        let address = (0..PINS.len()).fold(0, |sum, place| sum | usize::from(pin(place)) << place);
        bits.as_bytes()[15 - address] == b'1'
    };
    let table = [(false, false), (true, false), (false, true), (true, true)];
    match (table.map(|(old, new)| value(old, new)), others.first()) {
        ([false, true, true, false], Some(other)) => Some(Added::Net(other)),
        ([false, true, ..], None) => Some(Added::Constant(false)),
        ([true, false, ..], None) => Some(Added::Constant(true)),
        _ => None,
    }
}

fn name_of(net: u64) -> String {
    format!("n{net}")
}

/// The text of the module.
fn text(
    wrapped: &Wrapped<'_>,
    removed: &HashSet<&str>,
    name: &str,
    ports: &[Port],
    inputs: &[&Value],
    shown: &[String],
) -> Result<String> {
    let mut names: Vec<_> = vec![CLOCK.to_owned()];
    names.extend(ports.iter().map(|port| port.name.clone()));
    let mut text = format!("module {name}({});\n  input {CLOCK};\n", list(&names));
    let (mut driven, mut taken) = (inputs.iter(), shown.iter());
    let (mut known, mut assigns) = (HashMap::new(), String::new());
    if let Some(clock) = wrapped.clock.as_u64() {
        known.insert(clock, CLOCK.to_owned());
    }
    for port in ports {
        let (name, direction) = (&port.name, &port.direction);
        let _ = writeln!(text, "  {direction} [{}:0] {name};", port.width() - 1);
        for bit in 0..port.width() {
            if port.is_input() {
                let net = driven.next().and_then(|net| net.as_u64());
                known.extend(net.map(|net| (net, format!("{name}[{bit}]"))));
            } else {
                let value = taken
                    .next()
                    .ok_or_else(|| unexpected(format!("found no value of {name}[{bit}]")))?;
                let _ = writeln!(assigns, "  assign {name}[{bit}] = {value};");
            }
        }
    }
    let mut wires: Vec<u64> = Vec::new();
    let mut cells = String::new();
    for (name, cell) in wrapped.module["cells"].as_object().into_iter().flatten() {
        if is_bookkeeping(cell) || removed.contains(name.as_str()) {
            continue;
        }
        let nets = connections(cell)
            .flat_map(|(_, _, bits)| bits)
            .filter_map(Value::as_u64);
        wires.extend(nets);
        cells += &instance(name, cell, name_of)?;
    }
    // An output may be connected to an input, or to a net without a driver.
    wires.extend(known.keys());
    wires.sort_unstable();
    wires.dedup();
    for net in wires {
        let _ = match known.get(&net) {
            Some(value) => writeln!(text, "  wire n{net} = {value};"),
            None => writeln!(text, "  wire n{net};"),
        };
    }
    Ok(text + &assigns + &cells + "endmodule\n")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::netlist::Bit;

    /// The wrapper of a machine with two input bits, a and b, and two outputs, `a & b` and 0.
    fn wrapped() -> Value {
        let register = |d: u64, q: u64| {
            json!({
                "type": "TRELLIS_FF",
                "parameters": { "CEMUX": "1 ", "CLKMUX": "CLK", "LSRMUX": "LSR", "REGSET": "RESET" },
                "attributes": { "src": "serial.v:6.1-6.9|cells.v:1.1" },
                "port_directions": { "CLK": "input", "DI": "input", "LSR": "input", "Q": "output" },
                "connections": { "CLK": [2], "DI": [d], "LSR": ["0"], "Q": [q] },
            })
        };
        let lut = |init: &str, a: u64, b: u64, z: u64| {
            json!({
                "type": "LUT4",
                "parameters": { "INIT": init },
                "port_directions": { "A": "input", "B": "input", "C": "input", "D": "input", "Z": "output" },
                "connections": { "A": [a], "B": [b], "C": ["0"], "D": ["0"], "Z": [z] },
            })
        };
        // 2 clock, 3 serial_in, 4 and 5 driven, 6 shown, 7 taken, 8 and 9 folded.
        json!({ "modules": { "serial": {
            "attributes": { "top": "1" },
            "ports": {
                "clock": { "direction": "input", "bits": [2] },
                "serial_in": { "direction": "input", "bits": [3] },
                "serial_out": { "direction": "output", "bits": [9] },
            },
            "netnames": { "folded": { "bits": [8, 9] } },
            "cells": {
                "a": register(3, 4),
                "b": register(4, 5),
                "machine.and": lut("0000000000001000", 4, 5, 6),
                "taken": register(6, 7),
                "folded_0": register(8, 9),
                "folded_1": register(7, 8),
            },
        } } })
    }

    fn ports() -> Vec<Port> {
        let port = |name: &str, direction: &str| Port {
            name: name.to_owned(),
            direction: direction.to_owned(),
            bits: vec![Bit::Net(2)],
        };
        vec![
            port("a", "input"),
            port("b", "input"),
            port("both", "output"),
            port("none", "output"),
        ]
    }

    #[test]
    fn the_machine_is_all_that_is_left() {
        let text = unwrapped(&wrapped().into(), "the_top", &ports()).unwrap();
        for expected in [
            "module the_top(",
            "  wire n4 = a[0];",
            "  wire n5 = b[0];",
            "  assign both[0] = n6;",
            "  assign none[0] = 1'b0;",
            "\\machine.and (.A(n4), .B(n5)",
        ] {
            assert!(text.contains(expected), "{expected}: {text}");
        }
        assert_eq!(text.matches("TRELLIS_FF").count(), 0, "{text}");
    }

    #[test]
    fn what_is_not_as_the_wrappers_text_says_is_refused() {
        let edits: [(&str, Value, &str); 6] = [
            ("/b/parameters/CEMUX", json!("CE"), "without enable"),
            ("/b/connections/LSR/0", json!(6), "without enable and reset"),
            (
                "/taken/attributes/src",
                json!("top.v:1"),
                "no LUT that drives",
            ),
            ("/machine.and/connections/B/0", json!(7), "is the wrapper's"),
            (
                "/folded_0/connections/DI/0",
                json!(6),
                "expected an exclusive or",
            ),
            ("/taken/connections/DI/0", json!(3), "behind place 0"),
        ];
        for (place, value, expected) in edits {
            let mut netlist = wrapped();
            *netlist
                .pointer_mut(&format!("/modules/serial/cells{place}"))
                .unwrap() = value;
            let error = unwrapped(&netlist.into(), "the_top", &ports()).unwrap_err();
            let error = error.to_string();
            assert!(error.contains(expected), "{place}: {error}");
        }
    }

    #[test]
    fn a_lut_is_read_for_what_it_does() {
        let lut = |init: &str, ends: [Value; 4]| {
            let [a, b, c, d] = ends.map(|end| json!([end]));
            json!({ "parameters": { "INIT": init }, "connections": { "A": a, "B": b, "C": c, "D": d } })
        };
        let old = json!(8);
        let exclusive = lut(
            "0000000000000110",
            [json!(8), json!(7), json!("0"), json!("0")],
        );
        let found = exclusive_or(&exclusive, &old);
        assert!(matches!(found, Some(Added::Net(net)) if *net == 7));
        let either = lut(
            "0000000000001110",
            [json!(8), json!(7), json!("0"), json!("0")],
        );
        assert!(exclusive_or(&either, &old).is_none());
        let inverter = lut(
            "0000000000000001",
            [json!(8), json!("0"), json!("0"), json!("0")],
        );
        assert!(matches!(
            exclusive_or(&inverter, &old),
            Some(Added::Constant(true))
        ));
    }
}
