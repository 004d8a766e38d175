//! The figures of a format or a machine.

use anyhow::Result;
use photoncube_render::{BenchError, Engine, ErrorBench, ErrorReport, Measurement, QueryPoint};
use photoncube_spec::PhotonFormat;
use serde::Serialize;

use crate::hardware::PictureTime;
use crate::measured::{Area, Measured};
use crate::plots::{Kind, Point};

/// A row of the table.
#[derive(Serialize)]
pub struct Row {
    /// A format's or a machine's name.
    pub name: String,
    /// Whether it is a format or a machine. A format alone has no clocks and no area.
    pub kind: &'static str,
    /// The machine's photon format; null for plain numbers.
    pub format: Option<String>,
    /// Bits of a stored photon.
    pub bits_per_photon: u32,
    /// The reason why it cannot represent the scene; null where it can.
    pub cannot: Option<String>,
    /// Whether the measured error is within the bound.
    pub within_bound: bool,
    /// The figures of the hardware; empty for a format.
    #[serde(flatten)]
    pub hardware: Hardware,
    /// The speed of the golden model on this computer, one thread. Only for a format, because a machine's
    /// model is that of its format.
    pub photon_tests_per_second: Option<f64>,
    /// The spread of that speed between repeats.
    pub photon_tests_per_second_spread: Option<f64>,
    pub on_speed_front: bool,
    pub on_bits_front: bool,
    pub on_hardware_front: bool,
    /// The error of the worst of luminance and channels, which is what `fit` bounds.
    pub measurement: Option<Measurement>,
    /// The error of luminance.
    #[serde(flatten)]
    pub error: Option<ErrorReport>,
}

/// The figures that only machines have.
#[derive(Default, Serialize)]
pub struct Hardware {
    pub initiation_interval: Option<f64>,
    pub photon_tests_per_clock: Option<f64>,
    pub area_without_dsp: Option<Area>,
    pub photon_tests_per_second_at_fmax: Option<f64>,
    #[serde(flatten)]
    pub time: PictureTime,
}

impl Row {
    /// The error that is compared with the bound.
    pub fn error_over_noise(&self) -> Option<f64> {
        Some(self.measurement?.error_over_noise)
    }

    /// The row in a plot of a figure against the error; `None` where the error was not measured.
    pub fn point(&self, figure: f64) -> Option<Point> {
        let measurement = self.measurement?;
        Some(Point {
            label: self.name.clone(),
            kind: match self.is_format() {
                true => Kind::Format,
                false => Kind::Machine,
            },
            error: measurement.error_over_noise,
            interval: [
                measurement.error_over_noise_low,
                measurement.error_over_noise_high,
            ],
            figure,
            holds: self.within_bound,
        })
    }

    /// LUT4 equivalents without DSP blocks.
    pub fn lut4_equivalents(&self) -> Option<u64> {
        let area = self.hardware.area_without_dsp.as_ref()?;
        Some(area.lut4_equivalents)
    }

    /// The speed at the machine's measured clock.
    pub fn pictures_per_second(&self) -> Option<f64> {
        self.hardware.time.pictures_per_second
    }

    /// Whether the row is a format alone.
    pub fn is_format(&self) -> bool {
        self.kind == "format"
    }
}

/// Measures the row of a format or a machine. A row that cannot represent the scene states the reason.
///
/// `picture` has the queries of the picture whose time is forecast.
pub fn row(
    bench: &ErrorBench,
    engine: Engine<'_>,
    bound: f64,
    picture: &[QueryPoint],
) -> Result<Row> {
    let measured = bench.measure_light(engine);
    let (measurement, error, cannot) = match &measured {
        Ok(report) => (
            Some(Measurement::of(report)),
            Some(*report.luminance()),
            None,
        ),
        Err(error) => (None, None, Some(reason(error))),
    };
    let (name, kind, format, bits_per_photon) = match engine {
        Engine::F64 => ("f64".to_owned(), "reference", None, 0),
        Engine::Integers(numbers, machine) => {
            let format = numbers.format().map(PhotonFormat::name);
            let (name, kind) = match machine {
                Some(machine) => (machine.name.to_owned(), "machine"),
                None => (
                    format.clone().unwrap_or_else(|| numbers.to_string()),
                    "format",
                ),
            };
            (name, kind, format, numbers.bits_per_photon())
        }
        Engine::Hardware(machine, _) => (
            machine.name.to_owned(),
            "machine",
            machine.format().map(PhotonFormat::name),
            machine.bits_per_photon(),
        ),
    };
    Ok(Row {
        name,
        kind,
        format,
        bits_per_photon,
        cannot,
        within_bound: measurement.is_some_and(|m| m.error_over_noise <= bound),
        hardware: hardware(bench, engine, picture, measured.is_ok())?,
        photon_tests_per_second: None,
        photon_tests_per_second_spread: None,
        on_speed_front: false,
        on_bits_front: false,
        on_hardware_front: false,
        measurement,
        error,
    })
}

/// The innermost cause of an error: that of the golden model, without the pixel or the map.
pub fn reason(error: &BenchError) -> String {
    let mut cause: &dyn std::error::Error = error;
    while let Some(deeper) = cause.source() {
        cause = deeper;
    }
    cause.to_string()
}

fn hardware(
    bench: &ErrorBench,
    engine: Engine<'_>,
    picture: &[QueryPoint],
    takes_scene: bool,
) -> Result<Hardware> {
    let Engine::Integers(_, Some(machine)) = engine else {
        return Ok(Hardware::default());
    };
    let rate = machine.photon_tests_per_clock();
    let measured = Measured::of(machine)?;
    let fmax_mhz = measured.fastest().map(|clock| clock.fmax_mhz);
    let time = match takes_scene {
        true => PictureTime::of(machine, &bench.maps()[0], picture)?,
        false => PictureTime::default(),
    };
    Ok(Hardware {
        initiation_interval: Some(machine.rate().interval()),
        photon_tests_per_clock: Some(rate),
        area_without_dsp: measured.area_without_dsp,
        photon_tests_per_second_at_fmax: fmax_mhz.map(|fmax| rate * fmax * 1e6),
        time,
    })
}
