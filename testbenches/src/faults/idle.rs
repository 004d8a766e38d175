//! Drives unknown words on pins that the machine must ignore: those of a stream while it is not valid, and
//! those of a lane without a photon.
//!
//! By the spec some registers store such a word and may then be unknown too. The golden model finds these
//! registers for each clock: it runs several times, with different words on the idle pins. A value that is
//! equal in all runs does not depend on the words, so the device must show it, without unknown bits. One kind
//! of value is excepted: a comparison with an unknown operand is unknown in Verilog, even `0 <= x`. Unknown
//! values alone are not sufficient, because Verilog's `if` takes the else branch on an unknown condition,
//! which may hide a read of an idle word. So the words are also driven as all zeros and as all ones.

use std::ops::ControlFlow;

use photoncube_hdl::Emitted;
use photoncube_model::golden_machine;
use photoncube_spec::{Machine, PhotonFormat, Pins, Query};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::difference::difference;
use super::{FaultClass, FaultVerdict};
use crate::compare::Actual;
use crate::device::{Device, Icarus, Observed};
use crate::stimulus::{Block, Source, generate};
use crate::verify::{VerifyError, nothing_compared, wrong_count};

/// The number of runs with random words on idle pins. A flag that depends on them is equal in all runs with a
/// probability of 1 in 2^16.
const RANDOM_FILLS: usize = 16;

/// For each input column, the columns that must all be 1 for its word to matter. A photon memory stores the
/// words of absent photons for later queries, so a fill cannot be aimed at a query; in machines with a memory
/// these words are not filled.
pub(crate) fn governing(machine: &Machine, pins: &Pins) -> Vec<Vec<usize>> {
    let named = |wanted: String| pins.inputs.iter().position(|pin| pin.name == wanted);
    let column = |name: &str| -> Option<Vec<usize>> {
        let stream = match name {
            "query_valid" | "group_valid" => return None,
            _ if name.starts_with("query_") => "query_valid",
            _ if name.starts_with("group_") || name.starts_with("photon_") => "group_valid",
            _ => return None,
        };
        let lane = name
            .strip_prefix("photon_")
            .filter(|n| !n.starts_with("present"));
        let lane = lane.and_then(|name| name.rsplit_once('_'));
        let lane = lane.filter(|_| !machine.keeps_sets());
        let present = lane.and_then(|(_, lane)| named(format!("photon_present_{lane}")));
        Some(
            named(stream.to_owned())
                .into_iter()
                .chain(present)
                .collect(),
        )
    };
    let columns = pins.inputs.iter().map(|pin| column(&pin.name));
    columns.map(Option::unwrap_or_default).collect()
}

/// Whether the word in a column is ignored.
pub(crate) fn is_idle(governing: &[usize], row: &[u64]) -> bool {
    governing.iter().any(|&column| row[column] == 0)
}

/// The words that are driven on idle pins.
#[derive(Copy, Clone)]
enum Fill {
    Zeros,
    Ones,
    /// A photon at the position of the query in that engine, so that it is in range.
    At(usize),
    Random,
}

/// Verifies a text with unknown words on idle pins.
pub(super) fn verify_idle(
    machine: &Machine,
    design: &Emitted,
    seed: u64,
) -> Result<FaultVerdict, VerifyError> {
    let pins = Pins::of(machine);
    let governing = governing(machine, &pins);
    let block = all_rows(machine, FaultClass::IdleUnknown, seed)?;
    let mut device = Icarus::with_idle_unknown(design, governing.clone())?;
    let rows = Rows {
        machine,
        pins: &pins,
        block: &block,
        seed,
    };
    let mut depends = rows.depends(&governing);
    let pessimistic = excuse_comparisons(machine, &pins, &mut depends);
    rows.compare(&mut device, &block.inputs, &depends)?;
    for fill in [Fill::Zeros, Fill::Ones] {
        let inputs = rows.filled(&governing, fill, 0);
        rows.compare(&mut Icarus::new(design)?, &inputs, &depends)?;
    }
    let injections = unknown_words(&pins, &governing, &block.inputs);
    let compared = depends.iter().filter(|&&depends| !depends).count();
    if injections == 0 || compared == 0 || block.results == 0 {
        return Err(nothing_compared(device.name(), 0, block.results, 0));
    }
    Ok(FaultVerdict {
        machine: machine.name,
        fault: FaultClass::IdleUnknown.name(),
        device: device.name().to_owned(),
        tool_version: device.tool_version().to_owned(),
        injections,
        injected: format!(
            "unknown words; {compared} values do not depend on them and were known, {} do, {pessimistic} compare one that does",
            depends.len() - compared - pessimistic
        ),
        results_compared: block.results,
        // Three replays: with unknown words, zeros and ones.
        vectors_compared: 3 * block.clocks as u64,
        signals_per_vector: pins.observed.len(),
        known_after_reset: Vec::new(),
    })
}

/// The stimulus of a fault class, in one block.
pub(super) fn all_rows(
    machine: &Machine,
    class: FaultClass,
    seed: u64,
) -> Result<Block, VerifyError> {
    let mut all = Block {
        seed,
        ..Block::default()
    };
    let source = Source::Protocol(class.protocol());
    generate(machine, source, seed, u64::MAX, &mut |block| {
        all.inputs.extend(block.inputs);
        all.expected.extend(block.expected);
        all.clocks += block.clocks;
        all.iterations += block.iterations;
        all.results += block.results;
        ControlFlow::Continue(())
    })?;
    Ok(all)
}

fn unknown_words(pins: &Pins, governing: &[Vec<usize>], inputs: &[u64]) -> u64 {
    let idle = |row: &[u64]| governing.iter().filter(|g| is_idle(g, row)).count() as u64;
    inputs.chunks_exact(pins.inputs.len()).map(idle).sum()
}

/// The stimulus, with the golden model's signals.
struct Rows<'a> {
    machine: &'a Machine,
    pins: &'a Pins,
    block: &'a Block,
    seed: u64,
}

impl Rows<'_> {
    /// Replays rows into a device. Values that do not depend on idle words must be those of the golden model.
    fn compare(
        &self,
        device: &mut dyn Device,
        inputs: &[u64],
        depends: &[bool],
    ) -> Result<(), VerifyError> {
        let (pins, block) = (self.pins, self.block);
        let mut observed = Observed::default();
        device.replay(inputs, &mut observed)?;
        if observed.values.len() != block.expected.len() {
            return Err(wrong_count(device, block.clocks, &observed).into());
        }
        let differs = |index: &usize| {
            let expected = Actual::Known(block.expected[*index]);
            !depends[*index] && observed.at(*index) != expected
        };
        // Looking up an unknown value takes long, so only the rows with unknown values are considered.
        let suspects = observed.unknown.iter().map(|unknown| unknown.index);
        let unequal = (0..depends.len()).filter(|&i| observed.values[i] != block.expected[i]);
        match suspects.chain(unequal).filter(differs).min() {
            None => Ok(()),
            Some(index) => {
                let rows = (pins, block, &observed);
                Err(difference(self.machine, rows, device, index))
            }
        }
    }

    /// For each value of each row, whether it depends on idle words.
    fn depends(&self, governing: &[Vec<usize>]) -> Vec<bool> {
        let fixed = [Fill::Zeros, Fill::Ones].into_iter();
        let fills = fixed
            .chain((0..self.machine.queries_at_once()).map(Fill::At))
            .chain([Fill::Random; RANDOM_FILLS]);
        let visible = self.pins.observed.len();
        let mut depends = vec![false; self.block.expected.len()];
        let mut shown = Vec::new();
        for (index, fill) in fills.enumerate() {
            let mut model = golden_machine(self.machine);
            let filled = self.filled(governing, fill, index as u64);
            let expected = self.block.expected.chunks_exact(visible);
            let rows = filled.chunks_exact(self.pins.inputs.len()).zip(expected);
            for ((row, expected), marks) in rows.zip(depends.chunks_exact_mut(visible)) {
                let inputs = Pins::inputs_of(self.machine, row);
                shown.clear();
                model.observe(&inputs, &mut shown);
                model.clock(&inputs);
                for ((mark, shown), expected) in marks.iter_mut().zip(&shown).zip(expected) {
                    *mark |= shown != expected;
                }
            }
        }
        depends
    }

    /// The rows of inputs with other words on idle pins.
    fn filled(&self, governing: &[Vec<usize>], fill: Fill, index: u64) -> Vec<u64> {
        let mut rng = Pcg64::seed_from_u64(self.seed ^ index);
        let mut queries = Queries::default();
        let mut filled = Vec::with_capacity(self.block.inputs.len());
        let rows = self.block.inputs.chunks_exact(self.pins.inputs.len());
        let expected = self.block.expected.chunks_exact(self.pins.observed.len());
        for (row, expected) in rows.zip(expected) {
            queries.clock(self.machine, row, expected);
            for (column, &word) in row.iter().enumerate() {
                filled.push(match is_idle(&governing[column], row) {
                    true => self.word(column, fill, &queries, &mut rng),
                    false => word,
                });
            }
        }
        filled
    }

    fn word(&self, column: usize, fill: Fill, queries: &Queries, rng: &mut Pcg64) -> u64 {
        let pin = &self.pins.inputs[column];
        let ones = u64::MAX >> (u64::BITS - pin.width);
        let query = match fill {
            Fill::Zeros => return 0,
            Fill::Ones => return ones,
            Fill::Random => return rng.random::<u64>() & ones,
            Fill::At(engine) => queries.current.get(engine).copied().unwrap_or_default(),
        };
        let format = self.machine.format();
        let extra = format.map_or(0, |format| format.query_extra_bits);
        let mut axes = ["photon_x", "photon_y", "photon_z"].iter();
        let axis = axes.position(|axis| pin.name.starts_with(axis));
        axis.map_or(ones, |axis| u64::from(query.position[axis] >> extra))
    }
}

/// Marks the comparisons with an operand that depended on idle words in the clock before. Returns the number
/// of those that did not depend themselves.
fn excuse_comparisons(machine: &Machine, pins: &Pins, depends: &mut [bool]) -> usize {
    let named = |name: String| pins.observed.iter().position(|pin| pin.name == name);
    // In a spatial machine a photon at the query is in range, so that a flag which may depend on a photon does so in some
    // run. On half steps no photon need be within a small radius.
    let is_exact =
        machine.spatial().is_some() && !machine.format().is_some_and(PhotonFormat::half_steps);
    // The register `in_range` of a cell, or of a lane of an engine, compares its `distance` with its `radius_sq`.
    let comparisons: Vec<(usize, Vec<usize>)> = pins
        .observed
        .iter()
        .enumerate()
        .filter(|_| !is_exact)
        .filter_map(|(column, pin)| {
            let (cell, lane) = pin.name.rsplit_once("_in_range")?;
            let operands = ["distance", "distance_far", "radius_sq"];
            let operands = operands.map(|name| named(format!("{cell}_{name}{lane}")));
            Some((column, operands.into_iter().flatten().collect()))
        })
        .collect();
    let mut excused = 0;
    let visible = pins.observed.len();
    for row in (1..depends.len() / visible).rev() {
        for (column, operands) in &comparisons {
            let before = (row - 1) * visible;
            let is_unknown = operands.iter().any(|operand| depends[before + operand]);
            let mark = &mut depends[row * visible + column];
            excused += usize::from(is_unknown && !*mark);
            *mark |= is_unknown;
        }
    }
    excused
}

/// The queries in the machine, by the handshakes so far.
#[derive(Default)]
struct Queries {
    waiting: Vec<Query>,
    /// The queries of the current batch, one for each engine.
    current: Vec<Query>,
    open: bool,
}

impl Queries {
    fn clock(&mut self, machine: &Machine, row: &[u64], shown: &[u64]) {
        let inputs = Pins::inputs_of(machine, row);
        let outputs = Pins::outputs_of(machine, shown);
        if inputs.query_valid && outputs.query_ready {
            self.waiting.push(inputs.query);
        }
        if inputs.group_valid && outputs.group_ready {
            if !self.open && !self.waiting.is_empty() {
                let batch = machine.queries_at_once().min(self.waiting.len());
                self.current = self.waiting.drain(..batch).collect();
            }
            self.open = !inputs.group.last;
        }
        if inputs.reset {
            (self.waiting, self.open) = Default::default();
        }
    }
}
