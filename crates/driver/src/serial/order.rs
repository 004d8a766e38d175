//! The order of a core's words on a line that both of its streams share.

use photoncube_spec::{Beat, Core, CoreStreams, CoreWords, SerialKind};

/// The frames of words, each stream in its order: the leaves up to the end of a set stand before the first query on it.
///
/// A word that the core does not take holds back those behind it. A query here waits for no leaf behind it. A leaf that waits for a bank
/// waits for queries that are in front of the query for which it was sent, by the rule that the streams follow (see [`photoncube_spec::Core`]).
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
