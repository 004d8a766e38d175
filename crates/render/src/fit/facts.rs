//! Facts about a scene's light, measured on photon maps of it.

use glam::DVec3;
use serde::Serialize;

use crate::photon_map::PhotonMap;
use crate::view::QueryPoint;

/// The facts that decide the channels, the exponent and the size of the sums.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SceneFacts {
    /// The largest deviation of a photon's power from a multiple of its map's one colour, by its
    /// strongest channel.
    pub colour_deviation: f64,
    /// Whether all photons have one colour, so that one channel represents their light exactly.
    pub one_colour: bool,
    /// The power of the strongest photon over that of the weakest, each by its strongest channel. Photons
    /// without power are ignored.
    pub power_spread: f64,
    /// The largest number of photons that one query tests.
    pub largest_query: u64,
}

impl SceneFacts {
    /// The largest deviation of light that counts as one colour. Products of a hundred reflectances each
    /// round by 1e-16, and the colour, a sum of up to a million photons, by 1e-10 at most. A deviation over
    /// 1e-9 is a colour; a smaller one is far below half a step of the finest mantissa, 2^-17.
    pub const COLOUR_TOLERANCE: f64 = 1e-9;

    pub(super) fn of(maps: &[PhotonMap], queries: &[QueryPoint]) -> Self {
        let deviations = maps.iter().map(colour_deviation);
        let colour_deviation = deviations.fold(0.0, f64::max);
        let largest = maps.iter().map(|map| largest_query(map, queries));
        Self {
            colour_deviation,
            one_colour: colour_deviation <= Self::COLOUR_TOLERANCE,
            power_spread: maps.iter().map(power_spread).fold(1.0, f64::max),
            largest_query: largest.max().unwrap_or(0),
        }
    }
}

/// The largest number of photons that one of these queries tests, in blocks of the map's edge.
#[must_use]
pub fn largest_query(map: &PhotonMap, queries: &[QueryPoint]) -> u64 {
    let tests = |query: &QueryPoint| {
        let runs = map.candidates(query.position, query.front());
        runs.map(|run| run.photons.len() as u64).sum()
    };
    queries.iter().map(tests).max().unwrap_or(0)
}

fn colour_deviation(map: &PhotonMap) -> f64 {
    let sum: DVec3 = map.photons().iter().map(|photon| photon.power).sum();
    let colour = sum / sum.max_element();
    let lit = map.photons().iter().map(|photon| photon.power);
    let deviations = lit.filter(|power| power.max_element() > 0.0).map(|power| {
        let strongest = power.max_element();
        (power / strongest - colour).abs().max_element()
    });
    deviations.fold(0.0, f64::max)
}

fn power_spread(map: &PhotonMap) -> f64 {
    let powers = map
        .photons()
        .iter()
        .map(|photon| photon.power.max_element());
    let (low, high) = powers
        .filter(|power| *power > 0.0)
        .fold((f64::INFINITY, 0.0), |(low, high), power| {
            (f64::min(low, power), f64::max(high, power))
        });
    high / low
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::fixtures::map_of_powers;

    #[test]
    fn only_equal_colours_are_one_colour() {
        let colour = DVec3::new(0.3, 0.7, 0.1);
        let of = |powers: &[DVec3]| SceneFacts::of(&[map_of_powers(powers)], &[]);
        let equal = of(&[colour, colour / 3.0, DVec3::ZERO, 1e-6 * colour]);
        assert!(equal.one_colour, "{equal:?}");
        assert!((equal.power_spread / 1e6 - 1.0).abs() < 1e-12);
        let almost = of(&[colour, colour + DVec3::new(0.0, 0.0, 1e-7)]);
        assert!(!almost.one_colour, "{almost:?}");
        assert!(of(&[DVec3::X]).one_colour);
    }
}
