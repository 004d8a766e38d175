//! The difference of a photon and the query on one axis.
//!
//! The rules are those of `photoncube_spec::PhotonFormat`, "Distance"; plain numbers are the case without
//! extra bits and clamp. A machine's widths select the rules that it needs. A kernel would print all of them,
//! so this block writes its Verilog by hand. It is simulated from the emitted text.

use rust_hdl::prelude::*;

/// `magnitude = |a - b|` of a query `a` (`C` bits) and a photon `b` (`H` bits), clamped to all ones where
/// `M < C`. Where `H < C` the photon is on a grid line between two queries, and the magnitude is the whole
/// steps of the distance.
#[derive(LogicBlock, Default)]
pub(crate) struct Difference<const C: usize, const H: usize, const M: usize> {
    pub a: Signal<In, Bits<C>>,
    pub b: Signal<In, Bits<H>>,
    pub magnitude: Signal<Out, Bits<M>>,
}

impl<const C: usize, const H: usize, const M: usize> Difference<C, H, M> {
    /// Fraction bits that only a query has.
    const EXTRA_BITS: usize = C - H;
}

impl<const C: usize, const H: usize, const M: usize> Logic for Difference<C, H, M> {
    fn update(&mut self) {
        // In half steps of the query's grid, both middles are whole numbers.
        let query = 2 * self.a.val().to_u64() + 1;
        let photon = (2 * self.b.val().to_u64() + 1) << Self::EXTRA_BITS;
        let steps = query.abs_diff(photon) / 2;
        self.magnitude.next = steps.min((1 << M) - 1).to_bits();
    }

    fn connect(&mut self) {
        self.magnitude.connect();
    }

    fn hdl(&self) -> Verilog {
        let distance = match Self::EXTRA_BITS {
            0 => between_middles(C),
            extra_bits => from_grid_line(C, extra_bits),
        };
        Verilog::Custom(distance + &clamped(C, M))
    }
}

/// The text for equal grids. |A-B| is selected from the two differences; synthesis shares the comparison with
/// a subtraction.
fn between_middles(width: usize) -> String {
    let high = width - 1;
    format!(
        "wire [{high}:0] a_minus_b = a - b;\n\
         wire [{high}:0] b_minus_a = b - a;\n\
         wire below = a < b;\n\
         wire [{high}:0] distance = below ? b_minus_a : a_minus_b;\n"
    )
}

/// The text for a photon on a grid line. A query is half a step above its index. Below the line this half
/// step is subtracted, so the whole steps are the inverse of the difference, without an increment.
fn from_grid_line(width: usize, extra_bits: usize) -> String {
    let high = width - 1;
    let half_cell = 1 << (extra_bits - 1);
    format!(
        "wire [{high}:0] line = {{b, {extra_bits}'d{half_cell}}};\n\
         wire [{high}:0] a_minus_line = a - line;\n\
         wire below = a < line;\n\
         wire [{high}:0] distance = below ? ~a_minus_line : a_minus_line;\n"
    )
}

/// The text of the clamp. All ones is out of range, as is every distance with a bit above these.
fn clamped(width: usize, clamp: usize) -> String {
    if clamp == width {
        return "always @(*) magnitude = distance;\n".to_owned();
    }
    let (high, top) = (width - 1, clamp - 1);
    format!(
        "wire far = |distance[{high}:{clamp}];\n\
         always @(*) magnitude = distance[{top}:0] | {{{clamp}{{far}}}};\n"
    )
}
