//! A datasheet as a list of parts, from which Markdown and HTML are written.
//!
//! A text may have `code` between backquotes and [links](to-pages), as in Markdown.

use crate::table::Table;

/// A document.
pub struct Document {
    /// The title.
    pub title: String,
    /// The parts below it.
    pub parts: Vec<Part>,
}

/// A part of a document.
pub enum Part {
    /// The heading of a section.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// A list.
    List(Vec<String>),
    /// A table. Its cells are texts too.
    Table(Table),
    /// A picture in the folder of pictures, by the name of its file without ending.
    Picture {
        /// The name.
        name: String,
        /// What it shows, for those who do not see it.
        says: String,
    },
}

impl Document {
    /// A document with a title.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            parts: Vec::new(),
        }
    }

    /// Adds a heading.
    pub fn heading(&mut self, heading: &str) {
        self.parts.push(Part::Heading(heading.to_owned()));
    }

    /// Adds a paragraph.
    pub fn text(&mut self, text: impl Into<String>) {
        self.parts.push(Part::Text(text.into()));
    }

    /// Adds a list.
    pub fn list(&mut self, items: impl IntoIterator<Item = String>) {
        self.parts.push(Part::List(items.into_iter().collect()));
    }

    /// Adds a table.
    pub fn table(&mut self, table: Table) {
        self.parts.push(Part::Table(table));
    }

    /// Adds a picture.
    pub fn picture(&mut self, name: &str, says: &str) {
        self.parts.push(Part::Picture {
            name: name.to_owned(),
            says: says.to_owned(),
        });
    }
}
