//! Timing diagrams of a machine's ports, with the values of the golden model.

use anyhow::{Context, Result};
use photoncube_spec::{Machine, Photon, Query};

use super::wave::{Diagram, Signal};
use crate::project::Set;
use crate::rows::Rows;

/// A stream: its name, its valid and ready ports, and the ports of its words that are shown where the machine has them.
type Stream = (&'static str, [&'static str; 2], &'static [&'static str]);

const STREAMS: [Stream; 3] = [
    (
        "query",
        ["query_valid", "query_ready"],
        &["query_x", "query_last", "query_release"],
    ),
    (
        "group",
        ["group_valid", "group_ready"],
        &["group_last", "photon_x_0"],
    ),
    (
        "result",
        ["result_valid", "result_ready"],
        &["result_count"],
    ),
];

/// The batches that are shown.
const BATCHES: usize = 2;
/// The groups of a batch: in a machine with a program, in which each takes several clocks, and in others.
const GROUPS: [usize; 2] = [2, 3];
/// The clocks that are shown before the first word is offered, and behind the last result.
const AROUND: usize = 1;

/// Two batches through a machine, one after the other and without waiting.
///
/// # Errors
/// The golden model refuses the machine's example.
pub fn timing(machine: &Machine) -> Result<Diagram> {
    let rows = Rows::of(machine, &workload(machine)?)?;
    let pin = |name: &str| {
        rows.pin(name)
            .with_context(|| format!("{} has no pin {name}", machine.name))
    };
    let shown = shown(&pin("reset")?, &pin("query_valid")?, &pin("result_valid")?)?;
    let mut signals = Vec::new();
    for (stream, [valid, ready], words) in STREAMS {
        let [valids, readies] = [pin(valid)?, pin(ready)?];
        let begins: Vec<_> = shown
            .clone()
            .map(|clock| valids[clock - 1] == 1 && readies[clock - 1] == 1)
            .collect();
        for (name, values) in [(valid, &valids), (ready, &readies)] {
            let values = shown.clone().map(|clock| Some(values[clock]));
            signals.push(signal(stream, name, values.collect(), true, &begins));
        }
        for &name in words {
            let Some(values) = rows.pin(name) else {
                continue;
            };
            let values = shown
                .clone()
                .map(|clock| (valids[clock] == 1).then(|| values[clock]));
            let is_level = ["last", "release"].iter().any(|end| name.ends_with(end));
            signals.push(signal(stream, name, values.collect(), is_level, &begins));
        }
    }
    let queries = match machine.queries_at_once() {
        1 => "queries, each".to_owned(),
        queries => format!("batches of {queries} queries, each"),
    };
    Ok(Diagram {
        title: format!(
            "{}: {BATCHES} {queries} on {} groups",
            machine.name,
            groups(machine)
        ),
        clocks: shown.len(),
        signals,
    })
}

fn signal(
    group: &str,
    name: &str,
    values: Vec<Option<u64>>,
    is_level: bool,
    begins: &[bool],
) -> Signal {
    Signal {
        name: name.to_owned(),
        group: group.to_owned(),
        values,
        is_level,
        begins: begins.to_vec(),
    }
}

fn groups(machine: &Machine) -> usize {
    GROUPS[usize::from(machine.spatial().is_some())]
}

/// The queries of the batches, on the photons of an example.
fn workload(machine: &Machine) -> Result<Vec<(Query, Vec<Photon>)>> {
    let at_once = machine.queries_at_once();
    let set = Set::new(machine, 0, &[at_once; BATCHES])?;
    let lanes = machine.photons_per_iteration();
    let photons: Vec<_> = set
        .photons
        .into_iter()
        .take(lanes * groups(machine))
        .collect();
    let queries = set.batches.into_iter().flatten();
    Ok(queries.map(|(query, _)| (query, photons.clone())).collect())
}

/// The clocks to show: from the first query behind the last reset to the last result.
fn shown(reset: &[u64], queries: &[u64], results: &[u64]) -> Result<std::ops::Range<usize>> {
    let is_set = |value: &u64| *value == 1;
    let ready = reset.iter().rposition(is_set).map_or(0, |clock| clock + 1);
    let first = queries[ready..].iter().position(is_set);
    let first = ready + first.context("the golden model was given no query")?;
    let last = results.iter().rposition(is_set);
    let last = last.filter(|last| *last > first);
    let last = last.context("the golden model gave no result")?;
    Ok(first.saturating_sub(AROUND).max(ready).max(1)..(last + 1 + AROUND).min(results.len()))
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Spatial, find_machine};

    use super::*;

    /// The clocks of a diagram in which all of these signals are 1.
    fn clocks(diagram: &Diagram, names: &[&str]) -> Vec<usize> {
        let find = |name: &&str| diagram.signals.iter().find(|signal| signal.name == **name);
        let signals: Vec<_> = names.iter().map(|name| find(name).unwrap()).collect();
        let all = |clock: &usize| {
            signals
                .iter()
                .all(|signal| signal.values[*clock] == Some(1))
        };
        (0..diagram.clocks).filter(all).collect()
    }

    #[test]
    fn the_first_result_of_a_chain_comes_after_its_latency() {
        for name in ["stream", "tile-5", "tile-6"] {
            let machine = find_machine(name).unwrap();
            let diagram = timing(machine).unwrap();
            let last = clocks(&diagram, &["group_valid", "group_ready", "group_last"]);
            let results = clocks(&diagram, &["result_valid", "result_ready"]);
            assert_eq!(last.len(), BATCHES, "{name}");
            assert_eq!(results.len(), BATCHES * machine.queries_at_once());
            let latency = machine.spatial().unwrap().latency_clocks() as usize;
            assert_eq!(results[0] - last[0], latency, "{name}");
            let of_batch = &results[..machine.queries_at_once()];
            for pair in of_batch.windows(2) {
                assert_eq!((pair[1] - pair[0]) as u32, Spatial::RESULT_CLOCKS, "{name}");
            }
        }
    }

    #[test]
    fn the_results_of_a_program_are_its_clocks_apart() {
        for name in ["paper", "paper-5d"] {
            let machine = find_machine(name).unwrap();
            let diagram = timing(machine).unwrap();
            let results = clocks(&diagram, &["result_valid", "result_ready"]);
            let apart = machine
                .microprogram()
                .unwrap()
                .occupied_clocks(groups(machine) as u64);
            assert_eq!((results[1] - results[0]) as u64, apart, "{name}");
        }
    }

    #[test]
    fn a_machine_with_a_memory_is_given_its_groups_once() {
        let machine = find_machine("tile-6-mixed").unwrap();
        let diagram = timing(machine).unwrap();
        assert_eq!(
            clocks(&diagram, &["group_valid", "group_ready"]).len(),
            groups(machine)
        );
        let queries = clocks(&diagram, &["query_valid", "query_ready"]);
        assert_eq!(queries.len(), BATCHES * machine.queries_at_once());
    }
}
