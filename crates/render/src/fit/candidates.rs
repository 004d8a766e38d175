//! The formats that a fit chooses from, the cheapest first, and the formats with one bit less than a given
//! one.

use std::ops::RangeInclusive;

use photoncube_spec::{Channels, Exponent, PhotonFormat, PowerFormat, Rounding, Widths};

use super::facts::SceneFacts;

const POSITION_BITS: RangeInclusive<u32> = 4..=12;
const QUERY_EXTRA_BITS: RangeInclusive<u32> = 0..=2;
const MANTISSA_BITS: RangeInclusive<u32> = 1..=16;
const EXPONENT_BITS: RangeInclusive<u32> = 1..=8;

/// The margin of the largest query. A query of the picture may test more photons than any of the pilot:
/// another map, more points of the view, and with more photons a smaller radius, which resolves a caustic's
/// crest. The margin is a factor of two, and the result is rounded up to a power of two.
const LARGEST_QUERY_MARGIN: u64 = 2;

/// The cost of a format as a sort key: first memory, then the squarers' width, then the adders' width. Of
/// equal formats the one without dither comes first, because it needs less explanation.
pub(super) fn cost(format: &PhotonFormat) -> impl Ord + use<> {
    let widths = Widths::of_format(format);
    (
        widths.bits_per_photon,
        widths.difference,
        widths.power,
        format.power.rounding == Rounding::Dithered,
        format.power.mantissa_bits,
    )
}

/// All formats for such light, in the order of their cost.
pub(super) fn candidates(facts: &SceneFacts, max_photons: u64) -> Vec<PhotonFormat> {
    let powers = powers(facts);
    let positions = POSITION_BITS.flat_map(|p| QUERY_EXTRA_BITS.map(move |x| (p, x)));
    let formats = positions.flat_map(|(position_bits, query_extra_bits)| {
        powers.iter().map(move |power| PhotonFormat {
            position_bits,
            query_extra_bits,
            power: *power,
            max_photons,
        })
    });
    let mut formats: Vec<PhotonFormat> = formats.collect();
    formats.sort_by_cached_key(cost);
    formats
}

fn powers(facts: &SceneFacts) -> Vec<PowerFormat> {
    let channels = match facts.one_colour {
        true => Channels::Mono,
        false => Channels::Rgb,
    };
    let exponents: Vec<Exponent> = exponents(facts.power_spread);
    let pairs = MANTISSA_BITS.flat_map(|m| exponents.iter().map(move |e| (m, *e)));
    let both = [Rounding::Nearest, Rounding::Dithered];
    let power = pairs.flat_map(|(mantissa_bits, exponent)| {
        both.map(|rounding| PowerFormat {
            channels,
            mantissa_bits,
            exponent,
            rounding,
        })
    });
    power.collect()
}

/// No exponent, and exponents of a block or a photon with no more range than the spread of the light: a
/// photon of power P has an exponent below the largest only where the strongest power is at least 2 P.
fn exponents(power_spread: f64) -> Vec<Exponent> {
    let useful = power_spread.log2().floor();
    let narrower_is_enough = |bits: u32| bits > 1 && range(bits - 1) >= useful;
    let bits = EXPONENT_BITS.take_while(|bits| useful > 0.0 && !narrower_is_enough(*bits));
    let pairs = bits.flat_map(|bits| [Exponent::Block { bits }, Exponent::Photon { bits }]);
    std::iter::once(Exponent::None).chain(pairs).collect()
}

/// The largest exponent that these bits hold.
fn range(bits: u32) -> f64 {
    let power = PowerFormat {
        channels: Channels::Mono,
        mantissa_bits: 1,
        exponent: Exponent::Photon { bits },
        rounding: Rounding::Nearest,
    };
    power.exponent_range().into()
}

/// The size of the sums: the largest query found with its margin, or the known largest query.
pub(super) fn max_photons(found: u64, known: u64) -> u64 {
    let most = (LARGEST_QUERY_MARGIN * found).max(known);
    most.max(1).next_power_of_two()
}

/// Every legal format with one bit, or one degree of freedom, less than this one, with the name of what is
/// less.
pub(super) fn one_bit_less(format: &PhotonFormat) -> Vec<(&'static str, PhotonFormat)> {
    let power = format.power;
    let with = |power| PhotonFormat { power, ..*format };
    let mut less = vec![
        (
            "position bit",
            PhotonFormat {
                position_bits: format.position_bits - 1,
                ..*format
            },
        ),
        (
            "mantissa bit",
            with(PowerFormat {
                mantissa_bits: power.mantissa_bits - 1,
                ..power
            }),
        ),
    ];
    if format.query_extra_bits > 0 {
        let query_extra_bits = format.query_extra_bits - 1;
        let fewer = PhotonFormat {
            query_extra_bits,
            ..*format
        };
        less.push(("query bit", fewer));
    }
    let fewer = smaller_exponents(power.exponent);
    let fewer = fewer
        .into_iter()
        .map(|(what, exponent)| (what, with(PowerFormat { exponent, ..power })));
    less.extend(fewer);
    if power.rounding == Rounding::Dithered {
        let rounding = Rounding::Nearest;
        less.push(("dither", with(PowerFormat { rounding, ..power })));
    }
    if power.channels == Channels::Rgb {
        let channels = Channels::Mono;
        less.push(("two channels", with(PowerFormat { channels, ..power })));
    }
    less.retain(|(_, format)| format.check().is_ok());
    less
}

fn smaller_exponents(exponent: Exponent) -> Vec<(&'static str, Exponent)> {
    let bit = "exponent bit";
    match exponent {
        Exponent::None => vec![],
        Exponent::Block { bits: 1 } => vec![(bit, Exponent::None)],
        Exponent::Block { bits } => vec![(bit, Exponent::Block { bits: bits - 1 })],
        Exponent::Photon { bits: 1 } => vec![(bit, Exponent::None)],
        Exponent::Photon { bits } => vec![
            (bit, Exponent::Photon { bits: bits - 1 }),
            ("photon's own exponent", Exponent::Block { bits }),
        ],
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_photon_format;

    use super::*;

    fn facts(one_colour: bool, power_spread: f64) -> SceneFacts {
        SceneFacts {
            colour_deviation: 0.0,
            one_colour,
            power_spread,
            largest_query: 1000,
        }
    }

    #[test]
    fn candidates_are_legal_and_in_order() {
        let formats = candidates(&facts(false, 2e6), max_photons(1000, 0));
        assert!(formats.iter().all(|format| format.check().is_ok()));
        assert!(formats.is_sorted_by_key(cost));
        assert!(formats.iter().all(|format| format.max_photons == 2048));
        let name = formats[0].name();
        assert_eq!(name, "local4-rgb1-n2048");
    }

    #[test]
    fn one_colour_gets_one_channel_and_equal_powers_no_exponent() {
        let formats = candidates(&facts(true, 1.0), 4);
        let powers = || formats.iter().map(|format| format.power);
        assert!(powers().all(|power| power.channels == Channels::Mono));
        assert!(powers().all(|power| power.exponent == Exponent::None));
    }

    /// 2e6 is 2^20.9: the ranges are 1, 3, 7, 15 and, large enough, 24.
    #[test]
    fn exponents_hold_the_spread_and_no_more() {
        assert_eq!(exponents(1.99).len(), 1);
        assert_eq!(exponents(2.0).len(), 3);
        assert_eq!(exponents(2e6).len(), 11);
        assert_eq!(exponents(1e300).len(), 17);
    }

    #[test]
    fn sums_hold_twice_what_was_found_or_what_is_known() {
        assert_eq!(max_photons(1025, 0), 4096);
        assert_eq!(max_photons(1025, 4097), 8192);
        assert_eq!(max_photons(0, 0), 1);
    }

    #[test]
    fn one_bit_less_of_every_field() {
        let names = |name| -> Vec<String> {
            let format = find_photon_format(name).unwrap();
            let less = one_bit_less(&format);
            less.iter()
                .map(|(what, format)| format!("{what}: {format}"))
                .collect()
        };
        assert_eq!(
            names("local6x2-rgb5e3d"),
            [
                "position bit: local5x2-rgb5e3d",
                "mantissa bit: local6x2-rgb4e3d",
                "query bit: local6x1-rgb5e3d",
                "exponent bit: local6x2-rgb5e2d",
                "photon's own exponent: local6x2-rgb5b3d",
                "dither: local6x2-rgb5e3",
                "two channels: local6x2-mono5e3d",
            ]
        );
        assert_eq!(names("local4-mono1b1"), ["exponent bit: local4-mono1"]);
    }
}
