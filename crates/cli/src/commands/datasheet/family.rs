//! The families of machines, each of which has a datasheet.

use clap::builder::PossibleValuesParser;
use photoncube_spec::{Machine, Organisation};

/// A family: machines with the same ports and rules.
pub struct Family {
    /// The name, which is also that of its files.
    pub name: &'static str,
    /// The title of its datasheet.
    pub title: &'static str,
    /// The machine whose ports and timing are shown.
    pub example: &'static str,
    /// What the machines are, a sentence each.
    pub about: &'static [&'static str],
    /// The pictures of its parts, with what each shows.
    pub pictures: &'static [(&'static str, &'static str)],
}

const CELL: (&str, &str) = (
    "cell",
    "A cell: registers, operand multiplexers, units and links",
);
const HYPERCUBE: (&str, &str) = (
    "hypercube",
    "The hypercube of 16 cells: its links on four axes, the photons and the roles",
);
const TILE: (&str, &str) = (
    "tile",
    "A tile: a chain of engines behind a head, and a group's way through an engine",
);

/// The family of cores, which are no machines of their own.
pub const CORE: Family = Family {
    name: "core",
    title: "Cores",
    example: "leaf-5-local7-rgb6d-n64",
    about: &[
        "A core is several equal leaf machines, its chains, behind three AXI4-Streams and registers behind AXI4-Lite.",
        "Each chain has a memory of leaves and a chain of engines of its own.",
        "The modules around the chains move words, count and answer accesses. They do no arithmetic on photons.",
    ],
    pictures: &[(
        "core",
        "The modules of a core between its ports: slices, stages, queues, chains, merges, registers",
    )],
};

/// All families of machines, in the order of their datasheets.
pub const FAMILIES: [Family; 6] = [
    Family {
        name: "sequential",
        title: "Sequential machines",
        example: "paper",
        about: &[
            "A sequential machine is the processor of Ryu, Kim and Lee: 16 cells on a 4-D hypercube, or 32 on a 5-D one.",
            "All cells execute one instruction a clock. A group of photons is tested against one query in an iteration of the microprogram.",
        ],
        pictures: &[CELL, HYPERCUBE],
    },
    Family {
        name: "overlap",
        title: "Overlapped machine",
        example: "overlap",
        about: &[
            "The overlapped machine has the 16 cells of a sequential machine, with all units at work in every clock.",
            "Each role of cells has its own instruction, which a modulo scheduler finds. Two groups are under way in each iteration.",
        ],
        pictures: &[HYPERCUBE],
    },
    Family {
        name: "stream",
        title: "Stream machine",
        example: "stream",
        about: &[
            "The stream machine is one engine of 16 cells. Every cell keeps its instruction, and a group of photons enters in every clock.",
            "Each query has a search radius of its own. A change of query takes no clock.",
        ],
        pictures: &[HYPERCUBE, TILE],
    },
    Family {
        name: "tile",
        title: "Tiles",
        example: "tile-5",
        about: &[
            "A tile is a chain of 1 to 64 engines of 16 cells. Each engine holds one query of a batch.",
            "A photon is read once and meets the queries of all engines. All queries have the search radius of the photon format.",
        ],
        pictures: &[TILE],
    },
    Family {
        name: "chip",
        title: "Tiles with a photon memory",
        example: "tile-6-mixed",
        about: &[
            "These machines are tiles behind a photon memory of two banks.",
            "A set of photons is read in once and played to batch after batch of queries, while the next set is read into the other bank.",
        ],
        pictures: &[TILE],
    },
    Family {
        name: "leaf",
        title: "Leaf machines",
        example: "leaf-5-local7-rgb6d-n4096",
        about: &[
            "A leaf machine is a tile behind a memory of leaves, which are groups of eight photons that are close together.",
            "A culler skips the groups of four that are out of range of a whole batch of queries. No photon in range is skipped.",
        ],
        pictures: &[TILE],
    },
];

/// The names of all families, as the values of an argument.
pub fn family_names() -> PossibleValuesParser {
    Family::all()
        .map(|family| family.name)
        .collect::<Vec<_>>()
        .into()
}

impl Family {
    /// The family of a machine.
    pub fn of(machine: &Machine) -> &'static Self {
        let name = match &machine.organisation {
            Organisation::Sequential | Organisation::Programmed(_) => "sequential",
            Organisation::Overlapped => "overlap",
            Organisation::Leaf(_) => "leaf",
            Organisation::Spatial(_) if machine.has_memory() => "chip",
            Organisation::Spatial(_) if machine.fixed_radius_sq().is_none() => "stream",
            Organisation::Spatial(_) => "tile",
        };
        let family = FAMILIES.iter().find(|family| family.name == name);
        family.expect("every organisation has a family")
    }

    /// All families.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        FAMILIES.iter().chain([&CORE])
    }

    /// The file of its datasheet in the repository.
    pub fn page(&self) -> String {
        format!("docs/datasheets/{}.md", self.name)
    }

    /// The name of its timing diagram.
    pub fn timing(&self) -> String {
        format!("timing-{}", self.name)
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{CORES, MACHINES, Spatial, find_machine};

    use super::*;

    #[test]
    fn every_family_has_an_example_and_every_machine_a_family() {
        for family in &FAMILIES {
            let example = find_machine(family.example).unwrap();
            assert_eq!(Family::of(example).name, family.name);
        }
        for family in FAMILIES.iter().filter(|family| family.name != "leaf") {
            let members = MACHINES
                .iter()
                .filter(|m| Family::of(m).name == family.name);
            assert!(members.count() > 0, "{}", family.name);
        }
        assert_eq!(CORE.example, CORES[0].1);
    }

    #[test]
    fn the_numbers_in_the_words_about_tiles_are_those_of_the_machines() {
        let tile = FAMILIES
            .iter()
            .find(|family| family.name == "tile")
            .unwrap();
        let members = MACHINES.iter().filter(|m| Family::of(m).name == tile.name);
        let engines: Vec<_> = members.map(Machine::queries_at_once).collect();
        let said = format!(
            "{} to {} engines of {} cells",
            engines.iter().min().unwrap(),
            engines.iter().max().unwrap(),
            Spatial::ENGINE_CELLS
        );
        assert!(tile.about[0].contains(&said), "{said}");
    }
}
