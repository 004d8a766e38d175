//! Compares the whole chain with an independent renderer: the built-in scene, photon-mapped by the golden
//! model, beside Mitsuba's path-traced image of it.

use std::path::Path;

use photoncube_render::{
    Area, DirectLight, Engine, ErrorEstimate, Image, LIGHT_RADIANCE, Lighting, PhotonMap,
    Progressive, ProgressiveOptions, Rendering, Scene, TraceOptions, ViewOptions, light_mask,
    luminance, rel_mse, render, rms_relative_difference, trace,
};
use photoncube_spec::{PHOTON_FORMATS, find_machine};

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

/// The reference image: 128 x 128 pixels of 8,192 paths, by Mitsuba 3.9.1.
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
    let image = rendered(&scene, &map, Engine::from(paper), 128).image;
    let reference = reference();
    let mask = light_mask(&reference, LIGHT_RADIANCE);
    let error = rel_mse(&image, &reference, &mask).unwrap();
    println!("relMSE {error:.5}");
    assert!(error <= 0.01, "relMSE {error}");
}

/// The error of the number format alone: both engines have the same photons and query points.
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
        let engine = Engine::from(find_machine(machine).unwrap());
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

/// The picture of `passes` passes, with shadow rays and over the covered area.
fn progressive(engine: Engine<'_>, passes: u64) -> (Image, ErrorEstimate) {
    let scene = Scene::built_in("cornell").unwrap();
    let lighting = Lighting {
        direct: DirectLight::Rays(1),
        area: Area::Covered,
        ..Lighting::default()
    };
    let view = ViewOptions {
        width: 128,
        height: 128,
        samples_per_axis: 1,
        seed: 0,
    };
    let options = ProgressiveOptions::default();
    let mut progressive = Progressive::new(&scene, engine, lighting, view, options).unwrap();
    (0..passes).for_each(|_| progressive.pass().unwrap());
    (progressive.image(), progressive.error(0.9).unwrap())
}

/// The picture in integers differs from the f64 picture by less than a tenth of the noise. Its relMSE against
/// the path tracer is at most 2e-3 (measured: 1.4e-3), and nine of ten bounds of 90 % hold.
#[test]
fn passes_in_integers_come_as_near_to_the_path_tracer_as_those_of_f64() {
    const PASSES: u64 = 64;
    let reference = reference();
    let mask = light_mask(&reference, LIGHT_RADIANCE);
    let (integers, error) = progressive(Engine::from(&PHOTON_FORMATS[0]), PASSES);
    let (exact, _) = progressive(Engine::F64, PASSES);
    let of = |image: &Image| rel_mse(image, &reference, &mask).unwrap();
    let difference = rel_mse(&integers, &exact, &mask).unwrap().sqrt();
    let truth: Vec<f64> = reference.pixels().iter().map(|p| luminance(*p)).collect();
    let bounded = error.bounded(&truth).unwrap();
    println!(
        "relMSE {:.5}, f64 {:.5}; root of that between the two {difference:.5}, noise {:.5}; {bounded:.4} in bounds",
        of(&integers),
        of(&exact),
        error.noise()
    );
    assert!(of(&integers) <= 2e-3);
    assert!(difference < 0.1 * error.noise());
    // Wider bounds would be unjust as well. The path tracer's own noise, a third of the picture's, lowers the share.
    assert!((bounded - error.confidence).abs() < 0.03, "{bounded}");
}
