//! The photon memory: two banks of groups between the group stream and the head.
//!
//! A *set* of groups, from a first to a last, is read into one bank and played to the engines for
//! batch after batch of queries, while the next set is read into the other bank. So photons cross the
//! pins once for all queries near them, and not once for each batch.
//!
//! # Each clock
//! With all registers as they stand before the clock edge, `G` the groups of a bank, N engines, and
//! `bank` meaning bank `FillBank` or `PlayBank`:
//! - Fill: `group_ready` = not `Full` of `FillBank`. A group that is taken is written to place
//!   `FillPlace` of that bank. Where it is a last group (or `FillPlace` is G - 1, which then counts
//!   as last): `Full` of the bank := 1, `End` of it := `FillPlace`, `FillPlace` := 0, `FillBank` := the
//!   other; else `FillPlace` counts on.
//! - Play: `reads` = `Playing` or `starts`, and `starts` = `MayStart`. `MayStart` := neither `Playing`
//!   nor `starts`, `PlayFull`, `loaded` is N (the head's), `promised` leaves room for a batch,
//!   `spacing` <= `PlayEnd`, and not (`WordValid` and the word is a last one). What it asks for once
//!   holds until the start, so it may say it a clock later. `PlayFull` and `PlayEnd` := `Full` and
//!   `End` of `PlayBank`, in every clock; they are looked at when that bank has been played from for a
//!   clock at least. The place that is read is `PlayPlace`; the word read is in `Word` a clock later:
//!   `WordValid` := `reads`, `Word` := the memory's word at bank and place, in every clock (the memory
//!   starts as 0), but its flag `last` := `reads` and the place is `PlayEnd`, whatever was written.
//! - Where `reads` and the place is `PlayEnd`: `Playing` := 0, `PlayPlace` := 0, and if the
//!   batch releases the set (`Releases`, or at `starts` `ReleaseNext`): `Full` of the bank := 0 and
//!   `PlayBank` := the other. Where `reads` and it is not: `Playing` := 1 and `PlayPlace` counts on.
//! - `starts`: `Releases` := `ReleaseNext`, `ReleaseNext` := 0. A query that is taken with `query_release`:
//!   `ReleaseNext` := 1. (Queries are not taken in a clock with `starts`: the head is full.)
//! - The head takes `Word` as its group: valid is `WordValid`. Its conditions hold then by what
//!   `starts` asks for, so the head never makes the memory wait.
//! - Reset: all registers but `Word` become 0; the memory's words stay.

/// A register of the photon memory.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MemoryRegister {
    /// The bank that groups are read into.
    FillBank,
    /// The place in it that the next group goes to.
    FillPlace,
    /// Whether each bank has a whole set.
    Full,
    /// The place of each bank's last group.
    End,
    /// The bank that is played.
    PlayBank,
    /// Whether it has a whole set, a clock late.
    PlayFull,
    /// The place of its last group, a clock late.
    PlayEnd,
    /// The place in it that is read next.
    PlayPlace,
    /// The next batch begins.
    MayStart,
    /// A batch has begun and its last group is still to be read.
    Playing,
    /// The batch that is played is the last on its set.
    Releases,
    /// A query that waits for the next batch says that this will be.
    ReleaseNext,
    /// A word was read.
    WordValid,
    /// It is the last of its batch.
    WordLast,
    /// Whether there is a photon, for each lane of the word.
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
    pub const ALL: [Self; 18] = [
        Self::FillBank,
        Self::FillPlace,
        Self::Full,
        Self::End,
        Self::PlayBank,
        Self::PlayFull,
        Self::PlayEnd,
        Self::PlayPlace,
        Self::MayStart,
        Self::Playing,
        Self::Releases,
        Self::ReleaseNext,
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
            Self::Full => "full",
            Self::End => "end_place",
            Self::PlayBank => "play_bank",
            Self::PlayFull => "play_full",
            Self::PlayEnd => "play_end",
            Self::PlayPlace => "play_place",
            Self::MayStart => "may_start",
            Self::Playing => "playing",
            Self::Releases => "releases",
            Self::ReleaseNext => "release_next",
            Self::WordValid => "word_valid",
            Self::WordLast => "word_last",
            Self::WordPresent => "word_present",
            Self::WordPosition => "word_position",
            Self::WordPower => "word_power",
            Self::WordExponent => "word_exponent",
        }
    }
}
