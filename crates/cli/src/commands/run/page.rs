//! The run as a page.

use anyhow::Result;
use maud::{Markup, html};
use photoncube_render::{Rendering, ViewOptions};
use photoncube_spec::{Machine, Spatial};

use super::Report;
use crate::args::RunArgs;
use crate::hardware::digits;
use crate::page::{
    Cell, Page, Pictures, Pipeline, Section, figures, hypercube_section, or_reason, pictures,
    schedule, units,
};
use crate::stages::Traced;
use crate::table::grouped;

/// The most engines whose registers are shown.
const MOST_ENGINES: usize = 2;

/// What the page is about.
pub struct About<'a> {
    pub args: &'a RunArgs,
    pub machine: &'a Machine,
    pub traced: &'a Traced,
    pub view: &'a ViewOptions,
    pub rendering: &'a Rendering,
    pub reference: &'a Rendering,
    pub report: &'a Report,
}

impl About<'_> {
    /// The text of the page.
    pub fn text(&self) -> Result<String> {
        let name = self.traced.scene.name();
        let title = format!(
            "relative error: {} of {name} against f64",
            self.machine.name
        );
        let picture = pictures(&Pictures {
            made_by: self.machine.name,
            picture: &self.rendering.image,
            reference: &self.reference.image,
            title: &title,
        })?;
        let mut sections = vec![
            Section {
                id: "picture",
                title: "The picture".to_owned(),
                body: picture,
            },
            Section {
                id: "comparison",
                title: "The emitted Verilog against the golden model".to_owned(),
                body: self.comparison(),
            },
            hypercube_section(
                &self.traced.scene,
                self.traced.map(),
                self.machine,
                self.view,
            ),
        ];
        sections.extend(self.pipeline());
        sections.push(Section {
            id: "schedule",
            title: "What the cells do, clock by clock".to_owned(),
            body: html! { (units()) (schedule(self.machine)) },
        });
        let page = Page {
            title: format!("{name} on {}", self.machine.name),
            verdict: self.facts(),
            sections,
            command: self.command(),
        };
        Ok(page.text())
    }

    fn facts(&self) -> Vec<Markup> {
        let report = self.report;
        let scene = self.traced.scene.name();
        let mut facts = Vec::new();
        if let Some(fitted) = &report.fitted {
            facts.push(html! {
                strong { (scene) " needs " (fitted.row.bits_per_photon) " bits a photon" } " for an error within "
                (fitted.noise_ratio) " of its own noise: " code { (fitted.row.format) } "."
            });
        }
        facts.push(
            html! { "The machine is " strong { (report.machine) } ", " (self.machine.summary.replace('`', "")) "." },
        );
        facts.push(match (report.time.seconds_per_picture, report.time.fmax_mhz, report.time.speed_grade) {
            (Some(seconds), Some(mhz), Some(grade)) => html! {
                "It takes " strong { (digits(seconds)) " s" } " for this picture of " (grouped(report.query_points)) " queries on an \
                 ECP5, speed grade " (grade) ", at its measured " (format!("{mhz:.0}")) " MHz, while no stream waits."
            },
            _ => html! { "Its clock is not measured, so the time of the picture is not known." },
        });
        let core = report
            .fitted
            .as_ref()
            .and_then(|fitted| fitted.fastest_core.as_ref());
        if let Some(core) = core
            && let (Some(seconds), Some(mhz)) = (core.time.seconds_per_picture, core.time.fmax_mhz)
        {
            facts.push(html! {
                "The fastest core within the bound is " strong { (core.core) } ": " strong { (digits(seconds)) " s" }
                " for this picture at its measured " (format!("{mhz:.0}")) " MHz, the loads of its photons included, by the driver's \
                 forecast."
            });
        }
        facts.push(html! {
            "This computer took " strong { (digits(report.seconds.render_model)) " s" } " for the picture, by the golden model on all cores."
        });
        facts.push(match &report.divergence {
            None => html! {
                "Its emitted Verilog equals the golden model in " strong { (grouped(report.vectors_compared)) " clocks" }
                " with photons of this scene, in every signal. These are the clocks of all simulators together."
            },
            Some(_) => html! { strong { "Its emitted Verilog differs from the golden model" } "; see the comparison." },
        });
        facts.push(html! {
            "The picture differs from the reference in f64 by "
            (format!("{:.3} %", 100.0 * report.distance.rms_relative_error)) " (rms of the relative difference)."
        });
        facts
    }

    fn comparison(&self) -> Markup {
        let rows: Vec<_> = self
            .report
            .devices
            .iter()
            .map(|verdict| {
                vec![
                    Cell::text(&verdict.device),
                    Cell::Number(grouped(verdict.vectors_compared)),
                    Cell::Number(verdict.signals_per_vector.to_string()),
                    Cell::Number(grouped(verdict.results_compared)),
                    Cell::text(&verdict.tool_version),
                    verdict
                        .verilog_sha256
                        .as_deref()
                        .map_or(Cell::None, |digest| {
                            Cell::Text(digest.chars().take(12).collect())
                        }),
                ]
            })
            .collect();
        let header = [
            "device",
            "clocks compared",
            "signals",
            "results compared",
            "tool",
            "SHA-256 of the Verilog",
        ];
        html! {
            @if let Some(divergence) = &self.report.divergence { pre tabindex="0" { (divergence) } }
            (figures("Devices without a difference", &header, &rows, |_| false))
            @for missing in &self.report.devices_not_found {
                p { "Not run: " (missing.device) ". " code { (missing.missing) } " was not found; install it with: " code { (missing.install) } }
            }
        }
    }

    /// The registers of the machine's engines, if they are few enough to look at.
    fn pipeline(&self) -> Option<Section> {
        let machine = self.machine;
        let engines = machine.spatial().map_or(0, Spatial::engines);
        if engines == 0 || engines > MOST_ENGINES || machine.has_memory() {
            return None;
        }
        let body = Pipeline::of_scene(&self.traced.scene, self.traced.map(), machine, self.view);
        Some(Section {
            id: "pipeline",
            title: "Groups of photons through the machine".to_owned(),
            body: or_reason(body),
        })
    }

    /// The command that makes this page, with the values of its defaults.
    fn command(&self) -> String {
        let (args, picture) = (self.args, &self.args.picture);
        let machine = match self.report.fitted {
            Some(_) => format!("--maps {}", args.maps),
            None => format!("--machine {}", self.machine.name),
        };
        let iterations = args
            .iterations
            .map(|iterations| format!(" --iterations {iterations}"));
        format!(
            "photoncube run {} {machine} --photons {} --size {} --samples {} --in-range {} --seed {}{}",
            args.scene,
            picture.photons,
            picture.size,
            picture.samples,
            picture.in_range,
            picture.seed,
            iterations.unwrap_or_default()
        )
    }
}
