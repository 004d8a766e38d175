//! Gathers the sums of many queries at once, with the fastest instructions that the processor has.

use photoncube_spec::{Query, Sums};

use super::frame::Frame;
use super::kernel::Work;
use super::lanes::{Lanes, OfBytes, OfFlatBytes, OfWords, Positions};
use super::photon_planes::PhotonPlanes;
use super::portable::Portable;
use super::windows::Windows;
use crate::gather::GatherError;

/// The result of one query.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Gathered {
    /// Power and number of the photons in range.
    pub sums: Sums,
    /// The number of photons in the blocks around the query, which a machine tests one by one.
    pub photons: u64,
    /// The number of photons that this gather tested, in the leaves that the query's sphere may touch. A leaf may
    /// have photons beyond the blocks around the query.
    pub tests: u64,
}

/// An instruction set for the gather that this processor has.
#[derive(Debug, Clone, Copy)]
pub struct Instructions(Set);

#[derive(Debug, Clone, Copy)]
enum Set {
    /// Portable loops, vectorised by the compiler.
    Portable,
    /// x86-64 with AVX2.
    #[cfg(target_arch = "x86_64")]
    Avx2(pulp::x86::V3),
    /// x86-64 with the AVX-512 of all servers that have any: F, BW, CD, DQ and VL.
    #[cfg(target_arch = "x86_64")]
    Avx512(pulp::x86::V4),
    /// 64-bit Arm with NEON.
    #[cfg(all(target_arch = "aarch64", target_endian = "little"))]
    Neon(pulp::aarch64::Neon),
}

impl Instructions {
    /// The instruction sets that this processor has, the fastest first.
    pub fn available() -> impl Iterator<Item = Self> {
        #[cfg(target_arch = "x86_64")]
        let faster = [
            pulp::x86::V4::try_new().map(Set::Avx512),
            pulp::x86::V3::try_new().map(Set::Avx2),
        ];
        #[cfg(all(target_arch = "aarch64", target_endian = "little"))]
        let faster = [pulp::aarch64::Neon::try_new().map(Set::Neon)];
        #[cfg(not(any(
            target_arch = "x86_64",
            all(target_arch = "aarch64", target_endian = "little")
        )))]
        let faster = [None];
        let faster = faster.into_iter().flatten();
        faster.chain([Set::Portable]).map(Self)
    }

    /// The fastest instruction set that this processor has.
    #[must_use]
    pub fn fastest() -> Self {
        Self::available()
            .next()
            .expect("the portable ones are always there")
    }

    /// The instruction set's name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self.0 {
            Set::Portable => "portable",
            #[cfg(target_arch = "x86_64")]
            Set::Avx2(_) => "AVX2",
            #[cfg(target_arch = "x86_64")]
            Set::Avx512(_) => "AVX-512",
            #[cfg(all(target_arch = "aarch64", target_endian = "little"))]
            Set::Neon(_) => "NEON",
        }
    }
}

/// A query in the grid of a map's blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlacedQuery {
    /// The index of the query's block on each axis. A block may be outside the grid.
    pub block: [i32; 3],
    /// The place in the block, in fine steps.
    pub fraction: [u16; 3],
    /// Which groups the query gathers, as a number of the caller's.
    pub facing: u32,
}

impl PhotonPlanes {
    /// Gathers the sums of `queries` and writes each into its place of `found`. `radius_sq` is the word of the
    /// search radius, and `faces(facing, group)` whether queries of a facing gather a group. Consecutive
    /// queries near each other share work. The sums and the errors are those of [`crate::Gather::sums`], bit
    /// for bit.
    ///
    /// # Errors
    /// The radius does not fit the format, or there are more photons around a query than its sums are sized for.
    /// What is written in these cases is not specified.
    ///
    /// # Panics
    /// Where `found` and `queries` differ in length, or a fraction is outside its block.
    pub fn gather(
        &self,
        instructions: Instructions,
        radius_sq: u32,
        queries: &[PlacedQuery],
        faces: impl Fn(u32, u32) -> bool,
        found: &mut [Gathered],
    ) -> Result<(), GatherError> {
        self.gather_facing(instructions, radius_sq, queries, &faces, found)
    }

    /// Not generic over the closure, so that the kernel of each instruction set is compiled once, in this crate.
    fn gather_facing(
        &self,
        instructions: Instructions,
        radius_sq: u32,
        queries: &[PlacedQuery],
        faces: &dyn Fn(u32, u32) -> bool,
        found: &mut [Gathered],
    ) -> Result<(), GatherError> {
        assert_eq!(found.len(), queries.len(), "a place for each query");
        let position = [self.format().edge_steps(); 3];
        self.planes.limits.check_query(&Query {
            position,
            radius_sq,
        })?;
        let frame = Frame::new(self.format(), self.cube_edge(), radius_sq);
        let positions: Vec<_> = queries.iter().map(|query| frame.position(query)).collect();
        let work = Work {
            photons: self,
            positions: &positions,
            frame,
            windows: Windows::new(self, queries, faces),
            found,
        };
        match instructions.0 {
            Set::Portable => work.by(Portable),
            #[cfg(target_arch = "x86_64")]
            Set::Avx2(simd) => simd.vectorize(
                #[inline(always)]
                || work.by(simd),
            ),
            #[cfg(target_arch = "x86_64")]
            Set::Avx512(simd) => simd.vectorize(
                #[inline(always)]
                || work.by(simd),
            ),
            #[cfg(all(target_arch = "aarch64", target_endian = "little"))]
            Set::Neon(simd) => simd.vectorize(
                #[inline(always)]
                || work.by(simd),
            ),
        }
    }
}

impl Work<'_> {
    #[inline(always)]
    fn by<L: Lanes>(self, lanes: L) -> Result<(), GatherError>
    where
        OfBytes: Positions<L>,
        OfFlatBytes: Positions<L>,
        OfWords: Positions<L>,
    {
        if self.photons.planes.layout.wide {
            self.with_positions::<L, OfWords, OfWords>(lanes)
        } else {
            self.with_positions::<L, OfBytes, OfFlatBytes>(lanes)
        }
    }

    #[inline(always)]
    fn with_positions<L: Lanes, P: Positions<L>, Q: Positions<L>>(
        self,
        lanes: L,
    ) -> Result<(), GatherError> {
        match self.photons.planes.layout.mantissa_planes {
            1 => self.run::<L, P, Q, 1>(lanes),
            2 => self.run::<L, P, Q, 2>(lanes),
            3 => self.run::<L, P, Q, 3>(lanes),
            6 => self.run::<L, P, Q, 6>(lanes),
            planes => unreachable!("a channel or three of a byte or two, not {planes} planes"),
        }
    }
}
