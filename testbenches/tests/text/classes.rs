//! For each class of text that Verilog reads differently from the Rust it was printed from: the mistake as
//! rust-hdl prints it, and its correction. The evaluator must reproduce the mistake.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::design::{assert_as_in_icarus, design, in_text, rows};

/// A mistake, its correction, and the meaning of the Rust code. Both assign `y`.
struct Class {
    name: &'static str,
    width: u32,
    bad: &'static str,
    good: &'static str,
    meaning: fn(&Row) -> u64,
}

/// The inputs of a row: `a b c` of 12 bits, `m n o p` of 16, `s t` of 16 and `u` of 34 bits signed,
/// and `v` of 8 signed.
struct Row {
    a: u64,
    b: u64,
    c: u64,
    m: u64,
    n: u64,
    o: u64,
    p: u64,
    s: i64,
    t: i64,
    u: i64,
    v: i64,
}

const INPUTS: [(&str, u32); 11] = [
    ("a", 12),
    ("b", 12),
    ("c", 12),
    ("m", 16),
    ("n", 16),
    ("o", 16),
    ("p", 16),
    ("s_bits", 16),
    ("t_bits", 16),
    ("u_bits", 34),
    ("v_bits", 8),
];

const SIGNED: &str = "\
  wire signed [15:0] s = s_bits;
  wire signed [15:0] t = t_bits;
  wire signed [33:0] u = u_bits;
  wire signed [7:0] v = v_bits;
";

impl Row {
    fn of(values: &[u64]) -> Self {
        let signed = |index: usize| {
            let above = u64::BITS - INPUTS[index].1;
            ((values[index] << above) as i64) >> above
        };
        Self {
            a: values[0],
            b: values[1],
            c: values[2],
            m: values[3],
            n: values[4],
            o: values[5],
            p: values[6],
            s: signed(7),
            t: signed(8),
            u: signed(9),
            v: signed(10),
        }
    }
}

const M12: u64 = 0xfff;

const CLASSES: &[Class] = &[
    Class {
        name: "sum_in_a_wider_place",
        width: 13,
        bad: "always @(*) y = ((a + b) & 13'h1fff);",
        good: "reg [11:0] t0; always @(*) begin t0 = a + b; y = ((t0) & 13'h1fff); end",
        meaning: |r| (r.a + r.b) & M12,
    },
    Class {
        name: "difference_in_a_wider_place",
        width: 13,
        bad: "always @(*) y = ((a - b) & 13'h1fff);",
        good: "reg [11:0] t0; always @(*) begin t0 = a - b; y = ((t0) & 13'h1fff); end",
        meaning: |r| r.a.wrapping_sub(r.b) & M12,
    },
    Class {
        name: "inverse_in_a_wider_place",
        width: 13,
        bad: "always @(*) y = ((~a) & 13'h1fff);",
        good: "reg [11:0] t0; always @(*) begin t0 = ~a; y = ((t0) & 13'h1fff); end",
        meaning: |r| !r.a & M12,
    },
    Class {
        name: "shift_in_a_wider_place",
        width: 13,
        bad: "always @(*) y = ((a << 32'h3) & 13'h1fff);",
        good: "reg [11:0] t0; always @(*) begin t0 = a << 32'h3; y = ((t0) & 13'h1fff); end",
        meaning: |r| r.a << 3 & M12,
    },
    Class {
        name: "inverse_of_a_comparison",
        width: 13,
        bad: "always @(*) y = ((~(a > b)) & 13'h1fff);",
        good: "reg t0; always @(*) begin t0 = ~(a > b); y = ((t0) & 13'h1fff); end",
        meaning: |r| u64::from(r.a <= r.b),
    },
    Class {
        name: "sum_compared_with_a_literal_in_it",
        width: 1,
        bad: "always @(*) y = a + 32'h1 == b;",
        good: "reg [11:0] t0; always @(*) begin t0 = a + 32'h1; y = t0 == b; end",
        meaning: |r| u64::from((r.a + 1) & M12 == r.b),
    },
    Class {
        name: "difference_compared_with_a_literal",
        width: 1,
        bad: "always @(*) y = (a - b) > 32'h5;",
        good: "reg [11:0] t0; always @(*) begin t0 = a - b; y = t0 > 32'h5; end",
        meaning: |r| u64::from(r.a.wrapping_sub(r.b) & M12 > 5),
    },
    Class {
        name: "inverse_compared_with_a_literal",
        width: 1,
        bad: "always @(*) y = ~a != 32'hfff;",
        good: "reg [11:0] t0; always @(*) begin t0 = ~a; y = t0 != 32'hfff; end",
        meaning: |r| u64::from(!r.a & M12 != 0xfff),
    },
    Class {
        name: "and_beside_an_equality",
        width: 1,
        bad: "always @(*) y = a & b == c;",
        good: "always @(*) y = (a & b) == c;",
        meaning: |r| u64::from(r.a & r.b == r.c),
    },
    Class {
        name: "or_beside_an_equality",
        width: 1,
        bad: "always @(*) y = a | b == c;",
        good: "always @(*) y = (a | b) == c;",
        meaning: |r| u64::from(r.a | r.b == r.c),
    },
    Class {
        name: "xor_beside_a_comparison",
        width: 1,
        bad: "always @(*) y = a ^ b > c;",
        good: "always @(*) y = (a ^ b) > c;",
        meaning: |r| u64::from(r.a ^ r.b > r.c),
    },
    Class {
        name: "signed_below_a_literal",
        width: 1,
        bad: "always @(*) y = s < 32'h5;",
        good: "wire signed [15:0] t0 = 16'h5; always @(*) y = s < t0;",
        meaning: |r| u64::from(r.s < 5),
    },
    Class {
        name: "signed_below_a_part_of_a_signed",
        width: 1,
        bad: "always @(*) y = v < s[7:0];",
        good: "reg signed [7:0] t0; always @(*) begin t0 = s[7:0]; y = v < t0; end",
        meaning: |r| u64::from(r.v < i64::from(r.s as i8)),
    },
    Class {
        name: "sum_times",
        width: 24,
        bad: "always @(*) y = (a + b) * c;",
        good: "reg [11:0] t0; always @(*) begin t0 = a + b; y = t0 * c; end",
        meaning: |r| ((r.a + r.b) & M12) * r.c,
    },
    Class {
        name: "square_of_a_difference",
        width: 24,
        bad: "always @(*) y = (a - b) * (a - b);",
        good: "reg [11:0] t0; always @(*) begin t0 = a - b; y = t0 * t0; end",
        meaning: |r| (r.a.wrapping_sub(r.b) & M12).pow(2),
    },
    Class {
        name: "signed_sum_times",
        width: 32,
        bad: "always @(*) y = (s + t) * s;",
        good: "reg signed [15:0] t0; always @(*) begin t0 = s + t; y = t0 * s; end",
        meaning: |r| ((i64::from((r.s + r.t) as i16) * r.s) as u64) & 0xffff_ffff,
    },
    Class {
        name: "signed_product_in_a_cast",
        width: 34,
        bad: "always @(*) y = $signed(s * t) + u;",
        good: "reg signed [31:0] t0; always @(*) begin t0 = s * t; y = $signed(t0) + u; end",
        meaning: |r| (r.s * r.t + r.u) as u64 & ((1 << 34) - 1),
    },
    Class {
        name: "products_compared",
        width: 1,
        bad: "always @(*) y = m * n == o * p;",
        good: "reg [31:0] t0, t1; always @(*) begin t0 = m * n; t1 = o * p; y = t0 == t1; end",
        meaning: |r| u64::from(r.m * r.n == r.o * r.p),
    },
    Class {
        name: "upper_half_of_a_product",
        width: 16,
        // Icarus finds that this is 0, and without `t0` the block would wait for nothing.
        bad: "reg t0; always @(*) begin t0 = m[0]; y = (((m * n) >> 32'h10) & 16'hffff); end",
        good: "reg [31:0] t0; always @(*) begin t0 = m * n; y = ((t0 >> 32'h10) & 16'hffff); end",
        meaning: |r| (r.m * r.n) >> 16,
    },
    Class {
        name: "signed_narrowed_and_compared",
        width: 1,
        bad: "always @(*) y = $signed(s) < v;",
        good: "reg signed [7:0] t0; always @(*) begin t0 = s; y = t0 < v; end",
        meaning: |r| u64::from(i64::from(r.s as i8) < r.v),
    },
    Class {
        name: "bits_above_the_top",
        width: 5,
        bad: "always @(*) y = a[(32'h9)+:(5)];",
        good: "reg [23:0] t0; always @(*) begin t0 = a; y = t0[(32'h9)+:(5)]; end",
        meaning: |r| r.a >> 9,
    },
    Class {
        name: "a_block_of_constants",
        width: 3,
        bad: "always @(*) y = 3'h7;",
        good: "always @(*) begin y = 3'h7; if (a[0]) y = 3'h7; end",
        meaning: |_| 7,
    },
    Class {
        name: "a_word_that_is_never_written",
        width: 8,
        bad: "reg [7:0] words [0:15]; always @(*) y = words[a[3:0]];",
        good: "reg [7:0] words [0:15]; integer i;
  initial for (i = 0; i <= 15; i = i + 1) words[i] = 8'd0;
  always @(*) y = words[a[3:0]];",
        meaning: |_| 0,
    },
];

/// One design with a module for each class.
fn all() -> photoncube_hdl::Emitted {
    let inputs = INPUTS.map(|(name, width)| (name.to_owned(), width));
    let (mut outputs, mut items, mut modules) = (Vec::new(), String::new(), String::new());
    let ports = INPUTS.map(|(name, _)| name).join(", ");
    let wires = INPUTS.map(|(name, width)| format!("  input wire [{}:0] {name};\n", width - 1));
    let joined = INPUTS
        .map(|(name, _)| format!(".{name}({name})"))
        .join(", ");
    for class in CLASSES {
        for (way, text) in [("bad", class.bad), ("good", class.good)] {
            let (name, high) = (format!("{way}_{}", class.name), class.width - 1);
            items += &format!("  output wire [{high}:0] {name};\n");
            items += &format!("  m_{name} of_{name}({joined}, .y({name}));\n");
            modules += &format!("module m_{name}({ports}, y);\n{}", wires.concat());
            modules += &format!("  output reg [{high}:0] y;\n{SIGNED}  {text}\nendmodule\n");
            outputs.push((name, class.width));
        }
    }
    design(&inputs, &outputs, false, &items, &modules)
}

/// Random rows, and rows in which the operands are nearly equal, which show the mistakes.
fn vectors(design: &photoncube_hdl::Emitted) -> Vec<u64> {
    let rng = &mut Pcg64::seed_from_u64(3);
    let mut vectors = rows(design, 600, rng);
    for (index, row) in vectors.chunks_exact_mut(INPUTS.len()).enumerate() {
        if index % 3 == 0 {
            row[1] = (row[0] + index as u64 % 4) & M12;
            row[2] = [row[0] & row[1], row[0] | row[1], 0][index % 9 / 3];
            // Products that agree only in the lower half.
            (row[3], row[4], row[5], row[6]) = (0x100, 0x100 << rng.random_range(0..2), 0, 1);
        }
    }
    vectors
}

/// The correction has the meaning of the Rust code, and the mistake does not.
pub fn as_verilog() {
    let design = all();
    let vectors = vectors(&design);
    let observed = in_text(&design, &vectors);
    let outputs = design.pins.observed.len();
    for (column, class) in CLASSES.iter().enumerate() {
        let mut mistaken = 0;
        for (index, row) in vectors.chunks_exact(INPUTS.len()).enumerate() {
            let meant = (class.meaning)(&Row::of(row));
            let shown = |column: usize| {
                let at = index * outputs + column;
                let known = observed.unknown.iter().all(|unknown| unknown.index != at);
                known.then_some(observed.values[at])
            };
            assert_eq!(
                shown(2 * column + 1),
                Some(meant),
                "{}, {row:x?}",
                class.name
            );
            mistaken += usize::from(shown(2 * column) != Some(meant));
        }
        assert!(mistaken > 0, "{}: the mistake is not one", class.name);
    }
}

/// Mistake and correction give in Icarus the values that they give in the evaluator.
pub fn as_icarus() {
    let design = all();
    let vectors = vectors(&design);
    let compared = assert_as_in_icarus(&design, &vectors);
    assert_eq!(compared, 600 * 2 * CLASSES.len());
}
