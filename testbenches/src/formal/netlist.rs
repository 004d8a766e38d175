//! Proves that each module of a machine equals its own synthesised netlist, with its submodules removed.
//!
//! The outputs of a submodule are free inputs of both sides. The inputs of each submodule, and each register,
//! must be equal at power-up, and after any clock before which all were equal. Modules that are equal for any
//! submodules, and that have the same instances, make equal machines.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use photoncube_hdl::Emitted;

use super::modules::Modules;
use super::yosys::{Answer, Question, SECONDS_EACH, ask, run};
use super::{Proof, wrong};
use crate::device::{DeviceError, block_ram_names, netlist_text};
use crate::tools::LOWER;

/// The most mutants that are tried until one is refuted. Some mutants are equal to the module.
const MUTANTS: usize = 6;

/// Makes `gold` from the emitted text and `gate` from the netlist, up to their memories. `opt_dff` makes the enables of
/// registers, without which the register of a block RAM's word does not become a part of it, as it does in synthesis.
const READ: &str = "proc -norom\nopt_dff\nopt_clean\nmemory -nomap\n";

/// Removes the block RAMs, whose words have no value at power-up. The words read are free inputs of both sides; the inputs
/// of the block RAM must be equal, and so its words stay equal. Other memories become registers, and tables become gates.
fn map(block_rams: &[&str]) -> String {
    let removed = block_rams
        .iter()
        .map(|name| format!("expose -evert c:{name}\n"));
    removed.collect::<String>() + "memory_map\nopt_clean\n"
}

/// The assumptions about modules, by name. The queue's memory has `no_rw_check`: if a place is read in the
/// clock in which it is written, synthesis may choose the value. This happens only in a queue that is given
/// more than it holds, see `streams::queue`.
const ASSUMED: [(&str, &str); 1] = [(
    "queue",
    "!(result_valid_in && reads && write_place == read_place)",
)];

/// Makes the miter of both sides. Registers that both sides name are outputs.
const MITER: &str = "expose -shared -dff gold gate\nopt_clean\nmiter -equiv -flatten -make_outputs gold gate miter\n\
                     opt_clean\n";

/// The emitted text and the netlist of all modules.
pub(super) struct Netlist<'a> {
    prefix: &'a str,
    emitted: Modules<'a>,
    /// The names of arrays that are block RAMs.
    block_rams: BTreeSet<&'a str>,
    text: String,
}

impl<'a> Netlist<'a> {
    /// Synthesises a design, each module on its own.
    ///
    /// # Errors
    /// Yosys is missing or refuses the text.
    pub fn of(design: &'a Emitted) -> Result<Self, DeviceError> {
        Ok(Self {
            prefix: &design.top,
            emitted: Modules::of(&design.text),
            block_rams: block_ram_names(design),
            text: netlist_text(design, false)?,
        })
    }

    /// The block RAMs of a module.
    fn block_rams_of(&self, module: &str) -> Vec<&'a str> {
        let text = self.emitted.text(module);
        let is_declared = |name: &&str| text.contains(&format!(" {name} ["));
        self.block_rams
            .iter()
            .copied()
            .filter(is_declared)
            .collect()
    }

    /// Proves a module equal to its netlist.
    ///
    /// # Errors
    /// Yosys is missing or does not start.
    pub fn prove(&self, module: &str) -> Result<Proof, DeviceError> {
        let started = Instant::now();
        let netlist = Modules::of(&self.text);
        let assumption = assumption(&name(module, self.prefix));
        let text = self.emitted.with_parts(module);
        let ours = assumption.map(|condition| with_assumption(&text, module, condition));
        let ours = ours.unwrap_or(text);
        let sides = Sides {
            module,
            block_rams: &self.block_rams_of(module),
            ours,
            theirs: netlist.with_parts(module),
        };
        let mut found = Vec::new();
        let (ours, theirs) = (self.emitted.instances(module), netlist.instances(module));
        if ours != theirs {
            found.push(format!(
                "instances: {ours:?} in the text, {theirs:?} in the netlist"
            ));
        }
        if !sides.block_rams.is_empty() {
            found.extend(sides.unlike_block_rams()?);
        }
        let answer = sides.prove_equal()?;
        found.extend(wrong("the proof", &answer, &Answer::Holds));
        let proven = found.is_empty();
        let cover_reached = match assumption {
            Some(_) => Some(sides.is_possible()?),
            None => None,
        };
        if cover_reached == Some(false) {
            found.push("what is assumed is never so".to_owned());
        }
        let control_refuted = sides.are_refuted()?;
        if !control_refuted {
            found.push("no change of the netlist was refuted".to_owned());
        }
        Ok(Proof {
            property: format!("netlist::{}", name(module, self.prefix)),
            module: name(module, self.prefix),
            claim: claim(&name(module, self.prefix)),
            method: "equivalence",
            depth: 1,
            proven,
            cover_reached,
            control_refuted,
            seconds: started.elapsed().as_secs_f64(),
            not_proven_because: (!found.is_empty()).then(|| found.join("\n")),
        })
    }
}

/// The names of all modules of a design; the top is the last.
pub(super) fn modules(design: &Emitted) -> Vec<String> {
    let emitted = Modules::of(&design.text);
    let mut names: Vec<_> = emitted.names().map(str::to_owned).collect();
    names.sort_by_key(|name| *name == design.top);
    names
}

/// The name of a module without the machine's prefix.
pub(super) fn name(module: &str, prefix: &str) -> String {
    let rest = module.strip_prefix(prefix).unwrap_or(module);
    super::name_of(rest.trim_start_matches('_'))
}

/// The assumption about a module, if there is one.
fn assumption(name: &str) -> Option<&'static str> {
    let mut all = ASSUMED.iter();
    all.find(|(of, _)| *of == name)
        .map(|(_, condition)| *condition)
}

fn claim(name: &str) -> String {
    let mut claim = "the module is its synthesised netlist, for any parts".to_owned();
    if assumption(name).is_some() {
        claim += "; assumed: no word is read from a place in the clock that writes it";
    }
    claim
}

/// The text with an assumption in the module that holds in each clock.
fn with_assumption(text: &str, module: &str, condition: &str) -> String {
    let modules = verilog_eval::modules(text).into_iter();
    let mut places = modules.filter(|of| of.name == module).map(|of| of.place);
    let end = places
        .next()
        .map_or(text.len(), |place| place.end - "endmodule".len());
    let assumption = format!("  always @(*) assume({condition});\n");
    format!("{}{assumption}{}", &text[..end], &text[end..])
}

/// A module's text and its netlist, each with its parts.
struct Sides<'a> {
    module: &'a str,
    block_rams: &'a [&'a str],
    ours: String,
    theirs: String,
}

impl Sides<'_> {
    /// The commands that read one of the two sides.
    fn side(&self, name: &str, file: &str) -> String {
        let (module, map) = (self.module, map(self.block_rams));
        format!(
            "read_verilog -formal {file}\nhierarchy -top {module}\n{READ}{LOWER}{map}rename {module} {name}\nexpose -evert {name}/c:*\n"
        )
    }

    /// The commands that make the miter of both sides.
    fn miter(&self) -> String {
        self.side("gold", "design.v")
            + "design -copy-to joint gold\ndesign -reset\n"
            + &self.side("gate", "netlist.v")
            + "design -copy-to joint gate\ndesign -load joint\n"
            + MITER
    }

    /// Asks about the module and a netlist of it.
    fn ask(&self, theirs: &str, questions: &[Question]) -> Result<Vec<Answer>, DeviceError> {
        let files = [("design.v", self.ours.as_str()), ("netlist.v", theirs)];
        ask(&files, &self.miter(), questions)
    }

    /// The differences of the block RAMs of both sides in their parameters: clock edges, writes and resets.
    fn unlike_block_rams(&self) -> Result<Option<String>, DeviceError> {
        let module = self.module;
        let dump = |file: &str, mark: &str| {
            format!(
                "read_verilog {file}\nhierarchy -top {module}\n{READ}log {mark}\ndump t:$mem_v2\ndesign -reset\n"
            )
        };
        const MARKS: [&str; 3] = [
            "photoncube-emitted",
            "photoncube-netlist",
            "photoncube-dumped",
        ];
        let script = dump("design.v", MARKS[0]) + &dump("netlist.v", MARKS[1]) + "log " + MARKS[2];
        let files = [
            ("design.v", self.ours.as_str()),
            ("netlist.v", &self.theirs),
        ];
        let log = run(&files, &(script + "\n"), Duration::from_secs(SECONDS_EACH))?;
        let parameters = |marks: &[&str]| -> Option<Vec<&str>> {
            let begin = log.find(&format!("\n{}\n", marks[0]))? + 1;
            let end = begin + log[begin..].find(&format!("\n{}\n", marks[1]))?;
            let lines = log[begin..end].lines().map(str::trim);
            Some(
                lines
                    .filter(|line| line.starts_with("parameter "))
                    .collect(),
            )
        };
        Ok(match (parameters(&MARKS[..2]), parameters(&MARKS[1..])) {
            (Some(ours), Some(theirs)) if !ours.is_empty() && ours == theirs => None,
            (ours, theirs) => Some(format!(
                "the block RAMs: {ours:?} in the text, {theirs:?} in the netlist"
            )),
        })
    }

    /// Proves both sides equal at power-up, and equal after a clock if they were equal before it.
    fn prove_equal(&self) -> Result<Answer, DeviceError> {
        let question = Question {
            before: "",
            options: "-set-assumes -tempinduct -prove trigger 0 -maxsteps 1 miter".to_owned(),
        };
        let mut answers = self.ask(&self.theirs, &[question])?;
        Ok(answers.remove(0))
    }

    /// Whether the assumption is possible while both sides are equal.
    fn is_possible(&self) -> Result<bool, DeviceError> {
        let question = Question {
            before: "setattr -unset init w:*\n",
            options: "-set-assumes -seq 1 -set-at 1 trigger 0 miter".to_owned(),
        };
        Ok(self
            .ask(&self.theirs, &[question])?
            .contains(&Answer::Found))
    }

    /// Whether a change of the netlist is refuted: a value differs at power-up, or one clock after some state in
    /// which all values are equal.
    fn are_refuted(&self) -> Result<bool, DeviceError> {
        let at_first = Question {
            before: "",
            options:
                "-set-assumes -tempinduct -tempinduct-baseonly -prove trigger 0 -maxsteps 1 miter"
                    .to_owned(),
        };
        let after = Question {
            before: "setattr -unset init w:*\n",
            options: "-set-assumes -seq 2 -set-at 1 trigger 0 -prove trigger 0 -prove-skip 1 miter"
                .to_owned(),
        };
        let questions = [at_first, after];
        for mutant in mutants(&self.theirs, self.module) {
            if self.ask(&mutant, &questions)?.contains(&Answer::Refuted) {
                return Ok(true);
            }
        }
        Ok(false)
    }
}

/// Netlists with one assignment, or one input of a submodule, inverted.
fn mutants(netlist: &str, module: &str) -> Vec<String> {
    let lines: Vec<_> = netlist.lines().collect();
    let modules = verilog_eval::modules(netlist).into_iter();
    let mut places = modules.filter(|of| of.name == module).map(|of| of.place);
    let line_of = |at: usize| netlist[..at].matches('\n').count();
    let inside = places.next();
    let inside = inside.map_or(0..0, |place| line_of(place.start)..line_of(place.end));
    let inverted = |line: &str| {
        let (target, value) = line.strip_prefix("  assign ")?.split_once(" = ")?;
        let value = value.strip_suffix(';')?;
        Some(format!("  assign {target} = ~({value});"))
    };
    let clocked = |line: &str| {
        let (target, value) = line.split_once(" <= ")?;
        Some(format!("{target} <= ~({});", value.strip_suffix(';')?))
    };
    let outputs: BTreeSet<_> = lines.iter().filter_map(|line| output(line)).collect();
    let connected = |line: &str| {
        let (port, value) = line.trim().strip_prefix('.')?.split_once('(')?;
        if outputs.contains(port) {
            return None;
        }
        let end = value.rfind(')')?;
        Some(format!(".{port}(~{}){}", &value[..end], &value[end + 1..]))
    };
    let changed = |index: usize| {
        let line = lines[index];
        Some((
            index,
            inverted(line)
                .or_else(|| clocked(line))
                .or_else(|| connected(line))?,
        ))
    };
    let mut all: Vec<_> = inside.filter_map(changed).collect();
    // Assignments of logic come first, wires between submodules last. The choice is spread over the whole
    // module.
    all.sort_by_key(|(_, line)| line.starts_with('.'));
    let logic = all
        .iter()
        .filter(|(_, line)| !line.starts_with('.'))
        .count();
    let (logic, wires) = all.split_at(logic);
    let mutant = |(index, line): &(usize, String)| {
        let mut lines = lines.clone();
        lines[*index] = line;
        lines.join("\n") + "\n"
    };
    let spread = |all: &[(usize, String)]| -> Vec<_> {
        let step = all.len().div_ceil(MUTANTS).max(1);
        all.iter().step_by(step).map(mutant).collect()
    };
    [spread(logic), spread(wires)].concat()
}

/// The name of the output that a line declares; `None` for other lines.
fn output(line: &str) -> Option<&str> {
    let declared = line.strip_prefix("  output ")?.strip_suffix(';')?;
    declared.rsplit(' ').next()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_assumption_stands_in_its_module() {
        let text = "module a(p);\n  input p;\nendmodule\nmodule b(p);\n  input p;\nendmodule\n";
        let expected = "module a(p);\n  input p;\n  always @(*) assume(p);\nendmodule\nmodule b(p);\n  input p;\nendmodule\n";
        assert_eq!(with_assumption(text, "a", "p"), expected);
    }

    #[test]
    fn mutants_differ_in_one_line_of_the_module() {
        let netlist = "module a(p, q);\n  input p;\n  output q;\n  assign q = p;\nendmodule\n\
                       module b(x, y);\n  output [3:0] y;\n  assign y = x & 1'h1;\n    r <= x;\n  a one (\n    .p(x),\n    \
                       .q(y)\n  );\nendmodule\n";
        let mutants = mutants(netlist, "b");
        assert_eq!(mutants.len(), 3, "{mutants:#?}");
        let changes = ["  assign y = ~(x & 1'h1);", "    r <= ~(x);", ".p(~x),"];
        for (mutant, change) in mutants.iter().zip(changes) {
            let differ = mutant
                .lines()
                .zip(netlist.lines())
                .filter(|(new, old)| new != old);
            assert_eq!(differ.map(|(new, _)| new).collect::<Vec<_>>(), [change]);
        }
        assert!(super::mutants(netlist, "no_such").is_empty());
    }
}
