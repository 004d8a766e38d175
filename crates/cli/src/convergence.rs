//! Plots of how errors fall.

use anyhow::{Result, anyhow};
use plotters::prelude::*;

/// An error after so much work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Passes made.
    pub passes: f64,
    /// Photons in their maps.
    pub photons: f64,
    /// The relative error.
    pub error: f64,
}

/// A line of the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What it shows.
    pub name: &'static str,
    /// In their order; all figures over 0.
    pub points: Vec<Reached>,
}

/// One of the two charts: what is to the right.
type Axis = (&'static str, fn(&Reached) -> f64);

const AXES: [Axis; 2] = [("passes", |p| p.passes), ("photons", |p| p.photons)];
const SIZE: (u32, u32) = (1400, 620);
const COLOURS: [RGBColor; 4] = [
    RGBColor(190, 60, 40),
    RGBColor(90, 110, 140),
    RGBColor(60, 140, 90),
    RGBColor(30, 30, 30),
];

/// An SVG picture of errors against passes and against photons, logarithmic. Curves without points are left out.
pub fn convergence_plot(title: &str, curves: &[Curve]) -> Result<String> {
    let mut svg = String::new();
    draw(&mut svg, title, curves).map_err(|error| anyhow!("the plot cannot be drawn: {error}"))?;
    Ok(svg)
}

type Drawn = Result<(), Box<dyn std::error::Error>>;

fn draw(svg: &mut String, title: &str, curves: &[Curve]) -> Drawn {
    let area = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let charts = area.titled(title, ("sans-serif", 20))?;
    for (chart, axis) in charts.split_evenly((1, AXES.len())).iter().zip(AXES) {
        draw_chart(chart, axis, curves)?;
    }
    area.present()?;
    Ok(())
}

fn draw_chart(
    area: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>,
    (name, place): Axis,
    curves: &[Curve],
) -> Drawn {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let mut chart = ChartBuilder::on(area)
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(
            range(points().map(place)).log_scale(),
            range(points().map(|point| point.error)).log_scale(),
        )?;
    chart
        .configure_mesh()
        .x_desc(name)
        .y_desc("relative error")
        .x_labels(14)
        .x_label_formatter(&|place| short(*place))
        .y_label_formatter(&|error| format!("{:.1} %", 100.0 * error))
        .light_line_style(WHITE)
        .draw()?;
    for (curve, colour) in curves.iter().zip(COLOURS) {
        if !curve.points.is_empty() {
            let line = curve.points.iter().map(|point| (place(point), point.error));
            let line = LineSeries::new(line, colour.stroke_width(2)).point_size(3);
            let swatch = move |(x, y)| PathElement::new(vec![(x, y), (x + 20, y)], colour);
            chart.draw_series(line)?.label(curve.name).legend(swatch);
        }
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .border_style(BLACK)
        .background_style(WHITE)
        .draw()?;
    Ok(())
}

/// A count in few characters.
fn short(count: f64) -> String {
    match count {
        c if c >= 1e6 => format!("{} M", c / 1e6),
        c if c >= 1e3 => format!("{} k", c / 1e3),
        c => format!("{c:.0}"),
    }
}

/// From a little below the smallest to a little above the largest; anything where there is nothing.
fn range(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if high > 0.0 {
        0.9 * low..1.25 * high
    } else {
        0.1..1.0
    }
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
            curve("bound", &[reached(2.0, 0.5), reached(4.0, 0.3)]),
            curve("bias", &[]),
        ];
        let svg = convergence_plot("title", &curves).unwrap();
        for text in ["title", "bound", "passes", "photons", "relative error"] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(!svg.contains("bias"));
        assert!(convergence_plot("nothing", &[]).is_ok());
    }

    #[test]
    fn counts_are_short() {
        assert_eq!([3.0, 2e4, 5e6].map(short), ["3", "20 k", "5 M"]);
    }
}
