//! Makes inputs from good ones: close to what a reader accepts, and wrong in some places.

use std::ops::Range;

use rand::seq::IndexedRandom;
use rand::{Rng, RngExt};

/// The longest input in bytes; repeated pieces grow fast.
const LONGEST: usize = 1 << 16;

/// The most changes of one input.
const CHANGES: usize = 4;

/// Numbers at which parsers and the code behind them are known to fail.
const NUMBERS: [&str; 24] = [
    "0",
    "-0",
    "-1",
    "1e-320",
    "1e308",
    "-1e308",
    "1e309",
    "1e-9",
    "1e12",
    "0.1",
    "nan",
    "inf",
    "-inf",
    "4294967295",
    "4294967296",
    "2147483648",
    "9223372036854775807",
    "9223372036854775808",
    "18446744073709551616",
    "99999999999999999999999999",
    "0x10",
    "1_000",
    "1.",
    ".5",
];

/// Characters with a meaning in one of the languages, or in none.
const CHARACTERS: [char; 24] = [
    '"',
    '\'',
    '\\',
    '/',
    '{',
    '}',
    '[',
    ']',
    '(',
    ')',
    ',',
    '.',
    ':',
    ';',
    '=',
    '#',
    '-',
    '\n',
    '\r',
    '\t',
    ' ',
    '\0',
    '\u{e9}',
    '\u{1f525}',
];

/// One of the good texts, with one to four changes.
pub fn text(rng: &mut impl Rng, good: &[String]) -> String {
    let mut text = one_of(rng, good).clone();
    for _ in 0..rng.random_range(1..=CHANGES) {
        let other = one_of(rng, good);
        change_text(rng, &mut text, other);
        cut(&mut text, LONGEST);
    }
    text
}

/// One of the good files, with one to four changes.
pub fn bytes(rng: &mut impl Rng, good: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = one_of(rng, good).clone();
    for _ in 0..rng.random_range(1..=CHANGES) {
        change_bytes(rng, &mut bytes);
        bytes.truncate(LONGEST);
    }
    bytes
}

fn one_of<'a, T>(rng: &mut impl Rng, all: &'a [T]) -> &'a T {
    all.choose(rng).expect("there is a good one at least")
}

fn change_text(rng: &mut impl Rng, text: &mut String, other: &str) {
    match rng.random_range(0..10) {
        0..4 => {
            // Replaces a word by a word, or a number by a hostile one.
            let number = *one_of(rng, &NUMBERS);
            let word = words(other)
                .choose(rng)
                .map_or("", |word| &other[word.clone()]);
            let fresh = if rng.random() { number } else { word };
            replace_word(rng, text, fresh);
        }
        4 => replace_word(rng, text, ""),
        5 => {
            let at = boundary(rng, text);
            text.insert(at, *one_of(rng, &CHARACTERS));
        }
        6 => {
            let at = boundary(rng, text);
            text.truncate(at);
        }
        7 => {
            // Joins the beginning of one text and the end of another.
            let (at, from) = (boundary(rng, text), boundary(rng, other));
            text.truncate(at);
            text.push_str(&other[from..]);
        }
        8 => repeat_piece(rng, text),
        _ => swap_lines(rng, text),
    }
}

fn replace_word(rng: &mut impl Rng, text: &mut String, fresh: &str) {
    if let Some(word) = words(text).choose(rng) {
        text.replace_range(word.clone(), fresh);
    }
}

/// The ranges of words and numbers in a text.
fn words(text: &str) -> Vec<Range<usize>> {
    let mut words: Vec<Range<usize>> = Vec::new();
    let of_word = |c: char| c.is_alphanumeric() || "_.-+".contains(c);
    for (at, c) in text.char_indices().filter(|&(_, c)| of_word(c)) {
        let end = at + c.len_utf8();
        match words.last_mut() {
            Some(word) if word.end == at => word.end = end,
            _ => words.push(at..end),
        }
    }
    words
}

/// Repeats a piece of up to 64 bytes up to 4096 times, which makes deep nesting for parsers that recurse.
fn repeat_piece(rng: &mut impl Rng, text: &mut String) {
    let start = boundary(rng, text);
    let mut end = (start + rng.random_range(1..=64)).min(text.len());
    while !text.is_char_boundary(end) {
        end += 1;
    }
    let piece = text[start..end].repeat(1 << rng.random_range(1..=12));
    text.insert_str(start, &piece);
}

fn swap_lines(rng: &mut impl Rng, text: &mut String) {
    let mut lines: Vec<_> = text.split('\n').collect();
    let (a, b) = (
        rng.random_range(0..lines.len()),
        rng.random_range(0..lines.len()),
    );
    lines.swap(a, b);
    *text = lines.join("\n");
}

/// A random boundary between two characters.
fn boundary(rng: &mut impl Rng, text: &str) -> usize {
    let mut at = rng.random_range(0..=text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn cut(text: &mut String, longest: usize) {
    if text.len() > longest {
        let mut end = longest;
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        text.truncate(end);
    }
}

fn change_bytes(rng: &mut impl Rng, bytes: &mut Vec<u8>) {
    let at = rng.random_range(0..=bytes.len());
    match rng.random_range(0..5) {
        0 => bytes.truncate(at),
        1 => {
            let bit = 1 << rng.random_range(0..8);
            bytes
                .iter_mut()
                .skip(at)
                .take(1)
                .for_each(|byte| *byte ^= bit);
        }
        2 => {
            // A hostile size or offset, in either byte order.
            let hostile: [u32; 6] = [0, 1, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, 0x0001_0000];
            let fresh = one_of(rng, &hostile).to_le_bytes();
            bytes
                .iter_mut()
                .skip(at)
                .zip(fresh)
                .for_each(|(byte, fresh)| *byte = fresh);
        }
        3 => {
            let end = (at + rng.random_range(1..=64)).min(bytes.len());
            let piece = bytes[at..end].to_vec();
            bytes.splice(at..at, piece);
        }
        _ => bytes.insert(at, rng.random()),
    }
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_pcg::Pcg64;

    use super::*;

    #[test]
    fn inputs_are_near_the_good_ones_and_bounded() {
        let good = [
            "[a]\nb = 1.5 # \u{e9}\n".to_owned(),
            "c = \"d\"\n".repeat(4000),
        ];
        let made: Vec<_> = (0..2000)
            .map(|seed| text(&mut Pcg64::seed_from_u64(seed), &good))
            .collect();
        assert!(made.iter().all(|text| text.len() <= LONGEST));
        let with = |word: &str| made.iter().filter(|text| text.contains(word)).count();
        // Each of these words results from at least one kind of change, and is often kept.
        for word in ["1.5", "1e309", "c = \"d\"", "[a]", "\0", "\u{1f525}"] {
            assert!(with(word) > 0, "{word}");
        }
        let changed = made.iter().filter(|text| !good.contains(text)).count();
        assert!(changed > 1000, "{changed} of 2000 are changed");
    }

    #[test]
    fn files_are_changed_and_bounded() {
        let good = [vec![7; 300], Vec::new()];
        let made: Vec<_> = (0..500)
            .map(|seed| bytes(&mut Pcg64::seed_from_u64(seed), &good))
            .collect();
        assert!(made.iter().all(|bytes| bytes.len() <= LONGEST));
        assert!(made.iter().filter(|bytes| !good.contains(bytes)).count() > 250);
    }
}
