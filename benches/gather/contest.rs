//! The contestants of the benchmark: each sums the power in range of all queries, in parallel on the current
//! thread pool.

use glam::DVec3;
use photoncube_model::{Instructions, PhotonPlanes};
use photoncube_render::{QuantisedMap, QueryPoint, StoredPhoton};
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
        all.push(Box::new(FixedPoint {
            map: QuantisedMap::new(&data.map, &format.into()).expect("a legal radius"),
            instructions,
            name,
            queries: &data.queries,
        }));
    }
    let peers = PEERS.iter();
    let (photons, radius) = (data.map.photons(), data.map.radius());
    all.extend(peers.filter_map(|peer| peer(photons, radius, &data.queries)));
    all
}

/// Makes a peer from photons in any order, for a search radius; `None` where this processor cannot run it.
pub type Peer = fn(&[StoredPhoton], f64, &[QueryPoint]) -> Option<Box<dyn Contestant + Sync>>;

/// What people use today.
pub const PEERS: &[Peer] = &[
    #[cfg(target_arch = "x86_64")]
    grid,
    tree,
];

#[cfg(target_arch = "x86_64")]
fn grid(
    photons: &[StoredPhoton],
    radius: f64,
    queries: &[QueryPoint],
) -> Option<Box<dyn Contestant + Sync>> {
    let Some(simd) = V3::try_new() else {
        println!("this processor has no AVX2: the f32 grid is left out");
        return None;
    };
    Some(Box::new(Grid {
        grid: F32Grid::new(photons, radius),
        simd,
        queries: positions(queries),
    }))
}

fn tree(
    photons: &[StoredPhoton],
    radius: f64,
    queries: &[QueryPoint],
) -> Option<Box<dyn Contestant + Sync>> {
    Some(Box::new(KdTree {
        tree: Tree::new(photons, radius),
        queries: positions(queries),
    }))
}

fn positions(queries: &[QueryPoint]) -> Vec<DVec3> {
    queries.iter().map(|query| query.position).collect()
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

/// The golden model's fast gather.
pub struct FixedPoint<'a> {
    pub map: QuantisedMap<'a>,
    pub instructions: Instructions,
    pub name: &'static str,
    pub queries: &'a [QueryPoint],
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
