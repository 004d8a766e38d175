//! Measures lossless storage: the bits that photons of a block share.
//!
//! A *run* is the photons of one surface in one block, which a query selects; a whole block shares fewer
//! bits. Every format knows where blocks and runs begin, and so their number of photons; no figure here
//! counts that.

use photoncube_render::QuantisedMap;
use photoncube_spec::{PhotonRecord, Widths};

use crate::measure::{Case, quantised};
use crate::table::{Cell, Table};

/// Bits of the field that states how many bits are shared.
const WIDTH_FIELD: f64 = 4.0;

/// The bits of the positions of a group of photons, with p bits on every axis.
type Cost = fn(&[PhotonRecord], u32) -> f64;

const SCHEMES: [(&str, Cost); 9] = [
    ("plain", plain),
    ("ordered into 8 parts, counts", |g, p| counted(g, p, 1)),
    ("ordered into 64 parts, counts", |g, p| counted(g, p, 2)),
    ("ordered into 8 parts, unary", |g, p| unary(g, p, 1)),
    ("ordered into 64 parts, unary", |g, p| unary(g, p, 2)),
    ("ideal: no order", |g, p| plain(g, p) - order(g)),
    ("shared top bits", shared),
    ("shared top bits, ordered, unary", shared_and_ordered),
    ("shared top bits, ideal: no order", |g, p| {
        shared(g, p) - order(g)
    }),
];

/// A table of every scheme on the scenes' first maps.
pub fn positions(cases: &[Case]) -> Table {
    let mut header = vec!["positions local8".to_owned(), "group".to_owned()];
    header.extend(
        cases
            .iter()
            .map(|case| format!("{} bits/photon", case.name)),
    );
    let mut table = Table::new(
        "Position bits shared by photons of a block or run",
        "Plain is 24. `counts`: the photons of each part by a number, wide enough for all of the \
         group; `unary`: a bit for each photon and each part (Elias and Fano). The order of n photons \
         is worth log2 n!, less for those that are alike. `shared top bits`: on every axis those \
         that all photons have in common, once, and 4 bits that say how many they are; \
         `ordered, unary`: into 4 parts on each axis that has bits left.",
        header,
    );
    for by_run in [false, true] {
        let group = if by_run { "run" } else { "block" };
        let mut sizes = vec![
            Cell::text("photons, of a photon's group"),
            Cell::text(group),
        ];
        let mean = |groups: &[&[PhotonRecord]], all: usize| {
            groups.iter().map(|g| g.len().pow(2)).sum::<usize>() as f64 / all as f64
        };
        sizes.extend(per_map(cases, by_run, mean));
        table.push(sizes);
        for (name, cost) in SCHEMES {
            let mut row = vec![Cell::text(name), Cell::text(group)];
            row.extend(per_map(cases, by_run, |groups, all| {
                groups.iter().map(|g| cost(g, 8)).sum::<f64>() / all as f64
            }));
            table.push(row);
        }
    }
    table
}

fn per_map(
    cases: &[Case],
    by_run: bool,
    figure: impl Fn(&[&[PhotonRecord]], usize) -> f64,
) -> Vec<Cell> {
    let cell = |case: &Case| {
        let quantised = quantised(&case.bench.maps()[0], "local8-rgb8e5");
        let groups = groups(&quantised, by_run);
        Cell::Number(figure(&groups, quantised.records().len()), 2)
    };
    cases.iter().map(cell).collect()
}

fn groups<'a>(quantised: &'a QuantisedMap<'_>, by_run: bool) -> Vec<&'a [PhotonRecord]> {
    let photons: Vec<_> = quantised.map().traced_photons().collect();
    let mut groups = Vec::new();
    for block in quantised.map().block_slices() {
        let mut rest = &quantised.records()[block.clone()];
        for run in photons[block].chunk_by(|a, b| !by_run || a.surface == b.surface) {
            let (group, others) = rest.split_at(run.len());
            groups.push(group);
            rest = others;
        }
    }
    groups
}

/// Bits per photon of the whole records where runs share the top bits of positions and exponents.
pub fn shared_record(quantised: &QuantisedMap<'_>) -> f64 {
    let widths = Widths::of_numbers(quantised.numbers());
    let channels = quantised.numbers().power().channels.count();
    let bits = |run: &[PhotonRecord]| {
        let exponents = run.iter().map(|record| record.exponent.into());
        shared(run, widths.position)
            + shared_field(exponents, widths.record_exponent)
            + f64::from(channels * widths.mantissa) * run.len() as f64
    };
    let total: f64 = groups(quantised, true).into_iter().map(bits).sum();
    total / quantised.records().len() as f64
}

fn plain(group: &[PhotonRecord], position_bits: u32) -> f64 {
    f64::from(3 * position_bits) * group.len() as f64
}

/// The bits of photons sorted into parts of 2^s on every axis. A record then needs no place for the top s
/// bits.
fn counted(group: &[PhotonRecord], position_bits: u32, s: u32) -> f64 {
    let count_bits = (group.len() as f64 + 1.0).log2().ceil();
    plain(group, position_bits - s) + count_bits * f64::from(1_u32 << (3 * s))
}

fn unary(group: &[PhotonRecord], position_bits: u32, s: u32) -> f64 {
    let table = group.len() as f64 + f64::from(1_u32 << (3 * s));
    plain(group, position_bits - s) + table
}

/// The information in the order of the photons: log2 (n! / (m1! m2! ...)) for groups of m equal photons.
fn order(group: &[PhotonRecord]) -> f64 {
    let mut positions: Vec<_> = group.iter().map(|record| record.position).collect();
    positions.sort_unstable();
    let alike = positions.chunk_by(|a, b| a == b);
    log2_factorial(group.len()) - alike.map(|m| log2_factorial(m.len())).sum::<f64>()
}

fn log2_factorial(n: usize) -> f64 {
    (2..=n).map(|k| (k as f64).log2()).sum()
}

/// The bits on each axis: the number of top bits that all photons share, these bits, and the other bits of
/// each photon.
fn shared(group: &[PhotonRecord], position_bits: u32) -> f64 {
    let axis = |axis: usize| {
        let values = group.iter().map(|record| record.position[axis].into());
        shared_field(values, position_bits)
    };
    (0..3).map(axis).sum()
}

/// The bits of [`shared`], with the photons also sorted into 4 parts on each axis whose bits are not all
/// shared where that takes fewer bits. One more bit states the choice.
fn shared_and_ordered(group: &[PhotonRecord], position_bits: u32) -> f64 {
    let varies = |axis: usize| {
        let values = group.iter().map(|record| u32::from(record.position[axis]));
        own_bits(values) >= 2
    };
    let axes = (0..3).filter(|axis| varies(*axis)).count() as i32;
    let count = group.len() as f64;
    let saved = f64::from(2 * axes) * count - count - 4f64.powi(axes);
    shared(group, position_bits) + 1.0 - saved.max(0.0)
}

fn shared_field(values: impl Iterator<Item = u32> + Clone, bits: u32) -> f64 {
    let count = values.clone().count();
    let own = own_bits(values);
    WIDTH_FIELD + f64::from(bits - own) + f64::from(own) * count as f64
}

/// The number of bits below those that all values share.
fn own_bits(mut values: impl Iterator<Item = u32>) -> u32 {
    let first = values.next().unwrap_or(0);
    let differing = values.fold(0, |differing, value| differing | (value ^ first));
    u32::BITS - differing.leading_zeros()
}
