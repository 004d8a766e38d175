//! Makes small designs for the evaluator and Icarus.

use photoncube_hdl::Emitted;
use photoncube_spec::{Pin, Pins, SignalPlace};
use photoncube_testbench::{Device, Icarus, Observed, Text};
use rand::{Rng, RngExt};

/// A module `top` of these items, with an input for each name and width, an output for each name and width,
/// and optionally a clock.
pub fn design(
    inputs: &[(String, u32)],
    outputs: &[(String, u32)],
    clocked: bool,
    items: &str,
    other_modules: &str,
) -> Emitted {
    let pin = |(name, width): &(String, u32)| Pin {
        name: name.clone(),
        width: *width,
        place: SignalPlace::Top,
    };
    let pins = Pins {
        inputs: inputs.iter().map(pin).collect(),
        observed: outputs.iter().map(pin).collect(),
        outputs: outputs.len(),
    };
    let names = pins.inputs.iter().chain(&pins.observed);
    let mut ports: Vec<_> = names.map(|pin| pin.name.clone()).collect();
    let mut text = String::new();
    if clocked {
        ports.push("clock".to_owned());
        text += "  input wire clock;\n";
    }
    for input in &pins.inputs {
        text += &format!("  input wire [{}:0] {};\n", input.width - 1, input.name);
    }
    Emitted {
        text: format!(
            "module top({});\n{text}{items}endmodule\n{other_modules}",
            ports.join(", ")
        ),
        top: "top".to_owned(),
        ecp5_text: None,
        clocked,
        pins,
        register_paths: Vec::new(),
        block_rams: Vec::new(),
    }
}

/// Rows of inputs in which every other value is a corner.
pub fn rows(design: &Emitted, count: usize, rng: &mut impl Rng) -> Vec<u64> {
    let mut rows = Vec::new();
    for _ in 0..count {
        for pin in &design.pins.inputs {
            let all = u64::MAX >> (u64::BITS - pin.width);
            let value = match rng.random_range(0..8) {
                0 => 0,
                1 => all,
                2 => all >> 1,
                3 => (all >> 1) + 1,
                _ => rng.random(),
            };
            rows.push(value & all);
        }
    }
    rows
}

pub fn in_text(design: &Emitted, rows: &[u64]) -> Observed {
    let device = Text::new(design);
    let mut device = device.unwrap_or_else(|refusal| panic!("{refusal}\n{}", numbered(design)));
    let mut observed = Observed::default();
    device.replay(rows, &mut observed).expect("it runs");
    observed
}

pub fn in_icarus(design: &Emitted, rows: &[u64]) -> Observed {
    let mut device = Icarus::new(design).expect("Icarus takes the text");
    let mut observed = Observed::default();
    device.replay(rows, &mut observed).expect("it runs");
    observed
}

/// Requires that the evaluator shows the values of Icarus, unknown bits included. Returns the number of
/// values compared.
pub fn assert_as_in_icarus(design: &Emitted, rows: &[u64]) -> usize {
    let (ours, theirs) = (in_text(design, rows), in_icarus(design, rows));
    assert_eq!(ours.values.len(), theirs.values.len());
    let outputs = design.pins.observed.len();
    let shown = |observed: &Observed, index: usize| {
        let unknown = observed
            .unknown
            .iter()
            .find(|unknown| unknown.index == index);
        // An undriven bit is z in Icarus.
        let text = unknown.map(|unknown| unknown.text.replace('z', "x").replace('Z', "X"));
        text.unwrap_or_else(|| format!("{:x}", observed.values[index]))
    };
    for index in 0..ours.values.len() {
        let (ours, theirs) = (shown(&ours, index), shown(&theirs, index));
        if ours == theirs {
            continue;
        }
        let name = &design.pins.observed[index % outputs].name;
        let inputs = design.pins.inputs.len();
        let row = &rows[index / outputs * inputs..][..inputs];
        let word = |line: &&str| {
            let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
            words.any(|word| word == name.as_str())
        };
        let lines: Vec<_> = design.text.lines().filter(word).collect();
        panic!(
            "{name} in row {}: {ours}, in Icarus {theirs}; inputs {row:x?}\n{}\n",
            index / outputs,
            lines.join("\n")
        );
    }
    ours.values.len()
}

fn numbered(design: &Emitted) -> String {
    let lines = design.text.lines().enumerate();
    let lines: Vec<_> = lines
        .map(|(index, line)| format!("{:5} {line}", index + 1))
        .collect();
    lines.join("\n")
}
