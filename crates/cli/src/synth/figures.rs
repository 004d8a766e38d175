//! The files `docs/measured/synthesis.json` and `place.json`: read, brought up to date, checked.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use photoncube_spec::Machine;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::Subject;
use super::cells::Figures;
use super::flow::Flow;
use super::path::CriticalPath;
use super::place::{DEFAULT_GRADES, Device, Placer, Router, TARGET_MHZ};
use crate::files;
use crate::project::ABC9_TARGET_PS;

/// What writes the files.
pub const COMMAND: &str = "photoncube synth";

/// The area of a machine in a flow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AreaRow {
    /// The machine's name.
    pub machine: String,
    /// The flow.
    pub flow: Flow,
    /// Its figures.
    #[serde(flatten)]
    pub figures: Figures,
}

/// The clock of a machine, placed and routed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlaceRow {
    /// The machine's name.
    pub machine: String,
    /// What it was mapped by.
    pub flow: Flow,
    /// The speed grade of the device; a larger one is faster.
    pub speed_grade: u32,
    /// The seed of placement.
    pub seed: u32,
    /// How it was placed.
    #[serde(default)]
    pub placer: Placer,
    /// How it was routed.
    #[serde(default)]
    pub router: Router,
    /// The highest clock.
    pub fmax_mhz: f64,
    /// The digest of the netlist that was placed, see [`netlist::sha256`](super::netlist::sha256); none in rows from
    /// before it was kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub netlist_sha256: Option<String>,
    /// What it is bound by; none where it was not read.
    pub path: Option<CriticalPath>,
}

/// A row of either file.
pub trait Row: Clone + Serialize + DeserializeOwned {
    /// The file's name.
    const FILE: &'static str;
    /// What was the same for all rows: with anything else they could not be compared.
    type Setting: Clone + PartialEq + Serialize + DeserializeOwned;
    /// What is replaced together: the flow, or the flow and the speed grade.
    fn group(&self) -> Group;
    /// Where it stands.
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
    /// Rows of a machine in a flow.
    pub fn area(machine: &str, flow: Flow) -> Self {
        Self {
            machine: machine.to_owned(),
            what: format!("flow {}", flow.name()),
        }
    }

    /// Rows of a machine in a speed grade, with all seeds.
    pub fn place(machine: &str, speed_grade: u32) -> Self {
        Self {
            machine: machine.to_owned(),
            what: format!("speed grade {speed_grade}"),
        }
    }
}

/// How areas were measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AreaSetting {
    /// See [`ABC9_TARGET_PS`].
    pub abc9_target_ps: u32,
    /// The Yosys commands of each flow.
    pub scripts: BTreeMap<Flow, String>,
    /// The tools.
    pub tool_versions: BTreeMap<String, String>,
}

/// How clocks were measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlaceSetting {
    /// The FPGA.
    pub device: String,
    /// Its package.
    pub package: String,
    /// The clock that was asked for.
    pub target_mhz: u32,
    /// See [`ABC9_TARGET_PS`].
    pub abc9_target_ps: u32,
    /// The tools.
    pub tool_versions: BTreeMap<String, String>,
}

impl AreaSetting {
    /// That of this program and these tools.
    pub fn new(tool_versions: &BTreeMap<String, String>) -> Self {
        let mut tool_versions = tool_versions.clone();
        tool_versions.retain(|tool, _| tool.contains("yosys"));
        Self {
            abc9_target_ps: ABC9_TARGET_PS,
            scripts: Flow::all().map(|flow| (flow, flow.script("TOP"))).collect(),
            tool_versions,
        }
    }
}

impl PlaceSetting {
    /// That of this program and these tools.
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
    /// What wrote it.
    pub command: String,
    /// How it was measured.
    #[serde(flatten)]
    pub setting: R::Setting,
    /// The digest of each machine's Verilog that the rows are about.
    pub verilog_sha256: BTreeMap<String, String>,
    /// The figures.
    pub rows: Vec<R>,
}

impl<R: Row> Figured<R> {
    /// A file of nothing yet.
    pub fn new(setting: R::Setting) -> Self {
        Self {
            command: COMMAND.to_owned(),
            setting,
            verilog_sha256: BTreeMap::new(),
            rows: Vec::new(),
        }
    }

    /// The file of a folder; `None` if there is none.
    pub fn read(folder: &Path) -> Result<Option<Self>> {
        let path = folder.join(R::FILE);
        match fs::read_to_string(&path) {
            Ok(text) => {
                let file = serde_json::from_str(&text);
                file.with_context(|| path.display().to_string()).map(Some)
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

    /// Fails where rows of these groups could not stand beside those that the file keeps: long work is
    /// not begun for nothing.
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

    /// Replaces the rows of a machine in the groups that `rows` has, after [`Self::check_update`].
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

    /// What is wrong with the file, in words; `all` says that the subjects are all machines that there
    /// are.
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

/// A chain of engines takes minutes to map and up to an hour to place, and its engines are those of
/// `tile-4`: it is measured where someone has the time, and named where nobody had.
fn is_chain(machine: &Machine) -> bool {
    machine.queries_at_once() > 1
}

fn expected_areas(machine: &Machine) -> Vec<Group> {
    let flows = Flow::all().filter(|_| !is_chain(machine));
    flows.map(|flow| Group::area(machine.name, flow)).collect()
}

/// The machines of which a file has no row.
pub fn without<R: Row>(folder: &Path, subjects: &[Subject]) -> Result<Vec<&'static str>> {
    let rows = Figured::<R>::read(folder)?.map_or(Vec::new(), |file| file.rows);
    let names = subjects.iter().map(|subject| subject.machine.name);
    let is_there = |name: &&str| rows.iter().any(|row| row.group().machine == *name);
    Ok(names.filter(|name| !is_there(name)).collect())
}

/// What is wrong with the files of a folder; nothing is if they are about these machines, with every
/// flow and grade, measured as this program would.
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
            let expected = placed
                .flat_map(|machine| DEFAULT_GRADES.map(|grade| Group::place(machine.name, grade)));
            let expected: Vec<_> = expected.collect();
            faults.extend(file.faults(&expected, subjects, all));
            let flows = subjects
                .iter()
                .map(|s| (s.machine, Flow::to_place(s.machine)));
            for (machine, flow) in flows {
                let mut rows = file.rows.iter().filter(|row| row.machine == machine.name);
                if rows.any(|row| row.flow != flow) {
                    let fault = format!("{} was placed by another flow", machine.name);
                    faults.push(format!("{}: {fault}", PlaceRow::FILE));
                }
            }
            let device = Device::default_one();
            if file.setting != PlaceSetting::new(device, &file.setting.tool_versions) {
                faults.push(format!("{}: its settings are not today's", PlaceRow::FILE));
            }
        }
    }
    Ok(faults)
}

#[cfg(test)]
mod tests;
