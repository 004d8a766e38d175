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

const SIZE: (u32, u32) = (1100, 700);
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
        .x_label_formatter(&|error| format!("{error:.3}"))
        .light_line_style(WHITE)
        .draw()?;
    let front = pareto_front(points, plot.better);
    let mut on_front: Vec<_> = points.iter().zip(&front).filter(|(_, f)| **f).collect();
    on_front.sort_by(|(a, _), (b, _)| a.error.total_cmp(&b.error));
    let line = on_front
        .iter()
        .map(|(point, _)| (point.error, point.figure));
    chart.draw_series(LineSeries::new(line, FRONT.stroke_width(1)))?;
    // The front's labels first: they get the best places.
    let mut order: Vec<_> = points.iter().zip(front).collect();
    order.sort_by_key(|(_, is_front)| !is_front);
    let place = |point: &Point| chart.backend_coord(&(point.error, point.figure));
    let places: Vec<_> = order.iter().map(|(point, _)| place(point)).collect();
    let mut labels = Labels::around(&places);
    for ((point, is_front), place) in order.into_iter().zip(places) {
        let colour = if is_front { FRONT } else { OTHER };
        let at = EmptyElement::at((point.error, point.figure));
        let dot = Circle::new((0, 0), 4, colour.filled());
        let style = ("sans-serif", 12).into_font().color(&colour);
        let label = Text::new(
            point.label.clone(),
            labels.place(place, &point.label),
            style,
        );
        chart.draw_series([at + dot + label])?;
    }
    area.present()?;
    drop(chart);
    Ok(())
}

/// Where points and labels stand already, in pixels, so that no label is written over another.
struct Labels(Vec<Rectangle>);

/// From (left, top) to (right, bottom).
type Rectangle = ((i32, i32), (i32, i32));

impl Labels {
    const LINE: i32 = 13;
    /// The mean width of a character, rounded up.
    const CHARACTER: i32 = 7;
    /// Half of a point's size.
    const POINT: i32 = 5;

    fn around(points: &[(i32, i32)]) -> Self {
        let r = Self::POINT;
        let square = |&(x, y): &(i32, i32)| ((x - r, y - r), (x + r, y + r));
        Self(points.iter().map(square).collect())
    }

    /// Where the label's left top is, from its point on: the nearest free place to either side.
    fn place(&mut self, (x, y): (i32, i32), label: &str) -> (i32, i32) {
        let width = Self::CHARACTER * label.len() as i32;
        let rows = (0..20).flat_map(|row| [-Self::LINE - row * 4, row * 4 - Self::LINE / 2]);
        let offsets = rows.flat_map(|top| [(Self::POINT + 1, top), (-Self::POINT - width, top)]);
        let rectangle = |(left, top)| {
            let (left, top) = (x + left, y + top);
            ((left, top), (left + width, top + Self::LINE))
        };
        let is_free = |offset: &(i32, i32)| {
            let new = rectangle(*offset);
            !self.0.iter().any(|old| overlap(*old, new))
        };
        let found = offsets.clone().find(is_free);
        let offset = found.unwrap_or((Self::POINT + 1, -Self::LINE));
        self.0.push(rectangle(offset));
        offset
    }
}

fn overlap(a: Rectangle, b: Rectangle) -> bool {
    a.0.0 < b.1.0 && b.0.0 < a.1.0 && a.0.1 < b.1.1 && b.0.1 < a.1.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_one_place_stand_apart() {
        let place = (100, 100);
        let mut labels = Labels::around(&[place]);
        for _ in 0..6 {
            labels.place(place, "label");
        }
        for (index, one) in labels.0.iter().enumerate() {
            assert!(labels.0[..index].iter().all(|other| !overlap(*one, *other)));
        }
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
