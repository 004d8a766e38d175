//! Gowin GW1N: the area by Yosys.

use super::Family;
use crate::figure::{CellRow, Figure};
use crate::flow::Flow;

const NAME: &str = "gowin";

pub(super) static FAMILY: Family = Family {
    name: NAME,
    title: "Gowin GW1N",
    placement: None,
};

/// The design is a block of a larger one, so its ports get no pads.
pub(super) static FLOW: Flow = Flow {
    name: "gowin",
    family: NAME,
    heading: "Gowin GW1N",
    help: "Gowin GW1N",
    figures: &[
        Figure::Lut4,
        Figure::Carry,
        Figure::Ff,
        Figure::Dsp,
        Figure::BlockRam,
        Figure::LutRam,
    ],
    commands: "synth_gowin -family gw1n -noiopads -top TOP",
    cells: CELLS,
    terms: &[],
    transistors: None,
};

const CELLS: &[CellRow] = &[
    ("LUT1", Some(Figure::Lut4)),
    ("LUT2", Some(Figure::Lut4)),
    ("LUT3", Some(Figure::Lut4)),
    ("LUT4", Some(Figure::Lut4)),
    // The 2:1 muxes beside the LUTs.
    ("MUX2_LUT5", None),
    ("MUX2_LUT6", None),
    ("MUX2_LUT7", None),
    ("MUX2_LUT8", None),
    ("ALU", Some(Figure::Carry)),
    ("DFF", Some(Figure::Ff)),
    ("DFFE", Some(Figure::Ff)),
    ("DFFS", Some(Figure::Ff)),
    ("DFFSE", Some(Figure::Ff)),
    ("DFFR", Some(Figure::Ff)),
    ("DFFRE", Some(Figure::Ff)),
    ("MULT9X9", Some(Figure::Dsp)),
    ("MULT18X18", Some(Figure::Dsp)),
    ("MULT36X36", Some(Figure::Dsp)),
    ("SP", Some(Figure::BlockRam)),
    ("SPX9", Some(Figure::BlockRam)),
    ("SDPB", Some(Figure::BlockRam)),
    ("SDPX9B", Some(Figure::BlockRam)),
    ("DPB", Some(Figure::BlockRam)),
    ("DPX9B", Some(Figure::BlockRam)),
    ("RAM16S1", Some(Figure::LutRam)),
    ("RAM16S2", Some(Figure::LutRam)),
    ("RAM16S4", Some(Figure::LutRam)),
    ("RAM16SDP1", Some(Figure::LutRam)),
    ("RAM16SDP2", Some(Figure::LutRam)),
    ("RAM16SDP4", Some(Figure::LutRam)),
    ("VCC", None),
    ("GND", None),
];
