//! Measures the error of formats at single queries, against f64 on the same photons.

use glam::DVec3;
use photoncube_render::{Front, Photon, PhotonMap, QuantisedMap, Scene, TraceOptions, trace};
use photoncube_spec::{PhotonFormat, find_photon_format};

/// The figures of many queries.
#[derive(Debug, Default)]
struct Measured {
    /// Misclassified photons over photons in range.
    misclassified: f64,
    /// The rms relative error of the sum of the three channels.
    rms: f64,
    /// The rms of the Monte-Carlo noise; that of each query is estimated from its own photons: sqrt(sum w^2)
    /// / sum w.
    noise: f64,
}

fn measure(map: &PhotonMap, queries: &[(DVec3, DVec3)], format: &PhotonFormat) -> Measured {
    let quantised = QuantisedMap::new(map, &format.into()).unwrap();
    let (mut wrong, mut in_range, mut count) = (0, 0, 0.0);
    let (mut squares, mut noise) = (0.0, 0.0);
    for &(position, normal) in queries {
        let (mut exact, mut exact_sq) = (0.0, 0.0);
        for (photon, verdict) in quantised.verdicts(position, Front::of_any(normal)) {
            let truly = photon.position.distance(position) <= map.radius();
            wrong += u64::from(verdict != truly);
            in_range += u64::from(truly);
            if truly {
                exact += photon.power.element_sum();
                exact_sq += photon.power.element_sum().powi(2);
            }
        }
        if exact > 0.0 {
            let sums = quantised.gather(position, Front::of_any(normal)).unwrap();
            let sum = quantised.flux(sums.power).element_sum();
            squares += (sum / exact - 1.0).powi(2);
            noise += exact_sq / (exact * exact);
            count += 1.0;
        }
    }
    Measured {
        misclassified: wrong as f64 / in_range as f64,
        rms: f64::sqrt(squares / count),
        noise: f64::sqrt(noise / count),
    }
}

fn traced(scene: &Scene, photons: u64, seed: u64) -> Vec<Photon> {
    trace(scene, &TraceOptions { photons, seed }, &|_| ())
        .unwrap()
        .photons
}

/// A built-in scene's map for about `in_range` photons in range, and query points at the places of an
/// independent map's photons.
fn case(name: &str, in_range: f64) -> (PhotonMap, Vec<(DVec3, DVec3)>) {
    let scene = Scene::built_in(name).unwrap();
    let photons = traced(&scene, 300_000, 1);
    let radius = PhotonMap::radius_for(&scene, photons.len() as u64, in_range);
    let map = PhotonMap::new(&scene, photons, radius).unwrap();
    let normal = |surface: u32| {
        scene.surfaces()[surface as usize]
            .geometry
            .flat_normal()
            .unwrap()
    };
    let points = traced(&scene, 10_000, 2);
    let queries = points.iter().map(|p| (p.position, normal(p.surface)));
    (map, queries.collect())
}

/// The rms error over the Monte-Carlo noise.
fn ratio(found: &Measured) -> f64 {
    found.rms / found.noise
}

/// anchors.md has, uniform, 50 in range: local6 1.06 % misclassified and 0.11 of the noise, local7
/// 0.53 and 0.08, local8 0.26 and 0.06. Measured here: 1.06 and 0.104, 0.54 and 0.074, 0.26
/// and 0.052; on half steps local7x1 has 0.42 and 0.065. The bounds leave a tenth for other seeds.
#[test]
fn the_cornell_boxs_errors_are_those_of_the_anchors() {
    let (map, queries) = case("cornell", 50.0);
    for (name, misclassified, error) in [
        ("local6-rgb8e5", 0.0117, 0.115),
        ("local7-rgb8e5", 0.0059, 0.082),
        ("local8-rgb8e5", 0.0029, 0.058),
        ("local7x1-rgb8b5", 0.0046, 0.072),
    ] {
        let found = measure(&map, &queries, &find_photon_format(name).unwrap());
        assert!(found.misclassified < misclassified, "{name}: {found:?}");
        assert!(
            found.misclassified > 0.5 * misclassified,
            "{name}: {found:?}"
        );
        assert!(ratio(&found) < error, "{name}: {found:?}");
    }
}

/// A tenth of the noise adds half a percent to it. The default and the narrower formats that hold
/// this everywhere, by their own exponents for each photon.
#[test]
fn the_error_is_below_a_tenth_of_the_noise_on_every_scene() {
    for name in Scene::names() {
        let (map, queries) = case(name, 50.0);
        for format in ["local8-rgb8e5", "local7x1-rgb8e5", "local7x1-rgb5e5"] {
            let found = measure(&map, &queries, &find_photon_format(format).unwrap());
            assert!(ratio(&found) < 0.1, "{name} {format}: {found:?}");
        }
    }
}

/// The limit of a block's exponent: beside a photon of 1e6 times their power in the block, other photons
/// round to zero, and queries that reach only these get no light.
#[test]
fn a_blocks_exponent_fails_on_the_wide_range() {
    let (map, queries) = case("range", 50.0);
    for format in ["local8-rgb8b5", "local8-rgb16b5"] {
        let found = measure(&map, &queries, &find_photon_format(format).unwrap());
        assert!(ratio(&found) > 1.0, "{format}: {found:?}");
    }
}
