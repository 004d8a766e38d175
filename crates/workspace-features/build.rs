//! Lets the manifest have build-dependencies, whose features are those of procedural macros.

fn main() {}
