//! Gathers the sums of many queries at once, with the fastest instructions that the processor has.

use photoncube_spec::{Query, Sums};

use super::frame::Frame;
use super::kernel::Work;
use super::lanes::{Lanes, OfBytes, OfFlatBytes, OfWords, Positions};
use super::portable::Portable;
use super::store::PhotonPlanes;
use super::surroundings::Surroundings;
use crate::gather::GatherError;

/// The result of one query.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Gathered {
    /// Power and number of the photons in range.
    pub sums: Sums,
    /// The number of photons in the blocks around the query, which a machine tests one by one.
    pub photons: u64,
    /// The number of photons that this gather tested, in the leaves that the query's sphere may touch.
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
}

impl Instructions {
    /// The instruction sets that this processor has, the fastest first.
    pub fn available() -> impl Iterator<Item = Self> {
        #[cfg(target_arch = "x86_64")]
        let faster = pulp::x86::V3::try_new().map(Set::Avx2);
        #[cfg(not(target_arch = "x86_64"))]
        let faster = None;
        faster.into_iter().chain([Set::Portable]).map(Self)
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
        }
    }
}

impl PhotonPlanes {
    /// Gathers the sums of `queries` and writes each into its place of `found`. All queries must have one
    /// radius, and be in the block that `around` was set for. The sums and the errors are those of
    /// [`crate::Gather::sums`], bit for bit.
    ///
    /// # Errors
    /// A query does not fit the format, or there are more photons around it than its sums are sized for.
    /// Nothing is written in these cases.
    ///
    /// # Panics
    /// Where `found` and `queries` differ in length, a query is outside the frame's middle block, or the
    /// queries differ in their radii.
    pub fn gather(
        &self,
        around: &Surroundings,
        queries: &[Query],
        found: &mut [Gathered],
    ) -> Result<(), GatherError> {
        self.gather_by(Instructions::fastest(), around, queries, found)
    }

    /// Gathers as [`Self::gather`] does, with the given instruction set, which affects only the time.
    ///
    /// # Errors
    /// As for [`Self::gather`].
    ///
    /// # Panics
    /// As for [`Self::gather`].
    pub fn gather_by(
        &self,
        instructions: Instructions,
        around: &Surroundings,
        queries: &[Query],
        found: &mut [Gathered],
    ) -> Result<(), GatherError> {
        assert_eq!(found.len(), queries.len(), "a place for each query");
        let Some(first) = queries.first() else {
            return Ok(());
        };
        self.limits.check_query(first)?;
        let edge = self.format().edge_steps();
        let unlike = |query: &&Query| {
            let [x, y, z] = query.position.map(|at| at.wrapping_sub(edge) < edge);
            !(x && y && z) || query.radius_sq != first.radius_sq
        };
        if let Some(query) = queries.iter().find(unlike) {
            self.limits.check_query(query)?;
            panic!(
                "{query:?} is not in the block that the surroundings are of, or has another radius"
            );
        }
        self.limits.check_count(around.photons())?;
        let work = Work {
            planes: self,
            around,
            queries,
            frame: Frame::new(self.format(), first.radius_sq),
            found,
        };
        match instructions.0 {
            Set::Portable => work.by(Portable),
            #[cfg(target_arch = "x86_64")]
            Set::Avx2(simd) => simd.vectorize(
                #[inline(always)]
                || work.by(simd),
            ),
        }
        Ok(())
    }
}

impl Work<'_> {
    #[inline(always)]
    fn by<L: Lanes>(self, lanes: L)
    where
        OfBytes: Positions<L>,
        OfFlatBytes: Positions<L>,
        OfWords: Positions<L>,
    {
        if self.planes.layout.wide {
            // A box of 8-bit bounds is too coarse to show that a leaf is flat.
            self.with_positions::<L, OfWords, OfWords>(lanes);
        } else {
            self.with_positions::<L, OfBytes, OfFlatBytes>(lanes);
        }
    }

    #[inline(always)]
    fn with_positions<L: Lanes, P: Positions<L>, F: Positions<L>>(self, lanes: L) {
        match self.planes.layout.mantissa_planes {
            1 => self.run::<L, P, F, 1>(lanes),
            2 => self.run::<L, P, F, 2>(lanes),
            3 => self.run::<L, P, F, 3>(lanes),
            6 => self.run::<L, P, F, 6>(lanes),
            planes => unreachable!("a channel or three of a byte or two, not {planes} planes"),
        }
    }
}
