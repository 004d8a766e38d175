//! `report`: speed against error, formats and machines side by side.

mod dimensions;
mod estimators;

use anyhow::Result;
use photoncube_render::{
    BenchOptions, Engine, ErrorBench, ErrorReport, MAX_QUERY_NOISE, ViewOptions, f32_speed,
    gather_speed,
};
use photoncube_spec::{FormatWidths, MACHINES, PHOTON_FORMATS, PhotonFormat};
use serde::Serialize;

use crate::args::ReportArgs;
use crate::measured::{Area, Measured};
use crate::outputs::{self, Output};
use crate::plot::{Better, Plot, Point, against_error, pareto_front};
use crate::{files, output, progress, scenes, table};

#[derive(Serialize)]
struct Report {
    scene: String,
    seed: u64,
    maps: u64,
    photons: u64,
    noise_relative: f64,
    rows: Vec<Row>,
    estimators: Vec<estimators::Row>,
    f64_photon_tests_per_second: f64,
    f32_photon_tests_per_second: f64,
    dimensions: Vec<dimensions::Row>,
    speed_plot: String,
    bits_plot: String,
    hardware_plot: String,
    dimensions_plot: String,
}

#[derive(Serialize)]
struct Row {
    /// A format's or a machine's name.
    name: String,
    /// A format by itself has no clocks and no area.
    kind: &'static str,
    /// The machine's photon format; null in the paper's plain numbers.
    format: Option<String>,
    bits_per_photon: u32,
    initiation_interval: Option<f64>,
    photon_tests_per_clock: Option<f64>,
    area_without_dsp: Option<Area>,
    fmax_mhz: Option<f64>,
    speed_grade: Option<u32>,
    photon_tests_per_second_at_fmax: Option<f64>,
    photon_tests_per_second: f64,
    on_speed_front: bool,
    on_bits_front: bool,
    #[serde(flatten)]
    error: ErrorReport,
}

/// Measures every format and machine on a scene.
pub fn execute(args: &ReportArgs, json: bool) -> Result<()> {
    let scene = scenes::load(&args.scene)?;
    let name = scenes::stem(&args.scene);
    let file = |what: &str| args.out.join(format!("report-{name}{what}"));
    let (speed_path, bits_path) = (file("-speed.svg"), file("-bits.svg"));
    let (hardware_path, dimensions_path) = (file("-hardware.svg"), file("-dimensions.svg"));
    let data_path = file(".json");
    let paths = [
        &speed_path,
        &bits_path,
        &hardware_path,
        &dimensions_path,
        &data_path,
    ];
    let outputs = paths.map(|path| Output::within("--out", path.clone()));
    outputs::check(&outputs, scene.files())?;
    let formats = PHOTON_FORMATS.iter().map(Engine::Format);
    let engines: Vec<_> = formats.chain(MACHINES.iter().map(Engine::Model)).collect();
    let options = BenchOptions {
        photons: args.photons,
        in_range: args.in_range,
        maps: args.maps,
        seed: args.seed,
        view: ViewOptions {
            width: args.size.width,
            height: args.size.height,
            samples_per_axis: 1,
            seed: args.seed,
        },
    };
    let bar = progress::bar("measuring formats", engines.len() as u64 + 1);
    let bench = ErrorBench::new(&scene, &options)?;
    let mut rows = Vec::new();
    for engine in engines {
        bar.inc(1);
        rows.push(row(&bench, engine)?);
    }
    bar.finish_and_clear();
    mark_fronts(&mut rows);

    let (map, queries) = (&bench.maps()[0], bench.queries());
    let report = Report {
        scene: args.scene.clone(),
        seed: args.seed,
        maps: args.maps,
        photons: args.photons,
        noise_relative: rows[0].error.noise_relative,
        rows,
        estimators: estimators::measure(&bench, args.in_range)?,
        f64_photon_tests_per_second: gather_speed(map, queries, Engine::F64)?,
        f32_photon_tests_per_second: f32_speed(map, queries),
        dimensions: dimensions::rows()?,
        speed_plot: speed_path.display().to_string(),
        bits_plot: bits_path.display().to_string(),
        hardware_plot: hardware_path.display().to_string(),
        dimensions_plot: dimensions_path.display().to_string(),
    };
    files::write(&speed_path, SPEED.draw(&report)?.as_bytes())?;
    files::write(&bits_path, BITS.draw(&report)?.as_bytes())?;
    files::write(&hardware_path, HARDWARE.draw(&report)?.as_bytes())?;
    let plot = dimensions::plot(&report.dimensions)?;
    files::write(&dimensions_path, plot.as_bytes())?;
    let data = serde_json::to_string_pretty(&report)? + "\n";
    files::write(&data_path, data.as_bytes())?;
    output::print(json, &report, || text(&report))
}

fn mark_fronts(rows: &mut [Row]) {
    let (speed, bits) = (SPEED.front(rows), BITS.front(rows));
    for ((row, on_speed_front), on_bits_front) in rows.iter_mut().zip(speed).zip(bits) {
        (row.on_speed_front, row.on_bits_front) = (on_speed_front, on_bits_front);
    }
}

fn row(bench: &ErrorBench, engine: Engine<'static>) -> Result<Row> {
    let error = bench.measure(engine)?;
    let photon_tests_per_second = gather_speed(&bench.maps()[0], bench.queries(), engine)?;
    let unmeasured = |name, kind, format: Option<&PhotonFormat>, bits_per_photon| Row {
        name,
        kind,
        format: format.map(PhotonFormat::name),
        bits_per_photon,
        initiation_interval: None,
        photon_tests_per_clock: None,
        area_without_dsp: None,
        fmax_mhz: None,
        speed_grade: None,
        photon_tests_per_second_at_fmax: None,
        photon_tests_per_second,
        on_speed_front: false,
        on_bits_front: false,
        error,
    };
    Ok(match engine {
        Engine::F64 => unmeasured("f64".to_owned(), "reference", None, 0),
        Engine::Format(format) => {
            let bits = FormatWidths::of(format).bits_per_photon;
            unmeasured(format.name(), "format", Some(format), bits)
        }
        Engine::Model(machine) => {
            let measured = Measured::of(machine)?;
            let rate = machine.photon_tests_per_clock();
            let clock = measured.fastest();
            let fmax_mhz = clock.map(|clock| clock.fmax_mhz);
            let speed_grade = clock.map(|clock| clock.speed_grade);
            Row {
                initiation_interval: Some(machine.rate().interval()),
                photon_tests_per_clock: Some(rate),
                area_without_dsp: measured.area_without_dsp,
                fmax_mhz,
                speed_grade,
                photon_tests_per_second_at_fmax: fmax_mhz.map(|fmax| rate * fmax * 1e6),
                ..unmeasured(
                    machine.name.to_owned(),
                    "machine",
                    machine.format(),
                    machine.bits_per_photon(),
                )
            }
        }
    })
}

/// A figure that is held against the error.
struct Merit {
    name: &'static str,
    axis: &'static str,
    better: Better,
    of: fn(&Row) -> Option<f64>,
}

const SPEED: Merit = Merit {
    name: "speed",
    axis: "golden model, M photon tests per second, one thread",
    better: Better::Larger,
    of: |row| Some(row.photon_tests_per_second / 1e6),
};

const HARDWARE: Merit = Merit {
    name: "hardware speed",
    axis: "G photon tests per second at the routed Fmax",
    better: Better::Larger,
    of: |row| Some(row.photon_tests_per_second_at_fmax? / 1e9),
};

const BITS: Merit = Merit {
    name: "bits per photon",
    axis: "bits per photon",
    better: Better::Smaller,
    of: |row| Some(f64::from(row.bits_per_photon)),
};

impl Merit {
    fn points(&self, rows: &[Row]) -> Vec<Point> {
        let point = |row: &Row| {
            Some(Point {
                label: row.name.clone(),
                error: row.error.error_over_noise,
                figure: (self.of)(row)?,
            })
        };
        rows.iter().filter_map(point).collect()
    }

    fn front(&self, rows: &[Row]) -> Vec<bool> {
        pareto_front(&self.points(rows), self.better)
    }

    fn draw(&self, report: &Report) -> Result<String> {
        let plot = Plot {
            title: &format!("{}: {} against error", report.scene, self.name),
            error_axis: "rms error over the scene's noise",
            figure_axis: self.axis,
            better: self.better,
        };
        against_error(&plot, &self.points(&report.rows))
    }
}

/// The row's machine, if it is one's.
fn machine_of(row: &Row) -> &str {
    match row.kind {
        "machine" => &row.name,
        _ => "-",
    }
}

fn text(report: &Report) -> String {
    let header = [
        "machine",
        "format",
        "bits/photon",
        "clocks",
        "tests/clock",
        "LUT4 + CCU2C",
        "Fmax",
        "M tests/s at Fmax",
        "rms error",
        "p99",
        "error/noise",
        "bias",
        "misclassified",
        "model, M tests/s",
        "best in",
    ];
    let percent = |value: f64| format!("{:.3} %", 100.0 * value);
    let unknown = || "-".to_owned();
    let row = |row: &Row| {
        vec![
            machine_of(row).to_owned(),
            row.format.clone().unwrap_or_else(|| "plain".to_owned()),
            row.bits_per_photon.to_string(),
            row.initiation_interval
                .map_or_else(unknown, |clocks| clocks.to_string()),
            row.photon_tests_per_clock
                .map_or_else(unknown, |rate| format!("{rate:.3}")),
            row.area_without_dsp
                .as_ref()
                .map_or_else(unknown, |area| format!("{} + {}", area.lut4, area.ccu2c)),
            row.fmax_mhz
                .zip(row.speed_grade)
                .map_or_else(unknown, |(fmax, grade)| format!("{fmax:.0} MHz (-{grade})")),
            row.photon_tests_per_second_at_fmax
                .map_or_else(unknown, |speed| format!("{:.1}", speed / 1e6)),
            percent(row.error.rms_relative_error),
            percent(row.error.p99_relative_error),
            format!("{:.4}", row.error.error_over_noise),
            format!("{:+.4} %", 100.0 * row.error.bias_relative),
            format!("{:.3} %", row.error.misclassified_percent),
            format!("{:.0}", row.photon_tests_per_second / 1e6),
            best_in(row).to_owned(),
        ]
    };
    let rows: Vec<_> = report.rows.iter().map(row).collect();
    format!(
        "{}: noise {} rms over {} maps of {} photons; {} of {} estimates left out, their queries\n\
         noisier than {}\n\n{}\n\
         f64 loop {:.0} M photon tests/s, f32 loop {:.0}; `-`: a format by itself\n\
         plots: {}, {}, {}\n\n{}\n\
         Tiles of every dimension, plot {}:\n\n{}",
        report.scene,
        percent(report.noise_relative),
        report.maps,
        report.photons,
        report.rows[0].error.estimates_too_noisy,
        report.rows[0].error.estimates_too_noisy + report.rows[0].error.estimates_compared,
        percent(MAX_QUERY_NOISE),
        table::markdown(&header, &rows),
        report.f64_photon_tests_per_second / 1e6,
        report.f32_photon_tests_per_second / 1e6,
        report.speed_plot,
        report.bits_plot,
        report.hardware_plot,
        estimators::text(&report.estimators),
        report.dimensions_plot,
        dimensions::text(&report.dimensions),
    )
}

/// The Pareto fronts that a row is on.
fn best_in(row: &Row) -> &'static str {
    match (row.on_bits_front, row.on_speed_front) {
        (true, true) => "bits, speed",
        (true, false) => "bits",
        (false, true) => "speed",
        (false, false) => "",
    }
}
