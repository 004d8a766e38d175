//! The text of a generator's crate.

use std::path::Path;

use photoncube_spec::{Machine, Organisation};

use crate::build::{sequential_sizes, spatial_sizes};
use crate::leaf::leaf_sizes;

/// The manifest, for the sources of photoncube in that folder. The digest makes the program's name its own, as all
/// generators are built into one folder.
pub(super) fn manifest(sources: &Path, digest: &str) -> String {
    // A string of JSON is one of TOML.
    let path = |folder: &str| serde_json::json!(sources.join(folder).display().to_string());
    format!(
        "[package]\nname = \"photoncube-generator-{digest}\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n\
         [dependencies]\nphotoncube-hdl = {{ path = {}, default-features = false }}\n\n\
         [patch.crates-io]\nsvg = {{ path = {} }}\n\n\
         # Compiled in a third of the time. The text is printed as fast, and rust-hdl simulates 1.4 times longer.\n\
         [profile.release]\nopt-level = 0\ndebug = false\n\n\
         [workspace]\n",
        path("crates/hdl"),
        path("crates/svg"),
    )
}

/// The program: the machine's name, and the widths of its blocks.
pub(super) fn program(machine: &Machine) -> String {
    let (function, sizes) = match &machine.organisation {
        Organisation::Spatial(_) => ("spatial", spatial_sizes(machine)),
        Organisation::Leaf(_) => ("leaf", leaf_sizes(machine)),
        _ => ("sequential", sequential_sizes(machine)),
    };
    let sizes: Vec<_> = sizes.iter().map(ToString::to_string).collect();
    format!(
        "//! The generator of the machine `{name}`.\n\n\
         use std::process::ExitCode;\n\n\
         use photoncube_hdl::generator::{{{function}, serve}};\n\n\
         fn main() -> ExitCode {{\n    serve(\"{name}\", {function}::<{sizes}>)\n}}\n",
        name = machine.name,
        sizes = sizes.join(", "),
    )
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    #[test]
    fn the_crate_names_the_machine_its_widths_and_the_sources() {
        let machine = find_machine("tile-5-local7-rgb6d-n4096").unwrap();
        let text = program(machine);
        let call = "serve(\"tile-5-local7-rgb6d-n4096\", spatial::<9, 9, 10, 7, 14, 15, 6, 4, 18, 15, 16, 6, 0, 6, 7, 8, 18, 13>)";
        assert!(text.contains(call), "{text}");
        let text = program(find_machine("sequential-local8-rgb8e5").unwrap());
        assert!(
            text.contains("sequential::<10, 10, 8, 16, 16, 8, 5, 32, 34, 52, 4, 15, 4, 16, 4>")
        );
        let manifest = manifest(Path::new("/it's \"here\""), "1");
        assert!(
            manifest.contains(r#"path = "/it's \"here\"/crates/hdl""#),
            "{manifest}"
        );
    }
}
