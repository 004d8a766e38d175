//! The state of a progressive picture after some passes, from which more passes can be made at another time, or which is merged with
//! those of other passes.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::Progressive;
use super::sums::Sums;
use super::uniformity::Uniformity;
use crate::lighting::Radii;
use crate::render::RenderStats;

/// All that later passes and the error's estimate need of the passes so far. The sums are exact, so a picture that is interrupted and
/// continued, and one whose passes several computers made, are bit for bit the picture of one run.
///
/// Scene, engine, lighting, view and options are not in it: the caller must give the same ones. That of a [`Progressive`] refers to its
/// sums; one that is read has sums of its own.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ProgressiveState<'a> {
    passes: u64,
    photons: u64,
    radii: Option<Radii>,
    stats: RenderStats,
    pixels: Cow<'a, [Sums]>,
    uniformity: Cow<'a, [Uniformity]>,
}

impl<'a> ProgressiveState<'a> {
    /// The number of passes made.
    #[must_use]
    pub fn passes(&self) -> u64 {
        self.passes
    }

    /// Adds other passes of the same picture. The order of such additions makes no difference.
    ///
    /// # Errors
    /// The other state has another number of pixels. Nothing is added then.
    pub fn merge(&mut self, other: Self) -> Result<(), OtherPicture> {
        if self.passes == 0 {
            *self = other;
        } else if other.passes > 0 {
            let (found, expected) = (other.pixels.len(), self.pixels.len());
            if found != expected {
                return Err(OtherPicture { found, expected });
            }
            self.passes += other.passes;
            self.photons += other.photons;
            self.stats += other.stats;
            // A part that ended before the first caustic does not know its radius.
            let knows = |radii: &Option<Radii>| radii.is_some_and(|radii| radii.caustic.is_some());
            if !knows(&self.radii) {
                self.radii = other.radii;
            }
            let pixels = self.pixels.to_mut().iter_mut().zip(&*other.pixels);
            pixels.for_each(|(to, from)| *to += *from);
        }
        Ok(())
    }
}

/// A state that is not one of this picture.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("found the state of {found} pixels, expected {expected}")]
pub struct OtherPicture {
    /// The number of pixels in the state.
    pub found: usize,
    /// The number of pixels of the picture.
    pub expected: usize,
}

impl Progressive<'_> {
    /// The state after the passes so far.
    #[must_use]
    pub fn state(&self) -> ProgressiveState<'_> {
        ProgressiveState {
            passes: self.pixels.passes,
            photons: self.photons,
            radii: self.radii,
            stats: self.stats,
            pixels: Cow::Borrowed(&self.pixels.sums),
            uniformity: Cow::Borrowed(&self.uniformity),
        }
    }

    /// Takes over a state, as if its passes had been made here.
    ///
    /// # Errors
    /// The state has another number of pixels.
    pub fn resume(&mut self, state: ProgressiveState<'_>) -> Result<(), OtherPicture> {
        let expected = match state.passes {
            0 => 0,
            _ => self.view.width as usize * self.view.height as usize,
        };
        let found = state.pixels.len();
        if found != expected {
            return Err(OtherPicture { found, expected });
        }
        self.pixels.passes = state.passes;
        self.pixels.sums = state.pixels.into_owned();
        (self.photons, self.radii) = (state.photons, state.radii);
        // As many passes from the first on were searched at least, whichever they are.
        self.searched = state.passes;
        self.stats = state.stats;
        self.uniformity = state.uniformity.into_owned();
        Ok(())
    }
}
