//! Hard cases: sums of very many photons.
//!
//! In trials a sequential sum in f32 was 1 % off at a million photons.

use glam::DVec3;
use photoncube_model::Gather;
use photoncube_spec::{Exponent, PhotonBlock, PhotonFormat, PhotonRecord, Query, Sums};

use super::case::{Bound, Contrast, HardCase, HardCaseError, Outcome, every_format, percent};
use super::grid::Grid;
use super::naive::sum_f32;
use super::room::{FRONT, MIDDLE, RADIUS, Room, photon, photons};
use super::setting::Setting;
use photoncube_render::QuantisedMap;

pub(super) const QUARTER_MILLION: HardCase = HardCase {
    name: "quarter-million-in-a-block",
    breaks: "all photons identical, in one cell of one block: sums past 32 bits",
    result: "steps between the sums and count times power, and between the counts",
    bound: Bound::Zero,
    why: "sums are as wide as max_photons of full scale need; integer sums are exact",
    contrast: Contrast {
        what: "% of the power lost in 32-bit sums that wrap",
        at_least: 50.0,
    },
    applies: every_format,
    settings: |grid| Ok(vec![identical(grid, QUARTER)?]),
    measure: quarter_million,
};

pub(super) const FULLEST: HardCase = HardCase {
    name: "largest-declared-count",
    breaks: "max_photons of full-scale power, the most that the sums are sized for",
    settings: |grid| Ok(vec![identical(grid, MOST_PLACED)?]),
    measure: fullest,
    ..QUARTER_MILLION
};

pub(super) const MILLION: HardCase = HardCase {
    name: "a-million-photons",
    breaks: "a sum that rounds at every photon drifts",
    result: "% error of the sum",
    // The sum is exact; its flux is a product in f64.
    bound: Bound::AtMost(1e-10),
    why: "integers do not round; only the flux of the sum is in f64, at 1e-16 a product",
    contrast: Contrast {
        what: "% error of a sequential f32 sum",
        at_least: 0.5,
    },
    // The photons are those of the quarter million.
    settings: |_| Ok(Vec::new()),
    measure: million,
    ..QUARTER_MILLION
};

pub(super) const PERMUTED: HardCase = HardCase {
    name: "permuted",
    breaks: "photons in another order: sums that round depend on it",
    result: "queries whose sums are not bit-identical",
    bound: Bound::Zero,
    why: "integer sums do not depend on the order",
    contrast: Contrast {
        what: "% of queries change bits in sequential f32 sums",
        at_least: 10.0,
    },
    applies: every_format,
    settings: |grid| Ok(vec![ordered(grid, 0)?, ordered(grid, 1_234)?]),
    measure: permuted,
};

const QUARTER: usize = 250_000;

/// The most photons that a machine is given; a format's own limit may be thousands of millions.
const MOST_PLACED: usize = 1 << 20;

/// `count` photons in one cell, all of the largest power.
fn identical(grid: &Grid, count: usize) -> Result<Setting, HardCaseError> {
    let count = grid.at_most(count);
    let map = Room::UNIT.map(grid, vec![photon(MIDDLE, DVec3::ONE); count], RADIUS)?;
    Ok(Setting::counted(map, MIDDLE, count as u64))
}

fn quarter_million(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let setting = identical(&Grid::of_format(format), QUARTER)?;
    let quantised = QuantisedMap::new(&setting.map, &format.into())?;
    let sums = quantised.gather(MIDDLE, FRONT)?;
    let count = setting.counts[0];
    let one = one(&quantised)?;
    Ok(difference(
        one.power.map(|p| p * u128::from(count)),
        count,
        &sums,
    ))
}

fn fullest(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let channels = format.power.channels.names().len();
    let range = format.power.exponent_range() as u8;
    let (block_exponent, exponent) = match format.power.exponent {
        Exponent::Photon { .. } => (0, range),
        Exponent::Block { .. } | Exponent::None => (range, 0),
    };
    let mut full = PhotonRecord {
        exponent,
        ..PhotonRecord::default()
    };
    full.mantissa[..channels].fill(u16::MAX >> (16 - format.power.mantissa_bits));
    let block = PhotonBlock {
        offset: [1; 3],
        exponent: block_exponent,
        photons: &vec![full; REPEATED],
    };
    let query = Query {
        position: [format.edge_steps(); 3],
        radius_sq: format.largest_in_range(),
    };
    let sums = repeated(format, &query, block, format.max_photons)?;
    let mantissa = (1_u128 << format.power.mantissa_bits) - 1;
    let all = (mantissa << range) * u128::from(format.max_photons);
    let mut expected = [0; 3];
    expected[..channels].fill(all);
    Ok(difference(expected, format.max_photons, &sums))
}

/// The difference from the exact sums and counts; the contrast is the loss in 32 bits.
fn difference(expected: [u128; 3], count: u64, sums: &Sums) -> Outcome {
    let pairs = expected.iter().zip(sums.power);
    let off: u128 = pairs.map(|(a, b)| a.abs_diff(b)).sum();
    let brightest = expected.into_iter().max().unwrap_or_default();
    let wrapped = brightest % (1 << 32);
    Outcome {
        looked_at: sums.count,
        result: off as f64 + sums.count.abs_diff(count) as f64,
        contrast: 100.0 * (1.0 - wrapped as f64 / brightest as f64),
    }
}

fn million(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let count = format.max_photons.min(1_000_000);
    // A tenth is not a binary fraction, so every f32 sum of it rounds.
    let power = 0.1;
    let photons = vec![photon(MIDDLE, DVec3::splat(power)); REPEATED];
    let map = Room::UNIT.map(&Grid::of_format(format), photons, RADIUS)?;
    let quantised = QuantisedMap::new(&map, &format.into())?;
    let query = quantised.query(MIDDLE);
    let (mut sums, mut looked_at) = (Sums::default(), 0);
    for block in quantised.blocks(MIDDLE, FRONT) {
        sums = repeated(format, &query, block, count)?;
        looked_at += sums.count;
    }
    // With dithering, a stored photon may be a step less than before.
    let exact = quantised.power(0).x * count as f64;
    let drifted = f64::from(sum_f32((0..count).map(|_| power)));
    Ok(Outcome {
        looked_at,
        result: 100.0 * (quantised.flux(sums.power).x / exact - 1.0).abs(),
        contrast: 100.0 * (drifted / (count as f64 * power) - 1.0).abs(),
    })
}

/// The number of photons in a block that stands for a larger one.
const REPEATED: usize = 1 << 10;

/// The sums of a block's photons, repeated to `count` in all: the count matters and not the memory.
fn repeated(
    format: &PhotonFormat,
    query: &Query,
    block: PhotonBlock<'_>,
    count: u64,
) -> Result<Sums, HardCaseError> {
    let photons = block.photons.len() as u64;
    let times = usize::try_from(count / photons).unwrap_or(usize::MAX);
    let rest = PhotonBlock {
        photons: &block.photons[..(count % photons) as usize],
        ..block
    };
    let blocks = std::iter::repeat_n(block, times).chain([rest]);
    Ok(Gather::new(&format.into())?.sums(query, blocks)?)
}

/// The sums of one of the map's photons, which are all equal.
fn one(quantised: &QuantisedMap<'_>) -> Result<Sums, HardCaseError> {
    let gather = Gather::new(quantised.numbers())?;
    let blocks = quantised.blocks(MIDDLE, FRONT).map(|mut block| {
        block.photons = &block.photons[..1];
        block
    });
    Ok(gather.sums(&quantised.query(MIDDLE), blocks)?)
}

/// Photons of powers over 1e6:1, with the first `from` moved to the end and the others reversed.
fn ordered(grid: &Grid, from: usize) -> Result<Setting, HardCaseError> {
    let mut list = photons(5_000, 21);
    let queries = list.iter().step_by(61).map(|p| p.position).collect();
    if from > 0 {
        list.rotate_left(from);
        list.reverse();
    }
    let map = Room::UNIT.map(grid, list, RADIUS)?;
    Ok(Setting::new(map, queries))
}

fn permuted(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let grid = Grid::of_format(format);
    let settings = [ordered(&grid, 0)?, ordered(&grid, 1_234)?];
    let [a, b] = &settings;
    let pairs = a.sums(format)?.into_iter().zip(b.sums(format)?);
    let changed = pairs.filter(|(a, b)| a != b).count() as u64;
    let rounded = |setting: &Setting, query| {
        let runs = setting.map.candidates(query, FRONT);
        let all = runs.flat_map(|run| &setting.map.photons()[run.photons]);
        let near = all.filter(|p| p.position.distance(query) <= RADIUS);
        sum_f32(near.map(|p| p.power.x)).to_bits()
    };
    let drifts = |&&query: &&DVec3| rounded(a, query) != rounded(b, query);
    let drifted = a.queries.iter().filter(drifts).count() as u64;
    let looked_at = a.queries.len() as u64;
    Ok(Outcome {
        looked_at,
        result: changed as f64,
        contrast: percent(drifted, looked_at),
    })
}
