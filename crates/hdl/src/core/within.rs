//! A core in a module of another name, as tools expect it.

use std::fmt::Write as _;

use photoncube_spec::Core;

use super::EmittedCore;

/// The text of a module with the ports of a core, and the core in it. The module's clock has the name `clock`; the other ports
/// have their names. The text does not have that of the core.
pub fn core_within(module: &str, clock: &str, core: &Core, emitted: &EmittedCore) -> String {
    let ports = core.ports();
    let (own_clock, others) = ports.split_first().expect("a core has a clock");
    let names: Vec<_> = others.iter().map(|port| port.name.as_str()).collect();
    let mut text = format!(
        "\nmodule {module}({clock}, {});\n    input wire {clock};\n",
        names.join(", ")
    );
    for port in others {
        let _ = writeln!(
            text,
            "    {} wire [{}:0] {};",
            port.direction.name(),
            port.width - 1,
            port.name
        );
    }
    let connections = names.iter().map(|name| format!(".{name}({name})"));
    let connections: Vec<_> = connections.collect();
    let _ = writeln!(
        text,
        "    {} core(.{}({clock}), {});\nendmodule",
        emitted.top,
        own_clock.name,
        connections.join(", ")
    );
    text
}
