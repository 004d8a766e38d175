//! The reasons why some points cannot be used by any stimulus.

use photoncube_hdl::Emitted;
use photoncube_spec::{LeafSizes, Machine, Organisation, PhotonFormat, Role, Squarer, Widths};

use super::constants::{Constants, constants};
use super::points::{CoverageKind, Point};
use super::words::{self, Words};
use crate::device::{DeviceError, hdl_error};

/// The knowledge about a machine's points.
pub(super) struct Why<'a> {
    pub words: Words<'a>,
    pub constants: Constants,
}

impl<'a> Why<'a> {
    /// # Errors
    /// The machine's widths are not built in, or Yosys is missing or fails.
    pub fn new(machine: &'a Machine, design: &Emitted) -> Result<Self, DeviceError> {
        Ok(Self {
            words: Words::of(machine).map_err(hdl_error(machine))?,
            constants: constants(design)?,
        })
    }

    /// The reason why a point cannot be used; `None` if there is none. `name` and `bit` are those of the
    /// point's signal.
    pub fn reason(&self, point: &Point, name: &str, bit: Option<u32>) -> Option<&'static str> {
        let path = path(point, name);
        if point.kind == CoverageKind::Toggle
            && self.constants.contains(&(path.clone(), bit.unwrap_or(0)))
        {
            return Some("constant in this instance, by Yosys");
        }
        RULES
            .iter()
            .filter(|rule| rule.kind == point.kind)
            .find(|rule| (rule.holds)(&self.words, point, &path, bit.unwrap_or(0)))
            .map(|rule| rule.why)
    }
}

/// The path in the top instance of a point's signal of that name.
pub(super) fn path(point: &Point, name: &str) -> String {
    match point.instance.as_str() {
        "" => name.to_owned(),
        instance => format!("{instance}.{name}"),
    }
}

/// A reason that is written by hand, and not found by a tool.
struct Rule {
    kind: CoverageKind,
    /// Whether the reason applies to this bit of a signal, or to this point. The path is that in the top
    /// instance.
    holds: fn(&Words<'_>, &Point, &str, u32) -> bool,
    why: &'static str,
}

const RULES: &[Rule] = &[
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| words.bits(path).is_some_and(|bits| bit >= bits),
        why: "all cells have the widest cell's registers; with this cell's role a distance, a power or a count is shorter",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| bit == 0 && words.are_even(path),
        why: "a half square, m (m + 1), is even, and no power comes to this cell",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, _| {
            words.machine.microprogram().is_some()
                && words::roles(words.machine, path).any(|role| role == Role::D)
                && path.contains("square")
        },
        why: "a cell that counts photons has no coordinates: its square is always that of zeros",
    },
    Rule {
        kind: CoverageKind::Toggle,
        // 2 * 15 * 15 * 16 < 2^13.
        holds: |words, _, path, bit| {
            words.machine.organisation == Organisation::Overlapped
                && path.ends_with(".products")
                && bit >= 13
        },
        why: "twice the product of two digits of four bits, times 16, ends below",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| {
            let is_square = ["square", "squarer_square", "square_unit_square"];
            let name = path.rsplit('.').next().unwrap_or(path);
            words.machine.squarer == Squarer::Product
                && words.machine.spatial().is_none()
                && is_square.contains(&name)
                && bit == 1
        },
        why: SQUARES,
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| bit == 1 && words::is_square(words.machine, path),
        why: SQUARES,
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| bit == 0 && words::is_half_square(words.machine, path),
        why: "a half square, m (m + 1), is even, and so is a sum of half squares",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| {
            let product = Widths::of(words.machine).product();
            words.machine.spatial().is_some() && path.ends_with(".squared") && bit >= product
        },
        why: "a difference of coordinates of n bits is never -2^n, whose square alone has 2 n + 1 bits",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, _| {
            let last = format!("engine_{}", words.machine.queries_at_once() - 1);
            let leaves = ["_out", "_d", "_q", ".d", ".q"]
                .iter()
                .any(|end| path.ends_with(end));
            // The chain of a leaf machine is an instance.
            let of_chain = path.strip_prefix("chain.").unwrap_or(path);
            of_chain.starts_with(&last) && path.contains("token_valid") && leaves
        },
        why: "behind the last engine is none that a query could go on to",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| {
            let cleared = [
                ("player.rest", 1),
                ("player.rest_but_one", 2),
                ("player.mask_but_one", 1),
            ];
            let is_cleared = |&(name, bits): &(&str, u32)| path == name && bit < bits;
            words.machine.leaf().is_some() && cleared.iter().any(is_cleared)
        },
        why: "the lowest one of a mask is cleared, so its lowest bit is 0; behind two such steps its two lowest bits are",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, bit| {
            is_register(path, "player.spacing")
                && leaf_sizes(words).is_some_and(|sizes| bit >= bits_of(clocks_counted(sizes)))
        },
        why: SPACING,
    },
    Rule {
        kind: CoverageKind::Branch,
        holds: |words, point, path, _| {
            point.module == "player"
                && path.ends_with("if of `if (~is_spaced) begin`")
                && leaf_sizes(words).is_some_and(|sizes| clocks_counted(sizes) == 0)
        },
        why: SPACING,
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |words, _, path, _| is_register(path, "tags.tag_result") && has_one_engine(words),
        why: FIRST_IS_LAST,
    },
    Rule {
        kind: CoverageKind::Branch,
        holds: |words, point, path, _| {
            point.module == "tags"
                && path.ends_with("else of `if (is_last) begin`")
                && has_one_engine(words)
        },
        why: FIRST_IS_LAST,
    },
    Rule {
        kind: CoverageKind::User,
        holds: |words, _, path, _| {
            words.machine.microprogram().is_some() && path == "group_is_awaited"
        },
        why: "this machine's `group_ready` follows `group_valid`",
    },
    Rule {
        kind: CoverageKind::Line,
        holds: |_, point, path, _| point.module == "store" && path.contains("default:"),
        why: "no program reaches an address behind its end",
    },
    Rule {
        kind: CoverageKind::Line,
        holds: |words, point, path, _| {
            let is_half = words.machine.format().is_some_and(PhotonFormat::half_steps);
            let high_bits = Widths::of(words.machine)
                .difference
                .saturating_sub(DIGIT_BITS);
            point.module == "squarer"
                && is_half
                && high_bits < DIGIT_BITS
                && square_digit(path).is_some_and(|digit| digit >= 1 << high_bits)
        },
        why: "of a half square the high digit alone is squared, and it has fewer bits than a digit",
    },
];

/// The reason for what a player does not count between two last groups.
const SPACING: &str = "the player counts the clocks between two last groups, less two, which this machine leaves in fewer bits or not at all";

/// The reason for what a batch of several results would use.
const FIRST_IS_LAST: &str = "with one engine the first result of a batch is its last";

/// The sizes of a leaf machine.
fn leaf_sizes(words: &Words<'_>) -> Option<LeafSizes> {
    words.machine.leaf().map(LeafSizes::of)
}

fn has_one_engine(words: &Words<'_>) -> bool {
    leaf_sizes(words).is_some_and(|sizes| sizes.engines == 1)
}

/// The most that a leaf machine's player counts between two last groups: in one of the clocks between it finds that it may go on, in
/// another the group is played.
fn clocks_counted(sizes: LeafSizes) -> u32 {
    sizes.least_spacing.saturating_sub(2)
}

fn bits_of(largest: u32) -> u32 {
    u32::BITS - largest.leading_zeros()
}

/// Whether the path is that of a register, or of a wire to or from it.
fn is_register(path: &str, register: &str) -> bool {
    let end = path.strip_prefix(register);
    end.is_some_and(|end| ["_d", "_q", ".d", ".q"].contains(&end))
}

/// The reason for bit 1 of every square of a whole number.
const SQUARES: &str = "a square is 0 or 1 modulo 4";

/// Bits of a digit of a square.
const DIGIT_BITS: u32 = 4;

/// The digit whose square a line of the squarer's table has.
fn square_digit(path: &str) -> Option<u32> {
    let (label, _) = path.split_once(": digit_square")?;
    let largest = (1 << DIGIT_BITS) - 1;
    match label.rsplit_once("'d") {
        Some((_, digit)) => digit.parse().ok(),
        None => label.ends_with("default").then_some(largest),
    }
}
