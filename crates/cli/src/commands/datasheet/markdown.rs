//! A document as Markdown.

use super::document::{Document, Part};
use crate::table::Table;

/// The Markdown of a document, whose pictures are in that folder.
pub fn markdown(document: &Document, pictures: &str) -> String {
    let mut text = format!("# {}\n", document.title);
    for part in &document.parts {
        text += "\n";
        text += &match part {
            Part::Heading(heading) => format!("## {heading}\n"),
            Part::Text(words) => format!("{words}\n"),
            Part::List(items) => items.iter().map(|item| format!("- {item}\n")).collect(),
            Part::Table(table) => escaped(table).markdown(),
            // A page shrinks a wide picture; the link leads to it as it is.
            Part::Picture { name, says } => {
                format!("[![{says}]({pictures}/{name}.svg)]({pictures}/{name}.svg)\n")
            }
        };
    }
    text
}

/// The table with its bars escaped, which would end cells.
fn escaped(table: &Table) -> Table {
    let cells = |cells: &[String]| cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
    Table {
        header: cells(&table.header),
        rows: table.rows.iter().map(|row| cells(row)).collect(),
    }
}
