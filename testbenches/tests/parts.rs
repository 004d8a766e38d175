//! Each unit, one cell on random microprograms, and the network, of every named machine in every
//! device.

mod support;

use libtest_mimic::Arguments;
use photoncube_hdl::Level;
use photoncube_spec::MACHINES;
use photoncube_testbench::{DeviceKind, verify_part};

/// Rows of inputs for one part. The squarer and the difference are written by hand, so the fastest
/// device gets every pair of operands of the photon formats' square units; it takes longest to build, and has no other
/// parts.
fn vectors(kind: DeviceKind, part: Level) -> usize {
    match (kind, part) {
        (DeviceKind::Verilator, Level::Square | Level::SquarePair) => 1 << 21,
        (DeviceKind::Verilator, _) => 0,
        (DeviceKind::RustHdl | DeviceKind::Text, _) => 20_000,
        (DeviceKind::Icarus | DeviceKind::Netlist, _) => 5_000,
    }
}

fn main() {
    let mut trials = Vec::new();
    // The parts of a chain are those of one engine.
    for machine in MACHINES.iter().filter(|m| m.queries_at_once() == 1) {
        let parts = Level::of(machine).iter().copied();
        for part in parts.filter(|&level| level != Level::Machine) {
            for kind in DeviceKind::ALL {
                let vectors = vectors(kind, part);
                if vectors == 0 {
                    continue;
                }
                let name = format!("{}::{}::{kind}", part.name(), machine.name);
                let run = move || {
                    let verdict = verify_part(machine, part, kind, vectors, 1)?;
                    assert!(verdict.vectors_compared >= vectors as u64);
                    Ok(())
                };
                trials.push(support::trial(name, kind, run));
            }
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
