//! Measures the coverage of the emitted Verilog: the lines, branches, bits and cover points that the stimulus
//! of a verification used, by Verilator's counters in every instance. Each unused point is listed with a
//! reason.

mod constants;
mod covers;
mod points;
mod reasons;
mod words;

use std::collections::{BTreeMap, BTreeSet};

use photoncube_hdl::{Level, emit};
use photoncube_spec::Machine;
use serde::Serialize;

use crate::controls::Control;
use crate::device::{DeviceError, DeviceKind, Verilator, hdl_error};
use crate::stimulus::{Protocol, Source};
use crate::trace::TRACE;
use crate::verify::{Verdict, VerifyError, VerifyOptions, verify_device};

pub use points::CoverageKind;
use points::Point;
use reasons::Why;

/// The coverage that a verification reached in a machine's emitted Verilog.
#[derive(Clone, Debug, Serialize)]
pub struct Coverage {
    /// The verdict of the verification, which found no mismatch.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// The modules, sorted by name.
    pub modules: Vec<ModuleCoverage>,
    /// The points that were not used.
    pub gaps: Vec<Gap>,
    /// The points that were used although a recorded reason excludes it; such a reason is wrong.
    pub contradictions: Vec<Gap>,
    /// The controls: a used point with a planted reason, and a used point whose use is not counted.
    #[serde(skip)]
    pub controls: Vec<Control>,
}

/// The coverage of a module, over all its instances.
#[derive(Clone, Debug, Serialize)]
pub struct ModuleCoverage {
    /// The module's name, without the machine's prefix.
    pub module: String,
    /// The share of each kind of point that the module has.
    pub kinds: BTreeMap<CoverageKind, Share>,
}

/// A number of covered points out of a total.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Share {
    /// The number of points that were used at least once.
    pub covered: usize,
    /// The number of all points.
    pub points: usize,
}

/// Unused points of one signal or one line.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Gap {
    /// The kind of the points.
    #[serde(rename = "counter")]
    pub kind: CoverageKind,
    /// The module's name, without the machine's prefix.
    pub module: String,
    /// The signal with its bits, the statement, or the cover point.
    pub what: String,
    /// The number of points, in all instances.
    pub points: usize,
    /// The reason why the points cannot be used; `None` if no reason is recorded.
    pub reason: Option<&'static str>,
}

impl Coverage {
    /// The sum of a kind over all modules.
    pub fn total(&self, kind: CoverageKind) -> Share {
        let shares = self.modules.iter().filter_map(|m| m.kinds.get(&kind));
        shares.fold(Share::default(), |sum, share| Share {
            covered: sum.covered + share.covered,
            points: sum.points + share.points,
        })
    }

    /// The unused points without a recorded reason.
    pub fn unexplained(&self) -> impl Iterator<Item = &Gap> {
        self.gaps.iter().filter(|gap| gap.reason.is_none())
    }
}

/// Verifies a machine in Verilator, with the stimulus of the options and with that of each corner, and counts
/// the parts of the text that the stimulus used.
///
/// # Errors
/// The verification or the tool fails.
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
    let mut why = Why::new(machine, &design)?;
    let controls = controls(&mut why, &points, &lines);
    let contradictions = contradictions(&why, &points, &lines);
    let points = counted(machine, points);
    Ok(Coverage {
        verdict,
        modules: modules(&points),
        gaps: gaps(&why, &points, &lines),
        contradictions,
        controls,
    })
}

/// Plants a reason for a point that was used, and takes the use of the point away: the first must be a
/// contradiction, the second a gap without a reason. Empty where no bit of a signal is used.
fn controls(why: &mut Why<'_>, points: &[Point], lines: &[&str]) -> Vec<Control> {
    let used = points.iter().find(|point| {
        let (name, bit) = named(point, lines);
        point.kind == CoverageKind::Toggle
            && point.module != TRACE
            && point.hits > SETTLING
            && why.reason(point, &name, bit).is_none()
    });
    let Some(used) = used else {
        return Vec::new();
    };
    let (name, bit) = named(used, lines);
    let constant = (reasons::path(used, &name), bit.unwrap_or(0));
    let place = format!("{}.{}", used.instance, used.what);
    let used = [used.clone()];
    why.constants.insert(constant.clone());
    let of_reason = Control {
        planted: format!("a reason for {place}, which is used"),
        found: !contradictions(why, &used, lines).is_empty(),
    };
    why.constants.remove(&constant);
    let unused = used.map(|point| Point { hits: 0, ..point });
    let found = gaps(why, &counted(why.words.machine, unused.to_vec()), lines);
    let of_use = Control {
        planted: format!("no use of {place}"),
        found: found.iter().any(|gap| gap.reason.is_none()),
    };
    vec![of_reason, of_use]
}

/// The points that were not used, with their reasons.
fn gaps(why: &Why<'_>, points: &[Point], lines: &[&str]) -> Vec<Gap> {
    grouped(why, points.iter().filter(|point| point.hits == 0), lines)
}

/// The stimulus of corners that random stimulus reaches too rarely.
pub fn corners(machine: &Machine) -> Vec<Source<'static>> {
    match machine.overlap_program() {
        // In these machines the sums of lanes cross links of their own width.
        Some(_) => vec![Source::FullThenEmpty, Source::LaneAlone],
        // Results that wait fill the queue of batches under way.
        None if machine.leaf().is_some() => [
            Source::corners(machine),
            vec![
                Source::Protocol(Protocol::Stalls),
                Source::Protocol(Protocol::Holds),
            ],
        ]
        .concat(),
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

/// The points that count. A bit counts in every instance; a statement is used if one instance uses it.
fn counted(machine: &Machine, points: Vec<Point>) -> Vec<Point> {
    let mut merged: BTreeMap<_, Point> = BTreeMap::new();
    for point in points {
        // The trace module belongs to the testbench, so only its cover points count.
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

/// The point with its module's name without the machine's prefix.
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

/// The most changes that a bit which is constant later may have at the start: once as it is set, and once as
/// its consequences are.
const SETTLING: u64 = 2;

/// The points that were used in at least one run although a reason excludes it.
fn contradictions(why: &Why<'_>, points: &[Point], lines: &[&str]) -> Vec<Gap> {
    let used = points.iter().filter(|point| point.hits > SETTLING).cloned();
    let used = counted(why.words.machine, used.collect());
    let mut gaps = grouped(why, &used, lines);
    gaps.retain(|gap| gap.reason.is_some());
    gaps
}

/// Points with their reasons. Points of one signal or statement that have one reason are grouped.
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

    use super::words::Words;
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
        let words = Words::of(machine).unwrap();
        let why = Why { words, constants };
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

    #[test]
    fn controls_are_planted_at_a_used_point_and_found() {
        let machine = photoncube_spec::find_machine("paper").unwrap();
        let constants = HashSet::from([("cell_0.no_such".to_owned(), 1)]);
        let words = Words::of(machine).unwrap();
        let mut why = Why { words, constants };
        let points = [
            ("no_such[0]", SETTLING),
            ("no_such[1]", 9),
            ("no_such[2]", 9),
        ];
        let points = points.map(|(what, hits)| point(what, hits));
        let found = controls(&mut why, &points, &[]);
        assert!(found.len() == 2 && found.iter().all(|control| control.found));
        assert!(found[0].planted.contains("no_such[2]"), "{found:?}");
        assert_eq!(why.constants.len(), 1);
        assert_eq!(controls(&mut why, &points[..2], &[]), []);
    }
}
