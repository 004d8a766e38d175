//! The signals of a waveform, grouped by the parts of the machine.

use photoncube_spec::{Pin, SignalPlace};

use super::{Steps, Waves};

/// The name of the scope of the golden model.
const MODEL: &str = "model";

/// A value of a row that a signal shows.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Shown {
    /// The clock.
    Clock,
    /// The input pin of that index.
    Input(usize),
    /// The text of that index, of what a program does.
    Step(usize),
    /// Whether a visible signal differs from the golden model.
    Differs,
    /// The names of the signals that differ.
    Differing,
    /// The observed signal of that index, of the device.
    Device(usize),
    /// The observed signal of that index, of the golden model.
    Model(usize),
}

/// A signal of the waveform.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Signal {
    pub name: String,
    /// The width in bits; `None` for a text.
    pub bits: Option<u32>,
    pub shown: Shown,
}

impl Signal {
    fn of(name: &str, pin: &Pin, shown: Shown) -> Self {
        Self {
            name: name.to_owned(),
            bits: Some(pin.width),
            shown,
        }
    }

    fn flag(name: &str, shown: Shown) -> Self {
        Self {
            name: name.to_owned(),
            bits: Some(1),
            shown,
        }
    }

    fn text(name: impl Into<String>, shown: Shown) -> Self {
        Self {
            name: name.into(),
            bits: None,
            shown,
        }
    }
}

/// A scope of the waveform. Its path has one part, or two: the device or the model, and the machine's part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Scope {
    pub path: Vec<String>,
    pub signals: Vec<Signal>,
}

impl Scope {
    /// All scopes: the run, the input pins, then the device and the golden model, each with a scope for each part of
    /// the machine.
    pub fn of(waves: &Waves) -> Vec<Self> {
        let mut scopes = vec![Self::run(waves)];
        scopes.extend(Self::parts("inputs", &waves.pins.inputs, Shown::Input));
        let visible = &waves.pins.observed[..waves.visible];
        scopes.extend(Self::parts(&waves.device, visible, Shown::Device));
        if waves.has_model {
            scopes.extend(Self::parts(MODEL, &waves.pins.observed, Shown::Model));
        }
        scopes
    }

    /// The clock, the steps of the program, and how the device differs from the golden model.
    fn run(waves: &Waves) -> Self {
        let steps = waves.steps.iter().flat_map(Steps::names).enumerate();
        let steps = steps.map(|(index, name)| Signal::text(name, Shown::Step(index)));
        let compared = [
            Signal::flag("differs", Shown::Differs),
            Signal::text("differing", Shown::Differing),
        ];
        let compared = compared.into_iter().filter(|_| waves.has_model);
        let clock = Signal::flag("clock", Shown::Clock);
        Self {
            path: vec!["run".to_owned()],
            signals: [clock].into_iter().chain(steps).chain(compared).collect(),
        }
    }

    /// The scopes of pins and registers. Successive signals of one part of the machine are in one scope.
    fn parts(top: &str, pins: &[Pin], shown: fn(usize) -> Shown) -> Vec<Self> {
        let mut scopes: Vec<Self> = Vec::new();
        for (column, pin) in pins.iter().enumerate() {
            let part = part(pin);
            let path = [Some(top.to_owned()), part.clone()].into_iter().flatten();
            let path: Vec<_> = path.collect();
            let prefix = part.map(|part| part + "_").unwrap_or_default();
            let name = pin.name.strip_prefix(&prefix).unwrap_or(&pin.name);
            let signal = Signal::of(name, pin, shown(column));
            match scopes.last_mut() {
                Some(scope) if scope.path == path => scope.signals.push(signal),
                _ => scopes.push(Self {
                    path,
                    signals: vec![signal],
                }),
            }
        }
        scopes
    }
}

/// The part of the machine that a signal is in, or the AXI port of a core that it belongs to; `None` for another pin.
fn part(pin: &Pin) -> Option<String> {
    Some(match pin.place {
        SignalPlace::Top => return port(&pin.name),
        SignalPlace::Control(_) => "control".to_owned(),
        SignalPlace::Cell { node, .. } => format!("cell_{node}"),
        SignalPlace::Head { .. } => "head".to_owned(),
        SignalPlace::Memory { .. } => "memory".to_owned(),
        SignalPlace::Leaf { .. } => "leaf".to_owned(),
        SignalPlace::Engine { engine, .. } => format!("engine_{engine}"),
    })
}

/// The AXI port of a pin, as `s_axis_photons` of `s_axis_photons_tvalid` and `s_axi` of `s_axi_rdata`.
fn port(pin: &str) -> Option<String> {
    let words: Vec<_> = pin.split('_').collect();
    match words[..] {
        ["s" | "m", "axis", port, _, ..] => Some(format!("{}_axis_{port}", words[0])),
        ["s", "axi", _, ..] => Some("s_axi".to_owned()),
        _ => None,
    }
}
