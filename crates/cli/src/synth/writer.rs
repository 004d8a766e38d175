//! Writes rows to their file, machine by machine, so that measurements are stored when a later machine fails
//! or the run is ended.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use anyhow::Result;
use photoncube_spec::find_machine;

use super::Subject;
use super::figures::{AreaRow, AreaSetting, Figured, Group, PlaceRow, PlaceSetting, Row};
use super::plan::{Job, Measured, Plan};
use crate::args::SynthArgs;

/// The treatment of the rows that are not measured anew.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Others {
    /// All rows of today's machines are kept; it is an error if they cannot be combined.
    Keep,
    /// All rows are dropped in the end, because everything is measured anew.
    Drop,
}

/// The writers of both files; `None` where a file is not written.
pub struct Writers {
    areas: Option<Writer<AreaRow>>,
    places: Option<Writer<PlaceRow>>,
}

impl Writers {
    /// The writers of a plan.
    pub fn new(
        args: &SynthArgs,
        plan: &Plan,
        tool_versions: &BTreeMap<String, String>,
    ) -> Result<Self> {
        let (area_groups, place_groups) = plan.groups();
        let (has_areas, has_places) = (!plan.flows.is_empty(), plan.places);
        let areas = || {
            let setting = AreaSetting::new(tool_versions);
            plan.writer(args, setting, &area_groups, plan.flows.len())
        };
        let places = || {
            let setting = PlaceSetting::new(plan.device, tool_versions);
            plan.writer(args, setting, &place_groups, plan.tries().len())
        };
        Ok(Self {
            areas: (args.writes() && has_areas).then(areas).transpose()?,
            places: (args.writes() && has_places).then(places).transpose()?,
        })
    }

    /// Receives a measurement.
    pub fn take(&self, job: &Job<'_>, measured: &Measured) -> Result<()> {
        let (Job::Area(subject, _) | Job::Place(subject, _)) = job;
        match (measured, &self.areas, &self.places) {
            (Measured::Area(row), Some(writer), _) => writer.take(subject, row),
            (Measured::Placed(row, _), _, Some(writer)) => writer.take(subject, row),
            _ => Ok(()),
        }
    }

    /// The paths of the files that are written.
    pub fn paths(&self) -> Vec<String> {
        let areas = self.areas.as_ref().map(Writer::path);
        let places = self.places.as_ref().map(Writer::path);
        areas.into_iter().chain(places).collect()
    }
}

/// Receives rows and writes them.
pub struct Writer<R: Row> {
    folder: PathBuf,
    setting: R::Setting,
    others: Others,
    rows_each: usize,
    state: Mutex<State<R>>,
}

struct State<R: Row> {
    file: Figured<R>,
    pending: BTreeMap<String, Vec<R>>,
}

impl<R: Row> Writer<R> {
    /// A writer to a folder of rows of these groups; each machine has `rows_each` rows.
    pub fn new(
        folder: &Path,
        setting: R::Setting,
        others: Others,
        groups: &BTreeSet<Group>,
        subjects: &[Subject],
        rows_each: usize,
    ) -> Result<Self> {
        let file = match others {
            Others::Keep => {
                let file = kept(folder, &setting)?;
                file.check_update(&setting, groups, subjects)?;
                file
            }
            // A file that cannot be read is written anew.
            Others::Drop => match Figured::<R>::read(folder) {
                Ok(Some(mut file)) if file.setting == setting => {
                    file.rows.retain(|row| groups.contains(&row.group()));
                    file
                }
                _ => Figured::new(setting.clone()),
            },
        };
        let pending = BTreeMap::new();
        Ok(Self {
            folder: folder.to_owned(),
            setting,
            others,
            rows_each,
            state: Mutex::new(State { file, pending }),
        })
    }

    /// Receives a row of a machine, and writes the machine's rows when it is the last of them.
    pub fn take(&self, subject: &Subject, row: &R) -> Result<()> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let State { file, pending } = &mut *state;
        let rows = pending.entry(subject.name.clone()).or_default();
        rows.push(row.clone());
        if rows.len() < self.rows_each {
            return Ok(());
        }
        if self.others == Others::Keep {
            // Another run may have written other machines' rows since.
            *file = kept(&self.folder, &self.setting)?;
        }
        file.update(self.setting.clone(), subject, rows);
        file.write(&self.folder)?;
        Ok(())
    }

    /// The path of the file that is written.
    pub fn path(&self) -> String {
        self.folder.join(R::FILE).display().to_string()
    }
}

/// The file with the rows of today's machines; rows of removed machines are dropped.
fn kept<R: Row>(folder: &Path, setting: &R::Setting) -> Result<Figured<R>> {
    let old = Figured::<R>::read(folder)?;
    let mut file = old.unwrap_or_else(|| Figured::new(setting.clone()));
    file.rows
        .retain(|row| find_machine(&row.group().machine).is_ok());
    Ok(file)
}

#[cfg(test)]
mod tests {
    use fpga_flow::{FLOWS, Flow};

    use super::*;

    fn subject(machine: &str) -> Subject {
        Subject {
            name: machine.to_owned(),
            machine: find_machine(machine).unwrap(),
            design: fpga_flow::Design::default(),
            verilog_sha256: "00".to_owned(),
        }
    }

    fn row(machine: &str, flow: &'static Flow) -> AreaRow {
        AreaRow {
            machine: machine.to_owned(),
            flow,
            figures: BTreeMap::new(),
        }
    }

    /// The first two flows.
    fn flows() -> [&'static Flow; 2] {
        [FLOWS[0], FLOWS[1]]
    }

    /// Writes two rows of a machine, and returns the rows of the file then.
    fn write(folder: &Path, machine: &str, others: Others) -> Vec<AreaRow> {
        let setting = AreaSetting::new(&BTreeMap::new());
        let groups = flows().map(|flow| Group::area(machine, flow)).into();
        let subjects = [subject(machine)];
        let writer = Writer::new(folder, setting, others, &groups, &subjects, 2).unwrap();
        let before = Figured::<AreaRow>::read(folder).unwrap();
        writer
            .take(&subjects[0], &row(machine, flows()[1]))
            .unwrap();
        let half_way = Figured::<AreaRow>::read(folder).unwrap();
        let count = |file: Option<Figured<AreaRow>>| file.map_or(0, |file| file.rows.len());
        assert_eq!(
            count(before),
            count(half_way),
            "half a machine is not written"
        );
        writer
            .take(&subjects[0], &row(machine, flows()[0]))
            .unwrap();
        Figured::<AreaRow>::read(folder).unwrap().unwrap().rows
    }

    #[test]
    fn a_machine_is_written_when_all_of_it_is_there() {
        let folder = tempfile::tempdir().unwrap();
        let of = |machine: &str| flows().map(|flow| row(machine, flow)).to_vec();
        let by_order = |mut rows: Vec<AreaRow>| {
            rows.sort_by_key(Row::order);
            rows
        };
        let rows = write(folder.path(), "paper", Others::Drop);
        assert_eq!(rows, by_order(of("paper")));
        let rows = write(folder.path(), "local", Others::Keep);
        assert_eq!(rows, by_order([of("local"), of("paper")].concat()));
        let rows = write(folder.path(), "paper", Others::Drop);
        assert_eq!(rows, by_order(of("paper")));
    }

    #[test]
    fn runs_at_the_same_time_keep_each_others_rows() {
        let folder = tempfile::tempdir().unwrap();
        let setting = AreaSetting::new(&BTreeMap::new());
        let machines = ["paper", "local"];
        let writers = machines.map(|machine| {
            let groups = [Group::area(machine, flows()[0])].into();
            let (setting, subjects) = (setting.clone(), [subject(machine)]);
            Writer::new(folder.path(), setting, Others::Keep, &groups, &subjects, 1).unwrap()
        });
        for (writer, machine) in writers.iter().zip(machines) {
            let row = row(machine, flows()[0]);
            writer.take(&subject(machine), &row).unwrap();
        }
        let rows = Figured::<AreaRow>::read(folder.path()).unwrap().unwrap();
        let written: BTreeSet<_> = rows.rows.iter().map(|row| row.machine.as_str()).collect();
        assert_eq!(written, machines.into());
    }
}
