//! Mutants against the stimulus.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use photoncube_hdl::Emitted;
use photoncube_spec::Machine;

use super::{MutantOptions, Mutation};
use crate::compare::Comparer;
use crate::device::{Device, DeviceError, Observed, Verilator};
use crate::stimulus::{Block, Protocol, Source, generate, scrub_rows};
use crate::verify::{VerifyError, wrong_count};

/// A mutated design in Verilator, with one mutation active.
struct Selected {
    device: Verilator,
    mutant: u64,
    /// Input pins without the one that selects.
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

/// The stimulus that mutants are to be killed by.
pub(super) struct Kills<'a> {
    machine: &'a Machine,
    mutated: &'a Emitted,
    options: &'a MutantOptions,
    scrub: Vec<u64>,
    blocks: Vec<Block>,
    /// Vectors compared so far.
    pub vectors: AtomicU64,
}

impl<'a> Kills<'a> {
    /// # Errors
    /// The design with no mutation active is not the golden model.
    pub fn new(
        machine: &'a Machine,
        mutated: &'a Emitted,
        options: &'a MutantOptions,
    ) -> Result<Self, VerifyError> {
        let mut kills = Self {
            machine,
            mutated,
            options,
            scrub: scrub_rows(machine),
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

    /// The first iterations, with what the golden model shows.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
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
        Ok(generate(
            self.machine,
            source,
            seed,
            iterations,
            &mut shortened,
        )?)
    }

    /// A mutant behind the rows with which a chunk begins. What its registers hold before is not compared: Yosys's
    /// `mutate` loses the initial values of those that it touches.
    fn begin(&self, mutant: u64) -> Result<Compared<'a>, VerifyError> {
        let mut device = self.device(mutant)?;
        let mut observed = Observed::default();
        device.replay(&self.scrub, &mut observed)?;
        Ok(Compared {
            comparer: Comparer::new(self.machine, device.visible()),
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

    /// Whether the first iterations kill it.
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

    /// Whether longer stimulus kills it, or resets in each clock of a query, or that of the machine's corners.
    pub fn dies_later(&self, mutation: &Mutation) -> Result<bool, VerifyError> {
        let (seed, iterations) = (self.options.seed + 1, self.options.more_iterations);
        let first = [Source::Protocol(Protocol::Resets), Source::Random];
        let corners = Source::corners(self.machine);
        for source in first.into_iter().chain(corners) {
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

/// A mutant that is being compared.
struct Compared<'a> {
    device: Selected,
    comparer: Comparer<'a>,
    observed: Observed,
}

impl Compared<'_> {
    /// The first difference in the next block.
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
