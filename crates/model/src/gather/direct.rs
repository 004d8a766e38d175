//! The direct gather: the sums that a machine must return, computed photon by photon.

use photoncube_spec::{
    FormatError, Machine, Numbers, Photon, PhotonBlock, PhotonRecord, Query, Sums,
};

use super::error::GatherError;
use super::range::Limits;

/// Sums the power and the number of the photons in range of a query, from the words on a machine's pins:
/// eq. 2 of Ryu, Kim, Lee, without its constant factor `1 / (pi r^2)`. The sums are exact.
///
/// # Errors
/// The machine's numbers are not legal, a value does not fit them, or there are more photons than the sums
/// are sized for.
pub fn gather(
    machine: &Machine,
    query: &Query,
    photons: impl IntoIterator<Item = Photon>,
) -> Result<Sums, GatherError> {
    let gather = Gather::new(&machine.numbers)?;
    let mut sums = Sums::default();
    let mut given = 0;
    gather.limits.check_query(query)?;
    for photon in photons {
        gather.limits.check_photon(&photon)?;
        given += 1;
        // Photons past the limit are only counted, for the error.
        if given <= machine.max_photons() && gather.is_near(query, photon.position) {
            add(&mut sums, photon.power, photon.exponent);
        }
    }
    gather.limits.check_count(given)?;
    Ok(sums)
}

fn add(sums: &mut Sums, mantissa: [u32; 3], exponent: u32) {
    for (sum, mantissa) in sums.power.iter_mut().zip(mantissa) {
        // A mantissa has at most 16 bits, and an exponent is at most 24.
        *sum += u128::from(u64::from(mantissa) << exponent);
    }
    sums.count += 1;
}

/// The gather in the numbers of a machine, plain or local, over blocks of stored photons. The search radius
/// is that of each query.
///
/// Positions are compared in half fine steps, in which the middles of cells are integers too. This plain
/// geometry has no clamp and no half squares, and must give the decisions of the rules that have them.
#[derive(Copy, Clone, Debug)]
pub struct Gather {
    limits: Limits,
    /// The fraction bits of a query beyond those of a photon.
    extra: u32,
    position_bits: u32,
    /// The excess of (2 d)^2 over 4 `radius_sq` at the boundary. On half steps, where `radius_sq` bounds a
    /// sum of half squares, it is 1/4 for each axis.
    margin: u64,
}

impl Gather {
    /// Makes the gather in `numbers`.
    ///
    /// # Errors
    /// The numbers are not legal.
    pub fn new(numbers: &Numbers) -> Result<Self, FormatError> {
        let extra = numbers.query_extra_bits();
        Ok(Self {
            limits: Limits::of(numbers)?,
            extra,
            position_bits: numbers.position_bits(),
            margin: if extra > 0 { 3 } else { 0 },
        })
    }

    /// The numbers that this gather is for.
    #[must_use]
    pub fn numbers(&self) -> &Numbers {
        self.limits.numbers()
    }

    /// The limits of the numbers' words.
    #[must_use]
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Sums power and number of the photons in range. The sums are exact and independent of the order of the
    /// photons.
    ///
    /// # Errors
    /// A value does not fit the numbers, or there are more photons than the sums are sized for.
    pub fn sums<'b>(
        &self,
        query: &Query,
        blocks: impl IntoIterator<Item = PhotonBlock<'b>>,
    ) -> Result<Sums, GatherError> {
        self.limits.check_query(query)?;
        let mut sums = Sums::default();
        let mut given = 0;
        for block in blocks {
            given += block.photons.len() as u64;
            // Photons past the limit are only counted, for the error.
            if given <= self.numbers().max_photons() {
                self.limits.check_block(&block)?;
                self.add_block(query, &block, &mut sums);
            }
        }
        self.limits.check_count(given)?;
        Ok(sums)
    }

    /// Whether the photon of a block at `offset` is in range of the query. All values must be within
    /// [`Self::limits`].
    #[must_use]
    pub fn in_range(&self, query: &Query, offset: [u32; 3], record: &PhotonRecord) -> bool {
        self.is_near(query, self.place(offset, record))
    }

    fn add_block(&self, query: &Query, block: &PhotonBlock<'_>, sums: &mut Sums) {
        for record in block.photons {
            if self.is_near(query, self.place(block.offset, record)) {
                let exponent = block.exponent + record.exponent;
                add(sums, record.mantissa.map(u32::from), exponent.into());
            }
        }
    }

    /// The photon's coordinates in the frame, in photon steps.
    fn place(&self, offset: [u32; 3], record: &PhotonRecord) -> [u32; 3] {
        let place = |axis| (offset[axis] << self.position_bits) + u32::from(record.position[axis]);
        [place(0), place(1), place(2)]
    }

    /// Whether a photon at this place of the frame is in range.
    fn is_near(&self, query: &Query, photon: [u32; 3]) -> bool {
        let square = |axis: usize| {
            let query = 2 * query.position[axis] + 1;
            let photon = (2 * photon[axis] + 1) << self.extra;
            u64::from(query.abs_diff(photon)).pow(2)
        };
        square(0) + square(1) + square(2) <= 4 * u64::from(query.radius_sq) + self.margin
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::{MACHINES, PHOTON_FORMATS, PhotonFormat, PowerFormat};

    const PAPER: &Machine = &MACHINES[0];

    fn photon_at(x: u32, y: u32, z: u32) -> Photon {
        Photon {
            position: [x, y, z],
            power: [1, 2, 3],
            exponent: 0,
        }
    }

    #[test]
    fn the_boundary_is_in_range() {
        let query = Query {
            position: [100; 3],
            radius_sq: 25,
        };
        let photons = [photon_at(103, 96, 100), photon_at(103, 96, 101)];
        let sums = gather(PAPER, &query, photons).unwrap();
        assert_eq!((sums.count, sums.power), (1, [1, 2, 3]));
    }

    #[test]
    fn the_largest_declared_count_at_full_scale_is_exact() {
        let full = Photon {
            position: [0; 3],
            power: [65_535; 3],
            exponent: 0,
        };
        let many = |count| std::iter::repeat_n(full, count);
        let query = Query::default();
        let largest = PAPER.max_photons() as usize;
        let sums = gather(PAPER, &query, many(largest)).unwrap();
        assert_eq!(sums.power, [u128::from(u32::MAX); 3]);
        let refused = gather(PAPER, &query, many(largest + 3)).unwrap_err();
        let expected = "65540 photons is 3 over the 65537 that the plain format of 8-bit coordinates and 16-bit powers declares";
        assert!(refused.to_string().contains(expected), "{refused}");
    }

    #[test]
    fn what_does_not_fit_is_refused_with_the_limit() {
        let query = Query::default();
        let message = gather(PAPER, &query, [photon_at(0, 256, 0)])
            .unwrap_err()
            .to_string();
        assert!(message.contains("position y is 256"), "{message}");
        assert!(
            message.contains("1 over the largest") && message.contains("holds, 255"),
            "{message}"
        );
    }

    #[test]
    fn illegal_formats_are_refused() {
        let format = PhotonFormat {
            power: PowerFormat {
                mantissa_bits: 0,
                ..PHOTON_FORMATS[0].power
            },
            ..PHOTON_FORMATS[0]
        };
        let message = Gather::new(&format.into()).unwrap_err().to_string();
        assert!(message.contains("mantissa_bits is 0"), "{message}");
    }
}
