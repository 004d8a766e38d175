//! Verilog of words and ports.

/// Bits and value of a field of a word.
pub(super) type Field = (u32, u64);

/// A word of a stream: its fields in rows, the highest first.
pub(super) type Word = Vec<Vec<Field>>;

/// The longest line in characters.
const COLUMNS: usize = 120;

/// Puts values for the names in a template, where they stand as `@NAME@`.
pub(super) fn filled(template: &str, values: &[(&str, String)]) -> String {
    let mut text = template.to_owned();
    for (name, value) in values {
        text = text.replace(&format!("@{name}@"), value);
    }
    text
}

/// Words of a memory, one after the other from place 0.
pub(super) fn words(memory: &str, words: &[Word]) -> String {
    let line =
        |(place, rows): (usize, &Word)| format!("        {memory}[{place}] = {};\n", word(rows));
    words.iter().enumerate().map(line).collect()
}

/// A word with a line for each row. Rows of zeros below the first, one below the other, are one number.
fn word(rows: &[Vec<Field>]) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut zeros = 0;
    for (place, row) in rows.iter().enumerate() {
        if place > 0 && row.iter().all(|&(_, value)| value == 0) {
            zeros += bits(row);
            continue;
        }
        lines.extend(number(zeros));
        zeros = 0;
        let fields = row.iter().map(|(width, value)| format!("{width}'d{value}"));
        lines.push(fields.collect::<Vec<_>>().join(", "));
    }
    lines.extend(number(zeros));
    format!("{{{}}}", lines.join(",\n            "))
}

/// So many bits of 0; nothing for none.
fn number(zeros: u32) -> Option<String> {
    (zeros > 0).then(|| format!("{zeros}'d0"))
}

/// The bits of a row.
pub(super) fn bits(row: &[Field]) -> u32 {
    row.iter().map(|(width, _)| width).sum()
}

/// Parts in lines that begin as `first` and `next`, with commas between them.
pub(super) fn lines(parts: &[String], first: &str, next: &str) -> String {
    let mut text = first.to_owned();
    let mut column = first.len();
    for (place, part) in parts.iter().enumerate() {
        if place > 0 {
            text.push(',');
            if column + part.len() + 2 > COLUMNS {
                text += &format!("\n{next}");
                column = next.len();
            } else {
                text.push(' ');
                column += 2;
            }
        }
        text += part;
        column += part.len();
    }
    text
}

/// A wire for each port, neighbours of one width in one line.
pub(super) fn wires(ports: &[(String, u32)]) -> String {
    let mut text = String::new();
    for same in ports.chunk_by(|a, b| a.1 == b.1) {
        let first = match same[0].1 {
            1 => "    wire ".to_owned(),
            width => format!("    wire [{}:0] ", width - 1),
        };
        let names: Vec<_> = same.iter().map(|(name, _)| name.clone()).collect();
        text += &(lines(&names, &first, "        ") + ";\n");
    }
    text
}

/// The ports of an instance, each with its signal.
pub(super) fn connections(ports: impl Iterator<Item = (String, String)>) -> String {
    let parts: Vec<_> = ports
        .map(|(port, signal)| format!(".{port}({signal})"))
        .collect();
    lines(&parts, "        ", "        ")
}

/// Whether a port of a stream is a word's, not its `valid` or `ready`.
pub(super) fn is_of_word(name: &str) -> bool {
    !name.ends_with("valid") && !name.ends_with("ready")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_has_a_line_for_each_row_and_one_number_for_rows_of_zeros() {
        let one = vec![(3, 5), (1, 0)];
        assert_eq!(word(std::slice::from_ref(&one)), "{3'd5, 1'd0}");
        let zeros = vec![(2, 0), (4, 0)];
        let rows = [vec![(1, 0)], zeros.clone(), zeros.clone(), one, zeros];
        assert_eq!(
            word(&rows),
            "{1'd0,\n            12'd0,\n            3'd5, 1'd0,\n            6'd0}"
        );
    }

    #[test]
    fn lines_end_before_the_last_column() {
        let parts: Vec<_> = (0..60).map(|part| format!("part_{part}")).collect();
        let text = lines(&parts, "    ", "        ");
        assert!(text.lines().all(|line| line.len() <= COLUMNS + 1), "{text}");
        assert_eq!(text.matches(',').count(), 59);
    }
}
