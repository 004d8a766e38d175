//! Replays the regression cases, each in every device, and tests the campaign that makes them.

mod support;

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{Machine, find_machine};
use photoncube_testbench::{
    Device, DeviceError, DeviceKind, Divergence, Keeper, Pair, Regression, Source, State, Text,
    VerifyError, VerifyOptions, campaign, minimised, plant, verify_device,
};

/// The folder of the stored cases, and the command that replays one.
const FOLDER: &str = "regressions";

/// The clocks of the minimised case of a broken adder: the query, the group's two, the squares, the first
/// sum, and the clock that shows it.
const FEW_CLOCKS: usize = 6;

fn main() {
    let mut trials = Vec::new();
    for (name, case) in kept() {
        for kind in DeviceKind::ALL {
            let (name, case) = (format!("kept::{name}::{kind}"), case.clone());
            let run = move || {
                let mut device = kind.open(case.machine()?, Level::Machine)?;
                assert!(case.replay(device.as_mut())? > 0);
                Ok(())
            };
            trials.push(support::trial(name, kind, run));
        }
    }
    trials.push(Trial::test("minimised::a_planted_fault", planted_fault));
    trials.push(Trial::test("campaign::goes_on", goes_on));
    trials.push(Trial::test("campaign::leaves_out_what_failed", leaves_out));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// The cases in the folder. A file that is not a case fails the test.
fn kept() -> Vec<(String, Regression)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(FOLDER);
    let files = fs::read_dir(folder).expect("the folder of regression cases is there");
    let mut cases: Vec<_> = files
        .map(|file| {
            let path = file.expect("the folder can be read").path();
            let text = fs::read_to_string(&path).expect("a case can be read");
            let case = Regression::parse(&text)
                .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            let name = path.file_stem().unwrap_or_default().to_string_lossy();
            (name.into_owned(), case)
        })
        .collect();
    cases.sort_by(|(a, _), (b, _)| a.cmp(b));
    assert!(!cases.is_empty(), "no regression case to replay");
    cases
}

/// `paper` with an adder that loses its carries.
fn broken() -> Result<Emitted, Failed> {
    let machine = find_machine("paper")?;
    let mut design = emit(machine, Level::Machine)?;
    let module = format!("{}_add_unit", machine.module_prefix());
    design.text = plant(&design.text, &module, "a + b", "a ^ b")?;
    Ok(design)
}

fn planted_fault() -> Result<(), Failed> {
    let machine = find_machine("paper")?;
    let design = broken()?;
    let mut open = || Ok::<Box<dyn Device>, DeviceError>(Box::new(Text::new(&design)?));
    let options = VerifyOptions {
        iterations: 1_000,
        seed: 5,
        source: Source::Random,
    };
    let found = verify_device(machine, open()?.as_mut(), &options, &|_| ());
    let Err(VerifyError::Diverged(divergence)) = found else {
        return Err(format!("the fault was not found: {found:?}").into());
    };
    let case = minimised(machine, &divergence, &mut open)?;
    // The file `testbenches/regressions/planted-adder.json` was made from this output.
    println!("{}", case.text());
    let case = Regression::parse(&case.text())?;
    assert!(case.rows.len() <= FEW_CLOCKS, "{} clocks", case.rows.len());
    // Two numbers that are added are enough to show the fault; of some hundred values few are left.
    let values = case.rows.iter().flatten().filter(|&&value| value != 0);
    assert!(values.count() <= FEW_CLOCKS + 1, "{}", case.text());
    let again = case.replay(open()?.as_mut());
    assert!(matches!(again, Err(VerifyError::Diverged(_))), "{again:?}");
    let sound = case.replay(&mut Text::new(&emit(machine, Level::Machine)?)?)?;
    assert_eq!(sound, case.rows.len() as u64);
    Ok(())
}

/// A keeper that stores cases in memory.
#[derive(Default)]
struct Memory {
    saved: Vec<String>,
    kept: Vec<String>,
}

impl Keeper for Memory {
    type Error = VerifyError;

    fn save(&mut self, state: &State) -> Result<(), VerifyError> {
        self.saved.push(state.text());
        Ok(())
    }

    fn keep(&mut self, (machine, _): Pair, _: &Divergence) -> Result<String, VerifyError> {
        self.kept.push(machine.name.to_owned());
        Ok("case.json".to_owned())
    }
}

fn paper() -> Result<&'static Machine, Failed> {
    Ok(find_machine("paper")?)
}

/// A campaign that is killed after any of its jobs continues without repeating or omitting a job.
fn goes_on() -> Result<(), Failed> {
    let pairs = [(paper()?, DeviceKind::Text)];
    let mut memory = Memory::default();
    let soon = || Instant::now() + Duration::from_millis(50);
    campaign(&mut State::new(7), &pairs, soon(), &mut memory)?;
    let first = State::parse(memory.saved.first().ok_or("nothing was saved")?)?;
    assert_eq!(first.jobs.len(), 1);
    let mut state = first.clone();
    campaign(&mut state, &pairs, soon(), &mut memory)?;
    let mut jobs: Vec<_> = state.jobs.iter().map(|done| done.job).collect();
    jobs.sort_unstable();
    let all: Vec<_> = (0..jobs.len() as u64).collect();
    assert!(jobs.len() > 1 && jobs == all, "{jobs:?}");
    let mut seeds: Vec<_> = state.jobs.iter().map(|done| done.verdict.seed).collect();
    seeds.sort_unstable();
    seeds.dedup();
    assert_eq!(seeds.len(), jobs.len());
    assert!(state.vectors() > first.vectors() && first.vectors() > 0);
    Ok(())
}

fn leaves_out() -> Result<(), Failed> {
    let pairs = [(paper()?, DeviceKind::Text)];
    let mut state = State::new(7);
    state.failures.push(photoncube_testbench::Failure {
        machine: "paper".into(),
        device: "text".into(),
        seed: 1,
        divergence: String::new(),
        file: String::new(),
    });
    let never = Instant::now() + Duration::from_secs(3600);
    campaign(&mut state, &pairs, never, &mut Memory::default())?;
    assert!(state.jobs.is_empty(), "the only pair has failed");
    Ok(())
}
