//! The override of the comparison with the format's radius, in two levels of LUTs.
//!
//! Yosys maps this comparison to a carry chain and three or four levels of LUTs. On a full chip their nets
//! are long and limit the clock.

use super::super::modules::Module;
use super::ports::Ports;

/// The limit's bits in three groups, each for a LUT or for two LUTs with a multiplexer. In a limit of the
/// right pattern the lowest group is any number, the next is zeros, and the one above is ones.
const LOWEST: usize = 5;
const ZEROS: usize = 4;
const ONES: usize = 5;
/// The remaining bits, for the LUT that also has `far` as an input.
const MOST_HIGHEST: usize = 3;

/// The override of `in_range = distance <= limit, and not far`. The limit's bits must be, from the highest:
/// zeros; `ONES` ones; `ZEROS` zeros; `LOWEST` bits of any kind, not all of them ones. `None` for other
/// limits.
pub(super) fn range_of_format(module: &Module, ports: &Ports) -> Option<String> {
    let width = ports.width("distance");
    let highest = width.checked_sub(LOWEST + ZEROS + ONES)?;
    let limit = limit(module)?;
    let lowest_limit = limit % (1 << LOWEST);
    let is_right = limit >> LOWEST == ((1 << ONES) - 1) << ZEROS && lowest_limit + 1 < 1 << LOWEST;
    if !is_right || highest == 0 || highest > MOST_HIGHEST {
        return None;
    }
    let bit = |i: usize| format!("distance[{i}]");
    let bits = |from: usize, count: usize| (from..from + count).map(bit).collect::<Vec<_>>();
    let (zeros, ones) = (LOWEST, LOWEST + ZEROS);
    let top = [vec!["far".to_owned()], bits(ones + ONES, highest)].concat();
    Some(
        [
            lut("above", &top, |bits| bits != 0),
            lut_5("all", &bits(ones, ONES), |bits| bits == 0x1f),
            lut("middle", &bits(zeros, ZEROS), |bits| bits != 0),
            lut_5("low", &bits(0, LOWEST), |bits| {
                u64::from(bits) > lowest_limit
            }),
            lut(
                "near",
                &["above", "all", "middle", "low"].map(str::to_owned),
                // In range: not `above`, and neither `middle` nor `low` together with `all`.
                |bits| matches!(bits, 0b0000 | 0b0010 | 0b0100 | 0b1000 | 0b1100),
            ),
            "    assign in_range = near;\n".to_owned(),
        ]
        .concat(),
    )
}

/// Parses the limit in the module's text, such as `localparam limit = 16'h3e04;`.
fn limit(module: &Module) -> Option<u64> {
    let (_, rest) = module.body.split_once("localparam limit = ")?;
    let (_, digits) = rest.split_once(';')?.0.split_once("'h")?;
    u64::from_str_radix(digits, 16).ok()
}

/// A LUT of up to four inputs. The argument of `value` has the first input at bit 0.
fn lut(name: &str, inputs: &[String], value: impl Fn(u16) -> bool) -> String {
    let table = (0..16_u16).filter(|&index| value(index % (1 << inputs.len())));
    let table: u16 = table.map(|index| 1 << index).sum();
    let unused = "1'b0".to_owned();
    let input = |i: usize| inputs.get(i).unwrap_or(&unused);
    format!(
        "    wire {name};\n    LUT4 #(.INIT(16'h{table:04x})) lut_{name} (.A({}), .B({}), .C({}), .D({}), \
         .Z({name}));\n",
        input(0),
        input(1),
        input(2),
        input(3),
    )
}

/// Two LUTs and the multiplexer of their slice, for five inputs.
fn lut_5(name: &str, inputs: &[String], value: impl Fn(u16) -> bool) -> String {
    let (selected, low) = (&inputs[4], &inputs[..4]);
    let halves = [("without", 0), ("with", 16)];
    let halves =
        halves.map(|(half, bits)| lut(&format!("{name}_{half}"), low, |index| value(index + bits)));
    format!(
        "{}    wire {name};\n    PFUMX mux_{name} (.ALUT({name}_with), .BLUT({name}_without), .C0({selected}), \
         .Z({name}));\n",
        halves.concat()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(limit: &str) -> Option<String> {
        let module = Module {
            name: "m_range_of_format".to_owned(),
            body: format!(
                "(distance, far, in_range);\n    input wire [15:0] distance;\n    input wire far;\n    \
                 output reg in_range;\n    localparam limit = {limit};\n"
            ),
        };
        range_of_format(&module, &Ports::of(&module))
    }

    #[test]
    fn only_limits_of_the_right_shape_are_compared_so() {
        let text_of_format = text("16'h3e04").unwrap();
        assert_eq!(text_of_format.matches("LUT4 #").count(), 7);
        assert_eq!(text_of_format.matches("PFUMX ").count(), 2);
        for other in ["16'h3f01", "16'h7e04", "16'h3e1f", "16'h0000"] {
            assert_eq!(text(other), None, "{other}");
        }
    }
}
