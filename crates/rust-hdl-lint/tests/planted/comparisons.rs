//! Planted mistakes in comparisons: the rows of the table of operators.

use crate::blocks::*;
use rust_hdl::prelude::*;

planted! {
    compare_of_sum: CompareOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() + 1 == self.b.val();
        }
    }
    good { y: BitO, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.a.val() + 1;
            self.y.next = self.sum.val() == self.b.val();
        }
    }

    compare_of_difference: CompareOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.a.val() - self.b.val()) > 5;
        }
    }
    good { y: BitO, difference: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.difference.next = self.a.val() - self.b.val();
            self.y.next = self.difference.val() > 5;
        }
    }

    compare_of_not: CompareOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = !self.a.val() == 0xFFE;
        }
    }
    good { y: BitO, inverse: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.inverse.next = !self.a.val();
            self.y.next = self.inverse.val() == 0xFFE;
        }
    }

    compare_with_bits: CompareOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.a.val() - self.b.val()) > bits::<12>(5);
        }
    }
    good { y: BitO, difference: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.difference.next = self.a.val() - self.b.val();
            self.y.next = self.difference.val() > bits::<12>(5);
        }
    }

    condition_of_sum: CompareOfExpression
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            if self.x.val() {
                self.y.next = self.c.val();
            } else if self.a.val() + 1 == self.b.val() {
                self.y.next = self.b.val();
            }
        }
    }
    good { y: O<12>, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            self.sum.next = self.a.val() + 1;
            if self.x.val() {
                self.y.next = self.c.val();
            } else if self.sum.val() == self.b.val() {
                self.y.next = self.b.val();
            }
        }
    }

    match_of_sum: CompareOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = false;
            match (self.three.val() + 1).index() {
                0 => self.y.next = true,
                _ => {}
            }
        }
    }
    good { y: BitO, sum: L<3> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = false;
            self.sum.next = self.three.val() + 1;
            match self.sum.val().index() {
                0 => self.y.next = true,
                _ => {}
            }
        }
    }

    and_beside_equal: BitwiseBesideCompare
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() & self.b.val() == self.c.val();
        }
    }
    good { y: BitO, both: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.both.next = self.a.val() & self.b.val();
            self.y.next = self.x.val() & (self.both.val() == self.c.val());
        }
    }

    or_beside_equal: BitwiseBesideCompare
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() | self.b.val() == self.c.val();
        }
    }
    good { y: BitO, either: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.either.next = self.a.val() | self.b.val();
            self.y.next = (self.either.val() == self.c.val()) | self.x.val();
        }
    }

    xor_beside_greater: BitwiseBesideCompare
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() ^ self.b.val() > self.c.val();
        }
    }
    good { y: BitO, differing: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.differing.next = self.a.val() ^ self.b.val();
            self.y.next = self.x.val() ^ (self.differing.val() > self.c.val());
        }
    }

    bitwise_on_the_right: BitwiseBesideCompare
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val() > self.b.val() & self.c.val();
        }
    }
    good { y: BitO, both: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.both.next = self.b.val() & self.c.val();
            self.y.next = self.a.val() > self.both.val();
        }
    }

    signed_below_literal: SignedAgainstUnsigned
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.s.val() < 5.into();
        }
    }
    good { y: BitO, five: Constant<Signed<16>> = Constant::new(signed::<16>(5)) } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.s.val() < self.five.val();
        }
    }

    signed_below_part: SignedAgainstUnsigned
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.v.val() < self.s.val().get_bits::<8>(0);
        }
    }
    good { y: BitO, part: SignedL<8> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.part.next = self.s.val().get_bits::<8>(0);
            self.y.next = self.v.val() < self.part.val();
        }
    }

    signed_times_part: SignedAgainstUnsigned
    bad { y: SignedO<32> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.s.val() * self.u.val().get_bits::<16>(0);
        }
    }
    good { y: SignedO<32>, part: SignedL<16> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.part.next = self.u.val().get_bits::<16>(0);
            self.y.next = self.s.val() * self.part.val();
        }
    }

    extended_beside_literal: SignedAgainstUnsigned
    bad { y: SignedO<34> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = signed_bit_cast::<34, 16>(self.s.val()) + 5.into();
        }
    }
    good { y: SignedO<34>, wide: SignedL<34> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.wide.next = signed_bit_cast::<34, 16>(self.s.val());
            self.y.next = self.wide.val() + 5.into();
        }
    }

    extended_as_unsigned: SignedAgainstUnsigned
    bad { y: O<34> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = unsigned_cast(signed_bit_cast::<34, 16>(self.s.val()));
        }
    }
    good { y: O<34>, wide: SignedL<34> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.wide.next = signed_bit_cast::<34, 16>(self.s.val());
            self.y.next = unsigned_cast(self.wide.val());
        }
    }
}
