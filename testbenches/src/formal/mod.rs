//! Formal proofs about the emitted Verilog, by Yosys: each unit is its formula, the control block runs the
//! microprogram, streams neither lose nor repeat a word, sums do not overflow, and a netlist equals its text.
//!
//! A property is a row of a table: a harness that is written by hand from the spec, with its assumptions. It
//! passes if, in one run, it is proven, the states that its assumptions must allow are reached, and each
//! planted fault is refuted.

mod exhaustive;
mod leaf;
mod memory;
mod modules;
mod netlist;
mod overlap;
mod property;
mod sequential;
mod spatial;
mod streams;
mod wires;
mod yosys;

use std::time::Instant;

use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{Machine, Organisation, Unit};
use serde::Serialize;
use thiserror::Error;

use crate::controls::{module_place, plant};
use crate::device::{DeviceError, hdl_error};
use crate::tools::{Tool, ToolError};
use netlist::Netlist;
use property::{Fault, Method, Property};
use yosys::{Answer, DESIGN, ask, ask_of_each};

/// The result of the proof of a property.
#[derive(Clone, Debug, Serialize)]
pub struct Proof {
    /// The name of the property.
    pub property: String,
    /// The module that the property is about, without the machine's prefix.
    pub module: String,
    /// The claim, with its assumptions.
    pub claim: String,
    /// The method of the proof.
    pub method: &'static str,
    /// The largest number of clocks of the proof; 0 for logic without registers.
    pub depth: u32,
    /// Whether the property was proven.
    pub proven: bool,
    /// Whether the states that its assumptions must allow were reached; `None` where there are no
    /// assumptions.
    pub cover_reached: Option<bool>,
    /// Whether every planted fault was refuted by a counter-example.
    pub control_refuted: bool,
    /// The wall time in seconds.
    pub seconds: f64,
    /// The last output of the tool for the step that failed; `None` if no step failed.
    pub not_proven_because: Option<String>,
}

impl Proof {
    /// Whether the proof, the covers and the faults all have the required result.
    pub fn holds(&self) -> bool {
        self.proven && self.cover_reached != Some(false) && self.control_refuted
    }
}

/// All proofs about a machine.
#[derive(Clone, Debug, Serialize)]
pub struct Formal {
    /// The name of the machine.
    pub machine: &'static str,
    /// The tool's version.
    #[serde(skip)]
    pub tool_version: String,
    /// The proofs, one for each property.
    pub proofs: Vec<Proof>,
}

impl Formal {
    /// The proofs that do not have the required result.
    pub fn failed(&self) -> impl Iterator<Item = &Proof> {
        self.proofs.iter().filter(|proof| !proof.holds())
    }
}

/// The error of proofs that could not be tried.
#[derive(Debug, Error)]
pub enum FormalError {
    /// The machine's Verilog cannot be emitted, or Yosys does not run.
    #[error(transparent)]
    Device(#[from] DeviceError),
    /// Yosys is missing.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// No property has the given name.
    #[error("machine `{machine}` has no property of such a name; it has: {known}")]
    Nothing {
        /// The name of the machine.
        machine: &'static str,
        /// The names that exist.
        known: String,
    },
}

/// The properties of the machine's organisation.
fn properties(machine: &Machine, design: &Emitted) -> Vec<Property> {
    let has_module =
        |module: &str| !module_place(&design.text, &full_name(&design.top, module)).is_empty();
    match machine.organisation {
        Organisation::Sequential | Organisation::Programmed(_) => sequential::properties(machine),
        Organisation::Overlapped => overlap::properties(machine),
        Organisation::Spatial(_) => spatial::properties(machine, &has_module),
        Organisation::Leaf(_) => {
            let mut properties = spatial::properties(machine, &has_module);
            properties.extend(leaf::properties(machine));
            properties
        }
    }
}

/// A proof to be done.
enum Task {
    Property(Property),
    Exhaustive,
    /// The comparison of a module with its netlist.
    Netlist(String),
}

impl Task {
    fn name(&self, prefix: &str) -> String {
        match self {
            Self::Property(property) => property.name.to_owned(),
            Self::Exhaustive => exhaustive::NAME.to_owned(),
            Self::Netlist(module) => format!("netlist::{}", netlist::name(module, prefix)),
        }
    }
}

/// All proofs of a machine, in the order of the table.
fn tasks(machine: &Machine, design: &Emitted) -> Vec<Task> {
    let properties = properties(machine, design);
    let properties = properties.into_iter().map(Task::Property);
    let has_square = Level::of(machine)
        .iter()
        .any(|level| [Level::Unit(Unit::Square), Level::SquarePair].contains(level));
    let exhaustive = (has_square && exhaustive::is_possible(machine)).then_some(Task::Exhaustive);
    let is_gates = machine.spatial().is_none_or(streams::has_short_memories);
    let modules = is_gates
        .then(|| netlist::modules(design))
        .into_iter()
        .flatten();
    let netlists = modules.map(Task::Netlist);
    properties.chain(exhaustive).chain(netlists).collect()
}

/// Proves each property of a machine whose name is wanted. Calls `progress` with the number of proofs done
/// and their total.
///
/// # Errors
/// No property is wanted, Yosys is missing, or a property does not fit the emitted text. A property that is
/// not proven is a row of the result and not an error.
pub fn formal(
    machine: &Machine,
    wanted: &dyn Fn(&str) -> bool,
    progress: &dyn Fn(usize, usize),
) -> Result<Formal, FormalError> {
    let design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
    let tool_version = Tool::Yosys.version()?;
    let all = tasks(machine, &design);
    let is_wanted = |task: &&Task| wanted(&task.name(&design.top));
    let tasks: Vec<_> = all.iter().filter(is_wanted).collect();
    if tasks.is_empty() {
        let known = all.iter().map(|task| task.name(&design.top));
        return Err(FormalError::Nothing {
            machine: machine.name,
            known: known.collect::<Vec<_>>().join(", "),
        });
    }
    let needs_netlist = tasks.iter().any(|task| matches!(task, Task::Netlist(_)));
    let netlist = needs_netlist.then(|| Netlist::of(&design)).transpose()?;
    let mut proofs = Vec::new();
    for (done, task) in tasks.iter().enumerate() {
        progress(done, tasks.len());
        let proof = match (task, &netlist) {
            (Task::Property(property), _) => prove(property, &design.text, &design.top)?,
            (Task::Exhaustive, _) => exhaustive::prove(machine)?,
            (Task::Netlist(module), Some(netlist)) => netlist.prove(module)?,
            (Task::Netlist(_), None) => unreachable!("it was made for these"),
        };
        proofs.push(proof);
    }
    Ok(Formal {
        machine: machine.name,
        tool_version,
        proofs,
    })
}

/// Runs the proof, the covers and the faults of one property.
fn prove(property: &Property, design: &str, prefix: &str) -> Result<Proof, FormalError> {
    let started = Instant::now();
    let design = property.design.as_deref().unwrap_or(design);
    let mut questions = vec![property.proof()];
    questions.extend(property.covers.iter().map(|cover| property.search(cover)));
    let commands = property.commands(prefix);
    let harness = property.text();
    let files = [(DESIGN, design), ("harness.sv", &harness)];
    let answers = ask(&files, &commands, &questions)?;
    let mut found: Vec<_> = answers[..1]
        .iter()
        .filter_map(|answer| wrong("the proof", answer, &Answer::Holds))
        .collect();
    let proven = found.is_empty();
    let mut cover_reached = !property.covers.is_empty();
    for (cover, answer) in property.covers.iter().zip(&answers[1..]) {
        let missed = wrong(cover.output, answer, &Answer::Found);
        cover_reached &= missed.is_none();
        found.extend(missed);
    }
    let mut control_refuted = !property.faults.is_empty();
    let designs = property.faults.iter();
    let designs = designs.map(|fault| planted(fault, design, prefix));
    let designs = designs.collect::<Result<Vec<_>, _>>()?;
    let answers = ask_of_each(&designs, &files[1..], &commands, &property.refutation())?;
    for (fault, answer) in property.faults.iter().zip(&answers) {
        let missed = wrong(&fault.put, answer, &Answer::Refuted);
        control_refuted &= missed.is_none();
        found.extend(missed);
    }
    let (method, depth) = match property.method {
        Method::Sat => ("sat", 0),
        Method::Induction(depth) => ("induction", depth),
    };
    Ok(Proof {
        property: property.name.to_owned(),
        module: name_of(property.module),
        claim: property.claim.to_owned(),
        method,
        depth,
        proven,
        cover_reached: Some(cover_reached),
        control_refuted,
        seconds: started.elapsed().as_secs_f64(),
        not_proven_because: (!found.is_empty()).then(|| found.join("\n")),
    })
}

/// Describes an answer that differs from the expected one.
fn wrong(what: &str, answer: &Answer, expected: &Answer) -> Option<String> {
    (answer != expected).then(|| match answer {
        Answer::None(said) => {
            format!("{what}: {expected:?} expected, no answer; last was said:\n{said}")
        }
        answer => format!("{what}: {expected:?} expected, {answer:?} found"),
    })
}

fn name_of(module: &str) -> String {
    let name = if module.is_empty() { "top" } else { module };
    name.to_owned()
}

/// Plants a fault in the design.
fn planted(fault: &Fault, design: &str, prefix: &str) -> Result<String, DeviceError> {
    plant(
        design,
        &full_name(prefix, fault.module),
        &fault.find,
        &fault.put,
    )
}

/// The name of a module in the text, from its name without the prefix.
fn full_name(prefix: &str, module: &str) -> String {
    match module {
        "" => prefix.to_owned(),
        module => format!("{prefix}_{module}"),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use photoncube_spec::{MACHINES, find_machine};

    /// Every fault of every table changes its text in one place, property names are unique, and every unit
    /// belongs to some machine.
    #[test]
    fn every_fault_stands_in_its_module_once() {
        let mut units: BTreeSet<_> = spatial::unit_modules().collect();
        // Photons on grid lines are in custom machines alone.
        let half_steps = find_machine("stream-local6x2-rgb4e2d-n4096").unwrap();
        for machine in MACHINES.iter().chain([half_steps]) {
            let design = emit(machine, Level::Machine).unwrap();
            let properties = properties(machine, &design);
            for property in &properties {
                units.remove(property.module);
                assert!(!property.faults.is_empty() && !property.covers.is_empty());
                for fault in &property.faults {
                    let text = property.design.as_ref().unwrap_or(&design.text);
                    let planted = planted(fault, text, &design.top).unwrap();
                    assert_ne!(&planted, text);
                }
            }
            let tasks = tasks(machine, &design);
            let names: BTreeSet<_> = tasks.iter().map(|task| task.name(&design.top)).collect();
            assert_eq!(names.len(), tasks.len());
        }
        assert!(units.is_empty(), "{units:?}");
    }

    #[test]
    fn a_fault_that_is_not_there_is_an_error() {
        let machine = find_machine("paper").unwrap();
        let design = emit(machine, Level::Machine).unwrap();
        for (module, find) in [
            ("difference", "no such text"),
            ("no_such_module", "a"),
            ("difference", "a"),
        ] {
            let fault = Fault::new(module, find, "b");
            let error = planted(&fault, &design.text, &design.top).unwrap_err();
            assert!(error.to_string().contains("once"), "{error}");
        }
    }
}
