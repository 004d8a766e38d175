//! The square unit's second stage: squares and products of the two base-16 digits of a root.
//!
//! With `root = 16 high + low`, `root^2 = 256 high^2 + low^2 + 32 high low`. The two squares do not overlap,
//! so they are concatenated. The product has two halves, of two bits of the high digit each. All three are
//! added one clock later.

use rust_hdl::prelude::*;

/// `squares = 256 high^2 + low^2`, `low_product = low (high mod 4)` and
/// `high_product = low (high / 4)`, of an 8-bit root.
#[derive(LogicBlock, Default)]
pub(crate) struct Digits {
    pub root: Signal<In, Bits<8>>,
    pub squares: Signal<Out, Bits<16>>,
    pub low_product: Signal<Out, Bits<6>>,
    pub high_product: Signal<Out, Bits<6>>,
    high: Signal<Local, Bits<4>>,
    low: Signal<Local, Bits<4>>,
    high_square: DigitSquare,
    low_square: DigitSquare,
    wide_high: Signal<Local, Bits<16>>,
    shifted_high: Signal<Local, Bits<16>>,
    wide_low: Signal<Local, Bits<16>>,
    /// The low digit times 1 and times 2.
    once: Signal<Local, Bits<6>>,
    twice: Signal<Local, Bits<6>>,
    /// For each bit of the high digit: `once` or `twice`, or 0.
    rows: [Signal<Local, Bits<6>>; 4],
}

impl Logic for Digits {
    #[hdl_gen]
    fn update(&mut self) {
        self.high.next = self.root.val().get_bits::<4>(4);
        self.low.next = self.root.val().get_bits::<4>(0);
        self.high_square.digit.next = self.high.val();
        self.low_square.digit.next = self.low.val();
        self.wide_high.next = bit_cast::<16, 8>(self.high_square.square.val());
        self.shifted_high.next = self.wide_high.val() << 8;
        self.wide_low.next = bit_cast::<16, 8>(self.low_square.square.val());
        self.squares.next = self.shifted_high.val() | self.wide_low.val();

        self.once.next = bit_cast::<6, 4>(self.low.val());
        self.twice.next = self.once.val() << 1;
        for i in 0..4 {
            self.rows[i].next = 0.into();
        }
        if self.high.val().get_bit(0) {
            self.rows[0].next = self.once.val();
        }
        if self.high.val().get_bit(1) {
            self.rows[1].next = self.twice.val();
        }
        if self.high.val().get_bit(2) {
            self.rows[2].next = self.once.val();
        }
        if self.high.val().get_bit(3) {
            self.rows[3].next = self.twice.val();
        }
        self.low_product.next = self.rows[0].val() + self.rows[1].val();
        self.high_product.next = self.rows[2].val() + self.rows[3].val();
    }
}

/// The square of a base-16 digit: a LUT4 holds one bit of it.
#[derive(LogicBlock, Default)]
pub(crate) struct DigitSquare {
    pub digit: Signal<In, Bits<4>>,
    pub square: Signal<Out, Bits<8>>,
}

impl Logic for DigitSquare {
    #[hdl_gen]
    fn update(&mut self) {
        match self.digit.val().index() {
            0 => self.square.next = 0.into(),
            1 => self.square.next = 1.into(),
            2 => self.square.next = 4.into(),
            3 => self.square.next = 9.into(),
            4 => self.square.next = 16.into(),
            5 => self.square.next = 25.into(),
            6 => self.square.next = 36.into(),
            7 => self.square.next = 49.into(),
            8 => self.square.next = 64.into(),
            9 => self.square.next = 81.into(),
            10 => self.square.next = 100.into(),
            11 => self.square.next = 121.into(),
            12 => self.square.next = 144.into(),
            13 => self.square.next = 169.into(),
            14 => self.square.next = 196.into(),
            _ => self.square.next = 225.into(),
        }
    }
}
