//! The lint against planted mistakes, one for each form that is known to differ, and against
//! the code that replaces it.

// The kernels say what is to be printed as Verilog, not what reads best in Rust.
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
mod report;
mod selections;
mod structure;

use std::collections::BTreeSet;

use blocks::Case;
use photoncube_hdl::{Finding, Rule};

fn cases() -> impl Iterator<Item = &'static Case> {
    [expressions::CASES, selections::CASES, structure::CASES]
        .into_iter()
        .flatten()
}

fn rules(findings: &[Finding]) -> BTreeSet<Rule> {
    findings.iter().map(|finding| finding.rule).collect()
}

#[test]
fn every_planted_mistake_is_found_for_its_own_reason() {
    for case in cases() {
        let found = (case.bad)();
        assert_eq!(
            rules(&found),
            BTreeSet::from([case.rule]),
            "{}: {found:#?}",
            case.name
        );
    }
}

#[test]
fn every_cure_is_clean() {
    for case in cases() {
        let found = (case.good)();
        assert!(found.is_empty(), "{}: {found:#?}", case.name);
    }
}

#[test]
fn every_rule_has_a_planted_mistake() {
    let planted: BTreeSet<Rule> = cases().map(|case| case.rule).collect();
    assert_eq!(planted, Rule::ALL.iter().copied().collect());
}

#[test]
fn every_case_has_a_name_of_its_own() {
    let names: BTreeSet<&str> = cases().map(|case| case.name).collect();
    assert_eq!(names.len(), cases().count());
    assert!(names.len() > 60, "{} cases", names.len());
}
