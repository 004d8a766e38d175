//! Makes the estimates of an [`Estimator`], by any engine.

use std::f64::consts::SQRT_2;

use photoncube_model::Gathered;

use super::estimator::{Estimator, UnfitEstimator};
use super::gather::{Estimate, Refusal, estimate_f64, gather};
use super::integers::{Disc, KNearest, NearestSearch, Steps};
use super::kernel::Kernel;
use super::neighbourhood::{EstimatorError, KernelEstimate, Neighbourhood};
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::render::{Gatherer, GathererError, NearestGathered};
use crate::view::QueryPoint;

/// An engine's maps are a photon map and, in an engine of integers, `quantised`, which is that map in its
/// integers.
impl Estimator {
    /// The estimate at a query.
    ///
    /// # Errors
    /// The engine refuses the query.
    pub(crate) fn estimate(
        &self,
        map: &PhotonMap,
        quantised: Option<&QuantisedMap<'_>>,
        query: &QueryPoint,
    ) -> Result<Estimate, Refusal> {
        match quantised {
            None => Ok(self.in_f64(map, query)?),
            Some(quantised) => {
                let gather = |radius_sq| Ok(gather(quantised, query, radius_sq)?);
                self.in_integers(&Steps::of(quantised), gather)
            }
        }
    }

    /// The estimates at all queries, in their order. They equal those of [`Self::estimate`]; the fast gather
    /// makes them sooner where it can.
    ///
    /// # Errors
    /// The engine refuses a query; the error has its index.
    pub(crate) fn estimate_all(
        &self,
        map: &PhotonMap,
        quantised: Option<&QuantisedMap<'_>>,
        queries: &[QueryPoint],
    ) -> Result<Vec<Estimate>, (usize, Refusal)> {
        let together = |quantised: &QuantisedMap<'_>| {
            let gather = |queries: &[QueryPoint], radii_sq: &[u32]| {
                let at = |radius_sq: &u32| quantised.gather_all(queries, *radius_sq).ok();
                radii_sq.iter().map(at).collect()
            };
            self.together(quantised, queries, gather)
        };
        if let Some(found) = quantised.and_then(together) {
            return Ok(found);
        }
        let estimate = |(index, query)| {
            let estimate = self.estimate(map, quantised, query);
            estimate.map_err(|refusal| (index, refusal))
        };
        queries.iter().enumerate().map(estimate).collect()
    }

    /// The estimates at all queries, in their order, from the gathers of a machine. Where a query has a gather after the other, each
    /// gather of the machine has the queries that need one more.
    ///
    /// # Errors
    /// The gatherer's.
    ///
    /// # Panics
    /// For an estimate that integers cannot make, see [`Self::check`].
    pub(crate) fn estimate_by(
        &self,
        gatherer: &dyn Gatherer,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
    ) -> Result<Vec<Estimate>, GathererError> {
        if let Self::KNearest { k } = self {
            return nearest_by(*k, gatherer, map, queries);
        }
        let mut error = None;
        let found = self.together(map, queries, |queries, radii_sq| {
            gatherer
                .gather_ladder(map, queries, radii_sq)
                .map_err(|found| error = Some(found))
                .ok()
        });
        match error {
            None => Ok(found.expect("checked: an estimate from gathers at one radius")),
            Some(error) => Err(error),
        }
    }

    /// The estimates from gathers of all queries at once. `None` where each query has its own radii, and where
    /// a query was refused; going on query by query then finds which.
    fn together(
        &self,
        map: &QuantisedMap<'_>,
        queries: &[QueryPoint],
        gather_all: impl FnOnce(&[QueryPoint], &[u32]) -> Option<Vec<Vec<Gathered>>>,
    ) -> Option<Vec<Estimate>> {
        let steps = Steps::of(map);
        let radii = match self {
            Self::FixedRadius
            | Self::Smooth {
                kernel: Kernel::Rectangle,
            } => vec![steps.radius_sq],
            Self::Halved(times) => vec![steps.halved_radius_sq(*times)],
            Self::Ladder(ladder) => ladder.radii_sq(steps.radius_sq),
            Self::KNearest { .. } | Self::Smooth { .. } => return None,
        };
        let mut order: Vec<usize> = (0..queries.len()).collect();
        order.sort_by_cached_key(|index| map.map().sort_key(&queries[*index]));
        let sorted: Vec<_> = order.iter().map(|index| queries[*index]).collect();
        let gathered = gather_all(&sorted, &radii)?;
        let mut found = vec![Estimate::default(); queries.len()];
        for (place, query) in order.iter().enumerate() {
            // The gathers are in the order of the radii.
            let mut discs = gathered.iter().map(|all| Disc::of(map, &all[place]));
            let estimate = self.in_integers(&steps, |_| Ok(discs.next().expect("one for each")));
            found[*query] = estimate.ok()?;
        }
        Some(found)
    }

    /// The radius of the estimate's area for a map of search radius `radius`, where it is equal for all
    /// queries and not a mixture of several; else `None`.
    pub(crate) fn radius(&self, radius: f64) -> Option<f64> {
        match self {
            Self::FixedRadius => Some(radius),
            Self::Halved(times) => Some(halved(radius, *times)),
            Self::KNearest { .. } | Self::Smooth { .. } | Self::Ladder(_) => None,
        }
    }

    /// The estimate in f64. A ladder counts one gather for each rung, as a machine does; all others count one.
    fn in_f64(&self, map: &PhotonMap, query: &QueryPoint) -> Result<Estimate, EstimatorError> {
        let radius = map.radius();
        match self {
            // The reference of all engines, which needs no list of distances.
            Self::FixedRadius
            | Self::Smooth {
                kernel: Kernel::Rectangle,
            } => Ok(estimate_f64(map, query)),
            Self::Halved(times) => walk(map, query, 1, |near| {
                near.fixed_radius(halved(radius, *times), Kernel::Rectangle)
            }),
            Self::KNearest { k } => {
                walk(map, query, 1, |near| near.k_nearest(*k, Kernel::Rectangle))
            }
            Self::Smooth { kernel } => {
                walk(map, query, 1, |near| near.fixed_radius(radius, *kernel))
            }
            Self::Ladder(ladder) => {
                let rungs = ladder.rungs().len() as u64;
                walk(map, query, rungs, |near| near.ladder(radius, ladder))
            }
        }
    }

    fn in_integers(
        &self,
        steps: &Steps,
        gather: impl FnMut(u32) -> Result<Disc, Refusal>,
    ) -> Result<Estimate, Refusal> {
        match self {
            Self::FixedRadius
            | Self::Smooth {
                kernel: Kernel::Rectangle,
            } => steps.fixed_radius(gather),
            Self::Halved(times) => steps.halved(*times, gather),
            Self::KNearest { k } => steps.k_nearest(*k, gather),
            Self::Smooth { kernel } => Err(UnfitEstimator::SmoothInIntegers(*kernel).into()),
            Self::Ladder(ladder) => steps.ladder(ladder, gather),
        }
    }
}

/// The radius whose square is that of `radius`, halved `times` times.
pub(crate) fn halved(radius: f64, times: u32) -> f64 {
    // Powers of two round nothing.
    let even = radius * 0.5_f64.powi((times / 2) as i32);
    match times % 2 {
        0 => even,
        _ => even / SQRT_2,
    }
}

/// The estimates at the k-th photons: those that the machine finds, and the others in rounds of gathers.
fn nearest_by(
    k: u64,
    gatherer: &dyn Gatherer,
    map: &QuantisedMap<'_>,
    queries: &[QueryPoint],
) -> Result<Vec<Estimate>, GathererError> {
    let steps = Steps::of(map);
    let by_machine = gatherer.k_nearest(map, queries, k)?;
    let mut searches = vec![NearestSearch::new(k, steps.radius_sq); queries.len()];
    loop {
        let open = searches.iter().enumerate();
        let open = open.filter(|(query, _)| by_machine[*query].is_none());
        let open = open.filter_map(|(query, search)| Some((query, search.next()?)));
        let (open, radii): (Vec<_>, Vec<_>) = open.unzip();
        if open.is_empty() {
            break;
        }
        let asked: Vec<_> = open.iter().map(|&query| queries[query]).collect();
        let gathered = gatherer.gather_all(map, &asked, &radii)?;
        for (query, gathered) in open.into_iter().zip(gathered) {
            searches[query].tell(Disc::of(map, &gathered));
        }
    }
    let found = |(search, by_machine): (&NearestSearch, &Option<NearestGathered>)| match by_machine
    {
        Some(found) => KNearest {
            // A disc without area has no density.
            radius_sq: found.radius_sq.max(1),
            disc: Disc::of(map, &found.gathered),
            gathers: found.gathers,
        },
        None => search.found(),
    };
    let found = searches.iter().zip(&by_machine).map(found);
    Ok(found.map(|found| steps.of_nearest(&found)).collect())
}

/// An estimate from the photons of the blocks around the query.
fn walk(
    map: &PhotonMap,
    query: &QueryPoint,
    gathers: u64,
    estimate: impl FnOnce(&Neighbourhood) -> Result<KernelEstimate, EstimatorError>,
) -> Result<Estimate, EstimatorError> {
    let near = Neighbourhood::block_walk(map, query);
    let found = estimate(&near)?;
    Ok(Estimate {
        irradiance: found.irradiance,
        tests: near.near().len() as u64,
        skipped: 0,
        in_range: found.in_range,
        gathers,
    })
}

#[cfg(test)]
mod tests;
