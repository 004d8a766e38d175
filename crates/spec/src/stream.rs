//! The words of the machine's streams, and the values of its pins in one clock.

/// A query point: the place of an estimate.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Query {
    /// Its coordinates x, y, z in steps of the frame, [`crate::Widths::coordinate`] wide.
    pub position: [u32; 3],
    /// The squared search radius in square steps, [`crate::Widths::radius_sq`] wide. A photon with
    /// `d^2 <= radius_sq` is in range. On half steps it bounds the sum of half squares instead, see
    /// [`crate::Numbers::radius_word`].
    pub radius_sq: u32,
}

/// A photon as it stands on the machine's pins.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Photon {
    /// The photon's coordinates x, y, z in photon steps of the frame, [`crate::Widths::photon`] wide.
    pub position: [u32; 3],
    /// The mantissas of red, green, blue, [`crate::Widths::mantissa`] wide. With one channel, the first is
    /// used and the others are 0.
    pub power: [u32; 3],
    /// The exponent shared by all channels, [`crate::Widths::exponent`] wide; 0 where the machine has none.
    pub exponent: u32,
}

/// One lane of a group: the photon for one quad.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Lane {
    /// Whether the lane has a photon. Without one, the word on the pins has no effect.
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
    /// The facing of its photons, less than [`crate::Leaf::FACINGS`]; 0 but in a leaf machine.
    pub facing: u32,
}

/// The sums of a query over the photons in range.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Sums {
    /// The summed power in red, green, blue, in the map's power unit, [`crate::Widths::sum`] wide. With one
    /// channel, the first is used and the others are 0.
    pub power: [u128; 3],
    /// The number of photons in range.
    pub count: u64,
}

/// The words of the query stream that only a leaf machine has.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct BatchPins {
    /// The query is the last of its batch.
    pub last: bool,
    /// The facings that the batch gathers, bit i for facing i. The batch has those of its first query.
    pub facings: u32,
    /// The tag that the query's result has, [`crate::Leaf::TAG_BITS`] wide.
    pub tag: u32,
}

/// The values of the machine's input pins in one clock. Words are present whether or not they are valid, as
/// on real wires; a machine must ignore a word that is not valid.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inputs {
    /// Synchronous reset, active high.
    pub reset: bool,
    /// The query stream's valid.
    pub query_valid: bool,
    /// The query stream's word.
    pub query: Query,
    /// Marks a query whose batch is the last on its set of photons; for machines that keep sets.
    pub query_release: bool,
    /// The further words of the query stream; for leaf machines.
    pub batch: BatchPins,
    /// The group stream's valid. Once high it must stay high, with the word unchanged, until the group is
    /// taken.
    pub group_valid: bool,
    /// The group stream's word.
    pub group: Group,
    /// The result stream's ready.
    pub result_ready: bool,
}

/// What a leaf machine does in a clock; 0 in other machines.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct LeafEvents {
    /// The leaves whose boxes are compared with the box of a batch, 0 to [`crate::Leaf::PAIR`]: those of the pair in
    /// `Found`.
    pub compared: u32,
    /// The leaves that a comparison ends for and finds wanted, 0 to [`crate::Leaf::PAIR`]: those of the pair in the last stage
    /// of `Cull`.
    pub wanted: u32,
    /// The chain is given a group.
    pub played: bool,
}

/// The values of the machine's output pins in one clock.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    /// The query stream's ready: the machine takes the query of this clock, if it is valid.
    pub query_ready: bool,
    /// The group stream's ready: the machine takes the group of this clock, if it is valid.
    pub group_ready: bool,
    /// The result stream's valid: the result is complete.
    pub result_valid: bool,
    /// The result; meaningful while `result_valid`.
    pub result: Sums,
    /// The tag of the result's query; 0 while not `result_valid`, and in machines without leaves.
    pub result_tag: u32,
    /// What a leaf machine does in this clock, for counters.
    pub events: LeafEvents,
}

impl Group {
    /// The photons that are present.
    pub fn photons(&self) -> impl Iterator<Item = Photon> {
        let present = self.lanes.iter().filter(|lane| lane.present);
        present.map(|lane| lane.photon)
    }
}
