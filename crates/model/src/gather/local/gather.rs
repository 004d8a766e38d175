//! The direct gather of a photon format: the sum over the photons in range, in the format's integers.

use photoncube_spec::{
    FormatError, LocalQuery, LocalSums, PhotonBlock, PhotonFormat, PhotonRecord, Widths,
};

use super::limits::LocalLimits;
use crate::gather::{CountError, GatherError};

/// The gather of one format: eq. 2 of Ryu, Kim, Lee without its constant factor. The search radius is the
/// format's or any smaller one.
#[derive(Copy, Clone, Debug)]
pub struct LocalGather {
    format: PhotonFormat,
    limits: LocalLimits,
    /// The largest clamped difference.
    clamp: u32,
    /// The search radius squared, R^2.
    radius_sq: u32,
    /// The largest sum of (half) squares that is represented; larger sums saturate at it.
    saturated: u32,
}

impl LocalGather {
    /// Makes the gather of `format`.
    ///
    /// # Errors
    /// The format is not legal.
    pub fn new(format: &PhotonFormat) -> Result<Self, FormatError> {
        let limits = LocalLimits::of(format)?;
        let widths = Widths::of_format(format);
        Ok(Self {
            format: *format,
            limits,
            clamp: (1 << format.radius_bits()) - 1,
            radius_sq: format.radius_steps().pow(2),
            saturated: (1 << widths.saturated_distance) - 1,
        })
    }

    /// The format that this gather is for.
    #[must_use]
    pub fn format(&self) -> &PhotonFormat {
        &self.format
    }

    /// The limits of the format's values.
    #[must_use]
    pub fn limits(&self) -> &LocalLimits {
        &self.limits
    }

    /// The format's squared search radius R^2 in squared fine steps, the largest that [`Self::gather_within`]
    /// accepts.
    #[must_use]
    pub fn radius_sq(&self) -> u32 {
        self.radius_sq
    }

    /// Sums power and number of the photons in range. The sums are exact and independent of the order of the
    /// photons.
    ///
    /// # Errors
    /// A value does not fit the format, or there are more photons than its sums are sized for.
    pub fn gather<'b>(
        &self,
        query: &LocalQuery,
        blocks: impl IntoIterator<Item = PhotonBlock<'b>>,
    ) -> Result<LocalSums, GatherError> {
        self.gather_within(query, self.radius_sq, blocks)
    }

    /// Sums power and number of the photons with d^2 <= `radius_sq` (squared fine steps), a search radius of
    /// the caller's choice. The decision is exact, as it is at R. The search for the k-th photon by bisection
    /// and the ladder of radii use one such gather for each radius.
    ///
    /// # Errors
    /// As for [`Self::gather`], or `radius_sq` is over [`Self::radius_sq`]. Beyond that radius, photons
    /// outside the blocks around the query may be in range.
    pub fn gather_within<'b>(
        &self,
        query: &LocalQuery,
        radius_sq: u32,
        blocks: impl IntoIterator<Item = PhotonBlock<'b>>,
    ) -> Result<LocalSums, GatherError> {
        self.limits.check_query(query)?;
        self.limits.check_radius_sq(radius_sq)?;
        let mut sums = LocalSums::default();
        let mut given = 0;
        for block in blocks {
            given += block.photons.len() as u64;
            // Photons past the limit are only counted, for the error.
            if given <= self.format.max_photons {
                self.limits.check_block(&block)?;
                self.add_block(query, radius_sq, &block, &mut sums)?;
            }
        }
        self.check_count(given)?;
        Ok(sums)
    }

    /// Whether the photon of a block at `offset` is in range of the query. All values must be within
    /// [`Self::limits`].
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
    ) -> Result<(), GatherError> {
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

    /// Checks that the sums are sized for `found` photons.
    pub(crate) fn check_count(&self, found: u64) -> Result<(), CountError> {
        if found <= self.format.max_photons {
            return Ok(());
        }
        Err(CountError {
            found,
            max_photons: self.format.max_photons,
            kind: "format",
            name: self.format.name(),
        })
    }

    /// The query's position relative to a block's corner. All photons of the block share it.
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

    /// Whether a sum of (half) squares is in range. On half steps d^2 is the sum plus 3/4, which is at most
    /// an integer exactly where the sum plus 1 is.
    fn is_within<const HALF_STEPS: bool>(&self, sum: u32, radius_sq: u32) -> bool {
        sum.min(self.saturated) + u32::from(HALF_STEPS) <= radius_sq
    }

    /// The coordinate of a photon in this cell: its index, or the fine grid line through its cell's middle.
    fn centre(&self, cell: u16) -> i32 {
        let extra = self.format.query_extra_bits;
        (i32::from(cell) << extra) + ((1 << extra) >> 1)
    }

    /// The square of a clamped difference, or its half square on half steps.
    fn square<const HALF_STEPS: bool>(&self, difference: i32) -> u32 {
        if HALF_STEPS {
            // The result is d for d >= 0 and ~d for d < 0: the mask of the sign inverts.
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

    /// Formats with the fewest position bits, half steps included.
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

    /// Compares the squares, at every pair of places on one axis, with the distance from the definition. In
    /// halves of a fine step that distance is an integer.
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

    /// Compares the decision, at every triple of clamped differences, with f64, which is exact at this size.
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
                    // Up to R, d^2 rounded up is the smallest squared radius at which the photon is in range.
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
