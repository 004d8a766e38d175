//! Plain tables, which are readable in a terminal and are Markdown in the pages.

use serde_json::Value;

/// A number rounded to `digits` significant digits, or to a whole number where that has more.
pub fn significant(number: f64, digits: u32) -> String {
    let last = f64::from(digits) - 1.0;
    // `as` saturates.
    let places = (last - number.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{number:.places$}")
}

/// A table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// The headings of the columns.
    pub header: Vec<String>,
    /// The cells, row by row.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these headings.
    pub fn new(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Self {
        Self {
            header: header.iter().map(ToString::to_string).collect(),
            rows: rows.into_iter().collect(),
        }
    }

    /// The table as Markdown.
    pub fn markdown(&self) -> String {
        let header: Vec<_> = self.header.iter().map(String::as_str).collect();
        markdown(&header, &self.rows)
    }
}

/// A Markdown table with padded columns.
pub fn markdown(header: &[&str], rows: &[Vec<String>]) -> String {
    let width = |column: usize| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells
            .chain([header[column].chars().count()])
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let line = |cells: Vec<String>| {
        let padded = cells
            .iter()
            .zip(&widths)
            .map(|(c, &w)| format!(" {c:w$} |"));
        format!("|{}\n", padded.collect::<String>())
    };
    let mut text = line(header.iter().map(ToString::to_string).collect());
    text += &line(widths.iter().map(|&w| "-".repeat(w)).collect());
    text.extend(rows.iter().map(|row| line(row.clone())));
    text
}

/// A Markdown table of objects, with these keys of theirs, which spaces separate, as columns; empty without a row.
pub fn of_rows<'a>(rows: impl IntoIterator<Item = &'a Value>, keys: &str) -> String {
    let keys: Vec<_> = keys.split(' ').collect();
    let header: Vec<_> = keys.iter().map(|key| key.replace('_', " ")).collect();
    let header: Vec<_> = header.iter().map(String::as_str).collect();
    let row = |row: &Value| keys.iter().map(|key| cell(&row[*key])).collect();
    let rows: Vec<_> = rows.into_iter().map(row).collect();
    match rows.is_empty() {
        true => String::new(),
        false => markdown(&header, &rows),
    }
}

fn cell(value: &Value) -> String {
    match value {
        Value::Null => "none".to_owned(),
        Value::Bool(holds) => if *holds { "yes" } else { "NO" }.to_owned(),
        Value::Number(number) => match number.as_u64() {
            Some(number) => grouped(number),
            None => format!("{:.1}", number.as_f64().unwrap_or(f64::NAN)),
        },
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// A number with its noun: "1 format", "3 formats".
pub fn counted(number: u64, noun: &str) -> String {
    let end = if number == 1 { "" } else { "s" };
    format!("{} {noun}{end}", grouped(number))
}

/// A number with a comma before every three digits.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The width in columns that texts are wrapped to.
pub const COLUMNS: usize = 100;

/// Wraps a text between words to lines of at most [`COLUMNS`]. Lines after the first are indented by
/// `indent`. A longer word has its own line.
pub fn wrapped(text: &str, indent: usize) -> String {
    let mut lines = String::new();
    // The width of the line so far; `None` before the first word.
    let mut width = None;
    for word in text.split(' ') {
        let length = word.chars().count();
        width = Some(match width {
            None => length,
            Some(width) if width + 1 + length <= COLUMNS => {
                lines.push(' ');
                width + 1 + length
            }
            Some(_) => {
                lines += &format!("\n{:indent$}", "");
                indent + length
            }
        });
        lines += word;
    }
    lines
}

#[cfg(test)]
mod tests {
    #[test]
    fn columns_are_padded() {
        let table = super::markdown(&["a", "bb"], &[vec!["ccc".into(), "d".into()]]);
        assert_eq!(table, "| a   | bb |\n| --- | -- |\n| ccc | d  |\n");
    }

    #[test]
    fn objects_are_rows_with_the_keys_that_are_asked_for() {
        let rows = [
            serde_json::json!({ "proven": true, "vectors_compared": 1234, "seconds": 0.25, "a": 1 }),
            serde_json::json!({ "proven": false, "vectors_compared": 0, "seconds": null }),
        ];
        assert_eq!(
            super::of_rows(&rows, "vectors_compared proven seconds"),
            "| vectors compared | proven | seconds |\n\
             | ---------------- | ------ | ------- |\n\
             | 1,234            | yes    | 0.2     |\n\
             | 0                | NO     | none    |\n"
        );
        assert_eq!(super::of_rows(&[], "a"), "");
    }

    #[test]
    fn digits_are_grouped() {
        let grouped = [0, 999, 1000, 1_234_567].map(super::grouped);
        assert_eq!(grouped, ["0", "999", "1,000", "1,234,567"]);
    }

    #[test]
    fn long_lines_are_broken_between_words() {
        let word = "x".repeat(60);
        let text = super::wrapped(&format!("  a {word} {word}"), 4);
        assert_eq!(text, format!("  a {word}\n    {word}"));
        assert_eq!(super::wrapped("  short", 4), "  short");
        let long = "y".repeat(200);
        assert_eq!(
            super::wrapped(&format!("a {long} b"), 2),
            format!("a\n  {long}\n  b")
        );
    }
}
