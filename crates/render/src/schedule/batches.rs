//! Batches: queries that are tested against the photons of one stream.

use std::collections::HashMap;

use photoncube_spec::PhotonFormat;

use super::Bounds;
use crate::geometry::morton;
use crate::photon_map::PhotonMap;
use crate::quantise::QuantisedMap;
use crate::trace::Facing;
use crate::view::{Front, QueryPoint};

/// How queries are put into batches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BatchOptions {
    /// The most queries of a batch: the engines of a chain.
    pub queries: u32,
    /// A batch ends where the next query would make its box longer than this many search radii. Its other engines then
    /// stay empty.
    pub longest: Option<f64>,
    /// Whether the queries of a batch must gather photons of equal facings.
    pub facings: Facings,
}

/// Where the rule is applied by which a query gathers only photons that face its way, see [`PhotonMap`].
///
/// [`PhotonMap`]: crate::PhotonMap
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Facings {
    /// In each engine: a leaf is read if some query of the batch gathers its facing, and the engines of the other queries
    /// leave it out.
    Engine,
    /// Before the chain: all queries of a batch gather equal facings, and engines know nothing of them.
    Chain,
}

impl Facings {
    /// Both places.
    pub const ALL: [Self; 2] = [Self::Engine, Self::Chain];

    /// The name of the place in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Engine => "engine",
            Self::Chain => "chain",
        }
    }
}

/// A batch.
#[derive(Debug, Clone, PartialEq)]
pub struct Batch {
    /// The box around the middles of the queries' cells.
    pub bounds: Bounds,
    /// The queries, by their indices in the order of [`Batches::queries`].
    pub queries: std::ops::Range<usize>,
    /// The set of facings that they gather, by its index in [`Batches::facing_sets`]; 0 with [`Facings::Engine`], where they may
    /// gather different ones.
    pub facings: usize,
}

/// The batches of all queries of a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Batches {
    /// The queries in the order in which they are given to chains.
    pub queries: Vec<QueryPoint>,
    /// For each of these, its index among the queries that were given.
    pub order: Vec<usize>,
    /// The batches, in the order of the queries.
    pub batches: Vec<Batch>,
    /// The most queries of a batch.
    pub size: u32,
    /// The sets of facings that queries gather: for each group of photons of one facing, whether it is gathered. Empty with
    /// [`Facings::Engine`].
    pub facing_sets: Vec<Vec<bool>>,
}

/// Bits of a place in its block that order queries: eighths of an edge.
const ORDER_BITS: u32 = 3;

impl Batches {
    /// Sorts the queries along a Morton curve through the scene, those of one facing in a region after each other, and puts
    /// them into batches.
    ///
    /// # Panics
    /// For batches without queries, or a map in plain numbers.
    pub fn new(map: &QuantisedMap<'_>, queries: &[QueryPoint], options: &BatchOptions) -> Self {
        assert!(options.queries > 0, "a batch has queries");
        let format = map.numbers().format().expect("the map has a photon format");
        let mut facings = FacingSets::default();
        let mut order: Vec<usize> = (0..queries.len()).collect();
        order.sort_by_cached_key(|index| {
            let query = &queries[*index];
            let place = place(map, format, query);
            let eighth =
                place.map(|steps| (steps >> (format.radius_bits() + 1 - ORDER_BITS)) as u64);
            let region = eighth.map(|eighth| eighth >> (ORDER_BITS + 1));
            let facing = match options.facings {
                Facings::Engine => Facing::of(query.normal).index(),
                Facings::Chain => facings.number(map.map(), &query.front()),
            };
            (morton(region), facing, morton(eighth))
        });
        let queries: Vec<_> = order.iter().map(|index| queries[*index]).collect();
        let radius = f64::from(2 * format.radius_steps());
        let longest = options.longest.map(|radii| (radii * radius) as i64);
        let mut batches: Vec<Batch> = Vec::new();
        for (index, query) in queries.iter().enumerate() {
            let place = place(map, format, query);
            let facing = match options.facings {
                Facings::Engine => 0,
                Facings::Chain => facings.number(map.map(), &query.front()),
            };
            let joined = batches.last_mut().filter(|batch| {
                let fits = |longest| batch.bounds.with(place).longest() <= longest;
                let has_room = batch.queries.len() < options.queries as usize;
                has_room && facing == batch.facings && longest.is_none_or(fits)
            });
            match joined {
                Some(batch) => {
                    batch.bounds = batch.bounds.with(place);
                    batch.queries.end = index + 1;
                }
                None => batches.push(Batch {
                    bounds: Bounds::at(place),
                    queries: index..index + 1,
                    facings: facing,
                }),
            }
        }
        Self {
            queries,
            order,
            batches,
            size: options.queries,
            facing_sets: facings.sets(),
        }
    }
}

/// Numbers for the sets of facings that queries gather, in the order in which they are met.
#[derive(Default)]
struct FacingSets {
    of_fronts: HashMap<([u64; 3], Option<u32>), usize>,
    sets: HashMap<Vec<bool>, usize>,
}

impl FacingSets {
    fn number(&mut self, map: &PhotonMap, front: &Front) -> usize {
        let Self { of_fronts, sets } = self;
        *of_fronts.entry(front.key()).or_insert_with(|| {
            let next = sets.len();
            *sets.entry(map.facings(front)).or_insert(next)
        })
    }

    /// The sets by their numbers.
    fn sets(self) -> Vec<Vec<bool>> {
        let mut sets = vec![Vec::new(); self.sets.len()];
        for (set, number) in self.sets {
            sets[number] = set;
        }
        sets
    }
}

/// The middle of a query's cell, in half fine steps from the grid's origin.
fn place(map: &QuantisedMap<'_>, format: &PhotonFormat, query: &QueryPoint) -> [i64; 3] {
    let (block, fraction) = map.map().place(query.position);
    let bits = format.radius_bits();
    let cell = map.query_at(fraction, 0).position;
    // A query is in the second block of its frame.
    let base = block.to_array().map(|block| (block - 1) << bits);
    [0, 1, 2].map(|axis| 2 * (base[axis] + i64::from(cell[axis])) + 1)
}
