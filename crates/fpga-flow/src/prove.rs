//! Proves that a pass over a netlist preserves its function, with Yosys's SAT solver and the models of the
//! cells.

use std::fmt::Write;
use std::path::Path;

use serde::Serialize;

use crate::error::{Result, ensure, read, write};
use crate::models::Models;
use crate::netlist::{Change, Stage, changes};
use crate::yosys::Yosys;

/// The number of clocks of the induction. A word is compared at the output, behind at most two registers in a
/// row.
const MOST_STEPS: u32 = 4;

/// Yosys's messages of a successful and of a failed proof.
const PROVEN: &str = "Induction step proven: SUCCESS!";
const REFUTED: [&str; 2] = [
    "SAT temporal induction proof finished - model found for base case: FAIL!",
    "SAT proof finished - model found: FAIL!",
];

/// A mark in the log before the output of each question.
const MARK: &str = "fpga-flow-question";

/// The proof of one pass over a netlist.
#[derive(Clone, Debug, Serialize)]
pub struct PassProof {
    /// The name of the pass.
    pub pass: &'static str,
    /// The number of cells that it changed or removed.
    pub cells_changed: usize,
    /// The number of different changes among these.
    pub different_changes: usize,
    /// Whether each change preserves the function for all inputs, in all clocks from power-up.
    pub proven: bool,
    /// Whether a fault in each change was refuted by a counter-example.
    pub control_refuted: bool,
    /// The changes that fail one of these conditions, with Yosys's output.
    pub not_proven_because: Option<String>,
}

/// Proves each pass, with the models of the cells.
///
/// # Errors
/// A pass has done more than change cells, a cell has no model, or Yosys fails.
pub fn prove(
    yosys: &Yosys,
    folder: &Path,
    models: &Models,
    stages: &[Stage],
) -> Result<Vec<PassProof>> {
    stages
        .iter()
        .try_for_each(|stage| models.check(&stage.netlist))?;
    let pairs = stages.windows(2);
    let proof = |pair: &[Stage]| {
        let found = changes(&pair[0].netlist, &pair[1].netlist)?;
        prove_pass(yosys, folder, models, pair[1].name, &found)
    };
    pairs.map(proof).collect()
}

fn prove_pass(
    yosys: &Yosys,
    folder: &Path,
    models: &Models,
    pass: &'static str,
    found: &[Change],
) -> Result<PassProof> {
    let mut proof = PassProof {
        pass,
        cells_changed: found.iter().map(|change| change.places).sum(),
        different_changes: found.len(),
        proven: true,
        control_refuted: true,
        not_proven_because: None,
    };
    if found.is_empty() {
        return Ok(proof);
    }
    let mut wrong = Vec::new();
    for (change, [sound, fault]) in found.iter().zip(asked(yosys, folder, models, found)?) {
        let place = format!(
            "{} {} and {} others",
            change.kind,
            change.place,
            change.places - 1
        );
        if !sound.contains(PROVEN) {
            proof.proven = false;
            wrong.push(format!("{place} is not proven: {}", last(&sound)));
        }
        if !REFUTED.iter().any(|word| fault.contains(word)) {
            proof.control_refuted = false;
            wrong.push(format!(
                "a fault in {place} is not refuted: {}",
                last(&fault)
            ));
        }
    }
    proof.not_proven_because = (!wrong.is_empty()).then(|| wrong.join("\n"));
    Ok(proof)
}

/// Yosys's answers for each change, and for the fault in it.
fn asked(
    yosys: &Yosys,
    folder: &Path,
    models: &Models,
    found: &[Change],
) -> Result<Vec<[String; 2]>> {
    let (mut text, mut all) = (models.verilog().to_owned(), String::new());
    for (index, change) in found.iter().enumerate() {
        let name = format!("change_{index}");
        text += &change.modules(&name);
        for side in SIDES {
            let _ = writeln!(all, "  {name}_{side} {side}_{index}();");
        }
    }
    let _ = write!(text, "module all();\n{all}endmodule\n");
    write(&folder.join("changes.v"), &text)?;
    let log = folder.join("changes.log");
    write(&log, "")?;
    yosys.run(folder, &script(found.len(), models.words))?;
    let said = read(&log)?;
    let mut parts = said.split(MARK).skip(1).map(str::to_owned);
    let answers: Vec<_> = std::iter::from_fn(|| Some([parts.next()?, parts.next()?])).collect();
    let (asked, answered) = (found.len(), answers.len());
    ensure(answered == asked, || {
        format!("found {answered} answers in Yosys's log, expected {asked}")
    })?;
    Ok(answers)
}

const SIDES: [&str; 3] = ["before", "after", "wrong"];

/// The Yosys script. The words of a block RAM are removed: they are free, and the effect of both sides on
/// them must be equal. Unknown values are 0 on both sides.
fn script(count: usize, words: &str) -> String {
    let mut script = format!(
        "read_verilog changes.v; blackbox {words}; hierarchy -top all; proc; flatten change_*; \
         select -assert-none change_*/t:not_modelled; \
         expose -evert change_*/t:{words}; setundef -zero change_*; opt_clean"
    );
    for index in 0..count {
        for side in &SIDES[1..] {
            let (name, miter) = (format!("change_{index}"), format!("miter_{index}_{side}"));
            let _ = write!(
                script,
                "; miter -equiv -flatten -make_outputs {name}_before {name}_{side} {miter}; \
                 tee -q -a changes.log log {MARK}; \
                 tee -q -a changes.log sat -tempinduct -prove trigger 0 -maxsteps {MOST_STEPS} {miter}"
            );
        }
    }
    script
}

/// The end of Yosys's output.
fn last(said: &str) -> &str {
    said.trim_end().lines().last().unwrap_or("nothing was said")
}
