//! Compares mutants with the golden model under the stimulus.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use photoncube_hdl::{Emitted, Level};
use photoncube_spec::Machine;

use super::{MutantOptions, Mutation};
use crate::compare::Comparer;
use crate::device::{Device, DeviceError, Observed, Verilator};
use crate::levels::{memory_scrub_rows, memory_walk};
use crate::stimulus::{Block, Protocol, Source, generate, scrub_rows};
use crate::verify::{VerifyError, wrong_count};

/// The mutated design in Verilator, with one active mutation.
struct Selected {
    device: Verilator,
    mutant: u64,
    /// The number of input pins without the one that selects the mutation.
    columns: usize,
}

impl Device for Selected {
    fn name(&self) -> &str {
        "mutant"
    }

    fn tool_version(&self) -> &str {
        self.device.tool_version()
    }

    fn visible(&self) -> usize {
        self.device.visible()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        let rows = inputs.chunks_exact(self.columns);
        let selected = |row: &[u64]| [row, &[self.mutant]].concat();
        let inputs: Vec<_> = rows.flat_map(selected).collect();
        self.device.replay(&inputs, observed)
    }
}

/// The iterations that show the possible values of registers, as a multiple of the first iterations.
const MORE_ROUNDS: u64 = 10;

/// The part of a machine that is mutated.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum MutantPart {
    /// The whole machine.
    Machine,
    /// The photon memory on its own. Its stimulus is counted in clocks and not in iterations.
    Memory,
}

impl MutantPart {
    /// The parts of a machine that are mutated on their own; the first is the whole machine.
    pub fn of(machine: &Machine) -> Vec<Self> {
        let memory = machine.has_memory().then_some(Self::Memory);
        [Self::Machine].into_iter().chain(memory).collect()
    }

    /// The name of the part.
    pub fn name(self) -> &'static str {
        self.level().name()
    }

    /// The level at which the part is emitted.
    pub(super) fn level(self) -> Level {
        match self {
            Self::Machine => Level::Machine,
            Self::Memory => Level::Memory,
        }
    }
}

/// The stimulus that is to kill mutants.
pub(super) struct Kills<'a> {
    machine: &'a Machine,
    part: MutantPart,
    mutated: &'a Emitted,
    options: &'a MutantOptions,
    scrub: Vec<u64>,
    blocks: Vec<Block>,
    /// The number of vectors compared so far.
    pub vectors: AtomicU64,
}

impl<'a> Kills<'a> {
    /// # Errors
    /// The design without an active mutation differs from the golden model.
    pub fn new(
        machine: &'a Machine,
        part: MutantPart,
        mutated: &'a Emitted,
        options: &'a MutantOptions,
    ) -> Result<Self, VerifyError> {
        let mut kills = Self {
            machine,
            part,
            mutated,
            options,
            scrub: match part {
                MutantPart::Machine => scrub_rows(machine),
                MutantPart::Memory => memory_scrub_rows(machine)?,
            },
            blocks: Vec::new(),
            vectors: AtomicU64::new(0),
        };
        let mut blocks = Vec::new();
        let (seed, iterations) = (options.seed, options.iterations);
        kills.stimulus(Source::Random, seed, iterations, &mut |block| {
            blocks.push(block);
            ControlFlow::Continue(())
        })?;
        kills.blocks = blocks;
        let mut compared = kills.begin(0)?;
        for block in &kills.blocks {
            if let Some(difference) = compared.difference(block)? {
                return Err(difference);
            }
        }
        Ok(kills)
    }

    /// The first iterations, with the golden model's signals.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Passes further rows of the golden model's signals to `row`: of more iterations, and of stimulus that
    /// is hard on the protocol.
    pub fn more_rows(&self, row: &mut dyn FnMut(&[u64])) -> Result<(), VerifyError> {
        let columns = self.mutated.pins.observed.len();
        let mut sink = |block: Block| {
            block.expected.chunks_exact(columns).for_each(&mut *row);
            ControlFlow::Continue(())
        };
        let protocols = [Protocol::Stalls, Protocol::Patterns, Protocol::Resets];
        let bank = self.machine.has_memory().then_some(Source::FullBank);
        let sources = protocols.map(Source::Protocol).into_iter().chain(bank);
        let sources = match self.part {
            MutantPart::Machine => [Source::Random].into_iter().chain(sources).collect(),
            MutantPart::Memory => vec![Source::Random],
        };
        let iterations = MORE_ROUNDS * self.options.iterations;
        for source in sources {
            self.stimulus(source, self.options.seed + 2, iterations, &mut sink)?;
        }
        Ok(())
    }

    /// Blocks of stimulus, without the rows with which a chunk begins.
    fn stimulus(
        &self,
        source: Source<'_>,
        seed: u64,
        iterations: u64,
        sink: &mut dyn FnMut(Block) -> ControlFlow<()>,
    ) -> Result<(), VerifyError> {
        let signals = self.mutated.pins.observed.len();
        let scrub_clocks = self.scrub.len() / (self.mutated.pins.inputs.len() - 1);
        let mut shortened = |mut block: Block| {
            if block.chunk == 0 && block.first_clock == 0 {
                block.inputs.drain(..self.scrub.len());
                block.expected.drain(..scrub_clocks * signals);
                block.clocks -= scrub_clocks;
            }
            sink(block)
        };
        match self.part {
            MutantPart::Machine => {
                generate(self.machine, source, seed, iterations, &mut shortened)?
            }
            MutantPart::Memory => memory_walk(self.machine, seed, iterations, &mut shortened)?,
        }
        Ok(())
    }

    /// A mutant after the rows with which a chunk begins. Its registers are not compared before that, because
    /// Yosys's `mutate` loses the initial values of the registers that it changes.
    fn begin(&self, mutant: u64) -> Result<Compared<'a>, VerifyError> {
        let mut device = self.device(mutant)?;
        let mut observed = Observed::default();
        device.replay(&self.scrub, &mut observed)?;
        let mut pins = self.mutated.pins.clone();
        // The last pin selects the mutation.
        pins.inputs.pop();
        Ok(Compared {
            comparer: Comparer::of_pins(self.machine, pins, device.visible()),
            device,
            observed,
        })
    }

    fn device(&self, mutant: u64) -> Result<Selected, DeviceError> {
        Ok(Selected {
            device: Verilator::new(self.mutated)?,
            mutant,
            columns: self.mutated.pins.inputs.len() - 1,
        })
    }

    /// Whether the first iterations kill the mutant.
    pub fn dies(&self, mutation: &Mutation) -> Result<bool, VerifyError> {
        let mut compared = self.begin(mutation.mutant)?;
        let mut dies = false;
        for block in &self.blocks {
            dies = compared.difference(block)?.is_some();
            if dies {
                break;
            }
        }
        self.count(&compared, dies);
        Ok(dies)
    }

    /// Whether one of these kills the mutant: longer stimulus, resets in each clock of a query, the stimulus
    /// of the machine's corners.
    pub fn dies_later(&self, mutation: &Mutation) -> Result<bool, VerifyError> {
        let (seed, iterations) = (self.options.seed + 1, self.options.more_iterations);
        let corners = match self.part {
            MutantPart::Machine => Source::corners(self.machine),
            MutantPart::Memory => Vec::new(),
        };
        let resets = match self.part {
            MutantPart::Machine => Some(Source::Protocol(Protocol::Resets)),
            MutantPart::Memory => None,
        };
        let sources = resets.into_iter().chain([Source::Random]).chain(corners);
        for source in sources {
            let mut compared = self.begin(mutation.mutant)?;
            let mut found = Ok(None);
            self.stimulus(source, seed, iterations, &mut |block| {
                found = compared.difference(&block);
                match found {
                    Ok(None) => ControlFlow::Continue(()),
                    _ => ControlFlow::Break(()),
                }
            })?;
            let dies = found?.is_some();
            self.count(&compared, dies);
            if dies {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn count(&self, compared: &Compared<'_>, dies: bool) {
        let vectors = compared.comparer.vectors + u64::from(dies);
        self.vectors.fetch_add(vectors, Ordering::Relaxed);
    }
}

/// A mutant in a comparison.
struct Compared<'a> {
    device: Selected,
    comparer: Comparer<'a>,
    observed: Observed,
}

impl Compared<'_> {
    /// The first difference in the next block; `None` if there is none.
    fn difference(&mut self, block: &Block) -> Result<Option<VerifyError>, VerifyError> {
        self.observed.clear();
        self.device.replay(&block.inputs, &mut self.observed)?;
        if !self.comparer.is_complete(block, &self.observed) {
            return Err(wrong_count(&self.device, block.clocks, &self.observed).into());
        }
        let name = self.device.name();
        let compared = self
            .comparer
            .compare(block, &self.observed, name, String::new);
        Ok(compared.err().map(VerifyError::Diverged))
    }
}
