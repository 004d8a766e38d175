//! Stage 5 at one query point: the irradiance estimate, by each engine.
//!
//! Every engine sums the power of the photons in range, d^2 <= r^2, and divides by the area of the disc: the
//! paper's eq. 2 with the rectangle kernel, E = sum(power) / (pi r^2). The reflected radiance is E times the
//! query's rho / pi, which [`crate::QueryPoint`] carries as `beta`. Other estimates from such gathers are in
//! [`crate::estimate`].

use glam::DVec3;
use photoncube_model::GatherError;
use thiserror::Error;

use super::estimator::UnfitEstimator;
use super::integers::Disc;
use super::neighbourhood::EstimatorError;
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::view::QueryPoint;

/// The estimate of a query, with the work that it took.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Estimate {
    /// E, flux per area.
    pub irradiance: DVec3,
    /// The number of photons that each gather tests.
    pub tests: u64,
    /// The number of photons, over all gathers, that the fast gather decided by their block or leaf.
    pub skipped: u64,
    /// The number of photons in range in the widest disc that was summed.
    pub in_range: u64,
    /// The number of gathers, all over the same photons.
    pub gathers: u64,
}

/// The reason why an engine refused a query.
#[derive(Debug, Error)]
pub(crate) enum Refusal {
    /// The golden model refused it.
    #[error(transparent)]
    Gather(#[from] GatherError),
    /// The f64 reference has no such estimate.
    #[error(transparent)]
    Reference(#[from] EstimatorError),
    /// The engine cannot make this estimate at any query.
    #[error(transparent)]
    Estimator(#[from] UnfitEstimator),
}

/// The estimate in f64, the reference of all formats.
pub(crate) fn estimate_f64(map: &PhotonMap, query: &QueryPoint) -> Estimate {
    let radius_sq = map.radius() * map.radius();
    let mut estimate = Estimate {
        gathers: 1,
        ..Estimate::default()
    };
    let mut power = DVec3::ZERO;
    for run in map.candidates(query.position, query.front()) {
        estimate.tests += run.photons.len() as u64;
        for photon in &map.photons()[run.photons] {
            if photon.position.distance_squared(query.position) <= radius_sq {
                power += photon.power;
                estimate.in_range += 1;
            }
        }
    }
    estimate.irradiance = power / disc_area(map);
    estimate
}

/// One gather of the golden model, from integer photons to integer sums. The sums' scale converts them to
/// floats. `radius_sq` is in squared fine steps.
pub(crate) fn gather(
    quantised: &QuantisedMap<'_>,
    query: &QueryPoint,
    radius_sq: u32,
) -> Result<Disc, GatherError> {
    let gathered = quantised.gather_one(query, radius_sq)?;
    Ok(Disc::of(quantised, &gathered))
}

/// pi r^2 of the search radius (scene units squared).
pub(crate) fn disc_area(map: &PhotonMap) -> f64 {
    std::f64::consts::PI * map.radius() * map.radius()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{PHOTON_FORMATS, find_machine};

    use super::*;
    use crate::{Estimator, Photon, Scene};

    /// One photon on the floor's middle, surface found by name.
    fn one_photon() -> PhotonMap {
        let scene = Scene::built_in("cornell").unwrap();
        let floor = scene
            .surfaces()
            .iter()
            .position(|s| s.shape == "floor")
            .unwrap();
        let photon = Photon {
            position: DVec3::new(0.0, -1.0, 0.0),
            power: DVec3::new(4.0, 2.0, 1.0),
            surface: floor as u32,
            facing: crate::Facing::FLAT,
        };
        PhotonMap::new(&scene, vec![photon], 0.5).unwrap()
    }

    fn query(x: f64, normal: DVec3) -> QueryPoint {
        QueryPoint {
            position: DVec3::new(x, -1.0, 0.0),
            normal,
            surface: None,
            beta: DVec3::ONE,
        }
    }

    #[test]
    fn one_photon_gives_its_power_over_the_disc() {
        let map = one_photon();
        let quantised = QuantisedMap::new(&map, &find_machine("paper").unwrap().numbers).unwrap();
        let expected = DVec3::new(4.0, 2.0, 1.0) / (std::f64::consts::PI * 0.25);
        let reference = estimate_f64(&map, &query(0.1, DVec3::Y));
        let fixed = Estimator::FixedRadius;
        let model = fixed.estimate(&map, Some(&quantised), &query(0.1, DVec3::Y));
        let model = model.unwrap();
        assert_eq!((reference.tests, reference.in_range), (1, 1));
        assert_eq!((model.tests, model.in_range), (1, 1));
        assert!(reference.irradiance.distance(expected) < 1e-12);
        // Half a power step of 4 / 65535 in each channel, over the disc.
        assert!(model.irradiance.distance(expected) < 1e-4);
    }

    #[test]
    fn every_format_agrees_to_half_a_mantissas_step() {
        let map = one_photon();
        let reference = estimate_f64(&map, &query(0.1, DVec3::Y));
        for format in PHOTON_FORMATS {
            let quantised = QuantisedMap::new(&map, &format.into()).unwrap();
            let fixed = Estimator::FixedRadius;
            let found = fixed.estimate(&map, Some(&quantised), &query(0.1, DVec3::Y));
            let found = found.unwrap();
            assert_eq!((found.tests, found.in_range), (1, 1));
            let error = (found.irradiance - reference.irradiance)
                .abs()
                .max_element();
            let steps = f64::from((1 << format.power.mantissa_bits) - 1);
            // The strongest channel is all ones; the sum is exact.
            let bound = 0.5 / steps * reference.irradiance.max_element();
            assert!(error <= bound * 1.000001, "{format}: {error}");
        }
    }

    #[test]
    fn out_of_range_is_tested_and_facing_away_is_not() {
        let map = one_photon();
        let far = estimate_f64(&map, &query(0.500001, DVec3::Y));
        assert_eq!((far.tests, far.in_range), (1, 0));
        let below = estimate_f64(&map, &query(0.0, DVec3::NEG_Y));
        assert_eq!((below.tests, below.irradiance), (0, DVec3::ZERO));
    }

    #[test]
    fn a_photon_at_exactly_the_radius_is_in_range() {
        let map = one_photon();
        assert_eq!(estimate_f64(&map, &query(0.5, DVec3::Y)).in_range, 1);
    }
}
