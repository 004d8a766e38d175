//! The report of `progressive` for people.

use super::{Report, Row};
use crate::sight;
use crate::table::markdown;

/// A column of the table.
struct Column {
    name: &'static str,
    needs_reference: bool,
    of: fn(&Row) -> String,
}

const COLUMNS: [Column; 9] = [
    column("passes", |row| row.passes.to_string()),
    column("photons", |row| row.photons.to_string()),
    column("radius", |row| format!("{:.5}", row.search_radius)),
    column("noise", |row| percent(row.estimated_noise)),
    column("bias", |row| percent(row.estimated_bias)),
    column("bound", |row| percent(row.error_bound)),
    column("relMSE", |row| {
        row.rel_mse.map_or("-".to_owned(), |e| format!("{e:.2e}"))
    })
    .against_reference(),
    column("in bounds", |row| percent(row.bounded_share)).against_reference(),
    column("seconds", |row| format!("{:.1}", row.seconds)),
];

const fn column(name: &'static str, of: fn(&Row) -> String) -> Column {
    Column {
        name,
        needs_reference: false,
        of,
    }
}

impl Column {
    const fn against_reference(self) -> Self {
        Self {
            needs_reference: true,
            ..self
        }
    }
}

fn percent(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |value| format!("{:.2} %", 100.0 * value))
}

/// The report for people.
pub(super) fn text(report: &Report) -> String {
    let has_reference = report.progress.iter().any(|row| row.rel_mse.is_some());
    let columns = COLUMNS.iter();
    let columns: Vec<_> = columns
        .filter(|column| has_reference || !column.needs_reference)
        .collect();
    let header: Vec<_> = columns.iter().map(|column| column.name).collect();
    let cells = |row: &Row| columns.iter().map(|column| (column.of)(row)).collect();
    let table = markdown(
        &header,
        &report.progress.iter().map(cells).collect::<Vec<_>>(),
    );
    let lost = sight::without_power(report.photons_without_power) + &report.balls;
    let pass = pass_line(report);
    let bound = bound_line(report);
    let mut text = format!("{table}{pass}{bound}{lost}\n{}\n", report.output);
    text.extend(report.files.iter().map(|file| format!("{file}\n")));
    text
}

/// A line that states what a pass is made of.
fn pass_line(report: &Report) -> String {
    let (photons, axis) = (report.photons_per_pass, report.samples_per_axis);
    let direct = report.light.direct();
    let radii = report.halvings_mean.map(|mean| {
        format!(
            "The radius is the largest: by the chi-square rule a pixel's squared radius is halved {mean:.1} times, on\n\
             average.\n"
        )
    });
    format!(
        "A pass: at least {photons} photons traced, {axis} x {axis} view rays a pixel, direct light by {direct}.\n{}",
        radii.unwrap_or_default()
    )
}

/// What is said where bias rules the bound.
const BIAS_RULES: &str = "\
    Bias rules: the error may be above the bound, and no --error-target is met. Light leaks by the radius\n\
    at many pixels, as at sharp shadows. A smaller --in-range lowers it; so do --direct rays and\n\
    --caustics own.\n";

/// Explains the columns of the error.
fn bound_line(report: &Report) -> String {
    let confidence = 100.0 * report.confidence;
    let Some(quantile) = report.quantile else {
        return "One pass tells nothing of its error.\n".to_owned();
    };
    format!(
        "noise, bias: root mean squares over the pixels, each as a part of the pixel's luminance less its\n\
         bias. The bound is sqrt(noise^2 + 2 bias^2): where light jumps within the radius, the passes show\n\
         only a part of the bias. The bound of one pixel's error holds with {confidence:.0} % confidence; there the\n\
         noise counts t = {quantile:.2} times, Student's factor for these passes.\n{}",
        match report.is_ruled_by_bias {
            true => BIAS_RULES,
            false => "",
        }
    )
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::args::{Args, Command, EngineReport, LightingReport};

    fn report(rel_mse: Option<f64>) -> Report {
        let row = Row {
            passes: 2,
            photons: 10,
            search_radius: 0.1,
            error_bound: Some(0.2),
            estimated_bias: Some(0.05),
            estimated_noise: Some(0.05),
            rel_mse,
            bounded_share: rel_mse,
            seconds: 1.0,
        };
        let args = ["photoncube", "progressive", "cornell", "-o", "o.png"];
        let Command::Progressive(args) = Args::parse_from(args).command else {
            unreachable!("that is the command");
        };
        let light =
            LightingReport::of(&args.light.lighting(&photoncube_render::Lighting::default()));
        Report {
            scene: "cornell".to_owned(),
            engine: EngineReport::of(args.engine.find().unwrap().engine()),
            core: None,
            light,
            output: "o.png".to_owned(),
            seed: 1,
            photons_per_pass: 5000,
            samples_per_axis: 2,
            alpha: 0.5,
            radius_rule: "schedule".to_owned(),
            halvings_mean: None,
            confidence: 0.9,
            error_target: None,
            query_points: 1,
            photon_tests: 1,
            photons_without_power: 0,
            files: vec!["plot.svg".to_owned()],
            state: None,
            resumed_passes: 0,
            interrupted: false,
            progress: vec![row],
            quantile: Some(6.31),
            is_ruled_by_bias: false,
            balls: String::new(),
        }
    }

    #[test]
    fn columns_of_a_reference_are_there_with_one_and_the_bound_is_explained() {
        let without = text(&report(None));
        assert!(
            !without.contains("relMSE") && !without.contains("in bounds"),
            "{without}"
        );
        assert!(without.lines().all(|line| line.len() <= 100), "{without}");
        assert!(
            without.contains("t = 6.31 times")
                && without.contains("sqrt(noise^2 + 2 bias^2)")
                && without.contains("90 % confidence")
                && without.contains("at least 5000 photons traced, 2 x 2 view rays"),
            "{without}"
        );
        assert!(!without.contains(BIAS_RULES), "{without}");
        let biased = text(&Report {
            is_ruled_by_bias: true,
            ..report(None)
        });
        assert!(biased.contains(BIAS_RULES), "{biased}");
        assert!(!without.contains("chi-square"), "{without}");
        let by_rule = text(&Report {
            halvings_mean: Some(2.34),
            ..report(None)
        });
        assert!(
            by_rule.contains("halved 2.3 times") && by_rule.lines().all(|line| line.len() <= 100),
            "{by_rule}"
        );
        assert!(without.ends_with("o.png\nplot.svg\n"), "{without}");
        let with = text(&report(Some(0.01)));
        assert!(
            with.contains("relMSE") && with.contains("in bounds"),
            "{with}"
        );
    }
}
