//! Leaves: a few photons of one facing in groups, with the box around each group.

use std::ops::Range;

use photoncube_spec::{PhotonFormat, Spatial};
use rayon::prelude::*;

use super::{Bounds, close_together};
use crate::quantise::QuantisedMap;

/// Photons of a group, which a chain is given in a clock.
pub const GROUP: usize = Spatial::LANES;

/// A leaf.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Leaf {
    /// The box around the middles of the photons' cells, for each group.
    pub groups: Vec<Bounds>,
    /// The photons, as indices into [`QuantisedMap::records`], in groups of `GROUP`. A leaf of a run's last photons may have fewer than
    /// the others.
    pub photons: Vec<u32>,
}

impl Leaf {
    /// The photons of each group, with its box.
    pub fn groups(&self) -> impl Iterator<Item = (&Bounds, &[u32])> {
        self.groups.iter().zip(self.photons.chunks(GROUP))
    }
}

/// The leaves of a map, run by run.
#[derive(Debug, Clone, PartialEq)]
pub struct Leaves {
    /// The most photons of a leaf.
    size: u32,
    leaves: Vec<Leaf>,
    /// For each run of the map, its leaves.
    runs: Vec<Range<usize>>,
}

impl Leaves {
    /// Puts the photons of each run into leaves of `size`, each of photons that are close together, as are those of each of its groups.
    ///
    /// # Panics
    /// For leaves without photons, or a map in plain numbers, which has no cells.
    pub fn new(map: &QuantisedMap<'_>, size: u32) -> Self {
        assert!(size > 0, "a leaf has photons");
        let format = map.numbers().format().expect("the map has a photon format");
        let runs: Vec<_> = map.map().runs().collect();
        let of_runs: Vec<Vec<Leaf>> = runs
            .par_iter()
            .map(|run| of_run(map, format, run.clone(), size as usize))
            .collect();
        let mut start = 0;
        let runs = of_runs.iter().map(|leaves| {
            let first = start;
            start += leaves.len();
            first..start
        });
        Self {
            size,
            runs: runs.collect(),
            leaves: of_runs.concat(),
        }
    }

    /// The most photons of a leaf.
    pub fn size(&self) -> u32 {
        self.size
    }

    /// All leaves.
    pub fn all(&self) -> &[Leaf] {
        &self.leaves
    }

    /// The leaves of a run, by its index in the map.
    pub fn of_run(&self, run: usize) -> &[Leaf] {
        &self.leaves[self.runs[run].clone()]
    }
}

fn of_run(
    map: &QuantisedMap<'_>,
    format: &PhotonFormat,
    run: Range<usize>,
    size: usize,
) -> Vec<Leaf> {
    let block = run
        .clone()
        .next()
        .map(|first| map.map().place(map.map().photons()[first].position).0);
    let block = block.map_or([0; 3], |block| block.to_array());
    let position = |photon: u32| map.records()[photon as usize].position.map(i64::from);
    let mut photons: Vec<_> = (run.start as u32..run.end as u32).collect();
    close_together(&mut photons, size, &position);
    let middle = |photon: &u32| {
        let position = position(*photon);
        [0, 1, 2].map(|axis| {
            let cell = (block[axis] << format.position_bits) + position[axis];
            (2 * cell + 1) << format.query_extra_bits
        })
    };
    let bounds = |group: &[u32]| {
        let bounds = Bounds::around(group.iter().map(middle));
        bounds.expect("a chunk is not empty")
    };
    let leaf = |photons: &mut [u32]| {
        close_together(photons, GROUP, &position);
        Leaf {
            groups: photons.chunks(GROUP).map(bounds).collect(),
            photons: photons.to_vec(),
        }
    };
    photons.chunks_mut(size).map(leaf).collect()
}
