//! Compares the evaluator of the emitted Verilog (crate `verilog-eval`) with Icarus: on random expressions and blocks
//! of its whole subset, and on each class of text that Verilog reads differently from Rust. `machines.rs` and
//! `parts.rs` run the evaluator on all text that is emitted.

mod blocks;
mod classes;
mod design;
mod expressions;
#[path = "../support/mod.rs"]
mod support;

use libtest_mimic::{Arguments, Trial};
use photoncube_testbench::DeviceKind;

fn main() {
    let mut trials = vec![
        Trial::test("classes::each_is_read_as_verilog_does", || {
            classes::as_verilog();
            Ok(())
        }),
        support::trial("classes::icarus".to_owned(), DeviceKind::Icarus, || {
            classes::as_icarus();
            Ok(())
        }),
    ];
    for seed in 0..expressions::DESIGNS {
        let name = format!("expressions::{seed}::icarus");
        let run = move || {
            expressions::as_icarus(seed);
            Ok(())
        };
        trials.push(support::trial(name, DeviceKind::Icarus, run));
    }
    for seed in 0..blocks::DESIGNS {
        let name = format!("blocks::{seed}::icarus");
        let run = move || {
            blocks::as_icarus(seed);
            Ok(())
        };
        trials.push(support::trial(name, DeviceKind::Icarus, run));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
