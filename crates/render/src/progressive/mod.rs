//! Progressive photon mapping: pictures of independent photon maps with falling radius. Their mean has
//! neither noise nor bias in the limit. Memory does not depend on the number of passes.
//!
//! Knaus and Zwicker, "Progressive Photon Mapping: A Probabilistic Approach" (2011): with radii by
//! r_(i+1)^2 = r_i^2 (i + alpha) / (i + 1), 0 < alpha < 1, the variance of the mean of i pictures
//! falls as i^-alpha and its bias as i^(alpha - 1). Passes are independent of one another, so a pass is a
//! picture as [`crate::render_lit`] makes it, by any engine.
//!
//! # Where light is sharp
//! By the chi-square rule ([`RadiusRule::ChiSquare`]) each pixel has a radius of its own in the global map. It stays while the pixel's photons
//! are spread evenly and falls where they are not; see `uniformity.rs`. All passes then have the radius of the first, of which the
//! pixels take a half, a quarter, ... of the square. It is for maps that carry the caustics.
//!
//! # The error's estimate
//! After Hachisuka, Jarosz and Jensen, "A Progressive Error Estimation Framework for Photon Density
//! Estimation" (2010): the error is the sum of a bias, which is estimated, and of noise, which the spread of
//! bias-corrected pictures bounds with a stated confidence. They compute the bias from derivatives of a
//! smooth kernel. We compute it from a second gather of the same photons, at half the squared radius, because
//! the rectangle is the kernel that a machine has. The leading term of the bias is proportional to r^2 (for a
//! smooth irradiance E, r^2 / 8 times its Laplacian). So with x the estimate at r and y the estimate at r /
//! sqrt 2:
//!
//! - b = 2 (x - y) estimates the bias of x, and c = x - b = 2 y - x has none (Richardson's extrapolation). With S the power in
//!   range and S_in that at half the squared radius, c = (4 S_in - S) / (pi r^2), from the sums of two rings.
//! - Where the mean of b over n passes is significant, 3.5 standard deviations or as improbable by Student's distribution of n - 1
//!   degrees, the picture has the mean of c. Elsewhere it has the mean of x, which has less noise.
//! - The noise is s / sqrt n, where s^2 is the variance over the passes of what the picture has. The squared bias over the
//!   squared luminance is the mean of that over the 3 x 3 pixels around, less what noise contributes; a quarter of it in a corrected
//!   pixel.
//! - A pixel's error is below sqrt((t noise)^2 + 2 (u bias)^2) with confidence C, where t is the two-sided quantile of Student's
//!   distribution and u that of the normal distribution. The bound of the picture is sqrt(noise^2 + 2 bias^2), with the root mean
//!   squares over the pixels, each over its luminance.
//!
//! Where the irradiance jumps within the radius, as at the border of a shadow, the bias does not fall with r^2. A pixel at the jump
//! itself shows none of it, its neighbours show a part. This is why the squared bias is a mean over neighbours and counts twice.
//! Where black meets light, a pixel's luminance is mostly leaked light; the relative error is therefore taken over the luminance
//! less the bias.

mod balance;
mod error;
mod pixel;
mod rule;
mod state;
mod sums;
mod uniformity;

use glam::DVec3;
use thiserror::Error;

pub use self::balance::{Balance, Given};
pub use self::error::{ErrorEstimate, PixelBound};
pub use self::rule::{RadiusRule, UnknownRadiusRule};
pub use self::state::{OtherPicture, ProgressiveState};

use self::pixel::significant_ratio;
use self::sums::Pixels;
use self::uniformity::Uniformity;
use crate::estimate::Estimator;
use crate::image::Image;
use crate::lighting::{Caustics, Lighting, PhotonMaps, Radii};
use crate::metrics::Moments;
use crate::photon_map::MapError;
use crate::render::{Engine, Light, RenderError, RenderStats, Renderer};
use crate::scene::{Scene, Surface};
use crate::trace::{PhotonTrace, TraceError, TraceOptions, trace};
use crate::view::ViewOptions;

/// The schedule of the radii, and the photons of each pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProgressiveOptions {
    /// The least number of photons to store in each pass.
    pub photons: u64,
    /// The number of photons in range for which the radius of the first pass is chosen, on average.
    pub in_range: f64,
    /// The share of a pass' photons that reduces noise rather than bias: over 0, below 1.
    pub alpha: f64,
    /// The seed of the first pass; each next pass has the next seed.
    pub seed: u64,
    /// How the radii in the global map fall. In a caustics' map of its own they fall by the schedule.
    pub rule: RadiusRule,
}

/// 200,000 photons a pass, 100 of them in range at first, alpha 2/3, with which noise and bias fall as i^(-1/3) each.
impl Default for ProgressiveOptions {
    fn default() -> Self {
        Self {
            photons: 200_000,
            in_range: 100.0,
            alpha: 2.0 / 3.0,
            seed: 1,
            rule: RadiusRule::Schedule,
        }
    }
}

/// The reason why a pass failed.
#[derive(Debug, Error)]
pub enum ProgressiveError {
    /// A factor with which the radius would grow, or fall too fast.
    #[error("alpha: found {found}, expected a number over 0 and below 1")]
    Alpha {
        /// The factor that was given.
        found: f64,
    },
    /// A pass by the chi-square rule that is not the next.
    #[error(
        "found pass {pass}, expected the next, {next}: by the radius rule chi-square passes depend on those before them"
    )]
    Order {
        /// The pass to make.
        pass: u64,
        /// The next pass.
        next: u64,
    },
    /// Tracing gave no photons.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The photons make no map.
    #[error(transparent)]
    Map(#[from] MapError),
    /// No picture could be rendered.
    #[error(transparent)]
    Render(#[from] RenderError),
}

/// A picture that improves with every pass.
pub struct Progressive<'a> {
    scene: &'a Scene,
    engine: Engine<'a>,
    lighting: Lighting,
    view: ViewOptions,
    options: ProgressiveOptions,
    /// The radii of the first pass.
    radii: Option<Radii>,
    /// The number of passes, from the first on, in whose photons caustics were looked for.
    searched: u64,
    photons: u64,
    stats: RenderStats,
    pixels: Pixels,
    /// The radii of the pixels by the chi-square rule; empty by the schedule, and before the first pass.
    uniformity: Vec<Uniformity>,
}

impl<'a> Progressive<'a> {
    /// A picture without passes. The estimates are those of [`Estimator::FixedRadius`].
    ///
    /// # Errors
    /// Alpha is outside 0 to 1.
    pub fn new(
        scene: &'a Scene,
        engine: Engine<'a>,
        lighting: Lighting,
        view: ViewOptions,
        options: ProgressiveOptions,
    ) -> Result<Self, ProgressiveError> {
        if !(options.alpha > 0.0 && options.alpha < 1.0) {
            let found = options.alpha;
            return Err(ProgressiveError::Alpha { found });
        }
        Ok(Self {
            scene,
            engine,
            lighting,
            view,
            options,
            radii: None,
            searched: 0,
            photons: 0,
            stats: RenderStats::default(),
            pixels: Pixels::new(scene),
            uniformity: Vec::new(),
        })
    }

    /// Makes one more pass: photons, maps, a picture.
    ///
    /// # Errors
    /// Tracing, the maps or rendering fail.
    pub fn pass(&mut self) -> Result<(), ProgressiveError> {
        self.make(self.passes())
    }

    /// Makes the pass of that number, from 0, which need not be the next: several computers may make a part of the passes each, in
    /// rising order, and merge their states.
    ///
    /// # Errors
    /// Tracing, the maps or rendering fail. By the chi-square rule the radii of a pass depend on all passes before it, so it must be the
    /// next.
    pub fn make(&mut self, pass: u64) -> Result<(), ProgressiveError> {
        let next = self.passes();
        if self.options.rule == RadiusRule::ChiSquare && pass != next {
            return Err(ProgressiveError::Order { pass, next });
        }
        let trace = self.trace(pass)?;
        let first = self.radii(pass, &trace)?;
        let radii = Radii {
            global: first.global * self.shrunk(pass),
            ..first.scaled(self.scheduled(pass))
        };
        let maps = PhotonMaps::new(self.scene, trace, &self.lighting, radii)?;
        self.photons += maps.photons() as u64;
        self.add(&maps, self.seed(pass))?;
        Ok(())
    }

    /// The seed of a pass, the first of which is 0.
    fn seed(&self, pass: u64) -> u64 {
        self.options.seed.wrapping_add(pass)
    }

    fn trace(&self, pass: u64) -> Result<PhotonTrace, TraceError> {
        let options = TraceOptions {
            photons: self.options.photons,
            seed: self.seed(pass),
        };
        trace(self.scene, &options, &|_| ())
    }

    /// The radii of the first pass, as they are known at a pass whose photons are given. Those of the passes before it that other
    /// computers make are traced here too, until a caustic is found.
    fn radii(&mut self, pass: u64, photons: &PhotonTrace) -> Result<Radii, TraceError> {
        for before in self.searched..pass {
            if self.radii.is_some_and(|radii| self.is_complete(radii)) {
                break;
            }
            let trace = self.trace(before)?;
            self.find_radii(&trace);
        }
        self.searched = pass + 1;
        Ok(self.find_radii(photons))
    }

    /// Whether no later pass changes the radii: the caustics' is found, or there is none.
    fn is_complete(&self, radii: Radii) -> bool {
        let mut surfaces = self.scene.surfaces().iter();
        let is_own = matches!(self.lighting.caustics, Caustics::Own(_));
        radii.caustic.is_some() || !is_own || !surfaces.any(Surface::is_specular)
    }

    fn find_radii(&mut self, trace: &PhotonTrace) -> Radii {
        let of = || Radii::of(self.scene, trace, &self.lighting, self.options.in_range);
        let radii = self.radii.get_or_insert_with(of);
        radii.find_caustic(trace, &self.lighting);
        *radii
    }

    /// Renders a pass at both radii and adds it to the pixels.
    fn add(&mut self, maps: &PhotonMaps, seed: u64) -> Result<(), RenderError> {
        let halvings = self.halvings();
        let light = Light {
            lighting: &self.lighting,
            global: &maps.global,
            caustic: maps.caustic.as_ref(),
            estimator: &Estimator::FixedRadius,
        };
        let view = ViewOptions { seed, ..self.view };
        let renderer = Renderer::new(self.scene, light, self.engine, &view)?;
        let renderer = match self.options.rule {
            RadiusRule::Schedule => renderer,
            RadiusRule::ChiSquare => renderer.with_halvings(&halvings),
        };
        let rendered = renderer.render(&[Estimator::FixedRadius, Estimator::Halved(1)], &|_| ())?;
        let [whole, inner] = [0, 1].map(|index| rendered.images[index].pixels());
        self.pixels.push(whole, inner);
        self.stats += rendered.stats;
        let most = renderer.most_halvings();
        for (pixel, sectors) in self.uniformity.iter_mut().zip(&rendered.sectors) {
            pixel.push(sectors, most);
        }
        Ok(())
    }

    /// The global radius of a pass over that of the first. By the chi-square rule it stays, and pixels have smaller ones.
    fn shrunk(&self, pass: u64) -> f64 {
        match self.options.rule {
            RadiusRule::Schedule => self.scheduled(pass),
            RadiusRule::ChiSquare => 1.0,
        }
    }

    /// The radius of a pass over that of the first, by the schedule.
    fn scheduled(&self, pass: u64) -> f64 {
        let before = (1..=pass).map(|pass| pass as f64);
        let factors = before.map(|pass| (pass + self.options.alpha) / (pass + 1.0));
        factors.product::<f64>().sqrt()
    }

    /// How many times the squared radius of each pixel is halved in the next pass.
    fn halvings(&mut self) -> Vec<u8> {
        let pixels = match self.options.rule {
            RadiusRule::Schedule => 0,
            RadiusRule::ChiSquare => self.view.width as usize * self.view.height as usize,
        };
        self.uniformity.resize(pixels, Uniformity::default());
        let halvings = self.uniformity.iter().map(|pixel| pixel.halvings);
        halvings.collect()
    }

    /// How many times the squared radius of a pixel is halved by the chi-square rule, on average; `None` by the schedule, and before
    /// the first pass.
    #[must_use]
    pub fn halvings_mean(&self) -> Option<f64> {
        let halvings = self.uniformity.iter().map(|pixel| pixel.halvings.into());
        let mean = halvings.collect::<Moments>().mean();
        (!self.uniformity.is_empty()).then_some(mean)
    }

    /// The number of passes made.
    #[must_use]
    pub fn passes(&self) -> u64 {
        self.pixels.passes
    }

    /// The number of photons in the maps of all passes.
    #[must_use]
    pub fn photons(&self) -> u64 {
        self.photons
    }

    /// The radius of the last pass, where all before it are made, in scene units; `None` before the first. By the chi-square rule it is the largest of a pixel.
    #[must_use]
    pub fn radius(&self) -> Option<f64> {
        let last = self.passes().checked_sub(1)?;
        Some(self.radii?.global * self.shrunk(last))
    }

    /// The statistics of the work of all passes.
    #[must_use]
    pub fn stats(&self) -> RenderStats {
        self.stats
    }

    /// The picture, the mean of all passes, with the bias taken off where it is significant; black before the first.
    #[must_use]
    pub fn image(&self) -> Image {
        let pixels = match self.passes() {
            0 => vec![DVec3::ZERO; self.view.width as usize * self.view.height as usize],
            passes => {
                let ratio = significant_ratio(passes);
                let pixels = self.pixels.iter();
                pixels.map(|pixel| pixel.radiance(ratio)).collect()
            }
        };
        Image::from_rows(self.view.width, pixels)
    }

    /// The estimate of the picture's error; `None` before the second pass. `confidence` is over 0 and below
    /// 1.
    #[must_use]
    pub fn error(&self, confidence: f64) -> Option<ErrorEstimate> {
        ErrorEstimate::of(&self.pixels, self.view.width as usize, confidence)
    }
}

#[cfg(test)]
mod tests;
