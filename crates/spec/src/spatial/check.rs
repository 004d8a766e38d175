//! The rules that a spatial machine must satisfy so that its engines can be built.

use thiserror::Error;

use super::{Cut, EngineKind, Spatial};
use crate::formats::{FormatError, PhotonFormat, Squarer, Widths};
use crate::hypercube::Hypercube;
use crate::leaf::Leaf;
use crate::machine::Machine;

/// The reason why a spatial machine cannot be built.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SpatialError {
    /// A field is outside its legal range.
    #[error("machine `{machine}`: {field} is {found}, expected {min} to {max}")]
    Field {
        /// The name of the machine.
        machine: &'static str,
        /// The name of the field that is out of range.
        field: &'static str,
        /// The field's value.
        found: u64,
        /// The smallest legal value.
        min: u64,
        /// The largest legal value.
        max: u64,
    },
    /// A required pipeline register is missing.
    #[error("machine `{machine}`: there is no register at the cut {cut:?}, which {needed_by}")]
    Cut {
        /// The name of the machine.
        machine: &'static str,
        /// The place where the register is missing.
        cut: Cut,
        /// The part of the machine that needs the register.
        needed_by: &'static str,
    },
    /// Engines of different kinds differ at or after `RangeDelay`, where all engines must have the same
    /// pipeline registers.
    #[error(
        "machine `{machine}`: engines with other squarers have {} at the cut {cut:?}, expected {}, \
         as the machine's own have from the decisions on",
        register(*.has), register(!*.has)
    )]
    SharedCut {
        /// The name of the machine.
        machine: &'static str,
        /// The place where the kinds differ.
        cut: Cut,
        /// Whether the engines with other squarers have a register there.
        has: bool,
    },
    /// The machine has plain numbers, which have no radius bits to reduce differences to.
    #[error("machine `{0}` has plain numbers, and an engine needs a photon format")]
    PlainNumbers(&'static str),
    /// The photon format is not legal.
    #[error("machine `{machine}`: {error}")]
    Format {
        /// The name of the machine.
        machine: &'static str,
        /// The rule that the format violates.
        error: FormatError,
    },
}

fn register(has: bool) -> &'static str {
    if has { "a register" } else { "no register" }
}

impl Spatial {
    /// The bits per radius that the squarers from digits and from tables are made for.
    const RADIUS_BITS: [u64; 2] = [7, 8];

    /// The most groups of a memory bank: more than the block RAMs of a large FPGA hold.
    const MOST_MEMORY_GROUPS: u64 = 1 << 16;

    /// Checks that the engines of a machine with this organisation can be built.
    ///
    /// # Errors
    /// The first field outside its range, with the range, or the first required pipeline register that is
    /// missing.
    pub fn check(&self, machine: &Machine) -> Result<(), SpatialError> {
        let name = machine.name;
        let format = machine.format().ok_or(SpatialError::PlainNumbers(name))?;
        format.check().map_err(|error| SpatialError::Format {
            machine: name,
            error,
        })?;
        let most_axes = Hypercube::MAX_DIMENSION - Hypercube::MIN_DIMENSION;
        self.check_fields(
            name,
            [("query_axes", self.query_axes, [0, most_axes.into()])],
        )?;
        for engine in 0..self.engines() {
            self.check_squarer(name, format, self.kind(machine.squarer, engine).squarer)?;
        }
        if let Some(leaf) = machine.leaf() {
            self.check_squarer(name, format, leaf.culler.squarer)?;
            Self::check_needed_cuts(machine, leaf.culler)?;
        }
        let dimension = u64::from(Hypercube::MIN_DIMENSION + self.query_axes);
        let other_squarers: usize = self.others.iter().map(|&(_, engines)| engines).sum();
        self.check_fields(
            name,
            [
                ("dimension", machine.dimension, [dimension; 2]),
                // The model holds sums in 64 bits.
                ("bits of a sum", Widths::of(machine).sum, [1, 64]),
                (
                    "engines with squarers of other kinds",
                    u32::try_from(other_squarers).unwrap_or(u32::MAX),
                    [0, self.engines() as u64],
                ),
            ],
        )?;
        self.check_memory(machine)?;
        self.check_cuts(machine)
    }

    /// Checks that a squarer of that kind can be made for the format. One product is as wide as it needs to be.
    fn check_squarer(
        &self,
        machine: &'static str,
        format: &PhotonFormat,
        squarer: Squarer,
    ) -> Result<(), SpatialError> {
        if squarer == Squarer::Product {
            return Ok(());
        }
        self.check_fields(
            machine,
            [
                // Half squares would need other digits and other tables.
                ("query_extra_bits", format.query_extra_bits, [0, 0]),
                ("radius bits", format.radius_bits(), Self::RADIUS_BITS),
            ],
        )
    }

    /// Checks that a memory bank holds `max_photons`. A set of photons is no larger than that, so it fits the
    /// bank.
    fn check_memory(&self, machine: &Machine) -> Result<(), SpatialError> {
        if let Some(leaf) = machine.leaf() {
            let limits = [Leaf::FEWEST_GROUPS.into(), Self::MOST_MEMORY_GROUPS];
            return self.check_fields(
                machine.name,
                [("groups of a bank", leaf.bank_groups, limits)],
            );
        }
        let found = self.memory_groups;
        let needed = machine.max_photons().div_ceil(Self::LANES as u64);
        if found == 0 || (found.is_power_of_two() && u64::from(found) >= needed) {
            return Ok(());
        }
        Err(SpatialError::Field {
            machine: machine.name,
            field: "memory_groups, a power of two,",
            found: found.into(),
            min: needed,
            max: Self::MOST_MEMORY_GROUPS,
        })
    }

    fn check_fields<const N: usize>(
        &self,
        machine: &'static str,
        fields: [(&'static str, u32, [u64; 2]); N],
    ) -> Result<(), SpatialError> {
        for (field, found, [min, max]) in fields {
            let found = u64::from(found);
            if !(min..=max).contains(&found) {
                return Err(SpatialError::Field {
                    machine,
                    field,
                    found,
                    min,
                    max,
                });
            }
        }
        Ok(())
    }

    fn check_cuts(&self, machine: &Machine) -> Result<(), SpatialError> {
        let mut kinds = (0..self.engines()).map(|engine| self.kind(machine.squarer, engine));
        kinds.try_for_each(|kind| {
            self.check_shared_cuts(machine, kind)?;
            Self::check_needed_cuts(machine, kind)
        })
    }

    fn check_shared_cuts(&self, machine: &Machine, kind: EngineKind) -> Result<(), SpatialError> {
        let mut shared = Cut::ALL.into_iter().filter(|&cut| cut >= Cut::RangeDelay);
        match shared.find(|&cut| kind.cuts.has(cut) != self.cuts.has(cut)) {
            None => Ok(()),
            Some(cut) => Err(SpatialError::SharedCut {
                machine: machine.name,
                cut,
                has: kind.cuts.has(cut),
            }),
        }
    }

    fn check_needed_cuts(machine: &Machine, kind: EngineKind) -> Result<(), SpatialError> {
        let needed = [
            (
                Cut::Range,
                true,
                "the decision needs beside the power hop's register",
            ),
            (
                Cut::Cross,
                kind.squarer == Squarer::Table,
                "a table needs, as a block RAM has one",
            ),
            (
                Cut::GroupPower,
                kind.cuts.has(Cut::Decision),
                "the flags need that stand beside each sum, as the decisions do",
            ),
            (
                Cut::Decision,
                kind.cuts.has(Cut::RangeDelay),
                "the register RangeDelay needs, which is on the way there",
            ),
            (
                Cut::PairPower,
                kind.cuts.has(Cut::RangeDelay),
                "the flags need that are on their ways to the sums with RangeDelay",
            ),
        ];
        let missing = |&(cut, needed, _): &(Cut, bool, _)| needed && !kind.cuts.has(cut);
        match needed.into_iter().find(missing) {
            None => Ok(()),
            Some((cut, _, needed_by)) => Err(SpatialError::Cut {
                machine: machine.name,
                cut,
                needed_by,
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::{Numbers, PlainFormat};
    use crate::machines::{MACHINES, find_machine};
    use crate::organisation::Organisation;
    use crate::spatial::Cuts;

    #[test]
    fn every_named_spatial_machine_is_legal() {
        let mut checked = 0;
        for machine in MACHINES {
            if let Some(spatial) = machine.spatial() {
                assert_eq!(spatial.check(machine), Ok(()));
                checked += 1;
            }
        }
        assert!(checked > 0);
    }

    fn message(machine: Machine) -> String {
        let spatial = machine.spatial().expect("a spatial machine");
        spatial.check(&machine).unwrap_err().to_string()
    }

    #[test]
    fn what_cannot_be_built_is_refused_with_what_could_be() {
        let machine = *find_machine("tile-5").unwrap();
        let (spatial, format) = (*machine.spatial().unwrap(), *machine.format().unwrap());
        let with_spatial = |spatial| Machine {
            organisation: Organisation::Spatial(spatial),
            ..machine
        };
        let with_format = |format| Machine {
            numbers: Numbers::Local(format),
            ..machine
        };
        let plain = Numbers::Plain(PlainFormat {
            coordinate_bits: 8,
            power_bits: 16,
            max_photons: 1,
        });
        const fn kind(squarer: Squarer, cuts: &[Cut]) -> EngineKind {
            let cuts = Cuts::of(cuts);
            EngineKind { squarer, cuts }
        }
        const ENOUGH: &[Cut] = &[
            Cut::Magnitude,
            Cut::Products,
            Cut::Cross,
            Cut::Pair,
            Cut::Distance,
            Cut::Range,
            Cut::PairPower,
            Cut::GroupPower,
        ];
        const THREE: &[(EngineKind, usize)] = &[
            (kind(Squarer::Table, ENOUGH), 1),
            (kind(Squarer::Product, ENOUGH), 2),
        ];
        const NO_LOOKUP: &[(EngineKind, usize)] = &[(
            kind(
                Squarer::Table,
                &[
                    Cut::Difference,
                    Cut::Magnitude,
                    Cut::Products,
                    Cut::Pair,
                    Cut::Distance,
                    Cut::Range,
                    Cut::PairPower,
                    Cut::GroupPower,
                ],
            ),
            1,
        )];
        const NO_SUM: &[(EngineKind, usize)] =
            &[(kind(Squarer::Product, &[Cut::Range, Cut::PairPower]), 1)];
        const MORE_SUMS: &[(EngineKind, usize)] = &[(
            kind(
                Squarer::Product,
                &[Cut::Gate, Cut::Range, Cut::PairPower, Cut::GroupPower],
            ),
            1,
        )];
        let others = |others| with_spatial(Spatial { others, ..spatial });
        #[rustfmt::skip]
        let wrong = [
            (with_format(PhotonFormat { query_extra_bits: 1, ..format }), "query_extra_bits is 1, expected 0 to 0"),
            (with_format(PhotonFormat { position_bits: 6, ..format }), "radius bits is 6, expected 7 to 8"),
            (with_format(PhotonFormat { position_bits: 9, ..format }), "radius bits is 9, expected 7 to 8"),
            (with_format(PhotonFormat { position_bits: 3, ..format }), "position_bits is 3, expected 4 to 12"),
            (with_spatial(Spatial { memory_groups: 1, ..spatial }), "memory_groups, a power of two, is 1, expected 1024 to 65536"),
            (with_spatial(Spatial { query_axes: 64, ..spatial }), "query_axes is 64, expected 0 to 6"),
            (with_spatial(Spatial { query_axes: 2, ..spatial }), "dimension is 5, expected 6 to 6"),
            (others(THREE), "squarers of other kinds is 3, expected 0 to 2"),
            (with_spatial(Spatial { cuts: Cuts::of(&[Cut::Products]), ..spatial }), "the cut Range, which the decision needs beside the power hop's register"),
            (others(NO_LOOKUP), "the cut Cross, which a table needs, as a block RAM has one"),
            (with_spatial(Spatial { cuts: Cuts::of(&[Cut::Range, Cut::Decision]), ..spatial }), "the cut GroupPower, which the flags need that stand beside each sum, as the decisions do"),
            (with_spatial(Spatial { cuts: Cuts::of(&[Cut::Range, Cut::RangeDelay]), ..spatial }), "the cut Decision, which the register RangeDelay needs, which is on the way there"),
            (with_spatial(Spatial { cuts: Cuts::of(&[Cut::Range, Cut::RangeDelay, Cut::Decision, Cut::GroupPower]), ..spatial }), "the cut PairPower, which the flags need that are on their ways to the sums with RangeDelay"),
            (others(NO_SUM), "no register at the cut GroupPower, expected a register, as the machine's own have from the decisions on"),
            (others(MORE_SUMS), "a register at the cut Gate, expected no register, as the machine's own have from the decisions on"),
            (Machine { numbers: plain, ..machine }, "`tile-5` has plain numbers, and an engine needs a photon format"),
        ];
        for (machine, expected) in wrong {
            let found = message(machine);
            assert!(found.ends_with(expected), "{found}");
        }
    }
}
