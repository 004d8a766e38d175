//! The sums of all pixels over the passes, in integers, so that they do not depend on the order of the passes.
//!
//! Sums of floating-point numbers depend on their order. Passes that several computers make are summed in another order than those of
//! one, so each value is rounded once to a multiple of a step, and the multiples are added exactly. The unit is a power of two, at
//! least the radiance of the brightest lamp, which no surface exceeds but by noise.
//!
//! - The step of radiance is 2^-80 of the unit. An f64 above 2^-27 of the unit is a multiple of it, so it is not rounded.
//! - The step of luminance is 2^-36 of the unit. Squares and products of luminance, of which the noise is computed, are exact.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::pixel::Pixel;
use crate::metrics::{Moments, luminance};
use crate::scene::Scene;

/// The steps of radiance in a unit, as a power of two. A sum holds 2^47 units.
const RADIANCE_BITS: i32 = 80;

/// The steps of luminance in a unit, as a power of two.
const LUMINANCE_BITS: i32 = 36;

/// The largest luminance in the statistics, in steps: 2^20 units. A larger one counts as this. With it in every pass the sums of
/// products hold 2^12 passes, and with 16 units 2^44.
const MOST: i128 = 1 << (20 + LUMINANCE_BITS);

/// The sums of a pixel, in steps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Sums {
    /// The radiance at the search radius.
    whole: [i128; 3],
    /// The radiance at half the squared search radius.
    inner: [i128; 3],
    /// The luminances of both, x and y.
    luminance: [i128; 2],
    /// x x, x y and y y.
    products: [i128; 3],
}

impl Sums {
    fn push(&mut self, unit: f64, whole: DVec3, inner: DVec3) {
        let radiance = |value: f64| (value / unit * 2f64.powi(RADIANCE_BITS)).round() as i128;
        let [x, y] = [whole, inner].map(|radiance| {
            let steps = luminance(radiance) / unit * 2f64.powi(LUMINANCE_BITS);
            (steps.round() as i128).clamp(-MOST, MOST)
        });
        *self += Self {
            whole: whole.to_array().map(radiance),
            inner: inner.to_array().map(radiance),
            luminance: [x, y],
            products: [x * x, x * y, y * y],
        };
    }

    /// The pixel after `passes` passes.
    fn pixel(&self, unit: f64, passes: u64) -> Pixel {
        let step = unit * 2f64.powi(-RADIANCE_BITS);
        let [sum, inner_sum] = [self.whole, self.inner]
            .map(|sum| DVec3::from_array(sum.map(|steps| steps as f64)) * step);
        let means = [sum, inner_sum].map(|sum| luminance(sum) / passes.max(1) as f64);
        let moments = |[a, b]: [i64; 2]| {
            let mean = a as f64 * means[0] + b as f64 * means[1];
            let step_sq = (unit * 2f64.powi(-LUMINANCE_BITS)).powi(2);
            Moments::of(passes, mean, self.squares([a, b], passes) * step_sq)
        };
        Pixel {
            sum,
            inner_sum,
            plain: moments([1, 0]),
            corrected: moments([-1, 2]),
            bias: moments([2, -2]),
        }
    }

    /// The sum of the squared distances of a x + b y from their mean, in squared steps of luminance.
    ///
    /// It is computed about the whole number next to the mean, so that nothing cancels. Sums may leave 128 bits on the way, where they
    /// wrap; the result does not.
    fn squares(&self, [a, b]: [i64; 2], passes: u64) -> f64 {
        if passes == 0 {
            return 0.0;
        }
        let (a, b, passes) = (i128::from(a), i128::from(b), i128::from(passes));
        let sum = a * self.luminance[0] + b * self.luminance[1];
        let [xx, xy, yy] = self.products;
        let terms = [(a * a, xx), (2 * a * b, xy), (b * b, yy)];
        let near = sum.div_euclid(passes);
        let rest = sum.rem_euclid(passes);
        let about_near = terms
            .iter()
            .fold(0_i128, |all, (factor, product)| {
                all.wrapping_add(factor.wrapping_mul(*product))
            })
            .wrapping_sub(near.wrapping_mul(sum.wrapping_add(rest)));
        about_near as f64 - (rest as f64).powi(2) / passes as f64
    }
}

impl std::ops::AddAssign for Sums {
    fn add_assign(&mut self, other: Self) {
        fn add<const N: usize>(to: &mut [i128; N], from: [i128; N]) {
            to.iter_mut()
                .zip(from)
                .for_each(|(to, from)| *to = to.saturating_add(from));
        }
        add(&mut self.whole, other.whole);
        add(&mut self.inner, other.inner);
        add(&mut self.luminance, other.luminance);
        add(&mut self.products, other.products);
    }
}

/// The sums of all pixels, row by row.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pixels {
    /// The unit of radiance.
    unit: f64,
    /// The number of passes in the sums.
    pub passes: u64,
    /// Empty before the first pass.
    pub sums: Vec<Sums>,
}

impl Pixels {
    /// No passes, of a scene.
    pub fn new(scene: &Scene) -> Self {
        let lamps = scene.surfaces().iter().map(|surface| surface.radiance);
        let brightest = lamps.map(DVec3::max_element).fold(0.0, f64::max);
        Self::of_unit(match brightest > 0.0 {
            true => 2f64.powf(brightest.log2().ceil()),
            false => 1.0,
        })
    }

    /// No passes, in a unit of radiance.
    pub fn of_unit(unit: f64) -> Self {
        Self {
            unit,
            passes: 0,
            sums: Vec::new(),
        }
    }

    /// Adds a pass: the radiance of each pixel at the search radius and at half the squared radius.
    pub fn push(&mut self, whole: &[DVec3], inner: &[DVec3]) {
        self.passes += 1;
        self.sums.resize(whole.len(), Sums::default());
        for ((sums, whole), inner) in self.sums.iter_mut().zip(whole).zip(inner) {
            sums.push(self.unit, *whole, *inner);
        }
    }

    /// The pixels, row by row; none before the first pass.
    pub fn iter(&self) -> impl Iterator<Item = Pixel> {
        let pixel = |sums: &Sums| sums.pixel(self.unit, self.passes);
        self.sums.iter().map(pixel)
    }
}

/// Grey pixels in a unit of 1. Each has the values of its passes, at the search radius and at half its square.
#[cfg(test)]
pub(super) fn pixels(of: &[&[(f64, f64)]]) -> Pixels {
    let mut pixels = Pixels::of_unit(1.0);
    for pass in 0..of[0].len() {
        let values = |which: fn(&(f64, f64)) -> f64| {
            let values = of.iter().map(|passes| DVec3::splat(which(&passes[pass])));
            values.collect::<Vec<_>>()
        };
        pixels.push(&values(|both| both.0), &values(|both| both.1));
    }
    pixels
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn of(passes: &[(f64, f64)]) -> Pixels {
        pixels(&[passes])
    }

    proptest! {
        #[test]
        fn sums_do_not_depend_on_the_order_and_statistics_are_those_of_the_values(
            values in prop::collection::vec((0.0..16.0f64, 0.0..16.0f64), 1..40),
            first in 0_usize..40,
        ) {
            let whole = of(&values);
            let first = first.min(values.len());
            let mut turned = of(&values[first..]);
            for (to, from) in turned.sums.iter_mut().zip(of(&values[..first]).sums) {
                *to += from;
            }
            if first < values.len() {
                prop_assert_eq!(&turned.sums, &whole.sums);
            }
            let pixel = whole.iter().next().unwrap();
            let bias: Moments = values.iter().map(|(x, y)| 2.0 * (x - y)).collect();
            // 40 roundings of values to 32; then of their variance to steps of 2^-36.
            prop_assert!((pixel.bias.mean() - bias.mean()).abs() < 1e-12);
            let [found, expected] = [pixel.bias, bias].map(|m| m.variance().unwrap_or(0.0));
            prop_assert!((found - expected).abs() < 1e-8, "{found} {expected}");
        }
    }

    #[test]
    fn equal_passes_have_no_noise_and_one_pass_is_kept_to_the_bit() {
        let pixel = of(&[(0.1, 0.3); 7]).iter().next().unwrap();
        assert_eq!(pixel.corrected.variance(), Some(0.0));
        let pixel = of(&[(0.1, 1e-8)]).iter().next().unwrap();
        assert_eq!(
            (pixel.sum, pixel.inner_sum),
            (DVec3::splat(0.1), DVec3::splat(1e-8))
        );
    }

    #[test]
    fn a_firefly_is_no_overflow() {
        let pixels = of(&[(1e9, 0.0), (0.0, 1e9), (1e9, 1e9)]);
        let pixel = pixels.iter().next().unwrap();
        assert_eq!(pixel.sum, DVec3::splat(2e9));
        assert!(pixel.bias.variance().unwrap() > 1e12);
    }

    #[test]
    fn the_unit_is_that_of_the_brightest_lamp() {
        let scene = Scene::built_in("cornell").unwrap();
        let pixels = Pixels::new(&scene);
        let lamps = scene.surfaces().iter().map(|surface| surface.radiance);
        let brightest = lamps.map(DVec3::max_element).fold(0.0, f64::max);
        assert!(brightest > 0.0);
        assert!(brightest <= pixels.unit && pixels.unit < 2.0 * brightest);
        assert_eq!(pixels.unit.log2().fract(), 0.0);
    }
}
