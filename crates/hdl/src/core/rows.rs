//! A core for a simulation that drives and compares rows of numbers.

use std::fmt::Write as _;

use photoncube_spec::{Core, Direction, Pins, port_columns};

use super::EmittedCore;
use crate::emit::{BlockRam, Emitted};

/// Outputs that mean something only while a valid is 1: their prefixes and the valid. In other clocks they count as 0.
const UNDER_VALID: [(&str, &str); 3] = [
    ("m_axis_results_t", "m_axis_results_tvalid"),
    ("s_axi_b", "s_axi_bvalid"),
    ("s_axi_r", "s_axi_rvalid"),
];

/// The core within a module whose ports are the columns of [`Core::pins`].
pub fn core_rows(core: &Core, emitted: &EmittedCore) -> Emitted {
    let top = format!("{}_rows", emitted.top);
    let pins = core.pins();
    let names = pins.inputs.iter().chain(&pins.outputs);
    let names: Vec<_> = names.map(|pin| pin.name.as_str()).collect();
    let mut text = format!(
        "module {top}(clock, {});\n    input wire clock;\n",
        names.join(", ")
    );
    for (direction, pins) in [("input", &pins.inputs), ("output", &pins.outputs)] {
        for pin in pins {
            let _ = writeln!(
                text,
                "    {direction} wire [{}:0] {};",
                pin.width - 1,
                pin.name
            );
        }
    }
    let mut connections = vec![".aclk(clock)".to_owned()];
    for port in core.ports().iter().skip(1) {
        let columns = port_columns(port);
        match port.direction {
            Direction::Input => {
                let columns: Vec<_> = columns
                    .iter()
                    .rev()
                    .map(|(name, _)| name.as_str())
                    .collect();
                connections.push(format!(".{}({{{}}})", port.name, columns.join(", ")));
            }
            Direction::Output => {
                let _ = writeln!(text, "    wire [{}:0] of_{};", port.width - 1, port.name);
                connections.push(format!(".{0}(of_{0})", port.name));
                let mut low = 0;
                for (name, width) in columns {
                    let value = format!("of_{}[{}:{low}]", port.name, low + width - 1);
                    let value = match valid_of(&port.name) {
                        Some(valid) => format!("of_{valid} ? {value} : {width}'d0"),
                        None => value,
                    };
                    let _ = writeln!(text, "    assign {name} = {value};");
                    low += width;
                }
            }
        }
    }
    let _ = write!(
        text,
        "    {} core({});\nendmodule\n\n",
        emitted.top,
        connections.join(",\n        ")
    );
    let outputs = pins.outputs.len();
    let chains = 0..core.chains;
    let block_rams = chains.flat_map(|chain| {
        let rams = emitted.machine.block_rams.iter();
        rams.map(move |ram| BlockRam {
            path: format!("core.chain_{chain}.{}", ram.path),
            words: ram.words,
        })
    });
    Emitted {
        text: text + &emitted.text,
        top,
        ecp5_text: None,
        clocked: true,
        pins: Pins {
            inputs: pins.inputs,
            observed: pins.outputs,
            outputs,
        },
        register_paths: Vec::new(),
        block_rams: block_rams.collect(),
    }
}

/// The valid that an output depends on.
fn valid_of(port: &str) -> Option<&'static str> {
    let under = UNDER_VALID.iter().find(|(prefix, valid)| {
        port.starts_with(prefix) && port != *valid && !port.ends_with("ready")
    });
    under.map(|(_, valid)| *valid)
}
