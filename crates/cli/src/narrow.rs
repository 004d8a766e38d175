//! Fits a text with tables to the width of a terminal, [`COLUMNS`].
//!
//! A table that is too wide gets its cells and its header broken between words. Where that is not enough, the last columns
//! are left out and named below the table; `--wide` prints the text as it was, whose tables are Markdown.

use clap::Args;

use crate::table::COLUMNS;

/// The most lines that a row of a table may take.
const MOST_LINES: usize = 4;

/// How a line begins that is a command.
const COMMAND: &str = concat!(env!("CARGO_BIN_NAME"), " ");

/// The characters around a cell: a space before it, a space and a bar after it.
const AROUND: usize = 3;

// Whether tables are printed in full. A doc comment would replace the description of each method of `verify`, to which
// the option is added by hand.
#[derive(Args, Copy, Clone, Debug)]
pub struct WideArgs {
    /// Print every table in full, however wide, as Markdown
    #[arg(long)]
    pub wide: bool,
}

/// The text in lines of at most [`COLUMNS`], except for words that are longer.
pub fn narrow(text: &str) -> String {
    let mut narrow = String::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        if !line.starts_with('|') {
            narrow += &prose(line);
            continue;
        }
        let mut table = vec![line];
        while let Some(row) = lines.next_if(|line| line.starts_with('|')) {
            table.push(row);
        }
        match table.iter().all(|row| width(row) <= COLUMNS) {
            true => narrow.extend(table.iter().flat_map(|row| [row, "\n"])),
            false => narrow += &Table::of(&table).text(),
        }
    }
    narrow
}

fn width(text: &str) -> usize {
    text.chars().count()
}

/// A line, broken between words; one that is a command stays whole, to be copied. Further lines begin below its text, which two spaces part from what is on its left.
fn prose(line: &str) -> String {
    if width(line) <= COLUMNS || line.trim_start().starts_with(COMMAND) {
        return format!("{line}\n");
    }
    let start = line.len() - line.trim_start().len();
    let gap = line[start..].find("  ").map(|gap| start + gap);
    let after_gap = gap.map(|gap| line.len() - line[gap..].trim_start().len());
    let is_left = |at: &usize| width(&line[..*at]) < COLUMNS / 2;
    let parts_at = |at: usize| {
        let (left, text) = line.split_at(at);
        let indent = width(left);
        (left, indent, broken(text, COLUMNS.saturating_sub(indent)))
    };
    let fits = |(_, indent, lines): &(&str, usize, Vec<String>)| {
        lines.iter().all(|line| indent + width(line) <= COLUMNS)
    };
    // A word that is too long to stand beside what is on the left stands alone.
    let beside = after_gap.filter(is_left).map(parts_at).filter(fits);
    let (left, indent, lines) = beside.unwrap_or_else(|| parts_at(start));
    let indented = |(index, part): (usize, &String)| {
        let left = if index == 0 { left } else { "" };
        format!("{left:indent$}{part}").trim_end().to_owned() + "\n"
    };
    lines.iter().enumerate().map(indented).collect()
}

/// The text in lines of at most `width`, except for words that are longer.
fn broken(text: &str, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words(text) {
        match lines.last_mut() {
            Some(line) if width(line) + 1 + width(&word) <= most => *line += &format!(" {word}"),
            _ => lines.push(word),
        }
    }
    match lines.is_empty() {
        true => vec![String::new()],
        false => lines,
    }
}

/// The words of a text. A number stays with its `%`, and a command between backquotes stays in one line.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let has_commands = text.matches('`').count().is_multiple_of(2);
    let mut is_command = false;
    for word in text.split(' ') {
        match words.last_mut() {
            Some(last) if is_command || word.starts_with('%') => *last += &format!(" {word}"),
            _ => words.push(word.to_owned()),
        }
        is_command ^= has_commands && word.matches('`').count() % 2 == 1;
    }
    words
}

/// A Markdown table.
struct Table {
    /// The header, and then the rows.
    rows: Vec<Vec<String>>,
}

impl Table {
    fn of(lines: &[&str]) -> Self {
        let cells = |line: &&str| {
            let line = line.trim_start_matches('|').trim_end_matches('|');
            line.split('|').map(|cell| cell.trim().to_owned()).collect()
        };
        let rows = lines.iter().enumerate().filter(|(index, _)| *index != 1);
        Self {
            rows: rows.map(|(_, line)| cells(line)).collect(),
        }
    }

    /// The table with as many of its columns as fit.
    fn text(&self) -> String {
        let all = self.rows[0].len();
        let fits = |columns: &usize| self.widths(*columns).is_some();
        let columns = (1..=all).rev().find(fits).unwrap_or(1);
        let natural = || vec![self.natural(0)];
        let widths = self.widths(columns).unwrap_or_else(natural);
        let mut text = String::new();
        for (index, row) in self.rows.iter().enumerate() {
            text += &row_text(row, &widths);
            if index == 0 {
                let dashes: Vec<_> = widths.iter().map(|&width| "-".repeat(width)).collect();
                text += &row_text(&dashes, &widths);
            }
        }
        if columns < all {
            let left_out = self.rows[0][columns..].join(", ");
            text += &prose(&format!("Left out: {left_out}. --wide prints all columns."));
        }
        text
    }

    fn column(&self, index: usize) -> impl Iterator<Item = &str> {
        self.rows
            .iter()
            .filter_map(move |row| row.get(index).map(String::as_str))
    }

    fn natural(&self, column: usize) -> usize {
        self.column(column).map(width).max().unwrap_or(0)
    }

    /// The width of the longest word of a column.
    fn least(&self, column: usize) -> usize {
        let words = self.column(column).flat_map(words);
        words.map(|word| width(&word)).max().unwrap_or(0)
    }

    /// Widths with which the first columns fit; `None` where they do not. The header is broken first, and then the cells of the
    /// widest column, because a table with many broken cells is hard to read.
    fn widths(&self, columns: usize) -> Option<Vec<usize>> {
        let mut widths: Vec<_> = (0..columns).map(|column| self.natural(column)).collect();
        let cells: Vec<_> = (0..columns).map(|column| self.cells(column)).collect();
        let widest = (0..columns).max_by_key(|&column| cells[column])?;
        let least = |column: usize| match column == widest {
            true => self.least(column),
            false => self.least(column).max(cells[column]),
        };
        let least: Vec<_> = (0..columns).map(least).collect();
        let room = COLUMNS - 1 - AROUND * columns.min(COLUMNS / AROUND - 1);
        while widths.iter().sum::<usize>() > room {
            let may = (0..columns).filter(|&column| widths[column] > least[column]);
            let next = may.max_by_key(|&column| (widths[column] > cells[column], widths[column]));
            widths[next?] -= 1;
        }
        let lines = |row: &Vec<String>| {
            let cells = row.iter().zip(&widths);
            cells
                .map(|(cell, &width)| broken(cell, width).len())
                .max()
                .unwrap_or(0)
        };
        let most = self.rows.iter().map(lines).max().unwrap_or(0);
        (most <= MOST_LINES).then_some(widths)
    }

    /// The width of the longest cell of a column below its header.
    fn cells(&self, column: usize) -> usize {
        self.column(column).skip(1).map(width).max().unwrap_or(0)
    }
}

/// A row in as many lines as its cells take.
fn row_text(row: &[String], widths: &[usize]) -> String {
    let cells: Vec<_> = row
        .iter()
        .zip(widths)
        .map(|(cell, &width)| broken(cell, width))
        .collect();
    let lines = cells.iter().map(Vec::len).max().unwrap_or(0);
    let line = |index: usize| {
        let parts = cells.iter().zip(widths).map(|(cell, &width)| {
            let part = cell.get(index).map_or("", String::as_str);
            format!(" {part:width$} |")
        });
        format!("|{}\n", parts.collect::<String>())
    };
    (0..lines).map(line).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::table::markdown;

    #[test]
    fn what_fits_stays_as_it_is() {
        let table = markdown(&["a", "b"], &[vec!["1".into(), "2 3".into()]]);
        let text = format!("{table}\nA line.\n  `code`  text\n");
        assert_eq!(narrow(&text), text);
    }

    #[test]
    fn headers_are_broken_first_and_then_the_widest_cells() {
        let header = ["device", "results compared", "tool"];
        let tool = "one two three four five ".repeat(5);
        let table = markdown(
            &header,
            &[vec!["text".into(), "7".into(), tool.trim().into()]],
        );
        let lines: Vec<_> = narrow(&table).lines().map(str::to_owned).collect();
        assert!(
            lines[0].starts_with("| device | results  | tool "),
            "{lines:?}"
        );
        assert!(lines[1].starts_with("|        | compared |"), "{lines:?}");
        assert!(
            lines[3].starts_with("| text   | 7        | one two three"),
            "{lines:?}"
        );
        assert!(lines[4].starts_with("|        |          | "), "{lines:?}");
        assert_eq!(lines.len(), 5);
    }

    #[test]
    fn columns_that_do_not_fit_are_named() {
        let header: Vec<_> = (0..20).map(|column| format!("column{column}")).collect();
        let header: Vec<_> = header.iter().map(String::as_str).collect();
        let text = narrow(&markdown(&header, &[vec!["12345678".into(); 20]]));
        let columns = text.lines().next().unwrap().matches("column").count();
        assert!((6..12).contains(&columns), "{text}");
        let expected = format!("Left out: column{columns}, ");
        assert!(
            text.contains(&expected) && text.ends_with("--wide prints all columns.\n"),
            "{text}"
        );
    }

    #[test]
    fn a_line_goes_on_below_its_text_and_a_command_is_not_broken() {
        let command = format!("  photoncube run {}\n", "--photons 2000 ".repeat(9).trim());
        assert_eq!(narrow(&command), command);
        let text = format!("  key   {}`photoncube list`\n", "word ".repeat(17));
        let lines: Vec<_> = narrow(&text).lines().map(str::to_owned).collect();
        assert_eq!(lines[1], "        `photoncube list`");
        let long = format!("`{}`", ["photoncube"; 8].join(" "));
        let lines = narrow(&format!("  a longer key   {long} ends\n"));
        assert_eq!(lines, format!("  a longer key\n  {long} ends\n"));
    }

    proptest! {
        #[test]
        fn no_line_is_longer_and_no_word_is_lost(
            cells in prop::collection::vec(prop::collection::vec("[a-z%]{0,9}( [a-z0-9]{1,9}){0,9}", 4), 1..5),
            line in "[ a-z`]{0,300}",
        ) {
            let header = ["first", "second column", "third", "fourth one"];
            let table = markdown(&header, &cells);
            let text = narrow(&format!("{table}{line}\n"));
            for line in text.lines() {
                prop_assert!(width(line) <= COLUMNS || words(line.trim()).len() == 1, "{line}");
            }
            let all = |text: &str| text.split_whitespace().filter(|w| *w != "|").map(str::len).sum::<usize>();
            if !text.contains("Left out: ") {
                let dashes = |text: &str| text.matches('-').count();
                prop_assert_eq!(all(&text) - dashes(&text), all(&format!("{table}{line}")) - dashes(&table));
            }
        }
    }
}
