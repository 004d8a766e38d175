//! The report as a page.

use std::collections::BTreeSet;

use anyhow::Result;
use maud::{Markup, html};
use photoncube_render::{Engine, ErrorBench, PhotonMap, Scene, ViewOptions};
use photoncube_spec::{Machine, find_machine};

use super::pictures::{BITS, Merit};
use super::row::Row;
use super::verdict::Verdict;
use crate::args::ReportArgs;
use crate::hardware::digits;
use crate::page::{
    Cell, Chart, Page, Pictures, Pipeline, Section, figures, hypercube_section, or_reason,
    pictures, schedule, units,
};
use crate::plots::{Better, Point};
use crate::stages::picture_of_map;
use crate::table::grouped;
use crate::verified;

/// The machine that is shown where no machine is within the bound.
const PAPER: &str = "paper";
/// The machines whose schedules are shown, one of each organisation.
const SCHEDULES: [&str; 3] = [PAPER, "overlap", "stream"];
/// The machines through which groups are stepped: one engine, and a chain of two.
const PIPELINES: [&str; 2] = ["stream", "tile-5"];
/// The name of the error in charts and tables.
const ERROR: &str = "rms error over the scene's own noise";

/// What the page is about.
pub struct About<'a> {
    pub args: &'a ReportArgs,
    pub scene: &'a Scene,
    pub bench: &'a ErrorBench,
    pub rows: &'a [Row],
    pub verdict: &'a Verdict,
    /// The scene's own noise as a part of the radiance, rms.
    pub noise: f64,
}

/// The picture of the page, and what it takes.
struct Picture {
    view: ViewOptions,
    machine: &'static Machine,
    body: Markup,
    /// Photons that the golden model tests for it; `None` where it could not be made.
    photon_tests: Option<u64>,
}

/// Pictures a second, or another figure of a chart.
struct Speed {
    figure: f64,
    /// The slowest and the fastest repeat; `None` where it is not measured on this computer.
    range: Option<[f64; 2]>,
}

impl Speed {
    fn once(figure: f64) -> Self {
        Self {
            figure,
            range: None,
        }
    }
}

impl Picture {
    /// The pictures a second of a CPU core with the golden model of a format.
    fn speed_of_format(&self, row: &Row) -> Option<Speed> {
        let tests = self.photon_tests? as f64;
        let range = [
            row.photon_tests_per_second_low?,
            row.photon_tests_per_second_high?,
        ];
        Some(Speed {
            figure: row.photon_tests_per_second? / tests,
            range: Some(range.map(|speed| speed / tests)),
        })
    }
}

impl About<'_> {
    /// The text of the page.
    pub fn text(&self) -> Result<String> {
        let picture = self.picture()?;
        let size = format!("{} x {}", picture.view.width, picture.view.height);
        let speeds = self.speeds(&picture);
        let figure = format!("pictures of {size} pixels a second");
        let mut sections = vec![
            Section {
                id: "picture",
                title: format!("The picture, by {}", picture.machine.name),
                body: picture.body.clone(),
            },
            Section {
                id: "speed",
                title: "Speed against error".to_owned(),
                body: html! {
                    p {
                        "Machines at their measured clock on an ECP5, by the golden model's clocks while no stream waits. \
                         Cores at theirs, by the driver's forecast of their clocks, in which photons and queries come in over the core's \
                         streams. Photon formats: their golden model on one core of this computer, measured now."
                    }
                    (self.chart(&figure, Better::Larger, &speeds))
                },
            },
            Section {
                id: "bits",
                title: "Bits of a photon against the noise of the scene".to_owned(),
                body: html! {
                    p {
                        "The scene's own noise is " (format!("{:.2} %", 100.0 * self.noise)) " of the radiance, rms over "
                        (self.args.maps) " maps of at least " (grouped(self.args.photons)) " photons each. An error of 1 would be as large."
                    }
                    (self.chart("bits of a stored photon", Better::Smaller, &self.points(&BITS)))
                },
            },
        ];
        let (scene, map) = (self.scene, self.map());
        sections.push(hypercube_section(
            scene,
            map,
            picture.machine,
            &picture.view,
        ));
        sections.push(self.pipelines(&picture));
        sections.push(Section {
            id: "schedules",
            title: "What the cells do, clock by clock".to_owned(),
            body: html! {
                (units())
                @for name in SCHEDULES {
                    @if let Ok(machine) = find_machine(name) { (schedule(machine)) }
                }
            },
        });
        sections.push(Section {
            id: "machines",
            title: "All machines and formats".to_owned(),
            body: self.table(&speeds, &figure),
        });
        sections.push(self.verification()?);
        let page = Page {
            title: format!(
                "{}: the precision it needs, and the machines",
                self.scene.name()
            ),
            verdict: self.facts(&picture),
            sections,
            command: self.command(),
        };
        Ok(page.text())
    }

    fn map(&self) -> &PhotonMap {
        &self.bench.maps()[0]
    }

    /// The machine that makes the picture: the smallest within the bound, if there is one.
    fn machine(&self) -> Result<&'static Machine> {
        let name = self.verdict.smallest_machine.as_deref();
        Ok(find_machine(name.unwrap_or(PAPER))?)
    }

    fn picture(&self) -> Result<Picture> {
        let machine = self.machine()?;
        let view = super::picture_view(self.args);
        let made = self.rendered(machine, &view);
        let photon_tests = made.as_ref().ok().map(|(_, tests)| *tests);
        Ok(Picture {
            view,
            machine,
            body: or_reason(made.map(|(body, _)| body)),
            photon_tests,
        })
    }

    /// The pictures, and the photons that the golden model tests for that of the machine.
    fn rendered(&self, machine: &Machine, view: &ViewOptions) -> Result<(Markup, u64)> {
        let render = |engine, what| picture_of_map(self.scene, self.map(), engine, view, what);
        let reference = render(Engine::F64, "rendering, f64")?;
        let rendering = render(Engine::from(machine), "rendering, model")?;
        let title = format!("relative error: {} of {}", machine.name, self.scene.name());
        let body = pictures(&Pictures {
            made_by: machine.name,
            picture: &rendering.image,
            reference: &reference.image,
            title: &title,
        })?;
        Ok((body, rendering.stats.photon_tests))
    }

    /// The answer: what the scene needs, the smallest and the fastest machine, and a CPU core beside them.
    fn facts(&self, picture: &Picture) -> Vec<Markup> {
        let bound = self.args.noise_ratio;
        let size = format!("{} x {}", picture.view.width, picture.view.height);
        let mut facts = Vec::new();
        match (&self.verdict.format, self.verdict.bits_per_photon) {
            (Some(format), Some(bits)) => facts.push(html! {
                strong { (self.scene.name()) " needs at most " (bits) " bits a photon" } ": " code { (format) }
                " has the fewest of the formats listed below, alone or in a machine, whose error is within " (bound)
                " of the scene's own noise."
            }),
            _ => facts.push(html! {
                strong { "No listed format is precise enough" } " for " (self.scene.name()) ": none has an error within "
                (bound) " of the scene's own noise."
            }),
        }
        if let Some(name) = &self.verdict.smallest_machine {
            let row = self.rows.iter().find(|row| row.name == *name);
            let area = row.and_then(Row::lut4_equivalents);
            facts.push(html! {
                "The smallest machine within that bound is " strong { (name) }
                @if let Some(area) = area { ", " (area) " LUT4 equivalents" } "."
            });
        }
        if let Some(name) = &self.verdict.fastest_machine {
            let row = self.rows.iter().find(|row| row.name == *name);
            let time = row.map(|row| row.hardware.time.clone()).unwrap_or_default();
            facts.push(html! {
                "The fastest is " strong { (name) }
                @match (time.seconds_per_picture, time.fmax_mhz, time.speed_grade) {
                    (Some(seconds), Some(mhz), Some(grade)) => {
                        ": " strong { (digits(seconds)) " s" } " for a picture of " (size) " pixels on an ECP5, speed grade "
                        (grade) ", at its measured " (format!("{mhz:.0}")) " MHz, "
                        @if row.is_some_and(Row::is_core) { "the loads of its photons included, by the driver's forecast." }
                        @else { "while no stream waits." }
                    }
                    _ => { "; its clock is not measured." }
                }
            });
        }
        if let Some((format, speed)) = self.on_cpu(picture) {
            facts.push(html! {
                "One CPU core of this computer takes " strong { (digits(speed.figure.recip())) " s" } " for the photon tests of that \
                 picture, by the golden model of " code { (format) }
                @if let Some([slowest, fastest]) = speed.range {
                    " (" (digits(fastest.recip())) " to " (digits(slowest.recip())) " s in repeats)"
                }
                "."
            });
        }
        facts.push(
            html! { code { "photoncube fit" } " searches all formats, so it may find fewer bits." },
        );
        facts
    }

    /// The pictures a second of a CPU core, in the format of the fewest bits of those whose speed was measured.
    fn on_cpu(&self, picture: &Picture) -> Option<(&str, Speed)> {
        let formats = self
            .rows
            .iter()
            .filter(|row| row.is_format() && row.within_bound);
        let row = formats.min_by_key(|row| row.bits_per_photon)?;
        Some((&row.name, picture.speed_of_format(row)?))
    }

    /// For each row, its pictures a second.
    fn speeds(&self, picture: &Picture) -> Vec<Option<Speed>> {
        let speed = |row: &Row| match row.is_format() {
            true => picture.speed_of_format(row),
            false => row.pictures_per_second().map(Speed::once),
        };
        self.rows.iter().map(speed).collect()
    }

    fn points(&self, merit: &Merit) -> Vec<Option<Speed>> {
        let point = |row| (merit.of)(row).map(Speed::once);
        self.rows.iter().map(point).collect()
    }

    fn chart(&self, figure: &str, better: Better, values: &[Option<Speed>]) -> Markup {
        let rows = self.rows.iter().zip(values);
        let point = |(row, value): (&Row, &Option<Speed>)| -> Option<Point> {
            let value = value.as_ref()?;
            Some(Point {
                figure_range: value.range,
                ..row.point(value.figure)?
            })
        };
        let points: Vec<_> = rows.filter_map(point).collect();
        Chart {
            figure,
            error: ERROR,
            better,
            bound: self.args.noise_ratio,
            noise: 1.0,
            points: &points,
        }
        .markup()
    }

    fn pipelines(&self, picture: &Picture) -> Section {
        let of = |name| {
            let machine = find_machine(name)?;
            Pipeline::of_scene(self.scene, self.map(), machine, &picture.view)
        };
        Section {
            id: "pipelines",
            title: "Groups of photons through engines".to_owned(),
            body: html! { @for name in PIPELINES { (or_reason(of(name))) } },
        }
    }

    fn table(&self, speeds: &[Option<Speed>], figure: &str) -> Markup {
        let rows: Vec<_> = self
            .rows
            .iter()
            .zip(speeds)
            .map(|(row, speed)| cells(row, speed.as_ref()))
            .collect();
        let header = [
            "name",
            "kind",
            "bits a photon",
            "error / noise",
            "within the bound",
            "LUT4 equivalents (of a core beside its DSP blocks)",
            "clock, MHz",
            figure,
        ];
        let caption = format!(
            "Machines and formats; those above the bound of {} are grey",
            self.args.noise_ratio
        );
        figures(&caption, &header, &rows, |row| !self.rows[row].within_bound)
    }

    /// What was verified of the machines that the verdict names.
    fn verification(&self) -> Result<Section> {
        let named = [
            &self.verdict.smallest_machine,
            &self.verdict.fastest_machine,
        ];
        let is_named = |name: &str| named.iter().any(|other| other.as_deref() == Some(name));
        let table = verified::committed()?;
        let names: BTreeSet<_> = named.into_iter().flatten().collect();
        let is_recorded = |name: &str| table.lines.iter().any(|line| line.machine == name);
        let unrecorded = names.iter().filter(|name| !is_recorded(name));
        let lines = table.lines.iter().filter(|line| is_named(&line.machine));
        let rows: Vec<_> = lines
            .map(|line| {
                let digest = line
                    .verilog_sha256
                    .as_deref()
                    .map(|digest| digest.chars().take(12).collect());
                vec![
                    Cell::text(&line.machine),
                    Cell::text(line.heading()),
                    Cell::Number(grouped(line.volume)),
                    Cell::text(&line.unit),
                    Cell::text(&line.result),
                    digest.map_or(Cell::None, Cell::Text),
                ]
            })
            .collect();
        let header = [
            "machine",
            "method",
            "volume",
            "of",
            "outcome",
            "SHA-256 of the Verilog",
        ];
        Ok(Section {
            id: "verification",
            title: "How the machines of the verdict are verified".to_owned(),
            body: html! {
                @if !rows.is_empty() { (figures("Recorded results", &header, &rows, |_| false)) }
                @for name in unrecorded { p { "Nothing is recorded of " strong { (name) } "." } }
            },
        })
    }

    fn command(&self) -> String {
        let args = self.args;
        format!(
            "photoncube report {} --photons {} --in-range {} --maps {} --noise-ratio {} --size {} --picture-size {} --seed {}",
            args.scenes[0],
            args.photons,
            args.in_range[0],
            args.maps,
            args.noise_ratio,
            args.size,
            args.picture_size,
            args.seed
        )
    }
}

fn cells(row: &Row, speed: Option<&Speed>) -> Vec<Cell> {
    let clock = row.hardware.time.fmax_mhz;
    vec![
        Cell::text(&row.name),
        Cell::text(row.kind),
        Cell::Number(row.bits_per_photon.to_string()),
        Cell::number(row.error_over_noise().map(|error| format!("{error:.4}"))),
        Cell::text(match (&row.cannot, row.within_bound) {
            (Some(_), _) => "cannot hold the scene",
            (None, true) => "yes",
            (None, false) => "no",
        }),
        Cell::number(
            row.lut4_equivalents()
                .or(row.hardware.lut4_equivalents_with_dsp)
                .map(|area| area.to_string()),
        ),
        Cell::number(clock.map(|mhz| format!("{mhz:.0}"))),
        Cell::number(speed.map(|speed| digits(speed.figure))),
    ]
}
