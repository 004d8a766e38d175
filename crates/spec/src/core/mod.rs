//! Cores: leaf machines behind standard ports.
//!
//! A core has several equal leaf machines, its *chains*. Each has a memory of leaves and a chain of engines of its own, so
//! each works on another part of the picture. The core adds three AXI4-Streams, through which all chains are given photons
//! and queries and answer, and registers behind AXI4-Lite. It adds no arithmetic on photons.
//!
//! # Streams
//! [`CoreStreams`] has the fields of each word. The bits of a word that no field has are not looked at, but in a query they
//! must be 0.
//! - `s_axis_photons`: a word is a leaf of up to 8 photons, for the chain `tdest`. `tlast` ends the set. The first photons are
//!   present and the others absent. A set has at most [`Core::set_leaves`] leaves.
//! - `s_axis_queries`: a word is a query for the chain `tdest`. `tlast` ends its batch, which also ends where it has as many
//!   queries as a chain has engines. Where each query has a radius, a field `radius_sq` above the format's
//!   [`crate::Numbers::largest_radius_word`] means that largest radius.
//! - `m_axis_results`: a word is the result of a query, from the chain `tid`. `tlast` is the `tlast` of the query, and the
//!   field `tag` its tag. Where each query has a radius, `radius_sq` is that of the result, and a query may have several results, see
//!   [`Rounds`]. `tuser` is 1 where the query is outside of its frame: the sums are then 0. The results of one chain
//!   have the order of its queries; results of different chains come as they are found. With a ladder,
//!   the results of a batch come one round after the other.
//!
//! A word is taken at a rising edge of `aclk` with `tvalid` and `tready`. A stream's words reach the chains in their order, so
//! a word for a busy chain holds back the words behind it. The user must not make each stream wait for the other: where a
//! leaf waits for a bank, the queries on the set in that bank must come before every query that waits for a leaf behind
//! that one.
//!
//! # Wrong words
//! Each of these sets the bit of [`CoreEvent`] and is counted, and the words before and behind it lose nothing:
//! - a leaf with a photon behind an absent one, which is used as it is;
//! - the leaves of a set behind the last that the bank holds, which are dropped up to and with `tlast`;
//! - a query outside of its frame, which is answered with `tuser`;
//! - a word for a chain that there is not, which is dropped;
//! - an access to an address without a register, of which the two low bits are not looked at, and a write to a register that
//!   is only read, which are answered with SLVERR.
//!
//! # Each clock
//! All registers have the values before the clock edge, and `:=` gives the value after it. A word *moves* where its valid and
//! its ready are both 1. `reset` is a register, which is 1 in each clock behind one with `aresetn` = 0, and in the clock
//! behind a write of [`CoreRegister::Control`]'s restart. `reset` goes to all chains. The pin `aresetn` = 0 also gives all
//! registers of [`CoreRegister`] their reset values, in the same clock; a restart leaves them. So a word that moves in the
//! first clock of `aresetn` = 0 is lost.
//! - *Slices.* Each stream passes a slice of two places. Its ready is 1 where its second place is empty and `reset` is 0, its
//!   valid where its first place is full. A word that moves in goes to the first place where that is empty or its word
//!   moves out and the second place is empty, else to the second. Where the first place's word moves out, the second's
//!   follows. A `reset` empties both, and `m_axis_results_tvalid` is then 0: a result that waits there is taken back.
//! - *Links.* In front of each chain is a queue with [`Core::LEAF_PLACES`] places for leaves, and one with [`Core::QUERY_PLACES`] for queries.
//!   A link leads from a slice to each queue. A word passes [`Core::stages`] registers on its way, one in each clock, so for chain n it is in
//!   the queue n + 2 clocks after it leaves the slice, and a clock later the chain can be given it. Its flow control is by credits. After `reset` it has as many credits as places. A word
//!   that leaves the slice for the chain takes a credit, and gives it back n + 2 clocks after it leaves the queue. The ready of the link is 1
//!   where it has a credit and `reset` is 0. A `reset` empties the stages and the queues. So no path leads from a chain to a stream, and none
//!   is longer than from one chain to the next.
//! - *Behind each chain* is a place for one result. The ready of a place is 1 where it is empty and `reset` is 0, its
//!   valid where it is full. A `reset` empties it.
//! - *Leaves.* A leaf in the photon slice is *refused* where its chain is not there or drops. Else it is *given* where the link to
//!   its chain was ready in the clock before and no leaf was given to that chain then; in the clock behind `reset` that is so. The number of the leaf in its set is counted for each chain.
//!   Where the last leaf of a full set is given without `tlast`, the chain drops: up to and with the next word with `tlast`.
//! - *Groups.* The oldest leaf in a queue gives the chain its first group where the chain is ready, then its second in the next clock
//!   in which the chain is ready, and leaves with its last. A leaf has a second group unless it has `tlast` and its last four
//!   photons are absent. The chain's `group_last` is 1 with the last group of a word with `tlast`.
//! - *Queries.* A query in its slice is refused where its chain is not there, and given where the link to its
//!   chain is ready. The chain's tag has the query's tag in its low bits, `tlast` in [`Core::LAST_BIT`], and in [`Core::OUTSIDE_BIT`] whether
//!   it is outside: a bit that no field has is 1, as it is where a coordinate is not less than the frame.
//! - *Results.* Each chain has a slice, of its own results and of those that come from the slice of the chain behind it, the one with the next
//!   number. Where both have a result, the one goes in that is not of the kind that went in last; after `reset` the chain's own goes first.
//!   The slice of chain 0 gives its results to that of the stream.
//! - *Reads.* A read is taken where no other waits for its answer. In the next clock its answer is found, from the registers as they are then,
//!   and the high word of a counter is held. In the clock behind that it is answered, and sets events and counts.
//! - *Under way* are the queries that were given and whose results, each its last, have not left through `m_axis_results`. Both are counted a
//!   clock late, and so is that none is left. A restart forgets what happened in the clock before.
//! - *Counters and events* are a clock late: what happens in a clock is counted, and sets its event, at the end of the next
//!   clock. Only [`CoreCounter::Clocks`] counts at once, and what the chains do - leaves compared and wanted, groups played - is two clocks
//!   late, and not counted where that clock or the next is one of `reset`. The ways to the counters are long, and so are no part of the
//!   clock's slowest paths. `aresetn` = 0 forgets what happened in the clock before; a restart does not.
//! - *Stall.* The core is *silent* where no word moves on any of the three streams, a query is under way or a word waits on
//!   an input stream, and no result waits on `m_axis_results`. Where each query has a radius, no chain was given a group by its memory
//!   in the clock before either. After as many silent clocks in a row as [`CoreRegister::StallLimit`] says (0: never), the event `Stalled`
//!   occurs, in the second clock behind them; the count goes on.

mod counters;
mod events;
mod fields;
mod meanings;
mod ports;
mod registers;
mod rounds;
mod serial;
mod streams;
mod words;

pub use counters::{CoreCounter, CounterRow};
pub use events::{CoreEvent, EventRow};
pub use fields::CoreField;
pub use meanings::StreamRow;
pub use ports::{CorePins, port_columns};
pub use registers::{Access, CoreRegister, CoreRegisterRow};
pub use rounds::{QueryRounds, Rounds};
pub use serial::{Serial, SerialFault, SerialFaultRow, SerialKind, SerialRow, SerialSizes};
pub use streams::{CoreStreams, QueryResult, StreamField, StreamWord};
pub use words::{
    Beat, CoreAnswer, CoreInputs, CoreOutputs, CoreWords, LiteAnswer, LiteIn, ResultWord, StreamIn,
};

use thiserror::Error;

use crate::leaf::Leaf;
use crate::machine::{Machine, module_prefix};
use crate::spatial::Spatial;

/// A core: a leaf machine, as often as it has chains.
#[derive(Copy, Clone, Debug)]
pub struct Core {
    /// The leaf machine.
    pub machine: &'static Machine,
    /// The number of chains, 1 to [`Core::MOST_CHAINS`].
    pub chains: u32,
}

/// The cores whose Verilog is committed: chains, and the leaf machine. With three chains the streams can name a chain that there
/// is not.
pub const CORES: [(u32, &str); 1] = [(3, "leaf-5-local7-rgb6d-n64")];

/// Further cores that are verified and whose results are recorded. Of their Verilog only the digest is committed. The first is the
/// fastest that was placed and routed; the second has rounds.
pub const RECORDED_CORES: [(u32, &str); 2] = [
    (6, "leaf-7-local7-rgb6d-n4096"),
    (2, "leaf-5-radii-local7-rgb6d-n64"),
];

/// There is no such core.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CoreError {
    /// The machine has no memory of leaves.
    #[error("machine `{0}` is no leaf machine; expected one such as leaf-7-local7-rgb6d-n4096")]
    NoLeaves(&'static str),
    /// The number of chains is 0 or too large.
    #[error("found {0} chains, expected 1 to {most}", most = Core::MOST_CHAINS)]
    Chains(u32),
}

impl Core {
    /// The most chains.
    pub const MOST_CHAINS: u32 = 16;
    /// Places for queries in the queue of each chain: a power of 2, so many that the first chains can be given a query in each clock.
    pub const QUERY_PLACES: u32 = 16;
    /// Places for leaves in the queue of each chain: a power of 2. A chain takes a leaf in two clocks.
    pub const LEAF_PLACES: u32 = 8;
    /// Bits of the tag of a query: those of a chain's tag, without two flags of the core.
    pub const TAG_BITS: u32 = Leaf::TAG_BITS - 2;
    /// The bit of a chain's tag that has the `tlast` of the query.
    pub const LAST_BIT: u32 = Self::TAG_BITS;
    /// The bit of a chain's tag that says whether the query is outside of its frame.
    pub const OUTSIDE_BIT: u32 = Self::TAG_BITS + 1;
    /// Bits of the number of queries under way. The largest core has fewer.
    pub const UNDER_WAY_BITS: u32 = 16;
    /// Bits of a counter.
    pub const COUNTER_BITS: u32 = 48;
    /// Bits of an address on AXI4-Lite. Addresses count bytes.
    pub const ADDRESS_BITS: u32 = 9;
    /// Bits of a register. A counter takes two.
    pub const REGISTER_BITS: u32 = 32;
    /// Photons of a leaf.
    pub const LEAF_PHOTONS: usize = Leaf::GROUPS * Spatial::LANES;

    /// A core of this many of these machines.
    ///
    /// # Errors
    /// The machine is no leaf machine, or the number of chains is out of range.
    pub fn new(machine: &'static Machine, chains: u32) -> Result<Self, CoreError> {
        if machine.leaf().is_none() {
            return Err(CoreError::NoLeaves(machine.name));
        }
        match chains {
            1..=Self::MOST_CHAINS => Ok(Self { machine, chains }),
            _ => Err(CoreError::Chains(chains)),
        }
    }

    /// The parameters of its leaf machine.
    pub fn leaf(&self) -> &'static Leaf {
        let leaf = self.machine.leaf();
        leaf.expect("the machine of a core is a leaf machine")
    }

    /// The name of the core: `core-4-` and the name of its machine for four chains.
    pub fn name(&self) -> String {
        format!("core-{}-{}", self.chains, self.machine.name)
    }

    /// The name of the top module.
    pub fn top(&self) -> String {
        module_prefix(&self.name())
    }

    /// Bits of a chain's number on the streams: at least 1.
    pub fn chain_bits(&self) -> u32 {
        crate::formats::bits_for(u128::from(self.chains - 1)).max(1)
    }

    /// Whether each query has a radius of its own.
    pub fn has_radii(&self) -> bool {
        self.machine.fixed_radius_sq().is_none()
    }

    /// Clocks in which no word moves on any stream after which the core hangs. A chain's store may work on several batches, each in several
    /// rounds.
    pub fn silent_clocks(&self) -> u64 {
        let rounds = Rounds::of(self).map_or(1, |rounds| rounds.most() * Rounds::BATCHES as u32);
        Leaf::SILENT_CLOCKS * u64::from(rounds)
    }

    /// The stages that a word of a stream passes up to the queue of a chain, one for each chain up to it; the chains are counted from 0.
    pub fn stages(&self, chain: u32) -> u32 {
        chain + 1
    }

    /// Engines of each chain.
    pub fn engines(&self) -> usize {
        self.leaf().chain.engines()
    }

    /// The most leaves of a set.
    pub fn set_leaves(&self) -> u32 {
        self.leaf().bank_groups / Leaf::GROUPS as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::find_machine;

    #[test]
    fn only_leaf_machines_make_a_core_of_1_to_16_chains() {
        let leaf = find_machine("leaf-5-local7-rgb6d-n64").unwrap();
        let core = Core::new(leaf, 4).unwrap();
        assert_eq!(core.name(), "core-4-leaf-5-local7-rgb6d-n64");
        assert_eq!(core.top(), "photoncube_core_4_leaf_5_local7_rgb6d_n64");
        assert_eq!(
            [1, 2, 3, 16].map(|chains| Core { chains, ..core }.chain_bits()),
            [1, 1, 2, 4]
        );
        assert_eq!(Core::new(leaf, 17).unwrap_err(), CoreError::Chains(17));
        assert_eq!(Core::new(leaf, 0).unwrap_err(), CoreError::Chains(0));
        let paper = find_machine("paper").unwrap();
        assert_eq!(
            Core::new(paper, 1).unwrap_err(),
            CoreError::NoLeaves("paper")
        );
    }
}
