//! The scenes, maps and queries of the study, and the figures that its tables show.

use std::f64::consts::PI;

use glam::DVec3;
use photoncube_render::{
    BenchOptions, Engine, ErrorBench, ErrorReport, ErrorStudy, Interval, Misclassified, PhotonMap,
    QuantisedMap, QueryPoint, Scene, ViewOptions, luminance,
};
use photoncube_spec::{PhotonFormat, Widths, find_photon_format};
use rayon::prelude::*;

/// A built-in scene's maps and queries.
pub struct Case {
    pub name: &'static str,
    pub bench: ErrorBench,
}

impl Case {
    /// Maps of 200,000 photons with about `in_range` in range, with queries at `side` x `side` points.
    pub fn new(name: &'static str, in_range: f64, maps: u64, side: u32) -> Self {
        let scene = Scene::built_in(name).expect("a built-in scene");
        let options = BenchOptions {
            photons: 200_000,
            in_range,
            maps,
            seed: 1,
            view: ViewOptions {
                width: side,
                height: side,
                samples_per_axis: 1,
                seed: 1,
            },
        };
        Self {
            name,
            bench: ErrorBench::new(&scene, &options).expect("legal options"),
        }
    }

    /// 8 maps of every scene: enough to compare formats, which see the same photons.
    pub fn coarse() -> Vec<Self> {
        let case = |name| Self::new(name, 200.0, 8, 32);
        Scene::names().map(case).collect()
    }

    /// 32 maps and 64 x 64 queries: on the ring few queries have a bright spot's edge at their
    /// radius, and those make the error.
    pub fn fine() -> Vec<Self> {
        let case = |name| Self::new(name, 200.0, 32, 64);
        Scene::names().map(case).collect()
    }
}

/// The figures of a format in the tables.
pub struct Figures {
    pub ratio: Interval,
    pub bias: Interval,
    pub report: ErrorReport,
}

impl Figures {
    pub fn of(study: &ErrorStudy) -> Self {
        let report = study.report().expect("scenes have light");
        Self {
            ratio: study.error_over_noise().expect("several maps"),
            bias: Interval {
                mean: report.bias_relative,
                low: report.bias_relative_low,
                high: report.bias_relative_high,
            },
            report,
        }
    }

    /// Measures a format by the golden model.
    pub fn of_format(bench: &ErrorBench, name: &str) -> Self {
        let study = bench.study(Engine::from(&format(name)));
        Self::of(&study.expect("a legal format"))
    }
}

pub fn format(name: &str) -> PhotonFormat {
    find_photon_format(name).expect("a legal name")
}

pub fn bits(name: &str) -> u32 {
    Widths::of_format(&format(name)).bits_per_photon
}

pub fn quantised<'a>(map: &'a PhotonMap, name: &str) -> QuantisedMap<'a> {
    QuantisedMap::new(map, &format(name).into()).expect("a legal format")
}

/// A study of estimates that no engine makes. `answer` returns the flux in range and the in-range decisions.
pub fn study<'a, P: Sync>(
    bench: &'a ErrorBench,
    prepare: impl Fn(&'a PhotonMap) -> P,
    answer: impl Fn(&P, &QueryPoint) -> (DVec3, Misclassified) + Sync,
) -> ErrorStudy {
    let mut study = ErrorStudy::new(bench.queries().len());
    for (map, references) in bench.maps().iter().zip(bench.references()) {
        let prepared = prepare(map);
        let queries = bench.queries().par_iter();
        let answers: Vec<_> = queries.map(|query| answer(&prepared, query)).collect();
        let area = PI * map.radius() * map.radius();
        let light = |(query, (flux, _)): (&QueryPoint, &(DVec3, Misclassified))| {
            luminance(query.beta * *flux / area)
        };
        let estimates: Vec<f64> = bench.queries().iter().zip(&answers).map(light).collect();
        let mut counts = Misclassified::default();
        answers.iter().for_each(|(_, count)| counts += *count);
        let pushed = study.push_map(&estimates, references, counts);
        pushed.expect("one estimate for each query");
    }
    study
}

/// A study of rounded powers alone. The exact positions decide which photons are in range.
pub fn power_alone(
    bench: &ErrorBench,
    name: &str,
    powers: impl Fn(&QuantisedMap<'_>) -> Vec<DVec3>,
) -> ErrorStudy {
    let prepare = |map| {
        let quantised = quantised(map, name);
        let powers = powers(&quantised);
        (quantised, powers)
    };
    study(bench, prepare, |(quantised, powers), query| {
        let map = quantised.map();
        let (mut flux, mut counts) = (DVec3::ZERO, Misclassified::default());
        let runs = map.candidates(query.position, query.front());
        for photon in runs.flat_map(|run| run.photons) {
            let distance = map.photons()[photon].position.distance(query.position);
            let inside = distance <= map.radius();
            counts.push(inside, inside);
            if inside {
                flux += powers[photon];
            }
        }
        (flux, counts)
    })
}

/// The powers as the format stores them.
pub fn stored_powers(quantised: &QuantisedMap<'_>) -> Vec<DVec3> {
    let photons = 0..quantised.records().len();
    photons.map(|photon| quantised.power(photon)).collect()
}
