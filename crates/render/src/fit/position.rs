//! The position's part of an error: positions rounded by a format, powers exact.

use glam::DVec3;
use photoncube_spec::{Channels, Exponent, PhotonFormat, PowerFormat, Rounding};
use rayon::prelude::*;

use super::pilot::{Part, Pilot};
use crate::estimate::disc_area;
use crate::metrics::BenchError;
use crate::quantise::QuantisedMap;
use crate::view::QueryPoint;

/// The number of shifts of the lattice that each map is measured with. The error depends on the lattice's
/// place under a caustic. Each shift is another sample of it, from photons that are already traced.
const SHIFTS: usize = 2;

/// The error that p and x alone cause.
pub(super) fn position_part(
    pilot: &Pilot,
    position_bits: u32,
    query_extra_bits: u32,
) -> Result<Part, BenchError> {
    let format = positions(position_bits, query_extra_bits);
    let mut part = Part::default();
    for (index, map) in pilot.bench.maps().iter().enumerate() {
        let edge = QuantisedMap::edge_for(&format, map.radius());
        for draw in 0..SHIFTS {
            let shift = lattice_shift(index * SHIFTS + draw);
            let shifted = map.reblocked_at(edge, shift)?;
            let rounded = QuantisedMap::new(&shifted, &format.into())?;
            let queries = pilot.bench.queries().par_iter();
            let estimates: Vec<DVec3> = queries.map(|query| light(&rounded, query)).collect();
            pilot.push(&mut part, index, &estimates);
        }
    }
    Ok(part)
}

/// The reflected light of the photons that the format finds in range, with exact powers.
fn light(rounded: &QuantisedMap<'_>, query: &QueryPoint) -> DVec3 {
    let verdicts = rounded.verdicts(query.position, query.front());
    let in_range = verdicts.filter(|(_, in_range)| *in_range);
    let power: DVec3 = in_range.map(|(photon, _)| photon.power).sum();
    query.beta * power / disc_area(rounded.map())
}

/// A format with these position bits. Its powers are not used.
fn positions(position_bits: u32, query_extra_bits: u32) -> PhotonFormat {
    PhotonFormat {
        position_bits,
        query_extra_bits,
        power: PowerFormat {
            channels: Channels::Mono,
            mantissa_bits: 1,
            exponent: Exponent::None,
            rounding: Rounding::Nearest,
        },
        max_photons: PhotonFormat::DEFAULT_MAX_PHOTONS,
    }
}

/// The shift number `draw`, in block edges: the R3 sequence, multiples of powers of the root of x^4 = x + 1
/// (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018), which fills the cube evenly
/// for any number of shifts.
fn lattice_shift(draw: usize) -> DVec3 {
    const ROOT: f64 = 1.220_744_084_605_759_5;
    let step = DVec3::new(1.0 / ROOT, 1.0 / (ROOT * ROOT), 1.0 / (ROOT * ROOT * ROOT));
    (draw as f64 * step).fract()
}
