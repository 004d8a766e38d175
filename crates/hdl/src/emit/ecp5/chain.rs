//! A carry chain of ECP5 cells, bit by bit.
//!
//! In a bit of a CCU2C, `p` is a LUT of A, B, C, D, and the sum is `p ^ carry`. The carry out is the carry in
//! where p is 1, and `g` where p is 0; g is the LUT's lowest four bits as a table of A and B alone (Lattice,
//! FPGA-TN-02205, and Yosys's model). For a sum of two bits x + y: p = x ^ y, and g = x where x depends on A
//! and B only.

/// A bit of a carry chain: its LUT and the LUT's inputs. An unused input is `1'b1`.
pub(super) struct Bit {
    inputs: [String; 4],
    lut: u16,
}

/// The LUT of a bit, from p(A, B, C, D) and g(A, B). Where C and D are 0, p must equal g.
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
    pub(super) fn new(
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

    /// A last bit of the chain. Its sum shows the carry in, and its carry out is 0.
    pub(super) fn carry() -> Self {
        Self::new(&[], |_| false, |_, _| false)
    }
}

pub(super) fn bit(word: &str, index: usize) -> String {
    format!("{word}[{index}]")
}

/// The Verilog of the chain's cells; the sum bits are named `chain`.
pub(super) fn cells(mut bits: Vec<Bit>) -> String {
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
}
