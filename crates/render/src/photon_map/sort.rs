//! Sorts photons by block and group, in place and in parallel.
//!
//! A second copy of the photons, or a sort key for each, would take more memory than all else that a map is built from. So
//! the photons are first exchanged into buckets, each of a few thousand photons and all before the next one's. Then each bucket is
//! sorted by keys and a copy of its own photons, in a thread's turn. Beside a photon, its group, its index and its bucket take 10 bytes.

use glam::DVec3;
use rayon::prelude::*;

use super::{Run, StoredPhoton};

/// The mean number of photons in a bucket, which fit a processor's cache.
const BUCKET: usize = 2048;

/// The most buckets. A photon finds its bucket in a table of as many keys.
const MOST_BUCKETS: usize = 1024;

/// The photons whose keys are compared for each border of buckets. The largest buckets have about twice the photons of the mean then.
const SAMPLES: usize = 8;

/// The place of a photon in the order. With the index as the last key no two are equal, so the order does not depend on the threads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    block: u64,
    group: u32,
    /// The photon's block in the grid whose order decides inside a run.
    before: u64,
    index: u32,
}

impl Key {
    fn is_in_run_of(&self, other: &Self) -> bool {
        (self.block, self.group) == (other.block, other.group)
    }
}

/// The photons of a map, not in its order yet.
pub(super) struct Unsorted {
    pub photons: Vec<StoredPhoton>,
    /// The group of each photon.
    pub groups: Vec<u32>,
}

impl Unsorted {
    /// Sorts the photons by block, group, the block before and their index here, and finds the runs. `blocks` gives both blocks at a
    /// position.
    pub fn sorted(
        self,
        blocks: impl Fn(DVec3) -> [u64; 2] + Sync,
    ) -> (Vec<StoredPhoton>, Vec<Run>) {
        let Self {
            mut photons,
            mut groups,
        } = self;
        let mut indices: Vec<u32> = (0..photons.len() as u32).collect();
        let key = |photon: &StoredPhoton, group: u32, index: u32| {
            let [block, before] = blocks(photon.position);
            Key {
                block,
                group,
                before,
                index,
            }
        };
        let key_of = |index: usize| key(&photons[index], groups[index], index as u32);
        let borders = borders(photons.len(), key_of);
        let place = |key: Key| borders.partition_point(|border| *border <= key) as u16;
        let places = (0..photons.len()).into_par_iter();
        let places = places.map(|index| place(key_of(index))).collect();
        let mut all = Table {
            photons: &mut photons,
            groups: &mut groups,
            indices: &mut indices,
        };
        let lengths = all.exchange(places, borders.len() + 1);
        let buckets = all.into_buckets(&lengths);
        let runs: Vec<_> = buckets
            .into_par_iter()
            .map(|bucket| bucket.sort(key))
            .collect();
        drop((groups, indices));
        (photons, joined(runs))
    }
}

/// The first keys of all buckets but the first: keys of some photons, evenly far apart in the order.
fn borders(photons: usize, key_of: impl Fn(usize) -> Key + Sync) -> Vec<Key> {
    let buckets = (photons / BUCKET).clamp(1, MOST_BUCKETS);
    let samples = buckets * SAMPLES;
    let sample = |sample: usize| key_of((sample as u64 * photons as u64 / samples as u64) as usize);
    match buckets {
        1 => Vec::new(),
        _ => {
            let mut keys: Vec<_> = (0..samples).into_par_iter().map(sample).collect();
            keys.par_sort_unstable();
            keys.into_iter().step_by(SAMPLES).skip(1).collect()
        }
    }
}

/// Photons with what their order needs.
struct Table<'a> {
    photons: &'a mut [StoredPhoton],
    groups: &'a mut [u32],
    indices: &'a mut [u32],
}

impl<'a> Table<'a> {
    /// Exchanges photons until each is in its bucket, whose number is in `places`, and returns the buckets' lengths.
    fn exchange(&mut self, mut places: Vec<u16>, buckets: usize) -> Vec<usize> {
        let mut lengths = vec![0; buckets];
        places
            .iter()
            .for_each(|place| lengths[usize::from(*place)] += 1);
        let mut end = 0;
        let ends: Vec<usize> = lengths
            .iter()
            .map(|length| {
                end += length;
                end
            })
            .collect();
        // The first photon of each bucket that may not belong to it.
        let mut next: Vec<_> = ends.iter().zip(&lengths).map(|(end, n)| end - n).collect();
        for bucket in 0..buckets {
            while next[bucket] < ends[bucket] {
                let at = next[bucket];
                let place = usize::from(places[at]);
                let to = next[place];
                next[place] += 1;
                if place != bucket {
                    places.swap(at, to);
                    self.swap(at, to);
                }
            }
        }
        lengths
    }

    fn swap(&mut self, a: usize, b: usize) {
        self.photons.swap(a, b);
        self.groups.swap(a, b);
        self.indices.swap(a, b);
    }

    fn into_buckets(self, lengths: &[usize]) -> Vec<Bucket<'a>> {
        let (mut start, mut rest) = (0, self);
        let bucket = |length: &usize| {
            let (photons, others) = std::mem::take(&mut rest.photons).split_at_mut(*length);
            rest.photons = others;
            let (groups, others) = std::mem::take(&mut rest.groups).split_at_mut(*length);
            rest.groups = others;
            let (indices, others) = std::mem::take(&mut rest.indices).split_at_mut(*length);
            rest.indices = others;
            let table = Table {
                photons,
                groups,
                indices,
            };
            start += length;
            Bucket {
                start: start - length,
                table,
            }
        };
        lengths.iter().map(bucket).collect()
    }
}

/// Photons that are neighbours in the order, from `start` on.
struct Bucket<'a> {
    start: usize,
    table: Table<'a>,
}

impl Bucket<'_> {
    /// Sorts the photons and returns their runs.
    fn sort(self, key: impl Fn(&StoredPhoton, u32, u32) -> Key) -> Vec<Run> {
        let Table {
            photons,
            groups,
            indices,
        } = self.table;
        let rows = photons.iter().zip(groups).zip(indices);
        let mut order: Vec<_> = rows
            .zip(0_u32..)
            .map(|(((photon, group), index), place)| (key(photon, *group, *index), place))
            .collect();
        order.sort_unstable();
        let sorted: Vec<_> = order
            .iter()
            .map(|(_, place)| photons[*place as usize])
            .collect();
        photons.copy_from_slice(&sorted);
        let mut start = self.start as u32;
        let run = |run: &[(Key, u32)]| {
            let end = start + run.len() as u32;
            let photons = std::mem::replace(&mut start, end)..end;
            let Key { block, group, .. } = run[0].0;
            Run {
                block,
                group,
                photons,
            }
        };
        let runs = order.chunk_by(|(a, _), (b, _)| a.is_in_run_of(b)).map(run);
        runs.collect()
    }
}

/// The runs of all buckets. A run may end in one bucket and go on in the next.
fn joined(buckets: Vec<Vec<Run>>) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::with_capacity(buckets.iter().map(Vec::len).sum());
    for run in buckets.into_iter().flatten() {
        match runs.last_mut() {
            Some(last) if (last.block, last.group) == (run.block, run.group) => {
                last.photons.end = run.photons.end;
            }
            _ => runs.push(run),
        }
    }
    runs
}
