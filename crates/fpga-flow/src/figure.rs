//! The figures of an area, and how cells are counted in them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::error::{Result, unexpected};

/// A figure of the area, in the order of the tables.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Figure {
    /// LUTs with up to four inputs.
    Lut4,
    /// Carry cells of the ECP5.
    Ccu2c,
    /// Carry cells that are each one bit wide: SB_CARRY on iCE40, ALU on Gowin.
    Carry,
    /// LUTs and cells in their place on ECP5, counted as LUTs.
    Lut4Equivalents,
    /// Gates and flip-flops, counted as cells.
    Gates,
    /// Transistors of gates and flip-flops, in units of a NAND with two inputs.
    Nand2Equivalents,
    /// LUTs of Cyclone V, with two to six inputs or arithmetic.
    Alut,
    /// Adaptive logic modules of Cyclone V, if all LUTs that can share one do so.
    AlmAtLeast,
    /// LUTs of MAX 10, with or without carry.
    LogicCells,
    /// Flip-flops of any kind.
    Ff,
    /// Multipliers in DSP blocks.
    Dsp,
    /// Block RAMs of the device.
    BlockRam,
    /// RAMs made of LUTs.
    LutRam,
}

impl Figure {
    /// The figure's key in JSON.
    pub fn key(self) -> String {
        let json = serde_json::to_value(self);
        let json = json.expect("an enumerator is a string in JSON");
        json.as_str().unwrap_or_default().to_owned()
    }

    /// The heading of the figure in a table.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Lut4 => "LUT4",
            Self::Ccu2c => "CCU2C",
            Self::Carry => "carry",
            Self::Lut4Equivalents => "LUT4 equivalents",
            Self::Gates => "gates",
            Self::Nand2Equivalents => "NAND2 equivalents",
            Self::Alut => "ALUT",
            Self::AlmAtLeast => "ALM, at least",
            Self::LogicCells => "logic cells",
            Self::Ff => "FF",
            Self::Dsp => "DSP",
            Self::BlockRam => "block RAM",
            Self::LutRam => "LUT RAM",
        }
    }
}

/// Figures of one design.
pub type Figures = BTreeMap<Figure, u64>;

/// The number of cells of each type.
pub type CellCounts = BTreeMap<String, u64>;

/// A type of cell that a flow may leave, with the figure that it adds to. A `*` at the end of the type stands
/// for any characters. `None` is for a cell that takes no room.
pub(crate) type CellRow = (&'static str, Option<Figure>);

/// A figure that is computed from the number of cells and from the counted figures.
pub(crate) type Term = (Figure, fn(&CellCounts, &Figures) -> u64);

/// The figures of `wanted`, including zeros. A cell that adds to none of them is an error.
pub(crate) fn count(
    cells: &CellCounts,
    known: &[CellRow],
    terms: &[Term],
    wanted: &[Figure],
) -> Result<Figures> {
    let mut counted: Figures = wanted.iter().map(|&figure| (figure, 0)).collect();
    for (cell, &number) in cells {
        let row = known.iter().find(|(name, _)| is_named(cell, name));
        let figure = match row {
            Some((_, figure)) => *figure,
            None if cell == SCOPE => None,
            None => {
                return Err(unexpected(format!(
                    "found {number} cells {cell}, expected only kinds that are counted"
                )));
            }
        };
        let Some(figure) = figure else {
            continue;
        };
        let Some(sum) = counted.get_mut(&figure) else {
            return Err(unexpected(format!(
                "found {number} cells {cell}, expected none of {} here",
                figure.key()
            )));
        };
        *sum += number;
    }
    for (figure, term) in terms {
        let value = term(cells, &counted);
        counted.insert(*figure, value);
    }
    Ok(counted)
}

fn is_named(cell: &str, name: &str) -> bool {
    match name.strip_suffix('*') {
        Some(begin) => cell.starts_with(begin),
        None => cell == name,
    }
}

/// Yosys's record of a module that was flattened.
pub(crate) const SCOPE: &str = "$scopeinfo";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_cell_where_none_is_expected_is_an_error() {
        let cells = [("MULT18X18D".to_owned(), 1)].into();
        let known = [("MULT18X18D", Some(Figure::Dsp))];
        let error = count(&cells, &known, &[], &[Figure::Lut4]).unwrap_err();
        assert!(error.to_string().contains("none of dsp here"), "{error}");
        let error = count(&cells, &[], &[], &[Figure::Dsp]).unwrap_err();
        assert!(
            error.to_string().contains("found 1 cells MULT18X18D"),
            "{error}"
        );
    }
}
