//! `svg` 0.11 in the place of 0.10, which a later Rust will refuse to compile (rust-lang/rust, issue 79813).
//!
//! rust-hdl 0.46, whose version is pinned, asks for 0.10 to draw waveforms, which nothing here calls. 0.11 has the cure
//! and what rust-hdl uses of 0.10. Cargo.toml puts this package in its place.

pub use svg_0_11::*;
