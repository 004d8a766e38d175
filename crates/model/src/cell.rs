//! One cell: its registers and what an op does to them.

use photoncube_spec::{Op, Widths};

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
    pub power: u32,
    /// `v`: square, distance, gated power.
    pub work: u32,
    /// `s`: the sum of the query.
    pub sum: u64,
}

/// What stands at a cell's ports in one clock. Values must fit the machine's widths.
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
    /// The photon's power in the cell's channel.
    pub power: u32,
    /// The work register of the neighbour on the selected axis; 0 if none is selected.
    pub link: u32,
}

impl CellState {
    /// Does one op; the rows of [`photoncube_spec::OPS`] in plain integers.
    pub fn execute(&mut self, op: Op, inputs: &CellInputs, widths: &Widths) {
        match op {
            Op::Nop => {}
            Op::LoadQuery => {
                self.query = inputs.query;
                self.radius_sq = inputs.radius_sq;
                self.sum = 0;
            }
            Op::LoadPhoton => self.photon = inputs.photon,
            Op::LoadPower => self.power = if inputs.present { inputs.power } else { 0 },
            Op::SquareDifference => self.work = self.query.abs_diff(self.photon).pow(2),
            Op::ExchangeAdd => {
                let mask = u32::MAX >> (u32::BITS - widths.work);
                self.work = self.work.wrapping_add(inputs.link) & mask;
            }
            Op::Gate => {
                let out_of_range = self.work > self.radius_sq;
                self.work = if out_of_range { 0 } else { self.power };
            }
            Op::Accumulate => {
                let mask = u64::MAX >> (u64::BITS - widths.sum);
                self.sum = self.sum.wrapping_add(u64::from(self.work)) & mask;
            }
        }
    }

    /// The registers as numbers, in the order of [`photoncube_spec::REGISTERS`].
    pub fn registers(&self) -> [u64; 6] {
        [
            u64::from(self.query),
            u64::from(self.radius_sq),
            u64::from(self.photon),
            u64::from(self.power),
            u64::from(self.work),
            self.sum,
        ]
    }
}
