//! The frames of a picture, and the sets of photons and batches of queries of each.

use std::collections::HashMap;
use std::ops::Range;

use photoncube_render::{
    Batch, BatchOptions, Batches, Facings, QuantisedMap, QueryPoint, close_together,
};
use photoncube_spec::{Core, Leaf, Numbers, Photon, PhotonFormat, Query, QueryRounds, Spatial};

use crate::cut::Cutter;

/// Sets of facings that one set of photons serves: each photon's facing says which of these sets it is in.
const FACING_SETS: usize = Leaf::FACING_BITS as usize;

/// The queries of a picture that the machine's coordinates hold together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The frame's lowest block.
    origin: [i64; 3],
    /// Its batches, by their places in [`Batches::batches`].
    batches: Range<usize>,
}

/// A query of a set.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct SetQuery {
    /// The index of the query in the picture. A query whose photons need several sets is in each of them, and its sums are those
    /// of all its results.
    pub index: usize,
    /// The query in the coordinates of its frame.
    pub query: Query,
}

/// A batch of queries on a set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SetBatch {
    /// The queries; at most as many as a chain has engines.
    pub queries: Vec<SetQuery>,
    /// The facings that they gather, bit i for facing i.
    pub facings: u32,
}

/// A set of photons, and the batches that gather from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Set {
    /// The leaves; at most as many as a bank holds.
    pub leaves: Vec<PhotonLeaf>,
    /// The batches; the last releases the set.
    pub batches: Vec<SetBatch>,
}

/// The frames of a picture's queries, in the order in which a machine should be given them.
#[derive(Debug)]
pub struct FramePlan<'a> {
    map: &'a QuantisedMap<'a>,
    format: &'a PhotonFormat,
    cutter: Cutter,
    batches: Batches,
    /// The radius of each query of the picture, a word of the machine; empty where all have the map's.
    radii: Vec<u32>,
    /// The runs of the map, each with its photons, and their numbers in each block.
    runs: Vec<Range<usize>>,
    runs_of_block: HashMap<[i64; 3], Vec<usize>>,
    frames: Vec<Frame>,
}

impl<'a> FramePlan<'a> {
    /// Plans the queries of a picture for the chains of a core.
    ///
    /// # Panics
    /// Where the map has not the numbers of the core's machine.
    pub fn new(map: &'a QuantisedMap<'a>, core: &Core, queries: &[QueryPoint]) -> Self {
        assert_eq!(
            *map.numbers(),
            core.machine.numbers,
            "the map has the machine's numbers"
        );
        let format = map
            .numbers()
            .format()
            .expect("a leaf machine has a photon format");
        let options = BatchOptions {
            queries: core.engines() as u32,
            facings: Facings::Chain,
        };
        let mut plan = Self {
            map,
            format,
            cutter: Cutter::new(core),
            batches: Batches::new(map, queries, &options),
            radii: Vec::new(),
            runs: map.map().runs().collect(),
            runs_of_block: runs_by_block(map),
            frames: Vec::new(),
        };
        plan.frames = plan.list_frames();
        plan
    }

    /// This plan with a radius for each query of the picture: words of the machine, see [`Numbers::radius_word`].
    #[must_use]
    pub fn with_radii(self, radii: Vec<u32>) -> Self {
        Self { radii, ..self }
    }

    /// This plan for batches of these rounds.
    pub(crate) fn with_rounds(self, core: &Core, rounds: &QueryRounds) -> Self {
        // The k nearest are those of one set.
        let is_whole = matches!(rounds, QueryRounds::Nearest(_));
        Self {
            cutter: self.cutter.with_rounds(rounds.rounds(core), is_whole),
            ..self
        }
    }

    /// The frames.
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// Lists the frames. The queries of a batch are in one region, and each region is in a frame of its own.
    fn list_frames(&self) -> Vec<Frame> {
        let mut frames: Vec<Frame> = Vec::new();
        for (index, batch) in self.batches.batches.iter().enumerate() {
            // A query gathers from the blocks around its own.
            let origin = batch.region.map(|block| block - 1);
            match frames.last_mut().filter(|frame| frame.origin == origin) {
                Some(frame) => frame.batches.end = index + 1,
                None => frames.push(Frame {
                    origin,
                    batches: index..index + 1,
                }),
            }
        }
        frames
    }

    /// The number of queries of a frame.
    pub(crate) fn queries(&self, frame: &Frame) -> usize {
        let batches = &self.batches.batches[frame.batches.clone()];
        batches.iter().map(|batch| batch.queries.len()).sum()
    }

    /// The sets of a frame, each with its batches; none where no batch wants a photon.
    pub fn sets(&self, frame: &Frame) -> Vec<Set> {
        let mut all = Vec::new();
        let batches = &self.batches.batches[frame.batches.clone()];
        let mut facings: Vec<_> = batches.iter().map(|batch| batch.facings).collect();
        facings.sort_unstable();
        facings.dedup();
        for facings in facings.chunks(FACING_SETS) {
            let (leaves, batches) = (self.leaves(frame, facings), self.batches(frame, facings));
            all.extend(self.cutter.sets(&leaves, &batches));
        }
        all
    }

    /// The leaves of the photons that some of these sets of facings has. A photon's facing in the machine has a bit for each set
    /// that has it.
    fn leaves(&self, frame: &Frame, sets: &[usize]) -> Vec<PhotonLeaf> {
        let mut by_facing: Vec<Vec<Photon>> = vec![Vec::new(); Leaf::FACINGS as usize];
        for offset in offsets() {
            let block = [0, 1, 2].map(|axis| frame.origin[axis] + i64::from(offset[axis]));
            for &run in self.runs_of_block.get(&block).into_iter().flatten() {
                let group = self.map.map().group_of_run(run) as usize;
                let has = |(bit, set): (usize, &usize)| {
                    usize::from(self.batches.facing_sets[*set][group]) << bit
                };
                let facing: usize = sets.iter().enumerate().map(has).sum();
                if facing > 0 {
                    by_facing[facing].extend(self.photons(run, offset));
                }
            }
        }
        let facings = by_facing.iter_mut().enumerate();
        facings
            .flat_map(|(facing, photons)| in_leaves(facing, photons))
            .collect()
    }

    /// The photons of a run whose block has this offset in the frame.
    fn photons(&self, run: usize, offset: [u32; 3]) -> impl Iterator<Item = Photon> + '_ {
        let photons = self.runs[run].clone();
        photons.map(move |index| {
            let record = &self.map.records()[index];
            let place = |axis: usize| {
                (offset[axis] << self.format.position_bits) + u32::from(record.position[axis])
            };
            Photon {
                position: [0, 1, 2].map(place),
                power: record.mantissa.map(u32::from),
                exponent: self.map.exponent(index).into(),
            }
        })
    }

    /// The batches of a frame that gather some of these sets of facings.
    fn batches(&self, frame: &Frame, facings: &[usize]) -> Vec<SetBatch> {
        let position = |facing: &usize| facings.iter().position(|other| other == facing);
        let batches = self.batches.batches[frame.batches.clone()].iter();
        let batches = batches.filter_map(|batch| Some((batch, position(&batch.facings)?)));
        let query = |query: usize| SetQuery {
            index: self.batches.order[query],
            query: self.query(frame, query),
        };
        let batch = |(batch, set): (&Batch, usize)| SetBatch {
            queries: batch.queries.clone().map(query).collect(),
            facings: facings_with(set),
        };
        batches.map(batch).collect()
    }

    /// A query in the coordinates of its frame.
    fn query(&self, frame: &Frame, place: usize) -> Query {
        let query = &self.batches.queries[place];
        let bits = self.format.radius_bits();
        let (block, _) = self.map.map().place(query.position);
        // In the frame of its own, the query is in the block of offset 1.
        let own = self.map.query(query.position);
        let index = self.batches.order[place];
        let coordinate = |axis: usize| {
            let offset = (block[axis] - frame.origin[axis]) as u32;
            (offset << bits) + own.position[axis] - (1 << bits)
        };
        Query {
            position: [0, 1, 2].map(coordinate),
            radius_sq: self.radii.get(index).copied().unwrap_or(own.radius_sq),
        }
    }
}

/// A leaf: some photons of one facing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PhotonLeaf {
    /// The facing.
    pub facing: u32,
    /// The photons, 1 to [`Core::LEAF_PHOTONS`].
    pub photons: Vec<Photon>,
}

fn runs_by_block(map: &QuantisedMap<'_>) -> HashMap<[i64; 3], Vec<usize>> {
    let mut all: HashMap<_, Vec<_>> = HashMap::new();
    for (number, run) in map.map().runs().enumerate() {
        let first = map.map().photons()[run.start].position;
        let block = map.map().place(first).0;
        all.entry(block.to_array()).or_default().push(number);
    }
    all
}

/// The offsets of a frame's blocks.
fn offsets() -> impl Iterator<Item = [u32; 3]> {
    let blocks = Numbers::FRAME_BLOCKS;
    (0..blocks.pow(3)).map(move |index| {
        [
            index % blocks,
            index / blocks % blocks,
            index / blocks.pow(2),
        ]
    })
}

/// The facings of the machine whose bit `set` is set, as a word with a bit for each facing.
fn facings_with(set: usize) -> u32 {
    let facings = 0..Leaf::FACINGS;
    let has = facings.filter(|facing| facing >> set & 1 == 1);
    has.map(|facing| 1 << facing).sum()
}

/// Puts photons of one facing into leaves of photons that are close together, as are those of each of their groups.
fn in_leaves(facing: usize, photons: &[Photon]) -> Vec<PhotonLeaf> {
    let mut order: Vec<_> = (0..photons.len() as u32).collect();
    let place = |index: u32| photons[index as usize].position.map(i64::from);
    close_together(&mut order, Core::LEAF_PHOTONS, &place);
    let leaf = |chunk: &mut [u32]| {
        close_together(chunk, Spatial::LANES, &place);
        PhotonLeaf {
            facing: facing as u32,
            photons: chunk.iter().map(|&index| photons[index as usize]).collect(),
        }
    };
    order.chunks_mut(Core::LEAF_PHOTONS).map(leaf).collect()
}
