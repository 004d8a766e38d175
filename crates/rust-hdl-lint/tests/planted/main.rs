//! Planted mistakes: one for each form in which rust-hdl simulates one thing and prints another, beside the code
//! that replaces it. The lint must find each for its own reason, and say nothing of what replaces it.

// The kernels say what is to be printed as Verilog, not what reads best in Rust; and nobody calls their blocks.
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
mod expressions;
mod found;
mod report;
mod selections;
mod structure;

use rust_hdl_lint::{Finding, Rule};

use blocks::Case;

/// A planted mistake and its cure, as the lint sees them.
#[derive(Debug)]
struct Planted {
    /// The mistake's name.
    name: &'static str,
    /// The rule that it breaks.
    rule: Rule,
    /// What the lint says of the mistake: of its rule and no other, if the lint is right.
    found: Vec<Finding>,
    /// What it says of the cure: nothing, if the lint is right.
    false_alarms: Vec<Finding>,
}

impl Planted {
    /// Whether the lint finds the mistake for its own reason, and nothing besides.
    fn is_found(&self) -> bool {
        !self.found.is_empty() && self.found.iter().all(|finding| finding.rule == self.rule)
    }
}

fn cases() -> impl Iterator<Item = &'static Case> {
    [expressions::CASES, selections::CASES, structure::CASES]
        .into_iter()
        .flatten()
}

/// What the lint says of every planted mistake and its cure.
fn lint_planted() -> impl Iterator<Item = Planted> {
    cases().map(|case| Planted {
        name: case.name,
        rule: case.rule,
        found: (case.bad)(),
        false_alarms: (case.good)(),
    })
}
