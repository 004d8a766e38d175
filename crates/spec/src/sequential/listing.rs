//! Parses microprogram listings, the text form that people write and read.
//!
//! ```text
//! query:
//!   0  ldq
//! iteration:
//!   0  ldp
//!   1  ldw
//!   2  sqd
//!   3  add z
//! ```
//! A line has a clock and a step; `#` begins a comment. Two steps may name one clock. Whether the machine can
//! do both is for the schedule checker to decide; the parser accepts them.

use std::fmt;

use thiserror::Error;

use super::microprogram::Microprogram;
use crate::cell::{SEQUENTIAL, ScheduledStep, Step};
use crate::hypercube::Axis;

/// The largest clock that a listing may name. It is far past any useful program and bounds memory.
const MAX_CLOCK: u32 = 4095;

/// A syntax error of a listing, with its line.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("line {line}: found {found}, expected {expected}")]
pub struct ListingError {
    /// The line's number, from 1.
    pub line: usize,
    /// The text at that place.
    pub found: String,
    /// The text that the parser accepts there.
    pub expected: String,
}

/// Parses a listing into a microprogram.
///
/// # Errors
/// The first line that is neither a phase nor a clock and a step.
pub fn parse_listing(text: &str) -> Result<Microprogram, ListingError> {
    let mut program = Microprogram {
        query: Vec::new(),
        iteration: Vec::new(),
    };
    let mut phase = None;
    for (index, line) in text.lines().enumerate() {
        let line_number = index + 1;
        let content = line.split('#').next().unwrap_or_default().trim();
        match (content, phase) {
            ("", _) => {}
            ("query:", _) => phase = Some(Phase::Query),
            ("iteration:", _) => phase = Some(Phase::Iteration),
            (_, None) => return Err(error(line_number, content, "`query:` or `iteration:`")),
            (_, Some(phase)) => {
                let step = parse_step(line_number, content)?;
                match phase {
                    Phase::Query => program.query.push(step),
                    Phase::Iteration => program.iteration.push(step),
                }
            }
        }
    }
    Ok(program)
}

#[derive(Copy, Clone)]
enum Phase {
    Query,
    Iteration,
}

fn parse_step(line: usize, content: &str) -> Result<ScheduledStep, ListingError> {
    let mut words = content.split_whitespace();
    let clock = words.next().unwrap_or_default();
    let clock = clock
        .parse::<u32>()
        .ok()
        .filter(|&clock| clock <= MAX_CLOCK)
        .ok_or_else(|| error(line, clock, &format!("a clock from 0 to {MAX_CLOCK}")))?;
    let mnemonic = words.next().unwrap_or_default();
    let op = SEQUENTIAL.op_named(mnemonic);
    let op = op.ok_or_else(|| error(line, mnemonic, &mnemonics()))?;
    let axis = words.next();
    if let Some(extra) = words.next() {
        return Err(error(line, extra, "the end of the line"));
    }
    let axis = match (SEQUENTIAL.op(op).link.is_some(), axis) {
        (false, None) => None,
        (false, Some(word)) => return Err(error(line, word, "the end of the line")),
        (true, word) => {
            let word = word.unwrap_or_default();
            let axis = Axis::from_name(word);
            Some(axis.ok_or_else(|| error(line, word, "a network axis (x, y, z, w, v, ...)"))?)
        }
    };
    Ok(ScheduledStep {
        clock,
        step: Step { op, axis },
    })
}

fn mnemonics() -> String {
    let names: Vec<_> = SEQUENTIAL.ops.iter().map(|row| row.op.mnemonic()).collect();
    format!("one of {}", names.join(", "))
}

fn error(line: usize, found: &str, expected: &str) -> ListingError {
    let found = match found {
        "" => "the end of the line".to_owned(),
        text => format!("`{text}`"),
    };
    ListingError {
        line,
        found,
        expected: expected.to_owned(),
    }
}

impl fmt::Display for Microprogram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, phase) in [("query", &self.query), ("iteration", &self.iteration)] {
            writeln!(f, "{name}:")?;
            for scheduled in phase {
                let step = scheduled.step.to_string();
                let row = SEQUENTIAL.op(scheduled.step.op);
                let unit = row.unit.map_or("-", |unit| unit.name());
                writeln!(
                    f,
                    "{:>4}  {step:<6}  # {unit:<6}  {}",
                    scheduled.clock, row.formula
                )?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hypercube::Hypercube;
    use proptest::prelude::*;

    #[test]
    fn what_is_printed_is_read_back() {
        for dimension in 4..=10 {
            let program = Microprogram::all_reduce(Hypercube::new(dimension));
            assert_eq!(parse_listing(&program.to_string()), Ok(program));
        }
    }

    #[test]
    fn errors_name_the_line_and_what_was_expected() {
        let cases = [
            ("0 ldp", "line 1: found `0`"),
            ("query:\n 0 ldx", "line 2: found `ldx`, expected one of nop"),
            ("query:\n x ldq", "line 2: found `x`, expected a clock"),
            (
                "query:\n 0 add",
                "line 2: found the end of the line, expected a network axis",
            ),
            (
                "query:\n 0 add k",
                "line 2: found `k`, expected a network axis",
            ),
            ("query:\n 0 ldq x", "line 2: found `x`, expected the end"),
            ("iteration:\n\n 5000 nop", "line 3: found `5000`"),
        ];
        for (text, expected) in cases {
            let message = match parse_listing(text) {
                Err(error) => error.to_string(),
                Ok(program) => panic!("{text:?} was read as {program}"),
            };
            let start: String = message.chars().take(expected.len()).collect();
            let expected = expected.replace("found `0`", "found `0 ldp`");
            assert!(message.starts_with(&expected), "{start} / {message}");
        }
    }

    proptest! {
        #[test]
        fn no_text_makes_the_parser_panic(text in "(query:|iteration:|[0-9]{1,5}| |\n|#|add|ldp|[a-z])*") {
            let _ = parse_listing(&text);
        }
    }
}
