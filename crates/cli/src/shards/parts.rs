//! The shards whose results a file has.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use super::Shard;

/// The shards whose results a file has.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Parts {
    /// The number of shards of the work.
    pub of: u64,
    /// Those in the file, from 1.
    pub has: BTreeSet<u64>,
}

impl From<Shard> for Parts {
    fn from(shard: Shard) -> Self {
        Self {
            of: shard.of,
            has: [shard.index].into(),
        }
    }
}

impl Parts {
    /// The shards.
    pub fn shards(&self) -> impl Iterator<Item = Shard> {
        let of = self.of;
        self.has.iter().map(move |&index| Shard { index, of })
    }

    /// The number of those of `jobs` jobs that the shards have.
    pub fn jobs(&self, jobs: u64) -> u64 {
        self.shards().map(|shard| shard.number_of_jobs(jobs)).sum()
    }

    /// The shards that are not there.
    pub fn missing(&self) -> Vec<u64> {
        (1..=self.of)
            .filter(|index| !self.has.contains(index))
            .collect()
    }

    /// The one shard of work that is not shared out, where all are there.
    pub fn whole_if_complete(self) -> Self {
        match self.missing().is_empty() {
            true => Shard::WHOLE.into(),
            false => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_shards_are_the_whole() {
        let mut parts = Parts {
            of: 3,
            has: [1, 3].into(),
        };
        assert_eq!((parts.missing(), parts.jobs(10)), (vec![2], 7));
        assert_eq!(parts.clone().whole_if_complete(), parts);
        parts.has.insert(2);
        assert_eq!(parts.whole_if_complete(), Parts::from(Shard::WHOLE));
    }
}
