//! The example of a machine.

use anyhow::Result;
use photoncube_hdl::generate_command;
use photoncube_spec::{
    BatchPins, Group, Inputs, Lane, Machine, Outputs, Photon, Pin, Pins, Query, Sums,
};

use super::set::Set;
use super::text::{self, Field, Word};

/// The pins of a stream's word, and where they are in a row.
struct Stream<'a> {
    pins: Vec<(usize, &'a Pin)>,
}

impl<'a> Stream<'a> {
    /// The pins whose names begin with one of the prefixes.
    fn of(pins: &'a [Pin], prefixes: &[&str]) -> Self {
        let is_in = |name: &str| prefixes.iter().any(|prefix| name.starts_with(prefix));
        let pins = pins.iter().enumerate();
        let pins = pins.filter(|(_, pin)| is_in(&pin.name) && text::is_of_word(&pin.name));
        Self {
            pins: pins.collect(),
        }
    }

    /// The fields of the word in a row of pins.
    fn fields(&self, row: &[u64]) -> Vec<Field> {
        let fields = self.pins.iter();
        fields
            .map(|&(place, pin)| (pin.width, row[place]))
            .collect()
    }

    fn names(&self) -> Vec<String> {
        let pins = self.pins.iter();
        pins.map(|(_, pin)| pin.name.clone()).collect()
    }

    fn bits(&self) -> u32 {
        self.pins.iter().map(|(_, pin)| pin.width).sum()
    }
}

/// The testbench of a machine.
///
/// # Errors
/// The machine's numbers have no example.
pub(in crate::project) fn machine_example(machine: &Machine) -> Result<String> {
    let pins = Pins::of(machine);
    let outputs = &pins.observed[..pins.outputs];
    let streams = [
        Stream::of(&pins.inputs, &["query_"]),
        Stream::of(&pins.inputs, &["group_", "photon_"]),
        Stream::of(outputs, &["result_"]),
    ];
    let words = words(machine, &streams, &sets(machine)?);
    let ports = pins.inputs.iter().chain(outputs);
    let ports = ports.map(|pin| (pin.name.clone(), pin.width));
    let ports: Vec<_> = ports.filter(|(name, _)| name != "reset").collect();
    let names = ["clock", "reset"].map(str::to_owned).into_iter();
    let names = names.chain(ports.iter().map(|(name, _)| name.clone()));
    let connections = text::connections(names.map(|name| (name.clone(), name)));
    let mut values = vec![
        ("NAME", machine.name.to_owned()),
        ("COMMAND", generate_command(machine)),
        ("TOP", machine.module_prefix()),
        ("VERSION", env!("CARGO_PKG_VERSION").to_owned()),
        ("BATCH", machine.queries_at_once().to_string()),
        ("WIRES", text::wires(&ports)),
        ("CONNECTIONS", connections),
    ];
    for ((stream, words), memory) in streams.iter().zip(&words).zip(&MEMORIES) {
        values.extend(of_memory(stream, words, memory));
    }
    Ok(text::filled(include_str!("machine.v"), &values))
}

/// A memory of words, and the names of its values in the template: words, names of the fields, pins, number of words, last word, bits,
/// highest bit.
type Memory = (&'static str, [&'static str; 7]);

const MEMORIES: [Memory; 3] = [
    (
        "queries",
        [
            "QUERY_WORDS",
            "QUERY_NAMES",
            "QUERY_PINS",
            "QUERIES",
            "LAST_QUERY",
            "QUERY_BITS",
            "QUERY_HIGH",
        ],
    ),
    (
        "groups",
        [
            "GROUP_WORDS",
            "GROUP_NAMES",
            "GROUP_PINS",
            "GROUPS",
            "LAST_GROUP",
            "GROUP_BITS",
            "GROUP_HIGH",
        ],
    ),
    (
        "results",
        [
            "RESULT_WORDS",
            "RESULT_NAMES",
            "RESULT_PINS",
            "RESULTS",
            "LAST_RESULT",
            "RESULT_BITS",
            "RESULT_HIGH",
        ],
    ),
];

/// The values of a memory.
fn of_memory(
    stream: &Stream<'_>,
    words: &[Word],
    (memory, names): &Memory,
) -> Vec<(&'static str, String)> {
    let pins = stream.names();
    let (count, bits) = (words.len(), stream.bits());
    let values = [
        text::words(memory, words),
        text::lines(&pins, "        // ", "        // "),
        text::lines(&pins, "", "        "),
        count.to_string(),
        (count - 1).to_string(),
        bits.to_string(),
        (bits - 1).to_string(),
    ];
    names.iter().copied().zip(values).collect()
}

/// Two sets of photons. A machine that keeps sets plays the first to two batches.
fn sets(machine: &Machine) -> Result<Vec<Set>> {
    let batch = machine.queries_at_once();
    let first = if machine.keeps_sets() { 2 } else { 1 };
    let batches = [vec![batch; first], vec![batch]];
    let set = |(number, batches): (u64, &Vec<usize>)| Set::new(machine, number, batches);
    (0..).zip(&batches).map(set).collect()
}

/// The words of the queries, the groups and the results, in their orders.
fn words(machine: &Machine, streams: &[Stream<'_>; 3], sets: &[Set]) -> [Vec<Word>; 3] {
    let [query_stream, group_stream, result_stream] = streams;
    let lanes = machine.photons_per_iteration();
    let mut words = [Vec::new(), Vec::new(), Vec::new()];
    let [queries, groups, results] = &mut words;
    for set in sets {
        for group in set_groups(&set.photons, lanes) {
            let row = Pins::input_row(
                machine,
                &Inputs {
                    group,
                    ..idle(lanes)
                },
            );
            groups.push(lane_rows(&group_stream.fields(&row), lanes));
        }
        let last_batch = set.batches.len() - 1;
        for (batch, queries_of) in set.batches.iter().enumerate() {
            for (place, &(query, result)) in queries_of.iter().enumerate() {
                let tag = queries.len() as u32;
                let last = place + 1 == queries_of.len();
                let query_row = query_row(machine, query, batch == last_batch, last, tag);
                queries.push(vec![query_stream.fields(&query_row)]);
                let result_row = result_row(machine, result, tag);
                results.push(vec![result_stream.fields(&result_row)]);
            }
        }
    }
    words
}

/// Pins without a word.
fn idle(lanes: usize) -> Inputs {
    Inputs {
        group: Group {
            lanes: vec![Lane::default(); lanes],
            ..Group::default()
        },
        ..Inputs::default()
    }
}

/// Photons in groups, whose last has absent photons.
fn set_groups(photons: &[Photon], lanes: usize) -> impl Iterator<Item = Group> {
    let count = photons.len().div_ceil(lanes);
    let lane = |photon: Option<&Photon>| Lane {
        present: photon.is_some(),
        photon: photon.copied().unwrap_or_default(),
    };
    (0..count).map(move |group| Group {
        lanes: (0..lanes)
            .map(|place| lane(photons.get(group * lanes + place)))
            .collect(),
        last: group + 1 == count,
        facing: 0,
    })
}

/// A row for the pins of the group itself, and one for each lane.
fn lane_rows(fields: &[Field], lanes: usize) -> Vec<Vec<Field>> {
    let of_lanes = fields.len() / lanes * lanes;
    let (own, of_lanes) = fields.split_at(fields.len() - of_lanes);
    let of_lane = of_lanes.len() / lanes;
    let rows = of_lanes.chunks(of_lane).map(<[_]>::to_vec);
    std::iter::once(own.to_vec()).chain(rows).collect()
}

/// A query of a batch that gathers all facings; `release` and `last` are of its set and of its batch.
fn query_row(machine: &Machine, query: Query, release: bool, last: bool, tag: u32) -> Vec<u64> {
    let inputs = Inputs {
        query,
        query_release: release,
        batch: BatchPins {
            last,
            facings: u32::MAX,
            tag,
        },
        ..idle(machine.photons_per_iteration())
    };
    Pins::input_row(machine, &inputs)
}

fn result_row(machine: &Machine, result: Sums, tag: u32) -> Vec<u64> {
    let outputs = Outputs {
        result,
        result_tag: tag,
        ..Outputs::default()
    };
    Pins::output_row(machine, &outputs)
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{MACHINES, find_machine};

    use super::*;

    #[test]
    fn every_machine_has_an_example_of_lines_that_fit() {
        let leaf = find_machine("leaf-5-local7-rgb6d-n64").unwrap();
        for machine in MACHINES.iter().chain([leaf]) {
            let text = machine_example(machine).unwrap();
            let open = |line: &&str| line.contains('@') && !line.contains("always @(posedge");
            assert_eq!(text.lines().find(open), None);
            let longest = text.lines().map(str::len).max().unwrap();
            assert!(longest <= 140, "{}: {longest} columns", machine.name);
            for pin in Pins::of(machine).inputs {
                let port = format!(".{0}({0})", pin.name);
                assert!(text.contains(&port), "{}: no {port}", machine.name);
            }
        }
    }

    #[test]
    fn machines_of_the_smallest_and_largest_formats_have_an_example() {
        for name in [
            "sequential-local4-mono1-n1",
            "stream-local12-rgb16-n2",
            "tile-6-local4x2-rgb4e3-n3",
            "tile-10-local9-mono8-n65536",
            "leaf-4-local5-rgb2-n8",
        ] {
            let text = machine_example(find_machine(name).unwrap()).unwrap();
            assert!(text.contains(" results[0] = {"), "{name}");
        }
    }

    #[test]
    fn a_set_is_played_twice_where_it_is_kept() {
        let batches = |name| {
            let sets = sets(find_machine(name).unwrap()).unwrap();
            sets.iter().map(|set| set.batches.len()).collect::<Vec<_>>()
        };
        assert_eq!(batches("tile-5"), [1, 1]);
        assert_eq!(batches("tile-6-mixed"), [2, 1]);
    }
}
