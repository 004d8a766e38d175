//! Carry chains for the ECP5, in place of the emitted modules that add words of simple functions.
//!
//! A carry cell of an ECP5, CCU2C, has a LUT before each of its two adder bits. Yosys puts only plain
//! words there and spends LUTs on what stands before an adder: the AND of a gate, the inversion
//! of a subtrahend or of a negative difference. So each such module has a second text, which names
//! the carry cells. The first is what is simulated and what other devices are built from; that both
//! are the same function is proven for every module by `scripts/yosys/ecp5.sh`.
//!
//! In a bit of a CCU2C, `p` is a LUT of A, B, C, D; the sum is `p ^ carry`; the carry goes on where p
//! is 1, and is else `g`, the LUT's lowest four bits seen as a table of A and B alone (Lattice,
//! FPGA-TN-02205, and Yosys's model). For a sum of two bits x + y: p = x ^ y, and g = x where x
//! depends on A and B only.

use super::modules::{Module, split};

/// The second text of all modules that have one; none if no module has.
pub(super) fn carry_chains(text: &str) -> Option<String> {
    let modules = split(text);
    let chained: Vec<_> = modules.iter().filter_map(chained).collect();
    (!chained.is_empty()).then(|| chained.concat())
}

/// A module's second text: the same ports, and a carry chain.
fn chained(module: &Module) -> Option<String> {
    let ports = Ports::of(module);
    let named = |base: &str| {
        let (_, last) = module.name.rsplit_once(base)?;
        let numbered = last
            .strip_prefix('_')
            .is_some_and(|n| n.parse::<u32>().is_ok());
        (last.is_empty() || numbered).then_some(())
    };
    let body = None
        .or_else(|| named("_subtract").map(|()| subtract(&ports)))
        .or_else(|| named("_magnitude_of").map(|()| magnitude(&ports)))
        .or_else(|| named("_digit_products").map(|()| digit_products(&ports)))
        .or_else(|| named("_square_sum").map(|()| square_sum(&ports)))
        .or_else(|| named("_range_of_query").map(|()| range_of_query(&ports)))
        .or_else(|| named("_gated_sum").map(|()| gated_sum(&ports)))
        .or_else(|| named("_accumulate").map(|()| accumulate(&ports)))
        .or_else(|| named("_chosen_sum").map(|()| chosen_sum(&ports)))?;
    Some(format!(
        "\nmodule {}{}{}endmodule\n",
        module.name, ports.declaration, body
    ))
}

/// A module's ports as it declares them.
struct Ports {
    /// The list and the declarations, with all outputs as wires.
    declaration: String,
    widths: Vec<(String, usize)>,
}

impl Ports {
    fn of(module: &Module) -> Self {
        let is_port = |line: &&str| {
            let line = line.trim_start();
            // Not the inputs of functions, which are no wires.
            ["input wire ", "output wire ", "output reg "]
                .iter()
                .any(|kind| line.starts_with(kind))
        };
        let end = module.body.find(";\n").map_or(0, |at| at + 2);
        let declared: Vec<_> = module.body[end..].lines().filter(is_port).collect();
        let text: String = declared
            .iter()
            .map(|line| line.replace("output reg", "output wire") + "\n")
            .collect();
        Self {
            declaration: module.body[..end].to_owned() + &text,
            widths: declared.iter().filter_map(|line| port(line)).collect(),
        }
    }

    fn width(&self, name: &str) -> usize {
        let port = self.widths.iter().find(|(port, _)| port == name);
        port.expect("the module has the ports of its block").1
    }
}

/// Name and width of a declared port.
fn port(line: &str) -> Option<(String, usize)> {
    let line = line.trim().trim_end_matches(';');
    let name = line.rsplit(' ').next()?.to_owned();
    let width = match line
        .split_once('[')
        .and_then(|(_, rest)| rest.split_once(':'))
    {
        Some((high, _)) => high.parse::<usize>().ok()? + 1,
        None => 1,
    };
    Some((name, width))
}

/// A bit of a carry chain: the inputs of its LUT, where `1'b1` is what is not used, and the LUT.
struct Bit {
    inputs: [String; 4],
    lut: u16,
}

/// The LUT of a bit, from p(A, B, C, D) and g(A, B); where C and D are 0, p must be g.
fn lut(p: impl Fn([bool; 4]) -> bool, g: impl Fn(bool, bool) -> bool) -> u16 {
    let mut table = 0;
    for index in 0..16_u16 {
        let [a, b, c, d] = [0, 1, 2, 3].map(|bit| index >> bit & 1 == 1);
        let value = if c || d { p([a, b, c, d]) } else { g(a, b) };
        table |= u16::from(value) << index;
    }
    table
}

impl Bit {
    fn new(
        inputs: &[String],
        p: impl Fn([bool; 4]) -> bool,
        g: impl Fn(bool, bool) -> bool,
    ) -> Self {
        let unused = || "1'b1".to_owned();
        let input = |index: usize| inputs.get(index).cloned().unwrap_or_else(unused);
        Self {
            inputs: [input(0), input(1), input(2), input(3)],
            lut: lut(p, g),
        }
    }

    /// Shows the carry that comes in, and sends none on.
    fn carry() -> Self {
        Self::new(&[], |_| false, |_, _| false)
    }
}

fn bit(word: &str, index: usize) -> String {
    format!("{word}[{index}]")
}

/// The chain's cells; its sum bits are `chain`.
fn cells(mut bits: Vec<Bit>) -> String {
    if bits.len() % 2 == 1 {
        bits.push(Bit::carry());
    }
    let pairs = bits.len() / 2;
    let mut text = format!(
        "    wire [{}:0] chain;\n    wire [{pairs}:0] carry;\n    assign carry[0] = 1'b0;\n",
        bits.len() - 1
    );
    for (pair, halves) in bits.chunks(2).enumerate() {
        let inputs = |half: usize| {
            let named = ["A", "B", "C", "D"].into_iter().zip(&halves[half].inputs);
            let inputs: Vec<_> = named
                .map(|(name, input)| format!(".{name}{half}({input})"))
                .collect();
            inputs.join(", ")
        };
        text += &format!(
            "    CCU2C #(.INIT0(16'h{:04x}), .INIT1(16'h{:04x}), .INJECT1_0(\"NO\"), .INJECT1_1(\"NO\")) \
             pair_{pair} (\n        .CIN(carry[{pair}]), {},\n        {},\n        \
             .S0(chain[{}]), .S1(chain[{}]), .COUT(carry[{}]));\n",
            halves[0].lut,
            halves[1].lut,
            inputs(0),
            inputs(1),
            2 * pair,
            2 * pair + 1,
            pair + 1,
        );
    }
    text
}

/// `difference = a - b`: a + ~b + 1. The first bit makes the carry.
fn subtract(ports: &Ports) -> String {
    let width = ports.width("a");
    let mut bits = vec![Bit::new(&[], |_| false, |a, b| a & b)];
    bits.extend((0..width).map(|i| {
        Bit::new(
            &[bit("a", i), bit("b", i)],
            |[a, b, ..]| a == b,
            |a, b| a & !b,
        )
    }));
    // Above both words stand a 0 and the inverse of a 0.
    bits.push(Bit::new(&[], |_| true, |_, _| false));
    cells(bits) + &format!("    assign difference = chain[{}:1];\n", width + 1)
}

/// `(d ^ s) + s` with s the sign: bit 0 is that of d, and the carry from it is 1 where a negative d
/// is even.
fn magnitude(ports: &Ports) -> String {
    let sign = ports.width("difference") - 1;
    let negative = bit("difference", sign);
    let lowest = bit("difference", 0);
    let mut bits = vec![Bit::new(
        &[negative.clone(), lowest],
        |_| false,
        |s, d| s & !d,
    )];
    bits.extend((1..sign).map(|i| {
        Bit::new(
            &[bit("difference", i), negative.clone()],
            |[d, s, ..]| d ^ s,
            |_, _| false,
        )
    }));
    cells(bits)
        + &format!(
            "    assign magnitude = {{chain[{}:1], difference[0]}};\n",
            sign - 1
        )
}

/// Two rows of the high digit, the second one place up; where the low digit has three bits, the
/// second product is one row and no sum.
fn digit_products(ports: &Ports) -> String {
    const HIGH: usize = photoncube_spec::SpatialWidths::HIGH_DIGIT as usize;
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

/// The squares of both digits, side by side, and twice their product between them. A bit of a square
/// that depends on few bits of its digit needs no LUT before the chain.
fn square_sum(ports: &Ports) -> String {
    const HIGH: usize = photoncube_spec::SpatialWidths::HIGH_DIGIT as usize;
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

/// A bit of the squares of the two digits of `magnitude`, as a function of bits of its digit.
struct SquareBit {
    index: usize,
    /// The bits of `magnitude` that it depends on.
    inputs: Vec<usize>,
    /// Its value for each value of those.
    table: Vec<bool>,
}

impl SquareBit {
    fn of(index: usize, low: usize) -> Self {
        const HIGH: usize = photoncube_spec::SpatialWidths::HIGH_DIGIT as usize;
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

    /// As a sum of products.
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

    /// The sum of this bit and another, or with none this bit alone.
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

    /// An order of its inputs in which it is 0 where the last two are: a LUT's lowest bits, where C
    /// and D are 0, are also g. With an input to spare, D is 1 and any order does.
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

/// `in_range = distance <= largest, and not far`: whether largest + ~distance + 1 has a carry that
/// nothing above stops. The last bit shows it.
fn range_of_query(ports: &Ports) -> String {
    let (largest, distance) = (ports.width("largest"), ports.width("distance"));
    let digit = |i: usize| [bit("largest", i), bit("distance", i)];
    let mut bits = vec![Bit::new(&digit(0), |_| false, |l, d| l | !d)];
    bits.extend((1..largest).map(|i| Bit::new(&digit(i), |[l, d, ..]| l == d, |l, d| l & !d)));
    let above = (largest..distance).map(|i| bit("distance", i));
    let above: Vec<_> = above.chain(["far".to_owned()]).collect();
    assert_eq!(
        above.len(),
        3,
        "a carry bit's LUT has three inputs to spare"
    );
    bits.push(Bit::new(&above, |[a, b, c, _]| !(a | b | c), |_, _| false));
    bits.push(Bit::carry());
    let last = bits.len() - 1;
    cells(bits) + &format!("    assign in_range = chain[{last}];\n")
}

/// `sum = (a & a_in_range) + (b & b_in_range)`.
fn gated_sum(ports: &Ports) -> String {
    let width = ports.width("a");
    let mut bits: Vec<_> = (0..width)
        .map(|i| {
            Bit::new(
                &[
                    bit("a", i),
                    "a_in_range".to_owned(),
                    bit("b", i),
                    "b_in_range".to_owned(),
                ],
                |[a, b, c, d]| (a & b) ^ (c & d),
                |a, b| a & b,
            )
        })
        .collect();
    bits.push(Bit::carry());
    cells(bits) + &format!("    assign sum = chain[{width}:0];\n")
}

/// `next_sum = (first ? 0 : sum) + group`.
fn accumulate(ports: &Ports) -> String {
    let (sum, group) = (ports.width("sum"), ports.width("group"));
    let bits = (0..sum).map(|i| {
        let kept = [bit("sum", i), "first".to_owned()];
        if i < group {
            let [sum, first] = kept;
            Bit::new(
                &[sum, first, bit("group", i)],
                |[s, f, g, _]| (s & !f) ^ g,
                |s, f| s & !f,
            )
        } else {
            Bit::new(&kept, |[s, f, ..]| s & !f, |_, _| false)
        }
    });
    cells(bits.collect()) + &format!("    assign next_sum = chain[{}:0];\n", sum - 1)
}

/// `total = (add_sum ? sum : addend) + operand`; above the bits that can be chosen with the sum alone.
fn chosen_sum(ports: &Ports) -> String {
    let (sum, chosen, addend) = (
        ports.width("sum"),
        ports.width("sum_low"),
        ports.width("addend"),
    );
    let bits = (0..sum).map(|i| {
        let operand = bit("operand", i);
        let add_sum = || "add_sum".to_owned();
        match i {
            i if i < addend => Bit::new(
                &[operand, bit("sum_low", i), add_sum(), bit("addend", i)],
                |[o, s, add_sum, a]| o ^ if add_sum { s } else { a },
                |o, _| o,
            ),
            i if i < chosen => Bit::new(
                &[operand, bit("sum_low", i), add_sum()],
                |[o, s, add_sum, _]| o ^ (s & add_sum),
                |o, _| o,
            ),
            i => Bit::new(&[operand, bit("sum", i)], |[o, s, ..]| o ^ s, |o, _| o),
        }
    });
    cells(bits.collect()) + &format!("    assign total = chain[{}:0];\n", sum - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn luts_are_those_of_the_known_sums() {
        let gated = lut(|[a, b, c, d]| (a & b) ^ (c & d), |a, b| a & b);
        assert_eq!(gated, 0x7888);
        let kept = lut(|[s, f, g, _]| (s & !f) ^ g, |s, f| s & !f);
        assert_eq!(kept & 0xf00f, 0xd002);
    }

    #[test]
    fn only_known_modules_get_a_second_text_with_the_same_ports() {
        let text = "module m_accumulate(group, sum, first, next_sum);\n  input wire [7:0] group;\n  \
                    input wire [9:0] sum;\n  input wire first;\n  output reg [9:0] next_sum;\n  \
                    x\nendmodule\nmodule m_other(a);\n  input wire a;\nendmodule\n";
        let chained = carry_chains(text).unwrap();
        assert_eq!(chained.matches("CCU2C").count(), 5);
        assert!(chained.contains("output wire [9:0] next_sum;"), "{chained}");
        assert!(!chained.contains("m_other"));
        assert_eq!(
            carry_chains("module m_other(a);\n  input wire a;\nendmodule\n"),
            None
        );
    }
}
