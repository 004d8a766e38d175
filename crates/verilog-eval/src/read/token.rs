//! Splits the text into tokens. Comments and attributes `(* .. *)` have no meaning in a simulation and are
//! dropped.

use winnow::Parser;
use winnow::combinator::{alt, delimited, not, opt, preceded};
use winnow::error::{EmptyError, Result};
use winnow::token::{literal, one_of, take_until, take_while};

use super::super::syntax::Line;
use super::super::{Refusal, refuse};

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A name or a keyword.
    Word,
    Number,
    Symbol,
    /// The end of the text.
    End,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Token<'t> {
    pub kind: Kind,
    pub text: &'t str,
    pub line: Line,
}

/// The symbols of more than one character, the longest first.
const SYMBOLS: [&str; 19] = [
    "<<<", ">>>", "===", "!==", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "~&", "~|", "~^",
    "^~", "+:", "-:", "**",
];

/// Cuts a text into tokens.
pub fn tokens(text: &str) -> std::result::Result<Vec<Token<'_>>, Refusal> {
    let mut tokens = Vec::new();
    let (mut rest, mut line) = (text, 1);
    while !rest.is_empty() {
        let before = rest;
        let Ok(found) = lexeme.parse_next(&mut rest) else {
            let word = before.split_whitespace().next().unwrap_or_default();
            return refuse(line, format!("`{word}`"));
        };
        if let Some((kind, text)) = found {
            tokens.push(Token { kind, text, line });
        }
        let taken = &before[..before.len() - rest.len()];
        line += taken.bytes().filter(|&byte| byte == b'\n').count() as Line;
    }
    tokens.push(Token {
        kind: Kind::End,
        text: "the end of the text",
        line,
    });
    Ok(tokens)
}

fn lexeme<'t>(rest: &mut &'t str) -> Result<Option<(Kind, &'t str)>, EmptyError> {
    alt((
        blank.value(None),
        number.map(|text| Some((Kind::Number, text))),
        word.map(|text| Some((Kind::Word, text))),
        symbol.map(|text| Some((Kind::Symbol, text))),
    ))
    .parse_next(rest)
}

fn blank(rest: &mut &str) -> Result<(), EmptyError> {
    let space = take_while(1.., char::is_whitespace).void();
    let comment = ("//", take_while(0.., |letter| letter != '\n')).void();
    let long_comment = ("/*", take_until(0.., "*/"), "*/").void();
    // `@(*)` does not begin an attribute.
    let opening = ("(*", not((take_while(0.., ' '), ')')));
    let attribute = delimited(opening, take_until(0.., "*)"), "*)").void();
    alt((space, comment, long_comment, attribute)).parse_next(rest)
}

fn number<'t>(rest: &mut &'t str) -> Result<&'t str, EmptyError> {
    let digits = |rest: &mut &'t str| take_while(0.., is_name_letter).parse_next(rest);
    let based = preceded('\'', digits);
    let sized = (
        take_while(1.., |c: char| c.is_ascii_digit() || c == '_'),
        opt(based),
    )
        .take();
    alt((sized, ('\'', digits).take())).parse_next(rest)
}

fn is_name_letter(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '_' || letter == '$'
}

fn word<'t>(rest: &mut &'t str) -> Result<&'t str, EmptyError> {
    let first =
        one_of(|letter: char| letter.is_ascii_alphabetic() || letter == '_' || letter == '$');
    (first, take_while(0.., is_name_letter))
        .take()
        .parse_next(rest)
}

fn symbol<'t>(rest: &mut &'t str) -> Result<&'t str, EmptyError> {
    if let Some(symbol) = SYMBOLS.into_iter().find(|symbol| rest.starts_with(symbol)) {
        return literal(symbol).parse_next(rest);
    }
    one_of(|letter| "()[]{};:,.#@=+-*/%&|^~!<>?".contains(letter))
        .take()
        .parse_next(rest)
}
