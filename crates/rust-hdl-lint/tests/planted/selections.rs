//! Planted mistakes in selections: slices, indices, array paths, patterns.

use crate::blocks::*;
use rust_hdl::prelude::*;

/// A child block with an array of its own.
#[derive(LogicBlock, Default)]
pub struct Links {
    pub n: [Signal<Out, Bits<12>>; 2],
    pub sum: Signal<Out, Bits<12>>,
    pub y: Signal<In, Bits<12>>,
}

impl Logic for Links {
    #[hdl_gen]
    fn update(&mut self) {
        self.sum.next = self.y.val() + 1;
        for i in 0..2 {
            self.n[i].next = self.y.val();
        }
    }
}

planted! {
    slice_past_end: SliceOutOfRange
    bad { y: O<5> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bits::<5>(9);
        }
    }
    good { y: O<5> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bits::<5>(7);
        }
    }

    bit_past_end: SliceOutOfRange
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bit(12);
        }
    }
    good { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bit(11);
        }
    }

    variable_slice_past_end: SliceOutOfRange
    bad { y: O<4> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bits::<4>(self.four.val().index());
        }
    }
    good { y: O<4> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bits::<4>(self.three.val().index());
        }
    }

    replaced_past_end: SliceOutOfRange
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().replace_bit(12, self.x.val());
        }
    }
    good { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().replace_bit(11, self.x.val());
        }
    }

    bit_of_scalar: SliceOutOfRange
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.one.val().get_bit(0);
        }
    }
    good { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.one.val().into();
        }
    }

    slice_of_sum: SliceOfExpression
    bad { y: O<4> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = (self.a.val() + self.b.val()).get_bits::<4>(2);
        }
    }
    good { y: O<4>, sum: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.sum.next = self.a.val() + self.b.val();
            self.y.next = self.sum.val().get_bits::<4>(2);
        }
    }

    bit_of_cast: SliceOfExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = bit_cast::<24, 12>(self.a.val()).get_bit(3);
        }
    }
    good { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bit(3);
        }
    }

    slice_of_slice: SliceOfSlice
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bits::<6>(3).get_bit(2);
        }
    }
    good { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bit(5);
        }
    }

    index_of_sum: IndexExpression
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val().get_bit((self.three.val() + 1).index());
        }
    }
    good { y: BitO, place: L<3> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.place.next = self.three.val() + 1;
            self.y.next = self.a.val().get_bit(self.place.val().index());
        }
    }

    xor_in_index: IndexOperator
    bad { y: [O<12>; 4], d: [L<12>; 4] } {
        #[hdl_gen]
        fn update(&mut self) {
            self.d[0].next = self.a.val();
            self.d[1].next = self.b.val();
            self.d[2].next = self.c.val();
            self.d[3].next = self.a.val();
            for i in 0..4 {
                self.y[i].next = self.d[i ^ 1].val();
            }
        }
    }
    good { y: [O<12>; 4], d: [L<12>; 4] } {
        #[hdl_gen]
        fn update(&mut self) {
            self.d[0].next = self.a.val();
            self.d[1].next = self.b.val();
            self.d[2].next = self.c.val();
            self.d[3].next = self.a.val();
            for i in 0..4 {
                self.y[i].next = self.d[i + 1 - 2 * (i % 2)].val();
            }
        }
    }

    shift_in_index: IndexOperator
    bad { y: [O<12>; 2], d: [L<12>; 4] } {
        #[hdl_gen]
        fn update(&mut self) {
            for i in 0..4 {
                self.d[i].next = self.a.val();
            }
            for i in 0..2 {
                self.y[i].next = self.d[i << 1].val();
            }
        }
    }
    good { y: [O<12>; 2], d: [L<12>; 4] } {
        #[hdl_gen]
        fn update(&mut self) {
            for i in 0..4 {
                self.d[i].next = self.a.val();
            }
            for i in 0..2 {
                self.y[i].next = self.d[2 * i].val();
            }
        }
    }

    two_dimensions: NestedArrayPath
    bad { y: O<12>, d: [[L<12>; 2]; 2] } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            for i in 0..2 {
                for j in 0..2 {
                    self.d[i][j].next = self.a.val();
                }
            }
        }
    }
    good { y: O<12>, d: [L<12>; 4] } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = self.a.val();
            for i in 0..2 {
                for j in 0..2 {
                    self.d[2 * i + j].next = self.a.val();
                }
            }
        }
    }

    array_of_an_array_of_blocks: NestedArrayPath
    bad { y: O<12>, d: [Links; 2] } {
        #[hdl_gen]
        fn update(&mut self) {
            for i in 0..2 {
                self.d[i].y.next = self.a.val();
            }
            self.y.next = self.d[0].n[1].val();
        }
    }
    good { y: O<12>, d: [Links; 2] } {
        #[hdl_gen]
        fn update(&mut self) {
            for i in 0..2 {
                self.d[i].y.next = self.a.val();
            }
            self.y.next = self.d[0].sum.val();
        }
    }

    hexadecimal_pattern: CasePattern
    bad { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = false;
            match self.a.val().index() {
                0x1F => self.y.next = true,
                _ => {}
            }
        }
    }
    good { y: BitO } {
        #[hdl_gen]
        fn update(&mut self) {
            self.y.next = false;
            match self.a.val().index() {
                31 => self.y.next = true,
                _ => {}
            }
        }
    }

    bool_pattern: CasePattern
    bad { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            match self.x.val() {
                true => self.y.next = self.a.val(),
                _ => self.y.next = self.b.val(),
            }
        }
    }
    good { y: O<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            if self.x.val() {
                self.y.next = self.a.val();
            } else {
                self.y.next = self.b.val();
            }
        }
    }

    shadowed_field: ShadowedName
    bad { y: [O<12>; 2], i: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.i.next = self.a.val();
            for i in 0..2 {
                self.y[i].next = self.i.val();
            }
        }
    }
    good { y: [O<12>; 2], i: L<12> } {
        #[hdl_gen]
        fn update(&mut self) {
            self.i.next = self.a.val();
            for index in 0..2 {
                self.y[index].next = self.i.val();
            }
        }
    }
}
