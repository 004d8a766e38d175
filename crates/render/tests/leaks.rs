//! Light stays where surfaces keep it: a dark room beside a lit one is black, and a small ball has all of its light.

use std::path::Path;

use photoncube_render::{
    Area, Engine, Estimator, Image, Light, Lighting, PhotonMap, Scene, TraceOptions, ViewOptions,
    luminance, render_lit, trace,
};

/// A scene file of these shapes, seen from `position` towards `target`.
fn scene(position: [f64; 3], target: [f64; 3], fov_deg: u32, shapes: &[String]) -> Scene {
    let text = format!(
        "[camera]\nposition = {position:?}\ntarget = {target:?}\nfov_deg = {fov_deg}\n\
         [materials.grey]\ntype = \"diffuse\"\nreflectance = [0.5, 0.5, 0.5]\n\
         [materials.black]\ntype = \"diffuse\"\nreflectance = [0, 0, 0]\n{}",
        shapes.concat()
    );
    Scene::from_toml("leaks.toml", &text, Path::new("")).unwrap()
}

/// A shape of that type and material with these fields.
fn shape(kind: &str, material: &str, fields: &str) -> String {
    format!(
        "[[shapes]]\nname = \"{kind}\"\ntype = \"{kind}\"\nmaterial = \"{material}\"\n{fields}\n"
    )
}

/// A room whose fronts are inside.
fn room(material: &str, low: [f64; 3], high: [f64; 3]) -> String {
    let fields = format!("low = {low:?}\nhigh = {high:?}\ninward = true");
    shape("box", material, &fields)
}

/// A horizontal quad at that height. Its front is below where z runs from low to high, and above where from high to low.
fn flat(y: f64, [left, right]: [f64; 2], [near, far]: [f64; 2], emission: f64) -> String {
    let fields = format!(
        "corners = [[{left}, {y}, {near}], [{right}, {y}, {near}], [{right}, {y}, {far}], [{left}, {y}, {far}]]\n\
         emission = [{emission}, {emission}, {emission}]"
    );
    shape("quad", "grey", &fields)
}

/// Two rooms side by side, 0.002 apart, with floors, ceilings and back walls in common planes; a lamp in the right one. The camera is
/// in the right room or in the left one.
fn rooms(is_lit: bool) -> Scene {
    let x = if is_lit { 0.6 } else { -0.6 };
    let shapes = [
        room("grey", [-1.002, 0.0, 0.0], [-0.002, 2.0, 2.0]),
        room("grey", [0.0, 0.0, 0.0], [1.0, 2.0, 2.0]),
        flat(1.9, [0.3, 0.7], [0.8, 1.2], 5.0),
    ];
    scene([x, 1.0, 1.9], [x, 0.8, 0.0], 60, &shapes)
}

/// A floor below a lamp, whole or of two halves that share an edge.
fn floor(is_split: bool) -> Scene {
    let lamp = flat(2.0, [-0.4, 0.4], [-0.4, 0.4], 5.0);
    let part = |left, right| flat(0.0, [left, right], [1.0, -1.0], 0.0);
    let shapes = match is_split {
        true => vec![lamp, part(-1.0, 0.0), part(0.0, 1.0)],
        false => vec![lamp, part(-1.0, 1.0)],
    };
    scene([0.0, 1.5, 1.5], [0.0; 3], 40, &shapes)
}

/// A ball of reflectance 1/2 and radius 0.1 in a room whose walls all have a radiance of 1: the ball's radiance is 1/2 everywhere.
fn furnace() -> Scene {
    let walls = room("black", [-0.3; 3], [0.3; 3]) + "emission = [1, 1, 1]\n";
    let ball = shape("sphere", "grey", "center = [0, 0, 0]\nradius = 0.1");
    scene([0.0, 0.0, 0.28], [0.0; 3], 20, &[walls, ball])
}

fn picture(scene: &Scene, photons: u64, radius: f64, area: Area) -> Image {
    let options = TraceOptions { photons, seed: 3 };
    let photons = trace(scene, &options, &|_| ()).unwrap().photons;
    let map = PhotonMap::new(scene, photons, radius).unwrap();
    let lighting = Lighting {
        area,
        ..Lighting::default()
    };
    let light = Light {
        lighting: &lighting,
        global: &map,
        caustic: None,
        estimator: &Estimator::FixedRadius,
    };
    let view = ViewOptions {
        width: 16,
        height: 16,
        ..ViewOptions::default()
    };
    let rendered = render_lit(scene, light, Engine::F64, &view, &|_| ()).unwrap();
    rendered.image
}

fn brightest(image: &Image) -> f64 {
    image
        .pixels()
        .iter()
        .map(|rgb| luminance(*rgb))
        .fold(0.0, f64::max)
}

#[test]
fn a_dark_room_beside_a_lit_one_is_black() {
    for area in [Area::Disc, Area::Covered] {
        let dark = picture(&rooms(false), 20_000, 0.1, area);
        assert_eq!(brightest(&dark), 0.0, "{area}");
    }
    // In the lit room there is light, so the test sees what it looks for.
    assert!(brightest(&picture(&rooms(true), 20_000, 0.1, Area::Disc)) > 0.1);
}

#[test]
fn a_floor_of_two_halves_looks_like_a_whole_one() {
    for area in [Area::Disc, Area::Covered] {
        let [whole, split] =
            [false, true].map(|is_split| picture(&floor(is_split), 20_000, 0.1, area));
        for (whole, split) in whole.pixels().iter().zip(split.pixels()) {
            // 1e-9: the sums of the same photons in another order.
            assert!((*whole - *split).length() < 1e-9, "{whole} {split}");
        }
        assert!(brightest(&whole) > 0.1);
    }
}

#[test]
fn a_ball_smaller_than_the_search_sphere_has_its_light() {
    let mean = |radius, area| {
        let image = picture(&furnace(), 400_000, radius, area);
        let sum: f64 = image.pixels().iter().map(|rgb| luminance(*rgb)).sum();
        sum / image.pixels().len() as f64
    };
    for ratio in [0.5, 1.0, 1.4, 1.8] {
        // 10 %: the noise of some 20,000 photons on the ball, and the rounding of facings, which moves the border of the part that counts.
        let covered = mean(0.1 * ratio, Area::Covered) / 0.5;
        assert!((covered - 1.0).abs() < 0.1, "{ratio}: {covered}");
        let disc = mean(0.1 * ratio, Area::Disc) / 0.5;
        println!("{ratio}: {disc} by the disc, {covered} by the part of the ball that counts");
    }
    assert!(mean(0.18, Area::Disc) < 0.4 * 0.5);
}
