//! Makes a workload for the testbench: queries of a scene with their photons.

use photoncube_spec::{Machine, Photon, Query};
use rand::RngExt;
use thiserror::Error;

use crate::photon_map::PhotonMap;
use crate::quantise::{QuantiseError, QuantisedMap};
use crate::scene::Scene;
use crate::trace::sample::{Purpose, stream};
use crate::view::{ViewError, ViewOptions};

/// The number of pixels tried in a row without a photon before the search ends. Where one in a hundred
/// gathers a photon, the chance of a wrong end is 0.99^4096, below 1e-17.
const BARREN_PIXELS: u64 = 4096;

/// The reason why no workload could be made.
#[derive(Debug, Error)]
pub enum WorkloadError {
    /// The options describe no picture.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The machine's numbers do not fit.
    #[error(transparent)]
    Numbers(#[from] QuantiseError),
    /// No query gathers a photon.
    #[error(
        "workload: found no query with a photon in {BARREN_PIXELS} pixels, expected one: \
         is the radius too small for the photons there are?"
    )]
    NothingGathered,
}

/// Picks query points of the view at random, each with the quantised photons that it gathers, until they make
/// at least `groups` groups of [`Machine::photons_per_iteration`] (a query's last group may be partly
/// filled). Queries without photons are skipped. For a machine that tests several queries at once, each
/// picked pixel is followed by as many pixels around it as share its photons, up to that number.
///
/// A photon list can exceed [`Machine::max_photons`] only where rendering fails as well.
///
/// # Errors
/// The options have no pixels, the number formats do not fit the map, or no query of the view gathers a
/// photon.
pub fn workload(
    scene: &Scene,
    map: &PhotonMap,
    machine: &Machine,
    options: &ViewOptions,
    groups: u64,
    seed: u64,
) -> Result<Vec<(Query, Vec<Photon>)>, WorkloadError> {
    options.check()?;
    let quantised = QuantisedMap::new(map, &machine.numbers)?;
    let mut rng = stream(seed, Purpose::Workload, 0);
    let mut queries = Vec::new();
    let (mut have, mut barren) = (0, 0);
    while have < groups {
        let pixel = Pixel {
            x: rng.random_range(0..options.width),
            y: rng.random_range(0..options.height),
            sample: rng.random_range(0..options.samples_per_pixel()),
        };
        let look = |pixel| seen(scene, options, &quantised, pixel);
        match look(pixel) {
            Some((query, photons)) => {
                have += photons.len().div_ceil(machine.photons_per_iteration()) as u64;
                let around = pixel.around(options, machine.queries_at_once());
                let others = around.filter_map(look).filter(|(_, seen)| *seen == photons);
                let others: Vec<_> = others.collect();
                queries.push((query, photons));
                queries.extend(others.into_iter().take(machine.queries_at_once() - 1));
                barren = 0;
            }
            None if barren == BARREN_PIXELS => return Err(WorkloadError::NothingGathered),
            None => barren += 1,
        }
    }
    Ok(queries)
}

/// A sample of a pixel.
#[derive(Copy, Clone)]
struct Pixel {
    x: u32,
    y: u32,
    sample: u32,
}

impl Pixel {
    /// The sample with this index in the other pixels of a square around this one, inside the picture. The
    /// square has at least `pixels` pixels; for one pixel there are no others.
    fn around(self, options: &ViewOptions, pixels: usize) -> impl Iterator<Item = Self> + use<> {
        let reach = (pixels as f64).sqrt().ceil() as u32 / 2;
        let within =
            |centre: u32, size: u32| centre.saturating_sub(reach)..=(centre + reach).min(size - 1);
        let columns = within(self.x, options.width);
        let rows = within(self.y, options.height);
        let pixels = rows.flat_map(move |y| columns.clone().map(move |x| Self { x, y, ..self }));
        pixels.filter(move |other| (other.x, other.y) != (self.x, self.y))
    }
}

/// The query that a sample sees, with its photons; `None` if it gathers none.
fn seen(
    scene: &Scene,
    options: &ViewOptions,
    quantised: &QuantisedMap<'_>,
    pixel: Pixel,
) -> Option<(Query, Vec<Photon>)> {
    let sample = options
        .samples(scene, pixel.x, pixel.y)
        .nth(pixel.sample as usize);
    let point = sample?.query?;
    let photons = quantised.photons(point.position, point.front());
    let photons: Vec<_> = photons.collect();
    (!photons.is_empty()).then(|| (quantised.query(point.position), photons))
}

#[cfg(test)]
mod tests {
    use photoncube_model::gather;
    use photoncube_spec::find_machine;

    use super::*;
    use crate::scene::fixtures::traced_cornell;

    #[test]
    fn there_are_enough_groups_and_the_model_takes_them() {
        let (scene, map) = traced_cornell(20_000, 9, 0.1);
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
