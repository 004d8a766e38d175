//! Rounds powers in ways that no format has: with other exponents and other dithering.

use glam::DVec3;
use photoncube_render::{QuantisedMap, StoredPhoton};
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};

/// The photons that share an exponent.
#[derive(Copy, Clone, PartialEq)]
pub enum Sharing {
    /// Each photon has its own exponent.
    Photon,
    /// The photons of a block that is split into 2^s parts on every axis share an exponent in each part.
    SubBlock(u32),
}

/// The powers of a map whose format has an exponent for each photon. They are rounded to nearest, or dithered
/// by random numbers in place of the hash, with the largest exponent of the photons that share one.
pub fn powers(quantised: &QuantisedMap<'_>, sharing: Sharing, dithered: bool) -> Vec<DVec3> {
    let unit = quantised.flux([1; 3]);
    let full = f64::from((1_u32 << quantised.numbers().power().mantissa_bits) - 1);
    // Another sequence for each map, so that maps stay independent.
    let seed = quantised.map().photons()[0].position.x.to_bits();
    let mut rng = StdRng::seed_from_u64(seed);
    let exponents = exponents(quantised, sharing);
    let photons = quantised.map().photons().iter();
    let round = |(photon, exponent): (&StoredPhoton, u8)| {
        let step = unit * f64::from(exponent).exp2();
        let mut add = || if dithered { rng.random() } else { 0.5 };
        let offset = DVec3::new(add(), add(), add());
        let mantissa = (photon.power / step + offset).floor();
        mantissa.min(DVec3::splat(full)) * step
    };
    photons.zip(exponents).map(round).collect()
}

fn exponents(quantised: &QuantisedMap<'_>, sharing: Sharing) -> Vec<u8> {
    let own = quantised.records().iter().map(|record| record.exponent);
    match sharing {
        Sharing::Photon => own.collect(),
        Sharing::SubBlock(s) => shared_exponents(quantised, s),
    }
}

fn shared_exponents(quantised: &QuantisedMap<'_>, s: u32) -> Vec<u8> {
    let mut found = vec![0; quantised.records().len()];
    let shift = quantised.numbers().position_bits() - s;
    for block in quantised.map().block_slices() {
        let records = &quantised.records()[block.clone()];
        let mut largest = vec![0; 1 << (3 * s)];
        let places: Vec<usize> = records
            .iter()
            .map(|r| place(r.position, shift, s))
            .collect();
        for (place, record) in places.iter().zip(records) {
            largest[*place] = record.exponent.max(largest[*place]);
        }
        let shared = places.iter().map(|place| largest[*place]);
        found[block].copy_from_slice(&shared.collect::<Vec<u8>>());
    }
    found
}

/// The index of the sub-block of a position, with 2^s sub-blocks on every axis.
pub fn place(position: [u16; 3], shift: u32, s: u32) -> usize {
    let [x, y, z] = position.map(|axis| usize::from(axis) >> shift);
    (z << (2 * s)) | (y << s) | x
}
