//! Describes a difference from the golden model under unknown values.

use photoncube_spec::{Machine, Pins};
use thiserror::Error;

use crate::compare::Actual;
use crate::device::{Device, Observed};
use crate::stimulus::Block;
use crate::verify::VerifyError;

/// The error of a value that differs from the golden model's, or that is unknown and must not be.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "{device} with unknown values differs from the golden model of `{machine}` in clock {clock}\n  \
     signal    {signal}\n  expected  {expected}\n  actual    {found}\n  repeat    {repeat}"
)]
pub struct UnknownDifference {
    /// The name of the machine.
    pub machine: &'static str,
    /// The name of the device.
    pub device: String,
    /// The clock, counted from power-up.
    pub clock: u64,
    /// The signal's name, as in [`Pins`].
    pub signal: String,
    /// The value of the golden model.
    pub expected: u64,
    /// The value of the device.
    pub found: String,
    /// A command that reproduces the difference.
    pub repeat: String,
}

/// The difference at an index of the observed values.
pub(super) fn difference(
    machine: &Machine,
    (pins, block, observed): (&Pins, &Block, &Observed),
    device: &dyn Device,
    index: usize,
) -> VerifyError {
    let visible = pins.observed.len();
    VerifyError::Unknown(Box::new(UnknownDifference {
        machine: machine.name,
        device: device.name().to_owned(),
        clock: (index / visible) as u64,
        signal: pins.observed[index % visible].name.clone(),
        expected: block.expected[index],
        found: match observed.at(index) {
            Actual::Known(value) => value.to_string(),
            Actual::Unknown(text) => format!("{text} in hexadecimal, unknown bits"),
        },
        repeat: format!(
            "photoncube verify faults --machine {} --seed {}",
            machine.name, block.seed
        ),
    }))
}
