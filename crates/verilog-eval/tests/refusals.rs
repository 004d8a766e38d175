//! Requires that constructs outside the subset are refused by name and line.

use verilog_eval::{Design, Evaluator, Signal, instances_in};

const OTHER: &str = "module other(i, o);\n  input wire i;\n  output wire o;\nendmodule\n";

/// The items of a module, the line that is refused, and a part of the message.
const REFUSED: &[(&str, u32, &str)] = &[
    ("wire a;\nassign a = b;", 5, "`b` is not declared"),
    (
        "wire a;\nassign a = 1'bx;",
        5,
        "`1'bx`; expected a number without unknown bits",
    ),
    ("wire [3:0] a = 4'd7 / 4'd2;", 4, "`/`"),
    ("wire [3:0] a = 4'd7 % 4'd2;", 4, "`%`"),
    ("wire a = 1'b1 === 1'b1;", 4, "`===`"),
    ("wire a = 1'b1 !== 1'b1;", 4, "`!==`"),
    ("wire [3:0] a = 4'd7 ** 4'd2;", 4, "`**`"),
    ("wire a = i[0 -: 1];", 4, "`-:`"),
    ("wire [0:3] a;", 4, "[0:3]"),
    ("wire [4:1] a;", 4, "[4:1]"),
    (
        "reg a;\nalways @(posedge clock or negedge y) a <= 1;",
        5,
        "`or`",
    ),
    ("reg a;\nalways @(negedge clock) a <= 1;", 5, "`negedge`"),
    (
        "reg a;\nalways @(clock) a = 1;",
        5,
        "`clock`; expected * or posedge",
    ),
    ("reg a;\nalways #1 a = 1;", 5, "`#`"),
    (
        "reg a;\nalways @(posedge clock) a = 1;",
        5,
        "`=` in a block with a clock",
    ),
    ("reg a;\nalways @(*) a <= i;", 5, "`<=` without a clock"),
    (
        "reg a;\nalways @(*) if (i) a = 1;",
        5,
        "`a` is not assigned on every way through the block: a latch",
    ),
    (
        "reg a, b;\nalways @(*) begin a = b; b = i; end",
        5,
        "`b` is read before it is assigned",
    ),
    (
        "wire a, b;\nassign a = ~b;\nassign b = a & i;",
        4,
        "a loop without a register",
    ),
    ("wire a = i;\nassign a = i;", 5, "`a` is driven twice"),
    (
        "reg a;\nalways @(*) a = i;\nalways @(*) a = i;",
        6,
        "`a` is driven twice",
    ),
    (
        "reg a;\nalways @(posedge i) a <= i;",
        5,
        "the clock `i` is not that of the top module",
    ),
    ("wire a = clock & i;", 1, "the clock is read as a value"),
    ("another o(.a(i));", 4, "no module `another`"),
    ("top t(.i(i));", 1, "`top` is in itself"),
    (
        "wire [3:0] a; wire o;\nother b(.i(a), .o(o));",
        5,
        "4 bits on `i`, which has 1",
    ),
    ("initial $display(1);", 4, "`$display`"),
    ("generate\nendgenerate", 4, "`generate`; expected a name"),
    ("wire a;\nwire a;", 5, "`a` is declared twice"),
    (
        "reg [3:0] a;\nalways @(*) for (a = 0; a < 3; a = a + 1) ;",
        5,
        "`for` outside an initial block",
    ),
    (
        "function f; input x; f = i; endfunction\nwire a = f(i);",
        4,
        "a function reads `i`",
    ),
    ("`define X\n", 4, "``define`"),
    ("wire a = \"text\";", 4, "`\"text\";`"),
    (
        "wire [7:0] a = {4, i};",
        4,
        "a number without a width in a concatenation",
    ),
    (
        "reg [3:0] m [0:3];\nalways @(*) m[i] = 1;",
        5,
        "a word of `m` is assigned without a clock",
    ),
    ("wire a", 5, "`output`; expected ;"),
];

/// A module of these items that drives `y`, behind three lines of its own.
fn module(items: &str) -> String {
    // Only logic that `y` depends on is compiled: `a`, where the items have one.
    let driver = match items.contains(" a") && !items.contains("[0:3]") {
        true => "assign y = a;",
        false => "assign y = i;",
    };
    format!(
        "module top(i, y, clock);\n  input wire clock;\n  input wire i;\n{items}\n  output wire y;\n  {driver}\n\
         endmodule\n{OTHER}"
    )
}

fn evaluator(text: &str, inputs: &[(&str, u32)]) -> Result<Evaluator, verilog_eval::Refusal> {
    Evaluator::new(&Design {
        text,
        top: "top",
        clock: Some("clock"),
        inputs: inputs
            .iter()
            .map(|&(name, width)| Signal::new(name, width))
            .collect(),
        observed: vec![Signal::new("y", 1)],
        zeroed_memories: vec![],
    })
}

#[test]
fn are_by_name_and_line() {
    for &(items, line, said) in REFUSED {
        let text = module(items);
        let Err(refusal) = evaluator(&text, &[("i", 1)]) else {
            panic!("not refused:\n{text}");
        };
        let message = refusal.to_string();
        assert!(
            message.contains(said),
            "{message}; expected {said} of\n{text}"
        );
        assert_eq!(refusal.line(), line, "{message} of\n{text}");
        assert!(message.starts_with(&format!("line {line} ")), "{message}");
    }
}

#[test]
fn signals_that_are_not_there_in_that_width_are_refused() {
    let text = module("wire a = i;");
    for (inputs, said) in [
        (("b", 1), "there is no signal `b`"),
        (("i", 2), "`i` has 1 bits; expected 2"),
    ] {
        let refusal = evaluator(&text, &[inputs]).err().expect("it is refused");
        assert!(refusal.to_string().contains(said), "{refusal}");
    }
    let wide = module("input wire [64:0] w;\nwire a = i;");
    let refusal = evaluator(&wide, &[("w", 65)]).err().expect("it is refused");
    assert!(refusal.to_string().contains("at most 64"), "{refusal}");
}

#[test]
fn instances_are_those_of_the_module_with_parameters_too() {
    let text = format!(
        "{OTHER}module top(i, o);\n  input wire i;\n  output wire o;\n  wire between;\n  other first(.i(i), .o(between));\n  \
         absent #(.BITS(2)) second(.i(between), .o(o));\nendmodule\n"
    );
    let found = instances_in(&text, "top").unwrap();
    let named = |name: &str, module: &str| (name.to_owned(), module.to_owned());
    assert_eq!(found, [named("first", "other"), named("second", "absent")]);
    assert_eq!(instances_in(&text, "other").unwrap(), []);
    let refusal = instances_in(&text, "bottom").unwrap_err().to_string();
    assert!(refusal.contains("no module `bottom`"), "{refusal}");
}
