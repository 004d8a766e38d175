//! The arguments of `synth`.

use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::builder::PossibleValue;
use clap::{Args as ClapArgs, ValueEnum};

use crate::synth::flow::Flow;
use crate::synth::place::{DEVICES, Device, Placer, Router};

/// `synth`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube synth                                   all machines, and writes docs/measured/
  photoncube synth --machine paper --grade 8 --seeds 1
  photoncube synth --machine paper --flow gates --flow intel --json
  photoncube synth --machine paper --update          replaces that machine's rows and keeps the others
  photoncube synth --check                           fails where docs/measured/ is about other Verilog

Yosys maps each machine in every flow; nextpnr places and routes it on an ECP5, in a serial wrapper
that gives each port a register, with DSP blocks only where the machine's squarer is a product. About
5 s for each machine and flow, and half a minute for each machine, speed grade and seed; more where
machines are larger. `scripts/setup.sh --synthesis` installs both tools.")]
pub struct SynthArgs {
    /// Only this machine; can be given several times [default: all]
    #[arg(long = "machine", value_name = "M")]
    pub machines: Vec<String>,
    /// Only this; can be given several times [default: all]
    #[arg(long = "flow", value_enum, value_name = "F")]
    pub flows: Vec<Measurement>,
    /// The FPGA to place machines in
    #[arg(long, default_value = DEVICES[0].name, value_name = "D", value_parser = Device::find)]
    pub device: &'static Device,
    /// Its speed grade, 6 (slowest) to 8; can be given several times [default: 6 and 8]
    #[arg(long = "grade", value_name = "G", value_parser = clap::value_parser!(u32).range(6..=8))]
    pub grades: Vec<u32>,
    /// Place and route with the seeds 1 to N
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub seeds: u32,
    /// Place and route with this seed alone: where one takes an hour, or does not route
    #[arg(long, conflicts_with = "seeds", value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub seed: Option<u32>,
    /// How to place
    #[arg(long, value_enum, default_value_t, value_name = "P")]
    pub placer: Placer,
    /// How to route
    #[arg(long, value_enum, default_value_t, value_name = "R")]
    pub router: Router,
    /// Runs at the same time [default: one for each core]
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
    /// The folder of the tools [default: where `scripts/setup.sh --synthesis` installed them]
    #[arg(long, value_name = "DIR")]
    pub tools: Option<PathBuf>,
    /// The folder of synthesis.json and place.json
    #[arg(long, default_value = "docs/measured", value_name = "DIR")]
    pub out: PathBuf,
    /// Write what was measured, also if it is not everything, and keep the other rows
    #[arg(long)]
    pub update: bool,
    /// Measure nothing; fail if the files are not about these machines' Verilog, all of it
    #[arg(long, conflicts_with_all = ["update", "flows", "device", "grades", "seeds", "seed", "placer", "router", "jobs", "tools"])]
    pub check: bool,
}

/// A flow, or the clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Measurement {
    /// The area in a flow.
    Area(Flow),
    /// The clock, placed and routed.
    Place,
}

impl ValueEnum for Measurement {
    fn value_variants<'a>() -> &'a [Self] {
        const ALL: [Measurement; 7] = [
            Measurement::Area(Flow::Lut4),
            Measurement::Area(Flow::Ecp5),
            Measurement::Area(Flow::Ecp5Nodsp),
            Measurement::Area(Flow::Gates),
            Measurement::Area(Flow::Intel),
            Measurement::Area(Flow::Max10),
            Measurement::Place,
        ];
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Area(flow) => flow.to_possible_value(),
            Self::Place => Some(PossibleValue::new("place").help("The clock, placed and routed")),
        }
    }
}

impl SynthArgs {
    /// The flows to count areas in.
    pub fn area_flows(&self) -> Vec<Flow> {
        let wanted =
            |flow: &Flow| self.flows.is_empty() || self.flows.contains(&Measurement::Area(*flow));
        Flow::all().filter(wanted).collect()
    }

    /// Whether machines are placed.
    pub fn places(&self) -> bool {
        self.flows.is_empty() || self.flows.contains(&Measurement::Place)
    }

    /// The seeds to place with.
    pub fn all_seeds(&self) -> RangeInclusive<u32> {
        self.seed.map_or(1..=self.seeds, |seed| seed..=seed)
    }

    /// Whether nothing is left out.
    pub fn is_complete(&self) -> bool {
        let everything = self.machines.is_empty() && self.flows.is_empty();
        everything && self.grades.is_empty() && self.seed.is_none()
    }
}
