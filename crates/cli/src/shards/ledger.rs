//! The state file of jobs: a line of JSON for each that is done.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::{iter, thread};

use anyhow::{Context, Result, ensure};
use indicatif::ProgressBar;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::{Header, Input};
use crate::files;

/// The line of a job.
#[derive(Serialize, Deserialize)]
struct Line<T> {
    job: u64,
    result: T,
}

/// The number in the line of a job.
#[derive(Deserialize)]
struct Numbered {
    job: u64,
}

/// The results of a shard's jobs. Each is on the disk before the next job of its thread begins, so a worker that is killed loses only the
/// jobs that are under way. When all are done, they are in the order of their numbers.
pub struct Ledger<T> {
    header: Header,
    /// The number of jobs of all shards.
    jobs: u64,
    file: Option<(PathBuf, File)>,
    done: BTreeMap<u64, T>,
    /// The lines of the jobs that are done, where there is a file.
    lines: BTreeMap<u64, Vec<u8>>,
}

impl<T: Serialize + DeserializeOwned + Send> Ledger<T> {
    /// Opens the file of a state, or begins it where there is none. Without a path the results are kept in memory alone.
    ///
    /// # Errors
    /// The file is no state, or that of other work; another process has it open; or it cannot be read or written.
    pub fn open(path: Option<&Path>, header: Header) -> Result<Self> {
        let jobs = header.jobs.context("a ledger has a number of jobs")?;
        let mut ledger = Self {
            header,
            jobs,
            file: None,
            done: BTreeMap::new(),
            lines: BTreeMap::new(),
        };
        if let Some(path) = path {
            let said = || format!("--state {}", path.display());
            ledger.file = Some((path.to_owned(), ledger.open_file(path).with_context(said)?));
        }
        Ok(ledger)
    }

    fn open_file(&mut self, path: &Path) -> Result<File> {
        if !path.exists() {
            files::write(path, &self.header.line())?;
        }
        let file = OpenOptions::new().read(true).append(true).open(path)?;
        match file.try_lock() {
            Err(TryLockError::WouldBlock) => {
                anyhow::bail!(
                    "another process has the file open; give each shard a file of its own"
                )
            }
            other => other.map_err(std::io::Error::from)?,
        }
        let mut reader = BufReader::new(&file);
        let found = Header::read(&mut reader)?;
        self.header
            .check_same(&found, "give its options, or another --state")?;
        ensure!(
            found.shards == self.header.shards,
            "found shards {:?} of {}, expected {:?}; give another --state",
            found.shards.has,
            found.shards.of,
            self.header.shards.has
        );
        let mut whole = self.header.line().len() as u64;
        for (number, line) in (2..).zip(lines(reader)) {
            let line = line?;
            let parsed = serde_json::from_slice::<Line<T>>(&line).ok();
            let parsed = parsed.filter(|parsed| self.has(parsed.job));
            let parsed = parsed.with_context(|| {
                format!(
                    "line {number} is not that of a job of the shard; remove the file to begin anew"
                )
            })?;
            whole += line.len() as u64;
            self.done.insert(parsed.job, parsed.result);
            self.lines.insert(parsed.job, line);
        }
        // A worker that was killed while it wrote leaves half a line.
        file.set_len(whole)?;
        Ok(file)
    }

    /// Whether a job is one of the file's shards.
    fn has(&self, job: u64) -> bool {
        let shards = &self.header.shards;
        job < self.jobs && shards.has.contains(&(job % shards.of + 1))
    }

    /// The results of the jobs that are done, by number.
    pub fn done(&self) -> &BTreeMap<u64, T> {
        &self.done
    }

    /// The jobs of the shards of the file that are not done.
    pub fn to_do(&self) -> Vec<u64> {
        let all = self.header.shards.shards();
        let jobs = all.flat_map(|shard| shard.jobs(self.jobs));
        jobs.filter(|job| !self.done.contains_key(job)).collect()
    }

    /// Does all jobs that are not done, `workers` at a time and in the order of `key`, and returns the results of all by number.
    ///
    /// # Errors
    /// The first error of a job or of writing. What was done before is kept.
    pub fn work(
        self,
        workers: usize,
        bar: &ProgressBar,
        key: impl Fn(&u64) -> u64,
        run: impl Fn(u64) -> Result<T> + Sync,
    ) -> Result<BTreeMap<u64, T>> {
        let mut to_do = self.to_do();
        to_do.sort_by_key(key);
        bar.set_length((self.done.len() + to_do.len()) as u64);
        bar.set_position(self.done.len() as u64);
        let next = Mutex::new(to_do.into_iter());
        let shared = Mutex::new((self, None));
        let lock = || shared.lock().unwrap_or_else(PoisonError::into_inner);
        let take = || {
            let mut next = next.lock().unwrap_or_else(PoisonError::into_inner);
            lock().1.is_none().then(|| next.next()).flatten()
        };
        thread::scope(|scope| {
            for _ in 0..workers.max(1) {
                scope.spawn(|| {
                    for job in iter::from_fn(take) {
                        let result = run(job);
                        let (ledger, error) = &mut *lock();
                        match result.and_then(|result| ledger.record(job, result)) {
                            Ok(()) => bar.inc(1),
                            Err(found) => drop(error.get_or_insert(found)),
                        }
                    }
                });
            }
        });
        bar.finish_and_clear();
        let (ledger, error) = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
        error.map_or_else(|| ledger.finish(), Err)
    }

    /// Keeps the result of a job.
    fn record(&mut self, job: u64, result: T) -> Result<()> {
        if let Some((path, file)) = &mut self.file {
            let line = line(job, &result);
            let written = file.write_all(&line).and_then(|()| file.sync_data());
            written.map_err(|error| files::cannot_write(path, &error))?;
            self.lines.insert(job, line);
        }
        self.done.insert(job, result);
        Ok(())
    }

    /// Writes the lines in the order of their numbers.
    fn finish(self) -> Result<BTreeMap<u64, T>> {
        if let Some((path, _)) = &self.file {
            let lines = iter::once(self.header.line()).chain(self.lines.into_values());
            files::write(path, &lines.flatten().collect::<Vec<_>>())?;
        }
        Ok(self.done)
    }
}

fn line<T: Serialize>(job: u64, result: &T) -> Vec<u8> {
    let mut line = serde_json::to_vec(&Line { job, result }).expect("results can be written");
    line.push(b'\n');
    line
}

/// The number of jobs in a file.
///
/// # Errors
/// It cannot be read.
pub fn jobs_in(input: &Input) -> Result<u64> {
    let mut lines = lines(input.body()?);
    lines.try_fold(0, |count, line| Ok(line.map(|_| count + 1)?))
}

/// The lines of a file, each with its end. Half a line at the end is left out.
fn lines(mut file: impl BufRead) -> impl Iterator<Item = std::io::Result<Vec<u8>>> {
    iter::from_fn(move || {
        let mut line = Vec::new();
        match file.read_until(b'\n', &mut line) {
            Ok(_) if line.ends_with(b"\n") => Some(Ok(line)),
            Ok(_) => None,
            Err(error) => Some(Err(error)),
        }
    })
}

/// Writes the lines of all jobs of these files, in the order of their numbers. It takes memory for a line of each.
///
/// # Errors
/// A file cannot be read, or does not have its jobs in their order.
pub fn merge_lines(inputs: &[Input], jobs: u64, to: &mut impl Write) -> Result<()> {
    let mut files = Vec::new();
    let mut owners = BTreeMap::new();
    for (number, input) in inputs.iter().enumerate() {
        files.push(lines(input.body()?));
        owners.extend(
            input
                .header
                .shards
                .has
                .iter()
                .map(|&index| (index - 1, number)),
        );
    }
    let of = inputs.first().context("there is a file")?.header.shards.of;
    let mut to = BufWriter::new(to);
    for job in 0..jobs {
        let Some(&owner) = owners.get(&(job % of)) else {
            continue;
        };
        let path = inputs[owner].path.display();
        let line = files[owner]
            .next()
            .with_context(|| format!("{path}: job {job} is not there"))??;
        let found: Numbered = serde_json::from_slice(&line).with_context(|| format!("{path}"))?;
        ensure!(
            found.job == job,
            "{path}: found job {}, expected {job}; run the command of the shard again, which puts its jobs in order",
            found.job
        );
        to.write_all(&line)?;
    }
    to.flush()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::atomic::{AtomicU64, Ordering};

    use super::super::{Settings, Shard};
    use super::*;

    fn header(shard: &str) -> Header {
        Header::new(
            "test",
            Settings::new(),
            Some(9),
            shard.parse::<Shard>().unwrap(),
        )
    }

    fn work(
        path: &Path,
        shard: &str,
        run: impl Fn(u64) -> Result<String> + Sync,
    ) -> Result<BTreeMap<u64, String>> {
        let ledger = Ledger::open(Some(path), header(shard))?;
        ledger.work(2, &ProgressBar::hidden(), |&job| job, run)
    }

    #[test]
    fn a_shard_that_fails_or_is_killed_goes_on_with_what_it_has() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state");
        let failing = |job| match job {
            6 => anyhow::bail!("it fails"),
            job => Ok(format!("{job}\n")),
        };
        assert_eq!(
            work(&path, "1/3", failing).unwrap_err().to_string(),
            "it fails"
        );
        // Half a line, as of a worker that was killed.
        let kept = fs::read(&path).unwrap();
        fs::write(&path, [&kept[..], b"{\"job\":6,\"resu"].concat()).unwrap();
        let runs = AtomicU64::new(0);
        let done = work(&path, "1/3", |job| {
            runs.fetch_add(1, Ordering::Relaxed);
            Ok(format!("{job}\n"))
        });
        let jobs = [0, 3, 6];
        assert_eq!(
            done.unwrap(),
            jobs.map(|job| (job, format!("{job}\n"))).into()
        );
        assert_eq!(runs.into_inner(), 1);
        let text = fs::read_to_string(&path).unwrap();
        let found: Vec<_> = text.lines().skip(1).collect();
        let expected = jobs.map(|job| format!("{{\"job\":{job},\"result\":\"{job}\\n\"}}"));
        assert_eq!(found, expected);
        // There is nothing left to do.
        work(&path, "1/3", |job| anyhow::bail!("{job}")).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), text);
    }

    #[test]
    fn a_file_of_another_shard_or_open_elsewhere_or_damaged_is_refused_and_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("state");
        let run = |job: u64| Ok(job.to_string());
        work(&path, "1/3", run).unwrap();
        let kept = fs::read(&path).unwrap();
        let said = |shard| format!("{:#}", work(&path, shard, run).unwrap_err());
        assert!(
            said("2/3").contains("found shards {1} of 3, expected {2}"),
            "{}",
            said("2/3")
        );
        assert!(said("1/2").contains("number of shards: found 3, expected 2"));
        let open = Ledger::<String>::open(Some(&path), header("1/3")).unwrap();
        assert!(said("1/3").contains("another process has the file open"));
        drop(open);
        assert_eq!(fs::read(&path).unwrap(), kept);
        // A line that is none, a job of another shard, and one that no shard has.
        for line in [
            "a line",
            r#"{"job":1,"result":"1"}"#,
            r#"{"job":9,"result":"9"}"#,
        ] {
            fs::write(&path, [&kept[..], line.as_bytes(), b"\n"].concat()).unwrap();
            let said = said("1/3");
            assert!(
                said.contains("line 5 is not that of a job of the shard"),
                "{said}"
            );
        }
    }
}
