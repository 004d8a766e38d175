//! Stimulus, runners and comparison: HDL against golden model.
