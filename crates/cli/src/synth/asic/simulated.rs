//! The mapped netlist while it gathers photons of a scene: compared with the golden model, and its transitions counted.

use anyhow::Result;
use fpga_flow::asic::{Activities, CellFigures, Simulatable};
use photoncube_hdl::{Emitted, Level, emit};
use photoncube_render::{Lighting, ViewOptions, workload};
use photoncube_spec::{Machine, Photon, Query};
use photoncube_testbench::{
    Control, Icarus, Source, Verdict, VerifyError, VerifyOptions, verify_device, with_outputs_alone,
};
use serde::{Deserialize, Serialize};

use super::AsicRow;
use crate::args::PictureArgs;
use crate::failure::CheckFailed;
use crate::scenes::{self, SceneName};
use crate::stages::{Traced, trace_scene, view};
use crate::synth::Subject;
use crate::table;

/// The iterations in which the planted fault must be found.
const CONTROL_ITERATIONS: u64 = 20;

/// The pixels on a side of the picture whose queries are gathered. Neighbouring ones have the same photons nearly everywhere, so they fill
/// the batches of a machine that tests several queries at once.
const SIDE: u32 = 2048;

/// The photons and the view of a scene.
pub(super) struct Workload {
    scene: SceneName,
    traced: Traced,
    view: ViewOptions,
    seed: u64,
    /// The clocks in which a machine has photons at least, if it never waits.
    pub(super) clocks: f64,
    /// The iterations of random stimulus before the scene: with waits, resets and garbage, and not counted.
    pub(super) random_iterations: u64,
}

/// What a simulation compared and counted.
pub(super) struct Simulation {
    pub(super) activities: Activities,
    scene: Verdict,
    random: Verdict,
    photon_tests: u64,
}

/// A simulation of a netlist, and the energy at its activities.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Simulated {
    scene: String,
    /// The pixels on a side of the picture.
    side: u32,
    seed: u64,
    /// The digest of the netlist.
    netlist_sha256: String,
    /// The clocks in which transitions were counted.
    clocks_simulated: u64,
    /// The clocks, of these and of random stimulus, in which all outputs were equal to the golden model's.
    vectors_compared: u64,
    results_compared: u64,
    /// The tests of a photon of a query; a clock that waits has none.
    photon_tests: u64,
    /// The mean transitions of a net in a clock cycle, without the clock.
    activity: f64,
    /// The energy of all clocks over the photon tests, in picojoules.
    pub(super) energy_pj_per_test: f64,
    /// The share of the registers in the energy.
    register_energy_share: f64,
    /// The planted fault that the comparison has found.
    planted: String,
}

impl Workload {
    /// Traces a scene as `run` does without options, and takes queries of a picture of [`SIDE`] by [`SIDE`] pixels.
    pub(super) fn of(name: &SceneName) -> Result<Self> {
        let picture = PictureArgs::default();
        let traced = trace_scene(scenes::load(name)?, &picture, &Lighting::default())?;
        Ok(Self {
            scene: name.clone(),
            traced,
            view: ViewOptions {
                width: SIDE,
                height: SIDE,
                ..view(&picture)
            },
            seed: picture.seed,
            clocks: 2048.0,
            random_iterations: 100,
        })
    }

    /// Simulates the netlist of a machine. Its outputs equal the golden model's in every clock, and those of the netlist with a planted
    /// fault do not.
    pub(super) fn simulate(&self, subject: &Subject, netlist: &Simulatable) -> Result<Simulation> {
        let machine = subject.machine;
        let queries = self.queries(machine)?;
        let planted = &netlist.control.what;
        let mut wrong = Icarus::new(&design(machine, &netlist.control.text)?)?;
        let control = self.compare_random(machine, &mut wrong, CONTROL_ITERATIONS);
        if !Control::of(planted, control)?.found {
            return Err(CheckFailed(format!("a planted fault was not found: {planted}")).into());
        }
        let mut device = Icarus::new(&design(machine, &netlist.text)?)?;
        let random = self.compare_random(machine, &mut device, self.random_iterations);
        let random = random.map_err(failed)?;
        let mut device = device.dumping()?;
        let scene = self.compare(machine, &mut device, &queries);
        let scene = scene.map_err(failed)?;
        let tests = queries.iter().map(|(_, photons)| photons.len() as u64);
        Ok(Simulation {
            activities: device.activities(scene.vectors_compared)?,
            scene,
            random,
            photon_tests: tests.sum(),
        })
    }

    /// Queries of the scene with their photons, enough for [`Self::clocks`].
    fn queries(&self, machine: &Machine) -> Result<Vec<(Query, Vec<Photon>)>> {
        let tests = machine.photons_per_iteration() * machine.queries_at_once();
        let groups = (self.clocks * machine.photon_tests_per_clock() / tests as f64).ceil() as u64;
        let (scene, map) = (&self.traced.scene, self.traced.map());
        Ok(workload(
            scene, map, machine, &self.view, groups, self.seed,
        )?)
    }

    fn compare_random(
        &self,
        machine: &Machine,
        device: &mut Icarus,
        iterations: u64,
    ) -> Result<Verdict, VerifyError> {
        let options = VerifyOptions {
            iterations,
            seed: self.seed,
            source: Source::Random,
        };
        verify_device(machine, device, &options, &|_| ())
    }

    fn compare(
        &self,
        machine: &Machine,
        device: &mut Icarus,
        queries: &[(Query, Vec<Photon>)],
    ) -> Result<Verdict, VerifyError> {
        let scene = &self.scene;
        let options = VerifyOptions {
            iterations: u64::MAX,
            seed: self.seed,
            source: Source::Workload {
                queries,
                repeat: &format!(
                    "photoncube synth --asic --machine {} --activity-of {scene}",
                    machine.name
                ),
            },
        };
        verify_device(machine, device, &options, &|_| ())
    }
}

/// A difference from the golden model is a failed check, all else a computer that cannot run it.
fn failed(error: VerifyError) -> anyhow::Error {
    match error {
        VerifyError::Diverged(difference) => CheckFailed(difference.to_string()).into(),
        error => error.into(),
    }
}

/// The machine's pins around the text of its netlist.
fn design(machine: &Machine, text: &str) -> Result<Emitted> {
    let design = emit(machine, Level::Machine)?;
    Ok(with_outputs_alone(&design, text.to_owned()))
}

impl Simulated {
    /// The row of a simulation. `figures` are at the activities that it counted, whose mean is `activity`.
    pub(super) fn of(
        workload: &Workload,
        netlist: &Simulatable,
        simulation: &Simulation,
        (figures, activity): &(CellFigures, f64),
    ) -> Self {
        let Simulation { scene, random, .. } = simulation;
        let energy = figures.cycle_energy_pj() * scene.vectors_compared as f64;
        Self {
            scene: workload.scene.to_string(),
            side: workload.view.width,
            seed: workload.seed,
            netlist_sha256: netlist.netlist_sha256.clone(),
            clocks_simulated: scene.vectors_compared,
            vectors_compared: scene.vectors_compared + random.vectors_compared,
            results_compared: scene.results_compared + random.results_compared,
            photon_tests: simulation.photon_tests,
            activity: *activity,
            energy_pj_per_test: energy / simulation.photon_tests as f64,
            register_energy_share: figures.register_energy_pj / figures.cycle_energy_pj(),
            planted: netlist.control.what.clone(),
        }
    }

    /// Photon tests in a clock.
    pub(super) fn tests_per_clock(&self) -> f64 {
        self.photon_tests as f64 / self.clocks_simulated as f64
    }
}

/// The rows that were simulated, beside the energy at the assumed activity.
pub(super) fn table(rows: &[AsicRow]) -> String {
    let header = [
        "machine",
        "scene",
        "clocks simulated",
        "clocks compared",
        "photon tests",
        "tests a clock, of at most",
        "activity",
        "pJ a test, assumed",
        "pJ a test, simulated",
        "energy in registers",
    ];
    let cells = |row: &AsicRow| {
        let of = row.simulated.as_ref()?;
        Some(vec![
            row.machine.clone(),
            of.scene.clone(),
            table::grouped(of.clocks_simulated),
            table::grouped(of.vectors_compared),
            table::grouped(of.photon_tests),
            format!(
                "{:.2} of {:.2}",
                of.tests_per_clock(),
                row.photon_tests_per_clock
            ),
            format!("{:.3}", of.activity),
            format!("{:.1}", row.energy_pj_per_test),
            format!("{:.1}", of.energy_pj_per_test),
            format!("{:.0} %", 100.0 * of.register_energy_share),
        ])
    };
    table::markdown(&header, &rows.iter().filter_map(cells).collect::<Vec<_>>())
}
