//! Random queries and photons: some where distances are decided, some anywhere.

use photoncube_spec::{Group, Lane, Machine, Photon, Query, Widths};
use proptest::prelude::*;

use crate::driver::Batch;

/// A pseudo-random generator: xorshift64.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed | 1)
    }

    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub fn below(&mut self, limit: u32) -> u32 {
        (self.next() >> 16) as u32 % limit
    }
}

/// Random words that fit the machine's pins.
#[derive(Clone, Debug)]
pub struct Noise {
    random: Random,
    machine: Machine,
    widths: Widths,
}

impl Noise {
    pub fn new(machine: &Machine) -> Self {
        Self::seeded(machine, 0x5eed)
    }

    pub fn seeded(machine: &Machine, seed: u64) -> Self {
        Self {
            random: Random::new(seed),
            machine: *machine,
            widths: Widths::of(machine),
        }
    }

    pub fn query(&mut self) -> Query {
        let largest = self.machine.format().unwrap().largest_in_range();
        Query {
            position: [0; 3].map(|_| self.coordinate()),
            radius_sq: match self.machine.fixed_radius_sq() {
                Some(radius_sq) => radius_sq,
                None => largest / 2 + self.random.below(largest / 2),
            },
        }
    }

    /// A random coordinate. Half of them are near the middle of the frame, where photons are in range of most
    /// queries.
    fn coordinate(&mut self) -> u32 {
        let frame = 1 << self.widths.coordinate;
        if self.random.below(2) == 0 {
            self.random.below(frame)
        } else {
            3 * frame / 8 + self.random.below(frame / 4)
        }
    }

    pub fn group(&mut self) -> Group {
        Group {
            lanes: (0..4).map(|_| self.lane()).collect(),
            last: self.random.below(2) == 0,
            facing: 0,
        }
    }

    fn lane(&mut self) -> Lane {
        let channels = self.machine.channels().names().len();
        let exponents = self.machine.format().unwrap().power.exponent_range();
        let mut photon = Photon {
            position: [0; 3].map(|_| self.coordinate() >> extra_bits(&self.machine)),
            power: [0; 3].map(|_| self.random.below(1 << self.widths.mantissa)),
            exponent: self.random.below(exponents + 1),
        };
        photon.power[channels..].fill(0);
        Lane {
            present: self.random.below(8) != 0,
            photon,
        }
    }

    /// A batch of `groups` groups.
    pub fn batch(&mut self, groups: usize) -> Batch {
        Batch {
            queries: (0..self.machine.queries_at_once())
                .map(|_| self.query())
                .collect(),
            groups: (1..=groups)
                .map(|index| Group {
                    last: index == groups,
                    ..self.group()
                })
                .collect(),
        }
    }

    pub fn batches(&mut self, count: usize, groups: usize) -> Vec<Batch> {
        (0..count).map(|_| self.batch(groups)).collect()
    }
}

/// Coordinates at offsets from the frame's middle at which a comparison or a digit changes.
fn coordinate(machine: &Machine) -> impl Strategy<Value = u32> + use<> {
    let format = machine.format().unwrap();
    let (edge, radius) = (format.edge_steps(), format.radius_steps());
    let middle = 2 * edge;
    let near = [
        0,
        1,
        3,
        15,
        16,
        radius - 1,
        radius,
        radius + 1,
        edge,
        2 * edge - 1,
    ];
    let edges = near
        .into_iter()
        .flat_map(move |by| [middle - by, middle + by]);
    prop_oneof![
        0..4 * edge,
        middle - edge / 2..middle + edge / 2,
        prop::sample::select(edges.collect::<Vec<_>>()),
        Just(middle),
    ]
}

/// A photon's coordinate, whose steps are coarser than a query's by the extra bits.
fn photon_coordinate(machine: &Machine) -> impl Strategy<Value = u32> + use<> {
    let extra_bits = extra_bits(machine);
    coordinate(machine).prop_map(move |place| place >> extra_bits)
}

fn extra_bits(machine: &Machine) -> u32 {
    machine.format().unwrap().query_extra_bits
}

fn query(machine: &Machine) -> impl Strategy<Value = Query> + use<> {
    let largest = machine.format().unwrap().largest_in_range();
    let radius_sq = match machine.fixed_radius_sq() {
        Some(radius_sq) => Just(radius_sq).boxed(),
        None => prop_oneof![0..=largest, Just(largest)].boxed(),
    };
    (prop::array::uniform3(coordinate(machine)), radius_sq).prop_map(|(position, radius_sq)| {
        Query {
            position,
            radius_sq,
        }
    })
}

fn lane(machine: &Machine) -> impl Strategy<Value = Lane> + use<> {
    let widths = Widths::of(machine);
    let channels = machine.channels().names().len();
    (
        prop::bool::weighted(0.8),
        prop::array::uniform3(photon_coordinate(machine)),
        prop::array::uniform3(0..1_u32 << widths.mantissa),
        0..=machine.format().unwrap().power.exponent_range(),
    )
        .prop_map(move |(present, position, mut power, exponent)| {
            power[channels..].fill(0);
            let photon = Photon {
                position,
                power,
                exponent,
            };
            Lane { present, photon }
        })
}

/// A batch of up to `most_groups` groups, with no more photons than the machine declares.
pub fn batch(machine: &Machine, most_groups: usize) -> impl Strategy<Value = Batch> + use<> {
    let most = most_groups.min(machine.max_photons() as usize / 4);
    let group = prop::collection::vec(lane(machine), 4);
    (
        prop::collection::vec(query(machine), machine.queries_at_once()),
        prop::collection::vec(group, 1..=most),
    )
        .prop_map(|(queries, groups)| {
            let count = groups.len();
            let with_last = |(index, lanes)| Group {
                lanes,
                last: index + 1 == count,
                facing: 0,
            };
            Batch {
                queries,
                groups: groups.into_iter().enumerate().map(with_last).collect(),
            }
        })
}
