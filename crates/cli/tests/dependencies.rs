//! The dependencies of the workspace: each direct dependency is used, and each licence is allowed and listed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// The page that lists the licences.
const PAGE: &str = "docs/licences.md";

/// Licences that a project under MIT may use; they ask for a notice, and for no more.
const ALLOWED: [&str; 5] = ["Apache-2.0", "BSD-3-Clause", "MIT", "Unicode-3.0", "Zlib"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The package that gives builds of one package the features of the workspace. It has no code to name.
const FEATURES: &str = "workspace-features";

/// The standard output of a command of cargo, which must succeed.
fn cargo(arguments: &[&str]) -> String {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let mut command = Command::new(cargo);
    let output = command
        .args(arguments)
        .current_dir(root())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "cargo {arguments:?}: {said}");
    String::from_utf8(output.stdout).unwrap()
}

/// The output of `cargo metadata` for the packages that are built on this machine.
fn metadata() -> Value {
    let version = cargo(&["-vV"]);
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    let filter = ["--filter-platform", host.unwrap()];
    let options = ["metadata", "--locked", "--offline", "--format-version", "1"];
    serde_json::from_str(&cargo(&[&options[..], &filter].concat())).unwrap()
}

/// The packages from outside that a test build takes, each with its features, as `name vVERSION [FEATURES]`.
fn built(of: &[&str]) -> BTreeSet<String> {
    let format = [
        "--edges",
        "normal,build,dev",
        "--prefix",
        "none",
        "--format",
        "{p} [{f}]",
    ];
    let options = ["tree", "--locked", "--offline"];
    let tree = cargo(&[&options[..], of, &format].concat());
    let lines = tree.lines().map(|line| line.trim_end_matches(" (*)"));
    let outside = lines.filter(|line| !line.is_empty() && !line.contains(" (/"));
    outside.map(str::to_owned).collect()
}

fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().unwrap()
}

fn text<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

/// The name by which a package's manifest and its code know a dependency.
fn alias(dependency: &Value) -> &str {
    dependency["rename"]
        .as_str()
        .unwrap_or_else(|| text(dependency, "name"))
}

/// The packages of the workspace, or those from outside.
fn packages(metadata: &Value, own: bool) -> Vec<&Value> {
    let resolved = list(&metadata["resolve"], "nodes");
    let is_built = |package: &&Value| resolved.iter().any(|node| node["id"] == package["id"]);
    let packages = list(metadata, "packages").iter();
    packages
        .filter(|package| package["source"].is_null() == own)
        .filter(is_built)
        .collect()
}

/// Whether one of the alternatives of an SPDX expression has allowed licences only.
fn is_allowed(expression: &str) -> bool {
    let expression = expression.replace(['(', ')'], "").replace('/', " OR ");
    let mut alternatives = expression.split(" OR ");
    alternatives.any(|one| one.split(" AND ").all(|l| ALLOWED.contains(&l.trim())))
}

#[test]
fn an_expression_is_allowed_by_its_alternatives() {
    assert!(is_allowed("MIT OR GPL-3.0") && is_allowed("Unlicense/MIT"));
    assert!(is_allowed("(MIT OR Apache-2.0) AND Unicode-3.0"));
    assert!(!is_allowed("GPL-3.0") && !is_allowed("MIT AND GPL-3.0") && !is_allowed(""));
}

#[test]
fn every_licence_is_allowed_and_stands_on_the_page() {
    let metadata = metadata();
    let mut by_licence: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for package in packages(&metadata, false) {
        let (name, licence) = (text(package, "name"), text(package, "license"));
        assert!(is_allowed(licence), "{name}: the licence is `{licence}`");
        by_licence.entry(licence).or_default().push(name);
    }
    assert!(!by_licence.is_empty());
    let rows: Vec<_> = by_licence
        .into_iter()
        .map(|(licence, mut names)| {
            names.dedup();
            format!("- `{licence}`: {}", names.join(", "))
        })
        .collect();
    let page = fs::read_to_string(root().join(PAGE)).unwrap();
    let found: Vec<_> = page.lines().filter(|line| line.starts_with("- ")).collect();
    let expected = rows.join("\n");
    assert!(found == rows, "{PAGE}: expected the lines\n{expected}");
}

/// The text of all Rust files below a folder.
fn rust_text(folder: &Path) -> String {
    let entries = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    entries.fold(String::new(), |text, path| {
        if path.is_dir() {
            text + &rust_text(&path)
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            text + &fs::read_to_string(path).unwrap()
        } else {
            text
        }
    })
}

#[test]
fn every_package_names_each_of_its_dependencies() {
    let metadata = metadata();
    let own = packages(&metadata, true);
    assert!(!own.is_empty());
    for package in own {
        let folder = Path::new(text(package, "manifest_path")).parent().unwrap();
        let sources = rust_text(folder);
        if text(package, "name") == FEATURES {
            continue;
        }
        let dependencies = list(package, "dependencies").iter();
        for dependency in dependencies.filter(|dependency| alias(dependency) != FEATURES) {
            let name = alias(dependency).replace('-', "_");
            let found = ["::", ";", " as "]
                .iter()
                .any(|end| sources.contains(&format!("{name}{end}")));
            assert!(found, "{}: nothing names `{name}`", text(package, "name"));
        }
    }
}

#[test]
fn every_dependency_of_the_workspace_has_a_member_that_takes_it() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let (_, rows) = manifest.split_once("[workspace.dependencies]\n").unwrap();
    let (rows, _) = rows.split_once("\n[").unwrap();
    let metadata = metadata();
    let own = packages(&metadata, true);
    let taken = |name: &str| {
        let mut all = own.iter().flat_map(|package| list(package, "dependencies"));
        all.any(|dependency| alias(dependency) == name)
    };
    let names: Vec<_> = rows
        .lines()
        .filter_map(|row| row.split_once(" = "))
        .collect();
    assert!(!names.is_empty());
    for (name, _) in names {
        assert!(taken(name), "no member of the workspace takes `{name}`");
    }
}

#[test]
fn one_package_builds_the_features_of_the_workspace() {
    let all = built(&["--workspace"]);
    let metadata = metadata();
    // Both packages only pass on others.
    let passes_on = ["svg", FEATURES];
    let own = packages(&metadata, true).into_iter();
    let names = own.map(|package| text(package, "name"));
    for name in names.filter(|name| !passes_on.contains(name)) {
        let alone = built(&["--package", name]);
        assert!(!alone.is_empty());
        let others: Vec<_> = alone.difference(&all).collect();
        assert!(
            others.is_empty(),
            "-p {name} builds other features than --workspace: {others:#?}; crates/workspace-features/Cargo.toml lacks rows"
        );
    }
}
