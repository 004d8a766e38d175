//! The arguments of `fit`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use photoncube_render::{BenchOptions, FitOptions, MAX_PHOTONS, ViewOptions};

use super::Size;
use super::numbers::{count, positive, seed};
use crate::narrow::WideArgs;
use crate::scenes::SceneName;

/// `fit`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube fit ring
  photoncube fit cornell --noise-ratio 0.05 --json
  photoncube fit range --photons 1000000 --in-range 500
  photoncube fit mine.toml --emit verilog      writes the smallest machine of exactly this format

The estimate is that of a fixed radius. `render --engine format --format F --estimator E` and
`compare` measure a format for another one.

Every format is predicted on a pilot, the smallest below the bound is measured on photon maps of
its own, and so is each format with one bit less: exit code 0 says that it holds and they do not.")]
pub struct FitArgs {
    /// A built-in scene (see `photoncube list`) or a scene file, TOML (see docs/scenes.md) or JSON
    #[arg(default_value = "cornell")]
    pub scene: SceneName,
    /// The error's bound, as a part of the scene's own Monte-Carlo noise
    #[arg(long, default_value_t = FitOptions::default().noise_ratio, value_name = "R", value_parser = positive)]
    pub noise_ratio: f64,
    /// At least this many photons are stored in each map
    #[arg(long, default_value_t = FitOptions::default().bench.photons, value_name = "N", value_parser = count(1..=MAX_PHOTONS))]
    pub photons: u64,
    /// Photons in range that the search radius aims at, on average
    #[arg(long, default_value_t = FitOptions::default().bench.in_range, value_name = "N", value_parser = positive)]
    pub in_range: f64,
    /// Independent photon maps to measure on; more know the error better
    #[arg(long, default_value_t = FitOptions::default().bench.maps, value_name = "N", value_parser = count(3..=u64::MAX))]
    pub maps: u64,
    /// The view whose pixels are the queries
    #[arg(long, default_value_t = Size::of(&FitOptions::default().bench.view), value_name = "WxH")]
    pub size: Size,
    /// Write the Verilog of the smallest machine into a folder in this one
    #[arg(long, value_name = "DIR")]
    pub emit: Option<PathBuf>,
    /// Seed of all random numbers
    #[arg(long, default_value_t = FitOptions::default().bench.seed, value_name = "S", value_parser = seed)]
    pub seed: u64,
    #[command(flatten)]
    pub wide: WideArgs,
}

impl FitArgs {
    /// The options as the search of the crate `photoncube-render` takes them.
    pub fn options(&self) -> FitOptions {
        let options = FitOptions::default();
        FitOptions {
            noise_ratio: self.noise_ratio,
            bench: BenchOptions {
                photons: self.photons,
                in_range: self.in_range,
                maps: self.maps,
                seed: self.seed,
                view: ViewOptions {
                    width: self.size.width,
                    height: self.size.height,
                    seed: self.seed,
                    ..options.bench.view
                },
            },
            ..options
        }
    }
}
