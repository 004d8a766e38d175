//! The comment at the head of a core's Verilog.

use photoncube_spec::{Core, CoreRegister, CoreStreams, StreamWord};

/// The longest line in characters, without the comment mark.
const COLUMNS: usize = 97;

/// The header: what the core is, its ports, the fields of its words, its registers.
pub(super) fn header(core: &Core, digest: u64) -> String {
    let machine = core.machine;
    let mut lines = vec![
        format!("SPDX-License-Identifier: {}", env!("CARGO_PKG_LICENSE")),
        format!(
            "{}: {} chains behind AXI4-Stream and AXI4-Lite; each is the machine",
            core.name(),
            core.chains
        ),
        format!("{}: {}.", machine.name, machine.summary),
        format!(
            "Written by photoncube {}, `photoncube generate --machine {} --chains {}`; do not edit.",
            env!("CARGO_PKG_VERSION"),
            machine.name,
            core.chains
        ),
        String::new(),
        format!("Ports of {}:", core.top()),
    ];
    for port in core.ports() {
        let direction = port.direction.name();
        let range = match port.width {
            1 => String::new(),
            width => format!("[{}:0]", width - 1),
        };
        lines.push(
            format!(
                "  {direction:6} {range:8} {:22} {}",
                port.name, port.meaning
            )
            .trim_end()
            .to_owned(),
        );
    }
    let streams = CoreStreams::of(core);
    for (name, word) in [
        ("s_axis_photons_tdata", &streams.photons),
        ("s_axis_queries_tdata", &streams.queries),
        ("m_axis_results_tdata", &streams.results),
    ] {
        lines.push(String::new());
        lines.push(format!("Fields of {name}, highest and lowest bit:"));
        lines.extend(fields(word));
    }
    lines.push(String::new());
    lines.push("Registers, by their addresses in bytes:".to_owned());
    for row in CoreRegister::all(core, digest) {
        lines.push(format!("  {:03x} {}", row.address, row.name));
    }
    let commented = lines
        .iter()
        .map(|line| format!("// {line}").trim_end().to_owned() + "\n");
    commented.collect::<String>() + "\n"
}

/// The fields of a word, several on a line.
fn fields(word: &StreamWord) -> Vec<String> {
    let mut lines = vec![String::from(" ")];
    for field in &word.fields {
        let text = format!(
            " {} {}:{}",
            field.name,
            field.low + field.width - 1,
            field.low
        );
        match lines.last_mut() {
            Some(line) if line.len() + text.len() < COLUMNS => line.push_str(&(text + ",")),
            _ => lines.push(format!(" {text},")),
        }
    }
    if let Some(last) = lines.last_mut() {
        last.pop();
    }
    lines
}
