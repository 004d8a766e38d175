//! A photon as it is stored, and a block of such photons.
//!
//! A record packed into bits holds, from bit 0 up: position x, y, z; a mantissa for each channel; the
//! exponent, if each photon has one.

/// A photon as it is stored.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct PhotonRecord {
    /// The index of the photon's cell in its block, on x, y, z.
    pub position: [u16; 3],
    /// The mantissas of red, green, blue. With one channel, the first is used and the others are 0.
    pub mantissa: [u16; 3],
    /// The photon's own exponent; 0 where the exponent belongs to the block.
    pub exponent: u8,
}

/// The photons of one block, with the block's place in the frame of a query.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct PhotonBlock<'a> {
    /// The block's place in the query's frame, in block edges.
    pub offset: [u32; 3],
    /// The block's exponent; 0 where each photon has its own.
    pub exponent: u8,
    /// The photons, in any order.
    pub photons: &'a [PhotonRecord],
}
