//! The timing diagram of a core's streams, with the values of its golden model.

use std::collections::VecDeque;

use anyhow::{Result, bail};
use photoncube_model::CoreModel;
use photoncube_spec::{
    BatchPins, Beat, Core, CoreInputs, CoreOutputs, CoreStreams, QueryWord, StreamIn, StreamWord,
};

use super::wave::{Diagram, Signal};
use crate::project::Set;

/// The chains that are given words.
const CHAINS: u32 = 2;
/// The batches of each chain.
const BATCHES: usize = 2;
/// The facing of all photons.
const FACING: u32 = 0;
/// The clocks in which the results must come.
const MOST_CLOCKS: usize = 2_000;
/// The clocks that are shown before the first word, and behind the last result.
const AROUND: usize = 1;

/// Words for both input streams.
#[derive(Default)]
struct Words {
    photons: VecDeque<Beat>,
    queries: VecDeque<Beat>,
    results: usize,
}

/// The pins of a stream in a clock.
#[derive(Clone, Copy, Default)]
struct Pins {
    valid: bool,
    ready: bool,
    last: bool,
    chain: u64,
    /// The field that is shown.
    field: u64,
}

/// A stream: its name, the port with the chain's number, the field of its words that is shown.
type Stream = (&'static str, &'static str, &'static str);

const STREAMS: [Stream; 3] = [
    ("s_axis_photons", "tdest", "x_0"),
    ("s_axis_queries", "tdest", "x"),
    ("m_axis_results", "tid", "count"),
];

/// A set and two batches for each of two chains, without waiting.
///
/// # Errors
/// The core has no example, or its results do not come.
pub fn timing_of_core(core: &Core) -> Result<Diagram> {
    let streams = CoreStreams::of(core);
    let mut words = words(core, &streams)?;
    // The digest is seen in registers alone, which are not read.
    let mut model = CoreModel::new(core, 0);
    let mut clocks: Vec<[Pins; STREAMS.len()]> = Vec::new();
    let mut after = 0;
    while after <= AROUND {
        if clocks.len() == MOST_CLOCKS {
            bail!(
                "the golden model of {} gave no results in {MOST_CLOCKS} clocks",
                core.name()
            );
        }
        let waits = clocks.len() >= AROUND;
        let inputs = CoreInputs {
            photons: offered(words.photons.front().filter(|_| waits)),
            queries: offered(words.queries.front().filter(|_| waits)),
            result_ready: true,
            ..CoreInputs::default()
        };
        let outputs = model.outputs(&inputs);
        clocks.push(pins(&streams, &inputs, &outputs));
        if inputs.photons.valid && outputs.photon_ready {
            words.photons.pop_front();
        }
        if inputs.queries.valid && outputs.query_ready {
            words.queries.pop_front();
        }
        words.results -= usize::from(outputs.result.is_some());
        after += usize::from(words.results == 0);
        model.clock(&inputs);
    }
    let signals = STREAMS.iter().enumerate();
    Ok(Diagram {
        title: format!(
            "{}: a set of photons and {BATCHES} batches for each of {CHAINS} chains",
            core.name()
        ),
        clocks: clocks.len(),
        signals: signals
            .flat_map(|(place, stream)| signals_of(*stream, &clocks, place))
            .collect(),
    })
}

fn offered(beat: Option<&Beat>) -> StreamIn {
    StreamIn {
        valid: beat.is_some(),
        beat: beat.cloned().unwrap_or_default(),
    }
}

/// The words of a set and its batches for each chain. The chains take turns, batch by batch.
fn words(core: &Core, streams: &CoreStreams) -> Result<Words> {
    let mut words = Words::default();
    let sets = (0..CHAINS.min(core.chains))
        .map(|chain| Set::new(core.machine, chain.into(), &[core.engines(); BATCHES]))
        .collect::<Result<Vec<_>>>()?;
    for (chain, set) in (0..).zip(&sets) {
        let leaves = set.photons.chunks(Core::LEAF_PHOTONS);
        let count = leaves.len();
        words
            .photons
            .extend(leaves.enumerate().map(|(place, photons)| {
                Beat {
                    data: streams
                        .photons
                        .bytes(&CoreStreams::leaf_values(core, photons, FACING)),
                    last: place + 1 == count,
                    dest: chain,
                }
            }));
    }
    for batch in 0..BATCHES {
        for (chain, set) in (0..).zip(&sets) {
            let queries = &set.batches[batch];
            for (place, (query, _)) in queries.iter().enumerate() {
                let last = place + 1 == queries.len();
                let word = QueryWord {
                    query: *query,
                    release: batch + 1 == BATCHES,
                    batch: BatchPins {
                        last,
                        facings: 1 << FACING,
                        tag: words.results as u32,
                    },
                };
                words.queries.push_back(Beat {
                    data: streams
                        .queries
                        .bytes(&CoreStreams::query_values(core, &word)),
                    last,
                    dest: chain,
                });
                words.results += 1;
            }
        }
    }
    Ok(words)
}

fn pins(
    streams: &CoreStreams,
    inputs: &CoreInputs,
    outputs: &CoreOutputs,
) -> [Pins; STREAMS.len()] {
    let of_input =
        |stream: &StreamIn, ready: bool, word: &StreamWord, field: &str| match stream.valid {
            true => Pins {
                valid: true,
                ready,
                last: stream.beat.last,
                chain: stream.beat.dest.into(),
                field: value(word, &stream.beat.data, field),
            },
            false => Pins {
                ready,
                ..Pins::default()
            },
        };
    let [photons, queries, results] = STREAMS.map(|(_, _, field)| field);
    let result = outputs.result.as_ref().map(|result| Pins {
        valid: true,
        ready: true,
        last: result.last,
        chain: result.id.into(),
        field: value(&streams.results, &result.data, results),
    });
    [
        of_input(
            &inputs.photons,
            outputs.photon_ready,
            &streams.photons,
            photons,
        ),
        of_input(
            &inputs.queries,
            outputs.query_ready,
            &streams.queries,
            queries,
        ),
        result.unwrap_or(Pins {
            ready: inputs.result_ready,
            ..Pins::default()
        }),
    ]
}

/// The value of a field of a word.
fn value(word: &StreamWord, data: &[u8], field: &str) -> u64 {
    let fields = word.fields.iter().zip(word.values(data));
    let mut fields = fields.filter(|(of, _)| of.name == field);
    fields.next().map_or(0, |(_, value)| value)
}

fn signals_of(
    (stream, chain, field): Stream,
    clocks: &[[Pins; STREAMS.len()]],
    place: usize,
) -> Vec<Signal> {
    let pins: Vec<Pins> = clocks.iter().map(|clock| clock[place]).collect();
    let moved = |pins: &Pins| pins.valid && pins.ready;
    let begins: Vec<_> = std::iter::once(false)
        .chain(pins.iter().map(moved))
        .collect();
    let signal = |name: String, is_level: bool, value: &dyn Fn(&Pins) -> Option<u64>| Signal {
        name,
        group: stream.to_owned(),
        values: pins.iter().map(value).collect(),
        is_level,
        begins: begins.clone(),
    };
    let word = |pins: &Pins, value: u64| pins.valid.then_some(value);
    vec![
        signal("tvalid".to_owned(), true, &|pins| {
            Some(u64::from(pins.valid))
        }),
        signal("tready".to_owned(), true, &|pins| {
            Some(u64::from(pins.ready))
        }),
        signal("tlast".to_owned(), true, &|pins| {
            word(pins, u64::from(pins.last))
        }),
        signal(chain.to_owned(), false, &|pins| word(pins, pins.chain)),
        signal(format!("tdata: {field}"), false, &|pins| {
            word(pins, pins.field)
        }),
    ]
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{CORES, find_machine};

    use super::*;

    #[test]
    fn every_word_moves_once_and_each_chain_answers_all_its_queries() {
        let (chains, machine) = CORES[0];
        let core = Core::new(find_machine(machine).unwrap(), chains).unwrap();
        let diagram = timing_of_core(&core).unwrap();
        let of = |stream: &str, name: &str| {
            let mut signals = diagram.signals.iter();
            let found = signals.find(|signal| signal.group == stream && signal.name == name);
            found.unwrap().values.clone()
        };
        let moves = |stream: &str| {
            let pairs = of(stream, "tvalid").into_iter().zip(of(stream, "tready"));
            pairs.filter(|pair| *pair == (Some(1), Some(1))).count()
        };
        let queries = CHAINS as usize * BATCHES * core.engines();
        assert_eq!(moves("s_axis_queries"), queries);
        assert_eq!(moves("m_axis_results"), queries);
        assert!(moves("s_axis_photons") >= CHAINS as usize);
        let chains = of("m_axis_results", "tid");
        for chain in 0..u64::from(CHAINS) {
            let answers = chains.iter().filter(|of| **of == Some(chain)).count();
            assert_eq!(answers, queries / CHAINS as usize, "chain {chain}");
        }
    }
}
