//! The photon memory: two banks of groups between the group stream and the head.
//!
//! A *set* of groups, from a first to a last, is read into one bank and played to the engines for
//! batch after batch of queries, while the next set is read into the other bank. So photons cross the
//! pins once for all queries near them, and not once for each batch.
//!
//! # Each clock
//! With all registers as they stand before the clock edge, `G` the groups of a bank, N engines, and
//! `bank` meaning bank `FillBank` or `PlayBank`:
//! - Fill: `group_ready` = `FillReady`. A group that is taken is written to place `FillPlace` of
//!   `FillBank` a clock later: `WriteValid` := one is taken, `WriteBank` := `FillBank`, `WritePlace` :=
//!   `FillPlace`, and the words `Write` := the group on the pins, in every clock; and where `WriteValid`,
//!   these words go to that place. So the ways to the block RAMs start at registers that may stand near
//!   them; the first place is read two clocks later at the earliest. Where it is a last group (or `FillPlace` is G - 1, which then counts as last): `Full`
//!   of the bank := 1, `FillPlace` := 0, `FillBank` := the other; else `FillPlace` counts on. Where
//!   `FillReady`, `End` of `FillBank` := `FillPlace`, whether a group is taken or not: what is there
//!   when the set is complete stays. `FillReady` := not `Full` of `FillBank`, and no set is completed
//!   in this clock; so after a set it takes a clock at least until the next one.
//! - Play: `reads` = `Playing` or `starts`, and `starts` = `MayStart`. `MayStart` := neither `Playing`
//!   nor `starts`, `PlayFull`, `loaded` is N (the head's), `promised` leaves room for a batch,
//!   `spacing` <= `PlayEnd`, and neither of the two words below is a last one that is valid. What it
//!   asks for once holds until the start, so it may say it a clock later. `PlayFull` and `PlayEnd` :=
//!   `Full` and `End` of `PlayBank`, in every clock; they are looked at when that bank has been played
//!   from for a clock at least. The place that is read is `PlayPlace`; the word read is in `Read` a
//!   clock later:
//!   `ReadValid` := `reads`, `Read` := the memory's word at bank and place, in every clock, but its flag
//!   `last` := `reads` and `AtEnd`, whatever was written. The words have no initial value, so that every FPGA's
//!   block RAM can hold them: a word that was never written may be in `Read`, but never where `ReadValid`.
//!   `Word` with its flags := `Read` with its, in every clock: a block RAM has a register for each of the two,
//!   and the way from the second is short.
//!   The place that is read is the last where `AtEnd`, which is found a clock before: `AtEnd` := where
//!   `reads`, not `AtEnd` and `PlayPlace` is `BeforeEnd`; else whether `PlayEnd` is 0, as a batch
//!   begins at place 0. `BeforeEnd` := `End` of `PlayBank` less 1, modulo G, in every clock.
//! - Where `reads` and `AtEnd`: `Playing` := 0, `PlayPlace` := 0, and if the
//!   batch releases the set (`Releases`, or at `starts` `ReleaseNext`): `Full` of the bank := 0 and
//!   `PlayBank` := the other. Where `reads` and it is not: `Playing` := 1 and `PlayPlace` counts on.
//! - `starts`: `Releases` := `ReleaseNext`, `ReleaseNext` := 0. `ReleaseTaken` := a query is taken with
//!   `query_release`; where it is set, `ReleaseNext` := 1. (No query is taken in a clock with `starts`
//!   nor in that before: the head is full.)
//! - The head takes `Word` as its group: valid is `WordValid`. Its conditions hold then by what
//!   `starts` asks for, so the head never makes the memory wait.
//! - Reset: all registers but the words `Write`, `Read` and `Word` become 0; the memory's words stay,
//!   but that which is written in this clock.

/// A register of the photon memory.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MemoryRegister {
    /// The bank that groups are read into.
    FillBank,
    /// The place in it that the next group goes to.
    FillPlace,
    /// A group is taken if there is one.
    FillReady,
    /// A group was taken, and is written.
    WriteValid,
    /// The bank that it is written to.
    WriteBank,
    /// The place in it.
    WritePlace,
    /// Whether there is a photon, for each lane of it.
    WritePresent,
    /// Its coordinates: axis a of lane g is at 3 g + a.
    WritePosition,
    /// Its mantissas: channel c of lane g is at `channels` g + c.
    WritePower,
    /// Its exponent, for each lane; where photons have one.
    WriteExponent,
    /// Whether each bank has a whole set.
    Full,
    /// The place of each bank's last group; while it is filled, of the newest or the next one.
    End,
    /// The bank that is played.
    PlayBank,
    /// Whether it has a whole set, a clock late.
    PlayFull,
    /// The place of its last group, a clock late.
    PlayEnd,
    /// The place before that.
    BeforeEnd,
    /// The place in it that is read next.
    PlayPlace,
    /// That is the last place of the set.
    AtEnd,
    /// The next batch begins.
    MayStart,
    /// A batch has begun and its last group is still to be read.
    Playing,
    /// The batch that is played is the last on its set.
    Releases,
    /// A query that says that this will be, of the next batch, was taken.
    ReleaseTaken,
    /// A query that waits for the next batch says so.
    ReleaseNext,
    /// A word was read.
    ReadValid,
    /// It is the last of its batch.
    ReadLast,
    /// Whether there is a photon, for each lane of it.
    ReadPresent,
    /// Its coordinates: axis a of lane g is at 3 g + a.
    ReadPosition,
    /// Its mantissas: channel c of lane g is at `channels` g + c.
    ReadPower,
    /// Its exponent, for each lane; where photons have one.
    ReadExponent,
    /// The same a clock later, for the head.
    WordValid,
    /// It is the last of its batch.
    WordLast,
    /// Whether there is a photon, for each lane of it.
    WordPresent,
    /// Its coordinates: axis a of lane g is at 3 g + a.
    WordPosition,
    /// Its mantissas: channel c of lane g is at `channels` g + c.
    WordPower,
    /// Its exponent, for each lane; where photons have one.
    WordExponent,
}

impl MemoryRegister {
    /// All of them, in order.
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

    /// Its name in pins and in the emitted Verilog.
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
