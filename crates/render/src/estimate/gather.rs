//! Stage 5 at one query point: the irradiance estimate, by each engine.
//!
//! Every engine sums the power of the photons in range, d^2 <= r^2, and divides by the area of the disc: the
//! paper's eq. 2 with the rectangle kernel, E = sum(power) / (pi r^2). The reflected radiance is E times the
//! query's rho / pi, which [`crate::QueryPoint`] carries as `beta`. Other estimates from such gathers are in
//! [`crate::estimate`].

use glam::DVec3;
use photoncube_model::{GatherError, gather};
use photoncube_spec as spec;
use thiserror::Error;

use super::estimator::UnfitEstimator;
use super::integers::Disc;
use super::neighbourhood::EstimatorError;
use crate::photon_map::PhotonMap;
use crate::quantise::{FormatMap, QuantisedMap};
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
    /// The golden model of the machine or of the photon format refused it.
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
    for run in map.candidates(query.position, query.normal) {
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

/// One gather of a machine's golden model, from integer photons to integer sums. The sums' scale converts
/// them to floats. `radius_sq` is the value of the machine's pin.
pub(crate) fn gather_model(
    quantised: &QuantisedMap<'_>,
    query: &QueryPoint,
    radius_sq: u32,
) -> Result<Disc, GatherError> {
    let mut tests = 0;
    let photons = quantised.photons(query.position, query.normal);
    let counted = photons.inspect(|_| tests += 1);
    let centre = spec::Query {
        radius_sq,
        ..quantised.query(query.position)
    };
    let sums = gather(quantised.machine(), &centre, counted)?;
    Ok(Disc {
        power: DVec3::from(sums.power.map(|p| p as f64)) * quantised.power_step(),
        tests,
        skipped: 0,
        count: sums.count,
    })
}

/// One gather in a photon format, from integer photons to integer sums. `radius_sq` is in squared fine steps
/// of the format.
pub(crate) fn gather_format(
    quantised: &FormatMap<'_>,
    query: &QueryPoint,
    radius_sq: u32,
) -> Result<Disc, GatherError> {
    let blocks = quantised.blocks(query.position, query.normal);
    let tests = blocks.map(|block| block.photons.len() as u64).sum();
    let sums = quantised.gather_within(query.position, query.normal, radius_sq)?;
    Ok(Disc {
        power: quantised.flux(sums.power),
        tests,
        skipped: 0,
        count: sums.count,
    })
}

/// pi r^2 of the search radius (scene units squared).
pub(crate) fn disc_area(map: &PhotonMap) -> f64 {
    std::f64::consts::PI * map.radius() * map.radius()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{PHOTON_FORMATS, find_machine};

    use super::*;
    use crate::render::{Engine, Prepared};
    use crate::{Photon, Scene};

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
            beta: DVec3::ONE,
        }
    }

    #[test]
    fn one_photon_gives_its_power_over_the_disc() {
        let map = one_photon();
        let quantised = QuantisedMap::new(&map, find_machine("paper").unwrap()).unwrap();
        let expected = DVec3::new(4.0, 2.0, 1.0) / (std::f64::consts::PI * 0.25);
        let reference = estimate_f64(&map, &query(0.1, DVec3::Y));
        let model = Prepared::Model(quantised);
        let model = model.estimate(&map, &query(0.1, DVec3::Y)).unwrap();
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
            let quantised = Prepared::new(&map, Engine::Format(format)).unwrap();
            let found = quantised.estimate(&map, &query(0.1, DVec3::Y)).unwrap();
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
