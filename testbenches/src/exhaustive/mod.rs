//! Exhaustive comparisons: each unit at widths at which every pair of inputs can be tried, and every
//! difference with every radius in the lanes of a machine.

mod lane;
mod rows;

use photoncube_hdl::{Unit, emit_unit, unit_pins};
use photoncube_spec::Pins;
use serde::Serialize;

use crate::compare::Actual;
use crate::controls::{Control, PlantedFault, plant};
use crate::device::{Device, DeviceKind, Observed, hdl_error_of};
use crate::verify::{VerifyError, nothing_compared, wrong_count};

pub use lane::{LaneVerdict, Radii, exhaustive_lane, exhaustive_lane_device};
use rows::Rows;

/// A record of the comparison of a unit.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct UnitVerdict {
    /// The name of the unit.
    #[serde(rename = "part")]
    pub unit: &'static str,
    /// The number of bits of each operand.
    pub operand_bits: u32,
    /// The name of the device.
    pub device: String,
    /// The tool behind the device, with its version.
    pub tool_version: String,
    /// The number of different pairs of operands, which are all pairs.
    pub pairs_compared: u64,
    /// The number of rows of inputs. Every output was compared after each.
    pub vectors_compared: u64,
    /// The number of rows with a wrong output.
    pub mismatches: u64,
    /// A description of the first row with a wrong output.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_mismatch: Option<String>,
}

/// Compares a unit with operands of `bits` bits in a device, on every pair of operands.
///
/// # Errors
/// The device does not run, or nothing was compared. Mismatches are counted and are not an error.
pub fn exhaustive_unit(
    unit: Unit,
    bits: u32,
    kind: DeviceKind,
) -> Result<UnitVerdict, VerifyError> {
    let mut device = kind.open_unit(unit, bits)?;
    exhaustive_unit_device(unit, bits, device.as_mut())
}

/// Compares a unit in a device that is open and has not run yet.
///
/// # Errors
/// The device does not run, or nothing was compared. Mismatches are counted and are not an error.
pub fn exhaustive_unit_device(
    unit: Unit,
    bits: u32,
    device: &mut dyn Device,
) -> Result<UnitVerdict, VerifyError> {
    let pins = unit_pins(unit, bits).map_err(hdl_error_of(unit.name()))?;
    let rows = rows::rows(unit, bits);
    let mut observed = Observed::default();
    device.replay(&rows.inputs, &mut observed)?;
    let vectors = rows.expected.len() / pins.outputs;
    if device.visible() == 0 || vectors == 0 || rows.pairs == 0 {
        return Err(nothing_compared(device.name(), 0, 0, vectors as u64));
    }
    if device.visible() != pins.outputs || observed.values.len() != rows.expected.len() {
        return Err(wrong_count(device, vectors, &observed).into());
    }
    let wrong = wrong_rows(&rows, &pins, &observed);
    Ok(UnitVerdict {
        unit: unit.name(),
        operand_bits: bits,
        device: device.name().to_owned(),
        tool_version: device.tool_version().to_owned(),
        pairs_compared: rows.pairs,
        vectors_compared: vectors as u64,
        mismatches: wrong.len() as u64,
        first_mismatch: wrong
            .first()
            .map(|&row| account(&rows, &pins, &observed, row)),
    })
}

/// A lane that counts a photon on the boundary as out of range.
const BOUNDARY: PlantedFault = PlantedFault {
    what: "a difference on the boundary is out of range",
    machine: "stream",
    module: "range_of_query",
    edits: &[("distance <= limit", "distance < limit")],
};

/// Plants a sum that is wrong for a single pair of operands, and a lane that leaves the boundary out, in the built-in
/// evaluator.
///
/// # Errors
/// The evaluator does not run.
pub fn exhaustive_controls() -> Result<Vec<Control>, VerifyError> {
    let (unit, bits) = (Unit::Add, 8);
    let mut sum = emit_unit(unit, bits).map_err(hdl_error_of(unit.name()))?;
    let wrong = "(a + b) ^ ((a == 8'd171) && (b == 8'd205))";
    sum.text = plant(&sum.text, &sum.top, "a + b", wrong)?;
    let mut device = DeviceKind::Text.open_text(&sum)?;
    let verdict = exhaustive_unit_device(unit, bits, device.as_mut())?;
    let of_sum = Control {
        planted: format!("{unit} of {bits} bits: one of all sums is off by one"),
        found: verdict.mismatches == 1,
    };
    let (_, lanes) = BOUNDARY.plant()?;
    let mut open = || DeviceKind::Text.open_text(&lanes);
    let ended = exhaustive_lane_device(&mut open, Radii::Squares, &|_| ());
    Ok(vec![of_sum, Control::of(BOUNDARY.told(), ended)?])
}

fn wrong_rows(rows: &Rows, pins: &Pins, observed: &Observed) -> Vec<usize> {
    let expected = rows.expected.chunks_exact(pins.outputs);
    let found = observed.values.chunks_exact(pins.outputs);
    let differ = expected.zip(found).enumerate();
    let mut wrong: Vec<_> = differ
        .filter_map(|(row, (expected, found))| (expected != found).then_some(row))
        .collect();
    // An unknown output has the value 0 here, which may equal the expected value.
    wrong.extend(observed.unknown.iter().map(|x| x.index / pins.outputs));
    wrong.sort_unstable();
    wrong.dedup();
    wrong
}

/// Describes a row with its expected and its observed outputs.
fn account(rows: &Rows, pins: &Pins, observed: &Observed, row: usize) -> String {
    // An output behind registers depends on the inputs of an earlier row.
    let cause = row.saturating_sub(rows.latency);
    let inputs = &rows.inputs[cause * pins.inputs.len()..];
    let named = pins.inputs.iter().zip(inputs);
    let inputs: Vec<_> = named.map(|(pin, v)| format!("{}={v}", pin.name)).collect();
    let first = row * pins.outputs;
    let mut outputs = Vec::new();
    for (column, pin) in pins.observed.iter().enumerate() {
        let expected = rows.expected[first + column];
        let found = match observed.at(first + column) {
            Actual::Known(value) if value == expected => continue,
            Actual::Known(value) => value.to_string(),
            Actual::Unknown(text) => text,
        };
        outputs.push(format!("{}: expected {expected}, found {found}", pin.name));
    }
    format!("{}: {}", inputs.join(" "), outputs.join("; "))
}
