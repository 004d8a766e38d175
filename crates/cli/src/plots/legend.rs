//! Draws the legend, a row above the picture.

use plotters::prelude::*;

use super::chart::{Area, Drawn};
use super::palette::INK;

/// The form of a mark.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A solid line.
    Line,
    /// A dashed line.
    Dashes,
    /// A filled disc.
    Disc,
    /// A filled square.
    Square,
    /// A diagonal cross.
    Cross,
}

/// A mark and its meaning.
#[derive(Copy, Clone, Debug)]
pub struct Item {
    /// The form of the mark.
    pub mark: Mark,
    /// The colour of the mark.
    pub colour: RGBColor,
    /// The meaning of the mark.
    pub means: &'static str,
}

/// Half of a mark's size in pixels.
const HALF: i32 = 5;
const LINE: i32 = 24;
/// The mean width of a character in pixels, rounded up.
const CHARACTER: i32 = 8;
/// The gap between two items in pixels.
const GAP: i32 = 26;

/// Draws the items to the right of this point, the middle of their left side.
pub fn draw(area: &Area<'_>, (left, y): (i32, i32), items: &[Item]) -> Drawn {
    let mut x = left;
    for item in items {
        draw_mark(area, (x, y), item)?;
        let style = ("sans-serif", 16).into_font().color(&INK);
        area.draw(&Text::new(item.means, (x + LINE + 8, y - 8), style))?;
        x += LINE + 8 + CHARACTER * item.means.len() as i32 + GAP;
    }
    Ok(())
}

fn draw_mark(area: &Area<'_>, (x, y): (i32, i32), item: &Item) -> Drawn {
    let (style, middle) = (item.colour.stroke_width(2), x + LINE / 2);
    match item.mark {
        Mark::Line => area.draw(&PathElement::new([(x, y), (x + LINE, y)], style))?,
        Mark::Dashes => {
            for start in [x, x + 9, x + 18] {
                area.draw(&PathElement::new([(start, y), (start + 6, y)], style))?;
            }
        }
        Mark::Disc => area.draw(&Circle::new((middle, y), HALF, item.colour.filled()))?,
        Mark::Square => {
            let corners = [(middle - HALF, y - HALF), (middle + HALF, y + HALF)];
            area.draw(&Rectangle::new(corners, item.colour.filled()))?;
        }
        Mark::Cross => area.draw(&Cross::new((middle, y), HALF, style))?,
    }
    Ok(())
}
