//! Chooses the machine of a run: the given one, or the one that the scene needs.

use anyhow::Result;
use photoncube_model::{GatherError, Limits};
use photoncube_render::{BenchOptions, FitOptions, QuantisedMap, largest_query, view_queries};
use photoncube_spec::{Machine, PHOTON_FORMATS, PhotonFormat};
use serde::Serialize;

use crate::args::RunArgs;
use crate::chains::{self, ChainsChoice};
use crate::cores::{self, CoreTime};
use crate::fitted::{self, FormatRow};
use crate::stages::{Traced, view};

/// The format that the scene needs, as the reason for the machine's widths.
#[derive(Serialize)]
pub struct Fitted {
    /// The bound of the error, as a fraction of the noise.
    pub noise_ratio: f64,
    /// The needed format; the machine may be wider.
    #[serde(flatten)]
    pub row: FormatRow,
    /// The cores for the scene.
    pub cores: Option<ChainsChoice>,
    /// The fastest core whose clock is measured and whose error is within the bound.
    pub fastest_core: Option<CoreTime>,
}

/// The given machine, or else the smallest machine for the scene's fit.
pub fn machine(args: &RunArgs, traced: &Traced) -> Result<(&'static Machine, Option<Fitted>)> {
    if let Some(machine) = args.machine.find()? {
        check_room(machine, args, traced)?;
        return Ok((machine, None));
    }
    let options = options(args, traced)?;
    let fit = fitted::fit_with_bar(&traced.scene, &options)?;
    let (chosen, choices) = fitted::format_and_machines(&fit, &options)?;
    let queries = view_queries(&traced.scene, &view(&args.picture))?;
    let fitted = Fitted {
        noise_ratio: options.noise_ratio,
        row: FormatRow::of(&chosen),
        cores: chains::choose(&fit, options.noise_ratio, traced.map(), &queries)?,
        fastest_core: cores::fastest_within(&fit, options.noise_ratio, traced.map(), &queries)?,
    };
    Ok((choices.smallest.machine, Some(fitted)))
}

/// Refuses a machine whose sums do not hold the picture's largest query, before anything is emitted.
fn check_room(machine: &Machine, args: &RunArgs, traced: &Traced) -> Result<()> {
    let Some(format) = machine.format() else {
        return Ok(());
    };
    let largest = largest_in_picture(format, args, traced)?;
    let checked = Limits::of(&machine.numbers)?.check_count(largest);
    Ok(checked.map_err(GatherError::from)?)
}

/// The photons of the picture's largest query, in blocks of a format.
fn largest_in_picture(format: &PhotonFormat, args: &RunArgs, traced: &Traced) -> Result<u64> {
    let queries = view_queries(&traced.scene, &view(&args.picture))?;
    let map = traced.map();
    let map = map.reblocked(QuantisedMap::edge_for(format, map.radius()))?;
    Ok(largest_query(&map, &queries))
}

/// The options of the fit: the defaults of `fit` with the run's seed and photons in range, and no more
/// photons than the run has. The sums hold the picture's own queries.
fn options(args: &RunArgs, traced: &Traced) -> Result<FitOptions> {
    let options = FitOptions::default();
    let (bench, picture) = (options.bench, &args.picture);
    let bench = BenchOptions {
        photons: bench.photons.min(picture.photons),
        in_range: picture.in_range,
        maps: args.maps,
        seed: picture.seed,
        ..bench
    };
    Ok(FitOptions {
        bench,
        largest_query: largest_in_picture(&coarsest(), args, traced)?,
        ..options
    })
}

/// The format with the largest blocks for its radius, which has the largest queries.
fn coarsest() -> PhotonFormat {
    PhotonFormat {
        position_bits: 4,
        query_extra_bits: 0,
        ..PHOTON_FORMATS[0]
    }
}
