//! The method `--lint`: runs the lint on planted mistakes. It must find each, and report nothing for the
//! corrected code.

use anyhow::Result;
use photoncube_hdl::{Planted, Rule, lint_planted};
use serde::Serialize;

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, record};
use crate::{output, table};

/// The results for the mistakes of one rule.
#[derive(Debug, Default, PartialEq, Eq, Serialize)]
struct OfRule {
    rule: &'static str,
    planted: usize,
    missed: Vec<&'static str>,
    false_alarms: Vec<&'static str>,
}

#[derive(Serialize)]
struct Report {
    rules: Vec<OfRule>,
    planted: usize,
    #[serde(skip)]
    missed: usize,
    #[serde(skip)]
    false_alarms: usize,
}

impl Report {
    fn of(planted: &[Planted]) -> Self {
        let rules: Vec<_> = Rule::ALL
            .iter()
            .map(|&rule| of_rule(rule, planted))
            .collect();
        let sum = |count: fn(&OfRule) -> usize| rules.iter().map(count).sum();
        Self {
            planted: sum(|of| of.planted),
            missed: sum(|of| of.missed.len()),
            false_alarms: sum(|of| of.false_alarms.len()),
            rules,
        }
    }
}

fn of_rule(rule: Rule, planted: &[Planted]) -> OfRule {
    let mut of = OfRule {
        rule: rule.name(),
        ..OfRule::default()
    };
    for planted in planted.iter().filter(|planted| planted.rule == rule) {
        of.planted += 1;
        if !planted.is_found() {
            of.missed.push(planted.name);
        }
        if !planted.false_alarms.is_empty() {
            of.false_alarms.push(planted.name);
        }
    }
    of
}

/// Runs the lint on every planted mistake and its correction.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let planted: Vec<_> = lint_planted().collect();
    let report = Report::of(&planted);
    output::print(json, &report, || text(&report))?;
    verdict(&report)?;
    match &args.record {
        Some(path) => record(path, &[line(&report)]),
        None => Ok(()),
    }
}

/// Fails where a rule has no planted mistake, because it is then untested.
fn verdict(report: &Report) -> Result<()> {
    let wrong =
        |of: &&OfRule| of.planted == 0 || !of.missed.is_empty() || !of.false_alarms.is_empty();
    let wrong: Vec<_> = report.rules.iter().filter(wrong).collect();
    if wrong.is_empty() {
        return Ok(());
    }
    Err(CheckFailed(format!("the lint is wrong: {wrong:?}")).into())
}

fn line(report: &Report) -> Line {
    Line {
        method: "planted mistakes".to_owned(),
        by: format!("photoncube {}", env!("CARGO_PKG_VERSION")),
        volume: report.planted as u64,
        unit: "mistakes, each with its cure".to_owned(),
        result: format!(
            "{} missed, {} false alarms",
            report.missed, report.false_alarms
        ),
        command: "photoncube verify --lint".to_owned(),
        ..Line::of_no_verilog("lint".to_owned())
    }
}

fn text(report: &Report) -> String {
    let header = ["rule", "planted", "missed", "false alarms at cures"];
    let row = |of: &OfRule| {
        let numbers = [of.planted, of.missed.len(), of.false_alarms.len()];
        let mut row = vec![of.rule.to_owned()];
        row.extend(numbers.map(|number| number.to_string()));
        row
    };
    let rows: Vec<_> = report.rules.iter().map(row).collect();
    table::markdown(&header, &rows)
        + &format!(
            "{} planted, {} missed, {} false alarms\n",
            report.planted, report.missed, report.false_alarms
        )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missed_or_alarmed_at_fails_and_is_named() {
        let planted: Vec<_> = lint_planted().collect();
        assert!(verdict(&Report::of(&planted)).is_ok());
        let mut missed = planted.clone();
        missed[0].found.clear();
        let error = verdict(&Report::of(&missed)).unwrap_err().to_string();
        assert!(error.contains(missed[0].name), "{error}");
        let mut alarmed = planted.clone();
        alarmed[0].false_alarms = planted[1].found.clone();
        assert!(verdict(&Report::of(&alarmed)).is_err());
        assert!(verdict(&Report::of(&[])).is_err());
    }
}
