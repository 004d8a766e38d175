//! Predicts a format's error from its two parts.

use std::collections::HashMap;

use photoncube_spec::{PhotonFormat, PowerFormat};
use serde::Serialize;

use super::pilot::{Part, Pilot};
use super::position::position_part;
use super::power::Gathered;
use crate::metrics::{BenchError, MISCLASSIFIED_TIMES_STEPS, Measure};

/// A predicted error as a fraction of the noise, in the measure where it is largest.
///
/// Positions and powers round independently of one another: their mean squares add, and so do their biases,
/// so that error^2 = position^2 + power^2 + 2 bias bias.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Prediction {
    /// The measure with the largest error.
    pub measure: Measure,
    /// The predicted error over the noise.
    pub error_over_noise: f64,
    /// The part that the positions alone cause.
    pub position_error_over_noise: f64,
    /// The part that the powers alone cause.
    pub power_error_over_noise: f64,
    /// For comparison, the error of evenly spread photons: sqrt(0.67 / u) with u = 2^p.
    pub law_error_over_noise: f64,
}

/// Predicts formats on a pilot. Every part is measured once, when it is first needed.
pub(super) struct Predictor {
    pilot: Pilot,
    gathered: Gathered,
    positions: HashMap<(u32, u32), Part>,
    powers: HashMap<PowerFormat, Part>,
    /// Parts of powers that were measured on one map only.
    rough_powers: HashMap<PowerFormat, Part>,
}

/// The largest number of extra fraction bits of a query.
const FINEST_QUERY: u32 = 2;

/// The factor above the bound at which one map decides. One map knows a mean square over thousands of queries
/// far better than to this factor.
const FAR_ABOVE: f64 = 2.0;

impl Predictor {
    pub fn new(pilot: Pilot) -> Result<Self, BenchError> {
        Ok(Self {
            gathered: Gathered::new(&pilot)?,
            pilot,
            positions: HashMap::new(),
            powers: HashMap::new(),
            rough_powers: HashMap::new(),
        })
    }

    pub fn pilot(&self) -> &Pilot {
        &self.pilot
    }

    /// The number of parts of positions and powers measured so far.
    pub fn parts(&self) -> u64 {
        (self.positions.len() + self.powers.len() + self.rough_powers.len()) as u64
    }

    /// Predicts the error of the format.
    pub fn predict(&mut self, format: &PhotonFormat) -> Result<Prediction, BenchError> {
        let position = self.position(format.position_bits, format.query_extra_bits)?;
        let power = self.power(&format.power)?;
        let predictions = Measure::ALL.into_iter().filter_map(|measure| {
            let noise = self.pilot.noise(measure)?;
            let (a, b) = (position[measure as usize], power[measure as usize]);
            let square = a.rms().powi(2) + b.rms().powi(2) + 2.0 * a.mean() * b.mean();
            let prediction = Prediction {
                measure,
                error_over_noise: square.max(0.0).sqrt() / noise,
                position_error_over_noise: a.rms() / noise,
                power_error_over_noise: b.rms() / noise,
                law_error_over_noise: law(format),
            };
            Some((measure, prediction))
        });
        let worst = Measure::worst(predictions, |p| p.error_over_noise);
        Ok(worst.expect("a pilot's luminance has noise").1)
    }

    /// Whether one of the format's parts alone exceeds the bound, which quickly excludes whole families of
    /// formats. Formats with equal position bits are excluded by the one with the finest queries, and powers
    /// by one map where they are far above.
    pub fn a_part_exceeds(
        &mut self,
        format: &PhotonFormat,
        bound: f64,
    ) -> Result<bool, BenchError> {
        let finest = self.position(format.position_bits, FINEST_QUERY)?;
        if self.worst(&finest) > bound {
            return Ok(true);
        }
        let own = self.position(format.position_bits, format.query_extra_bits)?;
        if self.worst(&own) > bound {
            return Ok(true);
        }
        let rough = self.rough_power(&format.power)?;
        Ok(self.worst(&rough) > FAR_ABOVE * bound)
    }

    fn worst(&self, part: &Part) -> f64 {
        let measures = Measure::ALL.into_iter().zip(part);
        let ratios = measures.filter_map(|(measure, moments)| {
            let noise = self.pilot.noise(measure)?;
            Some(moments.rms() / noise)
        });
        ratios.fold(0.0, f64::max)
    }

    fn position(&mut self, p: u32, x: u32) -> Result<Part, BenchError> {
        if let Some(part) = self.positions.get(&(p, x)) {
            return Ok(*part);
        }
        let part = position_part(&self.pilot, p, x)?;
        self.positions.insert((p, x), part);
        Ok(part)
    }

    fn power(&mut self, power: &PowerFormat) -> Result<Part, BenchError> {
        if let Some(part) = self.powers.get(power) {
            return Ok(*part);
        }
        let part = self.gathered.power_part(&self.pilot, power)?;
        self.powers.insert(*power, part);
        Ok(part)
    }

    fn rough_power(&mut self, power: &PowerFormat) -> Result<Part, BenchError> {
        if let Some(part) = self.rough_powers.get(power) {
            return Ok(*part);
        }
        let part = self.gathered.rough_part(&self.pilot, power)?;
        self.rough_powers.insert(*power, part);
        Ok(part)
    }
}

/// The error over the noise for evenly spread photons, sqrt(0.67 / u) with u = 2^p steps per radius. Around a
/// caustic it is too small by half or more.
fn law(format: &PhotonFormat) -> f64 {
    let steps = f64::from(1_u32 << format.position_bits);
    (MISCLASSIFIED_TIMES_STEPS / steps).sqrt()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_photon_format;

    use super::*;
    use crate::metrics::{BenchOptions, ErrorBench};
    use crate::{Engine, Scene, ViewOptions};

    /// Compares the parts, each measured alone, with both together in the golden model, on the same maps and
    /// queries. The tolerance is 12 %: the pilot shifts the lattice and the model does not, and each knows
    /// the positions' error, some 40,000 misclassified photons of unequal weight, to 4 % (95 %).
    #[test]
    fn the_two_parts_add_as_squares() {
        let options = BenchOptions {
            photons: 50_000,
            maps: 6,
            view: ViewOptions {
                width: 32,
                height: 32,
                ..BenchOptions::default().view
            },
            ..BenchOptions::default()
        };
        let scene = Scene::built_in("cornell").unwrap();
        let bench = ErrorBench::new(&scene, &options).unwrap();
        let mut predictor = Predictor::new(Pilot::new(bench.clone()).unwrap()).unwrap();
        for (name, is_position) in [
            ("local5-rgb8d", true),
            ("local6x2-rgb5d", true),
            ("local7x1-rgb5", false),
            ("local9-rgb4d", false),
        ] {
            let format = find_photon_format(name).unwrap();
            let predicted = predictor.predict(&format).unwrap();
            let joint = bench.measure_light(Engine::from(&format)).unwrap();
            let ratio = predicted.error_over_noise / joint.worst().1.error_over_noise;
            println!("{name}: {predicted:?}, ratio {ratio:.3}");
            assert!((ratio - 1.0).abs() < 0.12, "{name}: {ratio}");
            let (position, power) = (
                predicted.position_error_over_noise,
                predicted.power_error_over_noise,
            );
            assert_eq!(position > power, is_position, "{name}");
        }
    }

    #[test]
    fn the_law_is_a_root_of_the_steps() {
        let law = |name| law(&find_photon_format(name).unwrap());
        assert!((law("local6-rgb8") - 0.102_3).abs() < 1e-4);
        // Two divisions and roots.
        assert!((law("local6-rgb8") / law("local8x1-rgb8") - 2.0).abs() < 1e-12);
    }
}
