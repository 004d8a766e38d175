//! Views that give a black picture are refused, with what the camera sees.

use anyhow::{Result, bail};
use glam::DVec3;
use photoncube_render::{
    Image, MetricsError, RenderStats, Scene, Sights, ViewOptions, WorkloadError, sees_a_front,
};

/// What helps, where there is a light at all.
const TRY: &str = "turn a light there, or give more --photons or a larger --in-range";

/// Before the work: whether any pixel sees a surface that can be lit.
pub fn check(scene: &Scene, view: &ViewOptions) -> Result<()> {
    if sees_a_front(scene, view)? {
        return Ok(());
    }
    let sights = Sights::of(scene, view)?;
    let why = match sights.has_backs() {
        true => {
            "a back is black; move the camera to the front, or turn the surface around (`inward` of a box)"
        }
        false => "move the camera, or turn it",
    };
    bail!("no pixel sees a lit surface: {sights}; {why}");
}

/// Says what the camera sees where no query has light.
pub fn explained<T>(result: Result<T>, scene: &Scene, view: &ViewOptions) -> Result<T> {
    let Err(error) = result else { return result };
    let is_dark = error.chain().any(|cause| {
        let nothing = [MetricsError::NothingCompared, MetricsError::NothingInRange];
        let metrics = cause.downcast_ref::<MetricsError>();
        metrics.is_some_and(|error| nothing.contains(error))
            || matches!(cause.downcast_ref(), Some(WorkloadError::NothingGathered))
    });
    if !is_dark {
        return Err(error);
    }
    bail!(
        "no light reaches what the camera sees: {}; {TRY}",
        Sights::of(scene, view)?
    )
}

/// After the work: a picture without any light has no error worth a bound.
pub fn check_light(
    image: &Image,
    scene: &Scene,
    view: &ViewOptions,
    stats: RenderStats,
) -> Result<()> {
    if image.pixels().iter().any(|pixel| *pixel != DVec3::ZERO) {
        return Ok(());
    }
    bail!(
        "no light reaches what the camera sees: {} query points, {} photons in range of them; {}; \
         {TRY}",
        stats.query_points,
        stats.photons_in_range,
        Sights::of(scene, view)?
    );
}
