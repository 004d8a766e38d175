//! Rounds powers by the rules of [`photoncube_spec::PhotonFormat`], "Power".

use glam::DVec3;
use photoncube_spec::{Channels, PowerFormat, Rounding};
use rayon::prelude::*;

use crate::photon_map::{PhotonMap, StoredPhoton};
use crate::trace::sample::mix;

/// The conversion of a map's powers to the integers of a format and back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PowerScale {
    /// The flux of a power of 1.
    unit: f64,
    /// The largest mantissa.
    full: f64,
    exponent_range: u8,
    rounding: Rounding,
    /// The common colour of all photons, with its strongest channel 1; `None` where each photon has its own
    /// colour.
    colour: Option<DVec3>,
}

impl PowerScale {
    pub fn new(map: &PhotonMap, power: PowerFormat) -> Self {
        let full = f64::from((1_u32 << power.mantissa_bits) - 1);
        let exponent_range = power.exponent_range() as u8;
        let powers = map.photons().par_iter().map(|p| p.power.max_element());
        let largest = powers.reduce(|| 0.0, f64::max);
        let unit = largest / full / power_of_two(exponent_range);
        Self {
            // A subnormal unit would round differently; such powers are practically no light.
            unit: if unit.is_normal() { unit } else { 1.0 },
            full,
            exponent_range,
            rounding: power.rounding,
            colour: match power.channels {
                Channels::Rgb => None,
                Channels::Mono => Some(colour(map.photons())),
            },
        }
    }

    /// The smallest exponent at which all of these photons fit.
    pub fn exponent(&self, photons: &[StoredPhoton]) -> u8 {
        let value = strongest(photons) / self.unit;
        let fits = |exponent: &u8| {
            let mantissa = value / power_of_two(*exponent);
            match self.rounding {
                Rounding::Nearest => mantissa.round() <= self.full,
                Rounding::Dithered => mantissa <= self.full,
            }
        };
        // The value is at least 2^k. With an exponent below the first, the mantissa would have more bits than full scale.
        let biased = value.abs().to_bits() >> (f64::MANTISSA_DIGITS - 1);
        let k = biased as i64 - i64::from(f64::MAX_EXP - 1);
        let mantissa_bits = i64::from((self.full as u32).count_ones());
        let first = (k - mantissa_bits + 1).clamp(0, self.exponent_range.into()) as u8;
        // At the largest exponent the map's strongest photon fits, by the choice of the unit.
        let found = (first..self.exponent_range).find(fits);
        found.unwrap_or(self.exponent_range)
    }

    /// The mantissas of a photon whose stored position is `cell`.
    pub fn mantissa(&self, power: DVec3, exponent: u8, cell: [u16; 3]) -> [u16; 3] {
        let stored = match self.colour {
            None => power,
            Some(_) => DVec3::new(power.max_element(), 0.0, 0.0),
        };
        let scaled = (stored / self.unit / power_of_two(exponent)).to_array();
        let mut channels = 0_u64..;
        scaled.map(|value| {
            let channel = channels.next().unwrap_or_default();
            let rounded = match self.rounding {
                Rounding::Nearest => value.round(),
                Rounding::Dithered => (value + dither(cell, channel)).floor(),
            };
            // The division by the unit may round the strongest photon an ulp past full scale.
            rounded.min(self.full) as u16
        })
    }

    /// The flux of a power, or of a sum of powers, in the map's unit.
    pub fn flux(&self, power: DVec3) -> DVec3 {
        let power = match self.colour {
            None => power,
            Some(colour) => power.x * colour,
        };
        power * self.unit
    }
}

fn strongest(photons: &[StoredPhoton]) -> f64 {
    let powers = photons.iter().map(|photon| photon.power.max_element());
    powers.fold(0.0, f64::max)
}

/// The colour of the photons' sum, with its strongest channel 1; white where there is no light.
fn colour(photons: &[StoredPhoton]) -> DVec3 {
    let sum: DVec3 = photons.iter().map(|photon| photon.power).sum();
    let strongest = sum.max_element();
    if strongest > 0.0 {
        sum / strongest
    } else {
        DVec3::ONE
    }
}

pub(crate) fn power_of_two(exponent: u8) -> f64 {
    (1_u64 << exponent) as f64
}

/// A multiple of 2^-16 from 0 up to 1, determined by the stored position and the channel: the top bits of
/// SplitMix64's finaliser.
fn dither(cell: [u16; 3], channel: u64) -> f64 {
    let [x, y, z] = cell.map(u64::from);
    let hash = mix(x | y << 16 | z << 32 | channel << 48);
    (hash >> 48) as f64 / 65_536.0
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_photon_format;

    use super::*;
    use crate::scene::fixtures::{map_of_powers, traced_cornell};

    #[test]
    fn dither_is_uniform() {
        let cells = (0..64).flat_map(|x| (0..64).map(move |y| [x, y, 7]));
        let values: Vec<f64> = cells.map(|cell| dither(cell, 1)).collect();
        let mean = values.iter().sum::<f64>() / 4096.0;
        // Five standard deviations of the mean of 4096 uniform numbers, each of deviation sqrt(1/12).
        assert!(
            (mean - 0.5).abs() < 5.0 * (1.0_f64 / 12.0 / 4096.0).sqrt(),
            "{mean}"
        );
        assert!(values.iter().all(|t| (0.0..1.0).contains(t)));
    }

    /// Equal powers all round alike to nearest. With dithering, their mean is the power.
    #[test]
    fn dithered_powers_have_no_bias() {
        let third = DVec3::new(0.37, 0.0, 0.0);
        let map = map_of_powers(&[DVec3::X, third]);
        let mean = |name| {
            let scale = PowerScale::new(&map, find_photon_format(name).unwrap().power);
            let cells = (0..100).flat_map(|x| (0..100).map(move |y| [x, y, 3]));
            let total: f64 = cells
                .map(|cell| f64::from(scale.mantissa(third, 0, cell)[0]))
                .sum();
            scale.flux(DVec3::new(total / 1e4, 0.0, 0.0)).x / 0.37 - 1.0
        };
        // 0.37 of 7 steps is 2.59: 3 is 16 % too much. A dithered step is 1 of 2.59, deviation
        // below 0.5, over the root of 10,000: 0.2 %.
        assert!(mean("local8-rgb3") > 0.15);
        assert!(mean("local8-rgb3d").abs() < 5.0 * 0.002);
    }

    #[test]
    fn the_strongest_photon_is_full_scale_however_it_is_rounded() {
        for largest in [1.0, 0.1, 1.0 / 3.0, 7e-7] {
            let map = map_of_powers(&[DVec3::splat(largest)]);
            for name in [
                "local8-rgb8e5",
                "local8-rgb8e5d",
                "local8-mono5d",
                "local8-rgb1b1d",
            ] {
                let format = find_photon_format(name).unwrap();
                let scale = PowerScale::new(&map, format.power);
                let exponent = scale.exponent(map.photons());
                assert_eq!(u32::from(exponent), format.power.exponent_range());
                let mantissa = scale.mantissa(map.photons()[0].power, exponent, [0; 3]);
                // With dithering, an ulp may round down to one less.
                let full = (1 << format.power.mantissa_bits) - 1;
                assert!(
                    mantissa[0] == full
                        || (format.power.rounding == Rounding::Dithered && mantissa[0] + 1 == full),
                    "{name}"
                );
            }
        }
    }

    /// The exponent is the first of all at which the power fits.
    #[test]
    fn exponents_are_the_smallest_that_fit() {
        for name in [
            "local8-rgb8e5",
            "local8-rgb3e5d",
            "local8-rgb1b1d",
            "local8-rgb8",
        ] {
            let format = find_photon_format(name).unwrap();
            let scale = PowerScale::new(&map_of_powers(&[DVec3::ONE]), format.power);
            let powers = (0..=40).map(|k| 0.5_f64.powi(k));
            let near = powers.flat_map(|p| [1.0, 0.999, 0.997, 0.75, 0.5001].map(|part| p * part));
            for power in near.flat_map(|p| [p, p.next_down()]).chain([0.0]) {
                let photon = map_of_powers(&[DVec3::splat(power)]).photons()[0];
                let fits = |exponent: &u8| {
                    let mantissa = power / scale.unit / power_of_two(*exponent);
                    match format.power.rounding {
                        Rounding::Nearest => mantissa.round() <= scale.full,
                        Rounding::Dithered => mantissa <= scale.full,
                    }
                };
                let smallest = (0..scale.exponent_range).find(fits);
                let smallest = smallest.unwrap_or(scale.exponent_range);
                assert_eq!(scale.exponent(&[photon]), smallest, "{name} {power}");
            }
        }
    }

    /// Light of one colour needs one channel: all three channels are restored.
    #[test]
    fn one_channel_holds_light_of_one_colour() {
        let colour = DVec3::new(0.5, 1.0, 0.25);
        let map = map_of_powers(&[3.0 * colour, 2.0 * colour, 0.5 * colour]);
        let scale = PowerScale::new(&map, find_photon_format("local8-mono16").unwrap().power);
        for photon in map.photons() {
            let [mantissa, none @ ..] = scale.mantissa(photon.power, 0, [0; 3]);
            assert_eq!(none, [0; 2]);
            let flux = scale.flux(DVec3::new(mantissa.into(), 0.0, 0.0));
            // Half a step of 65,535 of the largest, 3.
            assert!((flux - photon.power).abs().max_element() < 0.5001 * 3.0 / 65_535.0);
        }
    }

    #[test]
    fn traced_light_keeps_its_mean_when_dithered() {
        let (_, map) = traced_cornell(20_000, 4, 0.1);
        let format = find_photon_format("local8-rgb5e5d").unwrap();
        let quantised = crate::QuantisedMap::new(&map, &format.into()).unwrap();
        let total: DVec3 = (0..quantised.records().len())
            .map(|index| quantised.power(index))
            .sum();
        let exact: DVec3 = map.photons().iter().map(|photon| photon.power).sum();
        // A step is at most 1/16 of a power, its deviation below half of that, over the root of
        // 20,000 photons: 2e-4.
        assert!(
            (total / exact - 1.0).abs().max_element() < 5.0 * 2e-4,
            "{total} {exact}"
        );
    }
}
