//! The paper's three units: `A+B`, `(A-B)^2`, and `if A>B, output 0`.

mod add;
mod gate;
mod square;
mod squarer;

pub(crate) use add::AddUnit;
pub(crate) use gate::GateUnit;
pub(crate) use square::SquareUnit;
