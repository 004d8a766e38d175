//! The ports of an emitted top module, each with what it carries.

use photoncube_spec::{Machine, Pin, Pins, Widths};
use serde::Serialize;

/// A port of the top module, or the same port of every lane.
#[derive(Debug, PartialEq, Eq, Serialize)]
pub struct Port {
    /// Its Verilog name, `N` in the place of the lane's number.
    pub port: String,
    /// How many there are: one, or one for each lane.
    pub instances: usize,
    /// `input` or `output`.
    pub direction: &'static str,
    /// Its width.
    pub bits: u32,
    /// What it carries, and in which unit.
    pub means: String,
}

/// All ports of a machine: the clock, then in the order in which rows of pins have them.
pub fn ports(machine: &Machine) -> Vec<Port> {
    let pins = Pins::of(machine);
    let lanes = machine.photons_per_iteration();
    let mut ports = vec![port("clock", "input", 1, 1, machine)];
    for pin in &pins.inputs {
        match lane_of(pin) {
            None => ports.push(port(&pin.name, "input", pin.width, 1, machine)),
            // The others have the same ports.
            Some((name, 0)) => {
                ports.push(port(
                    &format!("{name}_N"),
                    "input",
                    pin.width,
                    lanes,
                    machine,
                ));
            }
            Some(_) => {}
        }
    }
    for pin in &pins.observed[..pins.outputs] {
        ports.push(port(&pin.name, "output", pin.width, 1, machine));
    }
    ports
}

/// The name and the lane of a lane's pin.
fn lane_of(pin: &Pin) -> Option<(&str, usize)> {
    let (name, lane) = pin.name.rsplit_once('_')?;
    Some((name, lane.parse().ok()?))
}

fn port(
    name: &str,
    direction: &'static str,
    bits: u32,
    instances: usize,
    machine: &Machine,
) -> Port {
    Port {
        port: name.to_owned(),
        instances,
        direction,
        bits,
        means: meaning(name, machine),
    }
}

fn meaning(port: &str, machine: &Machine) -> String {
    let said = match port {
        "clock" => "registers take their values at its rising edge",
        "reset" => "synchronous, active high: clears the control block",
        "query_valid" => "a query is offered; its words stay until query_ready",
        "query_ready" => "the query of this clock is taken, if it is valid",
        "query_x" | "query_y" | "query_z" => return place(Widths::of(machine).coordinate),
        "query_radius_sq" if machine.format().is_some_and(|f| f.query_extra_bits > 0) => {
            "bound of the sum of half squares m (m + 1), inclusive"
        }
        "query_radius_sq" => "squared radius, square steps; d^2 <= it is in range",
        "query_release" => "the query's batch is the last on its set of photons",
        "group_valid" => "a group is offered; its words stay until group_ready",
        "group_last" => "the group is the last of its query, or of its batch",
        "group_ready" => "the group of this clock is taken, if it is valid",
        "photon_present_N" => "lane N has a photon; else its words count for nothing",
        "photon_x_N" | "photon_y_N" | "photon_z_N" => return place(Widths::of(machine).photon),
        "photon_exponent_N" => "exponent of the photon's powers",
        "result_valid" => "a result is there; it stays until result_ready",
        "result_ready" => "the result of this clock is taken, if it is valid",
        "result_count" => "photons in range",
        sum if sum.starts_with("result_") => "sum of the powers in range, in power steps",
        _ if machine.has_exponent() => "mantissa of a power: power = mantissa << exponent",
        _ => "power, in power steps",
    };
    said.to_owned()
}

/// A coordinate of so many bits, which span the frame's [`Machine::FRAME_BLOCKS`] block edges.
fn place(bits: u32) -> String {
    let steps = (1_u64 << bits) / u64::from(Machine::FRAME_BLOCKS);
    format!("place in the frame, unsigned, in 1/{steps} block edge")
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{MACHINES, find_machine};

    use super::*;

    #[test]
    fn every_port_of_the_emitted_module_is_told_once_with_its_width_and_direction() {
        for machine in MACHINES {
            let pins = Pins::of(machine);
            let told: usize = ports(machine).iter().map(|port| port.instances).sum();
            assert_eq!(
                told,
                1 + pins.inputs.len() + pins.outputs,
                "{}",
                machine.name
            );
        }
        let text = include_str!("../../../../../hdl-out/paper/photoncube_paper.v");
        for port in ports(find_machine("paper").unwrap()) {
            let width = match port.bits {
                1 => String::new(),
                bits => format!("[{}:0] ", bits - 1),
            };
            let kind = if port.direction == "input" {
                "wire"
            } else {
                "reg"
            };
            for lane in 0..port.instances {
                let name = port.port.replace("_N", &format!("_{lane}"));
                let line = format!("    {} {kind} {width}{name};", port.direction);
                assert!(text.contains(&line), "{line}");
            }
        }
    }

    #[test]
    fn words_are_told_in_the_machines_own_units() {
        let means = |machine, port| {
            let ports = ports(find_machine(machine).unwrap());
            let found = ports.into_iter().find(|found| found.port == port);
            found.unwrap().means
        };
        // 8 bits for four block edges; 9 bits, one of them the query's half steps.
        assert!(means("paper", "query_x").contains("1/64 block edge"));
        assert!(means("local-half", "query_x").contains("1/512 block edge"));
        assert!(means("local-half", "photon_x_N").contains("1/256 block edge"));
        assert!(means("local", "photon_red_N").contains("mantissa << exponent"));
        assert!(means("fit-ring", "photon_power_N").starts_with("power, in power steps"));
        assert!(means("chip-lut", "query_release").contains("last on its set"));
    }
}
