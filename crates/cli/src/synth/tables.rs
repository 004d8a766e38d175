//! Areas and clocks as tables for people.

use std::collections::BTreeMap;

use fpga_flow::path::SLOW;
use fpga_flow::{CriticalPath, EndpointGroup, Endpoints, FLOWS, Figure, Flow};

use super::clock::Clock;
use super::figures::{AreaRow, PlaceRow, Row};
use super::plan::DeviceUse;
use crate::table::{self, Table};

/// The programs that measured, with their versions. The packages that they came in are left out.
pub fn measured_by(tool_versions: &BTreeMap<String, String>) -> String {
    let programs = tool_versions.iter();
    let programs = programs.filter(|(tool, _)| !tool.starts_with("yowasp-"));
    let programs: Vec<_> = programs
        .map(|(tool, version)| format!("{tool} {version}"))
        .collect();
    format!("By {}.", programs.join(", "))
}

/// A table for each flow that has rows, below the flow's name.
pub fn areas(rows: &[AreaRow]) -> String {
    let tables = areas_by_flow(rows);
    let text = |(name, table): &(String, Table)| format!("Area, {name}:\n{}\n", table.markdown());
    tables.iter().map(text).collect()
}

/// The areas of each flow that has rows, with the flow's name.
pub fn areas_by_flow(rows: &[AreaRow]) -> Vec<(String, Table)> {
    let of_flow = |flow: &Flow| {
        let rows: Vec<_> = rows.iter().filter(|row| *row.flow == *flow).collect();
        let figures = flow.figures;
        let header: Vec<_> = figures.iter().map(|figure| figure.heading()).collect();
        let header = [&["machine"][..], &header].concat();
        let cells = rows.iter().map(|row| area_cells(row, figures));
        let table = Table::new(&header, cells);
        let name = format!("{} ({})", flow.heading, flow.name);
        (!rows.is_empty()).then_some((name, table))
    };
    FLOWS.into_iter().filter_map(of_flow).collect()
}

fn area_cells(row: &AreaRow, figures: &[Figure]) -> Vec<String> {
    let number = |figure| {
        row.figures
            .get(figure)
            .map_or(String::new(), u64::to_string)
    };
    let mut cells = vec![row.machine.clone()];
    cells.extend(figures.iter().map(number));
    cells
}

/// The areas on other devices than ECP5: a row for each machine, in the order of the rows.
pub fn elsewhere(rows: &[AreaRow]) -> String {
    let columns = [
        ("LUT4, no carry chains", "lut4", Figure::Lut4),
        ("gates", "gates", Figure::Gates),
        ("NAND2 equivalents", "gates", Figure::Nand2Equivalents),
        ("Cyclone V", "intel", Figure::Alut),
        ("MAX 10", "max10", Figure::LogicCells),
        ("FF", "gates", Figure::Ff),
    ];
    let mut machines: Vec<&str> = Vec::new();
    for row in rows {
        if !machines.contains(&row.machine.as_str()) {
            machines.push(&row.machine);
        }
    }
    let cell = |machine: &str, flow: &str, figure: Figure| {
        let of_it = |row: &&AreaRow| row.machine == machine && row.flow.name == flow;
        let number = rows
            .iter()
            .find(of_it)
            .and_then(|row| row.figures.get(&figure));
        match (number, figure) {
            (None, _) => "not measured".to_owned(),
            (Some(number), Figure::Alut) => format!("{number} ALUT"),
            (Some(number), Figure::LogicCells) => format!("{number} logic cells"),
            (Some(number), _) => number.to_string(),
        }
    };
    let row = |machine: &&str| {
        let cells = columns.map(|(_, flow, figure)| cell(machine, flow, figure));
        [vec![machine.to_string()], cells.to_vec()].concat()
    };
    let header = columns.map(|(heading, ..)| heading);
    let header = [&["machine"][..], &header].concat();
    table::markdown(&header, &machines.iter().map(row).collect::<Vec<_>>())
}

/// The resources of a device that each machine needs, a line for each machine.
pub fn uses(rows: &[DeviceUse]) -> String {
    let row = |row: &DeviceUse| {
        let resources = row.resources.iter();
        let resources: Vec<_> = resources
            .map(|of| format!("{} {} of {}", of.resource, of.needed, of.available))
            .collect();
        let verdict = if row.fits { "fits" } else { "does not fit" };
        vec![
            row.machine.to_owned(),
            verdict.to_owned(),
            resources.join(", "),
        ]
    };
    let rows: Vec<_> = rows.iter().map(row).collect();
    table::markdown(&["machine", "in the device", "needed"], &rows)
}

/// The clocks, each with its critical path.
pub fn clocks(clocks: &[Clock]) -> String {
    let header = [
        "machine",
        "flow",
        "grade",
        "Fmax, MHz",
        "seeds",
        "placer, router",
        "critical path",
        "logic + nets, ns",
        "through",
        "most of it",
    ];
    let row = |clock: &Clock| {
        let path = clock.path.as_ref();
        let of_path = |text: fn(&CriticalPath) -> String| path.map_or("not read".to_owned(), text);
        vec![
            clock.machine.clone(),
            clock.flow.to_string(),
            clock.grade(),
            format!("{:.1}", clock.fmax_mhz),
            match clock.seeds {
                1 => "1".to_owned(),
                n => format!(
                    "{n}: {:.1} to {:.1}",
                    clock.fmax_mhz_low, clock.fmax_mhz_high
                ),
            },
            format!("{}, {}", clock.placer.name(), clock.router.name()),
            of_path(|path| format!("{} to {}", path.from, path.to)),
            of_path(|path| format!("{:.1} + {:.1}", path.logic_ns, path.routing_ns)),
            path.map_or("not read".to_owned(), |path| levels(path, clock.flow)),
            of_path(|path| path.binds.words().to_owned()),
        ]
    };
    table::markdown(&header, &clocks.iter().map(row).collect::<Vec<_>>())
}

/// The registers at which slow paths end, a table for each placement that lists them.
pub fn endpoints(rows: &[PlaceRow]) -> String {
    let table = |row: &PlaceRow| Some(endpoints_of(row, row.endpoints.as_ref()?));
    rows.iter().filter_map(table).collect()
}

fn endpoints_of(row: &PlaceRow, ends: &Endpoints) -> String {
    let Endpoints { all, slow, groups } = ends;
    let of_group = |group: &EndpointGroup| {
        vec![
            group.registers.clone(),
            table::grouped(group.slow),
            format!("{:.2}", group.slowest_ns),
        ]
    };
    let rows: Vec<_> = groups.iter().map(of_group).collect();
    format!(
        "\n{}, {}, seed {}: {} of {} paths take {:.0} % of the slowest's time or more. They end at\n{}",
        row.machine,
        row.group().what,
        row.seed,
        table::grouped(*slow),
        table::grouped(*all),
        100.0 * SLOW,
        table::markdown(&["registers", "slow paths", "slowest, ns"], &rows)
    )
}

fn levels(path: &CriticalPath, flow: &Flow) -> String {
    let mut levels = Vec::new();
    let mut name = |number: u64, one: &str, more: &str| match number {
        0 => {}
        1 => levels.push(format!("1 {one}")),
        n => levels.push(format!("{n} {more}")),
    };
    let chains = format!(
        "carry chain{} of {} {}",
        if path.carry_chains == 1 { "" } else { "s" },
        path.carry_cells,
        if flow.figures.contains(&Figure::Ccu2c) {
            "CCU2C"
        } else {
            "cells"
        }
    );
    name(path.carry_chains, &chains, &chains);
    name(path.dsp_levels, "DSP", "DSPs");
    name(path.lut_levels, "LUT", "LUTs");
    levels.join(", ")
}

#[cfg(test)]
mod tests {
    use fpga_flow::{Placer, Router};

    use super::*;

    #[test]
    fn only_placements_that_list_endpoints_have_a_table_of_them() {
        let without = PlaceRow {
            machine: "paper".to_owned(),
            flow: Flow::find("ecp5").unwrap(),
            speed_grade: Some(8),
            seed: 2,
            placer: Placer::default(),
            router: Router::default(),
            fmax_mhz: 200.0,
            netlist_sha256: "00".to_owned(),
            path: None,
            endpoints: None,
        };
        let group = |registers: &str, slow, slowest_ns| EndpointGroup {
            registers: registers.to_owned(),
            slow,
            slowest_ns,
        };
        let with = PlaceRow {
            endpoints: Some(Endpoints {
                all: 1234,
                slow: 41,
                groups: vec![group("cell_*.sum", 40, 5.0), group("control.step", 1, 4.5)],
            }),
            ..without.clone()
        };
        let expected = "
paper, speed grade 8, seed 2: 41 of 1,234 paths take 80 % of the slowest's time or more. They end at
| registers    | slow paths | slowest, ns |
| ------------ | ---------- | ----------- |
| cell_*.sum   | 40         | 5.00        |
| control.step | 1          | 4.50        |
";
        assert_eq!(endpoints(&[without, with]), expected);
    }

    #[test]
    fn each_flow_has_a_table_of_its_figures() {
        let row = |flow: &str, numbers: &[u64]| AreaRow {
            machine: "paper".to_owned(),
            flow: Flow::find(flow).unwrap(),
            figures: (Flow::find(flow).unwrap().figures.iter().copied())
                .zip(numbers.iter().copied())
                .collect(),
        };
        let rows = [
            row("gates", &[12_817, 20_119, 972]),
            row("lut4", &[3663, 972]),
        ];
        let expected = "\
Area, 4-input LUTs without carry chains (lut4):
| machine | LUT4 | FF  |
| ------- | ---- | --- |
| paper   | 3663 | 972 |

Area, gates with two inputs (gates):
| machine | gates | NAND2 equivalents | FF  |
| ------- | ----- | ----------------- | --- |
| paper   | 12817 | 20119             | 972 |

";
        assert_eq!(areas(&rows), expected);
        let cells = [
            "paper",
            "3663",
            "12817",
            "20119",
            "not measured",
            "not measured",
            "972",
        ];
        let table = elsewhere(&rows);
        let last: Vec<_> = table.lines().last().unwrap().split('|').collect();
        let last: Vec<_> = last.iter().map(|cell| cell.trim()).collect();
        assert_eq!(last[1..8], cells);
    }
}
