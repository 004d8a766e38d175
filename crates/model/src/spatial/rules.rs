//! What an engine's arithmetic depends on, fixed when the machine is made.

use std::mem;

use photoncube_spec::{Cut, EngineKind, EngineRegister, Machine, Spatial, SpatialWidths};

/// Cuts from `Difference` to `Distance`: as many delays of a radius can there be, and by as many can
/// kinds of engines differ, as all have a register at `Range`.
pub(super) const CUTS_BEFORE_RANGE: usize = Cut::Range as usize;

/// How an engine computes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Rules {
    pub(super) kind: EngineKind,
    pub(super) widths: SpatialWidths,
    /// The radius, where it is the same for all queries.
    pub(super) fixed_radius_sq: Option<u32>,
    /// Registers that a query's radius passes on its way to the compare.
    pub(super) radius_delays: usize,
    /// Clocks that a decision waits for those of slower engines.
    pub(super) range_waits: usize,
}

impl Rules {
    pub(super) fn of(machine: &Machine, spatial: &Spatial, engine: usize) -> Self {
        let format = machine.format();
        let kind = spatial.kind(machine.squarer, engine);
        let delays = EngineRegister::RadiusDelay.row().instances;
        Self {
            kind,
            widths: SpatialWidths::of(format.expect("a legal spatial machine has a photon format")),
            fixed_radius_sq: machine.fixed_radius_sq(),
            range_waits: spatial.range_waits(kind) as usize,
            radius_delays: delays.count(spatial, kind, machine.channels().names().len()),
        }
    }

    /// What is seen behind a cut in this clock: where a register stands there, what it held, and it
    /// takes `value` with the clock edge; elsewhere `value` itself.
    pub(super) fn cut<T>(&self, cut: Cut, register: &mut T, value: T) -> T {
        if self.kind.cuts.has(cut) {
            mem::replace(register, value)
        } else {
            value
        }
    }
}

/// The lowest `width` bits all ones, of up to 64.
pub(super) fn ones(width: u32) -> u64 {
    u64::MAX >> (u64::BITS - width)
}
