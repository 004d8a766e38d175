//! Smooth kernels from the machine's one comparison: a mixture of rectangles.
//!
//! A kernel that falls with the distance is a mixture of discs. A *ladder* of n rungs approximates it by n
//! discs with the squared radii s_i r^2 and the weights w_i: n gathers of the same photons, or one gather
//! with n comparisons. In s = d^2/r^2 the ladder is a staircase g with the value v_i up to s_i, and w_i =
//! (v_i - v_(i+1)) s_i.
//!
//! # How the rungs are chosen
//! For photons spread uniformly the difference of the two estimates, sum(power (f - g)), has mean
//! 0 where the weights add to 1, and a variance proportional to the integral of (f - g)^2 over
//! s. The rungs minimise that integral with the weights adding to 1. With a Lagrange multiplier the
//! conditions are those of Lloyd (1957) and Max (1960) for a quantiser whose lowest level is 0:
//! v_i is the mean of f over its step plus mu, f(s_i) = (v_i + v_(i+1))/2 - mu, and mu is what
//! the tail beyond s_n misses, shared out over s_n. They are iterated to a fixed point.
//!
//! For Epanechnikov, linear in s, it is s_i = i/q and w_i = 2i/q^2 with q^2 = n(n + 1), and the
//! error over the noise is sqrt((2n + 1)/q - 2), about 1/(2n + 1). The cone has no such form.
//!
//! | rungs | 2 | 4 | 8 |
//! |---|---|---|---|
//! | cone: error over noise | 0.251 | 0.141 | 0.075 |
//! | cone: largest pointwise error over the peak | 0.337 | 0.225 | 0.142 |
//! | Epanechnikov: error over noise | 0.203 | 0.112 | 0.059 |
//! | Epanechnikov: largest pointwise error over the peak | 0.225 | 0.118 | 0.061 |

use thiserror::Error;

use super::kernel::Kernel;

/// The most rungs: more than any kernel needs. At 64 the error is about 0.01 of the noise.
pub const MAX_RUNGS: usize = 64;

/// The most rounds of the iteration. The rounds needed grow with the square of the rungs; 64 rungs converge
/// well before this many.
const MAX_ROUNDS: usize = 100_000;

/// The limit of convergence: a round moves no rung by more. It is far below the step of any number format.
const CONVERGED: f64 = 1e-14;

/// One disc of the mixture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rung {
    /// The rung's squared radius as a fraction of the kernel's: over 0, at most 1.
    pub radius_sq_fraction: f64,
    /// The rung's share of the estimate. The shares of a ladder add to 1.
    pub weight: f64,
}

/// The error of a number of rungs that no ladder has.
#[derive(Debug, Clone, Copy, Error, PartialEq, Eq)]
#[error("rungs: found {found}, expected 1 to {MAX_RUNGS}")]
pub struct LadderError {
    /// The number that was given.
    pub found: usize,
}

/// A staircase of rectangles in place of a smooth kernel.
#[derive(Debug, Clone, PartialEq)]
pub struct Ladder {
    kernel: Kernel,
    rungs: Vec<Rung>,
}

impl Ladder {
    /// The best ladder of `rungs` rungs. The rectangle's ladder always has one.
    ///
    /// # Errors
    /// No rung, or more than [`MAX_RUNGS`].
    pub fn new(kernel: Kernel, rungs: usize) -> Result<Self, LadderError> {
        if !(1..=MAX_RUNGS).contains(&rungs) {
            return Err(LadderError { found: rungs });
        }
        let steps = match kernel {
            Kernel::Rectangle => vec![1.0],
            Kernel::Cone | Kernel::Epanechnikov => steps(kernel, rungs),
        };
        Ok(Self {
            kernel,
            rungs: rungs_of(&steps, &levels(kernel, &steps).0),
        })
    }

    /// The kernel that the ladder approximates.
    #[must_use]
    pub fn kernel(&self) -> Kernel {
        self.kernel
    }

    /// The rungs, the smallest first.
    #[must_use]
    pub fn rungs(&self) -> &[Rung] {
        &self.rungs
    }

    /// The rungs' squared radii in the machine's steps, rounded to nearest, for a kernel of `radius_sq`. Each
    /// rung's sum must be divided by pi times *this* value, so that the rounding causes no bias.
    #[must_use]
    pub fn radii_sq(&self, radius_sq: u32) -> Vec<u32> {
        let scaled = |rung: &Rung| (rung.radius_sq_fraction * f64::from(radius_sq)).round();
        // At least one step, so that the division is possible; `as` is exact below 2^32.
        let integers = self.rungs.iter().map(scaled);
        integers.map(|r| r.max(1.0) as u32).collect()
    }

    /// g(s), the staircase at s = d^2 / r^2, normalised like [`Kernel::density`].
    #[must_use]
    pub fn density(&self, s: f64) -> f64 {
        let holds = |rung: &&Rung| s <= rung.radius_sq_fraction;
        let parts = self.rungs.iter().filter(holds);
        parts.map(|r| r.weight / r.radius_sq_fraction).sum()
    }

    /// The largest |f - g| as a part of the kernel's peak f(0). Between rungs g is flat and f
    /// falls, so it is at 0 or on one side of a rung.
    #[must_use]
    pub fn max_error_over_peak(&self) -> f64 {
        let peak = self.kernel.density(0.0);
        let mut level = self.density(0.0);
        let mut largest = (peak - level).abs();
        for rung in &self.rungs {
            let s = rung.radius_sq_fraction;
            largest = largest.max((self.kernel.density(s) - level).abs());
            level -= rung.weight / s;
            if s < 1.0 {
                largest = largest.max((self.kernel.density(s) - level).abs());
            }
        }
        largest / peak
    }

    /// The root of the integral of (f - g)^2 over that of f^2. It is also what the ladder adds to
    /// an estimate on uniform photons, as a part of the smooth estimate's Monte-Carlo noise, for
    /// any number of photons: both variances carry the same factor.
    #[must_use]
    pub fn error_over_noise(&self) -> f64 {
        // (f - g)^2 = f^2 - 2 f g + g^2 with g the sum of w_i / s_i up to s_i.
        let share = |r: &Rung| r.weight / r.radius_sq_fraction;
        let cross: f64 = (self.rungs.iter())
            .map(|r| share(r) * self.kernel.mass(r.radius_sq_fraction))
            .sum();
        let mut square = 0.0;
        for a in &self.rungs {
            for b in &self.rungs {
                let both = a.radius_sq_fraction.min(b.radius_sq_fraction);
                square += share(a) * share(b) * both;
            }
        }
        let roughness = self.kernel.roughness();
        // Rounding may leave a tiny negative number for the rectangle.
        ((roughness - 2.0 * cross + square).max(0.0) / roughness).sqrt()
    }
}

/// The ends s_1 < .. < s_n of the best staircase's steps.
fn steps(kernel: Kernel, count: usize) -> Vec<f64> {
    let mut steps: Vec<f64> = (1..=count).map(|i| i as f64 / (count + 1) as f64).collect();
    for _ in 0..MAX_ROUNDS {
        let (levels, mu) = levels(kernel, &steps);
        let mut moved: f64 = 0.0;
        for i in 0..count {
            let below = levels.get(i + 1).copied().unwrap_or(0.0);
            let step = kernel.inverse(0.5 * (levels[i] + below) - mu);
            moved = moved.max((step - steps[i]).abs());
            steps[i] = step;
        }
        if moved < CONVERGED {
            break;
        }
    }
    steps
}

/// The levels v_i over these steps, and mu.
fn levels(kernel: Kernel, steps: &[f64]) -> (Vec<f64>, f64) {
    let last = steps[steps.len() - 1];
    let mu = (1.0 - kernel.mass(last)) / last;
    let starts = std::iter::once(0.0).chain(steps.iter().copied());
    let level = |(start, &end)| (kernel.mass(end) - kernel.mass(start)) / (end - start) + mu;
    (starts.zip(steps).map(level).collect(), mu)
}

fn rungs_of(steps: &[f64], levels: &[f64]) -> Vec<Rung> {
    let below = levels[1..].iter().copied().chain([0.0]);
    let rung = |((&step, level), below)| Rung {
        radius_sq_fraction: step,
        weight: (level - below) * step,
    };
    steps.iter().zip(levels).zip(below).map(rung).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMOOTH: [Kernel; 2] = [Kernel::Cone, Kernel::Epanechnikov];

    #[test]
    fn weights_add_to_one_and_rungs_rise() {
        for kernel in SMOOTH {
            for rungs in [1, 2, 4, 8, MAX_RUNGS] {
                let ladder = Ladder::new(kernel, rungs).unwrap();
                let sum: f64 = ladder.rungs().iter().map(|r| r.weight).sum();
                // Rounding of 64 terms.
                assert!((sum - 1.0).abs() < 1e-13, "{sum}");
                let fractions: Vec<f64> = ladder
                    .rungs()
                    .iter()
                    .map(|r| r.radius_sq_fraction)
                    .collect();
                assert!(fractions.is_sorted_by(|a, b| a < b) && fractions[0] > 0.0);
                assert!(fractions[rungs - 1] <= 1.0);
                assert!(ladder.rungs().iter().all(|r| r.weight > 0.0));
                // The limit that the documentation of MAX_RUNGS states.
                assert!(rungs < MAX_RUNGS || ladder.error_over_noise() < 0.0105);
            }
        }
    }

    /// A linear density has its fixed point by hand; see the module's text.
    #[test]
    fn epanechnikov_is_its_closed_form() {
        for rungs in [1, 2, 4, 8, 16, MAX_RUNGS] {
            let ladder = Ladder::new(Kernel::Epanechnikov, rungs).unwrap();
            let n = rungs as f64;
            let q = (n * (n + 1.0)).sqrt();
            for (i, rung) in (1..).map(f64::from).zip(ladder.rungs()) {
                // The iteration stops when a round moves less than 1e-14: 64 rungs are then still
                // 64^2 rounds' worth away, 1e-10.
                assert!((rung.radius_sq_fraction - i / q).abs() < 1e-10);
                assert!((rung.weight - 2.0 * i / (q * q)).abs() < 1e-10);
            }
            // Second order in the rungs' error; the difference from 2 loses some digits.
            let error = ((2.0 * n + 1.0) / q - 2.0).sqrt();
            assert!((ladder.error_over_noise() - error).abs() < 1e-10);
        }
    }

    #[test]
    fn the_modules_table_is_what_there_is() {
        let table = [
            (
                Kernel::Cone,
                [(2, 0.251, 0.337), (4, 0.141, 0.225), (8, 0.075, 0.142)],
            ),
            (
                Kernel::Epanechnikov,
                [(2, 0.203, 0.225), (4, 0.112, 0.118), (8, 0.059, 0.061)],
            ),
        ];
        for (kernel, rows) in table {
            for (rungs, error, largest) in rows {
                let ladder = Ladder::new(kernel, rungs).unwrap();
                // Half a unit in the last digit shown.
                assert!((ladder.error_over_noise() - error).abs() <= 5e-4);
                assert!((ladder.max_error_over_peak() - largest).abs() <= 5e-4);
            }
        }
    }

    #[test]
    fn no_small_move_of_a_rung_is_better() {
        for kernel in SMOOTH {
            let best = Ladder::new(kernel, 4).unwrap();
            let fractions: Vec<f64> = best.rungs().iter().map(|r| r.radius_sq_fraction).collect();
            for index in 0..4 {
                for by in [-1e-3, 1e-3] {
                    let mut moved = fractions.clone();
                    moved[index] += by;
                    let other = Ladder {
                        kernel,
                        rungs: rungs_of(&moved, &levels(kernel, &moved).0),
                    };
                    assert!(other.error_over_noise() > best.error_over_noise());
                }
            }
        }
    }

    #[test]
    fn the_errors_formula_is_the_integral() {
        for kernel in SMOOTH {
            let ladder = Ladder::new(kernel, 4).unwrap();
            let steps = 100_000;
            let at = |i| (f64::from(i) + 0.5) / f64::from(steps);
            let error = |i| kernel.density(at(i)) - ladder.density(at(i));
            let sum: f64 = (0..steps).map(|i| error(i).powi(2)).sum();
            let numeric = (sum / f64::from(steps) / kernel.roughness()).sqrt();
            // The midpoint rule over 4 jumps: 4 cells of 1e-5, each wrong by less than 1.
            assert!((numeric - ladder.error_over_noise()).abs() < 1e-4);
            let largest = (0..steps).map(|i| error(i).abs()).fold(0.0, f64::max);
            // The cone's steepest cell, the first: 3 sqrt(5e-6) = 0.007 of its peak 3.
            let peak = kernel.density(0.0);
            assert!((largest / peak - ladder.max_error_over_peak()).abs() < 0.003);
        }
    }

    #[test]
    fn integer_radii_are_rounded_to_nearest() {
        let ladder = Ladder::new(Kernel::Epanechnikov, 2).unwrap();
        for (integer, rung) in ladder.radii_sq(4096).iter().zip(ladder.rungs()) {
            let exact = rung.radius_sq_fraction * 4096.0;
            assert!((f64::from(*integer) - exact).abs() <= 0.5);
        }
        assert_eq!(ladder.radii_sq(0), [1, 1]);
    }

    #[test]
    fn the_rectangle_is_one_rung_and_exact() {
        let ladder = Ladder::new(Kernel::Rectangle, 4).unwrap();
        assert_eq!(ladder.rungs().len(), 1);
        assert_eq!(
            (ladder.error_over_noise(), ladder.max_error_over_peak()),
            (0.0, 0.0)
        );
        assert_eq!(Ladder::new(Kernel::Cone, 0), Err(LadderError { found: 0 }));
        assert!(Ladder::new(Kernel::Cone, MAX_RUNGS + 1).is_err());
    }
}
