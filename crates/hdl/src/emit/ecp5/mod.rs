//! Overrides of emitted modules for the ECP5, made of its own cells: carry chains for modules that add simple
//! functions of words, squarers in blocks with registers (`blocks`), and a comparison in few levels of LUTs
//! (`range`).
//!
//! A carry cell of an ECP5, CCU2C, has a LUT before each of its two adder bits. Yosys uses these LUTs only
//! for plain words and spends further LUTs on the logic before an adder: the AND of a gate, the inversion of
//! a subtrahend or of a negative difference. So each such module has an override, a second text that names
//! the carry cells. Simulation and other devices use the first text. `scripts/yosys/ecp5.sh` proves for every
//! module that both are the same function.

mod blocks;
mod chain;
mod ports;
mod range;
mod squares;
mod sums;

use super::modules::{Module, split};
use ports::Ports;

/// The function that makes an override's body.
#[derive(Copy, Clone)]
enum Body {
    /// For a module without registers and submodules.
    Chain(fn(&Ports) -> String),
    /// For a module that must have a certain form: a squarer with the registers of a block, or a comparison
    /// with a limit of the right bit pattern.
    Shaped(fn(&Module, &Ports) -> Option<String>),
    /// For a squarer that is one product, with the registers of a DSP block.
    Product,
}

/// The end of a module's name, and the body of its override.
const BODIES: &[(&str, Body)] = &[
    ("_subtract", Body::Chain(sums::subtract)),
    ("_magnitude_of", Body::Chain(sums::magnitude)),
    ("_digit_products", Body::Chain(squares::digit_products)),
    ("_square_sum", Body::Chain(squares::square_sum)),
    ("_range_of_query", Body::Chain(sums::range_of_query)),
    ("_gated_sum", Body::Chain(sums::gated_sum)),
    ("_accumulate", Body::Chain(sums::accumulate)),
    ("_chosen_sum", Body::Chain(sums::chosen_sum)),
    ("_lookup", Body::Shaped(blocks::lookup)),
    ("_product", Body::Product),
    ("_range_of_format", Body::Shaped(range::range_of_format)),
];

/// The overrides of all modules that have one; `None` if no module has one.
pub(super) fn second_texts(text: &str) -> Option<String> {
    let modules = split(text);
    // The text of the product tells whether squares are half squares.
    let is_half = modules.iter().any(|module| {
        is_named(module, "_difference_product") && module.body.contains("= d * d + d;")
    });
    let texts: Vec<_> = modules
        .iter()
        .filter_map(|module| second_text(module, is_half))
        .collect();
    (!texts.is_empty()).then(|| texts.concat())
}

/// The override of one module, with the module's ports.
fn second_text(module: &Module, is_half: bool) -> Option<String> {
    let (_, body) = BODIES.iter().find(|(base, _)| is_named(module, base))?;
    let ports = Ports::of(module);
    let body = match body {
        Body::Chain(body) => body(&ports),
        Body::Shaped(body) => body(module, &ports)?,
        Body::Product => blocks::product(module, &ports, is_half)?,
    };
    Some(format!(
        "\nmodule {}{}{}endmodule\n",
        module.name, ports.declaration, body
    ))
}

/// Whether the module's name ends with `base`, or with `base` and a number.
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
        let chained = second_texts(text).unwrap();
        assert_eq!(chained.matches("CCU2C").count(), 5);
        assert!(chained.contains("output wire [9:0] next_sum;"), "{chained}");
        assert!(!chained.contains("m_other"));
        assert_eq!(
            second_texts("module m_other(a);\n  input wire a;\nendmodule\n"),
            None
        );
    }
}
