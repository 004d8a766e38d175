//! The parameters of an engine's arithmetic, which are fixed when the machine is made.

use std::mem;

use photoncube_spec::{Cut, EngineKind, EngineRegister, Machine, Spatial, Widths};

/// The number of places from `Difference` to `Distance`. A radius has at most that many delays. Kinds of
/// engines differ by at most that many clocks, because all have a register at `Range`.
pub(super) const CUTS_BEFORE_RANGE: usize = Cut::Range as usize;

/// The rules by which an engine computes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Rules {
    pub(super) kind: EngineKind,
    pub(super) widths: Widths,
    /// Fraction bits that only a query has.
    extra_bits: u32,
    /// The squared radius, where all queries share it.
    pub(super) fixed_radius_sq: Option<u32>,
    /// The number of registers that a query's radius passes on its way to the compare.
    pub(super) radius_delays: usize,
    /// Clocks that the in-range flags wait for those of slower engines.
    pub(super) range_waits: usize,
}

impl Rules {
    pub(super) fn of(machine: &Machine, spatial: &Spatial, engine: usize) -> Self {
        let kind = spatial.kind(machine.squarer, engine);
        let delays = EngineRegister::RadiusDelay.row().instances;
        Self {
            kind,
            widths: Widths::of(machine),
            extra_bits: machine.format().map_or(0, |format| format.query_extra_bits),
            fixed_radius_sq: machine.fixed_radius_sq(),
            range_waits: spatial.range_waits(kind) as usize,
            radius_delays: delays.count(spatial, kind, machine.channels().names().len()),
        }
    }

    /// The place of a photon in the query's steps: its index, or on half steps the grid line in the middle of its
    /// cell.
    pub(super) fn place(&self, photon: u32) -> u32 {
        match self.extra_bits {
            0 => photon,
            bits => (2 * photon + 1) << (bits - 1),
        }
    }

    /// d^2; on half steps the half square m (m + 1), where m are the whole steps of the distance d + 1/2.
    pub(super) fn power(&self, d: i32) -> u64 {
        let steps = match (self.extra_bits, d < 0) {
            (0, _) => return u64::from(d.unsigned_abs()).pow(2),
            (_, false) => d.unsigned_abs(),
            (_, true) => d.unsigned_abs() - 1,
        };
        u64::from(steps) * u64::from(steps + 1)
    }

    /// The value after a place of the pipeline in this clock. Where a register stands there, it is the
    /// register's previous value, and the register stores `value`; elsewhere it is `value` itself.
    pub(super) fn cut<T>(&self, cut: Cut, register: &mut T, value: T) -> T {
        if self.kind.cuts.has(cut) {
            mem::replace(register, value)
        } else {
            value
        }
    }
}

/// A mask whose lowest `width` bits are ones; `width` is at most 64.
pub(super) fn ones(width: u32) -> u64 {
    u64::MAX >> (u64::BITS - width)
}
