//! Cases that broke something in trials, at the level of formats.

use glam::DVec3;
use photoncube_render::{
    Engine, FormatMap, PhotonMap, RenderError, Scene, TraceOptions, ViewOptions, render, trace,
};
use photoncube_spec::{Exponent, PHOTON_FORMATS, PhotonFormat};

use crate::room::{Case, NORMAL, format, photon, unit_photons};

const DEFAULT: &PhotonFormat = &PHOTON_FORMATS[0];
const MIDDLE: DVec3 = DVec3::splat(0.5);

#[test]
fn no_photons_and_no_light() {
    for format in PHOTON_FORMATS {
        let empty = Case::unit(vec![], 0.1).map();
        let quantised = FormatMap::new(&empty, format).unwrap();
        assert_eq!(quantised.gather(MIDDLE, NORMAL), Ok(Default::default()));
        let dark = Case::unit(vec![photon(MIDDLE, DVec3::ZERO)], 0.1).map();
        let sums = FormatMap::new(&dark, format)
            .unwrap()
            .gather(MIDDLE, NORMAL)
            .unwrap();
        assert_eq!((sums.power, sums.count), ([0; 3], 1));
    }
}

#[test]
fn one_photon_keeps_its_power() {
    let power = DVec3::new(4.0, 2.0, 1.0);
    for format in PHOTON_FORMATS {
        let map = Case::unit(vec![photon(MIDDLE, power)], 0.1).map();
        let quantised = FormatMap::new(&map, format).unwrap();
        // Half a step of the strongest channel's mantissa.
        let bound = 4.0 * 0.5 / f64::from((1 << format.power.mantissa_bits) - 1);
        let error = (quantised.power(0) - power).abs().max_element();
        assert!(error <= bound * 1.000001, "{}: {error}", format);
        assert_eq!(quantised.gather(MIDDLE, NORMAL).unwrap().count, 1);
    }
}

#[test]
fn a_quarter_million_identical_photons_in_one_block() {
    let photons = vec![photon(MIDDLE, DVec3::new(3.0, 2.0, 1.0)); 250_000];
    let map = Case::unit(photons, 0.1).map();
    for format in PHOTON_FORMATS {
        let quantised = FormatMap::new(&map, format).unwrap();
        assert_eq!(quantised.map().blocks(), 1);
        let sums = quantised.gather(MIDDLE, NORMAL).unwrap();
        assert_eq!(sums.count, 250_000);
        let power = quantised.flux(sums.power);
        let expected = quantised.power(0) * 250_000.0;
        assert!((power / expected - 1.0).abs().max_element() < 1e-12);
    }
}

/// On block borders and one float to either side, photon and query get the same cell: none is lost
/// past the last cell where rounding makes a fraction exactly 1.
#[test]
fn positions_at_block_borders_stay_in_their_block() {
    for format in PHOTON_FORMATS {
        let edge = FormatMap::edge_for(format, 0.1);
        for border in 0..9 {
            let at = (f64::from(border) + 0.5) * edge;
            for x in [at.next_down(), at, at.next_up(), at - 1e-18] {
                let position = DVec3::new(x, x, 0.25);
                let map = Case::unit(vec![photon(position, DVec3::ONE)], 0.1).map();
                let quantised = FormatMap::new(&map, format).unwrap();
                let query = quantised.query(position).position;
                let cell = quantised.records()[0].position.map(u32::from);
                let steps = format.edge_steps();
                assert_eq!(query.map(|q| (q - steps) >> format.query_extra_bits), cell);
                assert_eq!(quantised.gather(position, NORMAL).unwrap().count, 1);
            }
        }
    }
}

#[test]
fn a_radius_larger_than_the_scene_gathers_all() {
    let case = Case::unit(unit_photons(2_000), 20.0);
    for format in PHOTON_FORMATS {
        assert!(
            case.sums(format).iter().all(|sums| sums.count == 2_000),
            "{}",
            format
        );
    }
}

/// A bright photon a format's step outside the radius adds nothing; one as far inside all.
#[test]
fn a_bright_photon_just_outside_the_radius_is_not_seen() {
    for name in [
        "local8-rgb8e5",
        "local7x1-rgb8e5",
        "local12-rgb8e5",
        "local4-rgb8e5",
    ] {
        let format = format(name);
        let step = 0.1 / f64::from(format.radius_steps());
        let cell = step * f64::from(1 << format.query_extra_bits);
        for (distance, expected) in [(0.1 + cell, 1), (0.1 - cell, 2)] {
            let faint = photon(MIDDLE, DVec3::ONE);
            let bright = photon(MIDDLE + distance * DVec3::X, DVec3::splat(1e6));
            let map = Case::unit(vec![faint, bright], 0.1).map();
            let sums = FormatMap::new(&map, &format)
                .unwrap()
                .gather(MIDDLE, NORMAL)
                .unwrap();
            assert_eq!(sums.count, expected, "{name}");
        }
    }
}

/// RGBE keeps every photon to half a step of its own mantissa, even 1e6 times below the brightest of
/// its block. A block's exponent loses those: the error is half a step of the block's brightest.
#[test]
fn powers_over_1e6_to_1_in_one_block() {
    let power = |k: u32| DVec3::splat(10_f64.powf(-f64::from(k) * 0.006));
    let photons: Vec<_> = (0..=1000).map(|k| photon(MIDDLE, power(k))).collect();
    let map = Case::unit(photons, 0.1).map();
    for format in PHOTON_FORMATS {
        let quantised = FormatMap::new(&map, format).unwrap();
        let full = f64::from((1 << format.power.mantissa_bits) - 1);
        for (index, photon) in quantised.map().photons().iter().enumerate() {
            let error = (quantised.power(index) - photon.power).abs().max_element();
            let bound = match format.power.exponent {
                Exponent::None | Exponent::Block { .. } => 0.5 / full,
                // A mantissa is at least half of full scale, but for rounding.
                Exponent::Photon { .. } => photon.power.x / full,
            };
            assert!(error <= bound * 1.000001, "{} {index}", format);
        }
    }
}

/// A block's exponent follows its own photons: a dim block keeps its detail beside a bright one.
#[test]
fn powers_over_1e6_to_1_across_blocks() {
    let dim = DVec3::new(3e-6, 2e-6, 1e-6);
    let photons = vec![
        photon(DVec3::splat(0.1), DVec3::splat(3.0)),
        photon(DVec3::splat(0.9), dim),
    ];
    let map = Case::unit(photons, 0.1).map();
    let quantised = FormatMap::new(&map, &format("local8-rgb8b5")).unwrap();
    let index = quantised
        .map()
        .photons()
        .iter()
        .position(|p| p.power == dim)
        .unwrap();
    let error = (quantised.power(index) - dim).abs().max_element();
    // The exponent is the smallest that fits: a mantissa of at least half of 255.
    assert!(error <= 3e-6 / 255.0, "{error}");
}

#[test]
fn powers_round_to_nearest_without_bias() {
    let map = Case::unit(unit_photons(20_000), 0.1).map();
    let quantised = FormatMap::new(&map, DEFAULT).unwrap();
    let photons = quantised.map().photons().iter().enumerate();
    let error: f64 = photons
        .map(|(index, photon)| {
            let exact = photon.power.max_element();
            (quantised.power(index).max_element() - exact) / exact
        })
        .sum::<f64>()
        / 20_000.0;
    // Deviation 0.29 steps of at most 1/128, over the root of 20,000: 1.6e-5; truncation: -3e-3.
    assert!(error.abs() < 1e-4, "{error}");
}

#[test]
fn a_query_of_too_many_photons_is_refused_with_the_pixel() {
    let scene = Scene::built_in("cornell").unwrap();
    let options = TraceOptions {
        photons: 20_000,
        seed: 9,
    };
    let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
    let map = PhotonMap::new(&scene, photons, 0.15).unwrap();
    let view = ViewOptions {
        width: 8,
        height: 8,
        samples_per_axis: 1,
        seed: 9,
    };
    let small = PhotonFormat {
        max_photons: 3,
        ..*DEFAULT
    };
    let error = render(&scene, &map, Engine::Format(&small), &view, &|_| ()).unwrap_err();
    assert!(matches!(error, RenderError::LocalGather { .. }));
    assert!(
        error
            .to_string()
            .contains("over the 3 that format `local8-rgb8e5-n3` declares")
    );
    let illegal = PhotonFormat {
        position_bits: 13,
        ..*DEFAULT
    };
    let error = render(&scene, &map, Engine::Format(&illegal), &view, &|_| ()).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("position_bits is 13, expected 4 to 12")
    );
}

/// A caustic of 1/1000 of the scene with a radius of 1/2000: formats are relative to the radius, so
/// no more photons change sides than in any other place, 0.67 in a radius's steps.
#[test]
fn a_tight_caustic_is_as_accurate_as_any_place() {
    let mut photons = unit_photons(5_000);
    for photon in &mut photons {
        photon.position = MIDDLE + 1e-3 * photon.position;
    }
    let case = Case::unit(photons, 1.0 / 2000.0);
    let map = case.map();
    let quantised = FormatMap::new(&map, DEFAULT).unwrap();
    let (mut wrong, mut in_range) = (0, 0);
    for query in case.photons.iter().step_by(37) {
        for (photon, verdict) in quantised.verdicts(query.position, NORMAL) {
            let truly = photon.position.distance(query.position) <= map.radius();
            wrong += u64::from(verdict != truly);
            in_range += u64::from(truly);
        }
    }
    // Twice the expected share, for a volume's photons and the few there are.
    let share = wrong as f64 / in_range as f64;
    assert!(
        in_range > 10_000 && share < 2.0 * 0.67 / 254.0,
        "{wrong} of {in_range}"
    );
}
