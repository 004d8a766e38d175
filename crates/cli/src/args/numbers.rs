//! Numbers on the command line. What is refused is told with the range that holds.

use std::ops::RangeInclusive;

use clap::Command;

/// Reads a whole number of `range`: `200000`, or shorter `2e5` and `200k`; `M` and `G` are 1e6 and 1e9.
pub fn count<T: Copy + TryFrom<u64> + Into<u64> + PartialOrd>(
    range: RangeInclusive<T>,
) -> impl Fn(&str) -> Result<T, String> + Clone {
    move |text| {
        let number = whole(text).and_then(|number| T::try_from(number).ok());
        let number = number.filter(|number| range.contains(number));
        number.ok_or_else(|| expected((*range.start()).into(), (*range.end()).into()))
    }
}

/// Reads a seed: any number of 64 bits.
pub fn seed(text: &str) -> Result<u64, String> {
    text.parse()
        .map_err(|_| format!("expected a whole number from 0 to {}", u64::MAX))
}

/// Reads a number over 0.
pub fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    number
        .filter(|number| number.is_finite() && *number > 0.0)
        .ok_or_else(|| "expected a number above 0".to_owned())
}

/// A small number that people read: `1e-9`, not 0.000000001.
pub fn short(number: f64) -> String {
    match number != 0.0 && number.abs() < 1e-3 {
        true => format!("{number:e}"),
        false => number.to_string(),
    }
}

/// Numbers of five digits and more have a shorter form that is worth telling.
const LONG: u64 = 10_000;

fn expected(first: u64, last: u64) -> String {
    let to = match last {
        u64::MAX => String::new(),
        last => format!(" to {last}"),
    };
    let shorter = match last >= LONG {
        true => "; 2e5, 200k and 2M are read too",
        false => "",
    };
    format!("expected a whole number from {first}{to}{shorter}")
}

/// The number in figures, or figures with `k`, `M`, `G` or an exponent after them; none where it is not whole.
fn whole(text: &str) -> Option<u64> {
    let (figures, zeros) = match text.char_indices().next_back()? {
        (at, 'k') => (&text[..at], 3),
        (at, 'M') => (&text[..at], 6),
        (at, 'G') => (&text[..at], 9),
        _ => match text.split_once(['e', 'E']) {
            Some((figures, zeros)) => (figures, digits(zeros)?.parse::<usize>().ok()?),
            None => (text, 0),
        },
    };
    let (whole, part) = figures.split_once('.').unwrap_or((figures, "0"));
    let part = digits(part)?.trim_end_matches('0');
    let zeros = u32::try_from(zeros.checked_sub(part.len())?).ok()?;
    let figures = format!("{}{part}", digits(whole)?).parse::<u64>().ok()?;
    figures.checked_mul(10_u64.checked_pow(zeros)?)
}

/// The text, if it is one figure or more and nothing else.
fn digits(text: &str) -> Option<&str> {
    let is_number = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some(text)
}

/// Lets options have negative numbers as values, so that these are refused as what they are and not as options that
/// do not exist.
pub fn with_negative_values(command: Command) -> Command {
    command.mut_subcommands(|command| {
        with_negative_values(command).mut_args(|argument| {
            let is_option = !argument.is_positional() && argument.get_action().takes_values();
            // `-16x16` is no number.
            let is_size = argument.get_id() == "size";
            argument
                .allow_negative_numbers(is_option)
                .allow_hyphen_values(is_size)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_have_short_forms() {
        for (text, number) in [
            ("0", Some(0)),
            ("007", Some(7)),
            ("200000", Some(200_000)),
            ("2e5", Some(200_000)),
            ("2E5", Some(200_000)),
            ("200k", Some(200_000)),
            ("1.5M", Some(1_500_000)),
            ("1.50e2", Some(150)),
            ("2G", Some(2_000_000_000)),
            ("5.0", Some(5)),
            ("18446744073709551615", Some(u64::MAX)),
            ("18446744073709551616", None),
            ("1e20", None),
            ("1e99999999999999999999", None),
            ("1.5", None),
            ("1.234k", Some(1234)),
            ("1.2345k", None),
            ("", None),
            ("k", None),
            ("e5", None),
            (".5k", None),
            ("5.k", None),
            ("-1", None),
            ("+1", None),
            ("1e-2", None),
            ("1 000", None),
            ("2m", None),
            ("1e", None),
            ("∞", None),
        ] {
            assert_eq!(whole(text), number, "{text}");
        }
    }

    #[test]
    fn what_is_refused_is_told_with_the_range() {
        let refused = |range: RangeInclusive<u64>, text| count(range)(text).unwrap_err();
        assert_eq!(
            refused(1..=64, "65"),
            "expected a whole number from 1 to 64"
        );
        assert_eq!(
            refused(1..=64, "-5"),
            "expected a whole number from 1 to 64"
        );
        assert_eq!(
            refused(2..=u64::MAX, "many"),
            "expected a whole number from 2; 2e5, 200k and 2M are read too"
        );
        assert_eq!(count(0..=u32::MAX)("3M"), Ok(3_000_000));
        assert!(count(0..=u32::MAX)("5G").is_err());
        assert!(
            seed("-1")
                .unwrap_err()
                .contains("from 0 to 18446744073709551615")
        );
        assert_eq!(seed("1"), Ok(1));
        for text in ["0", "-1", "nan", "inf", "x"] {
            assert!(positive(text).is_err(), "{text}");
        }
    }

    #[test]
    fn small_numbers_are_written_short() {
        let written = [0.0, 0.1, 1.0, 0.25, 1e-9, 2.5e-4].map(short);
        assert_eq!(written, ["0", "0.1", "1", "0.25", "1e-9", "2.5e-4"]);
    }
}
