//! The forms of estimates, by name.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use super::kernel::Kernel;
use super::ladder::{Ladder, MAX_RUNGS};
use crate::render::Engine;

/// The form of an estimate. On the command line: `fixed`, `knn:50`, `cone`, `ladder:4:cone`.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Estimator {
    /// The map's search radius and the rectangle kernel: eq. 2 of the paper.
    #[default]
    FixedRadius,
    /// The rectangle kernel at the squared search radius, halved this many times. [`crate::Progressive`] estimates bias from
    /// it; on the command line it has no name.
    Halved(u32),
    /// The rectangle kernel with the distance of the k-th nearest photon as the radius, at most the map's
    /// search radius: eq. 1 of the paper. [`crate::Neighbourhood::k_nearest`] states which photons it sums.
    KNearest {
        /// The number k of the photon, at least [`MIN_K`].
        k: u64,
    },
    /// The map's search radius and a smooth kernel. Only the f64 engine has it, because a machine has no op
    /// for it.
    Smooth {
        /// The kernel; the rectangle makes it [`Self::FixedRadius`].
        kernel: Kernel,
    },
    /// An approximation of a smooth kernel by the machine's comparison: a mixture of rectangles.
    Ladder(Ladder),
}

/// The smallest k. The k-th photon sets the radius and only nearer photons are summed, so k = 1 would sum
/// none.
pub const MIN_K: u64 = 2;

/// The reason why an engine cannot make an estimate of that form.
#[derive(Debug, Clone, Copy, Error, PartialEq, Eq)]
pub enum UnfitEstimator {
    /// A k at which no photon is summed.
    #[error(
        "k: found {0}, expected at least {MIN_K}: only photons nearer than the k-th are summed"
    )]
    TooFewAsked(u64),
    /// A smooth kernel in an engine of integers.
    #[error(
        "estimator: found {0}, which an engine of integers cannot make, as it only decides \
         d^2 <= radius_sq; expected its ladder, such as ladder:4:{0}, or the engine f64"
    )]
    SmoothInIntegers(Kernel),
    /// An estimate by a machine whose queries all have the format's radius.
    #[error(
        "estimator: found another than `fixed`, expected `fixed`: the queries of the machine `{0}` all have the format's \
         radius; those of a machine such as leaf-7-radii-local7-rgb6d-n4096 each have one"
    )]
    OtherRadius(&'static str),
}

/// The error of a text that is not the name of an estimator.
#[derive(Debug, Clone, Error, PartialEq, Eq)]
#[error("{what}: found `{found}`, expected {expected}")]
pub struct UnknownEstimator {
    /// The part of the text that is wrong.
    pub what: &'static str,
    /// The text of that part.
    pub found: String,
    /// The text that is legal there.
    pub expected: String,
}

impl Estimator {
    /// The f64 estimate that this one approximates, against which its error is measured: the smooth kernel
    /// for a ladder, the estimator itself for others.
    #[must_use]
    pub fn reference(&self) -> Self {
        match self {
            Self::Ladder(ladder) => Self::Smooth {
                kernel: ladder.kernel(),
            },
            other => other.clone(),
        }
    }

    /// This estimate at the squared search radius halved `times` times more. Others than those of one given radius have no such
    /// form, and stay as they are.
    pub(crate) fn halved(&self, times: u32) -> Self {
        match (self, times) {
            (estimator, 0) => estimator.clone(),
            (Self::FixedRadius, times) => Self::Halved(times),
            (Self::Halved(before), times) => Self::Halved(before + times),
            (other, _) => other.clone(),
        }
    }

    /// Checks that `engine` can make the estimate.
    ///
    /// # Errors
    /// k below [`MIN_K`], or a smooth kernel in integers.
    pub fn check(&self, engine: Engine<'_>) -> Result<(), UnfitEstimator> {
        match (self, engine) {
            (Self::KNearest { k }, _) if *k < MIN_K => Err(UnfitEstimator::TooFewAsked(*k)),
            (Self::Smooth { kernel }, Engine::Integers(..) | Engine::Hardware(..))
                if *kernel != Kernel::Rectangle =>
            {
                Err(UnfitEstimator::SmoothInIntegers(*kernel))
            }
            (estimator, Engine::Hardware(machine, _))
                if *estimator != Self::FixedRadius && machine.fixed_radius_sq().is_some() =>
            {
                Err(UnfitEstimator::OtherRadius(machine.name))
            }
            _ => Ok(()),
        }
    }
}

impl fmt::Display for Estimator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FixedRadius => write!(f, "fixed"),
            Self::Halved(times) => write!(f, "halved:{times}"),
            Self::KNearest { k } => write!(f, "knn:{k}"),
            Self::Smooth { kernel } => write!(f, "{kernel}"),
            Self::Ladder(ladder) => {
                write!(f, "ladder:{}:{}", ladder.rungs().len(), ladder.kernel())
            }
        }
    }
}

impl FromStr for Estimator {
    type Err = UnknownEstimator;

    fn from_str(text: &str) -> Result<Self, UnknownEstimator> {
        match text.split_once(':') {
            None if text == "fixed" => Ok(Self::FixedRadius),
            None => match kernel("estimator", text) {
                Ok(kernel) => Ok(Self::Smooth { kernel }),
                Err(_) => Err(unknown_estimator(text)),
            },
            Some(("knn", k)) => Ok(Self::KNearest { k: photon(k)? }),
            Some(("ladder", rest)) => {
                let (count, name) = rest
                    .split_once(':')
                    .unwrap_or((rest, DEFAULT_KERNEL.name()));
                ladder(count, name).map(Self::Ladder)
            }
            Some(_) => Err(unknown_estimator(text)),
        }
    }
}

/// The kernel of a ladder whose name has none: the kernel of the least mean integrated squared error
/// (Epanechnikov, 1969), which a ladder also approximates best.
const DEFAULT_KERNEL: Kernel = Kernel::Epanechnikov;

fn unknown_estimator(found: &str) -> UnknownEstimator {
    UnknownEstimator {
        what: "estimator",
        found: found.to_owned(),
        expected: "fixed, knn:K, cone, epanechnikov or ladder:RUNGS[:KERNEL]".to_owned(),
    }
}

fn photon(found: &str) -> Result<u64, UnknownEstimator> {
    let k = found.parse().ok().filter(|k| *k >= MIN_K);
    k.ok_or_else(|| UnknownEstimator {
        what: "k",
        found: found.to_owned(),
        expected: format!("a whole number from {MIN_K}, such as knn:50"),
    })
}

fn ladder(count: &str, name: &str) -> Result<Ladder, UnknownEstimator> {
    let wrong_count = || UnknownEstimator {
        what: "rungs",
        found: count.to_owned(),
        expected: format!("1 to {MAX_RUNGS}, such as ladder:4:cone"),
    };
    let rungs = count.parse().map_err(|_| wrong_count())?;
    Ladder::new(kernel("kernel", name)?, rungs).map_err(|_| wrong_count())
}

fn kernel(what: &'static str, found: &str) -> Result<Kernel, UnknownEstimator> {
    let kernel = Kernel::ALL.into_iter().find(|k| k.name() == found);
    kernel.ok_or_else(|| UnknownEstimator {
        what,
        found: found.to_owned(),
        expected: Kernel::ALL.map(Kernel::name).join(", "),
    })
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{PHOTON_FORMATS, find_machine};
    use proptest::prelude::*;

    use super::*;

    fn any_estimator() -> impl Strategy<Value = Estimator> {
        let kernel = || prop::sample::select(Kernel::ALL.as_slice());
        prop_oneof![
            Just(Estimator::FixedRadius),
            (MIN_K..=u64::MAX).prop_map(|k| Estimator::KNearest { k }),
            kernel().prop_map(|kernel| Estimator::Smooth { kernel }),
            (kernel(), 1..=MAX_RUNGS)
                .prop_map(|(kernel, rungs)| Estimator::Ladder(Ladder::new(kernel, rungs).unwrap())),
        ]
    }

    proptest! {
        #[test]
        fn a_name_comes_back(estimator in any_estimator()) {
            prop_assert_eq!(estimator.check(Engine::F64), Ok(()));
            prop_assert_eq!(estimator.to_string().parse(), Ok(estimator));
        }
    }

    #[test]
    fn a_ladder_without_a_kernel_has_one() {
        let named = "ladder:4:epanechnikov".parse::<Estimator>();
        assert_eq!("ladder:4".parse(), named);
    }

    #[test]
    fn a_wrong_name_says_which_part_and_what_was_expected() {
        for (text, part) in [
            ("", "estimator: found ``, expected fixed, knn:K"),
            ("gauss", "estimator: found `gauss`"),
            ("knn", "estimator: found `knn`"),
            ("fixed:3", "estimator: found `fixed:3`"),
            ("knn:1", "k: found `1`, expected a whole number from 2"),
            ("knn:-1", "k: found `-1`"),
            ("ladder:0", "rungs: found `0`, expected 1 to 64"),
            ("ladder:65:cone", "rungs: found `65`"),
            ("ladder:cone", "rungs: found `cone`"),
            (
                "ladder:2:gauss",
                "kernel: found `gauss`, expected rectangle, cone, epanechnikov",
            ),
        ] {
            let message = text.parse::<Estimator>().unwrap_err().to_string();
            assert!(message.starts_with(part), "{message}");
        }
    }

    #[test]
    fn what_an_engine_cannot_do_is_refused() {
        let machine = find_machine("paper").unwrap();
        let integers = [Engine::from(machine), Engine::from(&PHOTON_FORMATS[0])];
        let of = |kernel| Estimator::Smooth { kernel };
        for engine in integers {
            let refused = of(Kernel::Cone).check(engine);
            assert_eq!(refused, Err(UnfitEstimator::SmoothInIntegers(Kernel::Cone)));
            let message = refused.unwrap_err().to_string();
            assert!(message.contains("such as ladder:4:cone"), "{message}");
            assert_eq!(of(Kernel::Rectangle).check(engine), Ok(()));
            for k in [0, 1] {
                let none = Estimator::KNearest { k }.check(engine);
                assert_eq!(none, Err(UnfitEstimator::TooFewAsked(k)));
            }
        }
    }
}
