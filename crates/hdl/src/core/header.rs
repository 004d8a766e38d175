//! The comment at the head of a core's Verilog.

use photoncube_spec::{Core, CoreRegister, CoreStreams, StreamWord};

use crate::emit::push;

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
    ];
    for fact in core.number_facts() {
        lines.extend(told(&format!("{:13}  ", fact.name), &fact.value));
    }
    lines.push(String::new());
    lines.push(format!("Ports of {}:", core.top()));
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
    for row in streams.rows() {
        lines.push(String::new());
        lines.push(format!("Fields of {}, highest and lowest bit:", row.port));
        lines.extend(fields(row.word));
        for (field, meaning) in row.meanings(core) {
            lines.extend(told(&format!("    {:10}  ", field.name), &meaning));
        }
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

/// The lines of a text behind its name.
fn told(name: &str, text: &str) -> Vec<String> {
    let mut lines = String::new();
    push(&mut lines, name, text);
    lines.lines().map(str::to_owned).collect()
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
