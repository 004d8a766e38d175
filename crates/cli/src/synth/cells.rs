//! Counts cells: the figure that each kind of cell adds to.

use std::collections::BTreeMap;

use anyhow::{Result, bail};
use serde::{Deserialize, Serialize};

/// A figure of the area, in the order of the tables.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Figure {
    /// LUTs with four inputs.
    Lut4,
    /// Carry cells of the ECP5.
    Ccu2c,
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
}

/// Figures of one run.
pub type Figures = BTreeMap<Figure, u64>;

/// The cells that a flow may leave, with the figure that each adds to. `None` is for a cell that takes no
/// room.
const CELLS: &[(&str, Option<Figure>)] = &[
    ("$lut", Some(Figure::Lut4)),
    ("LUT4", Some(Figure::Lut4)),
    ("CCU2C", Some(Figure::Ccu2c)),
    ("TRELLIS_FF", Some(Figure::Ff)),
    ("MULT18X18D", Some(Figure::Dsp)),
    ("DP16KD", Some(Figure::BlockRam)),
    // The block RAM in its wide mode.
    ("PDPW16KD", Some(Figure::BlockRam)),
    ("TRELLIS_DPR16X4", Some(Figure::LutRam)),
    // The 2:1 muxes beside the LUTs in every ECP5 slice.
    ("PFUMX", None),
    ("L6MUX21", None),
    ("MISTRAL_NOT", Some(Figure::Alut)),
    ("MISTRAL_ALUT2", Some(Figure::Alut)),
    ("MISTRAL_ALUT3", Some(Figure::Alut)),
    ("MISTRAL_ALUT4", Some(Figure::Alut)),
    ("MISTRAL_ALUT5", Some(Figure::Alut)),
    (WIDEST_ALUT, Some(Figure::Alut)),
    ("MISTRAL_ALUT_ARITH", Some(Figure::Alut)),
    ("MISTRAL_FF", Some(Figure::Ff)),
    ("MISTRAL_MUL9X9", Some(Figure::Dsp)),
    ("MISTRAL_MUL18X18", Some(Figure::Dsp)),
    ("MISTRAL_MUL27X27", Some(Figure::Dsp)),
    ("MISTRAL_M10K", Some(Figure::BlockRam)),
    ("MISTRAL_MLAB", Some(Figure::LutRam)),
    ("fiftyfivenm_lcell_comb", Some(Figure::LogicCells)),
    ("dffeas", Some(Figure::Ff)),
    ("fiftyfivenm_mac_mult", Some(Figure::Dsp)),
    // The other half of the multiplier's block.
    ("fiftyfivenm_mac_out", None),
    ("altsyncram", Some(Figure::BlockRam)),
    // Yosys's bookkeeping.
    ("$scopeinfo", None),
    // An inverter that the mapping to MAX 10 leaves as it is.
    ("$not", Some(Figure::LogicCells)),
];

/// The ALUT that fills an adaptive logic module of Cyclone V; a module holds two of the others.
const WIDEST_ALUT: &str = "MISTRAL_ALUT6";
const FFS_PER_ALM: u64 = 4;

/// Yosys's own flip-flops, whose names are `$_KIND_POLARITIES_`.
const GENERIC_FFS: &[&str] = &[
    "DFF", "DFFE", "DFFSR", "DFFSRE", "SDFF", "SDFFE", "SDFFCE", "ALDFF", "ALDFFE",
];

/// An ECP5 carry cell takes the place of two LUTs. A RAM of 16 x 4 takes that of three slices with two LUTs
/// each: two hold it, one is its write port.
const LUT4_PER_CCU2C: u64 = 2;
const LUT4_PER_LUT_RAM: u64 = 6;

/// The figures of `wanted`, including zeros. A cell that adds to none of them is an error.
pub fn count(cells: &BTreeMap<String, u64>, wanted: &[Figure]) -> Result<Figures> {
    let mut counted: Figures = wanted.iter().map(|&figure| (figure, 0)).collect();
    for (cell, &number) in cells {
        let Some(figure) = counted_as(cell) else {
            bail!("found {number} cells {cell}, expected only kinds that are counted");
        };
        let Some(figure) = figure else {
            continue;
        };
        match counted.get_mut(&figure) {
            Some(sum) => *sum += number,
            None => bail!(
                "found {number} cells {cell}, expected none of {} here",
                figure.key()
            ),
        }
    }
    let of = |figure| counted.get(&figure).copied().unwrap_or(0);
    let lut4_equivalents = of(Figure::Lut4)
        + LUT4_PER_CCU2C * of(Figure::Ccu2c)
        + LUT4_PER_LUT_RAM * of(Figure::LutRam);
    let widest = cells.get(WIDEST_ALUT).copied().unwrap_or(0);
    let halves = of(Figure::Alut) - widest;
    let alm_at_least = (widest + halves.div_ceil(2)).max(of(Figure::Ff).div_ceil(FFS_PER_ALM));
    for (figure, value) in [
        (Figure::Lut4Equivalents, lut4_equivalents),
        (Figure::AlmAtLeast, alm_at_least),
    ] {
        counted.entry(figure).and_modify(|sum| *sum = value);
    }
    Ok(counted)
}

/// The figure of a kind of cell; `None` for a kind that the table lacks.
fn counted_as(cell: &str) -> Option<Option<Figure>> {
    if let Some((_, figure)) = CELLS.iter().find(|(name, _)| *name == cell) {
        return Some(*figure);
    }
    is_generic_ff(cell).then_some(Some(Figure::Ff))
}

/// Whether a cell is one of Yosys's own flip-flops.
pub fn is_generic_ff(cell: &str) -> bool {
    let kind = cell.strip_prefix("$_").and_then(|cell| {
        let (kind, polarities) = cell.split_once('_')?;
        polarities.ends_with('_').then_some(kind)
    });
    kind.is_some_and(|kind| GENERIC_FFS.contains(&kind))
}

#[cfg(test)]
mod tests {
    use super::super::flow::Flow;
    use super::*;

    fn cells(of: &[(&str, u64)]) -> BTreeMap<String, u64> {
        let owned = of.iter().map(|&(cell, number)| (cell.to_owned(), number));
        owned.collect()
    }

    #[test]
    fn ecp5_counts_what_takes_the_place_of_luts() {
        let cells = cells(&[
            ("$scopeinfo", 200),
            ("CCU2C", 592),
            ("LUT4", 2055),
            ("PFUMX", 39),
            ("TRELLIS_FF", 972),
            ("MULT18X18D", 12),
            ("DP16KD", 1),
            ("PDPW16KD", 2),
            ("TRELLIS_DPR16X4", 10),
        ]);
        let figures = count(&cells, Flow::Ecp5.figures()).unwrap();
        let expected = [
            (Figure::Lut4, 2055),
            (Figure::Ccu2c, 592),
            (Figure::Lut4Equivalents, 2055 + 2 * 592 + 6 * 10),
            (Figure::Ff, 972),
            (Figure::Dsp, 12),
            (Figure::BlockRam, 3),
            (Figure::LutRam, 10),
        ];
        assert_eq!(figures, expected.into());
    }

    #[test]
    fn generic_flip_flops_count_and_latches_do_not() {
        let found = cells(&[
            ("$_DFFE_PP_", 338),
            ("$_SDFFCE_PN0P_", 628),
            ("$_SDFFE_PP0P_", 6),
            ("$lut", 3663),
            ("$scopeinfo", 200),
        ]);
        let figures = count(&found, Flow::Lut4.figures()).unwrap();
        assert_eq!(figures, [(Figure::Lut4, 3663), (Figure::Ff, 972)].into());
        for unknown in ["$_DLATCH_P_", "$_DFFX_P_", "$mul", "ALU54B", "CC_LUT"] {
            let error = count(&cells(&[(unknown, 3)]), Flow::Lut4.figures());
            let error = error.unwrap_err().to_string();
            assert!(
                error.contains(&format!("found 3 cells {unknown}")),
                "{error}"
            );
        }
    }

    #[test]
    fn a_known_cell_where_none_is_expected_is_an_error() {
        let error = count(&cells(&[("MULT18X18D", 1)]), Flow::Lut4.figures()).unwrap_err();
        assert!(error.to_string().contains("none of dsp here"), "{error}");
    }

    #[test]
    fn an_adaptive_logic_module_holds_two_aluts_or_the_widest() {
        let found = cells(&[
            ("MISTRAL_ALUT2", 4),
            ("MISTRAL_ALUT6", 10),
            ("MISTRAL_ALUT_ARITH", 3),
            ("MISTRAL_FF", 20),
        ]);
        let figures = count(&found, Flow::Intel.figures()).unwrap();
        assert_eq!(figures[&Figure::Alut], 17);
        assert_eq!(figures[&Figure::AlmAtLeast], 10 + 4);
        let registers = cells(&[("MISTRAL_FF", 41)]);
        let figures = count(&registers, Flow::Intel.figures()).unwrap();
        assert_eq!(figures[&Figure::AlmAtLeast], 11);
    }

    #[test]
    fn max10_counts_a_multiplier_once() {
        let found = cells(&[
            ("dffeas", 972),
            ("fiftyfivenm_lcell_comb", 3719),
            ("fiftyfivenm_mac_mult", 12),
            ("fiftyfivenm_mac_out", 12),
        ]);
        let figures = count(&found, Flow::Max10.figures()).unwrap();
        assert_eq!(figures[&Figure::Dsp], 12);
        assert_eq!(figures[&Figure::LogicCells], 3719);
    }
}
