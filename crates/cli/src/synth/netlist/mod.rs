//! Passes over a mapped netlist that Yosys and nextpnr lack.
//!
//! Each pass changes some cells of a mapped netlist and must preserve its function.
//! `photoncube verify --placed` checks that twice: [`changes()`] lists the cells that a pass changed, and
//! Yosys proves, with the models of the cells, that the changed logic is equivalent; and the netlist is
//! simulated after each pass.

mod changes;
mod digest;
mod open_ends;
mod output_registers;
mod unwrapped;
mod verilog;

use std::collections::HashMap;

use anyhow::{Context, Result};
use serde_json::{Map, Value};

pub use changes::{Change, changes};
pub use digest::sha256;
pub use unwrapped::unwrapped;

/// The cells of a module, by name.
type Cells = Map<String, Value>;
/// The readers of each net: a cell and its port, or a port of the module without a cell.
type Readers = HashMap<u64, Vec<(String, String)>>;

/// A pass over the cells of a module.
struct Pass {
    /// The name of the pass.
    name: &'static str,
    run: fn(&mut Cells, &Readers),
}

/// The passes, in the order in which they run.
const PASSES: [Pass; 2] = [
    Pass {
        name: "open carry ends",
        run: open_ends::open,
    },
    Pass {
        name: "block RAM registers",
        run: output_registers::fill,
    },
];

/// A netlist, as `write_json` writes it, with the name of the last step.
#[derive(Clone, Debug)]
pub struct Stage {
    /// The name of the step: Yosys's mapping, or the pass.
    pub name: &'static str,
    /// The netlist after that step.
    pub netlist: Value,
}

/// The netlist that Yosys's `write_json` wrote, then the result of each pass. The last one is placed.
///
/// # Errors
/// The text is not an output of `write_json`.
pub fn stages(mapped: &str) -> Result<Vec<Stage>> {
    let netlist: Value = serde_json::from_str(mapped).context("what `write_json` writes")?;
    netlist["modules"]
        .as_object()
        .context("a netlist has modules")?;
    let mut stages = vec![Stage {
        name: "mapped",
        netlist,
    }];
    for pass in &PASSES {
        let mut netlist = stages[stages.len() - 1].netlist.clone();
        let modules = netlist["modules"].as_object_mut().into_iter().flatten();
        for (_, module) in modules {
            let readers = readers(module);
            if let Some(cells) = module["cells"].as_object_mut() {
                (pass.run)(cells, &readers);
            }
        }
        stages.push(Stage {
            name: pass.name,
            netlist,
        });
    }
    Ok(stages)
}

/// The module that is placed; all other modules are models of cells.
///
/// # Errors
/// There is no such module.
pub fn top(netlist: &Value) -> Result<&Value> {
    let modules = netlist["modules"].as_object().into_iter().flatten();
    let mut tops = modules.filter(|(_, module)| module["attributes"]["top"].is_string());
    let (_, module) = tops.next().context("found no top module in the netlist")?;
    Ok(module)
}

/// Whether a cell is Yosys's record of a module that was flattened.
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

/// The connections of a cell: for each port its name, whether it is an output, and its bits.
fn connections(cell: &Value) -> impl Iterator<Item = (&str, bool, &[Value])> {
    let connections = cell["connections"].as_object().into_iter().flatten();
    connections.map(|(port, bits)| {
        let is_output = cell["port_directions"][port] == "output";
        (
            port.as_str(),
            is_output,
            bits.as_array().map_or(&[][..], Vec::as_slice),
        )
    })
}

/// A text parameter, without the blank that Yosys appends to texts of digits.
fn word<'a>(cell: &'a Value, parameter: &str) -> Option<&'a str> {
    cell["parameters"][parameter].as_str().map(str::trim_end)
}

/// The numbers of the nets among these bits; other bits are constants.
fn numbers(bits: &Value) -> impl Iterator<Item = u64> {
    let bits = bits.as_array().into_iter().flatten();
    bits.filter_map(Value::as_u64)
}
