//! Random words for a core: sets of photons and batches of queries, right and wrong ones, with the results that they must give.

use std::collections::VecDeque;

use photoncube_model::gather;
use photoncube_spec::{
    BatchPins, Beat, Core, CoreRegister, CoreStreams, Leaf, Photon, Query, QueryRounds, QueryWord,
    Rounds, Sums, Widths,
};
use rand::{Rng, RngExt};

/// A result that a chain must give.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Expected {
    pub(crate) sums: Sums,
    pub(crate) tag: u32,
    /// The radius, where queries have one; none where the query is outside of its frame.
    pub(crate) radius_sq: Option<u32>,
    pub(crate) last: bool,
    pub(crate) outside: bool,
}

/// Words that wait to be offered, and the results that the chains still owe.
#[derive(Debug, Default)]
pub(crate) struct Plan {
    pub(crate) photons: VecDeque<Beat>,
    pub(crate) queries: VecDeque<Beat>,
    /// Of each chain, in the order of its queries.
    pub(crate) owed: Vec<VecDeque<Expected>>,
}

/// A batch, and the results that its chain must give for it.
struct BatchWords {
    words: Vec<Beat>,
    expected: Vec<Expected>,
}

/// One wrong word in so many.
const WRONG: u32 = 24;

/// Draws words for a core.
pub(crate) struct Draw<'a, R> {
    core: &'a Core,
    streams: &'a CoreStreams,
    widths: Widths,
    rounds: QueryRounds,
    rng: R,
}

impl<'a, R: Rng> Draw<'a, R> {
    pub(crate) fn new(core: &'a Core, streams: &'a CoreStreams, rng: R) -> Self {
        Self {
            core,
            streams,
            widths: Widths::of(core.machine),
            rounds: QueryRounds::Own,
            rng,
        }
    }

    pub(crate) fn rng(&mut self) -> &mut R {
        &mut self.rng
    }

    fn wrong(&mut self) -> bool {
        self.rng.random_range(0..WRONG) == 0
    }

    fn bits(&mut self, bits: u32) -> u32 {
        self.rng.random_range(0..1_u64 << bits) as u32
    }

    /// Draws other rounds for the batches from now on. Returns the words to write to registers.
    pub(crate) fn other_rounds(&mut self) -> Vec<(CoreRegister, u32)> {
        let rungs = self.rng.random_range(1..1 << Rounds::RUNGS_BITS);
        let radii: Vec<_> = (0..Rounds::RUNGS).map(|_| self.radius_sq()).collect();
        let k = self
            .rng
            .random_range(1..=self.core.machine.max_photons() as u32 / 2);
        let rung = |(rung, radius_sq): (u32, &u32)| (CoreRegister::Rung(rung), *radius_sq);
        let mut writes: Vec<_> = (0..).zip(&radii).map(rung).collect();
        let mode = self.rng.random_range(0..3);
        writes.push((CoreRegister::Nearest, if mode == 2 { k } else { 0 }));
        // With the k nearest, the rungs are not looked at.
        writes.push((CoreRegister::Rungs, if mode == 0 { 0 } else { rungs }));
        self.rounds = match mode {
            0 => QueryRounds::Own,
            1 => QueryRounds::Ladder(radii[..rungs.min(Rounds::RUNGS) as usize].to_vec()),
            _ => QueryRounds::Nearest(k),
        };
        writes
    }

    /// Appends the words of a set for every chain, and of its batches, which are mixed.
    pub(crate) fn round(&mut self, plan: &mut Plan) {
        plan.owed
            .resize_with(self.core.chains as usize, VecDeque::new);
        let mut batches: Vec<_> = (0..self.core.chains)
            .map(|chain| {
                let set = self.set(chain, plan);
                self.batches(chain, &set)
            })
            .collect();
        while batches.iter().any(|batches| !batches.is_empty()) {
            let chain = self.rng.random_range(0..batches.len());
            if let Some(batch) = batches[chain].pop_front() {
                plan.queries.extend(batch.words);
                plan.owed[chain].extend(batch.expected);
            }
            if self.wrong() {
                self.query_for_no_chain(plan);
            }
        }
    }

    /// A photon near a place.
    fn photon(&mut self, near: [u32; 3]) -> Photon {
        let most = (1 << self.widths.photon) - 1;
        let reach = 1 << (self.widths.photon - 2);
        let channels = self.core.machine.channels().names().len();
        let mut power = [0; 3];
        for power in &mut power[..channels] {
            *power = self.bits(self.widths.mantissa);
        }
        Photon {
            position: near.map(|place| {
                let step = self.rng.random_range(0..=2 * reach);
                (place + step).saturating_sub(reach).min(most)
            }),
            power,
            exponent: match self.core.machine.has_exponent() {
                true => self.bits(self.widths.exponent),
                false => 0,
            },
        }
    }

    /// Appends the leaves of a set, and returns the photons that the chain holds of them, with their facings.
    fn set(&mut self, chain: u32, plan: &mut Plan) -> Vec<(u32, Photon)> {
        let most = self.core.set_leaves();
        let too_many = if self.wrong() { 3 } else { 0 };
        let leaves = self.rng.random_range(1..=most) + if too_many > 0 { most } else { 0 };
        let leaves = leaves.min(most + too_many);
        let place = [(); 3].map(|()| self.bits(self.widths.photon));
        let mut held = Vec::new();
        for leaf in 0..leaves {
            let facing = self.bits(2);
            let is_last = leaf + 1 == leaves;
            let photons = match self.rng.random_range(0..4) {
                0 => self.rng.random_range(0..Core::LEAF_PHOTONS),
                _ => Core::LEAF_PHOTONS,
            };
            let photons: Vec<_> = (0..photons).map(|_| self.photon(place)).collect();
            if leaf < most {
                held.extend(photons.iter().map(|&photon| (facing, photon)));
            }
            let word = self.leaf(chain, &photons, facing, is_last);
            plan.photons.push_back(word);
            if self.wrong() {
                self.leaf_for_no_chain(plan);
            }
        }
        held
    }

    /// The word of a leaf. The bits of absent photons, and those without a field, are random.
    fn leaf(&mut self, chain: u32, photons: &[Photon], facing: u32, last: bool) -> Beat {
        let word = &self.streams.photons;
        let mut values = CoreStreams::leaf_values(self.core, photons, facing);
        let of_photon = (values.len() - 1) / Core::LEAF_PHOTONS;
        if self.wrong() && !photons.is_empty() && photons.len() < Core::LEAF_PHOTONS {
            // The last photon changes its place with the absent one behind it: a gap.
            let place = photons.len() - 1;
            let (first, second) = values.split_at_mut((place + 1) * of_photon);
            first[place * of_photon..].swap_with_slice(&mut second[..of_photon]);
        }
        for lane in values.chunks_exact_mut(of_photon) {
            if lane[0] == 0 {
                for (value, field) in lane.iter_mut().zip(&word.fields).skip(1) {
                    *value = self.rng.random::<u64>() & ((1 << field.width) - 1);
                }
            }
        }
        let mut data = word.bytes(&values);
        let first_free = word.end() as usize;
        for bit in first_free..word.bits as usize {
            data[bit / 8] |= u8::from(self.rng.random::<bool>()) << (bit % 8);
        }
        Beat {
            data,
            last,
            dest: chain,
        }
    }

    /// The batches of a set with their results. The last releases the set.
    fn batches(&mut self, chain: u32, set: &[(u32, Photon)]) -> VecDeque<BatchWords> {
        let batches = self.rng.random_range(1..=3);
        let batch = |batch| self.batch(chain, set, batch + 1 == batches);
        (0..batches).map(batch).collect()
    }

    fn batch(&mut self, chain: u32, set: &[(u32, Photon)], release: bool) -> BatchWords {
        let engines = self.core.engines() as u32;
        let queries = self.rng.random_range(1..=engines);
        let facings = self.rng.random::<u32>() | 1 << self.bits(2);
        let near = match set.first() {
            Some((_, photon)) => photon.position,
            None => [0; 3],
        };
        let (words, results): (Vec<_>, Vec<_>) = (0..queries)
            .map(|number| {
                // A batch of as many queries as engines ends without `tlast` too.
                let is_last = number + 1 == queries;
                let needs_last = queries < engines || self.rng.random();
                self.query(chain, set, near, facings, release, is_last && needs_last)
            })
            .unzip();
        let rounds = 0..results.first().map_or(0, Vec::len);
        let expected = rounds.flat_map(|round| results.iter().map(move |of| of[round].clone()));
        BatchWords {
            words,
            expected: expected.collect(),
        }
    }

    /// The field of a radius: the format's; where queries have radii, one of any length up to it or, at times, above it.
    fn radius_sq(&mut self) -> u32 {
        let largest = self.largest();
        match self.core.has_radii() {
            true if self.wrong() => self
                .rng
                .random_range(largest + 1..1 << self.widths.radius_sq),
            true => {
                let radius = self.rng.random_range(0..=largest.isqrt());
                self.rng.random_range(radius * radius..=largest)
            }
            false => largest,
        }
    }

    fn largest(&self) -> u32 {
        self.core.machine.numbers.largest_radius_word()
    }

    fn query(
        &mut self,
        chain: u32,
        set: &[(u32, Photon)],
        near: [u32; 3],
        facings: u32,
        release: bool,
        last: bool,
    ) -> (Beat, Vec<Expected>) {
        let shift = self.widths.coordinate - self.widths.photon;
        let tag = self.bits(Core::TAG_BITS);
        let query = Query {
            position: self.photon(near).position.map(|place| place << shift),
            radius_sq: self.radius_sq(),
        };
        let word = QueryWord {
            query,
            release,
            batch: BatchPins { last, facings, tag },
        };
        let mut data = self
            .streams
            .queries
            .bytes(&CoreStreams::query_values(self.core, &word));
        let outside = self.wrong();
        if outside {
            // The lowest bit above a coordinate.
            let axis = ["x", "y", "z"][self.rng.random_range(0..3)];
            let field = self.streams.queries.field(axis);
            let bit = (field.low + field.width) as usize;
            data[bit / 8] |= 1 << (bit % 8);
        }
        let gathered = set.iter().filter(|(facing, _)| facings >> facing & 1 == 1);
        let photons: Vec<_> = gathered.map(|(_, photon)| *photon).collect();
        let found = self.found(&query, &photons);
        let stream = Beat {
            data,
            last,
            dest: chain,
        };
        let expected = |(radius_sq, sums)| Expected {
            sums: if outside { Sums::default() } else { sums },
            tag,
            radius_sq: (self.core.has_radii() && !outside).then_some(radius_sq),
            last,
            outside,
        };
        (stream, found.into_iter().map(expected).collect())
    }

    /// The radius and the sums of each result of a query, by the direct gather.
    fn found(&self, query: &Query, photons: &[Photon]) -> Vec<(u32, Sums)> {
        let largest = self.largest();
        let sums = |radius_sq: u32| {
            let query = Query {
                radius_sq,
                ..*query
            };
            let sums = gather(self.core.machine, &query, photons.iter().copied());
            sums.expect("a set has no more photons than the sums hold")
        };
        let of_field = |field: u32| {
            let radius = field.min(largest);
            (radius, sums(radius))
        };
        match &self.rounds {
            QueryRounds::Own => vec![of_field(query.radius_sq)],
            QueryRounds::Ladder(radii) => radii.iter().copied().map(of_field).collect(),
            QueryRounds::Nearest(k) => {
                let radii: Vec<_> = (0..=largest).collect();
                let smallest = radii.partition_point(|&radius| sums(radius).count < u64::from(*k));
                let smallest = smallest as u32;
                vec![(smallest.min(largest), sums(smallest.saturating_sub(1)))]
            }
        }
    }

    /// A number of a chain that there is not, if the streams can name one.
    fn no_chain(&mut self) -> Option<u32> {
        let numbers = 1 << self.core.chain_bits();
        (self.core.chains < numbers).then(|| self.rng.random_range(self.core.chains..numbers))
    }

    fn leaf_for_no_chain(&mut self, plan: &mut Plan) {
        if let Some(chain) = self.no_chain() {
            let last = self.rng.random();
            let word = self.leaf(chain, &[], 0, last);
            plan.photons.push_back(word);
        }
    }

    fn query_for_no_chain(&mut self, plan: &mut Plan) {
        if let Some(dest) = self.no_chain() {
            let bytes = self.streams.queries.bits as usize / 8;
            plan.queries.push_back(Beat {
                data: (0..bytes).map(|_| self.rng.random()).collect(),
                last: self.rng.random(),
                dest,
            });
        }
    }

    /// The pins of a stream that offers no word: anything.
    pub(crate) fn idle(&mut self, bits: u32) -> Beat {
        Beat {
            data: (0..bits / 8).map(|_| self.rng.random()).collect(),
            last: self.rng.random(),
            dest: self.rng.random_range(0..1 << self.core.chain_bits()),
        }
    }
}

/// Facings are drawn among the first four, so that batches gather some and not others.
const _: () = assert!(Leaf::FACINGS >= 4);
