//! The schedule of a chip with several chains of engines: which photons each chain is given for which queries.
//!
//! Photons are stored in *leaves*, a few photons of one facing that are close to each other, in groups of four with a box around
//! each. The queries of a picture are put into *batches*, one query for each engine of a chain. A batch is tested against
//! the groups whose box is within the search radius of the box around its queries; the others are skipped unread, since
//! none of their photons can be in range. [`Leaves`] and [`Batches`] make both from a photon map in the integers of a
//! photon format, and [`cost`] counts the photon tests and the clocks.
//!
//! All boxes are in half fine steps of the format, in which the middles of photons' and queries' cells are whole numbers,
//! so every decision here is exact.

mod batches;
mod cost;
mod kd_split;
mod leaves;

pub use batches::{Batch, BatchOptions, Batches, Facings};
pub use cost::{Cost, cost};
pub use kd_split::close_together;
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
    /// The box around some points; `None` where there is none.
    pub fn around(points: impl IntoIterator<Item = [i64; 3]>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = Self::at(points.next()?);
        Some(points.fold(first, Self::with))
    }

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

    /// The gap between two boxes on each axis; 0 where they overlap.
    fn gaps(self, other: Self) -> [i64; 3] {
        [0, 1, 2].map(|axis| {
            let above = other.low[axis] - self.high[axis];
            above.max(self.low[axis] - other.high[axis]).max(0)
        })
    }
}

/// The comparison of a group's box with a batch's box. With either, no group is skipped that has a photon in range of a
/// query: the distance of two points is no shorter than that of boxes around them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cull {
    /// A group is read if the gap on every axis is at most the radius: comparisons alone.
    Axes,
    /// A group is read if the distance of the boxes is at most the radius: the squares of the gaps, their sum, and a
    /// comparison, as an engine does with a photon.
    Distance,
}

impl Cull {
    /// Both comparisons.
    pub const ALL: [Self; 2] = [Self::Axes, Self::Distance];

    /// The name of the comparison in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Axes => "axes",
            Self::Distance => "distance",
        }
    }

    /// Whether a group is read for a batch, by their boxes and the radius in half fine steps.
    pub fn reads(self, group: Bounds, batch: Bounds, radius: i64) -> bool {
        let gaps = group.gaps(batch);
        match self {
            Self::Axes => gaps.into_iter().all(|gap| gap <= radius),
            Self::Distance => gaps.map(|gap| gap * gap).into_iter().sum::<i64>() <= radius * radius,
        }
    }
}
