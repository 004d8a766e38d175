//! Small scenes of mirrors and glass for the tests of tracing and viewing, and photon maps of the Cornell box.

use glam::DVec3;
use serde_json::{Value, json};

use super::Scene;
use crate::photon_map::PhotonMap;
use crate::trace::{Facing, Photon, TraceOptions, trace};

/// The Cornell box with the map of at least so many traced photons and of that search radius in scene units.
pub(crate) fn traced_cornell(photons: u64, seed: u64, radius: f64) -> (Scene, PhotonMap) {
    let scene = Scene::built_in("cornell").unwrap();
    let options = TraceOptions { photons, seed };
    let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
    let map = PhotonMap::new(&scene, photons, radius).unwrap();
    (scene, map)
}

/// A map of photons of these powers, all in one place.
pub(crate) fn map_of_powers(powers: &[DVec3]) -> PhotonMap {
    let photons = powers.iter().map(|&power| Photon {
        position: DVec3::ZERO,
        power,
        surface: 0,
        facing: Facing::FLAT,
    });
    let scene = Scene::built_in("cornell").unwrap();
    PhotonMap::new(&scene, photons.collect(), 0.2).unwrap()
}

/// The corners of the unit cube. The faces below have their fronts inside.
const CUBE: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 0.0, 1.0],
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 0.0],
    [1.0, 1.0, 0.0],
    [1.0, 1.0, 1.0],
    [0.0, 1.0, 1.0],
];
const FLOOR: [usize; 4] = [0, 3, 2, 1];
const CEILING: [usize; 4] = [4, 5, 6, 7];
const WALLS: [[usize; 4]; 4] = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2]];

fn quads(faces: &[[usize; 4]], bsdf: Value) -> Value {
    json!({"kind": "quads", "vertices": CUBE, "quads_ccw_outward": faces, "bsdf": bsdf})
}

fn rgb(value: f64) -> Value {
    json!({"type": "rgb", "value": [value, value, value]})
}

fn black() -> Value {
    json!({"type": "diffuse", "reflectance": rgb(0.0)})
}

fn mirror(reflectance: f64) -> Value {
    json!({"type": "conductor", "material": "none", "specular_reflectance": rgb(reflectance)})
}

/// A scene of these shapes. The camera is inside and looks along -z; its wide view reaches upwards.
fn scene(shapes: &Value) -> Scene {
    let to_world = [
        [-1.0, 0.0, 0.0, 0.4],
        [0.0, 1.0, 0.0, 0.3],
        [0.0, 0.0, -1.0, 0.8],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let camera = json!({"fov_deg": 100, "fov_axis": "smaller", "to_world": to_world});
    let text = json!({"name": "fixture", "camera": camera, "shapes": shapes}).to_string();
    Scene::from_json("fixture", &text).expect("a scene")
}

/// The unit cube with mirrors as walls. All of its ceiling emits a radiance of 1; ceiling and floor absorb
/// the light that arrives.
pub(crate) fn chamber(reflectance: f64) -> Scene {
    let mut ceiling = quads(&[CEILING], black());
    ceiling["emitter"] = json!({"type": "area", "radiance": rgb(1.0)});
    scene(&json!({
        "ceiling": ceiling,
        "floor": quads(&[FLOOR], black()),
        "walls": quads(&WALLS, mirror(reflectance)),
    }))
}

/// The unit cube with six perfect mirrors inside, and a light with a millionth of its area.
pub(crate) fn mirror_box() -> Scene {
    let mut light = quads(&[[0, 1, 2, 3]], black());
    let (a, b) = (0.5, 0.501);
    light["vertices"] = json!([[a, b, a], [b, b, a], [b, b, b], [a, b, b]]);
    light["emitter"] = json!({"type": "area", "radiance": rgb(1.0)});
    let mut faces = WALLS.to_vec();
    faces.extend([FLOOR, CEILING]);
    scene(&json!({"light": light, "walls": quads(&faces, mirror(1.0))}))
}

/// The number of walls of the [`chamber`] that light meets on its way to a point at `(x, z)` of the plane in
/// which the walls' mirror images are laid out flat.
pub(crate) fn walls_met(x: f64, z: f64) -> i32 {
    (x.floor().abs() + z.floor().abs()) as i32
}

/// The chamber of perfect mirrors with a ball of glass in its middle.
pub(crate) fn chamber_with_glass() -> Scene {
    let mut ceiling = quads(&[CEILING], black());
    ceiling["emitter"] = json!({"type": "area", "radiance": rgb(1.0)});
    scene(&json!({
        "ball": ball(),
        "ceiling": ceiling,
        "floor": quads(&[FLOOR], black()),
        "walls": quads(&WALLS, mirror(1.0)),
    }))
}

/// A ball of glass in a cube whose faces all emit a radiance of 1 and absorb the light that arrives.
pub(crate) fn glass_furnace() -> Scene {
    let mut faces = WALLS.to_vec();
    faces.extend([FLOOR, CEILING]);
    let mut walls = quads(&faces, black());
    walls["emitter"] = json!({"type": "area", "radiance": rgb(1.0)});
    scene(&json!({"ball": ball(), "walls": walls}))
}

fn ball() -> Value {
    let glass = json!({"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0});
    json!({"kind": "sphere", "center": [0.5, 0.5, 0.4], "radius": 0.3, "bsdf": glass})
}
