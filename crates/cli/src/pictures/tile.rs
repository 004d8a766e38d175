//! A tile: a chain of engines behind a head.

use anyhow::{Context, Result};
use photoncube_spec::{Machine, Spatial};

use super::canvas::{Canvas, Face, Kind, Place};

/// The size of the drawing.
pub const SIZE: [i32; 2] = [346, 340];

const TOP: i32 = 34;
const HEIGHT: i32 = 160;
const HEAD: Place = Place::new(58, TOP, 46, HEIGHT);
/// An engine's width, and the distance of two of them.
const ENGINE: [i32; 2] = [40, 58];
/// The heights of the streams of queries, photons and results.
const STREAMS: [i32; 3] = [TOP + 28, TOP + 78, TOP + 138];

/// Draws the head, the engines with their queries, and the three streams.
///
/// # Errors
/// The machine is no chain of engines.
pub fn tile(canvas: &mut Canvas, machine: &Machine) -> Result<()> {
    let spatial = machine.spatial().context("a tile is a spatial machine")?;
    let engines = spatial.engines() as i32;
    canvas.text(Face::Head, [0, 14], SIZE[0], "A tile: a chain of engines");
    let [queries, photons, results] = STREAMS;
    for (name, y) in ["queries", "photons", "results"].into_iter().zip(STREAMS) {
        canvas.text(Face::Note, [0, y - 8], 52, name);
    }
    canvas.labelled(Kind::Plain, HEAD, &[(Face::Label, "head")]);
    let left = |engine: i32| HEAD.right() + 16 + engine * ENGINE[1];
    for engine in 0..engines {
        let place = Place::new(left(engine), TOP, ENGINE[0], HEIGHT);
        canvas.rectangle(Kind::Unit, place);
        let query = Place::new(place.x + 5, queries - 13, ENGINE[0] - 10, 26);
        canvas.labelled(
            Kind::Register,
            query,
            &[(Face::Code, &format!("q{engine}"))],
        );
        canvas.centred(
            Face::Label,
            [place.x, photons + 32],
            place.width,
            &format!("e{engine}"),
        );
        let from = match engine {
            0 => HEAD.right(),
            _ => left(engine - 1) + ENGINE[0] - 5,
        };
        canvas.arrow(&format!("M{from} {queries} H{}", query.x - 1));
        canvas.arrow(&format!(
            "M{} {results} H{}",
            place.x,
            if engine == 0 {
                HEAD.right() + 1
            } else {
                left(engine - 1) + ENGINE[0] + 1
            }
        ));
        canvas.rectangle(Kind::Register, Place::new(place.x - 12, photons - 8, 6, 16));
    }
    canvas.arrow(&format!("M0 {queries} H{}", HEAD.x - 1));
    canvas.arrow(&format!("M0 {photons} H{}", HEAD.x - 1));
    canvas.arrow(&format!("M{} {results} H2", HEAD.x));
    canvas.arrow(&format!(
        "M{} {photons} H{}",
        HEAD.right(),
        left(engines - 1) + ENGINE[0] - 8
    ));
    canvas.lines(
        Face::Note,
        [0, TOP + HEIGHT + 24],
        SIZE[0],
        &remarks(machine, spatial),
    );
    Ok(())
}

fn remarks(machine: &Machine, spatial: &Spatial) -> Vec<String> {
    [
        format!(
            "{}: an engine e is {} cells and holds one query q.",
            machine.name,
            Spatial::ENGINE_CELLS
        ),
        format!(
            "{} photons a clock enter at the head and pass",
            Spatial::LANES
        ),
        "engine after engine, through pipeline registers.".to_owned(),
        "So each photon is read once and meets every query.".to_owned(),
        format!(
            "{} clocks after a batch's last group its first result",
            spatial.latency_clocks()
        ),
        format!(
            "leaves the head; each further one comes {} clocks",
            Spatial::RESULT_CLOCKS
        ),
        "later, in the order of the queries.".to_owned(),
    ]
    .into()
}

/// The lines of a group's way through an engine: clock, cells, units and step.
pub fn way(canvas: &mut Canvas, machine: &Machine, spatial: &Spatial, width: i32) {
    canvas.text(
        Face::Head,
        [0, 14],
        width,
        "A group's way through an engine",
    );
    let columns = [0, 60, 140, 220];
    for (x, heading) in columns
        .into_iter()
        .zip(["clock", "cells", "units", "value"])
    {
        canvas.text(Face::Note, [x, 36], 60, heading);
    }
    let mut before = None;
    for (index, row) in spatial.flow(machine.squarer).into_iter().enumerate() {
        let y = 54 + WAY_LINE * index as i32;
        let clock = row.clock.to_string();
        let clock = if before == Some(row.clock) {
            ""
        } else {
            &clock
        };
        before = Some(row.clock);
        for (x, text, room) in [
            (columns[0], clock, 60),
            (columns[1], row.cells, 80),
            (columns[2], row.units, 80),
            (columns[3], row.step, width - columns[3]),
        ] {
            canvas.text(Face::Code, [x, y], room, text);
        }
        if row.registered {
            canvas.rectangle(Kind::Register, Place::new(columns[0] + 30, y - 9, 6, 12));
        }
    }
}

/// The distance of two lines of a way.
pub const WAY_LINE: i32 = 18;
