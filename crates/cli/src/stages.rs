//! The stages of a picture that several commands share: tracing, rendering, writing, and the comparison of two
//! pictures.

use std::path::Path;

use anyhow::{Result, anyhow};
use photoncube_render::{
    Engine, Estimator, Image, LIGHT_RADIANCE, Light, Lighting, PhotonMap, PhotonMaps, Radii,
    Rendering, Scene, TraceOptions, ViewOptions, error_map, light_mask, rel_mse, relative_errors,
    render, render_lit, rms_relative_difference, rmse, trace,
};
use serde::Serialize;

use crate::args::PictureArgs;
use crate::{files, progress};

/// The exposure of written pictures: radiance 1 is white.
pub const EXPOSURE: f64 = 1.0;

/// A scene with its photon maps.
pub struct Traced {
    /// The scene that was traced.
    pub scene: Scene,
    /// The photon maps.
    pub maps: PhotonMaps,
    /// The number of paths that were emitted for the maps.
    pub paths: u64,
}

impl Traced {
    /// The map of all light, or of all light but that of the caustics' map.
    pub fn map(&self) -> &PhotonMap {
        &self.maps.global
    }
}

/// Stages 2 and 3: traces the photons and makes the maps that the lighting needs.
pub fn trace_scene(scene: Scene, picture: &PictureArgs, lighting: &Lighting) -> Result<Traced> {
    trace_for(scene, picture, lighting, Engine::F64)
}

/// Stages 2 and 3 for pictures by one engine, in whose blocks the maps are.
pub fn trace_for(
    scene: Scene,
    picture: &PictureArgs,
    lighting: &Lighting,
    engine: Engine<'_>,
) -> Result<Traced> {
    let options = TraceOptions {
        photons: picture.photons,
        seed: picture.seed,
    };
    let bar = progress::bar("tracing photons", picture.photons);
    let traced = trace(&scene, &options, &|stored| bar.set_position(stored))?;
    bar.finish_and_clear();
    let paths = traced.paths;
    let radii = Radii::of(&scene, &traced, lighting, picture.in_range);
    let maps = PhotonMaps::for_engine(&scene, traced, lighting, radii, engine)?;
    Ok(Traced { scene, maps, paths })
}

/// The view of the picture's options.
pub fn view(picture: &PictureArgs) -> ViewOptions {
    ViewOptions {
        width: picture.size.width,
        height: picture.size.height,
        samples_per_axis: picture.samples,
        seed: picture.seed,
    }
}

/// Stages 4 to 6 without writing: view rays, estimates, image. The search radius is fixed and all light comes
/// from the map.
pub fn picture(
    traced: &Traced,
    engine: Engine<'_>,
    view: &ViewOptions,
    what: &'static str,
) -> Result<Rendering> {
    picture_of_map(&traced.scene, traced.map(), engine, view, what)
}

/// Stages 4 to 6 without writing, from one photon map of all light. The search radius is fixed.
pub fn picture_of_map(
    scene: &Scene,
    map: &PhotonMap,
    engine: Engine<'_>,
    view: &ViewOptions,
    what: &'static str,
) -> Result<Rendering> {
    let pixels = u64::from(view.width) * u64::from(view.height);
    let bar = progress::bar(what, pixels);
    let progress = |done| bar.set_position(done);
    let rendering = render(scene, map, engine, view, &progress)?;
    bar.finish_and_clear();
    Ok(rendering)
}

/// Stages 4 to 6 without writing, with a lighting and an estimator.
pub fn picture_lit(
    traced: &Traced,
    engine: Engine<'_>,
    lighting: &Lighting,
    estimator: &Estimator,
    view: &ViewOptions,
    what: &'static str,
) -> Result<Rendering> {
    let pixels = u64::from(view.width) * u64::from(view.height);
    let bar = progress::bar(what, pixels);
    let light = Light {
        lighting,
        global: &traced.maps.global,
        caustic: traced.maps.caustic.as_ref(),
        estimator,
    };
    let progress = |done| bar.set_position(done);
    let rendering = render_lit(&traced.scene, light, engine, view, &progress)?;
    bar.finish_and_clear();
    Ok(rendering)
}

/// Writes a picture in the format of its name's ending.
pub fn write_picture(image: &Image, path: &Path) -> Result<()> {
    files::write(path, &image.encode(path, EXPOSURE)?)
}

/// The difference of two pictures. Pixels that see the light, and their neighbours, are left out, as for the
/// reference image.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Distance {
    /// The rms relative difference.
    pub rms_relative_error: f64,
    /// The relative mean squared error, see [`rel_mse`].
    pub rel_mse: f64,
    /// The root mean squared error, see [`rmse`].
    pub rmse: f64,
}

impl Distance {
    /// The difference of `image` from `reference`.
    pub fn between(image: &Image, reference: &Image) -> Result<Self> {
        let mask = light_mask(reference, LIGHT_RADIANCE);
        let explain = |error| anyhow!("the two pictures cannot be compared: {error}");
        let rms = rms_relative_difference(image, reference, &mask).map_err(explain)?;
        Ok(Self {
            rms_relative_error: rms,
            rel_mse: rel_mse(image, reference, &mask).map_err(explain)?,
            rmse: rmse(image, reference, &mask).map_err(explain)?,
        })
    }
}

/// A map of the errors of `image` against `reference`, which must have equal sizes.
pub fn map_of(image: &Image, reference: &Image, title: &str) -> String {
    let mask = light_mask(reference, LIGHT_RADIANCE);
    let errors = relative_errors(image.pixels(), reference.pixels(), &mask);
    error_map(title, image.width(), &errors)
}
