//! Overrides for the squarer from digits: the products of the two digits, and the sum of their squares and
//! products.

use super::chain::{Bit, bit, cells};
use super::ports::Ports;

/// The two digit products. Each adds two rows of the high digit, the second row one place up. Where the low
/// digit has three bits, the second product is one row and no sum.
pub(super) fn digit_products(ports: &Ports) -> String {
    const HIGH: usize = photoncube_spec::Widths::HIGH_DIGIT as usize;
    let product = ports.width("high_product");
    let low_digit = if product == HIGH { 3 } else { 4 };
    let high = |i: usize| bit("magnitude", low_digit + i);
    let rows = |name: &str, first: usize| {
        let [lower, upper] = [first, first + 1].map(|i| bit("magnitude", i));
        let and =
            |a: String, b: &str| Bit::new(&[a, b.to_owned()], |[a, b, ..]| a & b, |_, _| false);
        let mut bits = vec![and(high(0), &lower)];
        bits.extend((1..HIGH).map(|i| {
            Bit::new(
                &[high(i), lower.clone(), high(i - 1), upper.clone()],
                |[a, b, c, d]| (a & b) ^ (c & d),
                |a, b| a & b,
            )
        }));
        bits.push(and(high(HIGH - 1), &upper));
        bits.push(Bit::carry());
        cells(bits)
            .replace("chain", &format!("{name}_chain"))
            .replace("carry", &format!("{name}_carry"))
            .replace("pair_", &format!("{name}_pair_"))
            + &format!("    assign {name} = {name}_chain[{}:0];\n", HIGH + 1)
    };
    let second = match low_digit {
        3 => format!(
            "    assign high_product = magnitude[{}:{low_digit}] & {{{HIGH}{{magnitude[2]}}}};\n",
            low_digit + HIGH - 1
        ),
        _ => rows("high_product", 2),
    };
    rows("low_product", 0) + &second
}

/// The sum of the squares of both digits, side by side, and of twice their product. A bit of a square that
/// depends on few bits of its digit needs no LUT before the chain.
pub(super) fn square_sum(ports: &Ports) -> String {
    const HIGH: usize = photoncube_spec::Widths::HIGH_DIGIT as usize;
    let (radius, square) = (ports.width("magnitude"), ports.width("square"));
    let low = radius - HIGH;
    let place = low + 1;
    let mut text = String::new();
    let mut table = |index: usize| {
        let bit = SquareBit::of(index, low);
        text += &format!("    wire table_{index} = {};\n", bit.expression());
        bit
    };
    let below: Vec<_> = (0..place).map(&mut table).collect();
    let bits: Vec<_> = (place..square)
        .map(|index| {
            let cross = (index - place < radius).then(|| bit("cross_product", index - place));
            table(index).plus(cross)
        })
        .collect();
    let below: Vec<_> = (0..below.len())
        .rev()
        .map(|i| format!("table_{i}"))
        .collect();
    text + &cells(bits)
        + &format!(
            "    assign square = {{chain[{}:0], {}}};\n",
            square - place - 1,
            below.join(", ")
        )
}

/// A bit of the squares of the two digits of `magnitude`, as a function of bits of one digit.
struct SquareBit {
    index: usize,
    /// The bits of `magnitude` that the bit depends on.
    inputs: Vec<usize>,
    /// The bit's value for each value of `inputs`.
    table: Vec<bool>,
}

impl SquareBit {
    fn of(index: usize, low: usize) -> Self {
        const HIGH: usize = photoncube_spec::Widths::HIGH_DIGIT as usize;
        let (first, width, power) = match index.checked_sub(2 * low) {
            Some(power) => (low, HIGH, power),
            None => (0, low, index),
        };
        let value = |digit: usize| (digit * digit) >> power & 1 == 1;
        let matters =
            |bit: &usize| (0..1 << width).any(|digit| value(digit) != value(digit ^ 1 << bit));
        let bits: Vec<_> = (0..width).filter(matters).collect();
        let spread = |packed: usize| {
            let places = bits.iter().enumerate();
            places.map(|(from, to)| (packed >> from & 1) << to).sum()
        };
        Self {
            index,
            table: (0..1 << bits.len())
                .map(|packed| value(spread(packed)))
                .collect(),
            inputs: bits.iter().map(|bit| first + bit).collect(),
        }
    }

    fn value(&self, bits: &[bool]) -> bool {
        let packed = bits
            .iter()
            .enumerate()
            .map(|(place, &bit)| usize::from(bit) << place);
        self.table[packed.sum::<usize>()]
    }

    /// The bit as a sum of products, in Verilog.
    fn expression(&self) -> String {
        let ones = (0..self.table.len()).filter(|&packed| self.table[packed]);
        let product = |packed: usize| {
            let literals = self.inputs.iter().enumerate().map(|(place, &input)| {
                let not = if packed >> place & 1 == 1 { "" } else { "~" };
                format!("{not}magnitude[{input}]")
            });
            format!("({})", literals.collect::<Vec<_>>().join(" & "))
        };
        let products: Vec<_> = ones.map(product).collect();
        match products.as_slice() {
            [] => "1'b0".to_owned(),
            products => products.join(" | "),
        }
    }

    /// The carry-chain bit for the sum of this bit and `other`, or for this bit alone.
    fn plus(&self, other: Option<String>) -> Bit {
        let name = |input: &usize| bit("magnitude", *input);
        let own: Vec<_> = self.inputs.iter().map(name).collect();
        let own = |order: &[usize]| order.iter().map(|&i| own[i].clone()).collect::<Vec<_>>();
        match (other, self.order()) {
            (Some(other), Some(order)) if self.inputs.len() < 4 => {
                let inputs = [vec![other], own(&order)].concat();
                Bit::new(
                    &inputs,
                    |[a, rest @ ..]| a ^ self.ordered(&order, &rest),
                    |a, _| a,
                )
            }
            (Some(other), _) => {
                let inputs = [other, format!("table_{}", self.index)];
                Bit::new(&inputs, |[a, b, ..]| a ^ b, |a, _| a)
            }
            (None, Some(order)) => Bit::new(
                &own(&order),
                |bits| self.ordered(&order, &bits),
                |_, _| false,
            ),
            (None, None) => Bit::new(
                &[format!("table_{}", self.index)],
                |[a, ..]| a,
                |_, _| false,
            ),
        }
    }

    /// An order of the inputs in which the bit is 0 where the last two inputs are 0: the LUT's lowest bits,
    /// where C and D are 0, are also g. With an unused input, D is 1 and any order is possible.
    fn order(&self) -> Option<Vec<usize>> {
        let count = self.inputs.len();
        if count < 3 {
            return Some((0..count).collect());
        }
        let pairs = (0..count).flat_map(|c| (0..c).map(move |d| [c, d]));
        let is_zero = |[c, d]: &[usize; 2]| {
            (0..self.table.len())
                .all(|packed| packed >> c & 1 == 1 || packed >> d & 1 == 1 || !self.table[packed])
        };
        let [c, d] = pairs.into_iter().find(is_zero)?;
        let others = (0..count).filter(|&i| i != c && i != d);
        Some(others.chain([c, d]).collect())
    }

    fn ordered(&self, order: &[usize], bits: &[bool]) -> bool {
        let mut inputs = vec![false; order.len()];
        for (&input, &bit) in order.iter().zip(bits) {
            inputs[input] = bit;
        }
        self.value(&inputs)
    }
}
