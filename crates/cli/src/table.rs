//! Plain tables, which are readable in a terminal and are Markdown in the pages.

/// A number rounded to `digits` significant digits, or to a whole number where that has more.
pub fn significant(number: f64, digits: u32) -> String {
    let last = f64::from(digits) - 1.0;
    // `as` saturates.
    let places = (last - number.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{number:.places$}")
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
