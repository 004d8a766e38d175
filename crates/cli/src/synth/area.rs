//! Measures the area of a machine in one flow.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use serde::Deserialize;

use super::cells::{self, Figures};
use super::figures::AreaRow;
use super::flow::Flow;
use super::tools::Tools;
use super::{Subject, transistors};

/// The output of Yosys's `stat -json`.
#[derive(Deserialize)]
struct Stat {
    design: Design,
}

#[derive(Deserialize)]
struct Design {
    num_cells_by_type: BTreeMap<String, u64>,
    estimated_num_transistors: Option<String>,
}

/// Maps a machine, whose Verilog `{top}.v` is in the folder, and counts its cells.
pub fn measure(tools: &Tools, folder: &Path, subject: &Subject, flow: Flow) -> Result<AreaRow> {
    let (top, name) = (&subject.top, flow.name());
    let stat = format!("{name}.json");
    let technology = match flow {
        Flow::Gates => " -tech cmos",
        _ => "",
    };
    let script = format!(
        "{}; {}; tee -q -o {stat} stat -json{technology}",
        subject.read(flow),
        flow.script(top)
    );
    let figures = tools.yosys(folder, &script).and_then(|_| {
        let text = fs::read_to_string(folder.join(&stat))?;
        count(&text, flow)
    });
    Ok(AreaRow {
        machine: subject.machine.name.to_owned(),
        flow,
        figures: figures
            .with_context(|| format!("machine {} in flow {name}", subject.machine.name))?,
    })
}

/// The figures of one run.
fn count(stat: &str, flow: Flow) -> Result<Figures> {
    let stat: Stat = serde_json::from_str(stat).context("what Yosys's `stat -json` writes")?;
    let cells = stat.design.num_cells_by_type;
    if flow == Flow::Gates {
        let transistors = stat.design.estimated_num_transistors;
        return transistors::count(&cells, &transistors.unwrap_or_default());
    }
    cells::count(&cells, flow.figures())
}

#[cfg(test)]
mod tests {
    use super::super::cells::Figure;
    use super::*;

    /// The end of the output of Yosys 0.70; earlier versions had numbers in quotation marks.
    const STAT: &str = r#"{
        "creator": "Yosys 0.70 (git sha1 28ba3cb92, Release)",
        "modules": {"\\top": {"num_cells": 14, "num_cells_by_type": {"$_NAND_": 10, "$_DFF_P_": 4}}},
        "design": {
            "num_wires": 22,
            "num_cells_by_type": {"$_NAND_": 10, "$_DFF_P_": 4},
            "estimated_num_transistors": "104"
        }
    }"#;

    #[test]
    fn the_designs_cells_are_counted() {
        let figures = count(STAT, Flow::Gates).unwrap();
        assert_eq!(figures[&Figure::Nand2Equivalents], 26);
        let error = count(STAT, Flow::Ecp5).unwrap_err().to_string();
        assert!(error.contains("$_NAND_"), "{error}");
        assert!(count("{}", Flow::Ecp5).is_err());
    }
}
