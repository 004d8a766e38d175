//! The boxes of all groups of a set are compared with the box of a batch.

use std::collections::VecDeque;

use photoncube_spec::{Leaf, LeafSizes, Machine};

use super::Events;
use super::boxes::{Bounds, Boxes, LeafBox};
use super::former::Former;

/// The geometry of the comparison. Places are in half steps of the queries.
#[derive(Copy, Clone, Debug)]
struct Geometry {
    extra_bits: u32,
    /// Twice the radius, squared.
    limit: u64,
}

impl Geometry {
    fn of(machine: &Machine) -> Self {
        let format = machine
            .format()
            .expect("a leaf machine has a photon format");
        Self {
            extra_bits: format.query_extra_bits,
            limit: u64::from(2 * format.radius_steps()).pow(2),
        }
    }

    /// Whether two boxes are within the radius of each other. The middles of two cells of unequal sizes are at least a
    /// half step apart on each axis.
    fn is_in_range(self, queries: Bounds, group: Bounds) -> bool {
        let least = u64::from(self.extra_bits > 0);
        let gaps = [0, 1, 2].map(|axis| {
            let query = |place: u32| 2 * place + 1;
            let photon = |place: u32| (2 * place + 1) << self.extra_bits;
            let (low, high) = (photon(group.low[axis]), photon(group.high[axis]));
            let gap = if low > query(queries.high[axis]) {
                low - query(queries.high[axis])
            } else {
                query(queries.low[axis]).saturating_sub(high)
            };
            u64::from(gap).max(least)
        });
        let distance: u64 = gaps.iter().map(|gap| gap * gap).sum();
        distance <= self.limit - least
    }
}

/// A pair of leaves that is compared.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Pair {
    pub(super) valid: bool,
    pub(super) pair: usize,
    pub(super) bank: usize,
    pub(super) end: bool,
    pub(super) release: bool,
}

/// A pair with its entries.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Looked {
    pub(super) pair: Pair,
    pub(super) second: bool,
    pub(super) leaves: [LeafBox; Leaf::PAIR],
}

/// A pair whose boxes are being compared. Whether a facing is gathered shows from stage 1 on, and whether a box is in range in the
/// last stage alone.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Culled {
    pub(super) pair: Pair,
    /// For each leaf, whether the batch gathers each of the facings near the leaf's.
    pub(super) near: [[bool; Leaf::FACINGS_NEAR as usize]; Leaf::PAIR],
    /// The leaf's number among these.
    pub(super) facing: [usize; Leaf::PAIR],
    pub(super) gathered: [bool; Leaf::PAIR],
    pub(super) short: [bool; Leaf::PAIR],
    /// For each leaf, whether the boxes of its groups are in range.
    in_range: [[bool; Leaf::GROUPS]; Leaf::PAIR],
}

/// A pair whose groups are played.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Wanted {
    pub(super) pair: Pair,
    /// Bit i: group i of the pair is still to be played.
    pub(super) mask: u32,
}

impl Culled {
    /// The groups of a leaf that are wanted.
    fn of_leaf(&self, leaf: usize) -> u32 {
        let [first, second] = self.in_range[leaf];
        match self.gathered[leaf] {
            true => u32::from(first) | u32::from(second && !self.short[leaf]) << 1,
            false => 0,
        }
    }

    /// The groups of the pair that are wanted.
    fn mask(&self) -> u32 {
        self.of_leaf(0) | self.of_leaf(1) << Leaf::GROUPS
    }
}

#[derive(Clone, Debug)]
pub(super) struct Scan {
    geometry: Geometry,
    /// The batch starts in this clock.
    pub(super) starting: bool,
    /// The batch started in the clock before.
    pub(super) started: bool,
    pub(super) scanning: bool,
    pub(super) bank: usize,
    pub(super) pair: usize,
    pub(super) end: usize,
    pub(super) release: bool,
    pub(super) facings: u32,
    pub(super) bounds: Bounds,
    pub(super) used: u32,
    /// The places of the queue that were given back in the clock before.
    pub(super) returned: u32,
    pub(super) look: Looked,
    pub(super) found: Looked,
    /// The stages; stage 0 is the first.
    pub(super) cull: VecDeque<Culled>,
    pub(super) queue_write: u32,
    pub(super) queue_read: u32,
    queue: VecDeque<Wanted>,
}

impl Scan {
    pub(super) fn new(machine: &Machine, leaf: &Leaf) -> Self {
        let stages = LeafSizes::of(leaf).cull_clocks as usize;
        Self {
            geometry: Geometry::of(machine),
            starting: false,
            started: false,
            scanning: false,
            bank: 0,
            pair: 0,
            end: 0,
            release: false,
            facings: 0,
            bounds: Bounds::default(),
            used: 0,
            returned: 0,
            look: Looked::default(),
            found: Looked::default(),
            cull: vec![Culled::default(); stages].into(),
            queue_write: 0,
            queue_read: 0,
            queue: VecDeque::new(),
        }
    }

    /// The number of pairs in the queue.
    pub(super) fn queued(&self) -> usize {
        self.queue.len()
    }

    /// The leaves of the pair in `Found`.
    pub(super) fn compared(&self) -> u32 {
        match self.found.pair.valid {
            true => 1 + u32::from(self.found.second),
            false => 0,
        }
    }

    /// The leaves of the pair in the last stage that are wanted.
    pub(super) fn wanted(&self) -> u32 {
        let last = self.cull.back().filter(|culled| culled.pair.valid);
        let count = |culled: &Culled| {
            let leaves = 0..Leaf::PAIR;
            leaves.filter(|&leaf| culled.of_leaf(leaf) != 0).count()
        };
        last.map_or(0, count) as u32
    }

    /// The oldest pair in the queue.
    pub(super) fn oldest(&self) -> Option<Wanted> {
        self.queue.front().copied()
    }

    pub(super) fn clock(
        &mut self,
        sizes: &LeafSizes,
        events: Events,
        former: &Former,
        boxes: &Boxes,
    ) {
        let issues = self.scanning && self.used < sizes.queue();
        let may_start = self.may_start(issues, boxes);
        let queued = self.decide(sizes, events);
        let found = self.found;
        self.cull.pop_back();
        self.cull.push_front(self.gathered(found));
        self.found = self.look;
        self.issue(issues, sizes, boxes);
        self.used += u32::from(issues);
        self.used -= self.returned;
        self.returned = u32::from(queued == Some(false)) + u32::from(events.leaves_queue);
        if self.starting {
            self.scanning = true;
            self.pair = 0;
            self.end = boxes.set(self.bank).end;
            self.release = former.release;
        }
        if self.started {
            self.facings = former.facings;
            self.bounds = former.bounds;
        }
        self.started = self.starting;
        self.starting = may_start && former.is_complete(sizes.engines);
    }

    /// Whether a batch may start in the next clock, if one is complete.
    fn may_start(&self, issues: bool, boxes: &Boxes) -> bool {
        if self.starting {
            return false;
        }
        if !self.scanning {
            return boxes.set(self.bank).full;
        }
        let next_bank = self.bank ^ usize::from(self.release);
        issues && self.is_last() && boxes.set(next_bank).full
    }

    /// Whether the pair that is issued next is the last of its set.
    fn is_last(&self) -> bool {
        self.pair == self.end / Leaf::PAIR
    }

    /// Takes the pair that leaves out of the queue, and queues the pair in the last stage. Returns whether that is queued, if
    /// there is one.
    fn decide(&mut self, sizes: &LeafSizes, events: Events) -> Option<bool> {
        if events.leaves_queue {
            self.queue.pop_front();
            self.queue_read = (self.queue_read + 1) % sizes.queue();
        }
        let last = self.cull.back().filter(|culled| culled.pair.valid)?;
        let (mask, pair) = (last.mask(), last.pair);
        let queued = mask != 0 || pair.end;
        if queued {
            self.queue.push_back(Wanted { pair, mask });
            self.queue_write = (self.queue_write + 1) % sizes.queue();
        }
        Some(queued)
    }

    /// The first stage of the comparison.
    fn gathered(&self, found: Looked) -> Culled {
        let near = Leaf::FACINGS_NEAR;
        let is_there = [found.pair.valid, found.second];
        let gathers = |leaf: usize, other: u32| {
            let facing = found.leaves[leaf].note.facing / near * near + other;
            is_there[leaf] && self.facings >> facing & 1 == 1
        };
        let near_of = |leaf| [0, 1, 2, 3].map(|other| gathers(leaf, other));
        let leaf_facing = |leaf: usize| found.leaves[leaf].note.facing % near;
        Culled {
            pair: found.pair,
            near: [0, 1].map(near_of),
            facing: [0, 1].map(|leaf| leaf_facing(leaf) as usize),
            gathered: [0, 1].map(|leaf| gathers(leaf, leaf_facing(leaf))),
            short: found.leaves.map(|leaf| leaf.note.short),
            in_range: found.leaves.map(|leaf| {
                leaf.groups
                    .map(|group| self.geometry.is_in_range(self.bounds, group))
            }),
        }
    }

    fn issue(&mut self, issues: bool, sizes: &LeafSizes, boxes: &Boxes) {
        let is_last = self.is_last();
        let leaves = match issues {
            true => boxes.pair(self.bank, self.pair),
            false => self.look.leaves,
        };
        self.look = Looked {
            pair: Pair {
                valid: issues,
                pair: self.pair,
                bank: self.bank,
                end: is_last,
                release: self.release,
            },
            second: !is_last || self.end % Leaf::PAIR == 1,
            leaves,
        };
        if issues {
            self.pair = (self.pair + 1) % (1 << sizes.pair);
            if is_last {
                self.scanning = false;
                self.bank ^= usize::from(self.release);
            }
        }
    }

    pub(super) fn reset(&mut self) {
        (self.starting, self.started) = (false, false);
        self.scanning = false;
        self.bank = 0;
        (self.used, self.returned) = (0, 0);
        self.look.pair.valid = false;
        self.found.pair.valid = false;
        for culled in &mut self.cull {
            culled.pair.valid = false;
        }
        (self.queue_write, self.queue_read) = (0, 0);
        self.queue.clear();
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Photon, Query, find_machine};
    use proptest::prelude::*;

    use super::*;
    use crate::gather;

    /// Points in the frame, mostly close to each other, of which two are a box.
    fn points(bits: u32) -> impl Strategy<Value = [[u32; 3]; 2]> {
        let largest = (1_u32 << bits) - 1;
        let near = prop::array::uniform3(0..=1_u32 << (bits - 2));
        (prop::array::uniform3(0..=largest), near).prop_map(move |(first, steps)| {
            let second = [0, 1, 2].map(|axis| (first[axis] + steps[axis]).min(largest));
            [first, second]
        })
    }

    fn around([first, second]: [[u32; 3]; 2]) -> Bounds {
        Bounds::at(first).around(Bounds::at(second))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4_000))]
        /// With whole steps and on half steps: where a photon of a group is in range of a query of a batch, so are their boxes.
        #[test]
        fn no_group_with_a_photon_in_range_is_skipped(
            whole in (points(9), points(9)),
            half in (points(10), points(8)),
        ) {
            for (name, (queries, photons)) in [
                ("leaf-4-local7-rgb6d-n64", whole),
                ("leaf-4-local6x2-rgb4d-n64", half),
            ] {
                let machine = find_machine(name).unwrap();
                let geometry = Geometry::of(machine);
                let in_range = |query: [u32; 3], photon: [u32; 3]| {
                    let query = Query { position: query, radius_sq: machine.fixed_radius_sq().unwrap() };
                    let photon = Photon { position: photon, ..Photon::default() };
                    gather(machine, &query, [photon]).unwrap().count == 1
                };
                let some = queries.iter().any(|query| photons.iter().any(|photon| in_range(*query, *photon)));
                let boxes = geometry.is_in_range(around(queries), around(photons));
                prop_assert!(boxes || !some, "{name}: {queries:?} {photons:?}");
                // Of single points the decision is that of the photon, but for two cells within a half step of each other on an
                // axis, whose gap counts as half a step in both.
                let of_points = geometry.is_in_range(Bounds::at(queries[0]), Bounds::at(photons[0]));
                prop_assert_eq!(of_points, in_range(queries[0], photons[0]));
            }
        }
    }
}
