//! The modules of a Verilog text with their instances.

use std::collections::{BTreeMap, BTreeSet};

use verilog_eval::{ModuleText, modules};

/// The text of each module, by name.
#[derive(Debug)]
pub(super) struct Modules<'a> {
    texts: BTreeMap<&'a str, ModuleText<'a>>,
}

impl<'a> Modules<'a> {
    pub fn of(text: &'a str) -> Self {
        let modules = modules(text).into_iter();
        let texts = modules.map(|module| (module.name, module)).collect();
        Self { texts }
    }

    /// The names of the modules.
    pub fn names(&self) -> impl Iterator<Item = &'a str> {
        self.texts.keys().copied()
    }

    /// The text of a module; empty where it does not exist.
    pub fn text(&self, module: &str) -> &'a str {
        self.texts.get(module).map_or("", |module| module.text)
    }

    /// The instances in a module, each with its name and its module.
    pub fn instances(&self, module: &str) -> BTreeSet<(&'a str, &'a str)> {
        let module = self.texts.get(module).into_iter();
        let is_module = |name: &str| self.texts.contains_key(name);
        module
            .flat_map(|module| module.instances(is_module))
            .collect()
    }

    /// The text of a module and of all modules below it.
    pub fn with_parts(&self, module: &str) -> String {
        let parts = self.instances(module).into_iter().map(|(_, part)| part);
        let mut names: BTreeSet<_> = parts.collect();
        names.insert(module);
        let texts = names
            .into_iter()
            .map(|name| self.text(name).to_owned() + "\n");
        texts.collect()
    }
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
        assert!(modules.text("top").ends_with("endmodule"));
        assert_eq!(modules.text("none"), "");
        assert_eq!(
            modules.with_parts("part"),
            modules.text("part").to_owned() + "\n"
        );
    }
}
