//! Lists the fields of the default format that a scene does not need, with reasons.

use photoncube_render::{Prediction, SceneFacts, Trial};
use photoncube_spec::{Channels, PHOTON_FORMATS, PhotonFormat};
use serde::Serialize;

/// A field of the default format, compared with the fitted one's.
#[derive(Serialize)]
pub struct LeftOut {
    /// The name of the field.
    pub field: &'static str,
    /// The value of the default format.
    pub default: u32,
    /// The value of the fitted format.
    pub fitted: u32,
    /// The bits of a stored photon that the difference saves; negative where it takes more bits.
    pub bits_saved: i64,
    /// The measured reason.
    pub because: String,
}

/// The number of axes of a position.
const AXES: i64 = 3;

/// Compares field by field. The bits saved add up to the difference of the two formats.
pub fn left_out(chosen: &Trial, facts: &SceneFacts) -> Vec<LeftOut> {
    let (default, fitted) = (&PHOTON_FORMATS[0], &chosen.format);
    let prediction = chosen.predicted;
    let row = |field, of: fn(&PhotonFormat) -> u32, bits_each: i64, because| LeftOut {
        field,
        default: of(default),
        fitted: of(fitted),
        bits_saved: bits_each * (i64::from(of(default)) - i64::from(of(fitted))),
        because,
    };
    let channels = i64::from(fitted.power.channels.count());
    let mantissa = i64::from(default.power.mantissa_bits);
    let part = |error: f64| format!("its part of the error is {error:.3} of the noise");
    vec![
        row(
            "position bits",
            |f| f.position_bits,
            AXES,
            positions(&prediction),
        ),
        row(
            "query bits",
            |f| f.query_extra_bits,
            0,
            "no bits of a photon".to_owned(),
        ),
        row(
            "channels",
            |f| f.power.channels.count(),
            mantissa,
            colours(facts, fitted),
        ),
        row(
            "mantissa bits",
            |f| f.power.mantissa_bits,
            channels,
            part(prediction.power_error_over_noise),
        ),
        row(
            "exponent bits",
            |f| f.power.record_exponent_bits(),
            1,
            powers(facts),
        ),
    ]
}

/// The reason for the position bits. Even light means as many photons without a caustic or a shadow.
fn positions(prediction: &Prediction) -> String {
    let part = prediction.position_error_over_noise;
    let times = part / prediction.law_error_over_noise;
    format!(
        "its part of the error is {part:.3} of the noise, {times:.1} times that under even light"
    )
}

fn colours(facts: &SceneFacts, fitted: &PhotonFormat) -> String {
    let deviation = facts.colour_deviation;
    match fitted.power.channels {
        Channels::Mono => format!("all photons have one colour, to {deviation:.0e}"),
        Channels::Rgb => format!("colours differ by up to {:.0} %", 100.0 * deviation),
    }
}

fn powers(facts: &SceneFacts) -> String {
    let spread = facts.power_spread;
    format!("the strongest photon has {spread:.6} times the weakest's power")
}

#[cfg(test)]
mod tests {
    use photoncube_render::{Scene, fit};
    use photoncube_spec::Widths;

    use crate::fitted::quick_options;

    use super::*;

    #[test]
    fn the_bits_saved_add_up() {
        for scene in ["cornell", "ring"] {
            let scene = Scene::built_in(scene).unwrap();
            let fit = fit(&scene, &quick_options(), &|_| ()).unwrap();
            let chosen = fit.chosen.unwrap();
            let saved: i64 = (left_out(&chosen, &fit.facts).iter())
                .map(|row| row.bits_saved)
                .sum();
            let default = Widths::of_format(&PHOTON_FORMATS[0]).bits_per_photon;
            assert_eq!(
                saved,
                i64::from(default) - i64::from(chosen.bits_per_photon())
            );
        }
    }
}
