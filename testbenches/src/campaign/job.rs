//! The numbered jobs of a campaign that is shared out: each is a function of the seed and of its number alone.

use super::Pair;
use crate::device::DeviceKind;
use crate::stimulus::{Source, chunk_seed};
use crate::verify::{Verdict, VerifyError, VerifyOptions, verify};

/// The iterations in Verilator for one in the built-in evaluator, which takes about as long for machines of more than eight engines.
const EVALUATED: u64 = 100;

/// Job `number` of a campaign; the machines take turns.
#[derive(Copy, Clone, Debug)]
pub struct NumberedJob {
    /// The machine and the device.
    pub pair: Pair,
    /// The seed of the stimulus.
    pub seed: u64,
    /// The number of groups of photons.
    pub iterations: u64,
}

impl NumberedJob {
    /// The job of that number among the jobs of a seed. In Verilator it has `iterations` iterations, in the built-in evaluator a
    /// hundredth.
    ///
    /// # Panics
    /// There are no pairs.
    #[must_use]
    pub fn new(pairs: &[Pair], seed: u64, number: u64, iterations: u64) -> Self {
        let pair = pairs[(number % pairs.len() as u64) as usize];
        Self {
            pair,
            seed: chunk_seed(seed, number),
            iterations: match pair.1 {
                DeviceKind::Text => (iterations / EVALUATED).max(1),
                _ => iterations,
            },
        }
    }

    /// Verifies the machine.
    ///
    /// # Errors
    /// As those of [`verify`].
    pub fn run(&self) -> Result<Verdict, VerifyError> {
        let options = VerifyOptions {
            iterations: self.iterations,
            seed: self.seed,
            source: Source::Random,
        };
        verify(self.pair.0, self.pair.1, &options, &|_| ())
    }
}

#[cfg(test)]
mod tests {
    use super::super::pairs;
    use super::*;

    #[test]
    fn jobs_take_turns_and_have_seeds_of_their_own() {
        let pairs = pairs();
        let jobs = (0..2 * pairs.len() as u64).map(|n| NumberedJob::new(&pairs, 7, n, 1_000));
        let jobs: Vec<_> = jobs.collect();
        let (first, second) = jobs.split_at(pairs.len());
        for ((a, b), pair) in first.iter().zip(second).zip(&pairs) {
            assert_eq!((a.pair.0.name, b.pair.0.name), (pair.0.name, pair.0.name));
            let expected = if pair.1 == DeviceKind::Text {
                10
            } else {
                1_000
            };
            assert_eq!(a.iterations, expected);
        }
        let mut seeds: Vec<_> = jobs.iter().map(|job| job.seed).collect();
        seeds.sort_unstable();
        seeds.dedup();
        assert_eq!(seeds.len(), jobs.len());
    }
}
