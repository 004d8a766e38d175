//! The schedule of a chip with several chains of engines: which photons each chain is given for which queries.
//!
//! Photons are stored in *leaves*, a few photons of one facing that are close to each other, each with the box around
//! them. The queries of a picture are put into *batches*, one query for each engine of a chain. A batch is tested against
//! the leaves whose box is within the search radius of the box around its queries; the others are skipped unread, since
//! none of their photons can be in range. [`Leaves`] and [`Batches`] make both from a photon map in the integers of a
//! photon format, and [`cost`] counts the photon tests and the clocks.
//!
//! All boxes are in half fine steps of the format, in which the middles of photons' and queries' cells are whole numbers,
//! so every decision here is exact.

mod batches;
mod cost;
mod leaves;

pub use batches::{Batch, BatchOptions, Batches};
pub use cost::{Cost, cost};
pub use leaves::{Leaf, Leaves};

#[cfg(test)]
mod tests;

/// A box with its borders, in half fine steps from the grid's origin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bounds {
    /// The lowest corner.
    pub low: [i64; 3],
    /// The highest corner.
    pub high: [i64; 3],
}

impl Bounds {
    /// The box around one point.
    fn at(point: [i64; 3]) -> Self {
        Self {
            low: point,
            high: point,
        }
    }

    /// The box around this one and a point.
    fn with(self, point: [i64; 3]) -> Self {
        Self {
            low: [0, 1, 2].map(|axis| self.low[axis].min(point[axis])),
            high: [0, 1, 2].map(|axis| self.high[axis].max(point[axis])),
        }
    }

    /// The longest edge.
    fn longest(self) -> i64 {
        [0, 1, 2]
            .map(|axis| self.high[axis] - self.low[axis])
            .into_iter()
            .max()
            .unwrap_or(0)
    }

    /// Whether the gap between two boxes is at most `reach` on every axis. It is where a point of one is in range of a
    /// point of the other, since a distance is no shorter than its part on an axis.
    fn is_near(self, other: Self, reach: i64) -> bool {
        (0..3).all(|axis| {
            let gap = (self.low[axis] - other.high[axis]).max(other.low[axis] - self.high[axis]);
            gap <= reach
        })
    }
}
