//! Snapshots of the emitted cell and its three units, which are small enough to be read. A review sees a
//! change of the hardware as a change of this text.

use photoncube_hdl::{Level, emit};
use photoncube_spec::{Unit, find_machine};
use verilog_eval::modules;

fn text(machine: &str, level: Level) -> String {
    let machine = find_machine(machine).unwrap();
    emit(machine, level).unwrap().text
}

/// The first module of the text: the part itself, without the modules that it instantiates.
fn first_module(text: &str) -> String {
    text[..modules(text)[0].place.end].to_owned() + "\n"
}

/// The module whose name ends with `name`.
fn only_module(text: &str, name: &str) -> String {
    let mut modules = modules(text).into_iter();
    let module = modules.find(|module| module.name.ends_with(name));
    module.unwrap().text.to_owned() + "\n"
}

#[test]
fn the_cell() {
    insta::assert_snapshot!(first_module(&text("paper", Level::Cell)));
}

#[test]
fn the_unit_that_adds() {
    insta::assert_snapshot!(text("paper", Level::Unit(Unit::Add)));
}

#[test]
fn the_unit_that_squares_differences() {
    insta::assert_snapshot!(text("paper", Level::Unit(Unit::Square)));
}

#[test]
fn the_clamped_difference() {
    insta::assert_snapshot!(only_module(
        &text("local", Level::Unit(Unit::Square)),
        "_difference"
    ));
}

#[test]
fn the_difference_from_a_grid_line() {
    insta::assert_snapshot!(only_module(
        &text("fit-ring", Level::Unit(Unit::Square)),
        "_difference"
    ));
}

#[test]
fn the_half_squarer() {
    insta::assert_snapshot!(only_module(
        &text("fit-ring", Level::Unit(Unit::Square)),
        "_squarer"
    ));
}

#[test]
fn the_unit_that_gates() {
    insta::assert_snapshot!(text("paper", Level::Unit(Unit::Gate)));
}
