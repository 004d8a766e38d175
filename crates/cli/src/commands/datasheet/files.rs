//! The files of the datasheets: pages, pictures, and the diagrams from which timing pictures are drawn.

use std::collections::BTreeMap;

use anyhow::Result;
use photoncube_spec::{CORES, Core, MACHINES, find_machine};

use super::document::{Document, Part};
use super::family::{CORE, Family};
use super::html::html;
use super::markdown::markdown;
use super::{core, sheet};
use crate::pictures::{self, Diagram};
use crate::table::Table;

/// A file below the folder that is written.
pub struct PageFile {
    /// Its path, with `/` between the folders.
    pub path: String,
    /// Its contents.
    pub text: String,
}

/// The folders of the pages and of the pictures.
pub const FOLDERS: [&str; 2] = ["datasheets", "pictures"];

/// The picture of the whole, which the README shows.
const OVERVIEW: &str = "machine.svg";

/// The files of the datasheets of these families: of all, with the list of them and the overview, where they are the `whole`.
///
/// # Errors
/// A picture has no place for something, or a committed figure cannot be read.
pub fn page_files(families: &[&Family], whole: bool, with_html: bool) -> Result<Vec<PageFile>> {
    let [pages, folder] = FOLDERS;
    let mut drawn = BTreeMap::new();
    for picture in pictures::parts()? {
        drawn.insert(picture.name.to_owned(), picture.text);
    }
    let mut files = Vec::new();
    for family in families {
        let diagram = diagram(family)?;
        let wave = diagram.wave_json();
        let picture = pictures::picture(&wave, &diagram.title, &words(&diagram))?;
        files.push(PageFile {
            path: format!("{folder}/{}.json", family.timing()),
            text: wave,
        });
        drawn.insert(family.timing(), picture);
        let document = match family.name == CORE.name {
            true => core::sheet()?,
            false => sheet::sheet(family)?,
        };
        files.push(PageFile {
            path: format!("{pages}/{}.md", family.name),
            text: markdown(&document, &format!("../{folder}")),
        });
        if with_html {
            files.push(PageFile {
                path: format!("{pages}/{}.html", family.name),
                text: html(&document, |name| drawn.get(name).map(String::as_str))?,
            });
        }
        if !whole {
            files.extend(shown(&document, &drawn));
        }
    }
    if whole {
        files.extend(drawn.iter().map(svg_file));
        files.push(PageFile {
            path: OVERVIEW.to_owned(),
            text: pictures::overview()?,
        });
        files.push(PageFile {
            path: format!("{pages}/README.md"),
            text: markdown(&contents(families), &format!("../{folder}")),
        });
    }
    Ok(files)
}

fn svg_file((name, text): (&String, &String)) -> PageFile {
    PageFile {
        path: format!("{}/{name}.svg", FOLDERS[1]),
        text: text.clone(),
    }
}

/// The pictures that a document shows.
fn shown(document: &Document, drawn: &BTreeMap<String, String>) -> Vec<PageFile> {
    let names = document.parts.iter().filter_map(|part| match part {
        Part::Picture { name, .. } => Some(name),
        _ => None,
    });
    names
        .filter_map(|name| drawn.get_key_value(name))
        .map(svg_file)
        .collect()
}

/// The timing diagram of a family.
fn diagram(family: &Family) -> Result<Diagram> {
    match family.name == CORE.name {
        true => {
            let (chains, machine) = CORES[0];
            pictures::timing_of_core(&Core::new(find_machine(machine)?, chains)?)
        }
        false => pictures::timing(find_machine(family.example)?),
    }
}

/// A diagram in words, for those who do not see it.
fn words(diagram: &Diagram) -> String {
    let names: Vec<_> = diagram
        .signals
        .iter()
        .map(|signal| signal.name.as_str())
        .collect();
    format!(
        "The signals {} in {} clocks, with the values of the golden model.",
        names.join(", "),
        diagram.clocks
    )
}

/// The list of the datasheets.
fn contents(families: &[&Family]) -> Document {
    let mut document = Document::new("Datasheets");
    document.text(
        "A datasheet for each family of machines: ports, protocol, timing diagram, latency, throughput, limits, formats, known limitations, area \
         and clock. `photoncube datasheet` writes them, with `--html` also as HTML, and `photoncube list MACHINE` prints the figures of one \
         machine.",
    );
    let row = |family: &&Family| {
        let members = MACHINES
            .iter()
            .filter(|machine| family.name != CORE.name && Family::of(machine).name == family.name);
        let members: Vec<_> = members
            .map(|machine| format!("`{}`", machine.name))
            .collect();
        vec![
            format!("[{0}]({0}.md)", family.name),
            family.title.to_owned(),
            match members.is_empty() {
                true => "machines of any photon format".to_owned(),
                false => members.join(", "),
            },
        ]
    };
    document.table(Table::new(
        &["datasheet", "family", "machines"],
        families.iter().map(row),
    ));
    document.heading("Pictures");
    document.text(
        "They are drawn from the specification and from the emitted text. The diagrams of timing are beside them, as WaveJSON and as SVG.",
    );
    let mut named: Vec<_> = families.iter().flat_map(|family| family.pictures).collect();
    named.sort_unstable();
    named.dedup();
    document.list(
        named
            .iter()
            .map(|(name, says)| format!("[{name}](../{}/{name}.svg): {says}.", FOLDERS[1])),
    );
    document
}
