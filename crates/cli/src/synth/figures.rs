//! Reads, updates and checks the files `docs/measured/synthesis.json` and `place.json`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use fpga_flow::{CriticalPath, Device, Endpoints, FLOWS, Figures, Flow, Placer, Router};
use photoncube_spec::Machine;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::{DEFAULT_DEVICE, DEFAULT_GRADES, Subject, TARGET_MHZ, flow_to_place};
use crate::files;
use crate::project::ABC9_TARGET_PS;

/// The command that writes the files.
pub const COMMAND: &str = "photoncube synth";

/// The families whose flows are in the committed figures; `any` is for flows of none.
const RECORDED_FAMILIES: [&str; 4] = ["any", "ecp5", "cyclonev", "max10"];

/// The flows of the committed figures.
pub fn recorded_flows() -> impl Iterator<Item = &'static Flow> {
    let flows = FLOWS.into_iter();
    flows.filter(|flow| RECORDED_FAMILIES.contains(&flow.family))
}

/// The area of a machine in a flow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AreaRow {
    /// The machine's name.
    pub machine: String,
    /// The flow that mapped the machine.
    pub flow: &'static Flow,
    /// The figures of the area.
    #[serde(flatten)]
    pub figures: Figures,
}

/// The clock of a machine, placed and routed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlaceRow {
    /// The machine's name.
    pub machine: String,
    /// The flow that mapped the machine.
    pub flow: &'static Flow,
    /// The speed grade of the device, of which a larger one is faster; `None` where it has only one.
    pub speed_grade: Option<u32>,
    /// The seed of placement.
    pub seed: u32,
    /// The placer of the machine.
    #[serde(default)]
    pub placer: Placer,
    /// The router of the machine.
    #[serde(default)]
    pub router: Router,
    /// The highest clock in MHz.
    pub fmax_mhz: f64,
    /// The digest of the netlist that was placed, see [`Netlist::sha256`](fpga_flow::Netlist::sha256).
    pub netlist_sha256: String,
    /// The critical path; `None` where it was not read.
    pub path: Option<CriticalPath>,
    /// The registers at which slow paths end; `None` where they were not asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub endpoints: Option<Endpoints>,
}

/// A row of either file.
pub trait Row: Clone + Serialize + DeserializeOwned {
    /// The name of the file.
    const FILE: &'static str;
    /// The conditions of all rows of a file. Rows of other conditions could not be compared.
    type Setting: Clone + PartialEq + Serialize + DeserializeOwned;
    /// The group of rows that is replaced together: by flow, or by flow and speed grade.
    fn group(&self) -> Group;
    /// The sort key of the row.
    fn order(&self) -> (String, Group, u32);
}

/// Rows of one machine that are measured together.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Group {
    /// The machine's name.
    pub machine: String,
    /// The flow's name, or the speed grade.
    pub what: String,
}

impl Group {
    /// The rows of a machine in a flow.
    pub fn area(machine: &str, flow: &Flow) -> Self {
        Self {
            machine: machine.to_owned(),
            what: format!("flow {flow}"),
        }
    }

    /// The rows of a machine in a speed grade, with all seeds.
    pub fn place(machine: &str, speed_grade: Option<u32>) -> Self {
        let grade = speed_grade.map(|grade| format!("speed grade {grade}"));
        Self {
            machine: machine.to_owned(),
            what: grade.unwrap_or_else(|| "the only speed grade".to_owned()),
        }
    }
}

/// The conditions of the area measurements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AreaSetting {
    /// See [`ABC9_TARGET_PS`].
    pub abc9_target_ps: u32,
    /// The Yosys commands of each flow.
    pub scripts: BTreeMap<&'static Flow, String>,
    /// The versions of the tools.
    pub tool_versions: BTreeMap<String, String>,
}

/// The conditions of the clock measurements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlaceSetting {
    /// The name of the FPGA.
    pub device: String,
    /// The package of the FPGA.
    pub package: String,
    /// The clock that the tools were given as a target, in MHz.
    pub target_mhz: u32,
    /// See [`ABC9_TARGET_PS`].
    pub abc9_target_ps: u32,
    /// The versions of the tools.
    pub tool_versions: BTreeMap<String, String>,
}

impl AreaSetting {
    /// The conditions of this program with these tools.
    pub fn new(tool_versions: &BTreeMap<String, String>) -> Self {
        let mut tool_versions = tool_versions.clone();
        tool_versions.retain(|tool, _| tool.contains("yosys"));
        Self {
            abc9_target_ps: ABC9_TARGET_PS,
            scripts: recorded_flows()
                .map(|flow| (flow, flow.script("TOP", ABC9_TARGET_PS)))
                .collect(),
            tool_versions,
        }
    }
}

impl PlaceSetting {
    /// The conditions of this program with these tools.
    pub fn new(device: &Device, tool_versions: &BTreeMap<String, String>) -> Self {
        Self {
            device: device.name.to_owned(),
            package: device.package.to_owned(),
            target_mhz: TARGET_MHZ,
            abc9_target_ps: ABC9_TARGET_PS,
            tool_versions: tool_versions.clone(),
        }
    }
}

impl Row for AreaRow {
    const FILE: &'static str = "synthesis.json";
    type Setting = AreaSetting;
    fn group(&self) -> Group {
        Group::area(&self.machine, self.flow)
    }
    fn order(&self) -> (String, Group, u32) {
        (self.machine.clone(), self.group(), 0)
    }
}

impl Row for PlaceRow {
    const FILE: &'static str = "place.json";
    type Setting = PlaceSetting;
    fn group(&self) -> Group {
        Group::place(&self.machine, self.speed_grade)
    }
    fn order(&self) -> (String, Group, u32) {
        (self.machine.clone(), self.group(), self.seed)
    }
}

/// A file of rows.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(bound = "")]
pub struct Figured<R: Row> {
    /// The command that wrote the file.
    pub command: String,
    /// The conditions of the measurements.
    #[serde(flatten)]
    pub setting: R::Setting,
    /// The digest of each machine's Verilog that the rows are about.
    pub verilog_sha256: BTreeMap<String, String>,
    /// The measured figures.
    pub rows: Vec<R>,
}

impl<R: Row> Figured<R> {
    /// A file without rows.
    pub fn new(setting: R::Setting) -> Self {
        Self {
            command: COMMAND.to_owned(),
            setting,
            verilog_sha256: BTreeMap::new(),
            rows: Vec::new(),
        }
    }

    /// Reads the file in a folder; `None` if it does not exist.
    pub fn read(folder: &Path) -> Result<Option<Self>> {
        let path = folder.join(R::FILE);
        match fs::read_to_string(&path) {
            Ok(text) => {
                let file = serde_json::from_str(&text);
                let what_to_do = || {
                    format!(
                        "{} has rows that this version does not read; move it away, and `{COMMAND}` measures all machines anew",
                        path.display()
                    )
                };
                file.with_context(what_to_do).map(Some)
            }
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error).with_context(|| path.display().to_string()),
        }
    }

    /// Writes the file to a folder.
    pub fn write(&self, folder: &Path) -> Result<PathBuf> {
        let path = folder.join(R::FILE);
        let text = serde_json::to_string_pretty(self)? + "\n";
        files::write(&path, text.as_bytes())?;
        Ok(path)
    }

    /// Fails where rows of these groups could not be combined with the rows that the file keeps, so that long
    /// work is not begun in vain.
    pub fn check_update(
        &self,
        setting: &R::Setting,
        groups: &BTreeSet<Group>,
        subjects: &[Subject],
    ) -> Result<()> {
        let kept: Vec<_> = self.kept(groups).collect();
        if kept.is_empty() {
            return Ok(());
        }
        if self.setting != *setting {
            bail!(
                "{} was measured with other tools or settings; `{COMMAND}` measures all machines anew",
                R::FILE
            );
        }
        for Subject {
            machine,
            verilog_sha256,
            ..
        } in subjects
        {
            let changed = self.verilog_sha256.get(machine.name) != Some(verilog_sha256);
            let left = kept.iter().find(|row| row.group().machine == machine.name);
            if let Some(row) = left.filter(|_| changed) {
                bail!(
                    "{} has {} of `{}` with other Verilog; measure all of that machine: `{COMMAND} \
                     --update --machine {}`",
                    R::FILE,
                    row.group().what,
                    machine.name,
                    machine.name
                );
            }
        }
        Ok(())
    }

    /// Replaces the rows of a machine in the groups of `rows`, after [`Self::check_update`].
    pub fn update(&mut self, setting: R::Setting, subject: &Subject, rows: &[R]) {
        let groups = rows.iter().map(Row::group).collect();
        let kept: Vec<_> = self.kept(&groups).cloned().collect();
        self.rows = kept.into_iter().chain(rows.iter().cloned()).collect();
        self.rows.sort_by_key(Row::order);
        self.setting = setting;
        let machine = subject.machine.name.to_owned();
        let digest = subject.verilog_sha256.clone();
        self.verilog_sha256.insert(machine, digest);
        let machines: BTreeSet<_> = self.rows.iter().map(|row| row.group().machine).collect();
        self.verilog_sha256
            .retain(|machine, _| machines.contains(machine));
    }

    fn kept<'a>(&'a self, groups: &'a BTreeSet<Group>) -> impl Iterator<Item = &'a R> {
        self.rows
            .iter()
            .filter(|row| !groups.contains(&row.group()))
    }

    /// The faults of the file, as text. `all` states that the subjects are all existing machines.
    pub fn faults(&self, expected: &[Group], subjects: &[Subject], all: bool) -> Vec<String> {
        let mut faults = Vec::new();
        let found: BTreeSet<_> = self.rows.iter().map(Row::group).collect();
        for subject in subjects {
            let name = subject.machine.name;
            match self.verilog_sha256.get(name) {
                None if expected.iter().any(|group| group.machine == name) => {
                    faults.push(format!("{name} is not measured"));
                }
                None => {}
                Some(digest) if *digest != subject.verilog_sha256 => {
                    faults.push(format!("{name} was measured with other Verilog"));
                }
                Some(_) => {
                    let missing = expected.iter().filter(|group| group.machine == name);
                    let missing = missing.filter(|group| !found.contains(*group));
                    let missing: Vec<_> = missing.map(|group| group.what.as_str()).collect();
                    if !missing.is_empty() {
                        faults.push(format!("{name} has no {}", missing.join(", ")));
                    }
                }
            }
        }
        let known = |name: &String| subjects.iter().any(|s| s.machine.name == name);
        let measured = found.into_iter().map(|group| group.machine);
        let mut measured: BTreeSet<_> = measured.collect();
        measured.extend(self.verilog_sha256.keys().cloned());
        if all {
            let gone = measured.iter().filter(|name| !known(name));
            faults.extend(gone.map(|name| format!("{name} is no machine any more")));
        }
        let file = |fault| format!("{}: {fault}", R::FILE);
        faults.into_iter().map(file).collect()
    }
}

/// Whether the machine is a long chain of engines. Such a chain takes minutes to map and up to an hour to
/// place, and its engines are those of `tile-4`. It need not be measured; chains that were not are named.
fn is_chain(machine: &Machine) -> bool {
    machine.queries_at_once() > 1
}

fn expected_areas(machine: &Machine) -> Vec<Group> {
    let flows = recorded_flows().filter(|_| !is_chain(machine));
    flows.map(|flow| Group::area(machine.name, flow)).collect()
}

/// The machines without rows in a file.
pub fn without<R: Row>(folder: &Path, subjects: &[Subject]) -> Result<Vec<&'static str>> {
    let rows = Figured::<R>::read(folder)?.map_or(Vec::new(), |file| file.rows);
    let names = subjects.iter().map(|subject| subject.machine.name);
    let is_there = |name: &&str| rows.iter().any(|row| row.group().machine == *name);
    Ok(names.filter(|name| !is_there(name)).collect())
}

/// The faults of the files in a folder. There are none if the files are about these machines, with every flow
/// and grade, measured under this program's conditions.
pub fn faults(folder: &Path, subjects: &[Subject], all: bool) -> Result<Vec<String>> {
    let mut faults = Vec::new();
    match Figured::<AreaRow>::read(folder)? {
        None => faults.push(format!("{} is missing", AreaRow::FILE)),
        Some(file) => {
            let machines = subjects.iter().map(|subject| subject.machine);
            let expected: Vec<_> = machines.flat_map(expected_areas).collect();
            faults.extend(file.faults(&expected, subjects, all));
            if file.setting != AreaSetting::new(&file.setting.tool_versions) {
                faults.push(format!("{}: its scripts are not today's", AreaRow::FILE));
            }
        }
    }
    match Figured::<PlaceRow>::read(folder)? {
        None => faults.push(format!("{} is missing", PlaceRow::FILE)),
        Some(file) => {
            let machines = subjects.iter().map(|subject| subject.machine);
            let placed = machines.filter(|machine| !is_chain(machine));
            let expected = placed.flat_map(|machine| {
                DEFAULT_GRADES.map(|grade| Group::place(machine.name, Some(grade)))
            });
            let expected: Vec<_> = expected.collect();
            faults.extend(file.faults(&expected, subjects, all));
            let device = Device::find(DEFAULT_DEVICE)?;
            let flows = subjects
                .iter()
                .map(|s| (s.machine, flow_to_place(s.machine, device)));
            for (machine, flow) in flows {
                let mut rows = file.rows.iter().filter(|row| row.machine == machine.name);
                if rows.any(|row| row.flow != flow) {
                    let fault = format!("{} was placed by another flow", machine.name);
                    faults.push(format!("{}: {fault}", PlaceRow::FILE));
                }
            }
            if file.setting != PlaceSetting::new(device, &file.setting.tool_versions) {
                faults.push(format!("{}: its settings are not today's", PlaceRow::FILE));
            }
        }
    }
    Ok(faults)
}

#[cfg(test)]
mod tests;
