//! The leaf machines: a chain of engines behind a memory that gives it only the photons near a batch of queries.
//!
//! A [`Spatial`] machine tests every photon of a set against every query. Most of these photons are out of range of all
//! queries of a batch. A leaf machine stores the photons of a set in *leaves* of two groups of four, and with each group the box
//! around its photons. For each batch it compares the box around the batch's queries with the boxes of all groups, those of two
//! leaves a clock, and gives the engines only the groups that are *wanted*: those whose box is within the search radius of the
//! batch's box, and whose facing the batch gathers. A leaf is wanted where a group of it is. The engines are those of a spatial
//! machine without a photon memory; its registers are in [`crate::HeadRegister`] and [`crate::EngineRegister`].
//!
//! # No photon in range is skipped
//! On each axis an engine computes d = query - photon (on half steps: less the half), and its square grows with |d|. The
//! gap of two boxes on an axis is the d of their two nearest borders, or 0 where the boxes overlap. For each query in
//! the one box and each photon in the other, |d| is at least the gap's |d|, of equal sign. So every square, their sum,
//! and whether an axis is far, are at least those of the gaps: where the gaps are out of range, so is the photon.
//!
//! A query's own radius is at most the format's. The boxes are compared with the format's radius, so this holds for each radius.
//!
//! # Streams
//! - *Sets*: groups of four photons from a first to one with `group_last`, at most [`Leaf::bank_groups`] of them; the group
//!   at the last place counts as last. Two groups that follow each other are a leaf. All photons of a leaf have one
//!   *facing*, `group_facing` of the leaf's last group, a number below [`Leaf::FACINGS`] that the user chooses. A set
//!   that ends with the first group of a leaf has a leaf of four photons. Groups of photons that are close together
//!   have small boxes.
//! - *Queries*: a batch is all queries up to one with `query_last`, at most one for each engine; the engine after the last
//!   query's is not used. The batch gathers the facings in `query_facings` of its first query, one bit for each facing. It
//!   is tested against the photons of the set that was read in first and not released. A query with `query_release` has its
//!   batch release the set: the next batch uses the next set.
//! - *Results* leave in the order of the queries, each with the `query_tag` of its query.
//!
//! # Each clock
//! [`LeafRegister`] has the rules of every register.

mod registers;
mod words;

pub use registers::{LeafRegister, LeafRow};
pub use words::QueryWord;

use crate::formats::{Widths, bits_for};
use crate::machine::Machine;
use crate::pins::{Pin, SignalPlace};
use crate::spatial::{EngineKind, HeadSizes, Spatial};

/// The parameters of a leaf machine beside its numbers.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// The chain of engines. It has no photon memory of its own.
    pub chain: Spatial,
    /// The squarers and the pipeline registers of the comparison of boxes.
    pub culler: EngineKind,
    /// Groups that each of the two banks holds, a power of two.
    pub bank_groups: u32,
}

impl Leaf {
    /// Groups of a leaf.
    pub const GROUPS: usize = 2;
    /// Leaves that are compared in a clock: two neighbours, a *pair*.
    pub const PAIR: usize = 2;
    /// Groups of a pair, each of which has a box.
    pub const PAIR_GROUPS: usize = Self::PAIR * Self::GROUPS;
    /// The number of facings that the photons of a set may have.
    pub const FACINGS: u32 = 32;
    /// Bits of a facing.
    pub const FACING_BITS: u32 = Self::FACINGS.ilog2();
    /// Facings that a leaf's is first looked up among: those that equal it except for the lowest two bits.
    pub const FACINGS_NEAR: u32 = 4;
    /// Bits of a query's tag. A core uses two of them, see [`crate::Core::TAG_BITS`].
    pub const TAG_BITS: u32 = 18;
    /// Clocks in which no word moves on any stream after which a machine hangs. The scan of the largest bank is shorter.
    pub const SILENT_CLOCKS: u64 = 1 << 17;
    /// The most places of the queue of pairs that wait to be played.
    pub const QUEUE: u32 = 32;
    /// The fewest groups of a bank: two pairs.
    pub const FEWEST_GROUPS: u32 = 2 * (Self::GROUPS * Self::PAIR) as u32;

    /// The fewest groups, as a power of two, that hold that many photons.
    pub fn groups_for(photons: u64) -> u32 {
        let groups = photons.div_ceil(Spatial::LANES as u64).next_power_of_two();
        u32::try_from(groups)
            .unwrap_or(1 << 31)
            .max(Self::FEWEST_GROUPS)
    }
}

/// The sizes and widths of a leaf machine's registers.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct LeafSizes {
    /// Engines of the chain.
    pub engines: u32,
    /// Bits of a group's place in its bank.
    pub place: u32,
    /// Bits of a leaf's number in its bank.
    pub leaf: u32,
    /// Bits of a pair's number in its bank.
    pub pair: u32,
    /// Bits of a place in the queue of pairs, which has no more places than a bank has pairs, and at most [`Leaf::QUEUE`].
    pub queue_place: u32,
    /// Bits of the number of a batch's queries that the chain has taken, 0 to the engines.
    pub loaded: u32,
    /// The fewest clocks from one last group to the next, as in [`HeadSizes::spacing`].
    pub least_spacing: u32,
    /// Bits of the clocks until the next last group may be played.
    pub spacing: u32,
    /// The most batches whose results may be under way: those that the chain's queue of results has room for.
    pub most_outstanding: u32,
    /// Bits of the number of batches whose results are under way.
    pub outstanding: u32,
    /// Bits of a place in the queue of tags, which has room for the tags of all queries in the machine.
    pub tag_place: u32,
    /// Bits of a result's number in its batch.
    pub result: u32,
    /// Clocks from a pair's boxes in `Found` to the decision which of its groups are wanted.
    pub cull_clocks: u32,
}

impl LeafSizes {
    /// Computes the sizes for a machine.
    pub fn of(leaf: &Leaf) -> Self {
        let head = HeadSizes::of(&leaf.chain);
        let engines = leaf.chain.engines() as u32;
        let place = leaf.bank_groups.ilog2();
        let pair = place - (Leaf::GROUPS * Leaf::PAIR).ilog2();
        let most_outstanding = head.queue as u32 / engines;
        // The queries of the batch that is loaded, of the batch that is tested, and of the batches under way.
        let tags = 2 * engines + head.queue as u32;
        Self {
            engines,
            place,
            leaf: place - Leaf::GROUPS.ilog2(),
            pair,
            queue_place: pair.min(Leaf::QUEUE.ilog2()),
            loaded: bits_for(engines.into()),
            least_spacing: head.spacing,
            spacing: head.spacing_bits,
            most_outstanding,
            outstanding: bits_for(most_outstanding.into()),
            tag_place: tags.next_power_of_two().ilog2(),
            result: bits_for(u128::from(engines) - 1),
            cull_clocks: leaf.culler.cuts.latency(),
        }
    }

    /// The places of the queue of pairs that wait to be played.
    pub fn queue(&self) -> u32 {
        1 << self.queue_place
    }
}

/// Lists the registers of a leaf machine, except those of its chain.
pub(crate) fn registers(machine: &Machine, leaf: &Leaf) -> Vec<Pin> {
    let dimensions = registers::Dimensions {
        sizes: LeafSizes::of(leaf),
        widths: Widths::of(machine),
        channels: machine.channels().names().len(),
    };
    let pins = LeafRow::ALL.iter().flat_map(|row| {
        let width = (row.width)(&dimensions);
        (0..(row.count)(&dimensions)).map(move |index| Pin {
            name: format!("leaf_{}_{index}", row.name),
            width,
            place: SignalPlace::Leaf {
                register: row.register,
                index,
            },
        })
    });
    pins.collect()
}
