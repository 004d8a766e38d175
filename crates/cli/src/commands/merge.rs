//! The command `merge`: the state files of shards become that of one machine.

use std::io::Write;
use std::path::PathBuf;

use anyhow::Result;
use serde::Serialize;

use super::progressive;
use crate::args::MergeArgs;
use crate::outputs::{self, Output};
use crate::shards::{Input, Selection, jobs_in, merge_lines};
use crate::{files, output};

#[derive(Serialize)]
struct Report {
    /// The command whose state it is.
    work: String,
    shards: u64,
    shards_merged: usize,
    shards_missing: Vec<u64>,
    /// The jobs of the merged shards.
    jobs: u64,
    /// The files all of whose shards are in others too.
    files_twice: Vec<PathBuf>,
    output: String,
}

/// Merges the files.
pub fn execute(args: &MergeArgs, json: bool) -> Result<()> {
    let output = Output::within("-o", args.output.clone());
    outputs::check(&[output], &args.files)?;
    let selection = Selection::of(&args.files, done)?;
    if !args.partial {
        selection.check_complete()?;
    }
    let work = selection.inputs[0].header.photoncube.clone();
    write(&selection, args)?;
    let parts = &selection.parts;
    let report = Report {
        shards: parts.of,
        shards_merged: parts.has.len(),
        shards_missing: parts.missing(),
        jobs: parts.jobs(selection.jobs),
        output: args.output.display().to_string(),
        files_twice: selection.twice,
        work,
    };
    output::print(json, &report, || text(&report))
}

/// The number of jobs in a file.
fn done(input: &Input) -> Result<u64> {
    match is_picture(input) {
        true => progressive::passes(input),
        false => jobs_in(input),
    }
}

fn is_picture(input: &Input) -> bool {
    input.header.photoncube == progressive::NAME
}

fn write(selection: &Selection, args: &MergeArgs) -> Result<()> {
    let first = &selection.inputs[0];
    let parts = &selection.parts;
    let header = |jobs| {
        let shards = parts.clone().whole_if_complete();
        first.header.with(jobs, shards)
    };
    if is_picture(first) {
        // A whole picture has no last pass: more can be made.
        let is_whole = parts.missing().is_empty();
        let jobs = (!is_whole).then_some(selection.jobs);
        return progressive::merge(selection, &header(jobs), &args.output);
    }
    files::write_with(&args.output, |file| {
        file.write_all(&header(Some(selection.jobs)).line())?;
        merge_lines(&selection.inputs, selection.jobs, file)
    })
}

fn text(report: &Report) -> String {
    let twice = report.files_twice.iter();
    let twice =
        twice.map(|path| format!("{}: its shards are in other files too\n", path.display()));
    let missing = match report.shards_missing.len() {
        0 => String::new(),
        missing => format!("{missing} shards are missing\n"),
    };
    format!(
        "{}{missing}merged {} of {} shards of `{}`, {} jobs, into {}\n",
        twice.collect::<String>(),
        report.shards_merged,
        report.shards,
        report.work,
        report.jobs,
        report.output
    )
}
