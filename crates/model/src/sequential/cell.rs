//! The cell of a sequential machine: its registers and the effect of an op on them.
//!
//! Distances never wrap: the work register is wide enough for the sum of three squares.

use photoncube_spec::{Machine, Numbers, Op, Widths};

/// The registers of one cell.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct CellState {
    /// `q`: the query point's coordinate.
    pub query: u32,
    /// `r`: the squared search radius.
    pub radius_sq: u32,
    /// `p`: the photon's coordinate.
    pub photon: u32,
    /// `w`: the photon's power in the cell's channel.
    pub power: u64,
    /// `v`: a square, then a distance, then a gated power.
    pub work: u64,
    /// `s`: the sum of the query.
    pub sum: u64,
}

/// The values at a cell's ports in one clock. They must fit the machine's widths.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct CellInputs {
    /// The query's coordinate of the cell's role.
    pub query: u32,
    /// The query's squared search radius.
    pub radius_sq: u32,
    /// The photon's coordinate of the cell's role.
    pub photon: u32,
    /// Whether the lane holds a photon.
    pub present: bool,
    /// The photon's decoded power in the cell's channel.
    pub power: u64,
    /// The work register of the neighbour on the selected axis; 0 if none is selected.
    pub link: u64,
}

/// The arithmetic rules of a machine's cells.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct CellRules {
    widths: Widths,
    square: SquareRule,
}

/// The function that a cell computes as the square; see [`photoncube_spec::PhotonFormat`], "Distance".
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum SquareRule {
    /// The square of the plain difference.
    Plain,
    /// The square of |A-B|, clamped to `largest`.
    Clamped { largest: u32 },
    /// The half square, where a photon is on the fine grid line `(index << shift) + middle`.
    HalfSteps {
        largest: u32,
        shift: u32,
        middle: u32,
    },
}

impl CellRules {
    /// The rules of a machine's cells.
    pub fn of(machine: &Machine) -> Self {
        let widths = Widths::of(machine);
        let largest = u32::MAX >> (u32::BITS - widths.difference);
        let square = match &machine.numbers {
            Numbers::Plain(_) => SquareRule::Plain,
            Numbers::Local(format) if format.half_steps() => SquareRule::HalfSteps {
                largest,
                shift: format.query_extra_bits,
                middle: 1 << (format.query_extra_bits - 1),
            },
            Numbers::Local(_) => SquareRule::Clamped { largest },
        };
        Self { widths, square }
    }

    /// The query coordinate of a distance cell: the index just below the grid line of photon 0, so that its
    /// square is 0.
    pub(crate) fn idle_query(&self) -> u32 {
        match self.square {
            SquareRule::Plain | SquareRule::Clamped { .. } => 0,
            SquareRule::HalfSteps { middle, .. } => middle - 1,
        }
    }

    /// The widths of the cell's registers.
    pub fn widths(&self) -> &Widths {
        &self.widths
    }
}

impl SquareRule {
    fn apply(self, query: u32, photon: u32) -> u64 {
        match self {
            Self::Plain => u64::from(query.abs_diff(photon)).pow(2),
            Self::Clamped { largest } => u64::from(query.abs_diff(photon).min(largest)).pow(2),
            Self::HalfSteps {
                largest,
                shift,
                middle,
            } => {
                let line = (photon << shift) + middle;
                // A query is half a step above its index. Below the line, that half step is dropped.
                let steps = match query.checked_sub(line) {
                    Some(steps) => steps,
                    None => line - query - 1,
                };
                let m = u64::from(steps.min(largest));
                m * (m + 1)
            }
        }
    }
}

impl CellState {
    /// Does one op, by the rows of [`photoncube_spec::OPS`], in plain integers.
    pub fn execute(&mut self, op: Op, inputs: &CellInputs, rules: &CellRules) {
        match op {
            Op::Nop => {}
            Op::LoadQuery => {
                self.query = inputs.query;
                self.radius_sq = inputs.radius_sq;
                self.sum = 0;
            }
            Op::LoadPhoton => self.photon = inputs.photon,
            Op::LoadPower => self.power = if inputs.present { inputs.power } else { 0 },
            Op::SquareDifference => {
                self.work = rules.square.apply(self.query, self.photon);
            }
            Op::ExchangeAdd => {
                let mask = u64::MAX >> (u64::BITS - rules.widths.work);
                self.work = self.work.wrapping_add(inputs.link) & mask;
            }
            Op::Gate => {
                let out_of_range = self.work > u64::from(self.radius_sq);
                self.work = if out_of_range { 0 } else { self.power };
            }
            Op::Accumulate => {
                let mask = u64::MAX >> (u64::BITS - rules.widths.sum);
                self.sum = self.sum.wrapping_add(self.work) & mask;
            }
        }
    }

    /// The registers as numbers, in the order of [`photoncube_spec::REGISTERS`].
    pub fn registers(&self) -> [u64; 6] {
        [
            u64::from(self.query),
            u64::from(self.radius_sq),
            u64::from(self.photon),
            self.power,
            self.work,
            self.sum,
        ]
    }
}
