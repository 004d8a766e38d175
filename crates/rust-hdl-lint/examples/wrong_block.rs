//! A block whose Verilog differs from its Rust, and the lint that finds it.
//! `cargo run -p rust-hdl-lint --example wrong_block`

use rust_hdl::prelude::*;
use rust_hdl_lint::lint;

/// A comparison of a sum: Rust's 8-bit sum wraps, Verilog's has 9 bits.
#[derive(LogicBlock, Default)]
struct Overflow {
    a: Signal<In, Bits<8>>,
    b: Signal<In, Bits<8>>,
    limit: Signal<In, Bits<8>>,
    above: Signal<Out, Bit>,
}

impl Logic for Overflow {
    #[hdl_gen]
    fn update(&mut self) {
        self.above.next = self.a.val() + self.b.val() > self.limit.val();
    }
}

fn main() {
    let mut block = Overflow::default();
    block.connect_all();
    println!("{}", generate_verilog_unchecked(&block));
    for finding in lint(&block) {
        println!("{finding}");
    }
}
