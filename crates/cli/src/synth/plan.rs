//! Plans measurements and runs them on several cores.

use std::collections::BTreeSet;
use std::fs;
use std::ops::RangeInclusive;
use std::path::Path;
use std::thread::available_parallelism;

use anyhow::{Context, Result};
use fpga_flow::{
    Device, Flow, Placed, Placer, Resource, Router, Target, Tools, Try, area, map, place,
};
use indicatif::ProgressBar;
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use serde::Serialize;

use super::figures::{AreaRow, Group, PlaceRow, Row};
use super::writer::{Others, Writer};
use super::{Subject, TARGET_MHZ, flow_to_place};
use crate::args::SynthArgs;
use crate::{measured, progress};

/// The measurements to make.
pub struct Plan {
    /// The machines to measure.
    pub subjects: Vec<Subject>,
    /// The flows in which areas are counted.
    pub flows: Vec<&'static Flow>,
    /// Whether machines are placed.
    pub places: bool,
    /// The FPGA to place in.
    pub device: &'static Device,
    grades: Vec<Option<u32>>,
    seeds: RangeInclusive<u32>,
    abc9_target_ps: u32,
    placer: Placer,
    router: Router,
    jobs: usize,
}

impl Plan {
    /// The plan of the arguments, for these machines.
    pub fn new(args: &SynthArgs, subjects: Vec<Subject>) -> Self {
        let all = args.device.grades;
        let grades: BTreeSet<Option<u32>> = match (&args.grades[..], all) {
            ([], [slowest, .., fastest]) => [Some(*slowest), Some(*fastest)].into(),
            ([], _) => [all.first().copied()].into(),
            (named, _) => named.iter().copied().map(Some).collect(),
        };
        let cores = || available_parallelism().map_or(1, usize::from);
        Self {
            subjects,
            flows: args.area_flows(),
            places: args.places(),
            device: args.device,
            grades: grades.into_iter().collect(),
            seeds: args.all_seeds(),
            abc9_target_ps: args.map_for,
            placer: args.placer,
            router: args.router,
            jobs: args.jobs.map_or_else(cores, usize::from),
        }
    }

    /// The groups of rows that the plan produces.
    pub fn groups(&self) -> (BTreeSet<Group>, BTreeSet<Group>) {
        let names = || self.subjects.iter().map(|subject| subject.name.as_str());
        let areas = names().flat_map(|name| self.flows.iter().map(move |&f| Group::area(name, f)));
        let grades = self.grades.iter().filter(|_| self.places);
        let places = names().flat_map(|name| grades.clone().map(move |&g| Group::place(name, g)));
        (areas.collect(), places.collect())
    }

    /// The placements of one machine.
    pub fn tries(&self) -> Vec<Try> {
        let grades = self.grades.iter().filter(|_| self.places);
        let with = |speed_grade, seed| Try {
            device: self.device,
            speed_grade,
            seed,
            placer: self.placer,
            router: self.router,
            target_mhz: TARGET_MHZ,
        };
        grades
            .flat_map(|&grade| self.seeds.clone().map(move |seed| with(grade, seed)))
            .collect()
    }

    /// Announces the expected duration, from the areas that were measured before.
    pub fn announce(&self) {
        let (runs, tries) = (self.flows.len() as u64, self.tries().len() as u64);
        let of = |subject: &Subject| {
            let size = Size::of(subject);
            let mapping = u64::from(self.places) * size.map_ms();
            runs * size.map_ms() + mapping + tries * size.place_ms(self.device)
        };
        let ms: u64 = self.subjects.iter().map(of).sum();
        let machines = self.subjects.len() as u64;
        eprintln!(
            "{} syntheses and {} placements, {} at a time: about {} min on free cores",
            machines * (runs + u64::from(self.places)),
            machines * tries,
            self.jobs,
            ms.div_ceil(60_000 * self.jobs as u64)
        );
    }

    /// Writes each machine's Verilog to its own folder, where the tools find it.
    pub fn write_verilog(&self, scratch: &Path) -> Result<()> {
        for subject in &self.subjects {
            let folder = scratch.join(&subject.name);
            fs::create_dir(&folder)?;
            subject.design.write(&folder)?;
        }
        Ok(())
    }

    /// Measures each machine in each flow.
    pub fn areas(
        &self,
        tools: &Tools,
        scratch: &Path,
        writer: Option<&Writer<AreaRow>>,
    ) -> Result<Vec<AreaRow>> {
        let flows = |subject| self.flows.iter().map(move |&flow| (subject, flow));
        let work: Vec<_> = self.subjects.iter().flat_map(flows).collect();
        let work = work
            .into_iter()
            .map(|(subject, flow)| (subject, Size::of(subject).map_ms(), flow));
        self.in_parallel("areas", work.collect(), |subject, flow| {
            let machine = subject.name.as_str();
            let folder = scratch.join(machine);
            let figures = area(
                tools.yosys(),
                &folder,
                &subject.design,
                flow,
                self.abc9_target_ps,
            );
            let row = AreaRow {
                machine: machine.to_owned(),
                flow,
                figures: figures.with_context(|| format!("machine {machine} in flow {flow}"))?,
            };
            writer.map_or(Ok(()), |writer| writer.take(subject, &row))?;
            Ok(row)
        })
    }

    /// Maps each machine in its wrapper, then places it in each speed grade with each seed. Machines that the
    /// device cannot hold have no rows.
    pub fn placements(
        &self,
        tools: &Tools,
        scratch: &Path,
        writer: Option<&Writer<PlaceRow>>,
    ) -> Result<(Vec<PlaceRow>, Vec<DeviceUse>)> {
        if !self.places {
            return Ok((Vec::new(), Vec::new()));
        }
        let all = self.subjects.iter();
        let mappings = all.clone().map(|s| (s, Size::of(s).map_ms(), ()));
        self.in_parallel("mappings", mappings.collect(), |subject, ()| {
            let machine = subject.name.as_str();
            let target = self.target(subject);
            map(
                tools.yosys(),
                &scratch.join(machine),
                &subject.design,
                &target,
            )
            .with_context(|| format!("machine {machine} in its wrapper"))
            .map(|_| ())
        })?;
        let tries = self.tries();
        let each = |subject| tries.iter().map(move |&what| (subject, what));
        let work: Vec<_> = all.flat_map(each).collect();
        let work = work
            .into_iter()
            .map(|(subject, what)| (subject, Size::of(subject).place_ms(self.device), what));
        let placed = self.in_parallel("placements", work.collect(), |subject, what| {
            let (row, used) = self.place(tools, scratch, subject, &what)?;
            if let (Some(writer), Some(row)) = (writer, &row) {
                writer.take(subject, row)?;
            }
            Ok((row, used))
        })?;
        let (rows, mut uses): (Vec<_>, Vec<_>) = placed.into_iter().unzip();
        // A machine needs as much in every speed grade and with every seed.
        uses.dedup_by(|used, other| used.machine == other.machine);
        Ok((rows.into_iter().flatten().collect(), uses))
    }

    fn target(&self, subject: &Subject) -> Target {
        Target {
            device: self.device,
            flow: flow_to_place(subject.machine, self.device),
            abc9_target_ps: self.abc9_target_ps,
        }
    }

    /// Places one machine once.
    fn place(
        &self,
        tools: &Tools,
        scratch: &Path,
        subject: &Subject,
        what: &Try,
    ) -> Result<(Option<PlaceRow>, DeviceUse)> {
        let machine = subject.name.as_str();
        let placed = place(tools, &scratch.join(machine), what).with_context(|| {
            let group = Group::place(machine, what.speed_grade).what;
            format!("machine {machine}, {group}, seed {}", what.seed)
        })?;
        let used = |fits, resources| DeviceUse {
            machine: machine.to_owned(),
            fits,
            resources,
        };
        let routed = match placed {
            Placed::TooLarge(resources) => return Ok((None, used(false, resources))),
            Placed::Routed(routed) => routed,
        };
        let row = PlaceRow {
            machine: machine.to_owned(),
            flow: self.target(subject).flow,
            speed_grade: what.speed_grade,
            seed: what.seed,
            placer: what.placer,
            router: what.router,
            fmax_mhz: routed.fmax_mhz,
            netlist_sha256: Some(routed.netlist_sha256),
            path: Some(routed.path),
        };
        Ok((Some(row), used(true, routed.resources)))
    }

    /// Does the work in parallel with a progress bar; each item has an estimated time.
    fn in_parallel<I: Copy + Send + Sync, R: Send>(
        &self,
        what: &'static str,
        work: Vec<(&Subject, u64, I)>,
        run: impl Fn(&Subject, I) -> Result<R> + Sync,
    ) -> Result<Vec<R>> {
        let bar: ProgressBar = progress::bar(what, work.iter().map(|(_, ms, _)| ms).sum());
        let pool = ThreadPoolBuilder::new().num_threads(self.jobs).build()?;
        let results = pool.install(|| {
            let results = work.par_iter().map(|&(subject, ms, item)| {
                let result = run(subject, item);
                bar.inc(ms);
                result
            });
            results.collect()
        });
        bar.finish_and_clear();
        results
    }

    /// A writer of rows of these groups; each machine has `rows_each` rows.
    pub fn writer<R: Row>(
        &self,
        args: &SynthArgs,
        setting: R::Setting,
        groups: &BTreeSet<Group>,
        rows_each: usize,
    ) -> Result<Writer<R>> {
        let others = match args.update {
            true => Others::Keep,
            false => Others::Drop,
        };
        Writer::new(
            &args.out,
            setting,
            others,
            groups,
            &self.subjects,
            rows_each,
        )
    }
}

/// The resources of the device that a machine needs.
#[derive(Debug, Serialize)]
pub struct DeviceUse {
    /// The machine's name.
    pub machine: String,
    /// Whether the device has enough of everything.
    pub fits: bool,
    /// The resources that the machine needs, wrapper included.
    pub resources: Vec<Resource>,
}

impl DeviceUse {
    /// The resources that the device lacks, in words; empty where the machine fits.
    pub fn lacking(&self) -> String {
        let lacking = self
            .resources
            .iter()
            .filter(|resource| resource.is_lacking());
        let words = lacking.map(|of| {
            format!(
                "{} {} needed, {} available, {} lacking",
                of.needed, of.resource, of.available, of.lacking
            )
        });
        words.collect::<Vec<_>>().join(", ")
    }
}

/// The size of a machine, which determines the time of the tools.
struct Size {
    lut4_equivalents: u64,
}

impl Size {
    /// The size that was measured before; otherwise that of the largest of the paper's machines.
    fn of(subject: &Subject) -> Self {
        const UNKNOWN: u64 = 8000;
        let measured = measured::lut4_equivalents(&subject.name).unwrap_or(None);
        Self {
            lut4_equivalents: measured.unwrap_or(UNKNOWN),
        }
    }

    fn map_ms(&self) -> u64 {
        1000 + 3 * self.lut4_equivalents / 2
    }

    /// nextpnr-ice40 took 60 s for `paper`, which nextpnr-ecp5 places in 20 s.
    fn place_ms(&self, device: &Device) -> u64 {
        let ms_each = match device.family().name {
            "ecp5" => 7,
            _ => 20,
        };
        ms_each * self.lut4_equivalents
    }
}
