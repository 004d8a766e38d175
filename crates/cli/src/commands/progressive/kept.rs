//! The file of `--state`: what a progressive picture is after some passes, from which `--resume` goes on.
//!
//! The file has a line that says what it is, a line of JSON with the settings of the picture, the state in the format of
//! the crate `postcard`, and SHA-256 of all of this. The state has each number in 64 bits, so nothing is rounded.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use photoncube_render::{Balance, Engine, Image, Lighting, ProgressiveState, RadiusRule, Scene};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::Row;
use crate::args::{EngineReport, LightingReport, ProgressiveArgs};
use crate::files;

/// The first line. The number is that of the format and changes with it.
const FIRST_LINE: &[u8] = b"photoncube progressive state 3\n";

/// The bytes of SHA-256.
const DIGEST_BYTES: usize = 32;

/// All that two runs must have in common so that one can go on with the passes of the other, by the names of the
/// options, as text.
pub type Settings = BTreeMap<String, String>;

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
        ("photoncube version", env!("CARGO_PKG_VERSION").to_owned()),
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
pub struct Kept {
    /// The state of the picture.
    pub state: ProgressiveState,
    /// The rows of the table.
    pub rows: Vec<Row>,
    /// The digest of the reference that the rows compare with; `None` without a reference.
    pub reference: Option<Vec<u8>>,
    /// The time of all passes.
    pub seconds: f64,
}

impl Kept {
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
    settings: Settings,
}

impl Keeper {
    /// Keeps the state of a picture of these settings in that file.
    pub fn new(path: PathBuf, settings: Settings) -> Self {
        Self { path, settings }
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
    pub fn write(&self, kept: &Kept) -> Result<()> {
        files::write(&self.path, &bytes(&self.settings, kept)?)
    }

    /// Reads the file.
    ///
    /// # Errors
    /// It cannot be read, is no whole state, or is that of another picture.
    pub fn read(&self) -> Result<Kept> {
        let said = || format!("--state {}", self.path.display());
        let bytes = fs::read(&self.path).with_context(|| {
            format!(
                "{}: cannot be read; leave out --resume to begin a new picture",
                said()
            )
        })?;
        read(&self.settings, &bytes).with_context(said)
    }
}

fn bytes(settings: &Settings, kept: &Kept) -> Result<Vec<u8>> {
    let mut bytes = FIRST_LINE.to_vec();
    bytes.extend(serde_json::to_vec(settings)?);
    bytes.push(b'\n');
    bytes.extend(postcard::to_allocvec(kept)?);
    let digest = Sha256::digest(&bytes);
    bytes.extend(digest);
    Ok(bytes)
}

fn read(settings: &Settings, bytes: &[u8]) -> Result<Kept> {
    let expected = String::from_utf8_lossy(FIRST_LINE.trim_ascii_end());
    let Some(rest) = bytes.strip_prefix(FIRST_LINE) else {
        let first = bytes
            .split(|byte| *byte == b'\n')
            .next()
            .unwrap_or_default();
        let found =
            String::from_utf8_lossy(&first[..first.len().min(FIRST_LINE.len())]).into_owned();
        bail!("found a file that begins with {found:?}, expected {expected:?}");
    };
    let damaged =
        "found a file that is damaged or not whole, expected one as `progressive --state` wrote it";
    let end = bytes.len() - DIGEST_BYTES.min(rest.len());
    ensure!(Sha256::digest(&bytes[..end])[..] == bytes[end..], damaged);
    let body = &bytes[FIRST_LINE.len()..end];
    let line = body
        .iter()
        .position(|byte| *byte == b'\n')
        .context(damaged)?;
    let found: Settings = serde_json::from_slice(&body[..line]).context(damaged)?;
    same(&found, settings)?;
    postcard::from_bytes(&body[line + 1..]).context(damaged)
}

/// Refuses the settings of another picture.
fn same(found: &Settings, expected: &Settings) -> Result<()> {
    let names = found.keys().chain(expected.keys());
    let names: std::collections::BTreeSet<_> = names.collect();
    let of = |settings: &Settings, name: &str| {
        let value = settings.get(name);
        value.map_or("none".to_owned(), ToOwned::to_owned)
    };
    let differs = |name: &&&String| found.get(**name) != expected.get(**name);
    let differing = names.iter().filter(differs).map(|name| {
        let (found, expected) = (of(found, name), of(expected, name));
        format!("{name}: found {found}, expected {expected}")
    });
    let differing: Vec<_> = differing.collect();
    ensure!(
        differing.is_empty(),
        "the state is that of another picture: {}; give the options of the run that began it",
        differing.join("; ")
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use photoncube_render::{Progressive, ProgressiveOptions, ViewOptions};

    use super::*;

    fn kept() -> Kept {
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
        Kept {
            state: picture.state(),
            rows: Vec::new(),
            reference: None,
            seconds: 0.1,
        }
    }

    fn settings() -> Settings {
        let settings = [("--seed", "1"), ("--size", "4x4")];
        settings
            .map(|(name, value)| (name.to_owned(), value.to_owned()))
            .into()
    }

    #[test]
    fn what_is_written_is_read_and_a_pixel_takes_twelve_numbers() {
        let (settings, kept) = (settings(), kept());
        let bytes = bytes(&settings, &kept).unwrap();
        assert_eq!(read(&settings, &bytes).unwrap(), kept);
        let pixels = 16 * 12 * size_of::<f64>();
        assert!(
            (pixels..pixels + 256).contains(&bytes.len()),
            "{}",
            bytes.len()
        );
    }

    #[test]
    fn a_file_that_is_damaged_anywhere_is_refused() {
        let (settings, kept) = (settings(), kept());
        let whole = bytes(&settings, &kept).unwrap();
        for at in 0..whole.len() {
            let mut bytes = whole.clone();
            bytes[at] ^= 1;
            let said = format!("{:#}", read(&settings, &bytes).unwrap_err());
            assert!(said.starts_with("found a file that "), "{said}");
            assert!(read(&settings, &whole[..at]).is_err(), "{at}");
        }
        assert!(read(&settings, &[&whole[..], b"more"].concat()).is_err());
    }

    #[test]
    fn the_state_of_another_picture_is_refused_with_all_that_differs() {
        let (found, kept) = (settings(), kept());
        let bytes = bytes(&found, &kept).unwrap();
        let mut expected = found;
        expected.insert("--seed".to_owned(), "2".to_owned());
        expected.insert("--format".to_owned(), "local8-rgb8e5".to_owned());
        let said = read(&expected, &bytes).unwrap_err().to_string();
        assert_eq!(
            said,
            "the state is that of another picture: --format: found none, expected local8-rgb8e5; --seed: found 1, \
             expected 2; give the options of the run that began it"
        );
    }
}
