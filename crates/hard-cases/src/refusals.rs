//! Hard cases: values that cannot be represented are refused, with the limit and the excess.

use glam::DVec3;
use photoncube_model::Gather;
use photoncube_spec::{Exponent, Numbers, PhotonBlock, PhotonFormat, PhotonRecord, Query, Widths};

use super::case::{Bound, Contrast, HardCase, HardCaseError, Outcome, every_format, percent};
use super::naive::absolute;
use super::room::{COLOUR, MIDDLE, RADIUS, Room, photon};
use photoncube_render::Photon;
use photoncube_render::PhotonMap;

pub(super) const VALUES: HardCase = HardCase {
    name: "refused-values",
    breaks: "a coordinate, mantissa, exponent or offset past its field: cut to its low bits",
    result: "values taken, or refused without their limit and by how much they pass it",
    bound: Bound::Zero,
    why: "every field is checked before anything is summed",
    contrast: Contrast {
        what: "% of values silently become others in fields cut to their bits",
        at_least: 50.0,
    },
    applies: every_format,
    settings: |_| Ok(Vec::new()),
    measure: values,
};

pub(super) const COUNTS: HardCase = HardCase {
    name: "refused-counts",
    breaks: "more photons than max_photons: the sums wrap",
    result: "queries taken, or refused without the count and by how much it is passed",
    why: "photons are counted before they are summed",
    contrast: Contrast {
        what: "% of the power lost where four times max_photons of full scale wrap in the sum's bits",
        at_least: 50.0,
    },
    measure: counts,
    ..VALUES
};

pub(super) const PHOTONS: HardCase = HardCase {
    name: "refused-photons",
    breaks: "photons outside the scene or without a power, radii without a grid",
    result: "maps made, or refused without what was found and its limits",
    why: "a map checks all of its photons first",
    contrast: Contrast {
        what: "% of photons outside land in the scene where 16-bit positions wrap",
        at_least: 50.0,
    },
    measure: maps,
    ..VALUES
};

/// A word past its limit, with the limit.
struct Past {
    record: PhotonRecord,
    offset: [u32; 3],
    block_exponent: u8,
    query: Query,
    value: u32,
    largest: u32,
}

/// Values that exceed each limit of a format by `over`.
fn past(format: &PhotonFormat, over: u32) -> Vec<Past> {
    let widths = Widths::of_format(format);
    let ones = |bits: u32| u32::MAX >> (u32::BITS - bits);
    let good = |value: u32, largest: u32| Past {
        record: PhotonRecord::default(),
        offset: [1; 3],
        block_exponent: 0,
        query: Query::default(),
        value,
        largest,
    };
    let mut all = Vec::new();
    for axis in 0..3 {
        let mut one = good(ones(widths.position) + over, ones(widths.position));
        one.record.position[axis] = one.value as u16;
        all.push(one);
        let mut one = good(ones(widths.coordinate) + over, ones(widths.coordinate));
        one.query.position[axis] = one.value;
        all.push(one);
        let last = Numbers::FRAME_BLOCKS - 1;
        let mut one = good(last + over, last);
        one.offset[axis] = one.value;
        all.push(one);
    }
    // A mantissa of 16 bits fills its word, so it has no value past the limit.
    for channel in (0..format.power.channels.names().len()).filter(|_| widths.mantissa < 16) {
        let mut one = good(ones(widths.mantissa) + over, ones(widths.mantissa));
        one.record.mantissa[channel] = one.value as u16;
        all.push(one);
    }
    let range = format.power.exponent_range();
    let (of_block, of_photon) = match format.power.exponent {
        Exponent::None => (0, 0),
        Exponent::Block { .. } => (range, 0),
        Exponent::Photon { .. } => (0, range),
    };
    let mut one = good(of_photon + over, of_photon);
    one.record.exponent = one.value as u8;
    all.push(one);
    let mut one = good(of_block + over, of_block);
    one.block_exponent = one.value as u8;
    all.push(one);
    all
}

fn values(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let gather = Gather::new(&format.into())?;
    let (mut taken, mut cut, mut looked_at) = (0, 0, 0);
    for over in [1, 45] {
        for past in past(format, over) {
            let block = PhotonBlock {
                offset: past.offset,
                exponent: past.block_exponent,
                photons: &[past.record],
            };
            let said = format!("is {}, {over} over the largest", past.value);
            let limit = format!(", {}", past.largest);
            let refused = gather.sums(&past.query, [block]).map_err(|e| e.to_string());
            let refuses = |e: String| e.contains(&said) && e.ends_with(&limit);
            taken += u64::from(!refused.err().is_some_and(refuses));
            let bits = u32::BITS - past.largest.leading_zeros();
            cut += u64::from(past.value & ((1 << bits) - 1) != past.value);
            looked_at += 1;
        }
    }
    Ok(Outcome::wrong(taken, cut, looked_at))
}

fn counts(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let gather = Gather::new(&format.into())?;
    let photons = [PhotonRecord::default(); 1 << 10];
    let query = Query::default();
    let overs = [1, 2_000, 3 * format.max_photons];
    let mut taken = 0;
    for over in overs {
        let given = format.max_photons + over;
        let block = |photons| PhotonBlock {
            offset: [1; 3],
            exponent: 0,
            photons,
        };
        let times = usize::try_from(given >> 10).unwrap_or(usize::MAX);
        let rest = block(&photons[..(given % (1 << 10)) as usize]);
        let blocks = std::iter::repeat_n(block(&photons[..]), times).chain([rest]);
        let said = format!("{given} photons is {over} over the {}", format.max_photons);
        let refused = gather.sums(&query, blocks).map_err(|e| e.to_string());
        taken += u64::from(!refused.err().is_some_and(|e| e.contains(&said)));
    }
    let widths = Widths::of_format(format);
    let full = ((1_u128 << widths.mantissa) - 1) << format.power.exponent_range();
    let sum = 4 * u128::from(format.max_photons) * full;
    let kept = sum % (1 << widths.sum);
    Ok(Outcome {
        looked_at: overs.len() as u64,
        result: taken as f64,
        contrast: 100.0 * (1.0 - kept as f64 / sum as f64),
    })
}

/// Inputs that no map is made of: a photon, a radius, and the text that the refusal must contain.
fn impossible() -> Vec<(Photon, f64, &'static str)> {
    let at = |position| photon(position, COLOUR);
    let lit = |power| photon(MIDDLE, power);
    let good = at(MIDDLE);
    let elsewhere = Photon { surface: 7, ..good };
    vec![
        (
            at(MIDDLE.with_x(1.25)),
            RADIUS,
            "x is 1.25, 0.25 past the scene's 0 to 1",
        ),
        (
            at(MIDDLE.with_y(-2.5)),
            RADIUS,
            "y is -2.5, 2.5 past the scene's 0 to 1",
        ),
        (
            at(MIDDLE.with_z(1e6)),
            RADIUS,
            "z is 1000000, 999999 past the scene's 0 to 1",
        ),
        (at(MIDDLE.with_z(f64::NAN)), RADIUS, "z is NaN"),
        (lit(-DVec3::X), RADIUS, "expected numbers from 0 up"),
        (
            lit(DVec3::Y * f64::INFINITY),
            RADIUS,
            "expected numbers from 0 up",
        ),
        (
            elsewhere,
            RADIUS,
            "surface 7, expected one of the scene's 2",
        ),
        (good, 0.0, "search radius: found 0, expected 0.00000095"),
        (
            good,
            f64::NAN,
            "search radius: found NaN, expected 0.00000095",
        ),
        (
            good,
            1e7,
            "found 10000000, expected 0.00000095367431640625 to 1048576",
        ),
    ]
}

fn maps(_: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let scene = Room::UNIT.scene()?;
    let (mut made, mut outside, mut wrapped) = (0, 0, 0);
    let all = impossible();
    let looked_at = all.len() as u64;
    for (photon, radius, said) in all {
        let refused = PhotonMap::new(&scene, vec![photon], radius).map_err(|e| e.to_string());
        made += u64::from(!refused.err().is_some_and(|e| e.contains(said)));
        let place = photon.position;
        if place.is_finite() && !(place.cmpge(DVec3::ZERO) & place.cmple(DVec3::ONE)).all() {
            outside += 1;
            // Only the fraction is left of a coordinate whose upper bits are cut off.
            let cut = absolute(place - place.floor(), 16);
            wrapped += u64::from(cut.iter().all(|c| *c < 1 << 16));
        }
    }
    Ok(Outcome {
        looked_at,
        result: made as f64,
        contrast: percent(wrapped, outside),
    })
}
