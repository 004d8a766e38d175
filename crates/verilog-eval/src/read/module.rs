//! Parses modules and their contents.

use winnow::Parser;
use winnow::combinator::{delimited, separated};
use winnow::stream::Stream;

use super::super::syntax::{
    Always, Declaration, Direction, Expression, Function, Instance, Item, Kind, Module, Parameter,
};
use super::expression::{comma, expression, range};
use super::statement::{plain, statement};
use super::token::Kind as TokenKind;
use super::{Parsed, Tokens, expect, is_next, line, mismatch, name, peek, take};

pub fn module(tokens: &mut Tokens<'_>) -> Parsed<Module> {
    let line = line(tokens);
    expect("module").parse_next(tokens)?;
    let name = name(tokens)?;
    let mut ports = Vec::new();
    if take(tokens, "(") && !take(tokens, ")") {
        ports = separated(1.., super::name, comma).parse_next(tokens)?;
        expect(")").parse_next(tokens)?;
    }
    expect(";").parse_next(tokens)?;
    let mut items = Vec::new();
    while !take(tokens, "endmodule") {
        item(tokens, &mut items)?;
    }
    Ok(Module {
        name,
        ports,
        items,
        line,
    })
}

fn item(tokens: &mut Tokens<'_>, items: &mut Vec<Item>) -> Parsed<()> {
    match peek(tokens).text {
        "input" | "output" | "wire" | "reg" | "integer" => {
            items.extend(declarations(tokens)?.into_iter().map(Item::Declaration));
        }
        "localparam" | "parameter" => {
            items.extend(parameters(tokens)?.into_iter().map(Item::Parameter));
        }
        "assign" => {
            expect("assign").parse_next(tokens)?;
            let assignments: Vec<_> = separated(1.., plain, comma).parse_next(tokens)?;
            expect(";").parse_next(tokens)?;
            items.extend(assignments.into_iter().map(Item::Assign));
        }
        "always" => items.push(Item::Always(always(tokens)?)),
        "initial" => {
            expect("initial").parse_next(tokens)?;
            items.push(Item::Initial(statement(tokens)?));
        }
        "function" => items.push(Item::Function(function(tokens)?)),
        _ if peek(tokens).kind == TokenKind::Word => items.push(Item::Instance(instance(tokens)?)),
        _ => return mismatch(tokens, "a declaration, a block or an instance"),
    }
    Ok(())
}

/// Parses a declaration of one or several names.
fn declarations(tokens: &mut Tokens<'_>) -> Parsed<Vec<Declaration>> {
    let direction = if take(tokens, "input") {
        Some(Direction::Input)
    } else if take(tokens, "output") {
        Some(Direction::Output)
    } else {
        None
    };
    let kind = if take(tokens, "reg") {
        Kind::Reg
    } else if take(tokens, "integer") {
        Kind::Integer
    } else {
        let named = take(tokens, "wire");
        if !named && direction.is_none() {
            return mismatch(tokens, "wire, reg or integer");
        }
        Kind::Wire
    };
    let signed = take(tokens, "signed");
    let mut declarations = Vec::new();
    let start = tokens.checkpoint();
    loop {
        // Each name has the range, so the range is parsed again for each.
        let after = tokens.checkpoint();
        tokens.reset(&start);
        let range = range(tokens)?;
        if !declarations.is_empty() {
            tokens.reset(&after);
        }
        let line = line(tokens);
        let name = name(tokens)?;
        declarations.push(Declaration {
            name,
            direction,
            kind,
            signed,
            range,
            words: super::expression::range(tokens)?,
            value: value(tokens)?,
            line,
        });
        if !take(tokens, ",") {
            expect(";").parse_next(tokens)?;
            return Ok(declarations);
        }
    }
}

fn value(tokens: &mut Tokens<'_>) -> Parsed<Option<Expression>> {
    match take(tokens, "=") {
        true => expression(tokens).map(Some),
        false => Ok(None),
    }
}

fn parameters(tokens: &mut Tokens<'_>) -> Parsed<Vec<Parameter>> {
    let local = take(tokens, "localparam");
    if !local {
        expect("parameter").parse_next(tokens)?;
    }
    let signed = take(tokens, "signed");
    let range = range(tokens)?;
    let line = line(tokens);
    let name = name(tokens)?;
    expect("=").parse_next(tokens)?;
    let value = expression(tokens)?;
    expect(";").parse_next(tokens)?;
    Ok(vec![Parameter {
        name,
        local,
        signed,
        range,
        value,
        line,
    }])
}

fn always(tokens: &mut Tokens<'_>) -> Parsed<Always> {
    let line = line(tokens);
    expect("always").parse_next(tokens)?;
    expect("@").parse_next(tokens)?;
    let clock = match take(tokens, "*") {
        true => None,
        false => delimited(expect("("), event, expect(")")).parse_next(tokens)?,
    };
    Ok(Always {
        clock,
        body: statement(tokens)?,
        line,
    })
}

/// Parses `*` or `posedge clock`.
fn event(tokens: &mut Tokens<'_>) -> Parsed<Option<String>> {
    if take(tokens, "*") {
        return Ok(None);
    }
    if !take(tokens, "posedge") {
        return mismatch(tokens, "* or posedge");
    }
    name(tokens).map(Some)
}

fn function(tokens: &mut Tokens<'_>) -> Parsed<Function> {
    let line = line(tokens);
    expect("function").parse_next(tokens)?;
    let signed = take(tokens, "signed");
    let range = range(tokens)?;
    let name = name(tokens)?;
    expect(";").parse_next(tokens)?;
    let mut variables: Vec<Declaration> = Vec::new();
    let mut inputs = 0;
    loop {
        match peek(tokens).text {
            "input" if inputs == variables.len() => {
                variables.extend(declarations(tokens)?);
                inputs = variables.len();
            }
            "reg" | "integer" => variables.extend(declarations(tokens)?),
            _ => break,
        }
    }
    let body = statement(tokens)?;
    expect("endfunction").parse_next(tokens)?;
    Ok(Function {
        name,
        signed,
        range,
        inputs,
        variables,
        body,
        line,
    })
}

fn instance(tokens: &mut Tokens<'_>) -> Parsed<Instance> {
    let line = line(tokens);
    let module = name(tokens)?;
    let parameters = match take(tokens, "#") {
        true => delimited(expect("("), separated(1.., parameter, comma), expect(")"))
            .parse_next(tokens)?,
        false => Vec::new(),
    };
    let name = name(tokens)?;
    expect("(").parse_next(tokens)?;
    let connections = match is_next(tokens, ")") {
        true => Vec::new(),
        false => separated(1.., connection, comma).parse_next(tokens)?,
    };
    expect(")").parse_next(tokens)?;
    expect(";").parse_next(tokens)?;
    Ok(Instance {
        module,
        name,
        parameters,
        connections,
        line,
    })
}

fn parameter(tokens: &mut Tokens<'_>) -> Parsed<(String, Expression)> {
    expect(".").parse_next(tokens)?;
    let name = name(tokens)?;
    let value = delimited(expect("("), expression, expect(")")).parse_next(tokens)?;
    Ok((name, value))
}

fn connection(tokens: &mut Tokens<'_>) -> Parsed<(String, Option<Expression>)> {
    expect(".").parse_next(tokens)?;
    let name = name(tokens)?;
    expect("(").parse_next(tokens)?;
    let value = match is_next(tokens, ")") {
        true => None,
        false => Some(expression(tokens)?),
    };
    expect(")").parse_next(tokens)?;
    Ok((name, value))
}
