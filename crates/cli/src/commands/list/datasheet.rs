//! All that is known of one machine: numbers, clocks, ports, area, Fmax, how it was verified.

use anyhow::Result;
use photoncube_spec::Machine;
use photoncube_spec::overlap::program_report;
use serde::Serialize;

use super::ports::{Port, ports};
use super::{MachineRow, machine_row};
use crate::output;
use crate::synth::clock::Clock;
use crate::synth::tables;
use crate::table::{markdown, wrapped};
use crate::verified::{self, Line, grouped};

#[derive(Serialize)]
struct Datasheet {
    #[serde(flatten)]
    row: MachineRow,
    /// The top module, and the file of it below `hdl-out`.
    verilog_module: String,
    verilog_file: String,
    ports: Vec<Port>,
    /// The squared search radius where the machine fixes it; else it comes with each query.
    fixed_radius_sq: Option<u32>,
    latency_clocks: Option<u32>,
    latency_clocks_one_group: Option<u64>,
    /// Results about today's Verilog.
    lines: Vec<Line>,
    /// Results about other Verilog, which show nothing any more.
    stale: Vec<Line>,
}

/// Prints a machine's datasheet.
pub fn print(machine: &Machine, json: bool) -> Result<()> {
    let sheet = datasheet(machine)?;
    output::print(json, &sheet, || text(&sheet, machine))
}

fn datasheet(machine: &Machine) -> Result<Datasheet> {
    let module = machine.module_prefix();
    let is_its = |line: &Line| line.machine == machine.name;
    let table = verified::committed()?;
    let (program, overlapped) = (machine.microprogram(), machine.overlap_program());
    let one_group = program.map(|program| program.latency_clocks(1));
    Ok(Datasheet {
        row: machine_row(machine)?,
        verilog_file: format!("{}/{module}.v", machine.name),
        verilog_module: module,
        ports: ports(machine),
        fixed_radius_sq: machine.fixed_radius_sq(),
        latency_clocks: match (&overlapped, machine.spatial()) {
            (Some(program), _) => Some(program_report(program).latency_clocks),
            (None, spatial) => spatial.map(photoncube_spec::Spatial::latency_clocks),
        },
        latency_clocks_one_group: one_group.or(overlapped.map(|p| p.latency_clocks(1))),
        stale: table.stale.into_iter().filter(is_its).collect(),
        lines: table.lines.into_iter().filter(is_its).collect(),
    })
}

fn text(sheet: &Datasheet, machine: &Machine) -> String {
    design(sheet, machine) + &area_and_fmax(sheet) + &verified_by(sheet)
}

/// What the machine is, whoever measures it.
fn design(sheet: &Datasheet, machine: &Machine) -> String {
    let mut text = wrapped(&format!("{}: {}", machine.name, machine.summary), 2) + "\n";
    for (heading, rows) in [
        ("Numbers", numbers(sheet, machine)),
        ("Clocks", clocks(sheet)),
    ] {
        text += &format!("\n{heading}:\n");
        for (name, said) in rows {
            text += &wrapped(&format!("  {name:<16}  {said}"), 20);
            text += "\n";
        }
    }
    text += &format!(
        "\nPorts of module {} (hdl-out/{}):\n",
        sheet.verilog_module, sheet.verilog_file
    );
    text + &port_table(&sheet.ports)
}

fn area_and_fmax(sheet: &Datasheet) -> String {
    let mut text = format!(
        "\n{}Fmax, ECP5:\n",
        tables::areas(&sheet.row.measured.areas)
    );
    match &sheet.row.measured.fmax_by_grade[..] {
        [] => text += "  not measured\n",
        clocks => text.extend(clocks.iter().map(clock)),
    }
    text
}

type Rows = Vec<(&'static str, String)>;

fn numbers(sheet: &Datasheet, machine: &Machine) -> Rows {
    let row = &sheet.row;
    let format = match machine.format() {
        Some(format) => format!("{}: {}", format.name(), format.summary()),
        None => {
            "the paper's plain arithmetic: unsigned steps of the frame, linear powers".to_owned()
        }
    };
    let radius = match (sheet.fixed_radius_sq, machine.format()) {
        (Some(radius_sq), Some(format)) => format!(
            "{} steps of 1/{} block edge, for all queries; squared, as compared: {radius_sq}",
            format.radius_steps(),
            1_u64 << format.radius_bits()
        ),
        _ => "comes with each query, squared".to_owned(),
    };
    vec![
        ("format", format),
        ("stored photon", format!("{} bits", row.bits_per_photon)),
        ("search radius", radius),
        (
            "largest query",
            format!("{} photons: its sums cannot overflow", row.max_photons),
        ),
        (
            "widths",
            format!(
                "coordinate {}, position in block {}, radius_sq {}, power {}, work and link {}, sum {} bits",
                row.coordinate_bits,
                row.position_bits,
                row.radius_sq_bits,
                row.power_bits,
                row.work_bits,
                row.sum_bits
            ),
        ),
        ("cells", format!("{}, squarer: {}", row.cells, row.squarer)),
    ]
}

fn clocks(sheet: &Datasheet) -> Rows {
    let row = &sheet.row;
    let counted = |clocks: f64| match clocks == 1.0 {
        true => "1 clock".to_owned(),
        false => format!("{clocks} clocks"),
    };
    let group = format!(
        "{} for {} photons: {} photon tests a clock",
        counted(row.initiation_interval),
        row.photons_per_iteration,
        row.photon_tests_per_clock
    );
    let (queries, later) = match row.queries_at_once {
        1 => ("one at a time".to_owned(), ""),
        queries => (
            format!("{queries} at once: a batch waits until it has that many"),
            ", the others 2 clocks apart in the queries' order",
        ),
    };
    let latency = match (sheet.latency_clocks_one_group, sheet.latency_clocks) {
        (Some(clocks), _) => {
            format!("{clocks} clocks from a query's first step to its result, with one group")
        }
        (None, Some(clocks)) => {
            format!("{clocks} clocks from the last group to the first result{later}")
        }
        (None, None) => "not known".to_owned(),
    };
    vec![("group", group), ("queries", queries), ("latency", latency)]
}

fn port_table(ports: &[Port]) -> String {
    let row = |port: &Port| {
        let name = match port.instances {
            1 => port.port.clone(),
            lanes => port.port.replace("_N", &format!("_0..{}", lanes - 1)),
        };
        let direction = port.direction.to_owned();
        vec![name, direction, port.bits.to_string(), port.means.clone()]
    };
    let rows: Vec<_> = ports.iter().map(row).collect();
    markdown(&["port", "direction", "bits", "means"], &rows)
}

fn clock(clock: &Clock) -> String {
    let seeds = match clock.seeds {
        1 => "one seed".to_owned(),
        seeds => format!(
            "{seeds} seeds, {:.1} to {:.1}",
            clock.fmax_mhz_low, clock.fmax_mhz_high
        ),
    };
    let mut text = format!(
        "  grade {}  {:.1} MHz, {seeds}\n",
        clock.speed_grade, clock.fmax_mhz
    );
    if let Some(path) = &clock.path {
        text += &format!(
            "    slowest path: {:.1} ns of logic, {:.1} ns of nets; most of it: {}\n      from {}\n      to   {}\n",
            path.logic_ns,
            path.routing_ns,
            path.binds.words(),
            path.from,
            path.to
        );
    }
    text
}

fn verified_by(sheet: &Datasheet) -> String {
    let mut text = "\nVerified, bit for bit against the golden model:\n".to_owned();
    for proof in sheet.row.measured.verified_against.split("; ") {
        text += &wrapped(&format!("  {proof}"), 4);
        text += "\n";
    }
    text += "\nVerified by other methods (docs/verification.md says what each is):\n";
    for line in &sheet.lines {
        let volume = grouped(line.volume);
        let said = format!(
            "  {}: {volume} {}; {} ({})",
            line.method, line.unit, line.result, line.by
        );
        text += &wrapped(&said, 4);
        text += "\n";
    }
    if sheet.lines.is_empty() {
        text += "  nothing is recorded\n";
    }
    if !sheet.stale.is_empty() {
        text += &format!(
            "  {} results are about other Verilog and left out\n",
            sheet.stale.len()
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{MACHINES, find_machine};

    use super::*;
    use crate::table::COLUMNS;

    #[test]
    fn every_datasheet_fits_a_terminal_but_for_the_names_of_paths() {
        for machine in MACHINES {
            let text = text(&datasheet(machine).unwrap(), machine);
            for line in text.lines().filter(|line| !line.starts_with("      ")) {
                assert!(line.chars().count() <= COLUMNS, "{}: {line}", machine.name);
            }
            for part in [
                "Numbers:",
                "Clocks:",
                "Ports of",
                "Area, ",
                "Fmax, ",
                "Verified, ",
            ] {
                assert!(text.contains(part), "{}: {part}", machine.name);
            }
        }
    }

    #[test]
    fn the_datasheet_of_a_machine_that_fixes_the_radius() {
        let machine = find_machine("tile-6").unwrap();
        insta::assert_snapshot!(design(&datasheet(machine).unwrap(), machine));
    }
}
