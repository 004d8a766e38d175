//! Planted faults. A method of verification plants at least one in each run and must find it, since a method
//! that finds nothing may also be blind.

use std::collections::BTreeSet;
use std::ops::Range;

use photoncube_hdl::{Emitted, Level, emit};
use photoncube_spec::{Machine, find_machine};
use serde::Serialize;
use thiserror::Error;

use crate::device::{DeviceError, DeviceKind, hdl_error};
use crate::stimulus::Source;
use crate::verify::{VerifyError, VerifyOptions, verify_device};

/// A planted fault, and whether the method found it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Control {
    /// The fault, for people.
    pub planted: String,
    /// Whether the method found it.
    #[serde(rename = "control_found")]
    pub found: bool,
}

impl Control {
    /// The control of a verification with a planted fault, which must end with a difference.
    ///
    /// # Errors
    /// The verification ended for another reason.
    pub fn of<T>(
        planted: impl Into<String>,
        ended: Result<T, VerifyError>,
    ) -> Result<Self, VerifyError> {
        let found = match ended {
            Ok(_) => false,
            Err(VerifyError::Diverged(_) | VerifyError::Unknown(_)) => true,
            Err(other) => return Err(other),
        };
        let planted = planted.into();
        Ok(Self { planted, found })
    }
}

/// The controls of one run of a method. There is at least one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Controls(Vec<Control>);

/// The error of a run that planted no fault.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Error)]
#[error("no fault was planted, so the run shows nothing: expected at least one")]
pub struct NoControl;

impl Controls {
    /// One control, or more.
    pub fn new(first: Control, more: impl IntoIterator<Item = Control>) -> Self {
        Self([first].into_iter().chain(more).collect())
    }

    /// The controls that a method gathered in its run.
    ///
    /// # Errors
    /// It gathered none.
    pub fn gathered(all: impl IntoIterator<Item = Control>) -> Result<Self, NoControl> {
        let mut all = all.into_iter();
        Ok(Self::new(all.next().ok_or(NoControl)?, all))
    }

    /// These controls and more.
    #[must_use]
    pub fn with(mut self, more: impl IntoIterator<Item = Control>) -> Self {
        self.0.extend(more);
        self
    }

    /// The number of controls; never 0.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The controls that the method did not find.
    pub fn missed(&self) -> impl Iterator<Item = &Control> {
        self.0.iter().filter(|control| !control.found)
    }
}

/// A fault in the emitted text of a machine.
#[derive(Copy, Clone, Debug)]
pub struct PlantedFault {
    /// The fault, for people.
    pub what: &'static str,
    /// The name of the machine.
    pub machine: &'static str,
    /// The module, without the machine's prefix.
    pub module: &'static str,
    /// Each a text that occurs once in the module, and the text that replaces it.
    pub edits: &'static [(&'static str, &'static str)],
}

impl PlantedFault {
    /// The machine, and its text with the fault.
    ///
    /// # Errors
    /// The machine cannot be emitted, or an edited text does not occur once.
    ///
    /// # Panics
    /// There is no machine of that name.
    pub fn plant(&self) -> Result<(&'static Machine, Emitted), DeviceError> {
        let machine = find_machine(self.machine).expect("a fault names a built-in machine");
        Ok((machine, self.plant_in(machine)?))
    }

    /// The text of another machine with such a module, with the fault.
    fn plant_in(&self, machine: &Machine) -> Result<Emitted, DeviceError> {
        let mut design = emit(machine, Level::Machine).map_err(hdl_error(machine))?;
        let module = format!("{}_{}", machine.module_prefix(), self.module);
        for (from, to) in self.edits {
            design.text = plant(&design.text, &module, from, to)?;
        }
        Ok(design)
    }

    /// The fault and its machine, for people.
    pub fn told(&self) -> String {
        format!("{}: {}", self.machine, self.what)
    }
}

/// Replaces a text that occurs once in the module of that name.
///
/// # Errors
/// There is no such module, or the text does not occur in it once.
pub fn plant(text: &str, module: &str, from: &str, to: &str) -> Result<String, DeviceError> {
    let place = module_place(text, module);
    let body = &text[place.clone()];
    match body.matches(from).count() {
        1 => Ok(text[..place.start].to_owned() + &body.replacen(from, to, 1) + &text[place.end..]),
        times => Err(DeviceError::NotPlanted {
            module: module.to_owned(),
            find: from.to_owned(),
            times,
        }),
    }
}

/// The place of the text of a module; an empty place where there is no such module.
pub(crate) fn module_place(text: &str, module: &str) -> Range<usize> {
    let mut modules = verilog_eval::modules(text).into_iter();
    let module = modules.find(|of| of.name == module);
    module.map_or(0..0, |module| module.place)
}

/// The fault by which a run shows that its comparison finds differences.
const LOST_CARRIES: PlantedFault = PlantedFault {
    what: "the adder loses its carries",
    machine: "paper",
    module: "add_unit",
    edits: &[("a + b", "a ^ b")],
};

/// The controls of a method that compares machines with the golden model: in each device that it compares in, a
/// fault in the text of the smallest machine. rust-hdl has none, since it simulates no text; where it is alone, and
/// where there is no device, the built-in evaluator has the control.
///
/// # Errors
/// The text cannot be made, or a device does not run.
pub fn comparison_controls(
    kinds: impl IntoIterator<Item = DeviceKind>,
) -> Result<Controls, VerifyError> {
    let (machine, design) = LOST_CARRIES.plant()?;
    controls_in(kinds, machine, &design)
}

/// [`comparison_controls`] with the fault in the text of a machine with a user's program.
///
/// # Errors
/// The text cannot be made, or a device does not run.
pub fn program_comparison_controls(
    kinds: impl IntoIterator<Item = DeviceKind>,
    machine: &Machine,
) -> Result<Controls, VerifyError> {
    controls_in(kinds, machine, &LOST_CARRIES.plant_in(machine)?)
}

fn controls_in(
    kinds: impl IntoIterator<Item = DeviceKind>,
    machine: &Machine,
    design: &Emitted,
) -> Result<Controls, VerifyError> {
    let kinds = kinds.into_iter();
    let mut kinds: BTreeSet<_> = kinds.filter(|kind| *kind != DeviceKind::RustHdl).collect();
    let first = kinds.pop_first().unwrap_or(DeviceKind::Text);
    let control = |kind| comparison_control(kind, machine, design);
    let more: Result<Vec<_>, _> = kinds.into_iter().map(control).collect();
    Ok(Controls::new(control(first)?, more?))
}

fn comparison_control(
    kind: DeviceKind,
    machine: &Machine,
    design: &Emitted,
) -> Result<Control, VerifyError> {
    let options = VerifyOptions {
        iterations: 1_000,
        seed: 1,
        source: Source::Random,
    };
    let mut device = kind.open_emitted(design)?;
    let ended = verify_device(machine, device.as_mut(), &options, &|_| ());
    let planted = format!("{}: {}, in {kind}", machine.name, LOST_CARRIES.what);
    Control::of(planted, ended)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_control_of_comparisons_is_found_once_in_each_device() {
        use DeviceKind::{RustHdl, Text};
        for kinds in [vec![], vec![RustHdl], vec![RustHdl, Text, Text]] {
            let controls = comparison_controls(kinds).unwrap();
            assert_eq!((controls.count(), controls.missed().count()), (1, 0));
        }
    }

    #[test]
    fn a_run_without_a_planted_fault_has_no_controls() {
        assert_eq!(Controls::gathered([]), Err(NoControl));
        let control = |found| Control {
            planted: "a fault".to_owned(),
            found,
        };
        let controls = Controls::new(control(true), [control(false)]);
        assert_eq!((controls.count(), controls.missed().count()), (2, 1));
    }

    #[test]
    fn a_text_that_does_not_occur_once_is_refused() {
        let text = "module a(x);\n  b b c\nendmodule\nmodule d(x);\n  c\nendmodule\n";
        let planted = plant(text, "a", "c", "e").unwrap();
        assert_eq!(planted, text.replacen("b c", "b e", 1));
        for (module, from) in [("a", "b"), ("d", "b"), ("e", "c")] {
            assert!(plant(text, module, from, "e").is_err(), "{module} {from}");
        }
    }
}
