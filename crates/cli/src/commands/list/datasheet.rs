//! The datasheet of one machine: numbers, clocks, ports, area, Fmax, verification.

use anyhow::Result;
use photoncube_hdl::interface_text;
use photoncube_spec::overlap::program_report;
use photoncube_spec::{Interface, Limitation, Machine, Port};
use serde::Serialize;

use super::{MachineRow, machine_row};
use crate::commands::Family;
use crate::narrow::WideArgs;
use crate::output;
use crate::synth::clock::Clock;
use crate::synth::figures::AreaRow;
use crate::synth::tables;
use crate::table::{grouped, wrapped};
use crate::verified::{self, Line};

#[derive(Serialize)]
struct Datasheet {
    #[serde(flatten)]
    row: MachineRow,
    /// The path of the top module's file below `hdl-out`.
    verilog_module: String,
    verilog_file: String,
    ports: Vec<PortRow>,
    /// The rules of the streams' handshakes, one rule a line.
    protocol: Vec<String>,
    /// What a user must design around.
    limitations: Vec<LimitationRow>,
    /// The page of the machine's family.
    datasheet: String,
    /// The squared search radius where the machine fixes it; `None` where it comes with each query.
    fixed_radius_sq: Option<u32>,
    latency_clocks: Option<u32>,
    latency_clocks_one_group: Option<u64>,
    /// The verification results about today's Verilog.
    lines: Vec<Line>,
    /// The verification results about other Verilog, which are no longer valid.
    stale: Vec<Line>,
}

/// A port of the top module; `photon_x_0..3` means the ports of lanes 0 to 3.
#[derive(Debug, Serialize)]
pub(super) struct PortRow {
    port: String,
    direction: &'static str,
    bits: u32,
    means: String,
}

/// What is limited, and what to do about it.
#[derive(Debug, Serialize)]
pub(super) struct LimitationRow {
    limitation: String,
    remedy: String,
}

impl From<Port> for PortRow {
    fn from(port: Port) -> Self {
        Self {
            port: port.name,
            direction: port.direction.name(),
            bits: port.width,
            means: port.meaning,
        }
    }
}

impl From<Limitation> for LimitationRow {
    fn from(row: Limitation) -> Self {
        Self {
            limitation: row.says,
            remedy: row.remedy,
        }
    }
}

/// Prints a machine's datasheet.
pub fn print(machine: &Machine, wide: WideArgs, json: bool) -> Result<()> {
    let sheet = datasheet(machine)?;
    output::print_tables(json, wide, &sheet, || text(&sheet, machine))
}

fn datasheet(machine: &Machine) -> Result<Datasheet> {
    let module = machine.module_prefix();
    let is_its = |line: &Line| line.machine == machine.name;
    let table = verified::committed()?;
    let (program, overlapped) = (machine.microprogram(), machine.overlap_program());
    let one_group = program.map(|program| program.latency_clocks(1));
    let interface = Interface::of(machine);
    Ok(Datasheet {
        row: machine_row(machine)?,
        verilog_file: format!("{}/{module}.v", machine.name),
        verilog_module: module,
        ports: interface.ports.into_iter().map(PortRow::from).collect(),
        protocol: interface.protocol,
        limitations: interface
            .limitations
            .into_iter()
            .map(LimitationRow::from)
            .collect(),
        datasheet: Family::of(machine).page(),
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
    let measured = &sheet.row.measured;
    design(sheet, machine)
        + &limitations(&sheet.limitations)
        + &area_and_fmax(&measured.areas, &measured.fmax_by_grade)
        + &verified_by(sheet)
}

/// The facts about the machine's design, without measurements.
fn design(sheet: &Datasheet, machine: &Machine) -> String {
    let row = &sheet.row;
    // A machine of fixed radius has no port for it.
    let radius_sq = match sheet.fixed_radius_sq {
        None => format!("radius_sq {}, ", row.radius_sq_bits),
        Some(_) => String::new(),
    };
    let widths = format!(
        "Widths: coordinate {}, position in block {}, {radius_sq}power {}, work and link {}, sum {} bits",
        row.coordinate_bits, row.position_bits, row.power_bits, row.work_bits, row.sum_bits
    );
    format!(
        "{}\n\n{}\n{}\n\nVerilog: hdl-out/{}\n\
         \x20        which `photoncube generate --machine {}` writes\n\
         Family:  {}, with pictures and timing diagram\n",
        wrapped(&format!("{}: {}", machine.name, machine.summary), 2),
        interface_text(machine),
        wrapped(&widths, 2),
        sheet.verilog_file,
        machine.name,
        sheet.datasheet
    )
}

pub(super) fn limitations(rows: &[LimitationRow]) -> String {
    let row = |row: &LimitationRow| {
        let said = format!("  - {} {}", row.limitation, row.remedy).replace('`', "");
        wrapped(&said, 4) + "\n"
    };
    let rows: String = rows.iter().map(row).collect();
    format!("\nKnown limitations:\n{rows}")
}

pub(super) fn area_and_fmax(areas: &[AreaRow], clocks: &[Clock]) -> String {
    let mut text = format!("\n{}Fmax, ECP5:\n", tables::areas(areas));
    match clocks {
        [] => text += "  not measured\n",
        clocks => text.extend(clocks.iter().map(clock)),
    }
    text
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
        clock.grade(),
        clock.fmax_mhz
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
    text + &recorded(&sheet.lines, &sheet.stale)
}

/// The recorded results, a line each.
pub(super) fn recorded(lines: &[Line], stale: &[Line]) -> String {
    let said = |line: &Line| {
        let volume = grouped(line.volume);
        let said = format!(
            "  {}: {volume} {}; {} ({})",
            line.heading(),
            line.unit,
            line.result,
            line.by
        );
        wrapped(&said, 4) + "\n"
    };
    let mut text: String = lines.iter().map(said).collect();
    if lines.is_empty() {
        text += "  nothing is recorded\n";
    }
    if !stale.is_empty() {
        let stale = stale.len();
        text += &format!("  {stale} results are about other Verilog and left out\n");
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
                "numbers ",
                "clocks ",
                "Ports of",
                "Protocol:",
                "Known limitations:",
                "docs/datasheets/",
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
