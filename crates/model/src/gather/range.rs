//! The largest values that a machine can represent, and the check against them.

use photoncube_spec::{Channels, Machine, Photon, PhotonFormat, Query, Widths};

use super::error::RangeError;

const POSITION: [&str; 3] = ["position x", "position y", "position z"];
const POWER: [&str; 3] = ["red power", "green power", "blue power"];

/// The largest values of a machine's words. Limits of coordinates and powers are all ones.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    coordinate: u32,
    radius_sq: u32,
    photon: u32,
    power: [u32; 3],
    exponent: u32,
    machine: &'static str,
}

impl Limits {
    /// The limits of a machine's words.
    pub fn of(machine: &Machine) -> Self {
        let widths = Widths::of(machine);
        let ones = |bits| u32::MAX >> (u32::BITS - bits);
        Self {
            coordinate: ones(widths.coordinate),
            // In a photon format, a clamped distance is certainly out of range only for radii up to the
            // format's own.
            radius_sq: machine
                .format()
                .map_or(ones(widths.radius_sq), PhotonFormat::largest_in_range),
            photon: ones(widths.photon),
            power: match machine.channels() {
                Channels::Rgb => [ones(widths.mantissa); 3],
                Channels::Mono => [ones(widths.mantissa), 0, 0],
            },
            exponent: machine.format().map_or(0, |f| f.power.exponent_range()),
            machine: machine.name,
        }
    }

    /// Checks that a query fits.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_query(&self, query: &Query) -> Result<(), RangeError> {
        self.check_each(POSITION, query.position, [self.coordinate; 3])?;
        self.check(("radius_sq", query.radius_sq), self.radius_sq)
    }

    /// Checks that a photon fits.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_photon(&self, photon: &Photon) -> Result<(), RangeError> {
        self.check_each(POSITION, photon.position, [self.photon; 3])?;
        self.check_each(POWER, photon.power, self.power)?;
        self.check(("exponent", photon.exponent), self.exponent)
    }

    fn check_each(
        &self,
        names: [&'static str; 3],
        values: [u32; 3],
        largest: [u32; 3],
    ) -> Result<(), RangeError> {
        let mut named = names.into_iter().zip(values).zip(largest);
        named.try_for_each(|(value, largest)| self.check(value, largest))
    }

    fn check(&self, (what, value): (&'static str, u32), largest: u32) -> Result<(), RangeError> {
        if value <= largest {
            return Ok(());
        }
        Err(RangeError {
            what,
            value,
            largest,
            holder: format!("machine `{}`", self.machine),
        })
    }
}
