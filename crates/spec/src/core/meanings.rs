//! What the fields of a core's words mean.

use super::{Core, CoreStreams, StreamField, StreamWord};
use crate::interface::{Fact, Interface};

const PRESENT: &str = "the leaf has this photon; where it is 0, the photon's other fields are not looked at; no photon is behind an absent \
                       one";
const FACING: &str = "any number; batches with bit i of facings gather the leaves of facing i";

/// A stream of a core, and the fields of its words.
#[derive(Copy, Clone, Debug)]
pub struct StreamRow<'a> {
    /// The port that has the words.
    pub port: &'static str,
    /// The fields.
    pub word: &'a StreamWord,
    /// How the names of the same fields begin at the ports of a leaf machine.
    stem: &'static str,
}

impl CoreStreams {
    /// The three streams.
    pub fn rows(&self) -> [StreamRow<'_>; 3] {
        let row = |port, word, stem| StreamRow { port, word, stem };
        [
            row("s_axis_photons_tdata", &self.photons, "photon_"),
            row("s_axis_queries_tdata", &self.queries, "query_"),
            row("m_axis_results_tdata", &self.results, "result_"),
        ]
    }
}

impl<'a> StreamRow<'a> {
    /// The fields, each with its meaning. The photons of a leaf have equal fields, so only those of photon 0 are there.
    pub fn meanings(&self, core: &Core) -> Vec<(&'a StreamField, String)> {
        let ports = Interface::of(core.machine).ports;
        let of_machine = |field: &str| {
            let name = format!("{}{field}", self.stem);
            let port = ports
                .iter()
                .find(|port| port.name == name || port.name.starts_with(&format!("{name}_0..")));
            port.map_or_else(String::new, |port| port.meaning.clone())
        };
        let of_results = self.stem == "result_";
        let meaning = |name: &str| match name {
            "present_0" => PRESENT.to_owned(),
            "facing" => FACING.to_owned(),
            "tag" if of_results => "the tag of the query".to_owned(),
            "radius_sq" if of_results => {
                "the squared radius of the sums, as that of a query".to_owned()
            }
            name => of_machine(name.strip_suffix("_0").unwrap_or(name)),
        };
        let fields = self.word.fields.iter();
        let fields = fields.filter(|field| is_of_first_photon(&field.name));
        fields.map(|field| (field, meaning(&field.name))).collect()
    }
}

/// Whether a field is of a leaf's first photon, or of no photon.
fn is_of_first_photon(name: &str) -> bool {
    let number = name.rsplit_once('_').map(|(_, number)| number.parse());
    !matches!(number, Some(Ok(1_u32..)))
}

impl Core {
    /// The formats and limits of the chains' words: the numbers, the unit of powers, the frame, the search radius, the most photons of a query.
    pub fn number_facts(&self) -> Vec<Fact> {
        let facts = Interface::of(self.machine).facts.into_iter();
        let is_of_words = |fact: &Fact| {
            [
                "numbers",
                "power unit",
                "frame",
                "search radius",
                "most photons",
            ]
            .contains(&fact.name)
        };
        facts.filter(is_of_words).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CORES, find_machine};

    #[test]
    fn every_field_has_a_meaning() {
        let radii = ("leaf-7-radii-local7-rgb6d-n4096", 2);
        let named = CORES.iter().map(|&(chains, machine)| (machine, chains));
        for (machine, chains) in named.chain([radii]) {
            let core = Core::new(find_machine(machine).unwrap(), chains).unwrap();
            let streams = CoreStreams::of(&core);
            let meanings: Vec<_> = streams
                .rows()
                .iter()
                .flat_map(|row| row.meanings(&core))
                .collect();
            assert!(meanings.len() > 15, "{meanings:?}");
            for (field, meaning) in meanings {
                assert!(!meaning.is_empty(), "{machine}: {}", field.name);
            }
            // The search radius is a fact only where the queries have none.
            let facts = if core.has_radii() { 4 } else { 5 };
            assert_eq!(core.number_facts().len(), facts, "{machine}");
        }
    }
}
