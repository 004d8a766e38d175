//! The whole chain against an independent renderer: the built-in scene, photon-mapped through
//! the golden model, beside Mitsuba's path-traced image of it.

use std::path::Path;

use photoncube_render::{
    Engine, Image, LIGHT_RADIANCE, PhotonMap, Rendering, Scene, TraceOptions, ViewOptions,
    light_mask, rel_mse, render, rms_relative_difference, trace,
};
use photoncube_spec::find_machine;

/// Photons in range that the search radius is chosen for.
const IN_RANGE: f64 = 200.0;

fn map(scene: &Scene, options: &TraceOptions) -> PhotonMap {
    let trace = trace(scene, options, &|_| ()).unwrap();
    let radius = PhotonMap::radius_for(scene, trace.photons.len() as u64, IN_RANGE);
    PhotonMap::new(scene, trace.photons, radius).unwrap()
}

fn rendered(scene: &Scene, map: &PhotonMap, engine: Engine<'_>, side: u32) -> Rendering {
    let options = ViewOptions {
        width: side,
        height: side,
        ..ViewOptions::default()
    };
    render(scene, map, engine, &options, &|_| ()).unwrap()
}

/// 128 x 128 pixels of 8,192 paths, by Mitsuba 3.9.1.
fn reference() -> Image {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    Image::read_exr(&root.join("../../docs/reference/cornell.exr")).unwrap()
}

/// The issue asks for 0.02. The default options measure 0.008, of which the reference's own noise
/// is 0.0001; the seeds tried differ by a few percent, so 0.01 catches any real loss.
#[test]
fn the_golden_models_image_agrees_with_the_path_tracer() {
    let scene = Scene::built_in("cornell").unwrap();
    let map = map(&scene, &TraceOptions::default());
    let paper = find_machine("paper").unwrap();
    let image = rendered(&scene, &map, Engine::Model(paper), 128).image;
    let reference = reference();
    let mask = light_mask(&reference, LIGHT_RADIANCE);
    let error = rel_mse(&image, &reference, &mask).unwrap();
    println!("relMSE {error:.5}");
    assert!(error <= 0.01, "relMSE {error}");
}

/// What the number format alone costs: both engines on the same photons and query points.
/// Position error scales with the root of the step, so 12 bits for 8, a step 16 times finer, must
/// be about 4 times better; 3 leaves room for the powers' rounding.
#[test]
fn the_format_error_is_small_and_falls_with_the_step() {
    let scene = Scene::built_in("cornell").unwrap();
    let options = TraceOptions {
        photons: 300_000,
        ..TraceOptions::default()
    };
    let map = map(&scene, &options);
    let exact = rendered(&scene, &map, Engine::F64, 64).image;
    let mask = light_mask(&exact, LIGHT_RADIANCE);
    let error = |machine| {
        let engine = Engine::Model(find_machine(machine).unwrap());
        let image = rendered(&scene, &map, engine, 64).image;
        rms_relative_difference(&image, &exact, &mask).unwrap()
    };
    let (paper, finer) = (error("paper"), error("paper-12"));
    println!("rms relative difference {paper:.5}, {finer:.5}");
    // The noise of 200 photons is 7 %; 6 bits per radius cost 0.11 of it at one query, less in
    // the mean of a pixel's nine.
    assert!(paper < 0.11 * 0.07, "{paper}");
    assert!(finer < paper / 3.0, "{finer} {paper}");
}
