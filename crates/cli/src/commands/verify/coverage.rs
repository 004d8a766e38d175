//! The method `--coverage`: the parts of the emitted Verilog that a verification uses.

use anyhow::{Result, bail};
use photoncube_testbench::{
    Coverage, CoverageKind, Gap, ModuleCoverage, Share, Source, VerifyError, VerifyOptions,
    corners, coverage,
};

use crate::args::VerifyArgs;
use crate::failure::CheckFailed;
use crate::verified::{Line, record};
use crate::{output, progress, table};

/// Verifies one machine in Verilator and counts the parts of its text that the stimulus used.
pub fn execute(args: &VerifyArgs, json: bool) -> Result<()> {
    let machine = args.machine.find()?;
    let options = VerifyOptions {
        iterations: args.iterations,
        seed: args.seed,
        source: Source::Random,
    };
    let bar = progress::bar("coverage", args.iterations);
    let found = match coverage(machine, &options, &corners(machine), &|done| {
        bar.set_position(done)
    }) {
        Ok(found) => found,
        Err(VerifyError::Diverged(divergence)) => bail!(CheckFailed(divergence.to_string())),
        Err(error) => return Err(error.into()),
    };
    bar.finish_and_clear();
    output::print(json, &found, || text(&found))?;
    if let Some(gap) = found.contradictions.first() {
        let message = format!(
            "{} of {} was used, and cannot be for the reason \"{}\": that is wrong, in \
             testbenches/src/coverage/reasons.rs; --json lists all {}",
            gap.what,
            gap.module,
            gap.reason.unwrap_or_default(),
            found.contradictions.len()
        );
        return Err(CheckFailed(message).into());
    }
    if let Some(path) = &args.record {
        record(path, &[line(args, &found)?])?;
    }
    let unexplained = found.unexplained().count();
    if unexplained > 0 {
        let message = format!(
            "{unexplained} gaps have no reason: more iterations may use them (--iterations), or a \
             row in testbenches/src/coverage/reasons.rs is missing"
        );
        return Err(CheckFailed(message).into());
    }
    Ok(())
}

fn line(args: &VerifyArgs, found: &Coverage) -> Result<Line> {
    let verdict = &found.verdict;
    let totals = CoverageKind::ALL.map(|kind| (kind, found.total(kind)));
    let part =
        |(kind, share): &(CoverageKind, Share)| format!("{} {}", kind.name(), percent(*share));
    let explained = found.gaps.iter().filter(|gap| gap.reason.is_some());
    Ok(Line {
        method: "coverage".to_owned(),
        by: verdict.tool_version.clone(),
        volume: totals.iter().map(|(_, share)| share.points as u64).sum(),
        unit: "points".to_owned(),
        result: format!(
            "{}; {} gaps with a reason, {} without",
            totals.iter().map(part).collect::<Vec<_>>().join(", "),
            explained.count(),
            found.unexplained().count()
        ),
        command: format!(
            "photoncube verify --coverage --machine {} --iterations {} --seed {}",
            verdict.machine, args.iterations, args.seed
        ),
        ..Line::of_machine(verdict.machine)?
    })
}

fn text(found: &Coverage) -> String {
    let mut header = vec!["module"];
    header.extend(CoverageKind::ALL.map(CoverageKind::name));
    let row = |module: &ModuleCoverage| {
        let share = |kind| {
            module
                .kinds
                .get(&kind)
                .map_or(String::new(), |s| counted(*s))
        };
        let mut row = vec![module.module.clone()];
        row.extend(CoverageKind::ALL.map(share));
        row
    };
    let mut rows: Vec<_> = found.modules.iter().map(row).collect();
    let mut total = vec!["all".to_owned()];
    total.extend(CoverageKind::ALL.map(|kind| {
        let share = found.total(kind);
        format!("{} ({})", counted(share), percent(share))
    }));
    rows.push(total);
    let gap = |gap: &Gap| {
        vec![
            gap.module.clone(),
            gap.kind.name().to_owned(),
            gap.what.clone(),
            gap.points.to_string(),
            gap.reason.unwrap_or("NOT KNOWN").to_owned(),
        ]
    };
    let gaps: Vec<_> = found.gaps.iter().map(gap).collect();
    let verdict = &found.verdict;
    format!(
        "{}\n{}\n{} in {} iterations, {} vectors, all equal\n",
        table::markdown(&header, &rows),
        table::markdown(&["module", "kind", "not used", "points", "because"], &gaps),
        verdict.machine,
        verdict.iterations,
        verdict.vectors_compared,
    )
}

fn counted(share: Share) -> String {
    format!("{}/{}", share.covered, share.points)
}

/// A share in percent, rounded down, so that 100 % means that nothing is left.
fn percent(share: Share) -> String {
    let tenths = (share.covered * 1000).checked_div(share.points);
    tenths.map_or("none".to_owned(), |tenths| {
        format!("{}.{} %", tenths / 10, tenths % 10)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_but_one_is_not_all() {
        let share = |covered, points| percent(Share { covered, points });
        assert_eq!(share(9_999, 10_000), "99.9 %");
        assert_eq!(share(3, 3), "100.0 %");
        assert_eq!(share(0, 0), "none");
    }
}
