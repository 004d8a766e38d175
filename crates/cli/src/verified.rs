//! The verification results: the lines of `docs/verification.md`, stored as data in
//! `docs/measured/verification.json`, which `verify --record` writes.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use photoncube_hdl::{Level, Unit, emit, emit_unit, has_unit};
use photoncube_spec::find_machine;
use serde::{Deserialize, Serialize};

use crate::{digests, files, table};

/// A result of one verification method on one machine.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// The name of the machine, or of another object that was verified.
    pub machine: String,
    /// The digest of the Verilog that was verified, see [`photoncube_hdl::Emitted::verilog_sha256`]; `None`
    /// where the result is about no Verilog.
    pub verilog_sha256: Option<String>,
    /// The method, such as `equivalence` or `mutants`.
    pub method: String,
    /// The tools of the method, with their versions.
    pub by: String,
    /// The amount that was verified, in `unit`.
    pub volume: u64,
    /// The unit of `volume`.
    pub unit: String,
    /// The outcome, as text.
    #[serde(rename = "outcome")]
    pub result: String,
    /// The command that repeats the verification.
    pub command: String,
}

impl Line {
    /// A line about a machine, with its other fields empty.
    pub fn of_machine(name: &str) -> Result<Self> {
        let emitted = emit(find_machine(name)?, Level::Machine)?;
        Ok(Self::about(name.to_owned(), Some(emitted.verilog_sha256())))
    }

    /// A line about the unit of that name with operands of `bits` bits, with its other fields empty.
    pub fn of_unit(name: &str, bits: u32) -> Result<Self> {
        let mut units = Unit::ALL.into_iter();
        let unit = units.find(|unit| unit.name() == name);
        let unit = unit.with_context(|| format!("there is no unit `{name}`"))?;
        let emitted = emit_unit(unit, bits)?;
        Ok(Self::about(
            unit_name(unit, bits),
            Some(emitted.verilog_sha256()),
        ))
    }

    /// A line about an object without Verilog, with its other fields empty.
    pub fn of_no_verilog(what: String) -> Self {
        Self::about(what, None)
    }

    /// A line about Verilog of that digest, with its other fields empty.
    pub fn about(machine: String, verilog_sha256: Option<String>) -> Self {
        Self {
            machine,
            verilog_sha256,
            method: String::new(),
            by: String::new(),
            volume: 0,
            unit: String::new(),
            result: String::new(),
            command: String::new(),
        }
    }

    /// The key of a line. A new line replaces an earlier one of equal machine, method and tools.
    fn key(&self) -> [&str; 3] {
        [&self.machine, &self.method, &self.by]
    }
}

const COMMITTED: &str = include_str!("../../../docs/measured/verification.json");

/// All recorded lines.
#[derive(Debug, Serialize)]
pub struct Table {
    /// The lines about today's Verilog, sorted by machine and method.
    pub lines: Vec<Line>,
    /// The lines about other Verilog, which are no longer valid.
    pub stale: Vec<Line>,
}

/// The committed table.
pub fn committed() -> Result<Table> {
    let lines = parse(COMMITTED).context("docs/measured/verification.json")?;
    sorted_out(lines)
}

/// Separates the lines about today's Verilog from those about other Verilog.
fn sorted_out(lines: Vec<Line>) -> Result<Table> {
    let today = digests_of_today()?;
    let is_fresh = |line: &Line| today.get(&line.machine) == line.verilog_sha256.as_ref();
    let (lines, stale) = lines.into_iter().partition(is_fresh);
    Ok(Table { lines, stale })
}

/// The digest of every object with Verilog, by its name in a line.
fn digests_of_today() -> Result<BTreeMap<String, String>> {
    let machines = digests::committed()?.into_iter();
    let mut today: BTreeMap<_, _> = machines
        .map(|(name, digests)| (name, digests.verilog_sha256))
        .collect();
    for unit in Unit::ALL {
        for bits in Unit::BITS.into_iter().filter(|&bits| has_unit(unit, bits)) {
            let digest = emit_unit(unit, bits)?.verilog_sha256();
            today.insert(unit_name(unit, bits), digest);
        }
    }
    Ok(today)
}

fn unit_name(unit: Unit, bits: u32) -> String {
    format!("unit {unit}, {bits} bits")
}

/// Parses a table.
pub fn parse(text: &str) -> Result<Vec<Line>> {
    serde_json::from_str(text).context(
        "expected a list of lines as `verify --record` writes; remove the file to start anew",
    )
}

/// Adds lines to the table in a file, which is made if it does not exist.
pub fn record(path: &Path, fresh: &[Line]) -> Result<()> {
    let mut lines = match std::fs::read_to_string(path) {
        Ok(text) => parse(&text).with_context(|| path.display().to_string())?,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Vec::new(),
        Err(error) => {
            return Err(error).with_context(|| format!("cannot read {}", path.display()));
        }
    };
    lines.retain(|line| fresh.iter().all(|new| new.key() != line.key()));
    lines.extend_from_slice(fresh);
    lines.sort();
    let text = serde_json::to_string_pretty(&lines)? + "\n";
    files::write(path, text.as_bytes())
}

/// The table as Markdown.
pub fn table(lines: &[Line]) -> String {
    let header = ["machine", "method", "volume", "result", "by", "command"];
    let row = |line: &Line| {
        vec![
            line.machine.clone(),
            line.method.clone(),
            format!("{} {}", grouped(line.volume), line.unit),
            line.result.clone(),
            line.by.clone(),
            format!("`{}`", line.command),
        ]
    };
    table::markdown(&header, &lines.iter().map(row).collect::<Vec<_>>())
}

/// A number with a comma before every three digits.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    fn line(machine: &str, volume: u64) -> Line {
        Line {
            method: "equivalence".into(),
            by: "icarus 11.0".into(),
            volume,
            unit: "vectors".into(),
            result: "0 mismatches".into(),
            command: "photoncube verify".into(),
            ..Line::about(machine.into(), Some("00".into()))
        }
    }

    #[test]
    fn a_line_replaces_the_one_of_the_same_machine_and_method() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("table.json");
        record(&path, &[line("paper", 1)]).unwrap();
        record(&path, &[line("overlap", 2), line("paper", 3)]).unwrap();
        let lines = parse(&std::fs::read_to_string(&path).unwrap()).unwrap();
        assert_eq!(lines, [line("overlap", 2), line("paper", 3)]);
    }

    #[test]
    fn a_file_that_is_no_table_is_refused_and_kept() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("table.json");
        std::fs::write(&path, "{}").unwrap();
        let error = record(&path, &[line("paper", 1)]).unwrap_err();
        assert!(format!("{error:#}").contains("table.json"), "{error:#}");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "{}");
    }

    #[test]
    fn a_line_about_other_verilog_or_without_a_digest_is_stale() {
        let fresh = [
            Line::of_machine("paper").unwrap(),
            Line::of_unit("add", 6).unwrap(),
            Line::of_no_verilog("reader obj".to_owned()),
        ];
        let mut other = fresh[0].clone();
        other.verilog_sha256 = Some("00".to_owned());
        let mut without = fresh[1].clone();
        without.verilog_sha256 = None;
        let gone = line("pentium", 1);
        let stale = [other, without, gone];
        let table = sorted_out([&fresh[..], &stale].concat()).unwrap();
        assert_eq!(table.lines, fresh);
        assert_eq!(table.stale, stale);
    }

    #[test]
    fn a_line_without_the_key_of_its_digest_is_no_line_about_verilog() {
        let text = COMMITTED.replace("verilog_sha256", "sha256");
        assert!(parse(&text).is_err(), "another key is refused");
    }

    #[test]
    fn no_committed_line_is_stale() {
        let table = committed().unwrap();
        let stale: BTreeSet<_> = table.stale.iter().map(|line| &line.command).collect();
        assert!(
            stale.is_empty(),
            "run these again, with --record: {stale:#?}"
        );
    }

    #[test]
    fn the_docs_have_the_committed_table() {
        let docs = include_str!("../../../docs/verification.md");
        let lines = committed().unwrap().lines;
        assert!(!lines.is_empty());
        assert!(
            docs.contains(&table(&lines)),
            "docs/verification.md has another table than docs/measured/verification.json: put what \
             `photoncube verify --table` prints in its place, under `## Results`"
        );
    }

    #[test]
    fn digits_are_grouped() {
        let grouped = [0, 999, 1000, 1_234_567].map(grouped);
        assert_eq!(grouped, ["0", "999", "1,000", "1,234,567"]);
    }
}
