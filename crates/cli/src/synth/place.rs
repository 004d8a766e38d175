//! The clock that a machine reaches on an ECP5, placed and routed.

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
    /// Its name.
    pub name: &'static str,
    /// The package it is taken in; it decides nothing, since no pin is on a path that counts.
    pub package: &'static str,
    option: &'static str,
}

/// The devices, the one that figures are committed for first.
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

/// The slowest, which the figures of `list` are of, and the fastest.
pub const DEFAULT_GRADES: [u32; 2] = [6, 8];

/// More than any machine reaches, so that no path of one counts as short enough.
pub const TARGET_MHZ: u32 = 400;

const NETLIST: &str = "serial.json";

impl Device {
    /// The one that figures are committed for.
    pub fn default_one() -> &'static Self {
        &DEVICES[0]
    }

    /// By its name.
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
    /// Its netlist, wrapper included, as Yosys maps it and after each pass; the last is placed.
    pub stages: Vec<Stage>,
}

/// Maps a machine, whose Verilog `{top}.v` is in the folder, in its serial wrapper, and leaves there what is placed.
pub fn map(tools: &Tools, folder: &Path, subject: &Subject) -> Result<Mapped> {
    let top = &subject.top;
    let attempt = || -> Result<Mapped> {
        // -lib reads the ports alone.
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

/// What a machine is placed and routed in, and how.
#[derive(Copy, Clone, Debug)]
pub struct Try {
    /// The FPGA.
    pub device: &'static Device,
    /// Its speed grade.
    pub speed_grade: u32,
    /// The seed of placement.
    pub seed: u32,
    /// How it is placed.
    pub placer: Placer,
    /// How it is routed.
    pub router: Router,
}

/// Places and routes what [`map`] has left in the folder.
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
    // To look into while a long run goes on.
    let log = format!("{speed_grade}-{seed}.log");
    let (grade, seed_text) = (speed_grade.to_string(), seed.to_string());
    let target = TARGET_MHZ.to_string();
    // As on our own command line.
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
        // The target is out of reach by intent, and a missed one is no failure.
        "--timing-allow-fail",
    ];
    let figures = tools.nextpnr(folder, &options).and_then(|_| {
        // Of the routed design; the figures that nextpnr prints before are estimates.
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
