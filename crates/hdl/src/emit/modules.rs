//! Splits rust-hdl's printed text into modules.

/// A module as rust-hdl prints it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Module {
    /// The module's name: the path of its instance, joined by `$`.
    pub name: String,
    /// The text from the opening parenthesis after the name up to `endmodule`, without `endmodule`.
    pub body: String,
}

/// Splits the text into its modules, which keep the order of the text.
pub(super) fn split(text: &str) -> Vec<Module> {
    let modules = verilog_eval::modules(text).into_iter();
    let module = |module: verilog_eval::ModuleText<'_>| Module {
        name: module.name.to_owned(),
        body: module.body().to_owned(),
    };
    modules.map(module).collect()
}

/// Replaces every identifier of a text by the result of `rename`. A number such as `8'hff` is not an
/// identifier. Identifiers in comments are replaced too; rust-hdl prints no comments of interest.
pub(super) fn rename_identifiers(text: &str, mut rename: impl FnMut(&str) -> String) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
    let mut renamed = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(is_word) {
        renamed += &rest[..start];
        let tail = &rest[start..];
        let word = &tail[..tail.find(|c| !is_word(c)).unwrap_or(tail.len())];
        let in_number = renamed.ends_with('\'') || word.starts_with(|c: char| c.is_ascii_digit());
        renamed += &if in_number {
            word.to_owned()
        } else {
            rename(word)
        };
        rest = &tail[word.len()..];
    }
    renamed + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_cut_into_modules() {
        let text = "\n\nmodule top(a);\n  x\nendmodule // top\nmodule top$b();\nendmodule // top$b";
        let modules = split(text);
        assert_eq!(modules[0].name, "top");
        assert_eq!(modules[0].body, "(a);\n  x\n");
        assert_eq!(modules[1].name, "top$b");
        assert_eq!(modules.len(), 2);
    }

    #[test]
    fn identifiers_are_renamed_and_numbers_are_not() {
        let renamed = rename_identifiers("a$0 = b + 8'hb + 12;", |word| word.to_uppercase());
        assert_eq!(renamed, "A$0 = B + 8'hb + 12;");
    }
}
