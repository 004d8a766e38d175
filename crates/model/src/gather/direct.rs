//! The direct gather: the sums that a machine must return, computed photon by photon.

use photoncube_spec::{Machine, Photon, Query, Sums};

use super::error::{CountError, GatherError};
use super::range::Limits;

/// Sums the power and the number of the photons with `d^2 <= radius_sq`. The sums are exact.
///
/// Eq. 2 of Ryu, Kim, Lee, without its constant factor `1 / (pi r^2)`. In a photon format on half
/// steps, `radius_sq` bounds the sum of half squares, see [`photoncube_spec::PhotonFormat`].
///
/// # Errors
/// A value does not fit the machine's formats, or there are more photons than its sums are sized for.
pub fn gather(
    machine: &Machine,
    query: &Query,
    photons: impl IntoIterator<Item = Photon>,
) -> Result<Sums, GatherError> {
    let limits = Limits::of(machine);
    limits.check_query(query)?;
    let grid = Grid::of(machine);
    let mut sums = Sums::default();
    let mut given = 0;
    for photon in photons {
        limits.check_photon(&photon)?;
        given += 1;
        // Photons past the limit are only counted, for the error.
        if given <= machine.max_photons() && grid.in_range(query, photon.position) {
            for (sum, power) in sums.power.iter_mut().zip(photon.power) {
                *sum += u64::from(power) << photon.exponent;
            }
            sums.count += 1;
        }
    }
    if given > machine.max_photons() {
        return Err(GatherError::Count(CountError {
            found: given,
            max_photons: machine.max_photons(),
            kind: "machine",
            name: machine.name.to_owned(),
        }));
    }
    Ok(sums)
}

/// Positions in half fine steps, in which the middles of cells are integers too. This plain geometry has no
/// clamp and no half squares, and must give the decisions of the rules that have them.
#[derive(Copy, Clone)]
struct Grid {
    /// The fraction bits of a query beyond those of a photon.
    extra: u32,
    /// The excess of (2 d)^2 over 4 `radius_sq` at the boundary. On half steps, where `radius_sq` bounds a
    /// sum of half squares, it is 1/4 for each axis.
    margin: u64,
}

impl Grid {
    fn of(machine: &Machine) -> Self {
        let extra = machine.format().map_or(0, |f| f.query_extra_bits);
        Self {
            extra,
            margin: if extra > 0 { 3 } else { 0 },
        }
    }

    fn in_range(self, query: &Query, photon: [u32; 3]) -> bool {
        let squares = query
            .position
            .into_iter()
            .zip(photon)
            .map(|(query, photon)| {
                let query = 2 * u64::from(query) + 1;
                let photon = (2 * u64::from(photon) + 1) << self.extra;
                query.abs_diff(photon).pow(2)
            });
        squares.sum::<u64>() <= 4 * u64::from(query.radius_sq) + self.margin
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::MACHINES;

    const PAPER: &Machine = &MACHINES[0];

    fn photon_at(x: u32, y: u32, z: u32) -> Photon {
        Photon {
            position: [x, y, z],
            power: [1, 2, 3],
            exponent: 0,
        }
    }

    #[test]
    fn the_boundary_is_in_range() {
        let query = Query {
            position: [100; 3],
            radius_sq: 25,
        };
        let photons = [photon_at(103, 96, 100), photon_at(103, 96, 101)];
        let sums = gather(PAPER, &query, photons).unwrap();
        assert_eq!((sums.count, sums.power), (1, [1, 2, 3]));
    }

    #[test]
    fn the_largest_declared_count_at_full_scale_is_exact() {
        let full = Photon {
            position: [0; 3],
            power: [65_535; 3],
            exponent: 0,
        };
        let many = |count| std::iter::repeat_n(full, count);
        let query = Query::default();
        let largest = PAPER.max_photons() as usize;
        let sums = gather(PAPER, &query, many(largest)).unwrap();
        assert_eq!(sums.power, [u64::from(u32::MAX); 3]);
        let refused = gather(PAPER, &query, many(largest + 3)).unwrap_err();
        let expected = "65540 photons is 3 over the 65537 that machine `paper` declares";
        assert!(refused.to_string().contains(expected), "{refused}");
    }

    #[test]
    fn what_does_not_fit_is_refused_with_the_limit() {
        let query = Query::default();
        let message = gather(PAPER, &query, [photon_at(0, 256, 0)])
            .unwrap_err()
            .to_string();
        assert!(message.contains("position y is 256"), "{message}");
        assert!(
            message.contains("1 over the largest") && message.contains("holds, 255"),
            "{message}"
        );
    }
}
