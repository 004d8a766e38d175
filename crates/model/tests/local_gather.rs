//! Compares the gather of every photon format with the rules in their plainest form, and tests it at the
//! limits.

mod radius;

use photoncube_model::{Gather, GatherError, pack, unpack};
use photoncube_spec::{
    Channels, Exponent, Numbers, PHOTON_FORMATS, PhotonBlock, PhotonFormat, PhotonRecord,
    PowerFormat, Query, Rounding, Sums, Widths, find_photon_format,
};
use proptest::prelude::*;

/// A block that owns its photons.
#[derive(Clone, Debug)]
struct Block {
    offset: [u32; 3],
    exponent: u8,
    photons: Vec<PhotonRecord>,
}

impl Block {
    fn view(&self) -> PhotonBlock<'_> {
        PhotonBlock {
            offset: self.offset,
            exponent: self.exponent,
            photons: &self.photons,
        }
    }
}

fn gather(format: &PhotonFormat, query: &Query, blocks: &[Block]) -> Sums {
    let gather = Gather::new(&format.into()).unwrap();
    gather.sums(query, blocks.iter().map(Block::view)).unwrap()
}

/// 4 d^2 of a photon in squared fine steps, an integer. It is computed from the middles of both cells in
/// halves of a fine step, without clamp, half squares or saturation.
fn quarters(format: &PhotonFormat, query: &Query, offset: [u32; 3], record: &PhotonRecord) -> i128 {
    let x = format.query_extra_bits;
    (0..3)
        .map(|axis| {
            let place = (i128::from(offset[axis]) << format.position_bits)
                + i128::from(record.position[axis]);
            let halves = (2 * i128::from(query.position[axis]) + 1) - ((2 * place + 1) << x);
            halves * halves
        })
        .sum()
}

/// Whether a photon is in range of the format's own radius, by the plain geometry.
fn naively_in_range(
    format: &PhotonFormat,
    query: &Query,
    offset: [u32; 3],
    record: &PhotonRecord,
) -> bool {
    quarters(format, query, offset, record) <= (2 * i128::from(format.radius_steps())).pow(2)
}

fn naive(format: &PhotonFormat, query: &Query, blocks: &[Block]) -> ([i128; 3], i128) {
    let (mut power, mut count) = ([0; 3], 0);
    for block in blocks {
        for record in &block.photons {
            let weight = i128::from(naively_in_range(format, query, block.offset, record));
            let scale = 1_i128 << (i32::from(block.exponent) + i32::from(record.exponent));
            for (power, mantissa) in power.iter_mut().zip(record.mantissa) {
                *power += weight * i128::from(mantissa) * scale;
            }
            count += weight;
        }
    }
    (power, count)
}

/// The largest exponents of a block and of a photon.
fn exponents(format: &PhotonFormat) -> (u8, u8) {
    let largest = format.power.exponent_range() as u8;
    match format.power.exponent {
        Exponent::None => (0, 0),
        Exponent::Block { .. } => (largest, 0),
        Exponent::Photon { .. } => (0, largest),
    }
}

/// Every legal format, listed or not.
fn any_format() -> impl Strategy<Value = PhotonFormat> {
    let exponent = prop_oneof![
        Just(Exponent::None),
        (1..=8_u32).prop_map(|bits| Exponent::Block { bits }),
        (1..=8_u32).prop_map(|bits| Exponent::Photon { bits }),
    ];
    let channels = prop::sample::select(&[Channels::Mono, Channels::Rgb]);
    let rounding = Rounding::Nearest;
    (4..=12_u32, 0..=2_u32, channels, 1..=16_u32, exponent).prop_map(
        move |(position_bits, query_extra_bits, channels, mantissa_bits, exponent)| PhotonFormat {
            position_bits,
            query_extra_bits,
            power: PowerFormat {
                channels,
                mantissa_bits,
                exponent,
                rounding,
            },
            ..*DEFAULT
        },
    )
}

fn record(format: PhotonFormat) -> impl Strategy<Value = PhotonRecord> {
    let widths = Widths::of_format(&format);
    let position = prop::array::uniform3(0..1_u16 << widths.position);
    let mantissa = prop::array::uniform3(0..=u16::MAX >> (16 - widths.mantissa));
    let channels = format.power.channels.names().len();
    (position, mantissa, 0..=exponents(&format).1).prop_map(
        move |(position, mut mantissa, exponent)| {
            mantissa[channels..].fill(0);
            PhotonRecord {
                position,
                mantissa,
                exponent,
            }
        },
    )
}

fn block(format: PhotonFormat) -> impl Strategy<Value = Block> {
    let photons = prop::collection::vec(record(format), 0..40);
    let offset = prop::array::uniform3(0..3_u32);
    (offset, 0..=exponents(&format).0, photons).prop_map(|(offset, exponent, photons)| Block {
        offset,
        exponent,
        photons,
    })
}

fn case() -> impl Strategy<Value = (PhotonFormat, Query, Vec<Block>)> {
    let named = prop::sample::select(PHOTON_FORMATS);
    prop_oneof![named, any_format()].prop_flat_map(|format| {
        let edge = format.edge_steps();
        let query = prop::array::uniform3(edge..2 * edge);
        let query = query.prop_map(move |position| query_at(&format, position));
        (
            Just(format),
            query,
            prop::collection::vec(block(format), 0..8),
        )
    })
}

proptest! {
    #[test]
    fn equals_the_rules_without_clamp_or_saturation((format, query, blocks) in case()) {
        let sums = gather(&format, &query, &blocks);
        let (power, count) = naive(&format, &query, &blocks);
        prop_assert_eq!(sums.power.map(|p| p as i128), power);
        prop_assert_eq!(i128::from(sums.count), count);
    }

    #[test]
    fn the_order_never_matters((format, query, blocks) in case(), seed in any::<u64>()) {
        let mut shuffled = blocks.clone();
        shuffled.reverse();
        for block in &mut shuffled {
            block.photons.sort_by_key(|p| {
                let mixed = p.position.iter().fold(seed, |h, &v| h.wrapping_mul(31) ^ u64::from(v));
                mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15)
            });
        }
        prop_assert_eq!(gather(&format, &query, &blocks), gather(&format, &query, &shuffled));
    }

    #[test]
    fn records_pack_and_unpack(
        (format, record) in any_format()
            .prop_flat_map(|format| (Just(format), record(format)))
    ) {
        let bits = pack(&format, &record).unwrap();
        prop_assert!(bits >> Widths::of_format(&format).bits_per_photon == 0);
        prop_assert_eq!(unpack(&format, bits), Ok(record));
    }

    /// Bits that unpack are packed to these bits again, so no two bit patterns are one record.
    #[test]
    fn bits_unpack_to_one_record_or_none(
        format in any_format(),
        bits in any::<u128>(),
    ) {
        let width = Widths::of_format(&format).bits_per_photon;
        let bits = bits & ((1 << width) - 1);
        if let Ok(record) = unpack(&format, bits) {
            prop_assert_eq!(pack(&format, &record), Ok(bits));
        }
    }
}

const DEFAULT: &PhotonFormat = &PHOTON_FORMATS[0];

/// A query with the format's own radius.
fn query_at(format: &PhotonFormat, position: [u32; 3]) -> Query {
    Query {
        position,
        radius_sq: format.largest_in_range(),
    }
}

fn photon(position: [u16; 3]) -> PhotonRecord {
    PhotonRecord {
        position,
        mantissa: [3, 2, 1],
        exponent: 0,
    }
}

/// Tests all integer points on the sphere around the query, and their neighbours one step further out. Floats
/// decide about half of such ties wrongly.
#[test]
fn exact_boundary_ties_are_all_in_range_and_one_step_further_none() {
    let gather = Gather::new(&DEFAULT.into()).unwrap();
    let radius = DEFAULT.radius_steps() as i32;
    let query = query_at(DEFAULT, [256 + 255; 3]);
    let mut ties = 0;
    for (dx, dy) in (0..=radius).flat_map(|x| (0..=radius).map(move |y| (x, y))) {
        let rest = radius * radius - dx * dx - dy * dy;
        if rest < 0 || rest.isqrt().pow(2) != rest {
            continue;
        }
        ties += 1;
        let at = |dz: i32| photon([dx, dy, dz].map(|d| (255 - d) as u16));
        assert!(gather.in_range(&query, [1; 3], &at(rest.isqrt())));
        assert!(!gather.in_range(&query, [1; 3], &at(rest.isqrt() + 1)));
    }
    // A separate count: points of the sphere of radius 254 with no negative coordinate.
    assert_eq!(ties, 99);
}

/// Tests distances from corner to corner of the frame, where three squares exceed the distance's width. A sum
/// that wrapped would be small.
#[test]
fn distances_saturate_and_never_wrap() {
    for format in PHOTON_FORMATS {
        let gather = Gather::new(&format.into()).unwrap();
        let largest = ((1_u32 << format.position_bits) - 1) as u16;
        let query = query_at(format, [format.edge_steps(); 3]);
        for offset in [[0; 3], [3; 3], [0, 3, 1], [1, 1, 3]] {
            for corner in [0, largest] {
                let record = photon([corner; 3]);
                let expected = naively_in_range(format, &query, offset, &record);
                assert_eq!(gather.in_range(&query, offset, &record), expected);
            }
        }
    }
}

#[test]
fn none_one_and_a_quarter_million_identical_photons() {
    let query = query_at(DEFAULT, [300; 3]);
    let many = |count| Block {
        offset: [1; 3],
        exponent: 0,
        photons: vec![photon([44; 3]); count],
    };
    assert_eq!(gather(DEFAULT, &query, &[]), Sums::default());
    for count in [0, 1, 250_000] {
        let sums = gather(DEFAULT, &query, &[many(count)]);
        let count = count as u64;
        assert_eq!(sums.count, count);
        assert_eq!(sums.power, [3, 2, 1].map(|p| p * u128::from(count)));
    }
}

#[test]
fn the_largest_declared_count_at_full_scale_is_exact_and_one_more_is_refused() {
    for format in PHOTON_FORMATS {
        let widths = Widths::of_format(format);
        let (block_exponent, exponent) = exponents(format);
        let full = PhotonRecord {
            position: [0; 3],
            mantissa: [u16::MAX >> (16 - widths.mantissa); 3],
            exponent,
        };
        // The few photons are repeated, because the count matters and not the memory.
        let photons = vec![full; 1 << 10];
        let block = PhotonBlock {
            offset: [1; 3],
            exponent: block_exponent,
            photons: &photons,
        };
        let gather = Gather::new(&format.into()).unwrap();
        let query = query_at(format, [format.edge_steps(); 3]);
        let repeat = format.max_photons as usize >> 10;
        let sums = gather
            .sums(&query, std::iter::repeat_n(block, repeat))
            .unwrap();
        let full_scale = ((1_u128 << widths.mantissa) - 1) << format.power.exponent_range();
        assert_eq!(sums.power, [full_scale << 20; 3]);
        assert!(sums.power[0] < 1 << widths.sum);
        assert_eq!(sums.count, format.max_photons);
        let error = gather
            .sums(&query, std::iter::repeat_n(block, repeat + 2))
            .unwrap_err();
        assert!(matches!(error, GatherError::Count(_)));
        let message = error.to_string();
        assert!(message.contains("2048 over the 1048576"), "{message}");
    }
}

/// A photon of the smallest power beside one of full scale: both are in the sum.
#[test]
fn powers_of_1e6_to_1_keep_their_small_ones() {
    let of = |mantissa, exponent| PhotonRecord {
        mantissa: [mantissa; 3],
        exponent,
        ..photon([0; 3])
    };
    let block = Block {
        offset: [1; 3],
        exponent: 0,
        photons: vec![of(255, 24), of(1, 0), of(255, 4)],
    };
    let sums = gather(DEFAULT, &query_at(DEFAULT, [256; 3]), &[block]);
    assert_eq!(sums.power, [(255 << 24) + 1 + (255 << 4); 3]);
}

#[test]
fn a_bright_photon_just_outside_adds_nothing() {
    // The number of cells along x that are in range of the first fine cell. Their middles are c + 1/2 - 1/2,
    // 2c + 1 - 1/2 and 4c + 2 - 1/2 fine steps away, and the radius is 254 fine steps.
    for (name, expected) in [
        ("local8-rgb8e5", 255),
        ("local7x1-rgb8e5", 127),
        ("local6x2-rgb8e5", 64),
    ] {
        let format = &find_photon_format(name).unwrap();
        let query = query_at(format, [format.edge_steps(); 3]);
        let cells = 1_u16 << format.position_bits;
        let in_range = |&place: &u16| {
            let bright = PhotonRecord {
                position: [place % cells, 0, 0],
                mantissa: [255; 3],
                exponent: 24,
            };
            let block = Block {
                offset: [1 + u32::from(place / cells), 1, 1],
                exponent: 0,
                photons: vec![bright],
            };
            let sums = gather(format, &query, &[block]);
            assert_eq!(sums.count == 1, sums.power == [255 << 24; 3]);
            assert_eq!(sums.count == 0, sums.power == [0; 3]);
            sums.count == 1
        };
        assert_eq!((0..2 * cells).filter(in_range).count(), expected, "{name}");
    }
}

#[test]
fn what_does_not_fit_is_refused_with_the_limit_and_by_how_much() {
    let gather = Gather::new(&DEFAULT.into()).unwrap();
    let of = |record: PhotonRecord, offset, exponent, position| {
        let photons = [record];
        let block = PhotonBlock {
            offset,
            exponent,
            photons: &photons,
        };
        gather
            .sums(&query_at(DEFAULT, position), [block])
            .unwrap_err()
            .to_string()
    };
    let good = photon([0; 3]);
    #[rustfmt::skip]
    let cases = [
        (of(photon([0, 300, 0]), [1; 3], 0, [256; 3]), "position y is 300, 45 over the largest that format `local8-rgb8e5` holds, 255"),
        (of(PhotonRecord { mantissa: [0, 0, 256], ..good }, [1; 3], 0, [256; 3]), "blue mantissa is 256, 1 over"),
        (of(PhotonRecord { exponent: 25, ..good }, [1; 3], 0, [256; 3]), "photon exponent is 25, 1 over"),
        (of(good, [1; 3], 1, [256; 3]), "block exponent is 1, 1 over"),
        (of(good, [1, 1, 4], 0, [256; 3]), "block offset z is 4, 1 over"),
        (of(good, [1; 3], 0, [1024, 0, 0]), "position x is 1024, 1 over"),
    ];
    for (message, expected) in cases {
        assert!(message.contains(expected), "{message}");
    }
    let wide = unpack(DEFAULT, 1 << 53).unwrap_err().to_string();
    assert!(wide.contains("53 bits of format"), "{wide}");
    let message = unpack(DEFAULT, 25 << 48).unwrap_err().to_string();
    assert!(
        message.contains("photon exponent is 25, 1 over"),
        "{message}"
    );
}
