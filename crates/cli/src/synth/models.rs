//! The simulation models of an ECP5's cells: Yosys's own, and the project's models of the block RAM and the
//! DSP block.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use serde_json::{Map, Value};

use super::tools::Tools;

/// The project's models of the block RAM and the DSP block.
const BLOCKS: &str = include_str!("../../../../scripts/yosys/ecp5_blocks.v");

/// The module in it that holds a block RAM's words.
pub const WORDS: &str = "ecp5_block_words";

/// The models that are taken from Yosys: cells of a mapped netlist, and `LUT2`, which is a part of `CCU2C`.
const YOSYS: [&str; 7] = [
    "LUT2",
    "LUT4",
    "PFUMX",
    "L6MUX21",
    "CCU2C",
    "TRELLIS_FF",
    "TRELLIS_DPR16X4",
];

/// The models of all cells that a machine is mapped to, from the Yosys that maps it.
///
/// # Errors
/// Yosys fails, or lacks a model.
pub fn models(tools: &Tools, folder: &Path) -> Result<String> {
    let log = "models.log";
    // The included files are left out: pads, and other names of the flip-flops.
    let read = format!("tee -q -o {log} read_verilog -ppdump -D NO_INCLUDES +/ecp5/cells_sim.v");
    tools.yosys(folder, &read)?;
    let dump = fs::read_to_string(folder.join(log))?;
    let models = YOSYS.iter().map(|name| module(&dump, name));
    Ok(models.collect::<Result<String>>()? + BLOCKS)
}

/// Whether [`models`] contains the cell.
pub fn is_modelled(kind: &str) -> bool {
    YOSYS.contains(&kind) || module(BLOCKS, kind).is_ok()
}

/// Fails where a cell has a parameter that its model lacks, because a simulator may only warn.
///
/// # Errors
/// A parameter or a model is missing.
pub fn check_parameters(models: &str, cells: &Map<String, Value>) -> Result<()> {
    let mut known: BTreeMap<&str, String> = BTreeMap::new();
    for (name, cell) in cells {
        let kind = cell["type"].as_str().unwrap_or_default();
        if kind == "$scopeinfo" {
            continue;
        }
        if !known.contains_key(kind) {
            known.insert(kind, module(models, kind)?);
        }
        for parameter in cell["parameters"].as_object().into_iter().flatten() {
            let (parameter, value) = parameter;
            let is_declared = |line: &str| {
                let line = line.trim_start();
                let declared = line
                    .split('=')
                    .next()
                    .and_then(|line| line.split_whitespace().last());
                line.starts_with("parameter ") && declared == Some(parameter)
            };
            ensure!(
                known[kind].lines().any(is_declared),
                "found {parameter} = {value} of {name}, a parameter that the model of {kind} does not have"
            );
        }
    }
    Ok(())
}

/// The text of a module.
fn module(text: &str, name: &str) -> Result<String> {
    const END: &str = "\nendmodule\n";
    let begins = [format!("\nmodule {name}("), format!("\nmodule {name} (")];
    let found = begins.iter().find_map(|begin| {
        let text = &text[text.find(begin)?..];
        Some(&text[..text.find(END)? + END.len()])
    });
    let found = found.with_context(|| format!("found no model of {name}"))?;
    Ok(found.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parameter_that_no_model_has_is_refused() {
        let cells = |parameter: &str| {
            let cell = serde_json::json!({ "type": "DP16KD", "parameters": { parameter: "1" } });
            Map::from_iter([("block".to_owned(), cell)])
        };
        for known in ["GSR", "INITVAL_3F", "DATA_WIDTH_A"] {
            check_parameters(BLOCKS, &cells(known)).unwrap();
        }
        let error = check_parameters(BLOCKS, &cells("CLKA"))
            .unwrap_err()
            .to_string();
        assert!(error.contains("CLKA = \"1\" of block"), "{error}");
    }

    #[test]
    fn cells_of_both_sources_are_known_and_others_are_not() {
        for kind in ["LUT4", "TRELLIS_DPR16X4", "DP16KD", "MULT18X18D"] {
            assert!(is_modelled(kind), "{kind}");
        }
        for kind in ["ALU54B", "LUT", ""] {
            assert!(!is_modelled(kind), "{kind}");
        }
    }

    #[test]
    fn a_module_is_taken_whole_and_a_missing_one_is_named() {
        let text = "x\nmodule LUT4(a);\n  b\nendmodule\n\nmodule CCU2C (\n c);\nendmodule\n";
        assert_eq!(
            module(text, "LUT4").unwrap(),
            "\nmodule LUT4(a);\n  b\nendmodule\n"
        );
        assert!(
            module(text, "CCU2C")
                .unwrap()
                .starts_with("\nmodule CCU2C (\n")
        );
        let error = module(text, "LUT").unwrap_err().to_string();
        assert_eq!(error, "found no model of LUT");
    }
}
