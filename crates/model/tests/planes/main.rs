//! Compares the fast gather with the plain one: bit for bit, in every format, with every instruction set.

mod scene;

use photoncube_model::{
    Gather, GatherError, Gathered, INDEX_MASK, Instructions, PhotonPlanes, PlacedQuery,
};
use photoncube_spec::{
    Exponent, PHOTON_FORMATS, PhotonBlock, PhotonFormat, PhotonRecord, PowerFormat, Query, Sums,
};
use proptest::prelude::*;

use self::scene::{Run, Scene, faces, ones, scene};

/// The results of the fast gather, without the number of its tests.
fn fast(scene: &Scene, planes: &PhotonPlanes, instructions: Instructions) -> Vec<Gathered> {
    let mut found = vec![Gathered::default(); scene.queries.len()];
    let (radius_sq, queries) = (scene.radius_sq, &scene.queries);
    let done = planes.gather(instructions, radius_sq, queries, faces, &mut found);
    done.unwrap();
    for found in &mut found {
        assert!(found.sums.count <= found.tests);
        found.tests = 0;
    }
    found
}

/// Many scenes, or as many as the environment asks for: an emulator is slow.
fn config() -> ProptestConfig {
    let cases = std::env::var("PROPTEST_CASES").ok();
    let cases = cases.and_then(|cases| cases.parse().ok());
    ProptestConfig {
        cases: cases.unwrap_or(2000),
        ..ProptestConfig::default()
    }
}

/// `scripts/instructions.sh` names the instruction sets that it means to test.
#[test]
fn the_instructions_are_those_that_the_environment_names() {
    let available: Vec<_> = Instructions::available().map(Instructions::name).collect();
    if let Ok(expected) = std::env::var("PHOTONCUBE_INSTRUCTIONS") {
        assert_eq!(available.join(", "), expected);
    }
    assert_eq!(available.last(), Some(&"portable"));
}

proptest! {
    #![proptest_config(config())]

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
        let edge = PhotonPlanes::new(&scene.format).unwrap().cube_edge();
        let (first, rest) = scene.runs.iter().cloned().partition(|run| run.block[2] / edge < at as u32 % 3);
        let [first, rest] = [first, rest].map(|runs| Scene { runs, ..scene.clone() }.planes());
        let joined = first.joined(&rest);
        prop_assert_eq!(joined.photons(), scene.planes().photons());
        prop_assert_eq!(joined.runs(), scene.planes().runs());
        prop_assert_eq!(joined.bytes(), scene.planes().bytes());
        prop_assert_eq!(fast(&scene, &joined, Instructions::fastest()), scene.expected());
    }
}

/// A query in block (1, 1, 1), at a place in its own frame.
fn query_at(position: [u32; 3], format: &PhotonFormat) -> PlacedQuery {
    PlacedQuery {
        block: [1; 3],
        fraction: position.map(|at| (at - format.edge_steps()) as u16),
        facing: 0,
    }
}

/// Photons of one block, in the frame of [`query_at`].
fn run_at(block: [u32; 3], records: Vec<PhotonRecord>) -> Run {
    Run {
        block,
        group: 0,
        exponent: 0,
        records,
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
            radius_sq: format.largest_in_range(),
            queries: vec![query_at([edge + edge / 2 + 1, edge, 2 * edge - 1], format)],
            runs: Vec::new(),
        };
        for z in 0..3 {
            let cells = 0..1_u16 << format.position_bits;
            let on_axis = cells.clone().map(|x| [x, 0, ones(format.position_bits)]);
            let on_diagonal = cells.map(|x| [x, x, x]);
            for offset in [[0, 1, z], [1, 1, z], [2, 1, z], [1, 2, z]] {
                let positions = on_axis.clone().chain(on_diagonal.clone());
                let records = positions.map(|position| PhotonRecord {
                    position,
                    mantissa: [1, 1, 1],
                    exponent: 0,
                });
                scene.runs.push(run_at(offset, records.collect()));
            }
        }
        let expected = scene.expected();
        assert!(expected[0].sums.count > 0, "{format}");
        for instructions in Instructions::available() {
            let found = fast(&scene, &scene.planes(), instructions);
            assert_eq!(found, expected, "{format}");
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
        radius_sq: format.largest_in_range(),
        queries: vec![query_at([256 + 7; 3], &format)],
        runs: vec![Run {
            exponent: 24,
            ..run_at([1; 3], vec![photon; 1 << 20])
        }],
    };
    let total = u128::from(u16::MAX) << (24 + 20);
    for instructions in Instructions::available() {
        let found = fast(&scene, &scene.planes(), instructions);
        let sums = Sums {
            power: [total; 3],
            count: 1 << 20,
        };
        assert_eq!(found[0].sums, sums, "{}", instructions.name());
    }
}

#[test]
fn what_the_sphere_cannot_touch_is_not_tested() {
    let far = PhotonRecord {
        position: [255; 3],
        mantissa: [1; 3],
        exponent: 0,
    };
    // One group for each leaf, because a leaf may have photons of several blocks.
    let scene = Scene {
        format: PHOTON_FORMATS[0],
        radius_sq: 254 * 254,
        queries: vec![PlacedQuery {
            facing: 2,
            ..query_at([256; 3], &PHOTON_FORMATS[0])
        }],
        runs: vec![
            run_at([2; 3], vec![far; 40]),
            Run {
                group: 1,
                ..run_at([0; 3], vec![far; 3])
            },
        ],
    };
    for instructions in Instructions::available() {
        let mut found = [Gathered::default()];
        let done = scene.planes().gather(
            instructions,
            scene.radius_sq,
            &scene.queries,
            faces,
            &mut found,
        );
        done.unwrap();
        assert_eq!((found[0].tests, found[0].sums.count), (3, 3));
    }
}

/// Queries at the ends of the grid and beyond find what is next to them.
#[test]
fn the_ends_of_the_grid_have_neighbours() {
    let format = PHOTON_FORMATS[0];
    let last = INDEX_MASK as i32;
    let mut planes = PhotonPlanes::new(&format).unwrap();
    let edge = planes.cube_edge();
    let photons = [PhotonRecord {
        position: [128; 3],
        mantissa: [1; 3],
        exponent: 0,
    }];
    for block in [0, last as u32] {
        let block = PhotonBlock {
            offset: [block % edge; 3],
            exponent: 0,
            photons: &photons,
        };
        let cube = if block.offset[0] == 0 {
            0
        } else {
            INDEX_MASK / u64::from(edge)
        };
        planes.push_run([cube; 3], 0, &[block]).unwrap();
    }
    let counts = [
        -2,
        -1,
        0,
        1,
        2,
        last - 2,
        last - 1,
        last,
        last + 1,
        last + 2,
    ]
    .map(|at| {
        let query = PlacedQuery {
            block: [at; 3],
            fraction: [0; 3],
            facing: 0,
        };
        let mut found = [Gathered::default()];
        let done = planes.gather(Instructions::fastest(), 9, &[query], faces, &mut found);
        done.unwrap();
        found[0].photons
    });
    assert_eq!(counts, [0, 1, 1, 1, 0, 0, 1, 1, 1, 0]);
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
    let refused = |records: &[PhotonRecord], radius_sq| {
        let block = PhotonBlock {
            offset: [1; 3],
            exponent: 0,
            photons: records,
        };
        let mut planes = PhotonPlanes::new(&format).unwrap();
        planes.push_run([0; 3], 0, &[block]).unwrap();
        let query = query_at([300; 3], &format);
        let mut found = [Gathered::default()];
        let instructions = Instructions::fastest();
        let fast = planes.gather(instructions, radius_sq, &[query], faces, &mut found);
        let query = Query {
            position: [300; 3],
            radius_sq,
        };
        let plain = gather.sums(&query, [block]).unwrap_err();
        assert_eq!(fast.unwrap_err(), plain);
        plain
    };
    assert!(matches!(refused(&[photon; 4], 9), GatherError::Count(_)));
    assert!(matches!(
        refused(&[photon; 2], 254 * 254 + 1),
        GatherError::Range(_)
    ));
    let mut planes = PhotonPlanes::new(&format).unwrap();
    let wrong = PhotonRecord {
        position: [256, 0, 0],
        ..photon
    };
    for (exponent, photon) in [(0, wrong), (1, photon)] {
        let block = PhotonBlock {
            offset: [0; 3],
            exponent,
            photons: &[photon],
        };
        assert!(planes.push_run([0; 3], 0, &[block]).is_err());
    }
    assert_eq!((planes.photons(), planes.runs()), (0, 0));
}

#[test]
#[should_panic(expected = "is outside its block")]
fn a_query_outside_its_block_is_a_mistake() {
    let planes = PhotonPlanes::new(&PHOTON_FORMATS[0]).unwrap();
    let query = PlacedQuery {
        block: [0; 3],
        fraction: [0, 256, 0],
        facing: 0,
    };
    let mut found = [Gathered::default()];
    let _ = planes.gather(Instructions::fastest(), 9, &[query], faces, &mut found);
}
