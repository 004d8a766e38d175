//! The options of a picture that several commands share.

use clap::{Args as ClapArgs, Command, FromArgMatches};
use photoncube_render::{BenchOptions, MAX_PHOTONS, TraceOptions, ViewOptions};

use super::Size;
use super::numbers::{count, positive, seed};

/// The picture's size and quality.
#[derive(ClapArgs, Clone, Debug)]
pub struct PictureArgs {
    /// At least this many photons are traced; with `--direct rays` the map keeps only those of indirect light
    #[arg(long, default_value_t = TraceOptions::default().photons, value_name = "N", value_parser = count(1..=MAX_PHOTONS))]
    pub photons: u64,
    /// Picture size in pixels
    #[arg(long, default_value_t = Size::of(&ViewOptions::default()), value_name = "WxH")]
    pub size: Size,
    /// Query points for each pixel: N x N
    #[arg(long, default_value_t = ViewOptions::default().samples_per_axis, value_name = "N", value_parser = count(1..=64_u32))]
    pub samples: u32,
    /// Photons in range that the search radius aims at, on average
    #[arg(long, default_value_t = BenchOptions::default().in_range, value_name = "N", value_parser = positive)]
    pub in_range: f64,
    /// Seed of all random numbers; the same seed gives the same picture
    #[arg(long, default_value_t = 1, value_name = "S", value_parser = seed)]
    pub seed: u64,
}

impl Default for PictureArgs {
    /// The options where none is given.
    fn default() -> Self {
        let command = Self::augment_args(Command::new("picture"));
        let matches = command.try_get_matches_from(["picture"]);
        let read = matches.and_then(|matches| Self::from_arg_matches(&matches));
        read.expect("each option has a default")
    }
}
