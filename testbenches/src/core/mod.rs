//! Compares the emitted Verilog of a core with its golden model: every pin, in every clock.
//!
//! The stimulus is random: sets and batches for all chains, mixed; waits on every stream; wrong words of every kind; accesses to
//! registers that there are and that there are not; resets and restarts. Every result of the model is also compared
//! with the direct gather. The registers of the chains are compared by [`crate::verify`] on one chain alone.

mod controls;
mod drive;
pub(crate) mod plan;

use photoncube_hdl::{Emitted, EmittedCore, core_rows, emit_core};
use photoncube_spec::{Core, CoreStreams};
use serde::Serialize;
use thiserror::Error;

use crate::device::{Device, DeviceError, DeviceKind, Observed, hdl_error};
use crate::waves::{Recorder, Waves};
pub use controls::core_controls;
use drive::{Drive, Rows, possible_events};

/// Clocks that are compared at once.
const BLOCK: usize = 1024;

/// The length and the seed of a verification of a core.
#[derive(Copy, Clone, Debug)]
pub struct CoreOptions {
    /// Clocks.
    pub clocks: u64,
    /// The seed of the stimulus.
    pub seed: u64,
    /// The value of a counter that is cleared: 0, but in a test of the carry into the high word.
    counters_from: u64,
}

impl CoreOptions {
    /// The clocks in which the random words cause every event, and every planted fault is found.
    pub const CLOCKS: u64 = 40_000;

    /// A run of so many clocks with this seed.
    pub fn new(clocks: u64, seed: u64) -> Self {
        Self {
            clocks,
            seed,
            counters_from: 0,
        }
    }
}

/// A record of a verification in which all compared values were equal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CoreVerdict {
    /// The name of the core.
    pub core: String,
    /// The name of the device.
    pub device: String,
    /// The tool behind the device, with its version.
    pub tool_version: String,
    /// The seed of the stimulus.
    pub seed: u64,
    /// Clocks in which every pin was compared.
    pub vectors_compared: u64,
    /// Pins, in columns of at most 64 bits.
    pub signals_per_vector: usize,
    /// Results that were also compared with the direct gather.
    pub results_compared: u64,
    /// Leaves that were taken.
    pub leaf_beats: u64,
    /// Queries that were taken.
    pub query_beats: u64,
    /// Accesses to registers.
    pub accesses: u64,
    /// Resets by `aresetn`.
    pub resets: u64,
    /// Restarts by a register.
    pub restarts: u64,
    /// Each event with the number of times that it was set.
    pub events: Vec<(&'static str, u64)>,
}

/// The reason why a verification of a core failed.
#[derive(Debug, Error)]
pub enum CoreError {
    /// The device differs from the model.
    #[error(
        "{device} differs from the golden model of `{core}` in clock {clock} (seed {seed}): {signal} is {actual:#x}, expected \
         {expected:#x}"
    )]
    Diverged {
        /// The name of the core.
        core: String,
        /// The name of the device.
        device: String,
        /// The clock.
        clock: u64,
        /// The seed.
        seed: u64,
        /// The name of the pin.
        signal: String,
        /// The value of the model.
        expected: u64,
        /// The value of the device; 0 for an unknown bit.
        actual: u64,
    },
    /// The model differs from the direct gather.
    #[error("clock {clock}: the golden model gives {found}, the direct gather {expected}")]
    Model {
        /// The clock.
        clock: u64,
        /// The model's result.
        found: String,
        /// What the chain owes.
        expected: String,
    },
    /// Something never happened, so nothing was compared of it.
    #[error("nothing was compared of {0}: the run was too short; raise --clocks")]
    Never(String),
    /// The device does not run.
    #[error(transparent)]
    Device(#[from] DeviceError),
}

/// Verifies a core's emitted Verilog in a device.
///
/// # Errors
/// The device differs from the model or does not run, or something of the stimulus never happened.
pub fn verify_core(
    core: &Core,
    kind: DeviceKind,
    options: &CoreOptions,
    tick: &dyn Fn(u64),
) -> Result<CoreVerdict, CoreError> {
    let emitted = emit_core(core).map_err(hdl_error(core.machine))?;
    verify_core_text(core, &emitted, kind, options, tick)
}

/// Verifies a text in the place of a core's Verilog.
fn verify_core_text(
    core: &Core,
    emitted: &EmittedCore,
    kind: DeviceKind,
    options: &CoreOptions,
    tick: &dyn Fn(u64),
) -> Result<CoreVerdict, CoreError> {
    let rows = core_rows(core, emitted);
    let mut device = kind.open_emitted(&rows)?;
    let subject = Subject {
        core,
        digest: emitted.digest,
        rows: &rows,
    };
    verify_rows(&subject, &mut device, |_, _| (), options, tick)
}

/// Verifies a core as [`verify_core`] does, and records its pins in the last `clocks` clocks. If the device does not
/// run, nothing is recorded.
pub fn verify_core_recorded(
    core: &Core,
    kind: DeviceKind,
    options: &CoreOptions,
    clocks: usize,
    tick: &dyn Fn(u64),
) -> (Result<CoreVerdict, CoreError>, Option<Waves>) {
    let opened = || -> Result<_, DeviceError> {
        let emitted = emit_core(core).map_err(hdl_error(core.machine))?;
        let rows = core_rows(core, &emitted);
        let device = kind.open_emitted(&rows)?;
        Ok((emitted.digest, rows, device))
    };
    let (digest, rows, device) = match opened() {
        Ok(opened) => opened,
        Err(error) => return (Err(error.into()), None),
    };
    let mut recorder = Recorder::of_given(&core.name(), rows.pins.clone(), device, clocks);
    let subject = Subject {
        core,
        digest,
        rows: &rows,
    };
    let expect = |recorder: &mut Recorder<_>, block: &Rows| recorder.expect(&block.expected);
    let ended = verify_rows(&subject, &mut recorder, expect, options, tick);
    (ended, Some(recorder.into_waves()))
}

/// A core, with the digest in its registers and the text around its Verilog that has a pin for each column.
struct Subject<'a> {
    core: &'a Core,
    digest: u64,
    rows: &'a Emitted,
}

/// Verifies a core in an open device. `announce` is called with each block before the device replays it.
fn verify_rows<D: Device>(
    subject: &Subject<'_>,
    device: &mut D,
    announce: impl Fn(&mut D, &Rows),
    options: &CoreOptions,
    tick: &dyn Fn(u64),
) -> Result<CoreVerdict, CoreError> {
    let Subject { core, digest, rows } = *subject;
    let streams = CoreStreams::of(core);
    let mut drive = Drive::new(core, &streams, digest, options);
    let mut compared = 0;
    while compared < options.clocks {
        let clocks = (options.clocks - compared).min(BLOCK as u64) as usize;
        let mut block = Rows::default();
        drive.run(clocks, &mut block)?;
        announce(device, &block);
        compare(core, rows, device, &block, compared, options.seed)?;
        compared += clocks as u64;
        tick(compared);
    }
    let happened = drive.happened;
    let count = |name| happened.events.get(name).copied().unwrap_or(0);
    let events: Vec<_> = possible_events(core)
        .map(|row| (row.name, count(row.name)))
        .collect();
    let verdict = CoreVerdict {
        core: core.name(),
        device: device.name().to_owned(),
        tool_version: device.tool_version().to_owned(),
        seed: options.seed,
        vectors_compared: compared,
        signals_per_vector: rows.pins.observed.len(),
        results_compared: happened.results,
        leaf_beats: happened.leaves,
        query_beats: happened.queries,
        accesses: happened.accesses,
        resets: happened.resets,
        restarts: happened.restarts,
        events,
    };
    match never(&verdict) {
        Some(what) => Err(CoreError::Never(what)),
        None => Ok(verdict),
    }
}

/// Something that the stimulus has and that never happened.
fn never(verdict: &CoreVerdict) -> Option<String> {
    let mut all = vec![
        ("results", verdict.results_compared),
        ("accesses", verdict.accesses),
        ("resets", verdict.resets),
        ("restarts", verdict.restarts),
    ];
    all.extend(verdict.events.iter().copied());
    let never = all.iter().find(|(_, times)| *times == 0);
    never.map(|(what, _)| (*what).to_owned())
}

fn compare(
    core: &Core,
    rows: &Emitted,
    device: &mut dyn Device,
    block: &Rows,
    first: u64,
    seed: u64,
) -> Result<(), CoreError> {
    let mut observed = Observed::default();
    device.replay(&block.inputs, &mut observed)?;
    let columns = rows.pins.observed.len();
    let different = block
        .expected
        .iter()
        .zip(&observed.values)
        .position(|(expected, actual)| expected != actual);
    let unknown = observed.unknown.first().map(|unknown| unknown.index);
    let missing = (observed.values.len() < block.expected.len()).then_some(observed.values.len());
    let Some(index) = [different, unknown, missing].into_iter().flatten().min() else {
        return Ok(());
    };
    Err(CoreError::Diverged {
        core: core.name(),
        device: device.name().to_owned(),
        clock: first + (index / columns) as u64,
        seed,
        signal: rows.pins.observed[index % columns].name.clone(),
        expected: block.expected[index],
        actual: observed.values.get(index).copied().unwrap_or(0),
    })
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{CORES, find_machine};

    use super::*;
    use crate::controls::plant;

    /// No run is so long that a counter reaches its high word, so the counters start near its end.
    #[test]
    fn counters_carry_into_their_high_words() {
        let counters_from = (1 << Core::REGISTER_BITS) - 100;
        let (chains, machine) = CORES[0];
        let core = Core::new(find_machine(machine).unwrap(), chains).unwrap();
        let mut emitted = emit_core(&core).unwrap();
        let zero = format!("{}'d0;", Core::COUNTER_BITS);
        let start = format!("{}'d{counters_from};", Core::COUNTER_BITS);
        assert!(emitted.text.contains(&zero), "the counters are cleared");
        emitted.text = emitted.text.replace(&zero, &start);
        let options = CoreOptions {
            counters_from,
            ..CoreOptions::new(CoreOptions::CLOCKS, 1)
        };
        let verify = |emitted: &EmittedCore| {
            verify_core_text(&core, emitted, DeviceKind::Text, &options, &|_| ())
        };
        verify(&emitted).unwrap();

        let module = format!("{}_registers", emitted.top);
        let held = "if (reading & reads_low) counter_high <= counter_high_next;";
        emitted.text = plant(&emitted.text, &module, held, "").unwrap();
        let found = verify(&emitted);
        let is_found = matches!(found, Err(CoreError::Diverged { .. }));
        assert!(is_found, "{found:?}");
    }
}
