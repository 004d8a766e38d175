//! The pages that people read name files that exist: every path in back-quotes or in a code block, and every relative
//! link, with the heading that it leads to.

use std::fs;
use std::path::{Path, PathBuf};

/// The folders with which a path of the repository begins.
const FOLDERS: [&str; 6] = [
    "crates/",
    "testbenches/",
    "scripts/",
    "docs/",
    "hdl-out/",
    "benches/",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All pages: those at the root, those below `docs/`, and the READMEs of the crates.
fn pages() -> Vec<PathBuf> {
    let mut pages = Vec::new();
    let mut folders = vec![root().join("docs")];
    let at_root = files(&root()).into_iter();
    pages.extend(at_root.filter(|path| is_page(path)));
    let crates = files(&root().join("crates")).into_iter();
    pages.extend(
        crates
            .map(|path| path.join("README.md"))
            .filter(|path| path.exists()),
    );
    while let Some(folder) = folders.pop() {
        for path in files(&folder) {
            match path.is_dir() {
                true => folders.push(path),
                false if is_page(&path) => pages.push(path),
                false => {}
            }
        }
    }
    pages
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().path()).collect()
}

fn is_page(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "md")
}

/// The text between fences, and the rest.
fn blocks_and_prose(text: &str) -> (String, String) {
    let (mut blocks, mut prose, mut in_block) = (String::new(), String::new(), false);
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            in_block = !in_block;
            continue;
        }
        let part = if in_block { &mut blocks } else { &mut prose };
        *part += line;
        part.push('\n');
    }
    (blocks, prose)
}

/// The paths of the repository in a page's code spans and code blocks that do not exist.
fn missing_paths(root: &Path, text: &str) -> Vec<String> {
    let (blocks, prose) = blocks_and_prose(text);
    let spans = prose.split('`').skip(1).step_by(2);
    let words = spans
        .chain([blocks.as_str()])
        .flat_map(str::split_whitespace);
    let paths = words.map(|word| word.trim_matches([',', ';', ':', '.', '(', ')', '\'', '"']));
    paths
        .filter(|path| FOLDERS.iter().any(|folder| path.starts_with(folder)))
        .filter(|path| !root.join(fixed_part(path)).exists())
        .map(str::to_owned)
        .collect()
}

/// A path up to its first part that stands for any name, such as `*.v` or `MACHINE`.
fn fixed_part(path: &str) -> PathBuf {
    let stands_for_any = |part: &str| {
        let is_word = part.chars().all(|c| c.is_ascii_uppercase() || c == '_');
        part.contains('*') || (is_word && !part.is_empty())
    };
    path.split('/')
        .take_while(|part| !stands_for_any(part))
        .collect()
}

/// The relative links of a page that lead nowhere.
fn dead_links(page: &Path, text: &str) -> Vec<String> {
    let (_, prose) = blocks_and_prose(text);
    let targets = |before: &'static str, after: char| {
        let links = prose.split(before).skip(1);
        let links = links.filter_map(move |rest| rest.split_once(after));
        links
            .map(|(target, _)| target.to_owned())
            .collect::<Vec<_>>()
    };
    let links = [targets("](", ')'), targets("<img src=\"", '"')].concat();
    let is_relative = |link: &String| !link.contains("://") && !link.starts_with("mailto:");
    links
        .into_iter()
        .filter(is_relative)
        .filter(|link| !resolves(page, text, link))
        .collect()
}

fn resolves(page: &Path, text: &str, link: &str) -> bool {
    let (file, heading) = link.split_once('#').unwrap_or((link, ""));
    let target = page.parent().unwrap().join(file);
    let target_text = match file {
        "" => Some(text.to_owned()),
        _ => fs::read_to_string(&target).ok(),
    };
    let has_heading = || target_text.is_some_and(|text| headings(&text).contains(&heading.into()));
    (file.is_empty() || target.exists()) && (heading.is_empty() || has_heading())
}

/// The anchors of a page's headings, as GitHub makes them.
fn headings(text: &str) -> Vec<String> {
    let (_, prose) = blocks_and_prose(text);
    let lines = prose.lines().filter(|line| line.starts_with('#'));
    let kept = |c: &char| c.is_alphanumeric() || "-_ ".contains(*c);
    lines
        .map(|line| line.trim_start_matches('#').trim().to_lowercase())
        .map(|heading| heading.chars().filter(kept).collect::<String>())
        .map(|heading| heading.replace(' ', "-"))
        .collect()
}

#[test]
fn every_path_and_link_of_the_pages_exists() {
    let pages = pages();
    assert!(pages.len() > 15, "the pages are found: {pages:?}");
    let mut wrong = Vec::new();
    for page in pages {
        let text = fs::read_to_string(&page).unwrap();
        let mut found = dead_links(&page, &text);
        // The changelog names files of earlier versions.
        if !page.ends_with("CHANGELOG.md") {
            found.extend(missing_paths(&root(), &text));
        }
        wrong.extend(
            found
                .iter()
                .map(|path| format!("{}: {path}", page.display())),
        );
    }
    assert!(
        wrong.is_empty(),
        "these lead nowhere:\n{}",
        wrong.join("\n")
    );
}

/// Words without back-quotes are prose, and `*` and words of capitals stand for any name.
#[test]
fn a_wrong_path_is_found() {
    let page = "
`crates/cli/src/main.rs`, `crates/cli/src/no_such_file.rs`, crates/no_back_quotes, `scripts/test.sh --help`,
`hdl-out/MACHINE/*.v` and `no-such-folder/x`.

```sh
scripts/no_such_script.sh docs/scenes/knots.toml
```

`docs/no_such_page.md`; `hdl-out/no_such_machine/*.v`.
";
    let mut missing = missing_paths(&root(), page);
    missing.sort();
    assert_eq!(
        missing,
        [
            "crates/cli/src/no_such_file.rs",
            "docs/no_such_page.md",
            "hdl-out/no_such_machine/*.v",
            "scripts/no_such_script.sh",
        ]
    );
}

#[test]
fn a_link_that_leads_nowhere_is_found() {
    let page = "
# A page, with `code`

[here](#a-page-with-code) [gone](#no-such-heading) [there](CONTRIBUTING.md#style) [gone](README.md#no-such-heading)
[gone](docs/no_such_page.md) [folder](docs/scenes/) [web](https://example.org/x) <img src=\"docs/no_such.png\">

```text
[a block](is_no_link)
```
";
    assert_eq!(
        dead_links(&root().join("page.md"), page),
        [
            "#no-such-heading",
            "README.md#no-such-heading",
            "docs/no_such_page.md",
            "docs/no_such.png",
        ]
    );
}
