use std::f64::consts::PI;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::scene::fixtures::traced_cornell;
use crate::{ViewOptions, view_queries};

/// A photon of power 1 at each of the squared distances.
fn around(distances_sq: &[f64], reach: f64) -> Neighbourhood {
    let near = distances_sq.iter().map(|&distance_sq| Near {
        distance_sq,
        power: DVec3::ONE,
    });
    Neighbourhood {
        near: near.collect(),
        reach,
    }
}

/// Uniform points, given by their squared distances, which are uniform up to 4 in a disc of radius 2.
fn uniform(photons: usize, rng: &mut Pcg64Mcg) -> Neighbourhood {
    let distances: Vec<f64> = (0..photons).map(|_| 4.0 * rng.random::<f64>()).collect();
    around(&distances, f64::INFINITY)
}

#[test]
fn the_block_walk_is_the_brute_force() {
    let (scene, map) = traced_cornell(20_000, 3, 0.15);
    let view = ViewOptions {
        width: 16,
        height: 16,
        samples_per_axis: 1,
        seed: 3,
    };
    let queries = view_queries(&scene, &view).unwrap();
    let photons: Vec<_> = map.traced_photons().collect();
    let mut gathered = 0;
    for query in &queries {
        // In the map's order both add the same numbers in the same order, so they are equal, bit for bit.
        let brute = Neighbourhood::brute_force(&scene, &photons, query, map.radius());
        let walk = Neighbourhood::block_walk(&map, query);
        let ladder = Ladder::new(Kernel::Cone, 3).unwrap();
        assert_eq!(walk.ladder(0.15, &ladder), brute.ladder(0.15, &ladder));
        for kernel in Kernel::ALL {
            let estimate = walk.fixed_radius(0.15, kernel).unwrap();
            assert_eq!(Ok(estimate), brute.fixed_radius(0.15, kernel));
            gathered += estimate.in_range;
            if estimate.in_range >= 20 {
                assert_eq!(walk.k_nearest(20, kernel), brute.k_nearest(20, kernel));
            }
        }
    }
    assert!(queries.len() > 200 && gathered > 10_000, "{gathered}");
}

#[test]
fn kernels_weigh_as_stated() {
    let photons = around(&[0.0, 0.25, 1.0, 1.0000001], 2.0);
    let sum = |kernel| photons.fixed_radius(1.0, kernel).unwrap().irradiance.x * PI;
    // Exact but for the rounding of pi.
    assert!((sum(Kernel::Rectangle) - 3.0).abs() < 1e-14);
    assert!((sum(Kernel::Cone) - 3.0 * 1.5).abs() < 1e-14);
    assert!((sum(Kernel::Epanechnikov) - 2.0 * 1.75).abs() < 1e-14);
}

#[test]
fn the_kth_photon_and_its_ties_set_the_radius_and_do_not_count() {
    let photons = around(&[4.0, 1.0, 4.0, 2.0, 9.0], 5.0);
    for k in [3, 4] {
        let estimate = photons.k_nearest(k, Kernel::Rectangle).unwrap();
        assert_eq!((estimate.in_range, estimate.radius), (2, 2.0));
        assert_eq!(estimate.irradiance.x, 2.0 * (1.0 / (PI * 4.0)));
    }
}

#[test]
fn too_few_within_the_reach_is_the_fixed_radius_of_the_reach() {
    let photons = around(&[1.0, 4.0, 26.0], 5.0);
    assert_eq!(
        photons.k_nearest(3, Kernel::Cone),
        photons.fixed_radius(5.0, Kernel::Cone)
    );
    let all = around(&[1.0], f64::INFINITY).k_nearest(2, Kernel::Cone);
    assert_eq!(all, Err(EstimatorError::TooFew { found: 1, k: 2 }));
}

#[test]
fn what_has_no_estimate_is_an_error() {
    let photons = around(&[0.0, 0.0, 1.0], 2.0);
    for radius in [0.0, -1.0, 2.1, f64::NAN, f64::INFINITY] {
        let error = photons.fixed_radius(radius, Kernel::Rectangle).unwrap_err();
        assert!(matches!(error, EstimatorError::Radius { .. }), "{error}");
    }
    let k_nearest = |k| photons.k_nearest(k, Kernel::Rectangle);
    assert_eq!(k_nearest(0), Err(EstimatorError::NoPhotonAsked));
    assert_eq!(k_nearest(2), Err(EstimatorError::NoArea { k: 2 }));
    assert!(k_nearest(3).is_ok());
}

/// The mean of all estimates of a uniform field of density 1 / pi is 1 / pi, for every kernel.
#[test]
fn estimates_of_a_uniform_field_are_unbiased() {
    let mut rng = Pcg64Mcg::seed_from_u64(11);
    let (trials, k) = (4000, 20);
    let ladder = Ladder::new(Kernel::Epanechnikov, 4).unwrap();
    let mut sums = [0.0; 7];
    for _ in 0..trials {
        // 400 in an area of 4 pi: 100 in range of radius 1.
        let photons = uniform(400, &mut rng);
        let mut estimates: Vec<_> = Kernel::ALL.map(|k| photons.fixed_radius(1.0, k)).into();
        estimates.extend(Kernel::ALL.map(|kernel| photons.k_nearest(k, kernel)));
        estimates.push(photons.ladder(1.0, &ladder));
        for (sum, estimate) in sums.iter_mut().zip(estimates) {
            *sum += estimate.unwrap().irradiance.x * PI / 100.0;
        }
    }
    for sum in sums {
        // One estimate scatters by less than sqrt(1.5 / 18) = 0.29, the mean of 4000 by 0.0046;
        // four of these. Counting the k-th would show as 1 / 19 = 0.053.
        assert!((sum / f64::from(trials) - 1.0).abs() < 0.0185, "{sums:?}");
    }
}
