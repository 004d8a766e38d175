//! The passes of a picture that one of several computers makes.

use thiserror::Error;

/// A part of the passes of a picture: every N-th, from one of the first N on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    first: u64,
    step: u64,
}

/// A part that does not exist.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("part: found {index} of {of}, expected 1 to {of}")]
pub struct NoPart {
    /// The number of the part.
    pub index: u64,
    /// The number of parts.
    pub of: u64,
}

impl Part {
    /// All passes.
    pub const ALL: Self = Self { first: 0, step: 1 };

    /// The part `index`, from 1, of `of` parts. It has the passes whose number, from 0, leaves the rest `index` - 1 when divided by `of`.
    ///
    /// # Errors
    /// There is no such part.
    pub fn new(index: u64, of: u64) -> Result<Self, NoPart> {
        match (1..=of).contains(&index) {
            true => Ok(Self {
                first: index - 1,
                step: of,
            }),
            false => Err(NoPart { index, of }),
        }
    }

    /// The number, from 0, of the pass after `made` passes of this part.
    pub(super) fn pass(self, made: u64) -> u64 {
        self.first + self.step * made
    }

    /// The number of passes, of all parts, up to the last of `made` passes of this part.
    pub(super) fn searched(self, made: u64) -> u64 {
        made.checked_sub(1).map_or(0, |last| self.pass(last) + 1)
    }

    /// How many of `all` passes this part has.
    #[must_use]
    pub fn passes_of(self, all: u64) -> u64 {
        all.saturating_sub(self.first).div_ceil(self.step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_have_each_pass_once() {
        for of in [1, 2, 7] {
            let parts = (1..=of).map(|index| Part::new(index, of).unwrap());
            let passes = parts.flat_map(|part| (0..part.passes_of(23)).map(move |n| part.pass(n)));
            let mut passes: Vec<_> = passes.collect();
            passes.sort_unstable();
            assert_eq!(passes, Vec::from_iter(0..23));
        }
        assert_eq!(Part::new(1, 1), Ok(Part::ALL));
        assert_eq!(Part::new(5, 7).unwrap().passes_of(3), 0);
    }

    #[test]
    fn a_part_that_does_not_exist_is_refused() {
        for (index, of) in [(0, 2), (3, 2), (1, 0)] {
            assert_eq!(Part::new(index, of), Err(NoPart { index, of }));
        }
    }
}
