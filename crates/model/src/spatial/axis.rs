//! One photon's difference on one axis, and its square by each implementation of the squarer.

use photoncube_spec::{Cut, Squarer};

use super::rules::Rules;

/// A square, and whether |d| exceeds r bits. The square of a far axis is never used, but it is visible in the
/// registers, and the model has its exact value.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Square {
    /// The word of the square: d^2 or the half square modulo 2^(2 r) from a table or product, (|d| modulo 2^r)^2
    /// from digits.
    pub(super) word: u64,
    pub(super) far: bool,
}

/// d| modulo 2^r, and whether |d| exceeds r bits.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Magnitude {
    pub(super) word: u32,
    pub(super) far: bool,
}

/// d| modulo 2^r and the two products of its digits.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Products {
    pub(super) magnitude: Magnitude,
    pub(super) low: u64,
    pub(super) high: u64,
}

/// d| modulo 2^r and the product of its two digits.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Crossed {
    pub(super) magnitude: Magnitude,
    pub(super) cross: u64,
}

/// The registers of one axis of one lane. Registers of the other kinds of squarer stay 0.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Axis {
    pub(super) difference: i32,
    pub(super) magnitude: u32,
    pub(super) magnitude_delay: i32,
    pub(super) products: Products,
    pub(super) products_delay: i32,
    pub(super) crossed: Crossed,
    pub(super) lookup: Square,
    pub(super) product: u64,
    pub(super) square: Square,
    pub(super) square_delay: Square,
}

impl Axis {
    /// Applies one clock and returns the value after `Cut::SquareDelay`.
    pub(super) fn clock(&mut self, rules: &Rules, query: u32, photon: u32) -> Square {
        let d = query as i32 - rules.place(photon) as i32;
        let d = rules.cut(Cut::Difference, &mut self.difference, d);
        let square = match rules.kind.squarer {
            Squarer::Digits => self.digits_square(rules, d),
            Squarer::Product => self.product_square(rules, d),
            Squarer::Table => self.table_square(rules, d),
        };
        let square = rules.cut(Cut::Square, &mut self.square, square);
        rules.cut(Cut::SquareDelay, &mut self.square_delay, square)
    }

    fn digits_square(&mut self, rules: &Rules, d: i32) -> Square {
        let magnitude = rules.cut(Cut::Magnitude, &mut self.magnitude, d.unsigned_abs());
        let magnitude = Magnitude::of(rules, magnitude);
        let [high, low] = digits(rules, magnitude);
        let products = Products {
            magnitude,
            low: high * (low % 4),
            high: high * (low / 4),
        };
        let products = rules.cut(Cut::Products, &mut self.products, products);
        let crossed = Crossed {
            magnitude: products.magnitude,
            cross: products.low + 4 * products.high,
        };
        let crossed = rules.cut(Cut::Cross, &mut self.crossed, crossed);
        // (high 2^l + low)^2 contains the product of the digits twice, l bits up.
        let [high, low] = digits(rules, crossed.magnitude);
        let low_digit = rules.widths.low_digit();
        let squares = (high.pow(2) << (2 * low_digit)) + low.pow(2);
        Square {
            word: squares + (crossed.cross << (low_digit + 1)),
            far: crossed.magnitude.far,
        }
    }

    /// The difference before `Cut::Cross`, for a squarer that needs no digits.
    fn delayed(&mut self, rules: &Rules, d: i32) -> i32 {
        let d = rules.cut(Cut::Magnitude, &mut self.magnitude_delay, d);
        rules.cut(Cut::Products, &mut self.products_delay, d)
    }

    fn table_square(&mut self, rules: &Rules, d: i32) -> Square {
        let d = self.delayed(rules, d);
        let lookup = Square::of_product(rules, rules.power(d));
        rules.cut(Cut::Cross, &mut self.lookup, lookup)
    }

    fn product_square(&mut self, rules: &Rules, d: i32) -> Square {
        let d = self.delayed(rules, d);
        let product = rules.cut(Cut::Cross, &mut self.product, rules.power(d));
        Square::of_product(rules, product)
    }
}

impl Magnitude {
    fn of(rules: &Rules, magnitude: u32) -> Self {
        let word = magnitude % (1 << rules.widths.difference);
        Self {
            word,
            far: word != magnitude,
        }
    }
}

/// The high and the low digit of a magnitude.
fn digits(rules: &Rules, magnitude: Magnitude) -> [u64; 2] {
    let word = u64::from(magnitude.word);
    let low_digit = rules.widths.low_digit();
    [word >> low_digit, word % (1 << low_digit)]
}

impl Square {
    /// Reduces the full square to 2 r bits.
    fn of_product(rules: &Rules, product: u64) -> Self {
        let word = product % (1 << rules.widths.square);
        Self {
            word,
            far: word != product,
        }
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{Cut, Cuts, Machine, Organisation, Spatial, find_machine};

    use super::*;

    fn rules(machine: &Machine, squarer: Squarer, cuts: &[Cut]) -> Rules {
        let spatial = Spatial {
            cuts: Cuts::of(cuts),
            ..*machine.spatial().unwrap()
        };
        let machine = Machine {
            squarer,
            organisation: Organisation::Spatial(spatial),
            ..*machine
        };
        Rules::of(&machine, &spatial, 0)
    }

    /// Tests all differences, for both numbers of radius bits that squarers are made for.
    #[test]
    fn each_squarer_is_exact_up_to_r_bits_and_far_beyond() {
        for name in ["stream", "tile-5"] {
            let machine = find_machine(name).unwrap();
            for squarer in [Squarer::Digits, Squarer::Product, Squarer::Table] {
                let rules = rules(machine, squarer, &[]);
                let modulus = 1_u64 << rules.widths.square;
                for magnitude in 0..1_u32 << rules.widths.coordinate {
                    let [right, left] = [[magnitude, 0], [0, magnitude]]
                        .map(|[query, photon]| Axis::default().clock(&rules, query, photon));
                    assert_eq!(right, left);
                    assert_eq!(right.far, magnitude >> rules.widths.difference != 0);
                    let inside = u64::from(magnitude % (1 << rules.widths.difference));
                    let expected = match squarer {
                        Squarer::Digits => inside.pow(2),
                        Squarer::Product | Squarer::Table => u64::from(magnitude).pow(2) % modulus,
                    };
                    assert_eq!(right.word, expected, "{squarer:?} of {magnitude}");
                }
            }
        }
    }

    /// At each place with a register, the value is that of the clock before.
    #[test]
    fn a_value_takes_a_clock_for_each_register() {
        let machine = find_machine("stream").unwrap();
        let all = [
            Cut::Difference,
            Cut::Magnitude,
            Cut::Products,
            Cut::Cross,
            Cut::Square,
            Cut::SquareDelay,
        ];
        for squarer in [Squarer::Digits, Squarer::Product, Squarer::Table] {
            for count in 0..=all.len() {
                let rules = rules(machine, squarer, &all[..count]);
                let mut axis = Axis::default();
                let seen: Vec<_> = (1..20).map(|q| axis.clock(&rules, q, 0).word).collect();
                let squares: Vec<_> = (1..20 - count as u64).map(|q| q.pow(2)).collect();
                assert!(seen[..count].iter().all(|&word| word == 0));
                assert_eq!(seen[count..], squares);
            }
        }
    }
}
