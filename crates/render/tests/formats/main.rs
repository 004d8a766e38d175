//! Photon formats on maps: what no move, scale or order may change, the hard cases, and the
//! error against the f64 reference.

mod error;
mod hard_cases;
mod invariance;
mod room;
