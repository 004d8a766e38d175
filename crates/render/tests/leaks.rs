//! Light stays where surfaces keep it: a dark room beside a lit one is black, and a small ball has all of its light.

use std::path::Path;

use photoncube_render::{
    Area, Engine, Estimator, Image, Light, Lighting, PhotonMap, Scene, TraceOptions, ViewOptions,
    luminance, render_lit, trace,
};

/// Two rooms side by side, 0.002 apart, with floors, ceilings and back walls in common planes; a lamp in the right one. The camera is in
/// the left one.
const ROOMS: &str = r#"
[camera]
position = [-0.6, 1, 1.9]
target = [-0.5, 0.8, 0]
fov_deg = 60
[materials.grey]
type = "diffuse"
reflectance = [0.5, 0.5, 0.5]
[[shapes]]
name = "dark"
type = "box"
low = [-1.002, 0, 0]
high = [-0.002, 2, 2]
inward = true
material = "grey"
[[shapes]]
name = "lit"
type = "box"
low = [0, 0, 0]
high = [1, 2, 2]
inward = true
material = "grey"
[[shapes]]
name = "lamp"
type = "quad"
emission = [5, 5, 5]
material = "grey"
corners = [[0.3, 1.9, 0.8], [0.7, 1.9, 0.8], [0.7, 1.9, 1.2], [0.3, 1.9, 1.2]]
"#;

/// The floor of a lit room, whole or of two halves that share an edge.
fn halves(is_split: bool) -> String {
    let floor = |name: &str, low: f64, high: f64| {
        format!(
            "[[shapes]]\nname = \"{name}\"\ntype = \"quad\"\nmaterial = \"grey\"\n\
             corners = [[{low}, 0, 1], [{high}, 0, 1], [{high}, 0, -1], [{low}, 0, -1]]\n"
        )
    };
    let floors = match is_split {
        true => floor("left", -1.0, 0.0) + &floor("right", 0.0, 1.0),
        false => floor("floor", -1.0, 1.0),
    };
    format!(
        r#"
[camera]
position = [0, 1.5, 1.5]
target = [0, 0, 0]
fov_deg = 40
[materials.grey]
type = "diffuse"
reflectance = [0.5, 0.5, 0.5]
[[shapes]]
name = "lamp"
type = "quad"
emission = [5, 5, 5]
material = "grey"
corners = [[-0.4, 2, -0.4], [0.4, 2, -0.4], [0.4, 2, 0.4], [-0.4, 2, 0.4]]
{floors}"#
    )
}

fn picture(text: &str, photons: u64, radius: f64, area: Area) -> Image {
    let scene = Scene::from_toml("leaks.toml", text, Path::new("")).unwrap();
    let options = TraceOptions { photons, seed: 3 };
    let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
    let map = PhotonMap::new(&scene, photons, radius).unwrap();
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
    let rendered = render_lit(&scene, light, Engine::F64, &view, &|_| ()).unwrap();
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
        assert_eq!(brightest(&picture(ROOMS, 20_000, 0.1, area)), 0.0, "{area}");
    }
    // From the lit room there is light, so the test sees what it looks for.
    let lit = ROOMS
        .replace("[-0.6, 1, 1.9]", "[0.6, 1, 1.9]")
        .replace("[-0.5, 0.8, 0]", "[0.5, 0.8, 0]");
    assert!(brightest(&picture(&lit, 20_000, 0.1, Area::Disc)) > 0.1);
}

#[test]
fn a_floor_of_two_halves_looks_like_a_whole_one() {
    for area in [Area::Disc, Area::Covered] {
        let [whole, split] =
            [false, true].map(|is_split| picture(&halves(is_split), 20_000, 0.1, area));
        for (whole, split) in whole.pixels().iter().zip(split.pixels()) {
            // 1e-9: the sums of the same photons in another order.
            assert!((*whole - *split).length() < 1e-9, "{whole} {split}");
        }
        assert!(brightest(&whole) > 0.1);
    }
}

/// A ball of reflectance 1/2 in a room whose walls all have a radiance of 1: its radiance is 1/2 everywhere.
const FURNACE: &str = r#"
[camera]
position = [0, 0, 0.28]
target = [0, 0, 0]
fov_deg = 20
[materials.grey]
type = "diffuse"
reflectance = [0.5, 0.5, 0.5]
[materials.black]
type = "diffuse"
reflectance = [0, 0, 0]
[[shapes]]
name = "room"
type = "box"
low = [-0.3, -0.3, -0.3]
high = [0.3, 0.3, 0.3]
inward = true
material = "black"
emission = [1, 1, 1]
[[shapes]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 0.1
material = "grey"
"#;

#[test]
fn a_ball_smaller_than_the_search_sphere_has_its_light() {
    let mean = |radius, area| {
        let image = picture(FURNACE, 400_000, radius, area);
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
