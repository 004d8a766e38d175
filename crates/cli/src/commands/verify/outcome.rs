//! The one shape of what a method of verification found.

use anyhow::{Result, bail};
use photoncube_testbench::{Controls, VerifyError};
use serde::Serialize;
use serde_json::Value;

use super::method::Method;
use super::waves::Written;
use crate::failure::CheckFailed;
use crate::table;
use crate::verified::Line;

/// The outcome of a method. It cannot be made without the faults that the method planted.
#[derive(Debug, Serialize)]
pub struct Outcome {
    method: &'static str,
    controls: Controls,
    /// Defects of the subject, each with the command that repeats it. Any finding fails the run.
    findings: Vec<String>,
    /// The keys of the report that only this method has.
    #[serde(flatten)]
    details: Value,
    /// The verified subjects, each with digest, volume and outcome.
    lines: Vec<Line>,
    #[serde(skip)]
    text: String,
}

impl Outcome {
    /// The outcome of a method whose details are an object.
    ///
    /// # Errors
    /// The details cannot be written as JSON.
    pub fn new<M: Method>(controls: Controls, details: &impl Serialize) -> Result<Self> {
        Ok(Self {
            method: M::NAME,
            controls,
            findings: Vec::new(),
            details: serde_json::to_value(details)?,
            lines: Vec::new(),
            text: String::new(),
        })
    }

    /// Adds a table to the text.
    pub fn table(mut self, table: &str) -> Self {
        if !table.is_empty() {
            self.text += table;
            self.text.push('\n');
        }
        self
    }

    /// Adds the rows of the details under `key`, with these keys of theirs as columns.
    pub fn rows(self, key: &str, columns: &str) -> Self {
        self.rows_where(key, columns, |_| true)
    }

    /// Adds those rows of the details under `key` for which `is_told` holds.
    pub fn rows_where(self, key: &str, columns: &str, is_told: impl Fn(&Value) -> bool) -> Self {
        let rows = self.details[key].as_array().into_iter().flatten();
        let table = table::of_rows(rows.filter(|row| is_told(row)), columns);
        self.table(&table)
    }

    /// Adds a line to the text.
    pub fn note(mut self, note: impl AsRef<str>) -> Self {
        self.text += note.as_ref();
        self.text.push('\n');
        self
    }

    /// Adds the files of a waveform, where one was written.
    pub fn waves(self, written: Option<&Written>) -> Self {
        match written {
            None => self,
            Some(written) => self.note(written.text()),
        }
    }

    /// Adds what was verified.
    pub fn lines(mut self, lines: impl IntoIterator<Item = Line>) -> Self {
        self.lines.extend(lines.into_iter().map(|line| Line {
            method: self.method.to_owned(),
            ..line
        }));
        self
    }

    /// Adds what is wrong.
    pub fn findings(mut self, findings: impl IntoIterator<Item = String>) -> Self {
        self.findings.extend(findings);
        self
    }

    /// The outcome for people.
    pub fn text(&self) -> String {
        let (all, missed) = (self.controls.count(), self.controls.missed().count());
        format!(
            "{}{} of {all} planted faults found; {} findings\n",
            self.text,
            all - missed,
            self.findings.len()
        )
    }

    /// The lines for a table of results.
    pub fn recorded(&self) -> &[Line] {
        &self.lines
    }

    /// Whether the run passes.
    ///
    /// # Errors
    /// It has findings, it did not find a planted fault, or nothing was verified.
    pub fn conclusion(&self) -> Result<()> {
        let missed = self.controls.missed().map(|control| {
            format!(
                "the method is wrong: it did not find the planted fault: {}",
                control.planted
            )
        });
        let wrong: Vec<_> = self.findings.iter().cloned().chain(missed).collect();
        if !wrong.is_empty() {
            bail!(CheckFailed(wrong.join("\n")));
        }
        match self.lines.iter().find(|line| line.volume == 0) {
            Some(line) => bail!(CheckFailed(format!(
                "nothing was verified of {}: 0 {}",
                line.machine, line.unit
            ))),
            None if self.lines.is_empty() => {
                bail!(CheckFailed("nothing was verified".to_owned()))
            }
            None => Ok(()),
        }
    }
}

/// The verdict of a verification that has nothing more to report after a difference.
///
/// # Errors
/// The difference, as a check that failed; or the verification did not run.
pub fn equal<T>(ended: Result<T, VerifyError>) -> Result<T> {
    match ended {
        Err(error @ VerifyError::Diverged(_)) => bail!(CheckFailed(error.to_string())),
        ended => Ok(ended?),
    }
}

/// The verdicts of several verifications, up to the first difference.
#[derive(Debug)]
pub struct UpToDifference<V> {
    pub verdicts: Vec<V>,
    pub vectors_compared: u64,
    pub difference: Option<String>,
    vectors: fn(&V) -> u64,
}

impl<V> UpToDifference<V> {
    /// No verdict yet. `vectors` says how many vectors a verdict is about.
    pub fn new(vectors: fn(&V) -> u64) -> Self {
        Self {
            verdicts: Vec::new(),
            vectors_compared: 0,
            difference: None,
            vectors,
        }
    }

    /// Adds the verdict, or the difference in `what`. Returns whether there was none.
    ///
    /// # Errors
    /// The verification did not run.
    pub fn add(&mut self, what: &str, ended: Result<V, VerifyError>) -> Result<bool> {
        let difference = match ended {
            Ok(verdict) => {
                self.vectors_compared += (self.vectors)(&verdict);
                self.verdicts.push(verdict);
                return Ok(true);
            }
            Err(VerifyError::Diverged(difference)) => {
                self.vectors_compared += difference.vectors_compared + 1;
                difference.to_string()
            }
            Err(VerifyError::Unknown(difference)) => difference.to_string(),
            Err(error) => return Err(error.into()),
        };
        self.difference = Some(format!("{what}: {difference}"));
        Ok(false)
    }

    /// 1 where a difference was found: the first ends the verification.
    pub fn mismatches(&self) -> u64 {
        u64::from(self.difference.is_some())
    }
}

#[cfg(test)]
mod tests {
    use std::process::ExitCode;

    use photoncube_testbench::Control;

    use super::super::Lint;
    use super::*;
    use crate::failure::exit_code;

    fn outcome(found: bool) -> Outcome {
        let planted = "a lost carry".to_owned();
        let controls = Controls::new(Control { planted, found }, []);
        Outcome::new::<Lint>(
            controls,
            &serde_json::json!({ "machine": "paper", "blocks": [{ "block": "cell" }] }),
        )
        .unwrap()
    }

    fn line(volume: u64) -> Line {
        Line {
            volume,
            unit: "blocks".to_owned(),
            ..Line::of_no_verilog("paper".to_owned())
        }
    }

    #[test]
    fn a_finding_a_missed_control_and_nothing_verified_fail() {
        let sound = || outcome(true).lines([line(3)]);
        sound().conclusion().unwrap();
        for (outcome, expected) in [
            (sound().findings(["it differs".to_owned()]), "it differs"),
            (
                outcome(false).lines([line(3)]),
                "planted fault: a lost carry",
            ),
            (
                sound().lines([line(0)]),
                "nothing was verified of paper: 0 blocks",
            ),
            (outcome(true), "nothing was verified"),
        ] {
            let error = outcome.conclusion().unwrap_err();
            assert_eq!(exit_code(&error), ExitCode::from(1));
            assert!(error.to_string().contains(expected), "{error}");
        }
    }

    #[test]
    fn every_outcome_has_one_shape() {
        let outcome = outcome(true)
            .rows("blocks", "block")
            .rows_where("blocks", "block", |_| false)
            .lines([line(3)]);
        let json = serde_json::to_value(&outcome).unwrap();
        assert_eq!(json["method"], "lint");
        assert_eq!(json["machine"], "paper");
        assert_eq!(json["controls"][0]["control_found"], true);
        assert_eq!(json["lines"][0]["method"], "lint");
        assert_eq!(
            outcome.text(),
            "| block |\n| ----- |\n| cell  |\n\n1 of 1 planted faults found; 0 findings\n"
        );
    }
}
