//! The datasheet of one core: limits, ports, protocol, limitations, and the area and clock of a measured one.

use anyhow::Result;
use photoncube_hdl::ports_text;
use photoncube_spec::{Core, find_machine, parts_of_core};
use serde::Serialize;

use super::datasheet::{LimitationRow, PortRow, area_and_fmax, limitations, recorded};
use crate::commands::datasheet::{CORE, CORE_PROTOCOL, CORE_VERIFIED, core_facts, core_ports};
use crate::core::chains_said;
use crate::cores;
use crate::narrow::WideArgs;
use crate::output;
use crate::synth::clock::Clock;
use crate::synth::figures::AreaRow;
use crate::table::wrapped;
use crate::verified::{self, Line};

#[derive(Serialize)]
struct CoreSheet {
    core: String,
    machine: &'static str,
    chains: u32,
    chain_engines: usize,
    verilog_module: String,
    ports: Vec<PortRow>,
    protocol: [&'static str; CORE_PROTOCOL.len()],
    limitations: Vec<LimitationRow>,
    /// The page of cores.
    datasheet: String,
    /// Its area, if it is measured.
    areas: Vec<AreaRow>,
    /// Its clock, if it is measured.
    fmax_by_grade: Vec<Clock>,
    /// The recorded results of verification.
    lines: Vec<Line>,
    /// Results about other Verilog.
    stale: Vec<Line>,
}

/// The core of a name such as `core-6-leaf-7-local7-rgb6d-n4096`; `None` where the name is of another kind.
///
/// # Errors
/// There is no such machine, or no core of it with so many chains.
pub fn named(name: &str) -> Option<Result<Core>> {
    let (chains, machine) = parts_of_core(name)?;
    let core = |machine| Ok(Core::new(machine, chains)?);
    Some(find_machine(machine).map_err(Into::into).and_then(core))
}

/// Prints a core's datasheet.
pub fn print(core: &Core, wide: WideArgs, json: bool) -> Result<()> {
    let sheet = sheet(core)?;
    output::print_tables(json, wide, &sheet, || text(&sheet, core))
}

fn sheet(core: &Core) -> Result<CoreSheet> {
    let measured = cores::measured()?.into_iter();
    let measured: Vec<_> = measured
        .filter(|row| row.core.name() == core.name())
        .collect();
    let is_its = |line: &Line| line.machine == core.name();
    let verified = verified::committed()?;
    Ok(CoreSheet {
        core: core.name(),
        machine: core.machine.name,
        chains: core.chains,
        chain_engines: core.engines(),
        verilog_module: core.top(),
        ports: core_ports(core).into_iter().map(PortRow::from).collect(),
        protocol: CORE_PROTOCOL,
        limitations: core
            .limitations()
            .into_iter()
            .map(LimitationRow::from)
            .collect(),
        datasheet: CORE.page(),
        areas: measured.iter().map(|row| row.area.clone()).collect(),
        fmax_by_grade: measured.into_iter().map(|row| row.clock).collect(),
        lines: verified.lines.into_iter().filter(is_its).collect(),
        stale: verified.stale.into_iter().filter(is_its).collect(),
    })
}

fn text(sheet: &CoreSheet, core: &Core) -> String {
    let facts = core_facts(core);
    let width = facts.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let facts: String = facts
        .iter()
        .map(|(name, value)| format!("{name:width$}  {value}\n"))
        .collect();
    let rule = |rule: &&str| wrapped(&format!("  - {rule}").replace('`', ""), 4) + "\n";
    let protocol: String = sheet.protocol.iter().map(rule).collect();
    let about = format!(
        "{}: {} behind AXI4-Stream and AXI4-Lite; a chain is the machine {}",
        sheet.core,
        chains_said(sheet.chains, sheet.chain_engines),
        sheet.machine
    );
    format!(
        "{}\n\n{facts}\n{}\nProtocol:\n{protocol}\n\
         Verilog: `photoncube generate --machine {} --chains {}` writes it\n\
         Family:  {}, with words, registers, pictures and timing diagram\n{}{}\n{}\n\n\
         Recorded of this core:\n{}",
        wrapped(&about, 2),
        ports_text(&sheet.verilog_module, &core_ports(core)),
        sheet.machine,
        sheet.chains,
        sheet.datasheet,
        limitations(&sheet.limitations),
        area_and_fmax(&sheet.areas, &sheet.fmax_by_grade),
        wrapped(CORE_VERIFIED, 0),
        recorded(&sheet.lines, &sheet.stale)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::COLUMNS;

    #[test]
    fn the_datasheet_of_a_core_fits_a_terminal_and_has_the_measured_figures() {
        for measured in cores::measured().unwrap() {
            let name = measured.core.name();
            let core = named(&name).unwrap().unwrap();
            assert_eq!((core.name(), core.chains), (name, measured.core.chains));
            let text = text(&sheet(&core).unwrap(), &core);
            // The names of paths and of cores are as long as they are.
            let is_text = |line: &&str| !line.starts_with("      ") && !line.starts_with('|');
            for line in text.lines().filter(is_text) {
                assert!(line.chars().count() <= COLUMNS, "{line}");
            }
            let clock = format!("{:.1} MHz", measured.clock.fmax_mhz);
            let limitation = &core.limitations()[0].says[..30];
            for part in [clock.as_str(), limitation, "s_axis_photons_tdata", "Area, "] {
                assert!(text.contains(part), "{part}: {text}");
            }
        }
    }

    #[test]
    fn a_core_that_is_not_measured_says_so_and_other_names_are_no_cores() {
        let core = named("core-2-leaf-5-radii-local7-rgb6d-n64")
            .unwrap()
            .unwrap();
        let text = text(&sheet(&core).unwrap(), &core);
        assert!(text.contains("Fmax, ECP5:\n  not measured"), "{text}");
        assert!(text.contains("The registers of rounds"), "{text}");
        assert!(named("paper").is_none() && named("core-x-leaf").is_none());
        assert!(named("core-2-paper").unwrap().is_err());
        assert!(named("core-0-leaf-5-local7-rgb6d-n64").unwrap().is_err());
    }
}
