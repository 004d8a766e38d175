//! The paper's three units: `A+B`, `(A-B)^2`, and `if A>B, output 0`.

mod add;
mod gate;
mod square;
mod squarer;

use photoncube_spec::{Squarer, Unit};

use crate::pinned::Pinned;

pub(crate) use add::AddUnit;
pub(crate) use gate::GateUnit;
pub(crate) use square::SquareUnit;

/// Builds a unit on its own, with the widths of a cell; `None` for a port, which is no block.
pub(crate) fn build_unit<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
>(
    unit: Unit,
    squarer: Squarer,
) -> Option<Box<dyn Pinned>> {
    Some(match unit {
        Unit::Square => Box::new(SquareUnit::<C, H, M, Q>::new(squarer)),
        Unit::Gate => Box::new(GateUnit::<V, R, P>::default()),
        Unit::Add => Box::new(AddUnit::<S>::default()),
        Unit::Port | Unit::PhotonPort | Unit::PowerPort => return None,
    })
}
