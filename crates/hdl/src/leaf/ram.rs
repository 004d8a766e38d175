//! A small memory that is read in the clock in which it is addressed.

use rust_hdl::prelude::*;

use crate::defaults::defaulted;

/// A memory of `2^A` words of `W` bits, of at most 64 bits each. A word that is written is there from the next clock on. It
/// starts as zeros.
#[derive(LogicBlock)]
pub(crate) struct AsyncRam<const A: usize, const W: usize> {
    pub clock: Signal<In, Clock>,
    pub write: Signal<In, Bit>,
    pub write_place: Signal<In, Bits<A>>,
    pub write_word: Signal<In, Bits<W>>,
    pub read_place: Signal<In, Bits<A>>,
    pub read_word: Signal<Out, Bits<W>>,
    _words: Vec<u64>,
}

impl<const A: usize, const W: usize> Default for AsyncRam<A, W> {
    fn default() -> Self {
        defaulted!(Self {
            _words: vec![0; 1 << A],
        };
            clock write write_place write_word read_place read_word
        )
    }
}

impl<const A: usize, const W: usize> Logic for AsyncRam<A, W> {
    fn update(&mut self) {
        if self.clock.pos_edge() && self.write.val() {
            let place = self.write_place.val().to_u64() as usize;
            self._words[place] = self.write_word.val().to_u64();
        }
        let place = self.read_place.val().to_u64() as usize;
        self.read_word.next = self._words[place].to_bits();
    }

    fn connect(&mut self) {
        self.read_word.connect();
    }

    fn hdl(&self) -> Verilog {
        let (high, last) = (W - 1, (1_u64 << A) - 1);
        Verilog::Custom(format!(
            "reg [{high}:0] words [0:{last}];\n\
             integer place;\n\
             initial for (place = 0; place <= {last}; place = place + 1) words[place] = {W}'d0;\n\
             wire [{high}:0] read = words[read_place];\n\
             always @(*) read_word = read;\n\
             always @(posedge clock) if (write) words[write_place] <= write_word;\n",
        ))
    }
}
