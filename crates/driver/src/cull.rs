//! Which leaves a batch wants: those that its chain will play.

use photoncube_render::{Bounds, Cull};
use photoncube_spec::PhotonFormat;

use crate::frames::{PhotonLeaf, SetBatch};

/// For each batch the indices of the leaves that it wants: their facing is one that it gathers, and their box is within the
/// search radius of the box of its queries, as the chain compares them.
pub(crate) fn wanted(
    format: &PhotonFormat,
    leaves: &[PhotonLeaf],
    batches: &[SetBatch],
) -> Vec<Vec<usize>> {
    let radius = i64::from(2 * format.radius_steps());
    let leaves: Vec<_> = leaves.iter().map(|leaf| leaf_box(format, leaf)).collect();
    let wanted = |batch: &SetBatch| {
        let Some(queries) = batch_box(batch) else {
            return Vec::new();
        };
        let is_wanted = |(facing, leaf): &(u32, Option<Bounds>)| {
            batch.facings >> facing & 1 == 1
                && leaf.is_some_and(|leaf| Cull::Distance.reads(leaf, queries, radius))
        };
        let leaves = leaves.iter().enumerate();
        leaves
            .filter(|(_, leaf)| is_wanted(leaf))
            .map(|(index, _)| index)
            .collect()
    };
    batches.iter().map(wanted).collect()
}

/// The facing of a leaf, and the box around the middles of its photons' cells.
fn leaf_box(format: &PhotonFormat, leaf: &PhotonLeaf) -> (u32, Option<Bounds>) {
    let middle = |place: u32| i64::from(2 * place + 1) << format.query_extra_bits;
    let photons = leaf.photons.iter();
    let middles = photons.map(|photon| photon.position.map(middle));
    (leaf.facing, Bounds::around(middles))
}

/// The box around the middles of the queries' cells.
fn batch_box(batch: &SetBatch) -> Option<Bounds> {
    let middle = |place: u32| i64::from(2 * place + 1);
    let queries = batch.queries.iter().map(|query| query.query.position);
    Bounds::around(queries.map(|position| position.map(middle)))
}
