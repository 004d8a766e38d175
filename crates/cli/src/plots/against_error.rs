//! Plots a figure of merit against the error, with the bound and the Pareto front below it.

use anyhow::Result;
use plotters::prelude::*;

use super::chart::{Axis, Chart, Drawn, Frame, chart, framed, range};
use super::labels::{Labels, leader};
use super::legend::{Item, Mark};
use super::palette::{FAINT, FIRST, INK, SECOND, THIRD};
use super::ticks;

/// The kind of a point.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A photon format without a machine.
    Format,
    /// A machine in its own format.
    Machine,
}

/// A configuration in the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The name of the configuration.
    pub label: String,
    /// The kind of the configuration.
    pub kind: Kind,
    /// The error; smaller is better.
    pub error: f64,
    /// The 95 % interval of the error.
    pub interval: [f64; 2],
    /// The figure of merit; the plot states which direction is better.
    pub figure: f64,
    /// The smallest and the largest of its repeated measurements; `None` where it is not measured on this computer.
    pub figure_range: Option<[f64; 2]>,
    /// Whether its error is within the bound.
    pub holds: bool,
}

/// The direction in which a figure of merit is better.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Better {
    /// Smaller is better, as for bits per photon.
    Smaller,
    /// Larger is better, as for speed.
    Larger,
}

/// For each point whether it is within the bound and not dominated: no other such point is at least as good
/// in both figures and better in one.
pub fn pareto_front(points: &[Point], better: Better) -> Vec<bool> {
    let gain = |a: &Point, b: &Point| match better {
        Better::Smaller => b.figure - a.figure,
        Better::Larger => a.figure - b.figure,
    };
    let beats = |a: &Point, b: &Point| {
        let as_good = a.error <= b.error && gain(a, b) >= 0.0;
        a.holds && as_good && (a.error < b.error || gain(a, b) > 0.0)
    };
    let is_beaten = |point: &Point| points.iter().any(|other| beats(other, point));
    let on_front = |point: &Point| point.holds && !is_beaten(point);
    points.iter().map(on_front).collect()
}

const SIZE: (u32, u32) = (1100, 760);

/// The largest error in the chart, as a multiple of the bound; farther points would compress the others.
const FARTHEST: f64 = 5.0;

/// The contents of a plot.
#[derive(Copy, Clone, Debug)]
pub struct Plot<'a> {
    /// The heading of the plot.
    pub title: &'a str,
    /// The label of the error axis.
    pub error_axis: &'a str,
    /// The label of the figure axis.
    pub figure_axis: &'a str,
    /// The direction in which the figure is better.
    pub better: Better,
    /// The bound of the error.
    pub bound: f64,
}

const LEGEND: [Item; 6] = [
    item(Mark::Disc, SECOND, "photon format"),
    item(Mark::Square, THIRD, "machine"),
    item(Mark::Disc, FAINT, "above the bound"),
    item(Mark::Dashes, INK, "bound"),
    item(Mark::Line, FIRST, "best below it (Pareto front)"),
    item(Mark::Line, FAINT, "95 % interval of these"),
];

const fn item(mark: Mark, colour: RGBColor, means: &'static str) -> Item {
    Item {
        mark,
        colour,
        means,
    }
}

/// An SVG picture with the error on the x axis and the figure on the y axis, both logarithmic.
pub fn against_error(plot: &Plot<'_>, points: &[Point]) -> Result<String> {
    let (shown, off) = shown(plot, points);
    let frame = Frame {
        size: SIZE,
        title: plot.title,
        description: &description(plot, points, &off),
        legend: &LEGEND,
    };
    framed(&frame, |area| {
        let errors = shown.iter().map(|point| point.error).chain([plot.bound]);
        let (low, high) = range(errors);
        let x = Axis {
            name: plot.error_axis,
            low,
            high,
            ticks: ticks::round(low, high),
            text: ticks::short,
        };
        let (low, high) = range(shown.iter().map(|point| point.figure));
        let y = Axis {
            name: plot.figure_axis,
            low,
            high,
            ticks: ticks::round(low, high),
            text: ticks::short,
        };
        let mut chart = chart(area, &x, &y)?;
        let line = [(plot.bound, y.low), (plot.bound, y.high)];
        chart.draw_series(DashedLineSeries::new(line, 8, 6, INK.stroke_width(2)))?;
        let front = pareto_front(&shown, plot.better);
        draw_intervals(&mut chart, &shown, &front, (x.low, x.high))?;
        draw_front(&mut chart, &shown, &front)?;
        draw_points(&mut chart, &shown, &front)?;
        if !off.is_empty() {
            let text = format!("right of the picture: {}", off.join(", "));
            let style = ("sans-serif", 14).into_font().color(&INK);
            area.draw(&Text::new(text, (100, 2), style))?;
        }
        Ok(())
    })
}

/// The points of the picture, with points at one place merged, and the names and errors of the points outside
/// it.
fn shown(plot: &Plot<'_>, points: &[Point]) -> (Vec<Point>, Vec<String>) {
    let drawable = |point: &&Point| point.error > 0.0 && point.figure > 0.0;
    let is_near = |point: &&Point| point.error <= FARTHEST * plot.bound;
    let any_near = points.iter().filter(drawable).any(|p| is_near(&p));
    let (near, far): (Vec<_>, Vec<_>) = points
        .iter()
        .filter(drawable)
        .partition(|point| !any_near || is_near(point));
    let far = far.into_iter();
    let far = far.map(|point| format!("{} ({:.2})", point.label, point.error));
    let mut shown: Vec<(Point, usize)> = Vec::new();
    for point in near {
        let same = |(other, _): &&mut (Point, usize)| {
            (other.error, other.figure, other.kind) == (point.error, point.figure, point.kind)
        };
        match shown.iter_mut().find(same) {
            Some((_, others)) => *others += 1,
            None => shown.push((point.clone(), 0)),
        }
    }
    let named = shown.into_iter().map(|(point, others)| match others {
        0 => point,
        _ => Point {
            label: format!("{} and {others} alike", point.label),
            ..point
        },
    });
    (named.collect(), far.collect())
}

/// A description of the picture in a few sentences.
fn description(plot: &Plot<'_>, points: &[Point], off: &[String]) -> String {
    let holds = points.iter().filter(|point| point.holds).count();
    let front = pareto_front(points, plot.better);
    let best = points.iter().zip(front).filter(|(_, is_best)| *is_best);
    let best: Vec<_> = best
        .map(|(p, _)| format!("{} ({:.3}, {})", p.label, p.error, ticks::short(p.figure)))
        .collect();
    format!(
        "{} upwards against {} to the right, both logarithmic. {holds} of {} are within the bound of {}. Best of \
         these, with error and figure: {}. Right of the picture: {}.",
        plot.figure_axis,
        plot.error_axis,
        points.len(),
        plot.bound,
        none_or(&best),
        none_or(off),
    )
}

fn none_or(names: &[String]) -> String {
    match names {
        [] => "none".to_owned(),
        names => names.join(", "),
    }
}

/// Draws the intervals of the front only, because those of all points would hide the points.
fn draw_intervals(
    chart: &mut Chart<'_>,
    points: &[Point],
    front: &[bool],
    (left, right): (f64, f64),
) -> Drawn {
    let best = points.iter().zip(front).filter(|(_, is_best)| **is_best);
    let whiskers = best.map(|(point, _)| {
        let ends = point.interval.map(|error| error.clamp(left, right));
        let line = ends.map(|error| (error, point.figure));
        PathElement::new(line, FAINT.stroke_width(1))
    });
    chart.draw_series(whiskers)?;
    Ok(())
}

fn draw_front(chart: &mut Chart<'_>, points: &[Point], front: &[bool]) -> Drawn {
    let mut best: Vec<_> = points.iter().zip(front).filter(|(_, f)| **f).collect();
    best.sort_by(|(a, _), (b, _)| a.error.total_cmp(&b.error));
    let line = best.iter().map(|(point, _)| (point.error, point.figure));
    chart.draw_series(LineSeries::new(line, FIRST.stroke_width(2)))?;
    Ok(())
}

fn draw_points(chart: &mut Chart<'_>, points: &[Point], front: &[bool]) -> Drawn {
    // The labels of the front are placed first, so that they get the best places.
    let mut order: Vec<_> = points.iter().zip(front).collect();
    order.sort_by_key(|(point, is_front)| (!**is_front, !point.holds));
    let place = |point: &Point| chart.backend_coord(&(point.error, point.figure));
    let places: Vec<_> = order.iter().map(|(point, _)| place(point)).collect();
    let (across, down) = chart.plotting_area().get_pixel_range();
    let within = ((across.start, down.start), (across.end, down.end));
    let mut labels = Labels::around(&places, within);
    for ((point, is_front), (x, y)) in order.into_iter().zip(places) {
        let colour = match (point.holds, point.kind) {
            (false, _) => FAINT,
            (true, Kind::Format) => SECOND,
            (true, Kind::Machine) => THIRD,
        };
        let at = || EmptyElement::at((point.error, point.figure));
        match point.kind {
            Kind::Format => chart.draw_series([at() + Circle::new((0, 0), 5, colour.filled())])?,
            Kind::Machine => {
                let square = Rectangle::new([(-5, -5), (5, 5)], colour.filled());
                chart.draw_series([at() + square])?
            }
        };
        let Some(label) = labels.place((x, y), &point.label) else {
            continue;
        };
        let ink = match (is_front, point.holds) {
            (true, _) => FIRST,
            (false, true) => INK,
            (false, false) => RGBColor(110, 110, 110),
        };
        if let Some((to_x, to_y)) = leader((x, y), label) {
            let line = PathElement::new([(0, 0), (to_x - x, to_y - y)], ink.stroke_width(1));
            chart.draw_series([at() + line])?;
        }
        let (left, top) = label.0;
        let style = ("sans-serif", 15).into_font().color(&ink);
        let text = Text::new(point.label.clone(), (left - x, top - y), style);
        chart.draw_series([at() + text])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(label: &str, error: f64, figure: f64) -> Point {
        Point {
            label: label.to_owned(),
            kind: Kind::Format,
            error,
            interval: [0.9 * error, 1.1 * error],
            figure,
            figure_range: None,
            holds: error <= 0.7,
        }
    }

    fn plot(bound: f64) -> Plot<'static> {
        Plot {
            title: "which < is best",
            error_axis: "error",
            figure_axis: "speed",
            better: Better::Larger,
            bound,
        }
    }

    #[test]
    fn the_front_is_what_nothing_beats_below_the_bound() {
        let points = [
            point("exact, slow", 0.01, 1.0),
            point("rough, fast", 0.5, 9.0),
            point("beaten", 0.6, 8.0),
            point("between", 0.1, 5.0),
            point("slower for the same error", 0.1, 4.0),
            point("fastest, useless", 0.8, 99.0),
        ];
        let front = pareto_front(&points, Better::Larger);
        assert_eq!(front, [true, true, false, true, false, false]);
        let front = pareto_front(&points, Better::Smaller);
        assert_eq!(front, [true, false, false, false, false, false]);
    }

    #[test]
    fn equal_points_are_both_on_the_front() {
        let points = [point("a", 0.1, 1.0), point("b", 0.1, 1.0)];
        assert_eq!(pareto_front(&points, Better::Larger), [true, true]);
    }

    #[test]
    fn the_picture_names_points_marks_and_itself() {
        let points = [point("first", 0.01, 1e6), point("second", 0.5, 9e6)];
        let svg = against_error(&plot(0.7), &points).unwrap();
        assert!(svg.contains("<title>which &lt; is best</title>"), "{svg}");
        assert!(svg.contains("2 of 2 are within the bound of 0.7"), "{svg}");
        for text in LEGEND.iter().map(|item| item.means) {
            assert!(svg.contains(text), "{text}");
        }
        for text in ["<svg", "role=\"img\"", "first", "second", "error", "speed"] {
            assert!(svg.contains(text), "{text}");
        }
    }

    #[test]
    fn far_points_are_named_and_points_of_one_place_are_one() {
        let points = [
            point("near", 0.1, 1.0),
            point("same", 0.1, 1.0),
            point("far", 4.3, 1.0),
            point("exact", 0.0, 1.0),
        ];
        let (near, far) = shown(&plot(0.1), &points);
        let labels: Vec<_> = near.iter().map(|point| point.label.as_str()).collect();
        assert_eq!(
            (labels, far),
            (vec!["near and 1 alike"], vec!["far (4.30)".to_owned()])
        );
        // Where all points are far away, all are shown.
        assert_eq!(shown(&plot(0.001), &points).0.len(), 2);
        assert!(against_error(&plot(0.1), &points[..0]).is_ok());
    }
}
