//! The verification results: the lines of `docs/measured/verification.md`, stored as data in
//! `docs/measured/verification.json`, which `verify --record` writes.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result, bail};
use photoncube_hdl::{Level, Unit, emit, emit_unit, has_unit};
use photoncube_spec::find_machine;
use serde::{Deserialize, Serialize};

use crate::commands::METHODS;
use crate::table::grouped;
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
    /// The method, by its name in [`METHODS`].
    pub method: String,
    /// The part of the method that the line is about, such as a class of faults; empty for the whole method.
    pub aspect: String,
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
            aspect: String::new(),
            by: String::new(),
            volume: 0,
            unit: String::new(),
            result: String::new(),
            command: String::new(),
        }
    }

    /// The command with a placeholder for the machine, or for the reader.
    fn command_of_any(&self) -> String {
        let machine = format!("--machine {}", self.machine);
        let reader = self.machine.replacen("reader ", "--reader ", 1);
        let command = self.command.replace(&machine, "--machine MACHINE");
        match reader.starts_with("--reader ") {
            true => command.replace(&reader, "--reader NAME"),
            false => command,
        }
    }

    /// The key of a line. A new line replaces an earlier one with an equal key, of whatever version of the tool: the first word of
    /// `by` is the tool.
    fn key(&self) -> [&str; 4] {
        let tool = self.by.split([' ', ':']).next().unwrap_or_default();
        [&self.machine, &self.method, &self.aspect, tool]
    }

    /// The place of the method in [`METHODS`]; `None` where it is none of them.
    fn place(&self) -> Option<usize> {
        METHODS.iter().position(|entry| entry.name == self.method)
    }

    /// The method and its aspect, for people.
    pub fn heading(&self) -> String {
        match self.aspect.as_str() {
            "" => self.method.clone(),
            aspect => format!("{}: {aspect}", self.method),
        }
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
    let expected =
        "expected a list of lines as `verify --record` writes; remove the file to start anew";
    let lines: Vec<Line> = serde_json::from_str(text).context(expected)?;
    if let Some(line) = lines.iter().find(|line| line.place().is_none()) {
        let names = METHODS.map(|entry| entry.name).join(", ");
        bail!(
            "found the method `{}`, expected one of {names}; {expected}",
            line.method
        );
    }
    Ok(lines)
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

/// The results as Markdown: a section for each method and aspect, in the order of [`METHODS`], and in it a table for
/// each command and its tools.
pub fn table(lines: &[Line]) -> String {
    let mut tables: BTreeMap<_, Vec<&Line>> = BTreeMap::new();
    for line in lines {
        let key = (
            line.place(),
            line.heading(),
            &line.by,
            line.command_of_any(),
        );
        tables.entry(key).or_default().push(line);
    }
    let (mut text, mut section) = (String::new(), String::new());
    for ((_, heading, by, command), lines) in tables {
        if heading != section {
            text += &format!("\n## {heading}\n");
            section = heading;
        }
        text += &format!("\n`{command}`, by {by}:\n\n{}", results(&lines));
    }
    text
}

/// The table of lines that one command gave. What does not fit a cell goes on in the next row.
fn results(lines: &[&Line]) -> String {
    let unit = &lines[0].unit;
    let one_unit = lines.iter().all(|line| line.unit == *unit);
    let volume = |line: &Line| match one_unit {
        true => grouped(line.volume),
        false => format!("{} {}", grouped(line.volume), line.unit),
    };
    let names = lines.iter().map(|line| line.machine.len()).max();
    let volumes = lines.iter().map(|line| volume(line).len()).max();
    let taken = names.unwrap_or(0) + volumes.unwrap_or(0) + "|  |  |  |".len();
    let width = RESULT_WIDTH.min(TABLE_WIDTH.saturating_sub(taken));
    let mut rows = Vec::new();
    for line in lines {
        let mut first = vec![line.machine.clone(), volume(line)];
        for part in parts(&with_short_digests(&line.result), width) {
            let mut row = std::mem::replace(&mut first, vec![String::new(); 2]);
            row.push(part);
            rows.push(row);
        }
    }
    let volume = if one_unit { unit } else { "volume" };
    table::markdown(&["machine", volume, "result"], &rows)
}

/// The most characters of a row, and of a result in it.
const TABLE_WIDTH: usize = 120;
const RESULT_WIDTH: usize = 64;

/// A result in pieces of at most `width` characters, broken between words. A longer word stands alone.
fn parts(result: &str, width: usize) -> Vec<String> {
    let mut parts = vec![String::new()];
    for word in result.split(' ') {
        let last = parts.last_mut().expect("there is one from the start");
        let length = last.chars().count() + 1 + word.chars().count();
        match last.as_str() {
            "" => last.push_str(word),
            _ if length <= width => *last += &format!(" {word}"),
            _ => parts.push(word.to_owned()),
        }
    }
    parts
}

/// Words of 64 hexadecimal digits by their first twelve. The data have them whole.
fn with_short_digests(text: &str) -> String {
    let is_digest = |word: &str| word.len() == 64 && word.chars().all(|c| c.is_ascii_hexdigit());
    let short = |word| match is_digest(word) {
        true => format!("{}...", &word[..12]),
        false => word.to_owned(),
    };
    text.split(' ').map(short).collect::<Vec<_>>().join(" ")
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
        let newer = Line {
            by: "icarus 12.0".into(),
            ..line("paper", 4)
        };
        let other_tool = Line {
            by: "verilator 5".into(),
            ..line("paper", 5)
        };
        record(&path, &[newer.clone(), other_tool.clone()]).unwrap();
        let lines = parse(&std::fs::read_to_string(&path).unwrap()).unwrap();
        assert_eq!(lines, [line("overlap", 2), newer, other_tool]);
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
    fn a_method_that_does_not_exist_is_refused_with_those_that_do() {
        let text = COMMITTED.replacen("\"formal\"", "\"formal, by sat\"", 1);
        let error = parse(&text).unwrap_err().to_string();
        assert!(
            error.contains("`formal, by sat`, expected one of equivalence, lint"),
            "{error}"
        );
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
        let docs = include_str!("../../../docs/measured/verification.md");
        let lines = committed().unwrap().lines;
        assert!(!lines.is_empty());
        let table = table(&lines);
        assert!(
            docs.ends_with(&table),
            "docs/measured/verification.md has other results than docs/measured/verification.json: put what \
             `photoncube verify table --wide` prints in place of its sections"
        );
        let sections = |text: &str| text.lines().filter(|line| line.starts_with("## ")).count();
        assert_eq!(sections(docs), sections(&table));
        for row in table.lines().filter(|line| line.starts_with('|')) {
            assert!(row.chars().count() <= TABLE_WIDTH, "{row}");
        }
    }

    #[test]
    fn lines_of_one_command_stand_in_one_table() {
        let of = |machine: &str, aspect: &str| Line {
            aspect: aspect.into(),
            command: format!("photoncube verify --machine {machine} --seed 1"),
            ..line(machine, 1000)
        };
        let mut long = of("overlap", "b");
        long.result = format!("{} {}", "y".repeat(60), "0".repeat(64));
        let reader = Line {
            command: "photoncube verify fuzz 1000 --reader mesh".into(),
            unit: "inputs".into(),
            method: "fuzz".into(),
            ..of("reader mesh", "")
        };
        let lines = [of("paper", "a"), of("overlap", "a"), long, reader];
        let text = table(&lines);
        let wide = "y".repeat(60);
        assert_eq!(
            text,
            format!(
                "
## equivalence: a

`photoncube verify --machine MACHINE --seed 1`, by icarus 11.0:

| machine | vectors | result       |
| ------- | ------- | ------------ |
| paper   | 1,000   | 0 mismatches |
| overlap | 1,000   | 0 mismatches |

## equivalence: b

`photoncube verify --machine MACHINE --seed 1`, by icarus 11.0:

| machine | vectors | result                                                       |
| ------- | ------- | ------------------------------------------------------------ |
| overlap | 1,000   | {wide} |
|         |         | 000000000000...                                              |

## fuzz

`photoncube verify fuzz 1000 --reader NAME`, by icarus 11.0:

| machine     | inputs | result       |
| ----------- | ------ | ------------ |
| reader mesh | 1,000  | 0 mismatches |
"
            )
        );
    }
}
