//! Draws mutations with Yosys, and makes one design that contains all of them.

use std::collections::BTreeSet;
use std::path::Path;

use photoncube_hdl::Emitted;
use photoncube_spec::{Pin, Pins, SignalPlace};
use serde::Serialize;

use crate::device::{DeviceError, scratch_folder, write_file};
use crate::tools;

/// The pin that selects the active mutation; 0 selects none.
const PIN: &str = "mutant";
/// The width of the pin.
const PIN_WIDTH: u32 = 16;

/// Turns the text into cells that can be mutated. Processes become registers and two-way multiplexers, whose
/// meaning is defined for every select value; tables stay.
pub(super) const ELABORATION: &str = "proc -norom; pmuxtree; opt_clean";

/// Flattens the elaborated modules so that each net has one name and every register is kept, even without a
/// reader. A memory of more than 256 words is removed: its inputs become outputs, which are compared as
/// registers' next values are, so its words stay equal. The words read are free, and equal in both designs
/// for equal places. Smaller memories become registers. Buffers before the pins keep a register from being
/// named as the pin that it drives; a mutation between the two would otherwise change the name.
pub(super) const FLAT: &str = "flatten\nmemory_collect\nexpose -evert t:$mem_v2 r:SIZE>256 %i\n\
     iopadmap -bits -outpad $_BUF_ A:Y\nsetattr -set keep 1 t:$_BUF_\n\
     memory_map\nsetattr -set keep 1 t:$dff\nopt_clean -purge\nsetattr -unset keep t:$dff";

/// One mutation of a design.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Mutation {
    /// The mutation's number, from 1.
    pub mutant: u64,
    /// The module's name, without the machine's prefix. Every instance of it is mutated.
    pub module: String,
    /// The options for Yosys's `mutate`: the kind, the cell, its port and bit, and the place in the text.
    #[serde(rename = "mutation")]
    pub options: String,
}

impl Mutation {
    /// The module's name in the text.
    pub(super) fn module_in_text(&self) -> Option<&str> {
        module_in_text(&self.options)
    }
}

/// Draws about `wanted` mutations.
pub(super) fn draw(design: &Emitted, wanted: u64, seed: u64) -> Result<Vec<Mutation>, DeviceError> {
    let list = format!("tee -q -o list.txt mutate -list {wanted} -seed {seed}");
    let folder = scratch_folder()?;
    yosys(folder.path(), design, &list)?;
    let text = read(&folder.path().join("list.txt"))?;
    let mut seen = BTreeSet::new();
    let lines = text.lines().filter_map(|line| line.strip_prefix("mutate "));
    let lines = lines.filter(|options| seen.insert(options.to_string()));
    let mutations: Vec<_> = lines
        .filter(|options| !moves_an_edge(options) && !changes_an_initial_value(options))
        .zip(1..)
        .map(|(options, mutant)| Mutation {
            mutant,
            module: module_of(options, &design.top),
            options: options.to_owned(),
        })
        .collect();
    match mutations.is_empty() || mutations.len() >= 1 << PIN_WIDTH {
        false => Ok(mutations),
        true => Err(DeviceError::BrokeOff {
            device: "yosys".to_owned(),
            message: format!(
                "it drew {} mutations; expected 1 up to {}",
                mutations.len(),
                (1 << PIN_WIDTH) - 1
            ),
        }),
    }
}

/// Whether the mutation inverts a clock. The comparison is clock by clock and has no half clocks, so neither
/// simulation nor proof can distinguish the two edges. A mutation that stops a clock is kept.
fn moves_an_edge(options: &str) -> bool {
    let words: Vec<_> = options.split_whitespace().collect();
    let value = |name| {
        let index = words.iter().position(|word| *word == name)?;
        words.get(index + 1).copied()
    };
    let of_clock = [value("-port"), value("-wire")]
        .into_iter()
        .flatten()
        .any(|name| name.ends_with("clock") || name == "CLK");
    of_clock && !value("-mode").is_some_and(|mode| mode.starts_with("const"))
}

/// Whether the mutation changes the initial contents of a memory, which no pin can change.
fn changes_an_initial_value(options: &str) -> bool {
    options.contains("-cell $meminit")
}

fn module_in_text(options: &str) -> Option<&str> {
    let mut words = options.split_whitespace();
    words.find(|word| *word == "-module").and(words.next())
}

fn module_of(options: &str, prefix: &str) -> String {
    let module = module_in_text(options).unwrap_or_default();
    match module.strip_prefix(prefix) {
        Some("") => "top".to_owned(),
        Some(rest) => rest.trim_start_matches('_').to_owned(),
        None => module.to_owned(),
    }
}

/// The design with every mutation. Each is active where the new input pin [`PIN`] has its number.
pub(super) fn with_all(design: &Emitted, mutations: &[Mutation]) -> Result<Emitted, DeviceError> {
    let mut script = vec![format!("add -global_input {PIN} {PIN_WIDTH}")];
    script.extend(mutations.iter().map(|mutation| {
        let (number, options) = (mutation.mutant, &mutation.options);
        format!("mutate -ctrl {PIN} {PIN_WIDTH} {number} {options}")
    }));
    script.push("opt_clean".to_owned());
    script.push("write_verilog -noattr mutated.v".to_owned());
    let folder = scratch_folder()?;
    yosys(folder.path(), design, &script.join("\n"))?;
    let mut pins: Pins = design.pins.clone();
    pins.inputs.push(Pin {
        name: PIN.to_owned(),
        width: PIN_WIDTH,
        place: SignalPlace::Top,
    });
    Ok(Emitted {
        text: read(&folder.path().join("mutated.v"))?,
        pins,
        ..design.clone()
    })
}

/// Runs a script, one command a line, on the elaborated design.
pub(super) fn yosys(folder: &Path, design: &Emitted, script: &str) -> Result<(), DeviceError> {
    write_file(&folder.join("design.v"), &design.text)?;
    let top = &design.top;
    let script = format!(
        "read_verilog design.v\nhierarchy -top {top}\n{}\n{script}\n",
        ELABORATION.replace("; ", "\n")
    );
    run(folder, &script)
}

/// Runs a script, one command a line.
pub(super) fn run(folder: &Path, script: &str) -> Result<(), DeviceError> {
    let yosys = tools::yosys()?;
    let script = tools::script_for(&yosys, script)?;
    write_file(&folder.join(fpga_flow::SCRIPT), &script)?;
    yosys.run_script(folder)?;
    Ok(())
}

pub(super) fn read(path: &Path) -> Result<String, DeviceError> {
    std::fs::read_to_string(path).map_err(|source| DeviceError::File {
        action: "read",
        path: path.display().to_string(),
        source,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_may_stand_still_but_not_turn_round() {
        let of = |mode: &str, port: &str| {
            format!("-mode {mode} -module m_cell -cell c -port {port} -portbit 0 -wire a_clock")
        };
        assert!(moves_an_edge(&of("inv", "clock")));
        assert!(moves_an_edge("-mode cnot0 -cell c -port CLK"));
        assert!(!moves_an_edge(&of("const0", "clock")));
        assert!(!moves_an_edge("-mode inv -cell c -port Q -wire q"));
        assert_eq!(module_of(&of("inv", "A"), "m"), "cell");
        assert_eq!(module_of("-mode inv -module m -cell c", "m"), "top");
    }
}
