//! The head of a spatial machine: its handshakes with the streams, its result queue, and its sizes; then the
//! registers of an engine.
//!
//! In the rules below, `valid`, `ready` and `last` are the pins' values of this clock, N is the number of
//! engines, and all registers have the values before the clock edge. `:=` gives the value after the edge.
//! - `first` = not `open`. `full` = `loaded` is N. `fits` = not `waits` and `promised` shows fewer batches
//!   than the queue has room for.
//! - `group_ready` = `has_batch` and (not `group_last` or `fits`). A group is *taken* where `group_valid` and
//!   `group_ready`. Then `open` := not last.
//! - `query_ready` = not `full`, or a first group is taken.
//! - `loaded` := 0 if a first group is taken, else `loaded`; plus 1 if a query is taken.
//! - `has_batch` := `open` or `full`, both as they are after this clock: a batch is open or can be opened.
//! - `spacing` := [`HeadSizes::spacing`] - 1 if a last group is taken; else one less, but not below 0.
//!   `waits` := `spacing`, as it is after this clock, is not 0. Without [`HeadSizes::has_waits`], `waits` is
//!   always 0 and has no register.
//! - `promised` counts, in unary (the number of its lowest bits that are 1), the batches whose last group was
//!   taken and whose results were not all read from the queue's memory. It grows by one if a last group is
//!   taken. It shrinks by one if the last result of a batch is read, which is the result read at a
//!   `read_place` of N - 1 modulo N. Where a last group may have to wait ([`HeadSizes::has_waits`]), it
//!   shrinks one clock later: `batch_read` := that result is read, and `promised` shrinks by one where
//!   `batch_read` is set. A single engine has no `batch_read` register, because a query of one group each
//!   clock would then need one more place in the queue.
//! - Where [`Spatial::paced`], a group is given only where the rules above take it. So `group_ready` is always 1, and there are no
//!   registers `has_batch`, `spacing`, `waits`, `promised` and `batch_read`.
//! - Entry: registers that hold the pins' values one clock later. The coordinates of query and photons, the
//!   radius, mantissas, exponents and presence (`EntryPresent`) are stored in every clock. `EntryTaken` := a
//!   group is taken, `EntryTokenValid` := a query is taken, `EntryFirst` := a first group is taken,
//!   `EntryLast` := a last group is taken. The entry feeds engine 0: its incoming token, its photons, and
//!   `EntryFirst` as its incoming swap (see below).
//! - Delay line: stage 0 stores, in every clock, each lane's decoded powers (mantissa << exponent) from the
//!   entry; `DelayPresent`, whether the lane's photon is present and the group taken; `DelayAbsent`, the
//!   inverse of `DelayPresent`; and the two flags. Stage i stores the values of stage i - 1, but stage 1
//!   stores powers of 0 where `DelayAbsent`. The last stage feeds engine 0's power hop registers, so a
//!   group's powers are in that hop register [`Spatial::latency`] clocks after the group's positions are in
//!   theirs.
//! - Queue: where engine 0's `ResultValid` is set, its result is written at `write_place`, which is then
//!   incremented modulo the queue, and `newest_place` := that place. A result is *read* where `has_waiting`
//!   and (not `has_result` or `result_ready`). A read moves the word at `read_place` to the result pins,
//!   which otherwise keep their values, and increments `read_place`. `has_waiting` := a result is written, or
//!   `has_waiting` is set and the result at `newest_place` is not read. `has_result` := a result is read, or
//!   `has_result` is set and not `result_ready`; `result_valid` = `has_result`. The queue's memory and the
//!   result pins start as 0 and are not reset.
//! - Reset, at the end of the clock in which the pin is set: all registers of the head become 0. Exceptions
//!   are the words of the entry, `EntryPresent`, `EntryTaken`, `DelayPower`, `DelayPresent`, `DelayAbsent`
//!   and the queue's memory and word; they store what they store in any clock. The outputs do not depend on
//!   the reset pin.
//!
//! `HasBatch`, `HasWaiting`, `Waits` and the unary `Promised` are redundant: their values follow from the
//! other registers. Each of them decides, in the same clock, whether a group is taken, and the group taken
//! decides their next values. With comparisons of counters in their place, these were the slowest paths of
//! `stream` and of `tile-8`.
//!
//! # An engine, each clock
//! - `reset_in` is the pin for engine 0 and engine e - 1's `Reset` for engine e; `Reset` := `reset_in`. Where
//!   `reset_in` is set, `TokenValid`, `NextValid`, `Swap`, `First`, `Last`, `GateFirst`, `GateLast`,
//!   `PairFirst`, `PairLast`, `PairFirstDelay`, `GroupFirst`, `GroupLast`, `GroupLastDelay`, `SumFirst`,
//!   `SumDone`, `Done` and `ResultValid` become 0 with the edge, whatever the rules below say. `ResultValid`
//!   becomes 0 also where `Reset` is set, because the reset reaches engine e + 1 one clock later, and a
//!   result of that engine may still be on its way back.
//! - The incoming token of engine 0 is the query that the head takes; that of engine e is engine e - 1's
//!   `Token`. The incoming `swap` of engine 0 is that a first group is taken; that of engine e is engine e -
//!   1's `Swap`. `Swap` := incoming swap (cleared as above).
//! - On an incoming swap: `Query` := `Token` where `Keep`, else `Next`; and `Next` is free.
//! - An incoming valid token is kept where `Next` is free or is freed in this clock: `Keep` := 1, `NextValid`
//!   := 1, `TokenValid` := 0. Otherwise the token passes to the next engine: `Keep` := 0, `TokenValid` := 1.
//!   Without a valid token `Keep` := 0 and `TokenValid` := 0. `Token` and its radius store the incoming words
//!   in every clock. `NextValid` keeps its value, or becomes 0 where `Next` is freed and no token is kept. A
//!   reset does not change the new value of `Keep`.
//! - Where `Keep`, `Next` := `Token`. Thus the decision whether a token is kept must reach only the register
//!   `Keep` in time, and not all bits of `Next`.
//! - `Photon`, `Power`, `Present`, `First`, `Last` store the incoming words in every clock.
//! - The radius of a query (with [`super::Radius::Query`]) is compared at the `Range` step. It follows the
//!   photons through `RadiusDelay`: in every clock register 0 stores `QueryRadius`, and each further register
//!   stores the one before it.
//! - `Sum` := (`first` ? 0 : `Sum`) + the group's sums, in every clock. The flags are those beside the
//!   group's sums: in the last cut of the power flow that has a register, else in the hop registers. `Count`
//!   follows the same rule. Both wrap at their widths. They can wrap only after a reset during a batch: the
//!   reset clears `first`, and the photons of that batch are then added to the earlier sums. `Done` := the
//!   flag `last` at that place.
//! - Where `Done`, `Result` := `Sum` and `ResultCount` := `Count`, else engine e + 1's (0 for the last
//!   engine); `ResultValid` := `Done` or engine e + 1's.

use super::Spatial;
use crate::formats::bits_for;

/// The sizes of the head's queue of results and of its counters.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct HeadSizes {
    /// Results that the queue holds, a power of two. A last group is taken only when the queue has room for
    /// all results of its batch, beside the results still on their way. So the queue holds two batches, one
    /// that is read while the next is summed. It also holds as many results as a query of one group each
    /// clock needs to run without a bubble: the latency in clocks, since the result on the pins has left its
    /// place in the queue.
    pub queue: usize,
    /// The fewest clocks from one last group to the next, `2 engines - 1`. At this distance the results of
    /// two batches do not collide on the result chain.
    pub spacing: u32,
    /// Bits of the counter of queries taken for the next batch, 0 to `engines`.
    pub loaded_bits: u32,
    /// Bits of the counter of clocks until the next last group may come, 0 to `spacing - 1`.
    pub spacing_bits: u32,
    /// Bits of the unary number of batches whose results have places in the queue's memory.
    pub promised_bits: u32,
    /// Bits of a place in the queue.
    pub place_bits: u32,
}

impl HeadSizes {
    /// Whether a last group may have to wait for the results of the batch before. With one engine, results
    /// never collide.
    pub fn has_waits(&self) -> bool {
        self.spacing > 1
    }

    /// Computes the sizes for a machine.
    pub fn of(spatial: &Spatial) -> Self {
        let engines = spatial.engines();
        let without_bubble = spatial.latency_clocks() as usize;
        let queue = without_bubble.next_power_of_two().max(2 * engines);
        let spacing = 2 * engines as u32 - 1;
        Self {
            queue,
            spacing,
            loaded_bits: bits_for(engines as u128),
            spacing_bits: bits_for(u128::from(spacing) - 1),
            promised_bits: (queue / engines) as u32,
            place_bits: queue.ilog2(),
        }
    }
}
