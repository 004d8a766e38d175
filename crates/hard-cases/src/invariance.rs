//! Hard cases: scenes that are moved, scaled or brighter give equal bits.
//!
//! A scene scaled by a power of two gives equal bits wherever its photons are. With any other factor f64
//! rounds positions by 1e-16 of the scene, and a photon that close to its cell's border may change its cell;
//! one in the middle of its cell does not. So the factors 1e-3 and 1e6 are tried with photons at the middles
//! of cells, and powers of two with photons anywhere.

use glam::DVec3;
use photoncube_spec::PhotonFormat;

use super::case::{Bound, Contrast, HardCase, HardCaseError, Outcome, every_format, percent};
use super::grid::Grid;
use super::room::{COLOUR, RADIUS, Room, photon, photons, points};
use super::setting::Setting;
use photoncube_render::QuantisedMap;
use photoncube_render::{Photon, StoredPhoton};

pub(super) const MOVED: HardCase = HardCase {
    name: "moved-by-1e6",
    breaks: "a scene 1e6 of its sizes from the origin: few bits are left for positions",
    result: "queries whose sums, and photons whose records, are not bit-identical",
    bound: Bound::Zero,
    why: "only differences from the scene's corner are used; of coordinates that the move does not \
          round they are exact",
    contrast: Contrast {
        what: "% of queries change their count with positions in f32",
        at_least: 50.0,
    },
    applies: every_format,
    settings: |grid| Moved::SCENE.settings(grid),
    measure: |format| Moved::SCENE.measure(format, |at| at.as_vec3().as_dvec3()),
};

pub(super) const SCALED: HardCase = HardCase {
    name: "scaled-by-1e-3-and-1e6",
    breaks: "a scene of another unit of length: steps of a fixed length are too coarse or too many",
    why: "positions are fractions of blocks, blocks a ratio of the radius; photons at the middles of \
          cells for 1e-3 and 1e6, which round positions, and anywhere for powers of two, which do not",
    contrast: Contrast {
        what: "% of queries change their count in steps of 2^-16 of a unit of length",
        at_least: 10.0,
    },
    settings: scaled,
    measure: scaled_same,
    ..MOVED
};

pub(super) const BRIGHTER: HardCase = HardCase {
    name: "brighter-by-2^20",
    breaks: "light of another unit of power: steps of a fixed power are too coarse",
    result: "queries whose sums, and photons whose records, are not bit-identical",
    why: "the unit follows from the map's largest power; a power of two does not round",
    contrast: Contrast {
        what: "% of photons round to 0 in steps of 2^-16 of a unit of power",
        at_least: 10.0,
    },
    settings: |grid| {
        [1.0, BRIGHTNESS, 1.0 / BRIGHTNESS]
            .map(|by| lit(grid, by))
            .into_iter()
            .collect()
    },
    measure: brighter,
    ..MOVED
};

/// Photons and queries, and the rooms into which they are placed.
struct Moved {
    rooms: &'static [Room],
    /// Whether the photons are at the middles of cells.
    at_middles: bool,
}

impl Moved {
    const SCENE: Self = Self {
        rooms: &[
            Room::UNIT,
            Room {
                low: DVec3::splat(1e6),
                size: 1.0,
            },
            Room {
                low: DVec3::new(-1e6, 0.0, 3.25),
                size: 1.0,
            },
        ],
        at_middles: false,
    };

    const POWERS_OF_TWO: Self = Self {
        rooms: &[Room::UNIT, scaled_by(1.0 / 1024.0), scaled_by(1_048_576.0)],
        at_middles: false,
    };

    const ANY_FACTOR: Self = Self {
        rooms: &[Room::UNIT, scaled_by(1e-3), scaled_by(1e6)],
        at_middles: true,
    };

    /// A setting for each room; the first is the one that the others must equal.
    fn settings(&self, grid: &Grid) -> Result<Vec<Setting>, HardCaseError> {
        let rooms = self.rooms.iter().map(|room| {
            let (photons, queries) = self.photons(grid);
            let queries = queries.into_iter().map(|query| room.place(query));
            Ok(Setting::new(
                room.map(grid, photons, RADIUS)?,
                queries.collect(),
            ))
        });
        rooms.collect()
    }

    fn photons(&self, grid: &Grid) -> (Vec<Photon>, Vec<DVec3>) {
        if !self.at_middles {
            let photons = photons(3_000, 61);
            let queries = photons.iter().step_by(61).map(|p| p.position).collect();
            return (photons, queries);
        }
        // Blocks 3 to 5, which lie inside the room on every grid.
        let index = |p: DVec3, edge: u32| {
            let index = (3.0 + 3.0 * p) * f64::from(edge);
            index.to_array().map(|c| c as i64)
        };
        let cells = points(1_000, 62).map(|p| index(p, 1 << grid.position_bits));
        let photons = cells.map(|cell| photon(grid.photon_at(cell), COLOUR));
        let fine = points(40, 63).map(|p| index(p, grid.edge_steps()));
        (
            photons.collect(),
            fine.map(|at| grid.query_at(at)).collect(),
        )
    }

    /// Compares each room with the first. `naive` is the rounding of a position in another arithmetic.
    fn measure(
        &self,
        format: &PhotonFormat,
        naive: fn(DVec3) -> DVec3,
    ) -> Result<Outcome, HardCaseError> {
        let settings = self.settings(&Grid::of_format(format))?;
        let mut outcome = same(format, &settings)?;
        let counts: Vec<_> = settings.iter().map(|s| naive_counts(s, naive)).collect();
        let pairs = counts
            .iter()
            .skip(1)
            .flat_map(|other| counts[0].iter().zip(other));
        let changed = pairs.clone().filter(|(a, b)| a != b).count();
        outcome.contrast = percent(changed as u64, pairs.count() as u64);
        Ok(outcome)
    }
}

const fn scaled_by(size: f64) -> Room {
    Room {
        low: DVec3::ZERO,
        size,
    }
}

/// The number of queries and photons that differ from those of the first setting, without a contrast.
fn same(format: &PhotonFormat, settings: &[Setting]) -> Result<Outcome, HardCaseError> {
    let first = QuantisedMap::new(&settings[0].map, &format.into())?;
    let sums = settings[0].sums(format)?;
    let (mut differ, mut looked_at) = (0, 0);
    for other in &settings[1..] {
        let quantised = QuantisedMap::new(&other.map, &format.into())?;
        let records = first.records().iter().zip(quantised.records());
        differ += records.filter(|(a, b)| a != b).count();
        let others = other.sums(format)?;
        differ += sums.iter().zip(&others).filter(|(a, b)| a != b).count();
        looked_at += others.iter().map(|sums| sums.count).sum::<u64>();
    }
    Ok(Outcome {
        looked_at,
        result: differ as f64,
        contrast: 0.0,
    })
}

/// The photons in range of each query, with rounded positions and radius.
fn naive_counts(setting: &Setting, round: fn(DVec3) -> DVec3) -> Vec<usize> {
    let radius = round(DVec3::splat(setting.map.radius())).x;
    let photons = setting.map.photons().iter();
    let rounded: Vec<DVec3> = photons.map(|p| round(p.position)).collect();
    let count = |query: DVec3| {
        let in_range = |p: &&DVec3| p.distance(query) <= radius;
        rounded.iter().filter(in_range).count()
    };
    setting.queries.iter().map(|&q| count(round(q))).collect()
}

fn scaled(grid: &Grid) -> Result<Vec<Setting>, HardCaseError> {
    let mut settings = Moved::ANY_FACTOR.settings(grid)?;
    settings.extend(Moved::POWERS_OF_TWO.settings(grid)?);
    Ok(settings)
}

fn scaled_same(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let fixed = |at: DVec3| (at * 65_536.0).floor() / 65_536.0;
    let any = Moved::ANY_FACTOR.measure(format, fixed)?;
    let two = Moved::POWERS_OF_TWO.measure(format, fixed)?;
    Ok(Outcome {
        looked_at: any.looked_at.min(two.looked_at),
        result: any.result + two.result,
        contrast: any.contrast.max(two.contrast),
    })
}

const BRIGHTNESS: f64 = 1_048_576.0;

fn lit(grid: &Grid, by: f64) -> Result<Setting, HardCaseError> {
    let mut all = photons(3_000, 64);
    for photon in &mut all {
        photon.power *= by;
    }
    let queries = all.iter().step_by(61).map(|p| p.position).collect();
    Ok(Setting::new(Room::UNIT.map(grid, all, RADIUS)?, queries))
}

fn brighter(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let grid = Grid::of_format(format);
    let settings = [
        lit(&grid, 1.0)?,
        lit(&grid, BRIGHTNESS)?,
        lit(&grid, 1.0 / BRIGHTNESS)?,
    ];
    let mut outcome = same(format, &settings)?;
    let dim = settings[2].map.photons();
    let lost = |p: &&StoredPhoton| (p.power.max_element() * 65_536.0).round() == 0.0;
    outcome.contrast = percent(dim.iter().filter(lost).count() as u64, dim.len() as u64);
    Ok(outcome)
}
