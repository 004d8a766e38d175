//! The arguments of `run`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use photoncube_render::FitOptions;

use super::{PictureArgs, count};
use crate::commands::WavesArgs;
use crate::machines::ChosenMachineArgs;
use crate::narrow::WideArgs;
use crate::scenes::SceneName;

/// `run`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube run
  photoncube run cornell --machine paper-12 --out out --photons 2000000 --json

Without --machine the scene is fitted first, as by `photoncube fit`.
Both fit on maps of at most 200000 photons and size the sums for twice the largest query of these
maps. `run` also makes the sums hold the largest query of its own picture, which has all --photons;
its format may therefore end in a larger -n than the one that `fit` prints.
The Verilog is compared with the golden model, on photons of the scene, in the built-in evaluator
and in every simulator that is found (Icarus, Verilator); those that are not found are named, with
the command that installs them.")]
pub struct RunArgs {
    /// A built-in scene (see `photoncube list`) or a scene file, TOML (see docs/scenes.md) or JSON
    #[arg(default_value = "cornell")]
    pub scene: SceneName,
    #[command(flatten)]
    pub machine: ChosenMachineArgs,
    /// The folder for the picture, the Verilog and the summary
    #[arg(long, default_value = "out", value_name = "DIR")]
    pub out: PathBuf,
    #[command(flatten)]
    pub picture: PictureArgs,
    /// At least so many iterations (groups of photons of this scene) to compare in each simulator [default: by its speed]
    #[arg(long, value_name = "N", value_parser = count(1..=u64::MAX))]
    pub iterations: Option<u64>,
    /// Independent photon maps to fit the format on; more know the error better
    #[arg(long, default_value_t = FitOptions::default().bench.maps, value_name = "N", value_parser = count(3..=u64::MAX), conflicts_with = "machine")]
    pub maps: u64,
    #[command(flatten)]
    pub waves: WavesArgs,
    #[command(flatten)]
    pub wide: WideArgs,
}
