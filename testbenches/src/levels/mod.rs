//! Compares the parts of a machine on their own: each unit, one cell on random microprograms, and the
//! network, with the golden model's ops and the spec's topology.
//!
//! A part is small enough to be driven into corners that the whole machine reaches rarely. A difference found
//! here names the part.

mod cell;
mod memory;
mod overlap;
mod unit;

use photoncube_hdl::{Level, level_pins};
use photoncube_spec::{Cut, Field, Machine, Op, Organisation, Pin, Pins, SEQUENTIAL, Step, Widths};
use rand::SeedableRng;
use rand_pcg::Pcg64;
use serde::Serialize;

use crate::compare::{Activity, Actual, Divergence, mnemonic};
use crate::device::{Device, DeviceError, DeviceKind, Observed, hdl_error};
use crate::squares::SquarePair;
use crate::stimulus::corner;
use crate::verify::{VerifyError, nothing_compared, wrong_count};

use memory::MemoryWalk;
pub(crate) use memory::{scrub_rows as memory_scrub_rows, walk as memory_walk};
pub(crate) use unit::{op_of, result};

/// The most pairs of operands that every device squares: those of 8-bit coordinates.
const EXHAUSTIVE_PAIRS: usize = 1 << 16;

/// A record of the comparison of a part in which all values were equal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PartVerdict {
    /// The name of the machine.
    pub machine: &'static str,
    /// The name of the part.
    pub part: &'static str,
    /// The name of the device.
    pub device: String,
    /// The number of rows of inputs. Every visible signal was compared after each.
    pub vectors_compared: u64,
    /// The number of signals in a vector.
    pub signals_per_vector: usize,
}

/// Verifies a part of a machine in a device, on at least `vectors` rows of inputs. A square unit gets every
/// pair of operands where there are no more than `vectors` or 2^16, else every difference.
///
/// # Errors
/// The first difference; or the device or the stimulus fails.
///
/// # Panics
/// For the whole machine, which is no part: [`crate::verify`] is for that.
pub fn verify_part(
    machine: &Machine,
    part: Level,
    kind: DeviceKind,
    vectors: usize,
    seed: u64,
) -> Result<PartVerdict, VerifyError> {
    let mut device = kind.open(machine, part)?;
    verify_part_device(machine, part, device.as_mut(), vectors, seed)
}

/// Verifies a part of a machine in a device that is open and has not run yet.
///
/// # Errors
/// The first difference; or the device or the stimulus fails.
///
/// # Panics
/// For the whole machine, which is no part: [`crate::verify`] is for that.
pub fn verify_part_device(
    machine: &Machine,
    part: Level,
    device: &mut dyn Device,
    vectors: usize,
    seed: u64,
) -> Result<PartVerdict, VerifyError> {
    let pins = level_pins(machine, part).map_err(hdl_error(machine))?;
    let trace = Trace::of(machine, part, pins, vectors, seed)?;
    let mut observed = Observed::default();
    device.replay(&trace.inputs, &mut observed)?;
    let visible = device.visible();
    let rows = trace.activities.len();
    if observed.values.len() != rows * visible {
        return Err(wrong_count(device, rows, &observed).into());
    }
    if observed.values.is_empty() {
        return Err(nothing_compared(device.name(), 0, 0, 0));
    }
    if let Some(mut divergence) = trace.divergence(machine, part, &observed, visible) {
        divergence.seed = seed;
        divergence.device = device.name().to_owned();
        divergence.repeat = format!("{}::{}", divergence.repeat, device.name());
        return Err(VerifyError::Diverged(Box::new(divergence)));
    }
    Ok(PartVerdict {
        machine: machine.name,
        part: part.name(),
        device: device.name().to_owned(),
        vectors_compared: rows as u64,
        signals_per_vector: visible,
    })
}

/// Rows of inputs for a part, with the expected signals.
struct Trace {
    pins: Pins,
    inputs: Vec<u64>,
    expected: Vec<u64>,
    /// The activity of each row.
    activities: Vec<Activity>,
}

impl Trace {
    fn of(
        machine: &Machine,
        part: Level,
        pins: Pins,
        vectors: usize,
        seed: u64,
    ) -> Result<Self, DeviceError> {
        let mut trace = Self {
            pins,
            inputs: Vec::new(),
            expected: Vec::new(),
            activities: Vec::new(),
        };
        let rng = &mut Pcg64::seed_from_u64(seed);
        match part {
            Level::Machine => panic!("the whole machine is not a part"),
            Level::Cell => match machine.organisation {
                Organisation::Overlapped => trace.overlap_cell(machine, vectors, rng),
                Organisation::Programmed(program) => {
                    trace.program_cell(machine, &program.microprogram(), vectors, rng);
                }
                _ => trace.cell(machine, vectors, rng),
            },
            Level::Network => trace.network(machine, vectors, rng),
            Level::Unit(unit) => trace.unit(machine, unit, vectors, rng),
            Level::SquarePair => trace.square_pair(machine, vectors, rng),
            Level::Memory => trace.memory(machine, vectors, seed)?,
        }
        Ok(trace)
    }

    fn memory(&mut self, machine: &Machine, vectors: usize, seed: u64) -> Result<(), DeviceError> {
        let block = MemoryWalk::new(machine, seed)?.block(vectors as u64);
        (self.inputs, self.expected) = (block.inputs, block.expected);
        self.activities = vec![Activity::Flows; block.clocks];
        Ok(())
    }

    /// Appends a row: a value for each pin, by its name.
    fn push(&mut self, activity: Activity, value: impl Fn(&str) -> u64, expected: &[u64]) {
        let value = |pin: &Pin| value(&pin.name) & (u64::MAX >> (u64::BITS - pin.width));
        self.inputs.extend(self.pins.inputs.iter().map(value));
        self.expected.extend(expected);
        self.activities.push(activity);
    }

    /// Rows for two squares of a spatial machine, a pair of operands a clock. The output belongs to the
    /// operands of as many clocks before as the squares have registers; before that it is 0.
    fn square_pair(&mut self, machine: &Machine, vectors: usize, rng: &mut Pcg64) {
        let spatial = machine.spatial();
        let spatial = spatial.expect("only spatial machines have pairs of squares");
        let widths = Widths::of(machine);
        let of_squares = |cut: &Cut| *cut < Cut::Pair && spatial.cuts.has(*cut);
        let latency = Cut::ALL.iter().filter(|cut| of_squares(cut)).count();
        let mask = (1 << widths.coordinate) - 1;
        let extra_bits = widths.coordinate - widths.photon;
        let of_photon = mask >> extra_bits;
        let all_pairs = 1 << (widths.coordinate + widths.photon);
        let operands = |index: usize, rng: &mut Pcg64| match all_pairs <= vectors {
            // Both photons take every pair; the second takes them in another order.
            true => {
                let photon = index as u64 & of_photon;
                [
                    (index as u64 >> widths.photon) & mask,
                    photon,
                    photon ^ (of_photon >> 1),
                ]
            }
            false => {
                [widths.coordinate, widths.photon, widths.photon].map(|bits| corner(rng, bits))
            }
        };
        let mut squares = SquarePair::new(latency, widths.difference, extra_bits, machine.squarer);
        for index in 0..vectors.max(latency + 1) {
            let [query, photon_a, photon_b] = operands(index, rng);
            let expected = squares.clock(query, [photon_a, photon_b]);
            let value = |name: &str| match name {
                "query" => query,
                "photon_a" => photon_a,
                _ => photon_b,
            };
            let step = Step::new(Op::SquareDifference);
            self.push(Activity::Step(step), value, &expected);
        }
    }

    /// Every axis and no axis, with a different word for each node.
    fn network(&mut self, machine: &Machine, vectors: usize, rng: &mut Pcg64) {
        let work = Widths::of(machine).work;
        let nodes = machine.hypercube().nodes();
        let axes = machine.hypercube().axes().map(Some);
        let axes: Vec<_> = axes.chain([None]).collect();
        for index in 0..vectors.max(axes.len()) {
            let axis = axes[index % axes.len()];
            let words: Vec<_> = (0..nodes).map(|_| corner(rng, work)).collect();
            let mut expected = vec![0; nodes];
            if let Some(axis) = axis {
                for (node, link) in expected.iter_mut().enumerate() {
                    *link = words[node ^ (1 << axis.bit())];
                }
            }
            let inputs = |name: &str| match name.strip_prefix("work_") {
                Some(node) => words[node.parse::<usize>().expect("a node's index")],
                None => axis.map_or(0, |axis| 1 << axis.bit()),
            };
            let step = axis.map_or(Step::new(Op::Nop), Step::exchange_add);
            self.push(Activity::Step(step), inputs, &expected);
        }
    }

    fn divergence(
        &self,
        machine: &Machine,
        part: Level,
        observed: &Observed,
        visible: usize,
    ) -> Option<Divergence> {
        let columns = self.pins.observed.len();
        let expected = |index: usize| self.expected[index / visible * columns + index % visible];
        let differs = |&index: &usize| observed.at(index) != Actual::Known(expected(index));
        let index = (0..observed.values.len()).find(differs)?;
        let row = index / visible;
        let in_row = row * visible..(row + 1) * visible;
        let pin = &self.pins.observed[index % visible];
        // A register shows the effect of the clock before.
        let cause = match part {
            Level::Cell | Level::Memory => row.checked_sub(1),
            _ => Some(row),
        };
        let operands = cause.map_or(Vec::new(), |row| {
            let inputs = self.pins.inputs.len();
            let values = &self.inputs[row * inputs..][..inputs];
            let named = self.pins.inputs.iter().zip(values);
            named
                .map(|(pin, value)| (pin.name.clone(), *value))
                .collect()
        });
        Some(Divergence {
            machine: machine.name,
            device: String::new(),
            seed: 0,
            chunk: 0,
            clock: row as u64,
            signal: pin.name.clone(),
            place: pin.place,
            register: mnemonic(machine, pin.place),
            expected: expected(index),
            actual: observed.at(index),
            differing: in_row.filter(differs).count(),
            activity: cause.map_or(Activity::PowerUp, |row| self.activities[row]),
            operands,
            vectors_compared: row as u64,
            repeat: format!(
                "cargo test -p photoncube-testbench --test parts -- {}::{}",
                part.name(),
                machine.name
            ),
        })
    }
}

fn field_named(name: &str) -> Field {
    let mut rows = SEQUENTIAL.fields.iter();
    let row = rows.find(|row| row.name == name);
    row.expect("a cell's other pins are fields of the control word")
        .field
}
