//! Intel MAX 10: the area by Yosys.

use super::Family;
use crate::figure::{CellRow, Figure};
use crate::flow::Flow;

const NAME: &str = "max10";

pub(super) static FAMILY: Family = Family {
    name: NAME,
    title: "Intel MAX 10",
    placement: None,
};

/// Without block RAMs: Yosys's own mapping to them uses a parameter that its model of them lacks, and fails at
/// some memories.
pub(super) static FLOW: Flow = Flow {
    name: "max10",
    family: NAME,
    heading: "MAX 10",
    help: "Intel MAX 10",
    figures: &[
        Figure::LogicCells,
        Figure::Ff,
        Figure::Dsp,
        Figure::BlockRam,
    ],
    commands: "synth_intel -family max10 -nobram -top TOP",
    cells: CELLS,
    terms: &[],
    transistors: None,
};

const CELLS: &[CellRow] = &[
    ("fiftyfivenm_lcell_comb", Some(Figure::LogicCells)),
    // An inverter that the mapping leaves as it is.
    ("$not", Some(Figure::LogicCells)),
    ("dffeas", Some(Figure::Ff)),
    ("fiftyfivenm_mac_mult", Some(Figure::Dsp)),
    // The other half of the multiplier's block.
    ("fiftyfivenm_mac_out", None),
    ("altsyncram", Some(Figure::BlockRam)),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::count;

    #[test]
    fn a_multiplier_is_counted_once() {
        let found = [
            ("dffeas", 972),
            ("fiftyfivenm_lcell_comb", 3719),
            ("fiftyfivenm_mac_mult", 12),
            ("fiftyfivenm_mac_out", 12),
        ];
        let found = found.map(|(cell, n)| (cell.to_owned(), n)).into();
        let figures = count(&found, CELLS, FLOW.terms, FLOW.figures).unwrap();
        assert_eq!(figures[&Figure::Dsp], 12);
        assert_eq!(figures[&Figure::LogicCells], 3719);
    }
}
