//! Snapshots of the programs, disassembled from the words of the control store into readable text.

use photoncube_spec::{ControlWord, FIELDS, Field, Machine, find_machine};

/// Lists every control word with its fields that are not zero.
fn disassemble(machine: &Machine) -> String {
    let program = machine.microprogram().expect("it runs a program");
    let words = program.control_words();
    let steps = program.steps();
    let lines = steps.iter().zip(words).enumerate();
    lines
        .map(|(address, (step, word))| {
            let fields = fields(word, machine.dimension);
            format!(
                "{address:>2}  {:<6}  {word:#07x}  {fields}\n",
                step.to_string()
            )
        })
        .collect()
}

fn fields(word: ControlWord, dimension: u32) -> String {
    let field = |field: Field| match field.of(word, dimension) {
        0 => None,
        1 if (field.row().width)(dimension) == 1 => Some(field.row().name.to_owned()),
        value => Some(format!("{}={value}", field.row().name)),
    };
    let names: Vec<_> = FIELDS.iter().filter_map(|row| field(row.field)).collect();
    names.join(" ")
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
    use photoncube_spec::Role;
    use photoncube_spec::overlap::{FIELDS, Program};
    let program = Program::rotated().expect("the scheduler finds it");
    let mut text = program.to_string();
    for role in Role::ALL {
        text += &format!("control store of role {role}:\n");
        for (address, word) in program.control_words(role).into_iter().enumerate() {
            let fields = FIELDS.iter().map(|row| (row, row.field.of(word)));
            let fields = fields.filter(|(_, value)| *value != 0).map(|(row, value)| {
                if row.width == 1 {
                    row.name.to_owned()
                } else {
                    format!("{}={value:#b}", row.name)
                }
            });
            let fields: Vec<_> = fields.collect();
            let line = format!("{address:>2}  {word:#08x}  {}", fields.join(" "));
            text += &format!("{}\n", line.trim_end());
        }
    }
    text
}

#[test]
fn the_overlapped_kernel() {
    insta::assert_snapshot!(overlap_listing());
}
