//! The registers of a spatial machine, one row each.

use super::cuts::Cut;
use super::{EngineKind, Radius, Spatial};
use crate::formats::{Squarer, Widths};

/// A register of an engine.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EngineRegister {
    /// The reset, as it passes from engine to engine.
    Reset,
    /// `Token` holds a query that passes this engine.
    TokenValid,
    /// The coordinates of the passing query.
    Token,
    /// The squared search radius of the passing query.
    TokenRadius,
    /// The engine has a query for the next batch.
    NextValid,
    /// The next query arrived in the clock before and is still in `Token`.
    Keep,
    /// The coordinates of the next query, one clock after it arrived.
    Next,
    /// The squared search radius of the next query.
    NextRadius,
    /// The coordinates of the current query.
    Query,
    /// The squared search radius of the current query.
    QueryRadius,
    /// The radius, delayed to stay beside the photons that it is for: one register at each place from
    /// `Difference` to `Distance`.
    RadiusDelay,
    /// Hop: the group whose positions arrive is the first of its batch, and the query changes.
    Swap,
    /// Hop: the coordinates of the photons.
    Photon,
    /// d = query - photon.
    Difference,
    /// |d|, for squares from digits.
    Magnitude,
    /// d, one clock after `Difference`, for squarers that need no magnitude.
    MagnitudeDelay,
    /// |d| modulo 2^r.
    ProductsMagnitude,
    /// The high digit times the two lowest bits of the low one.
    LowProduct,
    /// The high digit times the other bits of the low one.
    HighProduct,
    /// |d| exceeds r bits.
    ProductsFar,
    /// d, at the place `Products`, for squarers that need no magnitude.
    ProductsDelay,
    /// |d| modulo 2^r.
    CrossMagnitude,
    /// The product of the digits.
    Cross,
    /// |d| exceeds r bits.
    CrossFar,
    /// d^2 modulo 2^(2 r) from a table, and above it whether |d| exceeds r bits.
    Lookup,
    /// d^2 as one product, in full; on half steps d (d + 1).
    Product,
    /// d^2 modulo 2^(2 r); on half steps d (d + 1) modulo 2^(2 r). A squarer from digits gives the square of |d| modulo 2^r, which is a different
    /// number where |d| exceeds r bits; the number is then unused.
    Square,
    /// |d| exceeds r bits.
    SquareFar,
    /// `Square`, one clock later.
    SquareDelay,
    /// `SquareFar`, one clock later.
    SquareFarDelay,
    /// x^2 + y^2.
    PairSquare,
    /// z^2.
    PairZ,
    /// Some |d| exceeds r bits.
    PairFar,
    /// x^2 + y^2 + z^2.
    Distance,
    /// Some |d| exceeds r bits.
    DistanceFar,
    /// The photon is in range: no axis far and distance <= `radius_sq`.
    InRange,
    /// In-range flag of an engine that is faster than the slowest kind, during its wait: that of lane g after
    /// i + 1 clocks is at 4 i + g.
    RangeWait,
    /// In-range flag, one clock later, between the lane and the sums.
    RangeDelay,
    /// In-range flag, one copy beside the sums for each lane and channel.
    Decision,
    /// In-range flag, one copy beside the count for each lane.
    PresenceDecision,
    /// Hop: the decoded powers of the photons, 0 for an absent one.
    Power,
    /// Hop: whether there is a photon.
    Present,
    /// Hop: the group is the first of its batch.
    First,
    /// Hop: the group is the last of its batch.
    Last,
    /// The powers of photons in range.
    GatedPower,
    /// Whether there is a photon in range.
    GatedPresent,
    /// `First`, at the place `Gate`.
    GateFirst,
    /// `Last`, at the place `Gate`.
    GateLast,
    /// Sums over photons 0 and 1, and over 2 and 3.
    PairPower,
    /// The photons in range of each pair.
    PairCount,
    /// `First`, at the place `PairPower`.
    PairFirst,
    /// `Last`, at the place `PairPower`.
    PairLast,
    /// `PairFirst` one clock later, one copy for each channel, on its way to `SumFirst`.
    PairFirstDelay,
    /// Sums over the group.
    GroupPower,
    /// The photons of the group that are in range.
    GroupCount,
    /// `First`, at the place `GroupPower`.
    GroupFirst,
    /// `Last`, at the place `GroupPower`.
    GroupLast,
    /// `GroupLast` one clock later, one copy for each channel, on its way to `SumDone`.
    GroupLastDelay,
    /// `GroupFirst` one clock later, one copy beside each channel's sum.
    SumFirst,
    /// The sums of the query so far; a first group replaces them.
    Sum,
    /// The photons in range of the query so far; a first group replaces the count.
    Count,
    /// The sums are complete.
    Done,
    /// `Done`, one copy beside each channel's sum.
    SumDone,
    /// `Result` holds a result: this engine's, or one from further along the chain.
    ResultValid,
    /// The sums on the result chain.
    Result,
    /// The count on the result chain.
    ResultCount,
}

/// The number of instances of a register in an engine, and their order.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Instances {
    /// One instance.
    One,
    /// One instance for each of x, y, z.
    Axes,
    /// Axis a of lane g is at 3 g + a.
    Coordinates,
    /// One instance for each lane.
    Lanes,
    /// Channel c of lane g is at `channels` g + c.
    LaneChannels,
    /// Two instances: lanes 0 and 1, lanes 2 and 3.
    Pairs,
    /// Channel c of pair i is at `channels` i + c.
    PairChannels,
    /// One instance for each channel.
    Channels,
    /// One instance for each place from `Difference` to `Distance` at which the engine has a register.
    RadiusDelays,
    /// One instance for each lane and each clock of [`Spatial::range_waits`].
    RangeWaits,
}

/// One row of the table of an engine's registers.
#[derive(Copy, Clone, Debug)]
pub struct EngineRow {
    /// The register that the row describes.
    pub register: EngineRegister,
    /// The register's name in pins and in the emitted Verilog.
    pub name: &'static str,
    /// The number of instances and their order.
    pub instances: Instances,
    /// The width of each instance in bits.
    pub width: fn(&Widths) -> u32,
    /// The machines and engines that have the register.
    condition: Condition,
}

#[derive(Copy, Clone, Debug)]
enum Condition {
    Always,
    /// In machines whose queries have a radius of their own.
    QueryRadius,
    At(Cut),
    /// At this place, in engines with squarers of this kind.
    Squarer(Cut, Squarer),
    /// At this place, in engines with squarers of another kind.
    NotSquarer(Cut, Squarer),
}

impl EngineRow {
    /// Whether an engine of that kind has the register.
    pub fn is_in(&self, spatial: &Spatial, kind: EngineKind) -> bool {
        let EngineKind { squarer, cuts } = kind;
        let has = |cut| cuts.has(cut);
        match self.condition {
            Condition::Always => true,
            Condition::QueryRadius => spatial.radius == Radius::Query,
            Condition::At(cut) => has(cut),
            Condition::Squarer(cut, kind) => has(cut) && squarer == kind,
            Condition::NotSquarer(cut, kind) => has(cut) && squarer != kind,
        }
    }
}

impl EngineRegister {
    /// The register's row in [`ENGINE_REGISTERS`].
    pub fn row(self) -> &'static EngineRow {
        &ENGINE_REGISTERS[self as usize]
    }
}

impl Instances {
    /// The number of instances in an engine of that kind, for that number of channels.
    pub fn count(self, spatial: &Spatial, kind: EngineKind, channels: usize) -> usize {
        match self {
            Self::One => 1,
            Self::Axes => 3,
            Self::Coordinates => 3 * Spatial::LANES,
            Self::Lanes => Spatial::LANES,
            Self::LaneChannels => channels * Spatial::LANES,
            Self::Pairs => Spatial::LANES / 2,
            Self::PairChannels => channels * Spatial::LANES / 2,
            Self::Channels => channels,
            Self::RadiusDelays => {
                let before_range = Cut::ALL.into_iter().take_while(|&cut| cut < Cut::Range);
                before_range.filter(|&cut| kind.cuts.has(cut)).count()
            }
            Self::RangeWaits => spatial.range_waits(kind) as usize * Spatial::LANES,
        }
    }

    /// The suffix of an instance in names: empty for a single instance, `_x`, `_x_2` (axis, lane), `_2`,
    /// `_red_2` (channel, lane or pair), `_red`.
    pub fn suffix(self, index: usize, channels: &[&str]) -> String {
        const AXES: [&str; 3] = ["x", "y", "z"];
        match self {
            Self::One => String::new(),
            Self::Axes => format!("_{}", AXES[index]),
            Self::Coordinates => format!("_{}_{}", AXES[index % 3], index / 3),
            Self::Lanes | Self::Pairs | Self::RadiusDelays | Self::RangeWaits => {
                format!("_{index}")
            }
            Self::LaneChannels | Self::PairChannels => {
                let count = channels.len();
                format!("_{}_{}", channels[index % count], index / count)
            }
            Self::Channels => format!("_{}", channels[index]),
        }
    }
}

/// A register of the head.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum HeadRegister {
    /// The number of queries taken for the next batch.
    Loaded,
    /// A batch has begun, and its last group has not been taken.
    Open,
    /// A batch is open or can be opened. The bit follows from `Open` and `Loaded`.
    HasBatch,
    /// Clocks until a last group may be taken.
    Spacing,
    /// A last group must wait: `Spacing` is not 0.
    Waits,
    /// The last result of a batch was read from the queue's memory.
    BatchRead,
    /// The number, in unary, of batches whose results have places in the queue's memory and were not all
    /// read.
    Promised,
    /// The place in the queue that the next result goes to.
    WritePlace,
    /// The place that the newest result went to.
    NewestPlace,
    /// The place in the queue of the result that is read next.
    ReadPlace,
    /// The queue's memory holds results that were not read.
    HasWaiting,
    /// The result pins hold a result.
    HasResult,
    /// A query was taken in the clock before.
    EntryTokenValid,
    /// The coordinates of the query.
    EntryToken,
    /// The squared search radius of the query; where queries have one.
    EntryRadius,
    /// The coordinates of the photons: axis a of lane g is at 3 g + a.
    EntryPhoton,
    /// The mantissas of the photons: channel c of lane g is at `channels` g + c.
    EntryPower,
    /// The exponent of each lane's photon; where photons have one.
    EntryExponent,
    /// Whether there is a photon on the pins, for each lane.
    EntryPresent,
    /// The photons in the entry belong to a group that was taken.
    EntryTaken,
    /// A first group was taken.
    EntryFirst,
    /// A last group was taken.
    EntryLast,
    /// The delay line of the powers, one register for each stage, lane and channel: channel c of lane g in
    /// stage i is at (4 i + g) `channels` + c. Stage 0 is nearest to the entry; there are
    /// [`Spatial::latency`] stages.
    DelayPower,
    /// The delay line of presence, whether there is a photon of a taken group: lane g in stage i is at 4 i +
    /// g.
    DelayPresent,
    /// The inverse of `DelayPresent` at stage 0, for each lane; it clears the lane's powers. At power-up it
    /// is 0 too, since there is nothing to clear.
    DelayAbsent,
    /// The delay line of the first group's flag, one register for each stage.
    DelayFirst,
    /// The delay line of the last group's flag, one register for each stage.
    DelayLast,
}

impl HeadRegister {
    /// All registers of the head, in their order as signals.
    pub const ALL: [Self; 27] = [
        Self::Loaded,
        Self::Open,
        Self::HasBatch,
        Self::Spacing,
        Self::Waits,
        Self::BatchRead,
        Self::Promised,
        Self::WritePlace,
        Self::NewestPlace,
        Self::ReadPlace,
        Self::HasWaiting,
        Self::HasResult,
        Self::EntryTokenValid,
        Self::EntryToken,
        Self::EntryRadius,
        Self::EntryPhoton,
        Self::EntryPower,
        Self::EntryExponent,
        Self::EntryPresent,
        Self::EntryTaken,
        Self::EntryFirst,
        Self::EntryLast,
        Self::DelayPower,
        Self::DelayPresent,
        Self::DelayAbsent,
        Self::DelayFirst,
        Self::DelayLast,
    ];

    /// The register's name in pins and in the emitted Verilog.
    pub fn name(self) -> &'static str {
        match self {
            Self::Loaded => "loaded",
            Self::Open => "open",
            Self::HasBatch => "has_batch",
            Self::Spacing => "spacing",
            Self::Waits => "waits",
            Self::BatchRead => "batch_read",
            Self::Promised => "promised",
            Self::WritePlace => "write_place",
            Self::NewestPlace => "newest_place",
            Self::ReadPlace => "read_place",
            Self::HasWaiting => "has_waiting",
            Self::HasResult => "has_result",
            Self::EntryTokenValid => "entry_token_valid",
            Self::EntryToken => "entry_token",
            Self::EntryRadius => "entry_radius_sq",
            Self::EntryPhoton => "entry_photon",
            Self::EntryPower => "entry_power",
            Self::EntryExponent => "entry_exponent",
            Self::EntryPresent => "entry_present",
            Self::EntryTaken => "entry_taken",
            Self::EntryFirst => "entry_first",
            Self::EntryLast => "entry_last",
            Self::DelayPower => "delay_power",
            Self::DelayPresent => "delay_present",
            Self::DelayAbsent => "delay_absent",
            Self::DelayFirst => "delay_first",
            Self::DelayLast => "delay_last",
        }
    }
}

macro_rules! rows {
    ($($register:ident $name:literal $instances:ident $width:expr, $condition:expr;)+) => {
        /// The registers of an engine, one row each, in the order of [`EngineRegister`].
        pub const ENGINE_REGISTERS: &[EngineRow] = &[$(EngineRow {
            register: EngineRegister::$register,
            name: $name,
            instances: Instances::$instances,
            width: $width,
            condition: $condition,
        },)+];
    };
}

use Condition::{Always, At, NotSquarer, QueryRadius};
use Squarer::{Digits, Product, Table};

rows! {
    Reset "reset" One |_| 1, Always;
    TokenValid "token_valid" One |_| 1, Always;
    Token "token" Axes |w| w.coordinate, Always;
    TokenRadius "token_radius_sq" One |w| w.radius_sq, QueryRadius;
    NextValid "next_valid" One |_| 1, Always;
    Keep "keep" One |_| 1, Always;
    Next "next" Axes |w| w.coordinate, Always;
    NextRadius "next_radius_sq" One |w| w.radius_sq, QueryRadius;
    Query "query" Axes |w| w.coordinate, Always;
    QueryRadius "query_radius_sq" One |w| w.radius_sq, QueryRadius;
    RadiusDelay "radius_sq_delay" RadiusDelays |w| w.radius_sq, QueryRadius;
    Swap "swap" One |_| 1, Always;
    Photon "photon" Coordinates |w| w.photon, Always;
    Difference "difference" Coordinates |w| w.signed_difference(), At(Cut::Difference);
    Magnitude "magnitude" Coordinates |w| w.coordinate, Condition::Squarer(Cut::Magnitude, Digits);
    MagnitudeDelay "magnitude_delay" Coordinates |w| w.signed_difference(),
        NotSquarer(Cut::Magnitude, Digits);
    ProductsMagnitude "products_magnitude" Coordinates |w| w.difference,
        Condition::Squarer(Cut::Products, Digits);
    LowProduct "low_product" Coordinates |w| w.low_product(),
        Condition::Squarer(Cut::Products, Digits);
    HighProduct "high_product" Coordinates |w| w.high_product(),
        Condition::Squarer(Cut::Products, Digits);
    ProductsFar "products_far" Coordinates |_| 1, Condition::Squarer(Cut::Products, Digits);
    ProductsDelay "products_delay" Coordinates |w| w.signed_difference(), NotSquarer(Cut::Products, Digits);
    CrossMagnitude "cross_magnitude" Coordinates |w| w.difference,
        Condition::Squarer(Cut::Cross, Digits);
    Cross "cross" Coordinates |w| w.cross(), Condition::Squarer(Cut::Cross, Digits);
    CrossFar "cross_far" Coordinates |_| 1, Condition::Squarer(Cut::Cross, Digits);
    Lookup "lookup" Coordinates |w| w.square + 1, Condition::Squarer(Cut::Cross, Table);
    Product "product" Coordinates |w| w.product(), Condition::Squarer(Cut::Cross, Product);
    Square "square" Coordinates |w| w.square, At(Cut::Square);
    SquareFar "square_far" Coordinates |_| 1, At(Cut::Square);
    SquareDelay "square_delay" Coordinates |w| w.square, At(Cut::SquareDelay);
    SquareFarDelay "square_far_delay" Coordinates |_| 1, At(Cut::SquareDelay);
    PairSquare "pair_square" Lanes |w| w.pair(), At(Cut::Pair);
    PairZ "pair_z" Lanes |w| w.square, At(Cut::Pair);
    PairFar "pair_far" Lanes |_| 1, At(Cut::Pair);
    Distance "distance" Lanes |w| w.distance, At(Cut::Distance);
    DistanceFar "distance_far" Lanes |_| 1, At(Cut::Distance);
    InRange "in_range" Lanes |_| 1, At(Cut::Range);
    RangeWait "range_wait" RangeWaits |_| 1, Always;
    RangeDelay "range_delay" Lanes |_| 1, At(Cut::RangeDelay);
    Decision "decision" LaneChannels |_| 1, At(Cut::Decision);
    PresenceDecision "presence_decision" Lanes |_| 1, At(Cut::Decision);
    Power "power" LaneChannels |w| w.power, Always;
    Present "present" Lanes |_| 1, Always;
    First "first" One |_| 1, Always;
    Last "last" One |_| 1, Always;
    GatedPower "gated_power" LaneChannels |w| w.power, At(Cut::Gate);
    GatedPresent "gated_present" Lanes |_| 1, At(Cut::Gate);
    GateFirst "gate_first" One |_| 1, At(Cut::Gate);
    GateLast "gate_last" One |_| 1, At(Cut::Gate);
    PairPower "pair_power" PairChannels |w| w.pair_power(), At(Cut::PairPower);
    PairCount "pair_count" Pairs |_| Widths::PAIR_COUNT, At(Cut::PairPower);
    PairFirst "pair_first" One |_| 1, At(Cut::PairPower);
    PairLast "pair_last" One |_| 1, At(Cut::PairPower);
    PairFirstDelay "pair_first_delay" Channels |_| 1, At(Cut::RangeDelay);
    GroupPower "group_power" Channels |w| w.group_power(), At(Cut::GroupPower);
    GroupCount "group_count" One |_| Widths::GROUP_COUNT, At(Cut::GroupPower);
    GroupFirst "group_first" One |_| 1, At(Cut::GroupPower);
    GroupLast "group_last" One |_| 1, At(Cut::GroupPower);
    GroupLastDelay "group_last_delay" Channels |_| 1, At(Cut::RangeDelay);
    SumFirst "sum_first" Channels |_| 1, At(Cut::Decision);
    Sum "sum" Channels |w| w.sum, Always;
    Count "count" One |w| w.count, Always;
    Done "done" One |_| 1, Always;
    SumDone "sum_done" Channels |_| 1, At(Cut::Decision);
    ResultValid "result_valid" One |_| 1, Always;
    Result "result" Channels |w| w.sum, Always;
    ResultCount "result_count" One |w| w.count, Always;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_enum() {
        for (index, row) in ENGINE_REGISTERS.iter().enumerate() {
            assert_eq!(row.register as usize, index);
        }
        for (index, register) in HeadRegister::ALL.into_iter().enumerate() {
            assert_eq!(register as usize, index);
        }
    }
}
