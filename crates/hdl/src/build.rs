//! Builds the rust-hdl block of a machine from the table of widths that are compiled in.
//!
//! rust-hdl's widths are const generics, so every set of widths is compiled for itself; each costs about a
//! second of build time. Custom machines have generators of their own, see [`crate::generator`].

use photoncube_spec::{Machine, Organisation, SEQUENTIAL, Squarer, Widths};
use thiserror::Error;

use crate::level::Level;
use crate::overlap;
use crate::pinned::{MachineBlock, Pinned};
use crate::sequential::{Cell, Network, Processor, build_unit};
use crate::spatial::{PhotonMemory, SpatialMachine, SquarePair};

/// The error of a machine whose widths are not compiled in.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "machine `{machine}` needs {needed}, which is not built in; built in are {built_in}. \
     Add a row to the table in crates/hdl/src/build.rs"
)]
pub struct NotBuiltIn {
    /// The name of the machine.
    pub machine: String,
    /// The widths that the machine needs.
    pub needed: String,
    /// The widths that are compiled in.
    pub built_in: String,
}

/// The widths that select a compiled block with a program, in the order of its table.
pub(crate) fn program_widths(widths: &Widths) -> [(&'static str, u32); 10] {
    [
        ("coordinate", widths.coordinate),
        ("photon", widths.photon),
        ("difference", widths.difference),
        ("square", widths.square),
        ("radius_sq", widths.radius_sq),
        ("mantissa", widths.mantissa),
        ("exponent", widths.exponent),
        ("power", widths.power),
        ("work", widths.work),
        ("sum", widths.sum),
    ]
}

/// The widths that select a compiled spatial block, in the order of its table.
fn spatial_widths(widths: &Widths) -> [(&'static str, u32); 18] {
    [
        ("coordinate", widths.coordinate),
        ("photon", widths.photon),
        ("signed difference", widths.signed_difference()),
        ("difference", widths.difference),
        ("square", widths.square),
        ("table's word", widths.square + 1),
        ("low product", widths.low_product()),
        ("high product", widths.high_product()),
        ("product", widths.product()),
        ("pair", widths.pair()),
        ("distance", widths.distance),
        ("mantissa", widths.mantissa),
        ("exponent", widths.exponent),
        ("power", widths.power),
        ("pair's power", widths.pair_power()),
        ("group's power", widths.group_power()),
        ("sum", widths.sum),
        ("count", widths.count),
    ]
}

/// The widths without their names.
pub(crate) fn bits<const N: usize>(widths: [(&'static str, u32); N]) -> [u32; N] {
    widths.map(|(_, bits)| bits)
}

/// The sizes that select a compiled block.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct Shape {
    /// The widths in the order of [`program_widths`].
    widths: [u32; 10],
    address: u32,
    word: u32,
    axis: u32,
    nodes: usize,
    lanes: usize,
}

impl Shape {
    /// The shape of a machine; `None` for a machine that runs no program, or whose squares are tables, which
    /// its cells have no place for.
    fn of(machine: &Machine) -> Option<Self> {
        if machine.squarer == Squarer::Table {
            return None;
        }
        let program = machine.microprogram()?;
        Some(Self {
            widths: bits(program_widths(&Widths::of(machine))),
            address: program.address_bits(),
            word: SEQUENTIAL.word_bits(machine.dimension),
            axis: machine.dimension,
            nodes: machine.hypercube().nodes(),
            lanes: machine.photons_per_iteration(),
        })
    }
}

/// The block of a machine with a program, at a level; the widths are those of the table below.
pub fn sequential<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const W: usize,
    const X: usize,
    const N: usize,
    const G: usize,
>(
    machine: &Machine,
    level: Level,
) -> Option<MachineBlock> {
    Some(MachineBlock(match level {
        Level::Machine => {
            Box::new(Processor::<C, H, M, Q, R, B, E, P, V, S, A, W, X, N, G>::new(machine))
        }
        Level::Cell => Box::new(Cell::<C, H, M, Q, R, P, V, S>::new(machine.squarer)),
        Level::Network => Box::new(Network::<N, V, X>::new(machine.hypercube())),
        Level::Unit(unit) => build_unit::<C, H, M, Q, R, P, V, S>(unit, machine.squarer)?,
        Level::SquarePair | Level::Memory => return None,
    }))
}

macro_rules! built_in {
    ($($c:literal $h:literal $m:literal $q:literal $r:literal
       $b:literal $e:literal $p:literal $v:literal $s:literal
       $a:literal $w:literal $x:literal $n:literal $g:literal;)*) => {
        const BUILT_IN: &[Shape] = &[$(Shape {
            widths: [$c, $h, $m, $q, $r, $b, $e, $p, $v, $s],
            address: $a, word: $w, axis: $x, nodes: $n, lanes: $g,
        },)*];

        fn find(machine: &Machine, level: Level) -> Option<Box<dyn Pinned>> {
            let shape = Shape::of(machine)?;
            let mut row = BUILT_IN.iter();
            $(
                if row.next() == Some(&shape) {
                    return sequential::<$c, $h, $m, $q, $r, $b, $e, $p, $v, $s, $a, $w, $x, $n, $g>(machine, level).map(|block| block.0);
                }
            )*
            None
        }
    };
}

// coordinate, photon, difference, square, radius_sq; mantissa, exponent, power, work, sum;
// address, control word, axes; cells, lanes
#[cfg(all(feature = "named-machines", not(test)))]
built_in! {
    8 8 8 16 18  16 0 16 18 32  4 15 4  16 4;
    12 12 12 24 26  16 0 16 26 32  4 15 4  16 4;
    8 8 8 16 18  16 0 16 19 32  4 16 5  32 8;
    8 8 8 16 18  16 0 16 18 32  5 15 4  16 4;
    8 8 8 16 18  16 0 16 19 32  5 16 5  32 8;
    10 10 8 16 16  8 5 32 34 52  4 15 4  16 4;
    11 10 9 18 18  8 5 32 34 52  4 15 4  16 4;
    10 8 8 16 16  6 0 6 18 18  4 15 4  16 4;
    10 9 8 16 16  1 0 1 18 18  4 15 4  16 4;
    9 8 7 14 14  4 5 28 30 42  4 15 4  16 4;
}

/// The block of a spatial machine, at a level; the widths are those of the table below.
pub fn spatial<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
>(
    machine: &Machine,
    level: Level,
) -> Option<MachineBlock> {
    let spatial = machine.spatial()?;
    Some(MachineBlock(match level {
        Level::Machine => Box::new(SpatialMachine::<
            C,
            H,
            D,
            R,
            Q,
            L,
            LP,
            HP,
            PR,
            T,
            U,
            B,
            E,
            P,
            PP,
            GP,
            S,
            N,
        >::new(machine, spatial)),
        Level::SquarePair => Box::new(SquarePair::<C, H, D, R, Q, L, LP, HP, PR>::new(
            spatial.cuts,
            machine.squarer,
        )),
        Level::Memory if machine.has_memory() => Box::new(PhotonMemory::<H, B, E>::new(
            spatial,
            machine.channels().names(),
        )),
        _ => return None,
    }))
}

macro_rules! built_in_spatial {
    ($($c:literal $h:literal $d:literal $r:literal $q:literal $l:literal
       $lp:literal $hp:literal $pr:literal $t:literal $u:literal;
       $b:literal $e:literal $p:literal $pp:literal $gp:literal $s:literal $n:literal;)*) => {
        const BUILT_IN_SPATIAL: &[[u32; 18]] = &[$([
            $c, $h, $d, $r, $q, $l, $lp, $hp, $pr, $t, $u, $b, $e, $p, $pp, $gp, $s, $n,
        ],)*];

        fn find_spatial(machine: &Machine, level: Level) -> Option<Box<dyn Pinned>> {
            let widths = bits(spatial_widths(&Widths::of(machine)));
            let mut row = BUILT_IN_SPATIAL.iter();
            $(
                if row.next() == Some(&widths) {
                    return spatial::<
                        $c, $h, $d, $r, $q, $l, $lp, $hp, $pr, $t, $u, $b, $e, $p, $pp, $gp, $s, $n,
                    >(machine, level).map(|block| block.0);
                }
            )*
            None
        }
    };
}

// coordinate, photon, difference, radius, square, table's word, two digit products, product, pair, distance;
// mantissa, exponent, power, pair's power, group's power, sum, count
#[cfg(all(feature = "named-machines", not(test)))]
built_in_spatial! {
    10 10 11 8 16 17 6 6 20 17 18;  8 0 8 9 10 22 15;
    9 9 10 7 14 15 6 4 18 15 16;  6 0 6 7 8 18 13;
}

// A generator has one machine of its own, and no table. The unit tests have none, so that they are compiled in seconds;
// tests/machines.rs tests the tables.
#[cfg(any(test, not(feature = "named-machines")))]
built_in! {}
#[cfg(any(test, not(feature = "named-machines")))]
built_in_spatial! {}

/// The widths and sizes of a machine with a program, in the order of the table.
pub(crate) fn sequential_sizes(machine: &Machine) -> Vec<u32> {
    let Some(shape) = Shape::of(machine) else {
        return Vec::new();
    };
    let sizes = [
        shape.address,
        shape.word,
        shape.axis,
        shape.nodes as u32,
        shape.lanes as u32,
    ];
    shape.widths.into_iter().chain(sizes).collect()
}

/// The widths of a spatial machine, in the order of the table.
pub(crate) fn spatial_sizes(machine: &Machine) -> Vec<u32> {
    bits(spatial_widths(&Widths::of(machine))).to_vec()
}

/// Describes the needed widths and the rows of a table.
fn described<const N: usize>(
    needed: [(&'static str, u32); N],
    table: impl Iterator<Item = [u32; N]>,
) -> (String, String) {
    let described = |row: [u32; N]| {
        let named = needed.iter().zip(row);
        let named: Vec<_> = named
            .map(|((name, _), bits)| format!("{name}: {bits}"))
            .collect();
        format!("[{}]", named.join(", "))
    };
    let table: Vec<_> = table.map(described).collect();
    (described(bits(needed)), table.join(", "))
}

impl NotBuiltIn {
    /// The error of a machine's level.
    pub(crate) fn of(machine: &Machine, level: Level) -> Self {
        let widths = Widths::of(machine);
        let (needed, built_in) = match &machine.organisation {
            Organisation::Sequential | Organisation::Programmed(_) => described(
                program_widths(&widths),
                BUILT_IN.iter().map(|row| row.widths),
            ),
            Organisation::Overlapped => {
                described(program_widths(&widths), [overlap::WIDTHS].into_iter())
            }
            Organisation::Spatial(_) | Organisation::Leaf(_) => {
                described(spatial_widths(&widths), BUILT_IN_SPATIAL.iter().copied())
            }
        };
        NotBuiltIn {
            machine: machine.name.to_owned(),
            needed: format!("{level:?} of {needed}"),
            built_in,
        }
    }
}

/// The number of steps of the longest program that the machine can be built with; 0 where it runs none.
pub fn most_steps(machine: &Machine) -> usize {
    let Some(shape) = Shape::of(machine) else {
        return 0;
    };
    let with = |address| Shape { address, ..shape };
    let same = BUILT_IN.iter().filter(|row| **row == with(row.address));
    same.map(|row| 1 << row.address).max().unwrap_or(0)
}

/// Builds the block of a machine at a level, with all signals claimed.
pub(crate) fn build(machine: &Machine, level: Level) -> Result<Box<dyn Pinned>, NotBuiltIn> {
    let block = match &machine.organisation {
        Organisation::Sequential | Organisation::Programmed(_) => find(machine, level),
        Organisation::Overlapped => overlap::build(machine, level),
        Organisation::Spatial(_) => find_spatial(machine, level),
        // Leaf machines have generators of their own.
        Organisation::Leaf(_) => None,
    };
    let mut block = block.ok_or_else(|| NotBuiltIn::of(machine, level))?;
    block.connect_all();
    Ok(block)
}
