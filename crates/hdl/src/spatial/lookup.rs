//! The parts of a square that a block RAM or a DSP block computes.

use rust_hdl::prelude::*;

use crate::defaults::defaulted;

/// A table of squares with two read ports: `{far, |d|^2}` of a difference of `D` bits, with the square in
/// `L - 1 = 2 r` bits. Two coordinates share the table, because a block RAM has two ports.
#[derive(LogicBlock)]
pub(crate) struct SquareTable<const D: usize, const L: usize> {
    pub clock: Signal<In, Clock>,
    pub difference_a: Signal<In, Bits<D>>,
    pub difference_b: Signal<In, Bits<D>>,
    pub lookup_a: Signal<Out, Bits<L>>,
    pub lookup_b: Signal<Out, Bits<L>>,
    /// Whether the words read are stored in registers, which are then those of the block RAM.
    _register: bool,
}

/// A word of the table, `{far, |d|^2}`, for a difference of `difference_bits` bits: the square modulo
/// `2^square_bits`, and whether |d| exceeds half of these bits.
pub(crate) fn square_word(difference: u64, difference_bits: usize, square_bits: usize) -> u64 {
    let magnitude = difference.min((1 << difference_bits) - difference);
    let far = u64::from(magnitude >> (square_bits / 2) != 0);
    (far << square_bits) | (magnitude * magnitude % (1 << square_bits))
}

impl<const D: usize, const L: usize> SquareTable<D, L> {
    pub fn new(register: bool) -> Self {
        defaulted!(Self {
            _register: register,
        };
            clock difference_a difference_b lookup_a lookup_b
        )
    }

    fn word(difference: u64) -> u64 {
        square_word(difference, D, L - 1)
    }
}

impl<const D: usize, const L: usize> Logic for SquareTable<D, L> {
    fn update(&mut self) {
        if !self._register || self.clock.pos_edge() {
            self.lookup_a.next = Self::word(self.difference_a.val().to_u64()).to_bits();
            self.lookup_b.next = Self::word(self.difference_b.val().to_u64()).to_bits();
        }
    }

    fn connect(&mut self) {
        self.lookup_a.connect();
        self.lookup_b.connect();
    }

    fn hdl(&self) -> Verilog {
        let (last, high) = ((1_u64 << D) - 1, L - 1);
        let words: String = (0..=last)
            .map(|d| format!("  squares[{d}] = {L}'d{};\n", Self::word(d)))
            .collect();
        let start = if self._register {
            format!("  lookup_a = {L}'d0;\n  lookup_b = {L}'d0;\n")
        } else {
            String::new()
        };
        let read = |port: char| match self._register {
            true => {
                format!("always @(posedge clock) lookup_{port} <= squares[difference_{port}];\n")
            }
            false => format!(
                "wire [{high}:0] word_{port} = squares[difference_{port}];\n\
                 always @(*) lookup_{port} = word_{port};\n"
            ),
        };
        Verilog::Custom(format!(
            "reg [{high}:0] squares [0:{last}];\ninitial begin\n{words}{start}end\n{}{}",
            read('a'),
            read('b'),
        ))
    }
}

/// Splits a word of the table, or of the register behind it, `{far, square}`.
#[derive(LogicBlock, Default)]
pub(crate) struct SplitLookup<const Q: usize, const L: usize> {
    pub lookup: Signal<In, Bits<L>>,
    pub square: Signal<Out, Bits<Q>>,
    pub far: Signal<Out, Bit>,
}

impl<const Q: usize, const L: usize> Logic for SplitLookup<Q, L> {
    fn update(&mut self) {
        let lookup = self.lookup.val().to_u64();
        self.square.next = (lookup % (1 << Q)).to_bits();
        self.far.next = lookup >> Q != 0;
    }

    fn connect(&mut self) {
        self.square.connect();
        self.far.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!(
            "always @(*) square = lookup[{}:0];\nalways @(*) far = lookup[{Q}];\n",
            Q - 1
        ))
    }
}

/// `product = difference^2` in `PR = 2 (D - 1)` bits, for a DSP block. On half steps it is `d (d + 1)`, the half square
/// of the distance `|d + 1/2|`.
#[derive(LogicBlock)]
pub(crate) struct DifferenceProduct<const D: usize, const PR: usize> {
    pub difference: Signal<In, Bits<D>>,
    pub product: Signal<Out, Bits<PR>>,
    _half_steps: bool,
}

impl<const D: usize, const PR: usize> DifferenceProduct<D, PR> {
    pub fn new(half_steps: bool) -> Self {
        defaulted!(Self { _half_steps: half_steps }; difference product)
    }
}

impl<const D: usize, const PR: usize> Logic for DifferenceProduct<D, PR> {
    fn update(&mut self) {
        let difference = self.difference.val().to_u64();
        let negative = difference >> (D - 1) == 1;
        let product = match (self._half_steps, negative) {
            (false, false) => difference * difference,
            (false, true) => ((1 << D) - difference).pow(2),
            (true, false) => difference * (difference + 1),
            (true, true) => ((1 << D) - difference) * ((1 << D) - difference - 1),
        };
        self.product.next = (product % (1 << PR)).to_bits();
    }

    fn connect(&mut self) {
        self.product.connect();
    }

    fn hdl(&self) -> Verilog {
        let high = D - 1;
        let half_step = if self._half_steps { " + d" } else { "" };
        Verilog::Custom(format!(
            "wire signed [{high}:0] d = difference;\n\
             wire signed [{}:0] squared = d * d{half_step};\n\
             always @(*) product = squared[{}:0];\n",
            2 * D - 1,
            PR - 1,
        ))
    }
}

/// Splits the product: the square in `Q = 2 r` bits, and whether |d| has more than r bits, in which case the
/// product has more than 2 r.
#[derive(LogicBlock, Default)]
pub(crate) struct SplitProduct<const Q: usize, const PR: usize> {
    pub product: Signal<In, Bits<PR>>,
    pub square: Signal<Out, Bits<Q>>,
    pub far: Signal<Out, Bit>,
}

impl<const Q: usize, const PR: usize> Logic for SplitProduct<Q, PR> {
    fn update(&mut self) {
        let product = self.product.val().to_u64();
        self.square.next = (product % (1 << Q)).to_bits();
        self.far.next = product >> Q != 0;
    }

    fn connect(&mut self) {
        self.square.connect();
        self.far.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(format!(
            "always @(*) square = product[{}:0];\nalways @(*) far = |product[{}:{Q}];\n",
            Q - 1,
            PR - 1,
        ))
    }
}
