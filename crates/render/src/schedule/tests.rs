use std::collections::HashSet;

use photoncube_spec::{Numbers, find_photon_format};

use super::batches::REGION_BLOCKS;
use super::*;
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::scene::fixtures::traced_cornell;
use crate::view::{QueryPoint, ViewOptions};
use crate::view_queries;

const FORMATS: [&str; 2] = ["local7-rgb6d-n4096", "local6x2-rgb6d-n4096"];

const BATCHES: [BatchOptions; 3] = [
    BatchOptions {
        queries: 1,
        facings: Facings::Engine,
    },
    BatchOptions {
        queries: 16,
        facings: Facings::Chain,
    },
    BatchOptions {
        queries: 64,
        facings: Facings::Engine,
    },
];

fn traced() -> (PhotonMap, Vec<QueryPoint>) {
    let (scene, map) = traced_cornell(20_000, 9, 0.1);
    let view = ViewOptions {
        width: 24,
        height: 24,
        samples_per_axis: 1,
        seed: 1,
    };
    let queries = view_queries(&scene, &view).unwrap();
    (map, queries)
}

fn quantised<'a>(map: &'a PhotonMap, format: &str) -> QuantisedMap<'a> {
    QuantisedMap::new(map, &Numbers::Local(find_photon_format(format).unwrap())).unwrap()
}

/// The photons in range of queries that are in no leaf that their batch reads with this radius, and those that are.
fn lost(
    map: &QuantisedMap<'_>,
    leaves: &Leaves,
    batches: &Batches,
    cull: Cull,
    radius: i64,
) -> (usize, usize) {
    let (mut lost, mut found) = (0, 0);
    for batch in &batches.batches {
        let groups = leaves.all().iter().flat_map(Leaf::groups);
        let near = groups.filter(|(bounds, _)| cull.reads(**bounds, batch.bounds, radius));
        let read: HashSet<_> = near.flat_map(|(_, photons)| photons).copied().collect();
        for query in &batches.queries[batch.queries.clone()] {
            let candidates = map.map().candidates(query.position, query.front());
            let photons = candidates.flat_map(|run| run.photons);
            let verdicts = map.verdicts(query.position, query.front());
            for (photon, (_, in_range)) in photons.zip(verdicts) {
                let is_read = read.contains(&(photon as u32));
                found += usize::from(in_range && is_read);
                lost += usize::from(in_range && !is_read);
            }
        }
    }
    (lost, found)
}

#[test]
fn a_group_with_a_photon_in_range_is_always_read() {
    let (map, queries) = traced();
    for format in FORMATS {
        let map = quantised(&map, format);
        let radius = map.numbers().format().unwrap().radius_steps();
        let leaves = Leaves::new(&map, 8);
        for options in BATCHES {
            let batches = Batches::new(&map, &queries, &options);
            let expected = map.gather_all(&batches.queries, map.radius_sq()).unwrap();
            let expected: u64 = expected.iter().map(|query| query.sums.count).sum();
            for cull in Cull::ALL {
                let found = lost(&map, &leaves, &batches, cull, i64::from(2 * radius));
                assert_eq!(
                    found,
                    (0, expected as usize),
                    "{format} {options:?} {cull:?}"
                );
            }
        }
        // A planted fault: a radius that is an eighth too short loses photons.
        let batches = Batches::new(&map, &queries, &BATCHES[0]);
        for cull in Cull::ALL {
            let short = i64::from(2 * radius * 7 / 8);
            assert!(lost(&map, &leaves, &batches, cull, short).0 > 0, "{cull:?}");
        }
    }
}

#[test]
fn every_photon_is_in_one_leaf_and_every_query_in_one_batch() {
    let (map, queries) = traced();
    let map = quantised(&map, FORMATS[0]);
    for size in [1, 8, 16] {
        let leaves = Leaves::new(&map, size);
        let mut photons: Vec<_> = leaves
            .all()
            .iter()
            .flat_map(|leaf| leaf.photons.clone())
            .collect();
        assert!(
            leaves
                .all()
                .iter()
                .all(|leaf| (1..=size as usize).contains(&leaf.photons.len()))
        );
        photons.sort_unstable();
        assert!(photons.into_iter().eq(0..map.records().len() as u32));
    }
    let block_bits = map.numbers().format().unwrap().radius_bits() + 1;
    for options in BATCHES {
        let batches = Batches::new(&map, &queries, &options);
        let mut next = 0;
        for batch in &batches.batches {
            assert_eq!(batch.queries.start, next);
            assert!((1..=options.queries as usize).contains(&batch.queries.len()));
            for corner in [batch.bounds.low, batch.bounds.high] {
                let blocks =
                    [0, 1, 2].map(|axis| (corner[axis] >> block_bits) - batch.region[axis]);
                assert!(
                    blocks
                        .iter()
                        .all(|block| (0..REGION_BLOCKS).contains(block))
                );
            }
            next = batch.queries.end;
        }
        assert_eq!(next, queries.len());
        assert_eq!(batches.queries.len(), queries.len());
    }
}

/// With [`Facings::Engine`] a batch does not tell the facing of its queries.
#[test]
fn of_the_batches_of_a_facing_in_a_region_only_the_last_is_not_full() {
    let (map, queries) = traced();
    let map = quantised(&map, FORMATS[0]);
    let options = BatchOptions {
        queries: 4,
        facings: Facings::Chain,
    };
    let batches = Batches::new(&map, &queries, &options).batches;
    let mut together = 0;
    for pair in batches.windows(2) {
        if (pair[0].region, pair[0].facings) == (pair[1].region, pair[1].facings) {
            assert_eq!(pair[0].queries.len(), 4);
            together += 1;
        }
    }
    assert!(together > 0);
    let mut kinds: Vec<_> = batches.iter().map(|of| (of.region, of.facings)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    assert_eq!(batches.len() - together, kinds.len());
}

#[test]
fn small_batches_test_fewer_photons_and_the_clocks_are_their_sum() {
    let (map, queries) = traced();
    let map = quantised(&map, FORMATS[0]);
    let leaves = Leaves::new(&map, 8);
    let of = |options: BatchOptions, cull| {
        cost(&map, &leaves, &Batches::new(&map, &queries, &options), cull)
    };
    let costs = BATCHES.map(|options| of(options, Cull::Distance));
    for (of, options) in costs.iter().zip(BATCHES) {
        assert_eq!(of.queries, queries.len() as u64);
        assert_eq!(
            of.photon_tests,
            of.groups_read * 4 * u64::from(options.queries)
        );
        assert_eq!(of.reading_clocks, of.groups_read);
        assert!(of.clocks >= of.reading_clocks && of.groups_read <= 2 * of.leaves_compared);
    }
    assert!(costs[0].photon_tests < costs[1].photon_tests);
    assert!(costs[1].photon_tests < costs[2].photon_tests);
    for (by_distance, options) in costs.iter().zip(BATCHES) {
        let by_axes = of(options, Cull::Axes);
        assert!(by_distance.groups_read < by_axes.groups_read);
        assert_eq!(by_distance.leaves_compared, by_axes.leaves_compared);
    }
}

#[test]
fn a_box_is_read_up_to_the_radius_and_no_further() {
    let unit = Bounds {
        low: [0; 3],
        high: [2; 3],
    };
    use Cull::{Axes, Distance};
    for (point, cull, radius) in [
        ([1, 1, 1], Axes, 0),
        ([1, 1, 1], Distance, 0),
        ([5, 0, 0], Axes, 3),
        ([5, 0, 0], Distance, 3),
        ([5, -4, 2], Axes, 4),
        ([5, -4, 2], Distance, 5),
    ] {
        let reads = |radius| cull.reads(unit, Bounds::at(point), radius);
        assert!(reads(radius), "{point:?} {cull:?}");
        assert!(radius == 0 || !reads(radius - 1), "{point:?} {cull:?}");
    }
}
