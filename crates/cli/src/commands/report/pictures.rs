//! The plots of figures against the error.

use anyhow::Result;

use super::Report;
use super::row::Row;
use crate::plots::{Better, Plot, Point, against_error, pareto_front};

/// A figure of merit that is plotted against the error.
pub struct Merit {
    title: &'static str,
    axis: &'static str,
    better: Better,
    pub of: fn(&Row) -> Option<f64>,
}

pub const SPEED: Merit = Merit {
    title: "the golden model's speed on this CPU, by photon format",
    axis: "M photon tests per second, one thread",
    better: Better::Larger,
    of: |row| Some(row.photon_tests_per_second? / 1e6),
};

pub const HARDWARE: Merit = Merit {
    title: "the machines' speed on an ECP5",
    axis: "G photon tests per second at the routed Fmax",
    better: Better::Larger,
    of: |row| Some(row.hardware.photon_tests_per_second_at_fmax? / 1e9),
};

pub const BITS: Merit = Merit {
    title: "how few bits a photon needs",
    axis: "bits per photon",
    better: Better::Smaller,
    of: |row| Some(f64::from(row.bits_per_photon)),
};

/// Marks the rows that are best within the bound.
pub fn mark_fronts(rows: &mut [Row]) {
    for (merit, mark) in [
        (
            &BITS,
            (|row| &mut row.on_bits_front) as fn(&mut Row) -> &mut bool,
        ),
        (&HARDWARE, |row| &mut row.on_hardware_front),
        (&SPEED, |row| &mut row.on_speed_front),
    ] {
        let points: Vec<_> = rows.iter().map(|row| merit.point(row)).collect();
        let known: Vec<_> = points.iter().flatten().cloned().collect();
        let mut front = pareto_front(&known, merit.better).into_iter();
        for (row, point) in rows.iter_mut().zip(&points) {
            *mark(row) = point.is_some() && front.next().unwrap_or(false);
        }
    }
}

impl Merit {
    fn point(&self, row: &Row) -> Option<Point> {
        row.point((self.of)(row)?)
    }

    /// Draws the plot as SVG.
    pub fn draw(&self, report: &Report) -> Result<String> {
        let points: Vec<_> = report
            .rows
            .iter()
            .filter_map(|row| self.point(row))
            .collect();
        let scene = &report.facts.scene_name;
        let plot = Plot {
            title: &format!("Scene {scene}: {}", self.title),
            error_axis: "rms error over the scene's own noise, worst of luminance, red, green, blue",
            figure_axis: self.axis,
            better: self.better,
            bound: report.noise_ratio,
        };
        against_error(&plot, &points)
    }
}
