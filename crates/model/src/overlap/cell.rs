//! The cell of an overlapped machine: its registers and the effect of a clock on them.

use photoncube_spec::{Axis, Op, POWER_WORDS, Step, Widths};

const WORDS: usize = POWER_WORDS as usize;

/// The registers of one cell; see [`photoncube_spec::OVERLAPPED`].
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct OverlapCell {
    /// `q`: the query's coordinate.
    pub query: u32,
    /// `r`: the squared search radius.
    pub radius_sq: u32,
    /// `p`: the photon's coordinate.
    pub photon: u32,
    /// `|q - p|`, the magnitude of the difference.
    pub magnitude: u32,
    /// The squares of the magnitude's base-16 digits, side by side.
    pub digit_squares: u64,
    /// The product of the magnitude's low digit and the lower half of the high one.
    pub low_product: u64,
    /// The product of the magnitude's low digit and the upper half of the high one.
    pub high_product: u64,
    /// `v`: the square.
    pub square: u64,
    /// `c`: the square of one clock ago.
    pub addend: u64,
    /// `b`: the operand of the next addition.
    pub operand: u64,
    /// `a`: a sum of squares of one photon.
    pub work: u64,
    /// `t`: the squared distance of one photon.
    pub distance: u64,
    /// `f`: the in-range flag of the distance of one clock ago.
    pub in_range: bool,
    /// `s`: the sum of the query.
    pub sum: u64,
    /// `w0`, ...: the power queue.
    pub power: [u64; WORDS],
    /// For each power in the queue, whether it has a photon.
    pub present: [bool; WORDS],
}

/// The values at a cell's ports in one clock.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct CellPorts {
    /// The query's coordinate.
    pub query: u32,
    /// The query's squared search radius.
    pub radius_sq: u32,
    /// The photon's coordinate.
    pub photon: u32,
    /// The photon's power in the cell's channel.
    pub power: u64,
    /// A group is taken, and this quad's lane has a photon.
    pub present: bool,
}

impl OverlapCell {
    /// Applies one clock with the steps that write at its end. `neighbour` returns the cell across an axis, as
    /// it was before the clock.
    ///
    /// # Panics
    /// Where an op is none of [`photoncube_spec::OVERLAPPED`].
    pub fn clock<'a>(
        &mut self,
        steps: &[Step],
        ports: &CellPorts,
        neighbour: impl Fn(Axis) -> &'a Self,
        widths: &Widths,
    ) {
        let old = *self;
        let (high, low) = (u64::from(old.magnitude) / 16, u64::from(old.magnitude) % 16);
        self.magnitude = old.query.abs_diff(old.photon);
        self.digit_squares = 256 * high * high + low * low;
        self.low_product = low * (high % 4);
        self.high_product = low * (high / 4);
        self.addend = old.square;
        self.operand = 0;
        self.in_range = old.distance <= u64::from(old.radius_sq);
        for &Step { op, axis } in steps {
            match op {
                // The comparison is done in every clock, above.
                Op::Compare => {}
                Op::LoadPhoton => self.photon = ports.photon,
                Op::LoadPower => {
                    self.power[0] = ports.power;
                    self.present[0] = ports.present;
                }
                Op::MovePower(place) => {
                    let place = usize::from(place);
                    self.power[place] = old.power[place - 1];
                    self.present[place] = old.present[place - 1];
                }
                Op::SquareDifference => {
                    self.square = old.digit_squares + 32 * old.low_product + 128 * old.high_product;
                }
                Op::Receive => {
                    self.operand = axis.map_or(0, |axis| neighbour(axis).sent(axis));
                }
                Op::Gate => self.operand = old.gated(),
                Op::Add => self.work = (old.addend + old.operand) % (1 << widths.work),
                Op::Accumulate => self.sum = (old.sum + old.operand) % (1 << widths.sum),
                Op::Keep => self.distance = axis.map_or(old.work, |axis| neighbour(axis).work),
                Op::Relay => {
                    self.distance = axis.map_or(old.distance, |axis| neighbour(axis).distance);
                }
                _ => panic!("an overlapped cell has no op {op:?}"),
            }
        }
    }

    /// Stores the values on the query's pins, whether or not they are valid; the last stored are those of the
    /// query. Results that are still in flight do not belong to the query.
    pub fn take_query(&mut self, ports: &CellPorts) {
        self.query = ports.query;
        self.radius_sq = ports.radius_sq;
        self.sum = 0;
        self.present = [false; WORDS];
    }

    /// The operand that the cell sends to its neighbour on an axis.
    fn sent(&self, axis: Axis) -> u64 {
        match axis {
            Axis::Z => self.square,
            Axis::W => self.work,
            _ => self.sum,
        }
    }

    fn gated(&self) -> u64 {
        if self.in_range && self.present[WORDS - 1] {
            self.power[WORDS - 1]
        } else {
            0
        }
    }

    /// The registers as numbers, in the order of [`photoncube_spec::OVERLAPPED`].
    pub fn registers(&self) -> impl Iterator<Item = u64> {
        let fixed = [
            u64::from(self.query),
            u64::from(self.radius_sq),
            u64::from(self.photon),
            u64::from(self.magnitude),
            self.digit_squares,
            self.low_product,
            self.high_product,
            self.square,
            self.addend,
            self.operand,
            self.work,
            self.distance,
            u64::from(self.in_range),
            self.sum,
        ];
        let queue = self.power.iter().zip(&self.present);
        let queue = queue.flat_map(|(&power, &present)| [power, u64::from(present)]);
        fixed.into_iter().chain(queue)
    }
}
