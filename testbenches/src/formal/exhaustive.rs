//! Proves the square unit by trying every input in the evaluator of the emitted text. A solver cannot decide
//! a product of two unknowns, and there are few pairs of coordinates.

use std::time::Instant;

use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{Machine, Unit, Widths};

use super::{FormalError, Proof};
use crate::device::{DeviceError, Text, hdl_error};
use crate::levels::verify_part_device;
use crate::verify::VerifyError;

/// The name of the property.
pub(super) const NAME: &str = "units::square";

/// The most bits of a pair of coordinates of which every one is tried, which takes a minute.
const MOST_BITS: u32 = 24;

/// Whether every pair of the machine's coordinates can be tried.
pub(super) fn is_possible(machine: &Machine) -> bool {
    let widths = Widths::of(machine);
    widths.coordinate + widths.photon <= MOST_BITS
}

/// Compares the square of every pair of coordinates; then requires that a planted fault in the difference is
/// found.
///
/// # Errors
/// The unit is not emitted or cannot be run.
pub(super) fn prove(machine: &Machine) -> Result<Proof, FormalError> {
    let started = Instant::now();
    let part = match machine.spatial() {
        Some(_) => Level::SquarePair,
        None => Level::Unit(Unit::Square),
    };
    let widths = Widths::of(machine);
    let pairs = 1_usize << (widths.coordinate + widths.photon);
    // The last pairs are still in the pipeline at the end, so some more rows follow.
    let rows = pairs + 16;
    let design = emit(machine, part).map_err(hdl_error(machine))?;
    let compared = |design: &Emitted| {
        let mut device = Text::new(design).map_err(DeviceError::from)?;
        verify_part_device(machine, part, &mut device, rows, 1)
    };
    let sound = compared(&design);
    let (proven, found) = match &sound {
        Ok(verdict) if verdict.vectors_compared >= rows as u64 => (true, None),
        Ok(verdict) => {
            let compared = verdict.vectors_compared;
            (
                false,
                Some(format!("{compared} rows compared, {rows} expected")),
            )
        }
        Err(error) => (false, Some(error.to_string())),
    };
    let control_refuted = matches!(
        compared(&with_fault(&design)),
        Err(VerifyError::Diverged(_))
    );
    Ok(Proof {
        property: NAME.to_owned(),
        module: part.name().to_owned(),
        claim: format!(
            "the square is the golden model's for every one of {pairs} pairs of coordinates"
        ),
        method: "exhaustive",
        depth: 0,
        proven,
        cover_reached: None,
        control_refuted,
        seconds: started.elapsed().as_secs_f64(),
        not_proven_because: found,
    })
}

/// Faults that make some squares wrong, for each implementation of squares: digits, a table, a product.
const FAULTS: [(&str, &str); 5] = [
    ("digit_square = 8'd4;", "digit_square = 8'd5;"),
    ("high_square = 8'd4;", "high_square = 8'd5;"),
    ("square = 32'h79", "square = 32'h78"),
    ("root * root", "root * root + (root == 11)"),
    ("= d * d", "= d * d * (d == 11 ? 2 : 1)"),
];

fn with_fault(design: &Emitted) -> Emitted {
    let mut planted = design.clone();
    for (right, wrong) in FAULTS {
        if design.text.contains(right) {
            planted.text = design.text.replacen(right, wrong, 1);
        }
    }
    planted
}
