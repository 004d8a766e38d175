//! Draws charts with two logarithmic axes, and the frame around charts.

use std::error::Error;

use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::coord::combinators::{BindKeyPoints, LogCoord, WithKeyPoints};
use plotters::prelude::*;

use super::legend::{self, Item};

/// A rectangular part of the picture.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A chart in such a part.
pub type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<Scale, Scale>>;
type Scale = WithKeyPoints<LogCoord<f64>>;
/// The result of drawing.
pub type Drawn<T = ()> = Result<T, Box<dyn Error>>;

/// The height of title and legend in pixels.
const HEADER: i32 = 74;
const TITLE: (&str, i32) = ("sans-serif", 22);
const TEXT: (&str, i32) = ("sans-serif", 16);

/// An axis of a chart.
pub struct Axis<'a> {
    /// The quantity of the axis, with its unit.
    pub name: &'a str,
    /// The lower end of the axis, over 0.
    pub low: f64,
    /// The upper end of the axis.
    pub high: f64,
    /// The numbers that have a label.
    pub ticks: Vec<f64>,
    /// The format of the labels.
    pub text: fn(f64) -> String,
}

/// The parts of a picture around its charts.
pub struct Frame<'a> {
    /// The picture's width and height (pixels).
    pub size: (u32, u32),
    /// A sentence above the charts, which screen readers read too.
    pub title: &'a str,
    /// A description of the picture for screen readers.
    pub description: &'a str,
    /// The legend: the meaning of each mark.
    pub legend: &'a [Item],
}

/// The picture that `draw` makes, with title, legend and description.
pub fn framed(frame: &Frame<'_>, draw: impl FnOnce(&Area<'_>) -> Drawn) -> Result<String> {
    let mut svg = String::new();
    let attempt = || -> Drawn {
        let area = SVGBackend::with_string(&mut svg, frame.size).into_drawing_area();
        area.fill(&WHITE)?;
        let title = TITLE.into_font().color(&super::palette::INK);
        area.draw(&Text::new(frame.title, (16, 14), title))?;
        legend::draw(&area, (16, 48), frame.legend)?;
        let (_, charts) = area.split_vertically(HEADER);
        draw(&charts)?;
        area.present()?;
        Ok(())
    };
    attempt().map_err(|error| anyhow!("the plot cannot be drawn: {error}"))?;
    Ok(with_words(&svg, frame))
}

/// Adds title and description to the SVG as the root's first children, where screen readers find them.
fn with_words(svg: &str, frame: &Frame<'_>) -> String {
    let root = svg.find("<svg").unwrap_or(0);
    let end = svg[root..].find('>').map_or(svg.len(), |end| root + end);
    let (title, description) = (escaped(frame.title), escaped(frame.description));
    let (head, rest) = svg.split_at(end);
    let rest = rest.strip_prefix('>').unwrap_or(rest);
    format!("{head} role=\"img\">\n<title>{title}</title>\n<desc>{description}</desc>{rest}")
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;")
}

/// An empty chart.
pub fn chart<'a>(area: &Area<'a>, x: &Axis<'_>, y: &Axis<'_>) -> Drawn<Chart<'a>> {
    let scale = |axis: &Axis<'_>| {
        let range = (axis.low..axis.high).log_scale();
        range.with_key_points(axis.ticks.clone())
    };
    let mut chart = ChartBuilder::on(area)
        .margin(14)
        .x_label_area_size(52)
        .y_label_area_size(84)
        .build_cartesian_2d(scale(x), scale(y))?;
    chart
        .configure_mesh()
        .x_desc(x.name)
        .y_desc(y.name)
        .axis_desc_style(TEXT)
        .label_style(TEXT)
        .x_label_formatter(&|number| (x.text)(*number))
        .y_label_formatter(&|number| (y.text)(*number))
        .light_line_style(WHITE)
        .draw()?;
    Ok(chart)
}

/// A range from slightly below the smallest to slightly above the largest value over 0; an arbitrary range
/// where there is none.
pub fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| *value > 0.0 && value.is_finite())
        .fold((f64::INFINITY, 0.0_f64), |(low, high), value| {
            (low.min(value), high.max(value))
        });
    match high > 0.0 {
        true => (0.8 * low, 1.25 * high),
        false => (0.1, 1.0),
    }
}
