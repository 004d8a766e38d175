//! Names as rust-hdl prints them.
//!
//! A path is kept as text, `cell[i]$n$next`. The printer removes `$next`, and replaces the first `[..]` by
//! `$` and the value that its own expression evaluator computes.

use super::finding::Fault;
use super::rule::Rule;

/// The loops around a statement: each loop's variable and current value.
pub(super) type Loops = Vec<(String, usize)>;

/// The value of a loop variable. Where loops share a name, the innermost counts.
pub(super) fn loop_value(loops: &Loops, name: &str) -> Option<usize> {
    loops
        .iter()
        .rev()
        .find(|(variable, _)| variable == name)
        .map(|(_, value)| *value)
}

/// The path in readable form, without rust-hdl's marks.
pub(super) fn readable(raw: &str) -> String {
    let name = raw
        .trim_start_matches('.')
        .replace("::", "$")
        .replace('.', "$");
    name.trim_end_matches("$next").to_owned()
}

/// The identifier that the printer makes of a path.
pub(super) fn printed(raw: &str, loops: &Loops) -> Result<String, Fault> {
    let name = readable(raw);
    let Some((base, rest)) = name.split_once('[') else {
        return Ok(name);
    };
    if rest.contains('[') {
        return Err(Fault::about(Rule::NestedArrayPath, &name));
    }
    let (index, rest) = rest
        .split_once(']')
        .ok_or_else(|| Fault::about(Rule::IndexOperator, &name))?;
    let value = evaluate(index, loops).ok_or_else(|| Fault::about(Rule::IndexOperator, index))?;
    Ok(format!("{base}${value}{rest}"))
}

/// The value of an index; `None` unless Rust and the printer's evaluator agree on it.
fn evaluate(index: &str, loops: &Loops) -> Option<i64> {
    let mut reader = Reader { rest: index, loops };
    let value = reader.sum()?;
    reader.rest.is_empty().then_some(value)
}

/// A recursive descent over the operators that have one meaning in both.
struct Reader<'a> {
    rest: &'a str,
    loops: &'a Loops,
}

impl<'a> Reader<'a> {
    fn sum(&mut self) -> Option<i64> {
        let mut value = self.product()?;
        while let Some(operator) = self.take_any(&['+', '-']) {
            let right = self.product()?;
            value = if operator == '+' {
                value + right
            } else {
                value - right
            };
        }
        Some(value)
    }

    fn product(&mut self) -> Option<i64> {
        let mut value = self.primary()?;
        while let Some(operator) = self.take_any(&['*', '/', '%']) {
            let right = self.primary()?;
            value = match operator {
                '*' => value.checked_mul(right)?,
                '/' => value.checked_div(right)?,
                _ => value.checked_rem(right)?,
            };
        }
        Some(value)
    }

    fn primary(&mut self) -> Option<i64> {
        if self.take_any(&['(']).is_some() {
            let value = self.sum()?;
            return self.take_any(&[')']).map(|_| value);
        }
        let word = self.take_word();
        match word.parse::<u32>() {
            Ok(number) => Some(number.into()),
            Err(_) => loop_value(self.loops, word).and_then(|value| value.try_into().ok()),
        }
    }

    fn take_any(&mut self, wanted: &[char]) -> Option<char> {
        let next = self.rest.chars().next().filter(|c| wanted.contains(c))?;
        self.rest = &self.rest[1..];
        Some(next)
    }

    fn take_word(&mut self) -> &'a str {
        let end = self
            .rest
            .find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        word
    }
}
