//! Parses expressions and numbers.

use winnow::Parser;
use winnow::combinator::{delimited, separated};

use super::super::syntax::{Binary, Expression, ExpressionKind, Number, Range, Select, Unary};
use super::token::Kind;
use super::{Parsed, Tokens, expect, is_next, line, mismatch, name, peek, take};
use winnow::stream::Stream;

/// Parses an expression; `? :` has the lowest precedence and associates to the right.
pub fn expression(tokens: &mut Tokens<'_>) -> Parsed<Expression> {
    let line = line(tokens);
    let condition = binary(tokens, 0)?;
    if !take(tokens, "?") {
        return Ok(condition);
    }
    let then = expression(tokens)?;
    expect(":").parse_next(tokens)?;
    let otherwise = expression(tokens)?;
    let kind = ExpressionKind::Conditional(Box::new([condition, then, otherwise]));
    Ok(Expression { kind, line })
}

/// Parses operators that bind tighter than `below`; they associate to the left.
fn binary(tokens: &mut Tokens<'_>, below: u32) -> Parsed<Expression> {
    let line = line(tokens);
    let mut left = unary(tokens)?;
    while let Some((operator, precedence)) = Binary::of(peek(tokens).text) {
        if precedence <= below {
            break;
        }
        tokens.next_token();
        let right = binary(tokens, precedence)?;
        let kind = ExpressionKind::Binary(operator, Box::new(left), Box::new(right));
        left = Expression { kind, line };
    }
    Ok(left)
}

fn unary(tokens: &mut Tokens<'_>) -> Parsed<Expression> {
    let token = peek(tokens);
    let operator = match token.kind {
        Kind::Symbol => Unary::of(token.text),
        _ => None,
    };
    let Some(operator) = operator else {
        return primary(tokens);
    };
    tokens.next_token();
    let operand = Box::new(unary(tokens)?);
    let kind = ExpressionKind::Unary(operator, operand);
    let line = token.line;
    Ok(Expression { kind, line })
}

fn primary(tokens: &mut Tokens<'_>) -> Parsed<Expression> {
    let token = peek(tokens);
    let line = token.line;
    let kind = match (token.kind, token.text) {
        (Kind::Symbol, "(") => {
            return delimited(expect("("), expression, expect(")")).parse_next(tokens);
        }
        (Kind::Symbol, "{") => braces(tokens)?,
        (Kind::Number, text) => {
            let Some(number) = number(text) else {
                return mismatch(tokens, "a number without unknown bits");
            };
            tokens.next_token();
            ExpressionKind::Number(number)
        }
        (Kind::Word, "$signed" | "$unsigned") => {
            tokens.next_token();
            let value = delimited(expect("("), expression, expect(")")).parse_next(tokens)?;
            ExpressionKind::Cast {
                signed: token.text == "$signed",
                value: Box::new(value),
            }
        }
        (Kind::Word, _) => {
            let name = name(tokens)?;
            match is_next(tokens, "(") {
                true => ExpressionKind::Call(name, arguments(tokens)?),
                false => ExpressionKind::Name(name, selects(tokens)?),
            }
        }
        _ => return mismatch(tokens, "an expression"),
    };
    Ok(Expression { kind, line })
}

fn arguments(tokens: &mut Tokens<'_>) -> Parsed<Vec<Expression>> {
    let list = separated(1.., expression, comma);
    delimited(expect("("), list, expect(")")).parse_next(tokens)
}

/// A comma, or the end of a list.
pub fn comma(tokens: &mut Tokens<'_>) -> Parsed<()> {
    match take(tokens, ",") {
        true => Ok(()),
        false => mismatch(tokens, ",").map_err(|error| error.backtrack()),
    }
}

/// A concatenation, or a replication of one.
fn braces(tokens: &mut Tokens<'_>) -> Parsed<ExpressionKind> {
    expect("{").parse_next(tokens)?;
    let first = expression(tokens)?;
    if is_next(tokens, "{") {
        let list = separated(1.., expression, comma);
        let parts = delimited(expect("{"), list, expect("}")).parse_next(tokens)?;
        expect("}").parse_next(tokens)?;
        return Ok(ExpressionKind::Replication(Box::new(first), parts));
    }
    let mut parts = vec![first];
    while take(tokens, ",") {
        parts.push(expression(tokens)?);
    }
    expect("}").parse_next(tokens)?;
    Ok(ExpressionKind::Concatenation(parts))
}

/// Parses the selects in brackets after a name.
pub fn selects(tokens: &mut Tokens<'_>) -> Parsed<Vec<Select>> {
    let mut selects = Vec::new();
    while take(tokens, "[") {
        let first = expression(tokens)?;
        selects.push(if take(tokens, ":") {
            Select::Range(Range {
                left: first,
                right: expression(tokens)?,
            })
        } else if take(tokens, "+:") {
            Select::Up(first, expression(tokens)?)
        } else {
            Select::One(first)
        });
        expect("]").parse_next(tokens)?;
    }
    Ok(selects)
}

/// Parses `[left:right]`, if it comes next.
pub fn range(tokens: &mut Tokens<'_>) -> Parsed<Option<Range>> {
    if !take(tokens, "[") {
        return Ok(None);
    }
    let left = expression(tokens)?;
    expect(":").parse_next(tokens)?;
    let right = expression(tokens)?;
    expect("]").parse_next(tokens)?;
    Ok(Some(Range { left, right }))
}

/// The value of a number; `None` where a character is not a digit, or a bit is unknown.
fn number(text: &str) -> Option<Number> {
    let Some((size, based)) = text.split_once('\'') else {
        return Some(Number {
            width: None,
            signed: true,
            words: vec![decimal(text)?],
        });
    };
    let width = match size {
        "" => None,
        size => Some(
            u32::try_from(decimal(size)?)
                .ok()
                .filter(|&width| width > 0)?,
        ),
    };
    let unsigned = based.strip_prefix(['s', 'S']);
    let signed = unsigned.is_some();
    let mut letters = unsigned.unwrap_or(based).chars();
    let bits = match letters.next()?.to_ascii_lowercase() {
        'b' => 1,
        'o' => 3,
        'h' => 4,
        'd' => {
            let words = vec![decimal(letters.as_str())?];
            return Some(Number {
                width,
                signed,
                words,
            });
        }
        _ => return None,
    };
    let words = power_of_two_digits(letters.as_str(), bits)?;
    Some(Number {
        width,
        signed,
        words,
    })
}

fn decimal(digits: &str) -> Option<u64> {
    digits.replace('_', "").parse().ok()
}

fn power_of_two_digits(digits: &str, bits: u32) -> Option<Vec<u64>> {
    let mut words = vec![0];
    let mut low = 0;
    let letters = digits.chars().rev().filter(|&letter| letter != '_');
    for letter in letters {
        let digit = u64::from(letter.to_digit(1 << bits)?);
        for bit in 0..bits {
            let (word, place) = ((low / 64) as usize, low % 64);
            if word == words.len() {
                words.push(0);
            }
            words[word] |= (digit >> bit & 1) << place;
            low += 1;
        }
    }
    (low > 0).then_some(words)
}
