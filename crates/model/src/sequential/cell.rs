//! The cell of a sequential machine: its registers and the effect of an op on them.
//!
//! Distances never wrap: the work register is wide enough for the sum of three squares.

use photoncube_spec::{Machine, Numbers, Op, Register, Widths};

/// The registers of one cell.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct CellState {
    /// `q`: the query point's coordinate.
    pub query: u64,
    /// `r`: the squared search radius.
    pub radius_sq: u64,
    /// `p`: the photon's coordinate.
    pub photon: u64,
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
    pub query: u64,
    /// The query's squared search radius.
    pub radius_sq: u64,
    /// The photon's coordinate of the cell's role.
    pub photon: u64,
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
    Clamped { largest: u64 },
    /// The half square, where a photon is on the fine grid line `(index << shift) + middle`.
    HalfSteps {
        largest: u64,
        shift: u32,
        middle: u64,
    },
}

impl CellRules {
    /// The rules of a machine's cells.
    pub fn of(machine: &Machine) -> Self {
        let widths = Widths::of(machine);
        let largest = u64::MAX >> (u64::BITS - widths.difference);
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

    /// The rules of cells with other widths, whose square is that of the plain difference.
    pub fn plain(widths: Widths) -> Self {
        let square = SquareRule::Plain;
        Self { widths, square }
    }

    /// The query coordinate of a distance cell: the index just below the grid line of photon 0, so that its
    /// square is 0.
    pub(crate) fn idle_query(&self) -> u64 {
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
    fn apply(self, query: u64, photon: u64) -> u64 {
        match self {
            Self::Plain => query.abs_diff(photon).pow(2),
            Self::Clamped { largest } => query.abs_diff(photon).min(largest).pow(2),
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
                let m = steps.min(largest);
                m * (m + 1)
            }
        }
    }
}

impl CellState {
    /// A cell with these values in its registers, and 0 in all others. The values must fit the registers.
    ///
    /// # Panics
    /// Where a register is none of [`photoncube_spec::SEQUENTIAL`].
    pub fn with(values: impl IntoIterator<Item = (Register, u64)>) -> Self {
        let mut cell = Self::default();
        for (register, value) in values {
            *cell.slot(register) = value;
        }
        cell
    }

    /// The value of a register.
    ///
    /// # Panics
    /// Where the register is none of [`photoncube_spec::SEQUENTIAL`].
    pub fn register(mut self, register: Register) -> u64 {
        *self.slot(register)
    }

    fn slot(&mut self, register: Register) -> &mut u64 {
        match register {
            Register::Query => &mut self.query,
            Register::RadiusSq => &mut self.radius_sq,
            Register::Photon => &mut self.photon,
            Register::Power(0) => &mut self.power,
            Register::Work => &mut self.work,
            Register::Sum => &mut self.sum,
            _ => panic!("a sequential cell has no register {register:?}"),
        }
    }

    /// Does one op, by its row of [`photoncube_spec::SEQUENTIAL`], in plain integers.
    ///
    /// # Panics
    /// Where the op is none of that table.
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
            Op::Add => {
                let mask = u64::MAX >> (u64::BITS - rules.widths.work);
                self.work = self.work.wrapping_add(inputs.link) & mask;
            }
            Op::Gate => {
                let out_of_range = self.work > self.radius_sq;
                self.work = if out_of_range { 0 } else { self.power };
            }
            Op::Accumulate => {
                let mask = u64::MAX >> (u64::BITS - rules.widths.sum);
                self.sum = self.sum.wrapping_add(self.work) & mask;
            }
            _ => panic!("a sequential cell has no op {op:?}"),
        }
    }

    /// The registers as numbers, in the order of [`photoncube_spec::SEQUENTIAL`].
    pub fn registers(&self) -> [u64; 6] {
        [
            self.query,
            self.radius_sq,
            self.photon,
            self.power,
            self.work,
            self.sum,
        ]
    }
}
