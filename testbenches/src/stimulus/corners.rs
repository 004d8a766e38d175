//! Batches of cases at the corners of sums: as many photons of full power as possible.

use photoncube_spec::Machine;

use super::case::Case;

/// The most photons of a query: over all lanes, and in one lane.
struct Most {
    together: u64,
    in_lane: u64,
    /// The most groups of a query; `None` in a machine that keeps no sets, where there is no limit.
    groups: Option<u64>,
}

impl Most {
    fn of(machine: &Machine) -> Self {
        let together = machine.max_photons();
        let groups = machine.bank_groups().map(u64::from);
        Self {
            together,
            in_lane: groups.map_or(together, |groups| together.min(groups)),
            groups,
        }
    }
}

/// The cases are done twice, so that each bit changes more often than by settling at the start.
pub(super) fn full_then_empty(machine: &Machine) -> Vec<Case> {
    let lanes = machine.photons_per_iteration() as u64;
    let most = Most::of(machine);
    let fullest = Case::fullest(machine);
    let groups = fullest.groups.len() as u64;
    if most.groups.is_none_or(|held| groups < held) {
        return vec![fullest.then_empty(machine); 2];
    }
    // A bank has no place for one more group.
    let less = Case::full_scale(machine, most.together - lanes).then_empty(machine);
    [vec![less; 2], vec![fullest; 2]].concat()
}

pub(super) fn lane_alone(machine: &Machine) -> impl Iterator<Item = Vec<Case>> {
    let most = Most::of(machine).in_lane;
    // The largest count, and the largest count of all ones: together they use all bits of a count.
    let counts = [most, (1 << most.ilog2()) - 1];
    let lanes = 0..machine.photons_per_iteration();
    let in_lane =
        move |lane| counts.map(|photons| vec![Case::full_scale_in(machine, lane, photons)]);
    lanes.flat_map(in_lane)
}
