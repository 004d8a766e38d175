//! The head: what it takes from the streams and when, and its sizes.
//!
//! With `valid`, `ready` and `last` those of this clock, N engines, and all registers as they stand
//! before the clock edge:
//! - `first` = not `open`. `full` = `loaded` is N. `fits` = `spacing` is 0 and
//!   `promised` <= queue - N.
//! - `group_ready` = (`open` or `full`) and (not `group_last` or `fits`). A group is *taken* where
//!   `group_valid` and `group_ready`. Then `open` := not last. It enters engine 0 with this clock's
//!   edge: the coordinates on the pins go into its `Photon` registers in every clock, taken or not.
//!   Engine 0's swap (see below) happens where the taken group is `first`.
//! - `query_ready` = not `full`, or a first group is taken. A query that is taken enters engine 0 as
//!   its incoming token.
//! - `loaded` := 0 if a first group is taken, else `loaded`; plus 1 if a query is taken.
//! - `spacing` := [`HeadSizes::spacing`] - 1 if a last group is taken; else one less, but not below
//!   0.
//! - `promised` := `promised`, plus N if a last group is taken, less 1 if a result is taken.
//! - Delay line: stage 0 gets, in every clock, each lane's decoded powers (mantissa << exponent) where
//!   a group is taken and the lane present, else 0; presence where taken and present; the flags
//!   `first` and `last` of a taken group. Stage i gets stage i - 1. The last stage is what engine
//!   0's power hop registers get, so a group's powers are in that hop register
//!   [`super::Cuts::latency`] clocks after its positions are in theirs.
//! - Queue: where engine 0's `ResultValid` is set, its result is written at `write_place`, which then
//!   counts on. `result_valid` = the places differ: `write_place` is not `read_place`, with one bit
//!   more than a place has, so that full and empty differ. The result pins show the word at
//!   `read_place` in every clock; a result taken counts that on. The queue's memory starts as 0 and
//!   is not reset.
//! - Reset, at the end of the clock in which the pin is set: all registers of the head but
//!   `DelayPower` and `DelayPresent` become 0, and these two and the queue's memory do as in any
//!   clock. No group or query counts as taken by the engines: engine 0's incoming token is not
//!   valid and its incoming swap is 0. The outputs do not look at the pin.
//!
//! # An engine, each clock
//! - `reset_in` is the pin for engine 0 and engine e - 1's `Reset` for engine e; `Reset` := it.
//!   Where `reset_in` is set, `TokenValid`, `NextValid`, `Swap`, `First`, `Last`, `GateFirst`,
//!   `GateLast`, `PairFirst`, `PairLast`, `GroupFirst`, `GroupLast`, `Done` and `ResultValid` become 0 with
//!   the edge, whatever else is said below; `ResultValid` also where `Reset` is set, because a
//!   result of engine e + 1, which the wave reaches a clock later, is on its way back.
//! - The incoming token is the query that the head takes for engine 0, and engine e - 1's `Token`
//!   for engine e; the incoming `swap` likewise: a first group taken, or engine e - 1's `Swap`;
//!   `Swap` := incoming swap (cleared as above).
//! - On an incoming swap: `Query` := `Next`, and `Next` is free.
//! - An incoming valid token is kept where `Next` is free or is freed in this clock: `Next` :=
//!   token, `NextValid` := 1, `TokenValid` := 0. Otherwise it passes: `Token` := token, `TokenValid`
//!   := 1. Without a valid token `TokenValid` := 0; `Token` (and its radius) take the incoming words
//!   in every clock. `NextValid` stays, or becomes 0 where it is freed and no token is kept.
//! - `Photon`, `Power`, `Present`, `First`, `Last` take the incoming words in every clock.
//! - The radius of a query (with [`super::Radius::Query`]) is compared at the `Range` step: it
//!   follows the photons through `RadiusDelay`, whose register 0 gets `QueryRadius`, each clock, and
//!   each further one the one before.
//! - `Sum` := (`first` ? 0 : `Sum`) + the group's sums, in every clock, with the flags as they stand
//!   beside these sums (in the last cut of the power flow that has a register, else in the hop);
//!   `Count` likewise. Both wrap at their widths, which only a reset in flight can lead to: photons
//!   of a batch whose `first` it cleared are added to the sums before. `Done` := the flag `last`
//!   there.
//! - Where `Done`, `Result` := `Sum` and `ResultCount` := `Count`, else engine e + 1's (0 for the last
//!   engine); `ResultValid` := `Done` or engine e + 1's.

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
    /// Bits of the counter of places in the queue that are taken or promised, 0 to `queue`.
    pub promised_bits: u32,
    /// Bits of a place in the queue, and one more that tells full from empty.
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
            promised_bits: bits_for(queue as u128),
            place_bits: queue.ilog2() + 1,
        }
    }
}
