//! Lighting: which part of a picture's light comes from the photon maps, and which from shadow rays and
//! gather rays.
//!
//! In Heckbert's notation, with E the eye, the light that a query point on a diffuse surface reflects arrives
//! by three kinds of paths. Each kind has two possible sources:
//!
//! | paths | from the global map | instead |
//! |---|---|---|
//! | LD, direct light | [`DirectLight::Map`] | [`DirectLight::Rays`]: points of the lights, seen or not |
//! | LS+D, caustics | [`Caustics::Map`] | [`Caustics::Own`]: a photon map of their own, of a smaller radius |
//! | all others | no final gather | a final gather: rays, and the global map where these end |
//!
//! After Jensen, "Realistic Image Synthesis Using Photon Mapping" (2001), chapter 9.

mod area;
mod balls;
mod direct;
mod maps;
mod named;

use glam::DVec3;
use rand_pcg::Pcg64Mcg;
use thiserror::Error;

pub(crate) use self::area::Fronts;
pub use self::balls::{BallError, ball_errors};
pub use self::maps::{PhotonMaps, Radii};
pub use self::named::UnknownLighting;

use self::direct::Shadows;
use crate::estimate::Estimator;
use crate::scene::Scene;
use crate::trace::PathKind;
use crate::trace::sample::{Apart, cosine_direction_at};
use crate::view::{QueryPoint, Ray, ViewSample, see};

/// The source of direct light. On the command line: `map`, `rays`, `rays:16`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum DirectLight {
    /// The global map.
    #[default]
    Map,
    /// This number of shadow rays, at least 1, from a query point to each light. Without bias, hence with
    /// sharp shadows.
    Rays(u32),
}

/// The source of caustics. On the command line: `map`, `own`, `own:100`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Caustics {
    /// The global map, with its radius.
    #[default]
    Map,
    /// A separate map, with a radius at which a caustic photon has this many photons in range on average.
    Own(f64),
}

impl Caustics {
    /// A separate map with 50 photons in range of a caustic photon. That is fewer than elsewhere, because caustics are bright and
    /// sharp.
    pub const OWN: Self = Self::Own(50.0);
}

/// The divisor of a sum of power. On the command line: `disc`, `covered`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Area {
    /// The area of the disc of the search radius, pi r^2, as in eq. 2 of the paper. At the border of a
    /// surface the disc extends past the surface, which darkens a strip of the radius' width.
    #[default]
    Disc,
    /// The area, inside the search sphere, of the flat fronts whose photons are gathered; no other part of
    /// the disc can have photons. On a ball smaller than the disc, the part of the ball whose photons count. On other curved surfaces,
    /// the disc.
    Covered,
}

/// The sources of a picture's light. The default is the paper's: one map gives all of it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Lighting {
    /// The source of direct light.
    pub direct: DirectLight,
    /// The source of caustics.
    pub caustics: Caustics,
    /// The number of rays of the final gather from each query point; 0 for no final gather.
    pub final_gather: u32,
    /// The divisor of a sum of power.
    pub area: Area,
}

/// The reason why a scene does not allow a lighting.
#[derive(Debug, Clone, Error, PartialEq)]
pub enum LightingError {
    /// A final gather needs direct light from shadow rays, because its rays would have to find the lights.
    #[error(
        "final gather: found direct light from the map, expected by shadow rays (`rays`): \
         gather rays see no lights"
    )]
    DirectFromMap,
    /// A final gather needs caustics from their own map, because its rays would have to find the lights by
    /// mirrors.
    #[error(
        "final gather: found caustics from the global map, expected a map of their own (`own`): \
         the scene has mirrors or borders of media"
    )]
    CausticsFromMap,
    /// The covered area needs a radius that depends on the map alone, which this estimator has not.
    #[error("area: found covered with the estimator {0}, expected the estimator fixed")]
    AreaOf(Estimator),
}

impl Lighting {
    /// Checks that `scene` allows this lighting with `estimator`.
    ///
    /// # Errors
    /// A [`LightingError`] that names the conflict.
    pub fn check(&self, scene: &Scene, estimator: &Estimator) -> Result<(), LightingError> {
        if self.area == Area::Covered && *estimator != Estimator::FixedRadius {
            return Err(LightingError::AreaOf(estimator.clone()));
        }
        if self.final_gather == 0 {
            return Ok(());
        }
        if self.direct == DirectLight::Map {
            return Err(LightingError::DirectFromMap);
        }
        let specular = scene.surfaces().iter().any(|s| s.is_specular());
        if specular && self.caustics == Caustics::Map {
            return Err(LightingError::CausticsFromMap);
        }
        Ok(())
    }

    /// Whether the global map holds photons of that kind. With a final gather, the map is used only where
    /// gather rays end, for all light that arrives there.
    #[must_use]
    pub fn maps(&self, kind: PathKind) -> bool {
        self.final_gather > 0
            || match kind {
                PathKind::Direct => self.direct == DirectLight::Map,
                PathKind::Caustic => self.caustics == Caustics::Map,
                PathKind::Indirect => true,
            }
    }
}

/// The lighting of a scene, prepared for its query points.
pub(crate) struct Lit<'a> {
    scene: &'a Scene,
    lighting: Lighting,
    shadows: Shadows<'a>,
}

/// The random numbers of the shadow rays and gather rays of a pixel.
pub(crate) struct Chances {
    rng: Pcg64Mcg,
    /// The points on the lights.
    lights: Apart,
    /// The directions of gather rays.
    directions: Apart,
}

impl Chances {
    /// Takes the random numbers from a stream.
    pub fn new(mut rng: Pcg64Mcg) -> Self {
        Self {
            lights: Apart::new(&mut rng),
            directions: Apart::new(&mut rng),
            rng,
        }
    }
}

/// The light of a query point, split into a known part and the gathers that remain.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Ungathered {
    /// The radiance towards the eye that needs no map.
    pub known: DVec3,
    /// The query points at the global map.
    pub global: Vec<QueryPoint>,
    /// The query point at the map of caustics; `None` where there is no such map.
    pub caustic: Option<QueryPoint>,
}

impl<'a> Lit<'a> {
    pub fn new(scene: &'a Scene, lighting: Lighting) -> Self {
        Self {
            scene,
            lighting,
            shadows: Shadows::of(scene),
        }
    }

    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// Splits the light of a view ray into parts.
    pub fn ungathered(&self, sample: &ViewSample, chances: &mut Chances) -> Ungathered {
        let mut found = Ungathered {
            known: sample.emitted,
            ..Ungathered::default()
        };
        let Some(query) = sample.query else {
            return found;
        };
        if let DirectLight::Rays(rays) = self.lighting.direct {
            found.known += query.beta * self.shadows.irradiance(&query, rays, &mut chances.lights);
        }
        match self.lighting.final_gather {
            0 => found.global.push(query),
            rays => found.global.extend(self.gather_rays(&query, rays, chances)),
        }
        found.caustic = matches!(self.lighting.caustics, Caustics::Own(_)).then_some(query);
        found
    }

    /// The ends of `rays` rays from the query point, of density cos / pi. The irradiance is pi times the mean
    /// of the radiances at these ends. Emitted light is not included, because it comes from shadow rays and
    /// caustics.
    fn gather_rays(
        &self,
        query: &QueryPoint,
        rays: u32,
        chances: &mut Chances,
    ) -> impl Iterator<Item = QueryPoint> {
        let share = query.beta * std::f64::consts::PI / f64::from(rays);
        (0..rays).filter_map(move |_| {
            let ray = Ray {
                origin: query.position,
                direction: cosine_direction_at(query.normal, chances.directions.next()),
            };
            let end = see(self.scene, &ray, &mut chances.rng).query?;
            Some(QueryPoint {
                beta: share * end.beta,
                ..end
            })
        })
    }
}

#[cfg(test)]
mod tests;
