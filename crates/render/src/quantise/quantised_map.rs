//! Converts photons and queries to the integers of a machine with plain numbers.
//!
//! A position is an unsigned fraction of its block, `floor(fraction * 2^f)` with f =
//! [`PlainFormat::position_bits`]. Queries follow the same rule, so that the mean error of a difference is
//! zero. The machine's coordinates span a frame of four block edges that starts one block before the query's
//! own. A block's offset of 0, 1 or 2 is added to the fraction, and no coordinate can overflow (the largest
//! is 3 * 2^f - 1). Where block edge and search radius are equal, as in [`PhotonMap::new`], the squared
//! radius is exactly 2^(2f); otherwise it is rounded down to a square step.
//!
//! Power is linear. The whole map has one step: the largest channel of any photon over `2^power_bits - 1`.
//! Powers are rounded to nearest, because truncation would bias every estimate, and more photons would not
//! remove the bias.

use photoncube_spec::{self as spec, Machine, Numbers, PlainFormat};
use rayon::prelude::*;
use thiserror::Error;

use glam::DVec3;

use crate::photon_map::{Candidates, PhotonMap};

/// The error of a machine to whose numbers the photon map cannot be converted.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum QuantiseError {
    /// A field is outside its legal range.
    #[error("machine `{machine}`: {field} is {found}, expected {min} to {max}")]
    Field {
        /// The name of the machine.
        machine: &'static str,
        /// The name of the field.
        field: &'static str,
        /// The field's value.
        found: u32,
        /// The smallest legal value.
        min: u32,
        /// The largest legal value.
        max: u32,
    },
    /// The machine has a photon format.
    #[error("machine `{machine}` has the photon format {format}, expected plain numbers")]
    NotPlain {
        /// The name of the machine.
        machine: &'static str,
        /// The name of its photon format.
        format: String,
    },
}

/// The photons of a map in one machine's integers, in the order of the map.
#[derive(Debug, Clone)]
pub struct QuantisedMap<'a> {
    map: &'a PhotonMap,
    machine: &'a Machine,
    format: &'a PlainFormat,
    photons: Vec<StoredPhoton>,
    power_step: f64,
}

/// A stored photon; its position is relative to its block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct StoredPhoton {
    fraction: [u16; 3],
    power: [u16; 3],
}

impl<'a> QuantisedMap<'a> {
    /// Rounds every photon of `map` to the plain numbers of `machine`.
    ///
    /// # Errors
    /// Coordinates outside 3 to 17 bits (a fraction of 1 to 15 bits, whose squared radius fits 32 bits),
    /// powers outside 1 to 16 bits, or a machine with a photon format.
    pub fn new(map: &'a PhotonMap, machine: &'a Machine) -> Result<Self, QuantiseError> {
        let format = match &machine.numbers {
            Numbers::Plain(format) => format,
            Numbers::Local(format) => {
                return Err(QuantiseError::NotPlain {
                    machine: machine.name,
                    format: format.name(),
                });
            }
        };
        check(machine, "coordinate_bits", format.coordinate_bits, 3, 17)?;
        check(machine, "power_bits", format.power_bits, 1, 16)?;
        let power_step = power_step(map, format.power_bits);
        let stored = |photon: &crate::Photon| StoredPhoton {
            fraction: fraction(map, photon.position, format.position_bits()).map(|f| f as u16),
            // Rounds half away from zero; the result cannot exceed the largest power.
            power: (photon.power / power_step)
                .round()
                .to_array()
                .map(|p| p as u16),
        };
        Ok(Self {
            map,
            machine,
            format,
            photons: map.photons().par_iter().map(stored).collect(),
            power_step,
        })
    }

    /// The machine that the integers are for.
    #[must_use]
    pub fn machine(&self) -> &'a Machine {
        self.machine
    }

    /// The flux of one step of the integer power.
    #[must_use]
    pub fn power_step(&self) -> f64 {
        self.power_step
    }

    /// The search radius squared in the machine's steps, not rounded.
    pub(crate) fn exact_radius_sq(&self) -> f64 {
        let edge = 1 << self.machine.position_bits();
        let radius = f64::from(edge) * (self.map.radius() / self.map.edge());
        radius.powi(2)
    }

    /// The machine's query at `position`: the fraction in its block, plus the edge of one block.
    #[must_use]
    pub fn query(&self, position: DVec3) -> spec::Query {
        let edge = 1 << self.format.position_bits();
        spec::Query {
            position: fraction(self.map, position, self.format.position_bits()).map(|f| edge + f),
            // The rounding of the quotient must not reduce a radius of whole steps by a square step.
            radius_sq: (self.exact_radius_sq() * (1.0 + 1e-12)) as u32,
        }
    }

    /// The photons that a query at `position` on a surface of unit normal `normal` gathers, in the query's
    /// frame, in the order of the stream.
    pub fn photons(&self, position: DVec3, normal: DVec3) -> impl Iterator<Item = spec::Photon> {
        let runs = self.map.candidates(position, normal);
        runs.flat_map(
            |Candidates {
                 offset, photons, ..
             }| {
                let base = offset.map(|blocks| blocks << self.format.position_bits());
                self.photons[photons].iter().map(move |p| spec::Photon {
                    position: std::array::from_fn(|axis| base[axis] + u32::from(p.fraction[axis])),
                    power: p.power.map(u32::from),
                    exponent: 0,
                })
            },
        )
    }
}

fn check(
    machine: &Machine,
    field: &'static str,
    found: u32,
    min: u32,
    max: u32,
) -> Result<(), QuantiseError> {
    if (min..=max).contains(&found) {
        return Ok(());
    }
    Err(QuantiseError::Field {
        machine: machine.name,
        field,
        found,
        min,
        max,
    })
}

/// The power of one integer step; 1 where no photon has any power.
fn power_step(map: &PhotonMap, bits: u32) -> f64 {
    let powers = map.photons().iter().map(|p| p.power.max_element());
    let largest = powers.fold(0.0, f64::max);
    let step = largest / f64::from((1u32 << bits) - 1);
    // A subnormal step would round differently; such powers are practically no light.
    if step.is_normal() { step } else { 1.0 }
}

/// floor(fraction * 2^bits) of a position in its block, below 2^bits also where rounding makes
/// the fraction exactly 1.
pub(crate) fn fraction(map: &PhotonMap, position: DVec3, bits: u32) -> [u32; 3] {
    in_steps(map.place(position).1, bits)
}

/// A fraction of a block's edge in steps of 2^-`bits`.
pub(crate) fn in_steps(fraction: DVec3, bits: u32) -> [u32; 3] {
    let steps = 1u32 << bits;
    let fraction = fraction * f64::from(steps);
    // `as` saturates and converts NaN to 0.
    fraction.to_array().map(|f| (f as u32).min(steps - 1))
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;
    use proptest::prelude::*;

    use super::*;
    use crate::{Photon, Scene, TraceOptions, trace};

    const RADIUS: f64 = 0.2;

    fn map() -> PhotonMap {
        let scene = Scene::built_in("cornell").unwrap();
        let options = TraceOptions {
            photons: 5_000,
            seed: 4,
        };
        let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
        PhotonMap::new(&scene, photons, RADIUS).unwrap()
    }

    #[test]
    fn positions_are_off_by_less_than_a_step() {
        let map = map();
        for name in ["paper", "paper-12"] {
            let machine = find_machine(name).unwrap();
            let quantised = QuantisedMap::new(&map, machine).unwrap();
            let step = RADIUS / f64::from(1 << machine.position_bits());
            for query in map.photons().iter().step_by(211) {
                let normal = DVec3::Y;
                let integers: Vec<_> = quantised.photons(query.position, normal).collect();
                let floats: Vec<usize> = map
                    .candidates(query.position, normal)
                    .flat_map(|c| c.photons)
                    .collect();
                assert_eq!(integers.len(), floats.len());
                let centre = quantised.query(query.position).position;
                for (integer, &index) in integers.iter().zip(&floats) {
                    let difference = map.photons()[index].position - query.position;
                    for axis in 0..3 {
                        let steps = f64::from(integer.position[axis]) - f64::from(centre[axis]);
                        // Two floors: the error of the difference is less than one step, plus rounding.
                        assert!((steps * step - difference[axis]).abs() < step * 1.000001);
                    }
                }
            }
        }
    }

    #[test]
    fn the_radius_is_the_maps_also_in_larger_blocks() {
        let machine = find_machine("paper").unwrap();
        for (edge, radius_sq) in [(RADIUS, 64 * 64), (RADIUS * 16.0 / 14.0, 56 * 56)] {
            let map = map().reblocked(edge).unwrap();
            let quantised = QuantisedMap::new(&map, machine).unwrap();
            assert_eq!(quantised.query(DVec3::ZERO).radius_sq, radius_sq);
        }
    }

    #[test]
    fn powers_use_the_whole_range_and_round_to_nearest() {
        let map = map();
        let quantised = QuantisedMap::new(&map, find_machine("paper").unwrap()).unwrap();
        let powers = || quantised.photons.iter().map(|p| p.power);
        assert_eq!(powers().flatten().max(), Some(u16::MAX));
        for (stored, photon) in powers().zip(map.photons()) {
            let error = DVec3::from(stored.map(f64::from)) - photon.power / quantised.power_step();
            // Half a step, and the rounding of the quotient.
            assert!(error.abs().max_element() < 0.500001);
        }
    }

    #[test]
    fn a_map_without_light_is_all_zero() {
        let scene = Scene::built_in("cornell").unwrap();
        let dark = Photon {
            position: DVec3::ZERO,
            power: DVec3::ZERO,
            surface: 0,
            facing: crate::Facing::FLAT,
        };
        let map = PhotonMap::new(&scene, vec![dark], RADIUS).unwrap();
        let quantised = QuantisedMap::new(&map, find_machine("paper").unwrap()).unwrap();
        assert_eq!(quantised.photons[0].power, [0; 3]);
    }

    #[test]
    fn formats_that_do_not_fit_are_errors() {
        let map = map();
        let paper = find_machine("paper").unwrap();
        let with = |coordinate_bits, power_bits| Machine {
            numbers: Numbers::Plain(PlainFormat {
                coordinate_bits,
                power_bits,
                ..*paper.plain().unwrap()
            }),
            ..*paper
        };
        for (coordinate_bits, power_bits) in [(2, 16), (18, 16), (8, 0), (8, 17)] {
            assert!(QuantisedMap::new(&map, &with(coordinate_bits, power_bits)).is_err());
        }
        let error = QuantisedMap::new(&map, &with(8, 17)).unwrap_err();
        let expected = "machine `paper`: power_bits is 17, expected 1 to 16";
        assert_eq!(error.to_string(), expected);
        let error = QuantisedMap::new(&map, find_machine("local").unwrap()).unwrap_err();
        assert!(
            error
                .to_string()
                .contains("photon format local8-rgb8e5, expected plain")
        );
    }

    proptest! {
        /// At any position, the query is in the frame's second block.
        #[test]
        fn queries_stay_in_their_block(x in prop::num::f64::ANY, y in -1.0..1.0f64, z in -1e-9..1e-9f64) {
            let map = PhotonMap::new(&Scene::built_in("cornell").unwrap(), vec![], RADIUS).unwrap();
            let machine = find_machine("paper").unwrap();
            let quantised = QuantisedMap::new(&map, machine).unwrap();
            let query = quantised.query(DVec3::new(x, y, z));
            prop_assert!(query.position.iter().all(|c| (64..128).contains(c)));
            prop_assert_eq!(query.radius_sq, 64 * 64);
        }
    }
}
