//! The photons and the queries of an example, with their sums.

use anyhow::{Result, bail};
use photoncube_model::gather;
use photoncube_spec::{Machine, Photon, Query, Sums, Widths};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// The photons of a set, if the sums hold as many. No number of lanes divides it, so the last group has absent photons. Of a core's
/// two leaves, the second has one photon.
const PHOTONS: u64 = 9;
/// The sets that are drawn before the search for one ends.
const ATTEMPTS: u64 = 10_000;

/// A set of photons, and the batches of queries that gather it.
pub struct Set {
    /// The photons, in their order.
    pub photons: Vec<Photon>,
    /// Each query with its sums over the photons.
    pub batches: Vec<Vec<(Query, Sums)>>,
}

impl Set {
    /// The set of a number, with so many queries in each batch. Each query has photons in range and, of several photons, some out of
    /// range.
    ///
    /// # Errors
    /// The numbers of the machine are not legal, or have no such set.
    pub fn new(machine: &Machine, number: u64, batches: &[usize]) -> Result<Self> {
        for attempt in 0..ATTEMPTS {
            let mut rng = Pcg64Mcg::seed_from_u64(number * ATTEMPTS + attempt);
            let set = Self::draw(machine, batches, &mut rng)?;
            if set.tells() {
                return Ok(set);
            }
        }
        bail!(
            "no example for `{}`: in none of {ATTEMPTS} sets has every query photons in range and photons out of range",
            machine.name
        )
    }

    fn draw(machine: &Machine, batches: &[usize], rng: &mut Pcg64Mcg) -> Result<Self> {
        let photons = machine.max_photons().min(PHOTONS);
        let photons: Vec<_> = (0..photons).map(|_| photon(machine, rng)).collect();
        let batch = |queries: &usize| {
            let query = |_| {
                let query = query(machine, rng);
                Ok((query, gather(machine, &query, photons.iter().copied())?))
            };
            (0..*queries).map(query).collect::<Result<Vec<_>>>()
        };
        let batches = batches.iter().map(batch).collect::<Result<_>>()?;
        Ok(Self { photons, batches })
    }

    /// Whether every query has photons in range and, of several photons, some out of range.
    fn tells(&self) -> bool {
        let photons = self.photons.len() as u64;
        let most = if photons == 1 { 1 } else { photons - 1 };
        let mut queries = self.batches.iter().flatten();
        queries.all(|(_, sums)| (1..=most).contains(&sums.count))
    }
}

/// A point at most `reach` steps from the middle of the frame on each axis, in coordinates of so many bits.
fn point(rng: &mut Pcg64Mcg, bits: u32, reach: u32) -> [u32; 3] {
    let first = (1 << (bits - 1)) - reach;
    [(); 3].map(|()| first + rng.random_range(0..=2 * reach))
}

/// A photon at most a block edge from the middle, which is a quarter of the frame.
fn photon(machine: &Machine, rng: &mut Pcg64Mcg) -> Photon {
    let widths = Widths::of(machine);
    let channels = machine.channels().names().len();
    let position = point(rng, widths.photon, 1 << (widths.photon - 2));
    let mut power = [0; 3];
    for power in &mut power[..channels] {
        *power = rng.random_range(0..1_u64 << widths.mantissa) as u32;
    }
    Photon {
        position,
        power,
        exponent: rng.random_range(0..=machine.numbers.power().exponent_range()),
    }
}

/// A query at most a quarter of a block edge from the middle. Where the radius is on the pins, it is three quarters of an edge.
fn query(machine: &Machine, rng: &mut Pcg64Mcg) -> Query {
    let bits = Widths::of(machine).coordinate;
    let edge = 1_u32 << (bits - 2);
    let radius = edge / 4 * 3;
    let word = || machine.numbers.radius_word(radius * radius);
    Query {
        position: point(rng, bits, edge / 4),
        radius_sq: machine.fixed_radius_sq().or_else(word).unwrap_or(0),
    }
}
