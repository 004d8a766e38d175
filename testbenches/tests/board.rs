//! A board's Verilog at the pins of its serial line: a picture, wrong frames, and planted faults.

mod support;

use std::time::Duration;

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_driver::{Driver, SerialTransport};
use photoncube_hdl::Ulx3s;
use photoncube_render::{Engine, PhotonMap, Scene, TraceOptions, ViewOptions, render, trace};
use photoncube_spec::{CORES, Core, CoreCounter, PhotonFormat, find_machine};
use photoncube_testbench::{BoardSimulation, DeviceKind, Scenario, board_controls, verify_board};

const VIEW: ViewOptions = ViewOptions {
    width: 4,
    height: 4,
    samples_per_axis: 1,
    seed: 3,
};

/// So many chains of the committed core, behind the fastest line of a clock: a simulation takes as long as its clocks.
fn board(chains: u32) -> Ulx3s {
    let (_, machine) = CORES[0];
    let core = Core::new(find_machine(machine).unwrap(), chains).unwrap();
    Ulx3s::new(&core, 25, Ulx3s::MOST_BAUD).unwrap()
}

fn a_picture() -> Result<(), Failed> {
    let board = board(CORES[0].0);
    let core = board.core();
    let scene = Scene::built_in("cornell")?;
    let options = TraceOptions {
        photons: 150,
        seed: 3,
    };
    let photons = trace(&scene, &options, &|_| ())?.photons;
    let radius = PhotonMap::radius_for(&scene, 150, 4.0);
    let map = PhotonMap::new(&scene, photons, radius)?;
    // A query of a small bank meets in several sets more photons than the machine's format lets it meet at once.
    let format = PhotonFormat {
        max_photons: 1 << 20,
        ..*core.machine.format().unwrap()
    };
    let expected = render(&scene, &map, Engine::from(&format), &VIEW, &|_| ())?;
    let simulation = BoardSimulation::new(&board)?;
    let digest = board.files()?.core.digest;
    let transport = SerialTransport::open(simulation, core, digest, Duration::from_secs(60))?;
    let driver = Driver::new(core, vec![transport])?;
    let engine = Engine::Hardware(core.machine, &driver);
    let found = render(&scene, &map, engine, &VIEW, &|_| ())?;
    assert_eq!(found.image, expected.image);
    let work = driver.work();
    assert!(work.query_words > 50, "{work:?}");
    assert_eq!(work.counter(CoreCounter::Results), work.query_words);
    println!("{work:?}");
    Ok(())
}

fn scenarios() -> Result<(), Failed> {
    let verdict = verify_board(&board(CORES[0].0), &Scenario::ALL, 1)?;
    println!("{verdict:?}");
    assert!(
        verdict.wrong > 20 && verdict.errors >= verdict.wrong,
        "{verdict:?}"
    );
    assert!(verdict.results > 20, "{verdict:?}");
    Ok(())
}

/// The faults are in the line, so one chain is enough.
fn faults() -> Result<(), Failed> {
    for control in board_controls(&board(1), 1)? {
        assert!(control.found, "{}", control.planted);
    }
    Ok(())
}

fn main() {
    let trial = |name: &str, run: fn() -> Result<(), Failed>| {
        support::trial(name.to_owned(), DeviceKind::Verilator, run)
    };
    let trials: Vec<Trial> = vec![
        trial("a_picture_is_that_of_the_direct_gather", a_picture),
        trial("its_frames_are_those_of_the_model", scenarios),
        trial("planted_faults_are_found", faults),
    ];
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
