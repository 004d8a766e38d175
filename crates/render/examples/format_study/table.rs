//! Tables that print as text or as JSON.

use std::fmt;

use photoncube_render::Interval;
use serde_json::{Value, json};

/// A value with the form in which it is printed.
pub enum Cell {
    Text(String),
    /// With so many decimals.
    Number(f64, usize),
    /// A mean and its 95 % interval, with so many decimals.
    Interval(Interval, usize),
}

impl Cell {
    pub fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    /// In per cent.
    pub fn percent(interval: Interval, decimals: usize) -> Self {
        let Interval { mean, low, high } = interval;
        let interval = Interval {
            mean: 100.0 * mean,
            low: 100.0 * low,
            high: 100.0 * high,
        };
        Self::Interval(interval, decimals)
    }

    fn json(&self) -> Value {
        match self {
            Self::Text(text) => json!(text),
            Self::Number(value, _) => json!(value),
            Self::Interval(interval, _) => json!(interval),
        }
    }
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(text) => f.pad(text),
            Self::Number(value, decimals) => f.pad(&format!("{value:.decimals$}")),
            Self::Interval(Interval { mean, low, high }, decimals) => f.pad(&format!(
                "{mean:.decimals$} ({low:.decimals$}..{high:.decimals$})"
            )),
        }
    }
}

/// Rows under a header.
pub struct Table {
    title: &'static str,
    note: &'static str,
    header: Vec<String>,
    rows: Vec<Vec<Cell>>,
}

impl Table {
    pub fn new(title: &'static str, note: &'static str, header: Vec<String>) -> Self {
        Self {
            title,
            note,
            header,
            rows: Vec::new(),
        }
    }

    pub fn push(&mut self, row: Vec<Cell>) {
        assert_eq!(row.len(), self.header.len(), "{}", self.title);
        self.rows.push(row);
    }

    /// Rows as objects of the header's keys.
    pub fn json(&self) -> Value {
        let object = |row: &Vec<Cell>| -> Value {
            let pairs = self.header.iter().zip(row);
            pairs
                .map(|(key, cell)| (key.clone(), cell.json()))
                .collect()
        };
        let rows: Vec<Value> = self.rows.iter().map(object).collect();
        json!({"title": self.title, "note": self.note, "rows": rows})
    }

    fn widths(&self) -> Vec<usize> {
        let width = |column: usize| {
            let cells = self.rows.iter().map(|row| row[column].to_string().len());
            cells.chain([self.header[column].len()]).max().unwrap_or(0)
        };
        (0..self.header.len()).map(width).collect()
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let widths = self.widths();
        writeln!(f, "## {}\n{}\n", self.title, self.note)?;
        let header: Vec<Cell> = self.header.iter().map(Cell::text).collect();
        for row in [&header].into_iter().chain(&self.rows) {
            for (cell, width) in row.iter().zip(&widths) {
                write!(f, "| {cell:<width$} ")?;
            }
            writeln!(f, "|")?;
            if std::ptr::eq(row, &header) {
                let rules = widths.iter().map(|width| "-".repeat(width + 2));
                writeln!(f, "|{}|", rules.collect::<Vec<_>>().join("|"))?;
            }
        }
        Ok(())
    }
}
