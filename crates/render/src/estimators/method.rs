//! An estimator at work: any form of estimate, by any engine.

use super::estimator::{Estimator, UnfitEstimator};
use super::integers::{Disc, Steps};
use super::kernel::Kernel;
use super::ladder::Ladder;
use super::neighbourhood::{EstimatorError, KernelEstimate, Neighbourhood};
use crate::estimate::{Estimate, Refusal, disc_area, estimate_f64, gather_format, gather_model};
use crate::photon_map::PhotonMap;
use crate::render::{Engine, Prepared};
use crate::view::QueryPoint;

/// An [`Estimator`] that an engine can make, with what is needed of it at every query.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Method {
    /// At the map's search radius, the rectangle.
    FixedRadius,
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
                let steps = Steps {
                    radius_sq: quantised.radius_sq(),
                    exact_radius_sq: quantised.radius_sq().into(),
                    disc_area: disc_area(map),
                };
                let gather = |radius_sq| Ok(gather_format(quantised, query, radius_sq)?);
                self.in_integers(&steps, gather)
            }
        }
    }

    /// The ladder counts a gather for each rung, as on a machine; the others are one.
    fn in_f64(&self, map: &PhotonMap, query: &QueryPoint) -> Result<Estimate, EstimatorError> {
        let radius = map.radius();
        match self {
            // The reference of all engines, without a list of distances.
            Self::FixedRadius => Ok(estimate_f64(map, query)),
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
            Self::KNearest(k) => steps.k_nearest(*k, gather),
            Self::Smooth(kernel) => Err(UnfitEstimator::SmoothInIntegers(*kernel).into()),
            Self::Ladder(ladder) => steps.ladder(ladder, gather),
        }
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
        in_range: found.in_range,
        gathers,
    })
}

#[cfg(test)]
mod tests;
