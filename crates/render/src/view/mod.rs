//! Stage 4: supersampled view rays, which end at the points where the image needs light.

mod camera;
mod sights;

use glam::DVec3;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use thiserror::Error;

pub use self::camera::{Camera, FovAxis, Ray};
pub use self::sights::{Sights, sees_a_front};

use crate::geometry::Hit;
use crate::scene::{Scattered, Scene};
use crate::trace::sample::{Purpose, stream};

/// The options of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ViewOptions {
    /// The number of pixels in a row.
    pub width: u32,
    /// The number of rows of pixels.
    pub height: u32,
    /// The samples of a pixel on each axis: the pixel is a grid of this number squared of cells, with a
    /// random point in each.
    pub samples_per_axis: u32,
    /// The seed of the points in the cells.
    pub seed: u64,
}

/// 256 x 256 pixels of 3 x 3 samples.
impl Default for ViewOptions {
    fn default() -> Self {
        Self {
            width: 256,
            height: 256,
            samples_per_axis: 3,
            seed: 1,
        }
    }
}

/// The error of options that describe no picture.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("{field}: found {found}, expected 1 to {max}")]
pub struct ViewError {
    /// The name of the option.
    pub field: &'static str,
    /// The value of the option.
    pub found: u32,
    /// The largest legal value.
    pub max: u32,
}

/// The longest side of an image in pixels. The number of pixels fits 32 bits.
const MAX_SIDE: u32 = 1 << 16;
/// The most mirrors that a view ray follows. At the next mirror it ends and sees black, so that facing
/// mirrors cannot keep it for ever. The loss is below the reflectance to the 64th power of the radiance: 4 %
/// at 0.95, and only where the picture shows a 65th image.
const MAX_MIRRORS: u32 = 64;
/// The most samples on each axis of a pixel: more than any picture needs, and few enough for their square to
/// fit.
const MAX_SAMPLES_PER_AXIS: u32 = 64;

/// A point where the estimate is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QueryPoint {
    /// The position in scene units.
    pub position: DVec3,
    /// The unit normal of its surface's front.
    pub normal: DVec3,
    /// The index of its surface; `None` where it is not known, and photons of all surfaces that face its way count.
    pub surface: Option<u32>,
    /// The factor from irradiance to radiance at the camera: rho / pi, the diffuse BRDF, times the
    /// reflectances of the mirrors in between.
    pub beta: DVec3,
}

impl QueryPoint {
    /// The front that the point is on.
    #[must_use]
    pub fn front(&self) -> Front {
        Front {
            normal: self.normal,
            surface: self.surface,
        }
    }
}

/// The front of a surface at a point, which decides which photons count there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Front {
    /// The unit normal.
    pub normal: DVec3,
    /// The index of the surface; `None` for any surface.
    pub surface: Option<u32>,
}

impl Front {
    /// A front of any surface, with that unit normal.
    #[must_use]
    pub fn of_any(normal: DVec3) -> Self {
        Self {
            normal,
            surface: None,
        }
    }

    /// Numbers that differ between fronts.
    pub(crate) fn key(&self) -> ([u64; 3], Option<u32>) {
        (self.normal.to_array().map(f64::to_bits), self.surface)
    }
}

/// The result of one view ray.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct ViewSample {
    /// The radiance from a light, seen directly or by mirrors.
    pub emitted: DVec3,
    /// The point at which to estimate the reflected light. `None` where the ray leaves the scene, meets a
    /// back, or is lost between mirrors.
    pub query: Option<QueryPoint>,
}

impl ViewOptions {
    /// # Errors
    /// An image without pixels or samples, or one that is too large to index.
    pub(crate) fn check(&self) -> Result<(), ViewError> {
        for (field, found, max) in [
            ("width", self.width, MAX_SIDE),
            ("height", self.height, MAX_SIDE),
            (
                "samples_per_axis",
                self.samples_per_axis,
                MAX_SAMPLES_PER_AXIS,
            ),
        ] {
            if !(1..=max).contains(&found) {
                return Err(ViewError { field, found, max });
            }
        }
        Ok(())
    }

    /// The number of view rays of one pixel.
    pub(crate) fn samples_per_pixel(&self) -> u32 {
        self.samples_per_axis * self.samples_per_axis
    }

    /// The index of pixel `(x, y)`, row by row.
    pub(crate) fn index(&self, x: u32, y: u32) -> u64 {
        u64::from(y) * u64::from(self.width) + u64::from(x)
    }

    /// The results of the view rays of pixel `(x, y)`, cell by cell; row 0 is at the top. The pixel's radiance is their sum over
    /// [`Self::samples_per_pixel`]: a ray that meets glass has several results, each with its share.
    pub(crate) fn samples(
        &self,
        scene: &Scene,
        x: u32,
        y: u32,
    ) -> impl Iterator<Item = ViewSample> {
        let sights = self.sights(scene, x, y).into_iter();
        sights.map(|sight| sight.sample(scene))
    }

    /// The ends of the view rays of pixel `(x, y)`.
    pub(crate) fn sights(&self, scene: &Scene, x: u32, y: u32) -> Vec<Sight> {
        let mut rng = stream(self.seed, Purpose::View, self.index(x, y));
        let cells = self.samples_per_axis;
        let mut found = Vec::with_capacity(self.samples_per_pixel() as usize);
        for cell in 0..self.samples_per_pixel() {
            let mut jittered = |pixel: u32, cell: u32| {
                f64::from(pixel) + (f64::from(cell) + random(&mut rng)) / f64::from(cells)
            };
            let px = jittered(x, cell % cells);
            let py = jittered(y, cell / cells);
            let ray = scene.camera().ray(px, py, self.width, self.height);
            follow(scene, Way::new(ray, SPLITS), &mut rng, &mut found);
        }
        found
    }
}

fn random(rng: &mut Pcg64Mcg) -> f64 {
    rng.random()
}

/// The end of a view ray.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Sight {
    /// The ray ends on the front of a diffuse surface.
    Diffuse {
        /// The index of the surface.
        surface: usize,
        /// The hit on the surface.
        hit: Hit,
        /// The fraction of the light that passes the mirrors and media in between.
        beta: DVec3,
    },
    /// The ray ends on a black back.
    Back {
        /// The index of the surface.
        surface: usize,
    },
    /// The ray leaves the scene.
    Nothing,
    /// The ray is lost between mirrors.
    Lost,
}

/// Follows a ray, at the borders of media along one of both ways by chance, and returns what it sees.
pub(crate) fn see(scene: &Scene, ray: &Ray, rng: &mut Pcg64Mcg) -> ViewSample {
    let mut found = Vec::with_capacity(1);
    follow(scene, Way::new(*ray, 0), rng, &mut found);
    let sight = found.pop().expect("a ray that is not split has one end");
    sight.sample(scene)
}

/// The borders of media at which a view ray follows both ways, each with its share, where a choice by chance would be noise. At a
/// third border the share of the weaker way is mostly below a thousandth.
const SPLITS: u32 = 2;

/// A view ray on its way.
struct Way {
    ray: Ray,
    /// The fraction of the light that passes the mirrors and media so far.
    beta: DVec3,
    /// The mirrors and borders so far.
    met: u32,
    /// The borders at which both ways are still followed.
    splits: u32,
}

impl Way {
    fn new(ray: Ray, splits: u32) -> Self {
        Self {
            ray,
            beta: DVec3::ONE,
            met: 0,
            splits,
        }
    }

    /// The way after a surface of that reflectance.
    fn after(&self, scattered: &Scattered, fraction: DVec3) -> Self {
        Self {
            ray: scattered.ray,
            beta: self.beta * (scattered.radiance * fraction),
            met: self.met + 1,
            splits: self.splits,
        }
    }
}

/// Follows a ray over mirrors and borders of media to its ends on diffuse surfaces.
fn follow(scene: &Scene, mut way: Way, rng: &mut Pcg64Mcg, found: &mut Vec<Sight>) {
    while way.met <= MAX_MIRRORS {
        let Some((index, hit)) = scene.intersect(&way.ray) else {
            return found.push(Sight::Nothing);
        };
        let surface = &scene.surfaces()[index];
        if !surface.is_lit(&hit) {
            return found.push(Sight::Back { surface: index });
        }
        if !surface.is_specular() {
            let (surface, beta) = (index, way.beta);
            return found.push(Sight::Diffuse { surface, hit, beta });
        }
        let both = (way.splits > 0).then(|| surface.both_ways(&way.ray, &hit));
        way = match both.flatten() {
            Some([(share, reflected), (rest, refracted)]) => {
                way.splits -= 1;
                let other = way.after(&reflected, DVec3::splat(share));
                follow(scene, other, rng, found);
                way.after(&refracted, DVec3::splat(rest))
            }
            None => {
                let scattered = surface.scatter(&way.ray, &hit, rng);
                way.after(&scattered, surface.reflectance())
            }
        };
    }
    found.push(Sight::Lost);
}

impl Sight {
    fn sample(self, scene: &Scene) -> ViewSample {
        match self {
            Self::Diffuse { surface, hit, beta } => diffuse_sample(scene, surface, &hit, beta),
            Self::Back { .. } | Self::Nothing | Self::Lost => ViewSample::default(),
        }
    }
}

fn diffuse_sample(scene: &Scene, index: usize, hit: &Hit, beta: DVec3) -> ViewSample {
    let surface = &scene.surfaces()[index];
    ViewSample {
        emitted: beta * surface.radiance,
        query: Some(QueryPoint {
            position: hit.position,
            normal: hit.normal,
            surface: Some(index as u32),
            beta: beta * surface.reflectance() / std::f64::consts::PI,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::fixtures::{chamber, glass_furnace, mirror_box, walls_met};

    const OPTIONS: ViewOptions = ViewOptions {
        width: 128,
        height: 128,
        samples_per_axis: 3,
        seed: 1,
    };

    #[test]
    fn the_light_is_seen_where_the_reference_sees_it() {
        let scene = Scene::built_in("cornell").unwrap();
        let mut samples = OPTIONS.samples(&scene, 64, 18);
        assert!(samples.all(|s| s.emitted == DVec3::new(18.387, 13.9873, 6.75357)));
        assert!(
            OPTIONS
                .samples(&scene, 64, 64)
                .all(|s| s.emitted == DVec3::ZERO)
        );
    }

    #[test]
    fn samples_repeat_and_differ_by_seed() {
        let scene = Scene::built_in("cornell").unwrap();
        let samples = |seed| -> Vec<_> {
            ViewOptions { seed, ..OPTIONS }
                .samples(&scene, 40, 90)
                .collect()
        };
        assert_eq!(samples(1).len(), 9);
        assert_eq!(samples(1), samples(1));
        assert_ne!(samples(1), samples(2));
    }

    #[test]
    fn samples_keep_to_their_pixel() {
        // The back wall at z = -1 is 4.9 away; pixel (60, 50) of 128 there spans this square.
        let scene = Scene::built_in("cornell").unwrap();
        let pixel = 4.9 * 2.0 * (39.3077f64 / 2.0).to_radians().tan() / 128.0;
        for sample in OPTIONS.samples(&scene, 60, 50) {
            let p = sample.query.unwrap().position;
            // 1e-6: the camera's single-precision position.
            assert!((p.z + 1.0).abs() < 1e-6);
            assert!((p.x + 3.5 * pixel).abs() < 0.5 * pixel + 1e-6, "{p}");
            assert!((p.y - 13.5 * pixel).abs() < 0.5 * pixel + 1e-6, "{p}");
        }
    }

    /// Where every light has a radiance of 1, all that is seen through glass has it too: a border adds by
    /// refraction what it takes from a ray by reflection, and the factor of the medium is undone on the way
    /// out.
    #[test]
    fn a_furnace_looks_alike_through_glass() {
        let scene = glass_furnace();
        let mut through = 0;
        for (x, y) in (0..64).flat_map(|x| (0..64).map(move |y| (x, y))) {
            let options = ViewOptions {
                width: 64,
                height: 64,
                ..OPTIONS
            };
            let ray = scene
                .camera()
                .ray(f64::from(x) + 0.5, f64::from(y) + 0.5, 64, 64);
            let (index, _) = scene.intersect(&ray).unwrap();
            through += usize::from(scene.surfaces()[index].shape == "ball");
            let sum: DVec3 = options.samples(&scene, x, y).map(|s| s.emitted).sum();
            // 1e-12: a rounding for each border and share.
            let mean = sum / f64::from(options.samples_per_pixel());
            assert!((mean - DVec3::ONE).abs().max_element() < 1e-12, "{x} {y}");
        }
        assert!(through > 500, "{through} pixels of the ball");
    }

    /// A ray through the middle of a glass ball is reflected by 4 %, passes by 0.96^2, and is reflected inside by 0.96 x 0.04.
    #[test]
    fn a_view_ray_sees_both_ways_of_glass_with_their_shares() {
        let scene = glass_furnace();
        let ball = scene.surfaces().iter().find(|s| s.shape == "ball").unwrap();
        let [low, high] = ball.geometry.bounds();
        let origin = scene.camera().position();
        let ray = Ray {
            origin,
            direction: (0.5 * (low + high) - origin).normalize(),
        };
        let mut found = Vec::new();
        let mut rng = stream(1, Purpose::View, 0);
        follow(&scene, Way::new(ray, SPLITS), &mut rng, &mut found);
        let share = |sight: &Sight| match sight {
            Sight::Diffuse { beta, .. } => beta.x,
            _ => panic!("the furnace is closed: {sight:?}"),
        };
        let shares: Vec<_> = found.iter().map(share).collect();
        let expected = [0.04, 0.96 * 0.04, 0.96 * 0.96];
        assert_eq!(shares.len(), 3);
        for (found, expected) in shares.iter().zip(expected) {
            // 1e-12: roundings at the two borders.
            assert!((found - expected).abs() < 1e-12, "{shares:?}");
        }
    }

    /// The ceiling is seen once directly and again in the walls, darker with every mirror: by
    /// laying out the mirror images flat, a straight view ray says how many.
    #[test]
    fn view_rays_follow_mirrors() {
        let scene = chamber(0.5);
        let mut most = 0;
        for (x, y) in (0..64).flat_map(|x| (0..32).map(move |y| (x, y))) {
            let ray = scene
                .camera()
                .ray(f64::from(x) + 0.5, f64::from(y) + 0.7, 64, 64);
            let t = (1.0 - ray.origin.y) / ray.direction.y;
            let at = ray.origin + t * ray.direction;
            let walls = walls_met(at.x, at.z);
            most = most.max(walls);
            let expected = if walls > MAX_MIRRORS as i32 {
                DVec3::ZERO
            } else {
                DVec3::splat(0.5f64.powi(walls))
            };
            assert_eq!(
                see(&scene, &ray, &mut stream(1, Purpose::View, 0)).emitted,
                expected,
                "{x}, {y}: {walls}"
            );
        }
        assert!(most > MAX_MIRRORS as i32, "the bound is met: {most}");
    }

    #[test]
    fn view_rays_between_perfect_mirrors_end() {
        let scene = mirror_box();
        let pixels = (0..64).flat_map(|x| OPTIONS.samples(&scene, x, 64));
        let (dark, lit): (Vec<_>, Vec<_>) = pixels.partition(|s| *s == ViewSample::default());
        // The light is a thousandth of the box's side, so hardly any ray finds it within 64 mirrors.
        assert!(dark.len() > 100 * lit.len(), "{} {}", dark.len(), lit.len());
    }

    #[test]
    fn options_without_pixels_are_errors() {
        assert_eq!(OPTIONS.check(), Ok(()));
        let error = ViewOptions {
            height: 0,
            ..OPTIONS
        }
        .check()
        .unwrap_err();
        assert_eq!(error.to_string(), "height: found 0, expected 1 to 65536");
        assert!(
            ViewOptions {
                width: 1 << 17,
                ..OPTIONS
            }
            .check()
            .is_err()
        );
        assert!(
            ViewOptions {
                samples_per_axis: 65,
                ..OPTIONS
            }
            .check()
            .is_err()
        );
    }
}
