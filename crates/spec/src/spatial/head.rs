//! The sizes of the head: how many results it has room for, and how far apart batches must end.

use super::Spatial;
use crate::format::bits_for;

/// The sizes of the head's queue of results and of its counters.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct HeadSizes {
    /// Results that the queue holds, a power of two. A last group is taken only when the queue has
    /// room for all results of its batch, beside those still on their way.
    pub queue: usize,
    /// After a last group, the next is taken so many clocks later at the earliest, `2 engines - 1`:
    /// then their results do not meet on the chain.
    pub spacing: u32,
    /// Bits of the counter of queries taken for the next batch, 0 to `engines`.
    pub loaded_bits: u32,
    /// Bits of the counter of clocks until the next last group may come, 0 to `spacing - 1`.
    pub spacing_bits: u32,
    /// Bits of the counter of free places in the queue, 0 to `queue`.
    pub room_bits: u32,
    /// Bits of a place in the queue.
    pub place_bits: u32,
}

impl HeadSizes {
    /// A queue of 16 lets queries of one group follow each other without a bubble, as a result is
    /// taken less than 16 clocks after its last group; two batches let one be read while the next
    /// is summed.
    const SMALLEST_QUEUE: usize = 16;

    /// The sizes for a machine.
    pub fn of(spatial: &Spatial) -> Self {
        let engines = spatial.engines();
        let queue = Self::SMALLEST_QUEUE.max(2 * engines);
        let spacing = 2 * engines as u32 - 1;
        Self {
            queue,
            spacing,
            loaded_bits: bits_for(engines as u128),
            spacing_bits: bits_for(u128::from(spacing) - 1),
            room_bits: bits_for(queue as u128),
            place_bits: queue.ilog2(),
        }
    }
}
