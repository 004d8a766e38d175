//! Simulation models of a family's cells.

use std::collections::BTreeMap;

use verilog_eval::modules;

use crate::error::{Result, ensure, unexpected};
use crate::netlist::{Netlist, is_bookkeeping};

/// The models of the cells that designs are mapped to, as Verilog.
#[derive(Clone, Debug)]
pub struct Models {
    text: String,
    /// The module that holds a block RAM's words.
    pub(crate) words: &'static str,
}

impl Models {
    /// The modules `names` of a text, and all of `others`.
    ///
    /// # Errors
    /// A module is missing.
    pub(crate) fn of(
        text: &str,
        names: &[&str],
        others: &str,
        words: &'static str,
    ) -> Result<Self> {
        let models = names.iter().map(|name| module(text, name));
        let text = models.collect::<Result<String>>()? + others;
        Ok(Self { text, words })
    }

    /// The Verilog of all models.
    pub fn verilog(&self) -> &str {
        &self.text
    }

    /// Fails where a cell of the netlist has no model, or has a parameter that its model lacks, because a
    /// simulator may only warn.
    ///
    /// # Errors
    /// A parameter or a model is missing, or the netlist has no top module.
    pub fn check(&self, netlist: &Netlist) -> Result<()> {
        let mut known: BTreeMap<&str, String> = BTreeMap::new();
        for (name, cell) in netlist.cells()? {
            if is_bookkeeping(cell) {
                continue;
            }
            let kind = cell["type"].as_str().unwrap_or_default();
            if !known.contains_key(kind) {
                known.insert(kind, module(&self.text, kind)?);
            }
            for (parameter, value) in cell["parameters"].as_object().into_iter().flatten() {
                ensure(declares(&known[kind], parameter), || {
                    format!(
                        "found {parameter} = {value} of {name}, a parameter that the model of {kind} does not have"
                    )
                })?;
            }
        }
        Ok(())
    }
}

/// Whether a module declares the parameter, on a line of its own.
fn declares(module: &str, parameter: &str) -> bool {
    module.lines().any(|line| {
        let line = line.trim_start();
        let before = line.split('=').next();
        let declared = before.and_then(|line| line.split_whitespace().last());
        line.starts_with("parameter ") && declared == Some(parameter)
    })
}

/// The text of a module.
fn module(text: &str, name: &str) -> Result<String> {
    let mut modules = modules(text).into_iter();
    let found = modules.find(|module| module.name == name);
    let found = found.map(|module| module.text.to_owned() + "\n");
    found.ok_or_else(|| unexpected(format!("found no model of {name}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_module_is_taken_whole_and_a_missing_one_is_named() {
        let text = "x\nmodule LUT4(a);\n  b\nendmodule\n\nmodule CCU2C (\n c);\nendmodule\n";
        assert_eq!(
            module(text, "LUT4").unwrap(),
            "module LUT4(a);\n  b\nendmodule\n"
        );
        assert!(
            module(text, "CCU2C")
                .unwrap()
                .starts_with("module CCU2C (\n")
        );
        let error = module(text, "LUT").unwrap_err().to_string();
        assert_eq!(error, "found no model of LUT");
    }
}
