//! A Liberty library, and the cells in it that the flow names.

use std::path::Path;

use serde_json::Value;

use super::LIBERTY;
use super::gating::{self, ClockGate};
use crate::area::areas_of_modules;
use crate::error::{Result, read, unexpected, write};
use crate::netlist::digest::hexadecimal;
use crate::netlist::{Netlist, cells};
use crate::yosys::Yosys;

/// A library of standard cells.
#[derive(Clone, Debug)]
pub struct Library {
    name: String,
    text: String,
    nand2_area: f64,
    register: Register,
    buffer: Cell,
    clock_gate: Option<ClockGate>,
}

/// The register of a library.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Register {
    pub cell: Cell,
    /// The name of its clock.
    pub clock: String,
    /// Its outputs but that of the cell, which they are the inverse of.
    pub inverse_outputs: Vec<String>,
}

/// A cell with the pins that the flow connects.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The name of the cell.
    pub cell: String,
    /// The name of its data input.
    pub input: String,
    /// The name of its output.
    pub output: String,
}

/// Two modules of a cell each, by which the library shows its NAND and its register.
const PROBE: &str = "\
module nand2(input a, input b, output y); assign y = ~(a & b); endmodule
module register(input clock, input d, output reg q); always @(posedge clock) q <= d; endmodule
";

/// The largest buffer that divides nets, in NANDs with two inputs.
const LARGEST_BUFFER: f64 = 2.0;

impl Library {
    /// Reads a library. Yosys maps two probes to it in the folder `scratch`.
    ///
    /// # Errors
    /// The file is no Liberty library, or has no NAND, no register or no buffer.
    pub fn read(yosys: &Yosys, scratch: &Path, path: &Path) -> Result<Self> {
        let text = read(path)?;
        let found = |what: &str| {
            let path = path.display();
            unexpected(format!(
                "found {what} in {path}, expected a Liberty library with one"
            ))
        };
        let name = name(&text).ok_or_else(|| found("no `library (NAME)`"))?;
        write(&scratch.join(LIBERTY), &text)?;
        write(&scratch.join("probe.v"), PROBE)?;
        let script = format!(
            "read_liberty -ignore_miss_func {LIBERTY}; write_json cells.json; design -reset; \
             read_liberty -lib -ignore_miss_func {LIBERTY}; read_verilog probe.v; \
             synth; dfflibmap -liberty {LIBERTY}; abc -liberty {LIBERTY}; write_json probe.json; \
             tee -q -o probe-stat.json stat -liberty {LIBERTY} -json"
        );
        yosys.run(scratch, &script)?;
        write(&scratch.join("gate-probe.v"), gating::PROBE)?;
        yosys.run(scratch, &gating::probe_script(LIBERTY))?;
        let gate = Netlist::parse(&read(&scratch.join("gate-probe.json"))?)?;
        let areas = areas_of_modules(&read(&scratch.join("probe-stat.json"))?)?;
        let nand2_area = areas.get("nand2").copied().filter(|area| *area > 0.0);
        let nand2_area = nand2_area.ok_or_else(|| found("no NAND with two inputs"))?;
        let probe = Netlist::parse(&read(&scratch.join("probe.json"))?)?;
        let known = Netlist::parse(&read(&scratch.join("cells.json"))?)?;
        Ok(Self {
            register: register(&probe, &known).ok_or_else(|| found("no register"))?,
            buffer: buffer(&known, LARGEST_BUFFER * nand2_area)
                .ok_or_else(|| found("no buffer"))?,
            clock_gate: ClockGate::of_probe(&gate),
            name,
            text,
            nand2_area,
        })
    }

    /// The name that the library has for itself.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// SHA-256 of the library's text in hexadecimal digits.
    #[must_use]
    pub fn sha256(&self) -> String {
        hexadecimal(&self.text)
    }

    /// The area of the cell that the library has for a NAND with two inputs.
    #[must_use]
    pub fn nand2_area(&self) -> f64 {
        self.nand2_area
    }

    /// The text for OpenSTA, which takes the outputs of a register for independent: where the conditions of an energy name both, their
    /// probabilities add up to a half. So a condition names one output here.
    pub(super) fn text(&self) -> String {
        let [both, other] = ["& Q & !QN", "& !Q & QN"];
        self.text.replace(both, "& Q").replace(other, "& !Q")
    }

    pub(super) fn register(&self) -> &Register {
        &self.register
    }

    /// The name of the cell that gates clocks, if the library has one.
    #[must_use]
    pub fn clock_gate_name(&self) -> Option<&str> {
        self.clock_gate.as_ref().map(|gate| gate.cell.as_str())
    }

    pub(super) fn clock_gate(&self) -> Option<&ClockGate> {
        self.clock_gate.as_ref()
    }

    pub(super) fn buffer(&self) -> &Cell {
        &self.buffer
    }
}

/// The name in the `library (NAME)` of the text.
fn name(text: &str) -> Option<String> {
    let (_, rest) = text.split_once("library")?;
    let (_, rest) = rest.split_once('(')?;
    let (name, _) = rest.split_once(')')?;
    let name = name.trim().trim_matches('"');
    (!name.is_empty()).then(|| name.to_owned())
}

/// The cell of the register's probe, with the pins on the probe's ports.
fn register(probe: &Netlist, library: &Netlist) -> Option<Register> {
    let module = &probe.json()["modules"]["register"];
    let [d, q, clock] = ["d", "q", "clock"].map(|port| &module["ports"][port]["bits"]);
    let mut cells = cells(module).ok()?.values();
    cells.find_map(|cell| {
        let pin = |bits: &Value| {
            let mut pins = cell["connections"].as_object()?.iter();
            Some(pins.find(|(_, on)| *on == bits)?.0.clone())
        };
        let (output, kind) = (pin(q)?, cell["type"].as_str()?);
        let ports = library.json()["modules"][kind]["ports"].as_object()?;
        let others = ports
            .iter()
            .filter(|(name, port)| port["direction"] == "output" && **name != output);
        Some(Register {
            clock: pin(clock)?,
            inverse_outputs: others.map(|(name, _)| name.clone()).collect(),
            cell: Cell {
                cell: kind.to_owned(),
                input: pin(d)?,
                output,
            },
        })
    })
}

/// The largest buffer up to an area; of several equally large ones the first by name.
fn buffer(library: &Netlist, most: f64) -> Option<Cell> {
    let modules = library.json()["modules"].as_object()?.iter();
    let buffers = modules.filter_map(|(name, module)| {
        let ports: Vec<_> = module["ports"].as_object()?.iter().collect();
        let of = |direction| {
            ports
                .iter()
                .find(|(_, port)| port["direction"] == direction)
        };
        let (input, output) = (of("input")?, of("output")?);
        let area: f64 = module["attributes"]["area"].as_str()?.trim().parse().ok()?;
        let is_buffer = ports.len() == 2 && input.1["bits"] == output.1["bits"];
        (is_buffer && area <= most).then(|| {
            let cell = Cell {
                cell: name.clone(),
                input: input.0.clone(),
                output: output.0.clone(),
            };
            (area, cell)
        })
    });
    let largest = buffers.max_by(|a, b| a.0.total_cmp(&b.0).then_with(|| b.1.cell.cmp(&a.1.cell)));
    largest.map(|(_, cell)| cell)
}

#[cfg(test)]
impl Library {
    pub(super) fn with_buffer(self, buffer: Cell) -> Self {
        Self { buffer, ..self }
    }

    pub(super) fn with_clock_gate(self, gate: ClockGate) -> Self {
        Self {
            clock_gate: Some(gate),
            ..self
        }
    }

    /// A library of a register alone.
    pub(super) fn small() -> Self {
        let [cell, input, output] = ["DFF", "D", "Q"].map(str::to_owned);
        let cell = Cell {
            cell,
            input,
            output,
        };
        Self {
            name: "small".to_owned(),
            text: String::new(),
            nand2_area: 1.0,
            buffer: cell.clone(),
            clock_gate: None,
            register: Register {
                cell,
                clock: "CK".to_owned(),
                inverse_outputs: vec!["QN".to_owned()],
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn cell(area: &str, input: u64, output: u64) -> Value {
        json!({"attributes": {"area": area}, "ports": {
            "A": {"direction": "input", "bits": [input]},
            "Y": {"direction": "output", "bits": [output]}}})
    }

    #[test]
    fn the_name_is_read_with_and_without_quotation_marks() {
        assert_eq!(
            name("/* x */\nlibrary (osu018) {").as_deref(),
            Some("osu018")
        );
        assert_eq!(name("library(\"one two\"){").as_deref(), Some("one two"));
        assert_eq!(name("library {"), None);
        assert_eq!(name("module top();"), None);
    }

    #[test]
    fn a_condition_for_opensta_names_one_output_of_a_register() {
        let library = Library {
            text: "when : \"D & Q & !QN\"; when : \"!CK & !Q & QN\"; when : \"A & !B\"".to_owned(),
            ..Library::small()
        };
        assert_eq!(
            library.text(),
            "when : \"D & Q\"; when : \"!CK & !Q\"; when : \"A & !B\""
        );
        assert_eq!(library.sha256(), hexadecimal(&library.text));
    }

    #[test]
    fn the_largest_buffer_within_the_limit_is_taken() {
        let library = Netlist::from(json!({"modules": {
            "INV": cell("16", 2, 3), "BUF1": cell("24", 2, 2), "BUF4": cell("32 ", 2, 2), "BUG4": cell("32", 2, 2),
            "BUF9": cell("136", 2, 2)}}));
        let expected = Cell {
            cell: "BUF4".to_owned(),
            input: "A".to_owned(),
            output: "Y".to_owned(),
        };
        assert_eq!(buffer(&library, 48.0), Some(expected));
        assert_eq!(buffer(&library, 20.0), None);
    }
}
