//! Facts about the critical path of a routed design, which limits its clock.

mod endpoints;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::error::{FlowError, Result, unexpected};
use crate::wrapper::INSTANCE;

pub use endpoints::{EndpointGroup, Endpoints, SLOW, endpoints};

/// The slowest path from register to register.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CriticalPath {
    /// The register, memory or DSP block at the start, without the bit.
    pub from: String,
    /// The register, memory or DSP block at the end, without the bit.
    pub to: String,
    /// The time in cells, including the registers at both ends, in ns.
    pub logic_ns: f64,
    /// The time on nets, in ns.
    pub routing_ns: f64,
    /// The time on the slowest net, in ns.
    pub longest_net_ns: f64,
    /// The number of carry chains on the path.
    pub carry_chains: u64,
    /// The number of carry cells in these chains: CCU2C of two bits on ECP5, logic cells of one bit on iCE40.
    pub carry_cells: u64,
    /// The number of LUTs; the muxes that join the LUTs of a slice are not counted.
    pub lut_levels: u64,
    /// The number of DSP blocks on the path.
    pub dsp_levels: u64,
    /// The part that takes most of the time.
    pub binds: Binding,
}

/// The part that takes most of a path's time. Each net is counted with the cell that it leads to, unless one
/// net takes more time than everything else.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Binding {
    /// Adders and comparators.
    CarryChains,
    /// LUTs without a carry chain.
    Luts,
    /// Multipliers.
    DspBlocks,
    /// Block RAMs and LUT RAMs.
    Memories,
    /// The registers at both ends, and the net to the last register.
    Registers,
    /// One long net.
    OneNet,
}

impl Binding {
    /// The description of the part in reports.
    pub fn words(self) -> &'static str {
        match self {
            Self::CarryChains => "carry chains",
            Self::Luts => "LUTs",
            Self::DspBlocks => "DSP blocks",
            Self::Memories => "memories",
            Self::Registers => "registers",
            Self::OneNet => "one net",
        }
    }
}

/// The used parts of nextpnr's `--report` file.
#[derive(Deserialize)]
struct Report {
    critical_paths: Vec<PathReport>,
    fmax: BTreeMap<String, Clock>,
}

#[derive(Deserialize)]
struct Clock {
    achieved: f64,
}

#[derive(Deserialize)]
struct PathReport {
    from: String,
    to: String,
    path: Vec<Step>,
}

/// A step of the path: the time in a cell or on a net.
#[derive(Deserialize)]
struct Step {
    #[serde(rename = "type")]
    kind: String,
    delay: f64,
    from: Pin,
    to: Pin,
}

#[derive(Deserialize)]
struct Pin {
    cell: String,
    port: String,
}

/// The names by which the cells of a family are known in nextpnr's report.
#[derive(Debug)]
pub struct PathRules {
    /// The kinds in cell names. Yosys names a cell `NET_KIND_PORT`, where the net itself may have such a name,
    /// and nextpnr preserves the kinds of cells only in these names.
    pub(crate) kinds: &'static [(&'static str, Binding)],
    /// The carry cell that a step in a cell passes; `None` where it passes none.
    pub(crate) carry_cell: for<'a> fn(&Hop<'a>) -> Option<&'a str>,
    /// The input port of the carry from the previous cell.
    pub(crate) carry_in: &'static str,
    /// The inputs of the muxes that join the LUTs of a slice.
    pub(crate) wide_mux_inputs: &'static [&'static str],
    /// Whether the set-up time of a register may have a LUT in it.
    pub(crate) has_lut_in_set_up: bool,
}

/// A step in a cell.
pub(crate) struct Hop<'a> {
    /// The name of the cell.
    pub cell: &'a str,
    /// The port by which the path leaves it.
    pub output: &'a str,
}

/// The highest clock in MHz that the routed design allows, and its critical path, from the text that nextpnr's
/// `--report` writes.
///
/// # Errors
/// The text is no such report, or has not one clock with a path.
pub fn parse(report: &str, rules: &PathRules) -> Result<(f64, CriticalPath)> {
    let report: Report = serde_json::from_str(report).map_err(|source| FlowError::Json {
        writer: "nextpnr's `--report`",
        source,
    })?;
    let clocks: Vec<_> = report.fmax.iter().collect();
    let &[(clock, fmax)] = clocks.as_slice() else {
        return Err(unexpected(format!(
            "found the clocks {:?} in nextpnr's report, expected one",
            report.fmax.keys()
        )));
    };
    // Other paths begin or end at pins.
    let own = |path: &&PathReport| path.from == path.to && path.from.ends_with(clock.as_str());
    let path = report.critical_paths.iter().find(own);
    let path =
        path.ok_or_else(|| unexpected(format!("found no critical path of the clock {clock}")))?;
    Ok((round(fmax.achieved, 2), facts(&path.path, rules)?))
}

fn facts(steps: &[Step], rules: &PathRules) -> Result<CriticalPath> {
    let (Some(first), Some(last)) = (steps.first(), steps.last()) else {
        return Err(unexpected(
            "found a critical path without steps in nextpnr's report",
        ));
    };
    let nets = steps.iter().filter(|step| step.is_net());
    let longest_net_ns = nets.map(|step| step.delay).fold(0.0, f64::max);
    let sum = |of_nets: bool| {
        let steps = steps.iter().filter(|step| step.is_net() == of_nets);
        steps.map(|step| step.delay).sum::<f64>()
    };
    let (mut carry_chains, mut lut_levels, mut dsp_levels) = (0, 0, 0);
    let mut carry_cells: Vec<&str> = Vec::new();
    let mut taken: BTreeMap<Binding, f64> = BTreeMap::new();
    let mut on_nets = 0.0;
    for step in steps {
        if step.is_net() {
            on_nets += step.delay;
            continue;
        }
        let part = step.part(rules);
        *taken.entry(part).or_default() += std::mem::take(&mut on_nets) + step.delay;
        if step.kind != "logic" {
            let is_in_set_up = rules.has_lut_in_set_up && step.kind == "setup";
            lut_levels += u64::from(is_in_set_up && part == Binding::Luts);
            continue;
        }
        match part {
            Binding::CarryChains => {
                carry_chains += u64::from(step.from.port != rules.carry_in);
                let cell = (rules.carry_cell)(&step.hop()).unwrap_or_default();
                if carry_cells.last() != Some(&cell) {
                    carry_cells.push(cell);
                }
            }
            Binding::DspBlocks => dsp_levels += 1,
            _ => lut_levels += u64::from(!step.is_wide_mux(rules)),
        }
    }
    let by_time = |a: &(&Binding, &f64), b: &(&Binding, &f64)| a.1.total_cmp(b.1);
    let largest = taken.iter().max_by(by_time).map(|(&part, _)| part);
    let total = sum(true) + sum(false);
    let binds = match largest {
        Some(part) if longest_net_ns <= total / 2.0 => part,
        _ => Binding::OneNet,
    };
    Ok(CriticalPath {
        from: register(&first.from.cell, rules),
        to: register(&last.to.cell, rules),
        logic_ns: round(sum(false), 2),
        routing_ns: round(sum(true), 2),
        longest_net_ns: round(longest_net_ns, 2),
        carry_chains,
        carry_cells: carry_cells.len() as u64,
        lut_levels,
        dsp_levels,
        binds,
    })
}

impl Step {
    fn is_net(&self) -> bool {
        self.kind == "routing"
    }

    /// The kind of the cell, by the last kind in its name.
    fn part(&self, rules: &PathRules) -> Binding {
        let cell = &self.to.cell;
        if (rules.carry_cell)(&self.hop()).is_some() {
            return Binding::CarryChains;
        }
        let kinds = rules.kinds.iter();
        let places = kinds.filter_map(|&(kind, part)| cell.rfind(kind).map(|at| (at, part)));
        let last = places.max_by_key(|&(at, _)| at).map(|(_, part)| part);
        match (last, self.kind.as_str()) {
            // A register with a LUT in front of it has the LUT's name after its own.
            (Some(part), _) => part,
            (None, "logic") => Binding::Luts,
            (None, _) => Binding::Registers,
        }
    }

    /// Whether the step passes one of the muxes that join the LUTs of a slice, and not a LUT.
    fn is_wide_mux(&self, rules: &PathRules) -> bool {
        rules.wide_mux_inputs.contains(&self.from.port.as_str())
    }

    fn hop(&self) -> Hop<'_> {
        Hop {
            cell: &self.to.cell,
            output: &self.to.port,
        }
    }
}

/// The name of a cell's register, without the wrapper's prefix and without Yosys's additions.
fn register(cell: &str, rules: &PathRules) -> String {
    let cell = cell
        .strip_prefix(INSTANCE)
        .and_then(|cell| cell.strip_prefix('.'))
        .unwrap_or(cell);
    let ends = rules.kinds.iter().filter_map(|(kind, _)| cell.find(kind));
    let end = ends.min().unwrap_or(cell.len());
    cell[..end].to_owned()
}

fn round(value: f64, digits: i32) -> f64 {
    let scale = 10f64.powi(digits);
    (value * scale).round() / scale
}

#[cfg(test)]
mod tests;
