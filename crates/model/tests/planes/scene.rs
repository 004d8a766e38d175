//! Queries in a format and the photons around them: any legal format, photons on walls and at borders, and queries that share cubes.

use photoncube_model::{Gather, Gathered, LEAF, PhotonPlanes, PlacedQuery};
use photoncube_spec::{
    Channels, Exponent, PHOTON_FORMATS, PhotonBlock, PhotonFormat, PhotonRecord, PowerFormat,
    Query, Rounding,
};
use proptest::prelude::*;
use proptest::sample::select;

/// Photons of one block and one group.
#[derive(Clone, Debug)]
pub struct Run {
    pub block: [u32; 3],
    pub group: u32,
    pub exponent: u8,
    pub records: Vec<PhotonRecord>,
}

/// Queries in a format, and the photons around them.
#[derive(Clone, Debug)]
pub struct Scene {
    pub format: PhotonFormat,
    pub radius_sq: u32,
    pub queries: Vec<PlacedQuery>,
    pub runs: Vec<Run>,
}

/// Whether queries of a facing gather a group: each facing its own, the last one all.
pub fn faces(facing: u32, group: u32) -> bool {
    facing == group || facing == 2
}

fn exponents() -> impl Strategy<Value = Exponent> {
    prop_oneof![
        Just(Exponent::None),
        (1_u32..=8).prop_map(|bits| Exponent::Block { bits }),
        (1_u32..=8).prop_map(|bits| Exponent::Photon { bits }),
    ]
}

/// Every legal format, except for `max_photons`, which no test here reaches.
fn formats() -> impl Strategy<Value = PhotonFormat> {
    let channels = select(vec![Channels::Mono, Channels::Rgb]);
    let fields = (4_u32..=12, 0_u32..=2, channels, 1_u32..=16, exponents());
    fields.prop_map(
        |(position_bits, query_extra_bits, channels, mantissa_bits, exponent)| PhotonFormat {
            position_bits,
            query_extra_bits,
            power: PowerFormat {
                channels,
                mantissa_bits,
                exponent,
                rounding: Rounding::Nearest,
            },
            ..PHOTON_FORMATS[0]
        },
    )
}

pub fn ones(bits: u32) -> u16 {
    (u32::from(u16::MAX) >> (16 - bits)) as u16
}

fn record(format: PhotonFormat) -> impl Strategy<Value = PhotonRecord> {
    let PowerFormat {
        channels,
        mantissa_bits,
        exponent,
        ..
    } = format.power;
    let largest = match exponent {
        Exponent::Photon { .. } => format.power.exponent_range() as u8,
        _ => 0,
    };
    // Half of the cells are near a border, where distances are 0, saturate or change sign.
    let cell = prop_oneof![
        0..=ones(format.position_bits),
        Just(0),
        Just(ones(format.position_bits))
    ];
    let mantissa = prop_oneof![0..=ones(mantissa_bits), Just(ones(mantissa_bits))];
    (
        prop::array::uniform3(cell),
        prop::array::uniform3(mantissa),
        prop_oneof![0..=largest, Just(largest)],
    )
        .prop_map(
            move |(position, [red, green, blue], exponent)| PhotonRecord {
                position,
                mantissa: match channels {
                    Channels::Mono => [red, 0, 0],
                    Channels::Rgb => [red, green, blue],
                },
                exponent,
            },
        )
}

fn run(format: PhotonFormat) -> impl Strategy<Value = Run> {
    let largest = match format.power.exponent {
        Exponent::Block { .. } => format.power.exponent_range() as u8,
        _ => 0,
    };
    let records = prop::collection::vec(record(format), 0..3 * LEAF);
    // The photons are on a wall along two axes, or on none.
    let wall = prop::option::of((0_usize..3, 0..=ones(format.position_bits)));
    // Cubes are 8 blocks wide.
    let block = prop::array::uniform3(5_u32..12);
    (block, 0_u32..2, 0..=largest, records, wall).prop_map(
        |(block, group, exponent, mut records, wall)| {
            if let Some((axis, cell)) = wall {
                records.iter_mut().for_each(|r| r.position[axis] = cell);
            }
            Run {
                block,
                group,
                exponent,
                records,
            }
        },
    )
}

/// A query in one of the blocks, or next to them.
fn query(format: PhotonFormat) -> impl Strategy<Value = PlacedQuery> {
    let last = ones(format.radius_bits());
    let coordinate = prop_oneof![0..=last, Just(0), Just(last)];
    let fraction = prop::array::uniform3(coordinate);
    (prop::array::uniform3(4_i32..13), fraction, 0_u32..3).prop_map(|(block, fraction, facing)| {
        PlacedQuery {
            block,
            fraction,
            facing,
        }
    })
}

pub fn scene() -> impl Strategy<Value = Scene> {
    formats().prop_flat_map(|format| {
        let largest = format.largest_in_range();
        let queries = prop::collection::vec(query(format), 1..6);
        // Neighbours share a cube, so that windows hold several queries.
        let queries = queries.prop_flat_map(|queries| {
            let near = prop::collection::vec(prop::array::uniform3(-1_i32..=1), 0..6);
            (Just(queries), near).prop_map(|(queries, near)| {
                let beside = near.iter().zip(queries.iter().cycle());
                let beside = beside.map(|(step, query)| PlacedQuery {
                    block: std::array::from_fn(|axis| query.block[axis] + step[axis]),
                    ..*query
                });
                let mut all: Vec<_> = queries.iter().copied().chain(beside).collect();
                all.sort_by_key(|query| (query.block.map(|at| at >> 3), query.facing));
                all
            })
        });
        (
            prop_oneof![Just(largest), 0..=largest, Just(0)],
            queries,
            prop::collection::vec(run(format), 0..24),
        )
            .prop_map(move |(radius_sq, queries, runs)| Scene {
                format,
                radius_sq,
                queries,
                runs,
            })
    })
}

impl Scene {
    /// The photons in planes.
    pub fn planes(&self) -> PhotonPlanes {
        let mut planes = PhotonPlanes::new(&self.format).unwrap();
        let edge = planes.cube_edge();
        let key = |run: &&Run| {
            let [x, y, z] = run.block.map(|at| at / edge);
            ([z, y, x], run.group)
        };
        let mut runs: Vec<_> = self.runs.iter().collect();
        runs.sort_by_key(key);
        for run in runs.chunk_by(|a, b| key(a) == key(b)) {
            let blocks = run.iter().map(|run| PhotonBlock {
                offset: run.block.map(|at| at % edge),
                exponent: run.exponent,
                photons: &run.records,
            });
            let blocks: Vec<_> = blocks.collect();
            let cube = run[0].block.map(|at| u64::from(at / edge));
            planes.push_run(cube, run[0].group, &blocks).unwrap();
        }
        planes
    }

    /// The results of the plain gather. It tests every photon.
    pub fn expected(&self) -> Vec<Gathered> {
        let gather = Gather::new(&self.format.into()).unwrap();
        let expected = |query: &PlacedQuery| {
            let blocks = self.blocks_around(query);
            let edge = self.format.edge_steps();
            let word = Query {
                position: query.fraction.map(|at| edge + u32::from(at)),
                radius_sq: self.radius_sq,
            };
            Gathered {
                photons: blocks.iter().map(|block| block.photons.len() as u64).sum(),
                sums: gather.sums(&word, blocks).unwrap(),
                tests: 0,
            }
        };
        self.queries.iter().map(expected).collect()
    }

    /// The blocks that a query gathers, with their offsets in its frame.
    fn blocks_around(&self, query: &PlacedQuery) -> Vec<PhotonBlock<'_>> {
        let near = |run: &Run| {
            let offset: [_; 3] =
                std::array::from_fn(|axis| run.block[axis] as i32 - query.block[axis] + 1);
            let is_near =
                faces(query.facing, run.group) && offset.iter().all(|at| (0..3).contains(at));
            is_near.then_some(offset.map(|at| at as u32))
        };
        let runs = self.runs.iter();
        runs.filter_map(|run| {
            Some(PhotonBlock {
                offset: near(run)?,
                exponent: run.exponent,
                photons: &run.records,
            })
        })
        .collect()
    }
}
