//! A core under the name of a clock that tools expect.

use std::fmt::Write as _;

use photoncube_spec::Core;

use super::EmittedCore;

/// A module around a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CoreWithClock {
    /// The name of the module.
    pub top: String,
    /// Its text, without that of the core.
    pub text: String,
}

/// A module with the ports of a core, but that the clock's name is `clock`, as that of every machine is.
pub fn core_with_clock(core: &Core, emitted: &EmittedCore) -> CoreWithClock {
    let top = format!("{}_with_clock", emitted.top);
    let ports = core.ports();
    let (clock, others) = ports.split_first().expect("a core has a clock");
    let names: Vec<_> = others.iter().map(|port| port.name.as_str()).collect();
    let mut text = format!(
        "\nmodule {top}(clock, {});\n    input wire clock;\n",
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
        "    {} core(.{}(clock), {});\nendmodule",
        emitted.top,
        clock.name,
        connections.join(", ")
    );
    CoreWithClock { top, text }
}
