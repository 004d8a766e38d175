//! Parses the subset: a grammar of the Verilog that `generate` emits and that rust-hdl prints, on winnow's
//! parsers. A text that no rule matches is refused with its line.
//!
//! `sv-parser`, which knows all of SystemVerilog, was tried first. It takes minutes to build, and its trees
//! have no precedence of operators.

mod expression;
mod module;
mod statement;
mod token;

use winnow::Parser;
use winnow::combinator::cut_err;
use winnow::error::{ErrMode, ParserError};
use winnow::stream::{Stream, TokenSlice};
use winnow::token::any;

use super::syntax::{Line, Module};
use super::{Refusal, refuse};
use token::{Kind, Token};

type Tokens<'t> = TokenSlice<'t, Token<'t>>;

type Parsed<T> = Result<T, ErrMode<Mismatch>>;

/// The place at which no rule matches, and the tokens that would match.
#[derive(Clone, Debug)]
struct Mismatch {
    /// The number of tokens from that place to the end.
    left: usize,
    expected: &'static str,
}

impl<'t> ParserError<Tokens<'t>> for Mismatch {
    type Inner = Self;

    fn from_input(tokens: &Tokens<'t>) -> Self {
        Self {
            left: tokens.eof_offset(),
            expected: "another word",
        }
    }

    fn into_inner(self) -> Result<Self, Self> {
        Ok(self)
    }
}

/// Parses all modules of a text.
pub fn read(text: &str) -> Result<Vec<Module>, Refusal> {
    let tokens = token::tokens(text)?;
    let mut rest = Tokens::new(&tokens);
    let mut modules = Vec::new();
    while peek(&rest).kind != Kind::End {
        match module::module.parse_next(&mut rest) {
            Ok(module) => modules.push(module),
            Err(error) => return refusal(&tokens, error),
        }
    }
    Ok(modules)
}

fn refusal<T>(tokens: &[Token<'_>], error: ErrMode<Mismatch>) -> Result<T, Refusal> {
    let (ErrMode::Backtrack(mismatch) | ErrMode::Cut(mismatch)) = error else {
        unreachable!("the text is all there");
    };
    // The first token that no rule matches.
    let found = &tokens[tokens.len() - mismatch.left];
    refuse(
        found.line,
        format!("`{}`; expected {}", found.text, mismatch.expected),
    )
}

/// The next token. The last token is never removed.
fn peek<'t>(tokens: &Tokens<'t>) -> Token<'t> {
    **tokens
        .peek_token()
        .as_ref()
        .expect("the end is never taken")
}

fn line(tokens: &Tokens<'_>) -> Line {
    peek(tokens).line
}

fn is_next(tokens: &Tokens<'_>, text: &str) -> bool {
    let token = peek(tokens);
    token.text == text && token.kind != Kind::End
}

/// Removes the token of this text, if it comes next.
fn take(tokens: &mut Tokens<'_>, text: &str) -> bool {
    let taken = is_next(tokens, text);
    if taken {
        tokens.next_token();
    }
    taken
}

/// The error of a rule that does not match here.
fn mismatch<T>(tokens: &Tokens<'_>, expected: &'static str) -> Parsed<T> {
    Err(ErrMode::Cut(Mismatch {
        left: tokens.eof_offset(),
        expected,
    }))
}

/// Parses the token of this text.
fn expect<'t>(text: &'static str) -> impl Parser<Tokens<'t>, (), ErrMode<Mismatch>> {
    move |tokens: &mut Tokens<'t>| match take(tokens, text) {
        true => Ok(()),
        false => mismatch(tokens, text),
    }
}

/// The keywords of IEEE 1364-2005 that can appear where a name could.
const KEYWORDS: [&str; 60] = [
    "always",
    "and",
    "assign",
    "begin",
    "buf",
    "case",
    "casex",
    "casez",
    "deassign",
    "default",
    "defparam",
    "disable",
    "edge",
    "else",
    "end",
    "endcase",
    "endfunction",
    "endgenerate",
    "endmodule",
    "endtask",
    "event",
    "for",
    "force",
    "forever",
    "fork",
    "function",
    "generate",
    "genvar",
    "if",
    "initial",
    "inout",
    "input",
    "integer",
    "join",
    "localparam",
    "module",
    "nand",
    "negedge",
    "nor",
    "not",
    "or",
    "output",
    "parameter",
    "posedge",
    "primitive",
    "real",
    "reg",
    "release",
    "repeat",
    "signed",
    "specify",
    "supply0",
    "supply1",
    "task",
    "time",
    "tri",
    "wait",
    "while",
    "wire",
    "xor",
];

/// A name.
fn name<'t>(tokens: &mut Tokens<'t>) -> Parsed<String> {
    let token = peek(tokens);
    let is_name =
        token.kind == Kind::Word && !token.text.starts_with('$') && !KEYWORDS.contains(&token.text);
    if !is_name {
        return mismatch(tokens, "a name");
    }
    cut_err(any)
        .map(|token: &Token<'t>| token.text.to_owned())
        .parse_next(tokens)
}
