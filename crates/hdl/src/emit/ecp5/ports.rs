//! The ports of a module in the emitted text.

use super::super::modules::Module;
use super::chain::bit;

/// A module's ports as it declares them.
pub(super) struct Ports {
    /// The port list and the declarations, with all outputs as wires.
    pub(super) declaration: String,
    widths: Vec<(String, usize)>,
}

impl Ports {
    pub(super) fn of(module: &Module) -> Self {
        let is_port = |line: &&str| {
            let line = line.trim_start();
            // Inputs of functions are left out, because they are not wires.
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

    pub(super) fn width(&self, name: &str) -> usize {
        let port = self.widths.iter().find(|(port, _)| port == name);
        port.expect("the module has the ports of its block").1
    }

    /// A bit of a port as an expression. A port of one bit is declared without a range and may not be
    /// indexed.
    pub(super) fn bit(&self, name: &str, index: usize) -> String {
        match self.width(name) {
            1 => name.to_owned(),
            _ => bit(name, index),
        }
    }
}

/// Parses name and width of a declared port.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_port_of_several_bits_is_indexed() {
        let module = Module {
            name: "m".to_owned(),
            body: "(a, b);\n  input wire a;\n  output reg [1:0] b;\n".to_owned(),
        };
        let ports = Ports::of(&module);
        assert_eq!(ports.bit("a", 0), "a");
        assert_eq!(ports.bit("b", 1), "b[1]");
    }
}
