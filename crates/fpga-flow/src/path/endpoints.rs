//! The registers at which a routed design's slow paths end.
//!
//! The critical path is one of many. Where few paths are nearly as slow, a change at a few registers makes the design faster; where
//! thousands are, the device or the whole design is at its limit.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{PathRules, register, round};
use crate::error::{FlowError, Result, unexpected};

/// A path counts as slow from this part of the slowest path's time on.
pub const SLOW: f64 = 0.8;

/// The ends of a routed design's paths from register to register. Each input of a register has one path: the slowest that ends there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Endpoints {
    /// The number of paths.
    pub all: u64,
    /// The number of slow paths, see [`SLOW`].
    pub slow: u64,
    /// The registers at which slow paths end, the slowest first.
    pub groups: Vec<EndpointGroup>,
}

/// Registers whose names differ only in numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct EndpointGroup {
    /// Their name, with `*` in the place of each number.
    pub registers: String,
    /// The slow paths that end at them.
    pub slow: u64,
    /// The time of the slowest, in ns.
    pub slowest_ns: f64,
}

/// The used parts of what nextpnr's `--detailed-timing-report` adds to its report.
#[derive(Deserialize)]
struct Report {
    detailed_net_timings: Vec<Net>,
}

#[derive(Deserialize)]
struct Net {
    event: String,
    endpoints: Vec<End>,
}

/// The end of a path. Its delays are the least and the most from the register at the path's start, in ns.
#[derive(Deserialize)]
struct End {
    cell: String,
    event: String,
    delay: [f64; 2],
}

/// The ends of the paths, from the text that nextpnr writes with `--report` and `--detailed-timing-report`.
///
/// # Errors
/// The text is no such report, or has no path from register to register.
pub fn endpoints(report: &str, rules: &PathRules) -> Result<Endpoints> {
    let report: Report = serde_json::from_str(report).map_err(|source| FlowError::Json {
        writer: "nextpnr's `--detailed-timing-report`",
        source,
    })?;
    let nets = report.detailed_net_timings.iter();
    // Other paths begin or end at pins.
    let ends = nets.flat_map(|net| {
        let ends = net.endpoints.iter();
        ends.filter(|end| end.event == net.event && end.event.starts_with("posedge"))
    });
    let ends: Vec<_> = ends.map(|end| (end, end.delay[1])).collect();
    let slowest = ends.iter().map(|(_, ns)| *ns).fold(0.0, f64::max);
    if slowest <= 0.0 {
        return Err(unexpected(
            "found no path from register to register in nextpnr's detailed timing report",
        ));
    }
    let mut groups: BTreeMap<String, (u64, f64)> = BTreeMap::new();
    for (end, ns) in ends.iter().filter(|(_, ns)| *ns >= SLOW * slowest) {
        let group = groups.entry(without_numbers(&register(&end.cell, rules)));
        let (slow, most) = group.or_default();
        *slow += 1;
        *most = most.max(*ns);
    }
    let mut groups: Vec<_> = groups
        .into_iter()
        .map(|(registers, (slow, slowest))| EndpointGroup {
            registers,
            slow,
            slowest_ns: round(slowest, 2),
        })
        .collect();
    groups.sort_by(|a, b| b.slowest_ns.total_cmp(&a.slowest_ns));
    Ok(Endpoints {
        all: ends.len() as u64,
        slow: groups.iter().map(|group| group.slow).sum(),
        groups,
    })
}

/// A name with `*` in the place of each number.
fn without_numbers(name: &str) -> String {
    let mut text = String::new();
    for letter in name.chars() {
        match letter.is_ascii_digit() {
            true if text.ends_with('*') => {}
            true => text.push('*'),
            false => text.push(letter),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::devices::ecp5::PATH;

    /// Paths that end at three bits of two registers, at a register that is fast, and at a pin.
    const REPORT: &str = r#"{"critical_paths": [], "fmax": {}, "detailed_net_timings": [
{"net": "a", "driver": "machine.a_TRELLIS_FF_Q", "port": "Q", "event": "posedge clk", "sources": [], "endpoints": [
  {"cell": "machine.chain_0.sum_TRELLIS_FF_Q_12", "port": "DI", "event": "posedge clk", "delay": [1.0, 5.004]},
  {"cell": "machine.chain_0.sum_TRELLIS_FF_Q_3", "port": "DI", "event": "posedge clk", "delay": [1.0, 4.5]},
  {"cell": "pin", "port": "I", "event": "<async>", "delay": [1.0, 9.0]}]},
{"net": "b", "driver": "machine.b_TRELLIS_FF_Q", "port": "Q", "event": "posedge clk", "sources": [], "endpoints": [
  {"cell": "machine.chain_11.sum_TRELLIS_FF_Q_3", "port": "DI", "event": "posedge clk", "delay": [1.0, 4.1]},
  {"cell": "machine.chain_11.count_TRELLIS_FF_Q", "port": "CE", "event": "posedge clk", "delay": [1.0, 4.8]},
  {"cell": "machine.chain_11.idle_TRELLIS_FF_Q", "port": "CE", "event": "posedge clk", "delay": [1.0, 3.9]}]}]}"#;

    fn group(registers: &str, slow: u64, slowest_ns: f64) -> EndpointGroup {
        EndpointGroup {
            registers: registers.to_owned(),
            slow,
            slowest_ns,
        }
    }

    #[test]
    fn the_ends_of_slow_paths_are_grouped_by_register() {
        let found = endpoints(REPORT, &PATH).unwrap();
        let groups = [group("chain_*.sum", 3, 5.0), group("chain_*.count", 1, 4.8)];
        assert_eq!((found.all, found.slow), (5, 4));
        assert_eq!(found.groups, groups);
    }

    #[test]
    fn a_report_without_details_or_without_paths_is_refused() {
        let error = endpoints(r#"{"fmax": {}}"#, &PATH).unwrap_err();
        assert!(
            error.to_string().contains("--detailed-timing-report"),
            "{error}"
        );
        let pins = REPORT.replace("posedge clk", "<async>");
        let error = endpoints(&pins, &PATH).unwrap_err().to_string();
        assert!(error.contains("found no path from register"), "{error}");
    }
}
