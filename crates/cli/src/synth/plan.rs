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
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

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
    lists_endpoints: bool,
    /// How many run at the same time.
    pub jobs: usize,
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
            lists_endpoints: args.endpoints,
            jobs: args.jobs.map_or_else(cores, usize::from),
        }
    }

    /// All measurements, in the order in which they are made: the areas, then the placements.
    pub fn measurements(&self) -> Vec<Job<'_>> {
        let areas = self.subjects.iter().flat_map(|subject| {
            let flows = self.flows.iter();
            flows.map(move |&flow| Job::Area(subject, flow))
        });
        let tries = self.tries();
        let places = self.subjects.iter().flat_map(|subject| {
            let tries = tries.iter();
            tries.map(move |what| Job::Place(subject, *what))
        });
        areas.chain(places).collect()
    }

    /// The expected time of a measurement on a free core, in ms.
    pub fn ms(&self, job: &Job<'_>) -> u64 {
        match job {
            Job::Area(subject, _) => Size::of(subject).map_ms(),
            Job::Place(subject, _) => Size::of(subject).place_ms(self.device),
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
            lists_endpoints: self.lists_endpoints,
        };
        grades
            .flat_map(|&grade| self.seeds.clone().map(move |seed| with(grade, seed)))
            .collect()
    }

    /// Announces the expected duration of these measurements, from the areas that were measured before.
    pub fn announce(&self, jobs: &[Job<'_>]) {
        let mapped = self.mapped(jobs);
        let mapping = mapped.iter().map(|subject| Size::of(subject).map_ms());
        let ms = mapping.sum::<u64>() + jobs.iter().map(|job| self.ms(job)).sum::<u64>();
        let areas = jobs.iter().filter(|job| matches!(job, Job::Area(..)));
        let areas = areas.count();
        eprintln!(
            "{} syntheses and {} placements, {} at a time: about {} min on free cores",
            areas + mapped.len(),
            jobs.len() - areas,
            self.jobs,
            ms.div_ceil(60_000 * self.jobs as u64)
        );
    }

    /// The subjects of the placements among these measurements, which are mapped first.
    fn mapped<'a>(&self, jobs: &[Job<'a>]) -> Vec<&'a Subject> {
        let places = jobs.iter().filter_map(|job| match job {
            Job::Area(..) => None,
            Job::Place(subject, _) => Some(*subject),
        });
        let mut mapped: Vec<_> = places.collect();
        mapped.dedup_by(|subject, other| subject.name == other.name);
        mapped
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

    /// Maps each machine of a placement in its wrapper.
    pub fn map(&self, tools: &Tools, scratch: &Path, jobs: &[Job<'_>]) -> Result<()> {
        let mapped = self.mapped(jobs);
        let bar = progress::bar("mappings", mapped.len() as u64);
        let pool = ThreadPoolBuilder::new().num_threads(self.jobs).build()?;
        pool.install(|| {
            mapped.par_iter().try_for_each(|subject| {
                let machine = subject.name.as_str();
                let (folder, target) = (scratch.join(machine), self.target(subject));
                map(tools.yosys(), &folder, &subject.design, &target)
                    .with_context(|| format!("machine {machine} in its wrapper"))?;
                bar.inc(1);
                anyhow::Ok(())
            })
        })?;
        bar.finish_and_clear();
        Ok(())
    }

    /// Makes a measurement. For a placement the machine is mapped.
    pub fn measure(&self, tools: &Tools, scratch: &Path, job: &Job<'_>) -> Result<Measured> {
        match *job {
            Job::Area(subject, flow) => {
                Ok(Measured::Area(self.area(tools, scratch, subject, flow)?))
            }
            Job::Place(subject, what) => self.place(tools, scratch, subject, &what),
        }
    }

    fn area(
        &self,
        tools: &Tools,
        scratch: &Path,
        subject: &Subject,
        flow: &'static Flow,
    ) -> Result<AreaRow> {
        let machine = subject.name.as_str();
        let folder = scratch.join(machine);
        let figures = area(
            tools.yosys(),
            &folder,
            &subject.design,
            flow,
            self.abc9_target_ps,
        );
        Ok(AreaRow {
            machine: machine.to_owned(),
            flow,
            figures: figures.with_context(|| format!("machine {machine} in flow {flow}"))?,
        })
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
    ) -> Result<Measured> {
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
            Placed::TooLarge(resources) => return Ok(Measured::TooLarge(used(false, resources))),
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
            netlist_sha256: routed.netlist_sha256,
            path: Some(routed.path),
            endpoints: routed.endpoints,
        };
        Ok(Measured::Placed(
            Box::new(row),
            used(true, routed.resources),
        ))
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

/// A measurement to make.
#[derive(Copy, Clone)]
pub enum Job<'a> {
    /// The area in a flow.
    Area(&'a Subject, &'static Flow),
    /// The clock, placed and routed.
    Place(&'a Subject, Try),
}

/// A measurement that was made.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Measured {
    /// The area in a flow.
    Area(AreaRow),
    /// The clock, and what the machine takes of the device.
    Placed(Box<PlaceRow>, DeviceUse),
    /// The device cannot hold the machine.
    TooLarge(DeviceUse),
}

/// The resources of the device that a machine needs.
#[derive(Clone, Debug, Serialize, Deserialize)]
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
