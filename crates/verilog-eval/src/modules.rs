//! Cuts a Verilog text into modules. Any Verilog is cut, not only the subset that is evaluated: comments,
//! texts in quotation marks and escaped names are passed over.

use std::ops::Range;

/// The text of a module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModuleText<'t> {
    /// The name of the module.
    pub name: &'t str,
    /// The text from the word `module` to the word `endmodule`, both included.
    pub text: &'t str,
    /// The place of the text in the whole text, in bytes.
    pub place: Range<usize>,
    /// The length of the text up to the end of the module's name.
    name_end: usize,
}

impl<'t> ModuleText<'t> {
    /// The text between the module's name and the word `endmodule`: its ports and its items.
    pub fn body(&self) -> &'t str {
        &self.text[self.name_end..self.text.len() - END.len()]
    }

    /// The instances of modules in the module, of those that `is_module` names: the name of each instance, and
    /// the name of its module. An instance with parameters is not found.
    pub fn instances(&self, is_module: impl Fn(&str) -> bool) -> Vec<(&'t str, &'t str)> {
        let words: Vec<_> = words(self.body()).collect();
        let between = |a: &Range<usize>, b: usize| self.body()[a.end..b].trim();
        let instance = |pair: &[Range<usize>]| {
            let [module, name] = [&pair[0], &pair[1]].map(|word| &self.body()[word.clone()]);
            let opens = self.body()[pair[1].end..].trim_start().starts_with('(');
            let is_instance =
                is_module(module) && opens && between(&pair[0], pair[1].start).is_empty();
            is_instance.then_some((name, module))
        };
        words.windows(2).filter_map(instance).collect()
    }
}

const END: &str = "endmodule";

/// The modules of a text, in their order. A module without an `endmodule` is left out.
pub fn modules(text: &str) -> Vec<ModuleText<'_>> {
    let mut modules = Vec::new();
    let mut words = words(text);
    while let Some(word) = words.next() {
        if &text[word.clone()] != "module" {
            continue;
        }
        let (Some(name), Some(end)) = (words.next(), words.find(|end| &text[end.clone()] == END))
        else {
            break;
        };
        let place = word.start..end.end;
        modules.push(ModuleText {
            name: &text[name.clone()],
            text: &text[place.clone()],
            name_end: name.end - word.start,
            place,
        });
    }
    modules
}

/// The places of the initial values of a text, in their order: each `initial` statement as a whole, and in each
/// declaration `reg NAME = VALUE;` the text from the equals sign to the end of the value.
pub fn initial_values(text: &str) -> Vec<Range<usize>> {
    let mut places: Vec<Range<usize>> = Vec::new();
    for word in words(text) {
        let is_inside = places.last().is_some_and(|place| word.start < place.end);
        match &text[word.clone()] {
            "initial" if !is_inside => places.push(word.start..statement_end(text, word.end)),
            "reg" if !is_inside => {
                let declaration = &text[word.end..statement_end(text, word.end)];
                let value = declaration.find(['=', ';', ',', ')']);
                let value = value.filter(|&at| declaration[at..].starts_with('='));
                places.extend(value.map(|at| {
                    let end = declaration.trim_end_matches(';').len();
                    word.end + declaration[..at].trim_end().len()..word.end + end
                }));
            }
            _ => {}
        }
    }
    places
}

/// The end of the statement that begins at `from`: its semicolon, or the `end` of its block.
fn statement_end(text: &str, from: usize) -> usize {
    let (mut at, mut brackets, mut blocks) = (from, 0_u32, 0_u32);
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = match rest.find(|letter| !is_word(letter)) {
            Some(0) => passed_over(rest),
            Some(length) => length,
            None => rest.len(),
        };
        at += length;
        match &rest[..length] {
            "begin" => blocks += 1,
            "end" if blocks == 1 => return at,
            "end" => blocks = blocks.saturating_sub(1),
            _ if first == '(' => brackets += 1,
            _ if first == ')' => brackets = brackets.saturating_sub(1),
            _ if first == ';' && brackets == 0 && blocks == 0 => return at,
            _ => {}
        }
    }
    at
}

/// The places of the words of a text: names, keywords and numbers.
fn words(text: &str) -> impl Iterator<Item = Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let rest = &text[at..];
            let first = rest.chars().next()?;
            let length = if is_word(first) {
                rest.find(|letter| !is_word(letter)).unwrap_or(rest.len())
            } else {
                passed_over(rest)
            };
            let place = at..at + length;
            at = place.end;
            if is_word(first) {
                return Some(place);
            }
        }
    })
}

fn is_word(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_' || letter == '$'
}

/// The length of what begins here and is no word: a comment, a quoted text, an escaped name, or one character.
fn passed_over(rest: &str) -> usize {
    let to = |end: &str, from: usize| {
        let found = rest[from..].find(end);
        found.map_or(rest.len(), |at| from + at + end.len())
    };
    if rest.starts_with("//") {
        to("\n", 2)
    } else if rest.starts_with("/*") {
        to("*/", 2)
    } else if rest.starts_with('\\') {
        rest.find(char::is_whitespace).unwrap_or(rest.len())
    } else if let Some(quoted) = rest.strip_prefix('"') {
        let mut is_escaped = false;
        let end = quoted.find(|letter| {
            let ends = letter == '"' && !is_escaped;
            is_escaped = letter == '\\' && !is_escaped;
            ends
        });
        end.map_or(rest.len(), |at| at + 2)
    } else {
        rest.chars().next().map_or(0, char::len_utf8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "// module no;\nmodule top(a, b);\n  input a; /* endmodule */\n  part one(\n    .a(a)\n  );\n  \
                        part two (.a(b)), part;\n  initial $display(\"endmodule \\\" \", \\endmodule );\nendmodule // top\n\
                        module top$b();\nendmodule";

    #[test]
    fn a_text_is_cut_into_modules() {
        let modules = modules(TEXT);
        let names: Vec<_> = modules.iter().map(|module| module.name).collect();
        assert_eq!(names, ["top", "top$b"]);
        assert!(modules[0].text.starts_with("module top(a, b);"));
        assert!(modules[0].text.ends_with(");\nendmodule"));
        assert_eq!(&TEXT[modules[0].place.clone()], modules[0].text);
        assert_eq!(modules[1].body(), "();\n");
    }

    #[test]
    fn a_module_that_does_not_end_is_left_out() {
        assert_eq!(modules("module a(); // endmodule"), []);
        assert_eq!(modules("endmodule \"module"), []);
        assert_eq!(modules("module"), []);
    }

    #[test]
    fn initial_values_are_statements_and_values_of_declarations() {
        let text = "module m(input wire a, output reg b);\n  reg [7:0] c = 8'd1;\n  reg d; // initial e = 1;\n  \
                    initial b = f(1'd0);\n  initial for (i = 0; i < 2; i = i + 1) w[i] = 0;\n  initial begin\n    \
                    if (a) begin c = 2; end\n    d = 1;\n  end\n  reg [1:0] w [0:1];\nendmodule";
        let found: Vec<_> = initial_values(text)
            .into_iter()
            .map(|place| &text[place])
            .collect();
        let expected = [
            " = 8'd1",
            "initial b = f(1'd0);",
            "initial for (i = 0; i < 2; i = i + 1) w[i] = 0;",
            "initial begin\n    if (a) begin c = 2; end\n    d = 1;\n  end",
        ];
        assert_eq!(found, expected);
        assert_eq!(
            initial_values("initial begin a = 1;").first(),
            Some(&(0..20))
        );
    }

    #[test]
    fn instances_are_names_before_a_bracket() {
        let top = &modules(TEXT)[0];
        let found = top.instances(|name| name == "part");
        assert_eq!(found, [("one", "part"), ("two", "part")]);
        assert_eq!(top.instances(|name| name == "input"), []);
    }
}
