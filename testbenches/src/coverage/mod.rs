//! Coverage of the emitted Verilog: which lines, branches, bits and cover points the stimulus of a verification
//! used, by Verilator's counters in every instance; and what it did not use, each with a reason.

mod constants;
mod covers;
mod points;
mod reasons;
mod words;

use std::collections::{BTreeMap, BTreeSet};

use photoncube_hdl::{Level, emit};
use photoncube_spec::Machine;
use serde::Serialize;

use crate::device::{DeviceError, DeviceKind, Verilator, hdl_error};
use crate::stimulus::Source;
use crate::trace::TRACE;
use crate::verify::{Verdict, VerifyError, VerifyOptions, verify_device};

pub use points::CoverageKind;
use points::Point;
use reasons::Why;

/// What a verification used of a machine's emitted Verilog.
#[derive(Clone, Debug, Serialize)]
pub struct Coverage {
    /// The verification, which went through without a mismatch.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// The modules, in the order of their names.
    pub modules: Vec<ModuleCoverage>,
    /// What was not used.
    pub gaps: Vec<Gap>,
    /// What was used although a reason says that it cannot be: the reason is wrong.
    pub contradictions: Vec<Gap>,
}

/// What was used of a module, in all its instances.
#[derive(Clone, Debug, Serialize)]
pub struct ModuleCoverage {
    /// The module, without the machine's prefix.
    pub module: String,
    /// For each kind of which it has points.
    pub kinds: BTreeMap<CoverageKind, Share>,
}

/// A part of a number of points.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Share {
    /// Points that were used at least once.
    pub covered: usize,
    /// All points.
    pub points: usize,
}

/// Points of one signal or one line.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Gap {
    /// Their kind.
    #[serde(rename = "counter")]
    pub kind: CoverageKind,
    /// The module, without the machine's prefix.
    pub module: String,
    /// The signal with its bits, the statement, or the cover point.
    pub what: String,
    /// How many points these are, in all instances.
    pub points: usize,
    /// Why they cannot be used; none is known where there is none.
    pub reason: Option<&'static str>,
}

impl Coverage {
    /// The sum over all modules.
    pub fn total(&self, kind: CoverageKind) -> Share {
        let shares = self.modules.iter().filter_map(|m| m.kinds.get(&kind));
        shares.fold(Share::default(), |sum, share| Share {
            covered: sum.covered + share.covered,
            points: sum.points + share.points,
        })
    }

    /// What was not used, and nobody knows why.
    pub fn unexplained(&self) -> impl Iterator<Item = &Gap> {
        self.gaps.iter().filter(|gap| gap.reason.is_none())
    }
}

/// Verifies a machine in Verilator, with the stimulus of the options and with that of each corner, and counts what of its
/// text that used.
///
/// # Errors
/// The verification fails, or the tool does.
pub fn coverage(
    machine: &Machine,
    options: &VerifyOptions<'_>,
    corners: &[Source<'_>],
    progress: &dyn Fn(u64),
) -> Result<Coverage, VerifyError> {
    if let Some(missing) = DeviceKind::Verilator.missing_tool() {
        return Err(DeviceError::from(missing).into());
    }
    let design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
    let covers = covers::statements(&covers::covers(machine));
    let used = |source| {
        let mut device = Verilator::with_coverage(&design, &covers)?;
        let options = VerifyOptions { source, ..*options };
        let verdict = verify_device(machine, &mut device, &options, progress)?;
        let points = points::parse(&device.coverage()?).map_err(unreadable)?;
        Ok::<_, VerifyError>((verdict, points))
    };
    let (mut verdict, mut points) = used(options.source)?;
    for &corner in corners {
        let (of_corner, more) = used(corner)?;
        verdict.vectors_compared += of_corner.vectors_compared;
        verdict.iterations += of_corner.iterations;
        verdict.results_compared += of_corner.results_compared;
        points.extend(more);
    }
    let lines: Vec<_> = design.text.lines().collect();
    let why = Why::new(machine, &design)?;
    let contradictions = contradictions(&why, &points, &lines);
    let points = counted(machine, points);
    let unused = points.iter().filter(|point| point.hits == 0);
    Ok(Coverage {
        verdict,
        modules: modules(&points),
        gaps: grouped(&why, unused, &lines),
        contradictions,
    })
}

/// The corners that random stimulus comes to too rarely.
pub fn corners(machine: &Machine) -> Vec<Source<'static>> {
    match machine.overlap_program() {
        // There sums of lanes cross links of their own width.
        Some(_) => vec![Source::FullThenEmpty, Source::LaneAlone],
        None if machine.has_memory() => Source::corners(machine),
        None => vec![Source::FullThenEmpty],
    }
}

fn unreadable(message: String) -> DeviceError {
    DeviceError::BrokeOff {
        device: "verilator".to_owned(),
        message,
    }
}

/// The points that count. A bit counts in every instance; a statement is used where one instance uses it.
fn counted(machine: &Machine, points: Vec<Point>) -> Vec<Point> {
    let mut merged: BTreeMap<_, Point> = BTreeMap::new();
    for point in points {
        // The trace module is the testbench's own: of it the cover points count.
        if point.module == TRACE && point.kind != CoverageKind::User {
            continue;
        }
        let instance = match point.kind {
            CoverageKind::Toggle => point.instance.clone(),
            _ => String::new(),
        };
        let key = (point.kind, instance, point.line, point.what.clone());
        let hits = point.hits;
        let entry = merged.entry(key).or_insert_with(|| Point {
            hits: 0,
            ..without_prefix(machine, point)
        });
        entry.hits += hits;
    }
    merged.into_values().collect()
}

/// The point with its module as people know it.
fn without_prefix(machine: &Machine, mut point: Point) -> Point {
    let prefix = machine.module_prefix();
    point.module = match point.module.strip_prefix(&prefix) {
        Some("") => "top".to_owned(),
        Some(rest) => rest.trim_start_matches('_').to_owned(),
        None => point.module,
    };
    point
}

fn modules(points: &[Point]) -> Vec<ModuleCoverage> {
    let mut modules: BTreeMap<&str, BTreeMap<CoverageKind, Share>> = BTreeMap::new();
    for point in points {
        let kinds = modules.entry(&point.module).or_default();
        let share = kinds.entry(point.kind).or_default();
        share.points += 1;
        share.covered += usize::from(point.hits > 0);
    }
    let module = |(name, kinds): (&str, _)| ModuleCoverage {
        module: name.to_owned(),
        kinds,
    };
    modules.into_iter().map(module).collect()
}

/// So often a bit that never changes later may change as a device starts: it is set, and then what follows from it.
const SETTLING: u64 = 2;

/// The points that were used in one run at least, and have a reason why they cannot be.
fn contradictions(why: &Why<'_>, points: &[Point], lines: &[&str]) -> Vec<Gap> {
    let used = points.iter().filter(|point| point.hits > SETTLING).cloned();
    let used = counted(why.machine, used.collect());
    let mut gaps = grouped(why, &used, lines);
    gaps.retain(|gap| gap.reason.is_some());
    gaps
}

/// Points with the reason why they cannot be used; those of a signal or a statement, for one reason, together.
fn grouped<'a>(
    why: &Why<'_>,
    points: impl IntoIterator<Item = &'a Point>,
    lines: &[&str],
) -> Vec<Gap> {
    let mut groups: BTreeMap<_, (BTreeSet<u32>, usize)> = BTreeMap::new();
    for point in points {
        let (name, bit) = named(point, lines);
        let reason = why.reason(point, &name, bit);
        let key = (point.module.as_str(), point.kind, name, reason);
        let (bits, points) = groups.entry(key).or_default();
        bits.extend(bit);
        *points += 1;
    }
    let gap = |((module, kind, name, reason), (bits, points)): ((&str, _, String, _), _)| Gap {
        what: name + &ranges(&bits),
        kind,
        module: module.to_owned(),
        points,
        reason,
    };
    groups.into_iter().map(gap).collect()
}

/// A point's signal and bit, or its statement.
fn named(point: &Point, lines: &[&str]) -> (String, Option<u32>) {
    let what = point.what.as_str();
    match point.kind {
        CoverageKind::User => (what.to_owned(), None),
        CoverageKind::Toggle => {
            let bit = what.strip_suffix(']').and_then(|what| {
                let (name, bit) = what.rsplit_once('[')?;
                Some((name.to_owned(), Some(bit.parse().ok()?)))
            });
            bit.unwrap_or_else(|| (what.to_owned(), None))
        }
        CoverageKind::Line | CoverageKind::Branch => {
            let line = point.line.checked_sub(1).and_then(|line| lines.get(line));
            let statement = line.map_or("", |line| line.trim());
            (format!("{what} of `{statement}`"), None)
        }
    }
}

/// Bits as Verilog's ranges, such as `[3:1]`, most significant first.
fn ranges(bits: &BTreeSet<u32>) -> String {
    let mut ranges: Vec<(u32, u32)> = Vec::new();
    for &bit in bits.iter().rev() {
        match ranges.last_mut() {
            Some((_, low)) if *low == bit + 1 => *low = bit,
            _ => ranges.push((bit, bit)),
        }
    }
    let range = |&(high, low): &(u32, u32)| match high == low {
        true => format!("[{high}]"),
        false => format!("[{high}:{low}]"),
    };
    ranges.iter().map(range).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    fn point(what: &str, hits: u64) -> Point {
        Point {
            kind: CoverageKind::Toggle,
            module: "cell".into(),
            instance: "cell_0".into(),
            line: 1,
            what: what.into(),
            hits,
        }
    }

    #[test]
    fn bits_of_a_signal_are_one_gap() {
        let unused = [5, 4, 3, 1].map(|bit| point(&format!("no_such[{bit}]"), 0));
        let used = [point("no_such[2]", 1), point("no_such[0]", 9)];
        let machine = photoncube_spec::find_machine("paper").unwrap();
        let constants = HashSet::from([("cell_0.no_such".to_owned(), 1)]);
        let why = Why { machine, constants };
        let [gap, constant] = &grouped(&why, &unused, &[])[..] else {
            panic!("two gaps");
        };
        assert_eq!((gap.what.as_str(), gap.points), ("no_such[5:3]", 3));
        assert_eq!(gap.reason, None);
        assert_eq!((constant.what.as_str(), constant.points), ("no_such[1]", 1));
        assert!(constant.reason.is_some());
        assert_eq!(contradictions(&why, &used, &[]), []);
        let settled = point("no_such[1]", SETTLING);
        assert_eq!(contradictions(&why, &[settled.clone(), settled], &[]), []);
        let wrong = contradictions(&why, &[point("no_such[1]", SETTLING + 1)], &[]);
        assert_eq!(
            wrong,
            std::slice::from_ref(constant),
            "used, and called constant"
        );
        let points = [unused.to_vec(), used.to_vec()].concat();
        let share = modules(&points)[0].kinds[&CoverageKind::Toggle];
        assert_eq!((share.covered, share.points), (2, 6));
    }
}
