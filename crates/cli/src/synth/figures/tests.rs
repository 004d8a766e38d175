use fpga_flow::Figure;
use photoncube_spec::find_machine;

use super::*;

fn versions(yosys: &str) -> BTreeMap<String, String> {
    [("yosys", yosys), ("nextpnr-ecp5", "0.11")]
        .map(|(tool, version)| (tool.to_owned(), version.to_owned()))
        .into()
}

fn subject(machine: &str, digest: &str) -> Subject {
    Subject {
        name: machine.to_owned(),
        machine: find_machine(machine).unwrap(),
        design: fpga_flow::Design::default(),
        verilog_sha256: digest.to_owned(),
    }
}

fn area(machine: &str, flow: &'static Flow, gates: u64) -> AreaRow {
    AreaRow {
        machine: machine.to_owned(),
        flow,
        figures: [(Figure::Gates, gates)].into(),
    }
}

fn of(flow: &str) -> &'static Flow {
    Flow::find(flow).unwrap()
}

/// A file with both machines in all flows.
fn file() -> Figured<AreaRow> {
    let mut file = Figured::<AreaRow>::new(AreaSetting::new(&versions("0.70")));
    for (name, digest) in [("paper", "00"), ("local", "01")] {
        let rows: Vec<_> = recorded_flows().map(|flow| area(name, flow, 1)).collect();
        file.update(file.setting.clone(), &subject(name, digest), &rows);
    }
    file
}

fn expected(machines: &[&str]) -> Vec<Group> {
    let machines = machines.iter();
    let groups = machines.flat_map(|name| recorded_flows().map(|flow| Group::area(name, flow)));
    groups.collect()
}

#[test]
fn an_update_replaces_its_rows_and_keeps_the_others() {
    let mut file = file();
    let rows = [area("paper", of("gates"), 7)];
    let subjects = [subject("paper", "00")];
    let groups = rows.iter().map(Row::group).collect();
    file.check_update(&file.setting.clone(), &groups, &subjects)
        .unwrap();
    file.update(file.setting.clone(), &subjects[0], &rows);
    assert_eq!(file.rows.len(), 12);
    let number = |machine, gates: u64| {
        let rows = file.rows.iter().filter(|row| row.machine == machine);
        rows.filter(|row| row.figures[&Figure::Gates] == gates)
            .count()
    };
    assert_eq!(
        (number("paper", 7), number("paper", 1), number("local", 1)),
        (1, 5, 6)
    );
    assert_eq!(file.verilog_sha256["local"], "01");
    assert!(file.rows.is_sorted_by_key(Row::order));
}

#[test]
fn rows_of_other_verilog_or_other_tools_do_not_stand_side_by_side() {
    let file = file();
    let one: BTreeSet<_> = [Group::area("paper", of("gates"))].into();
    let all: BTreeSet<_> = expected(&["paper"]).into_iter().collect();
    let changed = [subject("paper", "02")];
    let setting = file.setting.clone();
    let error = file.check_update(&setting, &one, &changed).unwrap_err();
    assert!(error.to_string().contains("with other Verilog"), "{error}");
    file.check_update(&setting, &all, &changed).unwrap();
    let other = AreaSetting::new(&versions("0.71"));
    let error = file.check_update(&other, &all, &changed).unwrap_err();
    assert!(error.to_string().contains("other tools"), "{error}");
}

#[test]
fn faults_are_stale_missing_and_gone_machines() {
    let file = file();
    let subjects = [subject("paper", "00"), subject("local", "01")];
    let faults = |file: &Figured<AreaRow>, subjects: &[Subject], all| {
        file.faults(&expected(&["paper", "local"]), subjects, all)
    };
    assert!(faults(&file, &subjects, true).is_empty());

    let stale = [subject("paper", "00"), subject("local", "02")];
    let found = faults(&file, &stale, true);
    assert_eq!(
        found,
        ["synthesis.json: local was measured with other Verilog"]
    );

    let found = faults(&file, &subjects[..1], true);
    assert_eq!(found, ["synthesis.json: local is no machine any more"]);
    assert!(faults(&file, &subjects[..1], false).is_empty());

    let mut less = file.clone();
    less.rows
        .retain(|row| row.group() != Group::area("paper", of("intel")));
    less.verilog_sha256.remove("local");
    less.rows.retain(|row| row.machine != "local");
    let found = faults(&less, &subjects, true);
    let expected = [
        "synthesis.json: paper has no flow intel",
        "synthesis.json: local is not measured",
    ];
    assert_eq!(found, expected);
}

#[test]
fn a_file_comes_back_as_it_was_written() {
    let folder = tempfile::tempdir().unwrap();
    assert!(Figured::<AreaRow>::read(folder.path()).unwrap().is_none());
    let file = file();
    let path = file.write(folder.path()).unwrap();
    let back = Figured::<AreaRow>::read(folder.path()).unwrap().unwrap();
    assert_eq!((back.rows, back.setting), (file.rows, file.setting));
    fs::write(&path, "{}").unwrap();
    let error = Figured::<AreaRow>::read(folder.path()).unwrap_err();
    assert!(format!("{error:#}").contains("synthesis.json"), "{error:#}");
}
