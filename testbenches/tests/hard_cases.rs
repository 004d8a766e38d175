//! Runs the hard cases in every named machine and every device: photons that some arithmetic gets wrong, as
//! the machine's words, with counts that follow from their placement.

mod extent;
mod support;

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_hard_cases::{Grid, HARD_CASES, HardCase};
use photoncube_model::gather;
use photoncube_spec::{MACHINES, Machine, Photon, Query, Sums};
use photoncube_testbench::{DeviceKind, Source, Verdict, VerifyOptions, verify};

use extent::Extent;

type Workload = Vec<(Query, Vec<Photon>)>;

/// The iterations of each case, which begin with its first photon, by the device's speed. Verilator runs all
/// of them, up to the most photons that a machine declares, in one machine of each organisation.
fn iterations_of_a_case(machine: &Machine, kind: DeviceKind) -> usize {
    match kind {
        DeviceKind::RustHdl => 250,
        DeviceKind::Text => 1_000,
        DeviceKind::Icarus => 70,
        DeviceKind::Verilator if Extent::of(machine) == Extent::Full => usize::MAX,
        DeviceKind::Verilator | DeviceKind::Netlist => 0,
    }
}

/// The most engines of a machine that runs the cases in devices.
const LONGEST_CHAIN: usize = 2;

fn main() {
    let mut trials = Vec::new();
    for machine in MACHINES {
        trials.push(Trial::test(format!("counts::{}", machine.name), || {
            counts(machine)
        }));
        // The engines of a longer chain are instances of one module.
        if machine.queries_at_once() > LONGEST_CHAIN {
            continue;
        }
        let has_cases = |kind: &DeviceKind| iterations_of_a_case(machine, *kind) > 0;
        for kind in DeviceKind::ALL.into_iter().filter(has_cases) {
            let name = format!("hard_cases::{}::{kind}", machine.name);
            trials.push(support::trial(name, kind, move || in_device(machine, kind)));
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// The golden model's counts are those of the placement, which uses no arithmetic.
fn counts(machine: &Machine) -> Result<(), Failed> {
    let (mut checked, mut ties) = (0, 0);
    for case in HARD_CASES {
        for setting in (case.settings)(&Grid::of_machine(machine))? {
            let workload = setting.workload(machine)?;
            for ((query, photons), count) in workload.iter().zip(&setting.counts) {
                let sums = gather(machine, query, photons.iter().copied())?;
                assert_eq!(sums.count, *count, "{}", case.name);
                checked += 1;
                if case.name == "boundary-ties-f32" {
                    ties += count;
                }
                if case.name == "largest-declared-count" {
                    assert_eq!(sums, largest_sums(machine));
                }
            }
        }
    }
    println!(
        "{}: {checked} queries counted, {ties} photons at the boundary",
        machine.name
    );
    assert!(checked > 100 && ties > 100);
    Ok(())
}

/// The largest sums that the machine declares.
fn largest_sums(machine: &Machine) -> Sums {
    let power = machine.full_scale() * u128::from(machine.max_photons());
    let mut sums = Sums {
        count: machine.max_photons(),
        ..Sums::default()
    };
    let channels = machine.channels().names().len();
    sums.power[..channels].fill(power);
    sums
}

/// Runs all cases at once, because a device is slow to build. If they differ, each is run alone to find its
/// name.
fn in_device(machine: &Machine, kind: DeviceKind) -> Result<(), Failed> {
    let mut all = Workload::new();
    let (mut cases, mut ties) = (0, 0);
    for case in HARD_CASES {
        let workload = workload(case, machine, kind)?;
        cases += usize::from(!workload.is_empty());
        if case.name == "boundary-ties-f32" {
            ties = workload.iter().map(|(_, photons)| photons.len()).sum();
        }
        all.extend(workload);
    }
    let verdict = match compare(machine, kind, &all) {
        Ok(verdict) => verdict,
        Err(error) => return Err(named(machine, kind)?.unwrap_or(error)),
    };
    println!(
        "{} in {}: {cases} cases, {} queries, {} iterations, {} vectors, {ties} photons at the boundary",
        verdict.machine,
        verdict.device,
        verdict.results_compared,
        verdict.iterations,
        verdict.vectors_compared
    );
    // Where a machine tests several queries at once, a query may be repeated.
    let results = verdict.results_compared;
    assert!(results >= all.len() as u64);
    assert!(machine.queries_at_once() > 1 || results == all.len() as u64);
    assert!(verdict.registers_compared);
    let clocks = machine.rate().interval() * verdict.iterations as f64;
    assert!(verdict.vectors_compared as f64 > clocks);
    let with_photons = HARD_CASES.iter().filter(|case| has_photons(case, machine));
    assert_eq!(cases, with_photons.count());
    assert!(cases >= 20 && ties > 100, "{cases} cases, {ties} ties");
    Ok(())
}

/// The queries of a case, as many as the device has time for.
fn workload(case: &HardCase, machine: &Machine, kind: DeviceKind) -> Result<Workload, Failed> {
    let mut left = iterations_of_a_case(machine, kind);
    let mut all = Workload::new();
    for setting in (case.settings)(&Grid::of_machine(machine))? {
        for (query, mut photons) in setting.workload(machine)? {
            if left == 0 {
                return Ok(all);
            }
            // Where a caustic has more photons than a machine declares, the first of them are used.
            let most = left.saturating_mul(machine.photons_per_iteration()) as u64;
            photons.truncate(most.min(machine.max_photons()) as usize);
            let groups = photons.len().div_ceil(machine.photons_per_iteration());
            left = left.saturating_sub(groups.max(1));
            all.push((query, photons));
        }
    }
    Ok(all)
}

fn compare(machine: &Machine, kind: DeviceKind, queries: &Workload) -> Result<Verdict, Failed> {
    let options = VerifyOptions {
        iterations: u64::MAX,
        seed: 1,
        source: Source::Workload {
            queries,
            repeat: "cargo test -p photoncube-testbench --test hard_cases",
        },
    };
    Ok(verify(machine, kind, &options, &|_| {})?)
}

fn has_photons(case: &HardCase, machine: &Machine) -> bool {
    (case.settings)(&Grid::of_machine(machine)).is_ok_and(|settings| !settings.is_empty())
}

/// The first case that fails alone.
fn named(machine: &Machine, kind: DeviceKind) -> Result<Option<Failed>, Failed> {
    for case in HARD_CASES {
        let queries = workload(case, machine, kind)?;
        if queries.is_empty() {
            continue;
        }
        if let Err(error) = compare(machine, kind, &queries) {
            let message = error.message().unwrap_or_default();
            return Ok(Some(Failed::from(format!("{}: {message}", case.name))));
        }
    }
    Ok(None)
}
