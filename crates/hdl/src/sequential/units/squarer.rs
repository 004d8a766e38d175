//! The unsigned squarer, from LUTs or as one product for a DSP block.
//!
//! rust-hdl multiplies 16 by 16 bits only, so this block writes its Verilog by hand. It is simulated
//! exhaustively, for every root, from the emitted text.

use photoncube_spec::Squarer;
use rust_hdl::prelude::*;

/// Bits of a digit of [`Squarer::Digits`]: a LUT4 holds one bit of a digit's square.
const DIGIT: usize = 4;

/// The function of the root that is computed.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Power {
    /// `m m`.
    Square,
    /// `m (m + 1)`: the square of `m + 1/2`, without its constant quarter.
    HalfSquare,
}

/// `square` is the square or half square of `root`; `Q = 2 M`, exact.
#[derive(LogicBlock)]
pub(crate) struct SquarerBlock<const M: usize, const Q: usize> {
    pub root: Signal<In, Bits<M>>,
    pub square: Signal<Out, Bits<Q>>,
    _kind: Squarer,
    _power: Power,
}

impl<const M: usize, const Q: usize> SquarerBlock<M, Q> {
    pub fn new(kind: Squarer, power: Power) -> Self {
        assert_eq!(Q, 2 * M);
        Self {
            root: Default::default(),
            square: Default::default(),
            _kind: kind,
            _power: power,
        }
    }
}

impl<const M: usize, const Q: usize> Logic for SquarerBlock<M, Q> {
    fn update(&mut self) {
        self.square.next = self._power.of(self.root.val().to_u64()).to_bits();
    }

    fn connect(&mut self) {
        self.square.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(match (self._kind, self._power) {
            (Squarer::Product, Power::Square) => product_text("root * root"),
            (Squarer::Product, Power::HalfSquare) => product_text("root * root + root"),
            (Squarer::Digits, Power::Square) => square_text(M),
            (Squarer::Digits, Power::HalfSquare) => half_square_text(M),
            (Squarer::Table, _) => unreachable!("tables are in spatial machines"),
        })
    }
}

impl Power {
    fn of(self, root: u64) -> u64 {
        match self {
            Self::Square => root * root,
            Self::HalfSquare => root * (root + 1),
        }
    }

    /// The name of the function's table of digits.
    fn table(self) -> &'static str {
        match self {
            Self::Square => "digit_square",
            Self::HalfSquare => "digit_half_square",
        }
    }
}

fn product_text(product: &str) -> String {
    format!("always @(*) square = {product};\n")
}

/// With `root = sum of d_i 16^i`, `root^2 = sum of d_i^2 256^i + 2 sum of d_i d_j 16^(i+j)`, i < j. The
/// squares of the digits do not overlap and are concatenated; the products are added.
fn square_text(width: usize) -> String {
    let digits = width.div_ceil(DIGIT);
    let products = pairs(digits).map(|(i, j)| {
        let shift = DIGIT * (i + j) + 1;
        format!("{{digit_product(digit_{i}, digit_{j}), {shift}'d0}}")
    });
    let mut text = table_function(Power::Square);
    if digits > 1 {
        text += &product_function(DIGIT);
    }
    text + &digit_wires(width) + &sum_text(Power::Square, digits, products)
}

/// `root (root + 1)` is the square plus the sum of `d_i 16^i`. At i = 0 the digit's square becomes
/// `d_0 (d_0 + 1)`. The other terms are part of the products with digit 0:
/// `2 d_0 d_j + d_j = (2 d_0 + 1) d_j`, which sets one bit below `d_0` and needs no adder.
fn half_square_text(width: usize) -> String {
    let digits = width.div_ceil(DIGIT);
    let products = pairs(digits).map(|(i, j)| {
        let shift = DIGIT * (i + j);
        let below = u8::from(i == 0);
        format!("{{digit_product(digit_{j}, {{digit_{i}, 1'd{below}}}), {shift}'d0}}")
    });
    let mut text = table_function(Power::HalfSquare);
    if digits > 1 {
        text += &table_function(Power::Square);
        text += &product_function(DIGIT + 1);
    }
    text + &digit_wires(width) + &sum_text(Power::HalfSquare, digits, products)
}

/// All pairs i < j of digits.
fn pairs(digits: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..digits).flat_map(|j| (0..j).map(move |i| (i, j)))
}

fn digit_wires(width: usize) -> String {
    let wire = |i: usize| {
        let low = i * DIGIT;
        let high = width.min(low + DIGIT) - 1;
        format!("wire [{}:0] digit_{i} = root[{high}:{low}];\n", DIGIT - 1)
    };
    (0..width.div_ceil(DIGIT)).map(wire).collect()
}

/// The sum of the digits' squares, of which the lowest is that of `lowest`, and the products. Verilog extends
/// a term with zeros. Where the highest digit is short, the bits that are truncated are 0.
fn sum_text(lowest: Power, digits: usize, products: impl Iterator<Item = String>) -> String {
    let squares: Vec<_> = (0..digits)
        .rev()
        .map(|i| {
            let power = if i == 0 { lowest } else { Power::Square };
            format!("{}(digit_{i})", power.table())
        })
        .collect();
    let mut terms = vec![format!("{{{}}}", squares.join(", "))];
    terms.extend(products);
    format!("always @(*) square = {};\n", terms.join("\n    + "))
}

fn table_function(power: Power) -> String {
    let name = power.table();
    let (digit_bits, square_bits) = (DIGIT, 2 * DIGIT);
    let mut text = format!(
        "function [{}:0] {name};\n  input [{}:0] digit;\n  case (digit)\n",
        square_bits - 1,
        digit_bits - 1
    );
    let largest = (1_u64 << DIGIT) - 1;
    for digit in 0..=largest {
        let label = match digit {
            _ if digit == largest => "default".to_owned(),
            _ => format!("{digit_bits}'d{digit}"),
        };
        let square = power.of(digit);
        text += &format!("    {label}: {name} = {square_bits}'d{square};\n");
    }
    text + "  endcase\nendfunction\n"
}

/// The product of `first` and `second`, two bits of `first` at a time: each row is one carry chain of two
/// bits more than `second`. Yosys maps the plain `a * b` to twice the LUTs.
fn product_function(second_bits: usize) -> String {
    let (row_bits, product_bits) = (second_bits + 2, second_bits + DIGIT);
    let row = |name: &str, bit: usize| {
        format!(
            "    {name} = (first[{bit}] ? {{2'd0, second}} : {row_bits}'d0) \
             + (first[{}] ? {{1'd0, second, 1'd0}} : {row_bits}'d0);\n",
            bit + 1
        )
    };
    let mut text = format!("function [{}:0] digit_product;\n", product_bits - 1);
    text += &format!("  input [{}:0] first;\n", DIGIT - 1);
    text += &format!("  input [{}:0] second;\n", second_bits - 1);
    for name in ["low", "high"] {
        text += &format!("  reg [{}:0] {name};\n", row_bits - 1);
    }
    text += "  begin\n";
    text += &row("low", 0);
    text += &row("high", 2);
    text += "    digit_product = {2'd0, low} + {high, 2'd0};\n";
    text + "  end\nendfunction\n"
}
