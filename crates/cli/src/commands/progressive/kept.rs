//! The file of `--state`: what a progressive picture is after some passes, from which `--resume` goes on, or what a shard has made of
//! it.
//!
//! The file has the header of a state file, the state in the format of the crate `postcard`, and SHA-256 of all of this. The state has
//! the exact sums, so nothing is rounded.

use std::fs;
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use photoncube_render::{Balance, Engine, Image, Lighting, ProgressiveState, RadiusRule, Scene};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::Row;
use crate::args::{EngineReport, LightingReport, ProgressiveArgs};
use crate::files;
use crate::shards::{Header, Input, Selection, Settings};

const DAMAGED: &str =
    "found a file that is damaged or not whole, expected one as `progressive --state` wrote it";

/// The bytes of SHA-256.
const DIGEST_BYTES: usize = 32;

/// The settings of a picture.
pub fn settings(
    args: &ProgressiveArgs,
    scene: &Scene,
    engine: Engine<'_>,
    lighting: &Lighting,
    balance: &Balance,
    rule: RadiusRule,
) -> Settings {
    let own = [
        ("scene, its SHA-256", scene.sha256()),
        ("--photons", balance.photons.to_string()),
        ("--in-range", args.in_range.to_string()),
        ("--alpha", args.alpha.to_string()),
        ("--radius-rule", rule.to_string()),
        ("--size", args.size.to_string()),
        ("--samples", balance.samples_per_axis.to_string()),
        ("--seed", args.seed.to_string()),
    ];
    let own = own.map(|(name, value)| (name.to_owned(), value));
    let (engine, lighting) = (EngineReport::of(engine), LightingReport::of(lighting));
    let reports = [serde_json::json!(engine), serde_json::json!(lighting)];
    let reported = reports.iter().filter_map(|report| report.as_object());
    let options = reported.flatten().filter(|(_, value)| !value.is_null());
    let option = |(key, value): (&String, &serde_json::Value)| {
        let value = value.as_str().map_or(value.to_string(), ToOwned::to_owned);
        (format!("--{}", key.replace('_', "-")), value)
    };
    own.into_iter().chain(options.map(option)).collect()
}

/// SHA-256 of the size and the pixels of a picture.
pub fn sha256_of_image(image: &Image) -> Vec<u8> {
    let mut hasher = Sha256::new();
    hasher.update(image.width().to_le_bytes());
    let numbers = image.pixels().iter().flat_map(|pixel| pixel.to_array());
    numbers.for_each(|number| hasher.update(number.to_le_bytes()));
    hasher.finalize().to_vec()
}

/// What is kept.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Kept<'a> {
    /// The state of the picture.
    pub state: ProgressiveState<'a>,
    /// The rows of the table.
    pub rows: Vec<Row>,
    /// The digest of the reference that the rows compare with; `None` without a reference.
    pub reference: Option<Vec<u8>>,
    /// The time of all passes.
    pub seconds: f64,
}

impl Kept<'_> {
    /// The rows after 1, 2, 4, 8, ... passes but that of the state itself, which is made anew. Distances from another
    /// reference are left out.
    pub fn rows_for(&self, reference: Option<&Image>) -> Vec<Row> {
        let is_same = self.reference == reference.map(sha256_of_image);
        let rows = self.rows.iter();
        let rows =
            rows.filter(|row| row.passes.is_power_of_two() && row.passes < self.state.passes());
        let row = |row: &Row| match is_same {
            true => row.clone(),
            false => Row {
                rel_mse: None,
                bounded_share: None,
                ..row.clone()
            },
        };
        rows.map(row).collect()
    }
}

/// Keeps the state of a picture in a file.
pub struct Keeper {
    path: PathBuf,
    header: Header,
}

impl Keeper {
    /// Keeps the state of that header in that file.
    pub fn new(path: PathBuf, header: Header) -> Self {
        Self { path, header }
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Refuses a file that exists: it may have the passes of hours.
    pub fn check_new(&self) -> Result<()> {
        ensure!(
            !self.path.exists(),
            "--state {}: found a file, expected none without --resume; give --resume to go on from it, or remove it",
            self.path.display()
        );
        Ok(())
    }

    /// Writes the file.
    pub fn write(&self, kept: &Kept<'_>) -> Result<()> {
        write(&self.path, &self.header, kept)
    }

    /// Reads the file.
    ///
    /// # Errors
    /// It cannot be read, is no whole state, or is that of another picture.
    pub fn read(&self) -> Result<Kept<'static>> {
        let said = || format!("--state {}", self.path.display());
        let bytes = fs::read(&self.path).with_context(|| {
            format!(
                "{}: cannot be read; leave out --resume to begin a new picture",
                said()
            )
        })?;
        let read = || {
            let mut rest = bytes.as_slice();
            let found = Header::read(&mut rest)?;
            let advice = "give the options of the run that began it";
            self.header.check_same(&found, advice)?;
            ensure!(
                found.shards == self.header.shards,
                "found shards {:?}, expected {:?}",
                found.shards.has,
                self.header.shards.has
            );
            kept_in(&bytes, rest)
        };
        read().with_context(said)
    }
}

/// Writes a file, part by part: the state of a large picture is in memory once.
fn write(path: &Path, header: &Header, kept: &Kept<'_>) -> Result<()> {
    files::write_with(path, |file| put(file, header, kept).map(drop))
}

/// Puts header, state and digest into `to`.
fn put<W: Write>(to: W, header: &Header, kept: &Kept<'_>) -> Result<W> {
    let mut hashed = Hashed {
        to: BufWriter::new(to),
        hasher: Sha256::new(),
    };
    hashed.write_all(&header.line())?;
    postcard::to_io(kept, &mut hashed)?;
    let Hashed { mut to, hasher } = hashed;
    to.write_all(&hasher.finalize())?;
    Ok(to.into_inner().map_err(io::IntoInnerError::into_error)?)
}

/// A writer that digests what it writes.
struct Hashed<W: Write> {
    to: BufWriter<W>,
    hasher: Sha256,
}

impl<W: Write> Write for Hashed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.to.write(bytes)?;
        self.hasher.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

/// What is kept in a file: `bytes`, all of it, of which `body` comes behind the header.
///
/// # Errors
/// The file is damaged, or not whole.
fn kept_in(bytes: &[u8], body: &[u8]) -> Result<Kept<'static>> {
    let body_bytes = body.len().checked_sub(DIGEST_BYTES).context(DAMAGED)?;
    let digest_at = bytes.len() - DIGEST_BYTES;
    ensure!(
        Sha256::digest(&bytes[..digest_at])[..] == bytes[digest_at..],
        DAMAGED
    );
    postcard::from_bytes(&body[..body_bytes]).context(DAMAGED)
}

/// The number of passes in a file, with which what is kept begins. Only [`merge`] finds whether the rest is damaged.
///
/// # Errors
/// It has no number there.
pub fn passes(input: &Input) -> Result<u64> {
    /// The bytes of the longest number.
    const LONGEST: u64 = 10;
    let said = || format!("{}: {DAMAGED}", input.path.display());
    let mut start = Vec::new();
    input.body()?.take(LONGEST).read_to_end(&mut start)?;
    let (passes, _) = postcard::take_from_bytes(&start).with_context(said)?;
    Ok(passes)
}

fn kept_of(input: &Input) -> Result<Kept<'static>> {
    let said = || input.path.display().to_string();
    let bytes = fs::read(&input.path).with_context(said)?;
    let mut rest = bytes.as_slice();
    Header::read(&mut rest)?;
    kept_in(&bytes, rest).with_context(said)
}

/// Writes the file of the shards of all files together, in memory for one of them and for their sum.
///
/// # Errors
/// A file is damaged, or of another picture; or the result cannot be written.
pub fn merge(selection: &Selection, header: &Header, to: &Path) -> Result<()> {
    let mut inputs = selection.inputs.iter();
    let mut sum = kept_of(inputs.next().context("there is a file")?)?;
    for input in inputs {
        let said = || input.path.display().to_string();
        sum.state.merge(kept_of(input)?.state).with_context(said)?;
    }
    write(to, header, &sum)
}

#[cfg(test)]
mod tests {
    use photoncube_render::{Progressive, ProgressiveOptions, ViewOptions};

    use super::*;
    use crate::shards::Shard;

    fn kept() -> Kept<'static> {
        let scene = Scene::built_in("cornell").unwrap();
        let view = ViewOptions {
            width: 4,
            height: 4,
            ..ViewOptions::default()
        };
        let options = ProgressiveOptions {
            photons: 500,
            ..ProgressiveOptions::default()
        };
        let lighting = Lighting::default();
        let mut picture = Progressive::new(&scene, Engine::F64, lighting, view, options).unwrap();
        picture.pass().unwrap();
        let kept = Kept {
            state: picture.state(),
            rows: Vec::new(),
            reference: None,
            seconds: 0.1,
        };
        postcard::from_bytes(&postcard::to_allocvec(&kept).unwrap()).unwrap()
    }

    fn header() -> Header {
        let settings = [("--seed", "1"), ("--size", "4x4")];
        let settings = settings.map(|(name, value)| (name.to_owned(), value.to_owned()));
        Header::new("progressive", settings.into(), None, Shard::WHOLE)
    }

    fn bytes(kept: &Kept<'_>) -> Vec<u8> {
        put(Vec::new(), &header(), kept).unwrap()
    }

    fn read(bytes: &[u8]) -> Result<Kept<'static>> {
        let mut rest = bytes;
        let found = Header::read(&mut rest)?;
        header().check_same(&found, "give its options")?;
        kept_in(bytes, rest)
    }

    #[test]
    fn what_is_written_is_read_and_a_pixel_takes_at_most_eleven_numbers() {
        let kept = kept();
        let bytes = bytes(&kept);
        assert_eq!(read(&bytes).unwrap(), kept);
        // Numbers of 128 bits take at most 19 bytes.
        let pixels = 16 * 11 * 19;
        assert!(bytes.len() < pixels + 512, "{}", bytes.len());
    }

    #[test]
    fn a_file_that_is_damaged_anywhere_is_refused() {
        let whole = bytes(&kept());
        for at in 0..whole.len() {
            let mut bytes = whole.clone();
            bytes[at] ^= 1;
            assert!(read(&bytes).is_err(), "{at}");
            assert!(read(&whole[..at]).is_err(), "{at}");
        }
        assert!(read(&[&whole[..], b"more"].concat()).is_err());
        let mut damaged = whole;
        *damaged.last_mut().unwrap() ^= 1;
        let said = format!("{:#}", read(&damaged).unwrap_err());
        assert!(said.starts_with("found a file that is damaged"), "{said}");
    }
}
