//! Computes distances, to place photons at boundaries. Only the golden model decides which photons are in
//! range.

use photoncube_spec::Machine;

/// The grid of a machine's photons and queries.
#[derive(Copy, Clone)]
pub(super) struct Aim {
    /// The fraction bits of a query beyond those of a photon.
    extra: u32,
}

impl Aim {
    pub fn of(machine: &Machine) -> Self {
        Self {
            extra: machine.format().map_or(0, |f| f.query_extra_bits),
        }
    }

    /// The photon cell that contains a query.
    pub fn cell(self, query: [u32; 3]) -> [u32; 3] {
        query.map(|index| index >> self.extra)
    }

    /// m: the whole steps between a query and a photon; on half steps, the distance less half a step.
    pub fn steps(self, query: u32, photon: u32) -> u32 {
        let line = self.line(photon);
        let above = line.saturating_sub(query + u32::from(self.half_steps()));
        above.max(query.saturating_sub(line))
    }

    /// The photons at `steps` steps above and below a query, where they exist.
    pub fn at_steps(self, query: u32, steps: u32) -> [Option<u32>; 2] {
        let above = query.checked_add(steps + u32::from(self.half_steps()));
        [above, query.checked_sub(steps)].map(|line| {
            let photon = line? >> self.extra;
            let inside = photon <= u32::MAX >> self.extra;
            (inside && Some(self.line(photon)) == line).then_some(photon)
        })
    }

    /// The sum of squares, or of half squares, that is compared with `radius_sq`, without clamp.
    pub fn distance_sq(self, query: [u32; 3], photon: [u32; 3]) -> u64 {
        let square = |axis: usize| {
            let steps = u64::from(self.steps(query[axis], photon[axis]));
            steps * (steps + u64::from(self.half_steps()))
        };
        square(0) + square(1) + square(2)
    }

    fn half_steps(self) -> bool {
        self.extra > 0
    }

    /// The grid line of a photon, in a query's steps.
    fn line(self, photon: u32) -> u32 {
        (photon << self.extra) + ((1 << self.extra) >> 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_found_again_on_either_side() {
        for extra in 0..=2 {
            let aim = Aim { extra };
            for query in 16..48 {
                for photon in 0..64_u32 >> extra {
                    let steps = aim.steps(query, photon);
                    assert!(aim.at_steps(query, steps).contains(&Some(photon)));
                    // The distance from its definition, in half steps.
                    let halves = (2 * query + 1).abs_diff((2 * photon + 1) << extra);
                    assert_eq!(halves, 2 * steps + u32::from(extra > 0));
                }
            }
        }
    }
}
