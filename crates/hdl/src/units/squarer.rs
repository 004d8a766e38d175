//! The unsigned squarer, as LUTs or as one product for a DSP block.
//!
//! rust-hdl multiplies 16 by 16 bits only, so this block writes its Verilog by hand; it is
//! simulated from the emitted text exhaustively, for every root.

use photoncube_spec::Squarer;
use rust_hdl::prelude::*;

/// Bits of a digit of [`Squarer::Digits`]: a LUT4 holds one bit of a digit's square.
const DIGIT: usize = 4;

/// `square = root^2`; `Q = 2 C`, exact.
#[derive(LogicBlock)]
pub(crate) struct SquarerBlock<const C: usize, const Q: usize> {
    pub root: Signal<In, Bits<C>>,
    pub square: Signal<Out, Bits<Q>>,
    _kind: Squarer,
}

impl<const C: usize, const Q: usize> SquarerBlock<C, Q> {
    pub fn new(kind: Squarer) -> Self {
        assert_eq!(Q, 2 * C);
        Self {
            root: Default::default(),
            square: Default::default(),
            _kind: kind,
        }
    }
}

impl<const C: usize, const Q: usize> Logic for SquarerBlock<C, Q> {
    fn update(&mut self) {
        let root = self.root.val().to_u64();
        self.square.next = (root * root).to_bits();
    }

    fn connect(&mut self) {
        self.square.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(match self._kind {
            Squarer::Product => "always @(*) square = root * root;\n".to_owned(),
            Squarer::Digits => digits_text(C),
        })
    }
}

/// With `root = sum of d_i 16^i`, `root^2 = sum of d_i^2 256^i + 2 sum of d_i d_j 16^(i+j)`, i < j:
/// the squares of the digits stand side by side without overlap, the products are added.
fn digits_text(width: usize) -> String {
    let digits = width.div_ceil(DIGIT);
    let mut text = square_function();
    if digits > 1 {
        text += PRODUCT_FUNCTION;
    }
    for i in 0..digits {
        let low = i * DIGIT;
        let high = width.min(low + DIGIT) - 1;
        text += &format!("wire [{}:0] digit_{i} = root[{high}:{low}];\n", DIGIT - 1);
    }
    let squares: Vec<_> = (0..digits)
        .rev()
        .map(|i| format!("digit_square(digit_{i})"))
        .collect();
    // Every term is at most as wide as the square, and Verilog extends it with zeros.
    let mut terms = vec![format!("{{{}}}", squares.join(", "))];
    for (i, j) in (0..digits).flat_map(|j| (0..j).map(move |i| (i, j))) {
        let shift = DIGIT * (i + j) + 1;
        terms.push(format!(
            "{{digit_product(digit_{i}, digit_{j}), {shift}'d0}}"
        ));
    }
    let sum = terms.join("\n    + ");
    text + &format!("always @(*) square = {sum};\n")
}

fn square_function() -> String {
    let (digit_bits, square_bits) = (DIGIT, 2 * DIGIT);
    let mut text = format!(
        "function [{}:0] digit_square;\n  input [{}:0] digit;\n  case (digit)\n",
        square_bits - 1,
        digit_bits - 1
    );
    let largest = (1_u32 << DIGIT) - 1;
    for digit in 0..=largest {
        let label = match digit {
            _ if digit == largest => "default".to_owned(),
            _ => format!("{digit_bits}'d{digit}"),
        };
        let square = digit * digit;
        text += &format!("    {label}: digit_square = {square_bits}'d{square};\n");
    }
    text + "  endcase\nendfunction\n"
}

/// Two bits of `first` at a time: each row is one carry chain of 6 bits. Yosys maps the bare `a * b`
/// to twice the LUTs.
const PRODUCT_FUNCTION: &str = "\
function [7:0] digit_product;
  input [3:0] first;
  input [3:0] second;
  reg [5:0] low;
  reg [5:0] high;
  begin
    low = (first[0] ? {2'd0, second} : 6'd0) + (first[1] ? {1'd0, second, 1'd0} : 6'd0);
    high = (first[2] ? {2'd0, second} : 6'd0) + (first[3] ? {1'd0, second, 1'd0} : 6'd0);
    digit_product = {2'd0, low} + {high, 2'd0};
  end
endfunction
";
