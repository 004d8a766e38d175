//! Formal proofs that need little time, each with what must be reachable and with planted faults.

mod support;

use libtest_mimic::{Arguments, Failed};
use photoncube_spec::find_machine;
use photoncube_testbench::{DeviceKind, formal};

fn main() {
    let mut trials = Vec::new();
    for machine in std::env::var("FM")
        .unwrap_or("paper".into())
        .leak()
        .split(',')
    {
        let run = move || all_hold(machine);
        trials.push(support::trial(
            format!("quick::{machine}"),
            DeviceKind::Netlist,
            run,
        ));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn all_hold(machine: &str) -> Result<(), Failed> {
    let found = formal(find_machine(machine)?, &|_| true, &|_, _| ())?;
    let failed: Vec<_> = found.failed().collect();
    assert!(failed.is_empty(), "{failed:#?}");
    assert!(!found.proofs.is_empty());
    for proof in &found.proofs {
        println!("{} {} {:.2}", proof.property, proof.holds(), proof.seconds);
    }
    Ok(())
}
