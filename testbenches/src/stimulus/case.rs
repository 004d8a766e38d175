//! A case: the queries that a machine tests at once, with their groups.

use photoncube_spec::{Group, Lane, Leaf, Machine, Photon, Query, Widths};

use super::aim::Aim;

/// The queries that a machine tests at once, with all their groups. There is at least one group, and the last
/// is marked as such. A group at the last place of a photon memory's bank ends a set with or without the
/// mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Case {
    /// The queries, [`Machine::queries_at_once`] of them; in a leaf machine at most as many.
    pub queries: Vec<Query>,
    pub groups: Vec<Group>,
    /// The facings that the queries gather, in a leaf machine; 0 in others.
    pub facings: u32,
    /// Whether the next case has these groups too, so that a machine with a photon memory keeps them.
    pub keeps_photons: bool,
}

impl Case {
    /// Packs the photons of a scene, in their order, into a case. Where there are fewer queries than the
    /// machine tests at once, the last query is repeated, but in a leaf machine. Absent lanes carry the first query point at full
    /// power, so that a machine which wrongly counts one shows it.
    ///
    /// # Panics
    /// Where there is no query, or more than the machine tests at once.
    pub fn pack(machine: &Machine, queries: &[Query], photons: &[Photon]) -> Self {
        let lanes = machine.photons_per_iteration();
        let last = *queries.last().expect("a case has a query");
        let at_once = machine.queries_at_once();
        assert!(queries.len() <= at_once);
        let repeats = match machine.leaf() {
            Some(_) => 0,
            None => at_once - queries.len(),
        };
        let repeats = std::iter::repeat_n(last, repeats);
        let queries: Vec<_> = queries.iter().copied().chain(repeats).collect();
        let absent = Lane {
            present: false,
            photon: Photon {
                position: Aim::of(machine).cell(queries[0].position),
                ..full_scale(machine)
            },
        };
        let present = |&photon| Lane {
            present: true,
            photon,
        };
        let count = photons.len().div_ceil(lanes).max(1);
        let groups = (0..count).map(|index| {
            let rest = photons.iter().skip(index * lanes).map(present);
            let lanes = rest.chain(std::iter::repeat(absent)).take(lanes).collect();
            Group {
                lanes,
                last: index + 1 == count,
                facing: 0,
            }
        });
        Self {
            groups: groups.collect(),
            queries,
            facings: all_facings(machine),
            keeps_photons: false,
        }
    }

    /// A query with a group that has no photon.
    pub fn empty(machine: &Machine) -> Self {
        let query = Query {
            radius_sq: machine.fixed_radius_sq().unwrap_or(0),
            ..Query::default()
        };
        let lanes = vec![Lane::default(); machine.photons_per_iteration()];
        Self {
            queries: vec![query; machine.queries_at_once()],
            groups: vec![Group {
                lanes,
                last: true,
                facing: 0,
            }],
            facings: 0,
            keeps_photons: false,
        }
    }

    /// As many photons of full power as the machine declares, all in range: the sums reach their largest
    /// value, and every bit of them is used.
    pub fn fullest(machine: &Machine) -> Self {
        Self::full_scale(machine, machine.max_photons())
    }

    /// This case with a group without photons appended, which adds nothing to the sums.
    pub fn then_empty(mut self, machine: &Machine) -> Self {
        if let Some(group) = self.groups.last_mut() {
            group.last = false;
        }
        self.groups.extend(Self::empty(machine).groups);
        self
    }

    /// `photons` photons of full power, all in range and all in one lane, so each in its own group.
    pub fn full_scale_in(machine: &Machine, lane: usize, photons: u64) -> Self {
        let one = Self::full_scale(machine, 1);
        let lanes = one.groups[0].lanes.iter().enumerate();
        let lanes = lanes.map(|(index, &other)| Lane {
            present: index == lane,
            photon: match index == lane {
                true => full_scale(machine),
                false => other.photon,
            },
        });
        let group = Group {
            lanes: lanes.collect(),
            last: false,
            facing: 0,
        };
        let count = usize::try_from(photons).expect("a test's photons fit the memory");
        let mut groups = vec![group; count];
        groups[count - 1].last = true;
        Self { groups, ..one }
    }

    /// The photons that a query of the case gathers, if they are in range. The facing of a leaf is that with its last group.
    pub fn gathered(&self, machine: &Machine) -> Vec<Photon> {
        let leaves = self.groups.chunks(Leaf::GROUPS);
        let gathers = |leaf: &&[Group]| match (machine.leaf(), leaf.last()) {
            (Some(_), Some(last)) => self.facings >> last.facing & 1 == 1,
            _ => true,
        };
        let groups = leaves.filter(gathers).flatten();
        groups.flat_map(Group::photons).collect()
    }

    /// `photons` photons of full power, all in range.
    pub fn full_scale(machine: &Machine, photons: u64) -> Self {
        let count = usize::try_from(photons).expect("a test's photons fit the memory");
        let query = Query {
            radius_sq: machine.numbers.largest_radius_word(),
            ..Query::default()
        };
        Self::pack(machine, &[query], &vec![full_scale(machine); count])
    }
}

/// The set of all facings; 0 in a machine that knows none.
fn all_facings(machine: &Machine) -> u32 {
    match machine.leaf() {
        Some(_) => u32::MAX,
        None => 0,
    }
}

/// A photon in the frame's first corner with the largest powers.
pub(super) fn full_scale(machine: &Machine) -> Photon {
    let mut power = [0; 3];
    power[..machine.channels().names().len()].fill(largest(Widths::of(machine).mantissa));
    Photon {
        position: [0; 3],
        power,
        exponent: machine.numbers.power().exponent_range(),
    }
}

/// The number whose `bits` bits are all ones.
pub(super) fn largest(bits: u32) -> u32 {
    u32::MAX >> (u32::BITS - bits)
}
