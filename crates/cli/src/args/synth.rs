//! The arguments of `synth`.

use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::sync::LazyLock;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args as ClapArgs, ValueEnum};
use fpga_flow::{Device, FLOWS, Flow, Placer, Router};

use crate::narrow::WideArgs;
use crate::project::ABC9_TARGET_PS;
use crate::scenes::SceneName;
use crate::shards::ShardArgs;
use crate::synth::figures::recorded_flows;
use crate::synth::{DEFAULT_DEVICE, asic};

/// `synth`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube synth                                   all machines, and writes docs/measured/
  photoncube synth --machine paper --grade 8 --seeds 1
  photoncube synth --machine paper --flow place --seed 1 --endpoints    where slow paths end
  photoncube synth --machine paper --flow gates --flow intel --json
  photoncube synth --machine paper --update          replaces that machine's rows, no others
  photoncube synth --machine paper --device up5k     area and clock in an iCE40, or what it lacks
  photoncube synth --check                           fails where the committed rows are stale
  photoncube synth --asic --machine stream           area, clock and energy in standard cells
  photoncube synth --asic --machine stream --activity-of cornell
  photoncube synth --seeds 20 --shard 2/7 --state 2.jobs    a part, for `photoncube merge`

Yosys maps each machine in every flow; nextpnr places and routes it on an FPGA, in a serial wrapper
that gives each port a register, with DSP blocks only where the machine's squarer is a product.
About 5 s for each machine and flow, and half a minute for each machine, speed grade and seed; more
where machines are larger. A machine that the FPGA cannot hold ends with exit code 1, and with what
is lacking.
`photoncube setup --synthesis` installs the tools, and `photoncube setup --asic` those of --asic.")]
pub struct SynthArgs {
    /// Only this machine; can be given several times [default: all]
    #[arg(long = "machine", value_name = "M")]
    pub machines: Vec<String>,
    /// The core of N chains of that machine
    #[arg(long, value_name = "N", requires = "machines", conflicts_with_all = ["update", "check"])]
    pub chains: Option<u32>,
    /// Only this; can be given several times [default: those of docs/measured and the clock; with an FPGA of
    /// another family, its flows and the clock]
    #[arg(long = "flow", value_enum, value_name = "F")]
    pub flows: Vec<Measurement>,
    /// The FPGA to place machines in: LFE5U-85F, -45F, -25F, -12F (ECP5; or 85k, 45k, 25k, 12k), iCE40UP5K, iCE40HX8K
    /// or iCE40HX1K (or up5k, hx8k, hx1k)
    #[arg(long, default_value = DEFAULT_DEVICE, value_name = "D", value_parser = Device::find)]
    pub device: &'static Device,
    /// Its speed grade, for an ECP5 6 (slowest) to 8; can be given several times [default: slowest and fastest]
    #[arg(long = "grade", value_name = "G")]
    pub grades: Vec<u32>,
    /// Place and route with the seeds 1 to N
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub seeds: u32,
    /// Place and route with this seed alone: where one takes an hour, or does not route
    #[arg(long, conflicts_with = "seeds", value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub seed: Option<u32>,
    /// The clock for which Yosys maps, in ps: where a path is longer, it takes more LUTs
    #[arg(long, default_value_t = ABC9_TARGET_PS, value_name = "PS", conflicts_with_all = ["update", "check"],
        value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub map_for: u32,
    /// How to place
    #[arg(long, default_value = "heap", value_name = "P", value_parser = placers())]
    pub placer: Placer,
    /// How to route
    #[arg(long, default_value = "router1", value_name = "R", value_parser = routers())]
    pub router: Router,
    /// Also list the registers at which slow paths end, and how many end there. Where few paths are slow, a change at a few registers
    /// gives a faster clock
    #[arg(long, requires = "machines", conflicts_with_all = ["update", "check", "shard"])]
    pub endpoints: bool,
    /// Runs at the same time [default: one for each core]
    #[arg(long, value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
    /// The folder of the tools [default: where `photoncube setup --synthesis` installed them]
    #[arg(long, value_name = "DIR")]
    pub tools: Option<PathBuf>,
    /// The folder of synthesis.json and place.json
    #[arg(long, default_value = "docs/measured", value_name = "DIR")]
    pub out: PathBuf,
    /// Write what was measured, also if it is not everything, and keep the other rows
    #[arg(long, conflicts_with = "shard")]
    pub update: bool,
    /// Measure nothing; fail if the files are not about these machines' Verilog, all of it
    #[arg(long, conflicts_with_all = ["update", "flows", "device", "grades", "seeds", "seed", "placer", "router", "jobs", "tools", "shard", "state"])]
    pub check: bool,
    /// In standard cells instead: area, clock, and energy of a photon test, by Yosys and OpenSTA, without wires and clock tree
    #[arg(long, conflicts_with_all = ["chains", "flows", "device", "grades", "seeds", "seed", "map_for", "placer", "router", "endpoints", "out",
        "update", "check", "shard", "state"])]
    pub asic: bool,
    /// The Liberty library of the standard cells
    #[arg(long, requires = "asic", default_value = asic::LIBERTY, value_name = "FILE")]
    pub liberty: PathBuf,
    /// The transitions of each net in a clock cycle
    #[arg(long, requires = "asic", default_value_t = asic::ACTIVITY, value_name = "X", value_parser = activity)]
    pub activity: f64,
    /// Simulate the mapped netlist on photons of this scene too, compare it with the golden model in every clock, and take the energy
    /// at each net's own transitions; without a name on cornell. Needs Icarus
    #[arg(long, requires = "asic", value_name = "SCENE", num_args = 0..=1, default_missing_value = "cornell")]
    pub activity_of: Option<SceneName>,
    /// Put clock gates of the library before registers with an enable. Only --activity-of knows how often these are enabled
    #[arg(long, requires = "asic")]
    pub clock_gating: bool,
    /// Also write the netlist of each machine to DIR/M.v
    #[arg(long, requires = "asic", value_name = "DIR")]
    pub netlists: Option<PathBuf>,
    #[command(flatten)]
    pub shard: ShardArgs,
    #[command(flatten)]
    pub wide: WideArgs,
}

/// A flow, or the clock.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Measurement {
    /// The area in a flow.
    Area(&'static Flow),
    /// The clock, placed and routed.
    Place,
}

impl ValueEnum for Measurement {
    fn value_variants<'a>() -> &'a [Self] {
        static ALL: LazyLock<Vec<Measurement>> = LazyLock::new(|| {
            let areas = FLOWS.into_iter().map(Measurement::Area);
            areas.chain([Measurement::Place]).collect()
        });
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Area(flow) => Some(PossibleValue::new(flow.name).help(flow.help)),
            Self::Place => Some(PossibleValue::new("place").help("The clock, placed and routed")),
        }
    }
}

impl Measurement {
    fn is_area(&self, flow: &Flow) -> bool {
        matches!(self, Self::Area(area) if *area == flow)
    }
}

/// Reads the transitions of a net in a clock cycle.
fn activity(text: &str) -> Result<f64, String> {
    let found = text.parse().ok();
    let found = found.filter(|activity| (0.0..=2.0).contains(activity));
    found.ok_or_else(|| "expected a number from 0 to 2, which is the clock's own".to_owned())
}

/// The placers by nextpnr's names.
fn placers() -> impl TypedValueParser<Value = Placer> {
    let heap = "Analytically, with slow paths first: nextpnr's default";
    let r#static = "By forces between cells: shorter nets, slow paths first only at the end; finds places in \
                    full devices";
    let names = [(Placer::Heap, heap), (Placer::Static, r#static)];
    let values = names.map(|(placer, help)| PossibleValue::new(placer.name()).help(help));
    PossibleValuesParser::new(values).map(|name| match name.as_str() {
        "static" => Placer::Static,
        _ => Placer::Heap,
    })
}

/// The routers by nextpnr's names.
fn routers() -> impl TypedValueParser<Value = Router> {
    let router1 = "Net by net, with slow paths first: nextpnr's default";
    let router2 = "All nets at once, dearer where they meet; finds routes in full devices";
    let names = [(Router::Router1, router1), (Router::Router2, router2)];
    let values = names.map(|(router, help)| PossibleValue::new(router.name()).help(help));
    PossibleValuesParser::new(values).map(|name| match name.as_str() {
        "router2" => Router::Router2,
        _ => Router::Router1,
    })
}

impl SynthArgs {
    /// Whether the measurements are written to the committed figures. Those of a shard are not.
    pub fn writes(&self) -> bool {
        self.shard.shard.is_none() && (self.update || self.is_complete())
    }

    /// The flows to count areas in.
    pub fn area_flows(&self) -> Vec<&'static Flow> {
        let family = self.device.family();
        match (
            self.flows.is_empty(),
            recorded_flows().any(|flow| flow.family == family.name),
        ) {
            (true, true) => recorded_flows().collect(),
            (true, false) => family.flows().collect(),
            (false, _) => {
                let is_wanted = |flow: &&Flow| self.flows.iter().any(|of| of.is_area(flow));
                FLOWS.into_iter().filter(is_wanted).collect()
            }
        }
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
        let all_tries = self.grades.is_empty() && self.seed.is_none();
        everything && all_tries && self.map_for == ABC9_TARGET_PS
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_activity_is_at_most_that_of_the_clock() {
        assert_eq!(activity("0.2"), Ok(0.2));
        assert_eq!(activity("2"), Ok(2.0));
        for wrong in ["-0.1", "2.1", "NaN", "much"] {
            assert!(activity(wrong).unwrap_err().contains("0 to 2"), "{wrong}");
        }
    }
}
