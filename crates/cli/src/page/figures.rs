//! Tables of figures.

use maud::{Markup, html};

use super::scrolling;

/// A cell of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cell {
    /// A text.
    Text(String),
    /// A number, which stands at the right.
    Number(String),
    /// A figure that there is not.
    None,
}

impl Cell {
    /// A text.
    pub fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    /// A number that is already written, if there is one.
    pub fn number(number: Option<String>) -> Self {
        number.map_or(Self::None, Self::Number)
    }
}

/// A table. The first cell of a row names it. A row for which `is_faint` holds is greyed.
pub fn figures(
    caption: &str,
    header: &[&str],
    rows: &[Vec<Cell>],
    is_faint: impl Fn(usize) -> bool,
) -> Markup {
    let table = html! {
        table {
            caption { (caption) }
            thead { tr { @for title in header { th scope="col" { (title) } } } }
            tbody {
                @for (index, row) in rows.iter().enumerate() {
                    tr.faint[is_faint(index)] {
                        @for (column, value) in row.iter().enumerate() {
                            @if column == 0 { th scope="row" { (cell(value)) } }
                            @else { td.number[matches!(value, Cell::Number(_))] { (cell(value)) } }
                        }
                    }
                }
            }
        }
    };
    scrolling(caption, table)
}

fn cell(cell: &Cell) -> Markup {
    match cell {
        Cell::Text(text) | Cell::Number(text) => html! { (text) },
        Cell::None => html! { span.none aria-label="not known" { "–" } },
    }
}
