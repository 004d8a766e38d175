//! The pipelines that machines are made with: their sets of pipeline registers.

use super::{Cut, Cuts, EngineKind};
use crate::formats::Squarer;

/// Pipeline registers at every place but `RangeDelay`, `Decision` and `Gate`: at most one adder or table
/// between two registers.
pub(crate) const FINE: Cuts = Cuts::of(&[
    Cut::Difference,
    Cut::Magnitude,
    Cut::Products,
    Cut::Cross,
    Cut::Square,
    Cut::Pair,
    Cut::Distance,
    Cut::Range,
    Cut::PairPower,
    Cut::GroupPower,
]);

/// Pipeline registers for a chip of many engines, where flip-flops are as scarce as LUTs: at most two adders
/// between two registers, whatever the squarers are made of.
const COARSE: Cuts = Cuts::of(&[
    Cut::Magnitude,
    Cut::Cross,
    Cut::Pair,
    Cut::Distance,
    Cut::Range,
    Cut::PairPower,
    Cut::GroupPower,
]);

/// `COARSE` with a pipeline register between the two adder chains that make a magnitude.
pub(crate) const DIGITS: Cuts = COARSE.and(Cut::Difference);

/// `DIGITS` with an in-range flag beside each sum, and a pipeline register between the lane and these flags.
/// On a full chip the sums of an engine are placed near their chains of powers and results, which may be far
/// from its lanes.
pub(crate) const DECISIONS: Cuts = DIGITS.and(Cut::RangeDelay).and(Cut::Decision);

/// Pipeline registers for standard cells. A register takes the energy of many gates, and more than the adders that it would part. A
/// register at `Magnitude` holds the fewest bits of all places before the sum of squares, and divides the longest path in the middle.
pub(crate) const SHALLOW: Cuts = Cuts::of(&[Cut::Magnitude, Cut::Range]);

/// Engines whose squarers are tables in block RAMs: `DECISIONS` with the block RAM's own output register.
pub(crate) const TABLE: EngineKind = EngineKind {
    squarer: Squarer::Table,
    cuts: DECISIONS.and(Cut::Square),
};

/// `FINE` for a full chip, as `DECISIONS` is `DIGITS` for one.
pub(crate) const FINE_DECISIONS: Cuts = FINE.and(Cut::RangeDelay).and(Cut::Decision);

/// Engines of such a chip whose squarers are tables in block RAMs: one register on the net to the block, and one on
/// that from it.
pub(crate) const FINE_TABLE: EngineKind = EngineKind {
    squarer: Squarer::Table,
    cuts: TABLE.cuts.and(Cut::SquareDelay),
};

/// Engines whose squarers are DSP blocks: the DSP block's own registers stand before and behind the product
/// (behind it at the cut `Cross`), and one more register on each net to and from the block. DSP blocks stand
/// in a few rows of the chip, and the products of two of them meet at one adder.
pub(crate) const PRODUCT: EngineKind = EngineKind {
    squarer: Squarer::Product,
    cuts: DECISIONS.and(Cut::Products).and(Cut::Square),
};

/// Engines of leaf machines. Several such machines share a device, where LUTs, flip-flops and the nets of full
/// regions are scarce alike: between two registers there are at most two carry chains, or one and a comparison in LUTs.
pub(crate) const LEAF: Cuts = Cuts::of(&[
    Cut::Magnitude,
    Cut::Cross,
    Cut::Pair,
    Cut::Range,
    Cut::GroupPower,
]);

/// Engines of leaf machines whose squarers are DSP blocks, and the comparison of boxes. The DSP block's registers stand before and
/// behind the product, and one holds the difference: a net to a DSP block is long, and on half steps an adder stands before it.
pub(crate) const LEAF_PRODUCT: EngineKind = EngineKind {
    squarer: Squarer::Product,
    cuts: Cuts::of(&[
        Cut::Difference,
        Cut::Products,
        Cut::Cross,
        Cut::Pair,
        Cut::Range,
        Cut::GroupPower,
    ]),
};

/// Engines of leaf machines whose squarers are tables in block RAMs: `LEAF` with the block RAM's own output register.
pub(crate) const LEAF_TABLE: EngineKind = EngineKind {
    squarer: Squarer::Table,
    cuts: LEAF.and(Cut::Square),
};
