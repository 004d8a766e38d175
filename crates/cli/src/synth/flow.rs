//! The ways in which Yosys maps a machine, one row each.

use clap::ValueEnum;
use photoncube_spec::{Machine, Squarer};
use serde::{Deserialize, Serialize};

use super::cells::Figure;
use super::option_name;
use crate::project::ABC9_TARGET_PS;

/// What a machine is mapped to.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Flow {
    /// LUTs with four inputs and no carry chains: any FPGA
    Lut4,
    /// Lattice ECP5
    Ecp5,
    /// Lattice ECP5 without its DSP blocks
    Ecp5Nodsp,
    /// Gates with two inputs, and plain flip-flops: any chip
    Gates,
    /// Intel Cyclone V
    Intel,
    /// Intel MAX 10
    Max10,
}

/// The parameters of a flow.
struct Row {
    flow: Flow,
    heading: &'static str,
    script: &'static str,
    figures: &'static [Figure],
}

const ECP5_FIGURES: &[Figure] = &[
    Figure::Lut4,
    Figure::Ccu2c,
    Figure::Lut4Equivalents,
    Figure::Ff,
    Figure::Dsp,
    Figure::BlockRam,
    Figure::LutRam,
];

/// The table of flows. In the scripts, `TOP` is the top module's name.
const ROWS: &[Row] = &[
    Row {
        flow: Flow::Lut4,
        heading: "4-input LUTs without carry chains",
        script: "synth -flatten -lut 4 -top TOP",
        figures: &[Figure::Lut4, Figure::Ff],
    },
    Row {
        flow: Flow::Ecp5,
        heading: "ECP5",
        script: "synth_ecp5 -top TOP",
        figures: ECP5_FIGURES,
    },
    Row {
        flow: Flow::Ecp5Nodsp,
        heading: "ECP5 without DSP blocks",
        script: "synth_ecp5 -nodsp -top TOP",
        figures: ECP5_FIGURES,
    },
    // Yosys's table of transistors has no flip-flop with enable or reset, so these become gates and a plain
    // flip-flop, and are counted as such. It has no entry for the bookkeeping cell `$scopeinfo`.
    Row {
        flow: Flow::Gates,
        heading: "gates with two inputs",
        script: "synth -flatten -top TOP; delete t:$scopeinfo; dfflegalize -cell $_DFF_P_ 01; \
                 abc -g AND,NAND,OR,NOR,XOR,XNOR,MUX; opt_clean",
        figures: &[Figure::Gates, Figure::Nand2Equivalents, Figure::Ff],
    },
    // The machine is a block of a larger design, so its ports get no pads and its clock no buffer.
    Row {
        flow: Flow::Intel,
        heading: "Cyclone V",
        script: "synth_intel_alm -family cyclonev -noiopad -noclkbuf -top TOP",
        figures: &[
            Figure::Alut,
            Figure::AlmAtLeast,
            Figure::Ff,
            Figure::Dsp,
            Figure::BlockRam,
            Figure::LutRam,
        ],
    },
    // Without block RAMs: Yosys's own mapping to them uses a parameter that its model of them lacks, and
    // fails at the queue of results.
    Row {
        flow: Flow::Max10,
        heading: "MAX 10",
        script: "synth_intel -family max10 -nobram -top TOP",
        figures: &[
            Figure::LogicCells,
            Figure::Ff,
            Figure::Dsp,
            Figure::BlockRam,
        ],
    },
];

impl Flow {
    /// All flows, in the order of the table.
    pub fn all() -> impl Iterator<Item = Self> {
        ROWS.iter().map(|row| row.flow)
    }

    /// The flow in which a machine is placed: with DSP blocks only where its squarer is made for them. In
    /// other machines the synthesiser finds products elsewhere, and the measurement would be of its choice.
    pub fn to_place(machine: &Machine) -> Self {
        let others = machine.spatial().map_or(&[][..], |spatial| spatial.others);
        let others = others.iter().map(|(kind, _)| kind.squarer);
        match others
            .chain([machine.squarer])
            .any(|kind| kind == Squarer::Product)
        {
            true => Self::Ecp5,
            false => Self::Ecp5Nodsp,
        }
    }

    fn row(self) -> &'static Row {
        let row = ROWS.iter().find(|row| row.flow == self);
        row.expect("a test has seen a row for each flow")
    }

    /// The target of the flow, as a heading.
    pub fn heading(self) -> &'static str {
        self.row().heading
    }

    /// The figures that are counted in the flow.
    pub fn figures(self) -> &'static [Figure] {
        self.row().figures
    }

    /// The flow's name on the command line.
    pub fn name(self) -> String {
        option_name(self)
    }

    /// The Yosys commands between reading and counting.
    pub fn script(self, top: &str) -> String {
        let script = self.row().script.replace("TOP", top);
        format!("scratchpad -set abc9.D {ABC9_TARGET_PS}; {script}")
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    #[test]
    fn each_flow_has_one_row_and_one_name() {
        for &flow in Flow::value_variants() {
            assert_eq!(Flow::all().filter(|&other| other == flow).count(), 1);
            let json = serde_json::to_value(flow).unwrap();
            assert_eq!(json.as_str(), Some(flow.name().as_str()));
            assert!(flow.script("the_top").contains("-top the_top"), "{flow:?}");
        }
    }

    #[test]
    fn dsp_blocks_are_for_squarers_that_are_products() {
        assert_eq!(
            Flow::to_place(find_machine("paper").unwrap()),
            Flow::Ecp5Nodsp
        );
        assert_eq!(
            Flow::to_place(find_machine("paper-dsp").unwrap()),
            Flow::Ecp5
        );
    }
}
