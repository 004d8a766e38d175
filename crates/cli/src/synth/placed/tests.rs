//! Tests of the placed netlist: small machines of each organisation equal the golden model in it, and planted
//! faults are found.

use std::collections::{BTreeMap, BTreeSet};

use photoncube_spec::find_machine;
use photoncube_testbench::{Source, pinned_tools};
use serde_json::{Value, json};

use super::*;
use crate::synth::figures::{COMMAND, Figured, PlaceRow};

/// Enough iterations for every fault here; Icarus, which needs no compiler, simulates some hundred clocks in
/// a second.
const ITERATIONS: u64 = 60;

/// Yosys, as `scripts/setup.sh` installs it.
fn tools() -> Tools {
    let folder = pinned_tools();
    assert!(
        folder.is_some(),
        "no Yosys of `scripts/setup.sh --where`; scripts/setup.sh installs it"
    );
    Tools::find(folder, None).unwrap()
}

fn simulated(placed: &Placed<'_>, netlist: &Netlist) -> Result<Verdict, VerifyError> {
    let options = VerifyOptions {
        iterations: ITERATIONS,
        seed: 1,
        source: Source::Random,
    };
    placed
        .verify(netlist, DeviceKind::Icarus, &options, &|_| ())
        .unwrap()
}

fn assert_differs(placed: &Placed<'_>, netlist: &Netlist, fault: &str) {
    let found = simulated(placed, netlist);
    assert!(
        matches!(found, Err(VerifyError::Diverged(_))),
        "{fault}: {found:?}"
    );
}

fn cells(netlist: &mut Netlist) -> &mut serde_json::Map<String, Value> {
    netlist.json_mut()["modules"]["serial"]["cells"]
        .as_object_mut()
        .unwrap()
}

/// Requires that each committed clock of the machine is of this netlist. It is of another one where Yosys, the flow or
/// a pass has changed since.
fn is_what_was_measured(placed: &Placed<'_>) {
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/measured");
    let file = Figured::<PlaceRow>::read(&committed).unwrap().unwrap();
    let machine = placed.subject.machine.name;
    let rows = file.rows.iter().filter(|row| row.machine == machine);
    let measured: BTreeSet<_> = rows.map(|row| row.netlist_sha256.as_str()).collect();
    let today = placed.netlist_sha256().unwrap();
    assert_eq!(
        measured,
        BTreeSet::from([today.as_str()]),
        "place.json: `{COMMAND} --flow place --update --machine {machine}` measures it anew"
    );
}

/// Compares each different stage with the golden model and proves the passes; then requires that a wrong LUT
/// is found.
fn holds(machine: &str) {
    let tools = tools();
    let subject = Subject::of(find_machine(machine).unwrap()).unwrap();
    let placed = Placed::map(&tools, &subject).unwrap();
    is_what_was_measured(&placed);
    let passes = placed.prove().unwrap();
    assert!(passes[0].cells_changed > 0, "{passes:#?}");
    assert!(
        passes
            .iter()
            .all(|pass| pass.proven && pass.control_refuted),
        "{passes:#?}"
    );
    let last = placed.stages().last().unwrap();
    let verdict = simulated(&placed, &last.netlist).unwrap();
    assert!(verdict.results_compared > 0);
    let mut wrong = last.netlist.clone();
    let lut = cells(&mut wrong)
        .iter_mut()
        .find(|(name, cell)| cell["type"] == "LUT4" && name.starts_with("machine."));
    let init = &mut lut.unwrap().1["parameters"]["INIT"];
    *init = inverted(init.as_str().unwrap()).into();
    assert_differs(&placed, &wrong, "a LUT that is wrong");
    assert_ne!(wrong.sha256().unwrap(), placed.netlist_sha256().unwrap());
    open_a_carry_that_is_read(&placed);
}

fn inverted(bits: &str) -> String {
    bits.chars()
        .map(|bit| if bit == '0' { '1' } else { '0' })
        .collect()
}

/// A pass that disconnects one end too many: its proof fails, and the simulation differs.
fn open_a_carry_that_is_read(placed: &Placed<'_>) {
    let mapped = &placed.stages()[0];
    let mut wrong = mapped.netlist.clone();
    let of_chain = |cell: &Value| cell["type"] == "CCU2C" && cell["connections"]["CIN"][0].is_u64();
    let read = cells(&mut wrong)
        .values()
        .find(|cell| of_chain(cell))
        .unwrap()["connections"]["CIN"]
        .clone();
    let driver = cells(&mut wrong)
        .values_mut()
        .find(|cell| cell["connections"]["COUT"] == read);
    driver.unwrap()["connections"]["COUT"] = json!(["x"]);
    let stage = |netlist: &Netlist| Stage {
        name: "open carry ends",
        netlist: netlist.clone(),
    };
    let stages = [stage(&mapped.netlist), stage(&wrong)];
    let passes = prove(
        placed.tools.yosys(),
        placed.folder(),
        &placed.models,
        &stages,
    )
    .unwrap();
    assert!(!passes[0].proven, "{passes:#?}");
    assert_differs(placed, &wrong, "a carry end that is read and open");
}

#[test]
#[ignore = "needs Icarus and Yosys: scripts/setup.sh installs them"]
fn a_sequential_machine_is_the_golden_model_as_it_is_placed() {
    holds("fit-ring");
}

#[test]
#[ignore = "needs Icarus and Yosys: scripts/setup.sh installs them"]
fn an_overlapped_machine_is_the_golden_model_as_it_is_placed() {
    holds("overlap");
}

#[test]
#[ignore = "needs Icarus and Yosys: scripts/setup.sh installs them"]
fn a_spatial_machine_is_the_golden_model_as_it_is_placed() {
    holds("tile-4");
}

#[test]
#[ignore = "needs Icarus and Yosys: scripts/setup.sh installs them"]
fn a_second_text_that_is_wrong_is_found() {
    let tools = tools();
    let mut subject = Subject::of(find_machine("tile-4").unwrap()).unwrap();
    let text = subject.design.overrides.remove("ecp5").unwrap();
    let (before, after) = text.split_once(".INIT1(16'h").unwrap();
    let (digits, rest) = after.split_at(4);
    let digits = u16::from_str_radix(digits, 16).unwrap() ^ 0xffff;
    let wrong = format!("{before}.INIT1(16'h{digits:04x}{rest}");
    subject.design.overrides.insert("ecp5", wrong);
    let placed = Placed::map(&tools, &subject).unwrap();
    assert_differs(
        &placed,
        &placed.stages()[0].netlist,
        "a second text that is wrong",
    );
}

/// The modules of a text by name, without the machine's name in them, and without comments.
fn modules(text: &str, top: &str) -> BTreeMap<String, String> {
    let lines = text
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let text = lines.collect::<Vec<_>>().join("\n").replace(top, "the");
    let modules = verilog_eval::modules(&text).into_iter();
    let modules = modules.map(|module| (module.name.to_owned(), module.text.to_owned()));
    modules.collect()
}

/// The names of the modules of a machine that is too large to simulate, which are not modules of the
/// simulated machines.
fn others(machine: &str, simulated: &[Subject]) -> [Vec<String>; 2] {
    let texts = |subject: &Subject| {
        let design = &subject.design;
        let ecp5 = design.overrides.get("ecp5").cloned().unwrap_or_default();
        [design.verilog.clone(), ecp5].map(|text| modules(&text, &design.top))
    };
    let known: Vec<_> = simulated.iter().map(texts).collect();
    let subject = Subject::of(find_machine(machine).unwrap()).unwrap();
    let own = texts(&subject);
    [0, 1].map(|which| {
        let is_known = |text: &String| {
            known
                .iter()
                .any(|known| known[which].values().any(|known| known == text))
        };
        assert!(!own[which].is_empty());
        let others = own[which].iter().filter(|(_, text)| !is_known(text));
        others.map(|(name, _)| name.clone()).collect()
    })
}

#[test]
fn chips_are_made_of_modules_of_machines_that_are_simulated() {
    let simulated =
        ["tile-6", "tile-6-mixed"].map(|name| Subject::of(find_machine(name).unwrap()).unwrap());
    let sizes = ["the", "the_admission", "the_queue"];
    assert_eq!(
        others("chip-lut", &simulated),
        [sizes.map(str::to_owned).to_vec(), vec![]]
    );
    let [portable, second] = others("chip-mixed", &simulated);
    assert_eq!(second, [""; 0]);
    let is_expected = |name: &String| {
        sizes.contains(&name.as_str())
            || name.starts_with("the_lane")
            || name.starts_with("the_square_pair")
    };
    let unexpected: Vec<_> = portable.iter().filter(|name| !is_expected(name)).collect();
    assert!(unexpected.is_empty(), "{unexpected:?}");
}
