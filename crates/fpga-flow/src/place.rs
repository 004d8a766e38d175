//! Places and routes a design in an FPGA, and measures the clock that it reaches.

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::design::Design;
use crate::devices::Device;
use crate::error::{Result, read, write};
use crate::flow::Flow;
use crate::netlist::{Netlist, Port, Stage};
use crate::path::{self, CriticalPath, Endpoints};
use crate::tools::Tools;
use crate::utilisation::{Resource, resources};
use crate::wrapper;
use crate::yosys::Yosys;

const NETLIST: &str = "serial.json";

/// A design that is mapped in its serial wrapper.
#[derive(Clone, Debug)]
pub struct Mapped {
    /// The ports of the design, without its clock.
    pub ports: Vec<Port>,
    /// Its netlists, wrapper included: as Yosys maps it and after each pass. The last is placed.
    pub stages: Vec<Stage>,
}

/// The device and the flow that a design is mapped to before it is placed.
#[derive(Copy, Clone, Debug)]
pub struct Target {
    /// The FPGA, whose family has the passes.
    pub device: &'static Device,
    /// The flow, see [`Device::flow`].
    pub flow: &'static Flow,
    /// See [`Flow::script`], in picoseconds.
    pub abc9_target_ps: u32,
}

/// Maps a design, whose files are in the folder (see [`Design::write`]), in its serial wrapper, and writes the
/// netlist to be placed into that folder. The design has one clock, an input `clock`.
///
/// # Errors
/// Yosys fails, or the design's ports do not fit the wrapper.
pub fn map(yosys: &Yosys, folder: &Path, design: &Design, target: &Target) -> Result<Mapped> {
    let (top, flow) = (&design.top, target.flow);
    // -lib reads only the ports.
    let file = "ports.json";
    yosys.run(
        folder,
        &format!("read_verilog -lib {top}.v; write_json {file}"),
    )?;
    let ports = wrapper::ports(top, &Netlist::parse(&read(&folder.join(file))?)?)?;
    write(&folder.join(wrapper::FILE), &wrapper::around(top, &ports)?)?;
    let script = format!(
        "{}; read_verilog {}; {} -json {NETLIST}",
        design.read_commands(flow.family),
        wrapper::FILE,
        flow.script(wrapper::TOP, target.abc9_target_ps)
    );
    yosys.run(folder, &script)?;
    let path = folder.join(NETLIST);
    let mapped = Netlist::parse(&read(&path)?)?;
    let stages = target.device.family().stages(mapped);
    if let Some(placed) = stages.last() {
        write(&path, &placed.netlist.to_string())?;
    }
    Ok(Mapped { ports, stages })
}

/// How nextpnr places.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Placer {
    /// Analytically, with slow paths first: nextpnr's default.
    #[default]
    Heap,
    /// By forces between cells: shorter nets, slow paths first only at the end; finds places in full devices.
    Static,
}

impl Placer {
    /// nextpnr's name of the placer.
    pub fn name(self) -> &'static str {
        match self {
            Self::Heap => "heap",
            Self::Static => "static",
        }
    }
}

/// How nextpnr routes.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Router {
    /// Net by net, with slow paths first: nextpnr's default.
    #[default]
    Router1,
    /// All nets at once, dearer where they meet; finds routes in full devices.
    Router2,
}

impl Router {
    /// nextpnr's name of the router.
    pub fn name(self) -> &'static str {
        match self {
            Self::Router1 => "router1",
            Self::Router2 => "router2",
        }
    }
}

/// The device and the options of one placement.
#[derive(Copy, Clone, Debug)]
pub struct Try {
    /// The FPGA to place in.
    pub device: &'static Device,
    /// The speed grade; `None` where the device has only one.
    pub speed_grade: Option<u32>,
    /// The seed of placement.
    pub seed: u32,
    /// The placer that is used.
    pub placer: Placer,
    /// The router that is used.
    pub router: Router,
    /// The clock that nextpnr is asked for, in MHz. One that no design reaches makes every path count as slow.
    pub target_mhz: u32,
    /// Whether to list the registers at which slow paths end.
    pub lists_endpoints: bool,
}

/// The result of one placement.
#[derive(Clone, Debug)]
pub enum Placed {
    /// The design is placed and routed.
    Routed(Box<Routed>),
    /// The design needs more than the device has: all resources that it needs.
    TooLarge(Vec<Resource>),
}

/// A design that is placed and routed.
#[derive(Clone, Debug)]
pub struct Routed {
    /// The highest clock in MHz.
    pub fmax_mhz: f64,
    /// The path that limits it.
    pub path: CriticalPath,
    /// The registers at which slow paths end, if they were asked for.
    pub endpoints: Option<Endpoints>,
    /// The digest of the netlist that was placed, see [`Netlist::sha256`].
    pub netlist_sha256: String,
    /// The resources of the device that are used.
    pub resources: Vec<Resource>,
}

/// Places and routes the netlist that [`map`] wrote into the folder.
///
/// # Errors
/// nextpnr fails for another reason than the size of the design.
pub fn place(tools: &Tools, folder: &Path, what: &Try) -> Result<Placed> {
    let grade = what.speed_grade.unwrap_or(0);
    let name = format!("{grade}-{}", what.seed);
    let (report, log) = (format!("{name}.json"), format!("{name}.log"));
    let said = tools.nextpnr(folder, &options(what, &report, &log));
    // The log has the resources as soon as the netlist is packed, also where placing then fails.
    let resources = resources(&read(&folder.join(&log)).unwrap_or_default());
    match said {
        Err(_) if resources.iter().any(Resource::is_lacking) => Ok(Placed::TooLarge(resources)),
        Err(error) => Err(error),
        Ok(_) => {
            // The figures of the routed design; those that nextpnr prints earlier are estimates.
            let report = read(&folder.join(&report))?;
            let rules = &what.device.placement().path;
            let (fmax_mhz, path) = path::parse(&report, rules)?;
            let endpoints = what
                .lists_endpoints
                .then(|| path::endpoints(&report, rules));
            let placed = Netlist::parse(&read(&folder.join(NETLIST))?)?;
            Ok(Placed::Routed(Box::new(Routed {
                fmax_mhz,
                path,
                endpoints: endpoints.transpose()?,
                netlist_sha256: placed.sha256()?,
                resources,
            })))
        }
    }
}

/// nextpnr's options for a placement.
fn options(what: &Try, report: &str, log: &str) -> Vec<String> {
    let grade = what.speed_grade.map(|grade| grade.to_string());
    let grade = grade.as_deref().map(|grade| ["--speed", grade]);
    let (target, seed) = (what.target_mhz.to_string(), what.seed.to_string());
    let device = what.device;
    // The log can be read while a long run continues.
    let first = ["--quiet", "--log", log, "--json", NETLIST, device.option];
    let last = [
        "--package",
        device.package,
        "--freq",
        &target,
        "--seed",
        &seed,
        "--placer",
        what.placer.name(),
        "--router",
        what.router.name(),
        "--report",
        report,
        // The target may be out of reach on purpose, so missing it is not a failure.
        "--timing-allow-fail",
    ];
    let details = what.lists_endpoints.then_some("--detailed-timing-report");
    let all = first.iter().chain(grade.iter().flatten()).chain(&last);
    let all = all.chain(&details);
    all.map(|option| (*option).to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn attempt(device: &str, speed_grade: Option<u32>) -> Try {
        Try {
            device: Device::find(device).unwrap(),
            speed_grade,
            seed: 2,
            placer: Placer::Static,
            router: Router::default(),
            target_mhz: 400,
            lists_endpoints: false,
        }
    }

    #[test]
    fn only_a_device_with_speed_grades_is_given_one() {
        let of = |what: &Try| options(what, "r", "l").join(" ");
        let ecp5 = of(&attempt("LFE5U-85F", Some(8)));
        assert!(
            ecp5.contains("--85k --speed 8 --package CABGA756"),
            "{ecp5}"
        );
        assert!(
            ecp5.contains("--seed 2 --placer static --router router1"),
            "{ecp5}"
        );
        let ice40 = of(&attempt("up5k", None));
        assert!(ice40.contains("--up5k --package sg48"), "{ice40}");
        let listing = Try {
            lists_endpoints: true,
            ..attempt("up5k", None)
        };
        assert_eq!(of(&listing), ice40 + " --detailed-timing-report");
    }

    #[test]
    fn the_names_are_those_in_json() {
        for placer in [Placer::Heap, Placer::Static] {
            assert_eq!(serde_json::to_value(placer).unwrap(), placer.name());
        }
        for router in [Router::Router1, Router::Router2] {
            assert_eq!(serde_json::to_value(router).unwrap(), router.name());
        }
    }

    /// A program that writes the log of a nextpnr that finds no place, and fails.
    #[cfg(unix)]
    #[test]
    fn a_design_that_is_too_large_is_a_result_and_another_failure_an_error() {
        use std::fs;

        use crate::program::write_program;

        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("nextpnr-ice40");
        fs::write(folder.path().join("yosys"), "").unwrap();
        let placed = |used: u64| {
            let log =
                format!("Info: Device utilisation:\\nInfo:  ICESTORM_LC: {used}/ 5280 99%\\n");
            let text = format!("#!/bin/sh\nprintf '{log}' >0-2.log\necho no place; exit 1\n");
            write_program(&path, &text);
            let what = attempt("up5k", None);
            let tools = Tools::find(Some(folder.path()), Some(what.device.family())).unwrap();
            place(&tools, folder.path(), &what)
        };
        let Placed::TooLarge(resources) = placed(5281).unwrap() else {
            panic!("it was placed");
        };
        assert_eq!(resources[0].lacking, 1);
        let error = placed(5280).unwrap_err().to_string();
        assert!(error.contains("no place"), "{error}");
    }
}
