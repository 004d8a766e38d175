//! The files of shards from which their work is put together.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};

use super::{Header, Parts};

/// A state file.
#[derive(Debug)]
pub struct Input {
    /// Its path.
    pub path: PathBuf,
    /// Its first line.
    pub header: Header,
}

impl Input {
    /// Reads the first line of a file.
    ///
    /// # Errors
    /// It cannot be read, or is no state file.
    pub fn read(path: &Path) -> Result<Self> {
        let said = || path.display().to_string();
        let file = File::open(path).with_context(said)?;
        let header = Header::read(&mut BufReader::new(file)).with_context(said)?;
        let path = path.to_owned();
        Ok(Self { path, header })
    }

    /// What comes behind the first line.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn body(&self) -> Result<BufReader<File>> {
        let said = || self.path.display().to_string();
        let mut file = BufReader::new(File::open(&self.path).with_context(said)?);
        Header::read(&mut file).with_context(said)?;
        Ok(file)
    }
}

/// The files to put together: each shard is in one of them.
#[derive(Debug)]
pub struct Selection {
    /// The files, in the order of their first shards.
    pub inputs: Vec<Input>,
    /// The files all of whose shards are in others too.
    pub twice: Vec<PathBuf>,
    /// The number of jobs of all shards.
    pub jobs: u64,
    /// The shards of the files together.
    pub parts: Parts,
}

impl Selection {
    /// Selects from these files; their order makes no difference. `done` counts the jobs in a file.
    ///
    /// # Errors
    /// A file is no state, or that of other work than the first; a shard is not complete; or two files share a part of their shards. The
    /// error names the file.
    pub fn of(paths: &[PathBuf], done: impl Fn(&Input) -> Result<u64>) -> Result<Self> {
        let inputs = paths.iter().map(|path| Input::read(path));
        let mut inputs = inputs.collect::<Result<Vec<_>>>()?;
        let first = inputs.first().context("expected a file")?;
        let (first_path, first) = (first.path.display().to_string(), first.header.clone());
        for input in &inputs {
            let advice = format!("all files must be of the work of {first_path}");
            first
                .check_same(&input.header, &advice)
                .with_context(|| input.path.display().to_string())?;
        }
        let jobs = first.jobs.with_context(|| {
            format!("{first_path}: found a state without shards, expected one that was written with --shard")
        })?;
        // Larger files first, so that a merged file takes the place of those it was made of.
        inputs.sort_by_key(|input| {
            let has = &input.header.shards.has;
            (std::cmp::Reverse(has.len()), has.first().copied())
        });
        let mut selection = Self {
            inputs: Vec::new(),
            twice: Vec::new(),
            jobs,
            parts: Parts {
                of: first.shards.of,
                has: BTreeSet::new(),
            },
        };
        let mut incomplete = Vec::new();
        for input in inputs {
            let (found, expected) = (done(&input)?, input.header.shards.jobs(jobs));
            match found == expected {
                true => selection.take(input)?,
                false => incomplete.push((input, found, expected)),
            }
        }
        for (input, found, expected) in incomplete {
            let (path, has) = (input.path.display(), &input.header.shards.has);
            ensure!(
                has.is_subset(&selection.parts.has),
                "{path}: shard {} of {} has {found} of {expected} jobs; run its command again, which goes on",
                named(has),
                first.shards.of
            );
            selection.twice.push(input.path);
        }
        selection
            .inputs
            .sort_by_key(|input| input.header.shards.has.first().copied());
        Ok(selection)
    }

    fn take(&mut self, input: Input) -> Result<()> {
        let has = &input.header.shards.has;
        let shared: BTreeSet<_> = has.intersection(&self.parts.has).copied().collect();
        if shared.is_empty() {
            self.parts.has.extend(has);
            self.inputs.push(input);
        } else if shared.len() == has.len() {
            self.twice.push(input.path);
        } else {
            bail!(
                "{}: shards {} are in another file too, and others are not; give files that share all of their shards or none",
                input.path.display(),
                named(&shared)
            );
        }
        Ok(())
    }

    /// Refuses files that lack a shard.
    ///
    /// # Errors
    /// The shards that are not there.
    pub fn check_complete(&self) -> Result<()> {
        let missing = self.parts.missing();
        ensure!(
            missing.is_empty(),
            "shards {} of {} are missing; give their files, or --partial",
            named(&missing.into_iter().collect()),
            self.parts.of
        );
        Ok(())
    }
}

/// The numbers, the first of many.
fn named(shards: &BTreeSet<u64>) -> String {
    const MOST: usize = 20;
    let names = shards.iter().take(MOST).map(u64::to_string);
    let names = names.collect::<Vec<_>>().join(", ");
    match shards.len() {
        count if count > MOST => format!("{names}, ... ({count} of them)"),
        _ => names,
    }
}
