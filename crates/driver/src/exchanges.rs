//! Shares out the frames of a picture among cores.

use std::sync::atomic::{AtomicUsize, Ordering};

use photoncube_spec::Core;

use crate::frames::{Frame, FramePlan};

/// Queries, about, that each chain is given at once. At their end the chains become empty one after the other, which costs a core some
/// thousand clocks.
const QUERIES_AT_ONCE: usize = 1 << 16;

/// The exchanges of a picture: in each, a core is given frames, and answers. They do not depend on which core is done first, so neither do
/// the clocks.
pub(crate) struct Exchanges<'a> {
    frames: &'a [Frame],
    /// The places of the frames of each.
    exchanges: Vec<Vec<usize>>,
    next: AtomicUsize,
    /// The number of frames that are done.
    done: AtomicUsize,
}

impl<'a> Exchanges<'a> {
    /// The exchanges for that many cores.
    pub(crate) fn new(plan: &'a FramePlan<'_>, core: &Core, cores: usize) -> Self {
        let frames = plan.frames();
        let queries: Vec<_> = frames.iter().map(|frame| plan.queries(frame)).collect();
        Self {
            frames,
            exchanges: dealt(&queries, QUERIES_AT_ONCE * core.chains as usize, cores),
            next: AtomicUsize::default(),
            done: AtomicUsize::default(),
        }
    }

    /// The frames of the next exchange; `None` behind the last.
    pub(crate) fn next(&self) -> Option<Vec<&'a Frame>> {
        let next = self.next.fetch_add(1, Ordering::Relaxed);
        let exchange = self.exchanges.get(next)?;
        Some(exchange.iter().map(|&frame| &self.frames[frame]).collect())
    }

    /// Notes that so many frames more are done. Returns how many are.
    pub(crate) fn done(&self, frames: usize) -> usize {
        self.done.fetch_add(frames, Ordering::Relaxed) + frames
    }
}

/// Deals frames of these numbers of queries out to parts of about as many queries each, about `at_once` or fewer. One core has as few parts as
/// that allows. Several cores have an even number of parts, whatever their number, so that two simulators end together.
///
/// Frames that follow one another are alike, and are dealt to different parts: in each part, some frames are of many queries a clock and
/// some of few.
fn dealt(queries: &[usize], at_once: usize, cores: usize) -> Vec<Vec<usize>> {
    let all: usize = queries.iter().sum();
    let multiple = cores.min(2);
    let number = multiple * all.div_ceil(multiple * at_once);
    let mut parts = vec![(0, Vec::new()); number];
    for (frame, queries) in queries.iter().enumerate() {
        let fewest = parts.iter_mut().min_by_key(|(queries, _)| *queries);
        if let Some((sum, frames)) = fewest {
            *sum += queries;
            frames.push(frame);
        }
    }
    let parts = parts.into_iter().map(|(_, frames)| frames);
    parts.filter(|frames| !frames.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;

    #[test]
    fn each_frame_is_in_one_part_and_the_parts_are_about_equal() {
        let mut rng = Pcg64::seed_from_u64(1);
        for _ in 0..1_000 {
            let frames = rng.random_range(1..200);
            let queries: Vec<_> = (0..frames).map(|_| rng.random_range(1..50)).collect();
            let (at_once, cores) = (rng.random_range(1..2_000), rng.random_range(1..5));
            let parts = dealt(&queries, at_once, cores);
            let mut in_parts = parts.concat();
            in_parts.sort_unstable();
            assert_eq!(in_parts, (0..frames).collect::<Vec<_>>());
            // A part is too large by a frame at most.
            let most = at_once + queries.iter().max().unwrap();
            let of_part = |part: &[usize]| part.iter().map(|&frame| queries[frame]).sum::<usize>();
            assert!(parts.iter().all(|part| (1..=most).contains(&of_part(part))));
        }
        assert_eq!(dealt(&[], 10, 2), Vec::<Vec<usize>>::new());
    }

    #[test]
    fn frames_that_follow_one_another_are_in_different_parts() {
        assert_eq!(dealt(&[5; 6], 10, 1), [[0, 3], [1, 4], [2, 5]]);
        assert_eq!(dealt(&[5, 1, 1, 5], 6, 2), [vec![0], vec![1, 2, 3]]);
    }

    #[test]
    fn several_cores_have_the_same_even_number_of_parts() {
        let queries = [5; 40];
        let parts = |at_once, cores| dealt(&queries, at_once, cores).len();
        assert_eq!([parts(200, 1), parts(200, 2)], [1, 2]);
        assert_eq!([parts(99, 1), parts(99, 2)], [3, 4]);
        assert_eq!(dealt(&queries, 99, 2), dealt(&queries, 99, 16));
    }
}
