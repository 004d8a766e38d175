//! The first line of a state file.

use std::collections::{BTreeMap, BTreeSet};
use std::io::BufRead;

use anyhow::{Context, Result, bail, ensure};
use serde::{Deserialize, Serialize};

use super::Parts;

/// The version of the format of all state files. It changes with them.
const FORMAT: u32 = 4;

/// The longest first line that is read: that of a million shards takes 7 MB.
const LONGEST: u64 = 1 << 24;

/// All that two runs must have in common so that the results of one are those of the other, by the names of the options, as text.
pub type Settings = BTreeMap<String, String>;

/// The first line of a state file: what it is the state of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Header {
    /// The command whose state it is.
    pub photoncube: String,
    /// The format of the file.
    format: u32,
    /// The settings of the work.
    pub settings: Settings,
    /// The number of jobs of all shards; `None` where there is no last one.
    pub jobs: Option<u64>,
    /// The shards in the file.
    pub shards: Parts,
}

impl Header {
    /// The header of a state of `work`, a command. The version of the program is one of the settings.
    pub fn new(
        work: &str,
        settings: Settings,
        jobs: Option<u64>,
        shards: impl Into<Parts>,
    ) -> Self {
        let version = ("photoncube version", env!("CARGO_PKG_VERSION"));
        let version = [version].map(|(name, value)| (name.to_owned(), value.to_owned()));
        Self {
            photoncube: work.to_owned(),
            format: FORMAT,
            settings: settings.into_iter().chain(version).collect(),
            jobs,
            shards: shards.into(),
        }
    }

    /// The header of the same work with other shards, and with that number of jobs.
    pub fn with(&self, jobs: Option<u64>, shards: Parts) -> Self {
        Self {
            jobs,
            shards,
            ..self.clone()
        }
    }

    /// The line, with its end.
    pub fn line(&self) -> Vec<u8> {
        let mut line = serde_json::to_vec(self).expect("texts and numbers can be written");
        line.push(b'\n');
        line
    }

    /// Reads the first line of a file.
    ///
    /// # Errors
    /// It is not the first line of a state file, or that of another format.
    pub fn read(file: &mut impl BufRead) -> Result<Self> {
        let mut line = Vec::new();
        let mut start = std::io::Read::take(&mut *file, LONGEST);
        start.read_until(b'\n', &mut line)?;
        let expected = "expected a state file of photoncube";
        let begins = String::from_utf8_lossy(&line[..line.len().min(40)]).into_owned();
        let found = || {
            format!(
                "found a file that begins with {:?}, {expected}",
                begins.trim_end()
            )
        };
        ensure!(line.ends_with(b"\n"), found());
        let json: serde_json::Value = serde_json::from_slice(&line).with_context(found)?;
        let format = json.get("format").with_context(found)?;
        ensure!(
            *format == FORMAT,
            "found a state file of format {format}, expected {FORMAT}: another version of photoncube wrote it"
        );
        let header: Self = serde_json::from_value(json).with_context(found)?;
        let Parts { of, has } = &header.shards;
        let all = has.iter().all(|index| (1..=*of).contains(index));
        ensure!(all && !has.is_empty() && *of <= super::shard::MOST, found());
        Ok(header)
    }

    /// Refuses a file whose header is not this one, but for the shards in it.
    ///
    /// # Errors
    /// All that differs, with the values of both. `advice` says what to do.
    pub fn check_same(&self, found: &Self, advice: &str) -> Result<()> {
        if found.photoncube != self.photoncube {
            let (found, expected) = (&found.photoncube, &self.photoncube);
            bail!("found a state of `{found}`, expected one of `{expected}`");
        }
        let [found, expected] = [found, self].map(Self::compared);
        let names: BTreeSet<_> = found.keys().chain(expected.keys()).collect();
        let of = |settings: &Settings, name: &str| {
            settings
                .get(name)
                .map_or("none".to_owned(), ToOwned::to_owned)
        };
        let differs = |name: &&&String| found.get(**name) != expected.get(**name);
        let differing = names.iter().filter(differs).map(|name| {
            let (found, expected) = (of(&found, name), of(&expected, name));
            format!("{name}: found {found}, expected {expected}")
        });
        let differing: Vec<_> = differing.collect();
        ensure!(
            differing.is_empty(),
            "the state is that of other work: {}; {advice}",
            differing.join("; ")
        );
        Ok(())
    }

    /// The settings, and the numbers of jobs and shards, as text.
    fn compared(&self) -> Settings {
        let jobs = self
            .jobs
            .map_or("as many as wanted".to_owned(), |jobs| jobs.to_string());
        let more = [
            ("number of jobs", jobs),
            ("number of shards", self.shards.of.to_string()),
        ];
        let more = more.map(|(name, value)| (name.to_owned(), value));
        self.settings.clone().into_iter().chain(more).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::Shard;
    use super::*;

    fn header(seed: &str, jobs: u64) -> Header {
        let settings = Settings::from([("--seed".to_owned(), seed.to_owned())]);
        Header::new("campaign", settings, Some(jobs), Shard::WHOLE)
    }

    #[test]
    fn a_header_is_read_as_it_is_written_and_the_rest_stays() {
        let written = header("1", 5);
        let file = [written.line(), b"rest".to_vec()].concat();
        let mut file = file.as_slice();
        assert_eq!(Header::read(&mut file).unwrap(), written);
        assert_eq!(file, b"rest");
    }

    #[test]
    fn another_first_line_is_refused() {
        let newer = String::from_utf8(header("1", 5).line()).unwrap();
        let newer = newer.replace("\"format\":4", "\"format\":5");
        for (text, expected) in [
            (
                "# a listing\n",
                "begins with \"# a listing\", expected a state file",
            ),
            ("{}\n", "begins with \"{}\""),
            ("", "begins with \"\""),
            (newer.as_str(), "found a state file of format 5, expected 4"),
        ] {
            let said = Header::read(&mut text.as_bytes()).unwrap_err().to_string();
            assert!(said.contains(expected), "{said}");
        }
    }

    #[test]
    fn other_work_is_refused_with_all_that_differs() {
        let said = header("1", 5)
            .check_same(&header("2", 6), "give its options")
            .unwrap_err();
        assert_eq!(
            said.to_string(),
            "the state is that of other work: --seed: found 2, expected 1; number of jobs: found 6, expected 5; give its \
             options"
        );
        let other = Header::new("synth", Settings::new(), None, Shard::WHOLE);
        let said = header("1", 5)
            .check_same(&other, "")
            .unwrap_err()
            .to_string();
        assert_eq!(said, "found a state of `synth`, expected one of `campaign`");
        assert!(header("1", 5).check_same(&header("1", 5), "").is_ok());
    }
}
