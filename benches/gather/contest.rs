//! The contestants of the benchmark: each sums the power in range of all queries, in parallel on the current
//! thread pool.

use glam::DVec3;
use photoncube_model::{Instructions, PhotonPlanes};
use photoncube_render::{QuantisedMap, QueryPoint};
use photoncube_spec::PhotonFormat;
use rayon::prelude::*;

use crate::data::Data;
use crate::found::Found;
use crate::tree::Tree;

#[cfg(target_arch = "x86_64")]
use {crate::grid::F32Grid, pulp::x86::V3};

/// The number of queries that a thread takes at a time, as in a tile of a picture.
const TILE: usize = 1024;

/// The number of tiles that all contestants gather for the comparison of their results, and that the slowest
/// is measured on.
pub const SOME: usize = 16;

/// A gather implementation.
pub trait Contestant {
    /// The contestant's name in the table.
    fn name(&self) -> &'static str;

    /// The number of bytes of its photons and its index.
    fn bytes(&self) -> usize;

    /// The sums over the queries of every `every`-th tile.
    fn gather(&self, every: usize) -> Found;

    /// The step of the tiles that are measured; a slow contestant need not gather all of them.
    fn every(&self) -> usize {
        1
    }
}

/// The contestants that this processor can run.
pub fn contestants<'a>(
    format: &PhotonFormat,
    data: &'a Data,
) -> Vec<Box<dyn Contestant + Sync + 'a>> {
    let mut all: Vec<Box<dyn Contestant + Sync + 'a>> = Vec::new();
    let names = |instructions: Instructions| match instructions.name() {
        "portable" => "fixed point, portable",
        "AVX2" => "fixed point, AVX2",
        _ => "fixed point",
    };
    for instructions in Instructions::available() {
        // The fastest instructions are those that a user gets.
        let name = if all.is_empty() {
            "fixed point"
        } else {
            names(instructions)
        };
        all.push(Box::new(FixedPoint::new(format, data, instructions, name)));
    }
    let positions: Vec<_> = data.queries.iter().map(|query| query.position).collect();
    #[cfg(target_arch = "x86_64")]
    match V3::try_new() {
        Some(simd) => all.push(Box::new(Grid {
            grid: F32Grid::new(&data.map),
            simd,
            queries: positions.clone(),
        })),
        None => println!("this processor has no AVX2: the f32 grid is left out"),
    }
    all.push(Box::new(KdTree {
        tree: Tree::new(&data.map),
        queries: positions,
    }));
    all
}

/// The sums of every `every`-th tile.
fn sum<Q: Sync>(
    queries: &[Q],
    every: usize,
    gather: impl Fn(&[Q]) -> Found + Sync + Send,
) -> Found {
    let tiles = queries.par_chunks(TILE).step_by(every).map(gather);
    tiles.reduce(Found::default, |mut all, tile| {
        all += tile;
        all
    })
}

struct FixedPoint<'a> {
    map: QuantisedMap<'a>,
    instructions: Instructions,
    name: &'static str,
    queries: &'a [QueryPoint],
}

impl<'a> FixedPoint<'a> {
    fn new(
        format: &PhotonFormat,
        data: &'a Data,
        instructions: Instructions,
        name: &'static str,
    ) -> Self {
        Self {
            map: QuantisedMap::new(&data.map, &format.into()).expect("a legal radius"),
            instructions,
            name,
            queries: &data.queries,
        }
    }
}

impl Contestant for FixedPoint<'_> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn bytes(&self) -> usize {
        self.map.planes().map_or(0, PhotonPlanes::bytes)
    }

    fn gather(&self, every: usize) -> Found {
        sum(self.queries, every, |tile| {
            let found = self
                .map
                .gather_all_by(self.instructions, tile, self.map.radius_sq());
            let mut all = Found::default();
            for query in found.expect("fewer photons than the format declares") {
                all += Found {
                    queries: 1,
                    power: self.map.flux(query.sums.power),
                    count: query.sums.count,
                    candidates: query.photons,
                    tests: query.tests,
                };
            }
            all
        })
    }
}

#[cfg(target_arch = "x86_64")]
struct Grid {
    grid: F32Grid,
    simd: V3,
    queries: Vec<DVec3>,
}

#[cfg(target_arch = "x86_64")]
impl Contestant for Grid {
    fn name(&self) -> &'static str {
        "f32 grid"
    }

    fn bytes(&self) -> usize {
        self.grid.bytes()
    }

    fn gather(&self, every: usize) -> Found {
        sum(&self.queries, every, |tile| {
            self.grid.gather_all(self.simd, tile)
        })
    }
}

struct KdTree {
    tree: Tree,
    queries: Vec<DVec3>,
}

impl Contestant for KdTree {
    fn name(&self) -> &'static str {
        "kiddo"
    }

    fn bytes(&self) -> usize {
        self.tree.bytes()
    }

    fn every(&self) -> usize {
        SOME
    }

    fn gather(&self, every: usize) -> Found {
        sum(&self.queries, every, |tile| self.tree.gather_all(tile))
    }
}
