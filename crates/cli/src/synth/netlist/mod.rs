//! What Yosys leaves undone in a mapped netlist, and nextpnr does not do.
//!
//! Each pass changes some cells of a mapped netlist and must not change what it computes. `photoncube verify --placed`
//! checks that twice: [`changes()`] lists the cells that a pass changed, and Yosys proves that the changed logic is
//! equivalent by the models of the cells; and the netlist is simulated after each pass.

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
/// What reads a net: a cell and its port, or no cell and a port of the module.
type Readers = HashMap<u64, Vec<(String, String)>>;

/// A way to change the cells of a module.
struct Pass {
    /// What it does.
    name: &'static str,
    run: fn(&mut Cells, &Readers),
}

/// The passes, in their order.
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

/// A netlist, as `write_json` writes it, and what was done last to it.
#[derive(Clone, Debug)]
pub struct Stage {
    /// Yosys's mapping, or the pass.
    pub name: &'static str,
    /// The netlist after it.
    pub netlist: Value,
}

/// The netlist that Yosys's `write_json` wrote, then what each pass makes of it. The last is what is placed.
///
/// # Errors
/// It is not what `write_json` writes.
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

/// The module that is placed: all others are models of cells.
///
/// # Errors
/// There is none.
pub fn top(netlist: &Value) -> Result<&Value> {
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

/// The connections of a cell: each of its ports, and whether it is an output, with its bits.
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

/// A parameter that is a word, without the blank that Yosys puts behind a word of digits.
fn word<'a>(cell: &'a Value, parameter: &str) -> Option<&'a str> {
    cell["parameters"][parameter].as_str().map(str::trim_end)
}

/// The numbers of the nets among these bits; the others are constants.
fn numbers(bits: &Value) -> impl Iterator<Item = u64> {
    let bits = bits.as_array().into_iter().flatten();
    bits.filter_map(Value::as_u64)
}
