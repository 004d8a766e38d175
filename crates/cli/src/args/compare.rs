//! The arguments of `compare`.

use std::path::PathBuf;

use clap::Args as ClapArgs;

/// `compare`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube render cornell -o model.exr --size 128x128
  photoncube compare model.exr docs/reference/cornell.exr
  photoncube render cornell -o f64.exr --size 128x128 --engine f64
  photoncube compare model.exr f64.exr --error-map error.svg --json

Pixels that see a light, and those that touch them, are left out: radiance over 5 in the reference.")]
pub struct CompareArgs {
    /// The picture, an OpenEXR file
    pub picture: PathBuf,
    /// What it should be, an OpenEXR file of the same size
    pub reference: PathBuf,
    /// A map of the relative error of the luminance, with a legend, an SVG file
    #[arg(long, value_name = "FILE")]
    pub error_map: Option<PathBuf>,
    /// Fail (exit code 1) where the relMSE is larger
    #[arg(long, value_name = "E", value_parser = super::numbers::positive)]
    pub max_rel_mse: Option<f64>,
}
