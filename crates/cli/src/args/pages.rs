//! Holds the command lines of `photoncube` in the pages to those that there are.

use std::fs;
use std::path::{Path, PathBuf};

use super::Args;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The pages at the root and in `docs/`, but the book, whose commands a test runs.
fn pages() -> Vec<PathBuf> {
    let folders = ["", "docs", "docs/datasheets", "docs/measured"];
    let entries = folders.map(|folder| fs::read_dir(root().join(folder)).unwrap());
    let paths = entries.into_iter().flatten();
    let paths = paths.map(|entry| entry.unwrap().path());
    paths
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect()
}

/// The lines between fences that are commands, each with the lines that go on with it.
fn commands(page: &str) -> Vec<String> {
    let (mut commands, mut in_block, mut goes_on) = (Vec::<String>::new(), false, false);
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            in_block = !in_block;
            continue;
        }
        let line = line.strip_prefix("$ ").unwrap_or(line).trim();
        let line = line.replacen("cargo run --release -- ", "photoncube ", 1);
        let (text, more) = match line.strip_suffix('\\') {
            Some(text) => (text, true),
            None => (line.as_str(), false),
        };
        if goes_on {
            *commands.last_mut().unwrap() += text.strip_prefix("> ").unwrap_or(text);
            goes_on = more;
        } else if in_block && text.starts_with("photoncube ") {
            commands.push(text.to_owned());
            goes_on = more;
        }
    }
    commands
}

/// The words of a command, up to a comment, a pipe or a redirection.
fn words(command: &str) -> Vec<&str> {
    command
        .split_whitespace()
        .take_while(|word| !["#", "|", ">", "&&", ";"].contains(word))
        .collect()
}

/// What is wrong with a command, apart from the help that it asks for.
fn mistake(command: &str) -> Option<String> {
    let error = Args::try_read(words(command)).err()?;
    error.use_stderr().then(|| format!("`{command}`: {error}"))
}

#[test]
fn every_command_line_of_the_pages_is_one_that_is_accepted() {
    let (mut seen, mut wrong) = (0, Vec::new());
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        for command in commands(&text) {
            seen += 1;
            wrong.extend(mistake(&command).map(|error| format!("{}: {error}", page.display())));
        }
    }
    assert!(seen > 40, "found {seen} commands");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_wrong_command_line_is_found() {
    let page = "
photoncube prose
```sh
photoncube render cornell -o box.png   # a comment
photoncube render cornell \\
    --no-such-option
$ photoncube list | tail -1
cargo run --release -- verify no-such-method
photoncube --help
```
";
    let commands = commands(page);
    assert_eq!(commands.len(), 5);
    let wrong: Vec<_> = commands.iter().filter_map(|line| mistake(line)).collect();
    assert_eq!(wrong.len(), 2, "{wrong:?}");
    assert!(wrong[0].contains("--no-such-option") && wrong[1].contains("no-such-method"));
}
