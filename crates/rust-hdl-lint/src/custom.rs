//! Lists blocks whose Verilog is text, and checks the text as far as possible.

use std::collections::BTreeSet;

use rust_hdl::prelude::Verilog;

use super::design::Module;
use super::finding::{Fault, Findings};
use super::keyword::is_keyword;
use super::rule::Rule;

/// The form in which a block supplies its own Verilog text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpaqueKind {
    /// The text of rust-hdl's `DFF`, with any initial value.
    Register,
    /// Any other `Verilog::Custom`.
    Custom,
    /// A `Verilog::Wrapper`.
    Wrapper,
    /// A `Verilog::Blackbox`.
    Blackbox,
}

/// A block that the lint cannot prove.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Opaque {
    /// The name of the block's module in the emitted text.
    pub path: String,
    /// The form in which the block supplies its text.
    pub kind: OpaqueKind,
    /// The text, with every run of white space replaced by one blank.
    pub text: String,
}

impl Opaque {
    pub(super) fn of(path: &str, hdl: &Verilog) -> Option<Self> {
        let (kind, text) = match hdl {
            Verilog::Empty | Verilog::Combinatorial(_) => return None,
            Verilog::Custom(text) if is_register(&squeezed(text)) => (OpaqueKind::Register, text),
            Verilog::Custom(text) => (OpaqueKind::Custom, text),
            Verilog::Wrapper(wrapper) => (OpaqueKind::Wrapper, &wrapper.code),
            Verilog::Blackbox(blackbox) => (OpaqueKind::Blackbox, &blackbox.code),
        };
        Some(Opaque {
            path: path.to_owned(),
            kind,
            text: squeezed(text),
        })
    }
}

fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn is_register(text: &str) -> bool {
    text.strip_prefix("initial begin q = ")
        .and_then(|rest| rest.strip_suffix("; end always @(posedge clock) begin q <= d; end"))
        .is_some_and(|value| {
            value
                .chars()
                .all(|c| c.is_ascii_alphanumeric() || c == '\'')
        })
}

/// Checks the properties that text shows: names without a declaration, memories without initial values.
pub(super) fn check(module: &Module, text: &str, findings: &mut Findings) {
    let tokens = tokens(text);
    for name in undeclared(module, &tokens) {
        findings.add(
            Fault::about(Rule::StaleName, &name),
            &format!("custom text, {name}"),
        );
    }
    for memory in memories(&tokens) {
        if !is_initialised(&memory, &tokens) {
            findings.add(
                Rule::UninitialisedMemory,
                &format!("memory {}", memory.name),
            );
        }
    }
}

/// The words and signs of the text, without comments, strings, attributes and the bases of numbers.
fn tokens(text: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = skipped(rest);
        if length > 0 {
            rest = &rest[length..];
            continue;
        }
        let in_word = |c: char| c.is_ascii_alphanumeric() || "_$'`".contains(c);
        let word = rest.find(|c| !in_word(c)).unwrap_or(rest.len());
        let length = if word > 0 { word } else { first.len_utf8() };
        tokens.push(rest[..length].to_owned());
        rest = &rest[length..];
    }
    tokens
}

/// The length of the comment, string or attribute that starts here; 0 if none does.
fn skipped(text: &str) -> usize {
    const PAIRS: [(&str, &str); 4] = [("//", "\n"), ("/*", "*/"), ("\"", "\""), ("(* ", "*)")];
    for (open, close) in PAIRS {
        if let Some(inside) = text.strip_prefix(open) {
            let end = inside
                .find(close)
                .map_or(inside.len(), |at| at + close.len());
            return open.len() + end;
        }
    }
    text.len() - text.trim_start().len()
}

fn is_identifier(token: &str) -> bool {
    token.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && !token.contains('\'')
        && !is_keyword(token)
}

/// The identifiers that neither the module nor the text declares. Text with modules, functions or instances
/// of its own is not checked.
fn undeclared(module: &Module, tokens: &[String]) -> BTreeSet<String> {
    let instance = tokens
        .windows(2)
        .any(|pair| pair.iter().all(|token| is_identifier(token)));
    let own_scope = ["module", "function", "task", "generate"];
    if instance
        || tokens
            .iter()
            .any(|token| own_scope.contains(&token.as_str()))
    {
        return BTreeSet::new();
    }
    let declared = declared(tokens);
    let mut previous = "";
    let mut names = BTreeSet::new();
    for token in tokens {
        let known = module.symbols.contains_key(token) || declared.contains(token.as_str());
        if is_identifier(token) && !known && previous != "." {
            names.insert(token.clone());
        }
        previous = token;
    }
    names
}

/// Every identifier in a declaration, and every label of a block.
fn declared(tokens: &[String]) -> BTreeSet<&str> {
    const STARTS: [&str; 8] = [
        "reg",
        "wire",
        "integer",
        "genvar",
        "real",
        "time",
        "localparam",
        "parameter",
    ];
    let mut names = BTreeSet::new();
    let mut inside = false;
    for (place, token) in tokens.iter().enumerate() {
        inside = (inside || STARTS.contains(&token.as_str())) && token != ";";
        let label = place > 1 && tokens[place - 1] == ":" && tokens[place - 2] == "begin";
        if (inside || label) && is_identifier(token) {
            names.insert(token.as_str());
        }
    }
    names
}

/// A `reg [7:0] mem [0:255];`.
struct Memory {
    name: String,
    /// The number of words, if the text gives it in digits.
    words: Option<usize>,
}

fn memories(tokens: &[String]) -> Vec<Memory> {
    let declarations = tokens.split(|token| token == ";").filter_map(|statement| {
        let start = statement.iter().rposition(|token| token == "reg")?;
        memory(&statement[start + 1..])
    });
    declarations.collect()
}

fn memory(declaration: &[String]) -> Option<Memory> {
    let at = declaration
        .windows(2)
        .position(|pair| is_identifier(&pair[0]) && pair[1] == "[")?;
    if at > 0 && !["]", "signed"].contains(&declaration[at - 1].as_str()) {
        return None;
    }
    let bounds: Vec<usize> = declaration[at + 2..]
        .iter()
        .filter_map(|token| token.parse().ok())
        .collect();
    let words = match bounds[..] {
        [one, two] => Some(one.abs_diff(two) + 1),
        _ => None,
    };
    Some(Memory {
        name: declaration[at].clone(),
        words,
    })
}

/// Whether an initial block fills the memory: by a loop, by a file, or word by word.
fn is_initialised(memory: &Memory, tokens: &[String]) -> bool {
    let has = |word: &str| tokens.iter().any(|token| token == word);
    if !has("initial") {
        return false;
    }
    if has("for") || has("$readmemh") || has("$readmemb") {
        return true;
    }
    let stores = tokens
        .windows(5)
        .filter(|five| five[0] == memory.name && five[1] == "[" && five[3] == "]" && five[4] == "=")
        .count();
    memory.words.is_none_or(|words| stores >= words)
}
