//! External faults, by class: waiting streams, resets, unknown words on idle pins, power-up without reset.
//!
//! A machine has no clock enable. The streams' valid and ready replace it, so patterns of valid and ready
//! replace the patterns of an enable.

mod difference;
mod idle;
mod planted;
mod power_up;

use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{Machine, Pins};
use serde::Serialize;

use crate::device::{Device, DeviceError, DeviceKind, Icarus, hdl_error};
use crate::stimulus::{Protocol, Source};
use crate::verify::{Verdict, VerifyError, VerifyOptions, nothing_compared, verify_device};

pub use difference::UnknownDifference;
pub use planted::{FaultOfClass, PLANTED_FAULTS, fault_controls};
pub use power_up::without_initial_values;

/// A class of external faults.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FaultClass {
    /// Each side of each stream waits at random.
    Stalls,
    /// Each stream alone is withheld for many clocks.
    Holds,
    /// Streams move in regular patterns.
    Patterns,
    /// A reset in every clock of a query.
    Resets,
    /// Words are unknown while they are not valid, in 4-state.
    IdleUnknown,
    /// No reset at all, in 4-state: registers start as the text says.
    NoReset,
    /// No register has an initial value, in 4-state; then a reset.
    UnknownPowerUp,
}

impl FaultClass {
    /// All classes.
    pub const ALL: [Self; 7] = [
        Self::Stalls,
        Self::Holds,
        Self::Patterns,
        Self::Resets,
        Self::IdleUnknown,
        Self::NoReset,
        Self::UnknownPowerUp,
    ];

    /// The name of the class in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Stalls => "streams wait at random",
            Self::Holds => "a stream alone is withheld for long",
            Self::Patterns => "streams move in patterns",
            Self::Resets => "a reset in every clock of a query",
            Self::IdleUnknown => "X on idle inputs",
            Self::NoReset => "power-up without reset",
            Self::UnknownPowerUp => "power-up without initial values",
        }
    }

    /// The stimulus of the class.
    fn protocol(self) -> Protocol {
        match self {
            Self::Stalls => Protocol::Stalls,
            Self::Holds => Protocol::Holds,
            Self::Patterns => Protocol::Patterns,
            Self::Resets => Protocol::Resets,
            Self::NoReset => Protocol::NoReset,
            Self::IdleUnknown | Self::UnknownPowerUp => Protocol::FewStalls,
        }
    }

    /// Whether only a device with unknown values can show the fault.
    pub fn is_four_state(self) -> bool {
        matches!(
            self,
            Self::IdleUnknown | Self::NoReset | Self::UnknownPowerUp
        )
    }
}

/// A record of a verification of a machine under a class of faults.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FaultVerdict {
    /// The name of the machine.
    pub machine: &'static str,
    /// The name of the fault class.
    pub fault: &'static str,
    /// The name of the device.
    pub device: String,
    /// The tool behind the device, with its version.
    pub tool_version: String,
    /// The number of injected faults.
    pub injections: u64,
    /// A description of what `injections` counts, with further observations.
    pub injected: String,
    /// The number of results compared.
    pub results_compared: u64,
    /// The number of clocks. Every visible signal was compared in each.
    pub vectors_compared: u64,
    /// The number of signals in a vector.
    pub signals_per_vector: usize,
    /// For a power-up without initial values: the kinds of signals that are known one clock after the reset.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub known_after_reset: Vec<String>,
}

/// Verifies a machine under a class of faults, in the given device, or in Icarus where only unknown values
/// show the fault.
///
/// # Errors
/// The first difference; or the device or the stimulus fails.
pub fn verify_fault(
    machine: &Machine,
    class: FaultClass,
    kind: DeviceKind,
    seed: u64,
) -> Result<FaultVerdict, VerifyError> {
    let kind = match class.is_four_state() {
        true => DeviceKind::Icarus,
        false => kind,
    };
    if let Some(missing) = kind.missing_tool() {
        return Err(DeviceError::from(missing).into());
    }
    if kind == DeviceKind::RustHdl {
        let mut device = kind.open(machine, Level::Machine)?;
        return verify_pace(machine, class, device.as_mut(), seed);
    }
    let design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
    verify_fault_text(machine, class, kind, &design, seed)
}

/// Verifies an emitted text, which may differ from the machine's own, under a class of faults.
///
/// # Errors
/// The first difference; or the device or the stimulus fails.
///
/// # Panics
/// For rust-hdl, which simulates blocks and not text.
pub fn verify_fault_text(
    machine: &Machine,
    class: FaultClass,
    kind: DeviceKind,
    design: &Emitted,
    seed: u64,
) -> Result<FaultVerdict, VerifyError> {
    match class {
        FaultClass::IdleUnknown => idle::verify_idle(machine, design, seed),
        FaultClass::UnknownPowerUp => power_up::verify_power_up(machine, design, seed),
        FaultClass::NoReset => verify_pace(machine, class, &mut Icarus::new(design)?, seed),
        _ => verify_pace(machine, class, kind.open_text(design)?.as_mut(), seed),
    }
}

/// Verifies a class of faults that are in the stimulus alone.
fn verify_pace(
    machine: &Machine,
    class: FaultClass,
    device: &mut dyn Device,
    seed: u64,
) -> Result<FaultVerdict, VerifyError> {
    let options = VerifyOptions {
        iterations: u64::MAX,
        seed,
        source: Source::Protocol(class.protocol()),
    };
    let verdict = verify_device(machine, device, &options, &|_| ())?;
    let (injections, injected) = injected(machine, class, &verdict);
    if injections == 0 {
        return Err(nothing_compared(&verdict.device, 0, 0, 0));
    }
    Ok(FaultVerdict {
        machine: machine.name,
        fault: class.name(),
        device: verdict.device,
        tool_version: verdict.tool_version,
        injections,
        injected,
        results_compared: verdict.results_compared,
        vectors_compared: verdict.vectors_compared,
        signals_per_vector: verdict.signals_per_vector,
        known_after_reset: Vec::new(),
    })
}

/// The number of injected faults, and a description of the count.
fn injected(machine: &Machine, class: FaultClass, verdict: &Verdict) -> (u64, String) {
    let pressure = verdict.pressure;
    let withheld = pressure.withheld.iter().sum();
    let each =
        |[query, group, result]: [u64; 3]| format!("query {query}, group {group}, result {result}");
    match class {
        FaultClass::Resets => (
            pressure.resets,
            "resets, each before a whole query".to_owned(),
        ),
        FaultClass::NoReset => {
            let pins = Pins::of(machine);
            let registers = pins.observed.len() - pins.outputs;
            let words = format!(
                "registers as the text starts them, {} resets",
                pressure.resets
            );
            (registers as u64, words)
        }
        FaultClass::Holds => (
            withheld,
            format!(
                "clocks withheld, at most so long: {}",
                each(pressure.longest)
            ),
        ),
        _ => (
            withheld,
            format!("clocks withheld: {}", each(pressure.withheld)),
        ),
    }
}
