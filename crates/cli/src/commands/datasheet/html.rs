//! A document as one HTML file, with its pictures in it.

use anyhow::{Context, Result};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, html};

use super::document::{Document, Part};
use crate::page;
use crate::table::Table;

/// How a datasheet looks on screen and paper, beside its colours.
const STYLE: &str = "\
body{background:var(--paper);color:var(--ink);font:16px/1.5 sans-serif;max-width:72rem;margin:0 auto;padding:1rem}
a{color:var(--second)}.wide{overflow-x:auto;margin:1rem 0}
table{border-collapse:collapse;font-size:.875rem}th,td{border:1px solid var(--faint);padding:.2rem .5rem;text-align:left}";

/// The HTML of a document. `picture` gives the SVG text of a picture.
///
/// # Errors
/// There is no such picture.
pub fn html<'a>(document: &Document, picture: impl Fn(&str) -> Option<&'a str>) -> Result<String> {
    let parts = document.parts.iter();
    let parts = parts.map(|part| match part {
        Part::Picture { name, says } => {
            let svg = picture(name).with_context(|| format!("there is no picture `{name}`"))?;
            let data = format!("data:image/svg+xml;base64,{}", STANDARD.encode(svg));
            Ok(html! { div.wide tabindex="0" { img src=(data) alt=(says); } })
        }
        part => Ok(markup(part)),
    });
    let parts = parts.collect::<Result<Vec<_>>>()?;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            (page::head(&document.title, STYLE))
            body {
                h1 { (document.title) }
                @for part in &parts { (part) }
            }
        }
    };
    Ok(page.into_string() + "\n")
}

fn markup(part: &Part) -> Markup {
    match part {
        Part::Heading(heading) => html! { h2 { (heading) } },
        Part::Text(text) => html! { p { (words(text)) } },
        Part::List(items) => html! { ul { @for item in items { li { (words(item)) } } } },
        Part::Table(table) => rows(table),
        Part::Picture { .. } => html! {},
    }
}

fn rows(table: &Table) -> Markup {
    html! {
        div.wide tabindex="0" {
            table {
                thead { tr { @for heading in &table.header { th scope="col" { (words(heading)) } } } }
                tbody {
                    @for row in &table.rows {
                        tr { @for cell in row { td { (words(cell)) } } }
                    }
                }
            }
        }
    }
}

/// A text with its code and its links.
fn words(text: &str) -> Markup {
    let pieces = text.split('`').enumerate();
    html! {
        @for (index, piece) in pieces {
            @if index % 2 == 1 { code { (piece) } } @else { (links(piece)) }
        }
    }
}

fn links(text: &str) -> Markup {
    let link = |text: &str| -> Option<[String; 4]> {
        let (before, rest) = text.split_once('[')?;
        let (shown, rest) = rest.split_once("](")?;
        let (target, after) = rest.split_once(')')?;
        Some([before, shown, target, after].map(str::to_owned))
    };
    match link(text) {
        None => html! { (text) },
        Some([before, shown, target, after]) => {
            // Another datasheet is beside this one, in the same form.
            let target = match target.contains('/') {
                true => target,
                false => target.replace(".md", ".html"),
            };
            html! { (before) a href=(target) { (shown) } (links(&after)) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document() -> Document {
        let mut document = Document::new("A < B");
        document.heading("Ports");
        document.text("See `query_x` and [ports](../ports.md), or a[0].");
        document.text("[leaf](leaf.md#area) is another.");
        document.list(["one & only".to_owned()]);
        document.table(Table::new(&["a|b"], [vec!["x | y".to_owned()]]));
        document.picture("cell", "a cell");
        document
    }

    #[test]
    fn both_forms_have_every_part_of_the_document() {
        let html = html(&document(), |name| (name == "cell").then_some("<svg/>")).unwrap();
        let markdown = super::super::markdown::markdown(&document(), "../pictures");
        for (part, of_markdown) in [
            ("<h1>A &lt; B</h1>", "# A < B\n"),
            ("<h2>Ports</h2>", "\n## Ports\n"),
            (
                "<code>query_x</code> and <a href=\"../ports.md\">ports</a>, or a[0].",
                "`query_x` and [ports](../ports.md)",
            ),
            (
                "<a href=\"leaf.html#area\">leaf</a> is",
                "\n[leaf](leaf.md#area) is",
            ),
            ("<li>one &amp; only</li>", "\n- one & only\n"),
            ("<td>x | y</td>", "| x \\| y |"),
            (
                "alt=\"a cell\"",
                "\n[![a cell](../pictures/cell.svg)](../pictures/cell.svg)\n",
            ),
        ] {
            assert!(html.contains(part), "{part}: {html}");
            assert!(markdown.contains(of_markdown), "{of_markdown}: {markdown}");
        }
    }

    #[test]
    fn a_picture_that_is_not_there_is_refused() {
        let error = html(&document(), |_| None).unwrap_err().to_string();
        assert_eq!(error, "there is no picture `cell`");
    }
}
