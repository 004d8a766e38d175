//! The sum over the photons in range, in one format's integers.

use photoncube_spec::{
    FormatError, FormatWidths, LocalQuery, LocalSums, PhotonBlock, PhotonFormat, PhotonRecord,
};

use super::error::{CountError, LocalError};
use super::limits::LocalLimits;

/// The gather of one format: eq. 2 of Ryu, Kim, Lee without its constant factor, with the search
/// radius that the format fixes or any smaller one.
#[derive(Copy, Clone, Debug)]
pub struct LocalGather {
    format: PhotonFormat,
    limits: LocalLimits,
    /// The largest clamped difference.
    clamp: u32,
    /// The search radius squared, R^2.
    radius_sq: u32,
    /// The largest sum of (half) squares that is told apart.
    saturated: u32,
}

impl LocalGather {
    /// The gather of `format`.
    ///
    /// # Errors
    /// A format that is not legal.
    pub fn new(format: &PhotonFormat) -> Result<Self, FormatError> {
        let limits = LocalLimits::of(format)?;
        let widths = FormatWidths::of(format);
        Ok(Self {
            format: *format,
            limits,
            clamp: (1 << format.radius_bits()) - 1,
            radius_sq: format.radius_steps().pow(2),
            saturated: (1 << widths.distance) - 1,
        })
    }

    /// The format.
    #[must_use]
    pub fn format(&self) -> &PhotonFormat {
        &self.format
    }

    /// The limits of its values.
    #[must_use]
    pub fn limits(&self) -> &LocalLimits {
        &self.limits
    }

    /// The format's search radius squared, R^2 (squared fine steps): the largest that
    /// [`Self::gather_within`] takes.
    #[must_use]
    pub fn radius_sq(&self) -> u32 {
        self.radius_sq
    }

    /// Sums power and number of the photons in range; exact, in whatever order they come.
    ///
    /// # Errors
    /// A value that the format cannot hold, or more photons than its sums are sized for.
    pub fn gather<'b>(
        &self,
        query: &LocalQuery,
        blocks: impl IntoIterator<Item = PhotonBlock<'b>>,
    ) -> Result<LocalSums, LocalError> {
        self.gather_within(query, self.radius_sq, blocks)
    }

    /// The same for another search radius: d^2 <= `radius_sq` (squared fine steps) is in range,
    /// which decides exactly, as at R. Bisection for the k-th photon and a ladder of radii are
    /// made of these, each radius one gather.
    ///
    /// # Errors
    /// As for [`Self::gather`], and a `radius_sq` over [`Self::radius_sq`]: the blocks around the
    /// query hold all photons only up to there.
    pub fn gather_within<'b>(
        &self,
        query: &LocalQuery,
        radius_sq: u32,
        blocks: impl IntoIterator<Item = PhotonBlock<'b>>,
    ) -> Result<LocalSums, LocalError> {
        self.limits.check_query(query)?;
        self.limits.check_radius_sq(radius_sq)?;
        let mut sums = LocalSums::default();
        let mut given = 0;
        for block in blocks {
            given += block.photons.len() as u64;
            // Past the limit nothing is summed, only counted for the error.
            if given <= self.format.max_photons {
                self.limits.check_block(&block)?;
                self.add_block(query, radius_sq, &block, &mut sums)?;
            }
        }
        self.check_count(given)?;
        Ok(sums)
    }

    /// Whether the query has the photon of a block at `offset` in range. All values must be
    /// within [`Self::limits`].
    #[must_use]
    pub fn in_range(&self, query: &LocalQuery, offset: [u32; 3], record: &PhotonRecord) -> bool {
        let relative = self.relative(query, offset);
        if self.format.half_steps() {
            self.in_range_of::<true>(self.radius_sq, relative, record)
        } else {
            self.in_range_of::<false>(self.radius_sq, relative, record)
        }
    }

    fn add_block(
        &self,
        query: &LocalQuery,
        radius_sq: u32,
        block: &PhotonBlock<'_>,
        sums: &mut LocalSums,
    ) -> Result<(), LocalError> {
        self.limits.check_records(block.photons)?;
        let relative = self.relative(query, block.offset);
        if self.format.half_steps() {
            self.add_records::<true>(radius_sq, relative, block, sums);
        } else {
            self.add_records::<false>(radius_sq, relative, block, sums);
        }
        Ok(())
    }

    fn add_records<const HALF_STEPS: bool>(
        &self,
        radius_sq: u32,
        relative: [i32; 3],
        block: &PhotonBlock<'_>,
        sums: &mut LocalSums,
    ) {
        for record in block.photons {
            if !self.in_range_of::<HALF_STEPS>(radius_sq, relative, record) {
                continue;
            }
            let exponent = block.exponent + record.exponent;
            for (sum, mantissa) in sums.power.iter_mut().zip(record.mantissa) {
                *sum += u128::from(u64::from(mantissa) << exponent);
            }
            sums.count += 1;
        }
    }

    /// Checks that the sums are sized for that many photons.
    pub(crate) fn check_count(&self, found: u64) -> Result<(), CountError> {
        if found <= self.format.max_photons {
            return Ok(());
        }
        Err(CountError {
            found,
            max_photons: self.format.max_photons,
            format: self.format.name(),
        })
    }

    /// The query seen from a block's corner: the same for all photons of the block.
    fn relative(&self, query: &LocalQuery, offset: [u32; 3]) -> [i32; 3] {
        let edge = self.format.edge_steps();
        std::array::from_fn(|axis| query.position[axis] as i32 - (offset[axis] * edge) as i32)
    }

    fn in_range_of<const HALF_STEPS: bool>(
        &self,
        radius_sq: u32,
        relative: [i32; 3],
        record: &PhotonRecord,
    ) -> bool {
        let square = |axis| {
            let difference = relative[axis] - self.centre(record.position[axis]);
            self.square::<HALF_STEPS>(difference)
        };
        let sum: u32 = square(0) + square(1) + square(2);
        self.is_within::<HALF_STEPS>(sum, radius_sq)
    }

    /// Whether a sum of (half) squares is in range. On half steps d^2 is the sum and 3/4, which is
    /// at most an integer where the sum and 1 are.
    fn is_within<const HALF_STEPS: bool>(&self, sum: u32, radius_sq: u32) -> bool {
        sum.min(self.saturated) + u32::from(HALF_STEPS) <= radius_sq
    }

    /// What a photon in this cell is subtracted as: its index, or the fine grid line through its
    /// cell's middle.
    fn centre(&self, cell: u16) -> i32 {
        let extra = self.format.query_extra_bits;
        (i32::from(cell) << extra) + ((1 << extra) >> 1)
    }

    /// The clamped square of a difference, or half square on half steps.
    fn square<const HALF_STEPS: bool>(&self, difference: i32) -> u32 {
        if HALF_STEPS {
            // d for d >= 0, ~d below: the sign's mask inverts.
            let inverted = difference ^ (difference >> 31);
            let m = (inverted as u32).min(self.clamp);
            m * (m + 1)
        } else {
            difference.unsigned_abs().min(self.clamp).pow(2)
        }
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{PHOTON_FORMATS, PowerFormat};

    use super::*;

    /// The smallest positions, half steps included.
    fn small_formats() -> impl Iterator<Item = PhotonFormat> {
        (0..=2).map(|query_extra_bits| PhotonFormat {
            position_bits: 4,
            query_extra_bits,
            ..PHOTON_FORMATS[0]
        })
    }

    fn square(gather: &LocalGather, difference: i32) -> u32 {
        if gather.format.half_steps() {
            gather.square::<true>(difference)
        } else {
            gather.square::<false>(difference)
        }
    }

    fn is_within(gather: &LocalGather, sum: u32, radius_sq: u32) -> bool {
        if gather.format.half_steps() {
            gather.is_within::<true>(sum, radius_sq)
        } else {
            gather.is_within::<false>(sum, radius_sq)
        }
    }

    /// Every pair of places on one axis: the squares against the distance in halves of a fine
    /// step, where it is an integer, from the definition alone.
    #[test]
    fn squares_are_exact_or_out_of_range_at_every_difference() {
        for format in small_formats() {
            let gather = LocalGather::new(&format).unwrap();
            let x = format.query_extra_bits;
            let edge = i64::from(format.edge_steps());
            let quarters_of_limit = (2 * i64::from(format.radius_steps())).pow(2);
            let three_quarters_left = i64::from(x > 0);
            for query in 0..4 * edge {
                for place in 0..4 * (1 << format.position_bits) {
                    let cell = (place % (1 << format.position_bits)) as u16;
                    let offset = (place >> format.position_bits) as u32;
                    let halves = (2 * query + 1) - ((2 * place + 1) << x);
                    let position = LocalQuery {
                        position: [query as u32; 3],
                    };
                    let relative = gather.relative(&position, [offset; 3])[0];
                    let square = i64::from(square(&gather, relative - gather.centre(cell)));
                    let quarters = 4 * square + three_quarters_left;
                    let is_exact = quarters == halves * halves;
                    let both_out = quarters > quarters_of_limit
                        && halves * halves > quarters_of_limit
                        && square + three_quarters_left > i64::from(gather.radius_sq);
                    assert!(is_exact || both_out, "{format:?} {query} {place}");
                }
            }
        }
    }

    /// Every triple of clamped differences: the compare against f64, which is exact at this size.
    #[test]
    fn the_compare_is_exact_at_every_distance() {
        for format in small_formats().filter(|format| format.radius_bits() <= 5) {
            let gather = LocalGather::new(&format).unwrap();
            let half = if format.query_extra_bits > 0 {
                0.5
            } else {
                0.0
            };
            let radius_sq = f64::from(format.radius_steps()).powi(2);
            let all = 0..=gather.clamp as i32;
            for (x, y) in all.clone().flat_map(|x| all.clone().map(move |y| (x, y))) {
                for z in all.clone() {
                    let sum: u32 = [x, y, z].map(|m| square(&gather, m)).iter().sum();
                    let distance_sq: f64 = [x, y, z]
                        .map(|m| (f64::from(m) + half).powi(2))
                        .iter()
                        .sum();
                    let decided = is_within(&gather, sum, gather.radius_sq);
                    assert_eq!(decided, distance_sq <= radius_sq, "{format:?} {x} {y} {z}");
                    // Up to R, d^2 rounded up is the smallest radius that holds the photon.
                    let reaches = distance_sq.ceil() as u32;
                    if reaches <= gather.radius_sq {
                        assert!(is_within(&gather, sum, reaches));
                        assert!(reaches == 0 || !is_within(&gather, sum, reaches - 1));
                    }
                }
            }
        }
    }

    #[test]
    fn below_a_half_step_the_inversion_gives_the_same_as_above() {
        let format = small_formats().find(|format| format.query_extra_bits == 1);
        let gather = LocalGather::new(&format.unwrap()).unwrap();
        for d in 0..40 {
            assert_eq!(square(&gather, d), square(&gather, !d));
        }
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
        let message = LocalGather::new(&format).unwrap_err().to_string();
        assert!(message.contains("mantissa_bits is 0"), "{message}");
    }
}
