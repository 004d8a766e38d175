//! Plain tables: one text that reads well in a terminal and is Markdown in the README.

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

#[cfg(test)]
mod tests {
    #[test]
    fn columns_are_padded() {
        let table = super::markdown(&["a", "bb"], &[vec!["ccc".into(), "d".into()]]);
        assert_eq!(table, "| a   | bb |\n| --- | -- |\n| ccc | d  |\n");
    }
}
