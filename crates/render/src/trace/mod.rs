//! Stage 2: photons leave the lights, follow mirrors and the borders of media, and are stored at every
//! diffuse hit on a surface's front. Mirrors and borders store no photons, because no estimate can gather
//! their light.
//!
//! Jensen, "Global Illumination using Photon Maps" (1996): emission in proportion to the
//! lights' power (or by the scene's [`crate::LightChoice`]), Russian roulette at every hit. A photon
//! survives with the probability by which the surface scales its strongest channel, so that the
//! strongest channel of every photon's power stays what the light gave it: powers are about
//! equal, which is what a narrow linear power format and a low variance both need.

mod facing;
pub(crate) mod sample;

use std::sync::atomic::{AtomicU64, Ordering};

use glam::DVec3;
use rand::RngExt;
use rand_pcg::Pcg64Mcg;
use rayon::current_num_threads;
use rayon::prelude::*;
use thiserror::Error;

pub use self::facing::Facing;

use self::sample::{Purpose, cosine_direction, stream};
use crate::scene::{Lights, Scene};
use crate::view::Ray;

/// The number of paths in a batch. Paths are emitted in whole batches; a partial batch would favour early
/// paths.
pub const BATCH_PATHS: u64 = 8192;

/// The number of paths that one task of the thread pool traces, large enough to make the pool's overhead
/// small.
const TASK_PATHS: u64 = 256;

/// The tasks whose photons are kept apart until all of them are done: at least three for each thread, so that threads seldom wait for
/// each other, and one for each so many photons asked. The photons of a task take some 60 KB.
const TASKS_A_THREAD: u64 = 3;
const ASKED_BESIDE_A_TASK: u64 = 1 << 14;

/// Tracing fails where fewer than one path in this many stores a photon.
const PATHS_PER_PHOTON_LIMIT: u64 = 64;

/// The largest survival probability of a photon at a hit, so that white surfaces or perfect mirrors cannot
/// keep one for ever. A path ends after 50 hits on average, and one in a million takes over 684. The
/// survivor's power rises accordingly, so the mean is unchanged.
const MAX_SURVIVAL: f64 = 0.98;

/// A stored hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Photon {
    /// The position of the hit in scene units.
    pub position: DVec3,
    /// The radiant flux that arrived, for red, green and blue; not yet reflected.
    pub power: DVec3,
    /// The index of the surface that it hit, on the front.
    pub surface: u32,
    /// The direction in which the front faces at the hit.
    pub facing: Facing,
}

/// The kind of a photon's path before it was stored. In the notation of Heckbert (1990), L is the light, S a
/// mirror or a border of a medium, D a diffuse surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathKind {
    /// The path meets no surface before, LD: direct light.
    Direct,
    /// The path meets only mirrors and borders of media before, LS+D: a caustic.
    Caustic,
    /// The path meets a diffuse surface before, L(S|D)*DS*D.
    Indirect,
}

/// The options of tracing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TraceOptions {
    /// The least number of photons to store. Batches are completed, so there are a few more.
    pub photons: u64,
    /// The seed of the random numbers.
    pub seed: u64,
}

/// Two million photons: with 200 in range, the built-in scene then stays clearly below a relMSE
/// of 0.01.
impl Default for TraceOptions {
    fn default() -> Self {
        Self {
            photons: 2_000_000,
            seed: 1,
        }
    }
}

/// The result of tracing.
#[derive(Debug, Clone, PartialEq)]
pub struct PhotonTrace {
    /// The stored photons, in the order of their paths.
    pub photons: Vec<Photon>,
    /// The kind of each photon's path.
    pub kinds: Vec<PathKind>,
    /// The number of paths emitted. The lights' power is divided among them.
    pub paths: u64,
}

impl PathKind {
    fn after_specular(self) -> Self {
        match self {
            Self::Direct | Self::Caustic => Self::Caustic,
            Self::Indirect => Self::Indirect,
        }
    }
}

impl PhotonTrace {
    /// The photons whose kind is `wanted`, in their order.
    #[must_use]
    pub fn of(&self, wanted: impl Fn(PathKind) -> bool) -> Vec<Photon> {
        let both = self.photons.iter().zip(&self.kinds);
        both.filter_map(|(photon, kind)| wanted(*kind).then_some(*photon))
            .collect()
    }

    /// The photons of [`Self::of`], in the memory of all photons.
    #[must_use]
    pub fn into_those(mut self, wanted: impl Fn(PathKind) -> bool) -> Vec<Photon> {
        let mut kinds = self.kinds.into_iter();
        self.photons.retain(|_| kinds.next().is_some_and(&wanted));
        self.photons
    }
}

/// The reason why tracing failed.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum TraceError {
    /// The number of photons is outside the range that a photon map can index.
    #[error("photons: found {found}, expected 1 to {}", MAX_PHOTONS)]
    Count {
        /// The requested number of photons.
        found: u64,
    },
    /// Hardly any path hits a front.
    #[error(
        "tracing: found {stored} photons stored from {paths} paths, \
         expected at least one from {PATHS_PER_PHOTON_LIMIT}: do the lights face the scene?"
    )]
    NothingHit {
        /// The number of photons stored.
        stored: u64,
        /// The number of paths traced.
        paths: u64,
    },
}

/// The most photons that may be requested, which bounds memory. A photon takes up to 64 bytes until it is in a map and in the numbers
/// of an engine (`crates/render/tests/memory.rs`), so this many take 8.6 GB. A `u32` counts them with room for the last batch.
pub const MAX_PHOTONS: u64 = 1 << 27;

/// Traces paths until at least `options.photons` photons are stored.
///
/// A light of area A and radiance L emits the flux pi A L from its front; a path starts on a
/// light by the scene's [`crate::LightChoice`], at a uniform point, in a direction of density cos / pi.
/// `progress` receives the number of photons stored so far, from any thread, not always in order.
///
/// # Errors
/// [`TraceError::Count`] for a count of 0 or over 2^27; [`TraceError::NothingHit`] where fewer
/// than one path in 64 stores a photon.
pub fn trace(
    scene: &Scene,
    options: &TraceOptions,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<PhotonTrace, TraceError> {
    if !(1..=MAX_PHOTONS).contains(&options.photons) {
        return Err(TraceError::Count {
            found: options.photons,
        });
    }
    let lights = Lights::of(scene);
    let stored = AtomicU64::new(0);
    let (mut photons, mut kinds) = (Vec::new(), Vec::new());
    let mut paths = 0;
    let tasks = BATCH_PATHS / TASK_PATHS;
    let at_least = TASKS_A_THREAD * current_num_threads() as u64;
    let tasks_at_once = at_least
        .max(options.photons / ASKED_BESIDE_A_TASK)
        .min(tasks);
    while (photons.len() as u64) < options.photons {
        let task = |task: u64| {
            let first = paths + task * TASK_PATHS;
            let mut found = Vec::new();
            for index in first..first + TASK_PATHS {
                let mut rng = stream(options.seed, Purpose::Path, index);
                trace_path(scene, &lights, &mut rng, &mut found);
            }
            let count = found.len() as u64;
            progress(stored.fetch_add(count, Ordering::Relaxed) + count);
            found
        };
        for first in (0..tasks).step_by(tasks_at_once as usize) {
            let at_once = first..tasks.min(first + tasks_at_once);
            let found: Vec<_> = at_once.into_par_iter().map(task).collect();
            let count = found.iter().map(Vec::len).sum();
            make_room(&mut photons, count, options.photons);
            make_room(&mut kinds, count, options.photons);
            for (photon, kind) in found.into_iter().flatten() {
                photons.push(photon);
                kinds.push(kind);
            }
        }
        paths += BATCH_PATHS;
        let count = photons.len() as u64;
        if count < paths / PATHS_PER_PHOTON_LIMIT {
            return Err(TraceError::NothingHit {
                stored: count,
                paths,
            });
        }
    }
    photons.shrink_to_fit();
    kinds.shrink_to_fit();
    let share = 1.0 / paths as f64;
    photons
        .iter_mut()
        .for_each(|photon: &mut Photon| photon.power *= share);
    Ok(PhotonTrace {
        photons,
        kinds,
        paths,
    })
}

/// Makes room for `count` values more: at the first batch for the `asked` values, at the last for what exceeds them. A list that
/// grows by doubling takes up to three times its memory.
fn make_room<T>(list: &mut Vec<T>, count: usize, asked: u64) {
    if list.capacity() - list.len() < count {
        let missing = (asked as usize).saturating_sub(list.len());
        list.reserve_exact(count.max(missing));
    }
}

/// Follows one path. The powers stored are those of a path that carries the light's whole power.
fn trace_path(
    scene: &Scene,
    lights: &Lights<'_>,
    rng: &mut Pcg64Mcg,
    found: &mut Vec<(Photon, PathKind)>,
) {
    let (light, mut power) = lights.choose(rng);
    let mut kind = PathKind::Direct;
    let mut ray = Ray {
        origin: light.point(rng.random(), rng.random()),
        direction: cosine_direction(light.normal(), rng),
    };
    while let Some((index, hit)) = scene.intersect(&ray) {
        let surface = &scene.surfaces()[index];
        if !surface.is_lit(&hit) {
            return;
        }
        if surface.is_specular() {
            kind = kind.after_specular();
        } else {
            let photon = Photon {
                position: hit.position,
                power,
                surface: index as u32,
                facing: surface.facing(&hit),
            };
            found.push((photon, kind));
            kind = PathKind::Indirect;
        }
        let Some(reflected) = reflect(power, surface.reflectance(), rng.random()) else {
            return;
        };
        power = reflected;
        ray = surface.scatter(&ray, &hit, rng).ray;
    }
}

/// Russian roulette: the power that continues, or `None` where the photon is absorbed. A mirror, and a
/// diffuse surface sampled by the cosine, multiply the power only by their reflectance.
fn reflect(power: DVec3, reflectance: DVec3, chance: f64) -> Option<DVec3> {
    let reflected = power * reflectance;
    let survival = (reflected.max_element() / power.max_element()).min(MAX_SURVIVAL);
    (chance < survival).then(|| reflected / survival)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::fixtures::{chamber, chamber_with_glass, mirror_box, walls_met};

    fn traced(photons: u64, seed: u64) -> PhotonTrace {
        let scene = Scene::built_in("cornell").unwrap();
        trace(&scene, &TraceOptions { photons, seed }, &|_| ()).unwrap()
    }

    #[test]
    fn threads_do_not_matter_and_the_seed_does() {
        let pool = |threads| {
            rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap()
        };
        let one = pool(1).install(|| traced(30_000, 5));
        let three = pool(3).install(|| traced(30_000, 5));
        assert_eq!(one, three);
        assert_ne!(one.photons[0], traced(30_000, 6).photons[0]);
    }

    #[test]
    fn batches_are_completed() {
        let trace = traced(10_000, 1);
        assert!(trace.photons.len() >= 10_000);
        assert_eq!(trace.paths % BATCH_PATHS, 0);
    }

    #[test]
    fn progress_ends_at_the_count() {
        let scene = Scene::built_in("cornell").unwrap();
        let last = AtomicU64::new(0);
        let options = TraceOptions {
            photons: 1,
            seed: 1,
        };
        let progress = |stored| {
            last.fetch_max(stored, Ordering::Relaxed);
        };
        let trace = trace(&scene, &options, &progress).unwrap();
        assert_eq!(last.into_inner(), trace.photons.len() as u64);
    }

    #[test]
    fn the_strongest_channel_of_every_power_is_equal() {
        let trace = traced(50_000, 3);
        let first = trace.photons[0].power.max_element();
        for photon in &trace.photons {
            let strongest = photon.power.max_element();
            // Rounding over some 50 bounces; no channel of this light becomes stronger than red.
            assert!(
                (strongest / first - 1.0).abs() < 1e-12,
                "{strongest} {first}"
            );
        }
    }

    #[test]
    fn the_first_hits_carry_the_lights_flux() {
        // The open front lets some light out; none may be gained.
        let scene = Scene::built_in("cornell").unwrap();
        let light = scene
            .surfaces()
            .iter()
            .find(|s| s.radiance != DVec3::ZERO)
            .unwrap();
        let trace = traced(50_000, 3);
        let path_power =
            std::f64::consts::PI * light.geometry.area() * light.radiance / trace.paths as f64;
        let first = trace.photons[0].power;
        assert!((first / path_power - DVec3::ONE).abs().max_element() < 1e-12);
    }

    #[test]
    fn roulette_keeps_the_mean() {
        let power = DVec3::new(1.0, 0.5, 0.25);
        for reflectance in [DVec3::new(0.1, 0.9, 0.4), DVec3::ONE] {
            let steps = 1000;
            let sum: DVec3 = (0..steps)
                .filter_map(|i| {
                    reflect(power, reflectance, (f64::from(i) + 0.5) / f64::from(steps))
                })
                .sum();
            let error = sum / f64::from(steps) - power * reflectance;
            // The survival probability is accurate to one step in a thousand.
            assert!(error.abs().max_element() < 1e-3, "{error}");
        }
        assert_eq!(reflect(power, DVec3::ZERO, 0.0), None);
    }

    /// The share of the light's flux that reaches the floor of the chamber. With the mirror images laid out
    /// flat, photons fly straight on and lose 1 - `reflectance` at every border of a unit square.
    fn floor_share(reflectance: f64) -> f64 {
        let steps = 24i32;
        let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(steps);
        let mut sum = 0.0;
        for i in 0..steps.pow(4) {
            let digit = |n| middle(i / steps.pow(n) % steps);
            let (sine, angle) = (digit(0).sqrt(), std::f64::consts::TAU * digit(1));
            let distance = sine / (1.0 - sine * sine).sqrt();
            let walls = walls_met(
                digit(2) + distance * angle.cos(),
                digit(3) + distance * angle.sin(),
            );
            sum += reflectance.powi(walls);
        }
        sum / f64::from(steps.pow(4))
    }

    #[test]
    fn mirrors_store_no_photon_and_keep_the_energy() {
        let options = TraceOptions {
            photons: 50_000,
            seed: 4,
        };
        for reflectance in [0.5, 0.9, 1.0] {
            let scene = chamber(reflectance);
            let trace = trace(&scene, &options, &|_| ()).unwrap();
            let shapes = trace
                .photons
                .iter()
                .map(|p| &scene.surfaces()[p.surface as usize].shape);
            assert!(shapes.into_iter().all(|shape| shape == "floor"));
            let arrived: DVec3 = trace.photons.iter().map(|p| p.power).sum();
            let share = arrived / std::f64::consts::PI;
            // Five deviations of the mean of over 50,000 paths, and the grid's steps: below 1 %.
            assert!(
                (share - floor_share(reflectance)).abs().max_element() < 0.01,
                "{share}"
            );
        }
    }

    /// Floor and ceiling receive all of the flux: glass absorbs nothing, whether light goes through, is
    /// reflected, or is caught inside for a while.
    #[test]
    fn glass_stores_no_photon_and_keeps_the_energy() {
        let scene = chamber_with_glass();
        let options = TraceOptions {
            photons: 50_000,
            seed: 4,
        };
        let trace = trace(&scene, &options, &|_| ()).unwrap();
        let mut shares = [0.0; 2];
        for photon in &trace.photons {
            let shape = scene.surfaces()[photon.surface as usize].shape.as_str();
            let place = ["floor", "ceiling"].iter().position(|name| *name == shape);
            shares[place.expect("not on glass or a mirror")] +=
                photon.power.x / std::f64::consts::PI;
        }
        // Both absorb; the ceiling also receives the light that the ball reflects to it. Five deviations of
        // roulette at some tens of mirrors: below 1 %.
        assert!((shares[0] + shares[1] - 1.0).abs() < 0.01, "{shares:?}");
        assert!(shares[1] > 0.01, "{shares:?}");
    }

    /// Nothing but Russian roulette ends a path between perfect mirrors.
    #[test]
    fn a_box_of_perfect_mirrors_does_not_hang() {
        let error = trace(&mirror_box(), &TraceOptions::default(), &|_| ()).unwrap_err();
        assert!(matches!(error, TraceError::NothingHit { .. }), "{error}");
    }

    #[test]
    fn bad_counts_and_hidden_lights_are_errors() {
        let scene = Scene::built_in("cornell").unwrap();
        let options = TraceOptions {
            photons: 0,
            seed: 1,
        };
        assert_eq!(
            trace(&scene, &options, &|_| ()),
            Err(TraceError::Count { found: 0 })
        );
        let text = include_str!("../../scenes/cornell.json");
        let mut json: serde_json::Value = serde_json::from_str(text).unwrap();
        let light = json["shapes"]["light"].take();
        json["shapes"] = serde_json::json!({ "light": light });
        let alone = Scene::from_json("alone", &json.to_string()).unwrap();
        let error = trace(&alone, &TraceOptions::default(), &|_| ()).unwrap_err();
        assert!(
            matches!(error, TraceError::NothingHit { stored: 0, .. }),
            "{error}"
        );
    }
}
