//! The named machines. Each sets every field; nothing defaults.

use thiserror::Error;

use crate::format::Squarer;
use crate::hypercube::Hypercube;
use crate::microprogram::Microprogram;

/// A machine's configuration.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Machine {
    /// Its name on the command line and in the emitted Verilog.
    pub name: &'static str,
    /// What it is, in a line.
    pub summary: &'static str,
    /// Hypercube dimension; the machine has `2^dimension` cells.
    pub dimension: u32,
    /// Bits of a coordinate. The frame of a query is [`Self::FRAME_BLOCKS`] block edges wide.
    pub coordinate_bits: u32,
    /// Bits of a photon's power in one channel.
    pub power_bits: u32,
    /// The most photons that one query may be given; it sizes the sums.
    pub max_photons: u64,
    /// How `(A-B)^2` is built.
    pub squarer: Squarer,
}

impl Machine {
    /// Block edges that the coordinates span: the query's block, one on each side, and one that
    /// keeps the count a power of two.
    pub const FRAME_BLOCKS: u32 = 4;

    /// The machine's network.
    pub fn hypercube(&self) -> Hypercube {
        Hypercube::new(self.dimension)
    }

    /// The machine's program.
    pub fn microprogram(&self) -> Microprogram {
        Microprogram::all_reduce(self.hypercube())
    }

    /// Photons tested in one iteration.
    pub fn photons_per_iteration(&self) -> usize {
        self.hypercube().photons()
    }

    /// Fraction bits of a position in its block.
    pub fn position_bits(&self) -> u32 {
        self.coordinate_bits - Self::FRAME_BLOCKS.ilog2()
    }

    /// Bits of a stored photon: a position in its block and three powers.
    pub fn bits_per_photon(&self) -> u32 {
        3 * (self.position_bits() + self.power_bits)
    }

    /// Photon tests per clock, with no waiting.
    pub fn photon_tests_per_clock(&self) -> f64 {
        self.photons_per_iteration() as f64 / f64::from(self.microprogram().initiation_interval())
    }

    /// The machine's name as a Verilog identifier: the prefix of all its modules.
    pub fn module_prefix(&self) -> String {
        format!("photoncube_{}", self.name.replace('-', "_"))
    }
}

/// All named machines, the default first.
pub const MACHINES: &[Machine] = &[
    Machine {
        name: "paper",
        summary: "Ryu, Kim, Lee: 16 cells on a 4-D hypercube, squarers for LUTs",
        dimension: 4,
        coordinate_bits: 8,
        power_bits: 16,
        max_photons: 65_537,
        squarer: Squarer::Digits,
    },
    Machine {
        name: "paper-dsp",
        summary: "the same, squarers for DSP blocks",
        dimension: 4,
        coordinate_bits: 8,
        power_bits: 16,
        max_photons: 65_537,
        squarer: Squarer::Product,
    },
    Machine {
        name: "paper-12",
        summary: "the same with 12-bit coordinates",
        dimension: 4,
        coordinate_bits: 12,
        power_bits: 16,
        max_photons: 65_537,
        squarer: Squarer::Digits,
    },
    Machine {
        name: "paper-5d",
        summary: "32 cells on a 5-D hypercube: 8 photons an iteration",
        dimension: 5,
        coordinate_bits: 8,
        power_bits: 16,
        max_photons: 65_537,
        squarer: Squarer::Digits,
    },
];

/// No machine has that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no machine `{found}`; the machines are {expected}")]
pub struct UnknownMachine {
    /// The name asked for.
    pub found: String,
    /// The names there are.
    pub expected: String,
}

/// The machine of that name.
///
/// # Errors
/// No machine has that name; the error lists those there are.
pub fn find_machine(name: &str) -> Result<&'static Machine, UnknownMachine> {
    let found = MACHINES.iter().find(|machine| machine.name == name);
    found.ok_or_else(|| UnknownMachine {
        found: name.to_owned(),
        expected: MACHINES
            .iter()
            .map(|machine| machine.name)
            .collect::<Vec<_>>()
            .join(", "),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schedule::check_schedule;

    #[test]
    fn every_named_machine_runs_a_legal_program_in_a_frame_that_holds_it() {
        for machine in MACHINES {
            assert_eq!(find_machine(machine.name), Ok(machine));
            let verdict = check_schedule(&machine.microprogram(), machine.hypercube());
            assert_eq!(verdict, Ok(()), "{}", machine.name);
            assert_eq!(
                Machine::FRAME_BLOCKS << machine.position_bits(),
                1 << machine.coordinate_bits
            );
        }
    }

    #[test]
    fn an_unknown_machine_is_named_with_those_there_are() {
        let message = find_machine("pentium").unwrap_err().to_string();
        assert!(message.contains("`pentium`") && message.contains("paper, paper-dsp"));
    }
}
