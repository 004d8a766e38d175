//! The configuration of a machine and the figures that follow from it. `machines` has the table of named
//! machines.

use crate::cell::{CellTables, OVERLAPPED, SEQUENTIAL};
use crate::formats::{Channels, Numbers, PhotonFormat, PlainFormat, Squarer};
use crate::hypercube::Hypercube;
use crate::leaf::Leaf;
use crate::organisation::{Organisation, Rate};
use crate::overlap;
use crate::sequential::{Microprogram, OwnProgram};
use crate::spatial::{Radius, Spatial};

/// A machine's configuration.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Machine {
    /// The machine's name on the command line and in the emitted Verilog; that of a custom machine states all of it.
    pub name: &'static str,
    /// A description of the machine in one line, for listings and headers.
    pub summary: &'static str,
    /// How the work is laid out over cells and clocks.
    pub organisation: Organisation,
    /// Hypercube dimension; the machine has `2^dimension` cells.
    pub dimension: u32,
    /// The number format of the words on the streams.
    pub numbers: Numbers,
    /// The implementation of the square; in a spatial machine, that of engines not in [`Spatial::others`].
    pub squarer: Squarer,
}

impl Machine {
    /// The machine's network.
    pub fn hypercube(&self) -> Hypercube {
        Hypercube::new(self.dimension)
    }

    /// The tables of the machine's cells; `None` for a spatial machine, whose engines have no program.
    pub fn cell(&self) -> Option<&'static CellTables> {
        match &self.organisation {
            Organisation::Sequential | Organisation::Programmed(_) => Some(&SEQUENTIAL),
            Organisation::Overlapped => Some(&OVERLAPPED),
            Organisation::Spatial(_) | Organisation::Leaf(_) => None,
        }
    }

    /// The microprogram of a sequential machine, which does one op a clock; `None` for other organisations.
    pub fn microprogram(&self) -> Option<Microprogram> {
        match &self.organisation {
            Organisation::Sequential => Some(Microprogram::all_reduce(self.hypercube())),
            Organisation::Programmed(program) => Some(program.microprogram()),
            Organisation::Overlapped | Organisation::Spatial(_) | Organisation::Leaf(_) => None,
        }
    }

    /// Parts the machine's own name from that of a user's program, in the name of a machine that runs it.
    pub const WITH_PROGRAM: &str = "-program-";

    /// The sequential machine whose control store has this program in place of the machine's own.
    pub fn with_program(&self, program: OwnProgram) -> Self {
        Self {
            organisation: Organisation::Programmed(program),
            ..*self
        }
    }

    /// The program of an overlapped machine, whose units work at the same time; `None` for other
    /// organisations. Each call runs the scheduler.
    ///
    /// # Panics
    /// Where the scheduler finds no program. A test holds that it finds one.
    pub fn overlap_program(&self) -> Option<overlap::Program> {
        (self.organisation == Organisation::Overlapped)
            .then(|| overlap::Program::rotated().expect("the scheduler finds a program"))
    }

    /// The parameters of a spatial machine beside its numbers, or those of a leaf machine's chain; `None` for other
    /// organisations.
    pub fn spatial(&self) -> Option<&Spatial> {
        match &self.organisation {
            Organisation::Spatial(spatial) => Some(spatial),
            Organisation::Leaf(leaf) => Some(&leaf.chain),
            Organisation::Sequential | Organisation::Programmed(_) | Organisation::Overlapped => {
                None
            }
        }
    }

    /// The parameters of a leaf machine beside its numbers; `None` for other organisations.
    pub fn leaf(&self) -> Option<&Leaf> {
        match &self.organisation {
            Organisation::Leaf(leaf) => Some(leaf),
            _ => None,
        }
    }

    /// Whether the machine reads in sets of photons and keeps them for several batches: in a photon memory or in leaves.
    pub fn keeps_sets(&self) -> bool {
        self.bank_groups().is_some()
    }

    /// Groups of a set at most, in a machine that keeps sets; `None` in others.
    pub fn bank_groups(&self) -> Option<u32> {
        match (self.leaf(), self.spatial()) {
            (Some(leaf), _) => Some(leaf.bank_groups),
            (None, Some(spatial)) if spatial.memory_groups > 0 => Some(spatial.memory_groups),
            _ => None,
        }
    }

    /// Whether a photon memory stands between the group stream and the engines.
    pub fn has_memory(&self) -> bool {
        self.spatial()
            .is_some_and(|spatial| spatial.memory_groups > 0)
    }

    /// Whether a stored photon has an exponent beside its mantissas.
    pub fn has_exponent(&self) -> bool {
        self.numbers.power().exponent_range() > 0
    }

    /// The photons of one iteration, which is the number of lanes of a group.
    pub fn photons_per_iteration(&self) -> usize {
        match self.spatial() {
            Some(_) => Spatial::LANES,
            None => self.hypercube().photons(),
        }
    }

    /// The number of queries that are tested against every photon at once.
    pub fn queries_at_once(&self) -> usize {
        self.spatial().map_or(1, Spatial::engines)
    }

    /// The number of groups that the machine takes per clock in the steady state.
    pub fn rate(&self) -> Rate {
        if let Some(program) = self.overlap_program() {
            return Rate {
                groups: program.groups as u32,
                clocks: program.interval,
            };
        }
        let clocks = self
            .microprogram()
            .map_or(1, |program| program.initiation_interval());
        Rate { groups: 1, clocks }
    }

    /// The machine's photon format; `None` in plain numbers.
    pub fn format(&self) -> Option<&PhotonFormat> {
        self.numbers.format()
    }

    /// The machine's plain format; `None` where it has a photon format.
    pub fn plain(&self) -> Option<&PlainFormat> {
        match &self.numbers {
            Numbers::Plain(format) => Some(format),
            Numbers::Local(_) => None,
        }
    }

    /// Fraction bits of a photon's position in its block.
    pub fn position_bits(&self) -> u32 {
        self.numbers.position_bits()
    }

    /// The squared search radius of all queries in square steps, where the machine fixes it; `None` where
    /// each query has its own.
    pub fn fixed_radius_sq(&self) -> Option<u32> {
        let fixed = self.spatial().is_some_and(|s| s.radius == Radius::Format);
        self.format()
            .filter(|_| fixed)
            .map(PhotonFormat::largest_in_range)
    }

    /// The most photons that one query may be given.
    pub fn max_photons(&self) -> u64 {
        self.numbers.max_photons()
    }

    /// The channels of a photon's power.
    pub fn channels(&self) -> Channels {
        self.numbers.power().channels
    }

    /// The largest decoded power: a mantissa of all ones at the largest exponent.
    pub fn full_scale(&self) -> u128 {
        self.numbers.power().full_scale()
    }

    /// Bits of a stored photon: a position in its block, its mantissas and its exponent.
    pub fn bits_per_photon(&self) -> u32 {
        self.numbers.bits_per_photon()
    }

    /// Photon tests per clock while no stream waits.
    pub fn photon_tests_per_clock(&self) -> f64 {
        let tests = self.photons_per_iteration() * self.queries_at_once();
        tests as f64 / self.rate().interval()
    }

    /// The prefix of all Verilog modules of the machine: the machine's name as an identifier.
    pub fn module_prefix(&self) -> String {
        module_prefix(self.name)
    }
}

/// The Verilog identifier of a design: `photoncube_` and its name, with `_` for `-`.
pub fn module_prefix(design: &str) -> String {
    format!("photoncube_{}", design.replace('-', "_"))
}
