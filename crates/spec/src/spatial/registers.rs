//! The registers of a spatial machine, one row each.

use super::cuts::Cut;
use super::widths::SpatialWidths;
use super::{EngineKind, Radius, Spatial};
use crate::format::Squarer;

/// A register of an engine.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EngineRegister {
    /// The wave of a reset.
    Reset,
    /// A query passes by.
    TokenValid,
    /// Its coordinates.
    Token,
    /// Its squared search radius.
    TokenRadius,
    /// There is a query for the next batch.
    NextValid,
    /// It came in the clock before: it is the token that stands in `Token`.
    Keep,
    /// Its coordinates, a clock after it came.
    Next,
    /// Its squared search radius.
    NextRadius,
    /// The query's coordinates.
    Query,
    /// Its squared search radius.
    QueryRadius,
    /// The radius follows the photons that it is for: one at each cut from `Difference` to
    /// `Distance`.
    RadiusDelay,
    /// Hop: the group whose positions arrive is the first of its batch, and the query changes.
    Swap,
    /// Hop: the coordinates of the photons.
    Photon,
    /// d = query - photon.
    Difference,
    /// |d|, for squares from digits.
    Magnitude,
    /// d once more, for other squares.
    MagnitudeDelay,
    /// |d| modulo 2^r.
    ProductsMagnitude,
    /// The high digit times the two lowest bits of the low one.
    LowProduct,
    /// The high digit times the other bits of the low one.
    HighProduct,
    /// |d| exceeds r bits.
    ProductsFar,
    /// d once more, for other squares.
    ProductsDelay,
    /// |d| modulo 2^r.
    CrossMagnitude,
    /// The product of the digits.
    Cross,
    /// |d| exceeds r bits.
    CrossFar,
    /// d^2 modulo 2^(2 r) from a table, and above it whether |d| exceeds r bits.
    Lookup,
    /// d^2 as one product, in full.
    Product,
    /// d^2 modulo 2^(2 r); from digits the square of |d| modulo 2^r, which is another number where
    /// |d| exceeds r bits, and counts for nothing there.
    Square,
    /// |d| exceeds r bits.
    SquareFar,
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
    /// The same, while it waits for the slowest kind of engine: of lane g after i + 1 clocks at
    /// 4 i + g.
    RangeWait,
    /// The same once more, between the lane and the sums.
    RangeDelay,
    /// The same once more, for each power.
    Decision,
    /// The same for each photon's presence.
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
    /// `First` once more.
    GateFirst,
    /// `Last` once more.
    GateLast,
    /// Sums over photons 0 and 1, and over 2 and 3.
    PairPower,
    /// How many of those are in range.
    PairCount,
    /// `First` once more.
    PairFirst,
    /// `Last` once more.
    PairLast,
    /// `PairFirst` once more for each channel, on its way to `SumFirst`.
    PairFirstDelay,
    /// Sums over the group.
    GroupPower,
    /// How many of the group are in range.
    GroupCount,
    /// `First` once more.
    GroupFirst,
    /// `Last` once more.
    GroupLast,
    /// `GroupLast` once more for each channel, on its way to `SumDone`.
    GroupLastDelay,
    /// `GroupFirst` once more for each channel's sum.
    SumFirst,
    /// The sums of the query so far; a first group replaces them.
    Sum,
    /// The photons in range so far.
    Count,
    /// The sums are complete.
    Done,
    /// The same once more for each channel's sum.
    SumDone,
    /// The result chain has a result here: this engine's, or one from further on.
    ResultValid,
    /// Its sums.
    Result,
    /// Its count.
    ResultCount,
}

/// How many of a register an engine has, and in which order.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Instances {
    /// One.
    One,
    /// One for x, y, z.
    Axes,
    /// Axis a of lane g is at 3 g + a.
    Coordinates,
    /// One for each lane.
    Lanes,
    /// Channel c of lane g is at `channels` g + c.
    LaneChannels,
    /// Lanes 0 and 1, lanes 2 and 3.
    Pairs,
    /// Channel c of pair i is at `channels` i + c.
    PairChannels,
    /// One for each channel.
    Channels,
    /// One for each cut from `Difference` to `Distance` that the engine has.
    RadiusDelays,
    /// One for each lane and clock of [`Spatial::range_waits`].
    RangeWaits,
}

/// One row of the table of an engine's registers.
#[derive(Copy, Clone, Debug)]
pub struct EngineRow {
    /// The register.
    pub register: EngineRegister,
    /// Its name in pins and in the emitted Verilog.
    pub name: &'static str,
    /// How many there are.
    pub instances: Instances,
    /// The width of each in bits.
    pub width: fn(&SpatialWidths) -> u32,
    /// When a machine, or an engine of it, has the register.
    condition: Condition,
}

#[derive(Copy, Clone, Debug)]
enum Condition {
    Always,
    /// Queries have a radius of their own.
    QueryRadius,
    At(Cut),
    /// At the cut in engines with squarers of this kind.
    Squarer(Cut, Squarer),
    /// At the cut in engines with squarers of another kind.
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
    /// The register's row.
    pub fn row(self) -> &'static EngineRow {
        &ENGINE_REGISTERS[self as usize]
    }
}

impl Instances {
    /// How many there are in an engine of that kind, with so many channels.
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

    /// What tells one from the others in names: empty for one, `_x`, `_x_2` (axis, lane), `_2`,
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
    /// Queries taken for the next batch.
    Loaded,
    /// A batch has begun and its last group is still to come.
    Open,
    /// A batch is open or can be opened: what `Open` and `Loaded` say, as one bit.
    HasBatch,
    /// Clocks until a last group may be taken.
    Spacing,
    /// They are not 0: what `Spacing` says, as one bit.
    Waits,
    /// The last result of a batch was read from the queue's memory.
    BatchRead,
    /// Batches whose results have places in the queue's memory and were not all read, in unary.
    Promised,
    /// The place in the queue that the next result goes to.
    WritePlace,
    /// The place that the newest result went to.
    NewestPlace,
    /// The place in the queue of the result that is read next.
    ReadPlace,
    /// The queue's memory holds results that were not read.
    HasWaiting,
    /// The result on the pins is one.
    HasResult,
    /// A query was taken.
    EntryTokenValid,
    /// Its coordinates.
    EntryToken,
    /// Its squared search radius; where queries have one.
    EntryRadius,
    /// The coordinates of the photons: axis a of lane g is at 3 g + a.
    EntryPhoton,
    /// Their mantissas: channel c of lane g is at `channels` g + c.
    EntryPower,
    /// Their exponent, for each lane; where photons have one.
    EntryExponent,
    /// Whether there is a photon on the pins, for each lane.
    EntryPresent,
    /// It is of a group that was taken.
    EntryTaken,
    /// A first group was taken.
    EntryFirst,
    /// A last group was taken.
    EntryLast,
    /// The delay line of the powers, one for each stage, lane and channel: channel c of lane g in
    /// stage i is at (4 i + g) `channels` + c. Stage 0 is nearest to the entry; there are
    /// [`Spatial::latency`] stages.
    DelayPower,
    /// Whether there is a photon of a taken group: lane g in stage i is at 4 i + g.
    DelayPresent,
    /// There is none, beside stage 0, for each lane: its powers are cleared. At power-up, when there
    /// is nothing to clear, 0 too.
    DelayAbsent,
    /// The same for the first group's flag, one for each stage.
    DelayFirst,
    /// The same for the last group's flag.
    DelayLast,
}

impl HeadRegister {
    /// All of them, in order.
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

    /// Its name in pins and in the emitted Verilog.
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
    Photon "photon" Coordinates |w| w.coordinate, Always;
    Difference "difference" Coordinates |w| w.difference, At(Cut::Difference);
    Magnitude "magnitude" Coordinates |w| w.coordinate, Condition::Squarer(Cut::Magnitude, Digits);
    MagnitudeDelay "magnitude_delay" Coordinates |w| w.difference,
        NotSquarer(Cut::Magnitude, Digits);
    ProductsMagnitude "products_magnitude" Coordinates |w| w.radius,
        Condition::Squarer(Cut::Products, Digits);
    LowProduct "low_product" Coordinates |w| w.low_product,
        Condition::Squarer(Cut::Products, Digits);
    HighProduct "high_product" Coordinates |w| w.high_product,
        Condition::Squarer(Cut::Products, Digits);
    ProductsFar "products_far" Coordinates |_| 1, Condition::Squarer(Cut::Products, Digits);
    ProductsDelay "products_delay" Coordinates |w| w.difference, NotSquarer(Cut::Products, Digits);
    CrossMagnitude "cross_magnitude" Coordinates |w| w.radius,
        Condition::Squarer(Cut::Cross, Digits);
    Cross "cross" Coordinates |w| w.cross, Condition::Squarer(Cut::Cross, Digits);
    CrossFar "cross_far" Coordinates |_| 1, Condition::Squarer(Cut::Cross, Digits);
    Lookup "lookup" Coordinates |w| w.square + 1, Condition::Squarer(Cut::Cross, Table);
    Product "product" Coordinates |w| w.product, Condition::Squarer(Cut::Cross, Product);
    Square "square" Coordinates |w| w.square, At(Cut::Square);
    SquareFar "square_far" Coordinates |_| 1, At(Cut::Square);
    PairSquare "pair_square" Lanes |w| w.pair, At(Cut::Pair);
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
    PairPower "pair_power" PairChannels |w| w.pair_power, At(Cut::PairPower);
    PairCount "pair_count" Pairs |_| SpatialWidths::PAIR_COUNT, At(Cut::PairPower);
    PairFirst "pair_first" One |_| 1, At(Cut::PairPower);
    PairLast "pair_last" One |_| 1, At(Cut::PairPower);
    PairFirstDelay "pair_first_delay" Channels |_| 1, At(Cut::RangeDelay);
    GroupPower "group_power" Channels |w| w.group_power, At(Cut::GroupPower);
    GroupCount "group_count" One |_| SpatialWidths::GROUP_COUNT, At(Cut::GroupPower);
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
