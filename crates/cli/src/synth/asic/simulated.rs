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

/// The clocks in which a machine has photons at least, if it never waits.
const CLOCKS: f64 = 4096.0;
/// The iterations of random stimulus before the scene: with waits, resets and garbage, and not counted.
const RANDOM_ITERATIONS: u64 = 200;

/// The photons and the view of a scene.
pub(super) struct Workload {
    scene: String,
    traced: Traced,
    view: ViewOptions,
    seed: u64,
}

/// A simulation, and the energy at its activities.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Simulated {
    scene: String,
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
    energy_pj_per_test: f64,
    /// The share of the registers in the energy.
    register_energy_share: f64,
    /// The planted fault that the comparison has found.
    planted: String,
}

impl Workload {
    /// Traces a scene as `run` does without options.
    pub(super) fn of(name: &SceneName) -> Result<Self> {
        let picture = PictureArgs::default();
        let traced = trace_scene(scenes::load(name)?, &picture, &Lighting::default())?;
        Ok(Self {
            scene: scenes::stem(name),
            traced,
            view: view(&picture),
            seed: picture.seed,
        })
    }

    /// Simulates the netlist of a machine. Its outputs equal the golden model's in every clock, and those of the netlist with a planted
    /// fault do not.
    pub(super) fn simulate(
        &self,
        subject: &Subject,
        netlist: &Simulatable,
    ) -> Result<(Simulated, Activities)> {
        let machine = subject.machine;
        let queries = self.queries(machine)?;
        let planted = &netlist.control.what;
        let mut wrong = Icarus::new(&design(machine, &netlist.control.text)?)?;
        let control = self.compare(machine, &mut wrong, &queries);
        if !Control::of(planted, control)?.found {
            return Err(CheckFailed(format!("a planted fault was not found: {planted}")).into());
        }
        let mut device = Icarus::new(&design(machine, &netlist.text)?)?;
        let random = VerifyOptions {
            iterations: RANDOM_ITERATIONS,
            seed: self.seed,
            source: Source::Random,
        };
        let random = verify_device(machine, &mut device, &random, &|_| ()).map_err(failed)?;
        let mut device = device.dumping()?;
        let verdict = self
            .compare(machine, &mut device, &queries)
            .map_err(failed)?;
        let tests = queries.iter().map(|(_, photons)| photons.len() as u64);
        let simulated = Simulated {
            scene: self.scene.clone(),
            seed: self.seed,
            netlist_sha256: netlist.netlist_sha256.clone(),
            clocks_simulated: verdict.vectors_compared,
            vectors_compared: verdict.vectors_compared + random.vectors_compared,
            results_compared: verdict.results_compared + random.results_compared,
            photon_tests: tests.sum(),
            activity: 0.0,
            energy_pj_per_test: 0.0,
            register_energy_share: 0.0,
            planted: planted.clone(),
        };
        Ok((simulated, device.activities(verdict.vectors_compared)?))
    }

    /// Queries of the scene with their photons, enough for [`CLOCKS`].
    fn queries(&self, machine: &Machine) -> Result<Vec<(Query, Vec<Photon>)>> {
        let tests = machine.photons_per_iteration() * machine.queries_at_once();
        let groups = (CLOCKS * machine.photon_tests_per_clock() / tests as f64).ceil() as u64;
        let (scene, map) = (&self.traced.scene, self.traced.map());
        Ok(workload(
            scene, map, machine, &self.view, groups, self.seed,
        )?)
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
    /// Adds the energy at the activities that were counted, whose mean is `activity`.
    pub(super) fn with_energy(self, figures: &CellFigures, activity: f64) -> Self {
        let clocks_per_test = self.clocks_simulated as f64 / self.photon_tests as f64;
        Self {
            activity,
            energy_pj_per_test: figures.cycle_energy_pj() * clocks_per_test,
            register_energy_share: figures.register_energy_pj / figures.cycle_energy_pj(),
            ..self
        }
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
        let tests_per_clock = of.photon_tests as f64 / of.clocks_simulated as f64;
        Some(vec![
            row.machine.clone(),
            of.scene.clone(),
            table::grouped(of.clocks_simulated),
            table::grouped(of.vectors_compared),
            table::grouped(of.photon_tests),
            format!("{tests_per_clock:.2} of {:.2}", row.photon_tests_per_clock),
            format!("{:.3}", of.activity),
            format!("{:.1}", row.energy_pj_per_test),
            format!("{:.1}", of.energy_pj_per_test),
            format!("{:.0} %", 100.0 * of.register_energy_share),
        ])
    };
    table::markdown(&header, &rows.iter().filter_map(cells).collect::<Vec<_>>())
}
