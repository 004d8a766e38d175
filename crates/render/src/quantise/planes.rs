//! The photons of a map in planes, made in parallel straight from the photons, without their records.

use photoncube_model::PhotonPlanes;
use photoncube_spec::{FormatError, PhotonBlock, PhotonFormat, PhotonRecord};
use rayon::prelude::*;

use super::QuantisedMap;

/// The least photons of a part, which a thread makes.
const PART: usize = 1 << 12;

/// The parts that exist beside the planes at a time: at least two for each thread, and one for each so many photons of the map. There
/// are few, because their photons take memory twice until they are joined.
const PARTS_A_THREAD: usize = 2;
const PHOTONS_BESIDE_A_PART: usize = 1 << 16;

/// The runs of the map in one cube of blocks and of one group, by their indices. They are one run of the planes.
type CubedRun<'a> = &'a [u32];

impl QuantisedMap<'_> {
    /// The photons in planes.
    ///
    /// # Errors
    /// The format is not legal.
    pub(super) fn planes_of(&self, format: &PhotonFormat) -> Result<PhotonPlanes, FormatError> {
        let mut planes = PhotonPlanes::new(format)?;
        let none = planes.clone();
        let edge = u64::from(planes.cube_edge());
        let key = |run: &u32| self.cube_of_run(*run, edge);
        let mut order: Vec<_> = (0..self.map().runs().len() as u32).collect();
        // With the index as the last key the order is total, hence independent of the threads.
        order.par_sort_unstable_by_key(|run| (key(run), *run));
        let runs: Vec<_> = order.chunk_by(|a, b| key(a) == key(b)).collect();
        planes.reserve(self.map().photons().len());
        let part = |runs: &&[CubedRun<'_>]| {
            let mut part = none.clone();
            runs.iter()
                .for_each(|run| self.push_run(run, edge, &mut part));
            part
        };
        let at_least = PARTS_A_THREAD * rayon::current_num_threads();
        let at_once = at_least.max(self.map().photons().len() / PHOTONS_BESIDE_A_PART);
        for parts in self.parts(&runs).chunks(at_once) {
            let parts: Vec<_> = parts.par_iter().map(part).collect();
            planes = parts.iter().fold(planes, PhotonPlanes::joined);
        }
        planes.shrink_to_fit();
        Ok(planes)
    }

    /// The cube of blocks that a run is in, as z, y, x, by which the planes are sorted, and its group.
    fn cube_of_run(&self, run: u32, edge: u64) -> ([u64; 3], u32) {
        let (block, group) = self.map().block_of_run(run as usize);
        let [x, y, z] = block.map(|at| at / edge);
        ([z, y, x], group)
    }

    /// The runs in parts of about as many photons.
    fn parts<'a>(&self, runs: &'a [CubedRun<'a>]) -> Vec<&'a [CubedRun<'a>]> {
        let photons = |runs: &CubedRun<'_>| -> usize {
            let runs = runs.iter();
            runs.map(|run| self.map().photons_of_run(*run as usize).len())
                .sum()
        };
        let mut filled = 0;
        let parts = runs.chunk_by(|run, _| {
            filled += photons(run);
            let goes_on = filled < PART;
            filled = if goes_on { filled } else { 0 };
            goes_on
        });
        parts.collect()
    }

    fn push_run(&self, runs: CubedRun<'_>, edge: u64, planes: &mut PhotonPlanes) {
        let photons = |run: &u32| self.map().photons_of_run(*run as usize);
        let exponent = |run: &u32| self.block_exponent(photons(run).start);
        let record = |run| {
            let exponent = exponent(run);
            photons(run).map(move |photon| self.record(photon, exponent))
        };
        let records: Vec<PhotonRecord> = runs.iter().flat_map(record).collect();
        let mut rest = records.as_slice();
        let blocks = runs.iter().map(|run| {
            let (of_block, others) = rest.split_at(photons(run).len());
            rest = others;
            let (block, _) = self.map().block_of_run(*run as usize);
            PhotonBlock {
                offset: block.map(|at| (at % edge) as u32),
                exponent: exponent(run),
                photons: of_block,
            }
        });
        let blocks: Vec<_> = blocks.collect();
        let ([z, y, x], group) = self.cube_of_run(runs[0], edge);
        let stored = planes.push_run([x, y, z], group, &blocks);
        stored.expect("rounded to the format");
    }
}
