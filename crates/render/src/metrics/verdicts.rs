//! Compares an engine's in-range decisions about a query's photons with the reference.

use photoncube_model::{GatherError, gather};

use super::misclassified::Misclassified;
use crate::photon_map::PhotonMap;
use crate::quantise::{FormatMap, QuantisedMap};
use crate::trace::Photon;
use crate::view::QueryPoint;

fn is_in_range(map: &PhotonMap, photon: &Photon, query: &QueryPoint) -> bool {
    photon.position.distance_squared(query.position) <= map.radius() * map.radius()
}

pub(super) fn f64_verdicts(map: &PhotonMap, query: &QueryPoint) -> Misclassified {
    let mut counts = Misclassified::default();
    for run in map.candidates(query.position, query.normal) {
        for photon in &map.photons()[run.photons] {
            let inside = is_in_range(map, photon, query);
            counts.push(inside, inside);
        }
    }
    counts
}

/// The golden model itself decides, photon by photon.
pub(super) fn model_verdicts(
    map: &PhotonMap,
    quantised: &QuantisedMap<'_>,
    query: &QueryPoint,
) -> Result<Misclassified, GatherError> {
    let runs = map.candidates(query.position, query.normal);
    let floats = runs.flat_map(|run| &map.photons()[run.photons]);
    let integers = quantised.photons(query.position, query.normal);
    let centre = quantised.query(query.position);
    let mut counts = Misclassified::default();
    for (float, integer) in floats.zip(integers) {
        let sums = gather(quantised.machine(), &centre, [integer])?;
        counts.push(is_in_range(map, float, query), sums.count == 1);
    }
    Ok(counts)
}

pub(super) fn format_verdicts(quantised: &FormatMap<'_>, query: &QueryPoint) -> Misclassified {
    let mut counts = Misclassified::default();
    for (photon, verdict) in quantised.verdicts(query.position, query.normal) {
        counts.push(is_in_range(quantised.map(), photon, query), verdict);
    }
    counts
}
