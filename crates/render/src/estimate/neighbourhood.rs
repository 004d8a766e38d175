//! The photons around a query, and the estimates on them.

use glam::DVec3;
use thiserror::Error;

use super::kernel::Kernel;
use super::ladder::Ladder;
use crate::photon_map::PhotonMap;
use crate::scene::Scene;
use crate::trace::Photon;
use crate::view::QueryPoint;

/// A photon near a query, as an estimate uses it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// The photon's squared distance from the query (scene units squared).
    pub distance_sq: f64,
    /// The photon's flux.
    pub power: DVec3,
}

/// The photons that a query may gather: all photons up to the reach that face its way, by the rule at
/// [`PhotonMap`].
#[derive(Debug, Clone, PartialEq)]
pub struct Neighbourhood {
    near: Vec<Near>,
    reach: f64,
}

/// An estimate with the photons and the radius that it is made from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KernelEstimate {
    /// E, flux per area.
    pub irradiance: DVec3,
    /// The number of photons summed, including those of weight 0 at the border.
    pub in_range: u64,
    /// The radius used (scene units).
    pub radius: f64,
}

/// The reason why there is no estimate.
#[derive(Debug, Clone, Copy, Error, PartialEq)]
pub enum EstimatorError {
    /// A radius that is not over 0, or that exceeds the reach.
    #[error("search radius: found {found}, expected over 0 and at most {reach}")]
    Radius {
        /// The radius that was given.
        found: f64,
        /// The largest radius for which the neighbourhood is complete.
        reach: f64,
    },
    /// k was 0.
    #[error("k: found 0, expected at least 1")]
    NoPhotonAsked,
    /// Fewer photons than k, and no reach to fall back on.
    #[error("k nearest: found {found} photons, expected at least {k}")]
    TooFew {
        /// The number of photons that exist.
        found: u64,
        /// The requested number of photons.
        k: u64,
    },
    /// The k-th photon lies at the query itself: a disc without area has no density.
    #[error("k nearest: found photon {k} at distance 0, expected it apart from the query")]
    NoArea {
        /// The number k of the photon.
        k: u64,
    },
}

impl Neighbourhood {
    /// Every photon of the scene, tested one by one against the rule of [`PhotonMap`] for that search radius (scene units); unlimited
    /// reach. The slow reference of [`Self::block_walk`].
    #[must_use]
    pub fn brute_force(scene: &Scene, photons: &[Photon], query: &QueryPoint, radius: f64) -> Self {
        let cosine = PhotonMap::MIN_FACING_COSINE;
        let joined = query.surface.map(|own| scene.joined(own, radius, cosine));
        let faces = |photon: &&Photon| {
            let surface = &scene.surfaces()[photon.surface as usize];
            let normal = surface.facing_normal(photon.facing);
            let is_joined = |joined: &Vec<u32>| joined.contains(&photon.surface);
            normal.dot(query.normal) > cosine && joined.as_ref().is_none_or(is_joined)
        };
        let facing = photons.iter().filter(faces);
        Self {
            near: facing.map(|p| near(p.position, p.power, query)).collect(),
            reach: f64::INFINITY,
        }
    }

    /// The photons of the blocks around the query; their reach is the map's radius.
    #[must_use]
    pub fn block_walk(map: &PhotonMap, query: &QueryPoint) -> Self {
        let runs = map.candidates(query.position, query.front());
        let photons = runs.flat_map(|run| &map.photons()[run.photons]);
        Self {
            near: photons.map(|p| near(p.position, p.power, query)).collect(),
            reach: map.radius(),
        }
    }

    /// The photons that the query tests, in the map's order.
    #[must_use]
    pub fn near(&self) -> &[Near] {
        &self.near
    }

    /// The largest distance up to which no photon is missing, in scene units.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// The estimate with a given radius; d^2 <= r^2 is in range. With the rectangle it is the
    /// paper's eq. 2, sum(power) / (pi r^2).
    ///
    /// # Errors
    /// [`EstimatorError::Radius`] for a radius not over 0, not finite, or over the reach.
    pub fn fixed_radius(
        &self,
        radius: f64,
        kernel: Kernel,
    ) -> Result<KernelEstimate, EstimatorError> {
        self.check(radius)?;
        Ok(self.sum(radius * radius, radius, kernel, |d, r| d <= r))
    }

    /// The estimate whose radius is the distance d_k of the k-th nearest photon: eq. 1 of
    /// the paper. Where the reach holds fewer than k, the fixed radius of the reach, as in
    /// Jensen's photon map.
    ///
    /// # The k-th photon sets the radius and does not count
    /// The sum is over the open disc, d^2 < d_k^2. In a uniform field of lambda photons per area
    /// the mean of (k - 1) / (pi d_k^2) is lambda, while k / (pi d_k^2) is too large by 1 / (k - 1)
    /// (Fukunaga, "Statistical Pattern Recognition", 1990, section 6.2): 2 % at 50, which more
    /// photons never remove. The smooth kernels give the k-th photon weight 0 anyway, so one rule
    /// serves all. Photons that tie with the k-th lie on the border and are left out with it.
    ///
    /// # Errors
    /// [`EstimatorError::NoPhotonAsked`], [`EstimatorError::TooFew`] where the reach is unlimited,
    /// and [`EstimatorError::NoArea`] where d_k is 0.
    pub fn k_nearest(&self, k: u64, kernel: Kernel) -> Result<KernelEstimate, EstimatorError> {
        let Some(radius_sq) = self.kth_distance_sq(k)? else {
            return self.fixed_radius(self.reach, kernel);
        };
        if radius_sq == 0.0 {
            return Err(EstimatorError::NoArea { k });
        }
        Ok(self.sum(radius_sq, radius_sq.sqrt(), kernel, |d, r| d < r))
    }

    /// The estimate with a given radius, its kernel made of the ladder's rectangles.
    ///
    /// # Errors
    /// As for [`Self::fixed_radius`].
    pub fn ladder(&self, radius: f64, ladder: &Ladder) -> Result<KernelEstimate, EstimatorError> {
        self.check(radius)?;
        let radius_sq = radius * radius;
        let mut estimate = self.sum(radius_sq, radius, Kernel::Rectangle, |d, r| d <= r);
        estimate.irradiance = DVec3::ZERO;
        for rung in ladder.rungs() {
            let rung_sq = rung.radius_sq_fraction * radius_sq;
            let part = self.sum(rung_sq, rung_sq.sqrt(), Kernel::Rectangle, |d, r| d <= r);
            estimate.irradiance += rung.weight * part.irradiance;
        }
        Ok(estimate)
    }

    fn check(&self, radius: f64) -> Result<(), EstimatorError> {
        if radius > 0.0 && radius.is_finite() && radius <= self.reach {
            return Ok(());
        }
        Err(EstimatorError::Radius {
            found: radius,
            reach: self.reach,
        })
    }

    /// d_k^2; `None` where the reach ends before the k-th photon.
    fn kth_distance_sq(&self, k: u64) -> Result<Option<f64>, EstimatorError> {
        let index = k.checked_sub(1).ok_or(EstimatorError::NoPhotonAsked)?;
        let reach_sq = self.reach * self.reach;
        let distances = self.near.iter().map(|near| near.distance_sq);
        let mut inside: Vec<f64> = distances.filter(|d| *d <= reach_sq).collect();
        let found = inside.len() as u64;
        if index < found {
            let (_, kth, _) = inside.select_nth_unstable_by(index as usize, f64::total_cmp);
            return Ok(Some(*kth));
        }
        if self.reach.is_finite() {
            return Ok(None);
        }
        Err(EstimatorError::TooFew { found, k })
    }

    fn sum(
        &self,
        radius_sq: f64,
        radius: f64,
        kernel: Kernel,
        is_in_range: impl Fn(f64, f64) -> bool,
    ) -> KernelEstimate {
        let mut power = DVec3::ZERO;
        let mut in_range = 0;
        for near in &self.near {
            if is_in_range(near.distance_sq, radius_sq) {
                power += near.power * kernel.weight(near.distance_sq / radius_sq);
                in_range += 1;
            }
        }
        KernelEstimate {
            irradiance: power * kernel.scale(radius_sq),
            in_range,
            radius,
        }
    }
}

fn near(position: DVec3, power: DVec3, query: &QueryPoint) -> Near {
    Near {
        distance_sq: position.distance_squared(query.position),
        power,
    }
}

#[cfg(test)]
mod tests;
