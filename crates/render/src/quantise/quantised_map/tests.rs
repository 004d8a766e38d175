use photoncube_model::gather;
use photoncube_spec::{MACHINES, PlainFormat, find_machine};
use proptest::prelude::*;

use super::*;
use crate::scene::fixtures::traced_cornell;
use crate::view::Front;
use crate::{Photon, Scene};

const RADIUS: f64 = 0.2;

fn map() -> PhotonMap {
    traced_cornell(5_000, 4, RADIUS).1
}

#[test]
fn positions_are_off_by_less_than_a_step() {
    let map = map();
    for name in ["paper", "paper-12"] {
        let machine = find_machine(name).unwrap();
        let quantised = QuantisedMap::new(&map, &machine.numbers).unwrap();
        let step = RADIUS / f64::from(1 << machine.position_bits());
        for query in map.photons().iter().step_by(211) {
            let normal = DVec3::Y;
            let integers: Vec<_> = quantised
                .photons(query.position, Front::of_any(normal))
                .collect();
            let floats: Vec<usize> = map
                .candidates(query.position, Front::of_any(normal))
                .flat_map(|c| c.photons)
                .collect();
            assert_eq!(integers.len(), floats.len());
            let centre = quantised.query(query.position).position;
            for (integer, &index) in integers.iter().zip(&floats) {
                let difference = map.photons()[index].position - query.position;
                for axis in 0..3 {
                    let steps = f64::from(integer.position[axis]) - f64::from(centre[axis]);
                    // Two floors: the error of the difference is less than one step, plus rounding.
                    assert!((steps * step - difference[axis]).abs() < step * 1.000001);
                }
            }
        }
    }
}

#[test]
fn the_radius_is_the_maps_also_in_larger_blocks() {
    let machine = find_machine("paper").unwrap();
    for (edge, radius_sq) in [(RADIUS, 64 * 64), (RADIUS * 16.0 / 14.0, 56 * 56)] {
        let map = map().reblocked(edge).unwrap();
        let quantised = QuantisedMap::new(&map, &machine.numbers).unwrap();
        assert_eq!(quantised.query(DVec3::ZERO).radius_sq, radius_sq);
    }
}

#[test]
fn powers_use_the_whole_range_and_round_to_nearest() {
    let map = map();
    let quantised = QuantisedMap::new(&map, &find_machine("paper").unwrap().numbers).unwrap();
    let powers = || quantised.records().iter().map(|p| p.mantissa);
    assert_eq!(powers().flatten().max(), Some(u16::MAX));
    for (stored, photon) in powers().zip(map.photons()) {
        let error = DVec3::from(stored.map(f64::from)) - photon.power / quantised.step(0);
        // Half a step, and the rounding of the quotient.
        assert!(error.abs().max_element() < 0.500001);
    }
}

/// One photon has a million times the power of the strongest other one: less than half a step of 16 bits, and far within an
/// exponent of 5 bits.
#[test]
fn photons_that_lose_their_power_are_counted() {
    let scene = Scene::built_in("cornell").unwrap();
    let mut photons: Vec<_> = map().traced_photons().collect();
    let powers = photons.iter().map(|photon| photon.power.max_element());
    photons[0].power = DVec3::splat(1e6 * powers.fold(0.0, f64::max));
    let others = photons.len() as u64 - 1;
    let map = PhotonMap::new(&scene, photons, RADIUS).unwrap();
    let lost = |numbers: &Numbers| {
        let quantised = QuantisedMap::new(&map, numbers).unwrap();
        quantised.photons_without_power()
    };
    assert_eq!(lost(&find_machine("paper").unwrap().numbers), others);
    let format = |name: &str| Numbers::Local(photoncube_spec::find_photon_format(name).unwrap());
    assert_eq!(lost(&format("local8-rgb8e5")), 0);
    assert_eq!(lost(&format("local8-rgb8")), others);
    // Dithered, the light is right on average.
    assert_eq!(lost(&format("local8-rgb8d")), 0);
}

#[test]
fn a_map_without_light_is_all_zero() {
    let scene = Scene::built_in("cornell").unwrap();
    let dark = Photon {
        position: DVec3::ZERO,
        power: DVec3::ZERO,
        surface: 0,
        facing: crate::Facing::FLAT,
    };
    let map = PhotonMap::new(&scene, vec![dark], RADIUS).unwrap();
    let quantised = QuantisedMap::new(&map, &find_machine("paper").unwrap().numbers).unwrap();
    assert_eq!(quantised.records()[0].mantissa, [0; 3]);
}

#[test]
fn formats_that_do_not_fit_are_errors() {
    let map = map();
    let paper = find_machine("paper").unwrap();
    let with = |coordinate_bits, power_bits| {
        Numbers::Plain(PlainFormat {
            coordinate_bits,
            power_bits,
            ..*paper.plain().unwrap()
        })
    };
    for (coordinate_bits, power_bits) in [(2, 16), (18, 16), (8, 0), (8, 17)] {
        assert!(QuantisedMap::new(&map, &with(coordinate_bits, power_bits)).is_err());
    }
    let error = QuantisedMap::new(&map, &with(8, 17)).unwrap_err();
    let expected = "the plain format of 8-bit coordinates and 17-bit powers: power_bits is 17, expected 1 to 16";
    assert_eq!(error.to_string(), expected);
}

proptest! {
    /// At any position, the query is in the frame's second block.
    #[test]
    fn queries_stay_in_their_block(x in prop::num::f64::ANY, y in -1.0..1.0f64, z in -1e-9..1e-9f64) {
        let map = PhotonMap::new(&Scene::built_in("cornell").unwrap(), vec![], RADIUS).unwrap();
        let machine = find_machine("paper").unwrap();
        let quantised = QuantisedMap::new(&map, &machine.numbers).unwrap();
        let query = quantised.query(DVec3::new(x, y, z));
        prop_assert!(query.position.iter().all(|c| (64..128).contains(c)));
        prop_assert_eq!(query.radius_sq, 64 * 64);
    }
}

/// The sums of a machine on its words equal those of its numbers' gather on the records.
#[test]
fn a_machine_sums_what_its_format_does() {
    let (scene, map) = traced_cornell(5_000, 4, RADIUS);
    for machine in MACHINES {
        let quantised = QuantisedMap::new(&map, &machine.numbers).unwrap();
        let mut in_range = 0;
        for photon in map.traced_photons().step_by(97) {
            let normal = scene.surfaces()[photon.surface as usize]
                .geometry
                .flat_normal()
                .unwrap();
            let streamed = quantised.photons(photon.position, Front::of_any(normal));
            let sums = gather(machine, &quantised.query(photon.position), streamed).unwrap();
            let expected = quantised
                .gather(photon.position, Front::of_any(normal))
                .unwrap();
            assert_eq!(sums, expected);
            in_range += sums.count;
        }
        assert!(in_range > 0);
    }
}
