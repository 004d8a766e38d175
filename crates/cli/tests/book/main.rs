//! The book: every command of its chapters is run and every output compared, and mdBook builds it without a dead link.
//!
//! A chapter that runs a tool which is missing is listed as ignored, with the command that installs the tool; with
//! `REQUIRE_EDA=1` it fails.

mod built;
mod chapter;
mod controls;
mod page;

use std::fs;
use std::path::{Path, PathBuf};

use libtest_mimic::{Arguments, Failed, Trial};

use self::page::Part;

/// Programs of chapters that come with neither Rust nor a shell.
const TOOLS: [&str; 3] = ["iverilog", "vvp", "yosys"];

/// Simulators that a command of a chapter starts by itself where they are installed: the chapter shows their rows.
const STARTED: [(&str, &str); 1] = [("first-machine", "verilator")];

/// The commands that no test runs, by chapter; the chapter says why.
const NOT_RUN: [(&str, &str); 7] = [
    // It takes nextpnr, and two minutes.
    (
        "core",
        "photoncube synth --machine leaf-5-local7-rgb6d-n64 --chains 1 --flow ecp5 --flow place --grade 8 --seeds 1",
    ),
    (
        "core",
        "quartus_sh --flow compile photoncube_core_1_leaf_5_local7_rgb6d_n64",
    ),
    ("first-machine", "cd photoncube"),
    ("first-machine", "cargo run --release -- run"),
    ("first-machine", "export PATH=$PWD/target/release:$PATH"),
    ("first-machine", "mkdir ../mine"),
    ("first-machine", "cd ../mine"),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn name(page: &Path) -> String {
    page.file_stem().unwrap().to_string_lossy().into_owned()
}

/// The chapters that were written for the book; its other pages describe one subject each.
fn chapters() -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join("docs/book")).unwrap();
    let mut pages: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    pages.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    pages.sort();
    pages
}

fn parts(page: &Path) -> Result<Vec<Part>, Failed> {
    let parts = page::parts(&fs::read_to_string(page).unwrap());
    parts.map_err(|error| format!("{}, {error}", page.display()).into())
}

/// The first tool that a chapter runs, or has rows of, and that is not installed.
fn missing_tool(page: &Path) -> Option<&'static str> {
    let parts = parts(page).unwrap_or_default();
    let runs = |tool: &&str| {
        parts.iter().any(|part| match part {
            Part::Run(command) => command.text.split_whitespace().any(|word| word == *tool),
            Part::File { .. } | Part::NotRun(_) => false,
        })
    };
    let started = STARTED
        .into_iter()
        .filter(|(chapter, _)| *chapter == name(page));
    TOOLS
        .into_iter()
        .filter(runs)
        .chain(started.map(|(_, tool)| tool))
        .find(|tool| !is_installed(tool))
}

fn is_installed(tool: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|folder| folder.join(tool).is_file())
}

/// A trial that needs a tool, of which `missing` says that it is not there.
fn trial(
    name: String,
    missing: Option<&str>,
    run: impl FnOnce() -> Result<(), Failed> + Send + 'static,
) -> Trial {
    let Some(missing) = missing else {
        return Trial::test(name, run);
    };
    let message = format!("needs {missing}: scripts/setup.sh installs it");
    let required = std::env::var("REQUIRE_EDA").is_ok_and(|value| value == "1");
    let name = format!("{name} ({message})");
    Trial::test(name, || Err(message.into())).with_ignored_flag(!required)
}

fn what_is_not_run_is_named() -> Result<(), Failed> {
    let mut found = Vec::new();
    for page in chapters() {
        for part in parts(&page)? {
            if let Part::NotRun(command) = part {
                found.push((name(&page), command.text));
            }
        }
    }
    let named = NOT_RUN.map(|(page, command)| (page.to_owned(), command.to_owned()));
    match found == named {
        true => Ok(()),
        false => Err(format!(
            "NOT_RUN in crates/cli/tests/book/main.rs: found {named:?}, expected {found:?}"
        )
        .into()),
    }
}

fn follow(page: &Path) -> Result<(), Failed> {
    let followed = chapter::follow(page, chapter::is_overwritten());
    followed.map_err(|error| format!("{}, {error}", page.display()).into())
}

fn main() {
    let chapters = chapters().into_iter().map(|page| {
        let missing = missing_tool(&page);
        trial(format!("chapter {}", name(&page)), missing, move || {
            follow(&page)
        })
    });
    let mut trials: Vec<_> = chapters.collect();
    trials.push(Trial::test(
        "what_is_not_run_is_named",
        what_is_not_run_is_named,
    ));
    trials.extend(controls::trials());
    trials.extend(built::trials());
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
