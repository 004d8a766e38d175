//! The data of the benchmark: photons of equal power on a floor, and queries at photons.

use glam::{DQuat, DVec3};
use photoncube_render::{Facing, Photon, PhotonMap, QuantisedMap, QueryPoint, Scene};
use photoncube_spec::PhotonFormat;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde_json::json;

/// The number of queries: those of a picture of 512x512 pixels with four view rays each.
pub const QUERIES: usize = 1 << 20;

/// The distribution of photons on the floor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Light {
    /// Uniform over the floor.
    Uniform,
    /// Half of the photons on a caustic: the nephroid of a round mirror, with a width of a hundredth of the
    /// floor's edge.
    Caustic,
    /// Uniform, on a floor that is parallel to no axis.
    Tilted,
}

impl Light {
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Caustic => "caustic",
            Self::Tilted => "tilted",
        }
    }

    /// The rotation of the floor.
    fn tilt(self) -> DQuat {
        match self {
            Self::Uniform | Self::Caustic => DQuat::IDENTITY,
            // An arbitrary rotation away from the axes.
            Self::Tilted => DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.6),
        }
    }

    fn place(self, rng: &mut Pcg64Mcg) -> DVec3 {
        let anywhere = DVec3::new(rng.random(), 0.0, rng.random());
        if self != Self::Caustic || rng.random::<bool>() {
            return self.tilt() * anywhere;
        }
        // The nephroid of a unit circle's mirror, divided by 3 to fit the floor.
        let t = rng.random::<f64>() * std::f64::consts::TAU;
        let on = DVec3::new(
            3.0 * t.cos() - (3.0 * t).cos(),
            0.0,
            3.0 * t.sin() - (3.0 * t).sin(),
        );
        let off = DVec3::new(rng.random::<f64>() - 0.5, 0.0, rng.random::<f64>() - 0.5);
        0.1 * on + 0.01 * off + DVec3::new(0.5, 0.0, 0.5)
    }
}

/// The parameters of one measurement.
#[derive(Debug, Clone, Copy)]
pub struct Workload {
    /// The beginning of its name.
    pub title: &'static str,
    pub light: Light,
    pub photons: usize,
    /// The photons that a query has in range on average, met within a twentieth.
    pub in_range: f64,
}

impl Workload {
    pub fn name(&self) -> String {
        let Self {
            title,
            photons,
            in_range,
            ..
        } = self;
        format!("{title} 1e{} {in_range}", photons.ilog10())
    }
}

/// Photons and queries of one measurement.
pub struct Data {
    pub map: PhotonMap,
    /// The queries, sorted by the map's blocks.
    pub queries: Vec<QueryPoint>,
}

impl Data {
    pub fn new(format: &PhotonFormat, workload: &Workload) -> Self {
        let Workload {
            light,
            photons,
            in_range,
            ..
        } = *workload;
        let scene = floor(light.tilt());
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        let floor = scene.surfaces().iter().position(|s| s.shape == "floor");
        let surface = floor.expect("a floor") as u32;
        let photon = |position| Photon {
            position,
            // As after tracing: the strongest channel is equal for all photons, the other channels depend on
            // their surfaces.
            power: DVec3::new(1.0, 0.7, 0.4) / photons as f64,
            surface,
            facing: Facing::FLAT,
        };
        let places: Vec<_> = (0..photons)
            .map(|_| photon(light.place(&mut rng)))
            .collect();
        let mut queries: Vec<_> = (0..QUERIES)
            .map(|_| QueryPoint {
                position: light.place(&mut rng),
                normal: light.tilt() * DVec3::Y,
                surface: None,
                beta: DVec3::ONE,
            })
            .collect();
        // The blocks have the format's edge. The queries are sorted by them, for all contestants alike.
        let map = |radius| {
            let edge = QuantisedMap::edge_for(format, radius);
            PhotonMap::with_edge(&scene, places.clone(), radius, edge).expect("a legal radius")
        };
        let radius = radius_for(&map, photons, &queries, in_range);
        let map = map(radius);
        map.sort_queries(&mut queries);
        Self { map, queries }
    }
}

/// The radius at which some of the queries have `in_range` photons in range on average.
fn radius_for(
    map: &dyn Fn(f64) -> PhotonMap,
    photons: usize,
    queries: &[QueryPoint],
    in_range: f64,
) -> f64 {
    let some: Vec<_> = queries.iter().step_by(queries.len() / 512).collect();
    // The radius of twice as many photons in range, if all were uniform; denser light needs no larger radius.
    let (mut low, mut high) = (
        0.0,
        (2.0 * in_range / (std::f64::consts::PI * photons as f64)).sqrt(),
    );
    let widest = map(high);
    let mut mean = 0.0;
    for _ in 0..30 {
        let radius = f64::midpoint(low, high);
        let count = |query: &&QueryPoint| {
            let runs = widest.candidates(query.position, query.front());
            let photons = runs.flat_map(|run| &widest.photons()[run.photons]);
            let near = photons.filter(|p| p.position.distance(query.position) <= radius);
            near.count() as f64
        };
        mean = some.iter().map(count).sum::<f64>() / some.len() as f64;
        if mean < in_range {
            low = radius;
        } else {
            high = radius;
        }
    }
    assert!(
        (mean / in_range - 1.0).abs() < 0.05,
        "found {mean} in range, expected {in_range}"
    );
    f64::midpoint(low, high)
}

/// A floor of one unit by one, with a light above it.
fn floor(tilt: DQuat) -> Scene {
    let rgb = |value: f64| json!({"type": "rgb", "value": [value, value, value]});
    let quad = |y: f64, order: [u32; 4]| {
        let corners = [[0.0, y, 0.0], [1.0, y, 0.0], [1.0, y, 1.0], [0.0, y, 1.0]];
        json!({
            "kind": "quads",
            "vertices": corners.map(|corner| (tilt * DVec3::from_array(corner)).to_array()),
            "quads_ccw_outward": [order],
            "bsdf": {"type": "diffuse", "reflectance": rgb(0.5)},
        })
    };
    let mut light = quad(1.0, [0, 1, 2, 3]);
    light["emitter"] = json!({"type": "area", "radiance": rgb(1.0)});
    let to_world = [
        [1.0, 0.0, 0.0, 0.5],
        [0.0, 1.0, 0.0, 0.5],
        [0.0, 0.0, 1.0, -1.0],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let text = json!({
        "name": "floor",
        "camera": {"fov_deg": 60, "fov_axis": "smaller", "to_world": to_world},
        "shapes": {"floor": quad(0.0, [0, 3, 2, 1]), "light": light},
    });
    Scene::from_json("floor", &text.to_string()).expect("a scene")
}
