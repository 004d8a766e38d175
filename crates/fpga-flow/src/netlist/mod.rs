//! Netlists as Yosys's `write_json` writes them: their modules, ports, nets and cells, and passes over them.
//!
//! A pass changes some cells of a mapped netlist and must preserve its function. [`changes()`] lists the cells
//! that a pass changed, and [`prove`](crate::prove()) shows, with the models of the cells, that the changed logic
//! is equivalent.

mod changes;
pub(crate) mod digest;
mod module;
pub(crate) mod verilog;

use std::collections::HashMap;
use std::fmt;

use serde_json::{Map, Value};

use crate::error::{FlowError, Result, unexpected};
use crate::figure::SCOPE;

pub use changes::{Change, changes};
pub use module::{Bit, Module, Port};

/// The cells of a module, by name.
pub(crate) type Cells = Map<String, Value>;
/// The readers of each net: a cell and its port, or a port of the module without a cell.
pub(crate) type Readers = HashMap<u64, Vec<(String, String)>>;

/// A netlist, as Yosys's `write_json` writes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Netlist {
    json: Value,
}

impl Netlist {
    /// Reads the text that `write_json` wrote.
    ///
    /// # Errors
    /// The text is no JSON, or has no modules.
    pub fn parse(text: &str) -> Result<Self> {
        let json: Value = serde_json::from_str(text).map_err(|source| FlowError::Json {
            writer: "Yosys's `write_json`",
            source,
        })?;
        match json["modules"].is_object() {
            true => Ok(Self { json }),
            false => Err(unexpected("found no modules in the netlist")),
        }
    }

    /// The JSON of the netlist.
    pub fn json(&self) -> &Value {
        &self.json
    }

    /// The JSON of the netlist, to be changed.
    pub fn json_mut(&mut self) -> &mut Value {
        &mut self.json
    }

    /// The modules, by name, models of cells included.
    pub fn modules(&self) -> impl Iterator<Item = (&str, Module<'_>)> {
        let modules = self.json["modules"].as_object().into_iter().flatten();
        modules.map(|(name, module)| (name.as_str(), Module::of(module)))
    }

    /// The module of that name.
    ///
    /// # Errors
    /// There is none.
    pub fn module(&self, name: &str) -> Result<Module<'_>> {
        let mut modules = self.modules();
        let found = modules.find(|(known, _)| *known == name);
        let found = found.map(|(_, module)| module);
        found.ok_or_else(|| unexpected(format!("found no module {name} in the netlist")))
    }

    /// SHA-256 of the netlist in hexadecimal digits. It covers the types, parameters, attributes and
    /// connections of the cells of the top module. It does not depend on the names of cells and nets, their
    /// order or origin, or on Yosys's records of the hierarchy.
    ///
    /// # Errors
    /// The netlist has no top module.
    pub fn sha256(&self) -> Result<String> {
        digest::sha256(self.top()?)
    }

    /// The module that is placed; all other modules are models of cells.
    ///
    /// # Errors
    /// There is no such module.
    pub(crate) fn top(&self) -> Result<&Value> {
        let modules = self.json["modules"].as_object().into_iter().flatten();
        let mut tops = modules.filter(|(_, module)| module["attributes"]["top"].is_string());
        let top = tops.next().map(|(_, module)| module);
        top.ok_or_else(|| unexpected("found no top module in the netlist"))
    }

    /// The cells of the top module, as `write_json` writes them.
    ///
    /// # Errors
    /// The netlist has no top module, or it has no cells.
    pub fn cells(&self) -> Result<&Map<String, Value>> {
        cells(self.top()?)
    }
}

impl From<Value> for Netlist {
    fn from(json: Value) -> Self {
        Self { json }
    }
}

impl fmt::Display for Netlist {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.json.fmt(f)
    }
}

/// A pass over the cells of a module.
#[derive(Debug)]
pub(crate) struct Pass {
    /// The name of the pass.
    pub name: &'static str,
    pub run: fn(&mut Cells, &Readers),
}

/// A netlist with the name of the last step.
#[derive(Clone, Debug)]
pub struct Stage {
    /// The name of the step: `mapped`, which is Yosys's mapping, or the pass.
    pub name: &'static str,
    /// The netlist after that step.
    pub netlist: Netlist,
}

/// The netlist that Yosys mapped, then the result of each pass. The last one is placed.
pub(crate) fn stages(mapped: Netlist, passes: &[Pass]) -> Vec<Stage> {
    let mut stages = vec![Stage {
        name: "mapped",
        netlist: mapped,
    }];
    for pass in passes {
        let mut netlist = stages[stages.len() - 1].netlist.clone();
        let modules = netlist.json["modules"].as_object_mut();
        for (_, module) in modules.into_iter().flatten() {
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
    stages
}

pub(crate) fn cells(module: &Value) -> Result<&Cells> {
    let cells = module["cells"].as_object();
    cells.ok_or_else(|| unexpected("found a module without cells in the netlist"))
}

/// Whether a cell is Yosys's record of a module that was flattened.
pub(crate) fn is_bookkeeping(cell: &Value) -> bool {
    cell["type"] == SCOPE
}

pub(crate) fn readers(module: &Value) -> Readers {
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
pub(crate) fn connections(cell: &Value) -> impl Iterator<Item = (&str, bool, &[Value])> {
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
pub(crate) fn word<'a>(cell: &'a Value, parameter: &str) -> Option<&'a str> {
    cell["parameters"][parameter].as_str().map(str::trim_end)
}

/// The numbers of the nets among these bits; other bits are constants.
fn numbers(bits: &Value) -> impl Iterator<Item = u64> {
    let bits = bits.as_array().into_iter().flatten();
    bits.filter_map(Value::as_u64)
}
