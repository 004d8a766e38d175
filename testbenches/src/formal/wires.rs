//! The property of the wires between the submodules of a module, which are removed: each input of a submodule
//! equals an output of another.

use std::collections::BTreeMap;

use super::property::{Fault, Open, Property, covers, of_logic};

/// The pairs of inputs and outputs that must be equal.
#[derive(Debug, Default)]
pub(super) struct Wires {
    /// The inputs of parts, with their widths.
    taken: BTreeMap<String, u32>,
    /// The outputs of parts, or pins of the module.
    sent: BTreeMap<String, u32>,
    equalities: Vec<String>,
}

impl Wires {
    /// An input of a part is the outputs, the most significant first, each with its width.
    pub fn equal(&mut self, input: &str, outputs: &[(&str, u32)]) {
        self.taken.insert(
            input.to_owned(),
            outputs.iter().map(|(_, width)| width).sum(),
        );
        self.sent.extend(
            outputs
                .iter()
                .map(|(name, width)| ((*name).to_owned(), *width)),
        );
        let outputs: Vec<_> = outputs
            .iter()
            .map(|(name, _)| format!("\\{name} "))
            .collect();
        self.equalities.push(format!(
            "assert (\\{input}  == {{{}}});",
            outputs.join(", ")
        ));
    }

    /// The property that all these pairs are equal.
    pub fn property(self, name: &'static str, claim: &'static str, faults: Vec<Fault>) -> Property {
        let declare = |kind: &'static str| {
            move |(name, width): (&String, &u32)| format!("{kind} [{width}-1:0] \\{name} ")
        };
        let ports = self.taken.keys().chain(self.sent.keys());
        let ports: Vec<_> = ports.map(|name| format!(".\\{name} (\\{name} )")).collect();
        let inputs: String = self
            .sent
            .iter()
            .map(|wire| declare("input wire")(wire) + ", ")
            .collect();
        let outputs: String = self
            .taken
            .iter()
            .map(|wire| declare("wire")(wire) + "; ")
            .collect();
        let some: Vec<_> = self
            .taken
            .keys()
            .map(|name| format!("(&\\{name} )"))
            .collect();
        Property {
            macros: vec![
                ("INPUTS", inputs),
                ("OUTPUTS", outputs),
                ("PORTS", ports.join(", ")),
                ("EQUALITIES", self.equalities.join(" ")),
                ("SOME", some.join(" & ")),
            ],
            open: Open::Parts,
            faults,
            covers: covers(["cover_moves"]),
            ..of_logic(name, "", claim, include_str!("harness/wires.sv"), &[])
        }
    }
}
