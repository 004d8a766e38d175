//! Why some points cannot be used, whatever the stimulus.

use photoncube_hdl::Emitted;
use photoncube_spec::{Machine, PhotonFormat, Role, Squarer, Widths};

use super::constants::{Constants, constants};
use super::points::{CoverageKind, Point};
use crate::device::DeviceError;

/// What is known of a machine's points.
pub(super) struct Why<'a> {
    pub machine: &'a Machine,
    pub constants: Constants,
}

impl<'a> Why<'a> {
    /// # Errors
    /// Yosys does not run.
    pub fn new(machine: &'a Machine, design: &Emitted) -> Result<Self, DeviceError> {
        Ok(Self {
            machine,
            constants: constants(design)?,
        })
    }

    /// Why a point cannot be used, where that is known. `name` and `bit` are its signal's.
    pub fn reason(&self, point: &Point, name: &str, bit: Option<u32>) -> Option<&'static str> {
        let path = match point.instance.as_str() {
            "" => name.to_owned(),
            instance => format!("{instance}.{name}"),
        };
        if point.kind == CoverageKind::Toggle
            && self.constants.contains(&(path.clone(), bit.unwrap_or(0)))
        {
            return Some("constant in this instance, by Yosys");
        }
        RULES
            .iter()
            .filter(|rule| rule.kind == point.kind)
            .find(|rule| (rule.holds)(self.machine, point, &path, bit.unwrap_or(0)))
            .map(|rule| rule.why)
    }
}

/// A reason that is not found by a tool.
struct Rule {
    kind: CoverageKind,
    /// Whether it is about this bit (of a signal) or point; the path is in the top instance.
    holds: fn(&Machine, &Point, &str, u32) -> bool,
    why: &'static str,
}

const RULES: &[Rule] = &[
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, bit| {
            machine.spatial().is_none()
                && counts_photons(machine, path)
                && bit >= count_bits(machine)
        },
        why: "a cell that counts photons has sums as wide as those of power; the count is shorter",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, bit| {
            let most = machine.max_photons();
            counts_photons(machine, path)
                && path.ends_with("sum_low")
                && most.is_power_of_two()
                && bit + 1 == count_bits(machine)
        },
        why: "a power of two, the most photons, is never added to",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, _| {
            machine.microprogram().is_some()
                && counts_photons(machine, path)
                && path.contains("square")
        },
        why: "a cell that counts photons has no coordinates: its square is always that of zeros",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, bit| {
            machine.spatial().is_none() && crosses_nodes(path) && bit >= link_bits(machine, path)
        },
        why: "a link has the width of the work register; what crosses it is part of a distance, or half a group's powers",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, bit| {
            machine.overlap_program().is_some()
                && adds_squares(path)
                && bit >= two_squares_bits(machine)
        },
        why: "of a quad's cells only those that add the third square have the full squared distance",
    },
    Rule {
        kind: CoverageKind::Toggle,
        // 2 * 15 * 15 * 16 < 2^13.
        holds: |machine, _, path, bit| {
            machine.overlap_program().is_some() && path.ends_with(".products") && bit >= 13
        },
        why: "twice the product of two digits of four bits, times 16, ends below",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, bit| {
            let is_square = ["square", "squarer_square", "square_unit_square"];
            let name = path.rsplit('.').next().unwrap_or(path);
            machine.squarer == Squarer::Product && is_square.contains(&name) && bit == 1
        },
        why: "a square is 0 or 1 modulo 4",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, _| {
            let last = format!("engine_{}", machine.queries_at_once() - 1);
            path.starts_with(&last) && path.contains("token_valid")
        },
        why: "behind the last engine is none that a query could go on to",
    },
    Rule {
        kind: CoverageKind::User,
        holds: |machine, _, path, _| machine.spatial().is_none() && path == "group_is_awaited",
        why: "this machine's `group_ready` follows `group_valid`",
    },
    Rule {
        kind: CoverageKind::Line,
        holds: |_, point, path, _| point.module == "store" && path.contains("default:"),
        why: "no program reaches an address behind its end",
    },
    Rule {
        kind: CoverageKind::Line,
        holds: |machine, point, path, _| {
            let is_half = machine.format().is_some_and(PhotonFormat::half_steps);
            let high_bits = Widths::of(machine).difference.saturating_sub(DIGIT_BITS);
            point.module == "squarer"
                && is_half
                && high_bits < DIGIT_BITS
                && square_digit(path).is_some_and(|digit| digit >= 1 << high_bits)
        },
        why: "of a half square the high digit alone is squared, and it has fewer bits than a digit",
    },
];

/// The roles of the nodes that a signal is named after.
fn roles(machine: &Machine, path: &str) -> impl Iterator<Item = Role> {
    let hypercube = machine.hypercube();
    let numbers = path.split(['.', '_']).filter_map(|name| name.parse().ok());
    let nodes = numbers.filter(move |&node| node < hypercube.nodes());
    nodes.map(move |node| hypercube.role(node))
}

/// Whether a signal belongs to a cell that counts photons: each quad's last.
fn counts_photons(machine: &Machine, path: &str) -> bool {
    path.contains("result_count") || roles(machine, path).any(|role| role == Role::D)
}

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

/// Bits of the largest number of photons.
fn count_bits(machine: &Machine) -> u32 {
    machine.max_photons().ilog2() + 1
}

/// Whether a signal is a link between cells or leads to one.
fn crosses_nodes(path: &str) -> bool {
    path.contains("link") || path.contains("w_out")
}

/// Whether a signal of an overlapped machine's cell holds squares or their sums.
fn adds_squares(path: &str) -> bool {
    const HOLDERS: [&str; 4] = ["from_quad", "from_role_axes", "from_w", "work"];
    HOLDERS.iter().any(|holder| path.contains(holder))
}

/// Bits of a sum of two squares of coordinates.
fn two_squares_bits(machine: &Machine) -> u32 {
    2 * Widths::of(machine).difference + 1
}

/// Bits of the largest word that the link of a signal carries. Where one adder adds all, the cells of x and y get a square
/// and that of z, which d leaves alone, and each cell at last the powers of the other half of the group.
fn link_bits(machine: &Machine, path: &str) -> u32 {
    let two_squares = two_squares_bits(machine);
    if machine.overlap_program().is_some() {
        return two_squares;
    }
    let role = roles(machine, path).next();
    let gets_one = matches!(role, Some(Role::X | Role::Y));
    let squares = two_squares - u32::from(gets_one);
    let half = machine.photons_per_iteration() as u128 / 2;
    let powers = (machine.full_scale() * half).ilog2() + 1;
    squares.max(powers)
}
