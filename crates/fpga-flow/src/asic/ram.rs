//! The memories of a design that stay outside of its standard cells, as RAMs.

use serde_json::Value;

use super::CLOCK;
use crate::error::{Result, unexpected};
use crate::netlist::{Netlist, cells};

/// The fewest bits of a memory that is a RAM. A smaller one becomes registers: a RAM has decoders and amplifiers, whose area
/// does not shrink with the bits.
const FEWEST_BITS: u64 = 4096;

/// The memories of a design that are RAMs.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Rams(Vec<Ram>);

/// A RAM.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Ram {
    /// The name of its cell.
    name: String,
    bits: u64,
    /// The pairs of a port that reads and a port that writes.
    port_pairs: usize,
}

impl Rams {
    /// The RAMs of the module `top`, whose memories are not mapped yet. A memory that is never written is logic.
    pub(super) fn of(netlist: &Netlist, top: &str) -> Result<Self> {
        let mut rams = Vec::new();
        for (name, cell) in cells(&netlist.json()["modules"][top])? {
            if cell["type"] != "$mem_v2" {
                continue;
            }
            let number = |parameter| number_of(name, cell, parameter);
            let bits = number("WIDTH")? * number("SIZE")?;
            let write_ports = number("WR_PORTS")?;
            if write_ports > 0 && bits >= FEWEST_BITS {
                rams.push(Ram {
                    name: name.clone(),
                    bits,
                    port_pairs: (number("RD_PORTS")? * write_ports) as usize,
                });
            }
        }
        Ok(Self(rams))
    }

    /// The bits of all RAMs.
    pub(super) fn bits(&self) -> u64 {
        self.0.iter().map(|ram| ram.bits).sum()
    }

    /// The name of the module that has the RAMs of `top`. Its instance has the same name.
    fn module(top: &str) -> String {
        format!("{top}_rams")
    }

    /// The commands that move the RAMs into a module of their own, of which `top` keeps an instance, and write it to the file.
    /// Nothing where there is no RAM.
    ///
    /// In the file no bit is unknown, since the activity of an unknown net cannot be counted: the words are 0 at power-up, and what is read
    /// while it is written is the old word.
    pub(super) fn cut_out(&self, top: &str, file: &str) -> String {
        if self.0.is_empty() {
            return String::new();
        }
        let module = Self::module(top);
        let cells = self.0.iter().map(|ram| format!(" {top}/c:{}", ram.name));
        let known = self.0.iter().map(
            |Ram {
                 name, port_pairs, ..
             }| {
                let zeros = "0".repeat(*port_pairs);
                format!(
                    "setparam -set RD_COLLISION_X_MASK {port_pairs}'{zeros} {module}/c:{name}; "
                )
            },
        );
        format!(
            "select{}; submod -name {module}; select {module}; setundef -zero -params; {}\
             write_verilog -selected -noattr {file}; select -clear; blackbox {module}; ",
            cells.collect::<String>(),
            known.collect::<String>()
        )
    }

    /// The commands after which the ports of the RAMs are ports of `top`, but their clock, and the RAMs are gone.
    pub(super) fn expose(&self, top: &str) -> String {
        let module = Self::module(top);
        match self.0.is_empty() {
            true => String::new(),
            false => {
                format!("expose -evert {top}/c:{module}; delete -output {top}/w:{module}.{CLOCK}; ")
            }
        }
    }
}

/// A parameter of a cell in Yosys's JSON, where numbers are binary.
fn number_of(name: &str, cell: &Value, parameter: &str) -> Result<u64> {
    let value = &cell["parameters"][parameter];
    let number = value.as_str().map(|bits| u64::from_str_radix(bits, 2));
    match number {
        Some(Ok(number)) => Ok(number),
        _ => Err(unexpected(format!(
            "found {parameter} {value} of the memory {name}, expected a binary number"
        ))),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    /// A module with a memory of eight words, which has a port that reads and this many that write.
    fn with_memory(width: &str, write_ports: &str) -> Result<Rams> {
        let memory = json!({"type": "$mem_v2", "parameters":
            {"WIDTH": width, "SIZE": "1000", "RD_PORTS": "1", "WR_PORTS": write_ports}});
        let netlist =
            json!({"modules": {"top": {"cells": {"words": memory, "sum": {"type": "$add"}}}}});
        Rams::of(&Netlist::from(netlist), "top")
    }

    #[test]
    fn a_memory_of_4096_bits_that_is_written_is_a_ram() {
        assert_eq!(with_memory("1000000000", "10").unwrap().bits(), 4096);
        let none = Rams::default();
        assert_eq!(with_memory("0111111111", "10").unwrap(), none);
        assert_eq!(with_memory("1000000000", "0").unwrap(), none);
        assert_eq!(
            (none.cut_out("top", "rams.v"), none.expose("top")),
            Default::default()
        );
    }

    #[test]
    fn a_parameter_that_is_no_number_is_an_error() {
        let error = with_memory("wide", "1").unwrap_err().to_string();
        assert!(
            error.contains("WIDTH \"wide\" of the memory words"),
            "{error}"
        );
    }
}
