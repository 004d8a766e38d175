//! The rules by which radii fall.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use crate::lighting::{Caustics, Lighting};

/// The rule by which the radii in the global map fall. On the command line: `schedule`, `chi-square`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum RadiusRule {
    /// All pixels have the radius of the pass, which falls with the passes.
    #[default]
    Schedule,
    /// A pixel's squared radius is halved when its photons are not spread evenly, as a chi-square test decides.
    ChiSquare,
}

impl RadiusRule {
    /// The rule of less error: the chi-square rule where the global map carries the caustics; else the schedule (`scripts/accuracy.sh
    /// radius`). Beside a map of caustics the rule gains much on some scenes and loses a little on others if the global map carries
    /// direct light, and gains nothing if it does not.
    #[must_use]
    pub fn of(lighting: &Lighting) -> Self {
        match lighting.caustics {
            Caustics::Map => Self::ChiSquare,
            Caustics::Own(_) => Self::Schedule,
        }
    }
}

/// The error of a text that is not the name of a rule.
#[derive(Debug, Clone, Error, PartialEq, Eq)]
#[error("radius rule: found `{found}`, expected schedule or chi-square")]
pub struct UnknownRadiusRule {
    /// The text that was given.
    pub found: String,
}

impl fmt::Display for RadiusRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Schedule => "schedule",
            Self::ChiSquare => "chi-square",
        })
    }
}

impl FromStr for RadiusRule {
    type Err = UnknownRadiusRule;

    fn from_str(text: &str) -> Result<Self, UnknownRadiusRule> {
        let rules = [Self::Schedule, Self::ChiSquare];
        let found = rules.into_iter().find(|rule| rule.to_string() == text);
        found.ok_or_else(|| UnknownRadiusRule {
            found: text.to_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_follows_from_what_the_map_carries() {
        let rule = |caustics| {
            RadiusRule::of(&Lighting {
                caustics,
                ..Lighting::default()
            })
        };
        assert_eq!(rule(Caustics::OWN), RadiusRule::Schedule);
        assert_eq!(rule(Caustics::Map), RadiusRule::ChiSquare);
    }

    #[test]
    fn names_are_read_as_they_are_written() {
        for rule in [RadiusRule::Schedule, RadiusRule::ChiSquare] {
            assert_eq!(rule.to_string().parse(), Ok(rule));
        }
        let said = "chi".parse::<RadiusRule>().unwrap_err().to_string();
        assert_eq!(
            said,
            "radius rule: found `chi`, expected schedule or chi-square"
        );
    }
}
