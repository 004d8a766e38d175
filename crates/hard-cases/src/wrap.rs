//! Hard cases: squares and differences past the width of their word.
//!
//! In trials 16-bit coordinates with sums of 32 bits that wrap gave 6.4 false accepts for each true one. The
//! share grows as 1/r: with r a hundredth of the scene there are fewer.

use glam::DVec3;
use photoncube_spec::{PhotonFormat, Widths};

use super::case::{Bound, Contrast, HardCase, HardCaseError, Outcome, every_format};
use super::exact::{Met, all_met};
use super::grid::Grid;
use super::naive::{in_range_wrapping_16, in_range_wrapping_32};
use super::room::{COLOUR, FRONT, RADIUS, Room, photon, points};
use super::setting::Setting;
use photoncube_render::QuantisedMap;

pub(super) const OWN_WIDTH: HardCase = HardCase {
    name: "wrap-own-width",
    breaks: "across the frame three squares exceed the word that d^2 has",
    result: "photons decided otherwise than by unbounded integers",
    bound: Bound::Zero,
    why: "the sum saturates past r^2, and each axis is clamped to r + 1: both are out of range",
    contrast: Contrast {
        what: "false accepts for each true one where a sum of the same width wraps",
        at_least: 1.0,
    },
    applies: every_format,
    settings: cloud,
    measure: own_width,
};

pub(super) const TRUNCATED: HardCase = HardCase {
    name: "wrap-difference-bits",
    breaks: "a difference has only the radius's bits: a photon a block further on looks near",
    why: "a clamped difference is r + 1, whose square alone is out of range",
    contrast: Contrast {
        what: "false accepts for each true one where a difference is cut to its low bits",
        at_least: 1.0,
    },
    // The photons are those of the case above.
    settings: |_| Ok(Vec::new()),
    measure: truncated,
    ..OWN_WIDTH
};

pub(super) const SQUARES_32: HardCase = HardCase {
    name: "wrap-32-bit-squares",
    breaks: "16-bit coordinates of the scene, d^2 in 32 bits: far photons wrap into range",
    result: "photons taken that are more than a cell's diagonal out of range",
    bound: Bound::Zero,
    why: "positions are off by half a cell on each axis and no more, and nothing wraps",
    contrast: Contrast {
        what: "false accepts for each true one in 32-bit sums that wrap",
        at_least: 1.0,
    },
    applies: every_format,
    settings: |grid| Ok(vec![scattered(grid)?]),
    measure: |format| {
        scene_wide(
            format,
            scattered(&Grid::of_format(format))?,
            in_range_wrapping_32,
        )
    },
};

pub(super) const DIFFERENCES_16: HardCase = HardCase {
    name: "wrap-16-bit-differences",
    breaks: "16-bit differences change their sign: opposite walls of the scene meet",
    contrast: Contrast {
        what: "false accepts for each true one in 16-bit differences that wrap",
        at_least: 1.0,
    },
    settings: |grid| Ok(vec![opposite(grid)?]),
    measure: |format| {
        scene_wide(
            format,
            opposite(&Grid::of_format(format))?,
            in_range_wrapping_16,
        )
    },
    ..SQUARES_32
};

/// Photons anywhere in the 27 blocks that a query gathers.
fn cloud(grid: &Grid) -> Result<Vec<Setting>, HardCaseError> {
    let edge = grid.edge(RADIUS);
    let low = 3.5 * edge;
    let anywhere = points(2_000, 11).map(|p| photon(low + 3.0 * edge * p, COLOUR));
    let map = Room::UNIT.map(grid, anywhere.collect(), RADIUS)?;
    // Two corners of the block, and positions inside it.
    let ends = [DVec3::splat(1e-6), DVec3::splat(1.0 - 1e-6)];
    let places = ends.into_iter().chain(points(6, 12));
    let queries = places.map(|p| low + edge * (1.0 + p));
    Ok(vec![Setting::new(map, queries.collect())])
}

fn own_width(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let half = u64::from(format.half_steps());
    let mask = (1_u64 << Widths::of_format(format).saturated_distance) - 1;
    in_frame(format, |met| {
        let sum: u64 = met.steps().iter().map(|m| m * (m + half)).sum();
        sum & mask
    })
}

fn truncated(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let half = u64::from(format.half_steps());
    let mask = (1_u64 << Widths::of_format(format).difference) - 1;
    in_frame(format, |met| {
        let low = met.steps().map(|m| m & mask);
        low.iter().map(|m| m * (m + half)).sum()
    })
}

/// Compares the format and a naive squared distance with the exact one, over the frame.
fn in_frame(format: &PhotonFormat, naive: impl Fn(&Met) -> u64) -> Result<Outcome, HardCaseError> {
    let (mut looked_at, mut wrong, mut truly, mut falsely) = (0, 0, 0, 0);
    for setting in cloud(&Grid::of_format(format))? {
        for met in all_met(&setting, format)? {
            let exact = met.truly(format);
            let naively = naive(&met) <= format.largest_in_range().into();
            looked_at += 1;
            wrong += u64::from(met.in_range != exact);
            truly += u64::from(exact);
            falsely += u64::from(naively && !exact);
        }
    }
    Ok(Outcome {
        looked_at,
        result: wrong as f64,
        contrast: per_true(falsely, truly),
    })
}

/// The number of false accepts for each true one. Without a true one there is no figure.
fn per_true(falsely: u64, truly: u64) -> f64 {
    match truly {
        0 => 0.0,
        truly => falsely as f64 / truly as f64,
    }
}

/// The search radius of the cases over the whole scene.
const SMALL_RADIUS: f64 = 0.01;

/// Photons all over the room, with a radius of a hundredth of it.
fn scattered(grid: &Grid) -> Result<Setting, HardCaseError> {
    let photons = points(60_000, 13).map(|p| photon(p, COLOUR)).collect();
    let map = Room::UNIT.map(grid, photons, SMALL_RADIUS)?;
    Ok(Setting::new(map, points(100, 14).collect()))
}

/// Photons along one wall, queries along the opposite.
fn opposite(grid: &Grid) -> Result<Setting, HardCaseError> {
    let beside =
        |x: f64| move |p: DVec3| DVec3::new(x + 0.5 * SMALL_RADIUS * p.x, 0.1 * p.y, 0.1 * p.z);
    let high = 1.0 - 0.5 * SMALL_RADIUS;
    let far = points(2_000, 15).map(beside(high));
    // A few photons are beside the queries, so that each query has some.
    let near = points(200, 16).map(beside(0.0));
    let photons = far.chain(near).map(|p| photon(p, COLOUR)).collect();
    let map = Room::UNIT.map(grid, photons, SMALL_RADIUS)?;
    let queries = points(20, 17).map(beside(0.0)).collect();
    Ok(Setting::new(map, queries))
}

type InRange = fn(DVec3, DVec3, f64) -> bool;

/// Tests every photon of the scene against every query: by the format and by `naive`.
fn scene_wide(
    format: &PhotonFormat,
    setting: Setting,
    naive: InRange,
) -> Result<Outcome, HardCaseError> {
    let quantised = QuantisedMap::new(&setting.map, &format.into())?;
    let beyond = SMALL_RADIUS + 3_f64.sqrt() * Grid::of_format(format).cell(SMALL_RADIUS);
    let (mut wrong, mut truly, mut falsely, mut looked_at) = (0, 0, 0, 0);
    for &query in &setting.queries {
        let taken = quantised.verdicts(query, FRONT).filter(|verdict| verdict.1);
        let far = taken.filter(|(p, _)| p.position.distance(query) > beyond);
        wrong += far.count() as u64;
        for photon in setting.map.photons() {
            let exact = photon.position.distance(query) <= SMALL_RADIUS;
            let taken = naive(photon.position, query, SMALL_RADIUS);
            truly += u64::from(exact);
            falsely += u64::from(taken && photon.position.distance(query) > beyond);
            looked_at += 1;
        }
    }
    Ok(Outcome {
        looked_at,
        result: wrong as f64,
        contrast: per_true(falsely, truly),
    })
}
