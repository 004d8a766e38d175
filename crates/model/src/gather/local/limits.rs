//! The largest value of every field of a photon format, and the checks against them.

use photoncube_spec::{
    Channels, Exponent, FormatError, LocalQuery, PhotonBlock, PhotonFormat, PhotonRecord, Widths,
};

use crate::gather::RangeError;

const POSITION: [&str; 3] = ["position x", "position y", "position z"];
const MANTISSA: [&str; 3] = ["red mantissa", "green mantissa", "blue mantissa"];
const OFFSET: [&str; 3] = ["block offset x", "block offset y", "block offset z"];

/// The largest values of a format's words.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct LocalLimits {
    radius_sq: u32,
    coordinate: u32,
    position: u32,
    mantissa: [u32; 3],
    photon_exponent: u32,
    block_exponent: u32,
    format: PhotonFormat,
}

impl LocalLimits {
    /// The limits of a format's words.
    ///
    /// # Errors
    /// The format is not legal.
    pub fn of(format: &PhotonFormat) -> Result<Self, FormatError> {
        format.check()?;
        let widths = Widths::of_format(format);
        let ones = |bits| u32::MAX >> (u32::BITS - bits);
        let range = format.power.exponent_range();
        let (photon_exponent, block_exponent) = match format.power.exponent {
            Exponent::None => (0, 0),
            Exponent::Block { .. } => (0, range),
            Exponent::Photon { .. } => (range, 0),
        };
        Ok(Self {
            radius_sq: format.radius_steps().pow(2),
            coordinate: ones(widths.coordinate),
            position: ones(widths.position),
            mantissa: match format.power.channels {
                Channels::Rgb => [ones(widths.mantissa); 3],
                Channels::Mono => [ones(widths.mantissa), 0, 0],
            },
            photon_exponent,
            block_exponent,
            format: *format,
        })
    }

    /// Checks that a query fits the frame.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_query(&self, query: &LocalQuery) -> Result<(), RangeError> {
        self.check_each(POSITION, query.position, [self.coordinate; 3])
    }

    /// Checks that a squared radius is at most the format's own.
    ///
    /// # Errors
    /// The squared radius is larger, with the limit.
    pub fn check_radius_sq(&self, radius_sq: u32) -> Result<(), RangeError> {
        self.check("radius_sq", radius_sq, self.radius_sq)
    }

    /// Checks a block's offset and exponent, but not its photons.
    ///
    /// # Errors
    /// The first value that does not fit, with the limit.
    pub fn check_block(&self, block: &PhotonBlock<'_>) -> Result<(), RangeError> {
        self.check_each(OFFSET, block.offset, [PhotonFormat::FRAME_BLOCKS - 1; 3])?;
        self.check_block_exponent(block.exponent)
    }

    /// Checks a block's exponent.
    ///
    /// # Errors
    /// The exponent does not fit, with the limit.
    pub fn check_block_exponent(&self, exponent: u8) -> Result<(), RangeError> {
        self.check("block exponent", exponent.into(), self.block_exponent)
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

    /// Checks that all records fit.
    ///
    /// # Errors
    /// As for [`Self::check_record`], for the first record that does not fit.
    pub fn check_records(&self, records: &[PhotonRecord]) -> Result<(), RangeError> {
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
        let fits = u32::from(position) <= self.position
            && self
                .check_each(MANTISSA, mantissa.map(u32::from), self.mantissa)
                .is_ok()
            && u32::from(exponent) <= self.photon_exponent;
        if fits {
            return Ok(());
        }
        records
            .iter()
            .try_for_each(|record| self.check_record(record))
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
            holder: format!("format `{}`", self.format.name()),
        })
    }
}
