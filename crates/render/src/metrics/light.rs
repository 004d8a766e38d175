//! Compares an engine's estimates with the reference by luminance and by every channel.

use glam::DVec3;

use super::bias::Interval;
use super::error::MetricsError;
use super::misclassified::Misclassified;
use super::queries::Measure;
use super::study::{ErrorReport, ErrorStudy};

/// One [`ErrorStudy`] for each [`Measure`], all on the same estimates.
#[derive(Debug, Clone, PartialEq)]
pub struct LightStudy {
    studies: [ErrorStudy; Measure::ALL.len()],
}

/// The reports of all measures that have light.
#[derive(Debug, Clone, PartialEq)]
pub struct LightReport {
    reports: Vec<(Measure, ErrorReport)>,
    error_over_noise: Interval,
}

impl LightStudy {
    /// A study of `queries` queries.
    #[must_use]
    pub fn new(queries: usize) -> Self {
        Self {
            studies: Measure::ALL.map(|_| ErrorStudy::new(queries)),
        }
    }

    /// Adds one map: reflected light in the order of the queries, and the counts of its photon tests.
    ///
    /// # Errors
    /// As for [`ErrorStudy::push_map`].
    pub fn push_map(
        &mut self,
        estimates: &[DVec3],
        references: &[DVec3],
        misclassified: Misclassified,
    ) -> Result<(), MetricsError> {
        for (study, measure) in self.studies.iter_mut().zip(Measure::ALL) {
            let values = |lights: &[DVec3]| lights.iter().map(|l| measure.of(*l)).collect();
            let (estimates, references): (Vec<_>, Vec<_>) = (values(estimates), values(references));
            study.push_map(&estimates, &references, misclassified)?;
        }
        Ok(())
    }

    /// The figures over all maps. A channel without light, or without noise, has no figures.
    ///
    /// # Errors
    /// As for [`ErrorStudy::report`] of the luminance, or fewer than three maps.
    pub fn report(&self) -> Result<LightReport, MetricsError> {
        let mut reports = Vec::new();
        for (study, measure) in self.studies.iter().zip(Measure::ALL) {
            match study.report() {
                Ok(report) => reports.push((measure, report)),
                Err(MetricsError::NothingCompared | MetricsError::NoNoise)
                    if measure != Measure::Luminance => {}
                Err(error) => return Err(error),
            }
        }
        let (measure, _) = worst(&reports);
        Ok(LightReport {
            error_over_noise: self.studies[measure as usize].error_over_noise()?,
            reports,
        })
    }
}

impl LightReport {
    /// The report of luminance.
    #[must_use]
    pub fn luminance(&self) -> &ErrorReport {
        &self.reports[0].1
    }

    /// The measures that have light, luminance first.
    pub fn measures(&self) -> impl Iterator<Item = (Measure, &ErrorReport)> {
        self.reports
            .iter()
            .map(|(measure, report)| (*measure, report))
    }

    /// The measure with the largest error over its own noise, see [`Measure::worst`].
    #[must_use]
    pub fn worst(&self) -> (Measure, &ErrorReport) {
        worst(&self.reports)
    }

    /// The error over noise of the worst measure, with the 95 % interval of [`ErrorStudy::error_over_noise`].
    #[must_use]
    pub fn worst_error_over_noise(&self) -> Interval {
        self.error_over_noise
    }
}

/// The worst of these reports, the first of which is that of luminance.
fn worst(reports: &[(Measure, ErrorReport)]) -> (Measure, &ErrorReport) {
    let measures = reports.iter().map(|(measure, report)| (*measure, report));
    let worst = Measure::worst(measures, |report| report.error_over_noise);
    worst.unwrap_or((reports[0].0, &reports[0].1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn study(estimates: [DVec3; 3], references: [DVec3; 3]) -> LightStudy {
        let mut counts = Misclassified::default();
        counts.push(true, true);
        let mut study = LightStudy::new(1);
        for (estimate, reference) in estimates.iter().zip(references) {
            study.push_map(&[*estimate], &[reference], counts).unwrap();
        }
        study
    }

    #[test]
    fn a_wrong_blue_is_worse_than_its_luminance() {
        let references = [1.0, 1.5, 1.1].map(DVec3::splat);
        let blue = DVec3::new(0.0, 0.0, 0.5);
        let report = study(references.map(|r| r + blue), references)
            .report()
            .unwrap();
        let (measure, worst) = report.worst();
        assert_eq!(measure, Measure::Blue);
        let interval = report.worst_error_over_noise();
        assert!(interval.holds(worst.error_over_noise));
        // Luminance sees 0.0722 of it; a few roundings.
        let seen = report.luminance().error_over_noise / worst.error_over_noise;
        assert!((seen - 0.0722).abs() < 1e-12, "{seen}");
    }

    #[test]
    fn a_channel_without_light_has_no_report() {
        let red = [1.0, 1.5, 1.1].map(|power| power * DVec3::X);
        let report = study(red, red).report().unwrap();
        let measures: Vec<_> = report.measures().map(|(measure, _)| measure).collect();
        assert_eq!(measures, [Measure::Luminance, Measure::Red]);
        let dark = study([DVec3::ZERO; 3], [DVec3::ZERO; 3]).report();
        assert_eq!(dark, Err(MetricsError::NothingCompared));
    }
}
