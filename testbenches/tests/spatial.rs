//! Spatial machines that have no name: other squarers and other cuts than those of the named ones,
//! against the golden model.

mod support;

use libtest_mimic::Arguments;
use photoncube_spec::{Cut, Cuts, Machine, Organisation, Spatial, Squarer, find_machine};
use photoncube_testbench::{DeviceKind, Source, VerifyOptions, verify};

/// Registers where one must be, and nowhere else.
const FEWEST: Cuts = Cuts::of(&[Cut::Range, Cut::Products]);
/// All registers.
const ALL: Cuts = Cuts::of(&Cut::ALL);

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

fn main() {
    let mut trials = Vec::new();
    let cuts = [("own", None), ("fewest", Some(FEWEST)), ("all", Some(ALL))];
    for name in ["stream", "tile-5"] {
        for squarer in [Squarer::Digits, Squarer::Product, Squarer::Table] {
            for (cuts_name, cuts) in cuts {
                for kind in [
                    DeviceKind::RustHdl,
                    DeviceKind::Icarus,
                    DeviceKind::Verilator,
                ] {
                    let machine = variant(name, squarer, cuts);
                    let title = format!("{name}::{}::{cuts_name}::{kind}", squarer.name());
                    let title2 = title.clone();
                    let run = move || {
                        let options = VerifyOptions {
                            iterations: 1_000,
                            seed: 1,
                            source: Source::Random,
                        };
                        let verdict = verify(&machine, kind, &options, &|_| ())?;
                        eprintln!(
                            "{title2} {} clocks {} signals",
                            verdict.vectors_compared, verdict.signals_per_vector
                        );
                        assert!(verdict.registers_compared && verdict.mismatches == 0);
                        Ok(())
                    };
                    trials.push(support::trial(title, kind, run));
                }
            }
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
