//! The head's delay line: it holds powers until an engine has decided which photons are in range.

use rust_hdl::prelude::*;

use super::stage::{FlagStage, Stage};
use super::wiring::{Wires, Wiring, logic_of_wires, wires, with_wires};
use crate::defaults::defaulted;

/// A word's delay line, one clock for each stage. Without stages it is a wire.
#[derive(LogicBlock)]
pub(crate) struct WordDelay<const W: usize> {
    pub clock: Signal<In, Clock>,
    pub word: Signal<In, Bits<W>>,
    pub delayed: Signal<Out, Bits<W>>,
    /// The stages; stage 0 is nearest to the pins.
    pub stage: Vec<Stage<Bits<W>>>,
    _wires: Wires,
}

impl<const W: usize> WordDelay<W> {
    pub fn new(stages: usize) -> Self {
        with_wires!(defaulted!(Self {
            stage: Stage::several(stages, true),
        };
            clock word delayed _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        let stages = self.stage.len();
        for index in 0..stages {
            wires!(self, wiring: (stage[index].clock) = (clock););
            match index {
                0 => wires!(self, wiring: (stage[0].d) = (word);),
                _ => wires!(self, wiring: (stage[index].d) = (stage[index - 1].q);),
            }
        }
        match stages {
            0 => wires!(self, wiring: (delayed) = (word);),
            _ => wires!(self, wiring: (delayed) = (stage[stages - 1].q);),
        }
    }
}

logic_of_wires!(WordDelay<W>);

/// A flag's delay line. A reset clears it.
#[derive(LogicBlock)]
pub(crate) struct FlagDelay {
    pub clock: Signal<In, Clock>,
    pub clear: Signal<In, Bit>,
    pub flag: Signal<In, Bit>,
    pub delayed: Signal<Out, Bit>,
    pub stage: Vec<FlagStage>,
    _wires: Wires,
}

impl FlagDelay {
    pub fn new(stages: usize) -> Self {
        assert!(stages > 0, "a decision takes a clock at least");
        with_wires!(defaulted!(Self {
            stage: (0..stages).map(|_| FlagStage::new(true)).collect(),
        };
            clock clear flag delayed _wires
        ))
    }

    fn wires(&mut self, wiring: &mut Wiring) {
        let stages = self.stage.len();
        wires!(self, wiring: (stage[0].d) = (flag););
        for index in 1..stages {
            wires!(self, wiring: (stage[index].d) = (stage[index - 1].q););
        }
        for index in 0..stages {
            wires!(self, wiring:
                (stage[index].clock) = (clock);
                (stage[index].clear) = (clear);
            );
        }
        wires!(self, wiring: (delayed) = (stage[stages - 1].q););
    }
}

logic_of_wires!(FlagDelay);
