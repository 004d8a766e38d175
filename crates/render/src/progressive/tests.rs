use photoncube_spec::PHOTON_FORMATS;

use super::*;
use crate::image::{light_mask, rel_mse};
use crate::{Area, render};

const VIEW: ViewOptions = ViewOptions {
    width: 24,
    height: 24,
    samples_per_axis: 1,
    seed: 0,
};

/// The picture after `passes` passes by a rule.
fn by_rule(
    scene: &Scene,
    engine: Engine<'_>,
    lighting: Lighting,
    rule: RadiusRule,
    [photons, passes]: [u64; 2],
) -> (Image, Option<f64>) {
    let options = ProgressiveOptions {
        rule,
        ..options(photons, 2.0 / 3.0)
    };
    let view = ViewOptions {
        samples_per_axis: 2,
        ..VIEW
    };
    let mut progressive = Progressive::new(scene, engine, lighting, view, options).unwrap();
    (0..passes).for_each(|_| progressive.pass().unwrap());
    (progressive.image(), progressive.halvings_mean())
}

/// All light from the map: the ring's caustic and its shadow are sharp.
#[test]
fn sharp_light_by_the_map_has_less_error_by_the_chi_square_rule() {
    let scene = Scene::built_in("ring").unwrap();
    let rays = Lighting {
        direct: crate::DirectLight::Rays(8),
        caustics: crate::Caustics::OWN,
        ..Lighting::default()
    };
    let (schedule, chi_square) = (RadiusRule::Schedule, RadiusRule::ChiSquare);
    let (truth, none) = by_rule(&scene, Engine::F64, rays, schedule, [200_000, 16]);
    assert_eq!(none, None);
    let mask = light_mask(&truth, crate::LIGHT_RADIANCE);
    for engine in [Engine::F64, Engine::from(&PHOTON_FORMATS[0])] {
        let [before, now] = [schedule, chi_square].map(|rule| {
            let (image, _) = by_rule(&scene, engine, Lighting::default(), rule, [20_000, 64]);
            rel_mse(&image, &truth, &mask).unwrap()
        });
        // It falls to less than half, so neither the truth's own error nor other photons decide.
        assert!(now < 0.5 * before, "{now} {before}");
    }
}

#[test]
fn even_light_keeps_its_radius_by_the_chi_square_rule() {
    // Only the borders of the floor are uneven, which most of the picture does not see.
    let scene = Scene::built_in("cornell").unwrap();
    let lighting = Lighting::default();
    let of = |passes| {
        let rule = RadiusRule::ChiSquare;
        by_rule(&scene, Engine::F64, lighting, rule, [2_000, passes])
    };
    // The first pass has the plain radius everywhere, and with it the plain picture.
    let (first, _) = of(1);
    let plain = by_rule(
        &scene,
        Engine::F64,
        lighting,
        RadiusRule::Schedule,
        [2_000, 1],
    )
    .0;
    assert_eq!(first, plain);
    let [early, late] = [2, 16].map(|passes| of(passes).1.unwrap());
    assert!(early < late && late < 3.0, "{early} {late}");
}

fn options(photons: u64, alpha: f64) -> ProgressiveOptions {
    ProgressiveOptions {
        photons,
        alpha,
        ..ProgressiveOptions::default()
    }
}

#[test]
fn the_first_pass_is_the_plain_picture() {
    let scene = Scene::built_in("cornell").unwrap();
    let engine = Engine::from(&PHOTON_FORMATS[0]);
    let lighting = Lighting::default();
    let options = options(20_000, 0.5);
    let mut progressive = Progressive::new(&scene, engine, lighting, VIEW, options).unwrap();
    assert_eq!(progressive.radius(), None);
    progressive.pass().unwrap();
    let trace_options = TraceOptions {
        photons: 20_000,
        seed: 1,
    };
    let photons = trace(&scene, &trace_options, &|_| ()).unwrap().photons;
    let radius = crate::PhotonMap::radius_for(&scene, photons.len() as u64, 100.0);
    let map = crate::PhotonMap::new(&scene, photons, radius).unwrap();
    let view = ViewOptions { seed: 1, ..VIEW };
    let plain = render(&scene, &map, engine, &view, &|_| ()).unwrap();
    assert_eq!(progressive.image(), plain.image);
    // 1e-12: a division and a multiplication by the same number.
    assert!((progressive.radius().unwrap() / radius - 1.0).abs() < 1e-12);
    assert_eq!(progressive.error(0.9), None, "one pass tells nothing");
}

/// r_n^2 / r_1^2 is the product of (i + alpha) / (i + 1) over i below n.
#[test]
fn radii_fall_as_the_papers() {
    let scene = Scene::built_in("cornell").unwrap();
    let options = options(2_000, 0.6);
    let lighting = Lighting::default();
    let mut progressive = Progressive::new(&scene, Engine::F64, lighting, VIEW, options).unwrap();
    progressive.pass().unwrap();
    let first = progressive.radius().unwrap();
    progressive.pass().unwrap();
    progressive.pass().unwrap();
    let ratio = (progressive.radius().unwrap() / first).powi(2);
    assert!((ratio - 1.6 / 2.0 * 2.6 / 3.0).abs() < 1e-12, "{ratio}");
    assert!(progressive.photons() >= 6_000);
}

#[test]
fn the_error_falls_with_passes_and_its_bound_with_it() {
    let scene = Scene::built_in("cornell").unwrap();
    let lighting = Lighting {
        area: Area::Covered,
        ..Lighting::default()
    };
    let image = |seed, photons, passes| {
        let options = ProgressiveOptions {
            seed,
            ..options(photons, 2.0 / 3.0)
        };
        let mut progressive =
            Progressive::new(&scene, Engine::F64, lighting, VIEW, options).unwrap();
        (0..passes).for_each(|_| progressive.pass().unwrap());
        (progressive.image(), progressive.error(0.9).unwrap())
    };
    let (reference, _) = image(1000, 200_000, 24);
    let mask = light_mask(&reference, crate::LIGHT_RADIANCE);
    let [few, many] = [2, 24].map(|passes| {
        let (image, error) = image(1, 5_000, passes);
        (rel_mse(&image, &reference, &mask).unwrap().sqrt(), error)
    });
    // The root falls as i^(-1/3) or faster: by 2.3 from 2 to 24 passes.
    assert!(many.0 < few.0 / 2.0, "{} {}", few.0, many.0);
    assert!(many.1.bound() < few.1.bound() / 2.0);
    assert!(many.1.noise() < few.1.noise());
}

#[test]
fn a_factor_that_is_none_is_an_error() {
    let scene = Scene::built_in("cornell").unwrap();
    for alpha in [0.0, 1.0, f64::NAN] {
        let lighting = Lighting::default();
        let made = Progressive::new(&scene, Engine::F64, lighting, VIEW, options(1000, alpha));
        assert!(matches!(made.err(), Some(ProgressiveError::Alpha { .. })));
    }
}

/// With light sources of its own, and with caustics whose radius is found in a later pass.
#[test]
fn a_picture_that_is_continued_is_that_of_one_run() {
    let format = &PHOTON_FORMATS[0];
    let own = Lighting {
        caustics: crate::Caustics::Own(20.0),
        ..Lighting::default()
    };
    let (schedule, chi_square) = (RadiusRule::Schedule, RadiusRule::ChiSquare);
    for (scene, engine, lighting, rule) in [
        ("cornell", Engine::F64, Lighting::default(), schedule),
        ("ring", Engine::from(format), own, schedule),
        ("ring", Engine::F64, Lighting::default(), chi_square),
        ("cornell", Engine::from(format), own, chi_square),
    ] {
        let scene = Scene::built_in(scene).unwrap();
        let options = |photons, alpha| ProgressiveOptions {
            rule,
            ..options(photons, alpha)
        };
        let new = || Progressive::new(&scene, engine, lighting, VIEW, options(2_000, 0.6)).unwrap();
        let mut whole = new();
        (0..5).for_each(|_| whole.pass().unwrap());
        for before in [0, 1, 3, 5] {
            let mut first = new();
            (0..before).for_each(|_| first.pass().unwrap());
            let mut second = new();
            second.resume(first.state()).unwrap();
            (before..5).for_each(|_| second.pass().unwrap());
            assert_eq!(second.state(), whole.state(), "{before}");
            assert_eq!(second.image(), whole.image());
            assert_eq!(second.error(0.9), whole.error(0.9));
        }
        let view = ViewOptions { width: 23, ..VIEW };
        let mut other =
            Progressive::new(&scene, engine, lighting, view, options(2_000, 0.6)).unwrap();
        let said = other.resume(whole.state()).unwrap_err().to_string();
        assert_eq!(said, "found the state of 576 pixels, expected 552");
    }
}

/// The Cornell box with two balls so small that few passes have a caustic.
fn with_rare_caustics() -> Scene {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../docs/scenes/spheres.toml"
    );
    let text = std::fs::read_to_string(file).unwrap();
    let text = text.replace("radius = 0.4", "radius = 0.005");
    Scene::from_toml(file, &text, std::path::Path::new(".")).unwrap()
}

/// Several computers make a part of the passes each.
#[test]
fn parts_of_the_passes_merge_to_the_picture_of_one_run() {
    const PASSES: u64 = 9;
    let own = Lighting {
        caustics: crate::Caustics::Own(20.0),
        ..Lighting::default()
    };
    let format = Engine::from(&PHOTON_FORMATS[0]);
    let scenes = [Scene::built_in("cornell").unwrap(), with_rare_caustics()];
    for (scene, engine) in scenes.iter().zip([format, Engine::F64]) {
        let of_seed = |seed| {
            let options = ProgressiveOptions {
                seed,
                ..options(500, 0.6)
            };
            Progressive::new(scene, engine, own, VIEW, options).unwrap()
        };
        let caustic = |picture: &Progressive<'_>| picture.radii.unwrap().caustic;
        let is_rare = scene.surfaces().iter().any(Surface::is_specular);
        // The first seed with which a caustic is found, but not in the first pass.
        let seed = (1..100).find(|&seed| {
            let mut picture = of_seed(seed);
            picture.pass().unwrap();
            let first = caustic(&picture);
            (1..PASSES).for_each(|_| picture.pass().unwrap());
            first.is_none() && caustic(&picture).is_some() == is_rare
        });
        let new = || of_seed(seed.unwrap());
        let mut whole = new();
        (0..PASSES).for_each(|_| whole.pass().unwrap());
        for parts in [2, 7, 12] {
            let of = |first: usize| {
                let mut picture = new();
                let mut passes = (first as u64..PASSES).step_by(parts);
                passes.try_for_each(|pass| picture.make(pass)).unwrap();
                picture
            };
            let pictures: Vec<_> = (0..parts).rev().map(of).collect();
            let mut merged = pictures[0].state();
            for picture in &pictures[1..] {
                merged.merge(picture.state()).unwrap();
            }
            assert_eq!(merged, whole.state(), "{parts}");
        }
    }
}

#[test]
fn a_part_by_the_chi_square_rule_is_refused() {
    let scene = Scene::built_in("cornell").unwrap();
    let options = ProgressiveOptions {
        rule: RadiusRule::ChiSquare,
        ..options(1_000, 0.6)
    };
    let lighting = Lighting::default();
    let mut picture = Progressive::new(&scene, Engine::F64, lighting, VIEW, options).unwrap();
    let said = picture.make(1).unwrap_err().to_string();
    assert!(
        said.starts_with("found pass 1, expected the next, 0"),
        "{said}"
    );
}
