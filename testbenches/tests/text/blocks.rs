//! Compares random blocks of the whole subset with Icarus: with and without a clock, with memories, functions
//! and instances, and registers without initial values.

use std::fmt::Write as _;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::design::{assert_as_in_icarus, design, rows};
use crate::expressions::{Name, SIGNALS, expression, inputs, name, names};

pub const DESIGNS: u64 = 6;
const BLOCKS: usize = 120;
const ROWS: usize = 60;

/// A register in rust-hdl's form, with its clock on a pin.
const REGISTER: &str = "
module held(clock, d, q);
  parameter start = 0;
  input wire clock;
  input wire [7:0] d;
  output reg [7:0] q;
  initial begin
    q = start;
  end
  always @(posedge clock) begin
    q <= d;
  end
endmodule
";

pub fn as_icarus(seed: u64) {
    let rng = &mut Pcg64::seed_from_u64(seed);
    let mut blocks = Blocks {
        names: names(),
        outputs: Vec::new(),
        items: SIGNALS.to_owned() + "  reg ck;\n  always @(*) ck = clock;\n",
    };
    for index in 0..BLOCKS {
        match rng.random_range(0..8) {
            0..3 => blocks.combinational(rng, index),
            3..5 => blocks.register(rng, index),
            5 => blocks.memory(rng, index),
            6 => blocks.function(rng, index),
            _ => blocks.instance(rng, index),
        }
    }
    let design = design(&inputs(), &blocks.outputs, true, &blocks.items, REGISTER);
    let rows = rows(&design, ROWS, rng);
    let compared = assert_as_in_icarus(&design, &rows);
    assert_eq!(compared, ROWS * blocks.outputs.len());
}

struct Blocks {
    /// The signals that an expression may read: none that are declared later, so that there is no loop.
    names: Vec<Name>,
    outputs: Vec<(String, u32)>,
    items: String,
}

impl Blocks {
    fn declare(&mut self, rng: &mut Pcg64, signal: &str, kind: &str) -> u32 {
        let width = rng.random_range(1..=40);
        // Icarus shifts by a signed bit of 1 as by -1; in IEEE 1364 an amount is unsigned.
        let signs = if width > 1 { 2 } else { 1 };
        let sign = ["", "signed "][rng.random_range(0..signs)];
        let high = width - 1;
        let _ = writeln!(self.items, "  output {kind} {sign}[{high}:0] {signal};");
        self.outputs.push((signal.to_owned(), width));
        width
    }

    fn known(&mut self, signal: &str, width: u32) {
        self.names.push(name(signal, width));
    }

    fn combinational(&mut self, rng: &mut Pcg64, index: usize) {
        let signal = format!("c{index}");
        let width = self.declare(rng, &signal, "reg");
        let first = expression(rng, &self.names, 2);
        // The block reads an input, so that it runs: see `waits.rs`.
        let _ = writeln!(
            self.items,
            "  always @(*) begin\n    {signal} = i0;\n    {signal} = {first};"
        );
        let count = rng.random_range(0..4);
        for _ in 0..count {
            self.items += &statement(rng, &self.names, &signal, width, "=", 3);
        }
        self.items += "  end\n";
        self.known(&signal, width);
    }

    fn register(&mut self, rng: &mut Pcg64, index: usize) {
        let signal = format!("q{index}");
        let width = self.declare(rng, &signal, "reg");
        if rng.random_range(0..4) > 0 {
            let _ = writeln!(self.items, "  initial {signal} = {width}'h{:x};", index % 2);
        }
        // A register may read itself.
        self.known(&signal, width);
        self.items += "  always @(posedge clock) begin\n";
        let count = rng.random_range(1..4);
        for _ in 0..count {
            self.items += &statement(rng, &self.names, &signal, width, "<=", 3);
        }
        if rng.random_range(0..3) == 0 {
            let _ = writeln!(self.items, "    if (i0) {signal} <= 32'h0;");
        }
        self.items += "  end\n";
    }

    fn memory(&mut self, rng: &mut Pcg64, index: usize) {
        let signal = format!("r{index}");
        let width = self.declare(rng, &signal, "reg");
        let (last, memory) = (rng.random_range(1..20), format!("m{index}"));
        let high = width - 1;
        let _ = writeln!(
            self.items,
            "  (* no_rw_check *) reg [{high}:0] {memory} [0:{last}];"
        );
        if rng.random_range(0..3) > 0 {
            let _ = writeln!(
                self.items,
                "  integer n{index};\n  initial for (n{index} = 0; n{index} <= {last}; \
                 n{index} = n{index} + 1) {memory}[n{index}] = {width}'d1;"
            );
        }
        let [enable, data] = [2, 2].map(|depth| expression(rng, &self.names, depth));
        let write = ["i3", "i2", "x1[5:2]", "{i0, i3}"][rng.random_range(0..4)];
        let read = ["i3", "i2", "x1[5:2]", "i4[7:3]"][rng.random_range(0..4)];
        let _ = writeln!(
            self.items,
            "  always @(posedge clock) begin\n    if ({enable}) {memory}[{write}] <= {data};\n    \
             if (i1) {memory}[{read}] <= {signal};\n    {signal} <= {memory}[{read}];\n  end"
        );
        self.known(&signal, width);
        let other = format!("a{index}");
        let _ = writeln!(
            self.items,
            "  output wire [{high}:0] {other};\n  assign {other} = {memory}[{read}];"
        );
        self.outputs.push((other, width));
    }

    fn function(&mut self, rng: &mut Pcg64, index: usize) {
        let signal = format!("f{index}");
        let width = self.declare(rng, &signal, "wire");
        let (high, called) = (width - 1, format!("g{index}"));
        let inner = &[name("first", 4), name("second", 8)];
        let mut body = format!("        {called} = {};\n", local(rng, inner));
        for _ in 0..rng.random_range(0..3) {
            let (condition, value) = (local(rng, inner), local(rng, inner));
            let _ = writeln!(body, "        if ({condition}) {called} = {value};");
        }
        let _ = writeln!(
            self.items,
            "  function [{high}:0] {called};\n    input [3:0] first;\n    \
             input signed [7:0] second;\n    reg [5:0] kept;\n    begin\n        \
             kept = first + second;\n        {called} = kept;\n{body}        case (first)\n          \
             4'd3: {called} = 5;\n          4'd4, 4'd9: {called} = second;\n          \
             default: ;\n        endcase\n    end\n  endfunction"
        );
        let [a, b] = [1, 1].map(|depth| expression(rng, &self.names, depth));
        let _ = writeln!(
            self.items,
            "  assign {signal} = {called}({a}, {b}) + {called}(i3, i4);"
        );
        self.known(&signal, width);
    }

    fn instance(&mut self, rng: &mut Pcg64, index: usize) {
        let signal = format!("h{index}");
        let given = expression(rng, &self.names, 2);
        let start = ["", " #(.start(8'd7))"][rng.random_range(0..2)];
        let _ = writeln!(
            self.items,
            "  output wire [7:0] {signal};\n  wire [7:0] d{index} = {given};\n  \
             held{start} held{index}(.clock(ck), .d(d{index}), .q({signal}));"
        );
        self.outputs.push((signal.clone(), 8));
        self.known(&signal, 8);
    }
}

/// An expression of a function's own variables, without a computed selection.
fn local(rng: &mut Pcg64, names: &[Name]) -> String {
    let mut one = || {
        let name = &names[rng.random_range(0..names.len())].name;
        match rng.random_range(0..3) {
            0 => format!("{name}[3:1]"),
            1 => format!("4'd{}", rng.random_range(0..16)),
            _ => name.clone(),
        }
    };
    let (a, b, c) = (one(), one(), one());
    match rng.random_range(0..4) {
        0 => format!("{a} + {b}"),
        1 => format!("({a} < {b} ? {c} : {a})"),
        2 => format!("{{{a}, {b}}} ^ {c}"),
        _ => format!("{a} & ~{b} | {c}"),
    }
}

/// A statement that assigns the target, or a part of it, in some way.
fn statement(
    rng: &mut Pcg64,
    names: &[Name],
    target: &str,
    width: u32,
    operator: &str,
    depth: u32,
) -> String {
    let inner = |rng: &mut Pcg64| statement(rng, names, target, width, operator, depth - 1);
    let value = expression(rng, names, 2);
    let kind = if depth == 0 {
        0
    } else {
        rng.random_range(0..10)
    };
    match kind {
        0..3 => format!("    {target} {operator} {value};\n"),
        3 => {
            let (one, two) = (rng.random_range(0..width), rng.random_range(0..width));
            format!(
                "    {target}[{}:{}] {operator} {value};\n",
                one.max(two),
                one.min(two)
            )
        }
        4 => {
            let at = ["i3", "i2", "x1[3:1]"][rng.random_range(0..3)];
            match rng.random_range(0..2) {
                0 => format!("    {target}[{at}] {operator} {value};\n"),
                _ => format!("    {target}[({at})+:(3)] {operator} {value};\n"),
            }
        }
        5..8 => {
            let condition = expression(rng, names, 1);
            let (then, otherwise) = (inner(rng), inner(rng));
            match rng.random_range(0..2) {
                0 => format!("    if ({condition}) begin\n{then}    end\n"),
                _ => format!(
                    "    if ({condition}) begin\n{then}    end else begin\n{otherwise}    end\n"
                ),
            }
        }
        _ => {
            let selector = ["i2", "i3", "x1[3:0]", "s1"][rng.random_range(0..4)];
            let mut items = String::new();
            for label in ["0", "3'd1, 3'd3", "4'b0100", "i0"] {
                let _ = write!(items, "    {label}: begin\n{}    end\n", inner(rng));
            }
            if rng.random_range(0..2) == 0 {
                let _ = write!(items, "    default: begin\n{}    end\n", inner(rng));
            }
            format!("    case ({selector})\n{items}    endcase\n")
        }
    }
}
