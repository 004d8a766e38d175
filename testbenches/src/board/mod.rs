//! Compares a board's Verilog, at the pins of its serial line, with the golden model: all frames that it sends, byte for byte.
//!
//! A scenario is a list of steps. A step's bytes go to both; then the frames that both have sent are compared, those of each kind in
//! their order, and results also by their chain: the order between them depends on clocks of the line, which the model does not have, and
//! so does when a credit is told.

mod faults;
mod scenario;

use std::collections::BTreeMap;

use photoncube_hdl::Ulx3s;
use photoncube_model::{SerialFrame, SerialModel};
use photoncube_spec::{Core, Serial, SerialKind, SerialSizes};
use thiserror::Error;

use crate::device::{BoardSimulation, DeviceError, Symbol, hdl_error};

pub use faults::board_controls;
pub use scenario::Scenario;

/// The times of a byte without a byte after which the board has nothing more to say.
const SILENT_BYTES: u64 = 24;

/// What was compared.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct BoardVerdict {
    /// Frames to the board that were right.
    pub right: usize,
    /// Wrong frames, and bytes outside of frames, to the board.
    pub wrong: usize,
    /// Frames of the board that were compared.
    pub compared: usize,
    /// Results among them.
    pub results: usize,
    /// Errors among them.
    pub errors: usize,
    /// Clocks of the simulation.
    pub clocks: u64,
}

/// The reason why a comparison of a board fails.
#[derive(Debug, Error)]
pub enum BoardError {
    /// The board differs from the model.
    #[error("step {step} of scenario {scenario:?} (seed {seed}): {what}")]
    Diverged {
        /// The scenario.
        scenario: Scenario,
        /// The seed.
        seed: u64,
        /// The number of the step.
        step: usize,
        /// What was found and expected.
        what: String,
    },
    /// The simulation does not run.
    #[error(transparent)]
    Device(#[from] DeviceError),
}

/// Runs scenarios on a board's Verilog in Verilator, and compares it with the model.
///
/// # Errors
/// The board differs from the model, or its simulation does not run.
pub fn verify_board(
    board: &Ulx3s,
    scenarios: &[Scenario],
    seed: u64,
) -> Result<BoardVerdict, BoardError> {
    let files = board.files().map_err(hdl_error(board.core().machine))?;
    let mut simulation = BoardSimulation::of_files(board, &files)?;
    let mut verdict = BoardVerdict::default();
    for &scenario in scenarios {
        Comparison::new(board, files.core.digest, scenario, seed)
            .run(&mut simulation, &mut verdict)?;
    }
    Ok(verdict)
}

/// A scenario under way.
struct Comparison {
    scenario: Scenario,
    seed: u64,
    core: Core,
    sizes: SerialSizes,
    model: SerialModel,
    /// The number of the board's next frame.
    next: Option<u8>,
    /// The bytes taken that the board has told.
    told: u16,
    step: usize,
}

impl Comparison {
    fn new(board: &Ulx3s, digest: u64, scenario: Scenario, seed: u64) -> Self {
        let core = *board.core();
        Self {
            scenario,
            seed,
            core,
            sizes: SerialSizes::of(&core),
            model: SerialModel::new(&core, digest),
            next: None,
            told: 0,
            step: 0,
        }
    }

    fn run(
        &mut self,
        simulation: &mut BoardSimulation,
        verdict: &mut BoardVerdict,
    ) -> Result<(), BoardError> {
        for step in self.scenario.steps(&self.core, self.seed) {
            let line = step.symbols();
            for symbol in &line {
                match *symbol {
                    Symbol::Byte(byte) => self.model.hear(byte),
                    Symbol::Broken(_) => self.model.hear_broken(),
                    Symbol::Reset => self.model.reset(),
                }
            }
            let mut found = simulation.exchange(&line, SILENT_BYTES)?;
            loop {
                let more = simulation.exchange(&[], SILENT_BYTES)?;
                if more.is_empty() {
                    break;
                }
                found.extend(more);
            }
            self.compare(&found, verdict)?;
            verdict.right += step.right();
            verdict.wrong += step.wrong();
            self.step += 1;
        }
        verdict.clocks = simulation.clocks();
        Ok(())
    }

    fn compare(&mut self, found: &[u8], verdict: &mut BoardVerdict) -> Result<(), BoardError> {
        let said = self.model.said();
        let expected =
            SerialFrame::of_bridge(&self.sizes, &said).map_err(|what| self.diverged(what))?;
        let found =
            SerialFrame::of_bridge(&self.sizes, found).map_err(|what| self.diverged(what))?;
        for frame in &found {
            if self.next.is_some_and(|next| next != frame.number) {
                let what = format!("found {frame:?}, expected the number {:?}", self.next);
                return Err(self.diverged(what));
            }
            self.next = Some(frame.number.wrapping_add(1));
        }
        let (by_model, by_board) = (sorted(&expected), sorted(&found));
        if by_model != by_board {
            let what = format!("found {by_board:02x?}, expected {by_model:02x?}");
            return Err(self.diverged(what));
        }
        self.credit(&found)?;
        let count = |kind| found.iter().filter(|frame| frame.kind == kind).count();
        verdict.compared += found.len();
        verdict.results += count(SerialKind::Result);
        verdict.errors += count(SerialKind::Error);
        Ok(())
    }

    /// When a credit is sent depends on the clocks of the line; at the end of a step less than [`Serial::CREDIT_STEP`] bytes are not told.
    fn credit(&mut self, found: &[SerialFrame]) -> Result<(), BoardError> {
        for frame in found {
            let taken = match frame.kind {
                SerialKind::Credit => [frame.payload[0], frame.payload[1]],
                SerialKind::Synced => [frame.payload[2], frame.payload[3]],
                _ => continue,
            };
            self.told = u16::from_le_bytes(taken);
        }
        let untold = self.model.taken().wrapping_sub(self.told);
        if usize::from(untold) < Serial::CREDIT_STEP {
            return Ok(());
        }
        let what = format!(
            "found the credit {}, expected less than {} before {}",
            self.told,
            Serial::CREDIT_STEP,
            self.model.taken()
        );
        Err(self.diverged(what))
    }

    fn diverged(&self, what: String) -> BoardError {
        BoardError::Diverged {
            scenario: self.scenario,
            seed: self.seed,
            step: self.step,
            what,
        }
    }
}

/// The payloads of each kind but credits, and of the results of each chain, in their order.
fn sorted(frames: &[SerialFrame]) -> BTreeMap<(SerialKind, u8), Vec<&[u8]>> {
    let mut sorted: BTreeMap<_, Vec<&[u8]>> = BTreeMap::new();
    let compared = frames
        .iter()
        .filter(|frame| frame.kind != SerialKind::Credit);
    for frame in compared {
        let chain = match frame.kind {
            SerialKind::Result => frame.payload[0] & ((1 << Serial::MARK_LAST) - 1),
            _ => 0,
        };
        let payloads = sorted.entry((frame.kind, chain)).or_default();
        payloads.push(&frame.payload);
    }
    sorted
}
