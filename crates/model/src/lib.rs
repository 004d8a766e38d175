//! The golden model: plain integers, step-exact, and the direct gather.
