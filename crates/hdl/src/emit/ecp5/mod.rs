//! Carry chains for the ECP5, in place of the emitted modules that add words of simple functions.
//!
//! A carry cell of an ECP5, CCU2C, has a LUT before each of its two adder bits. Yosys puts only plain
//! words there and spends LUTs on what stands before an adder: the AND of a gate, the inversion
//! of a subtrahend or of a negative difference. So each such module has a second text, which names
//! the carry cells. The first is what is simulated and what other devices are built from; that both
//! are the same function is proven for every module by `scripts/yosys/ecp5.sh`.

mod chain;
mod ports;
mod squares;
mod sums;

use super::modules::{Module, split};
use ports::Ports;

/// What makes a second text's body.
type Body = fn(&Ports) -> String;

/// The end of a module's name, and the body of its second text.
const CHAINS: &[(&str, Body)] = &[
    ("_subtract", sums::subtract),
    ("_magnitude_of", sums::magnitude),
    ("_digit_products", squares::digit_products),
    ("_square_sum", squares::square_sum),
    ("_range_of_query", sums::range_of_query),
    ("_gated_sum", sums::gated_sum),
    ("_accumulate", sums::accumulate),
    ("_chosen_sum", sums::chosen_sum),
];

/// The second text of all modules that have one; none if no module has.
pub(super) fn carry_chains(text: &str) -> Option<String> {
    let modules = split(text);
    let chained: Vec<_> = modules.iter().filter_map(chained).collect();
    (!chained.is_empty()).then(|| chained.concat())
}

/// A module's second text: the same ports, and a carry chain.
fn chained(module: &Module) -> Option<String> {
    let (_, body) = CHAINS.iter().find(|(base, _)| is_named(module, base))?;
    let ports = Ports::of(module);
    Some(format!(
        "\nmodule {}{}{}endmodule\n",
        module.name,
        ports.declaration,
        body(&ports)
    ))
}

/// Whether its name ends with that, or with that and a number.
fn is_named(module: &Module, base: &str) -> bool {
    let Some((_, last)) = module.name.rsplit_once(base) else {
        return false;
    };
    let number = last.strip_prefix('_').map(str::parse::<u32>);
    last.is_empty() || matches!(number, Some(Ok(_)))
}

#[cfg(test)]
mod tests {
    use super::*;

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
