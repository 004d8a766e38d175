//! The portable implementation of [`Lanes`]: plain loops over arrays, which compilers vectorise.

use super::cube::{Part, block_on};
use super::frame::Frame;
use super::lanes::{
    BYTES_NOWHERE, Boxes, Lanes, OfBytes, OfFlatBytes, OfWords, Positions, WORDS_NOWHERE,
};
use super::leaf::LEAF;
use super::store::{LeafPlanes, Words};
use super::tray::TRAY;

/// Words of a sum: as many as fit a vector register of the processors that this code is for.
const WORDS: usize = 8;

#[derive(Copy, Clone, Debug)]
pub(super) struct Portable;

/// The sums of a tray. Each word is the sum of every eighth photon.
#[derive(Copy, Clone, Debug)]
pub(super) struct Sums<const PLANES: usize> {
    planes: [[u16; WORDS]; PLANES],
    count: [u16; WORDS],
}

#[inline(always)]
fn total(sum: [u16; WORDS]) -> u32 {
    let mut total = 0;
    for word in sum {
        total += u32::from(word);
    }
    total
}

/// The sum with the mantissas of the photons in range.
#[inline(always)]
fn added(mut sum: [u16; WORDS], in_range: &[u16; LEAF], mantissas: &[u16; LEAF]) -> [u16; WORDS] {
    for first in (0..LEAF).step_by(WORDS) {
        for word in 0..WORDS {
            sum[word] += in_range[first + word] & mantissas[first + word];
        }
    }
    sum
}

/// The count with the photons in range, whose masks are -1.
#[inline(always)]
fn counted(mut count: [u16; WORDS], in_range: &[u16; LEAF]) -> [u16; WORDS] {
    for first in (0..LEAF).step_by(WORDS) {
        for word in 0..WORDS {
            count[word] = count[word].wrapping_sub(in_range[first + word]);
        }
    }
    count
}

impl Lanes for Portable {
    /// All ones where a photon is in range.
    type Mask = [u16; LEAF];
    type Powers<const PLANES: usize> = [[u16; LEAF]; PLANES];
    type Sums<const PLANES: usize> = Sums<PLANES>;

    #[inline(always)]
    fn powers<const PLANES: usize>(self, planes: &LeafPlanes) -> [[u16; LEAF]; PLANES] {
        let mut powers = [[0; LEAF]; PLANES];
        for (index, power) in powers.iter_mut().enumerate() {
            for (word, byte) in power.iter_mut().zip(planes.mantissas(index)) {
                *word = (*byte).into();
            }
        }
        powers
    }

    #[inline(always)]
    fn no_sums<const PLANES: usize>(self) -> Sums<PLANES> {
        Sums {
            planes: [[0; WORDS]; PLANES],
            count: [0; WORDS],
        }
    }

    #[inline(always)]
    fn add<const PLANES: usize>(
        self,
        mut sums: Sums<PLANES>,
        in_range: [u16; LEAF],
        powers: &[[u16; LEAF]; PLANES],
    ) -> Sums<PLANES> {
        sums.count = counted(sums.count, &in_range);
        for (sum, mantissas) in sums.planes.iter_mut().zip(powers) {
            *sum = added(*sum, &in_range, mantissas);
        }
        sums
    }

    #[inline(always)]
    fn totals<const PLANES: usize>(self, sums: Sums<PLANES>) -> ([u32; PLANES], u32) {
        let mut totals = [0; PLANES];
        for (each, sum) in totals.iter_mut().zip(sums.planes) {
            *each = total(sum);
        }
        (totals, total(sums.count))
    }

    #[inline(always)]
    fn meeting(self, boxes: &Boxes, low: [u16; 3], high: [u16; 3]) -> u32 {
        let mut apart = [false; TRAY];
        for axis in 0..3 {
            for (leaf, apart) in apart.iter_mut().enumerate() {
                *apart |= boxes.high[axis][leaf] < low[axis];
                *apart |= boxes.low[axis][leaf] > high[axis];
            }
        }
        let mut meeting = 0;
        for (leaf, apart) in apart.iter().enumerate() {
            meeting |= u32::from(!apart) << leaf;
        }
        meeting
    }

    #[inline(always)]
    fn inside(self, part: Part, blocks: &Words) -> u32 {
        let mut inside = 0;
        for (lane, block) in blocks.chunks_exact(2).enumerate() {
            let block = u16::from_le_bytes([block[0], block[1]]);
            inside |= u32::from(part.contains(block)) << lane;
        }
        inside
    }

    #[inline(always)]
    fn touched(self, boxes: &Boxes, query: [u16; 3]) -> u32 {
        let mut sums = [0_u16; TRAY];
        let bounds = boxes.low.iter().zip(&boxes.high);
        for ((low, high), query) in bounds.zip(query) {
            for ((low, high), sum) in low.iter().zip(high).zip(&mut sums) {
                let outside = low.saturating_sub(query) | query.saturating_sub(*high);
                let m = (outside >> boxes.shift).min(255);
                *sum = sum.saturating_add(m * m);
            }
        }
        let mut touched = 0;
        for (leaf, sum) in sums.iter().enumerate() {
            touched |= u32::from(*sum <= boxes.largest) << leaf;
        }
        touched
    }
}

// The largest sum of the mantissas that one word adds up fits the word.
const _: () = assert!(255 * (LEAF / WORDS) * TRAY <= u16::MAX as usize);

/// The coordinates of a leaf's photons, by axis.
type Places = [[i16; LEAF]; 3];

/// A query's coordinates, in a format of bytes or of words.
#[derive(Copy, Clone, Debug)]
pub(super) struct Query {
    frame: Frame,
    place: [i16; 3],
}

/// The coordinates of a leaf's photons; `centre` returns a photon's steps from the corner of its cube.
#[inline(always)]
fn places(
    photons: usize,
    nowhere: i16,
    corner: [i16; 3],
    centre: impl Fn(usize, usize) -> i16,
) -> Places {
    let mut places = [[nowhere; LEAF]; 3];
    for (axis, places) in places.iter_mut().enumerate() {
        for (lane, place) in places.iter_mut().enumerate().take(photons) {
            *place = corner[axis] + centre(axis, lane);
        }
    }
    places
}

impl Positions<Portable> for OfBytes {
    type Photons = Places;
    type Query = Query;

    #[inline(always)]
    fn photons(
        _: Portable,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places {
        let positions = axes.map(|axis| planes.bytes(axis));
        places(planes.photons(), BYTES_NOWHERE, corner, |axis, lane| {
            let block = block_on(planes.block(lane), axes[axis]) as i16;
            (block << frame.edge_bits()) + i16::from(positions[axis][lane])
        })
    }

    #[inline(always)]
    fn query(_: Portable, frame: &Frame, place: [i16; 3], _: i16) -> Query {
        Query {
            frame: *frame,
            place,
        }
    }

    #[inline(always)]
    fn in_range(_: Portable, photons: &Places, query: &Query) -> [u16; LEAF] {
        in_range::<3>(query, photons, [0; LEAF])
    }
}

impl Positions<Portable> for OfFlatBytes {
    type Photons = Places;
    /// With the square on the last axis.
    type Query = (Query, u16);

    #[inline(always)]
    fn photons(
        portable: Portable,
        frame: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places {
        <OfBytes as Positions<Portable>>::photons(portable, frame, planes, axes, corner)
    }

    #[inline(always)]
    fn query(_: Portable, frame: &Frame, place: [i16; 3], shared: i16) -> (Query, u16) {
        let query = Query {
            frame: *frame,
            place,
        };
        (query, byte_square(&query, 2, shared))
    }

    #[inline(always)]
    fn in_range(_: Portable, photons: &Places, (query, square): &(Query, u16)) -> [u16; LEAF] {
        in_range::<2>(query, photons, [*square; LEAF])
    }
}

/// m^2 or m (m + 1) in a word. A distance of 255 stands for all larger ones and is out of range.
#[inline(always)]
fn byte_square(query: &Query, axis: usize, photon: i16) -> u16 {
    let m = query.frame.distance(query.place[axis], photon);
    let m = (m as i16).min(255) as u16;
    m * (m + query.frame.half() as u16)
}

/// A mask of the photons for which the sum of these squares and those of the first axes is in range. A
/// saturated sum is out of range.
#[inline(always)]
fn in_range<const AXES: usize>(
    query: &Query,
    photons: &Places,
    mut sums: [u16; LEAF],
) -> [u16; LEAF] {
    for (axis, photons) in photons.iter().enumerate().take(AXES) {
        for (sum, photon) in sums.iter_mut().zip(photons) {
            *sum = sum.saturating_add(byte_square(query, axis, *photon));
        }
    }
    // The largest sum in range is at most 254^2.
    let largest = query.frame.largest as u16;
    let mut in_range = [0; LEAF];
    for (in_range, sum) in in_range.iter_mut().zip(sums) {
        *in_range = if sum <= largest { u16::MAX } else { 0 };
    }
    in_range
}

impl Positions<Portable> for OfWords {
    type Photons = Places;
    type Query = Query;

    #[inline(always)]
    fn photons(
        _: Portable,
        _: &Frame,
        planes: &LeafPlanes,
        axes: [usize; 3],
        corner: [i16; 3],
    ) -> Places {
        let words = axes.map(|axis| planes.words(axis));
        places(planes.photons(), WORDS_NOWHERE, corner, |axis, lane| {
            i16::from_le_bytes([words[axis][2 * lane], words[axis][2 * lane + 1]])
        })
    }

    #[inline(always)]
    fn query(_: Portable, frame: &Frame, place: [i16; 3], _: i16) -> Query {
        Query {
            frame: *frame,
            place,
        }
    }

    #[inline(always)]
    fn in_range(_: Portable, photons: &Places, query: &Query) -> [u16; LEAF] {
        let mut sums = [0_u32; LEAF];
        let frame = &query.frame;
        for (photons, place) in photons.iter().zip(query.place) {
            for (sum, photon) in sums.iter_mut().zip(photons) {
                let m = u32::from(frame.distance(place, *photon).min(Frame::FURTHEST));
                *sum += m * (m + frame.half() as u32);
            }
        }
        let mut in_range = [0; LEAF];
        for (in_range, sum) in in_range.iter_mut().zip(sums) {
            *in_range = if sum <= frame.largest { u16::MAX } else { 0 };
        }
        in_range
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Numbers, PHOTON_FORMATS, PhotonFormat};

    use super::super::cube::centre;
    use super::*;

    /// Formats of bytes with the fewest and with the most bits per radius, half steps included.
    fn formats() -> impl Iterator<Item = PhotonFormat> {
        let bits = [(4, 0), (4, 1), (4, 2), (8, 0), (7, 1), (6, 2)];
        let format = |(position_bits, query_extra_bits)| PhotonFormat {
            position_bits,
            query_extra_bits,
            ..PHOTON_FORMATS[0]
        };
        bits.into_iter().map(format)
    }

    /// A query on one place of all axes, in fine steps from the middle of the frame.
    fn query(format: &PhotonFormat, radius_sq: u32, place: i16) -> Query {
        Query {
            frame: Frame::new(format, 1, radius_sq),
            place: [place; 3],
        }
    }

    /// Compares the squares, at every pair of places on one axis, with the distance from the definition. In
    /// halves of a fine step that distance is an integer.
    #[test]
    fn squares_are_exact_or_out_of_range_at_every_difference() {
        for format in formats() {
            let x = format.query_extra_bits;
            let largest = format.largest_in_range();
            let quarters_of_limit = (2 * i64::from(format.radius_steps())).pow(2);
            let three_quarters_left = i64::from(x > 0);
            let frame = Frame::new(&format, 1, largest);
            for at in 0..4 * format.edge_steps() {
                let query = query(&format, largest, frame.place([at as u16; 3])[0]);
                for place in 0..4 << format.position_bits {
                    let cell = (place % (1 << format.position_bits)) as u16;
                    let [corner, ..] = frame.corner([(place >> format.position_bits) as u8; 3]);
                    let photon = corner + centre(&format, cell.into()) as i16;
                    let square = i64::from(byte_square(&query, 0, photon));
                    let halves = (2 * i64::from(at) + 1) - ((2 * i64::from(place) + 1) << x);
                    let quarters = 4 * square + three_quarters_left;
                    let is_exact = quarters == halves * halves;
                    let both_out = halves * halves > quarters_of_limit && square > largest.into();
                    assert!(is_exact || both_out, "{format:?} {at} {place}");
                }
            }
        }
    }

    /// Compares the decision, at every triple of clamped differences, with f64, which is exact at this size.
    #[test]
    fn the_compare_is_exact_at_every_distance() {
        for format in formats().filter(|format| format.radius_bits() <= 5) {
            let numbers = Numbers::from(&format);
            let half = if format.half_steps() { 0.5 } else { 0.0 };
            let largest = format.radius_steps().pow(2);
            let all = 0..=format.radius_steps() as i16 + 1;
            for (x, y) in all.clone().flat_map(|x| all.clone().map(move |y| (x, y))) {
                for z in all.clone() {
                    // The query is x, y and z steps above the photon.
                    let photon = [x, y, z].map(|m| [-m; LEAF]);
                    let is_within = |radius_sq| {
                        let query = numbers.radius_word(radius_sq);
                        let query = query.map(|word| self::query(&format, word, 0));
                        query.is_some_and(|query| in_range::<3>(&query, &photon, [0; LEAF])[0] != 0)
                    };
                    let squares = [x, y, z].map(|m| (f64::from(m) + half).powi(2));
                    let distance_sq: f64 = squares.iter().sum();
                    let decided = is_within(largest);
                    let expected = distance_sq <= f64::from(largest);
                    assert_eq!(decided, expected, "{format:?} {x} {y} {z}");
                    // Up to R, d^2 rounded up is the smallest squared radius at which the photon is in range.
                    let reaches = distance_sq.ceil() as u32;
                    if reaches <= largest {
                        assert!(is_within(reaches));
                        assert!(reaches == 0 || !is_within(reaches - 1));
                    }
                }
            }
        }
    }

    #[test]
    fn below_a_half_step_the_inversion_gives_the_same_as_above() {
        let format = formats().find(|format| format.query_extra_bits == 1);
        let query = query(&format.unwrap(), 9, 0);
        for d in 0..40_i16 {
            assert_eq!(byte_square(&query, 0, -d), byte_square(&query, 0, -!d));
        }
    }
}
