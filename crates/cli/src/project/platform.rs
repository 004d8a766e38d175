//! The component of a core for Intel's Platform Designer.

use std::fmt::Write as _;

use photoncube_spec::{Core, Direction, Port};

const CLOCK: &str = "aclk";
const RESET: &str = "aresetn";
const BUS: &str = "s_axi";

/// What belongs to one clock and its reset.
const SYNCHRONOUS: &[(&str, &str)] = &[("associatedClock", CLOCK), ("associatedReset", RESET)];

/// An interface of the component. Its ports begin with its name and `_`, and their roles are the rests of their names.
struct Interface {
    name: &'static str,
    kind: &'static str,
    /// `end` for a sink, a slave or an interrupt's sender, `start` for a source.
    side: &'static str,
    /// The role of the port that is the whole interface, where there is one.
    role: Option<&'static str>,
    properties: &'static [&'static [(&'static str, &'static str)]],
}

const INTERFACES: [Interface; 7] = [
    Interface {
        name: CLOCK,
        kind: "clock",
        side: "end",
        role: Some("clk"),
        properties: &[],
    },
    Interface {
        name: RESET,
        kind: "reset",
        side: "end",
        role: Some("reset_n"),
        properties: &[&[("associatedClock", CLOCK), ("synchronousEdges", "BOTH")]],
    },
    Interface {
        name: BUS,
        kind: "axi4lite",
        side: "end",
        role: None,
        // One access of each kind at a time.
        properties: &[
            SYNCHRONOUS,
            &[
                ("readAcceptanceCapability", "1"),
                ("writeAcceptanceCapability", "1"),
                ("combinedAcceptanceCapability", "2"),
            ],
        ],
    },
    stream("s_axis_photons", "end"),
    stream("s_axis_queries", "end"),
    stream("m_axis_results", "start"),
    Interface {
        name: "irq",
        kind: "interrupt",
        side: "end",
        role: Some("irq"),
        properties: &[SYNCHRONOUS, &[("associatedAddressablePoint", BUS)]],
    },
];

const fn stream(name: &'static str, side: &'static str) -> Interface {
    Interface {
        name,
        kind: "axi4stream",
        side,
        role: None,
        properties: &[SYNCHRONOUS],
    }
}

impl Interface {
    /// The role of a port, if the interface has it.
    fn role(&self, port: &Port) -> Option<String> {
        match self.role {
            Some(role) => (port.name == self.name).then(|| role.to_owned()),
            None => {
                let rest = port.name.strip_prefix(self.name)?;
                rest.strip_prefix('_').map(str::to_owned)
            }
        }
    }

    fn text(&self, ports: &[Port]) -> String {
        let Self {
            name, kind, side, ..
        } = self;
        let mut text = format!("\nadd_interface {name} {kind} {side}\n");
        for (property, value) in self.properties.iter().copied().flatten() {
            let _ = writeln!(text, "set_interface_property {name} {property} {value}");
        }
        for port in ports {
            if let Some(role) = self.role(port) {
                let direction = match port.direction {
                    Direction::Input => "Input",
                    Direction::Output => "Output",
                };
                let (port, width) = (&port.name, port.width);
                let _ = writeln!(
                    text,
                    "add_interface_port {name} {port} {role} {direction} {width}"
                );
            }
        }
        text
    }
}

/// The file `TOP_hw.tcl` of a core.
pub fn text(core: &Core) -> String {
    let (name, top, version) = (core.name(), core.top(), env!("CARGO_PKG_VERSION"));
    let (machine, chains) = (core.machine.name, core.chains);
    let ports = core.ports();
    let interfaces: String = INTERFACES
        .iter()
        .map(|interface| interface.text(&ports))
        .collect();
    format!(
        "# The component {name} for Intel's Platform Designer, which finds this file by its name on its search path.\n\
         # Written by photoncube {version}, `photoncube generate --machine {machine} --chains {chains}`; do not edit.\n\
         package require -exact qsys 16.1\n\
         \n\
         set_module_property NAME {top}\n\
         set_module_property VERSION {version}\n\
         set_module_property DISPLAY_NAME \"Photoncube {name}\"\n\
         set_module_property DESCRIPTION \"{chains} chains of {machine} behind AXI4-Stream and AXI4-Lite\"\n\
         set_module_property GROUP Photoncube\n\
         set_module_property INTERNAL false\n\
         set_module_property EDITABLE false\n\
         \n\
         foreach fileset {{QUARTUS_SYNTH SIM_VERILOG}} {{\n    \
         add_fileset $fileset $fileset \"\" \"\"\n    \
         set_fileset_property $fileset TOP_LEVEL {top}\n    \
         add_fileset_file {top}.v VERILOG PATH {top}.v TOP_LEVEL_FILE\n\
         }}\n\
         {interfaces}"
    )
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    #[test]
    fn every_port_has_one_interface_and_one_role() {
        let core = Core::new(find_machine("leaf-5-local7-rgb6d-n64").unwrap(), 3).unwrap();
        for port in core.ports() {
            let roles: Vec<_> = INTERFACES
                .iter()
                .filter_map(|interface| interface.role(&port))
                .collect();
            assert_eq!(roles.len(), 1, "{}: {roles:?}", port.name);
        }
        let text = text(&core);
        assert!(
            text.contains(
                "\nadd_interface_port s_axis_queries s_axis_queries_tdest tdest Input 2\n"
            )
        );
        assert!(text.contains("\nadd_interface_port irq irq irq Output 1\n"));
    }
}
