//! The command `compare`: measures the difference of two pictures.

use anyhow::Result;
use photoncube_render::Image;
use serde::Serialize;

use crate::args::CompareArgs;
use crate::failure::CheckFailed;
use crate::narrow::narrow;
use crate::outputs::{self, Output};
use crate::stages::{Distance, map_of};
use crate::{files, output};

#[derive(Serialize)]
struct Report {
    picture: String,
    reference_picture: String,
    #[serde(flatten)]
    distance: Distance,
    error_map: Option<String>,
}

/// Compares two files.
pub fn execute(args: &CompareArgs, json: bool) -> Result<()> {
    let map = args.error_map.iter();
    let outputs: Vec<_> = map.map(|path| Output::plot("--error-map", path)).collect();
    outputs::check(&outputs, &[args.picture.clone(), args.reference.clone()])?;
    let image = Image::read_exr(&args.picture)?;
    let reference = Image::read_exr(&args.reference)?;
    let distance = Distance::between(&image, &reference)?;
    let [picture, reference_picture] =
        [&args.picture, &args.reference].map(|path| path.display().to_string());
    if let Some(path) = &args.error_map {
        let title = format!("relative error: {picture} against {reference_picture}");
        files::write(path, map_of(&image, &reference, &title).as_bytes())?;
    }
    let report = Report {
        picture,
        reference_picture,
        distance,
        error_map: args.error_map.as_ref().map(|p| p.display().to_string()),
    };
    output::print(json, &report, || narrow(&text(&report)))?;
    match args.max_rel_mse {
        Some(max) if distance.rel_mse > max => Err(CheckFailed(format!(
            "{}: found a relMSE of {:.3e}, expected at most {max:.3e}",
            report.picture, distance.rel_mse
        ))
        .into()),
        _ => Ok(()),
    }
}

fn text(report: &Report) -> String {
    let d = report.distance;
    let mut text = format!(
        "{} against {}: relMSE {:.3e}, {:.3} % rms relative error, RMSE {:.3e}\n",
        report.picture,
        report.reference_picture,
        d.rel_mse,
        100.0 * d.rms_relative_error,
        d.rmse,
    );
    if let Some(map) = &report.error_map {
        text += &format!("error map: {map}\n");
    }
    text
}
