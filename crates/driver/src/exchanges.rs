//! Shares out the frames of a picture among cores.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use photoncube_spec::Core;

use crate::frames::{Frame, FramePlan};

/// Queries, about, that each chain is given at once. At their end the chains become empty one after the other, which costs a core some
/// thousand clocks.
const QUERIES_AT_ONCE: usize = 1 << 15;

/// The exchanges of a picture: in each, a core is given frames that follow one another, and answers. They do not depend on which core is
/// done first, so neither do the clocks.
pub(crate) struct Exchanges<'a> {
    frames: &'a [Frame],
    exchanges: Vec<Range<usize>>,
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
            exchanges: divided(&queries, QUERIES_AT_ONCE * core.chains as usize, cores),
            next: AtomicUsize::default(),
            done: AtomicUsize::default(),
        }
    }

    /// The frames of the next exchange; `None` behind the last.
    pub(crate) fn next(&self) -> Option<&'a [Frame]> {
        let next = self.next.fetch_add(1, Ordering::Relaxed);
        let exchange = self.exchanges.get(next)?;
        self.frames.get(exchange.clone())
    }

    /// Notes that so many frames more are done. Returns how many are.
    pub(crate) fn done(&self, frames: usize) -> usize {
        self.done.fetch_add(frames, Ordering::Relaxed) + frames
    }
}

/// Divides frames of these numbers of queries into parts of about as many queries each, `at_once` or fewer. One core has as few parts as
/// that allows. Several cores have an even number of parts, whatever their number, so that two simulators end together.
fn divided(queries: &[usize], at_once: usize, cores: usize) -> Vec<Range<usize>> {
    let all: usize = queries.iter().sum();
    let multiple = cores.min(2);
    let number = multiple * all.div_ceil(multiple * at_once);
    let mut parts = Vec::new();
    let (mut begins, mut before) = (0, 0);
    for (frame, queries) in queries.iter().enumerate() {
        before += queries;
        if before * number >= all * (parts.len() + 1) {
            parts.push(begins..frame + 1);
            begins = frame + 1;
        }
    }
    parts
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
            let parts = divided(&queries, at_once, cores);
            let in_parts: Vec<_> = parts.iter().cloned().flatten().collect();
            assert_eq!(in_parts, (0..frames).collect::<Vec<_>>());
            // A part is too large by a frame at most.
            let most = at_once + queries.iter().max().unwrap();
            let of_part = |part: &Range<usize>| queries[part.clone()].iter().sum::<usize>();
            assert!(parts.iter().all(|part| (1..=most).contains(&of_part(part))));
        }
        assert_eq!(divided(&[], 10, 2), []);
    }

    #[test]
    fn several_cores_have_the_same_even_number_of_parts() {
        let queries = [5; 40];
        assert_eq!(divided(&queries, 200, 1).len(), 1);
        assert_eq!(divided(&queries, 200, 2), [0..20, 20..40]);
        assert_eq!(divided(&queries, 99, 1).len(), 3);
        assert_eq!(divided(&queries, 99, 2).len(), 4);
        assert_eq!(divided(&queries, 99, 2), divided(&queries, 99, 16));
    }
}
