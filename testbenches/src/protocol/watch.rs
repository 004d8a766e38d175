//! What was on the pins of a device while it was verified.

use photoncube_spec::{Machine, Pins};

use super::FaultClass;
use crate::device::{Device, DeviceError, Observed};
use crate::verify::Verdict;

const STREAMS: [&str; 3] = ["query", "group", "result"];

/// A device, and a count of what its streams and its reset do.
pub(super) struct Watch<'a> {
    device: &'a mut dyn Device,
    columns: usize,
    reset: usize,
    streams: [Stream; 3],
    resets: u64,
}

/// One stream.
struct Stream {
    /// The column of the side that the stimulus has: valid, or the result's ready.
    own: usize,
    /// The column of the machine's side.
    machines: usize,
    /// Clocks in which the machine waited for the stimulus.
    withheld: u64,
    /// The longest run of such clocks.
    longest: u64,
    /// The run that lasts.
    run: u64,
}

impl Stream {
    fn of(pins: &Pins, name: &str) -> Self {
        let valid = format!("{name}_valid");
        let ready = format!("{name}_ready");
        let (own, machines) = match name {
            "result" => (ready, valid),
            _ => (valid, ready),
        };
        Self {
            own: column(pins.inputs.iter().map(|pin| &pin.name), &own),
            machines: column(pins.observed.iter().map(|pin| &pin.name), &machines),
            withheld: 0,
            longest: 0,
            run: 0,
        }
    }

    fn clock(&mut self, inputs: &[u64], shown: &[u64]) {
        if inputs[self.own] != 0 || shown[self.machines] == 0 {
            self.run = 0;
            return;
        }
        self.withheld += 1;
        self.run += 1;
        self.longest = self.longest.max(self.run);
    }
}

fn column<'n>(mut names: impl Iterator<Item = &'n String>, wanted: &str) -> usize {
    let column = names.position(|name| name == wanted);
    column.expect("every machine has the streams' pins")
}

impl<'a> Watch<'a> {
    pub fn new(machine: &Machine, device: &'a mut dyn Device) -> Self {
        let pins = Pins::of(machine);
        Self {
            device,
            columns: pins.inputs.len(),
            reset: column(pins.inputs.iter().map(|pin| &pin.name), "reset"),
            streams: STREAMS.map(|name| Stream::of(&pins, name)),
            resets: 0,
        }
    }

    /// How often the fault was there, and in which words that counts.
    pub fn seen(&self, class: FaultClass, verdict: &Verdict) -> (u64, String) {
        let withheld: u64 = self.streams.iter().map(|stream| stream.withheld).sum();
        let each = |of: fn(&Stream) -> u64| {
            let named = STREAMS.iter().zip(&self.streams);
            let words: Vec<_> = named.map(|(name, s)| format!("{name} {}", of(s))).collect();
            words.join(", ")
        };
        match class {
            FaultClass::Resets => (
                self.resets,
                format!("resets, in {} clocks", verdict.vectors_compared),
            ),
            // What starts as the text says is the registers.
            FaultClass::NoReset if self.resets == 0 => (
                verdict.signals_per_vector as u64,
                "signals at power-up".to_owned(),
            ),
            FaultClass::NoReset => (0, format!("{} resets", self.resets)),
            FaultClass::Holds => (
                withheld,
                format!(
                    "clocks withheld; the longest: {}",
                    each(|stream| stream.longest)
                ),
            ),
            _ => (
                withheld,
                format!("clocks withheld: {}", each(|stream| stream.withheld)),
            ),
        }
    }
}

impl Device for Watch<'_> {
    fn name(&self) -> &str {
        self.device.name()
    }

    fn tool_version(&self) -> &str {
        self.device.tool_version()
    }

    fn visible(&self) -> usize {
        self.device.visible()
    }

    fn replay(&mut self, inputs: &[u64], observed: &mut Observed) -> Result<(), DeviceError> {
        let before = observed.values.len();
        self.device.replay(inputs, observed)?;
        let visible = self.device.visible();
        let shown = observed.values[before..].chunks_exact(visible);
        for (inputs, shown) in inputs.chunks_exact(self.columns).zip(shown) {
            self.resets += inputs[self.reset];
            for stream in &mut self.streams {
                stream.clock(inputs, shown);
            }
        }
        Ok(())
    }
}
