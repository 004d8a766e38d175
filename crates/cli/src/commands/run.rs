//! The command `run`: the whole path, from a scene to verified Verilog and a picture.

mod page;
mod sizing;

use std::path::PathBuf;
use std::time::Instant;

use anyhow::Result;
use photoncube_render::{BATCH_PATHS, Engine, Lighting, Scene, view_queries, workload};
use photoncube_spec::Machine;
use photoncube_testbench::{DeviceKind, Source, Verdict, VerifyError, VerifyOptions};
use serde::Serialize;

use self::sizing::Fitted;
use super::verify::{Written, verdict_table, verify_with_bar};
use crate::args::RunArgs;
use crate::chains::ChainsChoice;
use crate::cores::CoreTime;
use crate::failure::CheckFailed;
use crate::hardware::PictureTime;
use crate::outputs::{self, Output};
use crate::stages::{Distance, Traced, map_of, picture, trace_scene, view, write_picture};
use crate::table::grouped;
use crate::{files, machines, output, project, scenes, sight};

#[derive(Serialize)]
struct Report {
    scene: String,
    machine: &'static str,
    /// The format that the scene needs; `None` where the machine was given.
    fitted: Option<Fitted>,
    seed: u64,
    photons: usize,
    photons_asked: u64,
    in_range: f64,
    photon_paths: u64,
    search_radius: f64,
    photons_in_range_mean: f64,
    query_points: u64,
    photon_tests: u64,
    largest_query: u64,
    photons_without_power: u64,
    photon_groups: u64,
    bits_per_photon: u32,
    initiation_interval: f64,
    photons_per_iteration: usize,
    queries_at_once: usize,
    photon_tests_per_clock: f64,
    /// The time of the picture at the measured clock of the machine.
    #[serde(flatten)]
    time: PictureTime,
    /// The vectors compared on emitted Verilog; those of rust-hdl's own simulation are not counted.
    vectors_compared: u64,
    mismatches: usize,
    divergence: Option<String>,
    devices: Vec<Verdict>,
    devices_not_found: Vec<NotFound>,
    /// The waveform of the last simulator; `None` where none was asked for.
    waves: Option<Written>,
    /// The difference of the golden model's picture from the f64 reference's, rms over pixels and channels.
    #[serde(flatten)]
    distance: Distance,
    picture: String,
    reference_picture: String,
    error_map: String,
    /// The path of the page.
    page: String,
    verilog: String,
    seconds: Seconds,
}

#[derive(Serialize)]
struct NotFound {
    device: &'static str,
    missing: &'static str,
    install: String,
}

#[derive(Serialize, Default)]
struct Seconds {
    trace: f64,
    fit: f64,
    emit: f64,
    verify: f64,
    render_f64: f64,
    render_model: f64,
}

/// Runs all stages and prints the report.
pub fn execute(args: &RunArgs, json: bool) -> Result<()> {
    // A wrong name is reported before the work.
    args.machine.find()?;
    let scene = scenes::load(&args.scene)?;
    let paths = Paths::of(args);
    paths.check(&scene)?;
    args.waves.check(scene.files())?;
    let view = view(&args.picture);
    sight::check(&scene, &view)?;
    let mut seconds = Seconds::default();

    let traced = timed(&mut seconds.trace, || {
        trace_scene(scene, &args.picture, &Lighting::default())
    })?;
    let sized = timed(&mut seconds.fit, || sizing::machine(args, &traced));
    let (machine, fitted) = sight::explained(sized, &traced.scene, &view)?;
    let written = timed(&mut seconds.emit, || {
        machines::prepare(machine)?;
        project::write(machine, "--out", &args.out, traced.scene.files())
    })?;
    let compared = timed(&mut seconds.verify, || compare(args, machine, &traced));
    let compared = sight::explained(compared, &traced.scene, &view)?;
    let reference = timed(&mut seconds.render_f64, || {
        picture(&traced, Engine::F64, &view, "rendering, f64")
    })?;
    let rendering = timed(&mut seconds.render_model, || {
        picture(&traced, Engine::from(machine), &view, "rendering, model")
    })?;
    write_picture(&rendering.image, &paths.picture)?;
    write_picture(&reference.image, &paths.reference)?;

    let distance = Distance::between(&rendering.image, &reference.image)?;
    let name = traced.scene.name();
    let title = format!("relative error: {} of {name} against f64", machine.name);
    let map = map_of(&rendering.image, &reference.image, &title);
    files::write(&paths.error_map, map.as_bytes())?;
    let stats = rendering.stats;
    let report = Report {
        scene: args.scene.to_string(),
        machine: machine.name,
        fitted,
        seed: args.picture.seed,
        photons: traced.map().photons().len(),
        photons_asked: args.picture.photons,
        in_range: args.picture.in_range,
        photon_paths: traced.paths,
        search_radius: traced.map().radius(),
        photons_in_range_mean: stats.photons_in_range_mean(),
        query_points: stats.query_points,
        photon_tests: stats.photon_tests,
        largest_query: stats.largest_query,
        photons_without_power: stats.photons_without_power,
        photon_groups: stats.photon_groups,
        bits_per_photon: machine.bits_per_photon(),
        initiation_interval: machine.rate().interval(),
        photons_per_iteration: machine.photons_per_iteration(),
        queries_at_once: machine.queries_at_once(),
        photon_tests_per_clock: machine.photon_tests_per_clock(),
        time: PictureTime::of(machine, traced.map(), &view_queries(&traced.scene, &view)?)?,
        vectors_compared: compared.on_verilog().map(|v| v.vectors_compared).sum(),
        mismatches: compared.divergence.iter().count(),
        divergence: compared.divergence.clone(),
        devices: compared.verdicts,
        devices_not_found: compared.not_found,
        waves: compared.waves,
        distance,
        picture: paths.picture.display().to_string(),
        reference_picture: paths.reference.display().to_string(),
        error_map: paths.error_map.display().to_string(),
        page: paths.page.display().to_string(),
        verilog: written[0].clone(),
        seconds,
    };
    let about = page::About {
        args,
        machine,
        traced: &traced,
        view: &view,
        rendering: &rendering,
        reference: &reference,
        report: &report,
    };
    files::write(&paths.page, about.text()?.as_bytes())?;
    let summary = serde_json::to_string_pretty(&report)? + "\n";
    files::write(&paths.summary, summary.as_bytes())?;
    output::print_tables(json, args.wide, &report, || text(&report))?;
    match report.divergence {
        None => Ok(()),
        Some(divergence) => Err(CheckFailed(divergence).into()),
    }
}

/// The paths of the files that a run writes besides the Verilog.
struct Paths {
    picture: PathBuf,
    reference: PathBuf,
    error_map: PathBuf,
    page: PathBuf,
    summary: PathBuf,
}

impl Paths {
    fn of(args: &RunArgs) -> Self {
        let name = scenes::stem(&args.scene);
        let path = |what: &str| args.out.join(format!("{name}{what}"));
        Self {
            picture: path(".png"),
            reference: path("-f64.png"),
            error_map: path("-error.svg"),
            page: path(".html"),
            summary: args.out.join("run.json"),
        }
    }

    fn check(&self, scene: &Scene) -> Result<()> {
        let paths = [
            &self.picture,
            &self.reference,
            &self.error_map,
            &self.page,
            &self.summary,
        ];
        let outputs = paths.map(|path| Output::within("--out", path.clone()));
        outputs::check(&outputs, scene.files())
    }
}

fn timed<T>(seconds: &mut f64, work: impl FnOnce() -> Result<T>) -> Result<T> {
    let start = Instant::now();
    let result = work();
    *seconds = start.elapsed().as_secs_f64();
    result
}

struct Comparison {
    verdicts: Vec<Verdict>,
    not_found: Vec<NotFound>,
    /// The waveform of the last device.
    waves: Option<Written>,
    /// The first difference, which ends the comparison.
    divergence: Option<String>,
}

impl Comparison {
    fn on_verilog(&self) -> impl Iterator<Item = &Verdict> {
        let own = DeviceKind::RustHdl.name();
        self.verdicts.iter().filter(move |v| v.device != own)
    }
}

/// The simulators, each with the iterations that it runs in a few seconds.
const SIMULATORS: [(DeviceKind, u64); 4] = [
    (DeviceKind::RustHdl, 5_000),
    (DeviceKind::Text, 20_000),
    (DeviceKind::Icarus, 500),
    (DeviceKind::Verilator, 200_000),
];

/// Verifies stage 5: runs photons of this scene through every simulator that is installed.
fn compare(args: &RunArgs, machine: &Machine, traced: &Traced) -> Result<Comparison> {
    let view = view(&args.picture);
    let mut compared = Comparison {
        verdicts: Vec::new(),
        not_found: Vec::new(),
        waves: None,
        divergence: None,
    };
    let repeat = format!(
        "photoncube run {} --machine {} --seed {}",
        args.scene, machine.name, args.picture.seed
    );
    for (device, iterations) in SIMULATORS {
        if let Some(tool) = device.missing_tool() {
            compared.not_found.push(NotFound {
                device: device.name(),
                missing: tool.program,
                install: tool.install(),
            });
            continue;
        }
        let iterations = args.iterations.unwrap_or(iterations);
        let (scene, map) = (&traced.scene, traced.map());
        let queries = workload(scene, map, machine, &view, iterations, args.picture.seed)?;
        let options = VerifyOptions {
            iterations,
            seed: args.picture.seed,
            source: Source::Workload {
                queries: &queries,
                repeat: &repeat,
            },
        };
        let (ended, recorded) = verify_with_bar(machine, device, &options, args.waves.clocks());
        compared.waves = args.waves.write(recorded.as_ref())?;
        match ended {
            Ok(verdict) => compared.verdicts.push(verdict),
            Err(VerifyError::Diverged(divergence)) => {
                compared.divergence = Some(divergence.to_string());
                break;
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(compared)
}

fn text(report: &Report) -> String {
    let r = report;
    let mut text = format!(
        "{} on machine {}\n\
         \x20 photons           {} stored from {} paths; at least {} asked for, batches of {BATCH_PATHS} paths are completed\n\
         \x20 query points      {}, on average {:.0} photons in range of radius {:.4}, {} aimed at\n\
         \x20 photon tests      {} in {} groups; {} in the largest query\n\
         \x20 clocks            {} ({} for {} photons, {:.3} photon tests a clock)\n\
         \x20 at the clock      {}\n\
         \x20 model against f64 {:.3} % rms relative error of the picture, relMSE {:.2e}, RMSE {:.2e}\n\
         \x20 pictures          {}, {}, {}\n\
         \x20 page              {}\n\
         \x20 Verilog           {}\n",
        r.scene,
        r.machine,
        grouped(r.photons as u64),
        grouped(r.photon_paths),
        grouped(r.photons_asked),
        grouped(r.query_points),
        r.photons_in_range_mean,
        r.search_radius,
        r.in_range,
        grouped(r.photon_tests),
        grouped(r.photon_groups),
        grouped(r.largest_query),
        r.time
            .clocks
            .map_or_else(|| "not known".to_owned(), grouped),
        r.initiation_interval,
        r.photons_per_iteration,
        r.photon_tests_per_clock,
        r.time.text(),
        100.0 * r.distance.rms_relative_error,
        r.distance.rel_mse,
        r.distance.rmse,
        r.picture,
        r.reference_picture,
        r.error_map,
        r.page,
        r.verilog,
    );
    text += &r.fitted.as_ref().map_or_else(String::new, fitted_line);
    text += &sight::without_power(r.photons_without_power);
    text += "\n";
    text += &verdict_table(&r.devices);
    if let Some(waves) = &r.waves {
        text += &(waves.text() + "\n");
    }
    for missing in &r.devices_not_found {
        text += &format!(
            "\nNOT RUN: {}: `{}` was not found; install it with: {}\n",
            missing.device, missing.missing, missing.install
        );
    }
    text += &format!(
        "\n{} vectors compared on the emitted Verilog, {} mismatches\n",
        grouped(r.vectors_compared),
        r.mismatches
    );
    let s = &r.seconds;
    text + &format!(
        "seconds: trace {:.1}, fit {:.1}, emit {:.1}, verify {:.1}, render f64 {:.1}, render model {:.1}\n",
        s.trace, s.fit, s.emit, s.verify, s.render_f64, s.render_model
    )
}

/// The time of the picture on the fastest core, if there is one.
fn core_line(core: Option<&CoreTime>) -> String {
    core.map_or_else(String::new, |core| {
        format!(
            "\x20 fastest core      {}: error / noise {:.4}; {}\n",
            core.core,
            core.error_over_noise,
            core.time.text_with_loads()
        )
    })
}

fn fitted_line(fitted: &Fitted) -> String {
    let row = &fitted.row;
    format!(
        "\x20 the scene needs   {}: {} bits per photon, error / noise {:.4} predicted, {:.4} measured, below {}; its sums \
         hold the largest query of this picture, which `photoncube fit` does not see\n",
        row.format,
        row.bits_per_photon,
        row.prediction.error_over_noise,
        row.measurement.error_over_noise,
        fitted.noise_ratio,
    ) + &core_line(fitted.fastest_core.as_ref())
        + &fitted
            .cores
            .as_ref()
            .map_or_else(String::new, ChainsChoice::text)
}
