//! Parses and prints the parts of a [`super::Lighting`].

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use super::{Area, Caustics, DirectLight};

/// The error of a text that is not the name of a lighting.
#[derive(Debug, Clone, Error, PartialEq, Eq)]
#[error("{what}: found `{found}`, expected {expected}")]
pub struct UnknownLighting {
    /// The part of the lighting that is wrong.
    pub what: &'static str,
    /// The text that was given.
    pub found: String,
    /// The texts that are legal there.
    pub expected: &'static str,
}

impl UnknownLighting {
    fn of(what: &'static str, found: &str, expected: &'static str) -> Self {
        Self {
            what,
            found: found.to_owned(),
            expected,
        }
    }
}

impl fmt::Display for DirectLight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Map => write!(f, "map"),
            Self::Rays(rays) => write!(f, "rays:{rays}"),
        }
    }
}

impl FromStr for DirectLight {
    type Err = UnknownLighting;

    fn from_str(text: &str) -> Result<Self, UnknownLighting> {
        let error = || UnknownLighting::of("direct light", text, "map or rays[:N], N from 1");
        match text.split_once(':') {
            None if text == "map" => Ok(Self::Map),
            None if text == "rays" => Ok(Self::Rays(1)),
            Some(("rays", rays)) => match rays.parse() {
                Ok(rays) if rays > 0 => Ok(Self::Rays(rays)),
                _ => Err(error()),
            },
            _ => Err(error()),
        }
    }
}

impl fmt::Display for Caustics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Map => write!(f, "map"),
            Self::Own(in_range) => write!(f, "own:{in_range}"),
        }
    }
}

impl FromStr for Caustics {
    type Err = UnknownLighting;

    fn from_str(text: &str) -> Result<Self, UnknownLighting> {
        let expected = "map or own[:N], N photons in range, over 0";
        let error = || UnknownLighting::of("caustics", text, expected);
        match text.split_once(':') {
            None if text == "map" => Ok(Self::Map),
            None if text == "own" => Ok(Self::OWN),
            Some(("own", in_range)) => match in_range.parse::<f64>() {
                Ok(in_range) if in_range > 0.0 && in_range.is_finite() => Ok(Self::Own(in_range)),
                _ => Err(error()),
            },
            _ => Err(error()),
        }
    }
}

impl fmt::Display for Area {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Disc => "disc",
            Self::Covered => "covered",
        })
    }
}

impl FromStr for Area {
    type Err = UnknownLighting;

    fn from_str(text: &str) -> Result<Self, UnknownLighting> {
        match text {
            "disc" => Ok(Self::Disc),
            "covered" => Ok(Self::Covered),
            _ => Err(UnknownLighting::of("area", text, "disc or covered")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_as_they_are_written() {
        for text in ["map", "rays:1", "rays:16"] {
            assert_eq!(text.parse::<DirectLight>().unwrap().to_string(), text);
        }
        for text in ["map", "own:50", "own:12.5"] {
            assert_eq!(text.parse::<Caustics>().unwrap().to_string(), text);
        }
        for text in ["disc", "covered"] {
            assert_eq!(text.parse::<Area>().unwrap().to_string(), text);
        }
        assert_eq!("rays".parse(), Ok(DirectLight::Rays(1)));
        assert_eq!("own".parse(), Ok(Caustics::OWN));
    }

    #[test]
    fn other_names_are_errors_that_say_what_could_stand_there() {
        for text in ["", "rays:0", "rays:", "ray", "map:1", "rays:-1"] {
            let error = text.parse::<DirectLight>().unwrap_err().to_string();
            assert!(error.contains("map or rays[:N]"), "{error}");
        }
        for text in ["own:0", "own:inf", "own:nan", "owned"] {
            assert!(text.parse::<Caustics>().is_err(), "{text}");
        }
        assert!("pi".parse::<Area>().is_err());
    }
}
