//! A page about a scene or a run: one HTML file that opens from the disk and loads nothing else.
//!
//! Sections are HTML made by [`maud`]; charts are SVG in it. Everything that a chart or a drawing shows stands
//! in a table too, which also works without scripts.

mod chart;
mod figures;
mod hypercube;
mod pictures;
mod pipeline;
mod schedule;
mod trace;

use anyhow::Result;
use maud::{DOCTYPE, Markup, PreEscaped, html};

pub use chart::Chart;
pub use figures::{Cell, figures};
pub use hypercube::hypercube_section;
pub use pictures::{Pictures, pictures};
pub use pipeline::Pipeline;
pub use schedule::{schedule, units};
pub use trace::Example;
use trace::Trace;

use crate::plots::palette;

/// What the page looks like, without its colours.
const STYLE: &str = include_str!("page.css");
/// What its controls do.
const SCRIPT: &str = include_str!("page.js");

/// A part of the page, with an entry in its list of contents.
pub struct Section {
    /// The anchor.
    pub id: &'static str,
    /// The heading.
    pub title: String,
    /// The contents.
    pub body: Markup,
}

/// A page.
pub struct Page {
    /// The title.
    pub title: String,
    /// The answer, one fact a sentence. It stands before everything else.
    pub verdict: Vec<Markup>,
    /// The sections, in their order.
    pub sections: Vec<Section>,
    /// The command that repeats the page.
    pub command: String,
}

impl Page {
    /// The HTML text.
    pub fn text(&self) -> String {
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                (head(&format!("{} · Photoncube", self.title), STYLE))
                body {
                    a.skip href="#verdict" { "To the verdict" }
                    header {
                        h1 { (self.title) }
                        nav aria-label="Contents" {
                            ul {
                                @for section in &self.sections {
                                    li { a href={ "#" (section.id) } { (section.title) } }
                                }
                            }
                        }
                    }
                    main {
                        section #verdict aria-labelledby="verdict-title" {
                            h2 #verdict-title { "Verdict" }
                            ul.verdict { @for fact in &self.verdict { li { (fact) } } }
                        }
                        @for section in &self.sections {
                            section id=(section.id) aria-labelledby={ (section.id) "-title" } {
                                h2 id={ (section.id) "-title" } { (section.title) }
                                (section.body)
                            }
                        }
                    }
                    footer {
                        p { "Photoncube " (env!("CARGO_PKG_VERSION")) ". This page is written by:" }
                        pre tabindex="0" { code { (self.command) } }
                    }
                    script { (PreEscaped(SCRIPT)) }
                }
            }
        };
        page.into_string() + "\n"
    }
}

/// The head of an HTML file, with the colours of both themes beside its style.
pub fn head(title: &str, style: &str) -> Markup {
    html! {
        head {
            meta charset="utf-8";
            meta name="viewport" content="width=device-width, initial-scale=1";
            meta name="color-scheme" content="light dark";
            title { (title) }
            // A page without an icon of its own makes browsers ask for one.
            link rel="icon" href="data:,";
            style { (PreEscaped(colours())) (PreEscaped(style)) }
        }
    }
}

/// The colours of light and dark pages, as variables.
fn colours() -> String {
    let set = |colours: &palette::Set| -> String {
        let names = ["paper", "ink", "faint", "first", "second", "third"];
        let all = [
            colours.paper,
            colours.ink,
            colours.faint,
            colours.first,
            colours.second,
            colours.third,
        ];
        let named = names.iter().zip(all);
        named
            .map(|(name, colour)| format!("--{name}:{};", palette::css(colour)))
            .collect()
    };
    format!(
        ":root{{{}}}@media (prefers-color-scheme:dark){{:root{{{}}}}}@media print{{:root{{{}}}}}",
        set(&palette::LIGHT),
        set(&palette::DARK),
        set(&palette::LIGHT)
    )
}

/// The contents of a section, or the reason why they cannot be shown. The rest of the page is shown all the same.
pub fn or_reason(body: Result<Markup>) -> Markup {
    body.unwrap_or_else(|error| html! { p { "Not shown: " (format!("{error:#}")) "." } })
}

/// The buttons that step from clock to clock.
fn controls() -> Markup {
    html! {
        div.controls {
            button type="button" data-go="first" { "First" }
            button type="button" data-go="back" { "Back" }
            button type="button" data-go="next" { "Next" }
            button type="button" data-go="last" { "Last" }
            span.hint { "or the arrow keys" }
        }
    }
}

/// Something wide, which scrolls by itself where it is wider than the page.
fn scrolling(name: &str, wide: Markup) -> Markup {
    html! {
        div.scroll tabindex="0" role="region" aria-label=(name) { (wide) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page() -> String {
        let section = |id, title: &str| Section {
            id,
            title: title.to_owned(),
            body: html! { p { "body of " (id) } },
        };
        let page = Page {
            title: "a < b".to_owned(),
            verdict: vec![html! { strong { "yes" } }],
            sections: vec![section("one", "First"), section("two", "Second & last")],
            command: "photoncube report 'x'".to_owned(),
        };
        page.text()
    }

    #[test]
    fn the_verdict_is_first_and_every_section_is_in_the_contents() {
        let text = page();
        let place = |part: &str| text.find(part).unwrap_or_else(|| panic!("no {part}"));
        assert!(place("<strong>yes</strong>") < place("body of one"));
        assert!(place("body of one") < place("body of two"));
        for id in ["one", "two"] {
            assert!(text.contains(&format!("<a href=\"#{id}\">")), "{id}");
            assert_eq!(text.matches(&format!("id=\"{id}\"")).count(), 1, "{id}");
        }
        assert!(text.contains("<title>a &lt; b"));
        assert!(text.contains("Second &amp; last"));
    }

    /// `scripts/page/check.sh` opens pages in a browser; this needs none.
    #[test]
    fn nothing_is_loaded_from_elsewhere() {
        let text = page();
        for from in ["http:", "https:", "//", "@import", "url("] {
            // Comments of the script begin with two slashes and a space.
            let found = text
                .match_indices(from)
                .find(|(at, _)| !text[*at..].starts_with("// "));
            assert!(
                found.is_none(),
                "{from}: {}",
                &text[found.unwrap().0..][..40]
            );
        }
    }
}
