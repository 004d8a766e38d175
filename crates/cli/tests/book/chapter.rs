//! Does what a chapter asks for, in a folder of its own, and compares the outputs.

use std::fs;
use std::path::Path;
use std::process::{Command as Process, Stdio};

use snapbox::Data;
use snapbox::filter::NormalizeToExpected;

use super::page::{Command, Part, parts, with_outputs};

/// Ends the output of a command; no output has it.
const SEPARATOR: char = '\u{1e}';

/// The variable that writes the outputs into the page instead of comparing them.
const OVERWRITE: &str = "BOOK";

/// One session of a shell, so that `cd`, variables and `$?` mean what they mean to a reader.
fn script(parts: &[Part]) -> String {
    let mut script = String::from("set -o pipefail; exec 2>&1\n");
    for part in parts {
        match part {
            Part::File { name, text } => {
                script += &format!("cat >'{name}' <<'{SEPARATOR}'\n{text}{SEPARATOR}\n");
            }
            Part::Run(command) => {
                script += &command.text;
                script += "\nbook_status=$?; printf '\\036%s\\036' \"$book_status\"; (exit \"$book_status\")\n";
            }
            Part::NotRun(_) => {}
        }
    }
    script
}

/// The output and the exit code of each command.
fn execute(folder: &Path, parts: &[Part]) -> Vec<(String, i32)> {
    let photoncube = assert_cmd::cargo::cargo_bin("photoncube");
    let programs = photoncube.parent().unwrap();
    let before = std::env::var("PATH").unwrap_or_default();
    let session = folder.join("session");
    fs::write(&session, script(parts)).unwrap();
    let work = folder.join("work");
    fs::create_dir(&work).unwrap();
    let output = Process::new("bash")
        .arg(session)
        .current_dir(work)
        .env("PATH", format!("{}:{before}", programs.display()))
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let pieces: Vec<&str> = said.split(SEPARATOR).collect();
    let pairs = pieces.chunks_exact(2);
    pairs
        .map(|pair| (pair[0].to_owned(), pair[1].parse().unwrap()))
        .collect()
}

/// The output in the words of the page: what its wildcards stand for is theirs.
fn in_words_of_the_page(found: &str, promised: &str) -> String {
    let (found, promised) = (Data::text(found), Data::text(promised));
    let found = NormalizeToExpected::new()
        .redact()
        .normalize(found, &promised);
    found.render().unwrap()
}

/// What is wrong in the outcome of a command; `next` is the command after it, which may show its exit code.
fn mistake(command: &Command, next: Option<&Command>, found: &str, code: i32) -> Option<String> {
    let at = format!("line {}: `{}`", command.line, command.text);
    let shown = next.is_some_and(|next| next.text == "echo $?");
    if code != 0 && !shown {
        return Some(format!("{at}: exit code {code}, and printed\n{found}"));
    }
    let found = in_words_of_the_page(found, &command.output);
    (found != command.output).then(|| {
        format!(
            "{at} printed\n{found}--- the page promises\n{}",
            command.output
        )
    })
}

/// Whether the outputs are to be written into the chapters instead of being compared.
pub fn is_overwritten() -> bool {
    std::env::var(OVERWRITE).is_ok_and(|value| value == "overwrite")
}

/// Does what the page asks for. With `overwrite` it then writes the outputs into the page.
///
/// # Errors
/// Every output that differs, with its line.
pub fn follow(page: &Path, overwrite: bool) -> Result<(), String> {
    let text = fs::read_to_string(page).unwrap();
    let parts = parts(&text)?;
    let folder = tempfile::tempdir().unwrap();
    let outcomes = execute(folder.path(), &parts);
    let commands = parts.iter().filter_map(|part| match part {
        Part::Run(command) => Some(command),
        Part::File { .. } | Part::NotRun(_) => None,
    });
    let commands: Vec<_> = commands.collect();
    if outcomes.len() != commands.len() {
        let last = &commands[outcomes.len()];
        return Err(format!(
            "line {}: `{}` ended the session",
            last.line, last.text
        ));
    }
    if overwrite {
        let outputs = commands.iter().zip(&outcomes);
        let outputs: Vec<_> = outputs
            .map(|(command, (found, _))| (*command, in_words_of_the_page(found, &command.output)))
            .collect();
        fs::write(page, with_outputs(&text, &outputs)).unwrap();
        return Ok(());
    }
    let nexts = commands.iter().skip(1).copied().map(Some).chain([None]);
    let mistakes: Vec<_> = commands
        .iter()
        .zip(nexts)
        .zip(&outcomes)
        .filter_map(|((command, next), (found, code))| mistake(command, next, found, *code))
        .collect();
    match mistakes.is_empty() {
        true => Ok(()),
        false => Err(format!(
            "{}\n{OVERWRITE}=overwrite writes the outputs into the page; then read `git diff`",
            mistakes.join("\n")
        )),
    }
}
