//! The book as mdBook builds it: every link in it leads to a page, a file or a heading of the book.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use libtest_mimic::{Failed, Trial};

use super::{is_installed, root, trial};

/// All files below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths
        .flat_map(|path| match path.is_dir() {
            true => files(&path),
            false => vec![path],
        })
        .collect()
}

/// The values of an attribute in a page of HTML.
fn attribute<'a>(html: &'a str, name: &str) -> Vec<&'a str> {
    let opening = format!(" {name}=\"");
    let values = html.split(&opening).skip(1);
    values.filter_map(|rest| rest.split('"').next()).collect()
}

/// A path without `.` and `..`.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                normal.pop();
            }
            Component::CurDir => {}
            part => normal.push(part),
        }
    }
    normal
}

fn is_elsewhere(link: &str) -> bool {
    link.contains(':') || link.is_empty()
}

/// The links of a built book that lead nowhere, as `PAGE: LINK`.
pub fn dead_links(book: &Path) -> Vec<String> {
    let pages = files(book).into_iter().filter(|path| {
        let is_html = path
            .extension()
            .is_some_and(|extension| extension == "html");
        // The book on one page has the links of all pages.
        is_html && !path.ends_with("print.html")
    });
    let texts: BTreeMap<_, _> = pages
        .map(|page| (page.clone(), fs::read_to_string(page).unwrap()))
        .collect();
    let mut dead = BTreeSet::new();
    for (page, text) in &texts {
        for link in [attribute(text, "href"), attribute(text, "src")].concat() {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = match file {
                "" => page.clone(),
                _ => normal(&page.parent().unwrap().join(file)),
            };
            let has_heading = || {
                let id = |text: &String| attribute(text, "id").contains(&heading);
                texts.get(&target).is_some_and(id)
            };
            let lives = target.is_file() && (heading.is_empty() || has_heading());
            if !is_elsewhere(link) && !lives {
                let page = page.strip_prefix(book).unwrap().display();
                dead.insert(format!("{page}: {link}"));
            }
        }
    }
    dead.into_iter().collect()
}

/// Builds the book with `scripts/book.sh`, which refuses warnings.
fn the_book_is_built() -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("book");
    let built = Command::new(root().join("scripts/book.sh"))
        .arg("--out")
        .arg(&out)
        .output()?;
    if !built.status.success() {
        return Err(String::from_utf8_lossy(&built.stderr).into_owned().into());
    }
    let pages = files(&out).len();
    let dead = dead_links(&out);
    match pages > 40 && dead.is_empty() {
        true => Ok(()),
        false => Err(format!(
            "{pages} files; these links lead nowhere:\n{}",
            dead.join("\n")
        )
        .into()),
    }
}

/// Whether `scripts/setup.sh` has installed mdBook, or another is on the PATH.
fn has_mdbook() -> bool {
    let setup = Command::new(root().join("scripts/setup.sh"))
        .arg("--where-book")
        .output();
    is_installed("mdbook") || setup.is_ok_and(|output| output.status.success())
}

pub fn trials() -> Vec<Trial> {
    let missing = (!has_mdbook()).then_some("mdBook");
    vec![trial("the_book_is_built".into(), missing, || {
        the_book_is_built()
    })]
}
