//! LUTs with four inputs, without carry chains: what any FPGA of LUTs has.

use crate::figure::{CellRow, Figure};
use crate::flow::Flow;

pub(super) static FLOW: Flow = Flow {
    name: "lut4",
    family: "any",
    heading: "4-input LUTs without carry chains",
    help: "LUTs with four inputs and no carry chains: any FPGA",
    figures: &[Figure::Lut4, Figure::Ff],
    commands: "synth -flatten -lut 4 -top TOP",
    cells: CELLS,
    terms: &[],
    transistors: None,
};

/// Yosys's own flip-flops have names `$_KIND_POLARITIES_`, with `N` or `P` for each control and `0` or `1` for
/// a reset value.
const CELLS: &[CellRow] = &[
    ("$lut", Some(Figure::Lut4)),
    ("$_DFF_*", Some(Figure::Ff)),
    ("$_DFFE_*", Some(Figure::Ff)),
    ("$_DFFSR_*", Some(Figure::Ff)),
    ("$_DFFSRE_*", Some(Figure::Ff)),
    ("$_SDFF_*", Some(Figure::Ff)),
    ("$_SDFFE_*", Some(Figure::Ff)),
    ("$_SDFFCE_*", Some(Figure::Ff)),
    ("$_ALDFF_*", Some(Figure::Ff)),
    ("$_ALDFFE_*", Some(Figure::Ff)),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{CellCounts, count};

    #[test]
    fn generic_flip_flops_count_and_latches_do_not() {
        let found = [
            ("$_DFFE_PP_", 338),
            ("$_SDFFCE_PN0P_", 628),
            ("$_SDFFE_PP0P_", 6),
            ("$lut", 3663),
            ("$scopeinfo", 200),
        ];
        let figures = |cells: &[(&str, u64)]| {
            let cells = cells.iter().map(|&(cell, n)| (cell.to_owned(), n));
            count(
                &cells.collect::<CellCounts>(),
                FLOW.cells,
                &[],
                FLOW.figures,
            )
        };
        assert_eq!(
            figures(&found).unwrap(),
            [(Figure::Lut4, 3663), (Figure::Ff, 972)].into()
        );
        for unknown in ["$_DLATCH_P_", "$_DFFX_P_", "$mul", "ALU54B", "CC_LUT"] {
            let error = figures(&[(unknown, 3)]).unwrap_err().to_string();
            assert!(
                error.contains(&format!("found 3 cells {unknown}")),
                "{error}"
            );
        }
    }
}
