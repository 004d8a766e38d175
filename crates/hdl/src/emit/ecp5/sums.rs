//! Overrides for sums, differences and comparisons, each with the selection or inversion before the adder.

use super::chain::{Bit, bit, cells};
use super::ports::Ports;

/// `difference = a - b`, computed as a + ~b + 1. The first bit of the chain makes the carry of 1.
pub(super) fn subtract(ports: &Ports) -> String {
    let width = ports.width("a");
    let mut bits = vec![Bit::new(&[], |_| false, |a, b| a & b)];
    bits.extend((0..width).map(|i| {
        Bit::new(
            &[bit("a", i), bit("b", i)],
            |[a, b, ..]| a == b,
            |a, b| a & !b,
        )
    }));
    // Above both words, the operands are 0 and the inverse of 0.
    bits.push(Bit::new(&[], |_| true, |_, _| false));
    cells(bits) + &format!("    assign difference = chain[{}:1];\n", width + 1)
}

/// `(d ^ s) + s` with s the sign of d. Bit 0 of the result is bit 0 of d, and its carry is 1 where d is
/// negative and even.
pub(super) fn magnitude(ports: &Ports) -> String {
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

/// `in_range = distance <= largest, and not far`: largest + ~distance + 1 has a carry that no higher bit
/// stops. The last bit of the chain shows the carry.
pub(super) fn range_of_query(ports: &Ports) -> String {
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
pub(super) fn gated_sum(ports: &Ports) -> String {
    let width = ports.width("a");
    let mut bits: Vec<_> = (0..width)
        .map(|i| {
            Bit::new(
                &[
                    ports.bit("a", i),
                    "a_in_range".to_owned(),
                    ports.bit("b", i),
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
pub(super) fn accumulate(ports: &Ports) -> String {
    let (sum, group) = (ports.width("sum"), ports.width("group"));
    let bits = (0..sum).map(|i| {
        let kept = [bit("sum", i), "first".to_owned()];
        if i < group {
            let [sum, first] = kept;
            Bit::new(
                &[sum, first, ports.bit("group", i)],
                |[s, f, g, _]| (s & !f) ^ g,
                |s, f| s & !f,
            )
        } else {
            Bit::new(&kept, |[s, f, ..]| s & !f, |_, _| false)
        }
    });
    cells(bits.collect()) + &format!("    assign next_sum = chain[{}:0];\n", sum - 1)
}

/// `total = (add_sum ? sum : addend) + operand`. Above the selectable bits the first operand is always the
/// sum.
pub(super) fn chosen_sum(ports: &Ports) -> String {
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
