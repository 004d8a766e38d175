//! Measures how fast the golden model gathers in each format on this computer. A machine's golden model is
//! that of its format, so formats have the figure and machines have none.

use anyhow::Result;
use photoncube_render::{Engine, ErrorBench, Speed, f32_speed, gather_speed};
use photoncube_spec::find_photon_format;
use serde::Serialize;

use super::row::Row;
use crate::progress;

/// The spread between repeats above which the report warns.
const WIDE_SPREAD: f64 = 0.2;

/// The speeds of plain loops beside the golden model, and the largest spread.
#[derive(Serialize)]
pub struct Speeds {
    /// The speed of the reference's loop in f64.
    pub f64_photon_tests_per_second: f64,
    /// The speed of the reference's loop in f32.
    pub f32_photon_tests_per_second: f64,
    /// The largest spread between the repeats of one figure, divided by its median.
    pub widest_spread: f64,
}

/// Measures the formats that can represent the scene, and the plain loops.
pub fn measure(bench: &ErrorBench, rows: &mut [Row]) -> Result<Speeds> {
    let (map, queries) = (&bench.maps()[0], bench.queries());
    let formats = || rows.iter().filter(|row| is_measured(row));
    let bar = progress::bar("measuring speeds", formats().count() as u64);
    let loops = [
        gather_speed(map, queries, Engine::F64)?,
        f32_speed(map, queries),
    ];
    let mut widest_spread = loops.iter().map(Speed::spread).fold(0.0, f64::max);
    for row in rows.iter_mut().filter(|row| is_measured(row)) {
        let format = find_photon_format(&row.name)?;
        let speed: Speed = gather_speed(map, queries, Engine::from(&format))?;
        row.photon_tests_per_second = Some(speed.photon_tests_per_second);
        row.photon_tests_per_second_spread = Some(speed.spread());
        row.photon_tests_per_second_low = Some(speed.slowest);
        row.photon_tests_per_second_high = Some(speed.fastest);
        widest_spread = widest_spread.max(speed.spread());
        bar.inc(1);
    }
    bar.finish_and_clear();
    let [f64_speed, f32_speed] = loops.map(|speed| speed.photon_tests_per_second);
    Ok(Speeds {
        f64_photon_tests_per_second: f64_speed,
        f32_photon_tests_per_second: f32_speed,
        widest_spread,
    })
}

fn is_measured(row: &Row) -> bool {
    row.is_format() && row.cannot.is_none()
}

impl Speeds {
    /// A warning where the figures are not steady.
    pub fn warning(&self) -> Option<String> {
        (self.widest_spread > WIDE_SPREAD).then(|| {
            format!(
                "warning: the speeds of one format differ by up to {:.0} % between repeats: other work runs here. \
                 Differences below that say nothing.\n",
                100.0 * self.widest_spread
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unsteady_figures_are_warned_of() {
        let speeds = |widest_spread| Speeds {
            f64_photon_tests_per_second: 1.0,
            f32_photon_tests_per_second: 1.0,
            widest_spread,
        };
        assert_eq!(speeds(0.2).warning(), None);
        assert!(speeds(0.35).warning().unwrap().contains("up to 35 %"));
    }
}
