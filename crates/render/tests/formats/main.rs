//! Tests of photon formats on maps: the hard cases, and the error against the f64 reference.

mod error;
mod hard_cases;
