//! A room with photons anywhere in it, which the cases place and scale.

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde_json::json;

use super::case::HardCaseError;
use super::grid::Grid;
use photoncube_render::PhotonMap;
use photoncube_render::Scene;
use photoncube_render::{Facing, Front, Photon};

/// A front that faces up. All photons count as lying on the floor, wherever they are.
pub(super) const FRONT: Front = Front {
    normal: DVec3::Y,
    surface: None,
};

/// The room's middle.
pub(super) const MIDDLE: DVec3 = DVec3::splat(0.5);

/// The search radius of most cases: about ten blocks in the unit room.
pub(super) const RADIUS: f64 = 0.1;

/// The colour of all photons, so that a format of one channel represents them too.
pub(super) const COLOUR: DVec3 = DVec3::new(1.0, 0.5, 0.25);

/// A cube with a floor and a light above it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Room {
    /// The lowest corner of the room.
    pub low: DVec3,
    /// The length of the room's edge.
    pub size: f64,
}

impl Room {
    /// The room from 0 to 1 on each axis.
    pub const UNIT: Self = Self {
        low: DVec3::ZERO,
        size: 1.0,
    };

    /// The position in this room of a position in the unit room.
    pub fn place(self, position: DVec3) -> DVec3 {
        position * self.size + self.low
    }

    /// The map of the unit room's photons, placed in this room, with the blocks of `grid`.
    pub fn map(
        self,
        grid: &Grid,
        mut photons: Vec<Photon>,
        radius: f64,
    ) -> Result<PhotonMap, HardCaseError> {
        for photon in &mut photons {
            photon.position = self.place(photon.position);
        }
        let radius = radius * self.size;
        let edge = grid.edge(radius);
        Ok(PhotonMap::with_edge(&self.scene()?, photons, radius, edge)?)
    }

    /// The scene of the room; surface 0 is the floor.
    pub fn scene(self) -> Result<Scene, HardCaseError> {
        let corner = |x, y, z| self.place(DVec3::new(x, y, z)).to_array();
        let quad = |y, normal: f64, [a, b]: [f64; 2]| {
            json!({
                "kind": "quad",
                "vertices": [corner(0.0, y, a), corner(1.0, y, a), corner(1.0, y, b), corner(0.0, y, b)],
                "normal": [0.0, normal, 0.0],
                "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.5, 0.5, 0.5]}},
            })
        };
        let mut light = quad(1.0, -1.0, [0.0, 1.0]);
        light["emitter"] =
            json!({"type": "area", "radiance": {"type": "rgb", "value": [1.0, 1.0, 1.0]}});
        let eye = corner(0.5, 0.5, 0.5);
        let to_world = json!([
            [1.0, 0.0, 0.0, eye[0]],
            [0.0, 1.0, 0.0, eye[1]],
            [0.0, 0.0, 1.0, eye[2]],
            [0.0, 0.0, 0.0, 1.0]
        ]);
        let text = json!({
            "name": "room",
            "camera": {"fov_deg": 60.0, "fov_axis": "smaller", "to_world": to_world},
            "shapes": {"floor": quad(0.0, 1.0, [1.0, 0.0]), "light": light},
        });
        Ok(Scene::from_json("room", &text.to_string())?)
    }
}

/// A photon on the floor's surface.
pub(super) fn photon(position: DVec3, power: DVec3) -> Photon {
    Photon {
        position,
        power,
        surface: 0,
        facing: Facing::FLAT,
    }
}

/// Points of the unit cube, on a lattice of 2^-30, so that sums with 1e6 are exact.
pub(super) fn points(count: usize, seed: u64) -> impl Iterator<Item = DVec3> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let lattice = f64::from(1 << 30);
    let mut point =
        move || DVec3::from_array(rng.random()).map(|c: f64| (c * lattice).floor() / lattice);
    (0..count).map(move |_| point())
}

/// Photons in the unit cube, of powers over 1e6:1 and of one colour.
pub(super) fn photons(count: usize, seed: u64) -> Vec<Photon> {
    let powers = points(count, !seed).map(|p| 10_f64.powf(-6.0 * p.x) * COLOUR);
    let pairs = points(count, seed).zip(powers);
    pairs.map(|(at, power)| photon(at, power)).collect()
}
