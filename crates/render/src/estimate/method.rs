//! Methods: an estimator together with the data that every query needs, for any engine.

use std::f64::consts::SQRT_2;

use photoncube_model::Gathered;

use super::estimator::{Estimator, UnfitEstimator};
use super::gather::{Estimate, Refusal, disc_area, estimate_f64, gather_format, gather_model};
use super::integers::{Disc, Steps};
use super::kernel::Kernel;
use super::ladder::Ladder;
use super::neighbourhood::{EstimatorError, KernelEstimate, Neighbourhood};
use crate::photon_map::PhotonMap;
use crate::quantise::FormatMap;
use crate::render::{Engine, Prepared};
use crate::view::QueryPoint;

/// An [`Estimator`] that an engine can make, with the data that every query needs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Method {
    /// The rectangle at the map's search radius.
    FixedRadius,
    /// The rectangle at half the squared search radius, from which bias is estimated.
    Inner,
    /// The rectangle with the k-th photon's distance as the radius.
    KNearest(u64),
    /// A smooth kernel in f64.
    Smooth(Kernel),
    /// A ladder of rectangles.
    Ladder(Ladder),
}

impl Method {
    /// Makes the method of an estimator.
    ///
    /// # Errors
    /// As for [`Estimator::check`].
    pub fn new(estimator: Estimator, engine: Engine<'_>) -> Result<Self, UnfitEstimator> {
        estimator.check(engine)?;
        Ok(match estimator {
            Estimator::FixedRadius => Self::FixedRadius,
            Estimator::KNearest { k } => Self::KNearest(k),
            Estimator::Smooth {
                kernel: Kernel::Rectangle,
            } => Self::FixedRadius,
            Estimator::Smooth { kernel } => Self::Smooth(kernel),
            Estimator::Ladder { kernel, rungs } => Self::Ladder(Ladder::new(kernel, rungs)?),
        })
    }

    /// The estimate at a query. `map` is the one that the engine was prepared for.
    ///
    /// # Errors
    /// The engine refuses the query.
    pub fn estimate(
        &self,
        engine: &Prepared<'_>,
        map: &PhotonMap,
        query: &QueryPoint,
    ) -> Result<Estimate, Refusal> {
        match engine {
            Prepared::F64 => Ok(self.in_f64(map, query)?),
            Prepared::Model(quantised) => {
                let steps = Steps {
                    radius_sq: quantised.query(query.position).radius_sq,
                    exact_radius_sq: quantised.exact_radius_sq(),
                    disc_area: disc_area(map),
                };
                let gather = |radius_sq| Ok(gather_model(quantised, query, radius_sq)?);
                self.in_integers(&steps, gather)
            }
            Prepared::Format(quantised, _) => {
                let gather = |radius_sq| Ok(gather_format(quantised, query, radius_sq)?);
                self.in_integers(&steps_of(quantised), gather)
            }
        }
    }

    /// The estimates at all queries, in their order. They equal those of [`Self::estimate`]; the fast gather
    /// makes them sooner where it can.
    ///
    /// # Errors
    /// The engine refuses a query; the error has its index.
    pub fn estimate_all(
        &self,
        engine: &Prepared<'_>,
        map: &PhotonMap,
        queries: &[QueryPoint],
    ) -> Result<Vec<Estimate>, (usize, Refusal)> {
        if let Prepared::Format(quantised, _) = engine
            && let Some(found) = self.together(quantised, queries)
        {
            return Ok(found);
        }
        let estimate = |(index, query)| {
            let estimate = self.estimate(engine, map, query);
            estimate.map_err(|refusal| (index, refusal))
        };
        queries.iter().enumerate().map(estimate).collect()
    }

    /// The estimates by the fast gather. `None` where each query has its own radii, and where a query was
    /// refused; going on query by query then finds which.
    fn together(&self, map: &FormatMap<'_>, queries: &[QueryPoint]) -> Option<Vec<Estimate>> {
        let steps = steps_of(map);
        let radii = match self {
            Self::FixedRadius => vec![steps.radius_sq],
            Self::Inner => vec![steps.inner_radius_sq()],
            Self::Ladder(ladder) => ladder.radii_sq(steps.radius_sq),
            Self::KNearest(_) | Self::Smooth(_) => return None,
        };
        let mut order: Vec<usize> = (0..queries.len()).collect();
        order.sort_by_cached_key(|index| map.map().sort_key(&queries[*index]));
        let sorted: Vec<_> = order.iter().map(|index| queries[*index]).collect();
        let at = |radius_sq: &u32| map.gather_all_within(&sorted, *radius_sq).ok();
        let gathered: Vec<_> = radii.iter().map(at).collect::<Option<_>>()?;
        let mut found = vec![Estimate::default(); queries.len()];
        for (place, query) in order.iter().enumerate() {
            // The gathers are in the order of the radii.
            let mut discs = gathered.iter().map(|all| disc(map, &all[place]));
            let estimate = self.in_integers(&steps, |_| Ok(discs.next().expect("one for each")));
            found[*query] = estimate.ok()?;
        }
        Some(found)
    }

    /// The radius of the estimate's area for a map of search radius `radius`, where it is equal for all
    /// queries and not a mixture of several; else `None`.
    pub fn radius(&self, radius: f64) -> Option<f64> {
        match self {
            Self::FixedRadius => Some(radius),
            Self::Inner => Some(radius / SQRT_2),
            Self::KNearest(_) | Self::Smooth(_) | Self::Ladder(_) => None,
        }
    }

    /// The estimate in f64. A ladder counts one gather for each rung, as a machine does; all other methods
    /// count one.
    fn in_f64(&self, map: &PhotonMap, query: &QueryPoint) -> Result<Estimate, EstimatorError> {
        let radius = map.radius();
        match self {
            // The reference of all engines, which needs no list of distances.
            Self::FixedRadius => Ok(estimate_f64(map, query)),
            Self::Inner => walk(map, query, 1, |near| {
                near.fixed_radius(radius / SQRT_2, Kernel::Rectangle)
            }),
            Self::KNearest(k) => walk(map, query, 1, |near| near.k_nearest(*k, Kernel::Rectangle)),
            Self::Smooth(kernel) => walk(map, query, 1, |near| near.fixed_radius(radius, *kernel)),
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
            Self::FixedRadius => steps.fixed_radius(gather),
            Self::Inner => steps.inner(gather),
            Self::KNearest(k) => steps.k_nearest(*k, gather),
            Self::Smooth(kernel) => Err(UnfitEstimator::SmoothInIntegers(*kernel).into()),
            Self::Ladder(ladder) => steps.ladder(ladder, gather),
        }
    }
}

fn steps_of(map: &FormatMap<'_>) -> Steps {
    Steps {
        radius_sq: map.radius_sq(),
        exact_radius_sq: map.radius_sq().into(),
        disc_area: disc_area(map.map()),
    }
}

fn disc(map: &FormatMap<'_>, gathered: &Gathered) -> Disc {
    Disc {
        power: map.flux(gathered.sums.power),
        tests: gathered.photons,
        skipped: gathered.photons - gathered.tests,
        count: gathered.sums.count,
    }
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
