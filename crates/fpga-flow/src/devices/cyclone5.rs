//! Intel Cyclone V: the area by Yosys.

use super::Family;
use crate::figure::{CellCounts, CellRow, Figure, Figures};
use crate::flow::Flow;

const NAME: &str = "cyclonev";

pub(super) static FAMILY: Family = Family {
    name: NAME,
    title: "Intel Cyclone V",
    placement: None,
};

/// The design is a block of a larger one, so its ports get no pads and its clock no buffer.
pub(super) static FLOW: Flow = Flow {
    name: "intel",
    family: NAME,
    heading: "Cyclone V",
    help: "Intel Cyclone V",
    figures: &[
        Figure::Alut,
        Figure::AlmAtLeast,
        Figure::Ff,
        Figure::Dsp,
        Figure::BlockRam,
        Figure::LutRam,
    ],
    commands: "synth_intel_alm -family cyclonev -noiopad -noclkbuf -top TOP",
    cells: CELLS,
    terms: &[(Figure::AlmAtLeast, alm_at_least)],
    transistors: None,
};

const CELLS: &[CellRow] = &[
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
];

/// The ALUT that fills an adaptive logic module; a module holds two of the others.
const WIDEST_ALUT: &str = "MISTRAL_ALUT6";
const FFS_PER_ALM: u64 = 4;

fn alm_at_least(cells: &CellCounts, figures: &Figures) -> u64 {
    let of = |figure| figures.get(&figure).copied().unwrap_or(0);
    let widest = cells.get(WIDEST_ALUT).copied().unwrap_or(0);
    let halves = of(Figure::Alut) - widest;
    (widest + halves.div_ceil(2)).max(of(Figure::Ff).div_ceil(FFS_PER_ALM))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::count;

    #[test]
    fn an_adaptive_logic_module_holds_two_aluts_or_the_widest() {
        let figures = |cells: &[(&str, u64)]| {
            let cells = cells.iter().map(|&(cell, n)| (cell.to_owned(), n));
            count(&cells.collect(), CELLS, FLOW.terms, FLOW.figures).unwrap()
        };
        let found = figures(&[
            ("MISTRAL_ALUT2", 4),
            (WIDEST_ALUT, 10),
            ("MISTRAL_ALUT_ARITH", 3),
            ("MISTRAL_FF", 20),
        ]);
        assert_eq!(found[&Figure::Alut], 17);
        assert_eq!(found[&Figure::AlmAtLeast], 10 + 4);
        assert_eq!(figures(&[("MISTRAL_FF", 41)])[&Figure::AlmAtLeast], 11);
    }
}
