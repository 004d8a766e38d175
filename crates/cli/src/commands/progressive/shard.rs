//! A shard of a picture: a part of its passes, whose sums are kept and no picture is made.

use std::path::Path;
use std::time::Instant;

use anyhow::{Context, Result};
use photoncube_render::Progressive;
use serde::Serialize;

use super::NAME;
use super::kept::{Keeper, Kept};
use super::setup::Setup;
use super::work::KEPT_EVERY;
use crate::args::ProgressiveArgs;
use crate::failure::CheckFailed;
use crate::interrupt::Interrupt;
use crate::shards::{Header, Shard};
use crate::{output, progress};

#[derive(Serialize)]
struct Report {
    scene: String,
    shard: String,
    /// The passes of all shards.
    passes: u64,
    /// Those in the state.
    passes_made: u64,
    /// Those that were in the state at the start.
    resumed_passes: u64,
    photons: u64,
    state: String,
    interrupted: bool,
}

/// Makes the passes of a shard that its state lacks.
pub fn execute(args: &ProgressiveArgs, setup: &Setup<'_>, shard: Shard, json: bool) -> Result<()> {
    let path = args.state.as_deref().context("a shard has a state")?;
    let header = Header::new(NAME, setup.settings(args), Some(args.passes), shard);
    let keeper = Keeper::new(path.to_owned(), header);
    let mut picture = setup.picture()?;
    if path.exists() {
        picture.resume(keeper.read()?.state)?;
    }
    let resumed_passes = picture.passes();
    let interrupted = make(&mut picture, &keeper, shard, args.passes)?;
    let report = Report {
        scene: args.scene.to_string(),
        shard: shard.to_string(),
        passes: args.passes,
        passes_made: picture.passes(),
        resumed_passes,
        photons: picture.photons(),
        state: path.display().to_string(),
        interrupted,
    };
    output::print(json, &report, || text(&report, path))?;
    match interrupted {
        true => Err(CheckFailed(format!(
            "interrupted after {} passes of shard {shard}; the same command goes on",
            report.passes_made
        ))
        .into()),
        false => Ok(()),
    }
}

/// Makes the passes, and keeps them each minute and at the end. Returns whether a signal ended it.
fn make(picture: &mut Progressive<'_>, keeper: &Keeper, shard: Shard, passes: u64) -> Result<bool> {
    let interrupt = Interrupt::watch()?;
    let mine = shard.jobs(passes);
    let bar = progress::bar("passes", shard.number_of_jobs(passes));
    bar.set_position(picture.passes());
    let mut kept = Instant::now();
    let mut is_asked = false;
    for pass in mine.skip(picture.passes() as usize) {
        is_asked = interrupt.is_asked();
        if is_asked {
            break;
        }
        picture.make(pass)?;
        bar.inc(1);
        if kept.elapsed() >= KEPT_EVERY {
            keep(picture, keeper)?;
            kept = Instant::now();
        }
    }
    bar.finish_and_clear();
    keep(picture, keeper)?;
    Ok(is_asked)
}

/// Writes the state. It has no times and no table, so that it depends on the passes alone.
fn keep(picture: &Progressive<'_>, keeper: &Keeper) -> Result<()> {
    keeper.write(&Kept {
        state: picture.state(),
        rows: Vec::new(),
        reference: None,
        seconds: 0.0,
    })
}

fn text(report: &Report, path: &Path) -> String {
    format!(
        "{}, shard {}: {} of its passes are in {}; `photoncube merge` adds the shards up\n",
        report.scene,
        report.shard,
        report.passes_made,
        path.display()
    )
}
