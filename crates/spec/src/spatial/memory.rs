//! The photon memory: two banks of groups between the group stream and the head.
//!
//! A *set* of groups, from a first to a last, is read into one bank and played to the engines for batch after
//! batch of queries, while the next set is read into the other bank. So photons cross the pins once for all
//! queries near them, and not once for each batch.
//!
//! # Each clock
//! All registers have the values before the clock edge, and `:=` gives the value after it. `G` is the number
//! of groups of a bank, N the number of engines, and `bank` means bank `FillBank` or `PlayBank`:
//! - Fill: `group_ready` = `FillReady`. A group that is taken is written to place `FillPlace` of `FillBank` a
//!   clock later: `WriteValid` := a group is taken, `WriteBank` := `FillBank`, `WritePlace` := `FillPlace`,
//!   and the words `Write` := the group on the pins, in every clock. Where `WriteValid`, these words are
//!   written to that place. So the nets to the block RAMs start at registers that may be placed near the
//!   block RAMs. The first place is read two clocks later at the earliest.
//! - End of a set: where the group taken is a last group (or `FillPlace` is G - 1, which then counts as
//!   last), `Full` of the bank := 1, `FillPlace` := 0, `FillBank` := the other. Where another group is taken,
//!   `FillPlace` is incremented. Where `FillReady`, `End` of `FillBank` := `FillPlace`, whether a group is
//!   taken or not; the value at the end of the set stays. `FillReady` := not `Full` of `FillBank`, and no set
//!   is completed in this clock; so at least one clock lies between two sets.
//! - Play: `reads` = `Playing` or `starts`, and `starts` = `MayStart`. `MayStart` := neither `Playing` nor
//!   `starts`, `PlayFull`, `loaded` is N (the head's), `promised` leaves room for a batch, `spacing` <=
//!   `PlayEnd`, and neither of the two words below is a last one that is valid. These conditions, once true,
//!   stay true until the start, so `MayStart` may be one clock late. `PlayFull` and `PlayEnd` := `Full` and
//!   `End` of `PlayBank`, in every clock; they are used only when that bank has been played from for at least
//!   one clock.
//! - Read: the place that is read is `PlayPlace`; the word read is in `Read` a clock later: `ReadValid` :=
//!   `reads`, `Read` := the memory's word at bank and place, in every clock, but its flag `last` := `reads`
//!   and `AtEnd`, whatever was written. The words have no initial value, so that every FPGA's block RAM can
//!   hold them. A word that was never written may be in `Read`, but never where `ReadValid`. `Word` with its
//!   flags := `Read` with its flags, in every clock: a block RAM has a register for each of the two, and the
//!   clock-to-output delay of the second is short.
//! - Last place: the place that is read is the last where `AtEnd`, which is computed a clock before: where
//!   `reads`, `AtEnd` := not `AtEnd` and `PlayPlace` is `BeforeEnd`; else `AtEnd` := `PlayEnd` is 0, as a
//!   batch begins at place 0. `BeforeEnd` := `End` of `PlayBank` less 1, modulo G, in every clock.
//! - Where `reads` and `AtEnd`: `Playing` := 0, `PlayPlace` := 0, and if the batch releases the set
//!   (`Releases`, or at `starts` `ReleaseNext`): `Full` of the bank := 0 and `PlayBank` := the other. Where
//!   `reads` and not `AtEnd`: `Playing` := 1 and `PlayPlace` is incremented.
//! - `starts`: `Releases` := `ReleaseNext`, `ReleaseNext` := 0. `ReleaseTaken` := a query is taken with
//!   `query_release`; where `ReleaseTaken` is set, `ReleaseNext` := 1. (No query is taken in a clock with
//!   `starts` nor in the clock before, because the head is full.)
//! - The head takes `Word` as its group: valid is `WordValid`. The conditions of `starts` imply the head's
//!   own conditions, so the head never makes the memory wait.
//! - Reset: all registers but the words `Write`, `Read` and `Word` become 0. The memory's words stay, but a
//!   word whose write is due in this clock is written.

/// A register of the photon memory.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MemoryRegister {
    /// The bank that groups are read into.
    FillBank,
    /// The place in `FillBank` that the next group goes to.
    FillPlace,
    /// The memory's ready: it takes the group of this clock, if it is valid.
    FillReady,
    /// A group was taken in the clock before and is written in this clock.
    WriteValid,
    /// The bank that the group is written to.
    WriteBank,
    /// The place that the group is written to.
    WritePlace,
    /// The written group: whether there is a photon, for each lane.
    WritePresent,
    /// The written group's coordinates: axis a of lane g is at 3 g + a.
    WritePosition,
    /// The written group's mantissas: channel c of lane g is at `channels` g + c.
    WritePower,
    /// The written group's exponent, for each lane; where photons have one.
    WriteExponent,
    /// For each bank, whether it holds a whole set.
    Full,
    /// For each bank, the place of its last group; while the bank is filled, the place of the newest or the
    /// next group.
    End,
    /// The bank that is played.
    PlayBank,
    /// Whether `PlayBank` holds a whole set, one clock late.
    PlayFull,
    /// The place of the last group of `PlayBank`, one clock late.
    PlayEnd,
    /// The place before the last group of `PlayBank`, one clock late.
    BeforeEnd,
    /// The place in `PlayBank` that is read next.
    PlayPlace,
    /// `PlayPlace` is the last place of the set.
    AtEnd,
    /// A batch begins in this clock.
    MayStart,
    /// A batch has begun and its last group is still to be read.
    Playing,
    /// The batch that is played is the last on its set.
    Releases,
    /// A query with `query_release` was taken in the clock before; the next batch is the last on its set.
    ReleaseTaken,
    /// The next batch is the last on its set, by one of its queries.
    ReleaseNext,
    /// `Read` holds a word that was read.
    ReadValid,
    /// The word in `Read` is the last of its batch.
    ReadLast,
    /// The word in `Read`: whether there is a photon, for each lane.
    ReadPresent,
    /// The coordinates in `Read`: axis a of lane g is at 3 g + a.
    ReadPosition,
    /// The mantissas in `Read`: channel c of lane g is at `channels` g + c.
    ReadPower,
    /// The exponent in `Read`, for each lane; where photons have one.
    ReadExponent,
    /// `ReadValid` one clock later: `Word` holds a group for the head.
    WordValid,
    /// The word in `Word` is the last of its batch.
    WordLast,
    /// The word in `Word`: whether there is a photon, for each lane.
    WordPresent,
    /// The coordinates in `Word`: axis a of lane g is at 3 g + a.
    WordPosition,
    /// The mantissas in `Word`: channel c of lane g is at `channels` g + c.
    WordPower,
    /// The exponent in `Word`, for each lane; where photons have one.
    WordExponent,
}

impl MemoryRegister {
    /// All registers of the photon memory, in their order as signals.
    pub const ALL: [Self; 35] = [
        Self::FillBank,
        Self::FillPlace,
        Self::FillReady,
        Self::WriteValid,
        Self::WriteBank,
        Self::WritePlace,
        Self::WritePresent,
        Self::WritePosition,
        Self::WritePower,
        Self::WriteExponent,
        Self::Full,
        Self::End,
        Self::PlayBank,
        Self::PlayFull,
        Self::PlayEnd,
        Self::BeforeEnd,
        Self::PlayPlace,
        Self::AtEnd,
        Self::MayStart,
        Self::Playing,
        Self::Releases,
        Self::ReleaseTaken,
        Self::ReleaseNext,
        Self::ReadValid,
        Self::ReadLast,
        Self::ReadPresent,
        Self::ReadPosition,
        Self::ReadPower,
        Self::ReadExponent,
        Self::WordValid,
        Self::WordLast,
        Self::WordPresent,
        Self::WordPosition,
        Self::WordPower,
        Self::WordExponent,
    ];

    /// The register's name in pins and in the emitted Verilog.
    pub fn name(self) -> &'static str {
        match self {
            Self::FillBank => "fill_bank",
            Self::FillPlace => "fill_place",
            Self::FillReady => "fill_ready",
            Self::WriteValid => "write_valid",
            Self::WriteBank => "write_bank",
            Self::WritePlace => "write_place",
            Self::WritePresent => "write_present",
            Self::WritePosition => "write_position",
            Self::WritePower => "write_power",
            Self::WriteExponent => "write_exponent",
            Self::Full => "full",
            Self::End => "end_place",
            Self::PlayBank => "play_bank",
            Self::PlayFull => "play_full",
            Self::PlayEnd => "play_end",
            Self::BeforeEnd => "before_end",
            Self::PlayPlace => "play_place",
            Self::AtEnd => "at_end",
            Self::MayStart => "may_start",
            Self::Playing => "playing",
            Self::Releases => "releases",
            Self::ReleaseTaken => "release_taken",
            Self::ReleaseNext => "release_next",
            Self::ReadValid => "read_valid",
            Self::ReadLast => "read_last",
            Self::ReadPresent => "read_present",
            Self::ReadPosition => "read_position",
            Self::ReadPower => "read_power",
            Self::ReadExponent => "read_exponent",
            Self::WordValid => "word_valid",
            Self::WordLast => "word_last",
            Self::WordPresent => "word_present",
            Self::WordPosition => "word_position",
            Self::WordPower => "word_power",
            Self::WordExponent => "word_exponent",
        }
    }
}
