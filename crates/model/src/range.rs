//! What a machine can represent, and the refusal of what it cannot.

use photoncube_spec::{Machine, Photon, Query, Widths};
use thiserror::Error;

/// A value does not fit its format.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "{what} is {value}, which machine `{machine}` cannot hold: its largest is {largest} ({bits} bits)"
)]
pub struct RangeError {
    /// Which value.
    pub what: &'static str,
    /// What it is.
    pub value: u32,
    /// The largest that fits.
    pub largest: u32,
    /// The format's bits.
    pub bits: u32,
    /// The machine.
    pub machine: &'static str,
}

const POSITION: [&str; 3] = ["position x", "position y", "position z"];
const POWER: [&str; 3] = ["red power", "green power", "blue power"];

fn check(machine: &Machine, what: &'static str, value: u32, bits: u32) -> Result<(), RangeError> {
    let largest = u32::MAX >> (u32::BITS - bits);
    if value <= largest {
        return Ok(());
    }
    Err(RangeError {
        what,
        value,
        largest,
        bits,
        machine: machine.name,
    })
}

/// Checks that a query fits the machine's formats.
///
/// # Errors
/// The first value that does not, with the limit.
pub fn check_query(machine: &Machine, query: &Query) -> Result<(), RangeError> {
    let widths = Widths::of(machine);
    for (what, value) in POSITION.into_iter().zip(query.position) {
        check(machine, what, value, widths.coordinate)?;
    }
    check(machine, "radius_sq", query.radius_sq, widths.distance)
}

/// Checks that a photon fits the machine's formats.
///
/// # Errors
/// The first value that does not, with the limit.
pub fn check_photon(machine: &Machine, photon: &Photon) -> Result<(), RangeError> {
    let widths = Widths::of(machine);
    for (what, value) in POSITION.into_iter().zip(photon.position) {
        check(machine, what, value, widths.coordinate)?;
    }
    for (what, value) in POWER.into_iter().zip(photon.power) {
        check(machine, what, value, widths.power)?;
    }
    Ok(())
}
