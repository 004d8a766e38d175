//! Which leaves a batch wants: those of which its chain will play a group.

use photoncube_render::{Bounds, Cull};
use photoncube_spec::{Photon, PhotonFormat, Spatial};

use crate::frames::{PhotonLeaf, SetBatch};

/// A leaf that a batch wants.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) struct WantedLeaf {
    /// The leaf's index in the set.
    pub(crate) index: usize,
    /// The number of its groups that are played.
    pub(crate) groups: usize,
}

/// For each batch the leaves that it wants: their facing is one that it gathers, and the box of a group is within the
/// search radius of the box of its queries, as the chain compares them.
pub(crate) fn wanted(
    format: &PhotonFormat,
    leaves: &[PhotonLeaf],
    batches: &[SetBatch],
) -> Vec<Vec<WantedLeaf>> {
    let radius = i64::from(2 * format.radius_steps());
    let leaves: Vec<_> = leaves.iter().map(|leaf| boxes(format, leaf)).collect();
    let wanted = |batch: &SetBatch| {
        let Some(queries) = batch_box(batch) else {
            return Vec::new();
        };
        let gathered = leaves.iter().enumerate();
        let gathered = gathered.filter(|(_, (facing, _))| batch.facings >> facing & 1 == 1);
        let is_near = |group: &&Bounds| Cull::Distance.reads(**group, queries, radius);
        let of_leaf = |(index, (_, groups)): (usize, &(u32, Vec<Bounds>))| WantedLeaf {
            index,
            groups: groups.iter().filter(is_near).count(),
        };
        let leaves = gathered.map(of_leaf);
        leaves.filter(|leaf| leaf.groups > 0).collect()
    };
    batches.iter().map(wanted).collect()
}

/// The facing of a leaf, and the box around the middles of its photons' cells, for each group.
fn boxes(format: &PhotonFormat, leaf: &PhotonLeaf) -> (u32, Vec<Bounds>) {
    let middle = |place: u32| i64::from(2 * place + 1) << format.query_extra_bits;
    let bounds =
        |group: &[Photon]| Bounds::around(group.iter().map(|photon| photon.position.map(middle)));
    let groups = leaf.photons.chunks(Spatial::LANES);
    (leaf.facing, groups.filter_map(bounds).collect())
}

/// The box around the middles of the queries' cells.
fn batch_box(batch: &SetBatch) -> Option<Bounds> {
    let middle = |place: u32| i64::from(2 * place + 1);
    let queries = batch.queries.iter().map(|query| query.query.position);
    Bounds::around(queries.map(|position| position.map(middle)))
}
