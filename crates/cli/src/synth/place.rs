//! Measures the clock that a machine reaches on an ECP5, placed and routed.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::figures::PlaceRow;
use super::flow::Flow;
use super::netlist::Stage;
use super::tools::Tools;
use super::wrapper::MachinePort;
use super::{Subject, netlist, option_name, path, wrapper};

/// An FPGA that nextpnr knows.
#[derive(Debug, PartialEq, Eq)]
pub struct Device {
    /// The name of the FPGA.
    pub name: &'static str,
    /// The package. It has no effect on the clock, since no path that counts has a pin.
    pub package: &'static str,
    option: &'static str,
}

/// The devices; the first is the one of the committed figures.
pub static DEVICES: [Device; 4] = [
    Device {
        name: "LFE5U-85F",
        package: "CABGA756",
        option: "--85k",
    },
    Device {
        name: "LFE5U-45F",
        package: "CABGA554",
        option: "--45k",
    },
    Device {
        name: "LFE5U-25F",
        package: "CABGA381",
        option: "--25k",
    },
    Device {
        name: "LFE5U-12F",
        package: "CABGA381",
        option: "--12k",
    },
];

/// The slowest speed grade, whose figures `list` shows, and the fastest.
pub const DEFAULT_GRADES: [u32; 2] = [6, 8];

/// The target clock in MHz, higher than any machine reaches, so that no path counts as fast enough.
pub const TARGET_MHZ: u32 = 400;

const NETLIST: &str = "serial.json";

impl Device {
    /// The device of the committed figures.
    pub fn default_one() -> &'static Self {
        &DEVICES[0]
    }

    /// Finds the device of that name.
    pub fn find(name: &str) -> Result<&'static Self> {
        let device = DEVICES.iter().find(|device| device.name == name);
        device.with_context(|| {
            let names = DEVICES.each_ref().map(|device| device.name);
            format!("expected one of {}", names.join(", "))
        })
    }
}

/// A machine that is mapped in its serial wrapper.
pub struct Mapped {
    /// The machine's ports.
    pub ports: Vec<MachinePort>,
    /// Its netlists, wrapper included: as Yosys maps it and after each pass. The last is placed.
    pub stages: Vec<Stage>,
}

/// Maps a machine, whose Verilog `{top}.v` is in the folder, in its serial wrapper, and writes the netlist to
/// be placed into that folder.
pub fn map(tools: &Tools, folder: &Path, subject: &Subject) -> Result<Mapped> {
    let top = &subject.top;
    let attempt = || -> Result<Mapped> {
        // -lib reads only the ports.
        let file = "ports.json";
        tools.yosys(
            folder,
            &format!("read_verilog -lib {top}.v; write_json {file}"),
        )?;
        let ports = wrapper::ports(top, &fs::read_to_string(folder.join(file))?)?;
        fs::write(folder.join(wrapper::FILE), wrapper::around(top, &ports)?)?;
        let flow = Flow::to_place(subject.machine);
        let (read, map) = (subject.read(flow), flow.script(wrapper::TOP));
        let script = format!(
            "{read}; read_verilog {}; {map} -json {NETLIST}",
            wrapper::FILE
        );
        tools.yosys(folder, &script)?;
        let path = folder.join(NETLIST);
        let stages = netlist::stages(&fs::read_to_string(&path)?)?;
        if let Some(placed) = stages.last() {
            fs::write(&path, placed.netlist.to_string())?;
        }
        Ok(Mapped { ports, stages })
    };
    attempt().with_context(|| format!("machine {} in its wrapper", subject.machine.name))
}

/// How nextpnr places.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Placer {
    /// Analytically, with slow paths first: nextpnr's default
    #[default]
    Heap,
    /// By forces between cells: shorter nets, slow paths first only at the end; finds places in full devices
    Static,
}

/// How nextpnr routes.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Router {
    /// Net by net, with slow paths first: nextpnr's default
    #[default]
    Router1,
    /// All nets at once, dearer where they meet; finds routes in full devices
    Router2,
}

/// The device and the options of one placement.
#[derive(Copy, Clone, Debug)]
pub struct Try {
    /// The FPGA to place in.
    pub device: &'static Device,
    /// The speed grade of the FPGA.
    pub speed_grade: u32,
    /// The seed of placement.
    pub seed: u32,
    /// The placer that is used.
    pub placer: Placer,
    /// The router that is used.
    pub router: Router,
}

/// Places and routes the netlist that [`map`] wrote into the folder.
pub fn measure(tools: &Tools, folder: &Path, subject: &Subject, what: Try) -> Result<PlaceRow> {
    let machine = subject.machine.name;
    let Try {
        device,
        speed_grade,
        seed,
        placer,
        router,
    } = what;
    let report = format!("{speed_grade}-{seed}.json");
    // The log can be read while a long run continues.
    let log = format!("{speed_grade}-{seed}.log");
    let (grade, seed_text) = (speed_grade.to_string(), seed.to_string());
    let target = TARGET_MHZ.to_string();
    // The names of the command line are nextpnr's names.
    let (placer_name, router_name) = (option_name(placer), option_name(router));
    let options = [
        "--quiet",
        "--log",
        &log,
        "--json",
        NETLIST,
        device.option,
        "--package",
        device.package,
        "--speed",
        &grade,
        "--freq",
        &target,
        "--seed",
        &seed_text,
        "--placer",
        &placer_name,
        "--router",
        &router_name,
        "--report",
        &report,
        // The target is out of reach on purpose, so missing it is not a failure.
        "--timing-allow-fail",
    ];
    let figures = tools.nextpnr(folder, &options).and_then(|_| {
        // The figures of the routed design; those that nextpnr prints earlier are estimates.
        path::parse(&fs::read_to_string(folder.join(&report))?)
    });
    let (fmax_mhz, path) = figures
        .with_context(|| format!("machine {machine}, speed grade {speed_grade}, seed {seed}"))?;
    let placed = serde_json::from_str(&fs::read_to_string(folder.join(NETLIST))?)?;
    Ok(PlaceRow {
        machine: machine.to_owned(),
        flow: Flow::to_place(subject.machine),
        speed_grade,
        seed,
        placer,
        router,
        fmax_mhz,
        netlist_sha256: Some(netlist::sha256(&placed)?),
        path: Some(path),
    })
}
