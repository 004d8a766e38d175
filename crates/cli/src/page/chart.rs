//! A figure of merit against the error, as SVG: both axes logarithmic, the bound drawn, what is beyond it greyed.

use std::fmt::Write as _;

use maud::{Markup, PreEscaped, html};

use super::figures::{Cell, figures};
use super::scrolling;
use crate::plots::labels::{Labels, leader};
use crate::plots::{Better, Kind, Point, pareto_front, ticks};
use crate::table::significant;

/// A chart.
pub struct Chart<'a> {
    /// The name of the figure, with its unit.
    pub figure: &'a str,
    /// The name of the error.
    pub error: &'a str,
    /// Which direction of the figure is better.
    pub better: Better,
    /// The bound of the error.
    pub bound: f64,
    /// The error that equals the scene's own noise.
    pub noise: f64,
    /// The points.
    pub points: &'a [Point],
}

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 520.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 64.0;

/// A logarithmic scale from values to places.
struct Scale {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Scale {
    /// A scale that has room around all values.
    fn of(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
        for value in values {
            low = low.min(value);
            high = high.max(value);
        }
        let (low, high) = (low / 1.3, high * 1.3);
        Self {
            low,
            high,
            from,
            to,
        }
    }

    fn at(&self, value: f64) -> f64 {
        let part = (value / self.low).ln() / (self.high / self.low).ln();
        self.from + part.clamp(0.0, 1.0) * (self.to - self.from)
    }
}

impl Chart<'_> {
    /// The chart, and its points as a table.
    pub fn markup(&self) -> Markup {
        let points: Vec<_> = self
            .points
            .iter()
            .filter(|point| is_positive(point))
            .cloned()
            .collect();
        if points.is_empty() {
            return html! { p { "No figure of " (self.figure) " was measured." } };
        }
        let front = pareto_front(&points, self.better);
        html! {
            figure.chart {
                (scrolling(&format!("Chart: {}", self.figure), PreEscaped(self.svg(&points, &front))))
                p.readout aria-live="polite" { "Point at a mark, or step to it by the Tab key, to read its figures." }
                ul.legend {
                    li { span.mark.format {} "photon format" }
                    li { span.mark.machine {} "machine" }
                    li { span.mark.best {} "best within the bound (Pareto front)" }
                    li { span.mark.beyond {} "error above the bound" }
                    li { span.mark.whisker {} "of the best: 95 % interval of the error" }
                    @if points.iter().any(|point| point.figure_range.is_some()) {
                        li { span.mark.whisker.upright {} "of formats: slowest and fastest repeat on this computer" }
                    }
                }
            }
            details {
                summary { "The figures of this chart as a table" }
                (self.table(&points, &front))
            }
        }
    }

    fn table(&self, points: &[Point], front: &[bool]) -> Markup {
        let rows: Vec<_> = points
            .iter()
            .zip(front)
            .map(|(point, on_front)| {
                vec![
                    Cell::text(&point.label),
                    Cell::Number(significant(point.figure, 3)),
                    Cell::Number(significant(point.error, 3)),
                    Cell::Number(spelled(point.interval)),
                    point
                        .figure_range
                        .map_or(Cell::None, |range| Cell::Number(spelled(range))),
                    Cell::text(if point.holds { "yes" } else { "no" }),
                    Cell::text(if *on_front { "yes" } else { "" }),
                ]
            })
            .collect();
        let header = [
            "name",
            self.figure,
            self.error,
            "95 % interval",
            "slowest to fastest repeat",
            "within the bound",
            "on the Pareto front",
        ];
        figures(
            &format!("{} against {}", self.figure, self.error),
            &header,
            &rows,
            |row| !points[row].holds,
        )
    }

    fn svg(&self, points: &[Point], front: &[bool]) -> String {
        let errors = points.iter().map(|point| point.error);
        let x = Scale::of(errors.chain([self.bound]), LEFT, WIDTH - RIGHT);
        let figures = points.iter().map(|point| point.figure);
        let repeats = points.iter().filter_map(|point| point.figure_range);
        let y = Scale::of(figures.chain(repeats.flatten()), HEIGHT - BOTTOM, TOP);
        let mut svg = format!(
            "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"group\" aria-label=\"{}\">\n",
            escaped(&self.description(points, front))
        );
        let bound = x.at(self.bound);
        let _ = writeln!(
            svg,
            "<rect class=\"beyond\" x=\"{bound:.1}\" y=\"{TOP}\" width=\"{:.1}\" height=\"{:.1}\"/>",
            WIDTH - RIGHT - bound,
            HEIGHT - BOTTOM - TOP
        );
        self.axes(&mut svg, &x, &y);
        let _ = writeln!(
            svg,
            "<path class=\"bound\" d=\"M{bound:.1} {TOP}V{:.1}\"/><text class=\"bound-name\" text-anchor=\"middle\" x=\"{:.1}\" y=\"{:.1}\">bound {}</text>",
            HEIGHT - BOTTOM,
            bound,
            TOP - 10.0,
            significant(self.bound, 2)
        );
        if (x.low..x.high).contains(&self.noise) {
            let noise = x.at(self.noise);
            let _ = writeln!(
                svg,
                "<path class=\"noise\" d=\"M{noise:.1} {TOP}V{:.1}\"/><text class=\"bound-name\" text-anchor=\"middle\" x=\"{noise:.1}\" y=\"{:.1}\">the scene's noise</text>",
                HEIGHT - BOTTOM,
                TOP - 10.0
            );
        }
        self.front(&mut svg, points, front, &x, &y);
        whiskers(&mut svg, points, front, &x, &y);
        for (point, on_front) in points.iter().zip(front) {
            self.point(
                &mut svg,
                point,
                *on_front,
                [x.at(point.error), y.at(point.figure)],
            );
        }
        labels(&mut svg, points, front, &x, &y, self.bound);
        svg + "</svg>\n"
    }

    fn axes(&self, svg: &mut String, x: &Scale, y: &Scale) {
        let foot = HEIGHT - BOTTOM;
        for value in ticks::round(x.low, x.high) {
            let at = x.at(value);
            let _ = writeln!(
                svg,
                "<path class=\"grid\" d=\"M{at:.1} {TOP}V{foot}\"/><text class=\"tick\" x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
                foot + 20.0,
                ticks::short(value)
            );
        }
        for value in ticks::round(y.low, y.high) {
            let at = y.at(value);
            let _ = writeln!(
                svg,
                "<path class=\"grid\" d=\"M{LEFT} {at:.1}H{:.1}\"/><text class=\"tick\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                WIDTH - RIGHT,
                LEFT - 8.0,
                at + 5.0,
                ticks::short(value)
            );
        }
        let middle = (TOP + foot) / 2.0;
        let _ = writeln!(
            svg,
            "<text class=\"axis\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\
             <text class=\"axis\" transform=\"translate(20 {middle:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            (LEFT + WIDTH - RIGHT) / 2.0,
            HEIGHT - 14.0,
            escaped(self.error),
            escaped(self.figure)
        );
    }

    fn front(&self, svg: &mut String, points: &[Point], front: &[bool], x: &Scale, y: &Scale) {
        let corners = corners(points, front, x, y, self.bound);
        let line: Vec<_> = corners
            .iter()
            .map(|[x, y]| format!("{x:.1} {y:.1}"))
            .collect();
        if !line.is_empty() {
            let _ = writeln!(svg, "<path class=\"front\" d=\"M{}\"/>", line.join("L"));
        }
    }

    fn point(&self, svg: &mut String, point: &Point, on_front: bool, [x, y]: [f64; 2]) {
        let kind = match point.kind {
            Kind::Format => "format",
            Kind::Machine => "machine",
        };
        let mut class = format!("point {kind}");
        if on_front {
            class += " best";
        }
        if !point.holds {
            class += " above";
        }
        let repeats = point.figure_range.map_or_else(String::new, |range| {
            format!(" (repeats {})", spelled(range))
        });
        let says = format!(
            "{}: {} {}{}, {} {} (95 % interval {}){}",
            point.label,
            self.figure,
            significant(point.figure, 3),
            repeats,
            self.error,
            significant(point.error, 3),
            spelled(point.interval),
            if point.holds { "" } else { ", above the bound" }
        );
        let mark = match point.kind {
            Kind::Format => format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"6\"/>"),
            Kind::Machine => {
                format!(
                    "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"11\" height=\"11\"/>",
                    x - 5.5,
                    y - 5.5
                )
            }
        };
        let _ = writeln!(
            svg,
            "<g class=\"{class}\" tabindex=\"0\" role=\"img\" aria-label=\"{}\">{mark}</g>",
            escaped(&says)
        );
    }

    /// The text in place of the picture.
    fn description(&self, points: &[Point], front: &[bool]) -> String {
        let best = points.iter().zip(front).filter(|(_, on)| **on);
        let best: Vec<_> = best.map(|(point, _)| point.label.as_str()).collect();
        let beyond = points.iter().filter(|point| !point.holds).count();
        format!(
            "{} against {}, {} marks, of which {beyond} are above the bound of {}. Best within it: {}.",
            self.figure,
            self.error,
            points.len(),
            significant(self.bound, 2),
            match best.is_empty() {
                true => "none".to_owned(),
                false => best.join(", "),
            }
        )
    }
}

/// The corners of the line through the points of the front, up to the bound. It is a staircase: between two points,
/// the figure of the one with the smaller error is reached.
fn corners(points: &[Point], front: &[bool], x: &Scale, y: &Scale, bound: f64) -> Vec<[f64; 2]> {
    let mut best: Vec<_> = points
        .iter()
        .zip(front)
        .filter(|(_, on)| **on)
        .map(|(point, _)| [x.at(point.error), y.at(point.figure)])
        .collect();
    best.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for point in best {
        if let Some(&[_, before]) = corners.last() {
            corners.push([point[0], before]);
        }
        corners.push(point);
    }
    if let Some(&[_, last]) = corners.last() {
        corners.push([x.at(bound), last]);
    }
    corners
}

/// The names of the points of the front, each near its point and where no mark, line or other name is. A name that is
/// farther from its point has a line to it.
fn labels(svg: &mut String, points: &[Point], front: &[bool], x: &Scale, y: &Scale, bound: f64) {
    // A place within the chart fits the type.
    let pixel = |[x, y]: [f64; 2]| (x as i32, y as i32);
    let at = |point: &Point| pixel([x.at(point.error), y.at(point.figure)]);
    let places: Vec<_> = points.iter().map(at).collect();
    let within = [[LEFT, TOP], [WIDTH - RIGHT, HEIGHT - BOTTOM]].map(pixel);
    let mut labels = Labels::around(&places, within.into());
    let wall = x.at(bound);
    labels.avoid(pixel([wall, TOP]), pixel([wall, HEIGHT - BOTTOM]));
    for ends in corners(points, front, x, y, bound).windows(2) {
        labels.avoid(pixel(ends[0]), pixel(ends[1]));
    }
    let named = points.iter().zip(front).filter(|(_, on)| **on);
    let mut named: Vec<_> = named.map(|(point, _)| point).collect();
    // Machines first, since formats stand close together.
    named.sort_by_key(|point| point.kind == Kind::Format);
    for ((x, y), label) in by_place(
        named
            .into_iter()
            .map(|point| (at(point), point.label.as_str())),
    ) {
        let Some(place) = labels.place((x, y), &label) else {
            continue;
        };
        if let Some((to_x, to_y)) = leader((x, y), place) {
            let _ = writeln!(svg, "<path class=\"leader\" d=\"M{x} {y}L{to_x} {to_y}\"/>");
        }
        let ((left, _), (_, bottom)) = place;
        let _ = writeln!(
            svg,
            "<text class=\"name\" x=\"{left}\" y=\"{}\">{}</text>",
            bottom - 3,
            escaped(&label)
        );
    }
}

/// One name for each place: where several points lie, that of the first and how many more there are.
fn by_place<'a>(named: impl Iterator<Item = ((i32, i32), &'a str)>) -> Vec<((i32, i32), String)> {
    let mut places: Vec<((i32, i32), &str, usize)> = Vec::new();
    for (place, label) in named {
        match places.iter_mut().find(|(other, ..)| *other == place) {
            Some((.., more)) => *more += 1,
            None => places.push((place, label, 0)),
        }
    }
    let named = |(place, label, more)| match more {
        0 => (place, str::to_owned(label)),
        more => (place, format!("{label} and {more} more")),
    };
    places.into_iter().map(named).collect()
}

/// The intervals of the errors of the front, because those of all points would hide the points; and of each point that was
/// measured repeatedly on this computer the slowest and the fastest repeat.
fn whiskers(svg: &mut String, points: &[Point], front: &[bool], x: &Scale, y: &Scale) {
    for (point, on_front) in points.iter().zip(front) {
        let [across, up] = [x.at(point.error), y.at(point.figure)];
        if *on_front {
            let [low, high] = point.interval.map(|error| x.at(error.max(x.low)));
            let _ = writeln!(
                svg,
                "<path class=\"whisker\" d=\"M{low:.1} {up:.1}H{high:.1}\"/>"
            );
        }
        if let Some(range) = point.figure_range {
            let [low, high] = range.map(|figure| y.at(figure));
            let _ = writeln!(
                svg,
                "<path class=\"whisker\" d=\"M{across:.1} {low:.1}V{high:.1}\"/>"
            );
        }
    }
}

/// "0.18 to 0.22".
fn spelled([low, high]: [f64; 2]) -> String {
    format!("{} to {}", significant(low, 3), significant(high, 3))
}

/// A logarithmic axis has no place for other figures.
fn is_positive(point: &Point) -> bool {
    point.error > 0.0 && point.figure > 0.0
}

/// A text in SVG or in an attribute.
pub(super) fn escaped(text: &str) -> String {
    html! { (text) }.into_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_at_one_place_have_one_name() {
        let named = [((1, 2), "a"), ((3, 4), "b"), ((1, 2), "c"), ((1, 2), "d")];
        let expected = [
            ((1, 2), "a and 2 more".to_owned()),
            ((3, 4), "b".to_owned()),
        ];
        assert_eq!(by_place(named.into_iter()), expected);
    }

    fn point(label: &str, error: f64, figure: f64) -> Point {
        Point {
            label: label.to_owned(),
            kind: Kind::Machine,
            error,
            interval: [error * 0.9, error * 1.1],
            figure,
            figure_range: None,
            holds: error <= 0.1,
        }
    }

    fn chart(points: &[Point]) -> String {
        let chart = Chart {
            figure: "speed",
            error: "error",
            better: Better::Larger,
            bound: 0.1,
            noise: 1.0,
            points,
        };
        chart.markup().into_string()
    }

    #[test]
    fn names_of_near_points_do_not_collide_and_all_points_are_in_the_table() {
        let near = |i: i32| {
            let more = 1.02_f64.powi(i);
            point(&format!("machine-{i}"), 0.01 * more, 10.0 * more)
        };
        // A point far away makes the others near.
        let points: Vec<_> = (0..12)
            .map(near)
            .chain([point("far", 1e-5, 1e-3)])
            .collect();
        let text = chart(&points);
        assert_eq!(text.matches("<text class=\"name\"").count(), 13);
        assert!(text.contains("class=\"leader\""));
        assert_eq!(text.matches("<th scope=\"row\">machine-").count(), 12);
        assert_eq!(text.matches("class=\"point machine best\"").count(), 13);
    }

    #[test]
    fn a_point_above_the_bound_is_greyed_and_named_as_such() {
        let text = chart(&[point("good", 0.05, 1.0), point("bad", 0.2, 5.0)]);
        assert!(
            text.contains("of which 1 are above the bound of 0.10. Best within it: good."),
            "{text}"
        );
        assert!(text.contains("point machine above"));
        assert!(text.contains(
            "bad: speed 5.00, error 0.200 (95 % interval 0.180 to 0.220), above the bound"
        ));
    }

    #[test]
    fn repeats_are_drawn_and_told() {
        let measured = Point {
            figure_range: Some([4.0, 8.0]),
            ..point("format", 0.05, 5.0)
        };
        let text = chart(&[measured, point("machine", 0.2, 1.0)]);
        assert!(text.contains("format: speed 5.00 (repeats 4.00 to 8.00), error 0.0500"));
        // The interval of the error of the one on the front, and the repeats of the one that has any.
        assert_eq!(text.matches("<path class=\"whisker\"").count(), 2);
        assert!(text.contains("4.00 to 8.00</td>"), "{text}");
        let unmeasured = chart(&[point("machine", 0.05, 1.0)]);
        assert_eq!(unmeasured.matches("<path class=\"whisker\"").count(), 1);
        assert!(!unmeasured.contains("repeats "));
    }

    #[test]
    fn figures_of_zero_have_no_place_and_names_are_escaped() {
        assert!(chart(&[point("zero", 0.0, 1.0)]).contains("No figure of speed"));
        assert!(chart(&[point("<b>", 0.05, 1.0)]).contains("&lt;b&gt;: speed"));
    }
}
