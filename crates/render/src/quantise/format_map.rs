//! Photons and queries in the integers of a photon format, by the rules of
//! [`photoncube_spec::PhotonFormat`].
//!
//! Block edge and search radius have the ratio that the format fixes, so the radius is exact and
//! nothing depends on the scene's place or size. Precisely: the records, the block exponents
//! and every sum are bit-identical
//! - after moving scene, photons and queries by a vector that rounds none of their coordinates
//!   (only their differences from the scene's corner are used, and those are exact);
//! - after scaling scene, radius and photons by a power of two; by any other factor, except
//!   for coordinates that f64 rounding carries across the border of a cell (relative 1e-15 of the
//!   scene), hence always for those in the middle of theirs;
//! - after scaling all powers by a power of two;
//! - up to the order of the records, after permuting the photons.

use std::borrow::Cow;
use std::ops::Range;

use glam::DVec3;
use photoncube_model::{GatherError, LocalGather, PhotonPlanes};
use photoncube_spec::{
    Exponent, FormatError, LocalQuery, LocalSums, PhotonBlock, PhotonFormat, PhotonRecord,
};
use rayon::prelude::*;
use thiserror::Error;

use super::power_scale::{PowerScale, power_of_two};
use super::quantised_map::{fraction, in_steps};
use crate::photon_map::{Candidates, MapError, PhotonMap};
use crate::trace::Photon;

/// The reason why a photon map has no form in a format.
#[derive(Debug, Error, PartialEq)]
pub enum FormatMapError {
    /// The format is not legal.
    #[error(transparent)]
    Format(#[from] FormatError),
    /// The map cannot have the blocks that the format needs.
    #[error(transparent)]
    Map(#[from] MapError),
}

/// The photons of a map in one photon format.
#[derive(Debug, Clone)]
pub struct FormatMap<'a> {
    map: Cow<'a, PhotonMap>,
    gather: LocalGather,
    /// The stored photons, in the order of the map.
    records: Vec<PhotonRecord>,
    /// The stored photons in planes, run by run, for the fast gather.
    planes: PhotonPlanes,
    blocks: Vec<Block>,
    scale: PowerScale,
}

/// A block: the index of its first record, and its exponent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Block {
    start: usize,
    exponent: u8,
}

impl<'a> FormatMap<'a> {
    /// Rounds every photon of `map` to `format`. The blocks have the edge [`Self::edge_for`] the map's
    /// radius; a map with blocks of another edge is sorted anew.
    ///
    /// # Errors
    /// The format is not legal.
    pub fn new(map: &'a PhotonMap, format: &PhotonFormat) -> Result<Self, FormatMapError> {
        let gather = LocalGather::new(format)?;
        let edge = Self::edge_for(format, map.radius());
        let map = if map.edge() == edge {
            Cow::Borrowed(map)
        } else {
            Cow::Owned(map.reblocked(edge)?)
        };
        let scale = PowerScale::new(&map, format);
        let slices: Vec<_> = map.block_slices().collect();
        let exponent = |photons: &[Photon]| match format.power.exponent {
            Exponent::Block { .. } => scale.exponent(photons),
            Exponent::None | Exponent::Photon { .. } => 0,
        };
        let blocks: Vec<Block> = slices
            .par_iter()
            .map(|slice| Block {
                start: slice.start,
                exponent: exponent(&map.photons()[slice.clone()]),
            })
            .collect();
        let records = slices
            .par_iter()
            .zip(&blocks)
            .flat_map_iter(|(slice, block)| {
                let photons = &map.photons()[slice.clone()];
                photons
                    .iter()
                    .map(|p| record(&map, format, &scale, block.exponent, p))
            });
        let records: Vec<_> = records.collect();
        Ok(Self {
            planes: planes(&map, gather, &records, &blocks),
            records,
            gather,
            blocks,
            scale,
            map,
        })
    }

    /// The edge of blocks, in scene units, with which `radius` is exact in the format.
    #[must_use]
    pub fn edge_for(format: &PhotonFormat, radius: f64) -> f64 {
        radius * f64::from(format.edge_steps()) / f64::from(format.radius_steps())
    }

    /// The photon format of the records.
    #[must_use]
    pub fn format(&self) -> &PhotonFormat {
        self.gather.format()
    }

    /// The stored photons in planes, as the fast gather uses them.
    #[must_use]
    pub fn planes(&self) -> &PhotonPlanes {
        &self.planes
    }

    /// The map before rounding, with the format's blocks.
    #[must_use]
    pub fn map(&self) -> &PhotonMap {
        &self.map
    }

    /// The stored photons, in the order of [`Self::map`].
    #[must_use]
    pub fn records(&self) -> &[PhotonRecord] {
        &self.records
    }

    /// The flux that sums of powers represent.
    #[inline]
    #[must_use]
    pub fn flux(&self, power: [u128; 3]) -> DVec3 {
        self.scale.flux(DVec3::from(power.map(float)))
    }

    /// The query at `position`, in its own frame.
    #[must_use]
    pub fn query(&self, position: DVec3) -> LocalQuery {
        self.query_at(self.map.place(position).1)
    }

    /// The query at `fraction` of the edge in its block.
    pub(crate) fn query_at(&self, fraction: DVec3) -> LocalQuery {
        let format = self.format();
        let steps = in_steps(fraction, format.radius_bits());
        LocalQuery {
            position: steps.map(|step| format.edge_steps() + step),
        }
    }

    /// The photons that a query at `position` on a surface of unit normal `normal` gathers, by the
    /// rule of [`PhotonMap`].
    pub fn blocks(&self, position: DVec3, normal: DVec3) -> impl Iterator<Item = PhotonBlock<'_>> {
        let runs = self.map.candidates(position, normal);
        runs.map(
            |Candidates {
                 offset, photons, ..
             }| PhotonBlock {
                offset,
                exponent: self.block_exponent(photons.start),
                photons: &self.records[photons],
            },
        )
    }

    /// Gathers the sums of a query.
    ///
    /// # Errors
    /// More photons are around the query than the format declares.
    pub fn gather(&self, position: DVec3, normal: DVec3) -> Result<LocalSums, GatherError> {
        self.gather_within(position, normal, self.radius_sq())
    }

    /// The search radius squared, in squared fine steps. It is exact, and the largest radius of a gather.
    #[must_use]
    pub fn radius_sq(&self) -> u32 {
        self.gather.radius_sq()
    }

    /// Gathers the sums of a query with another search radius, `radius_sq` in squared fine steps.
    ///
    /// # Errors
    /// More photons are around the query than the format declares, or `radius_sq` is over
    /// [`Self::radius_sq`].
    pub fn gather_within(
        &self,
        position: DVec3,
        normal: DVec3,
        radius_sq: u32,
    ) -> Result<LocalSums, GatherError> {
        let blocks = self.blocks(position, normal);
        let query = self.query(position);
        self.gather.gather_within(&query, radius_sq, blocks)
    }

    /// Every photon that a query gathers, before rounding, with the format's in-range decision. Misclassified
    /// photons are counted from these.
    pub fn verdicts(
        &self,
        position: DVec3,
        normal: DVec3,
    ) -> impl Iterator<Item = (&Photon, bool)> {
        let query = self.query(position);
        let runs = self.map.candidates(position, normal);
        runs.flat_map(
            move |Candidates {
                      offset, photons, ..
                  }| {
                photons.map(move |index| {
                    let record = &self.records[index];
                    let in_range = self.gather.in_range(&query, offset, record);
                    (&self.map.photons()[index], in_range)
                })
            },
        )
    }

    /// The flux of a stored photon in the format, with `index` as in [`Self::records`].
    #[must_use]
    pub fn power(&self, index: usize) -> DVec3 {
        let record = &self.records[index];
        let exponent = self.block_exponent(index) + record.exponent;
        let mantissa = DVec3::from(record.mantissa.map(f64::from));
        self.scale.flux(mantissa * power_of_two(exponent))
    }

    /// The flux of one step of a stored photon's mantissa, in the strongest channel, with `index` as in
    /// [`Self::records`].
    #[must_use]
    pub fn step(&self, index: usize) -> f64 {
        let exponent = self.block_exponent(index) + self.records[index].exponent;
        self.scale
            .flux(DVec3::ONE * power_of_two(exponent))
            .max_element()
    }

    fn block_exponent(&self, photon: usize) -> u8 {
        exponent_of(&self.blocks, photon)
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

fn exponent_of(blocks: &[Block], photon: usize) -> u8 {
    let next = blocks.partition_point(|block| block.start <= photon);
    blocks[next - 1].exponent
}

/// The planes of all runs, made in parallel by parts.
fn planes(
    map: &PhotonMap,
    gather: LocalGather,
    records: &[PhotonRecord],
    blocks: &[Block],
) -> PhotonPlanes {
    /// The runs of a part, some hundred thousand photons. The parts are joined one after another.
    const PART_RUNS: usize = 4096;
    let runs: Vec<_> = map.runs().collect();
    let part = |runs: &[Range<usize>]| {
        let mut planes = PhotonPlanes::new(gather);
        for run in runs {
            let stored = planes.push_run(exponent_of(blocks, run.start), &records[run.clone()]);
            stored.expect("rounded to the format");
        }
        planes
    };
    let parts: Vec<_> = runs.par_chunks(PART_RUNS).map(part).collect();
    let none = PhotonPlanes::new(gather);
    parts.iter().fold(none, PhotonPlanes::joined)
}

fn record(
    map: &PhotonMap,
    format: &PhotonFormat,
    scale: &PowerScale,
    block_exponent: u8,
    photon: &Photon,
) -> PhotonRecord {
    let exponent = match format.power.exponent {
        Exponent::Photon { .. } => scale.exponent(std::slice::from_ref(photon)),
        Exponent::None | Exponent::Block { .. } => 0,
    };
    let position = fraction(map, photon.position, format.position_bits).map(|cell| cell as u16);
    PhotonRecord {
        position,
        mantissa: scale.mantissa(photon.power, block_exponent + exponent, position),
        exponent,
    }
}
