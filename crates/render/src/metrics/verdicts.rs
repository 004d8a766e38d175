//! Compares an engine's in-range decisions about a query's photons with the reference.

use super::misclassified::Misclassified;
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::view::QueryPoint;

/// The decisions of the engine of `quantised`, photon by photon; without one, those of the reference itself.
pub(super) fn verdicts(
    map: &PhotonMap,
    quantised: Option<&QuantisedMap<'_>>,
    query: &QueryPoint,
) -> Misclassified {
    let radius_sq = map.radius() * map.radius();
    let mut counts = Misclassified::default();
    if let Some(quantised) = quantised {
        for (photon, verdict) in quantised.verdicts(query.position, query.front()) {
            let truly = photon.position.distance_squared(query.position) <= radius_sq;
            counts.push(truly, verdict);
        }
        return counts;
    }
    for run in map.candidates(query.position, query.front()) {
        for photon in &map.photons()[run.photons] {
            let truly = photon.position.distance_squared(query.position) <= radius_sq;
            counts.push(truly, truly);
        }
    }
    counts
}
