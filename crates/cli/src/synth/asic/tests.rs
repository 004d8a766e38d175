//! Tests of the measurements in standard cells.

use fpga_flow::asic::netlist_with_models;
use photoncube_hdl::{Level, emit};
use photoncube_spec::find_machine;
use photoncube_testbench::{
    Icarus, Source, Verdict, VerifyError, VerifyOptions, verify_device, with_outputs_alone,
};

use super::*;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");

#[test]
fn the_page_has_the_recorded_tables() {
    let page = fs::read_to_string(format!("{ROOT}/asic.md")).unwrap();
    let files = recorded::<Report>(&Path::new(ROOT).join("measured"), PREFIX).unwrap();
    assert!(!files.is_empty());
    for (file, report) in files {
        let table = rows_table(&report.machines);
        assert!(page.contains(&table), "{file} has this table:\n{table}");
        assert!(
            page.contains(&report.library_sha256),
            "{file}: {}",
            report.library_sha256
        );
    }
}

/// The mapped netlist of `machine` with the models of its cells, and the subject.
fn mapped(machine: &'static Machine) -> String {
    let scratch = tempfile::tempdir().unwrap();
    let tools = synth::tools(None, None).unwrap();
    let library = library(&tools, scratch.path(), Path::new(LIBERTY)).unwrap();
    let design = Subject::of(machine).unwrap().design;
    design.write(scratch.path()).unwrap();
    let (yosys, sta) = (tools.yosys(), Sta::find(scratch.path()).unwrap());
    measure(yosys, &sta, scratch.path(), &design, &library, ACTIVITY).unwrap();
    netlist_with_models(yosys, scratch.path()).unwrap()
}

/// What the simulation of a netlist says.
fn simulated(machine: &'static Machine, text: String) -> Result<Verdict, VerifyError> {
    let design = emit(machine, Level::Machine).unwrap();
    let mut device = Icarus::new(&with_outputs_alone(&design, text)).unwrap();
    let options = VerifyOptions {
        iterations: 200,
        seed: 1,
        source: Source::Random,
    };
    verify_device(machine, &mut device, &options, &|_| ())
}

/// The smallest machine, in standard cells, equals the golden model on its pins in every clock; a wrong cell is found.
#[test]
#[ignore = "needs Yosys, OpenSTA and Icarus: scripts/setup.sh --asic installs them"]
fn a_netlist_equals_the_golden_model() {
    let machine = find_machine("fit-ring").unwrap();
    let text = mapped(machine);
    let verdict = simulated(machine, text.clone()).unwrap();
    assert!(verdict.results_compared > 0, "{verdict:?}");
    let wrong = text.replacen("  AOI21X1 ", "  OAI21X1 ", 1);
    assert_ne!(wrong, text);
    let found = simulated(machine, wrong);
    assert!(matches!(found, Err(VerifyError::Diverged(_))), "{found:?}");
}
