//! Proves that a mutant equals the design: for equal values in all registers and on all input pins, all
//! registers have equal next values and all outputs have equal values.

use photoncube_hdl::Emitted;

use super::Mutation;
use super::design::{FLAT, yosys};
use super::invariants::{Invariants, around_two};
use crate::device::{DeviceError, scratch_folder, write_file};
use crate::tools::ToolError;

/// The time limit of the solver in seconds. A proof that takes longer fails.
const SECONDS: u32 = 60;

/// Proves that mutants equal the design.
pub(super) struct Prover<'a> {
    pub design: &'a Emitted,
    pub invariants: &'a Invariants,
}

impl Prover<'_> {
    /// The proof that no signal can differ, if one is found.
    ///
    /// # Errors
    /// Yosys does not run.
    pub fn proof(&self, mutation: &Mutation) -> Result<Option<String>, DeviceError> {
        let plain = format!("hierarchy -top miter\nopt -full\n{}", solve("", "miter"));
        if self.is_proven(mutation, &plain, &[])? {
            let proof = "the same next values of all registers, from any values, by sat";
            return Ok(Some(proof.to_owned()));
        }
        let options = "-set-assumes";
        let known = format!("{}\n{}", around_two(), solve(options, "wrapper"));
        if self.is_proven(mutation, &known, &[])? {
            let proof = "the same next values of all registers, from any values within the \
                         invariants and the declared count, by sat";
            return Ok(Some(proof.to_owned()));
        }
        let stays = self.invariants.group_stays();
        if !stays.is_empty() && self.is_proven(mutation, &known, &stays)? {
            let proof = "the same next values of all registers, from any values within the invariants and the \
                         declared count, while a group stays valid until it is taken, by sat";
            return Ok(Some(proof.to_owned()));
        }
        Ok(None)
    }

    fn is_proven(
        &self,
        mutation: &Mutation,
        last: &str,
        more: &[String],
    ) -> Result<bool, DeviceError> {
        let (top, options) = (&self.design.top, &mutation.options);
        let script = format!(
            "design -save elaborated\n{FLAT}\nrename {top} gold\ndesign -stash gold\n\
             design -load elaborated\nmutate {options}\n{FLAT}\nrename {top} gate\ndesign -stash gate\n\
             design -copy-from gold -as gold gold\ndesign -copy-from gate -as gate gate\n\
             expose -evert-dff -dff -shared gold gate\n\
             miter -equiv -flatten -make_assert -make_outputs gold gate miter\n{last}"
        );
        let folder = scratch_folder()?;
        let wrapper = self.invariants.around_miter(more);
        write_file(&folder.path().join("wrapper.sv"), &wrapper)?;
        match yosys(folder.path(), self.design, &script) {
            Ok(()) => Ok(true),
            Err(error) if is_not_proven(&error) => Ok(false),
            Err(error) => Err(error),
        }
    }
}

fn solve(options: &str, module: &str) -> String {
    format!("sat -verify -prove-asserts {options} -timeout {SECONDS} {module}")
}

/// Whether Yosys ended because the proof failed, or because the mutation is on a register itself. In the
/// second case the two designs do not share this register, and the solver does not accept the rest.
fn is_not_proven(error: &DeviceError) -> bool {
    let DeviceError::Tool(ToolError::Failed { message, .. }) = error else {
        return false;
    };
    // Yosys 0.23 and Yosys 0.70 print the last two for a register.
    let reasons = [
        "proof did fail",
        "timeout",
        "to SAT database",
        "No SAT model available for async FF cell",
    ];
    reasons.iter().any(|reason| message.contains(reason))
}
