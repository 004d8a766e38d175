//! Performance: the measured speed of an engine on this computer, and the forecast clocks of a machine.

mod forecast;
mod speed;

pub use forecast::forecast_clocks;
pub use speed::{Speed, f32_speed, gather_speed};
