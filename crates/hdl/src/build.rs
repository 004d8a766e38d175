//! From a machine's numbers to a rust-hdl block: the table of the widths that are built in.
//!
//! rust-hdl's widths are const generics, so every set of widths is compiled; each costs about a
//! second of build time.

use photoncube_spec::{Machine, Widths, control_word_bits};
use thiserror::Error;

use crate::cell::Cell;
use crate::level::Level;
use crate::network::Network;
use crate::pinned::Pinned;
use crate::processor::Processor;
use crate::units::{AddUnit, GateUnit, SquareUnit};

/// No block of these widths is compiled in.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "machine `{machine}` needs {needed}, which is not built in; built in are {built_in}. \
     Add a row to the table in crates/hdl/src/build.rs"
)]
pub struct NotBuiltIn {
    /// The machine.
    pub machine: String,
    /// The widths that it needs.
    pub needed: String,
    /// The widths that there are.
    pub built_in: String,
}

/// All that chooses a compiled block.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
struct Shape {
    widths: Widths,
    address: u32,
    word: u32,
    axis: u32,
    nodes: usize,
    lanes: usize,
}

impl Shape {
    /// None for a machine that runs no program.
    fn of(machine: &Machine) -> Option<Self> {
        let steps = machine.microprogram()?.steps().len();
        Some(Self {
            widths: Widths::of(machine),
            address: usize::BITS - (steps - 1).leading_zeros(),
            word: control_word_bits(machine.dimension),
            axis: machine.dimension,
            nodes: machine.hypercube().nodes(),
            lanes: machine.photons_per_iteration(),
        })
    }
}

macro_rules! built_in {
    ($($c:literal $h:literal $m:literal $q:literal $r:literal
       $b:literal $e:literal $p:literal $v:literal $s:literal
       $a:literal $w:literal $x:literal $n:literal $g:literal;)+) => {
        const BUILT_IN: &[Shape] = &[$(Shape {
            widths: Widths {
                coordinate: $c, photon: $h, difference: $m, square: $q, radius_sq: $r,
                mantissa: $b, exponent: $e, power: $p, work: $v, sum: $s,
            },
            address: $a, word: $w, axis: $x, nodes: $n, lanes: $g,
        },)+];

        fn find(machine: &Machine, level: Level) -> Option<Box<dyn Pinned>> {
            let shape = Shape::of(machine)?;
            let mut row = BUILT_IN.iter();
            $(
                if row.next() == Some(&shape) {
                    return Some(match level {
                        Level::Machine => Box::new(
                            Processor::<$c, $h, $m, $q, $r, $b, $e, $p, $v, $s, $a, $w, $x, $n, $g>
                                ::new(machine)),
                        Level::Cell => Box::new(
                            Cell::<$c, $h, $m, $q, $r, $p, $v, $s>::new(machine.squarer)),
                        Level::Network => Box::new(Network::<$n, $v, $x>::new(machine.hypercube())),
                        Level::Add => Box::new(AddUnit::<$s>::default()),
                        Level::Square => Box::new(SquareUnit::<$c, $h, $m, $q>::new(machine.squarer)),
                        Level::Gate => Box::new(GateUnit::<$v, $r, $p>::default()),
                    });
                }
            )+
            None
        }
    };
}

// coordinate, photon, difference, square, radius_sq; mantissa, exponent, power, work, sum;
// address, control word, axes; cells, lanes
built_in! {
    8 8 8 16 18  16 0 16 18 32  4 15 4  16 4;
    12 12 12 24 26  16 0 16 26 32  4 15 4  16 4;
    8 8 8 16 18  16 0 16 19 32  4 16 5  32 8;
    10 10 8 16 16  8 5 32 34 52  4 15 4  16 4;
    11 10 9 18 18  8 5 32 34 52  4 15 4  16 4;
    10 8 8 16 16  6 0 6 18 18  4 15 4  16 4;
    10 9 8 16 16  1 0 1 18 18  4 15 4  16 4;
    9 8 7 14 14  4 5 28 30 42  4 15 4  16 4;
}

/// The block of a machine at a level, with all its signals claimed.
pub(crate) fn build(machine: &Machine, level: Level) -> Result<Box<dyn Pinned>, NotBuiltIn> {
    let mut block = find(machine, level).ok_or_else(|| NotBuiltIn {
        machine: machine.name.to_owned(),
        needed: format!("{:?}", Shape::of(machine)),
        built_in: format!("{BUILT_IN:?}"),
    })?;
    block.connect_all();
    Ok(block)
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::{MACHINES, Numbers, PlainFormat};

    #[test]
    fn every_named_machine_is_built_in() {
        for machine in MACHINES {
            for level in Level::ALL {
                assert!(build(machine, level).is_ok(), "{} {level:?}", machine.name);
            }
        }
    }

    #[test]
    fn a_width_that_is_not_built_in_is_refused_with_those_that_are() {
        let numbers = Numbers::Plain(PlainFormat {
            coordinate_bits: 9,
            power_bits: 16,
            max_photons: 65_537,
        });
        let machine = Machine {
            numbers,
            ..MACHINES[0]
        };
        let error = build(&machine, Level::Machine).err().unwrap().to_string();
        assert!(
            error.contains("coordinate: 9") && error.contains("coordinate: 8"),
            "{error}"
        );
    }
}
