//! Finds round numbers along a logarithmic axis.

use crate::table::significant;

/// The fewest numbers with which an axis can be read.
const FEWEST: usize = 4;

/// The leading digits of the numbers, from coarse to fine.
const DIGITS: [&[f64]; 5] = [
    &[1.0],
    &[1.0, 3.0],
    &[1.0, 2.0, 5.0],
    &[1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0],
    &[1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0],
];

/// Round numbers from `low` to `high`, both over 0: the coarsest set of at least four. Where even the finest
/// logarithmic set has fewer, multiples of a round step.
pub fn round(low: f64, high: f64) -> Vec<f64> {
    let decades = low.log10().floor() as i32..=high.log10().ceil() as i32;
    let of = |digits: &[f64]| -> Vec<f64> {
        let numbers = decades.clone().flat_map(|decade| {
            let scale = 10_f64.powi(decade);
            digits.iter().map(move |digit| digit * scale)
        });
        numbers.filter(|n| (low..=high).contains(n)).collect()
    };
    let sets = DIGITS.map(of);
    let enough = sets.iter().find(|ticks| ticks.len() >= FEWEST);
    enough.map_or_else(|| multiples(low, high), Clone::clone)
}

/// Multiples of 1, 2 or 5 times a power of ten, at least four.
fn multiples(low: f64, high: f64) -> Vec<f64> {
    let most = (high - low) / FEWEST as f64;
    let decade = 10_f64.powf(most.log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|digit| digit * decade);
    let step = steps.into_iter().find(|step| *step <= most);
    let step = step.unwrap_or(decade);
    // `as` saturates.
    let numbers = (low / step).ceil() as u64..=(high / step).floor() as u64;
    numbers.map(|number| number as f64 * step).collect()
}

/// The numbers 1, 2, 4, 8, ... from `low` to `high`, for whole quantities.
pub fn doublings(low: f64, high: f64) -> Vec<f64> {
    let powers = (0..64).map(|power| 2_f64.powi(power));
    powers.filter(|n| (low..=high).contains(n)).collect()
}

/// A number in few characters, with k and M for thousands and millions.
pub fn short(number: f64) -> String {
    let (scaled, unit) = match number {
        n if n >= 1e6 => (n / 1e6, " M"),
        n if n >= 1e3 => (n / 1e3, " k"),
        n => (n, ""),
    };
    format!("{}{unit}", two_digits(scaled))
}

/// A fraction as per cent.
pub fn percent(part: f64) -> String {
    format!("{} %", two_digits(100.0 * part))
}

/// Two significant digits, or all before the point, without zeros at the end.
fn two_digits(number: f64) -> String {
    let text = significant(number, 2);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_enough_ticks_at_any_span() {
        for (low, high) in [
            (0.03, 45.0),
            (18.0, 80.0),
            (0.02, 0.5),
            (1.0, 1.9),
            (1e-9, 1e9),
        ] {
            let ticks = round(low, high);
            assert!(ticks.len() >= FEWEST, "{low} {high}: {ticks:?}");
            assert!(ticks.iter().all(|tick| (low..=high).contains(tick)));
        }
        assert_eq!(round(0.05, 50.0).first(), Some(&0.1));
        // No more numbers than there is room for their labels.
        assert!(round(5e4, 7e5).len() < 9, "{:?}", round(5e4, 7e5));
    }

    #[test]
    fn counts_have_whole_ticks() {
        assert_eq!(doublings(1.8, 20.0), [2.0, 4.0, 8.0, 16.0]);
        assert_eq!(doublings(0.9, 1.25), [1.0]);
    }

    #[test]
    fn numbers_are_short() {
        let said = [3.0, 2e4, 5e6, 0.3, 0.03, 1.5, 45.0, 150.0, 1500.0].map(short);
        assert_eq!(
            said,
            [
                "3", "20 k", "5 M", "0.3", "0.03", "1.5", "45", "150", "1.5 k"
            ]
        );
        assert_eq!([1.0, 0.05, 0.001].map(percent), ["100 %", "5 %", "0.1 %"]);
    }
}
