//! The head: what it takes from the streams and when, and its sizes.
//!
//! With `valid`, `ready` and `last` those of this clock, N engines, and all registers as they stand
//! before the clock edge:
//! - `first` = not `open`. `full` = `loaded` is N. `fits` = not `waits` and `promised` shows
//!   fewer batches than the queue has room for.
//! - `group_ready` = `has_batch` and (not `group_last` or `fits`). A group is *taken* where
//!   `group_valid` and `group_ready`. Then `open` := not last.
//! - `query_ready` = not `full`, or a first group is taken.
//! - `loaded` := 0 if a first group is taken, else `loaded`; plus 1 if a query is taken.
//! - `has_batch` := `open` or `full`, as they are after this clock: a batch is open or can be
//!   opened.
//! - `spacing` := [`HeadSizes::spacing`] - 1 if a last group is taken; else one less, but not below
//!   0. `waits` := `spacing`, as it is after this clock, is not 0; without [`HeadSizes::has_waits`] it
//!   never is, and there is no such register.
//! - `promised` holds the batches whose last group was taken and whose results were not all read from
//!   the queue's memory, in unary: so many of its lowest bits are 1. One more if a last group is taken;
//!   one less if the last result of a batch is read, which is that at a `read_place` of N - 1 modulo N.
//!   Where a last group may have to wait ([`HeadSizes::has_waits`]), one less a clock later:
//!   `batch_read` := that result is read, and one less if it is set. A single engine has no such
//!   register, because a query of one group each clock would need a place more in the queue.
//! - Entry: what came on the pins, a clock later. The coordinates of query and photons, the
//!   radius, mantissas, exponents and presence (`EntryPresent`) are taken over in every clock;
//!   `EntryTaken` is that a group is taken, `EntryTokenValid` that a query is, `EntryFirst` and
//!   `EntryLast` that a first and that a last group is. Engine 0 gets these: its incoming token,
//!   its photons, and `EntryFirst` as its incoming swap (see below).
//! - Delay line: stage 0 gets, in every clock, from the entry each lane's decoded powers (mantissa <<
//!   exponent); whether its photon is present and the group taken, and beside it, as `DelayAbsent`,
//!   the inverse; and the two flags. Stage i gets stage i - 1, but stage 1 gets powers of 0 where
//!   `DelayAbsent`. The last stage is what engine 0's power hop registers get, so a group's powers are
//!   in that hop register [`Spatial::latency`] clocks after its positions are in theirs.
//! - Queue: where engine 0's `ResultValid` is set, its result is written at `write_place`, which then
//!   counts on, modulo the queue, and `newest_place` := that place. A result is *read* where
//!   `has_waiting` and (not `has_result` or `result_ready`): the word at `read_place` goes to the result
//!   pins, which else stay as they are, and `read_place` counts on. `has_waiting` := a result is
//!   written, or it is set and stays so: not where the result at `newest_place` is read. `has_result` :=
//!   one is read, or it is set and not `result_ready`; `result_valid` = `has_result`. The queue's memory
//!   and the result pins start as 0 and are not reset.
//! - Reset, at the end of the clock in which the pin is set: all registers of the head become 0, but
//!   the words of the entry, `EntryPresent`, `EntryTaken`, `DelayPower`, `DelayPresent`, `DelayAbsent`
//!   and the queue's memory and word do as in any clock. The outputs do not look at the pin.
//!
//! `HasBatch`, `HasWaiting`, `Waits` and the unary `Promised` say what could be found from the others.
//! They are there because each decides, in the same clock, whether a group is taken, and with it what
//! they are in the next: as counters to be compared they were the slowest paths of `stream` and of
//! `tile-8`.
//!
//! # An engine, each clock
//! - `reset_in` is the pin for engine 0 and engine e - 1's `Reset` for engine e; `Reset` := it.
//!   Where `reset_in` is set, `TokenValid`, `NextValid`, `Swap`, `First`, `Last`, `GateFirst`,
//!   `GateLast`, `PairFirst`, `PairLast`, `PairFirstDelay`, `GroupFirst`, `GroupLast`, `GroupLastDelay`,
//!   `SumFirst`, `SumDone`, `Done` and `ResultValid` become 0 with the edge, whatever else is said
//!   below; `ResultValid` also where `Reset` is set, because a result of engine e + 1, which the wave
//!   reaches a clock later, is on its way back.
//! - The incoming token is the query that the head takes for engine 0, and engine e - 1's `Token`
//!   for engine e; the incoming `swap` likewise: a first group taken, or engine e - 1's `Swap`;
//!   `Swap` := incoming swap (cleared as above).
//! - On an incoming swap: `Query` := `Token` where `Keep`, else `Next`; and `Next` is free.
//! - An incoming valid token is kept where `Next` is free or is freed in this clock: `Keep` := 1,
//!   `NextValid` := 1, `TokenValid` := 0. Otherwise it passes: `Keep` := 0, `TokenValid` := 1. Without
//!   a valid token both := 0; `Token` (and its radius) take the incoming words in every clock.
//!   `NextValid` stays, or becomes 0 where it is freed and no token is kept. A reset does not change
//!   what `Keep` becomes.
//! - Where `Keep`, `Next` := `Token`. So what decides whether a token is kept needs only to reach one
//!   register in time, and not all of `Next`.
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
    /// room for all results of its batch, beside those still on their way. So it holds as many as a
    /// query of one group each clock needs to go on without a bubble, which is the latency, since the
    /// result on the pins has left its place; and two batches, so that one can be read while the next
    /// is summed.
    pub queue: usize,
    /// After a last group, the next is taken so many clocks later at the earliest, `2 engines - 1`:
    /// then their results do not meet on the chain.
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
    /// Whether a last group may have to wait for the results of the batch before: those of one engine
    /// never meet.
    pub fn has_waits(&self) -> bool {
        self.spacing > 1
    }

    /// The sizes for a machine.
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
