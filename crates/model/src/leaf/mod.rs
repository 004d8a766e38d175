//! The step-exact model of the leaf machines, by the rules of [`photoncube_spec::LeafRegister`].
//!
//! Each part is a file. A part has a function that computes its registers after the clock edge from those before it, and from
//! those of the parts before it. The comparison of boxes is plain geometry in half steps of the queries, in which
//! the middles of all cells are whole numbers; it has no clamp, no half squares and no stages.

mod boxes;
mod fill;
mod former;
mod memory;
mod observe;
mod player;
mod scan;
mod tags;

use photoncube_spec::{
    Group, Inputs, Leaf, LeafEvents, LeafSizes, Machine, Organisation, Outputs, Pins, Query,
};

use crate::golden::GoldenMachine;
use crate::spatial::SpatialMachine;
use boxes::Boxes;
use fill::Fill;
use former::Former;
use memory::GroupMemory;
use player::Player;
use scan::Scan;
use tags::Tags;

/// A leaf machine with its state. It starts in the power-up state, in which all registers are 0.
#[derive(Clone, Debug)]
pub struct LeafMachine {
    machine: Machine,
    sizes: LeafSizes,
    fill: Fill,
    memory: GroupMemory,
    boxes: Boxes,
    former: Former,
    scan: Scan,
    player: Player,
    tags: Tags,
    chain: SpatialMachine,
}

/// The values of a clock that several parts read, from before its edge.
#[derive(Copy, Clone, Debug)]
struct Events {
    /// The chain takes a token: a query, or a filler.
    token: Option<Token>,
    /// A batch starts.
    starts: bool,
    /// A pair of leaves leaves the queue.
    leaves_queue: bool,
    /// A group is played.
    plays: bool,
    /// The group that is played is the last of its batch.
    ends_batch: bool,
    /// The bank that is freed.
    frees: Option<usize>,
    /// A result is taken from the chain.
    takes_result: bool,
}

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Token {
    Query,
    Filler,
}

impl LeafMachine {
    /// Makes a machine in its power-up state.
    ///
    /// # Panics
    /// Where the machine is not a legal leaf machine, see [`photoncube_spec::Spatial::check`].
    pub fn new(machine: &Machine) -> Self {
        let leaf = *machine.leaf().expect("the machine is a leaf machine");
        let sizes = LeafSizes::of(&leaf);
        Self {
            machine: *machine,
            sizes,
            fill: Fill::default(),
            memory: GroupMemory::new(&leaf),
            boxes: Boxes::new(machine, &leaf),
            former: Former::default(),
            scan: Scan::new(machine, &leaf),
            player: Player::default(),
            tags: Tags::new(&sizes),
            chain: SpatialMachine::new(&chain(machine, &leaf)),
        }
    }

    /// The pins of the chain.
    fn chain_inputs(&self, inputs: &Inputs) -> Inputs {
        let token = self.former.offers(inputs, self.sizes.engines);
        Inputs {
            reset: inputs.reset,
            query_valid: token.is_some(),
            query: match self.former.closed {
                true => Query {
                    position: self.former.bounds.low,
                    ..inputs.query
                },
                false => inputs.query,
            },
            group_valid: self.player.word.valid,
            group: self.memory.word(self.player.word),
            result_ready: self.tags.is_filler() || inputs.result_ready,
            ..Inputs::default()
        }
    }

    fn events(&self, inputs: &Inputs, to_chain: &Inputs, from_chain: Outputs) -> Events {
        let plays = self.player.plays();
        let ends_batch = plays && self.player.entry.is_last_of_batch();
        let entry = self.player.entry;
        Events {
            token: self
                .former
                .offers(inputs, self.sizes.engines)
                .filter(|_| from_chain.query_ready),
            starts: self.scan.starting,
            leaves_queue: self.scan.queued() > 0 && (!entry.valid || (plays && entry.last)),
            plays,
            ends_batch,
            frees: (ends_batch && entry.pair.release).then_some(entry.pair.bank),
            takes_result: from_chain.result_valid && to_chain.result_ready,
        }
    }
}

/// The machine that the chain is on its own.
fn chain(machine: &Machine, leaf: &Leaf) -> Machine {
    Machine {
        organisation: Organisation::Spatial(leaf.chain),
        ..*machine
    }
}

impl GoldenMachine for LeafMachine {
    fn outputs(&self, inputs: &Inputs) -> Outputs {
        let chain = self.chain.outputs(&self.chain_inputs(inputs));
        let result_valid = chain.result_valid && !self.tags.is_filler();
        Outputs {
            query_ready: chain.query_ready && !self.former.closed,
            group_ready: self.fill.ready,
            result_valid,
            result: chain.result,
            result_tag: if result_valid { self.tags.tag() } else { 0 },
            events: LeafEvents {
                compared: self.scan.compared(),
                wanted: self.scan.wanted(),
                played: self.player.word.valid,
            },
        }
    }

    fn observe(&self, inputs: &Inputs, row: &mut Vec<u64>) {
        row.extend(Pins::output_row(&self.machine, &self.outputs(inputs)));
        self.observe_leaf(row);
        self.chain.observe_registers(row);
    }

    fn clock(&mut self, inputs: &Inputs) {
        let to_chain = self.chain_inputs(inputs);
        let from_chain = self.chain.outputs(&to_chain);
        assert!(
            from_chain.group_ready || !to_chain.group_valid,
            "the chain takes every group that is played"
        );
        let events = self.events(inputs, &to_chain, from_chain);
        let played = events.plays.then_some(self.player.address());
        let batch_leaves = self.tags.ends_batch(events, &self.sizes);
        // Each part reads what the parts behind it held before the edge.
        self.player
            .clock(&self.sizes, events, self.scan.oldest(), batch_leaves);
        self.scan
            .clock(&self.sizes, events, &self.former, &self.boxes);
        self.boxes
            .clock(&self.fill, &self.memory.write, events.frees);
        self.memory.clock(self.fill.write, inputs, played);
        self.tags.clock(&self.sizes, events, inputs.batch.tag);
        self.former.clock(&self.sizes, events, inputs);
        self.fill.clock(&self.sizes, inputs, events.frees);
        self.chain.clock(&to_chain);
        if inputs.reset {
            self.reset();
        }
    }

    /// Always true: only a program has clocks that count as waiting.
    fn works(&self, _inputs: &Inputs) -> bool {
        true
    }
}

impl LeafMachine {
    fn reset(&mut self) {
        self.fill.reset();
        self.boxes.reset();
        self.former.reset();
        self.scan.reset();
        self.player.reset();
        self.tags.reset();
    }
}

/// The group of zeros that a memory starts with.
fn no_group() -> Group {
    Group {
        lanes: vec![Default::default(); photoncube_spec::Spatial::LANES],
        ..Group::default()
    }
}
