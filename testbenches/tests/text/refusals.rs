//! Requires that constructs outside the subset are refused by name and line.

use photoncube_testbench::Text;

use crate::design::design;

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

pub fn by_name_and_line() {
    for &(items, line, said) in REFUSED {
        let outputs = [("y".to_owned(), 1)];
        // The observed signal depends on `a`, where the items declare it.
        let driver = match items.contains(" a") && !items.contains("[0:3]") {
            true => "assign y = a;",
            false => "assign y = i;",
        };
        let items = format!("{items}\n  output wire y;\n  {driver}\n");
        let design = design(&[("i".to_owned(), 1)], &outputs, true, &items, OTHER);
        let Err(refusal) = Text::new(&design) else {
            panic!("not refused:\n{}", design.text);
        };
        let message = refusal.to_string();
        assert!(
            message.contains(said),
            "{message}; expected {said} of\n{}",
            design.text
        );
        let at = format!("line {line} ");
        assert!(
            message.contains(&at),
            "{message}; expected {at}of\n{}",
            design.text
        );
    }
}
