//! The table of the named machines, and the search for a machine by its name. Each row sets every field; no field has
//! a default.

use thiserror::Error;

use crate::custom::{self, CustomError, CustomOrganisation};
use crate::formats::{
    Channels, Exponent, Numbers, PHOTON_FORMATS, PhotonFormat, PlainFormat, PowerFormat, Rounding,
    Squarer,
};
use crate::machine::Machine;
use crate::nearest::did_you_mean;
use crate::organisation::Organisation;
use crate::spatial::pipelines::{DECISIONS, DIGITS, FINE, PRODUCT, TABLE};
use crate::spatial::{Cuts, EngineKind, Radius, Spatial};

/// Plain numbers with 16-bit powers. The sum of 65,537 photons of full scale fits 32 bits exactly.
const fn plain(coordinate_bits: u32) -> Numbers {
    Numbers::Plain(PlainFormat {
        coordinate_bits,
        power_bits: 16,
        max_photons: 65_537,
    })
}

/// A tile of `2^query_axes` engines. Its format has one scale for all powers and seven bits for the radius;
/// `photoncube report SCENE` measures what the format costs in accuracy.
const fn tile(name: &'static str, summary: &'static str, query_axes: u32) -> Machine {
    Machine {
        name,
        summary,
        dimension: 4 + query_axes,
        numbers: Numbers::Local(PhotonFormat {
            position_bits: 7,
            query_extra_bits: 0,
            power: PowerFormat {
                channels: Channels::Rgb,
                mantissa_bits: 6,
                exponent: Exponent::None,
                rounding: Rounding::Dithered,
            },
            max_photons: 1 << 12,
        }),
        squarer: Squarer::Digits,
        organisation: Organisation::Spatial(Spatial {
            query_axes,
            radius: Radius::Format,
            cuts: DIGITS,
            others: &[],
            memory_groups: 0,
            paced: false,
        }),
    }
}

/// Adds to a tile a photon memory of two banks, each of which holds the most photons that a query may be
/// given. Sets the pipeline registers to `cuts` and adds engines of other kinds.
const fn with_memory(tile: Machine, cuts: Cuts, others: &'static [(EngineKind, usize)]) -> Machine {
    let Organisation::Spatial(spatial) = tile.organisation else {
        panic!("only spatial machines have a photon memory");
    };
    let Numbers::Local(format) = tile.numbers else {
        panic!("spatial machines have photon formats");
    };
    let memory_groups = (format.max_photons / Spatial::LANES as u64) as u32;
    Machine {
        organisation: Organisation::Spatial(Spatial {
            cuts,
            others,
            memory_groups,
            ..spatial
        }),
        ..tile
    }
}

/// All named machines; the first is the default.
pub const MACHINES: &[Machine] = &[
    Machine {
        name: "paper",
        summary: "Ryu, Kim, Lee: 16 cells on a 4-D hypercube, squarers for LUTs",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: plain(8),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "paper-dsp",
        summary: "the paper's 16 cells, squarers for DSP blocks",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: plain(8),
        squarer: Squarer::Product,
    },
    Machine {
        name: "paper-12",
        summary: "the paper's 16 cells with 12-bit coordinates",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: plain(12),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "paper-5d",
        summary: "32 cells on a 5-D hypercube: 8 photons an iteration",
        organisation: Organisation::Sequential,
        dimension: 5,
        numbers: plain(8),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "local",
        summary: "16 cells, numbers relative to the search radius: the default photon format",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: Numbers::Local(PHOTON_FORMATS[0]),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "local-half",
        summary: "16 cells, the default photon format, queries on half steps: the widest built",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: Numbers::Local(PhotonFormat {
            query_extra_bits: 1,
            ..PHOTON_FORMATS[0]
        }),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "fit-cornell",
        summary: "16 cells, the photon format that `fit` finds for the scene cornell",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: Numbers::Local(PhotonFormat {
            position_bits: 6,
            query_extra_bits: 2,
            power: PowerFormat {
                channels: Channels::Rgb,
                mantissa_bits: 6,
                exponent: Exponent::None,
                rounding: Rounding::Dithered,
            },
            max_photons: 1 << 12,
        }),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "fit-ring",
        summary: "16 cells, the photon format that `fit` finds for the scene ring",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: Numbers::Local(PhotonFormat {
            position_bits: 7,
            query_extra_bits: 1,
            power: PowerFormat {
                channels: Channels::Mono,
                mantissa_bits: 1,
                exponent: Exponent::None,
                rounding: Rounding::Nearest,
            },
            max_photons: 1 << 13,
        }),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "fit-range",
        summary: "16 cells, the photon format that `fit` finds for the scene range",
        organisation: Organisation::Sequential,
        dimension: 4,
        numbers: Numbers::Local(PhotonFormat {
            position_bits: 6,
            query_extra_bits: 1,
            power: PowerFormat {
                channels: Channels::Rgb,
                mantissa_bits: 4,
                exponent: Exponent::Photon { bits: 5 },
                rounding: Rounding::Dithered,
            },
            max_photons: 1 << 14,
        }),
        squarer: Squarer::Digits,
    },
    Machine {
        name: "stream",
        summary: "one engine of 16 cells that keep their instructions: a group of 4 photons a clock",
        dimension: 4,
        numbers: Numbers::Local(PhotonFormat {
            power: PowerFormat {
                exponent: Exponent::None,
                rounding: Rounding::Dithered,
                ..PHOTON_FORMATS[0].power
            },
            max_photons: 1 << 14,
            ..PHOTON_FORMATS[0]
        }),
        squarer: Squarer::Digits,
        organisation: Organisation::Spatial(Spatial {
            query_axes: 0,
            radius: Radius::Query,
            cuts: FINE,
            others: &[],
            memory_groups: 0,
            paced: false,
        }),
    },
    Machine {
        name: "overlap",
        summary: "the paper's 16 cells with all units at work: a modulo-scheduled kernel",
        organisation: Organisation::Overlapped,
        dimension: 4,
        numbers: plain(8),
        squarer: Squarer::Digits,
    },
    tile(
        "tile-4",
        "one engine with the ports of a tile: what a tile costs without a chain",
        0,
    ),
    tile(
        "tile-5",
        "2 engines in a chain: every photon is read once for 2 queries",
        1,
    ),
    tile(
        "tile-6",
        "4 engines in a chain: every photon is read once for 4 queries",
        2,
    ),
    tile(
        "tile-7",
        "8 engines in a chain: every photon is read once for 8 queries",
        3,
    ),
    tile(
        "tile-8",
        "16 engines in a chain: every photon is read once for 16 queries",
        4,
    ),
    tile(
        "tile-9",
        "32 engines in a chain: every photon is read once for 32 queries",
        5,
    ),
    tile(
        "tile-10",
        "64 engines in a chain: every photon is read once for 64 queries",
        6,
    ),
    with_memory(
        tile(
            "chip-mixed",
            "64 engines of three kinds of squarers, and the photon memory, for one FPGA",
            6,
        ),
        DECISIONS,
        &[(TABLE, 24), (PRODUCT, 10)],
    ),
    with_memory(
        tile(
            "tile-6-mixed",
            "4 engines of three kinds of squarers, and the photon memory",
            2,
        ),
        DECISIONS,
        &[(TABLE, 2), (PRODUCT, 1)],
    ),
    with_memory(
        tile(
            "chip-lut",
            "32 engines and the photon memory for one FPGA, squarers from LUTs",
            5,
        ),
        DIGITS,
        &[],
    ),
];

/// The error of [`find_machine`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnknownMachine {
    /// No machine has that name.
    #[error(
        "there is no machine `{found}`{meant}; the machines are {expected}, or an organisation with a photon format, \
         such as stream-local7-rgb6d-n4096"
    )]
    Name {
        /// The name that was given.
        found: String,
        /// A hint with the nearest name, made by [`did_you_mean`]; empty where none is near.
        meant: String,
        /// The names of all named machines.
        expected: String,
    },
    /// The name is that of an organisation alone.
    #[error(
        "`{0}` is an organisation, and a machine is an organisation with a photon format, such as {0}-local7-rgb6d-n4096; `photoncube list` \
         has the named machines"
    )]
    Organisation(String),
    /// The name is that of a core, whose machine and chains are two options.
    #[error(
        "`core-{chains}-{machine}` is a core; commands for cores take it as --machine {machine} --chains {chains}"
    )]
    Core {
        /// The chains that the name has.
        chains: u32,
        /// The rest of the name.
        machine: String,
    },
    /// The name is that of a custom machine which cannot be made.
    #[error(transparent)]
    Custom(#[from] CustomError),
}

/// Finds the machine of that name: a named one, or a custom one.
///
/// # Errors
/// No machine has that name, and the error lists the names; or the custom machine cannot be made.
pub fn find_machine(name: &str) -> Result<&'static Machine, UnknownMachine> {
    if let Some(machine) = MACHINES.iter().find(|machine| machine.name == name) {
        return Ok(machine);
    }
    if let Some((chains, machine)) = parts_of_core(name) {
        let machine = machine.to_owned();
        return Err(UnknownMachine::Core { chains, machine });
    }
    if let Some(custom) = custom::find(name) {
        return Ok(custom?);
    }
    if CustomOrganisation::from_name(name).is_ok() {
        return Err(UnknownMachine::Organisation(name.to_owned()));
    }
    Err(UnknownMachine::Name {
        found: name.to_owned(),
        meant: did_you_mean(name, MACHINES.iter().map(|machine| machine.name)),
        expected: MACHINES
            .iter()
            .map(|machine| machine.name)
            .collect::<Vec<_>>()
            .join(", "),
    })
}

/// The number of chains and the machine in a core's name, such as `core-6-leaf-7-local7-rgb6d-n4096`.
pub fn parts_of_core(name: &str) -> Option<(u32, &str)> {
    let (chains, machine) = name.strip_prefix("core-")?.split_once('-')?;
    Some((chains.parse().ok()?, machine))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::Widths;
    use crate::leaf::Leaf;
    use crate::overlap;
    use crate::sequential::check_schedule;

    #[test]
    fn the_name_of_a_core_is_answered_with_its_options() {
        let message = find_machine("core-7-leaf-7-local7-rgb6d-n4096").unwrap_err();
        let options = "--machine leaf-7-local7-rgb6d-n4096 --chains 7";
        assert!(message.to_string().contains(options), "{message}");
        assert_eq!(parts_of_core("core-x-leaf-7"), None);
    }

    #[test]
    fn every_named_machine_runs_a_legal_program_in_a_frame_that_holds_it() {
        for machine in MACHINES {
            assert_eq!(find_machine(machine.name), Ok(machine));
            match &machine.organisation {
                Organisation::Sequential | Organisation::Programmed(_) => {
                    let program = machine.microprogram().unwrap();
                    let verdict = check_schedule(&program, machine.hypercube());
                    assert_eq!(verdict, Ok(()), "{}", machine.name);
                }
                Organisation::Overlapped => {
                    let program = machine.overlap_program().unwrap();
                    let verdict = overlap::check_program(&program);
                    assert_eq!(verdict, Ok(()), "{}", machine.name);
                }
                Organisation::Spatial(spatial)
                | Organisation::Leaf(Leaf { chain: spatial, .. }) => {
                    assert_eq!(spatial.check(machine), Ok(()), "{}", machine.name);
                }
            }
            assert_eq!(
                Numbers::FRAME_BLOCKS << machine.position_bits(),
                1 << Widths::of(machine).photon
            );
        }
    }

    #[test]
    fn an_unknown_machine_is_named_with_those_there_are() {
        let message = find_machine("pentium").unwrap_err().to_string();
        assert!(message.contains("`pentium`;") && message.contains("paper, paper-dsp"));
        let message = find_machine("papper").unwrap_err().to_string();
        let expected =
            "there is no machine `papper` (did you mean `paper`?); the machines are paper, ";
        assert!(message.starts_with(expected), "{message}");
    }
}
