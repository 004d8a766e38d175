//! A figure of merit against error as a picture, with the Pareto front.

use anyhow::{Result, anyhow};
use plotters::prelude::*;

/// A configuration in the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// What it is called.
    pub label: String,
    /// Smaller is better.
    pub error: f64,
    /// The figure; the plot says which way is better.
    pub figure: f64,
}

/// Which way a figure is better.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Better {
    /// Smaller, as bits per photon.
    Smaller,
    /// Larger, as speed.
    Larger,
}

/// Which points no other beats: none is at least as good in both and better in one.
pub fn pareto_front(points: &[Point], better: Better) -> Vec<bool> {
    let gain = |a: &Point, b: &Point| match better {
        Better::Smaller => b.figure - a.figure,
        Better::Larger => a.figure - b.figure,
    };
    let beats = |a: &Point, b: &Point| {
        let as_good = a.error <= b.error && gain(a, b) >= 0.0;
        as_good && (a.error < b.error || gain(a, b) > 0.0)
    };
    let is_beaten = |point: &Point| points.iter().any(|other| beats(other, point));
    points.iter().map(|point| !is_beaten(point)).collect()
}

const SIZE: (u32, u32) = (900, 560);
const FRONT: RGBColor = RGBColor(190, 60, 40);
const OTHER: RGBColor = RGBColor(90, 110, 140);

/// What a plot shows.
#[derive(Copy, Clone, Debug)]
pub struct Plot<'a> {
    /// Its heading.
    pub title: &'a str,
    /// What the error is.
    pub error_axis: &'a str,
    /// What the figure is.
    pub figure_axis: &'a str,
    /// Which way the figure is better.
    pub better: Better,
}

/// An SVG picture: error (logarithmic) to the right, the figure upwards, the front in red.
pub fn against_error(plot: &Plot<'_>, points: &[Point]) -> Result<String> {
    let mut svg = String::new();
    draw(&mut svg, plot, points).map_err(|error| anyhow!("the plot cannot be drawn: {error}"))?;
    Ok(svg)
}

fn draw(
    svg: &mut String,
    plot: &Plot<'_>,
    points: &[Point],
) -> Result<(), Box<dyn std::error::Error>> {
    let errors = points.iter().map(|point| point.error);
    let lowest = errors.clone().fold(f64::INFINITY, f64::min);
    let highest = errors.fold(0.0, f64::max);
    let largest = points.iter().map(|point| point.figure).fold(0.0, f64::max);
    let area = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .caption(plot.title, ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(
            (0.7 * lowest..2.0 * highest).log_scale().base(2.0),
            0.0..1.1 * largest,
        )?;
    chart
        .configure_mesh()
        .x_desc(plot.error_axis)
        .y_desc(plot.figure_axis)
        .x_labels(8)
        .x_label_formatter(&|error| format!("{error:.2}"))
        .light_line_style(WHITE)
        .draw()?;
    let front = pareto_front(points, plot.better);
    let mut on_front: Vec<_> = points.iter().zip(&front).filter(|(_, f)| **f).collect();
    on_front.sort_by(|(a, _), (b, _)| a.error.total_cmp(&b.error));
    let line = on_front
        .iter()
        .map(|(point, _)| (point.error, point.figure));
    chart.draw_series(LineSeries::new(line, FRONT.stroke_width(1)))?;
    let mut labels = Labels::default();
    for (point, is_front) in points.iter().zip(front) {
        let colour = if is_front { FRONT } else { OTHER };
        let at = (point.error, point.figure);
        chart.draw_series([Circle::new(at, 4, colour.filled())])?;
        let style = ("sans-serif", 12).into_font().color(&colour);
        let height = labels.place(chart.backend_coord(&at), &point.label);
        let label = Text::new(point.label.clone(), (Labels::RIGHT, height), style);
        chart.draw_series([EmptyElement::at(at) + label])?;
    }
    area.present()?;
    drop(chart);
    Ok(())
}

/// Where labels stand already, in pixels, so that no two are written over each other.
#[derive(Default)]
struct Labels(Vec<((i32, i32), i32)>);

impl Labels {
    /// A label begins so far to the right of its point.
    const RIGHT: i32 = 6;
    const LINE: i32 = 12;
    /// The mean width of a character, rounded up.
    const CHARACTER: i32 = 7;

    /// The label's height over its point, negative as pixels count downwards: the free place that
    /// is nearest to just above it.
    fn place(&mut self, (x, y): (i32, i32), label: &str) -> i32 {
        let span = (x, x + Self::RIGHT + Self::CHARACTER * label.len() as i32);
        let heights =
            (0..20).map(|n| -Self::LINE + Self::LINE * if n % 2 == 0 { -n / 2 } else { n / 2 + 1 });
        let is_free = |height: &i32| {
            let overlaps = |((low, high), line): &((i32, i32), i32)| {
                span.0 < *high && *low < span.1 && (line - (y + height)).abs() < Self::LINE
            };
            !self.0.iter().any(overlaps)
        };
        let height = heights.clone().find(is_free).unwrap_or(-Self::LINE);
        self.0.push((span, y + height));
        height
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_one_place_stand_one_over_the_other() {
        let mut labels = Labels::default();
        let heights: Vec<_> = (0..4).map(|_| labels.place((100, 100), "label")).collect();
        assert_eq!(heights, [-12, 0, -24, 12]);
        assert_eq!(labels.place((300, 100), "far"), -12);
    }

    fn point(label: &str, error: f64, figure: f64) -> Point {
        Point {
            label: label.to_owned(),
            error,
            figure,
        }
    }

    #[test]
    fn the_front_is_what_nothing_beats() {
        let points = [
            point("exact, slow", 0.01, 1.0),
            point("rough, fast", 0.5, 9.0),
            point("beaten", 0.6, 8.0),
            point("between", 0.1, 5.0),
            point("slower for the same error", 0.1, 4.0),
        ];
        let front = pareto_front(&points, Better::Larger);
        assert_eq!(front, [true, true, false, true, false]);
        let front = pareto_front(&points, Better::Smaller);
        assert_eq!(front, [true, false, false, false, false]);
    }

    #[test]
    fn equal_points_are_both_on_the_front() {
        let points = [point("a", 0.1, 1.0), point("b", 0.1, 1.0)];
        assert_eq!(pareto_front(&points, Better::Larger), [true, true]);
    }

    #[test]
    fn every_point_is_named_in_the_picture() {
        let points = [point("first", 0.01, 1e6), point("second", 0.5, 9e6)];
        let plot = Plot {
            title: "title",
            error_axis: "error",
            figure_axis: "speed",
            better: Better::Larger,
        };
        let svg = against_error(&plot, &points).unwrap();
        for text in ["<svg", "title", "first", "second", "error", "speed"] {
            assert!(svg.contains(text), "{text}");
        }
    }
}
