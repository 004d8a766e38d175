//! Overrides for squarers that use the registers inside a DSP block or a block RAM.
//!
//! Yosys maps a product to a DSP block and a table to a block RAM, but keeps the registers before and behind
//! them in flip-flops. On a full chip these flip-flops are far from the block, and the nets between limit the
//! clock. The block's own registers need no net and no flip-flop.

use std::fmt::Write;

use super::super::modules::Module;
use super::ports::Ports;
use crate::spatial::square_word;

/// Bits of an operand of a MULT18X18D, and of its product (Lattice, FPGA-TN-02205).
const OPERAND: usize = 18;
/// Address and data bits of a DP16KD with two ports of full width, and the number of words in one of its
/// initial-value parameters, each word in 20 bits (Lattice, FPGA-TN-02204).
const ADDRESS: usize = 10;
const DATA: usize = 18;
const WORDS_OF_VALUE: usize = 16;
const DIGITS_OF_WORD: usize = 5;
/// The lowest address pin that counts in words of full width.
const FIRST_ADDRESS_PIN: usize = 4;

/// The connections `.A0(word[0]), ...` for `pins` pins.
fn pins(pin: &str, word: &str, pins: usize) -> String {
    let connect = |i: usize| format!(".{pin}{i}({word}[{i}])");
    (0..pins).map(connect).collect::<Vec<_>>().join(", ")
}

/// The connections of a word at the highest pins, with zeros below. Inputs of a block that are not connected
/// are 0, and at the highest pins the sign needs no extension.
fn high_pins(pin: &str, word: &str, width: usize, pins: usize) -> String {
    let zeros = pins - width;
    let connect = |i: usize| match i.checked_sub(zeros) {
        None => format!(".{pin}{i}(1'b0)"),
        Some(bit) => format!(".{pin}{i}({word}[{bit}])"),
    };
    (0..pins).map(connect).collect::<Vec<_>>().join(", ")
}

/// Whether an instance in a module is a register. A pipeline place without a register is a wire.
fn is_register(module: &Module, instance: &str) -> bool {
    let end = format!(" {instance}(");
    let mut lines = module.body.lines();
    lines.any(|line| line.ends_with(&end) && line.contains("_register_"))
}

/// A pipeline register or wire outside the block.
fn stage(module: &Module, name: &str, instance: &str, d: &str, width: usize) -> String {
    let high = width - 1;
    match is_register(module, instance) {
        true => format!(
            "    reg [{high}:0] {name};\n    initial {name} = {width}'d0;\n    \
             always @(posedge clock) {name} <= {d};\n"
        ),
        false => format!("    wire [{high}:0] {name} = {d};\n"),
    }
}

/// The override of a squarer in a DSP block: `square` and `far` of d^2, or of d (d + 1). `None` unless it has registers
/// before and behind the product.
pub(super) fn product(module: &Module, ports: &Ports, is_half: bool) -> Option<String> {
    if !is_register(module, "products_delay") || !is_register(module, "product") {
        return None;
    }
    let (difference, square) = (ports.width("difference"), ports.width("square"));
    // d is never -2^(D - 1), so d^2 and d (d + 1) are below 2^(2 (D - 1)).
    let product = 2 * (difference - 1);
    // d + 1 has a bit more than d.
    let factor = difference + usize::from(is_half);
    if factor > OPERAND || product <= square {
        return None;
    }
    let low = 2 * OPERAND - difference - factor;
    let (second, next) = match is_half {
        false => ("operand", String::new()),
        true => (
            "next",
            format!(
                "    wire [{difference}:0] next = {{operand[{}], operand}} + {factor}'d1;\n",
                difference - 1
            ),
        ),
    };
    Some(format!(
        "{operand}{next}    wire [{high}:0] product;\n    \
         MULT18X18D #(.REG_INPUTA_CLK(\"CLK0\"), .REG_INPUTB_CLK(\"CLK0\"), \
         .REG_OUTPUT_CLK(\"CLK0\"), .GSR(\"DISABLED\")) block (\n        \
         .CLK0(clock), .CE0(1'b1), .RST0(1'b0),\n        \
         .SIGNEDA(1'b1), .SIGNEDB(1'b1), .SOURCEA(1'b0), .SOURCEB(1'b0),\n        \
         {a},\n        {b},\n        {p});\n    \
         assign square = product[{}:{low}];\n    assign far = |product[{}:{}];\n",
        low + square - 1,
        low + product - 1,
        low + square,
        operand = stage(
            module,
            "operand",
            "magnitude_delay",
            "difference",
            difference
        ),
        high = 2 * OPERAND - 1,
        a = high_pins("A", "operand", difference, OPERAND),
        b = high_pins("B", second, factor, OPERAND),
        p = pins("P", "product", 2 * OPERAND),
    ))
}

/// The override of two squarers in a block RAM: two squares and their `far`. `None` unless it has a register
/// before the table (that of its address) and one behind it, or if the table does not fit a block RAM.
pub(super) fn lookup(module: &Module, ports: &Ports) -> Option<String> {
    let (difference, square) = (ports.width("difference_a"), ports.width("square_a"));
    let registers = ["square_stage_0", "square_stage_1"];
    let has_registers = registers.iter().all(|stage| is_register(module, stage));
    if !has_registers || difference > ADDRESS || square >= DATA {
        return None;
    }
    let mut text = String::new();
    for (port, photon) in [('a', 0), ('b', 1)] {
        let (before, delayed) = (format!("before_{port}"), format!("delayed_{port}"));
        text += &stage(
            module,
            &before,
            &format!("magnitude_delay_{photon}"),
            &format!("difference_{port}"),
            difference,
        );
        text += &stage(
            module,
            &delayed,
            &format!("products_delay_{photon}"),
            &before,
            difference,
        );
        text += &format!(
            "    wire [{high}:0] address_{port} = {delayed};\n    wire [{}:0] word_{port};\n    \
             assign square_{port} = word_{port}[{}:0];\n    assign far_{port} = word_{port}[{square}];\n",
            DATA - 1,
            square - 1,
            high = ADDRESS - 1,
        );
    }
    text += &format!(
        "    DP16KD #(.DATA_WIDTH_A({DATA}), .DATA_WIDTH_B({DATA}), .REGMODE_A(\"OUTREG\"), \
         .REGMODE_B(\"OUTREG\"), .GSR(\"DISABLED\"){}) block (",
        initial_values(difference, square)
    );
    let ends = ['A', 'B'].map(port_of_block);
    Some(text + &ends.join(",") + ");\n")
}

/// The pins of one of the block RAM's ports, used for reads only.
fn port_of_block(port: char) -> String {
    let small = port.to_ascii_lowercase();
    let low = (0..FIRST_ADDRESS_PIN).map(|i| format!(".AD{port}{i}(1'b0)"));
    let high =
        (0..ADDRESS).map(|i| format!(".AD{port}{}(address_{small}[{i}])", i + FIRST_ADDRESS_PIN));
    let address: Vec<_> = low.chain(high).collect();
    format!(
        "\n        .CLK{port}(clock), .CE{port}(1'b1), .OCE{port}(1'b1), .WE{port}(1'b0), \
         .RST{port}(1'b0),\n        .CS{port}0(1'b0), .CS{port}1(1'b0), .CS{port}2(1'b0),\n        \
         {},\n        {}",
        address.join(", "),
        pins(&format!("DO{port}"), &format!("word_{small}"), DATA),
    )
}

/// The table's words as the block RAM's parameters.
fn initial_values(difference: usize, square: usize) -> String {
    let words: Vec<_> = (0..1 << difference)
        .map(|d| square_word(d, difference, square))
        .collect();
    let mut text = String::new();
    for (index, words) in words.chunks(WORDS_OF_VALUE).enumerate() {
        let digits: String = words
            .iter()
            .rev()
            .map(|word| format!("{word:0width$x}", width = DIGITS_OF_WORD))
            .collect();
        let bits = 4 * DIGITS_OF_WORD * WORDS_OF_VALUE;
        write!(text, ",\n        .INITVAL_{index:02X}({bits}'h{digits})")
            .expect("a string takes all that is written to it");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A test module of a squarer with a register at each of these places.
    fn module(places: &[&str]) -> Module {
        let instances: String = ["products_delay", "product"]
            .map(|place| match places.contains(&place) {
                true => format!("    m_register_10 {place}(\n    );\n"),
                false => format!("    m_products_delay {place}(\n    );\n"),
            })
            .concat();
        Module {
            name: "m_product".to_owned(),
            body: format!(
                "(clock, difference, square, far);\n    input wire clock;\n    \
                 input wire [9:0] difference;\n    output reg [13:0] square;\n    \
                 output reg far;\n{instances}"
            ),
        }
    }

    #[test]
    fn a_product_is_a_block_only_with_both_of_its_registers() {
        let text = |places: &[&str]| {
            let module = module(places);
            product(&module, &Ports::of(&module), false)
        };
        let both = text(&["products_delay", "product"]).unwrap();
        assert!(both.contains(".A7(1'b0), .A8(operand[0])"), "{both}");
        assert!(both.contains("assign square = product[29:16];"));
        assert!(both.contains("assign far = |product[33:30];"));
        assert_eq!(text(&["products_delay"]), None);
        assert_eq!(text(&["product"]), None);
    }
}
