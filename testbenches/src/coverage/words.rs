//! Computes which bits the words of a cell can use. All cells have equal hardware, as wide as the widest word
//! needs; the words that a cell receives follow from its role.

use photoncube_hdl::generator::GeneratorError;
use photoncube_hdl::{Level, level_pins};
use photoncube_spec::{
    Axis, CellTables, Machine, OVERLAPPED, Organisation, PhotonFormat, Pin, Register, RegisterRow,
    Role, Widths,
};

/// A kind of word that a signal of a cell may hold.
#[derive(Copy, Clone)]
enum Word {
    /// The word that the cell's neighbour sends.
    Link,
    /// Squared distances, and the powers of an iteration's photons.
    Work,
    /// The powers of all of a query's photons.
    Sum,
}

/// A signal that holds words: the end of its path, with numbers left out and dots replaced by underscores.
type Holder = (String, Vec<Word>);

/// The words of a register, or of a unit's operand that is read from it; none where the register's width is that
/// of all its words.
fn words_of(tables: &CellTables, register: Register) -> &'static [Word] {
    let is_overlapped = std::ptr::eq(tables, &OVERLAPPED);
    match register {
        Register::Work => &[Word::Work],
        Register::Sum => &[Word::Sum],
        Register::Operand if is_overlapped => &[Word::Link, Word::Sum],
        _ => &[],
    }
}

/// The signals of a sequential machine that are neither registers nor pins of units.
const SEQUENTIAL_WIRES: &[(&str, &[Word])] = &[
    ("link", &[Word::Link]),
    ("link_in", &[Word::Link]),
    ("addend", &[Word::Link, Word::Sum]),
    ("network_work", &[Word::Work]),
    ("sum_low", &[Word::Sum]),
    ("sum_high", &[Word::Sum]),
    ("ports_sum", &[Word::Sum]),
];

/// The signals of an overlapped machine that are no registers. The link is the one along w; sums cross x and y,
/// and words that use all bits cross z.
const OVERLAPPED_WIRES: &[(&str, &[Word])] = &[
    ("link_w", &[Word::Link]),
    ("from_w", &[Word::Link]),
    ("from_role_axes", &[Word::Link]),
    ("from_quad", &[Word::Link]),
    ("w_out", &[Word::Work]),
    ("operand", &[Word::Link, Word::Sum]),
    ("link_x", &[Word::Sum]),
    ("link_y", &[Word::Sum]),
    ("from_x", &[Word::Sum]),
    ("from_y", &[Word::Sum]),
    ("from_photon_axes", &[Word::Sum]),
    ("chosen_sum_total", &[Word::Work, Word::Sum]),
    ("chosen_sum_high", &[Word::Work, Word::Sum]),
    ("chosen_sum_first", &[Word::Sum]),
    ("chosen_sum_low", &[Word::Sum]),
    ("chosen_sum_sum", &[Word::Sum]),
    ("chosen_sum_wide_low", &[Word::Sum]),
    ("sum_low", &[Word::Sum]),
];

/// The pins of a machine's units, each with the words that the unit's ops read or write there. The word of the
/// link is the last operand of an op that has one.
fn unit_pins(machine: &Machine, tables: &CellTables) -> Result<Vec<Holder>, GeneratorError> {
    let mut holders = Vec::new();
    for level in Level::of(machine) {
        let Level::Unit(unit) = level else { continue };
        let pins = level_pins(machine, level)?;
        let ops = || tables.ops.iter().filter(|row| row.unit == Some(unit));
        let mut add = |pin: &Pin, words: Vec<Word>| {
            let name = format!("{}_{}", unit.module(), pin.name);
            holders.extend((!words.is_empty()).then_some((name, words)));
        };
        for (place, pin) in pins.inputs.iter().enumerate() {
            let words = ops().flat_map(|row| match row.reads.get(place) {
                Some(&register) => words_of(tables, register),
                None if row.link.is_some() && place == row.reads.len() => &[Word::Link],
                None => &[],
            });
            add(pin, words.copied().collect());
        }
        let written = ops().flat_map(|row| row.writes);
        let written = written.flat_map(|&register| words_of(tables, register));
        add(&pins.observed[0], written.copied().collect());
    }
    Ok(holders)
}

/// The registers that hold words: what they store, what they hold, and what a cell sends of them.
fn registers(tables: &CellTables) -> Vec<Holder> {
    let of = |row: &RegisterRow| {
        let words = words_of(tables, row.register);
        let ends = ["d", "q", "out"].map(|end| (format!("{}_{end}", row.name), words.to_vec()));
        ends.into_iter().filter(|(_, words)| !words.is_empty())
    };
    tables.registers.iter().flat_map(of).collect()
}

/// The signals of a spatial machine that hold one square.
const SQUARES: &[&str] = &[
    "product_product",
    "product_product_d",
    "product_product_q",
    "squared",
    "square",
    "square_a",
    "square_b",
    "square_stage_d",
    "square_stage_q",
    "lookup",
    "lookup_a",
    "lookup_b",
    "axis_square",
    "pair_z_d",
    "pair_z_q",
    "pair_sum_a",
    "pair_sum_b",
    "pair_sum_wide_a",
    "pair_sum_wide_b",
    "distance_sum_b",
    "distance_sum_wide_b",
];

/// The output pins of the sums, with the role of the cells that hold them.
const PINS: [(&str, Role); 2] = [("result_power", Role::X), ("result_count", Role::D)];

/// The words of a machine's signals.
pub(super) struct Words<'a> {
    pub machine: &'a Machine,
    /// Empty for machines without cells.
    holders: Vec<Holder>,
}

impl<'a> Words<'a> {
    /// # Errors
    /// The machine's widths are not built in.
    pub fn of(machine: &'a Machine) -> Result<Self, GeneratorError> {
        let mut holders = Vec::new();
        if let Some(tables) = machine.cell() {
            let wires = match machine.organisation {
                Organisation::Overlapped => OVERLAPPED_WIRES,
                _ => SEQUENTIAL_WIRES,
            };
            holders = unit_pins(machine, tables)?;
            holders.extend(registers(tables));
            let wires = wires.iter();
            holders.extend(wires.map(|&(name, words)| (name.to_owned(), words.to_vec())));
        }
        Ok(Self { machine, holders })
    }

    /// The bits of the largest word that a signal receives; `None` for other signals, and for machines without
    /// cells. `path` is the signal's path in the top instance.
    pub fn bits(&self, path: &str) -> Option<u32> {
        let machine = self.machine;
        machine.cell()?;
        if let Some((_, role)) = PINS.iter().find(|(pin, _)| path.ends_with(pin)) {
            return Some(word_bits(machine, *role, Word::Sum));
        }
        let role = roles(machine, path).next()?;
        let words = self.words(path)?.iter();
        words.map(|&word| word_bits(machine, role, word)).max()
    }

    /// Whether all words that a signal of a sequential machine receives are half squares, or sums of half
    /// squares.
    pub fn are_even(&self, path: &str) -> bool {
        let machine = self.machine;
        machine.microprogram().is_some()
            && machine.format().is_some_and(PhotonFormat::half_steps)
            && roles(machine, path).any(|role| full_scale(machine, role) == 0)
            && self.words(path).is_some()
    }

    fn words(&self, path: &str) -> Option<&[Word]> {
        let name = without_numbers(path);
        let mut holders = self.holders.iter();
        let holder = holders.find(|(holder, _)| name.ends_with(holder));
        holder.map(|(_, words)| &words[..])
    }
}

/// Names, without numbers, of the signals that hold sums of squares in spatial machines.
const SUMS_OF_SQUARES: &[&str] = &[
    "pair_square_d",
    "pair_square_q",
    "pair_sum_sum",
    "distance_sum_a",
    "distance_sum_wide_a",
    "distance_sum_sum",
    "distance_d",
    "distance_q",
    "range_of_query_distance",
    "range_of_format_distance",
];

/// Whether a signal of a spatial machine holds half squares or a sum of them.
pub(super) fn is_half_square(machine: &Machine, path: &str) -> bool {
    let name = without_numbers(path);
    let mut holders = SQUARES.iter().chain(SUMS_OF_SQUARES);
    machine.spatial().is_some()
        && machine.format().is_some_and(PhotonFormat::half_steps)
        && holders.any(|holder| ends_with_name(&name, holder))
}

/// Whether a signal of a spatial machine holds the square of one coordinate's difference, in whole steps.
pub(super) fn is_square(machine: &Machine, path: &str) -> bool {
    let name = without_numbers(path);
    machine.spatial().is_some()
        && !machine.format().is_some_and(PhotonFormat::half_steps)
        && SQUARES.iter().any(|holder| ends_with_name(&name, holder))
}

/// The roles of the nodes in a signal's name.
pub(super) fn roles(machine: &Machine, path: &str) -> impl Iterator<Item = Role> {
    let hypercube = machine.hypercube();
    let numbers = path.split(['.', '_']).filter_map(|name| name.parse().ok());
    let nodes = numbers.filter(move |&node| node < hypercube.nodes());
    nodes.map(move |node| hypercube.role(node))
}

fn without_numbers(path: &str) -> String {
    let names = path.split(['.', '_']);
    let names: Vec<_> = names
        .filter(|name| name.parse::<usize>().is_err())
        .collect();
    names.join("_")
}

/// Whether a path ends with these whole names.
fn ends_with_name(path: &str, name: &str) -> bool {
    let before = path.strip_suffix(name);
    before.is_some_and(|before| before.is_empty() || before.ends_with('_'))
}

fn word_bits(machine: &Machine, role: Role, word: Word) -> u32 {
    match word {
        Word::Sum => power_bits(machine, role, machine.max_photons()),
        _ if machine.organisation == Organisation::Overlapped => {
            overlapped_bits(machine, role, word)
        }
        _ => sequential_bits(machine, role, word),
    }
}

/// The bits of a word in a sequential machine. The program sends one square to the cells of x and y, and two
/// squares to those of z and d. At the end it sends every cell the powers of the other half of the group.
fn sequential_bits(machine: &Machine, role: Role, word: Word) -> u32 {
    let two_squares = two_squares_bits(machine);
    let group = machine.photons_per_iteration() as u64;
    match word {
        Word::Link => {
            let gets_one = matches!(role, Role::X | Role::Y);
            let squares = two_squares - u32::from(gets_one);
            power_bits(machine, role, group / 2).max(squares)
        }
        _ => power_bits(machine, role, group).max(two_squares + 1),
    }
}

/// The bits of a word in an overlapped machine. The third square is added in the cells of z and d, which send
/// the sum along w.
fn overlapped_bits(machine: &Machine, role: Role, word: Word) -> u32 {
    let from = match word {
        Word::Link => role.across(Axis::W),
        _ => role,
    };
    two_squares_bits(machine) + u32::from(matches!(from, Role::Z | Role::D))
}

/// The bits of a sum of two squares of coordinates.
fn two_squares_bits(machine: &Machine) -> u32 {
    2 * Widths::of(machine).difference + 1
}

/// The bits of the power of `photons` photons, or of their count.
fn power_bits(machine: &Machine, role: Role, photons: u64) -> u32 {
    bits_of(full_scale(machine, role) * u128::from(photons))
}

/// The most that a photon adds to a cell's sum: a channel of its power, or 1 where photons are counted.
fn full_scale(machine: &Machine, role: Role) -> u128 {
    let channels = machine.channels().count() as usize;
    match role.coordinate() {
        Some(channel) if channel < channels => machine.full_scale(),
        Some(_) => 0,
        None => 1,
    }
}

/// The bits of a number; 0 for the number 0.
fn bits_of(number: u128) -> u32 {
    u128::BITS - number.leading_zeros()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    fn words(machine: &str) -> Words<'static> {
        Words::of(find_machine(machine).unwrap()).unwrap()
    }

    #[test]
    fn a_cell_uses_what_its_role_is_given() {
        let mono = words("fit-ring");
        // One bit of power, 2^13 photons; 8 bits of a difference.
        assert_eq!(mono.bits("cell_0.sum_q"), Some(14));
        assert_eq!(mono.bits("ports.sum_4"), Some(0));
        assert_eq!(mono.bits("result_power"), Some(14));
        assert_eq!(mono.bits("network.link_0"), Some(16));
        assert_eq!(mono.bits("cell_8.add_unit.b"), Some(17));
        assert_eq!(mono.bits("cell_8.work_out"), Some(18));
        assert_eq!(mono.bits("cell_8.write_sum"), None, "a sum's, not a sum");
        let coloured = words("local");
        // Powers of 32 bits, 2^20 photons.
        assert_eq!(coloured.bits("cell_4.sum_q"), Some(52));
        assert_eq!(coloured.bits("cell_4.work.q"), Some(34));
        assert_eq!(coloured.bits("cell_12.sum_q"), Some(21));
        assert_eq!(coloured.bits("cell_12.work.q"), Some(18));
    }

    #[test]
    fn in_an_overlapped_machine_two_roles_add_the_third_square() {
        let overlap = words("overlap");
        for (node, own, link, sum) in [
            (0, 17, 18, 32),
            (4, 17, 18, 32),
            (8, 18, 17, 32),
            (12, 18, 17, 17),
        ] {
            let bits = |name: &str| overlap.bits(&format!("cell_{node}.{name}"));
            assert_eq!(bits("work.q"), Some(own));
            assert_eq!(bits("link_w"), Some(link));
            assert_eq!(bits("chosen_sum.sum"), Some(sum));
        }
    }

    #[test]
    fn squares_are_known_by_their_names() {
        let machine = find_machine("tile-6-mixed").unwrap();
        for path in [
            "engine_1.lane_2.pair_sum.wide_a",
            "engine_1.lane_2.distance_sum_b",
            "engine_0.square_pair_3.lookup_0.square_table.lookup_b",
            "engine_2.lane_0_axis_square_1",
        ] {
            assert!(is_square(machine, path), "{path}");
        }
        for path in [
            "engine_1.lane_2.distance_sum.a",
            "engine_1.lane_2.pair_sum_sum",
            "engine_1.square_pair_0.digits_0.cross_product",
            "engine_1.lane_2.unsquared",
        ] {
            assert!(!is_square(machine, path), "{path}");
        }
        let sequential = find_machine("paper").unwrap();
        assert!(!is_square(sequential, "cell_0.square_unit.square"));
    }

    #[test]
    fn half_squares_are_even_where_no_power_comes() {
        let mono = words("fit-ring");
        assert!(mono.are_even("cell_4.work_q"));
        assert!(!mono.are_even("cell_0.work_q"), "a power comes");
        let coloured = words("fit-cornell");
        assert!(!coloured.are_even("cell_4.work_q"), "a power comes");
        let steps = words("local");
        assert!(!steps.are_even("cell_4.work_q"), "squares of whole steps");
    }
}
