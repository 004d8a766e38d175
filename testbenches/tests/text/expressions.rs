//! Compares random expressions of the whole subset with Icarus, thousands in one run.
//!
//! Numbers without a width are tested in `blocks.rs`, in the places where the emitted text has them. In
//! expressions Icarus evaluates them at a larger width than the standard states (its `-gstrict-expr-width` is
//! off).

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::design::{assert_as_in_icarus, design, rows};

pub const DESIGNS: u64 = 2;
const EXPRESSIONS: usize = 1_500;
const ROWS: usize = 24;

/// A signal that expressions may read.
#[derive(Clone, Debug)]
pub struct Name {
    pub name: String,
    pub width: u32,
}

pub fn name(name: impl Into<String>, width: u32) -> Name {
    Name {
        name: name.into(),
        width,
    }
}

pub const INPUTS: [u32; 10] = [1, 1, 3, 4, 8, 12, 16, 32, 33, 64];

pub fn inputs() -> Vec<(String, u32)> {
    let named = INPUTS.iter().enumerate();
    named
        .map(|(index, &width)| (format!("i{index}"), width))
        .collect()
}

/// The signals: inputs, signed and wide signals, one without a driver, and one that is half driven.
pub const SIGNALS: &str = "\
  wire signed [11:0] s0 = i5;
  wire signed [3:0] s1 = i3;
  wire signed [32:0] s2 = i8;
  wire [99:0] w0 = {i9, i7, i3};
  wire signed [69:0] w1 = {i8, i8, i2};
  reg [7:0] x0;
  wire [11:0] x1 = {i3, x0[3:0], i3};
";

pub fn names() -> Vec<Name> {
    let inputs = inputs()
        .into_iter()
        .map(|(input, width)| name(input, width));
    let more = [
        name("s0", 12),
        name("s1", 4),
        name("s2", 33),
        name("w0", 100),
        name("w1", 70),
        name("x0", 8),
        name("x1", 12),
    ];
    inputs.chain(more).collect()
}

pub fn as_icarus(seed: u64) {
    let rng = &mut Pcg64::seed_from_u64(seed);
    let names = names();
    let (mut outputs, mut items) = (Vec::new(), SIGNALS.to_owned());
    for index in 0..EXPRESSIONS {
        let width = rng.random_range(1..=64);
        let sign = ["", " signed"][rng.random_range(0..2)];
        let depth = rng.random_range(1..=4);
        let expression = expression(rng, &names, depth);
        items += &format!("  output wire{sign} [{}:0] o{index};\n", width - 1);
        items += &format!("  assign o{index} = {expression};\n");
        outputs.push((format!("o{index}"), width));
    }
    let design = design(&inputs(), &outputs, false, &items, "");
    let rows = rows(&design, ROWS, rng);
    let compared = assert_as_in_icarus(&design, &rows);
    assert_eq!(compared, EXPRESSIONS * ROWS);
}

/// A random expression. Operators that bind tighter are in parentheses at random.
pub fn expression(rng: &mut Pcg64, names: &[Name], depth: u32) -> String {
    if depth == 0 {
        return operand(rng, names);
    }
    let below = rng.random_range(0..depth);
    let inner = |rng: &mut Pcg64| {
        let text = expression(rng, names, below);
        match rng.random_range(0..3) {
            0 => text,
            _ => format!("({text})"),
        }
    };
    let (a, b) = (inner(rng), inner(rng));
    let mut one_of = |symbols: &[&'static str]| symbols[rng.random_range(0..symbols.len())];
    match one_of(&[
        "ab", "ab", "ab", "cmp", "cmp", "log", "sh", "un", "red", "if", "cat", "rep", "cast",
    ]) {
        "ab" => {
            let operator = one_of(&["+", "-", "*", "&", "|", "^", "~^"]);
            format!("{a} {operator} {b}")
        }
        "cmp" => {
            let operator = one_of(&["==", "!=", "<", "<=", ">", ">="]);
            format!("{a} {operator} {b}")
        }
        "log" => format!("{a} {} {b}", one_of(&["&&", "||"])),
        "sh" => {
            let operator = one_of(&["<<", ">>", ">>>"]);
            let by = match one_of(&["literal", "name", "any"]) {
                "literal" => format!("32'h{:x}", rng.random_range(0..70)),
                "name" => "i3".to_owned(),
                _ => operand(rng, names),
            };
            format!("{a} {operator} {by}")
        }
        "un" => format!("{}({a})", one_of(&["~", "-", "!", "+"])),
        "red" => format!("{}({a})", one_of(&["&", "|", "^", "~&", "~|", "~^"])),
        "if" => {
            let c = inner(rng);
            format!("({a} ? {b} : {c})")
        }
        "cat" => format!("{{{a}, {b}}}"),
        "rep" => format!("{{{}{{{a}}}}}", rng.random_range(1..4)),
        _ => format!("{}({a})", one_of(&["$signed", "$unsigned"])),
    }
}

/// A random operand: a signal, a part of one, or a number.
fn operand(rng: &mut Pcg64, names: &[Name]) -> String {
    let Name { name, width, .. } = &names[rng.random_range(0..names.len())];
    let width = *width;
    let (one, two) = (rng.random_range(0..width), rng.random_range(0..width));
    match rng.random_range(0..12) {
        0 => format!("{name}[{}:{}]", one.max(two), one.min(two)),
        1 => format!("{name}[32'h{one:x}]"),
        2 => format!("{name}[i3]"),
        3 => format!("{name}[({two})+:({})]", rng.random_range(1..10)),
        4 => format!("{name}[i2 +: {}]", rng.random_range(1..6)),
        5 => {
            let width = rng.random_range(1..=40);
            let value = rng.random::<u64>() & u64::MAX >> (64 - width);
            let sign = ["", "s"][rng.random_range(0..2)];
            format!("{width}'{sign}h{value:x}")
        }
        _ => name.clone(),
    }
}
