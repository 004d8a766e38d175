//! The frame of a gather: the coordinates of photons and queries on one axis, as the kernel uses them.

use photoncube_spec::PhotonFormat;

use super::cube::FRAME_CUBES;
use super::gather::PlacedQuery;
use super::windows::in_frame;

/// The rules that all photons and queries of a gather share.
///
/// Coordinates are fine steps from the middle of the frame, which is also the middle of the queries' cube.
/// They lie within 3 / 2 of 2^14 on either side. With d the difference of a query's and a photon's
/// coordinate, the distance on the axis is d or, on half steps, d + 1/2.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    /// Blocks on a cube's edge.
    blocks: u32,
    /// Fine steps of a block's edge, as a power of two.
    edge_bits: u32,
    /// Whether queries are half a step above their coordinates.
    pub half_steps: bool,
    /// The largest sum of squares, or half squares, in range.
    pub largest: u32,
}

impl Frame {
    /// The value at which distances may saturate. It is larger than any radius, and three squares of it fit
    /// 31 bits.
    pub const FURTHEST: u16 = (1 << 14) - 1;

    /// The frame of a format with cubes of `blocks` on an edge, for queries of this `radius_sq`.
    pub fn new(format: &PhotonFormat, blocks: u32, radius_sq: u32) -> Self {
        Self {
            blocks,
            edge_bits: format.radius_bits(),
            half_steps: format.half_steps(),
            largest: radius_sq,
        }
    }

    /// The lowest corner of the cube at `offset`, in fine steps from the middle of the frame.
    #[inline(always)]
    pub fn corner(&self, offset: [u8; 3]) -> [i16; 3] {
        let cube = (self.blocks << self.edge_bits) as i32;
        offset.map(|cubes| (i32::from(cubes) * cube - self.middle()) as i16)
    }

    /// The position of a query in fine steps from the frame's corner, which is less than two cubes of 2^14.
    ///
    /// # Panics
    /// Where a fraction is outside its block.
    #[inline]
    pub fn position(&self, query: &PlacedQuery) -> [u16; 3] {
        let [x, y, z] = query.fraction;
        let outside = u32::from(x | y | z) >> self.edge_bits;
        assert_eq!(outside, 0, "{query:?} is outside its block");
        let block = in_frame(query.block, self.blocks);
        std::array::from_fn(|axis| (block[axis] << self.edge_bits) as u16 + query.fraction[axis])
    }

    /// The coordinates of a query whose `position` is in fine steps from the frame's corner.
    #[inline(always)]
    pub fn place(&self, position: [u16; 3]) -> [i16; 3] {
        position.map(|at| (i32::from(at) - self.middle()) as i16)
    }

    #[inline(always)]
    fn middle(&self) -> i32 {
        ((FRAME_CUBES * self.blocks) << self.edge_bits) as i32 / 2
    }

    /// The number of bits of a place in a block.
    #[inline(always)]
    pub fn edge_bits(&self) -> u32 {
        self.edge_bits
    }

    /// 1 on half steps, otherwise 0.
    pub fn half(&self) -> i16 {
        self.half_steps.into()
    }

    /// m, the distance in whole fine steps: |d|, or ~d for negative d on half steps.
    #[inline(always)]
    pub fn distance(&self, query: i16, photon: i16) -> u16 {
        let d = query.saturating_sub(photon);
        // All ones for negative d. |-2^15| wraps to 2^15, which is correct as an unsigned value.
        let sign = d >> 15;
        (d ^ sign).wrapping_sub(sign & (self.half() - 1)) as u16
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::PHOTON_FORMATS;

    use super::*;

    /// Compares the distances with the spec's definition over the whole frame, for the smallest and the
    /// largest formats.
    #[test]
    fn distances_are_the_specs() {
        for (position_bits, query_extra_bits) in [(4, 0), (4, 2), (8, 0), (7, 1), (12, 0), (12, 2)]
        {
            let format = PhotonFormat {
                position_bits,
                query_extra_bits,
                ..PHOTON_FORMATS[0]
            };
            let frame = Frame::new(&format, 1, 9);
            let edge = format.edge_steps();
            let places = || {
                (0..3 * edge)
                    .step_by(1 + edge as usize / 50)
                    .chain([3 * edge - 1])
            };
            for query in places().filter(|at| (edge..2 * edge).contains(at)) {
                for photon in places() {
                    let offset = [(photon / edge) as u8; 3];
                    let [corner, ..] = frame.corner(offset);
                    let photon_at = corner + (photon % edge) as i16;
                    let d = query as i32 - photon as i32;
                    let m = if query_extra_bits > 0 && d < 0 {
                        !d
                    } else {
                        d.abs()
                    };
                    let found = frame.distance(frame.place([query as u16; 3])[0], photon_at);
                    assert_eq!(i32::from(found), m, "{format} {query} {photon}");
                }
            }
        }
    }
}
