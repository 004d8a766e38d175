//! Planted mistakes: one for each form in which rust-hdl's simulation and its Verilog differ, each beside its
//! corrected code. The lint must report each mistake under its own rule, and must report nothing for the
//! corrected code.

// The kernels are written for the Verilog that they print and not for readable Rust, and nothing calls their
// blocks.
#![allow(
    clippy::bool_comparison,
    clippy::collapsible_if,
    clippy::collapsible_match,
    clippy::match_like_matches_macro,
    clippy::needless_range_loop,
    clippy::nonminimal_bool,
    clippy::precedence,
    clippy::single_match
)]

mod blocks;
mod clean;
mod comparisons;
mod expressions;
mod found;
mod report;
mod selections;
mod structure;

use rust_hdl_lint::{Finding, Rule};

use blocks::Case;

/// A planted mistake and its correction, with the lint's findings.
#[derive(Debug)]
struct Planted {
    /// The name of the mistake.
    name: &'static str,
    /// The rule that the mistake breaks.
    rule: Rule,
    /// The findings for the mistake. A correct lint reports its rule and no other.
    found: Vec<Finding>,
    /// The findings for the correction. A correct lint reports none.
    false_alarms: Vec<Finding>,
}

impl Planted {
    /// Whether the lint finds the mistake under its own rule, and reports nothing else.
    fn is_found(&self) -> bool {
        !self.found.is_empty() && self.found.iter().all(|finding| finding.rule == self.rule)
    }
}

fn cases() -> impl Iterator<Item = &'static Case> {
    [
        expressions::CASES,
        comparisons::CASES,
        selections::CASES,
        structure::CASES,
    ]
    .into_iter()
    .flatten()
}

/// Runs the lint on every planted mistake and its correction.
fn lint_planted() -> impl Iterator<Item = Planted> {
    cases().map(|case| Planted {
        name: case.name,
        rule: case.rule,
        found: (case.bad)(),
        false_alarms: (case.good)(),
    })
}
