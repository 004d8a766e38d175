//! The command `hard-cases`: the inputs at which some arithmetic is known to fail, in every format.

use anyhow::Result;
use photoncube_hard_cases::{HARD_CASES, HardCaseReport, hard_case_formats, run_hard_case};
use photoncube_spec::{PhotonFormat, find_photon_format};
use serde::Serialize;

use crate::args::HardCasesArgs;
use crate::failure::CheckFailed;
use crate::table::{self, counted};
use crate::{output, progress};

#[derive(Serialize)]
struct Report {
    formats: Vec<String>,
    cases: Vec<HardCaseReport>,
    /// The names of rows that do not hold.
    failed: Vec<&'static str>,
}

/// Runs every case and prints the table.
pub fn execute(args: &HardCasesArgs, json: bool) -> Result<()> {
    let formats = match &args.format {
        Some(name) => vec![find_photon_format(name)?],
        None => hard_case_formats(),
    };
    // In a single format some cases are not hard: with 16 bits none can exceed 32 bits.
    let must_be_hard = args.format.is_none();
    let cases = run(&formats);
    let failed: Vec<_> = cases
        .iter()
        .filter(|case| fails(case, must_be_hard))
        .collect();
    let message: Vec<_> = failed.iter().map(|case| why_failed(case)).collect();
    let report = Report {
        formats: formats.iter().map(PhotonFormat::name).collect(),
        failed: failed.iter().map(|case| case.case).collect(),
        cases,
    };
    output::print_tables(json, args.wide, &report, || text(&report))?;
    match message.is_empty() {
        true => Ok(()),
        false => Err(CheckFailed(message.join("\n")).into()),
    }
}

fn run(formats: &[PhotonFormat]) -> Vec<HardCaseReport> {
    let bar = progress::bar("hard cases", HARD_CASES.len() as u64);
    let rows = HARD_CASES.iter().filter_map(|case| {
        let row = run_hard_case(case, formats);
        bar.inc(1);
        row
    });
    let rows = rows.collect();
    bar.finish_and_clear();
    rows
}

fn fails(case: &HardCaseReport, must_be_hard: bool) -> bool {
    !case.holds || (must_be_hard && !case.is_hard)
}

fn why_failed(case: &HardCaseReport) -> String {
    let found = match &case.refusal {
        Some(refusal) => refusal.clone(),
        None if case.holds => format!(
            "it is not hard: found {} {}, expected at least {}",
            number(case.contrast),
            case.contrast_of,
            case.contrast_at_least
        ),
        None => format!(
            "found {} {} in {}, expected {}",
            number(case.result),
            case.measures,
            case.worst_format,
            case.bound
        ),
    };
    format!("hard case `{}`: {found}", case.case)
}

fn text(report: &Report) -> String {
    let header = [
        "case",
        "result",
        "bound",
        "what could break",
        "why that bound",
        "contrast",
    ];
    let rows: Vec<_> = report.cases.iter().map(row).collect();
    let looked_at: u64 = report.cases.iter().map(|case| case.looked_at).sum();
    table::markdown(&header, &rows)
        + &format!(
            "\n{} cases in {}, {looked_at} decisions, photons and sums looked at, {} failed\n",
            report.cases.len(),
            counted(report.formats.len() as u64, "format"),
            report.failed.len()
        )
}

fn row(case: &HardCaseReport) -> Vec<String> {
    let result = match &case.refusal {
        Some(refusal) => format!("none: {refusal}"),
        None => format!(
            "{} {}; {} looked at{}",
            number(case.result),
            case.measures,
            case.looked_at,
            worst(case)
        ),
    };
    let hard = match case.is_hard {
        true => "",
        false => " (not hard here)",
    };
    vec![
        case.case.to_owned(),
        result,
        case.bound.clone(),
        case.breaks.to_owned(),
        case.why.to_owned(),
        format!("{} {}{hard}", number(case.contrast), case.contrast_of),
    ]
}

/// The worst format, where there is one.
fn worst(case: &HardCaseReport) -> String {
    match case.result == 0.0 {
        true => String::new(),
        false => format!(", worst {}", case.worst_format),
    }
}

/// A number with three digits, as many as a reader compares.
fn number(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-3 {
        return format!("{value:.1e}");
    }
    match value.abs() {
        size if size >= 100.0 || value.fract() == 0.0 => format!("{value:.0}"),
        size if size >= 10.0 => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_tell_them_apart() {
        for (value, expected) in [
            (0.0, "0"),
            (1.0, "1"),
            (2.2e-14, "2.2e-14"),
            (0.4469, "0.45"),
            (52.77, "52.8"),
            (408.004, "408"),
        ] {
            assert_eq!(number(value), expected);
        }
    }

    #[test]
    fn a_row_that_does_not_hold_is_named_with_what_was_found() {
        let formats = hard_case_formats();
        let mut row = run_hard_case(&HARD_CASES[0], &formats[..1]).unwrap();
        assert!(!fails(&row, true));
        row.is_hard = false;
        assert!(fails(&row, true) && !fails(&row, false));
        assert!(why_failed(&row).contains("`boundary-ties-f32`: it is not hard"));
        (row.holds, row.result) = (false, 3.0);
        let message = why_failed(&row);
        assert!(fails(&row, false));
        assert!(
            message.contains("found 3 photons decided wrong in local8-rgb8e5, expected = 0"),
            "{message}"
        );
        row.refusal = Some("local8-rgb8e5: looked at nothing".to_owned());
        assert!(why_failed(&row).contains("looked at nothing"));
    }
}
