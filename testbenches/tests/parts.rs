//! Verifies each unit, one cell on random microprograms, and the network, of every named machine in every
//! device.

mod support;

use libtest_mimic::Arguments;
use photoncube_hdl::Level;
use photoncube_spec::{MACHINES, Machine, Unit};
use photoncube_testbench::{DeviceKind, verify_part};

/// The rows of inputs for one part. The squarer and the difference are written by hand, so the fastest device
/// gets every pair of operands of the photon formats' square units. That device takes longest to build, and
/// gets no other parts.
fn vectors(kind: DeviceKind, part: Level) -> usize {
    match (kind, part) {
        (DeviceKind::Verilator, Level::Unit(Unit::Square) | Level::SquarePair) => 1 << 21,
        // Some sixty whole banks.
        (DeviceKind::Verilator, Level::Memory) => 1 << 17,
        // The pins of the memory show words that were never written, which a netlist's memory does not model.
        (DeviceKind::Netlist, Level::Memory) => 0,
        (DeviceKind::Verilator, _) => 0,
        (DeviceKind::RustHdl | DeviceKind::Text, _) => 20_000,
        (DeviceKind::Icarus | DeviceKind::Netlist, _) => 5_000,
    }
}

/// Whether a part of a machine differs from the parts of earlier machines. The parts of a chain are those of
/// one engine. All chips have the photon memory of the shortest chain with one.
fn is_new(machine: &Machine, part: Level) -> bool {
    match part {
        Level::Machine => false,
        Level::Memory => machine.name == "tile-6-mixed",
        _ => machine.queries_at_once() == 1,
    }
}

fn main() {
    let mut trials = Vec::new();
    for machine in MACHINES {
        let parts = Level::of(machine).into_iter();
        for part in parts.filter(|&part| is_new(machine, part)) {
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
