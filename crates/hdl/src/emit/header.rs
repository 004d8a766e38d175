//! The comment at the head of an emitted file, which describes the machine for an integrator.
//!
//! It consists of comment lines only, which the digests of results leave out.

use photoncube_spec::{Interface, Machine, Organisation, Port};

use super::modules::split;
use crate::level::Level;

/// The longest line in characters, without the comment mark.
const COLUMNS: usize = 97;

/// The header of a machine's Verilog. A part on its own has only the first lines.
pub(super) fn header(machine: &Machine, level: Level) -> String {
    let scope = match level {
        Level::Machine => String::new(),
        part => format!(", its {}", part.name()),
    };
    let about = format!("{}{scope}: {}.", machine.name, machine.summary);
    let mut text = first_lines(&about, machine);
    if level == Level::Machine {
        text += "\n";
        text += &interface_text(machine);
        if let (true, Some(program)) = (runs_own_program(machine), machine.microprogram()) {
            text += &format!("\nThe microprogram:\n{program}");
        }
    }
    comment(&text)
}

/// Describes a machine for an integrator, in lines of at most 97 columns: limits and clocks, ports, protocol.
pub fn interface_text(machine: &Machine) -> String {
    let interface = Interface::of(machine);
    let mut text = String::new();
    let width = interface.facts.iter().map(|fact| fact.name.len()).max();
    for fact in &interface.facts {
        let name = format!("{:1$}  ", fact.name, width.unwrap_or(0));
        push(&mut text, &name, &fact.value);
    }
    text += "\n";
    text += &ports_text(&machine.module_prefix(), &interface.ports);
    text += "\nProtocol:\n";
    for rule in &interface.protocol {
        push(&mut text, "  - ", rule);
    }
    text
}

/// Describes the ports of a top module, in lines of at most 97 columns.
pub fn ports_text(top: &str, ports: &[Port]) -> String {
    let mut text = format!("Ports of {top}; bit 0 is the lowest:\n");
    let columns = PortColumns::of(ports);
    for port in ports {
        push(&mut text, &columns.left(port), &port.meaning);
    }
    text
}

/// The header of the file with the overrides for an ECP5. `overrides` is the Verilog of these.
pub(super) fn override_header(machine: &Machine, overrides: &str) -> String {
    let top = machine.module_prefix();
    let modules = split(overrides);
    let about = format!(
        "{}: {} modules of {top}.v, made of an ECP5's own cells.",
        machine.name,
        modules.len()
    );
    let mut text = first_lines(&about, machine);
    text += "\n";
    push(
        &mut text,
        "",
        &format!(
            "Each replaces the module of that name in {top}.v and is the same function, which \
             scripts/yosys/ecp5.sh proves. With both files as they are a name is declared twice. Yosys: \
             read_verilog {top}.v; read_verilog -overwrite {top}_ecp5.v. Elsewhere leave the modules below out \
             of {top}.v; the cells (CCU2C, LUT4, ...) are those of Lattice's library."
        ),
    );
    text += "\n";
    for module in modules {
        push(&mut text, "  ", &module.name);
    }
    comment(&text)
}

/// The first lines of a header: licence, contents and generator.
fn first_lines(about: &str, machine: &Machine) -> String {
    let mut text = licence();
    push(&mut text, "", about);
    text + &format!(
        "Written by photoncube {}, `{}`; do not edit.\n",
        env!("CARGO_PKG_VERSION"),
        generate_command(machine)
    )
}

/// The command that writes the machine's files. FILE is the listing of a user's program, which the header has.
pub fn generate_command(machine: &Machine) -> String {
    let parts = machine.name.split_once(Machine::WITH_PROGRAM);
    let base = parts.map_or(machine.name, |(base, _)| base);
    match runs_own_program(machine) {
        true => format!("photoncube generate --machine {base} --program FILE"),
        false => format!("photoncube generate --machine {base}"),
    }
}

/// Whether the machine runs a program of the user's. Its name does not say which.
fn runs_own_program(machine: &Machine) -> bool {
    matches!(machine.organisation, Organisation::Programmed(_))
}

/// The header of a unit on its own.
pub(super) fn unit_header(about: &str) -> String {
    comment(&(licence() + about + "\n"))
}

fn licence() -> String {
    format!("SPDX-License-Identifier: {}\n", env!("CARGO_PKG_LICENSE"))
}

/// Makes a comment line of each line of the text.
fn comment(text: &str) -> String {
    let lines = text.lines();
    lines
        .map(|line| format!("// {line}").trim_end().to_owned() + "\n")
        .collect()
}

/// The column widths of the table of ports.
struct PortColumns {
    kind: usize,
    name: usize,
}

impl PortColumns {
    fn of(ports: &[Port]) -> Self {
        let longest = |column: fn(&Port) -> String| {
            let lengths = ports.iter().map(|port| column(port).len());
            lengths.max().unwrap_or(0)
        };
        Self {
            kind: longest(kind),
            name: longest(|port| port.name.clone()),
        }
    }

    fn left(&self, port: &Port) -> String {
        let (kind, name) = (kind(port), &port.name);
        format!("  {kind:0$}  {name:1$}  ", self.kind, self.name)
    }
}

/// The direction and range of a port, such as `input [7:0]`.
fn kind(port: &Port) -> String {
    match port.width {
        1 => port.direction.name().to_owned(),
        width => format!("{} [{}:0]", port.direction.name(), width - 1),
    }
}

/// Appends `text` to the right of `left`, with further lines below the text where one line is too short.
pub(crate) fn push(lines: &mut String, left: &str, text: &str) {
    let mut line = left.to_owned();
    let indent = " ".repeat(left.len());
    let mut is_empty = true;
    for word in text.split(' ') {
        if !is_empty && line.len() + 1 + word.len() > COLUMNS {
            lines.push_str(line.trim_end());
            lines.push('\n');
            line.clone_from(&indent);
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        line += word;
        is_empty = false;
    }
    lines.push_str(line.trim_end());
    lines.push('\n');
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{MACHINES, OwnProgram, Pins, find_machine, parse_listing};

    use super::*;

    #[test]
    fn a_header_is_comment_lines_and_names_every_pin() {
        for machine in MACHINES {
            let text = header(machine, Level::Machine);
            for line in text.lines() {
                assert!(
                    line.starts_with("//") && line.len() <= COLUMNS + 3,
                    "{line}"
                );
            }
            let pins = Pins::of(machine);
            let outputs = &pins.observed[..pins.outputs];
            for pin in pins.inputs.iter().chain(outputs) {
                let stem = pin.name.trim_end_matches(|c: char| c.is_ascii_digit());
                assert!(text.contains(&format!(" {stem}")), "{}", pin.name);
            }
        }
    }

    #[test]
    fn a_program_of_the_users_own_is_in_the_header() {
        let paper = find_machine("paper").unwrap();
        let program = paper.microprogram().unwrap();
        let own = Machine {
            name: "paper-program-mine",
            ..paper.with_program(OwnProgram::new(&program).unwrap())
        };
        let text = header(&own, Level::Machine);
        let listing: String = text
            .lines()
            .map(|line| line.replacen("//", "", 1) + "\n")
            .collect();
        let listing = listing.split("The microprogram:\n").nth(1).unwrap();
        assert_eq!(parse_listing(listing), Ok(program));
        let command = "`photoncube generate --machine paper --program FILE`";
        assert!(text.contains(command), "{text}");
    }

    #[test]
    fn a_part_has_the_first_lines_alone() {
        let machine = find_machine("paper").unwrap();
        assert_eq!(header(machine, Level::Cell).lines().count(), 3);
    }

    #[test]
    fn long_text_goes_on_below_its_beginning() {
        let mut lines = String::new();
        push(&mut lines, "ab  ", &"word ".repeat(30));
        let lines: Vec<_> = lines.lines().collect();
        assert!(lines[0].starts_with("ab  word word"));
        assert!(lines[1].starts_with("    word"));
        assert!(lines.iter().all(|line| line.len() <= COLUMNS));
    }

    #[test]
    fn an_override_names_what_it_replaces() {
        let machine = find_machine("stream").unwrap();
        let text = override_header(machine, "module photoncube_stream_sum(a);\nendmodule\n");
        assert!(text.contains("1 modules of photoncube_stream.v"), "{text}");
        assert!(text.ends_with("//   photoncube_stream_sum\n"), "{text}");
    }
}
