//! Parses the statements of blocks and functions.

use winnow::Parser;
use winnow::combinator::{delimited, separated};

use super::super::syntax::{Assignment, Expression, ExpressionKind, For, Statement};
use super::expression::{comma, expression, selects};
use super::token::Kind;
use super::{Parsed, Tokens, expect, is_next, line, mismatch, name, peek, take};

pub fn statement(tokens: &mut Tokens<'_>) -> Parsed<Statement> {
    match peek(tokens).text {
        "begin" => block(tokens),
        "if" => conditional(tokens),
        "case" => case(tokens),
        "for" => repetition(tokens),
        ";" => expect(";").map(|()| Statement::Nothing).parse_next(tokens),
        _ => assignment(tokens),
    }
}

fn block(tokens: &mut Tokens<'_>) -> Parsed<Statement> {
    expect("begin").parse_next(tokens)?;
    let mut statements = Vec::new();
    while !take(tokens, "end") {
        if peek(tokens).kind == Kind::End {
            return mismatch(tokens, "end");
        }
        statements.push(statement(tokens)?);
    }
    Ok(Statement::Block(statements))
}

fn conditional(tokens: &mut Tokens<'_>) -> Parsed<Statement> {
    expect("if").parse_next(tokens)?;
    let condition = delimited(expect("("), expression, expect(")")).parse_next(tokens)?;
    let then = Box::new(statement(tokens)?);
    let otherwise = match take(tokens, "else") {
        true => Some(Box::new(statement(tokens)?)),
        false => None,
    };
    Ok(Statement::If {
        condition,
        then,
        otherwise,
    })
}

fn case(tokens: &mut Tokens<'_>) -> Parsed<Statement> {
    expect("case").parse_next(tokens)?;
    let selector = delimited(expect("("), expression, expect(")")).parse_next(tokens)?;
    let (mut items, mut default) = (Vec::new(), None);
    while !take(tokens, "endcase") {
        if is_next(tokens, "default") {
            if default.is_some() {
                return mismatch(tokens, "one default");
            }
            take(tokens, "default");
            take(tokens, ":");
            default = Some(Box::new(statement(tokens)?));
            continue;
        }
        let labels = separated(1.., expression, comma).parse_next(tokens)?;
        expect(":").parse_next(tokens)?;
        items.push((labels, statement(tokens)?));
    }
    Ok(Statement::Case {
        selector,
        items,
        default,
    })
}

fn repetition(tokens: &mut Tokens<'_>) -> Parsed<Statement> {
    let line = line(tokens);
    expect("for").parse_next(tokens)?;
    expect("(").parse_next(tokens)?;
    let first = plain(tokens)?;
    expect(";").parse_next(tokens)?;
    let condition = expression(tokens)?;
    expect(";").parse_next(tokens)?;
    let next = plain(tokens)?;
    expect(")").parse_next(tokens)?;
    Ok(Statement::For(Box::new(For {
        first,
        condition,
        next,
        body: statement(tokens)?,
        line,
    })))
}

/// Parses `target = value`.
pub fn plain(tokens: &mut Tokens<'_>) -> Parsed<Assignment> {
    let line = line(tokens);
    let target = target(tokens)?;
    expect("=").parse_next(tokens)?;
    let value = expression(tokens)?;
    Ok(Assignment {
        target,
        value,
        line,
    })
}

fn assignment(tokens: &mut Tokens<'_>) -> Parsed<Statement> {
    let line = line(tokens);
    let target = target(tokens)?;
    let clocked = take(tokens, "<=");
    if !clocked {
        expect("=").parse_next(tokens)?;
    }
    let value = expression(tokens)?;
    expect(";").parse_next(tokens)?;
    let assignment = Assignment {
        target,
        value,
        line,
    };
    Ok(match clocked {
        true => Statement::Nonblocking(assignment),
        false => Statement::Blocking(assignment),
    })
}

/// Parses a signal, a part of one, or several in braces.
fn target(tokens: &mut Tokens<'_>) -> Parsed<Expression> {
    let line = line(tokens);
    let kind = if is_next(tokens, "{") {
        let list = separated(1.., target, comma);
        let parts = delimited(expect("{"), list, expect("}")).parse_next(tokens)?;
        ExpressionKind::Concatenation(parts)
    } else {
        if peek(tokens).kind != Kind::Word {
            return mismatch(tokens, "a statement");
        }
        ExpressionKind::Name(name(tokens)?, selects(tokens)?)
    };
    Ok(Expression { kind, line })
}
