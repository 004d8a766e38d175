//! The store of batches in front of a chain, by the rules of [`photoncube_spec::Rounds`].

use std::collections::VecDeque;

use photoncube_spec::{Outputs, QueryWord, Rounds, Sums};

use super::QueryIn;

/// The registers that say which rounds there are.
#[derive(Clone, Debug, Default)]
pub(super) struct Settings {
    pub(super) nearest: u32,
    pub(super) rungs: u32,
    pub(super) radii: [u32; Rounds::RUNGS as usize],
}

/// The rounds of a batch.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Kind {
    Nearest,
    Ladder(u32),
    Own,
}

/// A query of a batch, and what is known of it.
#[derive(Clone, Debug)]
struct Asked {
    query: QueryIn,
    /// The radius of the round under way, or of the last.
    radius: u32,
    /// In the search for the k nearest: every radius below has fewer than k photons.
    number: u32,
    /// The sums of the largest radius that had fewer than k.
    kept: Sums,
}

/// A batch that has all its queries.
#[derive(Clone, Debug)]
struct Batch {
    queries: Vec<Asked>,
    kind: Kind,
    releases: bool,
    /// Rounds that were given, and rounds whose results came back.
    given: u32,
    back: u32,
}

impl Batch {
    fn rounds(&self, rounds: Rounds) -> u32 {
        match self.kind {
            Kind::Nearest => rounds.nearest,
            Kind::Ladder(rungs) => rungs,
            Kind::Own => 1,
        }
    }

    fn is_under_way(&self) -> bool {
        self.given > self.back
    }

    fn is_ladder(&self) -> bool {
        matches!(self.kind, Kind::Ladder(_))
    }

    fn left(&self, rounds: Rounds) -> u32 {
        self.rounds(rounds) - self.given
    }
}

/// A result of the store.
#[derive(Clone, Debug)]
pub(super) struct Shown {
    pub(super) outputs: Outputs,
    pub(super) radius_sq: u32,
    pub(super) is_last: bool,
}

/// The store.
#[derive(Clone, Debug)]
pub(super) struct Store {
    rounds: Rounds,
    engines: usize,
    places: [Option<Batch>; Rounds::BATCHES],
    fill: usize,
    filling: Vec<QueryIn>,
    held: bool,
    turn: usize,
    position: usize,
    /// The places of the rounds under way, the oldest first.
    order: VecDeque<usize>,
    back: usize,
}

impl Store {
    pub(super) fn new(rounds: Rounds, engines: usize) -> Self {
        Self {
            rounds,
            engines,
            places: Default::default(),
            fill: 0,
            filling: Vec::new(),
            held: false,
            turn: 0,
            position: 0,
            order: VecDeque::new(),
            back: 0,
        }
    }

    /// A query is taken if it comes, unless there is a reset.
    pub(super) fn is_ready(&self) -> bool {
        self.places[self.fill].is_none() && !self.held
    }

    /// The batch in `turn`, if it goes.
    fn going(&self) -> Option<&Batch> {
        let batch = self.places[self.turn].as_ref()?;
        let left = batch.left(self.rounds);
        let before = (self.turn + Rounds::BATCHES - 1) % Rounds::BATCHES;
        // In an empty place were all rounds of a batch.
        let is_behind = |before: &Batch| batch.given < before.given;
        let is_behind = self.places[before].as_ref().is_none_or(is_behind);
        let follows = batch.kind == Kind::Nearest && left > 1 && is_behind;
        let is_free = batch.is_ladder() || !batch.is_under_way();
        let is_first = self.first() == Some(self.turn);
        (left > 0 && is_free && (is_first || follows)).then_some(batch)
    }

    /// The place of the oldest batch with a round left. `fill` is behind the youngest batch.
    fn first(&self) -> Option<usize> {
        let from_oldest = (0..Rounds::BATCHES).map(|place| (self.fill + place) % Rounds::BATCHES);
        let has_left = |place: &usize| {
            let batch = self.places[*place].as_ref();
            batch.is_some_and(|batch| batch.left(self.rounds) > 0)
        };
        from_oldest.into_iter().find(has_left)
    }

    /// The query that is offered to the chain.
    pub(super) fn offers(&self, settings: &Settings) -> Option<QueryIn> {
        let batch = self.going()?;
        let asked = &batch.queries[self.position];
        let mut query = asked.query;
        query.word = QueryWord {
            release: query.word.release && batch.left(self.rounds) == 1,
            ..query.word
        };
        query.word.query.radius_sq = self.radius(batch, asked, settings);
        Some(query)
    }

    fn radius(&self, batch: &Batch, asked: &Asked, settings: &Settings) -> u32 {
        match batch.kind {
            Kind::Own => self.at_most_largest(asked.query.word.query.radius_sq.into()),
            Kind::Ladder(_) => self.rung(settings, batch.given),
            Kind::Nearest => {
                let bit = 1_u64 << (batch.left(self.rounds) - 1);
                self.at_most_largest(u64::from(asked.number) + bit - 1)
            }
        }
    }

    /// The radius of that round of a ladder.
    fn rung(&self, settings: &Settings, round: u32) -> u32 {
        self.at_most_largest(settings.radii[round as usize].into())
    }

    fn at_most_largest(&self, radius: u64) -> u32 {
        radius.min(self.rounds.largest.into()) as u32
    }

    /// What the store makes of a chain's result: a result of its own, or none.
    pub(super) fn shows(&self, found: &Outputs, settings: &Settings) -> Option<Shown> {
        let batch = self.places[*self.order.front()?].as_ref()?;
        let asked = &batch.queries[self.back];
        let is_last = batch.back + 1 == batch.rounds(self.rounds);
        let mut outputs = *found;
        let radius_sq = match batch.kind {
            Kind::Nearest if !is_last => return None,
            Kind::Nearest => {
                let told = told(asked, &found.result, settings);
                if told.number > 0 {
                    outputs.result = told.kept;
                }
                self.at_most_largest(told.number.into())
            }
            Kind::Ladder(_) => self.rung(settings, batch.back),
            Kind::Own => asked.radius,
        };
        Some(Shown {
            outputs,
            radius_sq,
            is_last,
        })
    }

    /// A clock in which a query is taken, the chain's slice takes the query that is offered, and a chain's result leaves its place.
    pub(super) fn clock(
        &mut self,
        settings: &Settings,
        takes: Option<QueryIn>,
        gives: bool,
        comes: Option<&Outputs>,
        reset: bool,
    ) {
        if reset {
            *self = Self::new(self.rounds, self.engines);
            return;
        }
        // A round that is under way does not go, and a place that is filled is empty: each of these has another place.
        let goes = self.going().is_some();
        let offered = self.offers(settings).filter(|_| gives);
        if let Some(found) = comes {
            self.come(found, settings);
        }
        if let Some(query) = takes {
            self.take(query, settings);
        }
        let moves_on = offered.is_some_and(|query| self.give(&query));
        if moves_on || !goes {
            self.turn = (self.turn + 1) % Rounds::BATCHES;
        }
    }

    fn take(&mut self, query: QueryIn, settings: &Settings) {
        self.filling.push(query);
        if !query.word.batch.last && self.filling.len() < self.engines {
            return;
        }
        let queries = std::mem::take(&mut self.filling);
        let releases = queries.iter().any(|query| query.word.release);
        let asked = |query| Asked {
            query,
            radius: 0,
            number: 0,
            kept: Sums::default(),
        };
        self.places[self.fill] = Some(Batch {
            queries: queries.into_iter().map(asked).collect(),
            kind: match (settings.nearest, settings.rungs) {
                (0, 0) => Kind::Own,
                (0, rungs) => Kind::Ladder(rungs.min(Rounds::RUNGS)),
                _ => Kind::Nearest,
            },
            releases,
            given: 0,
            back: 0,
        });
        self.held = releases;
        self.fill = (self.fill + 1) % Rounds::BATCHES;
    }

    /// Gives a query of the batch in `turn`, and says whether `turn` then moves on.
    fn give(&mut self, query: &QueryIn) -> bool {
        let Some(batch) = self.places[self.turn].as_mut() else {
            return false;
        };
        batch.queries[self.position].radius = query.word.query.radius_sq;
        self.position += 1;
        if self.position < batch.queries.len() {
            return false;
        }
        self.position = 0;
        batch.given += 1;
        let is_last = batch.left(self.rounds) == 0;
        self.held &= !(batch.releases && is_last);
        self.order.push_back(self.turn);
        is_last || !batch.is_ladder()
    }

    /// A result of the oldest round comes back.
    fn come(&mut self, found: &Outputs, settings: &Settings) {
        let place = self.order.front().map(|&place| &mut self.places[place]);
        let Some(place) = place else {
            return;
        };
        let Some(batch) = place.as_mut() else {
            return;
        };
        let asked = &mut batch.queries[self.back];
        if batch.kind == Kind::Nearest {
            *asked = told(asked, &found.result, settings);
        }
        self.back += 1;
        if self.back == batch.queries.len() {
            self.back = 0;
            batch.back += 1;
            self.order.pop_front();
            if batch.back == batch.rounds(self.rounds) {
                *place = None;
            }
        }
    }
}

/// A query that was told the result of its radius.
fn told(asked: &Asked, found: &Sums, settings: &Settings) -> Asked {
    let mut asked = asked.clone();
    if found.count < settings.nearest.into() {
        asked.number = asked.radius + 1;
        asked.kept = *found;
    }
    asked
}
