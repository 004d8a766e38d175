//! Prints cells of a mapped netlist as Verilog.

use std::fmt::Write;

use serde_json::Value;

use super::connections;
use crate::error::{Result, unexpected};

/// An instance of a cell, on its own line; `net` returns the name of each net. An input that is not connected
/// is unknown.
///
/// # Errors
/// A parameter is no text.
pub(crate) fn instance(name: &str, cell: &Value, net: impl Fn(u64) -> String) -> Result<String> {
    let kind = cell["type"].as_str().unwrap_or_default();
    let mut parameters = Vec::new();
    for (parameter, value) in cell["parameters"].as_object().into_iter().flatten() {
        let value = value.as_str();
        let value = value.ok_or_else(|| {
            unexpected(format!(
                "found {parameter} of {name}, expected a text as its value"
            ))
        })?;
        parameters.push(format!(".{parameter}({})", literal(value)));
    }
    let mut ports = Vec::new();
    for (port, is_output, bits) in connections(cell) {
        if is_output && bits.iter().all(|bit| !bit.is_u64()) {
            continue;
        }
        let bits: Vec<_> = bits.iter().rev().map(|bit| end(bit, &net)).collect();
        ports.push(match &bits[..] {
            [bit] => format!(".{port}({bit})"),
            bits => format!(".{port}({{{}}})", bits.join(", ")),
        });
    }
    let parameters = match parameters.is_empty() {
        true => String::new(),
        false => format!("#({}) ", parameters.join(", ")),
    };
    Ok(format!(
        "  {kind} {parameters}\\{name} ({});\n",
        ports.join(", ")
    ))
}

/// A bit as Verilog: a net, or a constant.
pub(crate) fn end(bit: &Value, net: impl Fn(u64) -> String) -> String {
    match bit.as_u64() {
        Some(bit) => net(bit),
        None => format!("1'b{}", bit.as_str().unwrap_or("x")),
    }
}

/// A parameter as Verilog: binary digits are a number, other values are a text.
fn literal(value: &str) -> String {
    let is_number = |text: &str| text.bytes().all(|digit| b"01xz".contains(&digit));
    match value {
        "" => "\"\"".to_owned(),
        digits if is_number(digits) => format!("{}'b{digits}", digits.len()),
        // A text of binary digits has a trailing blank, which distinguishes it from a number.
        word => {
            let bare = word
                .strip_suffix(' ')
                .filter(|bare| is_number(bare.trim_end()));
            format!("\"{}\"", bare.unwrap_or(word))
        }
    }
}

/// A list of ports or bits over several lines.
pub(crate) fn list(items: &[String]) -> String {
    let mut text = String::new();
    for (index, item) in items.iter().enumerate() {
        let separator = if index + 1 < items.len() { "," } else { "" };
        let _ = write!(text, "\n    {item}{separator}");
    }
    text
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_cell_is_an_instance() {
        let cell = json!({
            "type": "CCU2C",
            "parameters": { "INIT0": "0000000000000010", "INJECT1_0": "NO", "CEMUX": "1 " },
            "port_directions": { "A0": "input", "CIN": "input", "COUT": "output", "Q": "output" },
            "connections": { "A0": [7], "CIN": ["x"], "COUT": ["x"], "Q": [8, "0"] },
        });
        let text = instance("top.sum", &cell, |net| format!("n{net}")).unwrap();
        let expected = "  CCU2C #(.CEMUX(\"1\"), .INIT0(16'b0000000000000010), .INJECT1_0(\"NO\")) \
                        \\top.sum (.A0(n7), .CIN(1'bx), .Q({1'b0, n8}));\n";
        assert_eq!(text, expected);
    }
}
