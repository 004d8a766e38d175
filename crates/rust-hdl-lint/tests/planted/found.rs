//! Tests of the lint on all planted mistakes.

use std::collections::BTreeSet;

use super::{cases, lint_planted};
use rust_hdl_lint::Rule;

#[test]
fn every_planted_mistake_is_found_for_its_own_reason() {
    for planted in lint_planted() {
        assert!(planted.is_found(), "{}: {planted:#?}", planted.name);
    }
}

#[test]
fn every_cure_is_clean() {
    for planted in lint_planted() {
        assert!(
            planted.false_alarms.is_empty(),
            "{}: {planted:#?}",
            planted.name
        );
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
