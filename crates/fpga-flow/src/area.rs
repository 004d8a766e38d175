//! Measures the area of a design in one flow.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;

use crate::design::Design;
use crate::error::{FlowError, Result, read, unexpected};
use crate::figure::{CellCounts, Figures};
use crate::flow::Flow;
use crate::yosys::Yosys;

/// The used parts of the output of Yosys's `stat -json`.
#[derive(Debug)]
pub(crate) struct Stat {
    /// The number of cells of each type in the whole design.
    pub cells: CellCounts,
    /// The sum of their transistors, as text; `None` without a technology.
    pub transistors: Option<String>,
    /// The area of the cells; `None` without a library.
    pub area: Option<f64>,
    /// The area of the registers among them.
    pub register_area: Option<f64>,
}

#[derive(Deserialize)]
struct Written {
    #[serde(default)]
    modules: BTreeMap<String, OfModule>,
    /// Missing where no module is the top.
    design: Option<OfDesign>,
}

#[derive(Deserialize)]
struct OfModule {
    area: Option<f64>,
}

#[derive(Deserialize)]
struct OfDesign {
    num_cells_by_type: CellCounts,
    estimated_num_transistors: Option<String>,
    area: Option<f64>,
    sequential_area: Option<f64>,
}

impl Written {
    fn parse(text: &str) -> Result<Self> {
        serde_json::from_str(text).map_err(|source| FlowError::Json {
            writer: "Yosys's `stat -json`",
            source,
        })
    }
}

impl Stat {
    pub fn parse(text: &str) -> Result<Self> {
        let design = Written::parse(text)?.design;
        let design = design
            .ok_or_else(|| unexpected("found no design in what Yosys's `stat -json` wrote"))?;
        Ok(Self {
            cells: design.num_cells_by_type,
            transistors: design.estimated_num_transistors,
            area: design.area,
            register_area: design.sequential_area,
        })
    }
}

/// The area of each module, by its name, from the output of Yosys's `stat -liberty -json`.
pub(crate) fn areas_of_modules(text: &str) -> Result<BTreeMap<String, f64>> {
    let modules = Written::parse(text)?.modules.into_iter();
    let area =
        |(name, of): (String, OfModule)| Some((name.trim_start_matches('\\').to_owned(), of.area?));
    Ok(modules.filter_map(area).collect())
}

/// Maps a design, whose files are in the folder (see [`Design::write`]), and counts its cells.
///
/// # Errors
/// Yosys fails, or a cell adds to none of the flow's figures.
pub fn area(
    yosys: &Yosys,
    folder: &Path,
    design: &Design,
    flow: &Flow,
    abc9_target_ps: u32,
) -> Result<Figures> {
    let file = format!("{flow}.json");
    let script = format!(
        "{}; {}; tee -q -o {file} stat {}",
        design.read_commands(flow.family),
        flow.script(&design.top, abc9_target_ps),
        flow.stat_options()
    );
    yosys.run(folder, &script)?;
    flow.count(&read(&folder.join(&file))?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Figure;

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
        let [gates, ecp5] = ["gates", "ecp5"].map(|name| Flow::find(name).unwrap());
        let figures = gates.count(STAT).unwrap();
        assert_eq!(figures[&Figure::Nand2Equivalents], 26);
        let error = ecp5.count(STAT).unwrap_err().to_string();
        assert!(error.contains("$_DFF_P_"), "{error}");
        assert!(ecp5.count("{}").is_err());
    }
}
