//! Converts a photon map to the words of a machine's streams, for either number format.

use glam::DVec3;
use photoncube_spec::{self as spec, Machine, Numbers, PhotonBlock};

use super::format_map::FormatMap;
use super::quantised_map::QuantisedMap;
use crate::photon_map::PhotonMap;
use crate::render::RenderError;

/// Photons and queries in the words that a machine reads.
#[derive(Debug, Clone)]
pub enum MachineMap<'a> {
    /// A map in plain numbers.
    Plain(QuantisedMap<'a>),
    /// A map in a photon format.
    Local(Box<FormatMap<'a>>),
}

impl<'a> MachineMap<'a> {
    /// Rounds every photon of `map` to the numbers of `machine`.
    ///
    /// # Errors
    /// The machine's numbers do not fit the map.
    pub fn new(map: &'a PhotonMap, machine: &'a Machine) -> Result<Self, RenderError> {
        Ok(match &machine.numbers {
            Numbers::Plain(_) => Self::Plain(QuantisedMap::new(map, machine)?),
            Numbers::Local(format) => Self::Local(Box::new(FormatMap::new(map, format)?)),
        })
    }

    /// The machine's query at `position`, with the map's search radius.
    #[must_use]
    pub fn query(&self, position: DVec3) -> spec::Query {
        match self {
            Self::Plain(quantised) => quantised.query(position),
            Self::Local(quantised) => spec::Query {
                position: quantised.query(position).position,
                radius_sq: quantised.format().largest_in_range(),
            },
        }
    }

    /// The photons that a query at `position` on a surface of unit normal `normal` gathers, in the query's
    /// frame, in the order of the stream.
    #[must_use]
    pub fn photons(&self, position: DVec3, normal: DVec3) -> Vec<spec::Photon> {
        match self {
            Self::Plain(quantised) => quantised.photons(position, normal).collect(),
            Self::Local(quantised) => {
                let bits = quantised.format().position_bits;
                let blocks = quantised.blocks(position, normal);
                blocks.flat_map(|block| words(block, bits)).collect()
            }
        }
    }
}

/// The words of a block's photons. The block's offset is the top of their coordinates, and its exponent is a
/// part of each word.
fn words(block: PhotonBlock<'_>, position_bits: u32) -> impl Iterator<Item = spec::Photon> {
    let base = block.offset.map(|blocks| blocks << position_bits);
    block.photons.iter().map(move |record| spec::Photon {
        position: std::array::from_fn(|axis| base[axis] + u32::from(record.position[axis])),
        power: record.mantissa.map(u32::from),
        exponent: u32::from(block.exponent + record.exponent),
    })
}

#[cfg(test)]
mod tests {
    use photoncube_model::gather;
    use photoncube_spec::MACHINES;

    use super::*;
    use crate::{Scene, TraceOptions, trace};

    /// The sums of a machine on its words equal those of the format's own gather on its records.
    #[test]
    fn a_machine_sums_what_its_format_does() {
        let scene = Scene::built_in("cornell").unwrap();
        let options = TraceOptions {
            photons: 5_000,
            seed: 4,
        };
        let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
        let map = PhotonMap::new(&scene, photons, 0.2).unwrap();
        for machine in MACHINES {
            let MachineMap::Local(quantised) = MachineMap::new(&map, machine).unwrap() else {
                continue;
            };
            let words = MachineMap::Local(quantised.clone());
            let mut in_range = 0;
            for photon in map.photons().iter().step_by(97) {
                let normal = scene.surfaces()[photon.surface as usize]
                    .geometry
                    .flat_normal()
                    .unwrap();
                let streamed = words.photons(photon.position, normal);
                let sums = gather(machine, &words.query(photon.position), streamed).unwrap();
                let expected = quantised.gather(photon.position, normal).unwrap();
                assert_eq!(sums.power.map(u128::from), expected.power);
                assert_eq!(sums.count, expected.count);
                in_range += sums.count;
            }
            assert!(in_range > 0);
        }
    }
}
