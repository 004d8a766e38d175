//! The squares of the differences of two photons from one query on one axis.

use photoncube_spec::{Cut, Cuts, Squarer};
use rust_hdl::prelude::*;

use super::arithmetic::{Subtract, SubtractLine};
use super::digits::{CrossSum, DigitProducts, Magnitude, SplitMagnitude, SquareSum};
use super::lookup::{DifferenceProduct, SplitLookup, SplitProduct, SquareTable};
use super::stage::Stage;
use super::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};
use crate::defaults::defaulted;

/// The squarer from digits, d to d^2. Widths: `C` coordinate, `D = C + 1` difference, `R` bits that are
/// squared, `Q = 2 R`; `LP` and `HP` bits of the two products.
#[derive(LogicBlock)]
pub(crate) struct DigitSquarer<
    const C: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const LP: usize,
    const HP: usize,
> {
    pub clock: Signal<In, Clock>,
    pub difference: Signal<In, Bits<D>>,
    pub square: Signal<Out, Bits<Q>>,
    pub far: Signal<Out, Bit>,
    magnitude_of: Magnitude<C, D>,
    pub magnitude: Stage<Bits<C>>,
    split_magnitude: SplitMagnitude<C, R>,
    digit_products: DigitProducts<R, LP, HP>,
    pub products_magnitude: Stage<Bits<R>>,
    pub low_product: Stage<Bits<LP>>,
    pub high_product: Stage<Bits<HP>>,
    pub products_far: Stage<Bit>,
    cross_sum: CrossSum<LP, HP, R>,
    pub cross_magnitude: Stage<Bits<R>>,
    pub cross_product: Stage<Bits<R>>,
    pub cross_far: Stage<Bit>,
    square_sum: SquareSum<Q, R>,
    _wires: Wires,
}

impl<
    const C: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const LP: usize,
    const HP: usize,
> DigitSquarer<C, D, R, Q, LP, HP>
{
    pub fn new(cuts: Cuts) -> Self {
        with_wires!(defaulted!(Self {
            magnitude: Stage::new(cuts.has(Cut::Magnitude)),
            products_magnitude: Stage::new(cuts.has(Cut::Products)),
            low_product: Stage::new(cuts.has(Cut::Products)),
            high_product: Stage::new(cuts.has(Cut::Products)),
            products_far: Stage::new(cuts.has(Cut::Products)),
            cross_magnitude: Stage::new(cuts.has(Cut::Cross)),
            cross_product: Stage::new(cuts.has(Cut::Cross)),
            cross_far: Stage::new(cuts.has(Cut::Cross)),
        };
            clock difference square far magnitude_of split_magnitude digit_products cross_sum square_sum _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (magnitude.clock) = (clock);
            (products_magnitude.clock) = (clock);
            (low_product.clock) = (clock);
            (high_product.clock) = (clock);
            (products_far.clock) = (clock);
            (cross_magnitude.clock) = (clock);
            (cross_product.clock) = (clock);
            (cross_far.clock) = (clock);
            (magnitude_of.difference) = (difference);
            (magnitude.d) = (magnitude_of.magnitude);
            (split_magnitude.magnitude) = (magnitude.q);
            (digit_products.magnitude) = (split_magnitude.counted);
            (products_magnitude.d) = (split_magnitude.counted);
            (low_product.d) = (digit_products.low_product);
            (high_product.d) = (digit_products.high_product);
            (products_far.d) = (split_magnitude.far);
            (cross_sum.low_product) = (low_product.q);
            (cross_sum.high_product) = (high_product.q);
            (cross_magnitude.d) = (products_magnitude.q);
            (cross_product.d) = (cross_sum.cross_product);
            (cross_far.d) = (products_far.q);
            (square_sum.magnitude) = (cross_magnitude.q);
            (square_sum.cross_product) = (cross_product.q);
            (square) = (square_sum.square);
            (far) = (cross_far.q);
        );
    }
}

logic_of_wires!(DigitSquarer<C, D, R, Q, LP, HP>);

/// The squarer from a table that two coordinates share, d to d^2; a word has `L = Q + 1` bits.
#[derive(LogicBlock)]
pub(crate) struct TableSquarer<const D: usize, const Q: usize, const L: usize> {
    pub clock: Signal<In, Clock>,
    pub difference_a: Signal<In, Bits<D>>,
    pub difference_b: Signal<In, Bits<D>>,
    pub square_a: Signal<Out, Bits<Q>>,
    pub square_b: Signal<Out, Bits<Q>>,
    pub far_a: Signal<Out, Bit>,
    pub far_b: Signal<Out, Bit>,
    pub magnitude_delay: Vec<Stage<Bits<D>>>,
    pub products_delay: Vec<Stage<Bits<D>>>,
    pub square_table: SquareTable<D, L>,
    split_0: SplitLookup<Q, L>,
    split_1: SplitLookup<Q, L>,
    pub square_stage: Vec<Stage<Bits<Q>>>,
    pub far_stage: Vec<Stage<Bit>>,
    _wires: Wires,
}

impl<const D: usize, const Q: usize, const L: usize> TableSquarer<D, Q, L> {
    pub fn new(cuts: Cuts) -> Self {
        with_wires!(defaulted!(Self {
            magnitude_delay: Stage::several(2, cuts.has(Cut::Magnitude)),
            products_delay: Stage::several(2, cuts.has(Cut::Products)),
            square_table: SquareTable::new(cuts.has(Cut::Cross)),
            square_stage: Stage::several(2, cuts.has(Cut::Square)),
            far_stage: Stage::several(2, cuts.has(Cut::Square)),
        };
            clock difference_a difference_b square_a square_b far_a far_b split_0 split_1 _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        for photon in 0..2 {
            wires!(self, wiring:
                (magnitude_delay[photon].clock) = (clock);
                (products_delay[photon].clock) = (clock);
                (products_delay[photon].d) = (magnitude_delay[photon].q);
                (square_stage[photon].clock) = (clock);
                (far_stage[photon].clock) = (clock);
            );
        }
        wires!(self, wiring:
            (square_table.clock) = (clock);
            (magnitude_delay[0].d) = (difference_a);
            (magnitude_delay[1].d) = (difference_b);
            (square_table.difference_a) = (products_delay[0].q);
            (square_table.difference_b) = (products_delay[1].q);
            (split_0.lookup) = (square_table.lookup_a);
            (split_1.lookup) = (square_table.lookup_b);
            (square_stage[0].d) = (split_0.square);
            (square_stage[1].d) = (split_1.square);
            (far_stage[0].d) = (split_0.far);
            (far_stage[1].d) = (split_1.far);
            (square_a) = (square_stage[0].q);
            (square_b) = (square_stage[1].q);
            (far_a) = (far_stage[0].q);
            (far_b) = (far_stage[1].q);
        );
    }
}

logic_of_wires!(TableSquarer<D, Q, L>);

/// The squarer that is one product, d to d^2 or on half steps to d (d + 1); `PR = 2 (D - 1)`.
#[derive(LogicBlock)]
pub(crate) struct ProductSquarer<const D: usize, const Q: usize, const PR: usize> {
    pub clock: Signal<In, Clock>,
    pub difference: Signal<In, Bits<D>>,
    pub square: Signal<Out, Bits<Q>>,
    pub far: Signal<Out, Bit>,
    pub magnitude_delay: Stage<Bits<D>>,
    pub products_delay: Stage<Bits<D>>,
    difference_product: DifferenceProduct<D, PR>,
    pub product: Stage<Bits<PR>>,
    split_product: SplitProduct<Q, PR>,
    _wires: Wires,
}

impl<const D: usize, const Q: usize, const PR: usize> ProductSquarer<D, Q, PR> {
    pub fn new(cuts: Cuts, half_steps: bool) -> Self {
        with_wires!(defaulted!(Self {
            difference_product: DifferenceProduct::new(half_steps),
            magnitude_delay: Stage::new(cuts.has(Cut::Magnitude)),
            products_delay: Stage::new(cuts.has(Cut::Products)),
            product: Stage::new(cuts.has(Cut::Cross)),
        };
            clock difference square far split_product _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        wires!(self, wiring:
            (magnitude_delay.clock) = (clock);
            (products_delay.clock) = (clock);
            (product.clock) = (clock);
            (magnitude_delay.d) = (difference);
            (products_delay.d) = (magnitude_delay.q);
            (difference_product.difference) = (products_delay.q);
            (product.d) = (difference_product.product);
            (split_product.product) = (product.q);
            (square) = (split_product.square);
            (far) = (split_product.far);
        );
    }
}

logic_of_wires!(ProductSquarer<D, Q, PR>);

/// The squares of the differences of two photons from one query on one axis. The block serves two photons,
/// because a table has two ports. `H` photon's coordinate, `L = Q + 1`; the other widths are those of the squarers. Where
/// `H < C`, the photons are on grid lines between two queries.
#[derive(LogicBlock)]
pub(crate) struct SquarePair<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
> {
    pub clock: Signal<In, Clock>,
    pub query: Signal<In, Bits<C>>,
    pub photon_a: Signal<In, Bits<H>>,
    pub photon_b: Signal<In, Bits<H>>,
    pub square_a: Signal<Out, Bits<Q>>,
    pub square_b: Signal<Out, Bits<Q>>,
    pub far_a: Signal<Out, Bit>,
    pub far_b: Signal<Out, Bit>,
    /// Two, or none where the photons are on grid lines.
    subtract: Vec<Subtract<C, H, D>>,
    /// Two, or none where the photons have the steps of the query.
    subtract_line: Vec<SubtractLine<C, H, D>>,
    pub difference: Vec<Stage<Bits<D>>>,
    /// Two squarers, or none where the squarer is of another kind.
    pub digits: Vec<DigitSquarer<C, D, R, Q, LP, HP>>,
    /// One squarer, or none.
    pub lookup: Vec<TableSquarer<D, Q, L>>,
    /// Two squarers, or none.
    pub product: Vec<ProductSquarer<D, Q, PR>>,
    /// The registers at `Cut::Square`; those of a table are in the block RAM.
    pub square_stage: Vec<Stage<Bits<Q>>>,
    pub far_stage: Vec<Stage<Bit>>,
    /// The registers at `Cut::SquareDelay`; empty where no register stands there.
    pub square_delay: Vec<Stage<Bits<Q>>>,
    pub far_delay: Vec<Stage<Bit>>,
    _wires: Wires,
}

impl<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
> SquarePair<C, H, D, R, Q, L, LP, HP, PR>
{
    pub fn new(cuts: Cuts, squarer: Squarer) -> Self {
        assert!(D == C + 1 && Q == 2 * R && L == Q + 1 && PR == 2 * C);
        let half_steps = H < C;
        let lines = if half_steps { 2 } else { 0 };
        let count = |kind, count| if squarer == kind { count } else { 0 };
        let digits = 0..count(Squarer::Digits, 2);
        let lookup = 0..count(Squarer::Table, 1);
        let product = 0..count(Squarer::Product, 2);
        let behind = cuts.has(Cut::Square) && squarer != Squarer::Table;
        let delays = if cuts.has(Cut::SquareDelay) { 2 } else { 0 };
        with_wires!(defaulted!(Self {
            subtract: (lines..2).map(|_| Default::default()).collect(),
            subtract_line: (0..lines).map(|_| Default::default()).collect(),
            difference: Stage::several(2, cuts.has(Cut::Difference)),
            digits: digits.map(|_| DigitSquarer::new(cuts)).collect(),
            lookup: lookup.map(|_| TableSquarer::new(cuts)).collect(),
            product: product.map(|_| ProductSquarer::new(cuts, half_steps)).collect(),
            square_stage: Stage::several(2, behind),
            far_stage: Stage::several(2, behind),
            square_delay: Stage::several(delays, true),
            far_delay: Stage::several(delays, true),
        };
            clock query photon_a photon_b square_a square_b far_a far_b _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        if self.subtract.is_empty() {
            wires!(self, wiring:
                (subtract_line[0].b) = (photon_a);
                (subtract_line[1].b) = (photon_b);
            );
        } else {
            wires!(self, wiring:
                (subtract[0].b) = (photon_a);
                (subtract[1].b) = (photon_b);
            );
        }
        for photon in 0..2 {
            if self.subtract.is_empty() {
                wires!(self, wiring:
                    (subtract_line[photon].a) = (query);
                    (difference[photon].clock) = (clock);
                    (difference[photon].d) = (subtract_line[photon].difference);
                );
            } else {
                wires!(self, wiring:
                    (subtract[photon].a) = (query);
                    (difference[photon].clock) = (clock);
                    (difference[photon].d) = (subtract[photon].difference);
                );
            }
            wires!(self, wiring:
                (square_stage[photon].clock) = (clock);
                (far_stage[photon].clock) = (clock);
            );
        }
        for photon in 0..self.digits.len() {
            wires!(self, wiring:
                (digits[photon].clock) = (clock);
                (digits[photon].difference) = (difference[photon].q);
                (square_stage[photon].d) = (digits[photon].square);
                (far_stage[photon].d) = (digits[photon].far);
            );
        }
        for table in 0..self.lookup.len() {
            wires!(self, wiring:
                (lookup[table].clock) = (clock);
                (lookup[table].difference_a) = (difference[0].q);
                (lookup[table].difference_b) = (difference[1].q);
                (square_stage[0].d) = (lookup[table].square_a);
                (square_stage[1].d) = (lookup[table].square_b);
                (far_stage[0].d) = (lookup[table].far_a);
                (far_stage[1].d) = (lookup[table].far_b);
            );
        }
        for photon in 0..self.product.len() {
            wires!(self, wiring:
                (product[photon].clock) = (clock);
                (product[photon].difference) = (difference[photon].q);
                (square_stage[photon].d) = (product[photon].square);
                (far_stage[photon].d) = (product[photon].far);
            );
        }
        if self.square_delay.is_empty() {
            wires!(self, wiring:
                (square_a) = (square_stage[0].q);
                (square_b) = (square_stage[1].q);
                (far_a) = (far_stage[0].q);
                (far_b) = (far_stage[1].q);
            );
            return;
        }
        for photon in 0..2 {
            wires!(self, wiring:
                (square_delay[photon].clock) = (clock);
                (far_delay[photon].clock) = (clock);
                (square_delay[photon].d) = (square_stage[photon].q);
                (far_delay[photon].d) = (far_stage[photon].q);
            );
        }
        wires!(self, wiring:
            (square_a) = (square_delay[0].q);
            (square_b) = (square_delay[1].q);
            (far_a) = (far_delay[0].q);
            (far_b) = (far_delay[1].q);
        );
    }
}

logic_of_wires!(SquarePair<C, H, D, R, Q, L, LP, HP, PR>);
