//! Mutants: emitted designs with one mutation each, which test whether the stimulus detects it.
//!
//! Yosys draws the mutations and puts all of them into one text, each enabled by a value of a new pin
//! `mutant`, so that one build runs them all. Each mutant that the stimulus does not kill must be proven
//! equal to the design; otherwise it survives.

mod alone;
mod design;
mod invariants;
mod kill;
mod prove;

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};

use photoncube_hdl::{Emitted, emit};
use photoncube_spec::Machine;
use rayon::prelude::*;
use serde::Serialize;

use crate::controls::Control;
use crate::device::{DeviceKind, hdl_error, scratch_folder};
use crate::tools::Tool;
use crate::verify::VerifyError;
use crate::waves::Waves;

use alone::ObservedModules;
pub use design::Mutation;
use invariants::Invariants;
use kill::Kills;
pub use kill::MutantPart;
use prove::{Prover, is_proven_alone};

/// The number of mutants, and how they are drawn.
#[derive(Copy, Clone, Debug)]
pub struct MutantOptions {
    /// The part that is mutated.
    pub part: MutantPart,
    /// The approximate number of mutations.
    pub mutants: u64,
    /// The seed of Yosys's choice and of the stimulus.
    pub seed: u64,
    /// The iterations of random stimulus for each mutant before proofs and longer stimulus.
    pub iterations: u64,
    /// The iterations for a mutant that the first stimulus does not kill and that is not proven equal.
    pub more_iterations: u64,
}

/// The fate of a mutant.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// Some signal differed from the golden model.
    Killed,
    /// It is proven that no signal can differ.
    Equivalent,
    /// The mutant is neither killed nor proven equivalent.
    Survived,
}

/// A mutant with its fate.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Judged {
    /// The mutation of the mutant.
    #[serde(flatten)]
    pub mutation: Mutation,
    /// The fate of the mutant.
    pub fate: Fate,
    /// The proof, or a note that there is none; `None` for a killed mutant.
    pub reason: Option<String>,
}

/// The results for the mutants of a machine.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MutantReport {
    /// The name of the machine.
    pub machine: &'static str,
    /// The name of the part that was mutated.
    pub part: &'static str,
    /// The tools, with their versions.
    pub tool_version: String,
    /// The seed of the mutations and of the stimulus.
    pub seed: u64,
    /// The number of vectors compared, over all mutants, until each was killed or the stimulus ended.
    pub vectors_compared: u64,
    /// The controls: killed mutants, of which the proofs must prove none equal.
    #[serde(skip)]
    pub controls: Vec<Control>,
    /// The mutants, in the order in which Yosys drew them.
    pub mutants: Vec<Judged>,
}

impl MutantReport {
    /// The number of mutants of each fate, by module and in total.
    pub fn counts(&self) -> BTreeMap<&str, [usize; 3]> {
        let mut counts: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
        for judged in &self.mutants {
            counts.entry(&judged.mutation.module).or_default()[judged.fate as usize] += 1;
        }
        counts
    }

    /// The number of mutants of a fate.
    pub fn count(&self, fate: Fate) -> usize {
        let same = |judged: &&Judged| judged.fate == fate;
        self.mutants.iter().filter(same).count()
    }
}

/// Draws mutants of a machine and judges each. Calls `progress` with the number of mutants judged.
///
/// # Errors
/// A tool is missing or fails, or the design without any mutation differs from the golden model.
pub fn mutants(
    machine: &Machine,
    options: &MutantOptions,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<MutantReport, VerifyError> {
    let Drawn {
        design,
        mutations,
        mutated,
    } = Drawn::new(machine, options)?;
    let kills = Kills::new(machine, options.part, &mutated, options)?;
    let judged = AtomicU64::new(0);
    let count = || progress(judged.fetch_add(1, Ordering::Relaxed) + 1);
    let dies = |mutation| {
        let dies = kills.dies(mutation)?;
        if dies {
            count();
        }
        Ok(dies)
    };
    let dead: Vec<bool> = mutations
        .par_iter()
        .map(dies)
        .collect::<Result<_, VerifyError>>()?;
    let invariants = Invariants::new(machine, &design, &kills)?;
    let observed = ObservedModules::of(&design)?;
    let prover = Prover {
        design: &design,
        invariants: &invariants,
        observed: &observed,
    };
    let controls = killed_controls(&mutations, &dead, &prover)?;
    let judge = |(mutation, dead): (&Mutation, &bool)| {
        let (fate, reason) = match dead {
            true => (Fate::Killed, None),
            false => {
                let judged = judge_closely(mutation, &prover, &kills)?;
                count();
                judged
            }
        };
        Ok(Judged {
            mutation: mutation.clone(),
            fate,
            reason,
        })
    };
    let judged = mutations.par_iter().zip(&dead).map(judge);
    let judged = judged.collect::<Result<_, VerifyError>>()?;
    Ok(MutantReport {
        machine: machine.name,
        part: options.part.name(),
        tool_version: format!(
            "{}; {}",
            Tool::Yosys.version().map_err(crate::DeviceError::from)?,
            Tool::Verilator
                .version()
                .map_err(crate::DeviceError::from)?
        ),
        seed: options.seed,
        vectors_compared: kills.vectors.into_inner(),
        controls,
        mutants: judged,
    })
}

/// A mutant under the stimulus, and its waveform.
#[derive(Debug)]
pub struct RecordedMutant {
    /// The mutation.
    pub mutation: Mutation,
    /// Whether some signal differed from the golden model.
    pub killed: bool,
    /// The number of clocks compared.
    pub vectors_compared: u64,
    /// The waveform. If the stimulus does not kill the mutant, it is of the end of the last stimulus.
    pub waves: Waves,
}

/// Records one of the mutants that [`mutants`] draws with these options, under the stimulus that it has there. Keeps
/// at most `clocks` clocks. `None` where no mutant has that number.
///
/// # Errors
/// A tool is missing or fails, or the design without any mutation differs from the golden model.
pub fn record_mutant(
    machine: &Machine,
    options: &MutantOptions,
    mutant: u64,
    clocks: usize,
) -> Result<Option<RecordedMutant>, VerifyError> {
    let drawn = Drawn::new(machine, options)?;
    let mut mutations = drawn.mutations.iter();
    let Some(mutation) = mutations.find(|mutation| mutation.mutant == mutant) else {
        return Ok(None);
    };
    let kills = Kills::new(machine, options.part, &drawn.mutated, options)?;
    let (killed, waves) = kills.record(mutation, clocks)?;
    Ok(Some(RecordedMutant {
        mutation: mutation.clone(),
        killed,
        vectors_compared: kills.vectors.into_inner(),
        waves,
    }))
}

/// Whether the mutation that these options of Yosys's `mutate` describe is proven to leave the outputs of its module as they are in all
/// clocks, on the module alone. `{prefix}` in the options stands for what the names of the machine's modules begin with. A
/// module that holds an observed register is not proven in this way.
///
/// # Errors
/// The machine cannot be emitted, or Yosys does not run.
pub fn is_equal_alone(machine: &Machine, options: &str) -> Result<bool, VerifyError> {
    let design = emit(machine, MutantPart::Machine.level()).map_err(hdl_error(machine))?;
    let mutation = Mutation {
        mutant: 1,
        module: String::new(),
        options: options.replace("{prefix}", &design.top),
    };
    let observed = ObservedModules::of(&design)?;
    let folder = scratch_folder()?;
    Ok(is_proven_alone(
        &design,
        &observed,
        &mutation,
        folder.path(),
    )?)
}

/// The mutations of a design.
struct Drawn {
    design: Emitted,
    mutations: Vec<Mutation>,
    /// The design with all mutations.
    mutated: Emitted,
}

impl Drawn {
    fn new(machine: &Machine, options: &MutantOptions) -> Result<Self, VerifyError> {
        let missing = [DeviceKind::Verilator, DeviceKind::Netlist]
            .into_iter()
            .find_map(DeviceKind::missing_tool);
        if let Some(missing) = missing {
            return Err(crate::DeviceError::from(missing).into());
        }
        let level = options.part.level();
        let design = emit(machine, level).map_err(hdl_error(machine))?;
        let mutations = design::draw(&design, options.mutants, options.seed)?;
        let mutated = design::with_all(&design, &mutations)?;
        Ok(Self {
            design,
            mutations,
            mutated,
        })
    }
}

/// The number of killed mutants on which the proofs are tried.
const CONTROLS: usize = 8;

/// Tries the proofs on killed mutants. A proof that one of them is equal is wrong.
fn killed_controls(
    mutations: &[Mutation],
    dead: &[bool],
    prover: &Prover<'_>,
) -> Result<Vec<Control>, VerifyError> {
    let all = mutations.iter().zip(dead);
    let killed: Vec<_> = all.filter(|(_, dead)| **dead).collect();
    let step = killed.len().div_ceil(CONTROLS).max(1);
    let control = |&(mutation, _): &(&Mutation, _)| {
        Ok(Control {
            planted: format!("a killed mutant, to be proven equal: {}", mutation.options),
            found: prover.proof(mutation)?.is_none(),
        })
    };
    let chosen: Vec<_> = killed.into_iter().step_by(step).collect();
    chosen.par_iter().map(control).collect()
}

/// Judges a mutant that the first iterations did not kill.
fn judge_closely(
    mutation: &Mutation,
    prover: &Prover<'_>,
    kills: &Kills<'_>,
) -> Result<(Fate, Option<String>), VerifyError> {
    if let Some(proof) = prover.proof(mutation)? {
        return Ok((Fate::Equivalent, Some(proof)));
    }
    if kills.dies_later(mutation)? {
        return Ok((Fate::Killed, None));
    }
    Ok((Fate::Survived, Some("no proof was found".to_owned())))
}
