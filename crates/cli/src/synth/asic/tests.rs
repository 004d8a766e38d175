//! Tests of the measurements in standard cells.

use std::ffi::OsString;

use fpga_flow::asic::{Activities, Simulatable, Toggles};
use photoncube_spec::find_machine;

use super::*;
use crate::failure::CheckFailed;

#[path = "beside.rs"]
mod beside;
#[path = "gated.rs"]
mod gated;
#[path = "shallow.rs"]
mod shallow;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");

/// The recorded files, but those with clock gates, of which the page has another table.
fn without_clock_gates() -> Vec<(String, Report)> {
    let mut files = recorded::<Report>(&Path::new(ROOT).join("measured"), PREFIX).unwrap();
    files.retain(|(_, report)| !report.clock_gating);
    files
}

#[test]
fn the_page_has_the_recorded_tables() {
    let page = fs::read_to_string(format!("{ROOT}/asic.md")).unwrap();
    let files = without_clock_gates();
    assert!(!files.is_empty());
    for (file, report) in files {
        let tables = [
            rows_table(&report.machines),
            simulated::table(&report.machines),
        ];
        for table in tables {
            assert!(page.contains(&table), "{file} has this table:\n{table}");
        }
        assert!(
            page.contains(&report.library_sha256),
            "{file}: {}",
            report.library_sha256
        );
    }
}

#[test]
fn every_recorded_key_is_documented() {
    let documented = fs::read_to_string(format!("{ROOT}/json.md")).unwrap();
    for (file, report) in recorded::<Report>(&Path::new(ROOT).join("measured"), PREFIX).unwrap() {
        let report = serde_json::to_value(report).unwrap();
        let row = &report["machines"][0];
        let objects = [&report, row, &row["simulated"]].map(|object| object.as_object().unwrap());
        let mut keys = objects.iter().flat_map(|object| object.keys());
        let missing = keys.find(|key| !documented.contains(&format!("`{key}`")));
        assert_eq!(missing, None, "{file}: docs/json.md does not explain it");
    }
}

/// A custom machine is among no subjects, and its row is held to its Verilog where all rows are.
#[test]
fn a_row_of_a_custom_machine_is_held_to_its_verilog() {
    let folder = tempfile::tempdir().unwrap();
    let (file, mut report) = recorded::<Report>(&Path::new(ROOT).join("measured"), PREFIX)
        .unwrap()
        .swap_remove(0);
    let mut found = |all| {
        let text = serde_json::to_string(&report).unwrap();
        fs::write(folder.path().join(&file), text).unwrap();
        report
            .machines
            .retain(|row| row.machine.starts_with("stream-shallow"));
        report.machines[0].verilog_sha256 = "00".to_owned();
        faults(folder.path(), &[], all).unwrap()
    };
    assert_eq!(found(true), Vec::<String>::new());
    let expected = "stream-shallow-local8-rgb8d-n16384 was measured with other Verilog";
    assert_eq!(found(true), [format!("{file}: {expected}")]);
    assert_eq!(found(false), Vec::<String>::new());
}

/// The netlist of the smallest machine in standard cells equals the golden model, on random stimulus and on photons of a scene. A wrong
/// cell is found, and a control that finds nothing fails. Where each net has the assumed activity, the energy is the assumed one.
#[test]
#[ignore = "needs Yosys, OpenSTA and Icarus: scripts/setup.sh --asic installs them"]
fn a_netlist_is_simulated_and_its_activities_are_told() {
    let scratch = tempfile::tempdir().unwrap();
    let (tools, folder) = (synth::tools(None, None).unwrap(), scratch.path());
    let library = library(&tools, folder, Path::new(LIBERTY)).unwrap();
    let subject = Subject::of(find_machine("fit-ring").unwrap()).unwrap();
    let design = &subject.design;
    design.write(folder).unwrap();
    let (yosys, sta) = (tools.yosys(), Sta::find(folder).unwrap());
    let options = Options {
        activity: ACTIVITY,
        clock_gating: false,
    };
    let figures = measure(yosys, &sta, folder, design, &library, &options).unwrap();
    let netlist = simulatable(yosys, folder, design, &library).unwrap();
    let mut workload = Workload::of(&OsString::from("cornell").into()).unwrap();
    (workload.clocks, workload.random_iterations) = (1.0, 20);

    let wrong = Simulatable {
        text: netlist.control.text.clone(),
        ..netlist.clone()
    };
    let error = workload.simulate(&subject, &wrong).err().unwrap();
    assert!(error.is::<CheckFailed>(), "{error}");
    assert!(
        error.to_string().contains("differs from the golden model"),
        "{error}"
    );
    let mut blind = netlist.clone();
    blind.control.text.clone_from(&netlist.text);
    let error = workload.simulate(&subject, &blind).err().unwrap();
    assert!(
        error.is::<CheckFailed>() && error.to_string().contains("was not found"),
        "{error}"
    );

    let simulation = workload.simulate(&subject, &netlist).unwrap();
    let simulated = |activities: &Activities| {
        let measured = (design, &figures);
        measure_simulated(yosys, &sta, folder, measured, &library, activities).unwrap()
    };
    let counted = simulated(&simulation.activities);
    let row = Simulated::of(&workload, &netlist, &simulation, &counted);
    assert!(row.tests_per_clock() > 0.4, "{row:?}");
    let mut uniform = simulation.activities;
    uniform.clocks = 10;
    let toggles = Toggles {
        transitions: 2,
        ones: 5,
    };
    uniform
        .nets
        .values_mut()
        .flatten()
        .for_each(|bit| *bit = toggles);
    let (same, mean) = simulated(&uniform);
    assert!((mean - ACTIVITY).abs() < 1e-9);
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-3;
    assert!(
        near(same.logic_energy_pj, figures.logic_energy_pj),
        "{same:?} {figures:?}"
    );
    assert!(
        near(same.register_energy_pj, figures.register_energy_pj),
        "{same:?} {figures:?}"
    );
    assert!(
        counted.0.logic_energy_pj < same.logic_energy_pj,
        "{counted:?}"
    );
}
