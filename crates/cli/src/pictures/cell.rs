//! A cell of a sequential machine: its registers, units and links.

use photoncube_spec::{CellTables, Machine, Op, SEQUENTIAL, Unit, Widths};

use super::canvas::{Canvas, Face, Kind, Place};

/// The size of the drawing.
pub const SIZE: [i32; 2] = [312, 340];

/// The width of everything but the wire that leads back to the registers.
const WIDTH: i32 = 296;
/// The registers of a line.
const IN_LINE: usize = 3;
const GAP: i32 = 4;

/// Draws a cell: the port, the registers, the operand multiplexers, the units, the way back and the links.
pub fn cell(canvas: &mut Canvas, machine: &Machine) {
    let tables = &SEQUENTIAL;
    canvas.text(Face::Head, [0, 14], WIDTH, "A cell");
    let port = Place::new(0, 30, WIDTH, 26);
    let loads = mnemonics(tables, |unit| unit.is_port());
    canvas.labelled(
        Kind::Plain,
        port,
        &[(Face::Note, &format!("port ({loads}): from the streams"))],
    );
    canvas.arrow("M148 56 V70");
    let registers = registers(canvas, machine, 72);
    let operands = Place::new(0, registers.bottom() + 18, WIDTH, 24);
    canvas.arrow(&format!("M148 {} V{}", registers.bottom(), operands.y - 1));
    canvas.labelled(
        Kind::Plain,
        operands,
        &[(Face::Note, "operand multiplexers")],
    );
    let units = units(canvas, tables, operands.bottom() + 18);
    let (low, back) = (units.bottom() + 14, WIDTH + 12);
    let [_, middle] = registers.middle();
    canvas.arrow(&format!("M148 {low} H{back} V{middle} H{}", WIDTH + 1));
    canvas.text(
        Face::Note,
        [0, low + 16],
        WIDTH,
        "the result is written back",
    );
    links(canvas, machine, low + 34);
}

/// The mnemonics of the ops on the units that `is_it` accepts.
fn mnemonics(tables: &CellTables, is_it: impl Fn(Unit) -> bool) -> String {
    let ops = tables.ops.iter();
    let ops = ops.filter(|row| row.unit.is_some_and(&is_it));
    ops.map(|row| row.op.mnemonic())
        .collect::<Vec<_>>()
        .join(", ")
}

/// The register file, in lines of boxes: the mnemonic, the name and the bits of each register.
fn registers(canvas: &mut Canvas, machine: &Machine, top: i32) -> Place {
    let widths = Widths::of(machine);
    let rows = SEQUENTIAL.registers;
    let width = (WIDTH - GAP * (IN_LINE as i32 - 1)) / IN_LINE as i32;
    let height = 38;
    for (index, row) in rows.iter().enumerate() {
        let (line, column) = ((index / IN_LINE) as i32, (index % IN_LINE) as i32);
        let place = Place::new(
            column * (width + GAP),
            top + line * (height + GAP),
            width,
            height,
        );
        let name = format!("{} {}", row.mnemonic, row.name);
        let bits = format!("{} bits", (row.width)(&widths));
        canvas.labelled(
            Kind::Register,
            place,
            &[(Face::Code, &name), (Face::Note, &bits)],
        );
    }
    let lines = rows.len().div_ceil(IN_LINE) as i32;
    Place::new(0, top, WIDTH, lines * (height + GAP) - GAP)
}

/// The units that compute, side by side, with the paper's words and the ops on each.
fn units(canvas: &mut Canvas, tables: &CellTables, top: i32) -> Place {
    let mut units: Vec<Unit> = Vec::new();
    for unit in tables.ops.iter().filter_map(|row| row.unit) {
        if !unit.is_port() && !units.contains(&unit) {
            units.push(unit);
        }
    }
    let width = (WIDTH - GAP * (units.len() as i32 - 1)) / units.len() as i32;
    let height = 58;
    for (index, &unit) in units.iter().enumerate() {
        let place = Place::new(index as i32 * (width + GAP), top, width, height);
        let [middle, _] = place.middle();
        canvas.arrow(&format!("M{middle} {} V{}", top - 18, top - 1));
        canvas.line(
            "wire",
            &format!("M{middle} {} V{}", place.bottom(), place.bottom() + 14),
        );
        let lines = formula_lines(unit);
        let mut lines: Vec<_> = lines
            .iter()
            .map(|line| (Face::Label, line.as_str()))
            .collect();
        let ops = mnemonics(tables, |of| of == unit);
        lines.push((Face::Code, &ops));
        canvas.labelled(Kind::Unit, place, &lines);
    }
    let first = width / 2;
    let last = (units.len() as i32 - 1) * (width + GAP) + width / 2;
    let low = top + height + 14;
    canvas.line("wire", &format!("M{first} {low} H{last}"));
    Place::new(0, top, WIDTH, height)
}

/// The formula of a unit, in a line for each of its clauses.
fn formula_lines(unit: Unit) -> Vec<String> {
    let formula = unit.formula();
    formula.split(", ").map(str::to_owned).collect()
}

/// The links to the neighbours, and the register that they carry.
fn links(canvas: &mut Canvas, machine: &Machine, top: i32) {
    let axes: Vec<_> = machine.hypercube().axes().map(|axis| axis.name()).collect();
    let carried = SEQUENTIAL.op(Op::Add).link.map(|of| of(None));
    let carried = SEQUENTIAL
        .registers
        .iter()
        .find(|row| Some(row.register) == carried);
    let name = carried.map_or("", |row| row.mnemonic);
    canvas.both_ways(&format!("M20 {top} V{}", top + 34));
    canvas.lines(
        Face::Note,
        [36, top + 14],
        WIDTH - 36,
        &[
            format!("a link on each axis ({}) carries {name}", axes.join(", ")),
            "to one neighbour, and that neighbour's back".to_owned(),
        ],
    );
}
