//! The hypercube of 16 cells as a torus of 4 by 4 in Gray code.

use photoncube_spec::{Axis, Hypercube, Machine, Op};

use super::canvas::{Canvas, Face, Kind, Place};

/// The size of the drawing.
pub const SIZE: [i32; 2] = [344, 340];

/// The distances of the nodes' middles, and the middle of the first.
const STEP: [i32; 2] = [76, 56];
const FIRST: [i32; 2] = [88, 82];
const NODE: [i32; 2] = [46, 24];
/// The lines and columns of the drawing.
const SIDE: usize = 4;

/// The place of a number of two bits in Gray code, in which neighbours differ in one bit.
fn gray(number: usize) -> i32 {
    (number ^ number >> 1) as i32
}

/// The column and the line of a node: its two lower bits and its two upper ones.
fn cell(node: usize) -> [i32; 2] {
    [gray(node % SIDE), gray(node / SIDE)]
}

fn middle(node: usize) -> [i32; 2] {
    let cell = cell(node);
    [0, 1].map(|side| FIRST[side] + STEP[side] * cell[side])
}

/// Draws the nodes with their photons and roles, the links, and what each axis joins.
pub fn hypercube(canvas: &mut Canvas, machine: &Machine) {
    let cube = machine.hypercube();
    let title = format!("{} cells: a {}-D hypercube", cube.nodes(), cube.dimension());
    canvas.text(Face::Head, [0, 14], SIZE[0], &title);
    for axis in cube.axes() {
        for node in 0..cube.nodes() {
            let other = cube.neighbour(node, axis);
            if node < other {
                canvas.line(axis.name(), &link(node, other));
            }
        }
    }
    for node in 0..cube.nodes() {
        let [x, y] = middle(node);
        let place = Place::new(x - NODE[0] / 2, y - NODE[1] / 2, NODE[0], NODE[1]);
        let bits = format!("{node:0width$b}", width = cube.dimension() as usize);
        canvas.labelled(Kind::Plain, place, &[(Face::Code, &bits)]);
    }
    headings(canvas, cube);
    axes(canvas, machine, cube);
}

/// A link: straight between cells side by side, else a curve around them.
fn link(node: usize, other: usize) -> String {
    let ([x, y], [to_x, to_y]) = (middle(node), middle(other));
    let ([column, line], [to_column, to_line]) = (cell(node), cell(other));
    let far = (to_column - column).abs() + (to_line - line).abs() > 1;
    match (far, line == to_line) {
        (false, _) => format!("M{x} {y} L{to_x} {to_y}"),
        (true, true) => format!(
            "M{x} {y} C{} {} {} {} {to_x} {to_y}",
            x + 50,
            y - 34,
            to_x - 50,
            y - 34
        ),
        (true, false) => format!(
            "M{x} {y} C{} {} {} {} {to_x} {to_y}",
            x - 46,
            y + 46,
            x - 46,
            to_y - 46
        ),
    }
}

/// The photon of each column and the role of each line.
fn headings(canvas: &mut Canvas, cube: Hypercube) {
    for node in 0..SIDE {
        let [x, _] = middle(node);
        let photon = format!("photon {}", cube.photon(node));
        canvas.centred(Face::Note, [x - STEP[0] / 2, 42], STEP[0], &photon);
    }
    for line in 0..SIDE {
        let [_, y] = middle(line * SIDE);
        canvas.text(Face::Label, [8, y + 4], 20, cube.role(line * SIDE).name());
    }
}

/// What each axis joins, and in which clocks of an iteration the program uses it.
fn axes(canvas: &mut Canvas, machine: &Machine, cube: Hypercube) {
    let top = FIRST[1] + STEP[1] * (SIDE as i32 - 1) + 30;
    let program = machine.microprogram().map(|program| program.iteration);
    for (index, axis) in cube.axes().enumerate() {
        let joins = match cube.role_axes().any(|role| role == axis) {
            true => "squares",
            false => "photons",
        };
        let steps = program.iter().flatten();
        let adds = steps.filter(|at| at.step.op == Op::Add && at.step.axis == Some(axis));
        let clocks: Vec<_> = adds.map(|at| at.clock.to_string()).collect();
        let text = format!("{axis}: adds {joins}, clock {}", clocks.join(", "));
        key(
            canvas,
            axis,
            &text,
            [(index % 2) as i32 * 172, top + (index / 2) as i32 * 18],
        );
    }
    canvas.text(
        Face::Note,
        [0, top + 36],
        SIZE[0],
        &format!(
            "A number is the bits {}; a link joins two cells",
            bits(cube)
        ),
    );
    canvas.text(
        Face::Note,
        [0, top + 52],
        SIZE[0],
        "that differ in one bit. A column tests one photon.",
    );
}

fn bits(cube: Hypercube) -> String {
    let mut names: Vec<_> = cube.axes().map(Axis::name).collect();
    names.reverse();
    names.join(" ")
}

fn key(canvas: &mut Canvas, axis: Axis, text: &str, [x, y]: [i32; 2]) {
    canvas.line(axis.name(), &format!("M{x} {} h16", y - 4));
    canvas.text(Face::Note, [x + 20, y], 152, text);
}
