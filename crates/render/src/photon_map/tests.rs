use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::ThreadPoolBuilder;

use super::*;
use crate::trace::{Facing, TraceOptions, trace};
use crate::view::Front;

fn scene() -> Scene {
    Scene::built_in("cornell").unwrap()
}

fn traced() -> Vec<Photon> {
    let options = TraceOptions {
        photons: 20_000,
        seed: 2,
    };
    trace(&scene(), &options, &|_| ()).unwrap().photons
}

fn faced(map: &PhotonMap, photon: &Photon) -> DVec3 {
    map.groups.normal(map.groups.group(photon))
}

#[test]
fn nothing_is_lost_and_blocks_are_slices() {
    let photons = traced();
    let map = PhotonMap::new(&scene(), photons.clone(), 0.1).unwrap();
    assert_eq!(map.photons().len(), photons.len());
    let sum = |photons: &[Photon]| photons.iter().map(|p| p.position).sum::<DVec3>();
    let mapped: Vec<_> = map.traced_photons().collect();
    // 1e-6: sums of 20,000 coordinates in two orders.
    assert!(sum(&mapped).distance(sum(&photons)) < 1e-6);
    let mut next = 0;
    for run in &map.runs {
        assert_eq!(run.photons.start, next);
        next = run.photons.end;
        for photon in &mapped[run.photons.start as usize..next as usize] {
            assert_eq!(
                (
                    block_key(map.in_blocks(photon.position)),
                    map.groups.group(photon)
                ),
                (run.block, run.group)
            );
        }
    }
    assert_eq!(next as usize, photons.len());
    assert!(map.blocks() <= map.runs.len() && map.fullest_block() > 0);
}

#[test]
fn candidates_hold_every_facing_photon_in_range_and_no_other_facing() {
    let map = PhotonMap::new(&scene(), traced(), 0.2).unwrap();
    let photons: Vec<_> = map.traced_photons().collect();
    for query in photons.iter().step_by(977) {
        let normal = faced(&map, query);
        let gathered: Vec<usize> = map
            .candidates(query.position, Front::of_any(normal))
            .flat_map(|c| c.photons)
            .collect();
        for (index, photon) in photons.iter().enumerate() {
            let faces = faced(&map, photon).dot(normal) > PhotonMap::MIN_FACING_COSINE;
            let in_range = photon.position.distance(query.position) <= 0.2;
            let is = gathered.binary_search(&index).is_ok();
            assert!(!(faces && in_range) || is, "photon {index} is missing");
            assert!(!is || faces, "photon {index} faces away");
        }
    }
}

#[test]
fn offsets_place_the_photon_in_the_query_frame() {
    let map = PhotonMap::new(&scene(), traced(), 0.3).unwrap();
    for query in map.traced_photons().step_by(1001) {
        let normal = faced(&map, &query);
        let centre = map.in_blocks(query.position).floor();
        for c in map.candidates(query.position, Front::of_any(normal)) {
            let place = centre + DVec3::from(c.offset.map(f64::from)) - DVec3::ONE;
            for photon in &map.photons()[c.photons] {
                assert_eq!(map.in_blocks(photon.position).floor(), place);
            }
        }
    }
}

#[test]
fn larger_blocks_hold_the_same_photons_in_range() {
    let (radius, edge) = (0.2, 0.2 * 16.0 / 14.0);
    let map = PhotonMap::new(&scene(), traced(), radius).unwrap();
    let larger = PhotonMap::with_edge(&scene(), traced(), radius, edge).unwrap();
    assert_eq!((larger.radius(), larger.edge()), (radius, edge));
    let count = |map: &PhotonMap, query: &Photon| {
        let near = |p: &&StoredPhoton| p.position.distance(query.position) <= radius;
        let runs = map.candidates(query.position, Front::of_any(faced(map, query)));
        let photons = runs.flat_map(|c| &map.photons()[c.photons]);
        photons.filter(near).count()
    };
    for query in map.traced_photons().step_by(977) {
        assert_eq!(count(&map, &query), count(&larger, &query));
    }
    let again = map.reblocked(edge).unwrap();
    assert_eq!(again.runs, larger.runs);
    assert_eq!(
        again.block_slices().map(|b| b.len()).sum::<usize>(),
        map.photons().len()
    );
    let error = map.reblocked(0.19).unwrap_err().to_string();
    assert!(
        error.starts_with("block edge: found 0.19, expected 0.2 to"),
        "{error}"
    );
}

#[test]
fn bad_radii_and_photons_are_errors() {
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9] {
        let error = PhotonMap::new(&scene(), vec![], radius).unwrap_err();
        assert!(matches!(error, MapError::Radius { .. }), "{error}");
    }
    let good = traced()[0];
    let bad = [
        Photon {
            position: DVec3::splat(3.0),
            ..good
        },
        Photon {
            position: DVec3::NAN,
            ..good
        },
        Photon {
            power: DVec3::NEG_X,
            ..good
        },
        Photon {
            surface: 99,
            ..good
        },
        Photon {
            facing: Facing::of(DVec3::NEG_Z),
            ..good
        },
    ];
    for photon in bad {
        let error = PhotonMap::new(&scene(), vec![good, photon], 0.1).unwrap_err();
        assert!(
            matches!(error, MapError::Photon { index: 1, .. }),
            "{error}"
        );
    }
}

#[test]
fn the_radius_for_a_count_finds_about_that_many() {
    let (scene, photons) = (scene(), traced());
    let radius = PhotonMap::radius_for(&scene, photons.len() as u64, 100.0);
    let map = PhotonMap::new(&scene, photons, radius).unwrap();
    let in_range = |query: Photon| {
        let near = |p: &&StoredPhoton| p.position.distance(query.position) <= radius;
        let facing = map.candidates(query.position, Front::of_any(faced(&map, &query)));
        facing
            .flat_map(|c| &map.photons()[c.photons])
            .filter(near)
            .count()
    };
    let sampled: Vec<usize> = map.traced_photons().step_by(97).map(in_range).collect();
    let mean = sampled.iter().sum::<usize>() as f64 / sampled.len() as f64;
    // Queries at photons favour dense places, so the mean is somewhat over 100.
    assert!((80.0..250.0).contains(&mean), "{mean}");
}

#[test]
fn an_empty_map_has_no_candidates() {
    let map = PhotonMap::new(&scene(), vec![], 0.1).unwrap();
    assert_eq!(
        map.candidates(DVec3::ZERO, Front::of_any(DVec3::Y)).count(),
        0
    );
    assert_eq!((map.blocks(), map.fullest_block()), (0, 0));
}

proptest! {
    /// Queries at any position, also far outside the grid, do not panic.
    #[test]
    fn queries_anywhere_do_not_panic(x in prop::num::f64::ANY, y in -2.0..2.0f64, z in prop::num::f64::ANY) {
        let photon = Photon { position: DVec3::ZERO, power: DVec3::ONE, surface: 0, facing: Facing::FLAT };
        let map = PhotonMap::new(&scene(), vec![photon], 0.1).unwrap();
        let _ = map.candidates(DVec3::new(x, y, z), Front::of_any(DVec3::Y)).count();
    }
}

proptest! {
    /// Compares the fast floors with the standard ones, for any number.
    #[test]
    fn floors_are_floors(
        any in prop::array::uniform3(any::<f64>()),
        near in prop::array::uniform3(-1e9..1e9),
        whole in prop::array::uniform3(-1000..1000_i64),
    ) {
        let border = [2_f64.powi(50), -(2_f64.powi(50)), 2_f64.powi(50).next_down()];
        let whole = whole.map(|index| index as f64);
        let below = whole.map(f64::next_down);
        for x in [any, near, whole, below, border, [-0.0, f64::NAN, f64::INFINITY]] {
            for x in [x, [x[0]; 3], [x[1]; 3], [x[2]; 3]] {
                let (floors, floats) = super::floors(DVec3::from_array(x));
                prop_assert_eq!(floors.to_array(), x.map(|x| x.floor() as i64));
                prop_assert_eq!(floats, floors.as_dvec3());
            }
        }
    }
}

/// Photons at few places and on few surfaces, in clusters of any size, with ties of all keys but the index.
fn clustered(scene: &Scene, photons: usize, places: u32, seed: u64) -> Vec<Photon> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let [low, high] = scene.bounds();
    let photon = |index: usize| {
        // The products crowd the lower places.
        let place = DVec3::from([(); 3].map(|()| {
            let place = rng.random_range(0..places) * rng.random_range(0..places);
            f64::from(place) / f64::from(places * places)
        }));
        Photon {
            position: low + place * (high - low),
            power: DVec3::splat(index as f64),
            surface: rng.random_range(0..3),
            facing: Facing::FLAT,
        }
    };
    (0..photons).map(photon).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The map's order is that of a plain stable sort, on any number of threads. The photons' powers tell them apart.
    #[test]
    fn the_order_is_that_of_a_stable_sort(
        photons in prop_oneof![0_usize..10, 0_usize..30_000],
        places in 1_u32..60,
        stretch in prop_oneof![Just(1.0), 1.0..4.0],
        seed: u64,
    ) {
        let (scene, radius) = (scene(), 0.07);
        let edge = stretch * radius;
        let photons = clustered(&scene, photons, places, seed);
        let maps = [1, 2, 5].map(|threads| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| PhotonMap::new_reblocked(&scene, photons.clone(), radius, edge).unwrap())
        });
        let map = &maps[0];
        prop_assert!(maps.iter().all(|other| other == map));
        let block = |p: &Photon, edge| block_key(map.in_blocks_of(p.position, edge));
        let mut expected = photons.clone();
        expected.sort_by_key(|p| (block(p, edge), map.groups.group(p), block(p, radius)));
        prop_assert_eq!(map.traced_photons().collect::<Vec<_>>(), expected);
        let runs = expected_runs(map);
        prop_assert_eq!(&map.runs, &runs);
        let again = PhotonMap::new(&scene, photons.clone(), radius).unwrap();
        prop_assert_eq!(&again.reblocked(edge).unwrap(), map);
        let with_edge = PhotonMap::with_edge(&scene, photons.clone(), radius, edge).unwrap();
        let mut expected = photons;
        expected.sort_by_key(|p| (block(p, edge), map.groups.group(p)));
        prop_assert_eq!(with_edge.traced_photons().collect::<Vec<_>>(), expected);
    }
}

/// The runs of the map's photons, one after another.
fn expected_runs(map: &PhotonMap) -> Vec<Run> {
    let key = |p: &Photon| (block_key(map.in_blocks(p.position)), map.groups.group(p));
    let photons: Vec<_> = map.traced_photons().collect();
    let mut end = 0;
    let run = |run: &[Photon]| {
        let start = end;
        end += run.len() as u32;
        let (block, group) = key(&run[0]);
        Run {
            block,
            group,
            photons: start..end,
        }
    };
    photons.chunk_by(|a, b| key(a) == key(b)).map(run).collect()
}
