//! A case: the queries that a machine tests at once, and their groups.

use photoncube_spec::{Group, Lane, Machine, Photon, PhotonFormat, Query, Widths};

use super::aim::Aim;

/// The queries that a machine tests at once, with all their groups, at least one, the last marked
/// as such; but a group at the last place of a photon memory's bank ends a set with or without a mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Case {
    /// [`Machine::queries_at_once`] queries.
    pub queries: Vec<Query>,
    pub groups: Vec<Group>,
    /// The next case has the same groups, so a machine with a photon memory keeps them.
    pub keeps_photons: bool,
}

impl Case {
    /// The case with the photons of a real scene, in their order. Where there are fewer queries than
    /// the machine tests at once, the last is there several times. Absent lanes repeat the first
    /// query point at full power: a machine that wrongly counted one would show it.
    ///
    /// # Panics
    /// Without a query, or with more than the machine tests at once.
    pub fn pack(machine: &Machine, queries: &[Query], photons: &[Photon]) -> Self {
        let lanes = machine.photons_per_iteration();
        let last = *queries.last().expect("a case has a query");
        let at_once = machine.queries_at_once();
        assert!(queries.len() <= at_once);
        let repeats = std::iter::repeat_n(last, at_once - queries.len());
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
            }
        });
        Self {
            groups: groups.collect(),
            queries,
            keeps_photons: false,
        }
    }

    /// A query that no photon comes to.
    pub fn empty(machine: &Machine) -> Self {
        let query = Query {
            radius_sq: machine.fixed_radius_sq().unwrap_or(0),
            ..Query::default()
        };
        let lanes = vec![Lane::default(); machine.photons_per_iteration()];
        Self {
            queries: vec![query; machine.queries_at_once()],
            groups: vec![Group { lanes, last: true }],
            keeps_photons: false,
        }
    }

    /// As many photons of full power as the machine declares, all in range: the sums reach their
    /// largest value, and every one of their bits is used.
    pub fn fullest(machine: &Machine) -> Self {
        Self::full_scale(machine, machine.max_photons())
    }

    /// With a group without photons behind: nothing is added to the sum that there is.
    pub fn then_empty(mut self, machine: &Machine) -> Self {
        if let Some(group) = self.groups.last_mut() {
            group.last = false;
        }
        self.groups.extend(Self::empty(machine).groups);
        self
    }

    /// So many photons of full power, all in range and all in one lane, so in as many groups.
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
        };
        let count = usize::try_from(photons).expect("a test's photons fit the memory");
        let mut groups = vec![group; count];
        groups[count - 1].last = true;
        Self { groups, ..one }
    }

    /// So many photons of full power, all in range.
    pub fn full_scale(machine: &Machine, photons: u64) -> Self {
        let count = usize::try_from(photons).expect("a test's photons fit the memory");
        let query = Query {
            radius_sq: largest_radius_sq(machine),
            ..Query::default()
        };
        Self::pack(machine, &[query], &vec![full_scale(machine); count])
    }
}

/// A photon in the frame's first corner whose powers are as large as can be.
pub(super) fn full_scale(machine: &Machine) -> Photon {
    let mut power = [0; 3];
    power[..machine.channels().names().len()].fill(largest(Widths::of(machine).mantissa));
    Photon {
        position: [0; 3],
        power,
        exponent: machine.format().map_or(0, |f| f.power.exponent_range()),
    }
}

/// The largest that a query may ask for.
pub(super) fn largest_radius_sq(machine: &Machine) -> u32 {
    let all_ones = largest(Widths::of(machine).radius_sq);
    machine
        .format()
        .map_or(all_ones, PhotonFormat::largest_in_range)
}

/// All ones of so many bits.
pub(super) fn largest(bits: u32) -> u32 {
    u32::MAX >> (u32::BITS - bits)
}
