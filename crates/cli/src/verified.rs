//! What was verified, how, and how much of it: the lines of `docs/verification.md`, kept as data in
//! `docs/measured/verification.json`, which `verify --record` writes.

use std::path::Path;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};

use crate::{files, table};

/// One line: what a method found of a machine.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// The machine, or what else was verified.
    pub machine: String,
    /// How, such as `equivalence` or `mutants`.
    pub method: String,
    /// The tools behind it, with their versions.
    pub by: String,
    /// How much of it, in `unit`.
    pub volume: u64,
    /// What `volume` counts.
    pub unit: String,
    /// What was found.
    #[serde(rename = "outcome")]
    pub result: String,
    /// The command that repeats it.
    pub command: String,
}

impl Line {
    /// A line takes the place of an earlier one of the same machine, method and tools.
    fn key(&self) -> [&str; 3] {
        [&self.machine, &self.method, &self.by]
    }
}

const COMMITTED: &str = include_str!("../../../docs/measured/verification.json");

/// All lines.
#[derive(Debug, Serialize)]
pub struct Table {
    /// In order of machine and method.
    pub lines: Vec<Line>,
}

/// The table that is committed.
pub fn committed() -> Result<Table> {
    let lines = parse(COMMITTED).context("docs/measured/verification.json")?;
    Ok(Table { lines })
}

/// Reads a table.
pub fn parse(text: &str) -> Result<Vec<Line>> {
    serde_json::from_str(text).context(
        "expected a list of lines as `verify --record` writes; remove the file to start anew",
    )
}

/// Puts lines into the table of a file, which is made where there is none.
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
    use super::*;

    fn line(machine: &str, volume: u64) -> Line {
        Line {
            machine: machine.into(),
            method: "equivalence".into(),
            by: "icarus 11.0".into(),
            volume,
            unit: "vectors".into(),
            result: "0 mismatches".into(),
            command: "photoncube verify".into(),
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
