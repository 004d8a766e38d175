//! Machines for the tests: the named spatial ones, and others in every legal shape.

use photoncube_model::SpatialMachine;
use photoncube_spec::{
    Cut, Cuts, EngineKind, MACHINES, Machine, Numbers, Organisation, Radius, Spatial, SpatialError,
    Squarer, find_machine, find_photon_format,
};
use proptest::prelude::*;

/// The machine of that name.
pub fn named(name: &str) -> Machine {
    *find_machine(name).unwrap()
}

/// The named spatial machines.
pub fn all_named() -> impl Iterator<Item = &'static Machine> {
    MACHINES
        .iter()
        .filter(|machine| machine.spatial().is_some())
}

/// The machine with another [`Spatial`].
pub fn with_spatial(machine: &Machine, spatial: Spatial) -> Machine {
    let machine = Machine {
        dimension: 4 + spatial.query_axes,
        organisation: Organisation::Spatial(spatial),
        ..*machine
    };
    assert_eq!(spatial.check(&machine), Ok(()));
    machine
}

/// The machine with other pipeline registers.
pub fn with_cuts(machine: &Machine, cuts: Cuts) -> Machine {
    let spatial = *machine.spatial().unwrap();
    with_spatial(machine, Spatial { cuts, ..spatial })
}

pub const SQUARERS: [Squarer; 3] = [Squarer::Digits, Squarer::Product, Squarer::Table];

/// Every set of pipeline registers that engines with such squarers may have, by the spec's check.
pub fn all_cuts(squarer: Squarer) -> impl Iterator<Item = Cuts> {
    let sets = (0_u32..1 << Cut::ALL.len()).map(|set| {
        let chosen = Cut::ALL.into_iter().enumerate();
        let chosen = chosen.filter(|(bit, _)| set >> bit & 1 == 1);
        Cuts::of(&chosen.map(|(_, cut)| cut).collect::<Vec<_>>())
    });
    sets.filter(move |&cuts| check_cuts(squarer, cuts).is_ok())
}

/// The spec's check of `stream` with such squarers and pipeline registers.
fn check_cuts(squarer: Squarer, cuts: Cuts) -> Result<(), SpatialError> {
    let stream = named("stream");
    let spatial = Spatial {
        cuts,
        ..*stream.spatial().unwrap()
    };
    let machine = Machine {
        squarer,
        organisation: Organisation::Spatial(spatial),
        ..stream
    };
    spatial.check(&machine)
}

/// Combines the pipeline registers of `machine` from `RangeDelay` on with those of `positions` before it.
fn with_positions(machine: Cuts, positions: Cuts) -> Cuts {
    let of = |cut| {
        if cut < Cut::RangeDelay {
            positions
        } else {
            machine
        }
    };
    let all = Cut::ALL.into_iter().filter(|&cut| of(cut).has(cut));
    Cuts::of(&all.collect::<Vec<_>>())
}

/// Adds the pipeline registers that the rules require. All kinds of squarers may occur, so the rules of
/// tables are used, which require the most.
fn completed(mut cuts: Vec<Cut>) -> Cuts {
    loop {
        match check_cuts(Squarer::Table, Cuts::of(&cuts)) {
            Ok(()) => return Cuts::of(&cuts),
            Err(SpatialError::Cut { cut, .. }) => cuts.push(cut),
            Err(other) => panic!("{other}"),
        }
    }
}

/// Sets of pipeline registers: those of named machines, the extremes, and any.
fn cuts() -> impl Strategy<Value = Cuts> {
    let of = |name| named(name).spatial().unwrap().cuts;
    prop_oneof![
        Just(Cuts::of(&Cut::ALL)),
        Just(completed(Vec::new())),
        Just(of("stream")),
        Just(of("tile-5")),
        prop::sample::subsequence(Cut::ALL.to_vec(), 0..=Cut::ALL.len()).prop_map(completed),
    ]
}

fn built() -> impl Strategy<Value = Machine> {
    use Squarer::Product;
    let by_any = [
        "local7-rgb6d-n4096",
        "local8-rgb8e5-n4096",
        "local8-rgb8b4-n4096",
        "local7-mono1-n8",
        "local8-mono16e8-n4096",
    ];
    // Half squares, and radii of other bits, have one squarer.
    let by_product = [
        "local4-rgb1-n8",
        "local6x2-rgb6d-n4096",
        "local7x1-mono1-n8192",
        "local4x2-rgb4e5d-n64",
        "local12x2-rgb16e8-n4096",
    ];
    let numbers = prop_oneof![
        (
            prop::sample::select(by_any.to_vec()),
            prop::sample::select(SQUARERS.to_vec())
        ),
        (prop::sample::select(by_product.to_vec()), Just(Product)),
    ];
    let others: [&'static [(Squarer, usize)]; 4] = [
        &[],
        &[(Squarer::Table, 1)],
        &[(Squarer::Product, 1)],
        &[(Squarer::Table, 1), (Squarer::Digits, 1)],
    ];
    (
        numbers,
        0_u32..=3,
        prop::bool::ANY,
        cuts(),
        prop::sample::select(others.to_vec()),
        prop::array::uniform2(cuts()),
    )
        .prop_map(
            move |((format, squarer), query_axes, own_radius, cuts, others, of_others)| {
                let is_by_product = by_product.contains(&format);
                let kind = |(&(squarer, engines), positions)| {
                    let cuts = with_positions(cuts, positions);
                    let squarer = if is_by_product { Product } else { squarer };
                    (EngineKind { squarer, cuts }, engines)
                };
                let most = others.len().min((1 << query_axes) as usize);
                let others: Vec<_> = others[..most].iter().zip(of_others).map(kind).collect();
                let machine = Machine {
                    numbers: Numbers::Local(find_photon_format(format).unwrap()),
                    squarer,
                    ..named("stream")
                };
                let spatial = Spatial {
                    query_axes,
                    radius: if own_radius {
                        Radius::Query
                    } else {
                        Radius::Format
                    },
                    cuts,
                    // The slice is leaked, because a machine's parts are `'static`, as those of the named
                    // machines are.
                    others: others.leak(),
                    memory_groups: 0,
                    paced: false,
                };
                with_spatial(&machine, spatial)
            },
        )
}

/// A named or any legal machine of up to 8 engines.
pub fn machine() -> impl Strategy<Value = Machine> {
    let few: Vec<_> = all_named().filter(|m| m.queries_at_once() <= 8).collect();
    prop_oneof![prop::sample::select(few).prop_map(|m| *m), built()]
}

#[test]
#[should_panic(expected = "memory_groups, a power of two, is 1")]
fn a_machine_that_is_not_legal_is_a_mistake() {
    let machine = named("tile-6-mixed");
    let spatial = Spatial {
        memory_groups: 1,
        ..*machine.spatial().unwrap()
    };
    let organisation = Organisation::Spatial(spatial);
    SpatialMachine::new(&Machine {
        organisation,
        ..machine
    });
}
