//! Options that several methods have.

use std::str::FromStr;

use clap::Args;
use photoncube_testbench::{DeviceKind, Source, Tool, UnknownDevice, VerifyOptions};

use crate::args::{count, seed};

/// A value of `--against`.
#[derive(Clone, Debug)]
pub enum Devices {
    /// The one that compares fastest.
    Fastest,
    /// Every one.
    All,
    /// The one of that name.
    Named(DeviceKind),
}

impl FromStr for Devices {
    type Err = UnknownDevice;

    fn from_str(name: &str) -> Result<Self, UnknownDevice> {
        Ok(match name {
            "all" => Self::All,
            "fastest" => Self::Fastest,
            name => Self::Named(DeviceKind::from_name(name)?),
        })
    }
}

/// The help of `--against`.
pub const AGAINST: &str = "What to compare the golden model with: rust-hdl, text, icarus, verilator, netlist; \
    comma-separated, or all; fastest is verilator, or text where that is missing";

/// The devices of `--against`, each once, in the given order.
pub fn devices(against: &[Devices]) -> Vec<DeviceKind> {
    devices_where(against, DeviceKind::fastest())
}

/// The devices of `--against` where `fastest` compares fastest, each once, in the given order.
pub fn devices_where(against: &[Devices], fastest: DeviceKind) -> Vec<DeviceKind> {
    let mut devices = Vec::new();
    for named in against {
        let named: &[DeviceKind] = match named {
            Devices::Fastest => &[fastest],
            Devices::All => &DeviceKind::ALL,
            Devices::Named(device) => &[*device],
        };
        for &device in named {
            if !devices.contains(&device) {
                devices.push(device);
            }
        }
    }
    devices
}

/// The tools of the devices of `--against`.
pub fn tools(against: &[Devices]) -> Vec<Tool> {
    let devices = devices(against).into_iter();
    devices.flat_map(DeviceKind::tools).copied().collect()
}

/// The length and the seed of random stimulus.
#[derive(Args, Clone, Debug)]
pub struct StimulusArgs {
    /// At least so many iterations (groups of photons) to compare in each device; a batch that began is ended
    #[arg(long, default_value_t = 20_000, value_name = "N", value_parser = count(1..=u64::MAX))]
    pub iterations: u64,
    #[command(flatten)]
    pub seed: SeedArgs,
}

/// The seed of a method.
#[derive(Args, Copy, Clone, Debug)]
pub struct SeedArgs {
    /// Seed of all random numbers
    #[arg(long, default_value_t = 1, value_name = "S", value_parser = seed)]
    pub seed: u64,
}

impl StimulusArgs {
    /// Random stimulus.
    pub fn random(&self) -> VerifyOptions<'static> {
        VerifyOptions {
            iterations: self.iterations,
            seed: self.seed.seed,
            source: Source::Random,
        }
    }
}
