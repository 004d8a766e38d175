//! The most memory that photons take, from tracing to the numbers of an engine. A test binary of its own, because it counts all memory
//! that is allocated in the process.

use std::alloc::System;

use cap::Cap;
use photoncube_render::{
    Engine, Lighting, PhotonMaps, QuantisedMap, Radii, Scene, TraceOptions, trace,
};
use photoncube_spec::{find_machine, find_photon_format};
use rayon::ThreadPoolBuilder;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// The bound of the project, in bytes. A traced photon takes 56 bytes, and 4 for its group until it is stored in 48; then 10 for the
/// sort; then 7.5 in planes or 14 as a record. The rest is for the tracing, sorting and rounding of two threads, which are a larger part of
/// few photons than of more.
const BYTES_A_PHOTON: f64 = 64.0;

#[test]
fn photons_take_64_bytes_at_the_most() {
    // Each thread sorts and rounds photons in memory of its own.
    let pool = ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    pool.install(|| {
        let format = find_photon_format("local8-rgb8e5").unwrap();
        let machine = find_machine("paper").unwrap();
        let engines = [Engine::from(&format), Engine::from(machine)];
        for photons in [100_000, 1_000_000] {
            for engine in engines {
                let peak = peak_of(photons, engine);
                assert!(
                    peak <= BYTES_A_PHOTON,
                    "{peak} of {photons} with {engine:?}"
                );
            }
        }
    });
}

/// The most bytes a photon of the Cornell box that were allocated in the process up to the engine's numbers, without those allocated
/// before, where none before took more.
fn peak_of(photons: u64, engine: Engine<'_>) -> f64 {
    let scene = Scene::built_in("cornell").unwrap();
    let lighting = Lighting::default();
    let before = ALLOCATOR.allocated();
    let options = TraceOptions { photons, seed: 1 };
    let traced = trace(&scene, &options, &|_| ()).unwrap();
    let radii = Radii::of(&scene, &traced, &lighting, 200.0);
    let maps = PhotonMaps::for_engine(&scene, traced, &lighting, radii, engine).unwrap();
    let Engine::Integers(numbers, _) = engine else {
        unreachable!("an engine of integers");
    };
    let quantised = QuantisedMap::new(&maps.global, &numbers).unwrap();
    let photons = quantised.map().photons().len();
    assert!(photons as u64 >= options.photons);
    (ALLOCATOR.max_allocated() - before) as f64 / photons as f64
}
