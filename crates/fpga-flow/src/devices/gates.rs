//! Gates with two inputs and plain flip-flops, counted in NAND2 equivalents, the unit of gate arrays.

use crate::area::Stat;
use crate::error::{Result, unexpected};
use crate::figure::{CellCounts, CellRow, Figure, Figures};
use crate::flow::Flow;

/// Yosys's table of transistors has no flip-flop with enable or reset, so these become gates and a plain
/// flip-flop, and are counted as such. It has no entry for the bookkeeping cell `$scopeinfo`.
pub(super) static FLOW: Flow = Flow {
    name: "gates",
    family: "any",
    heading: "gates with two inputs",
    help: "Gates with two inputs, and plain flip-flops: any chip",
    figures: &[Figure::Gates, Figure::Nand2Equivalents, Figure::Ff],
    commands: "synth -flatten -top TOP; delete t:$scopeinfo; dfflegalize -cell $_DFF_P_ 01; \
               abc -g AND,NAND,OR,NOR,XOR,XNOR,MUX; opt_clean",
    cells: CELLS,
    terms: &[
        (Figure::Gates, all_cells),
        (Figure::Nand2Equivalents, nand2_equivalents),
    ],
    transistors: Some(("cmos", check)),
};

const CELLS: &[CellRow] = &[
    ("$_NOT_", Some(Figure::Gates)),
    ("$_NAND_", Some(Figure::Gates)),
    ("$_NOR_", Some(Figure::Gates)),
    ("$_AND_", Some(Figure::Gates)),
    ("$_OR_", Some(Figure::Gates)),
    ("$_XOR_", Some(Figure::Gates)),
    ("$_XNOR_", Some(Figure::Gates)),
    ("$_MUX_", Some(Figure::Gates)),
    ("$_DFF_P_", Some(Figure::Ff)),
];

/// Transistors of each cell in static CMOS, as in Yosys's `stat -tech cmos`. Inverting gates are native; a
/// gate that does not invert has an inverter behind it. XOR, XNOR and the mux count as three NANDs; a
/// flip-flop is two latches of two gates each.
const TRANSISTORS: &[(&str, u64)] = &[
    ("$_NOT_", 2),
    ("$_NAND_", 4),
    ("$_NOR_", 4),
    ("$_AND_", 6),
    ("$_OR_", 6),
    ("$_XOR_", 12),
    ("$_XNOR_", 12),
    ("$_MUX_", 12),
    ("$_DFF_P_", 16),
];
/// The transistors of a NAND with two inputs.
const TRANSISTORS_PER_NAND2: u64 = 4;

fn all_cells(cells: &CellCounts, _: &Figures) -> u64 {
    cells.values().sum()
}

fn nand2_equivalents(cells: &CellCounts, _: &Figures) -> u64 {
    transistors(cells).div_ceil(TRANSISTORS_PER_NAND2)
}

fn transistors(cells: &CellCounts) -> u64 {
    let of = |(cell, each): &(&str, u64)| each * cells.get(*cell).copied().unwrap_or(0);
    TRANSISTORS.iter().map(of).sum()
}

/// Fails unless Yosys's sum of transistors agrees with the table's.
fn check(stat: &Stat) -> Result<()> {
    let said = stat.transistors.as_deref().unwrap_or_default();
    // Yosys prints a `+` after the number if it has left out cells.
    let yosys: u64 = said.parse().map_err(|_| {
        unexpected(format!(
            "found `{said}` transistors, expected a sum over all cells"
        ))
    })?;
    let table = transistors(&stat.cells);
    if yosys == table {
        return Ok(());
    }
    Err(unexpected(format!(
        "Yosys counts {yosys} transistors, the table {table}: this Yosys has another"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cells of a processor, as Yosys 0.70 counts them.
    const CELLS: &str = r#""$_AND_": 2640, "$_DFF_P_": 972, "$_MUX_": 355, "$_NAND_": 6934, "$_NOR_": 80,
        "$_NOT_": 212, "$_OR_": 524, "$_XNOR_": 444, "$_XOR_": 656"#;

    fn count(cells: &str, transistors: &str) -> Result<Figures> {
        FLOW.count(&format!(
            r#"{{"design": {{"num_cells_by_type": {{{cells}}}, "estimated_num_transistors": "{transistors}"}}}}"#
        ))
    }

    #[test]
    fn transistors_are_those_of_yosys() {
        let figures = count(CELLS, "80476").unwrap();
        assert_eq!(figures[&Figure::Gates], 12_817);
        assert_eq!(figures[&Figure::Nand2Equivalents], 20_119);
        assert_eq!(figures[&Figure::Ff], 972);
    }

    #[test]
    fn another_sum_or_an_incomplete_one_is_an_error() {
        assert!(count(CELLS, "80475").is_err());
        assert!(count(CELLS, "80476+").is_err());
        let with_enable = format!(r#"{CELLS}, "$_DFFE_PP_": 1"#);
        let error = count(&with_enable, "80476+").unwrap_err().to_string();
        assert!(error.contains("$_DFFE_PP_"), "{error}");
    }
}
