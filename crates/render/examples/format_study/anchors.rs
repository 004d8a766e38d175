//! Compares the figures that others measured on uniform photons with the built-in scenes.
//!
//! `tests/accuracy.rs` and `tests/formats/error.rs` require the noise of queries with a given count, the law
//! 0.67 / u and the local formats to agree with these figures; this module prints them side by side.

use glam::DVec3;
use photoncube_render::{Misclassified, NoiseMeter, PhotonMap, QueryPoint};

use crate::measure::{Case, Figures, study};
use crate::table::{Cell, Table};

/// Pairs of a count in range and the noise of uniform photons, in per cent.
const NOISE: [(f64, f64); 3] = [(50.0, 15.0), (200.0, 7.5), (1000.0, 3.3)];

/// The misclassified photons in per cent, and the error over the noise.
type Anchor = Option<(f64, f64)>;

/// The formats with the anchors' figures for 50 photons in range (Cornell) and for 200 (the ring).
#[rustfmt::skip]
const FORMATS: [(&str, &str, Anchor); 10] = [
    ("cornell", "local6-rgb8e8", Some((1.06, 0.11))),
    ("cornell", "local7-rgb8e8", Some((0.53, 0.08))),
    ("cornell", "local8-rgb8e8", Some((0.26, 0.06))),
    ("cornell", "abs8-linear8", Some((23.8, 0.56))),
    ("cornell", "abs12-linear12", Some((1.53, 0.13))),
    ("ring", "local6-rgb8e8", None),
    ("ring", "local7-rgb8e8", None),
    ("ring", "local8-rgb8e8", Some((0.21, 0.07))),
    ("ring", "abs8-linear8", None),
    ("ring", "abs12-linear12", Some((15.0, 1.5))),
];

/// A table of the noise by the number of photons in range.
pub fn noise() -> Table {
    let header = ["in range", "anchor noise %", "cornell median %", "rms %"];
    let mut table = Table::new(
        "The anchors' noise",
        "Theirs is of uniform photons of equal power. The median query is near it; the rms is higher \
         because most of the box is darker than its mean (tests/accuracy.rs has the queries with \
         that many in range).",
        header.map(str::to_owned).into(),
    );
    for (in_range, anchor) in NOISE {
        let case = Case::new("cornell", in_range, 8, 32);
        let mut meter = NoiseMeter::new(case.bench.queries().len());
        for references in case.bench.references() {
            meter.push_map(references).expect("one for each query");
        }
        let queries = 0..case.bench.queries().len();
        let mut noise: Vec<f64> = queries.filter_map(|query| meter.of_query(query)).collect();
        noise.sort_by(f64::total_cmp);
        let rms = meter.noise().expect("light").relative;
        table.push(vec![
            Cell::Number(in_range, 0),
            Cell::Number(anchor, 1),
            Cell::Number(100.0 * noise[noise.len() / 2], 1),
            Cell::Number(100.0 * rms, 1),
        ]);
    }
    table
}

/// A table of formats beside the anchors' figures.
pub fn formats() -> Table {
    let header = [
        "scene, in range",
        "format",
        "anchor misclassified %",
        "here",
        "anchor ratio",
        "ratio here",
        "bias %",
    ];
    let mut table = Table::new(
        "The anchors' formats",
        "Theirs: uniform photons at 50 in range, a caustic of their own at 200. abs formats: bits \
         over the whole scene's largest side, so they depend on the scene and on how many photons \
         it has: of 200,000 here the radius has twice the steps that it has of a million.",
        header.map(str::to_owned).into(),
    );
    let cases = [
        Case::new("cornell", 50.0, 8, 32),
        Case::new("ring", 200.0, 8, 32),
    ];
    for (scene, name, anchor) in FORMATS {
        let case = cases.iter().find(|case| case.name == scene);
        let case = case.expect("one of the two");
        let found = measured(case, name);
        let theirs = |value: Option<f64>| value.map_or(Cell::text("-"), |v| Cell::Number(v, 2));
        let in_range = if scene == "cornell" { 50 } else { 200 };
        table.push(vec![
            Cell::text(format!("{scene}, {in_range}")),
            Cell::text(name),
            theirs(anchor.map(|(misclassified, _)| misclassified)),
            Cell::Number(found.report.misclassified_percent, 2),
            theirs(anchor.map(|(_, ratio)| ratio)),
            Cell::Interval(found.ratio, 3),
            Cell::percent(found.bias, 2),
        ]);
    }
    table
}

fn measured(case: &Case, name: &str) -> Figures {
    match name.strip_prefix("abs") {
        None => Figures::of_format(&case.bench, name),
        Some(rest) => {
            let (bits, _) = rest.split_once('-').expect("abs BITS - linear BITS");
            absolute(case, bits.parse().expect("a number"))
        }
    }
}

/// A format of positions and powers with a number of bits over the whole scene.
struct Absolute {
    /// A map with blocks wide enough that no photon in range is outside the 27 blocks.
    map: PhotonMap,
    low: DVec3,
    step: f64,
    power_step: f64,
}

impl Absolute {
    fn new(map: &PhotonMap, bits: i32) -> Self {
        let positions = || map.photons().iter().map(|photon| photon.position);
        let low = positions().fold(DVec3::INFINITY, DVec3::min);
        let high = positions().fold(DVec3::NEG_INFINITY, DVec3::max);
        let powers = map.photons().iter().map(|p| p.power.max_element());
        let largest = powers.fold(0.0, f64::max);
        Self {
            map: map.reblocked(1.25 * map.radius()).expect("a legal edge"),
            low,
            step: (high - low).max_element() / 2f64.powi(bits),
            power_step: largest / (2f64.powi(bits) - 1.0),
        }
    }

    fn cell(&self, position: DVec3) -> DVec3 {
        ((position - self.low) / self.step).floor()
    }

    fn answer(&self, query: &QueryPoint) -> (DVec3, Misclassified) {
        let (mut flux, mut counts) = (DVec3::ZERO, Misclassified::default());
        let (radius, centre) = (self.map.radius(), self.cell(query.position));
        for run in self.map.candidates(query.position, query.front()) {
            for photon in &self.map.photons()[run.photons] {
                let truly = photon.position.distance(query.position) <= radius;
                let inside = self.cell(photon.position).distance(centre) * self.step <= radius;
                counts.push(truly, inside);
                if inside {
                    flux += (photon.power / self.power_step).round() * self.power_step;
                }
            }
        }
        (flux, counts)
    }
}

fn absolute(case: &Case, bits: i32) -> Figures {
    let prepare = |map| Absolute::new(map, bits);
    Figures::of(&study(&case.bench, prepare, Absolute::answer))
}
