//! The order of a core's words on a line that both of its streams share, and the words that are left when some were answered.

use photoncube_spec::{Beat, Core, CoreStreams, CoreWords, SerialKind};

/// The frames of words, each stream in its order: the leaves up to the end of a set stand before the first query on it.
///
/// A word that the core does not take holds back those behind it. A query here waits for no leaf behind it. A leaf that waits for a bank
/// waits for queries that are in front of the query for which it was sent, by the rule that the streams follow (see
/// [`photoncube_spec::Core`]).
pub(super) fn on_line<'a>(core: &Core, words: &'a CoreWords) -> Vec<(SerialKind, &'a Beat)> {
    let ends = set_ends(core, &words.photons);
    let mut sets = Sets::new(core);
    let mut all = Vec::with_capacity(words.photons.len() + words.queries.len());
    let mut leaves = words.photons.iter();
    let mut given = 0;
    let mut give = |to: usize, all: &mut Vec<_>| {
        let more = leaves.by_ref().take(to.saturating_sub(given));
        all.extend(more.map(|leaf| (SerialKind::Photons, leaf)));
        given = given.max(to);
    };
    for query in &words.queries {
        let set = sets.of(query);
        let of_chain = ends.get(query.dest as usize);
        if let Some(&end) = of_chain.and_then(|ends| ends.get(set)) {
            give(end, &mut all);
        }
        all.push((SerialKind::Query, query));
    }
    give(words.photons.len(), &mut all);
    all
}

/// For each chain, the number of leaves up to the end of each of its sets.
fn set_ends(core: &Core, leaves: &[Beat]) -> Vec<Vec<usize>> {
    let mut ends = vec![Vec::new(); core.chains as usize];
    for (place, leaf) in leaves.iter().enumerate().filter(|(_, leaf)| leaf.last) {
        if let Some(ends) = ends.get_mut(leaf.dest as usize) {
            ends.push(place + 1);
        }
    }
    ends
}

/// The set and the queries of its batch so far, of each chain.
struct Sets {
    streams: CoreStreams,
    engines: usize,
    chains: Vec<(usize, usize)>,
}

impl Sets {
    fn new(core: &Core) -> Self {
        Self {
            streams: CoreStreams::of(core),
            engines: core.leaf().chain.engines(),
            chains: vec![(0, 0); core.chains as usize],
        }
    }

    /// The set that a query, the next of its chain, gathers from.
    fn of(&mut self, query: &Beat) -> usize {
        let release = self.streams.queries.field("release").low as usize;
        let releases = query.data[release / 8] >> (release % 8) & 1 == 1;
        let Some((set, queries)) = self.chains.get_mut(query.dest as usize) else {
            return 0;
        };
        let of_query = *set;
        *queries += 1;
        if query.last || *queries == self.engines {
            *queries = 0;
            *set += usize::from(releases);
        }
        of_query
    }
}

/// The words that are left where each chain has answered so many queries: those of all sets with a query that is not answered. Also of
/// each chain how many results of them are known.
pub(super) fn left(core: &Core, words: &CoreWords, answered: &[usize]) -> (CoreWords, Vec<usize>) {
    let chains = core.chains as usize;
    let mut sets = Sets::new(core);
    let of_query: Vec<_> = words.queries.iter().map(|query| sets.of(query)).collect();
    // Of each chain, the queries up to the end of each set.
    let mut ends: Vec<Vec<usize>> = vec![Vec::new(); chains];
    for (query, &set) in words.queries.iter().zip(&of_query) {
        if let Some(ends) = ends.get_mut(query.dest as usize) {
            let before = ends.last().copied().unwrap_or(0);
            ends.resize(set + 1, before);
            ends[set] += 1;
        }
    }
    let done = |chain: usize| ends[chain].partition_point(|&end| end <= answered[chain]);
    let done: Vec<_> = (0..chains).map(done).collect();
    let is_left =
        |chain: u32, set: usize| done.get(chain as usize).is_some_and(|&done| set >= done);
    let mut set_of_leaf = vec![0; chains];
    let mut leaf_is_left = |leaf: &&Beat| {
        let Some(set) = set_of_leaf.get_mut(leaf.dest as usize) else {
            return false;
        };
        let of_leaf = *set;
        *set += usize::from(leaf.last);
        is_left(leaf.dest, of_leaf)
    };
    let photons = words
        .photons
        .iter()
        .filter(|leaf| leaf_is_left(leaf))
        .cloned()
        .collect();
    let queries = words.queries.iter().zip(&of_query);
    let queries = queries.filter(|(query, set)| is_left(query.dest, **set));
    let known = (0..chains).map(|chain| {
        let last_done = done[chain].checked_sub(1);
        answered[chain] - last_done.map_or(0, |set| ends[chain][set])
    });
    let left = CoreWords {
        photons,
        queries: queries.map(|(query, _)| query.clone()).collect(),
        rounds: words.rounds.clone(),
    };
    (left, known.collect())
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{BatchPins, Query, QueryWord, find_machine};

    use super::*;

    fn core() -> Core {
        Core::new(find_machine("leaf-5-local7-rgb6d-n64").unwrap(), 2).unwrap()
    }

    fn leaf(dest: u32, last: bool) -> Beat {
        Beat {
            data: Vec::new(),
            last,
            dest,
        }
    }

    fn query(core: &Core, dest: u32, tag: u32, release: bool) -> Beat {
        let word = QueryWord {
            query: Query {
                position: [0; 3],
                radius_sq: 0,
            },
            release,
            batch: BatchPins {
                last: true,
                facings: 0,
                tag,
            },
        };
        let words = CoreStreams::of(core).queries;
        Beat {
            data: words.bytes(&CoreStreams::query_values(core, &word)),
            last: true,
            dest,
        }
    }

    /// Two sets of chain 0 and one of chain 1; the first set of chain 0 has two batches.
    fn words(core: &Core) -> CoreWords {
        CoreWords {
            photons: vec![leaf(0, false), leaf(1, true), leaf(0, true), leaf(0, true)],
            queries: vec![
                query(core, 1, 0, true),
                query(core, 0, 1, false),
                query(core, 0, 2, true),
                query(core, 0, 3, true),
            ],
            ..CoreWords::default()
        }
    }

    #[test]
    fn the_leaves_of_a_set_are_in_front_of_its_queries() {
        let core = core();
        let words = words(&core);
        let order = on_line(&core, &words);
        let kinds: String = order
            .iter()
            .map(|(kind, _)| char::from(kind.code()))
            .collect();
        assert_eq!(kinds, "PPQPQQPQ");
    }

    #[test]
    fn sets_whose_queries_are_all_answered_are_not_left() {
        let core = core();
        let words = words(&core);
        let (all, known) = left(&core, &words, &[0, 0]);
        assert_eq!((&all, known), (&words, vec![0, 0]));
        // A query of the first set of chain 0 is answered, the other is not: all of the set is left.
        let (some, known) = left(&core, &words, &[1, 1]);
        assert_eq!(known, [1, 0]);
        assert_eq!(some.queries, words.queries[1..]);
        assert_eq!(
            some.photons,
            [0, 2, 3].map(|leaf| words.photons[leaf].clone())
        );
        let (last, known) = left(&core, &words, &[2, 1]);
        assert_eq!(known, [0, 0]);
        assert_eq!(last.queries, words.queries[3..]);
        assert_eq!(last.photons, words.photons[3..]);
        let (none, _) = left(&core, &words, &[3, 1]);
        assert_eq!(none, CoreWords::default());
    }
}
