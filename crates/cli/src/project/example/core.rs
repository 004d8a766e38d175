//! The example of a core.

use anyhow::{Context, Result};
use photoncube_spec::{
    BatchPins, Core, CoreCounter, CoreRegister, CoreStreams, Direction, Port, Query, QueryResult,
    QueryWord, StreamWord, Sums,
};

use super::set::Set;
use super::text::{self, Field, Word};

/// The most queries of a batch.
const QUERIES: usize = 2;
/// The ports that the template declares.
const OF_CLOCK: [&str; 2] = ["aclk", "aresetn"];
/// The facing of all photons.
const FACING: u32 = 0;

/// The words of an example, each its rows of fields.
#[derive(Default)]
struct Words {
    photons: Vec<Word>,
    queries: Vec<Word>,
    results: Vec<Word>,
    /// The counts of all results.
    in_range: u64,
}

/// The testbench of a core.
///
/// # Errors
/// The core's numbers have no example.
pub(in crate::project) fn core_example(core: &Core) -> Result<String> {
    let streams = CoreStreams::of(core);
    let words = words(core, &streams)?;
    let reads = reads(core, &words)?;
    let [wires, connections] = ports(core);
    let of_photon = (streams.photons.fields.len() - 1) / Core::LEAF_PHOTONS;
    let all = |word: &StreamWord| field_names(word, word.fields.len());
    let mut values = vec![
        ("NAME", core.name()),
        ("MACHINE", core.machine.name.to_owned()),
        ("TOP", core.top()),
        ("VERSION", env!("CARGO_PKG_VERSION").to_owned()),
        ("PHOTON_NAMES", field_names(&streams.photons, of_photon)),
        ("QUERY_NAMES", all(&streams.queries)),
        ("RESULT_NAMES", all(&streams.results)),
        ("PHOTON_WORDS", text::words("photons", &words.photons)),
        ("QUERY_WORDS", text::words("queries", &words.queries)),
        ("RESULT_WORDS", text::words("results", &words.results)),
        ("READ_WORDS", reads.concat()),
        ("WIRES", wires),
        ("CONNECTIONS", connections),
    ];
    let numbers = numbers(core, &words, reads.len() as u32);
    values.extend(numbers.map(|(name, number)| (name, number.to_string())));
    Ok(text::filled(include_str!("core.v"), &values))
}

/// The numbers of the template.
fn numbers(core: &Core, words: &Words, reads: u32) -> [(&'static str, u32); 20] {
    let memories = [&words.photons, &words.queries, &words.results];
    let [photons, queries, results] = memories.map(|words| words.len() as u32);
    let bits = |words: &Vec<Word>| words[0].iter().map(|row| text::bits(row)).sum();
    let [photon_bits, query_bits, result_bits]: [u32; 3] = memories.map(bits);
    [
        ("CHAINS", core.chains),
        ("LAST_CHAIN", core.chains - 1),
        ("PHOTONS", photons),
        ("LAST_PHOTON", photons - 1),
        ("QUERIES", queries),
        ("LAST_QUERY", queries - 1),
        ("RESULTS", results),
        ("LAST_RESULT", results - 1),
        ("OF_CHAIN", results / core.chains),
        ("READS", reads),
        ("LAST_READ", reads - 1),
        ("PHOTON_BITS", photon_bits),
        ("PHOTON_HIGH", photon_bits - 1),
        ("QUERY_BITS", query_bits),
        ("QUERY_HIGH", query_bits - 1),
        ("RESULT_HIGH", result_bits - 1),
        ("WORD_BITS", Core::REGISTER_BITS),
        ("WORD_HIGH", Core::REGISTER_BITS - 1),
        ("ADDRESS_BITS", Core::ADDRESS_BITS),
        ("READ_HIGH", Core::ADDRESS_BITS + Core::REGISTER_BITS - 1),
    ]
}

/// The wires of the testbench, and the ports of the core with what is on them. Nothing is written, so the ports of writes have no wires.
fn ports(core: &Core) -> [String; 2] {
    let (written, used): (Vec<_>, Vec<_>) = core.ports().into_iter().partition(is_of_writes);
    let wires = used
        .iter()
        .filter(|port| !OF_CLOCK.contains(&port.name.as_str()));
    let wires: Vec<_> = wires.map(|port| (port.name.clone(), port.width)).collect();
    let used = used
        .iter()
        .map(|port| (port.name.clone(), port.name.clone()));
    let written = written.iter().map(|port| (port.name.clone(), unused(port)));
    [text::wires(&wires), text::connections(used.chain(written))]
}

/// Whether a port is of AXI4-Lite's three channels of writes.
fn is_of_writes(port: &Port) -> bool {
    let channels = ["s_axi_aw", "s_axi_w", "s_axi_b"];
    channels
        .iter()
        .any(|channel| port.name.starts_with(channel))
}

/// What is on a port that is not used.
fn unused(port: &Port) -> String {
    match port.direction {
        Direction::Input => format!("{}'d0", port.width),
        Direction::Output => String::new(),
    }
}

/// The names of the first fields of a word, the highest first, in a comment.
fn field_names(word: &StreamWord, fields: usize) -> String {
    let names = word.fields[..fields].iter().rev();
    let names: Vec<_> = names
        .map(|field| field.name.trim_end_matches("_0").to_owned())
        .collect();
    text::lines(&names, "        //   ", "        //   ")
}

/// A set for each chain, gathered by two batches.
fn words(core: &Core, streams: &CoreStreams) -> Result<Words> {
    let mut words = Words::default();
    let batch = core.engines().min(QUERIES);
    for chain in 0..core.chains {
        let set = Set::new(core.machine, chain.into(), &[1, batch])?;
        let leaves = set.photons.chunks(Core::LEAF_PHOTONS);
        let last_leaf = leaves.len() - 1;
        for (place, photons) in leaves.enumerate() {
            let values = CoreStreams::leaf_values(core, photons, FACING);
            let fields = fields(&streams.photons, &values);
            let mut rows = photon_rows(&fields, (values.len() - 1) / Core::LEAF_PHOTONS);
            rows[0].splice(
                ..0,
                [
                    (1, u64::from(place == last_leaf)),
                    (core.chain_bits(), chain.into()),
                ],
            );
            words.photons.push(rows);
        }
        let last_batch = set.batches.len() - 1;
        for (number, queries) in set.batches.iter().enumerate() {
            for (place, &(query, sums)) in queries.iter().enumerate() {
                let last = place + 1 == queries.len();
                words.push(
                    core,
                    streams,
                    chain,
                    query_word(query, number == last_batch, last),
                    sums,
                );
            }
        }
    }
    Ok(words)
}

impl Words {
    /// Appends a query, whose tag is its number, and its result.
    fn push(
        &mut self,
        core: &Core,
        streams: &CoreStreams,
        chain: u32,
        mut word: QueryWord,
        sums: Sums,
    ) {
        word.batch.tag = self.queries.len() as u32;
        let last = (1, u64::from(word.batch.last));
        let mut query = vec![last, (core.chain_bits(), chain.into())];
        query.extend(fields(
            &streams.queries,
            &CoreStreams::query_values(core, &word),
        ));
        self.queries.push(vec![query]);
        let values = QueryResult {
            sums,
            tag: word.batch.tag,
            radius_sq: core.has_radii().then_some(word.query.radius_sq),
        };
        let values = CoreStreams::result_values(core, &values);
        let mut result = vec![(1, 0), last];
        result.extend(fields(&streams.results, &values));
        self.results.push(vec![result]);
        self.in_range += sums.count;
    }
}

/// A query of a batch that gathers the facing of the photons.
fn query_word(query: Query, release: bool, last: bool) -> QueryWord {
    QueryWord {
        query,
        release,
        batch: BatchPins {
            last,
            facings: 1 << FACING,
            tag: 0,
        },
    }
}

/// All bits of a word from the highest down. Bits without a field are a field of 0.
fn fields(word: &StreamWord, values: &[u64]) -> Vec<Field> {
    let mut fields = Vec::new();
    let mut end = 0;
    for (field, &value) in word.fields.iter().zip(values) {
        fields.extend((field.low > end).then_some((field.low - end, 0)));
        fields.push((field.width, value));
        end = field.low + field.width;
    }
    fields.extend((word.bits > end).then_some((word.bits - end, 0)));
    fields.reverse();
    fields
}

/// A row for the facing and the bits above, then one for each photon.
fn photon_rows(fields: &[Field], of_photon: usize) -> Vec<Vec<Field>> {
    let (head, photons) = fields.split_at(fields.len() - of_photon * Core::LEAF_PHOTONS);
    let photons = photons.chunks(of_photon).map(<[_]>::to_vec);
    std::iter::once(head.to_vec()).chain(photons).collect()
}

/// The registers that are read: for each a line with its address and the expected word.
fn reads(core: &Core, words: &Words) -> Result<Vec<String>> {
    let registers = [
        (CoreRegister::Identity, CoreRegister::IDENTITY),
        (
            CoreRegister::CounterLow(CoreCounter::Results),
            words.results.len() as u32,
        ),
        (
            CoreRegister::CounterLow(CoreCounter::PhotonsInRange),
            words.in_range as u32,
        ),
    ];
    // The digest changes no address.
    let rows = CoreRegister::all(core, 0);
    let line = |(place, (register, word)): (usize, (CoreRegister, u32))| {
        let row = rows.iter().find(|row| row.register == register);
        let row = row.with_context(|| format!("the map has no {register:?}"))?;
        Ok(format!(
            "        reads[{place}] = {{{}'h{:03x}, {}'h{word:08x}}};  // {}\n",
            Core::ADDRESS_BITS,
            row.address,
            Core::REGISTER_BITS,
            row.name
        ))
    };
    registers.into_iter().enumerate().map(line).collect()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::*;

    #[test]
    fn cores_of_all_formats_have_an_example() {
        for (chains, machine) in [
            (1, "leaf-4-local7-rgb6d-n64"),
            (3, "leaf-5-local7-rgb6d-n64"),
            (2, "leaf-4-local6x2-rgb4d-n64"),
            (2, "leaf-5-local8-rgb8e5-n4096"),
            (2, "leaf-5-radii-local7-rgb6d-n64"),
            (2, "leaf-4-radii-local6x2-rgb4d-n64"),
        ] {
            let core = Core::new(find_machine(machine).unwrap(), chains).unwrap();
            let text = core_example(&core).unwrap();
            let open = |line: &&str| line.contains('@') && !line.contains("always @(posedge");
            assert_eq!(text.lines().find(open), None);
            for port in core.ports() {
                let port = format!(".{}(", port.name);
                assert!(text.contains(&port), "{machine}: no {port}");
            }
        }
    }

    #[test]
    fn bits_without_a_field_are_zeros_between_the_fields() {
        let core = Core::new(find_machine("leaf-5-local7-rgb6d-n64").unwrap(), 2).unwrap();
        let word = CoreStreams::of(&core).queries;
        let fields = fields(&word, &[1, 2, 3, 4, 5, 1]);
        assert_eq!(text::bits(&fields), word.bits);
        let expected = [
            (31, 0),
            (1, 1),
            (32, 5),
            (16, 4),
            (7, 0),
            (9, 3),
            (7, 0),
            (9, 2),
            (7, 0),
            (9, 1),
        ];
        assert_eq!(fields, expected);
    }
}
