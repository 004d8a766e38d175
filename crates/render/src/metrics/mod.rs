//! Measures of the error of an estimate, all defined here.
//!
//! | measure | definition | unit |
//! |---|---|---|
//! | relative error of a query | e = (estimate - reference) / scale, of the [`luminance`] | 1 |
//! | `rms`, `median`, `p95`, `p99`, `max` | of \|e\| over queries and maps | 1 |
//! | bias | the mean of e, with a 95 % interval over independent maps: [`Interval`] | 1 |
//! | noise | the reference's deviation by mean over maps; rms over queries | 1 |
//! | error over noise | rms relative error by noise | 1 |
//! | misclassified | photons in range for one only, by the reference's in range | % |
//!
//! A relative error of 1 is 100 %. The scale is the reference itself where there is only one set
//! ([`RelativeErrors::between`]). Where there are several, it is the reference's mean over independent maps
//! ([`ErrorStudy`], which gives the reason). Where the scale is 0 there is no relative error: such queries
//! are left out and counted, and those that the estimate lights are counted separately. A comparison of
//! nothing is an error. A study leaves out, and counts, queries noisier than [`MAX_QUERY_NOISE`].
//!
//! A light has four [`Measure`]s: luminance, and each channel against its own noise ([`LightStudy`]).
//!
//! [`ErrorStudy`] takes estimates and references map by map and makes the [`ErrorReport`];
//! [`ErrorBench`] feeds it with any [`crate::Engine`] on photon maps of a scene.

mod bench;
mod bias;
mod error;
mod light;
mod misclassified;
mod moments;
mod noise;
mod queries;
mod quotient;
mod relative;
mod study;
mod verdicts;

pub use bench::{BenchError, BenchOptions, ErrorBench, EstimatorReport};
pub use bias::Interval;
pub use error::MetricsError;
pub use light::{LightReport, LightStudy};
pub use misclassified::MISCLASSIFIED_TIMES_STEPS;
pub use misclassified::Misclassified;
pub use moments::Moments;
pub use noise::{MAX_QUERY_NOISE, Noise, NoiseMeter};
pub use queries::{Measure, luminance, view_queries};
pub use relative::{RelativeErrors, RelativeSummary};
pub use study::{ErrorReport, ErrorStudy};
