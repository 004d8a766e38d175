//! The sums of many queries at once, by the fastest instructions that there are.

use photoncube_spec::{LocalQuery, LocalSums};

use super::frame::Frame;
use super::kernel::Work;
use super::lanes::{Lanes, OfBytes, OfFlatBytes, OfWords, Positions};
use super::portable::Portable;
use super::store::PhotonPlanes;
use super::surroundings::Surroundings;
use crate::local::LocalError;

/// What a query found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Gathered {
    /// Power and number of the photons in range.
    pub sums: LocalSums,
    /// Photons around it, which a machine tests one by one.
    pub photons: u64,
    /// Those that were tested here: of leaves that the sphere may touch.
    pub tests: u64,
}

/// Which instructions the gather is made of, of those that this processor has.
#[derive(Debug, Clone, Copy)]
pub struct Instructions(Set);

#[derive(Debug, Clone, Copy)]
enum Set {
    /// Whatever the compiler makes of plain loops.
    Portable,
    /// x86-64 with AVX2.
    #[cfg(target_arch = "x86_64")]
    Avx2(pulp::x86::V3),
}

impl Instructions {
    /// Those that this processor has, the fastest first.
    pub fn available() -> impl Iterator<Item = Self> {
        #[cfg(target_arch = "x86_64")]
        let faster = pulp::x86::V3::try_new().map(Set::Avx2);
        #[cfg(not(target_arch = "x86_64"))]
        let faster = None;
        faster.into_iter().chain([Set::Portable]).map(Self)
    }

    /// The fastest that this processor has.
    #[must_use]
    pub fn fastest() -> Self {
        Self::available()
            .next()
            .expect("the portable ones are always there")
    }

    /// Their name in reports.
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
    /// The sums of `queries`, all of the block that `around` is around, each into its place of `found`:
    /// bit for bit those of [`crate::LocalGather::gather_within`], with the same refusals.
    ///
    /// # Errors
    /// A query that the format cannot hold, more photons around than its sums are sized for,
    /// or a `radius_sq` (squared fine steps) over the format's. Nothing is written then.
    ///
    /// # Panics
    /// Where `found` has not a place for each query, or a query is in another block than the frame's middle one.
    pub fn gather(
        &self,
        around: &Surroundings,
        queries: &[LocalQuery],
        radius_sq: u32,
        found: &mut [Gathered],
    ) -> Result<(), LocalError> {
        self.gather_by(Instructions::fastest(), around, queries, radius_sq, found)
    }

    /// The same by these instructions, which changes only how long it takes.
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
        queries: &[LocalQuery],
        radius_sq: u32,
        found: &mut [Gathered],
    ) -> Result<(), LocalError> {
        assert_eq!(found.len(), queries.len(), "a place for each query");
        let edge = self.format().edge_steps();
        let elsewhere = |query: &&LocalQuery| {
            let [x, y, z] = query.position.map(|at| at.wrapping_sub(edge) < edge);
            !(x && y && z)
        };
        if let Some(query) = queries.iter().find(elsewhere) {
            self.gather.limits().check_query(query)?;
            panic!("{query:?} is not in the block that the surroundings are of");
        }
        self.gather.limits().check_radius_sq(radius_sq)?;
        self.gather.check_count(around.photons())?;
        let Some(frame) = Frame::new(self.format(), radius_sq) else {
            found.fill(Gathered {
                photons: around.photons(),
                ..Gathered::default()
            });
            return Ok(());
        };
        let work = Work {
            planes: self,
            around,
            queries,
            frame,
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
            // Boxes of 8 bits do not tell what is flat.
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
