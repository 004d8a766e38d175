//! The arguments of `progressive`.

use std::path::{Path, PathBuf};

use clap::Args as ClapArgs;
use photoncube_render::{MAX_PHOTONS, ProgressiveOptions, RadiusRule, ViewOptions};

use super::numbers::{count, positive, seed};
use super::{EngineArgs, LightArgs, Size};
use crate::scenes::SceneName;
use crate::shards::Shard;

/// `progressive`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube progressive cornell -o box.png
  photoncube progressive cornell -o box.png --error-target 0.1 --confidence 0.9 --passes 1000
  photoncube progressive ring -o ring.exr --engine format --snapshots --plot ring.svg
  photoncube progressive cornell -o box.exr --size 128x128 --reference docs/reference/cornell.exr
  photoncube progressive cornell -o box.png --state box.state --passes 16
  photoncube progressive cornell -o box.png --state box.state --resume --passes 64
  photoncube progressive cornell --passes 64 --shard 2/7 --state box-2.state

Each pass has photons of its own, and a smaller radius; the picture is the mean of the passes. Each
pass gathers at the whole and at half the squared radius, which tells the bias; the spread of the
passes tells the noise. Where the bias of a pixel is significant, it is taken off. --error-target
stops when sqrt(noise^2 + 2 bias^2), root mean squares over the pixels, each over the pixel's
luminance, is not above it and bias does not rule: where it does, as beside black, the error may be
above the bound. A pixel's own bound (--error-map) is not exceeded with the probability
--confidence. See docs/accuracy.md for how many bounds hold, and where they do not.

Photons, view rays and shadow rays of a pass are chosen by a pilot where they are not given: it
measures on some rows what each contributes to the error, and takes the choice of least error for a
given work. The same scene and seed give the same choice. Direct light comes from shadow rays and
caustics from a map of their own, unless --direct map and --caustics map are given.

With --radius-rule chi-square the pass keeps its radius, and each pixel has one of its own in the
global map: its photons are counted over the passes in two rings of four quadrants, and its squared
radius is halved when a chi-square test of 1 % says that they are not even. It pays where that map
carries the caustics. A caustics' map of its own has the schedule. See docs/accuracy.md.

Ctrl-C ends the run after the pass that is under way, and writes the picture of the passes so far.
--resume needs the options of the run that began the picture: those of the passes, the engine and
the light. --passes, --error-target, --confidence and the files may be others. It also makes the
picture of shards that `photoncube merge` has put together.")]
pub struct ProgressiveArgs {
    /// A built-in scene (see `photoncube list`) or a scene file, TOML (see docs/scenes.md) or JSON
    pub scene: SceneName,
    /// The picture, a PNG or OpenEXR file
    #[arg(short, long, value_name = "FILE", required_unless_present = "shard")]
    output: Option<PathBuf>,
    /// Passes, at most
    #[arg(long, default_value_t = 64, value_name = "N", value_parser = count(2..=u64::MAX))]
    pub passes: u64,
    /// Stop when the picture's error is below this part of its luminance: 0.05 is 5 %
    #[arg(long, value_name = "E", value_parser = positive)]
    pub error_target: Option<f64>,
    /// With which probability a pixel's error is below its bound
    #[arg(long, default_value_t = 0.9, value_name = "C", value_parser = parse_confidence)]
    pub confidence: f64,
    /// At least this many photons are traced in each pass; with `--direct rays` the map keeps only those of indirect light
    /// [default: the pilot's choice]
    #[arg(long, value_name = "N", value_parser = count(1..=MAX_PHOTONS))]
    pub photons: Option<u64>,
    /// Photons in range that the radius of the first pass aims at, on average
    #[arg(long, default_value_t = ProgressiveOptions::default().in_range, value_name = "N", value_parser = positive)]
    pub in_range: f64,
    /// How the radius falls: the squared radius of pass i + 1 is (i + A) / (i + 1) of that before
    #[arg(long, default_value_t = ProgressiveOptions::default().alpha, value_name = "A")]
    pub alpha: f64,
    /// How radii fall: schedule (one for all pixels, by --alpha) or chi-square (a pixel's squared radius is halved when its photons are not
    /// spread evenly) [default: chi-square with --caustics map, else schedule]
    #[arg(long, value_name = "RULE")]
    pub radius_rule: Option<RadiusRule>,
    /// Picture size in pixels
    #[arg(long, default_value_t = Size::of(&ViewOptions::default()), value_name = "WxH")]
    pub size: Size,
    /// Query points for each pixel and pass: N x N [default: the pilot's choice]
    #[arg(long, value_name = "N", value_parser = count(1..=64_u32))]
    pub samples: Option<u32>,
    /// Seed of all random numbers; the same seed gives the same picture
    #[arg(long, default_value_t = 1, value_name = "S", value_parser = seed)]
    pub seed: u64,
    #[command(flatten)]
    pub engine: EngineArgs,
    #[command(flatten)]
    pub light: LightArgs,
    /// What the picture should be, an OpenEXR file of the same size: says how far it is, and how many bounds hold
    #[arg(long, value_name = "FILE")]
    pub reference: Option<PathBuf>,
    /// Plots of the error against passes and against photons, an SVG file
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// A map of the pixels' bounds, relative, with a legend, an SVG file
    #[arg(long, value_name = "FILE")]
    pub error_map: Option<PathBuf>,
    /// Also write the picture after 1, 2, 4, 8, ... passes, with the number in its name
    #[arg(long)]
    pub snapshots: bool,
    /// Keep the state of the picture in this file: at the end, at Ctrl-C, and each minute
    #[arg(long, value_name = "FILE")]
    pub state: Option<PathBuf>,
    /// Go on from the state in the file of --state; the picture is byte for byte that of one run
    #[arg(long, requires = "state")]
    pub resume: bool,
    /// Make only every N-th pass, from pass I on, and no picture: its sums are kept in the file of --state, which a later run goes on with.
    /// `photoncube merge` adds the files of all shards up
    #[arg(long, value_name = "I/N", requires = "state", conflicts_with_all = ["output", "error_target", "reference", "plot", "error_map", "snapshots", "resume"])]
    pub shard: Option<Shard>,
}

impl ProgressiveArgs {
    /// The picture, which only a shard has not.
    pub fn output(&self) -> Option<&Path> {
        self.output.as_deref()
    }
}

fn parse_confidence(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    number
        .filter(|number| *number > 0.0 && *number < 1.0)
        .ok_or_else(|| "expected a number over 0 and below 1".to_owned())
}
