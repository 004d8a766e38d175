//! A machine's ports: one row for each kind of pin.

use crate::formats::Numbers;
use crate::machine::Machine;
use crate::pins::{Pin, Pins};

/// The direction of a port.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Into the machine.
    Input,
    /// Out of it.
    Output,
}

impl Direction {
    /// The direction as a Verilog keyword.
    pub fn name(self) -> &'static str {
        match self {
            Self::Input => "input",
            Self::Output => "output",
        }
    }
}

/// A port of a machine's top module, or the ports of all lanes that differ only in the lane's number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// The port's name; `photon_x_0..3` means the ports of lanes 0 to 3.
    pub name: String,
    /// The port's width in bits; for several lanes, the width of each.
    pub width: u32,
    /// The port's direction.
    pub direction: Direction,
    /// The port's meaning, with its unit.
    pub meaning: String,
}

/// All ports of a machine: the clock, then the others in the order of [`Pins`].
pub(super) fn ports(machine: &Machine) -> Vec<Port> {
    let pins = Pins::of(machine);
    let outputs = &pins.observed[..pins.outputs];
    let clock = Port {
        name: "clock".to_owned(),
        width: 1,
        direction: Direction::Input,
        meaning: "every register changes at its rising edge".to_owned(),
    };
    let mut ports = vec![clock];
    for (direction, pins) in [
        (Direction::Input, pins.inputs.as_slice()),
        (Direction::Output, outputs),
    ] {
        ports.extend(pins.iter().filter_map(|pin| port(machine, pin, direction)));
    }
    ports
}

/// The port of a pin; `None` for the pin of a lane that the first lane's port represents.
fn port(machine: &Machine, pin: &Pin, direction: Direction) -> Option<Port> {
    let last_lane = machine.photons_per_iteration() - 1;
    let (stem, name) = match lane_of(&pin.name) {
        None => (pin.name.as_str(), pin.name.clone()),
        Some((stem, 0)) => (stem, format!("{stem}_0..{last_lane}")),
        Some(_) => return None,
    };
    Some(Port {
        name,
        width: pin.width,
        direction,
        meaning: meaning(machine, stem),
    })
}

/// Splits `photon_x_2` into its stem and its lane.
fn lane_of(name: &str) -> Option<(&str, usize)> {
    let (stem, lane) = name.rsplit_once('_')?;
    let lane = lane.parse().ok()?;
    name.starts_with("photon_").then_some((stem, lane))
}

fn meaning(machine: &Machine, stem: &str) -> String {
    let text = match stem {
        "reset" => "synchronous, active high; one clock is enough, and what is taken in it is lost",
        "query_valid" => "a query is on the query_ pins",
        "query_ready" => "the query is taken at this edge, if it is valid",
        "query_x" | "query_y" | "query_z" => return coordinate(machine, true),
        "query_radius_sq" => return radius_sq(machine),
        "query_release" => {
            "any query of a batch may set it: the set of photons is given up behind that batch"
        }
        "query_last" => {
            "the query is the last of its batch, which may have fewer queries than the machine has engines"
        }
        "query_facings" => {
            "the facings that the batch gathers, bit i for facing i; those of its first query count"
        }
        "query_tag" => "any number; the query's result has it",
        "group_valid" => "a group is on the group_ and photon_ pins",
        "group_ready" => "the group is taken at this edge, if it is valid",
        "group_facing" => "the facing of the leaf's photons; that with its last group counts",
        "group_last" if machine.keeps_sets() => "this group ends its set",
        "group_last" if machine.queries_at_once() == 1 => "this group is the last of its query",
        "group_last" => "this group is the last of its batch of queries",
        "photon_present" => {
            "the lane has a photon; where it is 0, the lane's other pins are not looked at"
        }
        "photon_x" | "photon_y" | "photon_z" => return coordinate(machine, false),
        "photon_red" | "photon_green" | "photon_blue" | "photon_power" => return power(machine),
        "photon_exponent" => return exponent(machine),
        "result_valid" => "a result is on the result_ pins; it stays until it is taken",
        "result_ready" => "the result is taken at this edge, if it is valid",
        "result_tag" => "the tag of the result's query; 0 where there is no result",
        "compared" => "leaves whose boxes are compared in this clock, for a counter",
        "wanted" => "leaves that a comparison finds wanted in this clock, for a counter",
        "played" => "the engines are given a group in this clock, for a counter",
        "result_count" => "photons in range",
        "result_red" | "result_green" | "result_blue" | "result_power" => {
            "sum of the powers in range, in power units"
        }
        _ => "",
    };
    text.to_owned()
}

fn coordinate(machine: &Machine, of_query: bool) -> String {
    let frame = Numbers::FRAME_BLOCKS;
    match &machine.numbers {
        Numbers::Plain(format) => format!(
            "unsigned; steps of 2^-{} block edge, in a frame of {frame} block edges",
            format.position_bits()
        ),
        Numbers::Local(format) => {
            let bits = match of_query {
                true => format.radius_bits(),
                false => format.position_bits,
            };
            let stands = match (of_query, format.query_extra_bits) {
                (_, 0) | (true, _) => "stands for the cell's middle".to_owned(),
                (false, extra) => format!(
                    "stands for its middle, query step {} i + {}",
                    1_u32 << extra,
                    1_u32 << (extra - 1)
                ),
            };
            format!(
                "unsigned; cell i of 2^-{bits} block edge, in a frame of {frame} block edges; {stands}"
            )
        }
    }
}

fn radius_sq(machine: &Machine) -> String {
    let Some(format) = machine.format() else {
        return "squared search radius in square steps; in range where d^2 <= query_radius_sq"
            .to_owned();
    };
    let (least, radius) = (format.largest_in_range(), format.radius_steps());
    match format.half_steps() {
        false => format!(
            "squared search radius in square query steps, at most {least} = {radius}^2; in range where \
             d^2 <= query_radius_sq"
        ),
        true => format!(
            "a search radius of R query steps is R^2 - 1, at most {least} = {radius}^2 - 1; in range where the sum \
             of m (m + 1) <= query_radius_sq, m the difference on an axis less a half"
        ),
    }
}

/// Whether the meaning of a port names a limit below the largest word of the port.
pub(super) fn has_limits(machine: &Machine) -> bool {
    let radius_on_pins = machine.fixed_radius_sq().is_none();
    machine.has_exponent() || (radius_on_pins && machine.format().is_some())
}

fn power(machine: &Machine) -> String {
    match machine.has_exponent() {
        false => "unsigned; power units".to_owned(),
        true => {
            "unsigned mantissa; the power is mantissa << photon_exponent power units".to_owned()
        }
    }
}

fn exponent(machine: &Machine) -> String {
    let most = machine.numbers.power().exponent_range();
    format!("0 to {most}; more is not defined")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::MACHINES;

    #[test]
    fn every_pin_of_every_machine_has_one_port_and_a_meaning() {
        for machine in MACHINES {
            let pins = Pins::of(machine);
            let pins = pins.inputs.len() + pins.outputs;
            let lanes = machine.photons_per_iteration();
            let count = |port: &Port| if port.name.contains("..") { lanes } else { 1 };
            let ports = ports(machine);
            assert_eq!(ports.iter().map(count).sum::<usize>(), 1 + pins);
            for port in ports {
                assert!(!port.meaning.is_empty(), "{}: {}", machine.name, port.name);
            }
        }
    }

    #[test]
    fn a_machine_has_limits_where_a_port_names_one() {
        let names_limit = |port: &Port| {
            ["at most", "0 to"]
                .iter()
                .any(|word| port.meaning.contains(word))
        };
        for machine in MACHINES {
            let named = ports(machine).iter().any(names_limit);
            assert_eq!(has_limits(machine), named, "{}", machine.name);
        }
        let limits = |name| has_limits(crate::machines::find_machine(name).unwrap());
        assert!(!limits("paper") && !limits("tile-6") && limits("stream") && limits("fit-range"));
    }

    #[test]
    fn only_a_machine_of_several_queries_has_batches_on_its_ports() {
        for machine in MACHINES {
            let ports = ports(machine);
            let last = ports.iter().find(|port| port.name == "group_last").unwrap();
            let names_batch = last.meaning.contains("batch");
            assert!(
                !names_batch || machine.queries_at_once() > 1,
                "{}",
                machine.name
            );
        }
    }
}
