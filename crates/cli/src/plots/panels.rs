//! Plots quantities of different units against one number, with a chart for each.

use anyhow::Result;
use plotters::prelude::*;

use super::chart::{Area, Axis, Drawn, Frame, chart, framed, range};
use super::legend::{Item, Mark};
use super::palette::{FIRST, SECOND};
use super::ticks;

/// A chart of one quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The name of the quantity, with its unit.
    pub name: &'static str,
    /// The points at which it is known.
    pub places: Vec<Place>,
}

/// The value of a quantity at a dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The dimension of the hypercube.
    pub dimension: u32,
    /// The value, over 0.
    pub value: f64,
    /// Whether the point is joined with the others by a line; otherwise it is a cross.
    pub on_line: bool,
}

const SIZE: (u32, u32) = (1300, 560);

const LEGEND: [Item; 2] = [
    Item {
        mark: Mark::Line,
        colour: SECOND,
        means: "tiles: one axis more, twice the queries",
    },
    Item {
        mark: Mark::Cross,
        colour: FIRST,
        means: "machines with a photon memory",
    },
];

/// An SVG picture with a chart for each quantity and the dimension, in whole numbers, on the x axis.
pub fn panels(title: &str, panels: &[Panel]) -> Result<String> {
    let names: Vec<_> = panels.iter().map(|panel| panel.name).collect();
    let frame = Frame {
        size: SIZE,
        title,
        description: &format!(
            "Charts against the dimension of the hypercube: {}.",
            names.join("; ")
        ),
        legend: &LEGEND,
    };
    framed(&frame, |area| {
        let areas = area.split_evenly((1, panels.len().max(1)));
        let mut panels = areas.iter().zip(panels);
        panels.try_for_each(|(area, panel)| draw(area, panel))
    })
}

/// The number of cells. The x axis is logarithmic in it, so it is linear in the dimension.
fn cells(dimension: u32) -> f64 {
    f64::from(dimension).exp2()
}

fn draw(area: &Area<'_>, panel: &Panel) -> Drawn {
    let dimensions = || panel.places.iter().map(|place| place.dimension);
    let (first, last) = (
        dimensions().min().unwrap_or(1),
        dimensions().max().unwrap_or(2),
    );
    let x = Axis {
        name: "dimension of the hypercube",
        low: 0.7 * cells(first),
        high: 1.4 * cells(last),
        ticks: (first..=last).map(cells).collect(),
        text: |cells| format!("{:.0}", cells.log2()),
    };
    let (low, high) = range(panel.places.iter().map(|place| place.value));
    let y = Axis {
        name: panel.name,
        low,
        high,
        ticks: ticks::round(low, high),
        text: ticks::short,
    };
    let mut chart = chart(area, &x, &y)?;
    let places = |on_line| {
        let places = panel.places.iter().filter(move |p| p.on_line == on_line);
        places.map(|place| (cells(place.dimension), place.value))
    };
    chart.draw_series(LineSeries::new(places(true), SECOND.stroke_width(2)).point_size(4))?;
    chart.draw_series(places(false).map(|place| Cross::new(place, 6, FIRST.stroke_width(2))))?;
    Ok(())
}
