//! Verifies a device against the golden model on a stream of stimulus.

use std::ops::ControlFlow;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

use photoncube_hdl::{Level, emit};
use photoncube_spec::{Machine, Pins};
use serde::Serialize;
use thiserror::Error;

use crate::compare::{Comparer, Divergence};
use crate::device::{Device, DeviceError, DeviceKind, Observed, hdl_error};
use crate::faults::UnknownDifference;
use crate::stimulus::{Block, Pressure, Source, StimulusError, generate};
use crate::waves::{Recorder, Waves};

/// The stimulus of a verification and its length.
#[derive(Copy, Clone, Debug)]
pub struct VerifyOptions<'a> {
    /// The least number of iterations, which are groups whose sums are taken. A workload may end earlier,
    /// with its last query.
    pub iterations: u64,
    /// The seed of random stimulus.
    pub seed: u64,
    /// The source of the queries.
    pub source: Source<'a>,
}

/// A record of a verification in which all compared values were equal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Verdict {
    /// The name of the machine.
    pub machine: &'static str,
    /// SHA-256 of the machine's emitted Verilog, see [`Emitted::verilog_sha256`]; `None` where the caller
    /// opened the device with a design of its own.
    ///
    /// [`Emitted::verilog_sha256`]: photoncube_hdl::Emitted::verilog_sha256
    pub verilog_sha256: Option<String>,
    /// The name of the device.
    pub device: String,
    /// The tool behind the device, with its version.
    pub tool_version: String,
    /// The seed of the stimulus.
    pub seed: u64,
    /// The number of groups whose sums were taken.
    pub iterations: u64,
    /// The number of results taken. Each was also compared with the direct gather.
    pub results_compared: u64,
    /// The number of clocks. Every visible signal was compared in each.
    pub vectors_compared: u64,
    /// The number of signals in a vector.
    pub signals_per_vector: usize,
    /// Whether all registers of all cells were compared, or only the output pins.
    pub registers_compared: bool,
    /// The device's speed in clocks per second, without the time of the model and of the comparison.
    pub clocks_per_second: u64,
    /// Statistics of the waits and resets in the stimulus.
    #[serde(skip)]
    pub pressure: Pressure,
}

/// The reason why a verification failed.
#[derive(Debug, Error)]
pub enum VerifyError {
    /// The device differs from the golden model.
    #[error("{0}")]
    Diverged(Box<Divergence>),
    /// With unknown values on its pins or in its registers, the device shows a wrong or unknown value.
    #[error("{0}")]
    Unknown(Box<UnknownDifference>),
    /// Nothing passed through the machine, so nothing was compared.
    #[error(
        "nothing was compared in {device}: {iterations} iterations, {results} results, \
         {vectors} vectors; a verification needs at least one of each"
    )]
    NothingCompared {
        /// The name of the device.
        device: String,
        /// The number of iterations that were run.
        iterations: u64,
        /// The number of results that were taken.
        results: u64,
        /// The number of clocks that were compared.
        vectors: u64,
    },
    /// The device does not run.
    #[error(transparent)]
    Device(#[from] DeviceError),
    /// The stimulus cannot be made.
    #[error(transparent)]
    Stimulus(#[from] StimulusError),
}

/// The most blocks that wait between the golden model and the device.
const BLOCKS_AHEAD: usize = 4;

/// Verifies a machine in a device. Calls `progress` with the number of iterations done.
///
/// # Errors
/// The first difference, with its description; or the device or the stimulus fails.
pub fn verify(
    machine: &Machine,
    kind: DeviceKind,
    options: &VerifyOptions<'_>,
    progress: &dyn Fn(u64),
) -> Result<Verdict, VerifyError> {
    let (mut device, digest) = opened(machine, kind)?;
    let verdict = verify_device(machine, device.as_mut(), options, progress)?;
    Ok(Verdict {
        verilog_sha256: Some(digest),
        ..verdict
    })
}

/// Verifies a machine in a device as [`verify`] does, and records the last `clocks` clocks. A difference does not
/// end the recording at once. If the device does not run, nothing is recorded.
pub fn verify_recorded(
    machine: &Machine,
    kind: DeviceKind,
    options: &VerifyOptions<'_>,
    clocks: usize,
    progress: &dyn Fn(u64),
) -> (Result<Verdict, VerifyError>, Option<Waves>) {
    let (device, digest) = match opened(machine, kind) {
        Ok(opened) => opened,
        Err(error) => return (Err(error.into()), None),
    };
    let mut recorder = Recorder::new(machine, device, clocks);
    let ended = verify_device(machine, &mut recorder, options, progress);
    let verdict = ended.map(|verdict| Verdict {
        verilog_sha256: Some(digest),
        ..verdict
    });
    (verdict, Some(recorder.into_waves()))
}

/// Opens a device with a machine. Returns it with the digest of the machine's emitted text.
fn opened(machine: &Machine, kind: DeviceKind) -> Result<(Box<dyn Device>, String), DeviceError> {
    let design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
    let device = match kind {
        // The device simulates the blocks that the text is printed from.
        DeviceKind::RustHdl => kind.open(machine, Level::Machine)?,
        kind => kind.open_emitted(&design)?,
    };
    Ok((device, design.verilog_sha256()))
}

/// Verifies a machine in a device that is open and has not run yet.
///
/// # Errors
/// The first difference, with its description; or the device or the stimulus fails.
pub fn verify_device(
    machine: &Machine,
    device: &mut dyn Device,
    options: &VerifyOptions<'_>,
    progress: &dyn Fn(u64),
) -> Result<Verdict, VerifyError> {
    thread::scope(|scope| {
        // The golden model runs ahead of the device in a thread of its own.
        let (send, receive) = sync_channel(BLOCKS_AHEAD);
        let generator = scope.spawn(move || produce(machine, options, &send));
        // This call owns the receiver. Its end stops the generator if the device failed.
        let compared = consume(machine, device, options, receive, progress);
        let produced = generator.join().expect("the golden model does not panic");
        let verdict = compared?;
        produced?;
        nothing_is_not_a_pass(verdict)
    })
}

fn produce(
    machine: &Machine,
    options: &VerifyOptions<'_>,
    send: &SyncSender<Block>,
) -> Result<(), StimulusError> {
    let mut sink = |block| match send.send(block) {
        Ok(()) => ControlFlow::Continue(()),
        Err(_) => ControlFlow::Break(()),
    };
    let VerifyOptions {
        iterations,
        seed,
        source,
    } = *options;
    generate(machine, source, seed, iterations, &mut sink)
}

fn consume(
    machine: &Machine,
    device: &mut dyn Device,
    options: &VerifyOptions<'_>,
    blocks: Receiver<Block>,
    progress: &dyn Fn(u64),
) -> Result<Verdict, VerifyError> {
    let signals = Pins::of(machine).observed.len();
    if device.visible() == 0 {
        return Err(nothing_compared(device.name(), 0, 0, 0));
    }
    let mut comparer = Comparer::new(machine, device.visible());
    let mut observed = Observed::default();
    let (mut iterations, mut results) = (0, 0);
    let mut pressure = Pressure::default();
    let mut busy = Duration::ZERO;
    for block in blocks {
        observed.clear();
        let start = Instant::now();
        device.replay(&block.inputs, &mut observed)?;
        busy += start.elapsed();
        if !comparer.is_complete(&block, &observed) {
            return Err(wrong_count(device, block.clocks, &observed).into());
        }
        let repeat = || repeat_command(machine, device.name(), options, &block);
        let compared = comparer.compare(&block, &observed, device.name(), repeat);
        compared.map_err(VerifyError::Diverged)?;
        iterations += block.iterations;
        results += block.results;
        pressure = block.pressure;
        progress(iterations);
    }
    Ok(Verdict {
        machine: machine.name,
        verilog_sha256: None,
        device: device.name().to_owned(),
        tool_version: device.tool_version().to_owned(),
        seed: options.seed,
        iterations,
        results_compared: results,
        vectors_compared: comparer.vectors,
        signals_per_vector: device.visible(),
        registers_compared: device.visible() == signals,
        clocks_per_second: (comparer.vectors as f64 / busy.as_secs_f64()) as u64,
        pressure,
    })
}

/// The error of a device that does not answer row for row.
pub(crate) fn wrong_count(device: &dyn Device, clocks: usize, observed: &Observed) -> DeviceError {
    DeviceError::BrokeOff {
        device: device.name().to_owned(),
        message: format!(
            "it answered {} values in {clocks} clocks of {} signals",
            observed.values.len(),
            device.visible()
        ),
    }
}

fn nothing_is_not_a_pass(verdict: Verdict) -> Result<Verdict, VerifyError> {
    let (iterations, results) = (verdict.iterations, verdict.results_compared);
    let vectors = verdict.vectors_compared;
    if iterations > 0 && results > 0 && vectors > 0 {
        return Ok(verdict);
    }
    let device = &verdict.device;
    Err(nothing_compared(device, iterations, results, vectors))
}

pub(crate) fn nothing_compared(
    device: &str,
    iterations: u64,
    results: u64,
    vectors: u64,
) -> VerifyError {
    VerifyError::NothingCompared {
        device: device.to_owned(),
        iterations,
        results,
        vectors,
    }
}

/// The command whose first chunk is this chunk, and whose run is just long enough to reach the block.
fn repeat_command(
    machine: &Machine,
    device: &str,
    options: &VerifyOptions<'_>,
    block: &Block,
) -> String {
    match options.source {
        Source::Workload { repeat, .. } => repeat.to_owned(),
        Source::Protocol(_) => format!(
            "photoncube verify faults --machine {} --against {device} --seed {}",
            machine.name, options.seed
        ),
        Source::FullThenEmpty => repeat_corner("full_then_empty", machine, device),
        Source::LaneAlone => repeat_corner("lane_alone", machine, device),
        Source::FullBank => repeat_corner("full_bank", machine, device),
        Source::Random => format!(
            "photoncube verify --machine {} --against {device} --seed {} --iterations {}",
            machine.name,
            block.seed,
            block.iterations_before + block.iterations + 1
        ),
    }
}

fn repeat_corner(corner: &str, machine: &Machine, device: &str) -> String {
    format!(
        "cargo test -p photoncube-testbench --test equivalence -- {corner}::{}::{device}",
        machine.name
    )
}
