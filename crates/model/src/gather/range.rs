//! The largest value of every word in the numbers of a machine, and the checks against them.

use photoncube_spec::{
    Channels, Exponent, FormatError, Numbers, Photon, PhotonBlock, PhotonRecord, Query, Widths,
};

use super::error::{CountError, RangeError};

const POSITION: [&str; 3] = ["position x", "position y", "position z"];
const MANTISSA: [&str; 3] = ["red mantissa", "green mantissa", "blue mantissa"];
const OFFSET: [&str; 3] = ["block offset x", "block offset y", "block offset z"];

/// The largest values of words. Those of coordinates, positions and mantissas are all ones.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    numbers: Numbers,
    /// A query's coordinate in the frame.
    coordinate: u32,
    radius_sq: u32,
    /// A photon's coordinate in the frame.
    photon: u32,
    /// A photon's position in its block.
    position: u32,
    mantissa: [u32; 3],
    /// The exponent of a photon's word on the pins.
    exponent: u32,
    /// The exponent of a photon's record.
    photon_exponent: u32,
    block_exponent: u32,
}

impl Limits {
    /// The limits of the words in these numbers.
    ///
    /// # Errors
    /// The numbers are not legal.
    pub fn of(numbers: &Numbers) -> Result<Self, FormatError> {
        numbers.check()?;
        let widths = Widths::of_numbers(numbers);
        let ones = |bits: u32| u32::MAX >> (u32::BITS - bits);
        let power = numbers.power();
        let mantissa = ones(widths.mantissa);
        let exponent = power.exponent_range();
        let (photon_exponent, block_exponent) = match power.exponent {
            Exponent::None => (0, 0),
            Exponent::Block { .. } => (0, exponent),
            Exponent::Photon { .. } => (exponent, 0),
        };
        Ok(Self {
            numbers: *numbers,
            coordinate: ones(widths.coordinate),
            radius_sq: numbers.largest_radius_word(),
            photon: ones(widths.photon),
            position: ones(widths.position),
            mantissa: match power.channels {
                Channels::Rgb => [mantissa; 3],
                Channels::Mono => [mantissa, 0, 0],
            },
            exponent,
            photon_exponent,
            block_exponent,
        })
    }

    /// The numbers whose limits these are.
    #[must_use]
    pub fn numbers(&self) -> &Numbers {
        &self.numbers
    }

    /// Checks that a query fits.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_query(&self, query: &Query) -> Result<(), RangeError> {
        self.check_each(POSITION, query.position, [self.coordinate; 3])?;
        self.check("radius_sq", query.radius_sq, self.radius_sq)
    }

    /// Checks that the word of a photon fits.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_photon(&self, photon: &Photon) -> Result<(), RangeError> {
        self.check_each(POSITION, photon.position, [self.photon; 3])?;
        self.check_each(MANTISSA, photon.power, self.mantissa)?;
        self.check("exponent", photon.exponent, self.exponent)
    }

    /// Checks a block's offset, its exponent and all of its records.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_block(&self, block: &PhotonBlock<'_>) -> Result<(), RangeError> {
        self.check_each(OFFSET, block.offset, [Numbers::FRAME_BLOCKS - 1; 3])?;
        self.check_records(block.exponent, block.photons)
    }

    /// Checks the exponent of a block and its records.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_records(
        &self,
        block_exponent: u8,
        records: &[PhotonRecord],
    ) -> Result<(), RangeError> {
        self.check("block exponent", block_exponent.into(), self.block_exponent)?;
        // Limits of positions and mantissas are all ones, so a value exceeds its limit exactly where the OR
        // of all values does.
        let (mut position, mut mantissa, mut exponent) = (0, [0; 3], 0);
        for record in records {
            let [x, y, z] = record.position;
            position |= x | y | z;
            for (all, one) in mantissa.iter_mut().zip(record.mantissa) {
                *all |= one;
            }
            exponent = exponent.max(record.exponent);
        }
        let all = PhotonRecord {
            position: [position; 3],
            mantissa,
            exponent,
        };
        if self.check_record(&all).is_ok() {
            return Ok(());
        }
        records
            .iter()
            .try_for_each(|record| self.check_record(record))
    }

    /// Checks that a record fits.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_record(&self, record: &PhotonRecord) -> Result<(), RangeError> {
        self.check_each(POSITION, record.position.map(u32::from), [self.position; 3])?;
        self.check_each(MANTISSA, record.mantissa.map(u32::from), self.mantissa)?;
        let exponent = u32::from(record.exponent);
        self.check("photon exponent", exponent, self.photon_exponent)
    }

    /// Checks that the sums are sized for `found` photons of one query.
    ///
    /// # Errors
    /// There are more photons than the numbers declare.
    pub fn check_count(&self, found: u64) -> Result<(), CountError> {
        let max_photons = self.numbers.max_photons();
        if found <= max_photons {
            return Ok(());
        }
        Err(CountError {
            found,
            max_photons,
            holder: self.numbers.to_string(),
        })
    }

    fn check_each(
        &self,
        names: [&'static str; 3],
        values: [u32; 3],
        largest: [u32; 3],
    ) -> Result<(), RangeError> {
        let mut named = names.into_iter().zip(values).zip(largest);
        named.try_for_each(|((what, value), largest)| self.check(what, value, largest))
    }

    fn check(&self, what: &'static str, value: u32, largest: u32) -> Result<(), RangeError> {
        if value <= largest {
            return Ok(());
        }
        Err(RangeError {
            what,
            value,
            largest,
            holder: self.numbers.to_string(),
        })
    }
}
