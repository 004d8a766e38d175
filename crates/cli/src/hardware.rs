//! The time that a machine takes for a picture, at its measured clock.

use anyhow::Result;
use photoncube_render::{PhotonMap, QueryPoint, forecast_clocks};
use photoncube_spec::Machine;
use serde::Serialize;

use crate::measured::Measured;
use crate::table::significant;

/// The time of a picture on a machine. Fields are `None` where a clock was not measured.
#[derive(Clone, Debug, Default, Serialize)]
pub struct PictureTime {
    /// The golden model's clocks for all queries while no stream waits.
    pub clocks: Option<u64>,
    /// The highest clock of the routed machine in MHz.
    pub fmax_mhz: Option<f64>,
    /// The speed grade of that clock, the fastest that was measured.
    pub speed_grade: Option<u32>,
    /// The seconds for a picture at that clock.
    pub seconds_per_picture: Option<f64>,
    /// The pictures per second at that clock.
    pub pictures_per_second: Option<f64>,
}

impl PictureTime {
    /// The time of the queries on the photons of `map`.
    pub fn of(machine: &Machine, map: &PhotonMap, queries: &[QueryPoint]) -> Result<Self> {
        let clocks = forecast_clocks(map, queries, machine)?;
        let measured = Measured::of(machine)?;
        let fastest = measured.fastest();
        Ok(match (clocks, fastest) {
            (Some(clocks), Some(clock)) => Self::at(clocks, clock.fmax_mhz, clock.speed_grade),
            _ => Self {
                clocks,
                fmax_mhz: fastest.map(|clock| clock.fmax_mhz),
                speed_grade: fastest.and_then(|clock| clock.speed_grade),
                ..Self::default()
            },
        })
    }

    /// The time of so many clocks at a measured clock.
    pub fn at(clocks: u64, fmax_mhz: f64, speed_grade: Option<u32>) -> Self {
        let seconds = clocks as f64 / (fmax_mhz * 1e6);
        Self {
            clocks: Some(clocks),
            fmax_mhz: Some(fmax_mhz),
            speed_grade,
            seconds_per_picture: Some(seconds),
            pictures_per_second: Some(seconds.recip()),
        }
    }

    /// "0.34 s a picture, 2.9 pictures/s, at 95 MHz (ECP5, speed grade 8, routed), no waiting".
    pub fn text(&self) -> String {
        self.said("no waiting")
    }

    /// The text for a core, in whose clocks the words on its streams are counted.
    pub fn text_with_loads(&self) -> String {
        self.said("loads of photons included")
    }

    fn said(&self, of_streams: &str) -> String {
        match (self.seconds_per_picture, self.fmax_mhz, self.speed_grade) {
            (Some(seconds), Some(mhz), Some(grade)) => format!(
                "{} s a picture, {} pictures/s, at {mhz:.0} MHz (ECP5, speed grade {grade}, routed), {of_streams}",
                digits(seconds),
                digits(seconds.recip())
            ),
            _ => "its speed is not known, as no clock of it is measured".to_owned(),
        }
    }
}

/// A number with three significant digits.
pub fn digits(number: f64) -> String {
    significant(number, 3)
}

#[cfg(test)]
mod tests {
    use photoncube_render::{Scene, TraceOptions, ViewOptions, trace, view_queries};
    use photoncube_spec::MACHINES;

    use super::*;

    #[test]
    fn a_picture_takes_its_clocks_at_the_measured_clock() {
        let scene = Scene::built_in("ring").unwrap();
        let options = TraceOptions {
            photons: 2_000,
            seed: 1,
        };
        let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
        let map = PhotonMap::new(&scene, photons, 0.2).unwrap();
        let view = ViewOptions {
            width: 8,
            height: 8,
            ..ViewOptions::default()
        };
        let queries = view_queries(&scene, &view).unwrap();
        for machine in MACHINES {
            let time = PictureTime::of(machine, &map, &queries).unwrap();
            let (clocks, mhz) = (time.clocks.unwrap(), time.fmax_mhz.unwrap());
            let seconds = time.seconds_per_picture.unwrap();
            // A rounding of a division.
            assert!((seconds * mhz * 1e6 / clocks as f64 - 1.0).abs() < 1e-12);
            assert!(time.text().contains("pictures/s"), "{}", time.text());
        }
    }

    #[test]
    fn numbers_have_three_digits() {
        assert_eq!(
            [0.012_345, 1.234_5, 1234.5].map(digits),
            ["0.0123", "1.23", "1234"]
        );
    }
}
