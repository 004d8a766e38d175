//! Custom machines: an organisation with any photon format, made from a name.
//!
//! # Names
//! A custom machine's name states all of it: `ORGANISATION-FORMAT`, with the name of a photon format (see
//! [`PhotonFormat`]) and one of these organisations:
//!
//! - `sequential`: the paper's 16 cells;
//! - `stream`: one engine, each query with a radius of its own;
//! - `tile-D`: `2^(D - 4)` engines in a chain, D from 4 to 10, with the radius of the format;
//! - `stream-shallow`, `tile-D-shallow`: `stream` and `tile-D` with a [shallow](Pipeline::Shallow) pipeline;
//! - `tile-D-fine`: `tile-D` with a [fine](Pipeline::Fine) pipeline;
//! - `leaf-D`: the chain of `tile-D` behind a memory that skips the photons far from a batch of queries;
//! - `leaf-D-radii`: `leaf-D`, each query with a radius of its own.
//!
//! `stream-local6x2-rgb4d-n4096` is an example. Squares are made from digits where there is a squarer from digits for the
//! format, and as one product elsewhere. `tile-D-fine` also has engines with other squarers.

use std::collections::BTreeMap;
use std::sync::Mutex;

use thiserror::Error;

use crate::formats::{Numbers, PhotonFormat, Squarer, UnknownFormat, Widths, find_photon_format};
use crate::hypercube::Hypercube;
use crate::leaf::Leaf;
use crate::machine::Machine;
use crate::organisation::Organisation;
use crate::spatial::pipelines::{
    DIGITS, FINE, FINE_DECISIONS, FINE_TABLE, LEAF, LEAF_PRODUCT, LEAF_TABLE, PRODUCT, SHALLOW,
};
use crate::spatial::{Cuts, EngineKind, Radius, Spatial, SpatialError};

/// How many pipeline registers the engines of a custom machine have.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Pipeline {
    /// At most two adders stand between two registers, as an FPGA's LUTs have registers anyway.
    Deep,
    /// Two registers stand between a photon and its in-range flag, and one behind each sum: the least energy of a photon test in
    /// standard cells, where registers take most of it.
    Shallow,
    /// At most one adder or table stands between two registers: the shortest clock period on an FPGA. Of 64 engines, as many as an ECP5
    /// LFE5U-85F has blocks for take their squares from block RAMs and DSP blocks, whose own registers leave flip-flops for the others.
    Fine,
}

/// The organisation of a custom machine.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum CustomOrganisation {
    /// The paper's organisation on the 4-D hypercube.
    Sequential,
    /// One engine; each query has a radius of its own.
    Stream {
        /// The pipeline of the engine.
        pipeline: Pipeline,
    },
    /// A chain of engines on a hypercube of `dimension` dimensions; all queries have the format's radius.
    Tile {
        /// The dimension of the hypercube: `2^(dimension - 4)` engines.
        dimension: u32,
        /// The pipeline of an engine.
        pipeline: Pipeline,
    },
    /// The chain of a tile behind a memory of leaves, whose banks hold the photons of the format, see [`Leaf`].
    Leaf {
        /// The dimension of the hypercube: `2^(dimension - 4)` engines.
        dimension: u32,
        /// The source of the search radius.
        radius: Radius,
    },
}

/// The error of a custom machine.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CustomError {
    /// There is no such organisation.
    #[error(
        "there is no organisation `{0}` of custom machines; expected sequential, stream, stream-shallow, tile-4 to tile-10, tile-4-shallow to \
         tile-10-shallow, tile-4-fine to tile-10-fine, leaf-4 to leaf-10, or leaf-4-radii to leaf-10-radii"
    )]
    Organisation(String),
    /// The name of the format is not one.
    #[error(transparent)]
    Format(#[from] UnknownFormat),
    /// A spatial machine of that format cannot be built.
    #[error(transparent)]
    Spatial(#[from] SpatialError),
    /// The sums of a query are wider than the words that carry them.
    #[error(
        "machine `{machine}`: its sums have {bits} bits, expected at most 64; expected fewer photons (-n), a narrower \
         mantissa or a narrower exponent"
    )]
    Sums {
        /// The name of the machine.
        machine: String,
        /// Bits of a sum.
        bits: u32,
    },
}

impl CustomOrganisation {
    /// The organisation of that name.
    ///
    /// # Errors
    /// There is none; the error lists those there are.
    pub fn from_name(name: &str) -> Result<Self, CustomError> {
        let dimensions = Hypercube::MIN_DIMENSION..=Hypercube::MAX_DIMENSION;
        // The deep pipeline of a stream has at most one adder between two registers already.
        let streams = [Pipeline::Deep, Pipeline::Shallow];
        let streams = streams.map(|pipeline| Self::Stream { pipeline });
        let tiles = dimensions.clone().flat_map(|dimension| {
            [Pipeline::Deep, Pipeline::Shallow, Pipeline::Fine].map(|pipeline| Self::Tile {
                dimension,
                pipeline,
            })
        });
        let leaves = dimensions.flat_map(|dimension| {
            [Radius::Format, Radius::Query].map(|radius| Self::Leaf { dimension, radius })
        });
        let mut all = [Self::Sequential]
            .into_iter()
            .chain(streams)
            .chain(tiles)
            .chain(leaves);
        let found = all.find(|organisation| organisation.name() == name);
        found.ok_or_else(|| CustomError::Organisation(name.to_owned()))
    }

    /// The organisation's name in the names of machines.
    pub fn name(self) -> String {
        match self {
            Self::Sequential => "sequential".to_owned(),
            Self::Stream { pipeline } => format!("stream{}", pipeline.suffix()),
            Self::Tile {
                dimension,
                pipeline,
            } => format!("tile-{dimension}{}", pipeline.suffix()),
            Self::Leaf {
                dimension,
                radius: Radius::Format,
            } => format!("leaf-{dimension}"),
            Self::Leaf {
                dimension,
                radius: Radius::Query,
            } => format!("leaf-{dimension}-radii"),
        }
    }

    fn summary(self, format: &PhotonFormat) -> String {
        let cells = match self {
            Self::Sequential => "16 cells that do one instruction a clock".to_owned(),
            Self::Stream { pipeline } => format!(
                "one engine of 16 cells that keep their instructions{}",
                pipeline.summary()
            ),
            Self::Tile {
                dimension,
                pipeline,
            } => chain(dimension) + pipeline.summary(),
            Self::Leaf { dimension, radius } => {
                let radii = match radius {
                    Radius::Format => "",
                    Radius::Query => ", a radius for each query",
                };
                format!("{} behind a memory of leaves{radii}", chain(dimension))
            }
        };
        format!("{cells}, the photon format {}", format.name())
    }

    fn dimension(self) -> u32 {
        match self {
            Self::Sequential | Self::Stream { .. } => Hypercube::MIN_DIMENSION,
            Self::Tile { dimension, .. } | Self::Leaf { dimension, .. } => dimension,
        }
    }

    fn of_machine(self, squarer: Squarer, format: &PhotonFormat) -> Organisation {
        let is_product = squarer == Squarer::Product;
        let (radius, cuts, others) = match self {
            Self::Sequential => return Organisation::Sequential,
            Self::Stream { pipeline } => (Radius::Query, pipeline.cuts(FINE), NO_OTHERS),
            Self::Tile {
                dimension,
                pipeline: Pipeline::Fine,
            } if !is_product => (
                Radius::Format,
                FINE_DECISIONS,
                fine_blocks(dimension, format),
            ),
            Self::Tile { pipeline, .. } => {
                let deep = if is_product { PRODUCT.cuts } else { DIGITS };
                (Radius::Format, pipeline.cuts(deep), NO_OTHERS)
            }
            Self::Leaf { radius, .. } if is_product => (radius, LEAF_PRODUCT.cuts, NO_OTHERS),
            Self::Leaf { dimension, radius } => (radius, LEAF, leaf_blocks(dimension, format)),
        };
        let chain = Spatial {
            query_axes: self.dimension() - Hypercube::MIN_DIMENSION,
            radius,
            cuts,
            others,
            memory_groups: 0,
            paced: matches!(self, Self::Leaf { .. }),
        };
        match self {
            Self::Leaf { .. } => Organisation::Leaf(Leaf {
                chain,
                culler: LEAF_PRODUCT,
                bank_groups: Leaf::groups_for(format.max_photons),
            }),
            _ => Organisation::Spatial(chain),
        }
    }
}

impl Pipeline {
    /// What the name of a machine has behind its organisation.
    fn suffix(self) -> &'static str {
        match self {
            Self::Deep => "",
            Self::Shallow => "-shallow",
            Self::Fine => "-fine",
        }
    }

    fn summary(self) -> &'static str {
        match self {
            Self::Deep => "",
            Self::Shallow => ", few pipeline registers",
            Self::Fine => ", many pipeline registers",
        }
    }

    /// The pipeline registers of an engine, which has those of `deep` in a deep pipeline and in one that is as fine.
    fn cuts(self, deep: Cuts) -> Cuts {
        match self {
            Self::Deep | Self::Fine => deep,
            Self::Shallow => SHALLOW,
        }
    }
}

const NO_OTHERS: &[(EngineKind, usize)] = &[];

/// The most bits per radius for which the table of a difference's squares fits one block RAM: with 8 a difference has 11 bits.
const RADIUS_BITS_OF_TABLES: u32 = 7;

/// The engines of a leaf machine whose squares come from DSP blocks and from block RAMs: of 8 engines one each. An LFE5U-85F has
/// 156 DSP blocks and 208 block RAMs (Lattice, FPGA-DS-02012). With the comparison of boxes, six chains of eight engines have 144
/// and 204 of these, where a bank holds 4096 photons.
fn leaf_blocks(dimension: u32, format: &PhotonFormat) -> &'static [(EngineKind, usize)] {
    let engines: usize = 1 << (dimension - Hypercube::MIN_DIMENSION);
    let products = if engines > 1 { engines.div_ceil(8) } else { 0 };
    let tables = match format.radius_bits() <= RADIUS_BITS_OF_TABLES {
        true if engines > 2 => engines.div_ceil(8),
        _ => 0,
    };
    vec![(LEAF_PRODUCT, products), (LEAF_TABLE, tables)].leak()
}

/// Engines of a fine pipeline whose squares come from block RAMs and DSP blocks. Of 64 engines these are as many as an LFE5U-85F has blocks for,
/// and of fewer engines as large a part of them. It has 208 block RAMs, of which an engine takes 6 where the table of a difference fits one, and
/// the queue of results up to 4; and 156 DSP blocks, of which an engine takes 12 (Lattice, FPGA-DS-02012).
fn fine_blocks(dimension: u32, format: &PhotonFormat) -> &'static [(EngineKind, usize)] {
    const TABLES: usize = (208 - 4) / 6;
    const PRODUCTS: usize = 156 / 12;
    const ALL: usize = 1 << (Hypercube::MAX_DIMENSION - Hypercube::MIN_DIMENSION);
    let engines = 1 << (dimension - Hypercube::MIN_DIMENSION);
    let tables = match format.radius_bits() <= RADIUS_BITS_OF_TABLES {
        true => engines * TABLES / ALL,
        false => 0,
    };
    let products = (engines * PRODUCTS + ALL / 2) / ALL;
    vec![(FINE_TABLE, tables), (PRODUCT, products)].leak()
}

fn chain(dimension: u32) -> String {
    match 1 << (dimension - Hypercube::MIN_DIMENSION) {
        1 => "one engine".to_owned(),
        engines => format!("{engines} engines in a chain"),
    }
}

/// The custom machines that were asked for. A machine's parts are `'static`, so each is made once and kept.
static MADE: Mutex<BTreeMap<String, &'static Machine>> = Mutex::new(BTreeMap::new());

/// The machine of an organisation and a format. Equal arguments give the same machine.
///
/// # Errors
/// No machine can be built from them; the error says what could.
pub fn custom_machine(
    organisation: CustomOrganisation,
    format: &PhotonFormat,
) -> Result<&'static Machine, CustomError> {
    format.check().map_err(UnknownFormat::from)?;
    let name = format!("{}-{}", organisation.name(), format.name());
    let mut made = MADE
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    if let Some(machine) = made.get(&name) {
        return Ok(machine);
    }
    let machine = Machine {
        name: name.clone().leak(),
        summary: organisation.summary(format).leak(),
        organisation: organisation.of_machine(Squarer::Digits, format),
        dimension: organisation.dimension(),
        numbers: Numbers::Local(*format),
        squarer: Squarer::Digits,
    };
    let machine = checked(machine).or_else(|_| {
        checked(Machine {
            organisation: organisation.of_machine(Squarer::Product, format),
            squarer: Squarer::Product,
            ..machine
        })
    })?;
    let machine: &'static Machine = Box::leak(Box::new(machine));
    made.insert(name, machine);
    Ok(machine)
}

fn checked(machine: Machine) -> Result<Machine, CustomError> {
    if let Some(spatial) = machine.spatial() {
        spatial.check(&machine)?;
    }
    let bits = Widths::of(&machine).sum;
    match bits <= u64::BITS {
        true => Ok(machine),
        false => Err(CustomError::Sums {
            machine: machine.name.to_owned(),
            bits,
        }),
    }
}

/// The custom machine of a name; `None` where the name is not built as that of a custom machine.
pub(crate) fn find(name: &str) -> Option<Result<&'static Machine, CustomError>> {
    let (organisation, _) = name.split_once("-local")?;
    let format = &name[organisation.len() + 1..];
    let found = || {
        custom_machine(
            CustomOrganisation::from_name(organisation)?,
            &find_photon_format(format)?,
        )
    };
    Some(found())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::find_machine;

    #[test]
    fn a_name_states_the_machine() {
        for name in [
            "sequential-local6x2-rgb4d-n4096",
            "stream-local12x2-rgb16e4-n4096",
            "tile-4-local7-rgb6d-n4096",
            "tile-10-local4-mono1-n8",
            "stream-shallow-local6x2-rgb4d-n4096",
            "tile-5-shallow-local7-rgb6d-n4096",
            "tile-5-fine-local7-rgb6d-n4096",
            "leaf-7-local7-rgb6d-n4096",
            "leaf-7-radii-local7-rgb6d-n4096",
        ] {
            let machine = find_machine(name).unwrap();
            assert_eq!(machine.name, name);
            assert!(std::ptr::eq(machine, find_machine(name).unwrap()));
        }
    }

    #[test]
    fn a_tile_of_the_named_tiles_format_is_a_named_tile() {
        let named = find_machine("tile-6").unwrap();
        let custom = find_machine("tile-6-local7-rgb6d-n4096").unwrap();
        let renamed = Machine {
            name: named.name,
            summary: named.summary,
            ..*custom
        };
        assert_eq!(renamed, *named);
    }

    #[test]
    fn a_shallow_machine_has_other_pipeline_registers_and_nothing_else() {
        for (deep, shallow, stages) in [
            (
                "stream-local8-rgb8d-n16384",
                "stream-shallow-local8-rgb8d-n16384",
                [8, 2],
            ),
            (
                "tile-6-local7-rgb6d-n4096",
                "tile-6-shallow-local7-rgb6d-n4096",
                [6, 2],
            ),
        ] {
            let [deep, shallow] = [deep, shallow].map(|name| find_machine(name).unwrap());
            let [of_deep, of_shallow] = [deep, shallow].map(|machine| *machine.spatial().unwrap());
            assert_eq!([of_deep, of_shallow].map(|of| of.latency()), stages);
            let chain = Spatial {
                cuts: of_deep.cuts,
                ..of_shallow
            };
            let without = Machine {
                name: deep.name,
                summary: deep.summary,
                organisation: Organisation::Spatial(chain),
                ..*shallow
            };
            assert_eq!(without, *deep);
        }
    }

    #[test]
    fn a_fine_machine_has_the_squarers_that_a_device_has_blocks_for() {
        for (name, squarers) in [
            ("tile-4-fine-local7-rgb6d-n4096", [1, 0, 0]),
            ("tile-6-fine-local7-rgb6d-n4096", [1, 2, 1]),
            ("tile-10-fine-local7-mono1-n8192", [17, 34, 13]),
            ("tile-10-fine-local8-mono1-n8192", [51, 0, 13]),
            ("tile-10-fine-local7x1-mono1-n8192", [0, 0, 64]),
        ] {
            let machine = find_machine(name).unwrap();
            let spatial = machine.spatial().unwrap();
            let kinds = (0..spatial.engines()).map(|engine| spatial.kind(machine.squarer, engine));
            let kinds: Vec<_> = kinds.map(|kind| kind.squarer).collect();
            let found = [Squarer::Digits, Squarer::Table, Squarer::Product]
                .map(|squarer| kinds.iter().filter(|&&kind| kind == squarer).count());
            assert_eq!(found, squarers, "{name}");
            assert_eq!(spatial.latency(), 10, "{name}");
        }
    }

    #[test]
    fn a_leaf_machine_with_radii_has_another_radius_and_nothing_else() {
        let fixed = find_machine("leaf-6-local7-rgb6d-n4096").unwrap();
        let radii = find_machine("leaf-6-radii-local7-rgb6d-n4096").unwrap();
        let leaf = *radii.leaf().unwrap();
        assert_eq!(leaf.chain.radius, Radius::Query);
        let chain = Spatial {
            radius: Radius::Format,
            ..leaf.chain
        };
        let without = Machine {
            name: fixed.name,
            summary: fixed.summary,
            organisation: Organisation::Leaf(Leaf { chain, ..leaf }),
            ..*radii
        };
        assert_eq!(without, *fixed);
    }

    #[test]
    fn squares_are_one_product_where_there_are_no_digits_for_them() {
        let squarer = |name| find_machine(name).unwrap().squarer;
        assert_eq!(squarer("stream-local7-rgb6d-n4096"), Squarer::Digits);
        assert_eq!(squarer("stream-local6x2-rgb6d-n4096"), Squarer::Product);
        assert_eq!(squarer("sequential-local6x2-rgb6d-n4096"), Squarer::Digits);
    }

    #[test]
    fn what_cannot_be_made_is_refused_with_what_could() {
        for (name, expected) in [
            ("tiles-4-local7-rgb6d", "no organisation `tiles-4`"),
            ("tile-11-local7-rgb6d", "tile-4 to tile-10, tile-4-shallow"),
            ("stream-fine-local8-rgb8d", "no organisation `stream-fine`"),
            (
                "leaf-7-shallow-local7-rgb6d",
                "no organisation `leaf-7-shallow`",
            ),
            (
                "stream-local3-rgb6d",
                "position_bits is 3, expected 4 to 12",
            ),
            ("stream-local7-rgb", "there is no format `local7-rgb`"),
            (
                "leaf-7-local7-rgb6d",
                "groups of a bank is 262144, expected 8 to 65536",
            ),
            (
                "stream-local7-rgb16e8-n4294967296",
                "bits of a sum is 72, expected 1 to 64",
            ),
            (
                "sequential-local7-rgb16e8-n4294967296",
                "sums have 72 bits, expected at most 64",
            ),
        ] {
            let error = find_machine(name).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
    }
}
