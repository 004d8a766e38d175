//! Compares the fast gather with the plain one: bit for bit, in every format, with every instruction set.

use photoncube_model::{
    Gather, GatherError, Gathered, Instructions, LEAF, PhotonPlanes, Surroundings,
};
use photoncube_spec::{
    Channels, Exponent, PHOTON_FORMATS, PhotonBlock, PhotonFormat, PhotonRecord, PowerFormat,
    Query, Rounding, Sums,
};
use proptest::prelude::*;
use proptest::sample::select;

/// A run in a block around the query.
#[derive(Clone, Debug)]
struct Run {
    offset: [u32; 3],
    exponent: u8,
    records: Vec<PhotonRecord>,
}

/// The queries of one block in a format, and the photons around it.
#[derive(Clone, Debug)]
struct Scene {
    format: PhotonFormat,
    queries: Vec<Query>,
    runs: Vec<Run>,
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

fn query(position: [u32; 3], radius_sq: u32) -> Query {
    Query {
        position,
        radius_sq,
    }
}

fn ones(bits: u32) -> u16 {
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
    let offset = prop::array::uniform3(0_u32..3);
    (offset, 0..=largest, records, wall).prop_map(|(offset, exponent, mut records, wall)| {
        if let Some((axis, cell)) = wall {
            records.iter_mut().for_each(|r| r.position[axis] = cell);
        }
        Run {
            offset,
            exponent,
            records,
        }
    })
}

fn scene() -> impl Strategy<Value = Scene> {
    formats().prop_flat_map(|format| {
        let edge = format.edge_steps();
        let largest = format.largest_in_range();
        let coordinate = prop_oneof![edge..2 * edge, Just(edge), Just(2 * edge - 1)];
        (
            prop_oneof![Just(largest), 0..=largest, Just(0)],
            prop::collection::vec(prop::array::uniform3(coordinate), 1..6),
            prop::collection::vec(run(format), 0..12),
        )
            .prop_map(move |(radius_sq, positions, runs)| {
                let query = |position| Query {
                    position,
                    radius_sq,
                };
                Scene {
                    format,
                    queries: positions.into_iter().map(query).collect(),
                    runs,
                }
            })
    })
}

impl Scene {
    fn planes(&self) -> PhotonPlanes {
        let mut planes = PhotonPlanes::new(&self.format).unwrap();
        for run in &self.runs {
            planes.push_run(run.exponent, &run.records).unwrap();
        }
        planes
    }

    fn surroundings(&self, planes: &PhotonPlanes) -> Surroundings {
        let mut around = Surroundings::default();
        around.set(planes, self.runs.iter().map(|run| run.offset).zip(0..));
        around
    }

    /// The sums of the plain gather.
    fn expected(&self) -> Vec<Sums> {
        let blocks = self.runs.iter().map(|run| PhotonBlock {
            offset: run.offset,
            exponent: run.exponent,
            photons: &run.records,
        });
        let gather = Gather::new(&self.format.into()).unwrap();
        let sums = |query| gather.sums(query, blocks.clone()).unwrap();
        self.queries.iter().map(sums).collect()
    }
}

fn fast(scene: &Scene, planes: &PhotonPlanes, instructions: Instructions) -> Vec<Sums> {
    let around = scene.surroundings(planes);
    let mut found = vec![Gathered::default(); scene.queries.len()];
    let done = planes.gather_by(instructions, &around, &scene.queries, &mut found);
    done.unwrap();
    assert!(
        found
            .iter()
            .all(|f| (f.sums.count..=around.photons()).contains(&f.tests))
    );
    found.iter().map(|found| found.sums).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn all_instructions_give_the_plain_sums(scene in scene()) {
        let planes = scene.planes();
        let expected = scene.expected();
        for instructions in Instructions::available() {
            let found = fast(&scene, &planes, instructions);
            prop_assert_eq!(&found, &expected, "{}", instructions.name());
        }
    }

    #[test]
    fn planes_made_in_parts_are_those_made_at_once(scene in scene(), at in 0_usize..12) {
        let (first, rest) = scene.runs.split_at(at.min(scene.runs.len()));
        let [first, rest] = [first, rest].map(|runs| Scene { runs: runs.to_vec(), ..scene.clone() }.planes());
        let joined = first.joined(&rest);
        prop_assert_eq!(joined.photons(), scene.planes().photons());
        prop_assert_eq!(joined.bytes(), scene.planes().bytes());
        prop_assert_eq!(fast(&scene, &joined, Instructions::fastest()), scene.expected());
    }
}

/// Photons on both sides of the sphere, one step apart, along every axis and diagonal, are decided as by the
/// plain gather.
#[test]
fn the_border_of_the_sphere_is_decided_alike() {
    for format in PHOTON_FORMATS {
        let edge = format.edge_steps();
        let mut scene = Scene {
            format: *format,
            queries: vec![Query {
                position: [edge + edge / 2 + 1, edge, 2 * edge - 1],
                radius_sq: format.largest_in_range(),
            }],
            runs: Vec::new(),
        };
        for z in 0..3 {
            let cells = 0..1_u16 << format.position_bits;
            let on_axis = cells.clone().map(|x| [x, 0, ones(format.position_bits)]);
            let on_diagonal = cells.map(|x| [x, x, x]);
            for offset in [[0, 1, z], [1, 1, z], [2, 1, z], [1, 2, z]] {
                let records =
                    on_axis
                        .clone()
                        .chain(on_diagonal.clone())
                        .map(|position| PhotonRecord {
                            position,
                            mantissa: [1, 1, 1],
                            exponent: 0,
                        });
                scene.runs.push(Run {
                    offset,
                    exponent: 0,
                    records: records.collect(),
                });
            }
        }
        let expected = scene.expected();
        assert!(expected[0].count > 0, "{format}");
        for instructions in Instructions::available() {
            assert_eq!(
                fast(&scene, &scene.planes(), instructions),
                expected,
                "{format}"
            );
        }
    }
}

/// Powers at the top of every field: the sums have more than 64 bits where needed.
#[test]
fn full_scale_sums_do_not_wrap() {
    let format = PhotonFormat {
        power: PowerFormat {
            mantissa_bits: 16,
            exponent: Exponent::Block { bits: 8 },
            ..PHOTON_FORMATS[0].power
        },
        ..PHOTON_FORMATS[0]
    };
    let photon = PhotonRecord {
        position: [7; 3],
        mantissa: [u16::MAX; 3],
        exponent: 0,
    };
    let scene = Scene {
        format,
        queries: vec![Query {
            position: [256 + 7; 3],
            radius_sq: format.largest_in_range(),
        }],
        runs: vec![Run {
            offset: [1; 3],
            exponent: 24,
            records: vec![photon; 1 << 20],
        }],
    };
    let total = u128::from(u16::MAX) << (24 + 20);
    for instructions in Instructions::available() {
        let found = fast(&scene, &scene.planes(), instructions);
        assert_eq!(
            found,
            [Sums {
                power: [total; 3],
                count: 1 << 20
            }]
        );
    }
}

#[test]
fn what_the_sphere_cannot_touch_is_not_tested() {
    let far = PhotonRecord {
        position: [255; 3],
        mantissa: [1; 3],
        exponent: 0,
    };
    let scene = Scene {
        format: PHOTON_FORMATS[0],
        queries: vec![query([256; 3], 254 * 254)],
        runs: vec![
            Run {
                offset: [2; 3],
                exponent: 0,
                records: vec![far; 40],
            },
            Run {
                offset: [0; 3],
                exponent: 0,
                records: vec![far; 3],
            },
        ],
    };
    let planes = scene.planes();
    let mut found = [Gathered::default()];
    planes
        .gather(&scene.surroundings(&planes), &scene.queries, &mut found)
        .unwrap();
    assert_eq!((found[0].tests, found[0].sums.count), (3, 3));
}

#[test]
fn what_the_plain_gather_refuses_is_refused() {
    let format = PhotonFormat {
        max_photons: 3,
        ..PHOTON_FORMATS[0]
    };
    let gather = Gather::new(&format.into()).unwrap();
    let photon = PhotonRecord {
        position: [9; 3],
        mantissa: [1; 3],
        exponent: 0,
    };
    let refused = |records: &[PhotonRecord], position, radius_sq| {
        let mut planes = PhotonPlanes::new(&format).unwrap();
        planes.push_run(0, records).unwrap();
        let mut around = Surroundings::default();
        around.set(&planes, [([1; 3], 0)]);
        let query = query(position, radius_sq);
        let mut found = [Gathered::default()];
        let fast = planes.gather(&around, &[query], &mut found).unwrap_err();
        assert_eq!(found, [Gathered::default()]);
        let block = PhotonBlock {
            offset: [1; 3],
            exponent: 0,
            photons: records,
        };
        let plain = gather.sums(&query, [block]).unwrap_err();
        assert_eq!(fast, plain);
        fast
    };
    assert!(matches!(
        refused(&[photon; 4], [300; 3], 9),
        GatherError::Count(_)
    ));
    assert!(matches!(
        refused(&[photon; 2], [1024; 3], 9),
        GatherError::Range(_)
    ));
    assert!(matches!(
        refused(&[photon; 2], [300; 3], 254 * 254 + 1),
        GatherError::Range(_)
    ));
    let mut planes = PhotonPlanes::new(&format).unwrap();
    let wrong = PhotonRecord {
        position: [256, 0, 0],
        ..photon
    };
    assert!(planes.push_run(0, &[wrong]).is_err());
    assert!(planes.push_run(1, &[photon]).is_err());
    assert_eq!((planes.photons(), planes.runs()), (0, 0));
}

#[test]
#[should_panic(expected = "is not in the block that the surroundings are of")]
fn a_query_of_another_block_is_a_mistake() {
    let planes = PhotonPlanes::new(&PHOTON_FORMATS[0]).unwrap();
    let mut found = [Gathered::default()];
    let _ = planes.gather(&Surroundings::default(), &[query([0; 3], 1)], &mut found);
}

#[test]
#[should_panic(expected = "has another radius")]
fn queries_of_different_radii_are_a_mistake() {
    let planes = PhotonPlanes::new(&PHOTON_FORMATS[0]).unwrap();
    let queries = [1, 2].map(|radius_sq| query([256; 3], radius_sq));
    let mut found = [Gathered::default(); 2];
    let _ = planes.gather(&Surroundings::default(), &queries, &mut found);
}
