//! A room with photons anywhere in it, placed and scaled at will.

use glam::DVec3;
use photoncube_render::{FormatMap, Photon, PhotonMap, Scene};
use photoncube_spec::{LocalSums, PhotonFormat, find_photon_format};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde_json::json;

/// Faces up; all photons say that they lie on it, wherever they are.
pub const NORMAL: DVec3 = DVec3::Y;

pub fn format(name: &str) -> PhotonFormat {
    find_photon_format(name).unwrap()
}

/// A floor and a light above it: bounds from `low` to `low + size`, surface 0 the floor.
pub fn room(low: DVec3, size: f64) -> Scene {
    let corner = |x: f64, y: f64, z: f64| (low + size * DVec3::new(x, y, z)).to_array();
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
    Scene::from_json("room", &text.to_string()).unwrap()
}

/// A photon on the floor's surface.
pub fn photon(position: DVec3, power: DVec3) -> Photon {
    let mut photon = template();
    photon.position = position;
    photon.power = power;
    photon
}

fn template() -> Photon {
    Photon {
        position: DVec3::ZERO,
        power: DVec3::ZERO,
        surface: 0,
    }
}

/// Photons in the unit cube, on a lattice of 2^-30 that sums with 1e6 do not round, with powers over
/// 1e6:1.
pub fn unit_photons(count: usize) -> Vec<Photon> {
    let mut rng = Pcg64Mcg::seed_from_u64(7);
    let lattice = f64::from(1 << 30);
    let mut point =
        || DVec3::from_array(rng.random()).map(|c: f64| (c * lattice).floor() / lattice);
    let mut next = || {
        let (position, mut power) = (point(), point());
        power *= 10_f64.powf(-6.0 * power.x);
        photon(position, power)
    };
    (0..count).map(|_| next()).collect()
}

/// A room full of photons, with the search radius.
pub struct Case {
    pub scene: Scene,
    pub photons: Vec<Photon>,
    pub radius: f64,
}

impl Case {
    /// The unit room's photons.
    pub fn unit(photons: Vec<Photon>, radius: f64) -> Self {
        Self::placed(DVec3::ZERO, 1.0, photons, radius)
    }

    /// The unit room, scaled and then moved.
    pub fn placed(low: DVec3, size: f64, mut photons: Vec<Photon>, radius: f64) -> Self {
        for photon in &mut photons {
            photon.position = photon.position * size + low;
        }
        Self {
            scene: room(low, size),
            photons,
            radius: radius * size,
        }
    }

    pub fn map(&self) -> PhotonMap {
        PhotonMap::new(&self.scene, self.photons.clone(), self.radius).unwrap()
    }

    /// The sums of queries at some of the photons, in the list's order.
    pub fn sums(&self, format: &PhotonFormat) -> Vec<LocalSums> {
        let map = self.map();
        let quantised = FormatMap::new(&map, format).unwrap();
        let queries = self.photons.iter().step_by(37);
        queries
            .map(|query| quantised.gather(query.position, NORMAL).unwrap())
            .collect()
    }
}
