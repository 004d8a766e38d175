//! Relations between registers that are written by hand from the spec, and proven by induction together with the guessed
//! invariants: those of a photon memory, which hold for any signals of the head, and those of the comparison of boxes in a leaf
//! machine, whose registers are not observed.

use photoncube_spec::{Leaf, Machine, Organisation};

/// The relations, as Verilog over the names of the registers. `FULL` and `END` are those of the bank that is
/// played.
const OF_MEMORY: &[&str] = &[
    // Only a bank that is not full is filled, so the end of a full bank stays.
    "~memory_fill_ready_0 | ~(memory_fill_bank_0 ? memory_full_1 : memory_full_0)",
    // The delayed copies of the played bank's state are correct, except in the clock after a batch's end.
    "(memory_read_valid_0 & memory_read_last_0) | ~memory_play_full_0 \
     | (FULL & memory_play_end_0 == END & BEFORE)",
    // A batch begins at the first place.
    "memory_playing_0 | memory_play_place_0 == 0",
    // A batch is read without a gap: each word but the last is followed by another.
    "~memory_read_valid_0 | memory_read_last_0 | memory_playing_0",
    "~memory_word_valid_0 | memory_word_last_0 | memory_playing_0 | (memory_read_valid_0 & memory_read_last_0)",
    // While a batch is read, its set is complete, and the last place is known before it is read.
    "~(memory_playing_0 | memory_may_start_0) \
     | (FULL & BEFORE & memory_at_end_0 == (memory_play_place_0 == END) & memory_play_place_0 <= END)",
];

const SHORTHANDS: [(&str, &str); 3] = [
    // In a concatenation, the sum has the width of its operands.
    ("BEFORE", "{memory_before_end_0 + ONE} == {END}"),
    (
        "FULL",
        "(memory_play_bank_0 ? memory_full_1 : memory_full_0)",
    ),
    (
        "END",
        "(memory_play_bank_0 ? memory_end_place_1 : memory_end_place_0)",
    ),
];

/// What the names of registers in relations begin with: those of a photon memory, and those that are not observed.
const BEGINNINGS: [&str; 2] = ["memory_", UNOBSERVED];
const UNOBSERVED: &str = "culler_product_";

/// A relation between registers, as Verilog with their names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Relation(String);

impl Relation {
    /// The relations that are written for a machine.
    pub fn of(machine: &Machine) -> Vec<Self> {
        let has_squares = || machine.format().is_some_and(|format| !format.half_steps());
        match machine.organisation {
            Organisation::Spatial(spatial) if machine.has_memory() => {
                Self::of_memory(spatial.memory_groups.ilog2())
            }
            Organisation::Leaf(_) if has_squares() => Self::of_culler(),
            _ => Vec::new(),
        }
    }

    /// The relations of a photon memory whose places have `place_bits` bits.
    fn of_memory(place_bits: u32) -> Vec<Self> {
        let written = |text: &&str| {
            let long = SHORTHANDS
                .iter()
                .fold((*text).to_owned(), |text, (short, long)| {
                    text.replace(short, long)
                });
            Self(long.replace("ONE", &format!("{place_bits}'d1")))
        };
        OF_MEMORY.iter().map(written).collect()
    }

    /// The relations of a comparison of boxes whose squares are products: a square is 0 or 1 modulo 4.
    fn of_culler() -> Vec<Self> {
        let gaps = 0..3 * Leaf::PAIR_GROUPS;
        gaps.map(|gap| Self(format!("{UNOBSERVED}{gap}[1] == 0")))
            .collect()
    }

    /// The path of a register that is not observed, by its name in a relation.
    pub fn unobserved(name: &str) -> Option<String> {
        let gap = name.strip_prefix(UNOBSERVED)?;
        Some(format!("culler.product_{gap}.product.q"))
    }

    /// The relation with each register replaced by its expression; `None` where a register has none.
    pub fn with(&self, register: impl Fn(&str) -> Option<String>) -> Option<String> {
        let mut text = String::new();
        let mut rest = self.0.as_str();
        let begins = |text: &str| {
            let begins = BEGINNINGS.iter().filter_map(|name| text.find(name));
            begins.min()
        };
        while let Some(begin) = begins(rest) {
            let (before, name) = rest.split_at(begin);
            let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
            let end = name.find(|c| !is_name(c)).unwrap_or(name.len());
            text += before;
            text += &register(&name[..end])?;
            rest = &name[end..];
        }
        Some(text + rest)
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Pins, find_machine};

    use super::*;

    #[test]
    fn every_name_is_a_register_and_nothing_else_is_left_to_replace() {
        let pins = Pins::of(find_machine("tile-6-mixed").unwrap());
        let relations = Relation::of_memory(10);
        assert_eq!(relations.len(), OF_MEMORY.len());
        for relation in &relations {
            let known = |name: &str| {
                let mut pins = pins.observed.iter();
                pins.any(|pin| pin.name == name).then(|| "p".to_owned())
            };
            let text = relation.with(known).expect("its registers are observed");
            let plain = |c: char| !c.is_ascii_uppercase() && c != '_';
            assert!(text.chars().all(plain), "{text}");
        }
        assert_eq!(relations[0].with(|_| None), None);
        let squares = Relation::of_culler();
        let text = squares[11].with(Relation::unobserved);
        assert_eq!(text.as_deref(), Some("culler.product_11.product.q[1] == 0"));
    }
}
