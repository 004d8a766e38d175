//! Planted mistakes in expressions without comparisons: the rows of the table of operators.

use crate::blocks::*;
use rust_hdl::prelude::*;

planted! {
    cast_of_sum: CastOfExpression
    bad { y: O<13> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<13, 12>(self.a.val() + self.b.val());
        }
    }
    good { y: O<13>, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.a.val() + self.b.val();
            self.y.next = bit_cast::<13, 12>(self.sum.val());
        }
    }

    cast_of_difference: CastOfExpression
    bad { y: O<13> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<13, 12>(self.a.val() - self.b.val());
        }
    }
    good { y: O<13>, difference: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.difference.next = self.a.val() - self.b.val();
            self.y.next = bit_cast::<13, 12>(self.difference.val());
        }
    }

    cast_of_not: CastOfExpression
    bad { y: O<13> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<13, 12>(!self.a.val());
        }
    }
    good { y: O<13>, inverse: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.inverse.next = !self.a.val();
            self.y.next = bit_cast::<13, 12>(self.inverse.val());
        }
    }

    cast_of_shift: CastOfExpression
    bad { y: O<13> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<13, 12>(self.a.val() << 3);
        }
    }
    good { y: O<13>, shifted: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.shifted.next = self.a.val() << 3;
            self.y.next = bit_cast::<13, 12>(self.shifted.val());
        }
    }

    cast_of_not_compare: CastOfExpression
    bad { y: O<13> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<13, 1>((!(self.a.val() > self.b.val())).into());
        }
    }
    good { y: O<13>, flag: BitL } {
        #[hdl_gen]
        fn update(&mut self) {
            self.flag.next = !(self.a.val() > self.b.val());
            self.y.next = bit_cast::<13, 1>(self.flag.val().into());
        }
    }

    replaced_by_not: CastOfExpression
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().replace_bit(3, !self.x.val());
        }
    }
    good { y: O<12>, flag: BitL } {
        #[hdl_gen]
        fn update(&mut self) {
            self.flag.next = !self.x.val();
            self.y.next = self.a.val().replace_bit(3, self.flag.val());
        }
    }

    factor_sum: FactorExpression
    bad { y: O<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.m.val() + self.n.val()) * self.o.val();
        }
    }
    good { y: O<32>, sum: L<16> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.m.val() + self.n.val();
            self.y.next = self.sum.val() * self.o.val();
        }
    }

    squared_difference: FactorExpression
    bad { y: O<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.m.val() - self.n.val()) * (self.m.val() - self.n.val());
        }
    }
    good { y: O<32>, difference: L<16> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.difference.next = self.m.val() - self.n.val();
            self.y.next = self.difference.val() * self.difference.val();
        }
    }

    signed_factor_sum: FactorExpression
    bad { y: SignedO<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.s.val() + self.t.val()) * self.s.val();
        }
    }
    good { y: SignedO<32>, sum: SignedL<16> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.s.val() + self.t.val();
            self.y.next = self.sum.val() * self.s.val();
        }
    }

    cast_product_in_sum: CastOfProduct
    bad { y: SignedO<34> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = signed_bit_cast::<34, 32>(self.s.val() * self.t.val()) + self.u.val();
        }
    }
    good { y: SignedO<34>, product: SignedL<32>, wide: SignedL<34> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.product.next = self.s.val() * self.t.val();
            self.wide.next = signed_bit_cast::<34, 32>(self.product.val());
            self.y.next = self.wide.val() + self.u.val();
        }
    }

    cast_product_alone: CastOfProduct
    bad { y: SignedO<34> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = signed_bit_cast::<34, 32>(self.s.val() * self.t.val());
        }
    }
    good { y: SignedO<34>, product: SignedL<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.product.next = self.s.val() * self.t.val();
            self.y.next = signed_bit_cast::<34, 32>(self.product.val());
        }
    }

    compared_products: ProductInContext
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.m.val() * self.n.val() == self.o.val() * self.p.val();
        }
    }
    good { y: BitO, left: L<32>, right: L<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.left.next = self.m.val() * self.n.val();
            self.right.next = self.o.val() * self.p.val();
            self.y.next = self.left.val() == self.right.val();
        }
    }

    shifted_product: ProductInContext
    bad { y: O<16> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<16, 32>((self.m.val() * self.n.val()) >> 16);
        }
    }
    good { y: O<16>, product: L<32>, high: L<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.product.next = self.m.val() * self.n.val();
            self.high.next = self.product.val() >> 16;
            self.y.next = bit_cast::<16, 32>(self.high.val());
        }
    }

    narrowed_below: NarrowingSignedCast
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = signed_bit_cast::<8, 16>(self.s.val()) < self.v.val();
        }
    }
    good { y: BitO, narrow: SignedL<8> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.narrow.next = signed_bit_cast::<8, 16>(self.s.val());
            self.y.next = self.narrow.val() < self.v.val();
        }
    }

    narrowed_factor: NarrowingSignedCast
    bad { y: SignedO<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = signed_bit_cast::<16, 34>(self.u.val()) * self.s.val();
        }
    }
    good { y: SignedO<32>, narrow: SignedL<16> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.narrow.next = signed_bit_cast::<16, 34>(self.u.val());
            self.y.next = self.narrow.val() * self.s.val();
        }
    }

    shifted_sum: ShiftOfExpression
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.a.val() + 1) >> 1;
        }
    }
    good { y: O<12>, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.a.val() + 1;
            self.y.next = self.sum.val() >> 1;
        }
    }

    shifted_by_sum: ShiftOfExpression
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() << (self.three.val() + 1);
        }
    }
    good { y: O<12>, count: L<3> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.count.next = self.three.val() + 1;
            self.y.next = self.a.val() << self.count.val();
        }
    }

    all_of_cast: ReductionOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<8, 12>(self.a.val()).all();
        }
    }
    good { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bits::<8>(0).all();
        }
    }

    any_of_sum: ReductionOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.a.val() + 1).any();
        }
    }
    good { y: BitO, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.a.val() + 1;
            self.y.next = self.sum.val().any();
        }
    }

    literal_too_wide_to_compare: LiteralTooWide
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() == 0x1000;
        }
    }
    good { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() == 0xFFF;
        }
    }

    literal_too_wide_to_assign: LiteralTooWide
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            if self.x.val() {
                self.y.next = 0x1000.into();
            }
        }
    }
    good { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            if self.x.val() {
                self.y.next = 0xFFF.into();
            }
        }
    }

    chained_sum: SeveralOperators
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() + self.b.val() + self.c.val();
        }
    }
    good { y: O<12>, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.a.val() + self.b.val();
            self.y.next = self.sum.val() + self.c.val();
        }
    }

    compared_sum_of_equal_widths: SeveralOperators
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            if (self.a.val() + self.b.val()) == self.c.val() {
                self.y.next = self.b.val();
            }
        }
    }
    good { y: O<12>, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            self.sum.next = self.a.val() + self.b.val();
            if self.sum.val() == self.c.val() {
                self.y.next = self.b.val();
            }
        }
    }
}
