//! Refuses views that give a black picture, and states what the camera sees.

use anyhow::{Result, bail};
use glam::DVec3;
use photoncube_render::{
    BallError, Image, MetricsError, RenderStats, Scene, Sights, ViewOptions, WorkloadError,
    sees_a_front,
};

use crate::table::grouped;

/// A suggestion for scenes that have a light.
const TRY: &str = "turn a light there, or give more --photons or a larger --in-range";

/// Checks, before the work, that some pixel sees a surface that can be lit.
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

/// Adds to the error of a view without light what the camera sees.
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

/// A line about the photons whose power rounds to 0 in the integers of a picture; empty where there are none.
pub fn without_power(photons: u64) -> String {
    match photons {
        0 => String::new(),
        photons => format!(
            "{} photons give no light: their power is below half a step of these numbers; `photoncube fit` finds numbers that \
             hold them\n",
            grouped(photons)
        ),
    }
}

/// A line for each error of the estimates on a ball.
pub fn balls(errors: &[BallError]) -> String {
    let line = |error: &BallError| {
        let (shape, percent) = (&error.shape, 100.0 * error.radius);
        let mut line = format!("`{shape}`: the search radius is {percent:.0} % of the ball's.");
        if let Some(degrees) = error.leak {
            line += &format!(
                " Light leaks {degrees:.0} degrees round its dark side; --direct rays avoids this."
            );
        }
        if let Some(part) = error.too_dark {
            let percent = 100.0 * part;
            line += &format!(" It has {percent:.0} % of its light; --area covered restores it.");
        }
        line + "\n"
    };
    errors.iter().map(line).collect()
}

/// Checks, after the work, that the picture has light. A black picture has no meaningful error.
pub fn check_light(
    image: &Image,
    scene: &Scene,
    view: &ViewOptions,
    stats: RenderStats,
) -> Result<()> {
    if image.pixels().iter().any(|pixel| *pixel != DVec3::ZERO) {
        return Ok(());
    }
    if stats.photons_without_power > 0 && stats.photons_in_range > 0 {
        bail!(
            "the picture is black: {}",
            without_power(stats.photons_without_power).trim_end()
        );
    }
    bail!(
        "no light reaches what the camera sees: {} query points, {} photons in range of them; {}; \
         {TRY}",
        stats.query_points,
        stats.photons_in_range,
        Sights::of(scene, view)?
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_on_a_ball_names_it_and_the_option_that_helps() {
        let error = BallError {
            shape: "ball".to_owned(),
            radius: 2.0,
            leak: Some(90.0),
            too_dark: Some(0.25),
        };
        assert_eq!(
            balls(&[error]),
            "`ball`: the search radius is 200 % of the ball's. Light leaks 90 degrees round its dark side; --direct rays \
             avoids this. It has 25 % of its light; --area covered restores it.\n"
        );
        assert_eq!(balls(&[]), "");
    }

    #[test]
    fn a_picture_is_black_for_want_of_light_or_of_power() {
        let scene = Scene::built_in("cornell").unwrap();
        let view = ViewOptions::default();
        let image = Image::new(1, 1, vec![DVec3::ZERO]).unwrap();
        let said = |photons_without_power| {
            let stats = RenderStats {
                photons_in_range: 7,
                photons_without_power,
                ..RenderStats::default()
            };
            let error = check_light(&image, &scene, &view, stats).unwrap_err();
            error.to_string()
        };
        assert!(said(0).starts_with("no light reaches what the camera sees"));
        assert!(said(1200).starts_with("the picture is black: 1,200 photons give no light"));
    }
}
