//! The places of the registers of a leaf machine before its chain.

use photoncube_spec::{Leaf, LeafRegister};

use super::boxes::OF_LEAF;
use super::machine::LeafMachine;
use super::words::{BoxPair, BoxWords, GroupWords};
use crate::pinned::Word;
use crate::registers::{Answer, Ask, register};

const AXES: usize = 3;
const AXIS_NAMES: [&str; AXES] = ["x", "y", "z"];

/// A register's value or path, by the spec's index.
pub(super) fn own_register<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
    const PB: usize,
    const LB: usize,
    const KB: usize,
    const QB: usize,
    const QN: usize,
    const NB: usize,
    const SB: usize,
    const OB: usize,
    const TB: usize,
    const RB: usize,
>(
    m: &LeafMachine<
        C,
        H,
        D,
        R,
        Q,
        L,
        LP,
        HP,
        PR,
        T,
        U,
        B,
        E,
        P,
        PP,
        GP,
        S,
        N,
        PB,
        LB,
        KB,
        QB,
        QN,
        NB,
        SB,
        OB,
        TB,
        RB,
    >,
    register: LeafRegister,
    i: usize,
    ask: Ask,
) -> Answer {
    use LeafRegister as R;
    match register {
        R::FillBank => register!(ask, m, fill.fill_bank.q),
        R::FillPlace => register!(ask, m, fill.fill_place.q),
        R::FillReady => register!(ask, m, fill.fill_ready.q),
        R::WriteValid => register!(ask, m, fill.write_valid.q),
        R::WriteBank => register!(ask, m, fill.write_bank.q),
        R::WritePlace => register!(ask, m, fill.write_place.q),
        R::WriteLast => register!(ask, m, fill.write_last.q),
        R::WriteFacing => register!(ask, m, fill.write_facing.q),
        R::HalfValid => register!(ask, m, control.half_valid.q),
        R::HalfBank => register!(ask, m, control.half_bank.q),
        R::HalfPlace => register!(ask, m, control.half_place.q),
        R::HalfLast => register!(ask, m, control.half_last.q),
        R::HalfFacing => register!(ask, m, control.half_facing.q),
        R::GroupValid => register!(ask, m, control.group_valid.q),
        R::GroupBank => register!(ask, m, control.group_bank.q),
        R::GroupPlace => register!(ask, m, control.group_place.q),
        R::GroupLast => register!(ask, m, control.group_last.q),
        R::GroupFacing => register!(ask, m, control.group_facing.q),
        R::BoxValid => register!(ask, m, control.box_valid.q),
        R::BoxBank => register!(ask, m, control.box_bank.q),
        R::BoxLeaf => register!(ask, m, control.box_leaf.q),
        R::BoxLast => register!(ask, m, control.box_last.q),
        R::BoxShort if i == 0 => register!(ask, m, control.box_short_0.q),
        R::BoxShort => register!(ask, m, control.box_short_1.q),
        R::BoxFacing if i == 0 => register!(ask, m, control.box_facing_0.q),
        R::BoxFacing => register!(ask, m, control.box_facing_1.q),
        R::HalfLow => register!(ask, m, borders.half_low[i].q),
        R::HalfHigh => register!(ask, m, borders.half_high[i].q),
        R::GroupLow => register!(ask, m, borders.group_low[i].q),
        R::GroupHigh => register!(ask, m, borders.group_high[i].q),
        R::BoxLow => register!(ask, m, borders.held_low[i].held.q),
        R::BoxHigh => register!(ask, m, borders.held_high[i].held.q),
        R::Loaded => register!(ask, m, former.loaded.q),
        R::Closed => register!(ask, m, former.closed.q),
        R::Release => register!(ask, m, former.releases.q),
        R::Facings => register!(ask, m, former.facings.q),
        R::QueryLow => register!(ask, m, query_border[i].low.q),
        R::QueryHigh => register!(ask, m, query_border[i].high.q),
        R::Starting => register!(ask, m, scan.starting.q),
        R::Started => register!(ask, m, scan.started.q),
        R::Scanning => register!(ask, m, scan.scanning.q),
        R::ScanBank => register!(ask, m, scan.scan_bank.q),
        R::ScanPair => register!(ask, m, scan.scan_pair.q),
        R::ScanEnd => register!(ask, m, scan.scan_end.q),
        R::ScanRelease => register!(ask, m, scan.scan_release.q),
        R::ScanFacings => register!(ask, m, scan.scan_facings.q),
        R::ScanLow => register!(ask, m, scan_low[i].held.q),
        R::ScanHigh => register!(ask, m, scan_high[i].held.q),
        R::Returned => register!(ask, m, scan.returned.q),
        R::Used => register!(ask, m, scan.used.q),
        R::LookValid => register!(ask, m, scan.look_valid.q),
        R::LookPair => register!(ask, m, scan.look_pair.q),
        R::LookBank => register!(ask, m, scan.look_bank.q),
        R::LookEnd => register!(ask, m, scan.look_end.q),
        R::LookRelease => register!(ask, m, scan.look_release.q),
        R::LookSecond => register!(ask, m, scan.look_second.q),
        R::FoundValid => register!(ask, m, scan.found_valid.q),
        R::FoundPair => register!(ask, m, scan.found_pair.q),
        R::FoundBank => register!(ask, m, scan.found_bank.q),
        R::FoundEnd => register!(ask, m, scan.found_end.q),
        R::FoundRelease => register!(ask, m, scan.found_release.q),
        R::FoundSecond => register!(ask, m, scan.found_second.q),
        R::CullValid => register!(ask, m, cull[i].valid.q),
        R::CullPair => register!(ask, m, cull[i].pair.q),
        R::CullBank => register!(ask, m, cull[i].bank.q),
        R::CullEnd => register!(ask, m, cull[i].end_of_set.q),
        R::CullRelease => register!(ask, m, cull[i].releases.q),
        R::CullSet => register!(ask, m, gathers.leaf[i].near.q),
        R::CullFacing => register!(ask, m, gathers.leaf[i].number.q),
        R::CullGathered => register!(ask, m, gathers.stage[i].q),
        R::CullShort => register!(ask, m, cull[i / 2].short[i % 2].q),
        R::QueueWrite => register!(ask, m, queue.queue_write.q),
        R::QueueRead => register!(ask, m, queue.queue_read.q),
        R::QueueCount => register!(ask, m, queue.queue_count.q),
        R::EntryValid => register!(ask, m, player.entry_valid.q),
        R::EntryMask => register!(ask, m, player.entry_mask.q),
        R::EntryLast => register!(ask, m, player.entry_last.q),
        R::EntryPair => register!(ask, m, player.entry_pair.q),
        R::EntryBank => register!(ask, m, player.entry_bank.q),
        R::EntryEnd => register!(ask, m, player.entry_end.q),
        R::EntryRelease => register!(ask, m, player.entry_release.q),
        R::MayEnd => register!(ask, m, player.may_end.q),
        R::Spacing => register!(ask, m, player.spacing.q),
        R::Outstanding => register!(ask, m, player.outstanding.q),
        R::ReadValid => register!(ask, m, player.read_valid.q),
        R::ReadLast => register!(ask, m, player.read_last.q),
        R::ReadBlank => register!(ask, m, player.read_blank.q),
        R::WordValid => register!(ask, m, player.word_valid.q),
        R::WordLast => register!(ask, m, player.word_last.q),
        R::WordBlank => register!(ask, m, player.word_blank.q),
        R::TagWrite => register!(ask, m, tags.tag_write.q),
        R::TagRead => register!(ask, m, tags.tag_read.q),
        R::HasOldest => register!(ask, m, tags.has_oldest.q),
        R::Oldest => register!(ask, m, tags.oldest.q),
        R::TagResult => register!(ask, m, tags.tag_result.q),
        R::Filled if i == 0 => register!(ask, m, fill.filled_0.q),
        R::Filled => register!(ask, m, fill.filled_1.q),
        R::Full if i == 0 => register!(ask, m, control.full_0.q),
        R::Full => register!(ask, m, control.full_1.q),
        R::End if i == 0 => register!(ask, m, control.end_0.q),
        R::End => register!(ask, m, control.end_1.q),
        R::WritePresent | R::WritePosition | R::WritePower | R::WriteExponent => group_word(
            &m.group_words,
            &m.group_words._write,
            "write",
            register,
            i,
            ask,
        ),
        R::ReadPresent | R::ReadPosition | R::ReadPower | R::ReadExponent => group_word(
            &m.group_words,
            &m.group_words._read,
            "read",
            register,
            i,
            ask,
        ),
        R::WordPresent | R::WordPosition | R::WordPower | R::WordExponent => group_word(
            &m.group_words,
            &m.group_words._word,
            "word",
            register,
            i,
            ask,
        ),
        R::LookLow | R::LookHigh | R::LookFacing | R::LookShort => {
            box_word(&m.box_words, &m.box_words._look, "look", register, i, ask)
        }
        R::FoundLow | R::FoundHigh | R::FoundFacing | R::FoundShort => {
            box_word(&m.box_words, &m.box_words._found, "found", register, i, ask)
        }
    }
}

/// A field of a group's word.
fn group_word<const H: usize, const B: usize, const E: usize, const PB: usize>(
    words: &GroupWords<H, B, E, PB>,
    word: &[u64],
    name: &str,
    register: LeafRegister,
    i: usize,
    ask: Ask,
) -> Answer {
    use LeafRegister as R;
    let channels = words._channels.len();
    // Inside the machine a single channel has another name than on the pins.
    let channel_name = |channel: usize| match channels {
        1 => "mantissa",
        _ => words._channels[channel],
    };
    let (field, lane, place) = match register {
        R::WritePresent | R::ReadPresent | R::WordPresent => (format!("present_{i}"), i, 0),
        R::WritePosition | R::ReadPosition | R::WordPosition => {
            let (lane, axis) = (i / AXES, i % AXES);
            (format!("{}_{lane}", AXIS_NAMES[axis]), lane, 1 + axis)
        }
        R::WritePower | R::ReadPower | R::WordPower => {
            let (lane, channel) = (i / channels, i % channels);
            (
                format!("{}_{lane}", channel_name(channel)),
                lane,
                1 + AXES + channel,
            )
        }
        _ => (format!("exponent_{i}"), i, 1 + AXES + channels),
    };
    match ask {
        Ask::Value => Answer::Value(word[words.place(lane, place)]),
        Ask::Path => Answer::Path(format!("group_words.of_{name}_{field}")),
    }
}

/// A field of the words of a pair's boxes.
fn box_word<const H: usize, const LB: usize, const KB: usize>(
    _boxes: &BoxWords<H, LB, KB>,
    words: &BoxPair,
    name: &str,
    register: LeafRegister,
    i: usize,
    ask: Ask,
) -> Answer {
    use LeafRegister as R;
    let (field, value) = match register {
        R::LookLow | R::FoundLow => ("low", words.borders[i / OF_LEAF][i % OF_LEAF]),
        R::LookHigh | R::FoundHigh => ("high", words.borders[i / OF_LEAF][OF_LEAF + i % OF_LEAF]),
        R::LookFacing | R::FoundFacing => ("facing", words.notes[i]),
        _ => ("short", words.notes[Leaf::PAIR + i]),
    };
    match ask {
        Ask::Value => Answer::Value(value),
        Ask::Path => Answer::Path(format!("box_words.of_{name}_{field}_{i}")),
    }
}
