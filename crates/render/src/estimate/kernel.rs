//! Kernels on the disc: the weight of a photon by its distance.

use std::f64::consts::PI;
use std::fmt;

/// A radially decreasing kernel on the disc of the search radius.
///
/// Written as functions of s = d^2 / r^2, because s is uniform on a disc (its area up to s is
/// pi r^2 s). The density is f(s) = norm K(s), scaled so that its integral over s from 0 to 1 is
/// 1; a photon of power P then adds P f(s) / (pi r^2) to the irradiance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kernel {
    /// K = 1: every photon in range counts the same; norm 1. The paper's eq. 2.
    Rectangle,
    /// K = 1 - d/r; norm 3. Jensen, "Global Illumination using Photon Maps" (1996): the weight
    /// 1 - d/(k r) with the normalisation (1 - 2/(3k)) pi r^2, here with k = 1, which makes
    /// pi r^2 / 3.
    Cone,
    /// K = 1 - d^2/r^2; norm 2. Silverman, "Density Estimation" (1986), eq. 4.4: in two dimensions
    /// 2/pi (1 - x^T x).
    Epanechnikov,
}

impl Kernel {
    /// All kernels.
    pub const ALL: [Self; 3] = [Self::Rectangle, Self::Cone, Self::Epanechnikov];

    /// The kernel's name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rectangle => "rectangle",
            Self::Cone => "cone",
            Self::Epanechnikov => "epanechnikov",
        }
    }

    /// K at s = d^2 / r^2, not normalised; 0 outside the disc. The border itself is inside.
    #[must_use]
    pub fn weight(self, s: f64) -> f64 {
        if !(0.0..=1.0).contains(&s) {
            return 0.0;
        }
        match self {
            Self::Rectangle => 1.0,
            Self::Cone => 1.0 - s.sqrt(),
            Self::Epanechnikov => 1.0 - s,
        }
    }

    /// The factor that scales K to an integral of 1 over s.
    #[must_use]
    pub fn norm(self) -> f64 {
        match self {
            Self::Rectangle => 1.0,
            Self::Cone => 3.0,
            Self::Epanechnikov => 2.0,
        }
    }

    /// f(s), the weight times the norm.
    #[must_use]
    pub fn density(self, s: f64) -> f64 {
        self.norm() * self.weight(s)
    }

    /// The factor from sum(power K) to irradiance for the search radius squared `radius_sq`
    /// (scene units squared): norm / (pi r^2).
    #[must_use]
    pub fn scale(self, radius_sq: f64) -> f64 {
        self.norm() / (PI * radius_sq)
    }

    /// The integral of f from 0 to `s`, for s from 0 to 1.
    pub(super) fn mass(self, s: f64) -> f64 {
        match self {
            Self::Rectangle => s,
            Self::Cone => 3.0 * s - 2.0 * s * s.sqrt(),
            Self::Epanechnikov => 2.0 * s - s * s,
        }
    }

    /// The integral of f^2 over the disc: how much noisier the kernel is than the rectangle. The
    /// variance of an estimate from n equal photons in range is this over n.
    #[must_use]
    pub fn roughness(self) -> f64 {
        match self {
            Self::Rectangle => 1.0,
            Self::Cone => 1.5,
            Self::Epanechnikov => 4.0 / 3.0,
        }
    }

    /// The s at which a smooth kernel's density is `density`, from 0 to 1. For the rectangle, which has only
    /// two densities, it is 1.
    pub(super) fn inverse(self, density: f64) -> f64 {
        let part = (1.0 - density / self.norm()).clamp(0.0, 1.0);
        match self {
            Self::Rectangle => 1.0,
            Self::Cone => part * part,
            Self::Epanechnikov => part,
        }
    }
}

impl fmt::Display for Kernel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The midpoint rule over s.
    fn integral(f: impl Fn(f64) -> f64) -> f64 {
        let steps = 100_000;
        let sum: f64 = (0..steps).map(|i| f((f64::from(i) + 0.5) / 1e5)).sum();
        sum / 1e5
    }

    #[test]
    fn densities_integrate_to_one_and_squares_to_the_roughness() {
        for kernel in Kernel::ALL {
            // 1e-6: the midpoint rule at sqrt's steep start errs by about h^1.5 = 3e-8.
            assert!((integral(|s| kernel.density(s)) - 1.0).abs() < 1e-6);
            let squares = integral(|s| kernel.density(s).powi(2));
            assert!((squares - kernel.roughness()).abs() < 1e-6, "{squares}");
            let half = integral(|s| if s < 0.5 { kernel.density(s) } else { 0.0 });
            assert!((half - kernel.mass(0.5)).abs() < 1e-6, "{half}");
        }
    }

    #[test]
    fn the_disc_is_closed_and_nothing_counts_outside() {
        for kernel in Kernel::ALL {
            assert_eq!(kernel.weight(0.0), 1.0);
            assert_eq!(kernel.weight(1.0 + f64::EPSILON), 0.0);
            assert_eq!(kernel.weight(f64::NAN), 0.0);
        }
        assert_eq!(Kernel::ALL.map(|k| k.weight(1.0)), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn the_inverse_inverts() {
        for kernel in [Kernel::Cone, Kernel::Epanechnikov] {
            for s in [0.0, 0.1, 0.5, 1.0] {
                // A few roundings.
                assert!((kernel.inverse(kernel.density(s)) - s).abs() < 1e-15);
            }
        }
    }
}
