//! The method `coverage`: the parts of the emitted Verilog that a verification uses.

use anyhow::Result;
use clap::Args;
use photoncube_testbench::{
    Controls, Coverage as Found, CoverageKind, DeviceKind, ModuleCoverage, Share, Tool, corners,
    coverage,
};

use super::method::Method;
use super::options::StimulusArgs;
use super::outcome::{Outcome, equal};
use crate::machines::MachineArgs;
use crate::progress;
use crate::table::markdown;
use crate::verified::Line;

/// See [`Method::ABOUT`].
#[derive(Args, Debug)]
pub struct Coverage {
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    stimulus: StimulusArgs,
}

impl Method for Coverage {
    const NAME: &'static str = "coverage";
    const ABOUT: &'static str = "Count what a verification in Verilator uses of the emitted lines, branches and bits, and \
        list what it does not";
    const EXAMPLES: &'static [&'static str] =
        &["photoncube verify coverage --machine stream --iterations 200000"];

    fn tools(&self) -> Vec<Tool> {
        [&[Tool::Yosys], DeviceKind::Verilator.tools()].concat()
    }

    fn run(&self) -> Result<Outcome> {
        let machine = self.machine.find_to_emit()?;
        let bar = progress::bar("coverage", self.stimulus.iterations);
        let position = |done| bar.set_position(done);
        let corners = corners(machine);
        let found = equal(coverage(
            machine,
            &self.stimulus.random(),
            &corners,
            &position,
        ))?;
        bar.finish_and_clear();
        let header = CoverageKind::ALL.map(CoverageKind::name);
        let header = [&["module"], &header[..]].concat();
        let verdict = &found.verdict;
        let counts = format!(
            "{} in {} iterations, {} vectors, all equal",
            verdict.machine, verdict.iterations, verdict.vectors_compared,
        );
        Ok(
            Outcome::new::<Self>(Controls::gathered(found.controls.clone())?, &found)?
                .table(&markdown(&header, &rows(&found)))
                .rows("gaps", "module counter what points reason")
                .note(counts)
                .lines([self.line(&found)?])
                .findings(findings(&found)),
        )
    }
}

impl Coverage {
    fn line(&self, found: &Found) -> Result<Line> {
        let verdict = &found.verdict;
        let totals = CoverageKind::ALL.map(|kind| (kind, found.total(kind)));
        let part =
            |(kind, share): &(CoverageKind, Share)| format!("{} {}", kind.name(), percent(*share));
        let explained = found.gaps.iter().filter(|gap| gap.reason.is_some());
        Ok(Line {
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
                "photoncube verify coverage --machine {} --iterations {} --seed {}",
                verdict.machine, self.stimulus.iterations, self.stimulus.seed.seed
            ),
            ..Line::of_machine(verdict.machine)?
        })
    }
}

fn findings(found: &Found) -> Vec<String> {
    let contradictions = found.contradictions.iter().map(|gap| {
        format!(
            "{} of {} was used, and cannot be for the reason \"{}\": that is wrong, in \
             testbenches/src/coverage/reasons.rs",
            gap.what,
            gap.module,
            gap.reason.unwrap_or_default()
        )
    });
    let unexplained = found.unexplained().count();
    let gaps = (unexplained > 0).then(|| {
        format!(
            "{unexplained} gaps have no reason: more iterations may use them (--iterations), or a row in \
             testbenches/src/coverage/reasons.rs is missing"
        )
    });
    contradictions.chain(gaps).collect()
}

/// The points used of each module, and of all.
fn rows(found: &Found) -> Vec<Vec<String>> {
    let row = |module: &ModuleCoverage| {
        let share = |kind| {
            let share = module.kinds.get(&kind);
            share.map_or(String::new(), |share| counted(*share))
        };
        let mut row = vec![module.module.clone()];
        row.extend(CoverageKind::ALL.map(share));
        row
    };
    let mut total = vec!["all".to_owned()];
    total.extend(CoverageKind::ALL.map(|kind| {
        let share = found.total(kind);
        format!("{} ({})", counted(share), percent(share))
    }));
    found.modules.iter().map(row).chain([total]).collect()
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
