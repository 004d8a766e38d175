//! Why some points cannot be used, whatever the stimulus.

use photoncube_hdl::Emitted;
use photoncube_spec::{Machine, Role, Widths};

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
            machine.spatial().is_none() && crosses_nodes(path) && bit == link_bits(machine)
        },
        why: "a link has the width of a squared distance; what crosses it is at most a sum of two squares",
    },
    Rule {
        kind: CoverageKind::Toggle,
        holds: |machine, _, path, bit| {
            machine.overlap_program().is_some() && adds_squares(path) && bit == link_bits(machine)
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
];

/// Whether a signal belongs to a cell that counts photons: each quad's last.
fn counts_photons(machine: &Machine, path: &str) -> bool {
    let hypercube = machine.hypercube();
    let names = path.split(['.', '_']);
    let mut nodes = names.filter_map(|name| name.parse::<usize>().ok());
    path.contains("result_count")
        || nodes.any(|node| node < hypercube.nodes() && hypercube.role(node) == Role::D)
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
fn link_bits(machine: &Machine) -> u32 {
    2 * Widths::of(machine).difference + 1
}
