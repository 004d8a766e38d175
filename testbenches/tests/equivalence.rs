//! Verifies every named machine on random stimulus and on the photons of the built-in scene, in the devices that its
//! size allows ([`Extent`]).

mod extent;
mod support;

use std::process::Command;
use std::sync::OnceLock;

use libtest_mimic::{Arguments, Failed, Trial};
use photoncube_render::{PhotonMap, Scene, TraceOptions, ViewOptions, trace, workload};
use photoncube_spec::{MACHINES, Machine, find_machine};
use photoncube_testbench::{DeviceKind, Source, Verdict, VerifyOptions, verify};

use extent::Extent;

/// The iterations on random stimulus. Only machines that run in all devices have their netlist simulated here:
/// `parts` compares the netlist of each part of the others, and `photoncube verify placed` all of it.
fn random_iterations(kind: DeviceKind, extent: Extent) -> Option<u64> {
    let iterations = match kind {
        DeviceKind::RustHdl => [2_000, 400, 20, 0],
        DeviceKind::Text => [20_000, 2_000, 500, 50],
        DeviceKind::Icarus => [200, 50, 20, 0],
        DeviceKind::Verilator => [100_000, 0, 0, 0],
        DeviceKind::Netlist => [100, 0, 0, 0],
    };
    chosen(extent, iterations)
}

/// The iterations on photons of the scene. The netlist differs from Icarus only in its gates, which random
/// stimulus exercises better.
fn scene_iterations(kind: DeviceKind, extent: Extent) -> Option<u64> {
    let iterations = match kind {
        DeviceKind::RustHdl => [500, 100, 0, 0],
        DeviceKind::Text => [5_000, 1_000, 0, 0],
        DeviceKind::Icarus => [100, 25, 0, 0],
        DeviceKind::Verilator => [50_000, 0, 0, 0],
        DeviceKind::Netlist => [0; 4],
    };
    chosen(extent, iterations)
}

fn chosen(extent: Extent, [full, brief, chain, long_chain]: [u64; 4]) -> Option<u64> {
    let iterations = match extent {
        Extent::Full => full,
        Extent::Brief => brief,
        Extent::Chain => chain,
        Extent::LongChain => long_chain,
    };
    (iterations > 0).then_some(iterations)
}

/// The corners by name, each with machines that handle it differently: one of each organisation, one whose
/// most photons are a power of two, a chain, and one with a photon memory, whose bank holds the most photons.
const CORNERS: [(&str, Source, &[&str]); 3] = [
    (
        "lane_alone",
        Source::LaneAlone,
        &["paper", "overlap", "stream", "tile-6", "tile-6-mixed"],
    ),
    (
        "full_then_empty",
        Source::FullThenEmpty,
        &[
            "paper",
            "overlap",
            "stream",
            "fit-ring",
            "tile-6",
            "tile-6-mixed",
        ],
    ),
    ("full_bank", Source::FullBank, &["tile-6-mixed"]),
];

fn main() {
    let mut trials = Vec::new();
    // The trials of one machine stand apart, so that a simulation that one has built is ready for the next.
    for machine in MACHINES {
        for kind in DeviceKind::ALL {
            let iterations = random_iterations(kind, Extent::of(machine));
            let Some(iterations) = iterations else {
                continue;
            };
            let name = format!("random::{}::{kind}", machine.name);
            let run = move || random(machine, kind, iterations);
            trials.push(support::trial(name, kind, run));
        }
    }
    for machine in MACHINES {
        for kind in DeviceKind::ALL {
            if let Some(iterations) = scene_iterations(kind, Extent::of(machine)) {
                let name = format!("scene::{}::{kind}", machine.name);
                let run = move || scene(machine, kind, iterations);
                trials.push(support::trial(name, kind, run));
            }
        }
    }
    for (corner, source, machines) in CORNERS {
        for name in machines {
            let kind = DeviceKind::Verilator;
            let run = move || corner_alone(name, kind, source);
            trials.push(support::trial(
                format!("{corner}::{name}::{kind}"),
                kind,
                run,
            ));
        }
    }
    trials.push(Trial::test("tools::missing_ones_are_listed", missing_tools));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn random(machine: &Machine, kind: DeviceKind, iterations: u64) -> Result<(), Failed> {
    let options = VerifyOptions {
        iterations,
        seed: 1,
        source: Source::Random,
    };
    let verdict = verify(machine, kind, &options, &|_| {})?;
    check(machine, &verdict, kind, iterations);
    Ok(())
}

fn corner_alone(name: &str, kind: DeviceKind, source: Source<'static>) -> Result<(), Failed> {
    let machine = find_machine(name)?;
    let lanes = machine.photons_per_iteration() as u64;
    let groups = machine.max_photons() / lanes;
    let iterations = match source {
        // A bank holds as many photons of a lane as groups.
        Source::LaneAlone if machine.has_memory() => lanes * groups,
        Source::LaneAlone => lanes * machine.max_photons(),
        Source::FullThenEmpty if machine.has_memory() => 4 * groups,
        Source::FullThenEmpty => 2 * (groups + 1),
        // Batches of a whole bank, or of one place less, in each of two passes.
        _ => 2 * 13 * (groups - 1),
    };
    let options = VerifyOptions {
        iterations,
        seed: 1,
        source,
    };
    let verdict = verify(machine, kind, &options, &|_| {})?;
    check(machine, &verdict, kind, iterations);
    Ok(())
}

fn scene(machine: &Machine, kind: DeviceKind, iterations: u64) -> Result<(), Failed> {
    static MAP: OnceLock<(Scene, PhotonMap)> = OnceLock::new();
    let (scene, map) = MAP.get_or_init(photon_map);
    let queries = workload(scene, map, machine, &ViewOptions::default(), iterations, 1)?;
    let options = VerifyOptions {
        iterations,
        seed: 1,
        source: Source::Workload {
            queries: &queries,
            repeat: "cargo test -p photoncube-testbench --test equivalence -- scene",
        },
    };
    let verdict = verify(machine, kind, &options, &|_| {})?;
    check(machine, &verdict, kind, iterations);
    Ok(())
}

fn photon_map() -> (Scene, PhotonMap) {
    let scene = Scene::built_in("cornell").expect("the scene is built in");
    let options = TraceOptions {
        photons: 100_000,
        seed: 1,
    };
    let photons = trace(&scene, &options, &|_| ()).expect("the scene has a light");
    let photons = photons.photons;
    // 100 photons in range give queries with some hundred candidates.
    let radius = PhotonMap::radius_for(&scene, photons.len() as u64, 100.0);
    let map = PhotonMap::new(&scene, photons, radius).expect("the photons fit a map");
    (scene, map)
}

/// Runs this test program without any tool on its PATH.
fn missing_tools() -> Result<(), Failed> {
    let run = |arguments: &[&str], require: &str| {
        Command::new(std::env::current_exe()?)
            .args(arguments)
            .env("PATH", "")
            .env("REQUIRE_EDA", require)
            .output()
    };
    let listed = run(&["--list", "--ignored"], "0")?;
    let listed = String::from_utf8(listed.stdout)?;
    for package in ["iverilog", "verilator", "yosys"] {
        let named = format!("(sudo apt-get install -y {package})");
        assert!(listed.contains(&named), "{listed}");
    }
    for built_in in ["rust-hdl", "text"] {
        assert!(!listed.contains(built_in), "{listed}");
    }
    let icarus = ["--exact", "random::paper::icarus"];
    let ignored = run(&icarus, "0")?;
    assert!(ignored.status.success());
    let required = run(&icarus, "1")?;
    assert!(!required.status.success());
    let said = String::from_utf8(required.stdout)?;
    assert!(said.contains("`iverilog` is not on the PATH"), "{said}");
    Ok(())
}

fn check(machine: &Machine, verdict: &Verdict, kind: DeviceKind, iterations: u64) {
    println!(
        "{} in {}: {} clocks of {} signals, {} iterations, {} results",
        verdict.machine,
        verdict.device,
        verdict.vectors_compared,
        verdict.signals_per_vector,
        verdict.iterations,
        verdict.results_compared
    );
    assert!(verdict.iterations >= iterations);
    let clocks = machine.rate().interval() * verdict.iterations as f64;
    assert!(verdict.vectors_compared as f64 > clocks);
    assert!(verdict.results_compared > 0);
    assert_eq!(verdict.registers_compared, kind != DeviceKind::Netlist);
}
