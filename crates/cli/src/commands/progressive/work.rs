//! Makes the passes of a picture, and writes what comes of them.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};
use photoncube_render::{ErrorEstimate, Image, Progressive, error_map, luminance};

use super::kept::{self, Keeper, Kept};
use super::{End, Row};
use crate::args::ProgressiveArgs;
use crate::interrupt::Interrupt;
use crate::plots::{Curve, convergence_plot};
use crate::stages::{Distance, write_picture};
use crate::{files, progress};

/// The time between two writings of the state while the passes go on.
pub const KEPT_EVERY: Duration = Duration::from_secs(60);

/// The passes of a picture, and what is kept of them.
pub struct Work<'a> {
    pub args: &'a ProgressiveArgs,
    /// The picture.
    pub output: &'a Path,
    pub progressive: Progressive<'a>,
    pub reference: Option<Image>,
    pub start: Instant,
    /// The time of the passes that were made before this run.
    pub seconds_before: f64,
    /// The rows after 1, 2, 4, 8, ... passes and after the last.
    pub rows: Vec<Row>,
    /// The files that were written.
    pub files: Vec<String>,
    pub keeper: Option<Keeper>,
}

impl Work<'_> {
    /// Takes over the state of an earlier run, if that is asked for.
    pub fn resume(&mut self) -> Result<()> {
        let Some(keeper) = &self.keeper else {
            return Ok(());
        };
        if !self.args.resume {
            return keeper.check_new();
        }
        let kept = keeper.read()?;
        let (passes, all) = (kept.state.passes(), self.args.passes);
        ensure!(
            passes <= all,
            "{}: found {passes} passes, expected at most --passes {all}",
            keeper.path().display()
        );
        self.seconds_before = kept.seconds;
        self.rows = kept.rows_for(self.reference.as_ref());
        self.progressive.resume(kept.state)?;
        Ok(())
    }

    /// Makes passes until there are enough. A new picture gets at least one.
    pub fn run(&mut self, interrupt: &Interrupt) -> Result<End> {
        let bar = progress::bar("passes", self.args.passes);
        bar.set_position(self.progressive.passes());
        let mut end = None;
        if self.progressive.passes() > 0 {
            // The passes that were made before may be enough.
            end = self.ended(interrupt)?;
        }
        let mut kept = Instant::now();
        while end.is_none() {
            self.progressive.pass()?;
            bar.set_position(self.progressive.passes());
            end = self.ended(interrupt)?;
            if end.is_some() || kept.elapsed() >= KEPT_EVERY {
                self.keep()?;
                kept = Instant::now();
            }
        }
        bar.finish_and_clear();
        end.context("a picture has an end")
    }

    /// Whether the passes so far are enough. Adds their row to the table where it has a place there.
    fn ended(&mut self, interrupt: &Interrupt) -> Result<Option<End>> {
        let error = self.progressive.error(self.args.confidence);
        let end = self.end(error.as_ref(), interrupt);
        if self.progressive.passes().is_power_of_two() || end.is_some() {
            self.push_row(error.as_ref())?;
        }
        Ok(end)
    }

    /// Writes the state.
    fn keep(&self) -> Result<()> {
        let Some(keeper) = &self.keeper else {
            return Ok(());
        };
        let reference = self.reference.as_ref();
        keeper.write(&Kept {
            state: self.progressive.state(),
            rows: self.rows.clone(),
            reference: reference.map(kept::sha256_of_image),
            seconds: self.seconds(),
        })
    }

    fn seconds(&self) -> f64 {
        self.seconds_before + self.start.elapsed().as_secs_f64()
    }

    fn end(&self, error: Option<&ErrorEstimate>, interrupt: &Interrupt) -> Option<End> {
        let is_below =
            |error: &ErrorEstimate, target| error.bound() <= target && !error.is_ruled_by_bias();
        let below = |target| error.is_some_and(|error| is_below(error, target));
        if self.args.error_target.is_some_and(below) {
            Some(End::Reached)
        } else if self.progressive.passes() >= self.args.passes {
            Some(End::Passes)
        } else {
            interrupt.is_asked().then_some(End::Interrupted)
        }
    }

    fn push_row(&mut self, error: Option<&ErrorEstimate>) -> Result<()> {
        let (passes, image) = (self.progressive.passes(), self.progressive.image());
        if self.args.snapshots {
            let path = snapshot(self.output, passes);
            write_picture(&image, &path)?;
            self.files.push(path.display().to_string());
        }
        let reference = self.reference.as_ref();
        let distance = reference.map(|reference| Distance::between(&image, reference));
        let bounded = reference.zip(error).and_then(|(reference, error)| {
            let truth = reference.pixels().iter().map(|rgb| luminance(*rgb));
            error.bounded(&truth.collect::<Vec<_>>())
        });
        self.rows.push(Row {
            passes,
            photons: self.progressive.photons(),
            search_radius: self.progressive.radius().unwrap_or_default(),
            error_bound: error.map(ErrorEstimate::bound),
            estimated_bias: error.map(ErrorEstimate::bias),
            estimated_noise: error.map(ErrorEstimate::noise),
            rel_mse: distance.transpose()?.map(|distance| distance.rel_mse),
            bounded_share: bounded,
            seconds: self.seconds(),
        });
        Ok(())
    }

    pub fn write_plot(&mut self, scene: &str) -> Result<()> {
        let Some(path) = &self.args.plot else {
            return Ok(());
        };
        let curve = |name, of: fn(&Row) -> Option<f64>| Curve {
            name,
            points: self
                .rows
                .iter()
                .filter_map(|row| Some(row.reached(of(row)?)))
                // The logarithm of 0 cannot be drawn.
                .filter(|reached| reached.error > 0.0)
                .collect(),
        };
        let curves = [
            curve("bound", |row| row.error_bound),
            curve("estimated bias", |row| row.estimated_bias),
            curve("estimated noise", |row| row.estimated_noise),
            curve("error against the reference", |row| {
                row.rel_mse.map(f64::sqrt)
            }),
        ];
        let title = format!("How the error of {scene} falls with passes and photons",);
        files::write(path, convergence_plot(&title, &curves)?.as_bytes())?;
        self.files.push(path.display().to_string());
        Ok(())
    }

    pub fn write_error_map(&mut self, scene: &str) -> Result<()> {
        let error = self.progressive.error(self.args.confidence);
        let (Some(path), Some(error)) = (&self.args.error_map, error) else {
            return Ok(());
        };
        let bounds: Vec<_> = error
            .pixels
            .iter()
            .map(|p| Some(p.relative_error()))
            .collect();
        let title = format!(
            "bound of the relative error, {:.0} % confidence: {scene}",
            100.0 * error.confidence,
        );
        files::write(
            path,
            error_map(&title, self.args.size.width, &bounds).as_bytes(),
        )?;
        self.files.push(path.display().to_string());
        Ok(())
    }
}

/// The name of a snapshot: `box-0008.png` for `box.png` after 8 passes.
pub fn snapshot(output: &Path, passes: u64) -> PathBuf {
    let stem = output.file_stem().unwrap_or_default().to_string_lossy();
    let ending = output.extension().unwrap_or_default().to_string_lossy();
    output.with_file_name(format!("{stem}-{passes:04}.{ending}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapshots_are_named_by_their_passes() {
        let name = snapshot(Path::new("out/box.png"), 8);
        assert_eq!(name, Path::new("out/box-0008.png"));
    }
}
