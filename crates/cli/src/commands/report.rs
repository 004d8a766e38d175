//! The command `report`: the precision that a scene needs, and the speed of machines: formats and machines
//! side by side.

mod dimensions;
mod estimators;
mod page;
mod pictures;
mod row;
mod speed;
mod sweep;
mod text;
mod verdict;

use std::path::PathBuf;

use anyhow::{Result, ensure};
use photoncube_render::{BenchOptions, Engine, ErrorBench, Scene, ViewOptions, view_queries};
use photoncube_spec::{MACHINES, PHOTON_FORMATS};
use serde::Serialize;

use self::row::Row;
use self::speed::Speeds;
use self::verdict::Verdict;
use crate::args::ReportArgs;
use crate::outputs::{self, Output};
use crate::scenes::SceneName;
use crate::{cores, files, output, progress, scenes, sight};

#[derive(Serialize)]
struct Report {
    scene: String,
    seed: u64,
    maps: u64,
    photons: u64,
    in_range: f64,
    /// The number of queries of the picture of `picture_size`, which each machine's `clocks` are for.
    query_points: u64,
    noise_relative: f64,
    /// The bound of `error_over_noise`, which is the requested ratio.
    noise_ratio: f64,
    /// The verdict.
    scene_needs: Verdict,
    rows: Vec<Row>,
    estimators: Vec<estimators::Row>,
    #[serde(flatten)]
    speeds: Speeds,
    dimensions: Vec<dimensions::Row>,
    speed_plot: String,
    bits_plot: String,
    hardware_plot: String,
    dimensions_plot: String,
    /// The path of the page.
    page: String,
    #[serde(skip)]
    page_text: String,
    #[serde(skip)]
    facts: Facts,
}

/// The facts that the text states and that no JSON key has.
struct Facts {
    scene_name: String,
    estimates: u64,
    estimates_too_noisy: u64,
    photons_found: usize,
    photons_in_range_mean: f64,
}

/// Measures all formats and machines on a scene.
pub fn execute(args: &ReportArgs, json: bool) -> Result<()> {
    if args.sweep {
        return sweep::execute(args, json);
    }
    let (name, in_range) = args.single()?;
    ensure!(
        args.shard.state.is_none(),
        "--state: found no --sweep, expected one; the speed of this computer cannot be shared out"
    );
    let scene = scenes::load(name)?;
    let paths = Paths::of(args, name);
    paths.check(&scene)?;
    let options = options(args, in_range);
    sight::check(&scene, &options.view)?;
    let measured = measure(args, &scene, &options, &paths);
    let report = sight::explained(measured, &scene, &options.view)?;
    paths.write(&report)?;
    output::print_tables(json, args.wide, &report, || text::text(&report))
}

fn options(args: &ReportArgs, in_range: f64) -> BenchOptions {
    BenchOptions {
        photons: args.photons,
        in_range,
        maps: args.maps,
        seed: args.seed,
        view: ViewOptions {
            width: args.size.width,
            height: args.size.height,
            samples_per_axis: 1,
            seed: args.seed,
        },
    }
}

/// The view of the picture of the page, for which the machines' time is forecast.
fn picture_view(args: &ReportArgs) -> ViewOptions {
    ViewOptions {
        width: args.picture_size.width,
        height: args.picture_size.height,
        samples_per_axis: 1,
        seed: args.seed,
    }
}

fn measure(
    args: &ReportArgs,
    scene: &Scene,
    options: &BenchOptions,
    paths: &Paths,
) -> Result<Report> {
    let formats = PHOTON_FORMATS.iter().map(Engine::from);
    let engines: Vec<_> = formats.chain(MACHINES.iter().map(Engine::from)).collect();
    let cores = cores::measured()?;
    let bar = progress::bar(
        "measuring formats",
        args.maps + (engines.len() + cores.len()) as u64,
    );
    let bench = ErrorBench::traced(scene, options, &|maps| bar.set_position(maps))?;
    // This measurement has no error of its own: if it fails, the scene is the cause and not a format.
    let reference = bench.measure(Engine::F64)?;
    let picture = view_queries(scene, &picture_view(args))?;
    let mut rows = Vec::new();
    for engine in engines {
        rows.push(row::row(&bench, engine, args.noise_ratio, &picture)?);
        bar.inc(1);
    }
    for core in &cores {
        rows.push(row::core_row(&bench, core, args.noise_ratio, &picture)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let speeds = speed::measure(&bench, &mut rows)?;
    pictures::mark_fronts(&mut rows);
    let verdict = Verdict::of(rows.iter().map(Row::candidate));
    let about = page::About {
        args,
        scene,
        bench: &bench,
        rows: &rows,
        verdict: &verdict,
        noise: reference.noise_relative,
    };
    let page_text = about.text()?;
    let estimates = reference.estimates_compared + reference.estimates_too_noisy;
    let queries = bench.queries().len() as u64;
    Ok(Report {
        scene: args.scenes[0].to_string(),
        seed: args.seed,
        maps: args.maps,
        photons: args.photons,
        in_range: options.in_range,
        query_points: picture.len() as u64,
        noise_relative: reference.noise_relative,
        noise_ratio: args.noise_ratio,
        scene_needs: verdict,
        rows,
        estimators: estimators::measure(&bench, options.in_range),
        speeds,
        dimensions: dimensions::rows()?,
        speed_plot: paths.speed.display().to_string(),
        bits_plot: paths.bits.display().to_string(),
        hardware_plot: paths.hardware.display().to_string(),
        dimensions_plot: paths.dimensions.display().to_string(),
        page: paths.page.display().to_string(),
        page_text,
        facts: Facts {
            scene_name: scene.name().to_owned(),
            estimates,
            estimates_too_noisy: reference.estimates_too_noisy,
            photons_found: bench.maps()[0].photons().len(),
            photons_in_range_mean: reference.photons_in_range as f64 / (queries * args.maps) as f64,
        },
    })
}

/// The paths of the files that are written.
struct Paths {
    speed: PathBuf,
    bits: PathBuf,
    hardware: PathBuf,
    dimensions: PathBuf,
    page: PathBuf,
    data: PathBuf,
}

impl Paths {
    fn of(args: &ReportArgs, scene: &SceneName) -> Self {
        let name = scenes::stem(scene);
        let file = |what: &str| args.out.join(format!("report-{name}{what}"));
        Self {
            speed: file("-speed.svg"),
            bits: file("-bits.svg"),
            hardware: file("-hardware.svg"),
            dimensions: file("-dimensions.svg"),
            page: file(".html"),
            data: file(".json"),
        }
    }

    fn check(&self, scene: &Scene) -> Result<()> {
        let paths = [
            &self.speed,
            &self.bits,
            &self.hardware,
            &self.dimensions,
            &self.page,
            &self.data,
        ];
        let outputs = paths.map(|path| Output::within("--out", path.clone()));
        outputs::check(&outputs, scene.files())
    }

    fn write(&self, report: &Report) -> Result<()> {
        let plots = [
            (&self.speed, pictures::SPEED.draw(report)?),
            (&self.bits, pictures::BITS.draw(report)?),
            (&self.hardware, pictures::HARDWARE.draw(report)?),
            (&self.dimensions, dimensions::plot(&report.dimensions)?),
            (&self.page, report.page_text.clone()),
            (&self.data, serde_json::to_string_pretty(report)? + "\n"),
        ];
        let files = plots.iter();
        files::write_all(files.map(|(path, text)| ((*path).clone(), text.as_bytes())))
    }
}
