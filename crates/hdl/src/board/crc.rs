//! The module of the CRC: one step over a byte, as equations of its bits.

use std::fmt::Write as _;

use photoncube_spec::Serial;

/// Bits of the CRC.
const BITS: usize = 16;

/// A bit of the CRC as a sum modulo 2: of which bits of the CRC before, and of which bits of the byte.
#[derive(Copy, Clone, Default)]
struct Equation {
    crc: u16,
    data: u8,
}

impl Equation {
    fn plus(self, other: Self) -> Self {
        Self {
            crc: self.crc ^ other.crc,
            data: self.data ^ other.data,
        }
    }
}

/// The equations of a step over a byte. Bit by bit, the highest first: the register moves up, and where the bit that leaves it differs from
/// that of the byte, the polynomial is added.
fn equations() -> [Equation; BITS] {
    let mut crc: [Equation; BITS] = std::array::from_fn(|bit| Equation {
        crc: 1 << bit,
        data: 0,
    });
    for bit in (0..u8::BITS).rev() {
        let of_data = Equation {
            crc: 0,
            data: 1 << bit,
        };
        let leaves = crc[BITS - 1].plus(of_data);
        let moved: [Equation; BITS] = std::array::from_fn(|place| match place {
            0 => Equation::default(),
            _ => crc[place - 1],
        });
        crc = std::array::from_fn(|place| match Serial::CRC_POLYNOMIAL >> place & 1 {
            0 => moved[place],
            _ => moved[place].plus(leaves),
        });
    }
    crc
}

/// The module.
pub(super) fn crc(top: &str) -> String {
    let high = BITS - 1;
    let mut text = format!(
        "// The CRC behind a byte, from that in front of it.\n\
         module {top}_crc(crc, data, next);\n    \
         input wire [{high}:0] crc;\n    \
         input wire [7:0] data;\n    \
         output wire [{high}:0] next;\n"
    );
    for (place, equation) in equations().iter().enumerate() {
        let of_crc = (0..BITS).filter(|bit| equation.crc >> bit & 1 == 1);
        let of_data = (0..8).filter(|bit| equation.data >> bit & 1 == 1);
        let terms: Vec<_> = of_crc
            .map(|bit| format!("crc[{bit}]"))
            .chain(of_data.map(|bit| format!("data[{bit}]")))
            .collect();
        let _ = writeln!(text, "    assign next[{place}] = {};", terms.join(" ^ "));
    }
    text + "endmodule\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The catalogue of CRCs has this value of CRC-16/IBM-3740 over the digits 1 to 9.
    #[test]
    fn the_equations_give_the_known_check_value() {
        let equations = equations();
        let step = |crc: u16, byte: &u8| {
            let bit = |equation: &Equation| {
                (equation.crc & crc).count_ones() + (equation.data & byte).count_ones()
            };
            let bits = equations.iter().zip(0..);
            bits.map(|(equation, place)| ((bit(equation) & 1) as u16) << place)
                .sum()
        };
        assert_eq!(b"123456789".iter().fold(Serial::CRC_START, step), 0x29b1);
    }
}
