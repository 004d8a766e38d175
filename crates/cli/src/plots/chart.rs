//! A chart with two logarithmic axes, and the frame around charts.

use std::error::Error;

use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::coord::combinators::{BindKeyPoints, LogCoord, WithKeyPoints};
use plotters::prelude::*;

use super::legend::{self, Item};

/// A part of the picture.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A chart in it.
pub type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<Scale, Scale>>;
type Scale = WithKeyPoints<LogCoord<f64>>;
/// What drawing may end in.
pub type Drawn<T = ()> = Result<T, Box<dyn Error>>;

/// Height of title and legend (pixels).
const HEADER: i32 = 74;
const TITLE: (&str, i32) = ("sans-serif", 22);
const TEXT: (&str, i32) = ("sans-serif", 16);

/// One axis.
pub struct Axis<'a> {
    /// What it shows, with the unit.
    pub name: &'a str,
    /// From, over 0.
    pub low: f64,
    /// To.
    pub high: f64,
    /// Numbers that are named.
    pub ticks: Vec<f64>,
    /// How they are written.
    pub text: fn(f64) -> String,
}

/// What is around the charts.
pub struct Frame<'a> {
    /// The picture's width and height (pixels).
    pub size: (u32, u32),
    /// A sentence above, and for those who hear the picture.
    pub title: &'a str,
    /// What is seen, for them.
    pub description: &'a str,
    /// What each mark means.
    pub legend: &'a [Item],
}

/// The picture of `draw`, with its title, legend and words.
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

/// The SVG with a title and a description, as a screen reader wants them: the root's first children.
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

/// A little below the smallest and a little above the largest of what is over 0; anything where there is nothing.
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
