//! Moved, scaled, permuted: the same bits.

use glam::DVec3;
use photoncube_render::{FormatMap, Photon};
use photoncube_spec::{PHOTON_FORMATS, PhotonFormat, PhotonRecord};

use crate::room::{Case, unit_photons};

const RADIUS: f64 = 0.11;

fn records(case: &Case, format: &PhotonFormat) -> Vec<PhotonRecord> {
    FormatMap::new(&case.map(), format)
        .unwrap()
        .records()
        .to_vec()
}

fn assert_same(case: &Case, other: &Case) {
    for format in PHOTON_FORMATS {
        let sums = case.sums(format);
        assert!(sums.iter().any(|s| s.count > 1) && sums.iter().any(|s| s.power[0] > 0));
        assert_eq!(sums, other.sums(format), "{format}");
        assert_eq!(records(case, format), records(other, format));
    }
}

#[test]
fn a_scene_moved_by_1e6_gives_the_same_bits() {
    let case = Case::unit(unit_photons(5_000), RADIUS);
    for low in [DVec3::splat(1e6), DVec3::new(-1e6, 0.0, 3.25)] {
        let moved = Case::placed(low, 1.0, unit_photons(5_000), RADIUS);
        assert_eq!(moved.photons[0].position - low, case.photons[0].position);
        assert_same(&case, &moved);
    }
}

/// By powers of two this holds always. By 1e-3 and 1e6, positions round by 1e-16 of the scene: none
/// of these 5000 is that close to the border of its cell.
#[test]
fn a_scaled_scene_gives_the_same_bits() {
    let case = Case::unit(unit_photons(5_000), RADIUS);
    for size in [2_f64.powi(-10), 2_f64.powi(20), 1e-3, 1e6] {
        assert_same(
            &case,
            &Case::placed(DVec3::ZERO, size, unit_photons(5_000), RADIUS),
        );
    }
}

#[test]
fn scaled_powers_give_the_same_bits_and_another_unit() {
    let case = Case::unit(unit_photons(5_000), RADIUS);
    let brighter = |photon: Photon| Photon {
        power: photon.power * 1024.0,
        ..photon
    };
    let photons = unit_photons(5_000).into_iter().map(brighter).collect();
    let brighter = Case::unit(photons, RADIUS);
    assert_same(&case, &brighter);
    let unit = |case: &Case| {
        FormatMap::new(&case.map(), &PHOTON_FORMATS[0])
            .unwrap()
            .flux([1; 3])
    };
    assert_eq!(unit(&case) * 1024.0, unit(&brighter));
}

#[test]
fn permuted_photons_give_the_same_sums() {
    let case = Case::unit(unit_photons(5_000), RADIUS);
    for format in PHOTON_FORMATS {
        let map = case.map();
        let mut permuted = case.photons.clone();
        permuted.reverse();
        permuted.rotate_left(1234);
        let permuted = Case::unit(permuted, RADIUS).map();
        let (a, b) = (
            FormatMap::new(&map, format),
            FormatMap::new(&permuted, format),
        );
        let (a, b) = (a.unwrap(), b.unwrap());
        for query in case.photons.iter().step_by(37) {
            let sums = |map: &FormatMap<'_>| map.gather(query.position, DVec3::Y).unwrap();
            assert_eq!(sums(&a), sums(&b));
        }
    }
}
