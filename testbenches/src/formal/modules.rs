//! Splits a Verilog text into modules and finds their instances.

use std::collections::{BTreeMap, BTreeSet};

/// The text of each module, by name.
#[derive(Debug)]
pub(super) struct Modules<'a> {
    texts: BTreeMap<&'a str, &'a str>,
}

impl<'a> Modules<'a> {
    pub fn of(text: &'a str) -> Self {
        let mut texts = BTreeMap::new();
        let mut rest = text;
        while let Some(begin) = find_module(rest) {
            let module = &rest[begin..];
            let end = module.find("\nendmodule");
            let end = end.map_or(module.len(), |end| end + "\nendmodule\n".len());
            let end = end.min(module.len());
            let name = module["module ".len()..].split('(').next();
            texts.insert(name.unwrap_or_default().trim(), &module[..end]);
            rest = &module[end..];
        }
        Self { texts }
    }

    /// The names of the modules.
    pub fn names(&self) -> impl Iterator<Item = &'a str> {
        self.texts.keys().copied()
    }

    /// The text of a module; empty where it does not exist.
    pub fn text(&self, module: &str) -> &'a str {
        self.texts.get(module).copied().unwrap_or_default()
    }

    /// The instances in a module, each with its name and its module.
    pub fn instances(&self, module: &str) -> BTreeSet<(&'a str, &'a str)> {
        let lines = self.text(module).lines();
        let instance = |line: &'a str| {
            let (module, rest) = line.trim().split_once(' ')?;
            let (name, _) = rest.split_once('(')?;
            (self.texts.contains_key(module)).then_some((name.trim(), module))
        };
        lines.filter_map(instance).collect()
    }

    /// The text of a module and of all modules below it.
    pub fn with_parts(&self, module: &str) -> String {
        let parts = self.instances(module).into_iter().map(|(_, part)| part);
        let mut names: BTreeSet<_> = parts.collect();
        names.insert(module);
        names.into_iter().map(|name| self.text(name)).collect()
    }
}

fn find_module(text: &str) -> Option<usize> {
    if text.starts_with("module ") {
        return Some(0);
    }
    text.find("\nmodule ").map(|at| at + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "// a\nmodule top(a, b);\n  input a;\n  output reg [3:0] b;\n  part one(\n    .a(a)\n  );\n  \
                        part two (.a(b));\nendmodule\n\nmodule part(a);\n  input a;\nendmodule\n";

    #[test]
    fn modules_and_their_instances_are_found() {
        let modules = Modules::of(TEXT);
        assert_eq!(modules.names().collect::<Vec<_>>(), ["part", "top"]);
        let instances = [("one", "part"), ("two", "part")];
        assert_eq!(modules.instances("top"), BTreeSet::from(instances));
        assert!(modules.instances("part").is_empty());
        assert!(modules.text("top").ends_with("endmodule\n"));
        assert_eq!(modules.text("none"), "");
        assert_eq!(modules.with_parts("part"), modules.text("part"));
    }
}
