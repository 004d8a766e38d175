//! Values of a TOML text with their place in it, so that every error can name line and field.

use std::collections::BTreeSet;

use glam::DVec3;
use photoncube_spec::did_you_mean;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::scene::SceneError;

/// The largest coordinate and length. Products of such numbers are far from overflow, and no unit needs more.
const MAX_LENGTH: f64 = 1e12;

/// The text that values are read from.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    /// The name of the file, for errors.
    pub file: &'a str,
    pub text: &'a str,
}

impl Source<'_> {
    /// The line and the column of a byte of the text, counted from 1.
    pub fn place(&self, at: usize) -> (usize, usize) {
        let before = &self.text.as_bytes()[..at.min(self.text.len())];
        let line_start = before
            .iter()
            .rposition(|b| *b == b'\n')
            .map_or(0, |n| n + 1);
        let line = 1 + before.iter().filter(|b| **b == b'\n').count();
        let column = 1 + String::from_utf8_lossy(&before[line_start..])
            .chars()
            .count();
        (line, column)
    }

    pub fn error(&self, at: usize, place: &str, found: String, expected: &str) -> SceneError {
        SceneError::Field {
            file: self.file.to_owned(),
            line: self.place(at).0,
            place: place.to_owned(),
            found,
            expected: expected.to_owned(),
        }
    }
}

/// A value with its place in the text.
#[derive(Clone)]
pub(super) struct Field<'a> {
    source: Source<'a>,
    value: &'a Spanned<DeValue<'a>>,
    /// The path of the value from the top, such as `shapes[2].corners[0]`.
    pub path: String,
}

impl<'a> Field<'a> {
    pub fn error(&self, found: String, expected: &str) -> SceneError {
        let at = self.value.span().start;
        self.source.error(at, &self.path, found, expected)
    }

    /// The error of a value of the wrong type.
    fn wrong(&self, expected: &str) -> SceneError {
        self.error(describe(self.value.get_ref()), expected)
    }

    pub fn line(&self) -> usize {
        self.source.place(self.value.span().start).0
    }

    pub fn text(&self, expected: &str) -> Result<&'a str, SceneError> {
        let text = self.value.get_ref().as_str();
        text.ok_or_else(|| self.wrong(expected))
    }

    pub fn boolean(&self) -> Result<bool, SceneError> {
        let value = self.value.get_ref().as_bool();
        value.ok_or_else(|| self.wrong("true or false"))
    }

    /// A number that satisfies `holds`.
    pub fn number(&self, holds: impl Fn(f64) -> bool, expected: &str) -> Result<f64, SceneError> {
        let number = number(self.value.get_ref()).filter(|number| holds(*number));
        number.ok_or_else(|| self.wrong(expected))
    }

    /// A length in scene units, over 0.
    pub fn length(&self) -> Result<f64, SceneError> {
        let possible = |length| length > 0.0 && length <= MAX_LENGTH;
        self.number(possible, "a number over 0, up to 1e12")
    }

    /// A position or an offset in scene units.
    pub fn point(&self) -> Result<DVec3, SceneError> {
        let expected = "a number from -1e12 to 1e12";
        self.three(|c| c.abs() <= MAX_LENGTH, expected)
    }

    /// Three numbers that satisfy `holds`.
    pub fn three(&self, holds: impl Fn(f64) -> bool, expected: &str) -> Result<DVec3, SceneError> {
        let [x, y, z] = self.items("an array of three numbers")?;
        let number = |field: Field| field.number(&holds, expected);
        Ok(DVec3::new(number(x)?, number(y)?, number(z)?))
    }

    /// The items of an array of `N` items.
    pub fn items<const N: usize>(&self, expected: &str) -> Result<[Field<'a>; N], SceneError> {
        let items = self.array(expected)?;
        let count = items.len();
        items
            .try_into()
            .map_err(|_| self.error(format!("an array of {count}"), expected))
    }

    /// The items of an array of any length.
    pub fn array(&self, expected: &str) -> Result<Vec<Field<'a>>, SceneError> {
        let array = self.value.get_ref().as_array();
        let array = array.ok_or_else(|| self.wrong(expected))?;
        let item = |(index, value)| Field {
            source: self.source,
            value,
            path: format!("{}[{index}]", self.path),
        };
        Ok(array.iter().enumerate().map(item).collect())
    }

    pub fn table(&self, expected: &str) -> Result<Fields<'a>, SceneError> {
        let table = self.value.get_ref().as_table();
        Ok(Fields {
            source: self.source,
            table: table.ok_or_else(|| self.wrong(expected))?,
            start: self.value.span().start,
            path: self.path.clone(),
        })
    }

    /// The value that one of a list of words stands for.
    pub fn choice<T: Copy>(&self, choices: &[(&str, T)]) -> Result<T, SceneError> {
        let names = choices.iter().map(|(name, _)| format!("`{name}`"));
        let expected = names.collect::<Vec<_>>().join(", ");
        let text = self.text(&expected)?;
        let choice = choices.iter().find(|(name, _)| *name == text);
        choice.map(|(_, value)| *value).ok_or_else(|| {
            let meant = did_you_mean(text, choices.iter().map(|(name, _)| *name));
            self.error(format!("{text:?}{meant}"), &expected)
        })
    }
}

/// A table with its place in the text.
#[derive(Clone)]
pub(super) struct Fields<'a> {
    pub source: Source<'a>,
    pub table: &'a DeTable<'a>,
    /// The index of the first byte of its text.
    pub start: usize,
    /// The path of the table; empty for the top.
    pub path: String,
}

impl<'a> Fields<'a> {
    /// The path of one of the table's fields.
    pub fn path_to(&self, name: &str) -> String {
        match self.path.as_str() {
            "" => name.to_owned(),
            path => format!("{path}.{name}"),
        }
    }

    /// Refuses fields that are not in the list.
    pub fn only(&self, known: &[&str]) -> Result<(), SceneError> {
        let unknown = |name: &&Spanned<_>| {
            let name: &std::borrow::Cow<str> = name.get_ref();
            !known.contains(&name.as_ref())
        };
        // The first unknown field in the text, whatever the order of the table.
        let stray = self.table.keys().filter(unknown);
        let Some(key) = stray.min_by_key(|key| key.span().start) else {
            return Ok(());
        };
        let meant = did_you_mean(key.get_ref(), known.iter().copied());
        let found = format!("a field of no meaning here{meant}");
        let expected = format!("one of {}", known.join(", "));
        let path = self.path_to(key.get_ref());
        Err(self.source.error(key.span().start, &path, found, &expected))
    }

    pub fn get(&self, name: &str) -> Option<Field<'a>> {
        let value = self.table.get(name)?;
        Some(Field {
            source: self.source,
            value,
            path: self.path_to(name),
        })
    }

    /// A field that must exist.
    pub fn need(&self, name: &str, expected: &str) -> Result<Field<'a>, SceneError> {
        self.get(name).ok_or_else(|| {
            let path = self.path_to(name);
            self.source
                .error(self.start, &path, "nothing".to_owned(), expected)
        })
    }

    /// All fields by name, sorted, so that nothing depends on the parser's order.
    pub fn all(&self) -> Vec<(&'a str, Field<'a>)> {
        let names: BTreeSet<&str> = self
            .table
            .keys()
            .map(|key| key.get_ref().as_ref())
            .collect();
        let fields = names
            .into_iter()
            .filter_map(|name| Some((name, self.get(name)?)));
        fields.collect()
    }
}

fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        DeValue::Float(float) => float.as_str().parse().ok(),
        _ => None,
    }
}

/// A short description of a value.
fn describe(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => format!("{text:?}"),
        DeValue::Integer(integer) => integer.as_str().to_owned(),
        DeValue::Float(float) => float.as_str().to_owned(),
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Array(items) => format!("an array of {}", items.len()),
        DeValue::Table(_) => "a table".to_owned(),
        DeValue::Datetime(_) => "a date or a time".to_owned(),
    }
}
