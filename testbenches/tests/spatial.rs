//! Verifies unnamed spatial machines: every kind of squarer, with the pipeline registers of a named machine,
//! with the fewest and with all of them.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_hdl::Level;
use photoncube_spec::{Cut, Cuts, Machine, Organisation, Spatial, Squarer, find_machine};
use photoncube_testbench::{DeviceKind, Source, VerifyOptions, verify, verify_part};

/// The fewest pipeline registers that the rules allow.
fn fewest(squarer: Squarer) -> Cuts {
    match squarer {
        // A table is a memory with a clock.
        Squarer::Table => Cuts::of(&[Cut::Cross, Cut::Range]),
        _ => Cuts::of(&[Cut::Range]),
    }
}

/// Pipeline registers at all places.
const ALL: Cuts = Cuts::of(&Cut::ALL);

/// The devices that start at once. Verilator takes longer to build these machines than the test to run them.
const DEVICES: [DeviceKind; 3] = [DeviceKind::RustHdl, DeviceKind::Text, DeviceKind::Icarus];

/// The number of pairs of two 10-bit coordinates.
const ALL_PAIRS: usize = 1 << 20;

fn variant(name: &str, squarer: Squarer, cuts: Option<Cuts>) -> Machine {
    let machine = *find_machine(name).expect("a named machine");
    let spatial = *machine.spatial().expect("a spatial machine");
    Machine {
        squarer,
        organisation: Organisation::Spatial(Spatial {
            cuts: cuts.unwrap_or(spatial.cuts),
            ..spatial
        }),
        ..machine
    }
}

/// The iterations. One engine gets a thousand, with each squarer's corners. The engines of a chain are alike,
/// so the chain gets enough for each engine to pass words on, and more where that is quick.
fn iterations(name: &str, kind: DeviceKind) -> u64 {
    match (name, kind) {
        ("stream", _) | (_, DeviceKind::Text) => 1_000,
        _ => 50,
    }
}

fn equal(machine: &Machine, kind: DeviceKind, iterations: u64) -> Result<(), Failed> {
    let options = VerifyOptions {
        iterations,
        seed: 1,
        source: Source::Random,
    };
    let verdict = verify(machine, kind, &options, &|_| ())?;
    assert!(verdict.registers_compared && verdict.iterations >= iterations);
    Ok(())
}

fn main() {
    let mut trials = Vec::new();
    // One engine whose queries have radii, and a chain with the format's radius.
    for name in ["stream", "tile-5"] {
        for squarer in [Squarer::Digits, Squarer::Product, Squarer::Table] {
            let fewest = Some(fewest(squarer));
            for (cuts_name, cuts) in [("own", None), ("fewest", fewest), ("all", Some(ALL))] {
                let machine = variant(name, squarer, cuts);
                for kind in DEVICES {
                    let title = format!("{name}::{}::{cuts_name}::{kind}", squarer.name());
                    let iterations = iterations(name, kind);
                    let run = move || equal(&machine, kind, iterations);
                    trials.push(support::trial(title, kind, run));
                }
            }
        }
    }
    for squarer in [Squarer::Product, Squarer::Table] {
        let machine = variant("stream", squarer, None);
        let kind = DeviceKind::Verilator;
        let title = format!("square_pair::stream::{}::{kind}", squarer.name());
        let run = move || {
            let verdict = verify_part(&machine, Level::SquarePair, kind, ALL_PAIRS, 1)?;
            assert!(verdict.vectors_compared >= ALL_PAIRS as u64);
            Ok(())
        };
        trials.push(support::trial(title, kind, run));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
