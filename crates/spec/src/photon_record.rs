//! The words of a photon format: a stored photon, a block of them, a query, its sums.
//!
//! A record packed into bits holds, from bit 0 up: position x, y, z; a mantissa for each channel;
//! the exponent, if the format has one there.

/// A stored photon.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct PhotonRecord {
    /// The cell of its block that contains it, on x, y, z.
    pub position: [u16; 3],
    /// Red, green, blue; of one channel the first, and the others are 0.
    pub mantissa: [u16; 3],
    /// Its own exponent; 0 where the block has it.
    pub exponent: u8,
}

/// Photons of one block as a query meets them.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct PhotonBlock<'a> {
    /// The block's place in the query's frame, in block edges.
    pub offset: [u32; 3],
    /// The block's exponent; 0 where each photon has its own.
    pub exponent: u8,
    /// The photons, in any order.
    pub photons: &'a [PhotonRecord],
}

/// A query point: its fine cell in the frame, on x, y, z. The search radius is the format's.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct LocalQuery {
    /// In fine steps of the frame.
    pub position: [u32; 3],
}

/// The sums of a query over the photons in range.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct LocalSums {
    /// Power in red, green, blue, in the map's units; of one channel the first.
    pub power: [u128; 3],
    /// Photons in range.
    pub count: u64,
}
