//! Groups of photons through the engines of a spatial machine, with the values of all registers, clock by clock.

use anyhow::{Context, Result};
use maud::{Markup, PreEscaped, html};
use photoncube_render::{PhotonMap, Scene, ViewOptions};
use photoncube_spec::{EngineRow, Machine, Pins, SignalPlace};
use serde_json::json;

use super::figures::{Cell, figures};
use super::trace::Example;
use super::{controls, scrolling};
use crate::rows::Rows;

/// The groups of an example.
const GROUPS: usize = 2;

/// The registers of all engines, clock by clock.
pub struct Pipeline {
    /// A row for each register of each engine, in the order of a group's way.
    rows: Vec<Row>,
    /// For each clock, the values of all rows' instances.
    clocks: Vec<Vec<u64>>,
}

/// A register of an engine, with all its instances.
struct Row {
    engine: usize,
    name: &'static str,
    /// The places of its instances among the values of a clock.
    places: std::ops::Range<usize>,
    /// A label for each instance, such as `x 2` for axis x of photon 2; empty for the only one.
    labels: Vec<String>,
}

impl Pipeline {
    /// Runs the golden model of a spatial machine on an example: from the clock that takes the first group to the one
    /// that shows the first result. Every engine has the query of the example.
    ///
    /// # Errors
    /// The golden model refuses the example.
    fn of(machine: &Machine, example: &Example) -> Result<Self> {
        let queries = machine.queries_at_once();
        let run = Rows::of(machine, &example.workload(queries))?;
        let taken = run.clocks_with("query_valid", "query_ready")?;
        let results = run.clocks_with("result_ready", "result_valid")?;
        let first = taken
            .len()
            .checked_sub(queries)
            .context("the golden model took no query")?;
        let of_groups = run.clocks_with("group_valid", "group_ready")?;
        let first = of_groups.into_iter().find(|clock| *clock >= taken[first]);
        let first = first.context("the golden model took no group")?;
        let last = results.into_iter().find(|clock| *clock > first);
        let last = last.context("the golden model gave no result")?;
        let pins = Pins::of(machine);
        let format = machine
            .format()
            .context("the machine has no photon format")?;
        let channels = format.power.channels.names();
        let mut columns = Vec::new();
        let mut rows: Vec<Row> = Vec::new();
        for (column, pin) in pins.observed.iter().enumerate() {
            let SignalPlace::Engine {
                engine,
                register,
                index,
            } = pin.place
            else {
                continue;
            };
            let place = columns.len();
            columns.push(column);
            let EngineRow {
                name, instances, ..
            } = register.row();
            let label = instances.suffix(index, channels).replace('_', " ");
            match rows.last_mut() {
                Some(row) if (row.engine, row.name) == (engine, *name) => {
                    row.places.end = place + 1;
                    row.labels.push(label);
                }
                _ => rows.push(Row {
                    engine,
                    name,
                    places: place..place + 1,
                    labels: vec![label],
                }),
            }
        }
        let of_clock = |row: &Vec<u64>| columns.iter().map(|&column| row[column]).collect();
        Ok(Self {
            rows,
            clocks: run.observed[first..=last].iter().map(of_clock).collect(),
        })
    }

    /// An example of the scene through the engines of the machine.
    ///
    /// # Errors
    /// The machine cannot hold the scene, or no query of the view gathers a photon.
    pub fn of_scene(
        scene: &Scene,
        map: &PhotonMap,
        machine: &Machine,
        view: &ViewOptions,
    ) -> Result<Markup> {
        let example = Example::of(scene, map, machine, view, GROUPS)?;
        Ok(Self::of(machine, &example)?.markup(machine, &example))
    }

    /// The registers with their controls, and all values as a table.
    fn markup(&self, machine: &Machine, example: &Example) -> Markup {
        let engines = 1 + self.rows.iter().map(|row| row.engine).max().unwrap_or(0);
        let data = json!({ "clocks": self.clocks }).to_string();
        html! {
            p {
                (machine.name) ": " (example.photons.len()) " photons of this scene, in groups of "
                (machine.photons_per_iteration()) ", pass "
                @if engines == 1 { "one engine" } @else { (engines) " engines, one after the other" }
                ". A group enters every clock. A row is a register of an engine. Over each of its values stand the axis or channel and \
                 the photon of the group, or the pair of photons, that it belongs to; in a delay, the place. A name that ends in valid, and token, keep, next and swap, are of the control that gives the engine its \
                 query. " (example.in_range) " of the photons are in range."
            }
            div.stepper role="group" aria-label={ "Registers of " (machine.name) ", clock by clock" } {
                (controls())
                p.now aria-live="polite" { "Clock 0" }
                (scrolling(&format!("Registers of {}", machine.name), self.registers()))
                script type="application/json" class="pipeline-data" { (PreEscaped(data)) }
            }
            details {
                summary { "All values of " (machine.name) " as a table" }
                (self.table(machine))
            }
        }
    }

    fn registers(&self) -> Markup {
        html! {
            table.pipeline {
                tbody {
                    @for row in &self.rows {
                        tr {
                            th scope="row" { "engine " (row.engine) ", " (row.name) }
                            @for (place, label) in row.places.clone().zip(&row.labels) {
                                td.number {
                                    @if !label.is_empty() { span.instance { (label.trim_start()) } }
                                    span data-place=(place) { (self.clocks[0][place]) }
                                }
                            }
                        }
                    }
                }
            }
        }
    }

    fn table(&self, machine: &Machine) -> Markup {
        let mut header = vec!["engine, register".to_owned()];
        header.extend((0..self.clocks.len()).map(|clock| format!("clock {clock}")));
        let header: Vec<_> = header.iter().map(String::as_str).collect();
        let rows = self.rows.iter().map(|row| {
            let name = Cell::text(format!("{}, {}", row.engine, row.name));
            let values = self.clocks.iter().map(|clock| {
                let values = clock[row.places.clone()].iter().map(u64::to_string);
                Cell::Number(values.collect::<Vec<_>>().join(" "))
            });
            [name].into_iter().chain(values).collect::<Vec<_>>()
        });
        let caption = format!("The registers of {}, clock by clock", machine.name);
        figures(&caption, &header, &rows.collect::<Vec<_>>(), |_| false)
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::find_machine;

    use super::super::trace::example;
    use super::*;

    /// Each engine counts the photons in range of its query, and all engines have the query of the example.
    #[test]
    fn every_engine_counts_the_photons_in_range() {
        for (name, engines) in [("stream", 1), ("tile-5", 2)] {
            let machine = find_machine(name).unwrap();
            let example = example(machine, 2);
            assert_eq!((example.photons.len(), example.in_range), (8, 7));
            let pipeline = Pipeline::of(machine, &example).unwrap();
            let counts = pipeline
                .rows
                .iter()
                .filter(|row| row.name == "result_count");
            let counts: Vec<_> = counts.collect();
            assert_eq!(counts.len(), engines, "{name}");
            for row in counts {
                let values = pipeline.clocks.iter().map(|clock| clock[row.places.start]);
                assert_eq!(
                    values.max(),
                    Some(example.in_range),
                    "{name}, engine {}",
                    row.engine
                );
            }
            let text = pipeline.markup(machine, &example).into_string();
            let places = pipeline.clocks[0].len();
            assert_eq!(text.matches("data-place=").count(), places, "{name}");
        }
    }
}
