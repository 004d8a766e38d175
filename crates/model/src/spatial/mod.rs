//! The step-exact model of the spatial machines: all registers of the head and of the engines, in every
//! clock.
//!
//! The rules are those of the module of [`photoncube_spec::HeadSizes`] and of
//! [`photoncube_spec::EngineRegister`]. At each place of the pipeline a value is either registered or passes
//! in the clock in which it is computed, see [`rules::Rules::cut`]. So one description serves every set of
//! pipeline registers.

mod axis;
mod engine;
mod entry;
mod head;
mod lane;
mod link;
mod memory;
mod observe;
mod rules;
mod sums;

use photoncube_spec::{Inputs, Machine, Outputs, Pins, Widths};

use crate::golden::GoldenMachine;
use engine::Engine;
use head::Head;
use memory::PhotonMemory;

pub use memory::{GoldenMemory, HeadStatus};

/// A spatial machine with its state. It starts in the power-up state, in which all registers are 0.
#[derive(Clone, Debug)]
pub struct SpatialMachine {
    machine: Machine,
    memory: Option<PhotonMemory>,
    head: Head,
    engines: Vec<Engine>,
}

impl SpatialMachine {
    /// Makes a machine in its power-up state.
    ///
    /// # Panics
    /// Where the machine is not a legal [`photoncube_spec::Organisation::Spatial`], see
    /// [`photoncube_spec::Spatial::check`].
    pub fn new(machine: &Machine) -> Self {
        let spatial = machine.spatial().expect("the machine is a spatial one");
        if let Err(error) = spatial.check(machine) {
            panic!("{error}");
        }
        Self {
            machine: *machine,
            memory: PhotonMemory::of(machine, spatial),
            head: Head::new(spatial, Widths::of(machine).power),
            engines: (0..spatial.engines())
                .map(|engine| Engine::new(machine, spatial, engine))
                .collect(),
        }
    }

    /// Appends the registers in the order of [`photoncube_spec::Pins`].
    pub(crate) fn observe_registers(&self, row: &mut Vec<u64>) {
        let channels = self.machine.channels().names().len();
        self.head.observe(&self.machine, row);
        if let Some(memory) = &self.memory {
            memory.observe(row);
        }
        if let Some(spatial) = self.machine.spatial() {
            for engine in &self.engines {
                engine.observe(spatial, channels, row);
            }
        }
    }
}

impl GoldenMachine for SpatialMachine {
    fn outputs(&self, inputs: &Inputs) -> Outputs {
        let Some(memory) = &self.memory else {
            return self.head.outputs(inputs);
        };
        Outputs {
            group_ready: memory.group_ready(),
            ..self.head.outputs(&memory.head_inputs(inputs))
        }
    }

    fn observe(&self, inputs: &Inputs, row: &mut Vec<u64>) {
        row.extend(Pins::output_row(&self.machine, &self.outputs(inputs)));
        self.observe_registers(row);
    }

    fn clock(&mut self, inputs: &Inputs) {
        let result = self.engines[0].result();
        let mut hop = match &mut self.memory {
            None => self.head.clock(inputs, result),
            Some(memory) => {
                let words = memory.head_inputs(inputs);
                memory.clock(inputs, self.head.status(&words));
                self.head.clock(&words, result)
            }
        };
        // From the head on: the values that an engine held before the edge pass to the next engine. The next
        // engine is not yet clocked, so its result is that of before the edge.
        for index in 0..self.engines.len() {
            let beyond = self.engines.get(index + 1).map(Engine::result);
            hop = self.engines[index].clock(hop, beyond.unwrap_or_default());
        }
    }

    /// Always true: only a program has clocks that count as waiting.
    fn works(&self, _inputs: &Inputs) -> bool {
        true
    }
}
