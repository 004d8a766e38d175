//! Tests the method `placed`. `crates/cli/src/synth/placed/tests.rs` plants faults in the netlists.

use super::error;
use super::json_keys::of_a_method_with_tools;

#[test]
fn what_cannot_simulate_models_of_cells_is_refused() {
    let message = error(&["verify", "placed", "--against", "text"], 2);
    assert!(
        message.contains("models of cells, so expected verilator or icarus"),
        "{message}"
    );
}

#[test]
#[ignore = "needs Icarus and Yosys: scripts/setup.sh installs them"]
fn a_small_machine_is_the_golden_model_as_it_is_placed() {
    let machine = ["--machine", "tile-4", "--against", "icarus"];
    let few = ["--iterations", "60"];
    of_a_method_with_tools(&[&["verify", "placed"], &machine[..], &few].concat(), 0);
}
