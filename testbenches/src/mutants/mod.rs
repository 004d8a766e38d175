//! Mutants: an emitted design with one thing wrong, to see whether the stimulus notices.
//!
//! Yosys draws the mutations and puts all of them into one text, each behind a value of a new pin `mutant`, so that
//! one build runs them all. What the stimulus does not kill is either proven equal to the design or survives.

mod design;
mod invariants;
mod kill;
mod prove;

use std::collections::BTreeMap;

use photoncube_hdl::{Level, emit};
use photoncube_spec::Machine;
use serde::Serialize;

use crate::device::{DeviceKind, hdl_error};
use crate::tools::Tool;
use crate::verify::VerifyError;

pub use design::Mutation;
use invariants::Invariants;
use kill::Kills;
use prove::Prover;

/// How many mutants there are, and how they are drawn.
#[derive(Copy, Clone, Debug)]
pub struct MutantOptions {
    /// About so many mutations.
    pub mutants: u64,
    /// The seed of Yosys's choice and of the stimulus.
    pub seed: u64,
    /// Iterations of random stimulus for a mutant before it is looked at more closely.
    pub iterations: u64,
    /// Iterations for a mutant that these do not kill, and that is not proven equal.
    pub more_iterations: u64,
}

/// What became of a mutant.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// Some signal differed from the golden model.
    Killed,
    /// It is proven that no signal can differ.
    Equivalent,
    /// Neither.
    Survived,
}

/// A mutant and its fate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Judged {
    /// What is wrong with it.
    #[serde(flatten)]
    pub mutation: Mutation,
    /// What became of it.
    pub fate: Fate,
    /// The proof, or that there is none; nothing for what was killed.
    pub reason: Option<String>,
}

/// What became of a machine's mutants.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MutantReport {
    /// The machine.
    pub machine: &'static str,
    /// The tools behind it, with their versions.
    pub tool_version: String,
    /// The seed.
    pub seed: u64,
    /// Vectors that were compared until each was killed or the stimulus ended, all together.
    pub vectors_compared: u64,
    /// The mutants, in Yosys's order.
    pub mutants: Vec<Judged>,
}

impl MutantReport {
    /// How many of each fate there are, by module and together.
    pub fn counts(&self) -> BTreeMap<&str, [usize; 3]> {
        let mut counts: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
        for judged in &self.mutants {
            counts.entry(&judged.mutation.module).or_default()[judged.fate as usize] += 1;
        }
        counts
    }

    /// How many of a fate there are.
    pub fn count(&self, fate: Fate) -> usize {
        let same = |judged: &&Judged| judged.fate == fate;
        self.mutants.iter().filter(same).count()
    }
}

/// Draws mutants of a machine and judges each; `progress` is told how many are judged.
///
/// # Errors
/// A tool is missing or fails, or the design without any mutation differs from the golden model.
pub fn mutants(
    machine: &Machine,
    options: &MutantOptions,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<MutantReport, VerifyError> {
    let missing = [DeviceKind::Verilator, DeviceKind::Netlist]
        .into_iter()
        .find_map(DeviceKind::missing_tool);
    if let Some(missing) = missing {
        return Err(crate::DeviceError::from(missing).into());
    }
    let design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
    let mutations = design::draw(machine, &design, options.mutants, options.seed)?;
    let mutated = design::with_all(&design, &mutations)?;
    let mut kills = Kills::new(machine, &mutated, options)?;
    let alive = kills.alive(&mutations, progress)?;
    let invariants = Invariants::new(&design, kills.blocks())?;
    let prover = Prover {
        design: &design,
        invariants: &invariants,
    };
    let mut judged = Vec::new();
    for (mutation, alive) in mutations.iter().zip(alive) {
        let (fate, reason) = match alive {
            false => (Fate::Killed, None),
            true => match prover.proof(mutation)? {
                Some(proof) => (Fate::Equivalent, Some(proof)),
                None if kills.dies_later(mutation)? => (Fate::Killed, None),
                None => (Fate::Survived, Some("no proof was found".to_owned())),
            },
        };
        judged.push(Judged {
            mutation: mutation.clone(),
            fate,
            reason,
        });
    }
    Ok(MutantReport {
        machine: machine.name,
        tool_version: format!(
            "{}; {}",
            Tool::Yosys.version().map_err(crate::DeviceError::from)?,
            Tool::Verilator
                .version()
                .map_err(crate::DeviceError::from)?
        ),
        seed: options.seed,
        vectors_compared: kills.vectors,
        mutants: judged,
    })
}
