//! Counts gates in NAND2 equivalents, the unit of gate arrays.

use std::collections::BTreeMap;

use anyhow::{Context, Result, bail};

use super::cells::{Figure, Figures};

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
    (FF, 16),
];
const FF: &str = "$_DFF_P_";
/// The transistors of a NAND with two inputs.
const TRANSISTORS_PER_NAND2: u64 = 4;

/// The figures of a design of gates. Yosys's sum of transistors must agree with the table's.
pub fn count(cells: &BTreeMap<String, u64>, yosys_transistors: &str) -> Result<Figures> {
    let mut transistors = 0;
    for (cell, &number) in cells {
        let found = TRANSISTORS.iter().find(|(name, _)| name == cell);
        let Some((_, each)) = found else {
            bail!("found {number} cells {cell}, expected only gates of two inputs and {FF}");
        };
        transistors += each * number;
    }
    // Yosys prints a `+` after the number if it has left out cells.
    let yosys: u64 = yosys_transistors.parse().with_context(|| {
        format!("found {yosys_transistors} transistors, expected a sum over all cells")
    })?;
    if yosys != transistors {
        bail!("Yosys counts {yosys} transistors, the table {transistors}: this Yosys has another");
    }
    Ok([
        (Figure::Gates, cells.values().sum()),
        (
            Figure::Nand2Equivalents,
            transistors.div_ceil(TRANSISTORS_PER_NAND2),
        ),
        (Figure::Ff, cells.get(FF).copied().unwrap_or(0)),
    ]
    .into())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The cells of the machine `paper`, as Yosys 0.70 counts them.
    fn paper() -> BTreeMap<String, u64> {
        let cells = [
            ("$_AND_", 2640),
            ("$_DFF_P_", 972),
            ("$_MUX_", 355),
            ("$_NAND_", 6934),
            ("$_NOR_", 80),
            ("$_NOT_", 212),
            ("$_OR_", 524),
            ("$_XNOR_", 444),
            ("$_XOR_", 656),
        ];
        cells.map(|(cell, n)| (cell.to_owned(), n)).into()
    }

    #[test]
    fn transistors_are_those_of_yosys() {
        let figures = count(&paper(), "80476").unwrap();
        assert_eq!(figures[&Figure::Gates], 12_817);
        assert_eq!(figures[&Figure::Nand2Equivalents], 20_119);
        assert_eq!(figures[&Figure::Ff], 972);
    }

    #[test]
    fn another_sum_or_an_incomplete_one_is_an_error() {
        assert!(count(&paper(), "80475").is_err());
        assert!(count(&paper(), "80476+").is_err());
        let mut cells = paper();
        cells.insert("$_DFFE_PP_".to_owned(), 1);
        let error = count(&cells, "80476+").unwrap_err().to_string();
        assert!(error.contains("$_DFFE_PP_"), "{error}");
    }
}
