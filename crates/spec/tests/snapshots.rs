//! Snapshots of the programs, disassembled from the words of the control store into readable text.

use photoncube_spec::overlap::Program;
use photoncube_spec::{
    CellTables, ControlWord, Machine, OVERLAPPED, Role, SEQUENTIAL, find_machine,
};

/// Lists every control word with its fields that are not zero.
fn disassemble(machine: &Machine) -> String {
    let program = machine.microprogram().expect("it runs a program");
    let words = program.control_words();
    let steps = program.steps();
    let lines = steps.iter().zip(words).enumerate();
    lines
        .map(|(address, (step, word))| {
            let fields = fields(&SEQUENTIAL, word, machine.dimension, |value| {
                value.to_string()
            });
            format!(
                "{address:>2}  {:<6}  {word:#07x}  {fields}\n",
                step.to_string()
            )
        })
        .collect()
}

/// The fields of a word that are not zero: the name alone of one that is a bit.
fn fields(
    tables: &CellTables,
    word: ControlWord,
    dimension: u32,
    value: impl Fn(u32) -> String,
) -> String {
    let fields =
        tables
            .fields
            .iter()
            .filter_map(|row| match tables.field(row.field, word, dimension) {
                0 => None,
                1 if (row.width)(dimension) == 1 => Some(row.name.to_owned()),
                found => Some(format!("{}={}", row.name, value(found))),
            });
    fields.collect::<Vec<_>>().join(" ")
}

#[test]
fn the_papers_control_store() {
    insta::assert_snapshot!(disassemble(find_machine("paper").unwrap()));
}

#[test]
fn the_control_store_of_five_dimensions() {
    insta::assert_snapshot!(disassemble(find_machine("paper-5d").unwrap()));
}

/// The kernel of the overlapped machine, and the control store of each role.
fn overlap_listing() -> String {
    let program = Program::rotated().expect("the scheduler finds it");
    let mut text = program.to_string();
    for role in Role::ALL {
        text += &format!("control store of role {role}:\n");
        for (address, word) in program.control_words(role).into_iter().enumerate() {
            let fields = fields(&OVERLAPPED, word, 4, |value| format!("{value:#b}"));
            let line = format!("{address:>2}  {word:#08x}  {fields}");
            text += &format!("{}\n", line.trim_end());
        }
    }
    text
}

#[test]
fn the_overlapped_kernel() {
    insta::assert_snapshot!(overlap_listing());
}
