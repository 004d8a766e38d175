//! Photons and queries in the integers of [`Numbers`], plain or of a photon format.
//!
//! A position is an unsigned fraction of its block, `floor(fraction * 2^p)` with p =
//! [`Numbers::position_bits`]. Queries follow the same rule with [`Numbers::radius_bits`]. The coordinates
//! span a frame of four block edges that starts one block before the query's own. A block's offset of 0, 1
//! or 2 is added to the fraction, so no coordinate can overflow (the largest is 3 * 2^p - 1).
//!
//! In a photon format, block edge and search radius have the ratio that the format fixes, so the radius is
//! exact. In plain numbers, blocks are those of the map: where block edge and search radius are equal, as in
//! [`PhotonMap::new`], the squared radius is exactly 2^(2p); otherwise it is rounded down to a square step.
//!
//! Powers are rounded by the rules of [`PhotonFormat`], plain ones to nearest with one step for the whole map.
//! Truncation would bias every estimate, and more photons would not remove the bias.
//!
//! Nothing depends on the scene's place or size. Precisely: the records, the block exponents and every sum
//! are bit-identical
//! - after moving scene, photons and queries by a vector that rounds none of their coordinates
//!   (only their differences from the scene's corner are used, and those are exact);
//! - after scaling scene, radius and photons by a power of two; by any other factor, except
//!   for coordinates that f64 rounding carries across the border of a cell (relative 1e-15 of the
//!   scene), hence always for those in the middle of theirs;
//! - after scaling all powers by a power of two;
//! - up to the order of the records, after permuting the photons.

use std::borrow::Cow;
use std::ops::Range;
use std::sync::OnceLock;

use glam::DVec3;
use photoncube_model::{Gather, GatherError, PhotonPlanes};
use photoncube_spec::{
    self as spec, Exponent, FormatError, Numbers, PhotonBlock, PhotonFormat, PhotonRecord, Query,
    Rounding, Sums,
};
use rayon::prelude::*;
use thiserror::Error;

use super::power_scale::{PowerScale, power_of_two};
use crate::photon_map::{Candidates, MapError, PhotonMap, StoredPhoton};
use crate::view::Front;

/// The reason why a photon map has no form in these numbers.
#[derive(Debug, Error, PartialEq)]
pub enum QuantiseError {
    /// The numbers are not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// The map cannot have the blocks that the photon format needs.
    #[error(transparent)]
    Map(#[from] MapError),
}

/// The photons of a map in the integers of one number format.
#[derive(Debug, Clone)]
pub struct QuantisedMap<'a> {
    map: Cow<'a, PhotonMap>,
    gather: Gather,
    /// The search radius squared in squared fine steps, not rounded.
    exact_radius_sq: f64,
    /// The stored photons, in the order of the map. In a photon format they are made when they are first asked for, because the
    /// fast gather does without.
    records: OnceLock<Vec<PhotonRecord>>,
    /// The stored photons of a photon format in planes, run by run, for the fast gather.
    planes: Option<PhotonPlanes>,
    /// The exponents of blocks; empty where a photon has its own, or none.
    exponents: Vec<BlockExponent>,
    scale: PowerScale,
}

/// The exponent of a block, with the index of the block's first record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct BlockExponent {
    start: usize,
    exponent: u8,
}

impl<'a> QuantisedMap<'a> {
    /// Rounds every photon of `map` to `numbers`. In a photon format, blocks have the edge [`Self::edge_for`]
    /// the map's radius; a map with blocks of another edge is sorted anew.
    ///
    /// # Errors
    /// The numbers are not legal, or the map cannot have such blocks.
    pub fn new(map: &'a PhotonMap, numbers: &Numbers) -> Result<Self, QuantiseError> {
        let gather = Gather::new(numbers)?;
        let map = Self::blocked(map, numbers)?;
        let power = numbers.power();
        let scale = PowerScale::new(&map, power);
        let exponents = match power.exponent {
            Exponent::Block { .. } => block_exponents(&map, &scale),
            Exponent::None | Exponent::Photon { .. } => Vec::new(),
        };
        let mut quantised = Self {
            exact_radius_sq: exact_radius_sq(&map, numbers),
            records: OnceLock::new(),
            planes: None,
            gather,
            exponents,
            scale,
            map,
        };
        match numbers.format() {
            Some(format) => quantised.planes = Some(quantised.planes_of(format)?),
            None => quantised.records = quantised.all_records().into(),
        }
        Ok(quantised)
    }

    /// All photons in the map's order, made in parallel.
    fn all_records(&self) -> Vec<PhotonRecord> {
        let photons = (0..self.map.photons().len()).into_par_iter();
        photons
            .map(|photon| self.record(photon, self.block_exponent(photon)))
            .collect()
    }

    /// The stored form of a photon whose block has that exponent.
    pub(super) fn record(&self, photon: usize, block_exponent: u8) -> PhotonRecord {
        let photon = &self.map.photons()[photon];
        let exponent = match self.numbers().power().exponent {
            Exponent::Photon { .. } => self.scale.exponent(std::slice::from_ref(photon)),
            Exponent::None | Exponent::Block { .. } => 0,
        };
        let fraction = self.map.place(photon.position).1;
        let bits = self.numbers().position_bits();
        let position = in_steps(fraction, bits).map(|cell| cell as u16);
        PhotonRecord {
            position,
            mantissa: self
                .scale
                .mantissa(photon.power, block_exponent + exponent, position),
            exponent,
        }
    }

    /// The exponent of the block of a photon; 0 where blocks have none.
    pub(super) fn block_exponent(&self, photon: usize) -> u8 {
        exponent_of(&self.exponents, photon)
    }

    /// The edge of blocks, in scene units, with which `radius` is exact in the format.
    #[must_use]
    pub fn edge_for(format: &PhotonFormat, radius: f64) -> f64 {
        radius * f64::from(format.edge_steps()) / f64::from(format.radius_steps())
    }

    /// The map in the blocks that `numbers` need; plain numbers take any blocks.
    pub(crate) fn blocked(
        map: &'a PhotonMap,
        numbers: &Numbers,
    ) -> Result<Cow<'a, PhotonMap>, MapError> {
        let edge = numbers
            .format()
            .map_or(map.edge(), |format| Self::edge_for(format, map.radius()));
        if map.edge() == edge {
            return Ok(Cow::Borrowed(map));
        }
        Ok(Cow::Owned(map.reblocked(edge)?))
    }

    /// The numbers of the records.
    #[must_use]
    pub fn numbers(&self) -> &Numbers {
        self.gather.numbers()
    }

    /// The stored photons in planes, as the fast gather uses them; `None` in plain numbers.
    #[must_use]
    pub fn planes(&self) -> Option<&PhotonPlanes> {
        self.planes.as_ref()
    }

    /// The map before rounding, in the blocks of the records.
    #[must_use]
    pub fn map(&self) -> &PhotonMap {
        &self.map
    }

    /// The stored photons, in the order of [`Self::map`].
    #[must_use]
    pub fn records(&self) -> &[PhotonRecord] {
        // One thread makes them: in the thread pool, it could be given a task that waits for them.
        self.records.get_or_init(|| {
            let photons = 0..self.map.photons().len();
            let records = photons.map(|photon| self.record(photon, self.block_exponent(photon)));
            records.collect()
        })
    }

    /// The number of photons whose power rounds to 0 in every channel: they are counted where they are in range, and give no light.
    /// 0 where powers are dithered, because the light is then right on average.
    #[must_use]
    pub fn photons_without_power(&self) -> u64 {
        if self.numbers().power().rounding == Rounding::Dithered {
            return 0;
        }
        let photons = (0..self.map.photons().len()).into_par_iter();
        let is_lost = |photon: &usize| {
            let record = self.record(*photon, self.block_exponent(*photon));
            record.mantissa == [0; 3] && self.map.photons()[*photon].power != DVec3::ZERO
        };
        photons.filter(is_lost).count() as u64
    }

    /// The flux that sums of powers represent.
    #[inline]
    #[must_use]
    pub fn flux(&self, power: [u128; 3]) -> DVec3 {
        self.scale.flux(DVec3::from(power.map(float)))
    }

    /// The search radius squared in squared fine steps, not rounded. It is whole in a photon format, and in
    /// plain numbers where the block edge is the search radius.
    #[must_use]
    pub fn exact_radius_sq(&self) -> f64 {
        self.exact_radius_sq
    }

    /// The search radius squared in whole squared fine steps, the largest radius of a gather.
    #[must_use]
    pub fn radius_sq(&self) -> u32 {
        // The rounding of the quotient must not reduce a radius of whole steps by a square step.
        (self.exact_radius_sq * (1.0 + 1e-12)) as u32
    }

    /// The query at `position` with the map's search radius, in its own frame.
    #[must_use]
    pub fn query(&self, position: DVec3) -> Query {
        let query = self.query_within(position, self.radius_sq());
        query.expect("the search radius has two steps or more")
    }

    /// The query at `position` with another search radius, `radius_sq` in squared fine steps. `None` where no
    /// photon can be in range.
    #[must_use]
    pub fn query_within(&self, position: DVec3, radius_sq: u32) -> Option<Query> {
        let fraction = self.map.place(position).1;
        let radius_sq = self.numbers().radius_word(radius_sq)?;
        Some(self.query_at(fraction, radius_sq))
    }

    /// The query at `fraction` of the edge in its block, with this word as the radius.
    pub(crate) fn query_at(&self, fraction: DVec3, radius_sq: u32) -> Query {
        let bits = self.numbers().radius_bits();
        Query {
            position: in_steps(fraction, bits).map(|step| (1 << bits) + step),
            radius_sq,
        }
    }

    /// The photons that a query at `position` on `front` gathers, by the rule of [`PhotonMap`].
    pub fn blocks(&self, position: DVec3, front: Front) -> impl Iterator<Item = PhotonBlock<'_>> {
        let runs = self.map.candidates(position, front);
        runs.map(
            |Candidates {
                 offset, photons, ..
             }| PhotonBlock {
                offset,
                exponent: exponent_of(&self.exponents, photons.start),
                photons: &self.records()[photons],
            },
        )
    }

    /// The photons of [`Self::blocks`] as the words of a machine's stream, in order. A block's offset is the
    /// top of their coordinates, and its exponent is a part of each word.
    pub fn photons(&self, position: DVec3, front: Front) -> impl Iterator<Item = spec::Photon> {
        let bits = self.numbers().position_bits();
        let blocks = self.blocks(position, front);
        blocks.flat_map(move |block| {
            let base = block.offset.map(|blocks| blocks << bits);
            block.photons.iter().map(move |record| spec::Photon {
                position: [0, 1, 2].map(|axis| base[axis] + u32::from(record.position[axis])),
                power: record.mantissa.map(u32::from),
                exponent: u32::from(block.exponent + record.exponent),
            })
        })
    }

    /// Gathers the sums of a query at the search radius.
    ///
    /// # Errors
    /// More photons are around the query than the numbers declare.
    pub fn gather(&self, position: DVec3, front: Front) -> Result<Sums, GatherError> {
        self.gather_within(position, front, self.radius_sq())
    }

    /// Gathers the sums of a query with another search radius, `radius_sq` in squared fine steps.
    ///
    /// # Errors
    /// More photons are around the query than the numbers declare, or `radius_sq` is over that of a photon
    /// format.
    pub fn gather_within(
        &self,
        position: DVec3,
        front: Front,
        radius_sq: u32,
    ) -> Result<Sums, GatherError> {
        match self.query_within(position, radius_sq) {
            Some(query) => self.gather.sums(&query, self.blocks(position, front)),
            None => Ok(Sums::default()),
        }
    }

    /// Every photon that a query gathers, before rounding, with the in-range decision of the integers.
    /// Misclassified photons are counted from these.
    pub fn verdicts(
        &self,
        position: DVec3,
        front: Front,
    ) -> impl Iterator<Item = (&StoredPhoton, bool)> {
        let query = self.query(position);
        let runs = self.map.candidates(position, front);
        runs.flat_map(
            move |Candidates {
                      offset, photons, ..
                  }| {
                photons.map(move |index| {
                    let record = &self.records()[index];
                    let in_range = self.gather.in_range(&query, offset, record);
                    (&self.map.photons()[index], in_range)
                })
            },
        )
    }

    /// The flux of a stored photon, with `index` as in [`Self::records`].
    #[must_use]
    pub fn power(&self, index: usize) -> DVec3 {
        let mantissa = DVec3::from(self.records()[index].mantissa.map(f64::from));
        self.scale
            .flux(mantissa * power_of_two(self.exponent(index)))
    }

    /// The flux of one step of a stored photon's mantissa, in the strongest channel, with `index` as in
    /// [`Self::records`].
    #[must_use]
    pub fn step(&self, index: usize) -> f64 {
        let step = DVec3::ONE * power_of_two(self.exponent(index));
        self.scale.flux(step).max_element()
    }

    /// The exponent of a stored photon on a machine's pins: its own and that of its block, with `index` as in
    /// [`Self::records`].
    #[must_use]
    pub fn exponent(&self, index: usize) -> u8 {
        exponent_of(&self.exponents, index) + self.records()[index].exponent
    }
}

/// The nearest f64. Most sums fit 63 bits, which processors convert with one instruction, with equal results.
#[inline]
fn float(sum: u128) -> f64 {
    i64::try_from(sum).map_or_else(|_| long_float(sum), |sum| sum as f64)
}

/// A separate function, because the compiler otherwise converts all sums in this way.
#[cold]
#[inline(never)]
fn long_float(sum: u128) -> f64 {
    sum as f64
}

/// The search radius squared in squared fine steps: exact in a photon format, whose blocks are made for it.
fn exact_radius_sq(map: &PhotonMap, numbers: &Numbers) -> f64 {
    match numbers {
        Numbers::Plain(format) => {
            let edge = f64::from(1 << format.position_bits());
            (edge * (map.radius() / map.edge())).powi(2)
        }
        Numbers::Local(format) => f64::from(format.radius_steps().pow(2)),
    }
}

fn block_exponents(map: &PhotonMap, scale: &PowerScale) -> Vec<BlockExponent> {
    let slices: Vec<_> = map.block_slices().collect();
    let exponent = |slice: &Range<usize>| BlockExponent {
        start: slice.start,
        exponent: scale.exponent(&map.photons()[slice.clone()]),
    };
    slices.par_iter().map(exponent).collect()
}

/// The exponent of the block of a photon; 0 where blocks have none.
fn exponent_of(exponents: &[BlockExponent], photon: usize) -> u8 {
    let next = exponents.partition_point(|block| block.start <= photon);
    let block = next.checked_sub(1).map(|block| exponents[block]);
    block.map_or(0, |block| block.exponent)
}

/// A fraction of a block's edge in steps of 2^-`bits`, below 2^bits also where rounding makes the fraction
/// exactly 1.
fn in_steps(fraction: DVec3, bits: u32) -> [u32; 3] {
    let steps = 1u32 << bits;
    let fraction = fraction * f64::from(steps);
    // `as` saturates and converts NaN to 0.
    fraction.to_array().map(|f| (f as u32).min(steps - 1))
}

#[cfg(test)]
mod tests;
