//! Random queries and photons, weighted towards the corners where a datapath fails.

use photoncube_spec::{Group, Lane, Leaf, Machine, Photon, Query, Widths};
use rand::{Rng, RngExt};

use super::aim::Aim;
use super::case::{Case, full_scale, largest};

/// The places of the photons of a case.
#[derive(Copy, Clone, Debug)]
enum Theme {
    /// Anywhere.
    Uniform,
    /// On corner values of each coordinate.
    Corners,
    /// At the query point.
    Equal,
    /// The query is in a corner of the frame, the photons are in the opposite one.
    Farthest,
    /// Within a random power of two of the query point.
    Near,
    /// On lattice points at one distance, some of them one step off.
    Shell,
    /// The photons of each leaf at one place near the largest radius, and all queries at one place: the box of the leaf
    /// is just wanted, or just not.
    Leaves,
}

/// A generator of cases for one machine.
pub(crate) struct Cases<'a, R> {
    pub(super) widths: Widths,
    pub(super) aim: Aim,
    pub(super) full: Photon,
    largest_radius_sq: u32,
    pub(super) fixed_radius_sq: Option<u32>,
    at_once: usize,
    /// Whether batches may have fewer queries, and photons have facings.
    pub(super) has_leaves: bool,
    lanes: usize,
    /// Groups of a set at most.
    most_groups: usize,
    max_photons: u64,
    pub(super) rng: &'a mut R,
}

impl<'a, R: Rng> Cases<'a, R> {
    pub fn new(machine: &Machine, rng: &'a mut R) -> Self {
        Self {
            widths: Widths::of(machine),
            aim: Aim::of(machine),
            full: full_scale(machine),
            largest_radius_sq: machine.numbers.largest_radius_word(),
            fixed_radius_sq: machine.fixed_radius_sq(),
            at_once: machine.queries_at_once(),
            has_leaves: machine.leaf().is_some(),
            lanes: machine.photons_per_iteration(),
            most_groups: machine
                .bank_groups()
                .map_or(usize::MAX, |groups| groups as usize),
            max_photons: machine.max_photons(),
            rng,
        }
    }

    /// A case, mostly of one to three groups, sometimes of up to 40.
    pub fn case(&mut self) -> Case {
        self.drawn(None)
    }

    /// A case of `groups` groups.
    pub fn of_groups(&mut self, groups: usize) -> Case {
        self.drawn(Some(groups))
    }

    fn drawn(&mut self, groups: Option<usize>) -> Case {
        let theme = self.theme();
        let position = [(); 3].map(|()| match theme {
            Theme::Farthest if self.rng.random() => largest(self.widths.coordinate),
            Theme::Farthest => 0,
            _ => self.corner(self.widths.coordinate),
        });
        let pivot = match (theme, self.fixed_radius_sq) {
            (Theme::Shell, Some(radius_sq)) => self.at_radius(position, radius_sq),
            (Theme::Leaves, _) => self.next_to_radius(position, self.largest_radius_sq),
            _ => self.photon_position(theme, position, None),
        };
        let first = Query {
            position,
            radius_sq: self.radius_sq(self.aim.distance_sq(position, pivot)),
        };
        let others = (1..self.batch()).map(|_| match theme {
            Theme::Leaves => first,
            _ => self.companion(first),
        });
        let queries = [first].into_iter().chain(others).collect();
        let count = groups.unwrap_or_else(|| self.count().min(self.most_groups));
        let mut place = pivot;
        let groups = (0..count).map(|index| {
            if matches!(theme, Theme::Leaves) && index % Leaf::GROUPS == 0 {
                place = self.on_shell(position, pivot);
            }
            Group {
                lanes: self.lanes(theme, position, place),
                last: index + 1 == count,
                facing: self.facing(),
            }
        });
        let mut groups: Vec<_> = groups.collect();
        // A query has no more photons than the format declares.
        let lanes = groups.iter_mut().flat_map(|group| &mut group.lanes);
        let present = lanes.filter(|lane| lane.present);
        let most = usize::try_from(self.max_photons).unwrap_or(usize::MAX);
        present.skip(most).for_each(|lane| lane.present = false);
        Case {
            queries,
            groups,
            facings: self.facings(),
            keeps_photons: false,
        }
    }

    /// The number of queries of a case.
    fn batch(&mut self) -> usize {
        match self.has_leaves && self.rng.random() {
            true => self.rng.random_range(1..=self.at_once),
            false => self.at_once,
        }
    }

    /// The facing of a group: mostly one of two, so that leaves of a set have it too.
    pub(super) fn facing(&mut self) -> u32 {
        match self.has_leaves {
            false => 0,
            true if self.rng.random_ratio(1, 4) => self.rng.random_range(0..Leaf::FACINGS),
            true => self.rng.random_range(0..2) * (Leaf::FACINGS - 1),
        }
    }

    /// The facings that a batch gathers: all of them, some, or one.
    fn facings(&mut self) -> u32 {
        if !self.has_leaves {
            return 0;
        }
        match self.rng.random_range(0..4) {
            0 => self.rng.random(),
            1 => 1 << self.facing(),
            _ => u32::MAX,
        }
    }

    fn count(&mut self) -> usize {
        match self.rng.random_range(0..16) {
            // Long enough for batches to follow each other in a chain of engines without waiting.
            0..=3 if self.at_once > 1 => self.rng.random_range(1..=4 * self.at_once),
            0 => self.rng.random_range(1..=40),
            1..=3 => 3,
            4..=7 => 2,
            _ => 1,
        }
    }

    /// `count` cases. With `shared`, a machine with a photon memory gets some cases that reuse the photons of
    /// the case before.
    pub fn cases(&mut self, count: usize, shared: bool) -> Vec<Case> {
        let mut cases: Vec<Case> = Vec::new();
        for _ in 0..count {
            let mut case = self.case();
            if let Some(before) = cases.last_mut()
                && shared
                && self.rng.random()
            {
                before.keeps_photons = true;
                case.groups.clone_from(&before.groups);
            }
            cases.push(case);
        }
        cases
    }

    /// A further query of the batch: equal to the first, some steps off, or anywhere.
    fn companion(&mut self, first: Query) -> Query {
        let bits = self.widths.coordinate;
        let position = match self.rng.random_range(0..4) {
            0 => first.position,
            1 => [(); 3].map(|()| self.corner(bits)),
            _ => first.position.map(|coordinate| {
                let offset = self.rng.random_range(0..=4_u32);
                (coordinate + offset).saturating_sub(2).min(largest(bits))
            }),
        };
        let tie = u64::from(first.radius_sq) + self.rng.random_range(0..2);
        Query {
            position,
            radius_sq: self.radius_sq(tie),
        }
    }

    fn theme(&mut self) -> Theme {
        if self.has_leaves && self.rng.random_ratio(1, 8) {
            return Theme::Leaves;
        }
        match self.rng.random_range(0..16) {
            0..=2 => Theme::Uniform,
            3..=5 => Theme::Corners,
            6 => Theme::Equal,
            7 => Theme::Farthest,
            8..=10 => Theme::Near,
            _ => Theme::Shell,
        }
    }

    /// A squared radius: mostly at the edge of a photon at the pivot's distance, sometimes an extreme.
    fn radius_sq(&mut self, tie: u64) -> u32 {
        if let Some(fixed) = self.fixed_radius_sq {
            return fixed;
        }
        let limit = u64::from(self.largest_radius_sq);
        let farthest = self
            .aim
            .distance_sq([0; 3], [largest(self.widths.photon); 3]);
        let value = match self.rng.random_range(0..16) {
            0..=3 => tie,
            4..=6 => tie.saturating_sub(1),
            7..=9 => tie + 1,
            10 => 0,
            11 => limit,
            12 => farthest,
            13 => farthest - 1,
            14 => u64::from(self.corner(self.widths.radius_sq)),
            _ => u64::from(self.uniform(self.widths.difference)).pow(2),
        };
        u32::try_from(value.min(limit)).expect("distances fit 32 bits")
    }

    fn lanes(&mut self, theme: Theme, query: [u32; 3], pivot: [u32; 3]) -> Vec<Lane> {
        let presence = self.rng.random_range(0..8);
        let alone = self.rng.random_range(0..self.lanes);
        let lanes = (0..self.lanes).map(|lane| Lane {
            present: match presence {
                0 => false,
                1 => lane == alone,
                2 | 3 => self.rng.random(),
                _ => true,
            },
            photon: Photon {
                position: self.photon_position(theme, query, Some(pivot)),
                ..self.power()
            },
        });
        lanes.collect()
    }

    /// A photon's powers and exponent, often extreme.
    fn power(&mut self) -> Photon {
        let bits = self.widths.mantissa;
        let exponent = match self.rng.random_range(0..4) {
            0 => 0,
            1 => self.full.exponent,
            _ => self.rng.random_range(0..=self.full.exponent),
        };
        let power = self.full.power.map(|full| self.corner(bits) & full);
        Photon {
            position: [0; 3],
            power: match self.rng.random_range(0..16) {
                0 => self.full.power,
                _ => power,
            },
            exponent,
        }
    }

    fn photon_position(
        &mut self,
        theme: Theme,
        query: [u32; 3],
        pivot: Option<[u32; 3]>,
    ) -> [u32; 3] {
        let bits = self.widths.photon;
        match (theme, pivot) {
            (Theme::Uniform, _) => [(); 3].map(|()| self.uniform(bits)),
            (Theme::Corners, _) => [(); 3].map(|()| self.corner(bits)),
            (Theme::Equal, _) => self.aim.cell(query),
            (Theme::Farthest, _) => self.aim.cell(query).map(|cell| largest(bits) - cell),
            (Theme::Near, _) | (Theme::Shell | Theme::Leaves, None) => self.near(query),
            (Theme::Shell, Some(pivot)) => self.on_shell(query, pivot),
            (Theme::Leaves, Some(place)) => place,
        }
    }

    fn near(&mut self, query: [u32; 3]) -> [u32; 3] {
        let span = self.rng.random_range(0..self.widths.photon);
        let limit = largest(self.widths.photon);
        self.aim.cell(query).map(|centre| {
            let offset = self.rng.random_range(0..=1_u32 << span);
            if self.rng.random() {
                (centre + offset).min(limit)
            } else {
                centre.saturating_sub(offset)
            }
        })
    }

    /// The pivot, mirrored and with its axes exchanged where the frame allows it, which preserves the
    /// distance. One in four is then moved by one step.
    fn on_shell(&mut self, query: [u32; 3], pivot: [u32; 3]) -> [u32; 3] {
        let limit = largest(self.widths.photon);
        let mut steps = [0, 1, 2].map(|axis| self.aim.steps(query[axis], pivot[axis]));
        steps.rotate_left(self.rng.random_range(0..3));
        if self.rng.random() {
            steps.swap(0, 1);
        }
        let mirrored = [0, 1, 2].map(|axis| {
            let sides = self.aim.at_steps(query[axis], steps[axis]);
            let [above, below] = sides.map(|side| side.filter(|&photon| photon <= limit));
            if self.rng.random() {
                above.or(below)
            } else {
                below.or(above)
            }
        });
        let mut position = match mirrored {
            [Some(x), Some(y), Some(z)] => [x, y, z],
            _ => pivot,
        };
        if self.rng.random_ratio(1, 4) {
            let axis = self.rng.random_range(0..3);
            position[axis] = (position[axis] + 1).min(limit);
        }
        position
    }

    fn corner(&mut self, bits: u32) -> u32 {
        u32::try_from(corner(self.rng, bits)).expect("values but the sums fit 32 bits")
    }

    pub(super) fn uniform(&mut self, bits: u32) -> u32 {
        self.rng.random::<u32>() & largest(bits)
    }
}

/// A value of `bits` bits. Half of the time it is a corner of its width.
pub(crate) fn corner(rng: &mut impl Rng, bits: u32) -> u64 {
    let largest = u64::MAX >> (u64::BITS - bits);
    let power = 1 << rng.random_range(0..bits);
    match rng.random_range(0..12) {
        0 | 1 => 0,
        2 | 3 => largest,
        4 => power,
        5 => power - 1,
        6 => (power + 1) & largest,
        _ => rng.random::<u64>() & largest,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use photoncube_model::Limits;
    use photoncube_spec::MACHINES;
    use rand::SeedableRng;
    use rand_pcg::Pcg64;

    use super::*;

    #[test]
    fn every_value_fits_and_every_corner_is_met() {
        for machine in MACHINES {
            let mut rng = Pcg64::seed_from_u64(1);
            let mut cases = Cases::new(machine, &mut rng);
            let limits = Limits::of(&machine.numbers).unwrap();
            let mut met = BTreeSet::new();
            for _ in 0..5_000 {
                let case = cases.case();
                assert_eq!(case.queries.len(), machine.queries_at_once());
                for query in &case.queries {
                    limits.check_query(query).unwrap();
                }
                let query = case.queries[0];
                let tie = u64::from(query.radius_sq);
                met.insert(if tie == 0 { "radius 0" } else { "radius" });
                if query.radius_sq == machine.numbers.largest_radius_word() {
                    met.insert("radius max");
                }
                if case.groups.iter().all(|g| g.photons().count() == 0) {
                    met.insert("no photon");
                }
                assert!(case.groups.last().unwrap().last);
                for lane in case.groups.iter().flat_map(|group| &group.lanes) {
                    limits.check_photon(&lane.photon).unwrap();
                    let aim = Aim::of(machine);
                    let distance = aim.distance_sq(query.position, lane.photon.position);
                    met.extend(lane_corners(machine, lane, distance, tie));
                }
            }
            let wanted = [
                "absent",
                "above",
                "below",
                "equal",
                "farthest",
                "full",
                "no photon",
                "radius",
                "radius 0",
                "radius max",
                "tie",
                "zero power",
            ];
            let mut wanted = BTreeSet::from(wanted);
            if machine.fixed_radius_sq().is_some() {
                wanted.remove("radius 0");
            }
            assert_eq!(met, wanted, "{}", machine.name);
        }
    }

    fn lane_corners(
        machine: &Machine,
        lane: &Lane,
        distance: u64,
        tie: u64,
    ) -> impl Iterator<Item = &'static str> {
        let full = full_scale(machine);
        let corner = [largest(Widths::of(machine).photon); 3];
        let farthest = Aim::of(machine).distance_sq([0; 3], corner);
        let corners = [
            ("absent", !lane.present),
            ("above", lane.present && distance == tie + 1),
            ("below", lane.present && distance + 1 == tie),
            ("equal", lane.present && distance == 0),
            ("farthest", lane.present && distance == farthest),
            (
                "full",
                Photon {
                    position: [0; 3],
                    ..lane.photon
                } == full,
            ),
            ("tie", lane.present && distance == tie && tie > 0),
            ("zero power", lane.photon.power == [0; 3]),
        ];
        corners
            .into_iter()
            .filter_map(|(name, met)| met.then_some(name))
    }

    #[test]
    fn packing_keeps_the_photons_and_their_order() {
        let machine = &MACHINES[0];
        let photon = |x| Photon {
            position: [x, 0, 0],
            power: [x; 3],
            exponent: 0,
        };
        for count in [0, 1, 3, 4, 5, 8, 9] {
            let photons: Vec<_> = (0..count).map(photon).collect();
            let case = Case::pack(machine, &[Query::default()], &photons);
            let packed: Vec<_> = case.groups.iter().flat_map(Group::photons).collect();
            assert_eq!(packed, photons);
            assert_eq!(case.groups.len(), photons.len().div_ceil(4).max(1));
            assert_eq!(
                case.groups.iter().filter(|group| group.last).count(),
                1,
                "{count}"
            );
        }
    }
}
