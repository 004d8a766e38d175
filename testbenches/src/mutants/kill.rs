//! Compares mutants with the golden model under the stimulus.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use photoncube_hdl::{Emitted, Level};
use photoncube_spec::{Machine, Pins};

use super::{MutantOptions, Mutation};
use crate::compare::Comparer;
use crate::device::{Device, DeviceError, Observed, Verilator};
use crate::levels::{memory_scrub_rows, memory_walk};
use crate::stimulus::{Block, Protocol, Source, generate, scrub_rows};
use crate::verify::{VerifyError, wrong_count};
use crate::waves::{Recorder, Waves};

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
        let mut compared = kills.compared(kills.device(0)?)?;
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
    fn compared<D: Device>(&self, mut device: D) -> Result<Compared<'a, D>, VerifyError> {
        let mut observed = Observed::default();
        device.replay(&self.scrub, &mut observed)?;
        Ok(Compared {
            comparer: Comparer::of_pins(self.machine, self.pins(), device.visible()),
            device,
            observed,
        })
    }

    /// The pins of the part.
    fn pins(&self) -> Pins {
        let mut pins = self.mutated.pins.clone();
        // The last pin selects the mutation.
        pins.inputs.pop();
        pins
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
        self.dies_at_first(&mut self.compared(self.device(mutation.mutant)?)?)
    }

    fn dies_at_first<D: Device>(
        &self,
        compared: &mut Compared<'_, D>,
    ) -> Result<bool, VerifyError> {
        let mut dies = false;
        for block in &self.blocks {
            dies = compared.difference(block)?.is_some();
            if dies {
                break;
            }
        }
        self.count(compared, dies);
        Ok(dies)
    }

    /// Whether later stimulus kills the mutant, see [`Self::later_sources`].
    pub fn dies_later(&self, mutation: &Mutation) -> Result<bool, VerifyError> {
        for source in self.later_sources() {
            let mut compared = self.compared(self.device(mutation.mutant)?)?;
            if self.dies_under(source, &mut compared)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The stimulus of mutants that the first iterations do not kill: resets in each clock of a query, more
    /// iterations, the stimulus of the machine's corners.
    fn later_sources(&self) -> Vec<Source<'static>> {
        let corners = match self.part {
            MutantPart::Machine => Source::corners(self.machine),
            MutantPart::Memory => Vec::new(),
        };
        let resets = match self.part {
            MutantPart::Machine => Some(Source::Protocol(Protocol::Resets)),
            MutantPart::Memory => None,
        };
        let sources = resets.into_iter().chain([Source::Random]);
        sources.chain(corners).collect()
    }

    fn dies_under<D: Device>(
        &self,
        source: Source<'_>,
        compared: &mut Compared<'_, D>,
    ) -> Result<bool, VerifyError> {
        let (seed, iterations) = (self.options.seed + 1, self.options.more_iterations);
        let mut found = Ok(None);
        self.stimulus(source, seed, iterations, &mut |block| {
            found = compared.difference(&block);
            match found {
                Ok(None) => ControlFlow::Continue(()),
                _ => ControlFlow::Break(()),
            }
        })?;
        let dies = found?.is_some();
        self.count(compared, dies);
        Ok(dies)
    }

    /// Records a mutant under the first iterations and, where these do not kill it, under the later stimulus. Returns
    /// whether it died, with the waveform of the last stimulus.
    pub fn record(&self, mutation: &Mutation, clocks: usize) -> Result<(bool, Waves), VerifyError> {
        let recorded = || self.compared(self.recorder(mutation, clocks)?);
        let mut compared = recorded()?;
        let mut dies = self.dies_at_first(&mut compared)?;
        for source in self.later_sources() {
            if dies {
                break;
            }
            compared = recorded()?;
            dies = self.dies_under(source, &mut compared)?;
        }
        Ok((dies, compared.device.into_waves()))
    }

    fn recorder(
        &self,
        mutation: &Mutation,
        clocks: usize,
    ) -> Result<Recorder<Selected>, DeviceError> {
        let device = self.device(mutation.mutant)?;
        let recorder = match self.part {
            MutantPart::Machine => Recorder::new(self.machine, device, clocks),
            MutantPart::Memory => Recorder::of_part(self.machine.name, self.pins(), device, clocks),
        };
        let unknown = self.scrub.len() / self.pins().inputs.len();
        Ok(recorder.unknown_for(unknown as u64))
    }

    fn count<D>(&self, compared: &Compared<'_, D>, dies: bool) {
        let vectors = compared.comparer.vectors + u64::from(dies);
        self.vectors.fetch_add(vectors, Ordering::Relaxed);
    }
}

/// A mutant in a comparison.
struct Compared<'a, D> {
    device: D,
    comparer: Comparer<'a>,
    observed: Observed,
}

impl<D: Device> Compared<'_, D> {
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
