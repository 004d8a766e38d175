//! The parts of a square from two digits of |d|, a high one of 4 bits and a low one of r - 4:
//! `(16.. high + low)^2` from tables of squares and from sums of gated digits.
//!
//! These blocks select single bits and slices by a machine's widths, which rust-hdl's kernels cannot express,
//! so their Verilog is written by hand. The square as a whole is simulated from the emitted text for every
//! pair of coordinates.

use photoncube_spec::Widths;
use rust_hdl::prelude::*;

/// Bits of the high digit.
const HIGH: usize = Widths::HIGH_DIGIT as usize;
/// Bits of the low digit that the first of the two products uses.
const FIRST: usize = 2;

/// `magnitude = |difference|`; `D = C + 1`.
#[derive(LogicBlock, Default)]
pub(crate) struct Magnitude<const C: usize, const D: usize> {
    pub difference: Signal<In, Bits<D>>,
    pub magnitude: Signal<Out, Bits<C>>,
}

impl<const C: usize, const D: usize> Logic for Magnitude<C, D> {
    fn update(&mut self) {
        let difference = self.difference.val().to_u64();
        let modulus = 1 << D;
        let magnitude = if difference >= modulus / 2 {
            modulus - difference
        } else {
            difference
        };
        // The lowest number of D bits is not a difference of two coordinates.
        self.magnitude.next = (magnitude % (modulus / 2)).to_bits();
    }

    fn connect(&mut self) {
        self.magnitude.connect();
    }

    fn hdl(&self) -> Verilog {
        let (sign, high) = (D - 1, C - 1);
        Verilog::Custom(format!(
            "wire negative = difference[{sign}];\n\
             wire [{high}:0] inverted = difference[{high}:0] ^ {{{C}{{negative}}}};\n\
             always @(*) magnitude = inverted + {{{high}'d0, negative}};\n",
        ))
    }
}

/// `counted = magnitude` modulo 2^R, and whether it exceeds R bits.
#[derive(LogicBlock, Default)]
pub(crate) struct SplitMagnitude<const C: usize, const R: usize> {
    pub magnitude: Signal<In, Bits<C>>,
    pub counted: Signal<Out, Bits<R>>,
    pub far: Signal<Out, Bit>,
}

impl<const C: usize, const R: usize> Logic for SplitMagnitude<C, R> {
    fn update(&mut self) {
        let magnitude = self.magnitude.val().to_u64();
        self.counted.next = (magnitude % (1 << R)).to_bits();
        self.far.next = magnitude >> R != 0;
    }

    fn connect(&mut self) {
        self.counted.connect();
        self.far.connect();
    }

    fn hdl(&self) -> Verilog {
        let (top, high) = (C - 1, R - 1);
        Verilog::Custom(format!(
            "always @(*) counted = magnitude[{high}:0];\n\
             always @(*) far = |magnitude[{top}:{R}];\n",
        ))
    }
}

/// The high digit times the two lowest bits of the low one, and times its other bits.
#[derive(LogicBlock, Default)]
pub(crate) struct DigitProducts<const R: usize, const LP: usize, const HP: usize> {
    pub magnitude: Signal<In, Bits<R>>,
    pub low_product: Signal<Out, Bits<LP>>,
    pub high_product: Signal<Out, Bits<HP>>,
}

impl<const R: usize, const LP: usize, const HP: usize> Logic for DigitProducts<R, LP, HP> {
    fn update(&mut self) {
        let (high, low) = digits(self.magnitude.val().to_u64(), R);
        self.low_product.next = (high * (low % (1 << FIRST))).to_bits();
        self.high_product.next = (high * (low >> FIRST)).to_bits();
    }

    fn connect(&mut self) {
        self.low_product.connect();
        self.high_product.connect();
    }

    fn hdl(&self) -> Verilog {
        let low = low_bits(R);
        let high_digit = format!("magnitude[{}:{low}]", R - 1);
        let product = |width: usize, bits: std::ops::Range<usize>| {
            let first = bits.start;
            let rows = bits.map(|bit| row(width, bit - first, bit));
            rows.collect::<Vec<_>>().join(" + ")
        };
        Verilog::Custom(format!(
            "wire [{}:0] high = {high_digit};\n\
             always @(*) low_product = {};\n\
             always @(*) high_product = {};\n",
            HIGH - 1,
            product(LP, 0..FIRST),
            product(HP, FIRST..low),
        ))
    }
}

/// A row of a product: the high digit shifted up by `places` where bit `bit` of the low digit is set, in a
/// word of `width` bits.
fn row(width: usize, places: usize, bit: usize) -> String {
    let gated = format!("high & {{{HIGH}{{magnitude[{bit}]}}}}");
    let above = width - HIGH - places;
    let zeros = |count: usize| match count {
        0 => None,
        _ => Some(format!("{count}'d0")),
    };
    let parts = [zeros(above), Some(gated), zeros(places)];
    format!(
        "{{{}}}",
        parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
    )
}

/// The product of the digits, as the sum of its two parts.
#[derive(LogicBlock, Default)]
pub(crate) struct CrossSum<const LP: usize, const HP: usize, const R: usize> {
    pub low_product: Signal<In, Bits<LP>>,
    pub high_product: Signal<In, Bits<HP>>,
    pub cross_product: Signal<Out, Bits<R>>,
}

impl<const LP: usize, const HP: usize, const R: usize> Logic for CrossSum<LP, HP, R> {
    fn update(&mut self) {
        let (low, high) = (self.low_product.val(), self.high_product.val());
        let cross = low.to_u64() + (high.to_u64() << FIRST);
        // At power-up the registers may hold values that are no products of digits.
        self.cross_product.next = (cross % (1 << R)).to_bits();
    }

    fn connect(&mut self) {
        self.cross_product.connect();
    }

    /// The Verilog. The lowest bits are those of the first product; only the upper bits are added.
    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!(
            "wire [{}:0] upper = low_product[{}:{FIRST}] + high_product;\n\
             always @(*) cross_product = {{upper, low_product[{}:0]}};\n",
            R - FIRST - 1,
            LP - 1,
            FIRST - 1,
        ))
    }
}

/// `square = high^2 4^l + low^2 + 2 cross 2^l`, modulo `2^Q`, with l bits in the low digit.
#[derive(LogicBlock, Default)]
pub(crate) struct SquareSum<const Q: usize, const R: usize> {
    pub magnitude: Signal<In, Bits<R>>,
    pub cross_product: Signal<In, Bits<R>>,
    pub square: Signal<Out, Bits<Q>>,
}

impl<const Q: usize, const R: usize> SquareSum<Q, R> {
    /// The place of the cross product's lowest bit.
    const PLACE: usize = low_bits(R) + 1;
}

impl<const Q: usize, const R: usize> Logic for SquareSum<Q, R> {
    fn update(&mut self) {
        let (high, low) = digits(self.magnitude.val().to_u64(), R);
        let squares = ((high * high) << (2 * low_bits(R))) | (low * low);
        let sum = squares + (self.cross_product.val().to_u64() << Self::PLACE);
        self.square.next = (sum % (1 << Q)).to_bits();
    }

    fn connect(&mut self) {
        self.square.connect();
    }

    /// The Verilog. The squares of the digits are concatenated; below the cross product nothing is added.
    fn hdl(&self) -> Verilog {
        let (place, low) = (Self::PLACE, low_bits(R));
        let tables = table("high_square", HIGH) + &table("low_square", low);
        Verilog::Custom(format!(
            "{tables}wire [{}:0] squares = {{high_square(magnitude[{}:{low}]), \
             low_square(magnitude[{}:0])}};\n\
             wire [{}:0] upper = squares[{}:{place}] + {{{}'d0, cross_product}};\n\
             always @(*) square = {{upper, squares[{}:0]}};\n",
            Q - 1,
            R - 1,
            low - 1,
            Q - place - 1,
            Q - 1,
            Q - place - R,
            place - 1,
        ))
    }
}

/// Bits of the low digit of a |d| of `radius_bits` bits.
const fn low_bits(radius_bits: usize) -> usize {
    radius_bits - HIGH
}

/// The high and the low digit of |d|, of which the low `radius_bits` bits count.
fn digits(magnitude: u64, radius_bits: usize) -> (u64, u64) {
    let low = low_bits(radius_bits);
    let counted = magnitude % (1 << radius_bits);
    (counted >> low, counted % (1 << low))
}

/// A Verilog function that squares a digit, as a table.
fn table(name: &str, digit: usize) -> String {
    let square = 2 * digit;
    let mut text = format!(
        "function [{}:0] {name};\n  input [{}:0] digit;\n  case (digit)\n",
        square - 1,
        digit - 1
    );
    let largest = (1_u64 << digit) - 1;
    for value in 0..=largest {
        let label = match value {
            _ if value == largest => "default".to_owned(),
            _ => format!("{digit}'d{value}"),
        };
        text += &format!("    {label}: {name} = {square}'d{};\n", value * value);
    }
    text + "  endcase\nendfunction\n"
}
