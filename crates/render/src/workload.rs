//! Real work for the machine's testbench: queries of this very scene with their photons.

use photoncube_spec::{Machine, Photon, Query};
use rand::RngExt;
use thiserror::Error;

use crate::machine_map::MachineMap;
use crate::photon_map::PhotonMap;
use crate::render::RenderError;
use crate::sample::{Purpose, stream};
use crate::scene::Scene;
use crate::view::{ViewError, ViewOptions};

/// Pixels tried in a row without one that gathers a photon before giving up. Where one in a
/// hundred gathers, the chance to give up wrongly is 0.99^4096, below 1e-17.
const BARREN_PIXELS: u64 = 4096;

/// Why a workload could not be put together.
#[derive(Debug, Error)]
pub enum WorkloadError {
    /// The options give no picture.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The machine's numbers do not fit.
    #[error(transparent)]
    Numbers(#[from] RenderError),
    /// No query gathers a photon.
    #[error(
        "workload: found no query with a photon in {BARREN_PIXELS} pixels, expected one: \
         is the radius too small for the photons there are?"
    )]
    NothingGathered,
}

/// Query points picked at random from the view, each with the quantised photons that it
/// gathers, until they make at least `groups` groups of [`Machine::photons_per_iteration`] (a
/// query's last group may not be full). Queries without photons are passed over.
///
/// A photon list can exceed [`Machine::max_photons`] only where rendering fails as well.
///
/// # Errors
/// Options without pixels, formats that do not fit the map, or a view that gathers no photon.
pub fn workload(
    scene: &Scene,
    map: &PhotonMap,
    machine: &Machine,
    options: &ViewOptions,
    groups: u64,
    seed: u64,
) -> Result<Vec<(Query, Vec<Photon>)>, WorkloadError> {
    options.check()?;
    let quantised = MachineMap::new(map, machine)?;
    let mut rng = stream(seed, Purpose::Workload, 0);
    let mut queries = Vec::new();
    let (mut have, mut barren) = (0, 0);
    while have < groups {
        let x = rng.random_range(0..options.width);
        let y = rng.random_range(0..options.height);
        let sample = rng.random_range(0..options.samples_per_pixel());
        let seen = options.samples(scene, x, y).nth(sample as usize);
        let point = seen.and_then(|sample| sample.query);
        let photons: Vec<Photon> = match &point {
            Some(point) => quantised.photons(point.position, point.normal),
            None => Vec::new(),
        };
        match point.filter(|_| !photons.is_empty()) {
            Some(point) => {
                have += photons.len().div_ceil(machine.photons_per_iteration()) as u64;
                queries.push((quantised.query(point.position), photons));
                barren = 0;
            }
            None if barren == BARREN_PIXELS => return Err(WorkloadError::NothingGathered),
            None => barren += 1,
        }
    }
    Ok(queries)
}

#[cfg(test)]
mod tests {
    use photoncube_model::gather;
    use photoncube_spec::find_machine;

    use super::*;
    use crate::{TraceOptions, trace};

    fn map(scene: &Scene) -> PhotonMap {
        let options = TraceOptions {
            photons: 20_000,
            seed: 9,
        };
        let photons = trace(scene, &options, &|_| ()).unwrap().photons;
        PhotonMap::new(scene, photons, 0.1).unwrap()
    }

    #[test]
    fn there_are_enough_groups_and_the_model_takes_them() {
        let scene = Scene::built_in("cornell").unwrap();
        let map = map(&scene);
        let machine = find_machine("paper").unwrap();
        let make =
            |seed| workload(&scene, &map, machine, &ViewOptions::default(), 1000, seed).unwrap();
        let queries = make(1);
        let groups: usize = queries
            .iter()
            .map(|(_, photons)| photons.len().div_ceil(4))
            .sum();
        assert!(groups >= 1000);
        let sums = queries
            .iter()
            .map(|(query, photons)| gather(machine, query, photons.iter().copied()).unwrap());
        assert!(sums.map(|s| s.count).sum::<u64>() > 0);
        assert_eq!(queries, make(1));
        assert_ne!(queries, make(2));
    }

    #[test]
    fn a_map_without_photons_is_an_error() {
        let scene = Scene::built_in("cornell").unwrap();
        let map = PhotonMap::new(&scene, vec![], 0.1).unwrap();
        let machine = find_machine("paper").unwrap();
        let result = workload(&scene, &map, machine, &ViewOptions::default(), 1, 1);
        assert!(matches!(result, Err(WorkloadError::NothingGathered)));
    }
}
