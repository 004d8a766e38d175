//! The arguments of `render`, and those that it shares.

use std::path::PathBuf;

use anyhow::Result;
use clap::{Args as ClapArgs, ValueEnum};
use photoncube_driver::Driver;
use photoncube_hdl::Ulx3s;
use photoncube_render::{Area, Caustics, DirectLight, Engine, Estimator, Lighting};
use photoncube_spec::{Core, PHOTON_FORMATS, PhotonFormat, find_photon_format};
use serde::Serialize;

use super::PictureArgs;
use super::numbers::count;
use crate::core::{self, CoreReport, Way};
use crate::machines::MachineArgs;
use crate::scenes::SceneName;

/// `render`
#[derive(ClapArgs, Debug)]
#[command(after_help = "\
Examples:
  photoncube render cornell -o box.png
  photoncube render cornell -o reference.exr --engine f64 --photons 4000000
  photoncube render cornell -o small.png --size 128x128 --machine paper-12
  photoncube render range -o range.png --engine format --format local8-rgb8e5
  photoncube render ring -o ring.png --engine format --estimator knn:50
  photoncube render cornell -o smooth.png --engine f64 --estimator epanechnikov
  photoncube render cornell -o ladder.png --estimator ladder:4:cone
  photoncube render cornell -o core.png --engine core --machine leaf-7-local7-rgb6d-n4096
  photoncube render cornell -o core.png --engine core --port /dev/ttyUSB0 \\
      --machine leaf-5-local7-rgb6d-n64 --chains 3
  photoncube render ring -o sharp.png --engine format --direct rays:4 --caustics own \\
      --final-gather 16

Estimators:
  fixed                    all photons within the search radius count the same
  knn:K                    the radius is that of the K-th nearest photon, at most the search radius;
                           `model` and `format` find it by bisection, some 15 gathers a query
  cone, epanechnikov       kernels that fall with the distance; only `f64` has them
  ladder:RUNGS[:KERNEL]    such a kernel (epanechnikov unless named) as a mixture of discs, which
                           every engine can gather, one gather for each

A picture ends in .png (8 bits, sRGB) or .exr (linear, to compute with: see `photoncube compare`).")]
pub struct RenderArgs {
    /// A built-in scene (see `photoncube list`) or a scene file, TOML (see docs/scenes.md) or JSON
    pub scene: SceneName,
    /// The picture, a PNG or OpenEXR file
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    #[command(flatten)]
    pub engine: EngineArgs,
    /// The form of the estimate: fixed, knn:K, cone, epanechnikov or `ladder:RUNGS[:KERNEL]`, see below
    #[arg(long, default_value_t = Estimator::FixedRadius, value_name = "E")]
    pub estimator: Estimator,
    #[command(flatten)]
    pub light: LightArgs,
    #[command(flatten)]
    pub picture: PictureArgs,
}

/// Which engine.
#[derive(ClapArgs, Clone, Debug)]
pub struct EngineArgs {
    /// What makes the radiance estimates
    #[arg(long, value_enum, default_value_t = EngineName::Model)]
    pub engine: EngineName,
    /// The photon format (see `photoncube list`) of the engine `format`
    #[arg(long, default_value_t = PHOTON_FORMATS[0].name(), value_name = "F")]
    pub format: String,
    #[command(flatten)]
    pub machine: MachineArgs,
    /// The chains of the engine `core`, each a machine
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub chains: u32,
    /// Of the engine `core`: the serial port of a board that has the core, in the place of a simulation
    #[arg(long, value_name = "PORT")]
    pub port: Option<String>,
    /// Bits a second on that port, as its bitstream was made for
    #[arg(long, default_value_t = Ulx3s::BAUD, value_name = "N", requires = "port")]
    pub baud: u32,
}

/// What makes the radiance estimates.
#[derive(Copy, Clone, Debug, PartialEq, Eq, ValueEnum)]
pub enum EngineName {
    /// The reference, in f64
    F64,
    /// The golden model of the machine
    Model,
    /// The golden model of a photon format
    Format,
    /// The emitted Verilog of a core of leaf machines, simulated in Verilator or, with --port, on a board
    Core,
}

impl EngineArgs {
    /// The engine asked for. A machine or a format that does not exist is an error, also where it is not used.
    pub fn find(&self) -> Result<ChosenEngine> {
        let machine = self.machine.find()?;
        let format = find_photon_format(&self.format)?;
        Ok(match self.engine {
            EngineName::F64 => ChosenEngine::Own(Engine::F64),
            EngineName::Model => ChosenEngine::Own(machine.into()),
            EngineName::Format => ChosenEngine::Own((&format).into()),
            EngineName::Core => {
                let core = Core::new(machine, self.chains)?;
                let driver = match &self.port {
                    None => core::driver(&core)?,
                    Some(port) => core::driver_on_board(&core, port, self.baud)?,
                };
                ChosenEngine::Core(core, Box::new(driver))
            }
        })
    }
}

/// An engine, with the way to a core where it is one.
pub enum ChosenEngine {
    /// An engine of the renderer.
    Own(Engine<'static>),
    /// A core, and the way to it.
    Core(Core, Box<Driver<Way>>),
}

impl ChosenEngine {
    /// The engine for the renderer.
    pub fn engine(&self) -> Engine<'_> {
        match self {
            Self::Own(engine) => *engine,
            Self::Core(core, driver) => Engine::Hardware(core.machine, &**driver),
        }
    }

    /// The work of the core so far for that many estimates, if it is one.
    pub fn core_report(&self, estimates: u64) -> Option<CoreReport> {
        match self {
            Self::Own(_) => None,
            Self::Core(core, driver) => Some(CoreReport::of(core, &driver.work(), estimates)),
        }
    }
}

/// An engine in reports.
#[derive(Debug, Serialize)]
pub struct EngineReport {
    engine: &'static str,
    machine: Option<String>,
    format: Option<String>,
}

impl EngineReport {
    /// The engine as reports have it.
    pub fn of(engine: Engine<'_>) -> Self {
        let (engine, machine, format) = match engine {
            Engine::F64 => ("f64", None, None),
            Engine::Hardware(machine, _) => ("core", Some(machine.name.to_owned()), None),
            Engine::Integers(_, Some(machine)) => ("model", Some(machine.name.to_owned()), None),
            Engine::Integers(numbers, None) => {
                ("format", None, numbers.format().map(PhotonFormat::name))
            }
        };
        Self {
            engine,
            machine,
            format,
        }
    }
}

/// A lighting in reports.
#[derive(Debug, Serialize)]
pub struct LightingReport {
    direct: String,
    caustics: String,
    final_gather: u32,
    area: String,
}

impl LightingReport {
    /// That of a lighting.
    pub fn of(lighting: &Lighting) -> Self {
        Self {
            direct: lighting.direct.to_string(),
            caustics: lighting.caustics.to_string(),
            final_gather: lighting.final_gather,
            area: lighting.area.to_string(),
        }
    }

    /// The source of direct light, as on the command line.
    pub fn direct(&self) -> &str {
        &self.direct
    }
}

/// Where the light of a picture comes from.
#[derive(ClapArgs, Copy, Clone, Debug)]
pub struct LightArgs {
    /// Direct light from the photon `map`, or by N shadow rays to each light: `rays[:N]` [default: `map` in `render`; in
    /// `progressive` by as many rays as the pilot chooses]
    #[arg(long, value_name = "D")]
    pub direct: Option<DirectLight>,
    /// Caustics from the one photon `map`, or from one of their own with N photons in range: `own[:N]` [default: `map` in
    /// `render`, `own` in `progressive`]
    #[arg(long, value_name = "C")]
    pub caustics: Option<Caustics>,
    /// Rays of a final gather from each query point; 0 for none. In `progressive` it takes more time than none, but for very small errors
    #[arg(long, default_value_t = 0, value_name = "N", value_parser = count(0..=65_536_u32))]
    pub final_gather: u32,
    /// What sums of power are divided by: the `disc`, or what it covers of surfaces, `covered` [default: `disc` in `render`,
    /// `covered` in `progressive`]
    #[arg(long, value_name = "A")]
    pub area: Option<Area>,
}

impl LightArgs {
    /// The lighting as the crate `photoncube-render` takes it. What is not given is that of `default`.
    pub fn lighting(&self, default: &Lighting) -> Lighting {
        Lighting {
            direct: self.direct.unwrap_or(default.direct),
            caustics: self.caustics.unwrap_or(default.caustics),
            final_gather: self.final_gather,
            area: self.area.unwrap_or(default.area),
        }
    }
}
