//! The figures of a format or a machine.

use anyhow::Result;
use fpga_flow::Figure;
use photoncube_render::{BenchError, Engine, ErrorBench, ErrorReport, Measurement, QueryPoint};
use photoncube_spec::PhotonFormat;
use serde::Serialize;

use super::verdict::Candidate;
use crate::cores::MeasuredCore;
use crate::hardware::PictureTime;
use crate::measured::{Area, Measured};
use crate::plots::{Kind, Point};

/// A row of the table.
#[derive(Serialize)]
pub struct Row {
    /// A format's or a machine's name.
    pub name: String,
    /// Whether it is a format, a machine or a core. A format alone has no clocks and no area.
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
    /// The slowest repeat.
    pub photon_tests_per_second_low: Option<f64>,
    /// The fastest repeat.
    pub photon_tests_per_second_high: Option<f64>,
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
    /// The LUT4 equivalents of a core, whose squarers are DSP blocks too.
    pub lut4_equivalents_with_dsp: Option<u64>,
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
            label: self.label(),
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
            figure_range: None,
            holds: self.within_bound,
        })
    }

    /// The name in a plot. That of a core would take half of its width, so it ends before the format of its photons.
    fn label(&self) -> String {
        let name = self.name.as_str();
        let short = match &self.format {
            Some(format) if self.is_core() => name.strip_suffix(&format!("-{format}")),
            _ => None,
        };
        short.unwrap_or(name).to_owned()
    }

    /// LUT4 equivalents without DSP blocks; a core is measured with them only.
    pub fn lut4_equivalents(&self) -> Option<u64> {
        let area = self.hardware.area_without_dsp.as_ref()?;
        Some(area.lut4_equivalents)
    }

    /// The speed at the machine's measured clock.
    pub fn pictures_per_second(&self) -> Option<f64> {
        self.hardware.time.pictures_per_second
    }

    /// The row as the verdict takes it.
    pub fn candidate(&self) -> Candidate<'_> {
        Candidate {
            name: &self.name,
            format: self.format.as_deref(),
            bits_per_photon: self.bits_per_photon,
            is_format: self.is_format(),
            within_bound: self.within_bound,
            lut4_equivalents: self.lut4_equivalents(),
            pictures_per_second: self.pictures_per_second(),
        }
    }

    /// Whether the row is a core of several chains.
    pub fn is_core(&self) -> bool {
        self.kind == "core"
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
    let mut row = Row {
        format,
        bits_per_photon,
        ..measured(bench, engine, bound, name, kind)
    };
    row.hardware = hardware(bench, engine, picture, row.cannot.is_none())?;
    Ok(row)
}

/// Measures the row of a core, by the golden model of its format.
///
/// `picture` has the queries of the picture whose time is forecast.
pub fn core_row(
    bench: &ErrorBench,
    measured_core: &MeasuredCore,
    bound: f64,
    picture: &[QueryPoint],
) -> Result<Row> {
    let (core, clock) = (&measured_core.core, &measured_core.clock);
    let numbers = measured_core.numbers_of_picture();
    let mut row = Row {
        format: core.machine.format().map(PhotonFormat::name),
        bits_per_photon: core.machine.bits_per_photon(),
        ..measured(bench, Engine::from(&numbers), bound, core.name(), "core")
    };
    let rate = measured_core.photon_tests_per_clock();
    row.hardware = Hardware {
        initiation_interval: Some(core.machine.rate().interval()),
        photon_tests_per_clock: Some(rate),
        area_without_dsp: None,
        lut4_equivalents_with_dsp: measured_core
            .area
            .figures
            .get(&Figure::Lut4Equivalents)
            .copied(),
        photon_tests_per_second_at_fmax: Some(rate * clock.fmax_mhz * 1e6),
        time: match row.cannot {
            None => measured_core.time(&bench.maps()[0], picture)?,
            Some(_) => PictureTime::default(),
        },
    };
    Ok(row)
}

/// A row with the error that is measured, and with nothing else.
fn measured(
    bench: &ErrorBench,
    engine: Engine<'_>,
    bound: f64,
    name: String,
    kind: &'static str,
) -> Row {
    let (measurement, error, cannot) = match &bench.measure_light(engine) {
        Ok(report) => (
            Some(Measurement::of(report)),
            Some(*report.luminance()),
            None,
        ),
        Err(error) => (None, None, Some(reason(error))),
    };
    Row {
        name,
        kind,
        format: None,
        bits_per_photon: 0,
        cannot,
        within_bound: measurement.is_some_and(|m| m.error_over_noise <= bound),
        hardware: Hardware::default(),
        photon_tests_per_second: None,
        photon_tests_per_second_spread: None,
        photon_tests_per_second_low: None,
        photon_tests_per_second_high: None,
        on_speed_front: false,
        on_bits_front: false,
        on_hardware_front: false,
        measurement,
        error,
    }
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
        lut4_equivalents_with_dsp: None,
        photon_tests_per_second_at_fmax: fmax_mhz.map(|fmax| rate * fmax * 1e6),
        time,
    })
}
