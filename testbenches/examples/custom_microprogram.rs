//! A microprogram of one's own, from its listing to its emitted Verilog, compared with the golden model in every clock.
//! `cargo run -p photoncube-testbench --example custom_microprogram`

use std::error::Error;

use photoncube_spec::{check_schedule, find_machine, parse_listing};
use photoncube_testbench::{DeviceKind, Source, VerifyOptions, programmed, verify};

/// The paper's gather with the two sums over an axis of photons before the gate's step in another order: `add w` comes
/// first. docs/microprograms.md has the ops.
const LISTING: &str = "\
query:
   0  ldq
iteration:
   0  ldp
   1  ldw
   2  sqd
   3  add w
   4  add z
   5  gate
   6  add y
   7  add x
   8  acc
";

fn main() -> Result<(), Box<dyn Error>> {
    let paper = find_machine("paper")?;
    let program = parse_listing(LISTING)?;
    check_schedule(&program, paper.hypercube())?;
    let machine = programmed(paper, &program);
    let options = VerifyOptions {
        iterations: 2000,
        seed: 1,
        source: Source::Random,
    };
    // The evaluator runs the Verilog that the generator emits, and needs no tool.
    let verdict = verify(&machine, DeviceKind::Text, &options, &|_| ())?;
    println!(
        "{} groups of photons, {} clocks of {} signals: the emitted Verilog is the golden model",
        verdict.iterations, verdict.vectors_compared, verdict.signals_per_vector
    );
    Ok(())
}
