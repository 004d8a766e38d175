//! Proves that a mutant equals the design: for equal values in all registers and on all input pins, all
//! registers have equal next values and all outputs have equal values. Where that fails, the mutated module alone may be proven
//! equal at its outputs.

use std::path::Path;

use photoncube_hdl::Emitted;

use super::Mutation;
use super::alone::{self, ObservedModules};
use super::design::{FLAT, run, yosys};
use super::invariants::{Invariants, around_two};
use crate::device::{DeviceError, scratch_folder, write_file};
use crate::tools::ToolError;

/// The time limit of the solver in seconds. A proof that takes longer fails.
const SECONDS: u32 = 60;

/// The solver's command, without the module. Yosys fails where the proof does.
const SOLVE: &str = "sat -verify -prove-asserts";

/// The file of the design, the mutant and their comparison.
const MITER: &str = "miter.il";

/// Proves that mutants equal the design.
pub(super) struct Prover<'a> {
    pub design: &'a Emitted,
    pub invariants: &'a Invariants,
    pub observed: &'a ObservedModules,
}

impl Prover<'_> {
    /// The proof that no signal can differ, if one is found.
    ///
    /// # Errors
    /// Yosys does not run.
    pub fn proof(&self, mutation: &Mutation) -> Result<Option<String>, DeviceError> {
        let folder = scratch_folder()?;
        let folder = folder.path();
        if self.is_proven_plainly(mutation, folder)? {
            let proof = "the same next values of all registers, from any values, by sat";
            return Ok(Some(proof.to_owned()));
        }
        if self.is_proven_within(&[], folder)? {
            let proof = "the same next values of all registers, from any values within the \
                         invariants and the declared count, by sat";
            return Ok(Some(proof.to_owned()));
        }
        let stays = self.invariants.group_stays();
        if !stays.is_empty() && self.is_proven_within(&stays, folder)? {
            let proof = "the same next values of all registers, from any values within the invariants and the \
                         declared count, while a group stays valid until it is taken, by sat";
            return Ok(Some(proof.to_owned()));
        }
        if is_proven_alone(self.design, self.observed, mutation, folder)? {
            let proof = "the same outputs of the module in all clocks, by temporal induction on the module alone";
            return Ok(Some(proof.to_owned()));
        }
        Ok(None)
    }

    /// Makes the comparison of the design and the mutant, writes it to [`MITER`] of the folder, and tries to prove it from any
    /// values of the registers.
    fn is_proven_plainly(&self, mutation: &Mutation, folder: &Path) -> Result<bool, DeviceError> {
        let (top, options) = (&self.design.top, &mutation.options);
        let script = format!(
            "design -save elaborated\n{FLAT}\nrename {top} gold\ndesign -stash gold\n\
             design -load elaborated\nmutate {options}\n{FLAT}\nrename {top} gate\ndesign -stash gate\n\
             design -copy-from gold -as gold gold\ndesign -copy-from gate -as gate gate\n\
             expose -evert-dff -dff -shared gold gate\n\
             miter -equiv -flatten -make_assert -make_outputs gold gate miter\nwrite_rtlil {MITER}\n\
             hierarchy -top miter\nopt -full\n{}",
            solve("", "miter")
        );
        is_proven(yosys(folder, self.design, &script))
    }

    /// Tries to prove the comparison in the folder from values within the invariants and these further conditions.
    fn is_proven_within(&self, more: &[String], folder: &Path) -> Result<bool, DeviceError> {
        write_file(
            &folder.join("wrapper.sv"),
            &self.invariants.around_miter(more),
        )?;
        let script = format!(
            "read_rtlil {MITER}\n{}\n{}\n",
            around_two(),
            solve("-set-assumes", "wrapper")
        );
        is_proven(run(folder, &script))
    }
}

/// Tries to prove the outputs of the mutated module alone.
pub(super) fn is_proven_alone(
    design: &Emitted,
    observed: &ObservedModules,
    mutation: &Mutation,
    folder: &Path,
) -> Result<bool, DeviceError> {
    let solve = format!("{SOLVE} -timeout {SECONDS}");
    match alone::script(observed, mutation, &solve) {
        Some(script) => is_proven(yosys(folder, design, &script)),
        None => Ok(false),
    }
}

/// Whether the proof that Yosys ran succeeded.
fn is_proven(ended: Result<(), DeviceError>) -> Result<bool, DeviceError> {
    match ended {
        Ok(()) => Ok(true),
        Err(error) if is_not_proven(&error) => Ok(false),
        Err(error) => Err(error),
    }
}

fn solve(options: &str, module: &str) -> String {
    format!("{SOLVE} {options} -timeout {SECONDS} {module}")
}

/// Whether Yosys ended because the proof failed, because the mutation is on a register itself, or because a register has
/// another clock. In the second case the two designs do not share this register, and the solver does not accept the rest.
fn is_not_proven(error: &DeviceError) -> bool {
    let DeviceError::Tool(ToolError::Failed { message, .. }) = error else {
        return false;
    };
    // Yosys 0.23 and Yosys 0.70 print the third and the fourth for a register.
    let reasons = [
        "proof did fail",
        "timeout",
        "to SAT database",
        "No SAT model available for async FF cell",
        "selection is not empty",
    ];
    reasons.iter().any(|reason| message.contains(reason))
}
