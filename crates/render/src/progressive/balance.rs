//! Chooses what a pass is made of: photons, view rays and shadow rays.
//!
//! The error of a picture has four parts, which fall with different work. Over n passes of squared radii that fall as i^(alpha - 1):
//!
//! - the gather's variance A, which depends on the photons in range alone: A n^-alpha / (2 - alpha);
//! - the squared bias, in proportion to r^4 and thus to the inverse squared photons p of a pass: B (p_0 / p)^2 n^(2 alpha - 2) / alpha^2;
//! - the variance V of the points in a pixel, of s view rays in as many cells: V / (s^1.5 n), as for an edge through the pixel;
//! - the variance D of the points on the lights, of s k shadow rays that are well separated: D / ((s k)^1.5 n).
//!
//! A pilot measures A, B, V and D on some rows of the picture. The choice is the one of least error among a grid of p, s and k, in the
//! time of 32 passes of three photons, four view rays and 16 shadow rays a pixel. All numbers are relative to a pixel's luminance, as
//! in relMSE. Nothing here depends on measured time, so the same scene and seed give the same choice.

use crate::estimate::Estimator;
use crate::image::{Image, relative_scale};
use crate::lighting::{DirectLight, Lighting, PhotonMaps, Radii};
use crate::metrics::luminance;
use crate::render::{Engine, Light, RenderError, Renderer};
use crate::scene::Scene;
use crate::trace::{TraceOptions, trace};
use crate::view::ViewOptions;

use super::{ProgressiveError, ProgressiveOptions};

/// The cost of a photon, a view ray with its gathers, and a shadow ray, in shadow rays: medians over five scenes of a fit to the user time of
/// passes with other options. The error is flat around the best choice, so a factor of two matters little.
const PHOTON: f64 = 6.0;
const VIEW_RAY: f64 = 10.0;
const SHADOW_RAY: f64 = 1.0;

/// The passes, and what one consists of for each pixel, that state the time in which the error is to be least.
const PASSES: f64 = 32.0;
const PHOTONS: f64 = 3.0;
const SAMPLES_PER_AXIS: u32 = 2;
const RAYS: u32 = 4;

/// The pixels that the pilot renders, at most, or one row.
const PILOT_PIXELS: u32 = 4096;
/// The photons of a map of the pilot, at most.
const PILOT_PHOTONS: u64 = 200_000;
/// The fewest photons of a pass.
const FEWEST_PHOTONS: f64 = 1000.0;

/// What a pass is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Balance {
    /// The least number of photons to store.
    pub photons: u64,
    /// The samples of a pixel on each axis.
    pub samples_per_axis: u32,
    /// The shadow rays from a query point to each light; without meaning where direct light is from the map.
    pub rays: u32,
}

/// The parts of a [`Balance`] that are given.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Given {
    /// The photons.
    pub photons: Option<u64>,
    /// The samples on each axis.
    pub samples_per_axis: Option<u32>,
    /// The shadow rays.
    pub rays: Option<u32>,
}

impl Balance {
    /// Chooses the parts that are not given by a pilot: two photon maps and five renderings of some rows, in f64, which cost about as much as
    /// two passes. `lighting` and `options` are those of the picture; their shadow rays and photons do not matter. Nothing is rendered
    /// where all parts are given.
    ///
    /// # Errors
    /// Tracing, the maps or rendering fail.
    pub fn choose(
        scene: &Scene,
        lighting: &Lighting,
        view: &ViewOptions,
        options: &ProgressiveOptions,
        given: Given,
    ) -> Result<Self, ProgressiveError> {
        let has_rays = matches!(lighting.direct, DirectLight::Rays(_));
        let given = Given {
            rays: if has_rays { given.rays } else { Some(1) },
            ..given
        };
        if let (Some(photons), Some(samples_per_axis), Some(rays)) =
            (given.photons, given.samples_per_axis, given.rays)
        {
            return Ok(Self {
                photons,
                samples_per_axis,
                rays,
            });
        }
        let pixels = f64::from(view.width) * f64::from(view.height);
        let pilot = Pilot {
            scene,
            lighting,
            view,
            photons: (PHOTONS * pixels).max(FEWEST_PHOTONS) as u64,
        };
        let parts = pilot.measure(options, has_rays)?;
        Ok(parts.least(pixels, options.alpha, given))
    }
}

/// The renderings from which the parts of the error are measured.
struct Pilot<'a> {
    scene: &'a Scene,
    lighting: &'a Lighting,
    view: &'a ViewOptions,
    photons: u64,
}

impl Pilot<'_> {
    fn measure(
        &self,
        options: &ProgressiveOptions,
        has_rays: bool,
    ) -> Result<Parts, ProgressiveError> {
        let photons = self.photons.min(PILOT_PHOTONS);
        // The seeds before those of the passes.
        let seeds = [1, 2].map(|back| options.seed.wrapping_sub(back));
        let mut maps = Vec::new();
        let mut radii = None;
        for seed in seeds {
            let found = trace(self.scene, &TraceOptions { photons, seed }, &|_| ())?;
            let radii = *radii.get_or_insert_with(|| {
                Radii::of(self.scene, &found, self.lighting, options.in_range)
            });
            maps.push(PhotonMaps::new(self.scene, found, self.lighting, radii)?);
        }
        let both = [Estimator::FixedRadius, Estimator::Halved(1)];
        let [first, second] =
            [&maps[0], &maps[1]].map(|maps| self.render(maps, seeds[0], 1, &both));
        let (first, second) = (first?, second?);
        let whole = &both[..1];
        let other = self.render(&maps[0], seeds[1], 1, whole)?;
        let points = half_square_of_difference(&first[0], &other[0]);
        let lights = match has_rays {
            false => 0.0,
            true => {
                let [many, others] = seeds.map(|seed| self.render(&maps[0], seed, RAYS, whole));
                let rest = half_square_of_difference(&many?[0], &others?[0]);
                // D (1 - RAYS^-1.5) is the difference. Noise may make it negative.
                ((points - rest) / (1.0 - separated(f64::from(RAYS)))).clamp(0.0, points)
            }
        };
        Ok(Parts {
            gather: half_square_of_difference(&first[0], &second[0]),
            bias_sq: product_of_biases(&first, &second),
            points: points - lights,
            lights,
            photons: photons as f64,
        })
    }

    /// Some rows of the picture by these maps.
    fn render(
        &self,
        maps: &PhotonMaps,
        seed: u64,
        rays: u32,
        estimators: &[Estimator],
    ) -> Result<Vec<Image>, RenderError> {
        let lighting = Lighting {
            direct: match self.lighting.direct {
                DirectLight::Map => DirectLight::Map,
                DirectLight::Rays(_) => DirectLight::Rays(rays),
            },
            ..*self.lighting
        };
        let light = Light {
            lighting: &lighting,
            global: &maps.global,
            caustic: maps.caustic.as_ref(),
            estimator: &Estimator::FixedRadius,
        };
        let view = ViewOptions {
            seed,
            samples_per_axis: 1,
            ..*self.view
        };
        let rows = (PILOT_PIXELS / view.width.max(1)).clamp(1, view.height.max(1));
        let renderer = Renderer::new(self.scene, light, Engine::F64, &view)?;
        renderer.render_rows(view.height / rows, estimators)
    }
}

/// The mean over the pixels of `of`, in the luminances of two pictures, over the squared luminance.
fn relative_mean(a: &Image, b: &Image, of: impl Fn(usize, f64, f64) -> f64) -> f64 {
    let pairs = a.pixels().iter().zip(b.pixels()).enumerate();
    let relative = pairs.map(|(index, (a, b))| {
        let [a, b] = [*a, *b].map(luminance);
        of(index, a, b) / relative_scale(0.5 * (a + b)).powi(2)
    });
    relative.sum::<f64>() / a.pixels().len().max(1) as f64
}

/// The relative variance of one of two independent pictures.
fn half_square_of_difference(a: &Image, b: &Image) -> f64 {
    relative_mean(a, b, |_, a, b| 0.5 * (a - b).powi(2))
}

/// The relative squared bias: the product of two independent estimates of it, which noise does not enlarge on average.
fn product_of_biases(first: &[Image], second: &[Image]) -> f64 {
    let bias = |images: &[Image], index: usize, whole: f64| {
        2.0 * (whole - luminance(images[1].pixels()[index]))
    };
    let product = |index, a, b| bias(first, index, a) * bias(second, index, b);
    relative_mean(&first[0], &second[0], product).max(0.0)
}

/// The parts of the error of one pass with one view ray and one shadow ray for each pixel, squared and relative.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Parts {
    gather: f64,
    /// With this many photons.
    bias_sq: f64,
    photons: f64,
    points: f64,
    lights: f64,
}

impl Parts {
    /// The error of passes of `balance` in the time, squared.
    fn error_sq(&self, balance: &Balance, pixels: f64, alpha: f64) -> f64 {
        let axis = f64::from(balance.samples_per_axis);
        let (samples, rays) = (axis * axis, f64::from(balance.rays));
        let photons = balance.photons as f64;
        let passes = PASSES * cost(PHOTONS * pixels, pixels, SAMPLES_PER_AXIS, RAYS)
            / cost(photons, pixels, balance.samples_per_axis, balance.rays);
        // A picture has a pass at least, and the errors of its parts are those of one pass.
        let passes = passes.max(1.0);
        let gather = self.gather * passes.powf(-alpha) / (2.0 - alpha);
        let shrunk = passes.powf(alpha - 1.0) / alpha;
        let bias_sq = self.bias_sq * (self.photons / photons * shrunk).powi(2);
        let view = self.points * separated(samples) + self.lights * separated(samples * rays);
        gather + bias_sq + view / passes
    }

    /// The balance of least error, with the parts that are given.
    fn least(&self, pixels: f64, alpha: f64, given: Given) -> Balance {
        let halves = (0..=12).map(|half| 0.25 * 2f64.powf(0.5 * f64::from(half)));
        let photons = given_or(given.photons, halves.map(|each| rounded(pixels * each)));
        let samples = given_or(given.samples_per_axis, 1..=4);
        let rays = given_or(given.rays, [1, 2, 3, 4, 6, 8, 12, 16]);
        let mut least: Option<(f64, Balance)> = None;
        for &photons in &photons {
            for &samples_per_axis in &samples {
                for &rays in &rays {
                    let balance = Balance {
                        photons,
                        samples_per_axis,
                        rays,
                    };
                    let error = self.error_sq(&balance, pixels, alpha);
                    if least.is_none_or(|(smallest, _)| error < smallest) {
                        least = Some((error, balance));
                    }
                }
            }
        }
        least.expect("the grid has points").1
    }
}

/// The values to choose from: the given one alone, or all of the grid.
fn given_or<T>(given: Option<T>, grid: impl IntoIterator<Item = T>) -> Vec<T> {
    given.map_or_else(|| grid.into_iter().collect(), |given| vec![given])
}

/// The variance of the mean of `points` points, each in a cell of its own, over that of one point: that of an edge through the cells.
fn separated(points: f64) -> f64 {
    points.powf(-1.5)
}

/// The cost of a pass, in shadow rays.
fn cost(photons: f64, pixels: f64, samples_per_axis: u32, rays: u32) -> f64 {
    let samples = pixels * f64::from(samples_per_axis).powi(2);
    PHOTON * photons + samples * (VIEW_RAY + SHADOW_RAY * f64::from(rays))
}

/// A number of photons of two figures.
fn rounded(photons: f64) -> u64 {
    let photons = photons.max(FEWEST_PHOTONS);
    let unit = 10f64.powf(photons.log10().floor() - 1.0);
    ((photons / unit).round() * unit) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    const PIXELS: f64 = 16384.0;
    const ALPHA: f64 = 2.0 / 3.0;
    const EVEN: Parts = Parts {
        gather: 0.01,
        bias_sq: 0.001,
        photons: 50_000.0,
        points: 0.02,
        lights: 0.02,
    };

    fn least(parts: Parts) -> Balance {
        parts.least(PIXELS, ALPHA, Given::default())
    }

    #[test]
    fn each_part_of_the_error_draws_work_to_itself() {
        let even = least(EVEN);
        let biased = least(Parts {
            bias_sq: 0.1,
            ..EVEN
        });
        assert!(biased.photons > even.photons, "{biased:?} {even:?}");
        let edges = least(Parts {
            points: 2.0,
            ..EVEN
        });
        assert!(
            edges.samples_per_axis > even.samples_per_axis,
            "{edges:?} {even:?}"
        );
        let shadows = least(Parts {
            lights: 2.0,
            ..EVEN
        });
        assert!(shadows.rays > even.rays, "{shadows:?} {even:?}");
        let none = least(Parts {
            lights: 0.0,
            ..EVEN
        });
        assert_eq!(none.rays, 1);
    }

    #[test]
    fn what_is_given_stays() {
        let given = Given {
            photons: Some(12_345),
            samples_per_axis: Some(7),
            rays: Some(5),
        };
        let found = EVEN.least(PIXELS, ALPHA, given);
        assert_eq!(
            (found.photons, found.samples_per_axis, found.rays),
            (12_345, 7, 5)
        );
        let one = Given {
            samples_per_axis: Some(3),
            ..Given::default()
        };
        assert_eq!(EVEN.least(PIXELS, ALPHA, one).samples_per_axis, 3);
    }

    #[test]
    fn the_pilot_finds_the_shadows_noise_and_is_repeatable() {
        let scene = Scene::built_in("cornell").unwrap();
        let lighting = Lighting {
            direct: DirectLight::Rays(1),
            ..Lighting::default()
        };
        let view = ViewOptions {
            width: 64,
            height: 64,
            ..ViewOptions::default()
        };
        let options = ProgressiveOptions::default();
        let pilot = Pilot {
            scene: &scene,
            lighting: &lighting,
            view: &view,
            photons: 12_000,
        };
        let parts = pilot.measure(&options, true).unwrap();
        // 100 photons in range, and powers that are about equal: the variance is about 1 / 100, less where light is of few paths.
        assert!(parts.gather > 0.001 && parts.gather < 0.03, "{parts:?}");
        // One shadow ray to a light that is a quarter of the ceiling's edge: far more noise than in the gather.
        assert!(parts.lights > 0.01 && parts.points > 0.0, "{parts:?}");
        assert_eq!(pilot.measure(&options, true).unwrap(), parts);
    }

    #[test]
    fn photons_are_rounded_to_two_figures() {
        assert_eq!(
            [12_345.6, 99_900.0, 3.0].map(rounded),
            [12_000, 100_000, 1000]
        );
    }
}
