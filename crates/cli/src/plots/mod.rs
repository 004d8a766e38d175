//! SVG plots. Each has a description in words, and its colours are distinguishable with red-green colour
//! blindness.

mod against_error;
mod chart;
mod convergence;
pub mod labels;
mod legend;
pub mod palette;
mod panels;
pub mod ticks;

pub use self::against_error::{Better, Kind, Plot, Point, against_error, pareto_front};
pub use self::convergence::{Curve, Reached, convergence_plot};
pub use self::panels::{Panel, Place, panels};
