//! The words that cross the machine's streams, and one clock's worth of its pins.

/// A query point: where an estimate is made.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Query {
    /// Its coordinates x, y, z in steps of the frame, [`crate::Widths::coordinate`] wide.
    pub position: [u32; 3],
    /// The squared search radius in square steps, [`crate::Widths::radius_sq`] wide. A photon with
    /// `d^2 <= radius_sq` is in range.
    pub radius_sq: u32,
}

/// A photon as the machine sees it.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Photon {
    /// Its coordinates x, y, z in its own steps of the frame, [`crate::Widths::photon`] wide.
    pub position: [u32; 3],
    /// Its power in red, green, blue, [`crate::Widths::mantissa`] wide; of one channel the first,
    /// and the others are 0.
    pub power: [u32; 3],
    /// The exponent of all its powers, [`crate::Widths::exponent`] wide; 0 where the machine has
    /// none.
    pub exponent: u32,
}

/// One quad's part of a group.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Lane {
    /// Whether there is a photon; without one, the word counts for nothing, whatever it is.
    pub present: bool,
    /// The word on the lane's pins.
    pub photon: Photon,
}

/// The photons of one iteration: a lane for each quad.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Group {
    /// One lane for each quad of the machine.
    pub lanes: Vec<Lane>,
    /// Whether it is the last group of its query.
    pub last: bool,
}

/// The sums of a query over the photons in range.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Sums {
    /// Power in red, green, blue, in power steps; of one channel the first, and the others are 0.
    pub power: [u64; 3],
    /// Photons in range.
    pub count: u64,
}

/// What stands on the machine's input pins in one clock. Words are there whether or not they are
/// valid, as on real wires: a machine must not look at them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inputs {
    /// Synchronous reset, active high.
    pub reset: bool,
    /// The query stream's valid.
    pub query_valid: bool,
    /// The query stream's word.
    pub query: Query,
    /// The query's batch is the last on its set of photons; for machines with a photon memory.
    pub query_release: bool,
    /// The group stream's valid; once high it must stay, with the word, until it is taken.
    pub group_valid: bool,
    /// The group stream's word.
    pub group: Group,
    /// The result stream's ready.
    pub result_ready: bool,
}

/// What stands on the machine's output pins in one clock.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    /// The machine takes the query of this clock, if it is valid.
    pub query_ready: bool,
    /// The machine takes the group of this clock, if it is valid.
    pub group_ready: bool,
    /// The result is complete.
    pub result_valid: bool,
    /// The result; meaningful while `result_valid`.
    pub result: Sums,
}

impl Group {
    /// The photons that are present.
    pub fn photons(&self) -> impl Iterator<Item = Photon> {
        let present = self.lanes.iter().filter(|lane| lane.present);
        present.map(|lane| lane.photon)
    }
}
