//! Finds the surfaces, and the sides of them, that a camera sees. A view of black backs alone gives a black
//! picture, and the user needs an explanation.

use std::collections::BTreeMap;
use std::fmt;

use glam::DVec3;
use rayon::prelude::*;

use super::{Sight, ViewError, ViewOptions};
use crate::scene::Scene;

/// The most surfaces that are named.
const NAMED: usize = 3;

/// A side of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Side {
    Front,
    Back,
}

/// The ends of a picture's view rays.
#[derive(Debug, Clone, PartialEq)]
pub struct Sights {
    camera: DVec3,
    rays: u64,
    /// The number of rays by shape and side, the most frequent first. Fronts of mirrors and media are not
    /// ends.
    ends: Vec<(String, Side, u64)>,
    /// The number of rays that leave the scene.
    nothing: u64,
    /// The number of rays that are lost between mirrors.
    lost: u64,
}

/// Whether any view ray of the picture ends on the front of a diffuse surface, where an estimate can be made.
///
/// # Errors
/// The options describe no picture.
pub fn sees_a_front(scene: &Scene, options: &ViewOptions) -> Result<bool, ViewError> {
    options.check()?;
    let pixels = (0..options.height).into_par_iter();
    Ok(pixels.any(|y| {
        let mut row = (0..options.width).flat_map(|x| options.sights(scene, x, y));
        row.any(|sight| matches!(sight, Sight::Diffuse { .. }))
    }))
}

impl Sights {
    /// Follows all view rays of the picture.
    ///
    /// # Errors
    /// The options describe no picture.
    pub fn of(scene: &Scene, options: &ViewOptions) -> Result<Self, ViewError> {
        options.check()?;
        let mut sights = Self {
            camera: scene.camera().position(),
            rays: 0,
            ends: Vec::new(),
            nothing: 0,
            lost: 0,
        };
        let mut ends: BTreeMap<(&str, Side), u64> = BTreeMap::new();
        let pixels = (0..options.height).flat_map(|y| (0..options.width).map(move |x| (x, y)));
        for sight in pixels.flat_map(|(x, y)| options.sights(scene, x, y)) {
            sights.rays += 1;
            let mut meet = |surface: usize, side| {
                let shape = &scene.surfaces()[surface].shape;
                *ends.entry((shape, side)).or_default() += 1;
            };
            match sight {
                Sight::Diffuse { surface, .. } => meet(surface, Side::Front),
                Sight::Back { surface } => meet(surface, Side::Back),
                Sight::Nothing => sights.nothing += 1,
                Sight::Lost => sights.lost += 1,
            }
        }
        let ends = ends.into_iter();
        let ends = ends.map(|((shape, side), rays)| (shape.to_owned(), side, rays));
        sights.ends = ends.collect();
        sights
            .ends
            .sort_by_key(|(.., rays)| std::cmp::Reverse(*rays));
        Ok(sights)
    }

    /// Whether any view ray ends on a black back.
    #[must_use]
    pub fn has_backs(&self) -> bool {
        self.ends.iter().any(|(_, side, _)| *side == Side::Back)
    }

    fn percent(&self, rays: u64) -> f64 {
        100.0 * rays as f64 / self.rays.max(1) as f64
    }
}

/// "the camera at [0, 1, 3.8] sees the back of `room` (81.2 % of the view rays), nothing (18.8 %)".
impl fmt::Display for Sights {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.camera.to_array();
        write!(f, "the camera at [{x}, {y}, {z}] sees ")?;
        let mut parts: Vec<(String, u64)> = Vec::new();
        for (shape, side, rays) in self.ends.iter().take(NAMED) {
            let side = match side {
                Side::Front => "front",
                Side::Back => "back",
            };
            parts.push((format!("the {side} of `{shape}`"), *rays));
        }
        let others = self.ends.iter().skip(NAMED);
        parts.push((
            "other surfaces".to_owned(),
            others.map(|(.., rays)| rays).sum(),
        ));
        parts.push(("nothing".to_owned(), self.nothing));
        parts.push(("mirrors in mirrors without end".to_owned(), self.lost));
        parts.retain(|(_, rays)| *rays > 0);
        for (index, (what, rays)) in parts.iter().enumerate() {
            let comma = if index > 0 { ", " } else { "" };
            let of = if index == 0 { " of the view rays" } else { "" };
            write!(f, "{comma}{what} ({:.1} %{of})", self.percent(*rays))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::fixtures::mirror_box;

    const OPTIONS: ViewOptions = ViewOptions {
        width: 16,
        height: 16,
        samples_per_axis: 1,
        seed: 1,
    };

    /// A room whose fronts face inwards, seen from outside: the back of the near wall hides the rest.
    fn room(camera: &str) -> Scene {
        let text = format!(
            "[camera]\n{camera}\nfov_deg = 40\n\
             [materials.grey]\ntype = \"diffuse\"\nreflectance = [0.5, 0.5, 0.5]\n\
             [[shapes]]\nname = \"room\"\ntype = \"box\"\nlow = [-1, 0, -1]\nhigh = [1, 2, 1]\ninward = true\n\
             material = \"grey\"\n\
             [[shapes]]\nname = \"lamp\"\ntype = \"quad\"\nemission = [5, 5, 5]\nmaterial = \"grey\"\n\
             corners = [[-0.3, 1.9, -0.3], [0.3, 1.9, -0.3], [0.3, 1.9, 0.3], [-0.3, 1.9, 0.3]]\n"
        );
        Scene::from_toml("room.toml", &text, std::path::Path::new("")).unwrap()
    }

    #[test]
    fn a_camera_outside_a_room_sees_its_back() {
        let scene = room("position = [0, 1, 3.8]\ntarget = [0, 1, 0]");
        assert!(!sees_a_front(&scene, &OPTIONS).unwrap());
        let sights = Sights::of(&scene, &OPTIONS).unwrap();
        assert!(sights.has_backs());
        let said = sights.to_string();
        assert!(
            said.starts_with("the camera at [0, 1, 3.8] sees the back of `room` ("),
            "{said}"
        );
        assert!(said.contains("% of the view rays)"), "{said}");
    }

    #[test]
    fn a_camera_inside_sees_fronts_and_one_that_looks_away_nothing() {
        let scene = room("position = [0, 1, 0.9]\ntarget = [0, 1, 0]");
        assert!(sees_a_front(&scene, &OPTIONS).unwrap());
        let sights = Sights::of(&scene, &OPTIONS).unwrap().to_string();
        assert!(sights.contains("the front of `room` (100.0 %"), "{sights}");
        let scene = room("position = [0, 1, 3.8]\ntarget = [0, 1, 9]");
        assert!(!sees_a_front(&scene, &OPTIONS).unwrap());
        let sights = Sights::of(&scene, &OPTIONS).unwrap();
        assert!(!sights.has_backs());
        assert!(
            sights
                .to_string()
                .ends_with("sees nothing (100.0 % of the view rays)"),
            "{sights}"
        );
    }

    #[test]
    fn rays_between_mirrors_are_told_apart() {
        let sights = Sights::of(&mirror_box(), &OPTIONS).unwrap();
        assert!(sights.lost > 0, "{sights}");
        let ends: u64 = sights.ends.iter().map(|(.., rays)| rays).sum();
        assert_eq!(ends + sights.nothing + sights.lost, sights.rays);
        assert_eq!(sights.rays, 256);
    }
}
