//! The command `datasheet`: writes the datasheets of the families with their pictures, or checks those that are there.

mod core;
mod document;
mod family;
mod files;
mod html;
mod markdown;
mod sheet;

use std::fs;
use std::path::Path;

use anyhow::{Result, bail};
use serde::Serialize;

pub use self::core::{
    PROTOCOL as CORE_PROTOCOL, VERIFIED as CORE_VERIFIED, facts as core_facts, ports as core_ports,
};
pub use self::family::{CORE, Family, family_names};
use self::files::{FOLDERS, PageFile, page_files};
use crate::args::DatasheetArgs;
use crate::failure::CheckFailed;
use crate::{files as disk, output, outputs};

#[derive(Serialize)]
struct Report {
    families: Vec<&'static str>,
    out: String,
    checked: bool,
    files: Vec<String>,
    stale: Vec<String>,
}

/// Writes, or checks, the datasheets and the pictures.
pub fn execute(args: &DatasheetArgs, json: bool) -> Result<()> {
    if !args.check {
        outputs::check_folder("--out", &args.out)?;
    } else if !args.out.is_dir() {
        bail!("{} is no folder: nothing to check", args.out.display());
    }
    let is_wanted = |family: &&Family| {
        args.family
            .as_deref()
            .is_none_or(|name| name == family.name)
    };
    let families: Vec<_> = Family::all().filter(is_wanted).collect();
    let whole = args.family.is_none();
    let files = page_files(&families, whole, args.html)?;
    let stale = match args.check {
        true => stale(&args.out, &files, whole),
        false => {
            let texts = files.iter();
            disk::write_all(texts.map(|file| (args.out.join(&file.path), file.text.as_bytes())))?;
            Vec::new()
        }
    };
    let report = Report {
        families: families.iter().map(|family| family.name).collect(),
        out: args.out.display().to_string(),
        checked: args.check,
        files: files.iter().map(|file| file.path.clone()).collect(),
        stale,
    };
    output::print(json, &report, || text(&report))?;
    match report.stale.as_slice() {
        [] => Ok(()),
        stale => Err(CheckFailed(format!(
            "{} holds {} files that are not what `photoncube datasheet` writes: {}; run it and review the change, and delete what is not ours",
            report.out,
            stale.len(),
            stale.join(", ")
        ))
        .into()),
    }
}

/// The files that differ or are missing, and where all are checked, those in the folders that are not written.
fn stale(out: &Path, files: &[PageFile], whole: bool) -> Vec<String> {
    let differs = |file: &&PageFile| {
        let found = fs::read(out.join(&file.path)).ok();
        found.as_deref() != Some(file.text.as_bytes())
    };
    let mut stale: Vec<_> = files
        .iter()
        .filter(differs)
        .map(|file| file.path.clone())
        .collect();
    let folders = FOLDERS.iter().filter(|_| whole);
    for folder in folders {
        let entries = fs::read_dir(out.join(folder))
            .into_iter()
            .flatten()
            .flatten();
        let paths =
            entries.map(|entry| format!("{folder}/{}", entry.file_name().to_string_lossy()));
        // HTML beside the Markdown is written by --html alone.
        let foreign = paths
            .filter(|path| !path.ends_with(".html") && files.iter().all(|file| file.path != *path));
        let mut foreign: Vec<_> = foreign.map(|path| format!("{path} (not ours)")).collect();
        foreign.sort();
        stale.extend(foreign);
    }
    stale
}

fn text(report: &Report) -> String {
    let done = if report.checked { "checked" } else { "wrote" };
    format!(
        "{done} {} files in {}: the datasheets of {}\n",
        report.files.len(),
        report.out,
        report.families.join(", ")
    )
}
