//! Forecasts the clocks that a machine takes for all queries of a picture.

use std::collections::HashMap;

use photoncube_spec::{Machine, Pace, SharedGroups};

use crate::photon_map::{MapError, PhotonMap};
use crate::quantise::QuantisedMap;
use crate::view::QueryPoint;

/// The clocks for these queries of `map` while no stream waits. Queries that are tested against equal photons
/// follow each other, as from a host that knows the blocks. `None` where the machine has no program.
///
/// # Errors
/// A format whose blocks do not fit the map.
pub fn forecast_clocks(
    map: &PhotonMap,
    queries: &[QueryPoint],
    machine: &Machine,
) -> Result<Option<u64>, MapError> {
    let Some(pace) = Pace::of(machine) else {
        return Ok(None);
    };
    let lists = shared(&*QuantisedMap::blocked(map, &machine.numbers)?, queries);
    let lanes = machine.photons_per_iteration() as u64;
    let lists = lists.values().map(|(queries, photons)| SharedGroups {
        queries: *queries,
        groups: photons.div_ceil(lanes),
    });
    Ok(Some(pace.clocks(lists)))
}

/// For each list of runs that queries are tested against: the number of queries and the number of photons.
fn shared(map: &PhotonMap, queries: &[QueryPoint]) -> HashMap<Vec<usize>, (u64, u64)> {
    let mut lists: HashMap<Vec<usize>, (u64, u64)> = HashMap::new();
    for query in queries {
        let (mut runs, mut photons) = (Vec::new(), 0);
        for run in map.candidates(query.position, query.front()) {
            runs.push(run.run);
            photons += run.photons.len() as u64;
        }
        lists.entry(runs).or_insert((0, photons)).0 += 1;
    }
    lists
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;
    use crate::scene::fixtures::traced_cornell;
    use crate::{Engine, ViewOptions, render, view_queries};

    fn of_the_box(machine: &str) -> (u64, u64, u64) {
        let (scene, map) = traced_cornell(20_000, 9, 0.15);
        let view = ViewOptions {
            width: 24,
            height: 16,
            samples_per_axis: 1,
            seed: 9,
        };
        let machine = find_machine(machine).unwrap();
        let queries = view_queries(&scene, &view).unwrap();
        let clocks = forecast_clocks(&map, &queries, machine).unwrap().unwrap();
        let stats = render(&scene, &map, Engine::from(machine), &view, &|_| ()).unwrap();
        (clocks, stats.stats.photon_groups, stats.stats.query_points)
    }

    /// Compares the forecast with the groups that the golden model gathered, query by query.
    #[test]
    fn the_forecast_is_the_clocks_of_what_is_rendered() {
        let (clocks, groups, queries) = of_the_box("paper");
        assert_eq!(clocks, 9 * groups + 2 * queries);
        let (clocks, groups, _) = of_the_box("stream");
        let latency = find_machine("stream")
            .unwrap()
            .spatial()
            .unwrap()
            .latency_clocks();
        assert_eq!(clocks, groups + u64::from(latency));
        // 1.5 clocks for each group, and about 18 more for each query.
        let (clocks, groups, queries) = of_the_box("overlap");
        let over = clocks as f64 - 1.5 * groups as f64;
        assert!((10.0..25.0).contains(&(over / queries as f64)), "{over}");
    }

    /// Four engines divide the clocks by at most four, and queries of one block fill some of the engines.
    #[test]
    fn a_tile_is_faster_where_queries_share_photons() {
        let (clocks, groups, _) = of_the_box("tile-6");
        assert!(
            clocks >= groups / 4 && clocks < groups,
            "{clocks} of {groups}"
        );
    }
}
