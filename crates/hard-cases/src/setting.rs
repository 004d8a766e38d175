//! A setting: photons with queries among them.

use glam::DVec3;
use photoncube_spec::{Machine, Photon, PhotonFormat, Query, Sums};

use super::case::HardCaseError;
use super::room::FRONT;
use photoncube_render::{PhotonMap, QuantisedMap, QueryPoint};

/// A photon map with query points.
#[derive(Debug, Clone)]
pub struct Setting {
    /// The photons, in blocks of the grid that the setting was made for.
    pub map: PhotonMap,
    /// Query points.
    pub queries: Vec<DVec3>,
    /// The number of photons in range of each query, where it follows from their placement; else empty.
    pub counts: Vec<u64>,
}

impl Setting {
    /// A setting whose counts do not follow from the placement.
    pub(super) fn new(map: PhotonMap, queries: Vec<DVec3>) -> Self {
        Self {
            map,
            queries,
            counts: Vec::new(),
        }
    }

    /// A setting of one query whose photons in range are known.
    pub(super) fn counted(map: PhotonMap, query: DVec3, count: u64) -> Self {
        Self {
            map,
            queries: vec![query],
            counts: vec![count],
        }
    }

    /// The sums of every query in a format, by the fast gather.
    pub(super) fn sums(&self, format: &PhotonFormat) -> Result<Vec<Sums>, HardCaseError> {
        let quantised = QuantisedMap::new(&self.map, &format.into())?;
        let query = |&position: &DVec3| QueryPoint {
            position,
            normal: FRONT.normal,
            surface: FRONT.surface,
            beta: DVec3::ONE,
        };
        let queries: Vec<_> = self.queries.iter().map(query).collect();
        let found = quantised.gather_all(&queries, quantised.radius_sq())?;
        Ok(found.into_iter().map(|found| found.sums).collect())
    }

    /// The number of photons that a format counts too much or too little.
    pub(super) fn miscounted(&self, format: &PhotonFormat) -> Result<u64, HardCaseError> {
        let sums = self.sums(format)?;
        let pairs = sums.iter().zip(&self.counts);
        Ok(pairs.map(|(sums, count)| sums.count.abs_diff(*count)).sum())
    }

    /// The queries with their photons as the words of a machine.
    ///
    /// # Errors
    /// The machine's numbers do not fit.
    pub fn workload(&self, machine: &Machine) -> Result<Vec<(Query, Vec<Photon>)>, HardCaseError> {
        let words = QuantisedMap::new(&self.map, &machine.numbers)?;
        let queries = self.queries.iter();
        Ok(queries
            .map(|&query| (words.query(query), words.photons(query, FRONT).collect()))
            .collect())
    }
}
