//! The values that pass from the head to engine 0, from engine to engine, and back.

use photoncube_spec::{Query, Spatial, Sums};

/// The position of a group in its batch.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Flags {
    pub(super) first: bool,
    pub(super) last: bool,
}

/// The decoded powers of a group. From stage 1 of the delay line on, the powers of an absent photon are 0.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Powers {
    /// The powers by lane, then channel.
    pub(super) power: [[u64; 3]; Spatial::LANES],
    pub(super) present: [bool; Spatial::LANES],
    pub(super) flags: Flags,
}

/// The hop registers: all values that an engine gets from the engine before, or engine 0 from the head.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Hop {
    pub(super) reset: bool,
    pub(super) token_valid: bool,
    pub(super) token: Query,
    pub(super) swap: bool,
    /// The coordinates by lane, then axis.
    pub(super) photon: [[u32; 3]; Spatial::LANES],
    pub(super) powers: Powers,
}

/// A link of the result chain, which runs back to the head.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct ResultLink {
    pub(super) valid: bool,
    pub(super) sums: Sums,
}
