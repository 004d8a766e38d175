//! The arguments of `plan`.

use clap::Args as ClapArgs;
use photoncube_render::{Cull, Facings};

use super::PictureArgs;
use super::numbers::count;
use crate::narrow::WideArgs;
use crate::scenes::SceneName;

/// The most photons of a leaf and engines of a chip: more than any FPGA holds.
const MOST: u32 = 1024;

/// `plan`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube plan cornell
  photoncube plan ring --photons 500000 --leaf 8 --chain 4,8,16
  photoncube plan mine.toml --format local6x2-rgb4d-n4096 --json

The queries of the picture are put into batches, one query for each engine of a chain, and the
photons into leaves. A batch is tested against the leaves whose box is within the radius of its own
box. The forecast assumes that every chain always has a batch: no loads, no waiting.")]
pub struct PlanArgs {
    /// A built-in scene (see `photoncube list`) or a scene file, TOML (see docs/scenes.md) or JSON
    #[arg(default_value = "cornell")]
    pub scene: SceneName,
    /// The photon format, by name (see docs/formats.md), whose steps the boxes have
    #[arg(long, default_value = "local7-rgb6d", value_name = "F")]
    pub format: String,
    /// Photons of a leaf
    #[arg(long, default_value = "8,16", value_delimiter = ',', value_name = "LIST", value_parser = count(1..=MOST))]
    pub leaf: Vec<u32>,
    /// Engines of a chain, which are the queries of a batch [default: 8,16,64, those that the chip has]
    #[arg(long, value_delimiter = ',', value_name = "LIST", value_parser = count(1..=MOST))]
    pub chain: Vec<u32>,
    /// How the box of a leaf is compared with that of a batch: `axes`, the gap on each, or `distance`
    #[arg(long, default_value = Cull::Distance.name(), value_name = "C", value_parser = cull)]
    pub cull: Cull,
    /// What leaves out photons of facings that a query does not gather: each `engine`, so that queries of all facings
    /// share a batch, or the `chain`, so that they do not
    #[arg(long, default_value = Facings::Chain.name(), value_name = "F", value_parser = facings)]
    pub facings: Facings,
    /// Engines of the chip, which are divided among its chains
    #[arg(long, default_value_t = 64, value_name = "N", value_parser = count(1..=MOST))]
    pub engines: u32,
    #[command(flatten)]
    pub picture: PictureArgs,
    #[command(flatten)]
    pub wide: WideArgs,
}

fn cull(name: &str) -> Result<Cull, String> {
    let found = Cull::ALL.into_iter().find(|cull| cull.name() == name);
    found.ok_or_else(|| format!("expected {}", Cull::ALL.map(Cull::name).join(" or ")))
}

fn facings(name: &str) -> Result<Facings, String> {
    let found = Facings::ALL
        .into_iter()
        .find(|facings| facings.name() == name);
    found.ok_or_else(|| format!("expected {}", Facings::ALL.map(Facings::name).join(" or ")))
}
