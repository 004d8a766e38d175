//! Waveforms of a verification: the pins and registers of a device beside those of the golden model, clock by
//! clock, for a waveform viewer.

mod recorder;
mod scopes;
mod setup;
mod steps;
mod vcd;

use std::collections::VecDeque;

use photoncube_spec::Pins;

pub use recorder::Recorder;
use scopes::Scope;
use steps::Steps;

use crate::compare::Actual;

/// The length of a clock in the waveform, in ns. It is a unit of the picture and no measured clock.
pub const NS_PER_CLOCK: u64 = 10;

/// The most names that the signal `differing` shows.
const MOST_NAMES: usize = 4;

/// The last clocks of a verification. If the device differed from the golden model, they end some clocks after
/// the first difference.
#[derive(Debug)]
pub struct Waves {
    /// What was recorded.
    subject: String,
    /// The device's name as an identifier.
    device: String,
    pins: Pins,
    visible: usize,
    has_model: bool,
    steps: Option<Steps>,
    /// The most clocks that are kept.
    most: usize,
    rows: VecDeque<Row>,
    /// The number of clocks that were seen, of which `rows` are the last.
    seen: u64,
    difference: Option<Difference>,
}

/// The signals in one clock, before its rising edge.
#[derive(Debug)]
struct Row {
    /// The values of the input pins.
    inputs: Vec<u64>,
    /// The values of the device's visible signals.
    device: Vec<Actual>,
    /// The values of the golden model's signals; empty where there is no model.
    model: Vec<u64>,
    /// The columns of the visible signals that differ.
    differing: Vec<usize>,
}

/// The first difference of the device from the golden model.
#[derive(Copy, Clone, Debug)]
struct Difference {
    /// The number of clocks before it.
    clock: u64,
    /// The number of clocks after it that are still to be recorded.
    to_come: usize,
}

/// The files of a waveform.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WaveFiles {
    /// The waveform, as a value change dump (IEEE 1364-2005, section 18).
    pub vcd: Vec<u8>,
    /// The commands that make Surfer show the waveform.
    pub surfer: String,
    /// The save file that makes GTKWave show the waveform.
    pub gtkwave: String,
}

impl Waves {
    fn new(subject: &str, pins: Pins, visible: usize, device: &str, most: usize) -> Self {
        Self {
            subject: subject.to_owned(),
            device: device.replace('-', "_"),
            pins,
            visible,
            has_model: false,
            steps: None,
            most: most.max(1),
            rows: VecDeque::new(),
            seen: 0,
            difference: None,
        }
    }

    /// Whether no further clock is to be recorded.
    fn is_complete(&self) -> bool {
        self.difference
            .is_some_and(|difference| difference.to_come == 0)
    }

    /// Adds a clock; forgets the first one where there are too many.
    fn push(&mut self, row: Row) {
        match &mut self.difference {
            Some(difference) => difference.to_come -= 1,
            None if row.differing.is_empty() => {}
            None => {
                self.difference = Some(Difference {
                    clock: self.seen,
                    // Most of what is kept leads to the difference.
                    to_come: self.most / 4,
                });
            }
        }
        if self.rows.len() == self.most {
            self.rows.pop_front();
        }
        self.rows.push_back(row);
        self.seen += 1;
    }

    /// The numbers of the recorded clocks, counted from power-up.
    pub fn clocks(&self) -> std::ops::Range<u64> {
        self.seen - self.rows.len() as u64..self.seen
    }

    /// The clock of the first difference from the golden model, counted from power-up.
    pub fn difference(&self) -> Option<u64> {
        self.difference.map(|difference| difference.clock)
    }

    /// The time in the waveform at which the values of a clock are first shown, in ns.
    pub fn time(clock: u64) -> u64 {
        clock * NS_PER_CLOCK
    }

    /// The files of the waveform, which viewers open.
    pub fn files(&self) -> WaveFiles {
        let scopes = Scope::of(self);
        WaveFiles {
            vcd: vcd::written(self, &scopes),
            surfer: setup::surfer(self, &scopes),
            gtkwave: setup::gtkwave(self, &scopes),
        }
    }

    /// The names of the signals that differ in a clock; `-` where none does.
    fn names_differing(&self, row: &Row) -> String {
        let names = row.differing.iter().take(MOST_NAMES);
        let mut names: Vec<_> = names
            .map(|&column| self.pins.observed[column].name.clone())
            .collect();
        match row.differing.len().saturating_sub(MOST_NAMES) {
            0 => {}
            more => names.push(format!("{more} more")),
        }
        match names.is_empty() {
            true => "-".to_owned(),
            false => names.join(", "),
        }
    }
}
