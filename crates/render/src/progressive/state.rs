//! The state of a progressive picture after some passes, from which more passes can be made at another time.

use glam::DVec3;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::Progressive;
use super::pixel::Pixel;
use super::uniformity::Uniformity;
use crate::lighting::Radii;
use crate::metrics::Moments;
use crate::render::RenderStats;

/// The numbers of a pixel.
const NUMBERS: usize = 12;

/// All that later passes and the error's estimate need of the passes so far. The numbers are those of the sums, not
/// rounded, so a picture that is interrupted and continued is bit for bit the picture of one run.
///
/// Scene, engine, lighting, view and options are not part of it: the caller must give the same ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ProgressiveState {
    passes: u64,
    photons: u64,
    radii: Option<Radii>,
    shrunk_sq: f64,
    stats: RenderStats,
    pixels: Vec<[f64; NUMBERS]>,
    uniformity: Vec<Uniformity>,
}

impl ProgressiveState {
    /// The number of passes made.
    #[must_use]
    pub fn passes(&self) -> u64 {
        self.passes
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
    pub fn state(&self) -> ProgressiveState {
        ProgressiveState {
            passes: self.passes,
            photons: self.photons,
            radii: self.radii,
            shrunk_sq: self.shrunk_sq,
            stats: self.stats,
            pixels: self.pixels.iter().map(Pixel::numbers).collect(),
            uniformity: self.uniformity.clone(),
        }
    }

    /// Takes over a state, as if its passes had been made here.
    ///
    /// # Errors
    /// The state has another number of pixels.
    pub fn resume(&mut self, state: &ProgressiveState) -> Result<(), OtherPicture> {
        let expected = match state.passes {
            0 => 0,
            _ => self.view.width as usize * self.view.height as usize,
        };
        let found = state.pixels.len();
        if found != expected {
            return Err(OtherPicture { found, expected });
        }
        let pixel = |numbers: &[f64; NUMBERS]| Pixel::of_numbers(numbers, state.passes);
        self.pixels = state.pixels.iter().map(pixel).collect();
        (self.passes, self.photons) = (state.passes, state.photons);
        (self.radii, self.shrunk_sq) = (state.radii, state.shrunk_sq);
        self.stats = state.stats;
        self.uniformity = state.uniformity.clone();
        Ok(())
    }
}

impl Pixel {
    /// The two sums and, of each of the moments, the mean and the squares. Each has as many values as there were passes.
    fn numbers(&self) -> [f64; NUMBERS] {
        let sums = [self.sum, self.inner_sum].map(|sum| sum.to_array());
        let moments = [&self.plain, &self.corrected, &self.bias];
        let moments = moments.map(|moments| <[f64; 2]>::from(moments.mean_and_squares()));
        let all = sums.as_flattened().iter().chain(moments.as_flattened());
        let mut numbers = [0.0; NUMBERS];
        numbers
            .iter_mut()
            .zip(all)
            .for_each(|(to, from)| *to = *from);
        numbers
    }

    fn of_numbers(numbers: &[f64; NUMBERS], passes: u64) -> Self {
        let [sum, inner_sum] = [0, 3].map(|at| DVec3::from_slice(&numbers[at..]));
        let moments = [6, 8, 10].map(|at| Moments::of(passes, numbers[at], numbers[at + 1]));
        let [plain, corrected, bias] = moments;
        Self {
            sum,
            inner_sum,
            plain,
            corrected,
            bias,
        }
    }
}
