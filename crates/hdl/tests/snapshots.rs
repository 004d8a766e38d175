//! The emitted cell and its three units, small enough to be read: a change of the hardware is
//! seen in the review as a change of this text.

use photoncube_hdl::{Level, emit};
use photoncube_spec::find_machine;

fn text(level: Level) -> String {
    let paper = find_machine("paper").unwrap();
    emit(paper, level).unwrap().text
}

/// The first module: the part itself without what it instantiates.
fn first_module(text: &str) -> String {
    let end = text.find("endmodule").unwrap() + "endmodule".len();
    text[..end].to_owned() + "\n"
}

#[test]
fn the_cell() {
    insta::assert_snapshot!(first_module(&text(Level::Cell)));
}

#[test]
fn the_unit_that_adds() {
    insta::assert_snapshot!(text(Level::Add));
}

#[test]
fn the_unit_that_squares_differences() {
    insta::assert_snapshot!(text(Level::Square));
}

#[test]
fn the_unit_that_gates() {
    insta::assert_snapshot!(text(Level::Gate));
}
