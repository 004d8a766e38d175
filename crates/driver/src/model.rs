//! The golden model of a core as a way to it.

use photoncube_model::CoreModel;
use photoncube_spec::{
    Beat, Core, CoreAnswer, CoreInputs, CoreOutputs, CoreRegister, CoreWords, CounterRow, LiteIn,
    StreamIn,
};

use crate::transport::{Transport, TransportError};

/// The golden model of a core, clock by clock.
#[derive(Debug)]
pub struct ModelTransport {
    core: Core,
    model: CoreModel,
}

impl ModelTransport {
    /// Makes the model in its power-up state.
    pub fn new(core: &Core) -> Self {
        // No register is read, so the digest of the Verilog has no part.
        let digest = 0;
        Self {
            core: *core,
            model: CoreModel::new(core, digest),
        }
    }

    /// Writes the registers that words need.
    fn set(&mut self, words: &CoreWords) {
        let rows = CoreRegister::all(&self.core, 0);
        for (register, word) in words.rounds.registers(&self.core) {
            let row = rows.iter().find(|row| row.register == register);
            let lite = LiteIn {
                write_address: row.expect("the map has all registers").address,
                write_address_valid: true,
                write_data: word,
                write_strobe: 0xf,
                write_data_valid: true,
                ..LiteIn::default()
            };
            let answer = LiteIn {
                write_answer_ready: true,
                ..LiteIn::default()
            };
            for lite in [lite, answer] {
                let inputs = CoreInputs {
                    lite,
                    ..CoreInputs::default()
                };
                self.model.clock(&inputs);
            }
        }
    }

    /// One clock with these words offered.
    fn clock(&mut self, photons: Option<&Beat>, queries: Option<&Beat>) -> CoreOutputs {
        let offered = |beat: Option<&Beat>| StreamIn {
            valid: beat.is_some(),
            beat: beat.cloned().unwrap_or_default(),
        };
        let inputs = CoreInputs {
            photons: offered(photons),
            queries: offered(queries),
            result_ready: true,
            ..CoreInputs::default()
        };
        let outputs = self.model.outputs(&inputs);
        self.model.clock(&inputs);
        outputs
    }

    fn counters(&self) -> Vec<u64> {
        let counters = CounterRow::ALL.iter();
        counters
            .map(|row| self.model.counter(row.counter))
            .collect()
    }
}

impl Transport for ModelTransport {
    fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, TransportError> {
        let mut photons = words.photons.iter().peekable();
        let mut queries = words.queries.iter().peekable();
        self.set(words);
        let before = self.counters();
        let mut results = Vec::with_capacity(words.results());
        let mut still = 0;
        let silent_clocks = self.core.silent_clocks();
        while results.len() < words.results() {
            let outputs = self.clock(photons.peek().copied(), queries.peek().copied());
            still += 1;
            if outputs.photon_ready && photons.next().is_some() {
                still = 0;
            }
            if outputs.query_ready && queries.next().is_some() {
                still = 0;
            }
            if let Some(result) = outputs.result {
                results.push(result);
                still = 0;
            }
            if still > silent_clocks {
                return Err(format!(
                    "the model has not moved a word for {} clocks, with {} of {} results",
                    silent_clocks,
                    results.len(),
                    words.results()
                )
                .into());
            }
        }
        // Counters are a clock late.
        self.clock(None, None);
        let counters = self.counters().into_iter().zip(before);
        Ok(CoreAnswer {
            results,
            counters: counters.map(|(after, before)| after - before).collect(),
        })
    }

    fn has_rounds(&self) -> bool {
        self.core.has_radii()
    }
}
