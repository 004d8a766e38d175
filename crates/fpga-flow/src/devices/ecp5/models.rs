//! The simulation models of an ECP5's cells: Yosys's own, and this crate's models of the block RAM and the DSP
//! block.

use std::path::Path;

use crate::error::{Result, read};
use crate::models::Models;
use crate::yosys::Yosys;

/// This crate's models of the block RAM and the DSP block.
const BLOCKS: &str = include_str!("../../../models/ecp5_blocks.v");

/// The module in it that holds a block RAM's words.
const WORDS: &str = "ecp5_block_words";

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

/// The models of all cells that a design is mapped to, from the Yosys that maps it.
///
/// # Errors
/// Yosys fails, or lacks a model.
pub fn models(yosys: &Yosys, folder: &Path) -> Result<Models> {
    let log = "models.log";
    // The included files are left out: pads, and other names of the flip-flops.
    let commands =
        format!("tee -q -o {log} read_verilog -ppdump -D NO_INCLUDES +/ecp5/cells_sim.v");
    yosys.run(folder, &commands)?;
    let dump = read(&folder.join(log))?;
    Models::of(&dump, &YOSYS, BLOCKS, WORDS)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::netlist::Netlist;

    #[test]
    fn a_cell_or_a_parameter_that_no_model_has_is_refused() {
        let models = Models::of("", &[], BLOCKS, WORDS).unwrap();
        let check = |kind: &str, parameter: &str| {
            models.check(&Netlist::from(json!({ "modules": { "top": {
                "attributes": { "top": "1" },
                "cells": { "block": { "type": kind, "parameters": { parameter: "1" } } },
            } } })))
        };
        for known in ["GSR", "INITVAL_3F", "DATA_WIDTH_A"] {
            check("DP16KD", known).unwrap();
        }
        check("MULT18X18D", "GSR").unwrap();
        let error = check("DP16KD", "CLKA").unwrap_err().to_string();
        assert!(error.contains("CLKA = \"1\" of block"), "{error}");
        for unknown in ["ALU54B", "DP16", ""] {
            let error = check(unknown, "GSR").unwrap_err().to_string();
            assert!(error.contains("no model of"), "{error}");
        }
    }
}
