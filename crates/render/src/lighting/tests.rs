use std::f64::consts::PI;

use super::*;
use crate::render::{Engine, Light, render_lit};
use crate::trace::sample::{Purpose, stream};
use crate::trace::{TraceOptions, trace};
use crate::view::ViewOptions;
use glam::DVec3;
use photoncube_spec::{PHOTON_FORMATS, find_machine, find_photon_format};

const CORNELL: &str = include_str!("../../scenes/cornell.json");

/// The Cornell box without its boxes.
fn empty_box() -> Scene {
    let mut json: serde_json::Value = serde_json::from_str(CORNELL).unwrap();
    let shapes = json["shapes"].as_object_mut().unwrap();
    shapes.retain(|_, shape| shape["kind"] == "quad");
    Scene::from_json("empty", &json.to_string()).unwrap()
}

fn spheres() -> Scene {
    let text = include_str!("../../../../docs/scenes/spheres.json");
    Scene::from_json("spheres", text).unwrap()
}

fn named(direct: &str, caustics: &str, final_gather: u32, area: &str) -> Lighting {
    Lighting {
        direct: direct.parse().unwrap(),
        caustics: caustics.parse().unwrap(),
        final_gather,
        area: area.parse().unwrap(),
    }
}

/// The form factor of a rectangle of sides `a` and `b`, in units of its distance, to a point below one of its
/// corners that faces it (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-3).
fn corner_form_factor(a: f64, b: f64) -> f64 {
    let part = |a: f64, b: f64| {
        let root = (1.0 + a * a).sqrt();
        a / root * (b / root).atan()
    };
    (part(a, b) + part(b, a)) / (2.0 * PI)
}

#[test]
fn shadow_rays_give_the_form_factor() {
    let scene = empty_box();
    let light = scene.surfaces().iter().find(|s| s.shape == "light");
    let light = light.unwrap();
    let [low, high] = light.geometry.bounds();
    let centre = low.midpoint(high);
    let query = QueryPoint {
        position: DVec3::new(centre.x, -1.0, centre.z),
        normal: DVec3::Y,
        surface: None,
        beta: DVec3::ONE,
    };
    let half = (high - low) / 2.0 / (centre.y + 1.0);
    let expected = PI * 4.0 * corner_form_factor(half.x, half.z) * light.radiance;
    let mut points = Apart::new(&mut stream(1, Purpose::Light, 0));
    let found = Shadows::of(&scene).irradiance(&query, 20_000, &mut points);
    // The integrand varies by some 5 % over the light, so the mean of 20,000 by far less than 0.2 %.
    let error = ((found - expected) / expected).abs().max_element();
    assert!(error < 0.002, "{found} {expected}");
}

/// A point under a box's bottom edge receives no light, nor does a point whose front is turned away.
#[test]
fn what_is_in_the_way_casts_a_shadow() {
    let scene = Scene::built_in("cornell").unwrap();
    let shadows = Shadows::of(&scene);
    let at = |position: [f64; 3], normal| {
        let query = QueryPoint {
            position: position.into(),
            normal,
            surface: None,
            beta: DVec3::ONE,
        };
        let mut points = Apart::new(&mut stream(1, Purpose::Light, 0));
        shadows.irradiance(&query, 64, &mut points)
    };
    assert!(at([0.0, -1.0, 0.9], DVec3::Y).min_element() > 0.0);
    assert_eq!(at([0.0, -1.0, 0.9], DVec3::NEG_Y), DVec3::ZERO);
    // The point is left of the tall box, by the red wall, at the box's back.
    assert_eq!(at([-0.9, -0.9, -0.95], DVec3::Y), DVec3::ZERO);
}

/// The mean radiance of a small picture.
fn mean(scene: &Scene, lighting: &Lighting, engine: Engine<'_>) -> DVec3 {
    let pixels = pixels(scene, lighting, engine);
    pixels.iter().copied().sum::<DVec3>() / pixels.len() as f64
}

fn pixels(scene: &Scene, lighting: &Lighting, engine: Engine<'_>) -> Vec<DVec3> {
    let options = TraceOptions {
        photons: 300_000,
        seed: 8,
    };
    let trace = trace(scene, &options, &|_| ()).unwrap();
    let radii = Radii::of(scene, &trace, lighting, 100.0);
    let maps = PhotonMaps::new(scene, trace, lighting, radii).unwrap();
    let light = Light {
        lighting,
        global: &maps.global,
        caustic: maps.caustic.as_ref(),
        estimator: &Estimator::FixedRadius,
    };
    let view = ViewOptions {
        width: 32,
        height: 32,
        samples_per_axis: 2,
        seed: 8,
    };
    let rendering = render_lit(scene, light, engine, &view, &|_| ()).unwrap();
    rendering.image.pixels().to_vec()
}

/// However light is divided among photons and rays, the result is equal.
#[test]
fn every_lighting_gives_the_same_light() {
    let format = Engine::from(&PHOTON_FORMATS[0]);
    for (name, scene) in [
        ("cornell", Scene::built_in("cornell").unwrap()),
        ("spheres", spheres()),
    ] {
        let all = mean(&scene, &named("map", "map", 0, "covered"), Engine::F64);
        for (lighting, engine) in [
            (named("rays:2", "map", 0, "covered"), Engine::F64),
            (named("map", "own", 0, "covered"), Engine::F64),
            (named("rays:2", "own", 0, "covered"), format),
            (named("rays:2", "own", 4, "covered"), Engine::F64),
            (named("rays:2", "own", 4, "covered"), format),
        ] {
            let found = mean(&scene, &lighting, engine);
            let error = ((found - all) / all).abs().max_element();
            // Noise: 4,096 view rays of 100 photons, of which neighbours share most, 0.5 %; 16,384 gather rays whose
            // radiances vary by about their mean, 0.8 %. Bias: shadows leak by the radius, near 1 % of the light.
            assert!(error < 0.025, "{name} {lighting:?}: {found} {all}");
        }
    }
}

/// Division by the covered area changes pixels at a border, by up to a factor of two (four in a corner), and
/// no others.
#[test]
fn the_covered_area_keeps_borders_bright() {
    let [disc, covered] = ["disc", "covered"]
        .map(|area| pixels(&empty_box(), &named("map", "map", 0, area), Engine::F64));
    let seen = disc.iter().zip(&covered).filter(|(d, _)| d.x > 0.0);
    let mut ratios: Vec<f64> = seen.map(|(disc, covered)| covered.x / disc.x).collect();
    ratios.sort_by(f64::total_cmp);
    let quantile = |part: f64| ratios[(part * (ratios.len() - 1) as f64) as usize];
    // Above the light the ceiling is a second front in the sphere, which halves the light at most. 1e-3: the
    // walls' single-precision corners.
    assert!(
        quantile(0.0) > 0.5 && quantile(0.02) > 1.0 - 1e-3,
        "{}",
        quantile(0.02)
    );
    assert!(quantile(0.5) < 1.0 + 1e-3, "{}", quantile(0.5));
    assert!(
        quantile(1.0) > 1.3 && quantile(1.0) < 4.0,
        "{}",
        quantile(1.0)
    );
}

#[test]
fn what_does_not_fit_together_is_an_error() {
    let scene = Scene::built_in("ring").unwrap();
    let check = |lighting: Lighting, estimator| lighting.check(&scene, estimator);
    let fixed = &Estimator::FixedRadius;
    assert_eq!(check(Lighting::default(), fixed), Ok(()));
    assert_eq!(check(named("rays", "own", 8, "covered"), fixed), Ok(()));
    let error = check(named("map", "own", 8, "disc"), fixed).unwrap_err();
    assert!(error.to_string().contains("shadow rays"), "{error}");
    let error = check(named("rays", "map", 8, "disc"), fixed).unwrap_err();
    assert!(error.to_string().contains("map of their own"), "{error}");
    let error = check(
        named("map", "map", 0, "covered"),
        &Estimator::KNearest { k: 50 },
    );
    assert!(error.unwrap_err().to_string().contains("knn:50"));
    // Without mirrors there are no caustics that a map of their own would have to hold.
    let cornell = Scene::built_in("cornell").unwrap();
    assert_eq!(
        named("rays", "map", 8, "disc").check(&cornell, fixed),
        Ok(())
    );
}

/// A picture by an engine is the same from maps in its own blocks as from any, bit for bit, and so is its work. One channel's colour is a
/// sum in the map's order.
#[test]
fn maps_in_the_blocks_of_an_engine_give_its_picture() {
    let scene = spheres();
    let lighting = named("map", "own:30", 0, "disc");
    let options = TraceOptions {
        photons: 40_000,
        seed: 9,
    };
    let traced = trace(&scene, &options, &|_| ()).unwrap();
    let radii = Radii::of(&scene, &traced, &lighting, 50.0);
    let formats = ["local8-rgb8e5", "local8-mono16", "local7-mono5b3d"];
    let formats = formats.map(|name| find_photon_format(name).unwrap());
    let mut engines: Vec<_> = formats.iter().map(Engine::from).collect();
    engines.push(find_machine("paper").unwrap().into());
    for engine in engines {
        let any = PhotonMaps::new(&scene, traced.clone(), &lighting, radii).unwrap();
        let own = PhotonMaps::for_engine(&scene, traced.clone(), &lighting, radii, engine).unwrap();
        assert!(own.caustic.is_some());
        assert_eq!(own.global.edge(), engine.edge(radii.global));
        let [any, own] = [any, own].map(|maps| {
            let light = Light {
                lighting: &lighting,
                global: &maps.global,
                caustic: maps.caustic.as_ref(),
                estimator: &Estimator::FixedRadius,
            };
            let view = ViewOptions {
                width: 24,
                height: 24,
                samples_per_axis: 1,
                seed: 9,
            };
            render_lit(&scene, light, engine, &view, &|_| ()).unwrap()
        });
        assert_eq!(own.image, any.image);
        assert_eq!(own.stats, any.stats);
    }
}
