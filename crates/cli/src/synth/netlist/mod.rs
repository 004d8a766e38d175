//! What Yosys leaves undone in a mapped netlist, and nextpnr does not do.

mod digest;
mod open_ends;
mod output_registers;

use std::collections::HashMap;

use anyhow::{Context, Result};
use serde_json::{Map, Value};

pub use digest::sha256;

/// The cells of a module, by name.
type Cells = Map<String, Value>;
/// What reads a net: a cell and its port, or no cell and a port of the module.
type Readers = HashMap<u64, Vec<(String, String)>>;

/// The netlist that Yosys's `write_json` wrote, with open ends of carry chains and block RAMs that have
/// their output registers. Its logic and its clocks are the same.
pub fn finish(netlist: &str) -> Result<String> {
    let mut netlist: Value = serde_json::from_str(netlist).context("what `write_json` writes")?;
    let modules = netlist["modules"].as_object_mut();
    for module in modules.context("a netlist has modules")?.values_mut() {
        let readers = readers(module);
        if let Some(cells) = module["cells"].as_object_mut() {
            open_ends::open(cells, &readers);
            output_registers::fill(cells, &readers);
        }
    }
    Ok(netlist.to_string())
}

/// The module that is placed: all others are models of cells.
fn top(netlist: &Value) -> Result<&Value> {
    let modules = netlist["modules"].as_object().into_iter().flatten();
    let mut tops = modules.filter(|(_, module)| module["attributes"]["top"].is_string());
    let (_, module) = tops.next().context("found no top module in the netlist")?;
    Ok(module)
}

/// Whether a cell is Yosys's note of a module that it has taken apart.
fn is_bookkeeping(cell: &Value) -> bool {
    cell["type"] == "$scopeinfo"
}

fn readers(module: &Value) -> Readers {
    let mut readers = Readers::new();
    let mut add = |bits: &Value, cell: &str, port: &str| {
        for bit in numbers(bits) {
            let reader = (cell.to_owned(), port.to_owned());
            readers.entry(bit).or_default().push(reader);
        }
    };
    for (name, cell) in module["cells"].as_object().into_iter().flatten() {
        for (port, bits) in cell["connections"].as_object().into_iter().flatten() {
            if cell["port_directions"][port] != "output" {
                add(bits, name, port);
            }
        }
    }
    for (name, port) in module["ports"].as_object().into_iter().flatten() {
        add(&port["bits"], "", name);
    }
    readers
}

/// The numbers of the nets among these bits; the others are constants.
fn numbers(bits: &Value) -> impl Iterator<Item = u64> {
    let bits = bits.as_array().into_iter().flatten();
    bits.filter_map(Value::as_u64)
}
