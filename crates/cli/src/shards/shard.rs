//! A shard, and its argument.

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

use clap::Args;

/// One of several shards of the same work. On the command line `2/7`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// From 1 to `of`.
    pub index: u64,
    /// The number of shards, at most [`MOST`].
    pub of: u64,
}

/// The most shards. The header of a file has a number for each shard in it.
pub const MOST: u64 = 1_000_000;

impl Shard {
    /// The whole work.
    pub const WHOLE: Self = Self { index: 1, of: 1 };

    /// The jobs of the shard among `jobs` jobs, which are numbered from 0.
    pub fn jobs(self, jobs: u64) -> impl Iterator<Item = u64> {
        (self.index - 1..jobs).step_by(self.of as usize)
    }

    /// The number of these jobs.
    pub fn number_of_jobs(self, jobs: u64) -> u64 {
        jobs.saturating_sub(self.index - 1).div_ceil(self.of)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(index, of)| {
            let numbers = [index, of].map(|text| text.parse().ok());
            Some((numbers[0]?, numbers[1]?))
        });
        match numbers {
            Some((index, of)) if of <= MOST && (1..=of).contains(&index) => Ok(Self { index, of }),
            _ => Err(format!(
                "expected I/N, shard I of N, with I from 1 to N and N at most {MOST}: 2/7"
            )),
        }
    }
}

/// The arguments of a command whose jobs can be shared out.
#[derive(Args, Clone, Debug)]
pub struct ShardArgs {
    /// Do only the jobs of shard I of N, and keep their results in the file of --state; `photoncube merge` puts the files of all shards
    /// together
    #[arg(long, value_name = "I/N", requires = "state")]
    pub shard: Option<Shard>,
    /// Keep each result in this file, and begin with those that it has: a command that was killed goes on where it was
    #[arg(long, value_name = "FILE")]
    pub state: Option<PathBuf>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_are_read_as_they_are_written_and_others_are_refused() {
        for text in ["1/1", "2/7", "7/7"] {
            assert_eq!(text.parse::<Shard>().unwrap().to_string(), text);
        }
        for text in [
            "0/2",
            "3/2",
            "1/0",
            "1",
            "1/2/3",
            "-1/2",
            "1/1000001",
            "a/b",
        ] {
            assert!(text.parse::<Shard>().unwrap_err().contains("I/N"), "{text}");
        }
    }

    #[test]
    fn the_shards_have_each_job_once() {
        for of in [1, 2, 7] {
            let shards = (1..=of).map(|index| Shard { index, of });
            let counted: u64 = shards.clone().map(|shard| shard.number_of_jobs(23)).sum();
            assert_eq!(counted, 23);
            let mut jobs: Vec<_> = shards.flat_map(|shard| shard.jobs(23)).collect();
            jobs.sort_unstable();
            assert_eq!(jobs, Vec::from_iter(0..23));
        }
    }
}
