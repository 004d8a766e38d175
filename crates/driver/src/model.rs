//! The golden model as a machine.

use photoncube_model::{GoldenMachine, LeafMachine};
use photoncube_spec::{
    Group, Inputs, Lane, Leaf, LeafAnswer, LeafWords, Machine, Query, Spatial, TaggedSums,
};

use crate::transport::{Transport, TransportError};

/// The golden model of a leaf machine, clock by clock.
#[derive(Debug)]
pub struct ModelTransport {
    model: LeafMachine,
    idle: Inputs,
}

impl ModelTransport {
    /// Makes the model in its power-up state.
    ///
    /// # Panics
    /// For a machine that is not a leaf machine.
    pub fn new(machine: &Machine) -> Self {
        Self {
            model: LeafMachine::new(machine),
            idle: Inputs {
                query: Query {
                    radius_sq: machine.fixed_radius_sq().unwrap_or(0),
                    ..Query::default()
                },
                group: Group {
                    lanes: vec![Lane::default(); Spatial::LANES],
                    ..Group::default()
                },
                result_ready: true,
                ..Inputs::default()
            },
        }
    }
}

impl Transport for ModelTransport {
    fn exchange(&mut self, words: &LeafWords) -> Result<LeafAnswer, TransportError> {
        let mut queries = words.queries.iter().peekable();
        let mut groups = words.groups.iter().peekable();
        let mut answer = LeafAnswer::default();
        let mut still = 0;
        let played = self.model.groups_played();
        while answer.results.len() < words.queries.len() {
            let mut inputs = self.idle.clone();
            if let Some(word) = queries.peek() {
                inputs.query_valid = true;
                inputs.query = word.query;
                inputs.query_release = word.release;
                inputs.batch = word.batch;
            }
            if let Some(group) = groups.peek() {
                inputs.group_valid = true;
                inputs.group.clone_from(group);
            }
            let outputs = self.model.outputs(&inputs);
            self.model.clock(&inputs);
            answer.clocks += 1;
            still += 1;
            if inputs.query_valid && outputs.query_ready {
                queries.next();
                still = 0;
            }
            if inputs.group_valid && outputs.group_ready {
                groups.next();
                still = 0;
            }
            if outputs.result_valid {
                answer.results.push(TaggedSums {
                    sums: outputs.result,
                    tag: outputs.result_tag,
                });
                still = 0;
            }
            if still > Leaf::SILENT_CLOCKS {
                return Err(format!(
                    "the model has not moved a word for {} clocks, with {} of {} results",
                    Leaf::SILENT_CLOCKS,
                    answer.results.len(),
                    words.queries.len()
                )
                .into());
            }
        }
        answer.groups_played = self.model.groups_played() - played;
        Ok(answer)
    }
}
