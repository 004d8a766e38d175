//! The registers of a leaf machine before its chain of engines, one row each.

use super::{Leaf, LeafSizes};
use crate::formats::Widths;
use crate::spatial::Spatial;

/// The values that the widths and numbers of registers follow from.
pub struct Dimensions {
    pub(super) sizes: LeafSizes,
    pub(super) widths: Widths,
    pub(super) channels: usize,
}

impl Dimensions {
    fn exponents(&self) -> usize {
        if self.widths.exponent == 0 { 0 } else { LANES }
    }

    fn culls(&self) -> usize {
        self.sizes.cull_clocks as usize
    }
}

/// A row of the table of registers.
pub struct LeafRow {
    /// The register.
    pub register: LeafRegister,
    /// The register's name in pins.
    pub name: &'static str,
    /// The number of such registers.
    pub(super) count: fn(&Dimensions) -> usize,
    /// Bits of each.
    pub(super) width: fn(&Dimensions) -> u32,
}

const LANES: usize = Spatial::LANES;
const AXES: usize = 3;

macro_rules! registers {
    ($($(#[doc = $doc:literal])+ $register:ident $name:literal [$count:expr] $width:expr;)+) => {
        /// A register of a leaf machine before its chain.
        ///
        /// All registers have the values before the clock edge, and `:=` gives the value after it. A register keeps its
        /// value where no rule gives it another. A reset sets these to 0 and no other: `FillBank`, `FillPlace`,
        /// `FillReady`, `Filled`, `WriteValid`, `HalfValid`, `GroupValid`, `BoxValid`, `Full`, `Loaded`, `Closed`, `Starting`,
        /// `Started`, `Scanning`, `ScanBank`, `Used`, `Returned`, `LookValid`, `FoundValid`, `CullValid`, `QueueWrite`, `QueueRead`,
        /// `QueueCount`, `EntryValid`, `Spacing`, `MayEnd`, `Outstanding`, `ReadValid`, `WordValid`, `TagWrite`, `TagRead`,
        /// `HasOldest`, `TagResult`.
        #[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum LeafRegister {
            $($(#[doc = $doc])+ $register,)+
        }

        impl LeafRow {
            /// All registers, in their order as signals.
            pub const ALL: &[Self] = &[$(Self {
                register: LeafRegister::$register,
                name: $name,
                count: $count,
                width: $width,
            },)+];
        }
    };
}

registers! {
    /// The bank that groups are read into.
    FillBank "fill_bank" [|_| 1] |_| 1;
    /// The place in `FillBank` of the next group. A group is *taken* where `group_valid` and `FillReady`: `FillPlace` is then
    /// incremented. The group is the *last* where `group_last` or `FillPlace` is all ones: `FillPlace` := 0, `FillBank` := the
    /// other, `Filled` of the bank := 1.
    FillPlace "fill_place" [|_| 1] |d| d.sizes.place;
    /// `group_ready`. := `Filled` of `FillBank` is 0, and no last group is taken.
    FillReady "fill_ready" [|_| 1] |_| 1;
    /// For each bank, whether it holds a set that is complete or being played. := 0 where the bank is *freed*: the last
    /// group of a batch is played with `EntryRelease`, from bank `EntryBank`.
    Filled "filled" [|_| 2] |_| 1;
    /// A group was taken in the clock before. Its words are written to the memory at the edge.
    WriteValid "write_valid" [|_| 1] |_| 1;
    /// := `FillBank`, in every clock.
    WriteBank "write_bank" [|_| 1] |_| 1;
    /// := `FillPlace`, in every clock.
    WritePlace "write_place" [|_| 1] |d| d.sizes.place;
    /// := a last group is taken.
    WriteLast "write_last" [|_| 1] |_| 1;
    /// := `group_facing`, in every clock.
    WriteFacing "write_facing" [|_| 1] |_| Leaf::FACING_BITS;
    /// The pins of the group, in every clock: whether there is a photon, for each lane.
    WritePresent "write_present" [|_| LANES] |_| 1;
    /// The pins of the group, in every clock: axis a of lane g is at 3 g + a.
    WritePosition "write_position" [|_| AXES * LANES] |d| d.widths.photon;
    /// The pins of the group, in every clock: channel c of lane g is at `channels` g + c.
    WritePower "write_power" [|d| d.channels * LANES] |d| d.widths.mantissa;
    /// The pins of the group, in every clock: the exponent of each lane, where photons have one.
    WriteExponent "write_exponent" [Dimensions::exponents] |d| d.widths.exponent;
    /// := `WriteValid`. The stages `Half` and `Group` find the box around a group, and `Box` holds those of a leaf.
    HalfValid "half_valid" [|_| 1] |_| 1;
    /// := `WriteBank`.
    HalfBank "half_bank" [|_| 1] |_| 1;
    /// := `WritePlace`.
    HalfPlace "half_place" [|_| 1] |d| d.sizes.place;
    /// := `WriteLast`.
    HalfLast "half_last" [|_| 1] |_| 1;
    /// := `WriteFacing`.
    HalfFacing "half_facing" [|_| 1] |_| Leaf::FACING_BITS;
    /// The lower coordinate of the photons in lanes 0 and 1, and in lanes 2 and 3, in every clock: axis a of half h is at
    /// 3 h + a. An absent photon counts with all ones.
    HalfLow "half_low" [|_| 2 * AXES] |d| d.widths.photon;
    /// The higher coordinate of these photons. An absent photon counts with 0.
    HalfHigh "half_high" [|_| 2 * AXES] |d| d.widths.photon;
    /// := `HalfValid`.
    GroupValid "group_valid" [|_| 1] |_| 1;
    /// := `HalfBank`.
    GroupBank "group_bank" [|_| 1] |_| 1;
    /// := `HalfPlace`.
    GroupPlace "group_place" [|_| 1] |d| d.sizes.place;
    /// := `HalfLast`.
    GroupLast "group_last" [|_| 1] |_| 1;
    /// := `HalfFacing`.
    GroupFacing "group_facing" [|_| 1] |_| Leaf::FACING_BITS;
    /// The lower of the two `HalfLow` of an axis, in every clock.
    GroupLow "group_low" [|_| AXES] |d| d.widths.photon;
    /// The higher of the two `HalfHigh` of an axis, in every clock.
    GroupHigh "group_high" [|_| AXES] |d| d.widths.photon;
    /// := `GroupValid`, and `GroupPlace` is odd or `GroupLast`: a leaf is complete. Where `BoxValid`, `BoxLow` and `BoxHigh` are
    /// written to the boxes at the edge: to those of leaf `BoxLeaf`, and where that is even, also to those of the next leaf, so that the
    /// boxes of a pair are never undefined. `BoxFacing` and `BoxShort` are written for both leaves of the pair.
    BoxValid "box_valid" [|_| 1] |_| 1;
    /// := `GroupBank`.
    BoxBank "box_bank" [|_| 1] |_| 1;
    /// := `GroupPlace` / 2.
    BoxLeaf "box_leaf" [|_| 1] |d| d.sizes.leaf;
    /// := `GroupLast`.
    BoxLast "box_last" [|_| 1] |_| 1;
    /// For each leaf of the pair, whether it has one group. Where `GroupValid`: that of the second leaf := `GroupPlace` is even; that of the
    /// first too if the group is one of the first leaf, as `GroupPlace` / 2 is even.
    BoxShort "box_short" [|_| Leaf::PAIR] |_| 1;
    /// For each leaf of the pair, `GroupFacing`, by the rule of `BoxShort`.
    BoxFacing "box_facing" [|_| Leaf::PAIR] |_| Leaf::FACING_BITS;
    /// The low borders of the boxes of the leaf's groups: axis a of group g is at 3 g + a. Where `GroupValid`: those of the second group :=
    /// `GroupLow`; those of the first too if `GroupPlace` is even.
    BoxLow "box_low" [|_| AXES * Leaf::GROUPS] |d| d.widths.photon;
    /// The high borders, by the rule of `BoxLow`.
    BoxHigh "box_high" [|_| AXES * Leaf::GROUPS] |d| d.widths.photon;
    /// For each bank, whether all boxes of its set are written. := 1 where `BoxValid` and `BoxLast`, for `BoxBank`; := 0 where the
    /// bank is freed.
    Full "full" [|_| 2] |_| 1;
    /// For each bank, its last leaf. := `BoxLeaf` where `BoxValid` and `BoxLast`, for `BoxBank`.
    End "end" [|_| 2] |d| d.sizes.leaf;
    /// The tokens of the batch that the chain has taken, the queries and those that fill the batch up. The chain is given a
    /// query where `query_valid` and not `Closed`, with `query_ready` = not `Closed` and the chain is ready. Where `Closed` and `Loaded`
    /// is less than the engines, it is given a *filler*, whose result is dropped. Its query pins are those of the machine, but `QueryLow` where `Closed`. := 0
    /// where the batch *starts*: see `Starting`.
    Loaded "loaded" [|_| 1] |d| d.sizes.loaded;
    /// The batch has all its queries. := 1 where a query is taken with `query_last` or as the last of as many queries as engines; := 0 where
    /// the batch starts.
    Closed "closed" [|_| 1] |_| 1;
    /// A query of the batch has `query_release`. With the first query := its `query_release`.
    Release "release" [|_| 1] |_| 1;
    /// A query is *offered* where `query_valid` and not `Closed`. Where `Loaded` is 0 and a query is offered := `query_facings`. So it is that of
    /// the first query, which is offered in the clock in which it is taken.
    Facings "facings" [|_| 1] |_| Leaf::FACINGS;
    /// The low border of the box around the batch's queries. Where a query is offered: := its coordinate if `Loaded` is 0, else the
    /// lower of `QueryLow` and its coordinate. Thus no query waits for the chain's decision here. A query that is offered and not taken can only make the box
    /// larger, and more leaves wanted.
    QueryLow "query_low" [|_| AXES] |d| d.widths.coordinate;
    /// The high border.
    QueryHigh "query_high" [|_| AXES] |d| d.widths.coordinate;
    /// The batch starts in this clock. := `Closed`, as many tokens as engines, not `Starting`, and either not `Scanning` and `Full` of
    /// `ScanBank`, or the last pair of the batch before is issued and `Full` of the bank that `ScanBank` becomes.
    Starting "starting" [|_| 1] |_| 1;
    /// := `Starting`. The last pair of the batch before is in `Found` in this clock at the latest, and the first of this batch is not there yet.
    Started "started" [|_| 1] |_| 1;
    /// The pairs of `ScanBank` are compared with a batch. := 1 where a batch starts. A pair is *issued* where `Scanning` and `Used` is less than [`LeafSizes::queue`]; where it is the last,
    /// `Scanning` := 0.
    Scanning "scanning" [|_| 1] |_| 1;
    /// The bank of the batch. := the other where the last pair is issued and `ScanRelease`.
    ScanBank "scan_bank" [|_| 1] |_| 1;
    /// The pair that is issued next. := 0 where a batch starts; incremented where one is issued.
    ScanPair "scan_pair" [|_| 1] |d| d.sizes.pair;
    /// := `End` of `ScanBank` where a batch starts. Pair `ScanEnd` / 2 is the last.
    ScanEnd "scan_end" [|_| 1] |d| d.sizes.leaf;
    /// := `Release` where a batch starts.
    ScanRelease "scan_release" [|_| 1] |_| 1;
    /// := `Facings` where `Started`.
    ScanFacings "scan_facings" [|_| 1] |_| Leaf::FACINGS;
    /// := `QueryLow` where `Started`.
    ScanLow "scan_low" [|_| AXES] |d| d.widths.coordinate;
    /// := `QueryHigh` where `Started`.
    ScanHigh "scan_high" [|_| AXES] |d| d.widths.coordinate;
    /// Places of the queue that a pair has or may need. Plus 1 where a pair is issued; less `Returned`.
    Used "used" [|_| 1] |d| d.sizes.queue_place + 1;
    /// := the places that are no longer needed: 1 where an issued pair is not queued, and 1 where a pair leaves the queue.
    Returned "returned" [|_| 1] |_| 2;
    /// := a pair is issued. The stages `Look` and `Found` read the boxes.
    LookValid "look_valid" [|_| 1] |_| 1;
    /// := `ScanPair`, in every clock.
    LookPair "look_pair" [|_| 1] |d| d.sizes.pair;
    /// := `ScanBank`, in every clock.
    LookBank "look_bank" [|_| 1] |_| 1;
    /// := `ScanPair` is the last pair, in every clock.
    LookEnd "look_end" [|_| 1] |_| 1;
    /// := `ScanRelease`, in every clock.
    LookRelease "look_release" [|_| 1] |_| 1;
    /// The pair has a second leaf. := `ScanPair` is not the last pair or `ScanEnd` is odd, in every clock.
    LookSecond "look_second" [|_| 1] |_| 1;
    /// The low borders of the pair that is issued: axis a of group i of the pair is at 3 i + a. They keep their values where no
    /// pair is issued, as all words of `Look` do.
    LookLow "look_low" [|_| AXES * Leaf::PAIR_GROUPS] |d| d.widths.photon;
    /// The high borders.
    LookHigh "look_high" [|_| AXES * Leaf::PAIR_GROUPS] |d| d.widths.photon;
    /// The facings of the pair's leaves.
    LookFacing "look_facing" [|_| Leaf::PAIR] |_| Leaf::FACING_BITS;
    /// Whether the pair's leaves have one group.
    LookShort "look_short" [|_| Leaf::PAIR] |_| 1;
    /// := `LookValid`. All of `Found` := all of `Look`, in every clock.
    FoundValid "found_valid" [|_| 1] |_| 1;
    /// := `LookPair`.
    FoundPair "found_pair" [|_| 1] |d| d.sizes.pair;
    /// := `LookBank`.
    FoundBank "found_bank" [|_| 1] |_| 1;
    /// := `LookEnd`.
    FoundEnd "found_end" [|_| 1] |_| 1;
    /// := `LookRelease`.
    FoundRelease "found_release" [|_| 1] |_| 1;
    /// := `LookSecond`.
    FoundSecond "found_second" [|_| 1] |_| 1;
    /// := `LookLow`.
    FoundLow "found_low" [|_| AXES * Leaf::PAIR_GROUPS] |d| d.widths.photon;
    /// := `LookHigh`.
    FoundHigh "found_high" [|_| AXES * Leaf::PAIR_GROUPS] |d| d.widths.photon;
    /// := `LookFacing`.
    FoundFacing "found_facing" [|_| Leaf::PAIR] |_| Leaf::FACING_BITS;
    /// := `LookShort`.
    FoundShort "found_short" [|_| Leaf::PAIR] |_| 1;
    /// The stages of `Cull` delay a pair's words while the boxes in `Found` are compared with `ScanLow` and `ScanHigh`, by the
    /// arithmetic and the pipeline registers of the chain's engines. Stage 0 := `FoundValid`, stage i := stage i - 1.
    CullValid "cull_valid" [Dimensions::culls] |_| 1;
    /// From `FoundPair`.
    CullPair "cull_pair" [Dimensions::culls] |d| d.sizes.pair;
    /// From `FoundBank`.
    CullBank "cull_bank" [Dimensions::culls] |_| 1;
    /// From `FoundEnd`.
    CullEnd "cull_end" [Dimensions::culls] |_| 1;
    /// From `FoundRelease`.
    CullRelease "cull_release" [Dimensions::culls] |_| 1;
    /// For each leaf, bits of `ScanFacings` in stage 0: := those of the facings that equal `FoundFacing` except for the lowest two bits, from
    /// the lowest facing up; 0 for the first leaf without `FoundValid`, and for the second without `FoundSecond`.
    CullSet "cull_set" [|_| Leaf::PAIR] |_| Leaf::FACINGS_NEAR;
    /// For each leaf, in stage 0: := the lowest two bits of `FoundFacing`.
    CullFacing "cull_facing" [|_| Leaf::PAIR] |_| Leaf::FACINGS_NEAR.ilog2();
    /// Whether the batch gathers the leaf's facing, from stage 1 on; leaf i of stage s is at 2 (s - 1) + i. Stage 1 := the bit `CullFacing` of
    /// `CullSet`.
    CullGathered "cull_gathered" [|d| Leaf::PAIR * (d.culls() - 1)] |_| 1;
    /// From `FoundShort`; leaf i of stage s is at 2 s + i.
    CullShort "cull_short" [|d| Leaf::PAIR * d.culls()] |_| 1;
    /// The place of the next pair in the queue. A pair is *queued* where the last `CullValid`, and a group is wanted or
    /// `CullEnd`: a group is wanted where its box is in range, `CullGathered` of its leaf, and it is not the second of a leaf with
    /// `CullShort`. Incremented where a pair is queued.
    QueueWrite "queue_write" [|_| 1] |d| d.sizes.queue_place;
    /// The place of the oldest pair in the queue. A pair *leaves* the queue where `QueueCount` is not 0, and not `EntryValid` or the
    /// last group of the entry is played. Incremented where a pair leaves.
    QueueRead "queue_read" [|_| 1] |d| d.sizes.queue_place;
    /// Pairs in the queue.
    QueueCount "queue_count" [|_| 1] |d| d.sizes.queue_place + 1;
    /// A pair is played. := a pair leaves the queue, or `EntryValid` and not the last group of the entry is played.
    EntryValid "entry_valid" [|_| 1] |_| 1;
    /// The groups of the pair that are still to be played. Where a pair leaves the queue := those that are wanted. Where a group is played, the lowest bit that is set := 0. A group is
    /// *played* where `EntryValid`; but the *last of a batch* (`EntryEnd` and `EntryLast`) only where also
    /// `MayEnd`.
    EntryMask "entry_mask" [|_| 1] |_| (Leaf::GROUPS * Leaf::PAIR) as u32;
    /// The next group is the *last group of the entry*: at most one bit of `EntryMask` is set. Where a pair leaves the queue := at most one of its
    /// groups is to be played; else where a group is played := at most two bits of `EntryMask` are set.
    EntryLast "entry_last" [|_| 1] |_| 1;
    /// Where a pair leaves the queue := its `CullPair`.
    EntryPair "entry_pair" [|_| 1] |d| d.sizes.pair;
    /// Where a pair leaves the queue := its `CullBank`.
    EntryBank "entry_bank" [|_| 1] |_| 1;
    /// Where a pair leaves the queue := its `CullEnd`.
    EntryEnd "entry_end" [|_| 1] |_| 1;
    /// Where a pair leaves the queue := its `CullRelease`.
    EntryRelease "entry_release" [|_| 1] |_| 1;
    /// Clocks until `MayEnd` may be set. Where a last group is played := the least spacing less 2, but at least 0; else less 1 down
    /// to 0.
    Spacing "spacing" [|_| 1] |d| d.sizes.spacing;
    /// A last group may be played. := `Spacing` is 0, `Outstanding` less than the most, and no last group is played.
    MayEnd "may_end" [|_| 1] |_| 1;
    /// Batches whose last group was played and whose last result has not been taken from the chain. Plus 1 where a last group is played;
    /// less 1 where the last result of a batch leaves the chain.
    Outstanding "outstanding" [|_| 1] |d| d.sizes.outstanding;
    /// := a group is played.
    ReadValid "read_valid" [|_| 1] |_| 1;
    /// := the group is the last of its batch.
    ReadLast "read_last" [|_| 1] |_| 1;
    /// := `EntryMask` is 0: the group stands for no photons, whatever its words.
    ReadBlank "read_blank" [|_| 1] |_| 1;
    /// The memory's words at the bank, pair and lowest bit that is set; they keep their values where no group is played.
    ReadPresent "read_present" [|_| LANES] |_| 1;
    /// As in `WritePosition`.
    ReadPosition "read_position" [|_| AXES * LANES] |d| d.widths.photon;
    /// As in `WritePower`.
    ReadPower "read_power" [|d| d.channels * LANES] |d| d.widths.mantissa;
    /// As in `WriteExponent`.
    ReadExponent "read_exponent" [Dimensions::exponents] |d| d.widths.exponent;
    /// := `ReadValid`. The chain is given the words of `Word` as a group; where `WordBlank` without photons. It is ready.
    WordValid "word_valid" [|_| 1] |_| 1;
    /// := `ReadLast`.
    WordLast "word_last" [|_| 1] |_| 1;
    /// := `ReadBlank`.
    WordBlank "word_blank" [|_| 1] |_| 1;
    /// := `ReadPresent`, in every clock.
    WordPresent "word_present" [|_| LANES] |_| 1;
    /// := `ReadPosition`, in every clock.
    WordPosition "word_position" [|_| AXES * LANES] |d| d.widths.photon;
    /// := `ReadPower`, in every clock.
    WordPower "word_power" [|d| d.channels * LANES] |d| d.widths.mantissa;
    /// := `ReadExponent`, in every clock.
    WordExponent "word_exponent" [Dimensions::exponents] |d| d.widths.exponent;
    /// The place of the next tag. Where the chain takes a token, its tag and whether it is a query are written there, and the place
    /// is incremented.
    TagWrite "tag_write" [|_| 1] |d| d.sizes.tag_place;
    /// The place of the oldest tag in the memory. Where there is one (`TagRead` is not `TagWrite`), and `HasOldest` is 0 or a result is
    /// taken, it is *loaded*: `Oldest` := the word at that place, and the place is incremented.
    TagRead "tag_read" [|_| 1] |d| d.sizes.tag_place;
    /// `Oldest` is a token under way. := a tag is loaded, or `HasOldest` and no result is taken.
    HasOldest "has_oldest" [|_| 1] |_| 1;
    /// The token of the chain's next result: in bit 0 whether it is a query, above that its tag. A filler's result is taken from the chain at
    /// once; a query's where `result_ready`, and `result_valid` shows it. The chain takes longer than a tag needs to get here.
    Oldest "oldest" [|_| 1] |_| Leaf::TAG_BITS + 1;
    /// The number of the chain's result in its batch. Where a result is taken := the next, or 0 behind the batch's last.
    TagResult "tag_result" [|_| 1] |d| d.sizes.result;
}
