//! Batches: queries that are tested against the photons of one stream.

use std::collections::HashMap;

use photoncube_spec::{Numbers, PhotonFormat};

use super::{Bounds, close_together};
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
    /// The lowest block of the region of [`Batches`] that the queries are in. A frame that begins a block below it on each axis holds all
    /// blocks that they gather from.
    pub region: [i64; 3],
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

/// The edge of a *region* in blocks. The queries of a batch are in one region. A frame holds a region and a block on each side of it,
/// since a query gathers photons of the blocks around its own.
pub(super) const REGION_BLOCKS: i64 = Numbers::FRAME_BLOCKS as i64 - 2;

/// What decides in which batch a query is.
struct Place {
    /// The middle of the query's cell, in half fine steps from the grid's origin.
    middle: [i64; 3],
    /// The lowest block of its region.
    region: [i64; 3],
    /// The query's facing; with [`Facings::Chain`] its set of facings.
    facing: usize,
}

impl Place {
    fn of(
        map: &QuantisedMap<'_>,
        format: &PhotonFormat,
        query: &QueryPoint,
        facing: usize,
    ) -> Self {
        let (block, fraction) = map.map().place(query.position);
        let block = block.to_array();
        let cell = map.query_at(fraction, 0).position;
        // A query is in the second block of its frame.
        let base = block.map(|block| (block - 1) << format.radius_bits());
        Self {
            middle: [0, 1, 2].map(|axis| 2 * (base[axis] + i64::from(cell[axis])) + 1),
            region: block.map(|block| block.div_euclid(REGION_BLOCKS) * REGION_BLOCKS),
            facing,
        }
    }
}

impl Batches {
    /// Puts the queries of one facing in a region into batches of queries that are close together; the last may be smaller than the
    /// others. Regions follow each other along a Morton curve through the scene.
    ///
    /// # Panics
    /// For batches without queries, or a map in plain numbers.
    pub fn new(map: &QuantisedMap<'_>, queries: &[QueryPoint], options: &BatchOptions) -> Self {
        assert!(options.queries > 0, "a batch has queries");
        let size = options.queries as usize;
        let format = map.numbers().format().expect("the map has a photon format");
        let mut facings = FacingSets::default();
        let mut place = |query: &QueryPoint| {
            let facing = match options.facings {
                Facings::Engine => Facing::of(query.normal).index(),
                Facings::Chain => facings.number(map.map(), &query.front()),
            };
            Place::of(map, format, query, facing)
        };
        let places: Vec<_> = queries.iter().map(&mut place).collect();
        let key = |query: u32| {
            let place = &places[query as usize];
            let along_curve = morton(place.region.map(|block| (block / REGION_BLOCKS) as u64));
            (along_curve, place.facing)
        };
        let mut order: Vec<_> = (0..queries.len() as u32).collect();
        order.sort_by_cached_key(|&query| key(query));
        let mut batches: Vec<Batch> = Vec::new();
        for equal in order.chunk_by_mut(|&query, &next| key(query) == key(next)) {
            close_together(equal, size, &|query| places[query as usize].middle);
            for chunk in equal.chunks(size) {
                let middles = chunk.iter().map(|&query| places[query as usize].middle);
                let start = batches.last().map_or(0, |batch| batch.queries.end);
                batches.push(Batch {
                    bounds: Bounds::around(middles).expect("a chunk is not empty"),
                    region: places[chunk[0] as usize].region,
                    queries: start..start + chunk.len(),
                    facings: match options.facings {
                        Facings::Engine => 0,
                        Facings::Chain => places[chunk[0] as usize].facing,
                    },
                });
            }
        }
        let order: Vec<_> = order.iter().map(|&query| query as usize).collect();
        Self {
            queries: order.iter().map(|&query| queries[query]).collect(),
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
