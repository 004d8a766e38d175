//! Plots the decrease of errors.

use anyhow::Result;
use plotters::prelude::*;

use super::chart::{Area, Axis, Drawn, Frame, chart, framed, range};
use super::legend::{Item, Mark};
use super::palette::{FIRST, INK, SECOND, THIRD};
use super::ticks;

/// An error, with the work after which it was reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// The number of passes made.
    pub passes: f64,
    /// The number of photons in their maps.
    pub photons: f64,
    /// The relative error.
    pub error: f64,
}

/// A line of the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The name of the curve.
    pub name: &'static str,
    /// The points in their order; all figures are over 0.
    pub points: Vec<Reached>,
}

/// One of the two charts: the quantity on the x axis, and its labelled numbers.
struct Chart {
    name: &'static str,
    of: fn(&Reached) -> f64,
    ticks: fn(f64, f64) -> Vec<f64>,
}

const CHARTS: [Chart; 2] = [
    Chart {
        name: "passes",
        of: |reached| reached.passes,
        ticks: ticks::doublings,
    },
    Chart {
        name: "photons",
        of: |reached| reached.photons,
        ticks: ticks::round,
    },
];
const SIZE: (u32, u32) = (1400, 660);
const COLOURS: [RGBColor; 4] = [FIRST, SECOND, THIRD, INK];

/// An SVG picture of errors against passes and against photons, logarithmic. Curves without points are left
/// out.
pub fn convergence_plot(title: &str, curves: &[Curve]) -> Result<String> {
    let items = curves.iter().zip(COLOURS);
    let items = items.filter(|(curve, _)| !curve.points.is_empty());
    let legend = items.map(|(curve, colour)| Item {
        mark: Mark::Line,
        colour,
        means: curve.name,
    });
    let frame = Frame {
        size: SIZE,
        title,
        description: &description(curves),
        legend: &legend.collect::<Vec<_>>(),
    };
    framed(&frame, |area| {
        let areas = area.split_evenly((1, CHARTS.len()));
        let mut charts = areas.iter().zip(CHARTS);
        charts.try_for_each(|(area, chart)| draw(area, &chart, curves))
    })
}

/// A sentence that states the end of each curve.
fn description(curves: &[Curve]) -> String {
    let ends = curves.iter().filter_map(|curve| {
        let last = curve.points.last()?;
        let (error, passes) = (ticks::percent(last.error), last.passes);
        Some(format!("{}: {error} after {passes} passes", curve.name))
    });
    let ends = ends.collect::<Vec<_>>().join("; ");
    format!("Relative error upwards against passes and against photons, all logarithmic. {ends}.")
}

fn draw(area: &Area<'_>, axis: &Chart, curves: &[Curve]) -> Drawn {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let (left, right) = range(points().map(axis.of));
    let x = Axis {
        name: axis.name,
        low: left,
        high: right,
        ticks: (axis.ticks)(left, right),
        text: ticks::short,
    };
    let (low, high) = range(points().map(|point| point.error));
    let y = Axis {
        name: "relative error",
        low,
        high,
        ticks: ticks::round(low, high),
        text: ticks::percent,
    };
    let mut chart = chart(area, &x, &y)?;
    for (curve, colour) in curves.iter().zip(COLOURS) {
        let line = curve
            .points
            .iter()
            .map(|point| ((axis.of)(point), point.error));
        chart.draw_series(LineSeries::new(line, colour.stroke_width(2)).point_size(4))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_named_and_empty_ones_are_not() {
        let reached = |passes, error| Reached {
            passes,
            photons: 2e5 * passes,
            error,
        };
        let curve = |name, points: &[Reached]| Curve {
            name,
            points: points.to_vec(),
        };
        let curves = [
            curve("bound", &[reached(2.0, 0.5), reached(4.0, 0.03)]),
            curve("bias", &[]),
        ];
        let svg = convergence_plot("title", &curves).unwrap();
        for text in [
            "<title>title</title>",
            "bound",
            "passes",
            "photons",
            "relative error",
        ] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(svg.contains("bound: 3 % after 4 passes"), "{svg}");
        // Values below ten per cent have labels too.
        assert!(svg.contains("\n5 %\n"), "{svg}");
        assert!(!svg.contains("bias"));
        assert!(convergence_plot("nothing", &[]).is_ok());
    }
}
