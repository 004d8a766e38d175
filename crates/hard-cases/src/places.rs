//! Hard cases: borders of blocks and of the scene, and radii as large as these.

use glam::DVec3;
use photoncube_spec::PhotonFormat;

use super::case::{Bound, Contrast, HardCase, HardCaseError, Outcome, every_format, percent};
use super::grid::Grid;
use super::naive::in_range_wrapping_32;
use super::room::{COLOUR, FRONT, RADIUS, Room, photon, photons, points};
use super::setting::Setting;
use photoncube_render::Photon;
use photoncube_render::PhotonMap;
use photoncube_render::QuantisedMap;

pub(super) const EXACTLY_ONE: HardCase = HardCase {
    name: "position-of-one",
    breaks: "a fraction of exactly 1, or one that rounds to it, needs a bit more than there is",
    result: "photons not found at their own place, or in another cell than a query there",
    bound: Bound::Zero,
    why: "a fraction is floored, and one of exactly 1 is in the last cell",
    contrast: Contrast {
        what: "% of photons at their block's other end where fractions round to nearest and lose the carry",
        at_least: 10.0,
    },
    applies: every_format,
    settings: borders,
    measure: exactly_one,
};

pub(super) const CORNERS: HardCase = HardCase {
    name: "block-edges-and-corners",
    breaks: "photons in range on all sides of an edge or a corner where blocks meet",
    result: "photons missed",
    bound: Bound::Zero,
    why: "the 27 blocks around a query hold all that is in range, as an edge is no shorter than r",
    contrast: Contrast {
        what: "% of photons missed in the query's own block alone",
        at_least: 50.0,
    },
    settings: corners,
    measure: own_corners,
    ..EXACTLY_ONE
};

pub(super) const RADIUS_IS_EDGE: HardCase = HardCase {
    name: "radius-is-block-edge",
    breaks: "blocks of exactly the radius: rounding carries a photon in range two blocks away",
    result: "photons missed that are a cell inside the radius",
    bound: Bound::Zero,
    why: "a format takes blocks of its own, two steps longer than r",
    contrast: Contrast {
        what: "% of photons at d <= r in f64 in none of the 27 blocks where these have an edge of r",
        at_least: 1.0,
    },
    settings: at_the_edge,
    measure: radius_is_edge,
    ..EXACTLY_ONE
};

pub(super) const RADIUS_OVER_SCENE: HardCase = HardCase {
    name: "radius-over-the-scene",
    breaks: "a radius of 20 scenes: one block holds all, and r^2 in the scene's steps is past 32 bits",
    result: "photons missed",
    bound: Bound::Zero,
    why: "the radius is a whole number of the format's steps, whatever it is in the scene's",
    contrast: Contrast {
        what: "% of photons missed in 16 bits over the scene with r^2 in 32 bits",
        at_least: 50.0,
    },
    settings: |grid| Ok(vec![large_radius(grid)?]),
    measure: radius_over_scene,
    ..EXACTLY_ONE
};

/// Single photons at blocks' borders, one float to either side of them, and in the scene's corners.
fn borders(grid: &Grid) -> Result<Vec<Setting>, HardCaseError> {
    let edge = grid.edge(RADIUS);
    let near = |at: f64| [at.next_down(), at, at.next_up(), at - 1e-18];
    let inner = (0..8).map(|block| (f64::from(block) + 0.5) * edge);
    let places = inner.flat_map(near).chain([0.0, 1.0, 1.0_f64.next_down()]);
    let settings = places.map(|x| {
        let position = DVec3::new(x, x, 0.25);
        let map = Room::UNIT.map(grid, vec![photon(position, COLOUR)], RADIUS)?;
        Ok(Setting::counted(map, position, 1))
    });
    settings.collect()
}

fn exactly_one(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let (mut wrong, mut carried, mut looked_at) = (0, 0, 0);
    for setting in borders(&Grid::of_format(format))? {
        let quantised = QuantisedMap::new(&setting.map, &format.into())?;
        let position = setting.queries[0];
        let query = quantised.query(position).position;
        let of_query = query.map(|q| (q - format.edge_steps()) >> format.query_extra_bits);
        let record = quantised.records()[0].position.map(u32::from);
        let found = setting.miscounted(format)? == 0;
        wrong += u64::from(of_query != record || !found);
        carried += u64::from(is_carried(&setting.map, position, format.position_bits));
        looked_at += 1;
    }
    Ok(Outcome::wrong(wrong, carried, looked_at))
}

/// Whether a fraction that is rounded to nearest loses its carry.
fn is_carried(map: &PhotonMap, position: DVec3, bits: u32) -> bool {
    let (_, fraction) = map.place(position);
    let fraction = fraction.x * f64::from(1_u32 << bits);
    fraction.round() as u32 >> bits == 1
}

/// Photons around points where blocks meet, all within half the radius of the query there.
fn corners(grid: &Grid) -> Result<Vec<Setting>, HardCaseError> {
    let edge = grid.edge(RADIUS);
    let meeting = DVec3::splat(4.5 * edge);
    let off = 0.25 * edge;
    let places = [
        DVec3::ZERO,
        DVec3::X * off,
        DVec3::new(off, 0.0, off),
        DVec3::splat(-1e-9),
    ];
    let settings = places.map(|place| {
        let query = meeting + place;
        let around = points(500, 41).map(|p| query + RADIUS * (p - 0.5));
        let photons: Vec<_> = around.map(|at| photon(at, COLOUR)).collect();
        let count = photons.len() as u64;
        let map = Room::UNIT.map(grid, photons, RADIUS)?;
        Ok(Setting::counted(map, query, count))
    });
    settings.into_iter().collect()
}

fn own_corners(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let (mut missed, mut outside, mut looked_at) = (0, 0, 0);
    for setting in corners(&Grid::of_format(format))? {
        missed += setting.miscounted(format)?;
        let own = setting.map.candidates(setting.queries[0], FRONT);
        let own = own.filter(|run| run.offset == [1; 3]);
        let own: usize = own.map(|run| run.photons.len()).sum();
        outside += setting.counts[0] - own as u64;
        looked_at += setting.counts[0];
    }
    Ok(Outcome::wrong(missed, outside, looked_at))
}

/// A query just below a block's border, with photons a cell less than the radius away on each axis.
fn at_the_edge(grid: &Grid) -> Result<Vec<Setting>, HardCaseError> {
    let settings = below_borders().map(|at| {
        let query = DVec3::splat(at);
        let inside = RADIUS - grid.cell(RADIUS);
        let map = Room::UNIT.map(grid, around(query, inside), RADIUS)?;
        Ok(Setting::counted(map, query, 6))
    });
    settings.collect()
}

/// The borders of blocks of exactly the radius, and the floats below them.
fn below_borders() -> impl Iterator<Item = f64> {
    let borders = (1..8).map(|block| (f64::from(block) + 0.5) * RADIUS);
    borders.flat_map(|at| [at, at.next_down(), at.next_down().next_down(), at.next_up()])
}

/// A photon at that distance on each side of each axis.
fn around(query: DVec3, distance: f64) -> Vec<Photon> {
    let axes = DVec3::AXES.into_iter();
    let sides = axes.flat_map(|axis| [query + distance * axis, query - distance * axis]);
    sides.map(|at| photon(at, COLOUR)).collect()
}

fn radius_is_edge(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let (mut missed, mut looked_at) = (0, 0);
    for setting in at_the_edge(&Grid::of_format(format))? {
        missed += setting.miscounted(format)?;
        looked_at += setting.counts[0];
    }
    Ok(Outcome {
        looked_at,
        result: missed as f64,
        contrast: lost_by_blocks_of_the_radius()?,
    })
}

/// The percentage of photons in no block around the query, among those with d <= r in f64 and d a few floats
/// from r.
fn lost_by_blocks_of_the_radius() -> Result<f64, HardCaseError> {
    let scene = Room::UNIT.scene()?;
    let (mut lost, mut in_range) = (0, 0);
    for at in below_borders() {
        let query = DVec3::splat(at);
        let mut photons = around(query, RADIUS);
        photons.extend(around(query, RADIUS.next_up()));
        photons.retain(|p| p.position.distance(query) <= RADIUS);
        in_range += photons.len();
        let map = PhotonMap::new(&scene, photons, RADIUS)?;
        let found = map.candidates(query, FRONT).map(|run| run.photons.len());
        lost += map.photons().len() - found.sum::<usize>();
    }
    Ok(percent(lost as u64, in_range as u64))
}

/// The radius as a multiple of the scene's size.
const LARGE_RADIUS: f64 = 20.0;

fn large_radius(grid: &Grid) -> Result<Setting, HardCaseError> {
    let photons = photons(grid.at_most(2_000), 42);
    let count = photons.len() as u64;
    let queries: Vec<_> = photons.iter().step_by(97).map(|p| p.position).collect();
    let counts = vec![count; queries.len()];
    let map = Room::UNIT.map(grid, photons, LARGE_RADIUS)?;
    Ok(Setting {
        map,
        queries,
        counts,
    })
}

fn radius_over_scene(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let setting = large_radius(&Grid::of_format(format))?;
    let (mut missed, mut looked_at) = (0, 0);
    for &query in &setting.queries {
        for photon in setting.map.photons() {
            missed += u64::from(!in_range_wrapping_32(photon.position, query, LARGE_RADIUS));
            looked_at += 1;
        }
    }
    Ok(Outcome::wrong(
        setting.miscounted(format)?,
        missed,
        looked_at,
    ))
}
