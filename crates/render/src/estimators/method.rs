//! An estimator at work: any form of estimate, by any engine.

use std::f64::consts::SQRT_2;

use photoncube_model::Gathered;

use super::estimator::{Estimator, UnfitEstimator};
use super::integers::{Disc, Steps};
use super::kernel::Kernel;
use super::ladder::Ladder;
use super::neighbourhood::{EstimatorError, KernelEstimate, Neighbourhood};
use crate::estimate::{Estimate, Refusal, disc_area, estimate_f64, gather_format, gather_model};
use crate::format_map::FormatMap;
use crate::photon_map::PhotonMap;
use crate::render::{Engine, Prepared};
use crate::view::QueryPoint;

/// An [`Estimator`] that an engine can make, with what is needed of it at every query.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Method {
    /// At the map's search radius, the rectangle.
    FixedRadius,
    /// The same at half the squared radius: what bias is estimated from.
    Inner,
    /// At the k-th photon.
    KNearest(u64),
    /// A smooth kernel in f64.
    Smooth(Kernel),
    /// Its rectangles.
    Ladder(Ladder),
}

impl Method {
    /// What makes the estimates.
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
    /// What the engine refuses.
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

    /// The estimates at all queries, in their order: the same, sooner where the fast gather can make them.
    ///
    /// # Errors
    /// What the engine refuses, and at which query.
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

    /// By the fast gather. None where each query has radii of its own, and where one was refused: going on one
    /// at a time says which.
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
            // The radii are asked for in their order.
            let mut discs = gathered.iter().map(|all| disc(map, &all[place]));
            let estimate = self.in_integers(&steps, |_| Ok(discs.next().expect("one for each")));
            found[*query] = estimate.ok()?;
        }
        Some(found)
    }

    /// The radius that the estimate's area is of, if it is the same at all queries and no mixture of several, for
    /// a map of search radius `radius`.
    pub fn radius(&self, radius: f64) -> Option<f64> {
        match self {
            Self::FixedRadius => Some(radius),
            Self::Inner => Some(radius / SQRT_2),
            Self::KNearest(_) | Self::Smooth(_) | Self::Ladder(_) => None,
        }
    }

    /// The ladder counts a gather for each rung, as on a machine; the others are one.
    fn in_f64(&self, map: &PhotonMap, query: &QueryPoint) -> Result<Estimate, EstimatorError> {
        let radius = map.radius();
        match self {
            // The reference of all engines, without a list of distances.
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

/// An estimate on the photons of the blocks around the query.
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
