//! Pictures of figures, SVG: each says in words what it shows, and keeps its lines apart for eyes that tell red from
//! green badly.

mod against_error;
mod chart;
mod convergence;
mod labels;
mod legend;
mod palette;
mod panels;
mod ticks;

pub use self::against_error::{Better, Kind, Plot, Point, against_error, pareto_front};
pub use self::convergence::{Curve, Reached, convergence_plot};
pub use self::panels::{Panel, Place, panels};
