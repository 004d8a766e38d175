//! Builds a leaf machine, for its generator.

use photoncube_spec::{LeafSizes, Machine};

use super::LeafMachine;
use crate::build::spatial_sizes;
use crate::level::Level;
use crate::pinned::MachineBlock;

/// The block of a leaf machine, at a level; the widths are those of `leaf_sizes`.
pub fn leaf<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
    const PB: usize,
    const LB: usize,
    const KB: usize,
    const QB: usize,
    const QN: usize,
    const NB: usize,
    const SB: usize,
    const OB: usize,
    const TB: usize,
    const RB: usize,
>(
    machine: &Machine,
    level: Level,
) -> Option<MachineBlock> {
    let leaf = machine.leaf()?;
    (level == Level::Machine).then(|| {
        MachineBlock(Box::new(LeafMachine::<
            C,
            H,
            D,
            R,
            Q,
            L,
            LP,
            HP,
            PR,
            T,
            U,
            B,
            E,
            P,
            PP,
            GP,
            S,
            N,
            PB,
            LB,
            KB,
            QB,
            QN,
            NB,
            SB,
            OB,
            TB,
            RB,
        >::new(machine, leaf)))
    })
}

/// The widths of a leaf machine: those of its chain, then those of its own.
pub(crate) fn leaf_sizes(machine: &Machine) -> Vec<u32> {
    let Some(leaf) = machine.leaf() else {
        return Vec::new();
    };
    let sizes = LeafSizes::of(leaf);
    let own = [
        sizes.place,
        sizes.leaf,
        sizes.pair,
        sizes.queue_place,
        sizes.queue_place + 1,
        sizes.loaded,
        sizes.spacing,
        sizes.outstanding,
        sizes.tag_place,
        sizes.result,
    ];
    spatial_sizes(machine).into_iter().chain(own).collect()
}
