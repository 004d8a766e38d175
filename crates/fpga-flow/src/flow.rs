//! The ways in which Yosys maps a design, one row each.

use std::cmp::Ordering;
use std::fmt;

use serde::de::{self, Deserialize, Deserializer};
use serde::ser::{Serialize, Serializer};

use crate::area::Stat;
use crate::devices::FLOWS;
use crate::error::{Result, unexpected};
use crate::figure::{CellRow, Figure, Figures, Term, count};

/// A way to map a design: the Yosys commands, and the figures of its area. The rows are in [`FLOWS`]; JSON has
/// a flow's name.
#[derive(Debug)]
pub struct Flow {
    /// The flow's name.
    pub name: &'static str,
    /// The name of the family of FPGAs; `any` where the flow is of none.
    pub family: &'static str,
    /// The target of the flow, as a heading.
    pub heading: &'static str,
    /// The target in a list of flows.
    pub help: &'static str,
    /// The figures that are counted.
    pub figures: &'static [Figure],
    /// The Yosys commands between reading and counting. `TOP` is the top module's name.
    pub(crate) commands: &'static str,
    /// The cells that the commands may leave.
    pub(crate) cells: &'static [CellRow],
    /// The figures that are computed from others.
    pub(crate) terms: &'static [Term],
    /// The technology whose transistors Yosys's `stat` adds up, and their check; `None` where there is none.
    pub(crate) transistors: Option<Transistors>,
}

/// The name of a technology, and the check of Yosys's sum of transistors.
type Transistors = (&'static str, fn(&Stat) -> Result<()>);

impl Flow {
    /// Finds the flow of that name.
    ///
    /// # Errors
    /// There is none; the error has all names.
    pub fn find(name: &str) -> Result<&'static Self> {
        let flow = FLOWS.iter().find(|flow| flow.name == name);
        flow.copied().ok_or_else(|| {
            let names: Vec<_> = FLOWS.iter().map(|flow| flow.name).collect();
            unexpected(format!(
                "found the flow `{name}`, expected one of {}",
                names.join(", ")
            ))
        })
    }

    /// The Yosys commands between reading and counting. ABC9 trades area for speed where a path is longer than
    /// `abc9_target_ps`, in picoseconds.
    pub fn script(&self, top: &str, abc9_target_ps: u32) -> String {
        let commands = self.commands.replace("TOP", top);
        format!("scratchpad -set abc9.D {abc9_target_ps}; {commands}")
    }

    /// The options of Yosys's `stat` whose output [`Self::count`] reads.
    pub fn stat_options(&self) -> String {
        let technology = self.transistors.map(|(technology, _)| technology);
        technology.map_or("-json".to_owned(), |of| format!("-json -tech {of}"))
    }

    /// The figures of the area, from what Yosys's `stat` printed with [`Self::stat_options`].
    ///
    /// # Errors
    /// The text is no such output, or a cell adds to none of the figures.
    pub fn count(&self, stat: &str) -> Result<Figures> {
        let stat = Stat::parse(stat)?;
        let figures = count(&stat.cells, self.cells, self.terms, self.figures)?;
        if let Some((_, check)) = self.transistors {
            check(&stat)?;
        }
        Ok(figures)
    }

    fn place(&self) -> usize {
        let place = FLOWS.iter().position(|flow| flow.name == self.name);
        place.unwrap_or(FLOWS.len())
    }
}

impl fmt::Display for Flow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl PartialEq for Flow {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Flow {}

impl PartialOrd for Flow {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Flow {
    fn cmp(&self, other: &Self) -> Ordering {
        self.place().cmp(&other.place())
    }
}

impl Serialize for Flow {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(self.name)
    }
}

impl<'de> Deserialize<'de> for &'static Flow {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let name = String::deserialize(from)?;
        Flow::find(&name).map_err(de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_flow_has_one_row_and_one_name() {
        for flow in FLOWS {
            assert_eq!(FLOWS.iter().filter(|other| **other == flow).count(), 1);
            let json = serde_json::to_string(flow).unwrap();
            let back: &Flow = serde_json::from_str(&json).unwrap();
            assert_eq!(back.name, flow.name);
            let script = flow.script("the_top", 10_000);
            assert!(script.contains("-top the_top"), "{flow}");
            assert!(!script.contains("TOP"), "{flow}");
        }
        assert!(
            Flow::find("asic")
                .unwrap_err()
                .to_string()
                .contains("gates")
        );
    }
}
