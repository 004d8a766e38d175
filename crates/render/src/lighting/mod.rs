//! Where the light of a picture comes from: which part of it the photon maps give, and which shadow rays
//! and gather rays.
//!
//! In Heckbert's notation, with E the eye, the light that a query point on a diffuse surface reflects arrives
//! by three kinds of paths, and each may be had in two ways:
//!
//! | paths | from the global map | instead |
//! |---|---|---|
//! | LD, direct light | [`DirectLight::Map`] | [`DirectLight::Rays`]: points of the lights, seen or not |
//! | LS+D, caustics | [`Caustics::Map`] | [`Caustics::Own`]: a photon map of their own, of a smaller radius |
//! | all others | no final gather | a final gather: rays, and the global map where these end |
//!
//! After Jensen, "Realistic Image Synthesis Using Photon Mapping" (2001), chapter 9.

mod area;
mod direct;
mod maps;
mod named;

use glam::DVec3;
use rand_pcg::Pcg64Mcg;
use thiserror::Error;

pub(crate) use self::area::Fronts;
pub use self::maps::{PhotonMaps, Radii};
pub use self::named::UnknownLighting;

use self::direct::Shadows;
use crate::camera::Ray;
use crate::estimators::Estimator;
use crate::sample::{Apart, cosine_direction_at};
use crate::scene::Scene;
use crate::trace::PathKind;
use crate::view::{QueryPoint, ViewSample, see};

/// Where direct light comes from. On the command line: `map`, `rays`, `rays:16`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum DirectLight {
    /// From the global map, as all light.
    #[default]
    Map,
    /// By this many shadow rays from a query point to each light; from 1. No bias, hence sharp shadows.
    Rays(u32),
}

/// Where caustics come from. On the command line: `map`, `own`, `own:100`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Caustics {
    /// From the global map, with its radius.
    #[default]
    Map,
    /// From a map of their own, whose radius has this many photons in range where a photon is, on average.
    Own(f64),
}

/// What a sum of power is divided by. On the command line: `disc`, `covered`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Area {
    /// The disc of the search radius, pi r^2, as in eq. 2 of the paper. At the border of a surface it reaches
    /// over it, which darkens a strip of the radius' width.
    #[default]
    Disc,
    /// The area of the flat fronts that the search sphere cuts out, of those whose photons are gathered: photons
    /// can be stored on no other part of the disc. Of curved surfaces, the disc.
    Covered,
}

/// Where the light of a picture comes from. The default is the paper's: one map gives all of it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Lighting {
    /// Direct light.
    pub direct: DirectLight,
    /// Caustics.
    pub caustics: Caustics,
    /// Rays of the final gather from each query point; 0 for none.
    pub final_gather: u32,
    /// What a sum of power is divided by.
    pub area: Area,
}

/// Why a scene cannot be lit so.
#[derive(Debug, Clone, Copy, Error, PartialEq)]
pub enum LightingError {
    /// A final gather whose rays would have to find the lights.
    #[error(
        "final gather: found direct light from the map, expected by shadow rays (`rays`): \
         gather rays see no lights"
    )]
    DirectFromMap,
    /// A final gather whose rays would have to find the lights by mirrors.
    #[error(
        "final gather: found caustics from the global map, expected a map of their own (`own`): \
         the scene has mirrors or borders of media"
    )]
    CausticsFromMap,
    /// An estimate whose radius is no matter of the map alone.
    #[error("area: found covered with the estimator {0}, expected the estimator fixed")]
    AreaOf(Estimator),
}

impl Lighting {
    /// Whether `scene` can be lit so, with `estimator`.
    ///
    /// # Errors
    /// [`LightingError`], which says what does not fit together.
    pub fn check(&self, scene: &Scene, estimator: Estimator) -> Result<(), LightingError> {
        if self.area == Area::Covered && estimator != Estimator::FixedRadius {
            return Err(LightingError::AreaOf(estimator));
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

    /// Whether the global map holds photons of that kind. With a final gather it is asked only where gather
    /// rays end, for all that arrives there.
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

/// The lighting of a scene, ready for its query points.
pub(crate) struct Lit<'a> {
    scene: &'a Scene,
    lighting: Lighting,
    shadows: Shadows<'a>,
}

/// The random numbers of a pixel's rays.
pub(crate) struct Chances {
    rng: Pcg64Mcg,
    /// On the lights.
    lights: Apart,
    /// Of gather rays' directions.
    directions: Apart,
}

impl Chances {
    /// Those of a stream.
    pub fn new(mut rng: Pcg64Mcg) -> Self {
        Self {
            lights: Apart::new(&mut rng),
            directions: Apart::new(&mut rng),
            rng,
        }
    }
}

/// What is left to gather of a query point's light.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Ungathered {
    /// Radiance towards the eye that needs no map.
    pub known: DVec3,
    /// At the global map.
    pub global: Vec<QueryPoint>,
    /// At that of the caustics, if they have one.
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

    /// What a view ray sees, in parts.
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

    /// Where `rays` rays from the query point, of density cos / pi, end: the irradiance is pi times the mean of
    /// the radiances that they see. Emitted light is not among these, as it comes by shadow rays and caustics.
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
