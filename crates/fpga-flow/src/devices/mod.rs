//! The families of FPGAs, one module each.
//!
//! A family is a row of data: its flows (Yosys commands, cells, area terms) and, where nextpnr places designs
//! in it, its devices with their packages and speed grades, the passes over its netlists, and the names by
//! which its cells are known on a critical path. A new family is a module with these rows, an entry in
//! [`FAMILIES`] and one in [`FLOWS`] for each flow.

mod cyclone5;
pub mod ecp5;
mod gates;
mod gowin;
mod ice40;
mod lut4;
mod max10;

use crate::error::{Result, unexpected};
use crate::flow::Flow;
use crate::netlist::{Netlist, Pass, Stage, stages};
use crate::path::PathRules;
use crate::program::Program;

/// All flows, in the order of their tables.
pub static FLOWS: [&Flow; 9] = [
    &lut4::FLOW,
    &ecp5::WITH_DSP,
    &ecp5::WITHOUT_DSP,
    &gates::FLOW,
    &cyclone5::FLOW,
    &max10::FLOW,
    &ice40::HX,
    &ice40::UP,
    &gowin::FLOW,
];

/// The families of FPGAs. The flows `lut4` and `gates` are of none.
pub static FAMILIES: [&Family; 5] = [
    &ecp5::FAMILY,
    &cyclone5::FAMILY,
    &max10::FAMILY,
    &ice40::FAMILY,
    &gowin::FAMILY,
];

/// A family of FPGAs.
#[derive(Debug)]
pub struct Family {
    /// The name, which its flows have in [`Flow::family`].
    pub name: &'static str,
    /// The name in reports.
    pub title: &'static str,
    /// How designs are placed; `None` where only the area is measured.
    pub placement: Option<Placement>,
}

/// How nextpnr places designs in a family.
#[derive(Debug)]
pub struct Placement {
    /// The devices; the first is the default one.
    pub devices: &'static [Device],
    pub(crate) program: &'static Program,
    pub(crate) passes: &'static [Pass],
    pub(crate) path: PathRules,
}

/// An FPGA in which designs are placed.
#[derive(Debug)]
pub struct Device {
    /// The name of the FPGA.
    pub name: &'static str,
    /// The package. It has no effect on the clock, since no path that counts has a pin.
    pub package: &'static str,
    /// The speed grades, the slowest first; empty where the device has only one.
    pub grades: &'static [u32],
    /// The flow that maps a design to be placed, and the one that also uses DSP blocks.
    pub(crate) flows: [&'static Flow; 2],
    /// nextpnr's option for the device.
    pub(crate) option: &'static str,
}

impl Family {
    /// The netlist that Yosys mapped, then the result of each pass of the family over it. The last one is placed.
    pub fn stages(&self, mapped: Netlist) -> Vec<Stage> {
        let passes = self.placement.as_ref();
        stages(mapped, passes.map_or(&[], |placement| placement.passes))
    }

    /// The flows that map designs to the family.
    pub fn flows(&self) -> impl Iterator<Item = &'static Flow> {
        FLOWS.into_iter().filter(|flow| flow.family == self.name)
    }
}

/// All devices in which designs are placed, with their families.
pub fn devices() -> impl Iterator<Item = (&'static Family, &'static Placement, &'static Device)> {
    let placements = FAMILIES.into_iter();
    let placements = placements.filter_map(|family| Some((family, family.placement.as_ref()?)));
    placements.flat_map(|(family, placement)| {
        let devices = placement.devices.iter();
        devices.map(move |device| (family, placement, device))
    })
}

impl Device {
    /// Finds a device by its name, such as `LFE5U-85F`, or by nextpnr's, such as `up5k`, in capitals or not.
    ///
    /// # Errors
    /// There is none; the error has all names.
    pub fn find(name: &str) -> Result<&'static Self> {
        let is_it = |device: &Self| {
            let names = [device.name, device.option.trim_start_matches('-')];
            names.iter().any(|known| known.eq_ignore_ascii_case(name))
        };
        let mut all = devices().map(|(_, _, device)| device);
        all.find(|device| is_it(device)).ok_or_else(|| {
            let names = devices().map(|(_, _, device)| {
                let short = device.option.trim_start_matches('-');
                format!("{} ({short})", device.name)
            });
            let names: Vec<_> = names.collect();
            unexpected(format!("expected one of {}", names.join(", ")))
        })
    }

    /// The family of the device.
    pub fn family(&self) -> &'static Family {
        self.place().0
    }

    pub(crate) fn placement(&self) -> &'static Placement {
        self.place().1
    }

    fn place(&self) -> (&'static Family, &'static Placement) {
        let found = devices().find(|(_, _, device)| device.name == self.name);
        let (family, placement, _) = found.expect("a device is of a family");
        (family, placement)
    }

    /// The flow that maps a design to be placed in the device. It uses DSP blocks only if asked for, and only
    /// where the family's flow for them is verified.
    pub fn flow(&self, with_dsp: bool) -> &'static Flow {
        self.flows[usize::from(with_dsp)]
    }

    /// Fails where the device has no such speed grade.
    ///
    /// # Errors
    /// The grade is none of [`Self::grades`]; the error has them.
    pub fn check_grade(&self, grade: u32) -> Result<()> {
        if self.grades.contains(&grade) {
            return Ok(());
        }
        let grades: Vec<_> = self.grades.iter().map(u32::to_string).collect();
        let expected = match grades.is_empty() {
            true => "none, since the device has only one".to_owned(),
            false => grades.join(", "),
        };
        Err(unexpected(format!(
            "found the speed grade {grade} of {}, expected {expected}",
            self.name
        )))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_flow_is_of_a_family_that_is_listed() {
        let names: BTreeSet<_> = FAMILIES.iter().map(|family| family.name).collect();
        assert_eq!(names.len(), FAMILIES.len());
        for flow in FLOWS {
            assert!(
                flow.family == "any" || names.contains(flow.family),
                "{flow}"
            );
            let terms = flow.terms.iter().map(|(figure, _)| figure);
            let of_cells = flow.cells.iter().filter_map(|(_, figure)| figure.as_ref());
            for figure in terms.chain(of_cells) {
                assert!(flow.figures.contains(figure), "{flow}: {}", figure.key());
            }
        }
        for family in FAMILIES {
            assert!(family.flows().next().is_some(), "{}", family.name);
        }
    }

    #[test]
    fn a_device_is_found_by_either_name_and_placed_by_a_flow_of_its_family() {
        for (family, _, device) in devices() {
            let short = device.option.trim_start_matches('-');
            for name in [device.name, &device.name.to_lowercase(), short] {
                assert_eq!(Device::find(name).unwrap().name, device.name);
            }
            assert_eq!(device.family().name, family.name);
            for with_dsp in [false, true] {
                assert_eq!(device.flow(with_dsp).family, family.name);
            }
            assert!(device.check_grade(99).is_err());
            for &grade in device.grades {
                device.check_grade(grade).unwrap();
            }
        }
        let error = Device::find("iCE40").unwrap_err().to_string();
        assert!(error.contains("LFE5U-85F") && error.contains("iCE40UP5K"));
    }
}
