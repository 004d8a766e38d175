//! Regression cases: inputs that once showed a difference, which the tests replay.

use photoncube_spec::{Machine, Pins, UnknownMachine, find_machine};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::compare::Comparer;
use crate::device::{Device, Observed};
use crate::stimulus::{Block, modelled, scrub_rows};
use crate::verify::{VerifyError, nothing_compared, wrong_count};

/// Rows of inputs on which a device differed from the golden model. They follow the rows with which every
/// chunk of stimulus begins, which set each register to a value that does not depend on its past.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Regression {
    /// The name of the machine.
    pub machine: String,
    /// The name of the device that differed.
    pub device: String,
    /// A description of the difference.
    pub divergence: String,
    /// The machine's input pins, in their order.
    pub pins: Vec<String>,
    /// A value for each pin, clock by clock.
    pub rows: Vec<Vec<u64>>,
}

/// The error of a regression case that no present machine can replay.
#[derive(Debug, Error)]
pub enum RegressionError {
    /// The text is not a regression case.
    #[error("it is no regression case; expected what `verify campaign` writes")]
    Format(#[from] serde_json::Error),
    /// There is no such machine.
    #[error(transparent)]
    Machine(#[from] UnknownMachine),
    /// The machine's input pins have changed.
    #[error(
        "machine `{machine}` has other input pins than the case, which has {found}; expected \
         {expected}: write the case anew for these, or remove it with the reason"
    )]
    Pins {
        /// The name of the machine.
        machine: String,
        /// The pins of the case.
        found: String,
        /// The pins of the machine.
        expected: String,
    },
    /// A row has too few values, too many, or one that is wider than its pin.
    #[error("row {row} has {found}; expected {expected} values, none wider than its pin")]
    Row {
        /// The index of the row.
        row: usize,
        /// The row's values, as far as they are wrong.
        found: String,
        /// The number of pins.
        expected: usize,
    },
}

impl Regression {
    /// Makes a case of these rows.
    pub(super) fn new(machine: &Machine, device: &str, divergence: String, rows: &[u64]) -> Self {
        let pins = Pins::of(machine).inputs;
        Self {
            machine: machine.name.to_owned(),
            device: device.to_owned(),
            divergence,
            rows: rows.chunks(pins.len()).map(<[u64]>::to_vec).collect(),
            pins: pins.into_iter().map(|pin| pin.name).collect(),
        }
    }

    /// Parses the output of [`Self::text`] and checks that the machine still has these pins.
    ///
    /// # Errors
    /// The text is not a regression case, or is about another machine.
    pub fn parse(text: &str) -> Result<Self, RegressionError> {
        let case: Self = serde_json::from_str(text)?;
        let pins = Pins::of(case.machine()?).inputs;
        let names: Vec<_> = pins.iter().map(|pin| pin.name.clone()).collect();
        if names != case.pins {
            return Err(RegressionError::Pins {
                machine: case.machine,
                found: case.pins.join(", "),
                expected: names.join(", "),
            });
        }
        let fits = |row: &Vec<u64>| {
            row.len() == pins.len()
                && row
                    .iter()
                    .zip(&pins)
                    .all(|(value, pin)| value.checked_shr(pin.width).unwrap_or(0) == 0)
        };
        match case.rows.iter().position(|row| !fits(row)) {
            Some(row) => Err(RegressionError::Row {
                row,
                found: format!("{:?}", case.rows[row]),
                expected: pins.len(),
            }),
            None => Ok(case),
        }
    }

    /// The case as JSON, with one clock a line.
    pub fn text(&self) -> String {
        let rows: Vec<_> = self
            .rows
            .iter()
            .map(|row| format!("    {}", json(row)))
            .collect();
        format!(
            "{{\n  \"machine\": {},\n  \"device\": {},\n  \"divergence\": {},\n  \"pins\": {},\n  \
             \"rows\": [\n{}\n  ]\n}}\n",
            json(&self.machine),
            json(&self.device),
            json(&self.divergence),
            json(&self.pins),
            rows.join(",\n")
        )
    }

    /// The machine of the case.
    ///
    /// # Errors
    /// No machine has that name.
    pub fn machine(&self) -> Result<&'static Machine, RegressionError> {
        Ok(find_machine(&self.machine)?)
    }

    /// Replays the case in an open device and returns the number of clocks compared.
    ///
    /// # Errors
    /// The first difference, or nothing was compared.
    pub fn replay(&self, device: &mut dyn Device) -> Result<u64, VerifyError> {
        let machine = find_machine(&self.machine).expect("a case that was read has a machine");
        let rows = self.rows.concat();
        let block = modelled(machine, &rows);
        if block.clocks == 0 {
            return Err(nothing_compared(device.name(), 0, 0, 0));
        }
        compare(machine, device, &block)?;
        Ok(block.clocks as u64)
    }
}

fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("numbers and texts can be written")
}

/// Compares a block that follows the rows with which a chunk begins.
pub(super) fn compare(
    machine: &Machine,
    device: &mut dyn Device,
    block: &Block,
) -> Result<(), VerifyError> {
    let mut observed = Observed::default();
    device.replay(&scrub_rows(machine), &mut observed)?;
    observed.clear();
    device.replay(&block.inputs, &mut observed)?;
    let mut comparer = Comparer::new(machine, device.visible());
    if !comparer.is_complete(block, &observed) {
        return Err(wrong_count(device, block.clocks, &observed).into());
    }
    let repeat = || "cargo test -p photoncube-testbench --test campaign".to_owned();
    let compared = comparer.compare(block, &observed, device.name(), repeat);
    compared.map_err(VerifyError::Diverged)
}
