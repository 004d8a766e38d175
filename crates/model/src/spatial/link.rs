//! What passes from the head to engine 0, from engine to engine, and back.

use photoncube_spec::{Query, Spatial, Sums};

/// Which group of its batch it is.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Flags {
    pub(super) first: bool,
    pub(super) last: bool,
}

/// The powers of a group, decoded; from stage 1 of the delay line on 0 for an absent photon.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Powers {
    /// By lane, then channel.
    pub(super) power: [[u64; 3]; Spatial::LANES],
    pub(super) present: [bool; Spatial::LANES],
    pub(super) flags: Flags,
}

/// A hop: all that an engine gets from the one before, or engine 0 from the head.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Hop {
    pub(super) reset: bool,
    pub(super) token_valid: bool,
    pub(super) token: Query,
    pub(super) swap: bool,
    /// By lane, then axis.
    pub(super) photon: [[u32; 3]; Spatial::LANES],
    pub(super) powers: Powers,
}

/// A place on the result chain, which runs back to the head.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct ResultLink {
    pub(super) valid: bool,
    pub(super) sums: Sums,
}
