//! The arguments of `report`.

use std::path::PathBuf;

use anyhow::{Result, bail};
use clap::Args as ClapArgs;
use photoncube_render::{BenchOptions, FitOptions, MAX_PHOTONS};

use super::Size;
use super::numbers::{count, positive, seed};
use crate::narrow::WideArgs;
use crate::scenes::SceneName;
use crate::shards::ShardArgs;

/// `report`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube report
  photoncube report ring --maps 12 --out out --json
  photoncube report --sweep cornell ring mine.toml --in-range 50,200,800
  photoncube report --sweep cornell ring --in-range 50,200 --shard 2/7 --state 2.jobs

The verdict comes first: the bits that the scene needs, the smallest and the fastest machine. The
error is over the scene's own Monte-Carlo noise, from independent photon maps. Speed on this CPU is
the golden model's by photon format, one thread, the median of repeats, beside plain loops.")]
pub struct ReportArgs {
    /// A built-in scene (see `photoncube list`) or a scene file, TOML (see docs/scenes.md) or JSON
    #[arg(default_value = "cornell", value_name = "SCENE")]
    pub scenes: Vec<SceneName>,
    /// Measure all formats and machines on every SCENE and for every --in-range, of which there may be several: the error alone, no plots
    /// and no speed of this computer
    #[arg(long)]
    pub sweep: bool,
    #[command(flatten)]
    pub shard: ShardArgs,
    /// The folder for the page (HTML), the plots (SVG) and the data of the table (JSON)
    #[arg(long, default_value = "out", value_name = "DIR")]
    pub out: PathBuf,
    /// At least this many photons are stored in each map
    #[arg(long, default_value_t = 200_000, value_name = "N", value_parser = count(1..=MAX_PHOTONS))]
    pub photons: u64,
    /// Photons in range that the search radius aims at, on average
    #[arg(long, default_values_t = [BenchOptions::default().in_range], value_name = "N", value_delimiter = ',', value_parser = positive)]
    pub in_range: Vec<f64>,
    /// Independent photon maps; more know noise and bias better
    #[arg(long, default_value_t = 8, value_name = "N", value_parser = count(3..=u64::MAX))]
    pub maps: u64,
    /// The error's bound, as a part of the scene's own Monte-Carlo noise
    #[arg(long, default_value_t = FitOptions::default().noise_ratio, value_name = "R", value_parser = positive)]
    pub noise_ratio: f64,
    /// The view whose pixels are the queries
    #[arg(long, default_value_t = Size { width: 32, height: 32 }, value_name = "WxH")]
    pub size: Size,
    /// The picture of the page, for which the machines' time is forecast
    #[arg(long, default_value_t = Size { width: 256, height: 256 }, value_name = "WxH")]
    pub picture_size: Size,
    /// Seed of all random numbers
    #[arg(long, default_value_t = 1, value_name = "S", value_parser = seed)]
    pub seed: u64,
    #[command(flatten)]
    pub wide: WideArgs,
}

impl ReportArgs {
    /// The scene and the photons in range of a report that is no sweep.
    ///
    /// # Errors
    /// There are several.
    pub fn single(&self) -> Result<(&SceneName, f64)> {
        match (&self.scenes[..], &self.in_range[..]) {
            ([scene], [in_range]) => Ok((scene, *in_range)),
            (scenes, radii) => bail!(
                "found {} scenes and {} values of --in-range, expected one of each without --sweep",
                scenes.len(),
                radii.len()
            ),
        }
    }
}
