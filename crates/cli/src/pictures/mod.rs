//! Pictures of the hardware, drawn from the data of the spec and from the emitted text. Only the places on the canvas are
//! chosen by hand; every name, width and number is the machine's.

mod canvas;
mod cell;
mod core;
mod hypercube;
mod tile;
mod timing;
mod timing_core;
mod wave;

use anyhow::{Context, Result};
use photoncube_spec::{CORES, Core, Machine, SEQUENTIAL, find_machine};

use self::canvas::{Canvas, Face};
pub use self::timing::timing;
pub use self::timing_core::timing_of_core;
pub use self::wave::{Diagram, picture};

/// A picture of the pages.
pub struct Picture {
    /// The name of its file, without folder and ending.
    pub name: &'static str,
    /// The SVG text.
    pub text: String,
}

/// The machines whose cell and whose tile are drawn.
const CELL: &str = "paper";
const TILE: &str = "tile-6";
/// The distance of the drawings from the edge, and from each other.
const MARGIN: i32 = 20;

/// A picture, and where it is in the text.
type Drawing = (&'static str, fn() -> Result<String>);

/// All pictures but those of timing.
const ALL: [Drawing; 4] = [
    ("cell", cell_alone),
    ("hypercube", hypercube_alone),
    ("tile", tile_alone),
    ("core", core_alone),
];

/// Draws the picture of each part of the hardware.
///
/// # Errors
/// The data has something for which a picture has no place.
pub fn parts() -> Result<Vec<Picture>> {
    let drawn = ALL.into_iter().map(|(name, draw)| {
        let text = draw()?;
        Ok(Picture { name, text })
    });
    drawn.collect()
}

/// Cell, hypercube and tile side by side.
///
/// # Errors
/// The data has something for which the picture has no place.
pub fn overview() -> Result<String> {
    let sizes = [cell::SIZE, hypercube::SIZE, tile::SIZE];
    let width: i32 = sizes.iter().map(|[width, _]| width + MARGIN).sum();
    let height = sizes.iter().map(|[_, height]| *height).max().unwrap_or(0);
    let mut canvas = Canvas::new(
        [width + MARGIN, height + 2 * MARGIN],
        "A cell, the hypercube of 16 cells, and a tile of engines",
        &[cell_words(), hypercube_words(), tile_words()].join(" "),
    );
    let [paper, tile] = [find_machine(CELL)?, find_machine(TILE)?];
    let mut x = MARGIN;
    canvas.part([x, MARGIN], |canvas| cell::cell(canvas, paper));
    x += cell::SIZE[0] + MARGIN;
    canvas.part([x, MARGIN], |canvas| hypercube::hypercube(canvas, paper));
    x += hypercube::SIZE[0] + MARGIN;
    canvas.part([x, MARGIN], |canvas| tile::tile(canvas, tile))?;
    canvas.finish()
}

fn cell_words() -> String {
    let names: Vec<_> = SEQUENTIAL.registers.iter().map(|row| row.name).collect();
    format!(
        "A cell has the registers {}, operand multiplexers, and units, whose result is written back; links lead to the neighbours.",
        names.join(", ")
    )
}

fn hypercube_words() -> String {
    "The cells of the hypercube are numbered in binary, bits w z y x; a link joins two cells whose numbers differ in one bit. A column is \
     the quad of one photon, a row is a role."
        .to_owned()
}

fn tile_words() -> String {
    "A tile is a chain of engines: photons enter at the head and pass every engine, each engine holds one query, and results are shifted \
     back to the head."
        .to_owned()
}

/// The cell, and what each of its ops does.
fn cell_alone() -> Result<String> {
    let machine = find_machine(CELL)?;
    let ops = SEQUENTIAL.ops;
    let room = 440;
    let size = [
        2 * MARGIN + cell::SIZE[0] + 2 * MARGIN + room,
        cell::SIZE[1] + 2 * MARGIN,
    ];
    let title = format!("A cell of {}", machine.name);
    let mut canvas = Canvas::new(size, &title, &cell_words());
    canvas.part([MARGIN, MARGIN], |canvas| cell::cell(canvas, machine));
    canvas.part([3 * MARGIN + cell::SIZE[0], MARGIN], |canvas| {
        canvas.text(Face::Head, [0, 14], room, "Its ops");
        let mut y = 44;
        for row in ops {
            let unit = row.unit.map_or("", |unit| unit.name());
            canvas.text(Face::Code, [0, y], 60, row.op.mnemonic());
            canvas.text(Face::Note, [60, y], 60, unit);
            let parts = row.formula.split("; ");
            let parts: Vec<_> = parts.map(str::to_owned).collect();
            canvas.lines(Face::Code, [120, y], room - 120, &parts);
            y += 16 * parts.len() as i32 + 14;
        }
    });
    canvas.finish()
}

fn hypercube_alone() -> Result<String> {
    let machine = find_machine(CELL)?;
    alone(
        hypercube::SIZE,
        &format!("The hypercube of {}", machine.name),
        &hypercube_words(),
        |canvas| {
            hypercube::hypercube(canvas, machine);
            Ok(())
        },
    )
}

fn alone(
    [width, height]: [i32; 2],
    title: &str,
    words: &str,
    draw: impl FnOnce(&mut Canvas) -> Result<()>,
) -> Result<String> {
    let size = [width + 2 * MARGIN, height + 2 * MARGIN];
    let mut canvas = Canvas::new(size, title, words);
    canvas.part([MARGIN, MARGIN], draw)?;
    canvas.finish()
}

/// The tile, and a group's way through one of its engines.
fn tile_alone() -> Result<String> {
    let machine: &Machine = find_machine(TILE)?;
    let spatial = machine.spatial().context("a tile is a spatial machine")?;
    let lines = spatial.flow(machine.squarer).len() as i32;
    let room = 640;
    let height = tile::SIZE[1].max(54 + tile::WAY_LINE * lines);
    alone(
        [tile::SIZE[0] + 2 * MARGIN + room, height],
        &format!("The tile {}", machine.name),
        &tile_words(),
        |canvas| {
            tile::tile(canvas, machine)?;
            canvas.part([2 * MARGIN + tile::SIZE[0], 0], |canvas| {
                tile::way(canvas, machine, spatial, room);
            });
            Ok(())
        },
    )
}

fn core_alone() -> Result<String> {
    let (chains, machine) = CORES[0];
    core::core(&Core::new(find_machine(machine)?, chains)?)
}
