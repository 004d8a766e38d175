//! The table of named photon formats. Each sets every field; nothing defaults.

use thiserror::Error;

use crate::photon_format::{PhotonFormat, PowerFormat};

/// 8-bit mantissas and an 8-bit exponent: Ward, "Real pixels" (Graphics Gems II, 1991).
const RGBE8: PowerFormat = shared(8, 8);
/// 9-bit mantissas and a 5-bit exponent: EXT_texture_shared_exponent.
const RGB9E5: PowerFormat = shared(9, 5);
/// RGBE8 in the exponents that a range of 24 needs.
const RGB8E5: PowerFormat = shared(8, 5);

/// 2^24 is over 1e7: a photon of a millionth of the map's largest keeps a full mantissa.
const EXPONENT_RANGE: u32 = 24;

/// Four times the quarter million in one block that the hard cases ask for.
const MAX_PHOTONS: u64 = 1 << 20;

const fn shared(mantissa_bits: u32, exponent_bits: u32) -> PowerFormat {
    PowerFormat::SharedExponent {
        mantissa_bits,
        exponent_bits,
    }
}

const fn linear(mantissa_bits: u32) -> PowerFormat {
    PowerFormat::BlockLinear { mantissa_bits }
}

/// All named formats, the default first. `localPxX`: P fraction bits of a block edge, X further
/// ones for query points.
pub const PHOTON_FORMATS: &[PhotonFormat] = &[
    PhotonFormat {
        name: "local8-rgbe8",
        summary: "the default: 8 bits per radius, RGBE8",
        position_bits: 8,
        query_extra_bits: 0,
        radius_bits: 8,
        power: RGBE8,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local4-rgbe8",
        summary: "4 bits per radius: the coarsest there is",
        position_bits: 4,
        query_extra_bits: 0,
        radius_bits: 4,
        power: RGBE8,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local6-rgbe8",
        summary: "6 bits per radius, as the paper's 8-bit coordinates have",
        position_bits: 6,
        query_extra_bits: 0,
        radius_bits: 6,
        power: RGBE8,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local7-rgbe8",
        summary: "7 bits per radius",
        position_bits: 7,
        query_extra_bits: 0,
        radius_bits: 7,
        power: RGBE8,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local10-rgbe8",
        summary: "10 bits per radius",
        position_bits: 10,
        query_extra_bits: 0,
        radius_bits: 10,
        power: RGBE8,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local12-rgbe8",
        summary: "12 bits per radius: the finest there is",
        position_bits: 12,
        query_extra_bits: 0,
        radius_bits: 12,
        power: RGBE8,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local8-rgb9e5",
        summary: "8 bits per radius, RGB9E5",
        position_bits: 8,
        query_extra_bits: 0,
        radius_bits: 8,
        power: RGB9E5,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local8-linear8",
        summary: "8 bits per radius, 8-bit power, a block's exponent",
        position_bits: 8,
        query_extra_bits: 0,
        radius_bits: 8,
        power: linear(8),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local8-linear10",
        summary: "8 bits per radius, 10-bit power, a block's exponent",
        position_bits: 8,
        query_extra_bits: 0,
        radius_bits: 8,
        power: linear(10),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local8-linear12",
        summary: "8 bits per radius, 12-bit power, a block's exponent",
        position_bits: 8,
        query_extra_bits: 0,
        radius_bits: 8,
        power: linear(12),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local8-linear16",
        summary: "8 bits per radius, 16-bit power, a block's exponent",
        position_bits: 8,
        query_extra_bits: 0,
        radius_bits: 8,
        power: linear(16),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local8-rgb8e5",
        summary: "the default without the exponent bits that its range never uses",
        position_bits: 8,
        query_extra_bits: 0,
        radius_bits: 8,
        power: RGB8E5,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local7x1-rgb8e5",
        summary: "7 bits per radius, queries on half steps",
        position_bits: 7,
        query_extra_bits: 1,
        radius_bits: 8,
        power: RGB8E5,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local6x2-rgb8e5",
        summary: "6 bits per radius, queries on quarter steps",
        position_bits: 6,
        query_extra_bits: 2,
        radius_bits: 8,
        power: RGB8E5,
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local7x1-linear8",
        summary: "7 bits per radius, queries on half steps, a block's exponent",
        position_bits: 7,
        query_extra_bits: 1,
        radius_bits: 8,
        power: linear(8),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local6x2-linear8",
        summary: "6 bits per radius, queries on quarter steps, a block's exponent",
        position_bits: 6,
        query_extra_bits: 2,
        radius_bits: 8,
        power: linear(8),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local8x1-linear6",
        summary: "8 bits per radius, queries on half steps, 6-bit power, a block's exponent",
        position_bits: 8,
        query_extra_bits: 1,
        radius_bits: 9,
        power: linear(6),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local7x1-linear6",
        summary: "7 bits per radius, queries on half steps, 6-bit power, a block's exponent",
        position_bits: 7,
        query_extra_bits: 1,
        radius_bits: 8,
        power: linear(6),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local7x1-rgb6e5",
        summary: "7 bits per radius, queries on half steps, 6-bit mantissas, 5-bit exponent",
        position_bits: 7,
        query_extra_bits: 1,
        radius_bits: 8,
        power: shared(6, 5),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local7x1-rgb5e5",
        summary: "7 bits per radius, queries on half steps, 5-bit mantissas, 5-bit exponent",
        position_bits: 7,
        query_extra_bits: 1,
        radius_bits: 8,
        power: shared(5, 5),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
    PhotonFormat {
        name: "local6x2-rgb6e5",
        summary: "6 bits per radius, queries on quarter steps, 6-bit mantissas, 5-bit exponent",
        position_bits: 6,
        query_extra_bits: 2,
        radius_bits: 8,
        power: shared(6, 5),
        exponent_range: EXPONENT_RANGE,
        max_photons: MAX_PHOTONS,
    },
];

/// No format has that name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no format `{found}`; the formats are {expected}")]
pub struct UnknownFormat {
    /// The name asked for.
    pub found: String,
    /// The names there are.
    pub expected: String,
}

/// The format of that name.
///
/// # Errors
/// No format has that name; the error lists those there are.
pub fn find_photon_format(name: &str) -> Result<&'static PhotonFormat, UnknownFormat> {
    let found = PHOTON_FORMATS.iter().find(|format| format.name == name);
    found.ok_or_else(|| UnknownFormat {
        found: name.to_owned(),
        expected: PHOTON_FORMATS
            .iter()
            .map(|format| format.name)
            .collect::<Vec<_>>()
            .join(", "),
    })
}
