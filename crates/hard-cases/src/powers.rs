//! Hard cases: powers of wide range, single powers, and absent powers.

use glam::DVec3;
use photoncube_spec::{Exponent, PhotonFormat, Rounding};

use super::case::{Bound, Contrast, HardCase, HardCaseError, Outcome, every_format, percent};
use super::grid::Grid;
use super::room::{COLOUR, MIDDLE, RADIUS, Room, photon, points};
use super::setting::Setting;
use photoncube_render::QuantisedMap;
use photoncube_render::StoredPhoton;

pub(super) const NONE: HardCase = HardCase {
    name: "no-photon-no-light",
    breaks: "a map without photons, or of photons without power: 0/0 in the scale",
    result: "sums that are not 0 and counts that are not the photons there are",
    bound: Bound::Zero,
    why: "nothing is given, or all that is given is 0; a map without light takes a unit of 1",
    contrast: Contrast {
        what: "% of results no number as power over the largest power",
        at_least: 50.0,
    },
    applies: every_format,
    settings: dark,
    measure: none,
};

pub(super) const ONE: HardCase = HardCase {
    name: "one-photon",
    breaks: "one photon is the largest of its map: full scale, and no bit more",
    result: "of what the format may round",
    bound: Bound::AtMost(1.000_001),
    why: "half a step of the mantissa (a step if dithered), and a product in f64",
    contrast: Contrast {
        what: "% of the power lost where the largest is 2^m in m bits that wrap",
        at_least: 100.0,
    },
    settings: |grid| Ok(vec![lone(grid)?]),
    measure: one,
    ..NONE
};

pub(super) const ONE_BLOCK: HardCase = HardCase {
    name: "powers-1e6-in-a-block",
    breaks: "powers over 1e6:1 in one block: the dim ones round to nothing",
    result: "of what the format may round at the exponent of the photon, or of its block; the largest error",
    contrast: Contrast {
        what: "% of photons round to 0 in one linear scale of as many bits",
        at_least: 10.0,
    },
    settings: |grid| Ok(vec![wide(grid)?]),
    measure: one_block,
    ..ONE
};

pub(super) const ACROSS_BLOCKS: HardCase = HardCase {
    name: "powers-1e6-across-blocks",
    breaks: "a block of 1e-6 of another's power: its own light rounds to nothing",
    contrast: Contrast {
        what: "% of the dim block's power lost in one linear scale of as many bits",
        at_least: 50.0,
    },
    settings: |grid| Ok(vec![two_blocks(grid)?]),
    measure: across_blocks,
    ..ONE_BLOCK
};

pub(super) const ROUNDING: HardCase = HardCase {
    name: "rounding-bias",
    breaks: "a rounding that prefers a side: a bias that more photons do not remove",
    result: "% of a step: the mean error of 20,000 powers",
    bound: Bound::AtMost(1.5),
    why: "five deviations of the mean: a step's error has at most 0.41 (dithered; 0.29 nearest), over \
          the root of 20,000",
    contrast: Contrast {
        what: "% of a step by truncation",
        at_least: 10.0,
    },
    // A mantissa of fewer bits with an exponent does not divide the drawn powers into whole steps.
    applies: |format| format.power.mantissa_bits >= 4 || format.power.exponent == Exponent::None,
    settings: |grid| Ok(vec![many(grid)?]),
    measure: rounding,
};

/// The largest error of a power: half a step, or a whole step with dithering.
fn allowed(format: &PhotonFormat, largest_of_scale: f64, largest_of_map: f64) -> f64 {
    let full = full(format);
    let unit = largest_of_map / full / f64::from(1_u32 << format.power.exponent_range());
    // A mantissa is at least half of full scale, or the exponent is 0.
    let step = match format.power.exponent {
        Exponent::None => unit,
        _ => unit.max(2.0 * largest_of_scale / full),
    };
    match format.power.rounding {
        Rounding::Nearest => 0.5 * step,
        Rounding::Dithered => step,
    }
}

fn full(format: &PhotonFormat) -> f64 {
    f64::from((1_u32 << format.power.mantissa_bits) - 1)
}

/// The largest error of a photon over the allowed error. `scale_of` is the power that a photon's exponent
/// follows where photons have none of their own.
fn worst_error(
    setting: &Setting,
    format: &PhotonFormat,
    scale_of: impl Fn(&StoredPhoton) -> f64,
) -> Result<f64, HardCaseError> {
    let quantised = QuantisedMap::new(&setting.map, &format.into())?;
    let photons = quantised.map().photons();
    let brightest = photons
        .iter()
        .map(|p| p.power.max_element())
        .fold(0.0, f64::max);
    let errors = photons.iter().enumerate().map(|(index, photon)| {
        let error = (quantised.power(index) - photon.power).abs().max_element();
        let scale = match format.power.exponent {
            Exponent::Photon { .. } => photon.power.max_element(),
            Exponent::Block { .. } | Exponent::None => scale_of(photon),
        };
        error / allowed(format, scale, brightest)
    });
    Ok(errors.fold(0.0, f64::max))
}

fn dark(grid: &Grid) -> Result<Vec<Setting>, HardCaseError> {
    let maps = [vec![], vec![photon(MIDDLE, DVec3::ZERO)]];
    let settings = maps.map(|photons| {
        let count = photons.len() as u64;
        let map = Room::UNIT.map(grid, photons, RADIUS)?;
        Ok(Setting::counted(map, MIDDLE, count))
    });
    settings.into_iter().collect()
}

fn none(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let (mut wrong, mut no_numbers, mut looked_at) = (0, 0, 0);
    for setting in dark(&Grid::of_format(format))? {
        let sums = setting.sums(format)?;
        let lit = sums.iter().filter(|sums| sums.power != [0; 3]).count() as u64;
        wrong += lit + setting.miscounted(format)?;
        let powers = setting.map.photons().iter().map(|p| p.power.x);
        let (sum, largest) = (powers.clone().sum::<f64>(), powers.fold(0.0, f64::max));
        no_numbers += u64::from((sum / largest).is_nan());
        looked_at += sums.len() as u64;
    }
    Ok(Outcome::wrong(wrong, no_numbers, looked_at))
}

fn lone(grid: &Grid) -> Result<Setting, HardCaseError> {
    let map = Room::UNIT.map(grid, vec![photon(MIDDLE, 4.0 * COLOUR)], RADIUS)?;
    Ok(Setting::counted(map, MIDDLE, 1))
}

fn one(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let setting = lone(&Grid::of_format(format))?;
    let result = worst_error(&setting, format, |p| p.power.max_element())?;
    let missed = setting.miscounted(format)?;
    let steps = 1_u32 << format.power.mantissa_bits;
    let kept = steps & (steps - 1);
    Ok(Outcome {
        looked_at: setting.counts[0],
        result: result + missed as f64,
        contrast: percent((steps - kept).into(), steps.into()),
    })
}

/// A thousand photons at one place, with powers from 1 down to 1e-6.
fn wide(grid: &Grid) -> Result<Setting, HardCaseError> {
    let power = |k: usize| 10_f64.powf(-6.0 * k as f64 / 1_000.0) * COLOUR;
    let count = grid.at_most(1_001);
    let photons = (0..count).map(|k| photon(MIDDLE, power(k))).collect();
    let map = Room::UNIT.map(grid, photons, RADIUS)?;
    Ok(Setting::counted(map, MIDDLE, count as u64))
}

fn one_block(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let setting = wide(&Grid::of_format(format))?;
    let brightest = COLOUR.max_element();
    let result = worst_error(&setting, format, |_| brightest)?;
    let dim = |p: &&StoredPhoton| (p.power.max_element() / brightest * full(format)).round() == 0.0;
    let lost = setting.map.photons().iter().filter(dim).count() as u64;
    Ok(Outcome {
        looked_at: setting.counts[0],
        result,
        contrast: percent(lost, setting.counts[0]),
    })
}

/// A bright block, and at the room's other end a block of a millionth of its power.
fn two_blocks(grid: &Grid) -> Result<Setting, HardCaseError> {
    let of = |at: f64, power: f64| {
        (0..10).map(move |k| photon(DVec3::splat(at), power * f64::from(10 - k) / 10.0 * COLOUR))
    };
    let photons = of(0.1, 1.0).chain(of(0.9, 1e-6)).collect();
    let map = Room::UNIT.map(grid, photons, RADIUS)?;
    let queries = [0.1, 0.9].map(DVec3::splat).to_vec();
    Ok(Setting {
        map,
        queries,
        counts: vec![10, 10],
    })
}

fn across_blocks(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let setting = two_blocks(&Grid::of_format(format))?;
    let scale = |p: &StoredPhoton| if p.position.x < 0.5 { 1.0 } else { 1e-6 };
    let result = worst_error(&setting, format, scale)?;
    let dim = setting.map.photons().iter().map(|p| p.power.max_element());
    let dim: Vec<f64> = dim.filter(|power| *power < 1e-5).collect();
    let linear = dim
        .iter()
        .map(|power| (power * full(format)).round() / full(format));
    let kept: f64 = linear.sum::<f64>() / dim.iter().sum::<f64>();
    Ok(Outcome {
        looked_at: setting.map.photons().len() as u64,
        result,
        contrast: 100.0 * (1.0 - kept),
    })
}

/// Photons of powers from 0 up to the largest, which is among them, in whole steps of a linear scale.
fn many(grid: &Grid) -> Result<Setting, HardCaseError> {
    let pairs = points(20_000, 51).zip(points(20_000, 52));
    let photons = pairs.map(|(at, p)| photon(at, p.x * COLOUR));
    let photons = photons.chain([photon(MIDDLE, COLOUR)]).collect();
    let map = Room::UNIT.map(grid, photons, RADIUS)?;
    Ok(Setting::new(map, points(20, 53).collect()))
}

fn rounding(format: &PhotonFormat) -> Result<Outcome, HardCaseError> {
    let setting = many(&Grid::of_format(format))?;
    let quantised = QuantisedMap::new(&setting.map, &format.into())?;
    let photons = quantised.map().photons();
    let (mut error, mut truncated) = (0.0, 0.0);
    for (index, photon) in photons.iter().enumerate() {
        let exact = photon.power.max_element();
        let stored = quantised.power(index).max_element();
        let step = quantised.step(index);
        error += (stored - exact) / step;
        truncated += (exact / step).fract();
    }
    let count = photons.len() as f64;
    Ok(Outcome {
        looked_at: photons.len() as u64,
        result: 100.0 * (error / count).abs(),
        contrast: 100.0 * truncated / count,
    })
}
