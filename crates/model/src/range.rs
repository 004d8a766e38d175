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

/// The largest values of a machine's formats; each is all ones.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    coordinate: u32,
    radius_sq: u32,
    power: u32,
    machine: &'static str,
}

impl Limits {
    /// The limits of a machine.
    pub fn of(machine: &Machine) -> Self {
        let widths = Widths::of(machine);
        let ones = |bits| u32::MAX >> (u32::BITS - bits);
        Self {
            coordinate: ones(widths.coordinate),
            radius_sq: ones(widths.distance),
            power: ones(widths.power),
            machine: machine.name,
        }
    }

    /// Checks that a query fits.
    ///
    /// # Errors
    /// The first value that does not, with the limit.
    pub fn check_query(&self, query: &Query) -> Result<(), RangeError> {
        self.check_each(POSITION, query.position, self.coordinate)?;
        self.check(("radius_sq", query.radius_sq), self.radius_sq)
    }

    /// Checks that a photon fits.
    ///
    /// # Errors
    /// The first value that does not, with the limit.
    pub fn check_photon(&self, photon: &Photon) -> Result<(), RangeError> {
        self.check_each(POSITION, photon.position, self.coordinate)?;
        self.check_each(POWER, photon.power, self.power)
    }

    /// All three at once: a limit is all ones, so one value is past it where their OR is.
    fn check_each(
        &self,
        names: [&'static str; 3],
        values: [u32; 3],
        largest: u32,
    ) -> Result<(), RangeError> {
        let [a, b, c] = values;
        if a | b | c <= largest {
            return Ok(());
        }
        let mut named = names.into_iter().zip(values);
        named.try_for_each(|value| self.check(value, largest))
    }

    fn check(&self, (what, value): (&'static str, u32), largest: u32) -> Result<(), RangeError> {
        if value <= largest {
            return Ok(());
        }
        Err(RangeError {
            what,
            value,
            largest,
            bits: largest.count_ones(),
            machine: self.machine,
        })
    }
}
