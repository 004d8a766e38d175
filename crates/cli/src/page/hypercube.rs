//! The hypercube as a drawing, through which a group of photons is stepped.

use std::fmt::Write as _;

use anyhow::Result;
use maud::{Markup, PreEscaped, html};
use photoncube_render::{PhotonMap, Scene, ViewOptions};
use photoncube_spec::{Axis, Hypercube, Machine, SEQUENTIAL, Step, find_machine};
use serde_json::json;

use super::chart::escaped;
use super::figures::{Cell, figures};
use super::{Example, Section, Trace, controls, or_reason, scrolling};

/// The size of a node's box, and the distances of the nodes of a quad and of the quads.
const BOX: [f64; 2] = [122.0, 58.0];
const NEAR: [f64; 2] = [156.0, 92.0];
const FAR: [f64; 2] = [370.0, 250.0];
const MARGIN: f64 = 30.0;

/// The centre of a node: the photon axes x and y within a quad, the role axes z and w between the quads.
fn centre(node: usize) -> [f64; 2] {
    let bit = |axis: usize| (node >> axis & 1) as f64;
    let at =
        |side: usize| MARGIN + BOX[side] / 2.0 + bit(side) * NEAR[side] + bit(side + 2) * FAR[side];
    [at(0), at(1)]
}

fn size() -> [f64; 2] {
    [0, 1].map(|side| 2.0 * MARGIN + BOX[side] + NEAR[side] + FAR[side] + 20.0)
}

/// The machine whose steps are shown where the given one has no microprogram, or a cube that is not drawn.
const PAPER: &str = "paper";
/// The dimensions of the drawing.
const DIMENSIONS: u32 = 4;

/// A group of photons of the scene on the hypercube of the machine, or on that of `paper`.
pub fn hypercube_section(
    scene: &Scene,
    map: &PhotonMap,
    machine: &Machine,
    view: &ViewOptions,
) -> Section {
    let body = || -> Result<Markup> {
        let is_drawn = machine.hypercube().dimension() == DIMENSIONS;
        let shown = match is_drawn && machine.microprogram().is_some() {
            true => machine,
            false => find_machine(PAPER)?,
        };
        let example = Example::of(scene, map, shown, view, 1)?;
        let trace = Trace::of(shown, &example)?;
        Ok(html! {
            @if shown.name != machine.name {
                p {
                    code { (machine.name) } " has no steps that a drawing of four dimensions shows. " code { (shown.name) }
                    " has, and is drawn here, with photons of this scene in its own numbers."
                }
            }
            (hypercube(shown, &example, &trace))
        })
    };
    Section {
        id: "hypercube",
        title: "A group of photons on the hypercube".to_owned(),
        body: or_reason(body()),
    }
}

/// The drawing with its controls, and all values as a table.
fn hypercube(machine: &Machine, example: &Example, trace: &Trace) -> Markup {
    let cube = machine.hypercube();
    let data = json!({
        "registers": trace.registers,
        "steps": trace.steps.iter().zip(&trace.clocks).map(|(step, clock)| json!({
            "clock": clock,
            "text": step.to_string(),
            "axis": step.axis.map(Axis::name),
            "formula": SEQUENTIAL.op(step.op).formula,
        })).collect::<Vec<_>>(),
        "states": trace.states,
    });
    // In a script, `</` would end it.
    let data = data.to_string().replace("</", "<\\/");
    html! {
        p {
            "Each box is a cell of " code { (machine.name) } " with the work register v and the sum s. A group of "
            (machine.photons_per_iteration()) " photons of this scene is tested against a query; " (example.in_range)
            " of them are in range. Every clock all cells do one step. The values are those of the golden model."
        }
        div.stepper role="group" aria-label="A group of photons, clock by clock" {
            (controls())
            p.now aria-live="polite" { "Before the first step" }
            div.cube { (scrolling("Drawing of the hypercube", PreEscaped(drawing(cube, trace)))) }
            ol.steps {
                @for (step, clock) in trace.steps.iter().zip(&trace.clocks) {
                    li {
                        span { (clock) }
                        code { (step) }
                        span { span.unit { (unit(*step)) } ": " (SEQUENTIAL.op(step.op).formula) }
                    }
                }
            }
            script type="application/json" class="steps-data" { (PreEscaped(data)) }
        }
        details {
            summary { "All values as a table" }
            (table(trace))
        }
    }
}

fn unit(step: Step) -> &'static str {
    SEQUENTIAL.op(step.op).unit.map_or("", |unit| unit.name())
}

fn drawing(cube: Hypercube, trace: &Trace) -> String {
    let [width, height] = size();
    let mut svg = format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"The hypercube: four quads of cells, one for each of x, y, z and \
         the distance; in each quad a cell for each of four photons\">\n"
    );
    for node in 0..cube.nodes() {
        for axis in cube.axes() {
            let other = cube.neighbour(node, axis);
            if node < other {
                link(&mut svg, axis, node, other);
            }
        }
    }
    let of = |name: &str| {
        trace
            .registers
            .iter()
            .position(|register| *register == name)
    };
    let value = |node: usize, register| {
        let column = of(register)?;
        Some(trace.states[0][node][column])
    };
    for node in 0..cube.nodes() {
        let [x, y] = centre(node);
        let (left, top) = (x - BOX[0] / 2.0, y - BOX[1] / 2.0);
        let _ = writeln!(
            svg,
            "<g class=\"node\" data-node=\"{node}\"><rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" rx=\"5\"/>\
             <text class=\"node-name\" x=\"{:.1}\" y=\"{:.1}\">{} · photon {}</text>\
             <text class=\"v\" x=\"{:.1}\" y=\"{:.1}\">v {}</text><text class=\"s\" x=\"{:.1}\" y=\"{:.1}\">s {}</text></g>",
            BOX[0],
            BOX[1],
            left + 7.0,
            top + 16.0,
            cube.role(node).name(),
            cube.photon(node),
            left + 7.0,
            top + 33.0,
            value(node, "v").unwrap_or(0),
            left + 7.0,
            top + 49.0,
            value(node, "s").unwrap_or(0),
        );
    }
    svg + "</svg>\n"
}

/// A link. Those between quads are curves, so that they do not run behind other cells.
fn link(svg: &mut String, axis: Axis, node: usize, other: usize) {
    let ([x, y], [to_x, to_y]) = (centre(node), centre(other));
    let bend = match axis.name() {
        "z" => [0.0, -34.0],
        "w" => [-62.0, 0.0],
        _ => [0.0, 0.0],
    };
    let middle = [
        (x + to_x) / 2.0 + 2.0 * bend[0],
        (y + to_y) / 2.0 + 2.0 * bend[1],
    ];
    let _ = writeln!(
        svg,
        "<path class=\"link\" data-axis=\"{}\" d=\"M{x} {y}Q{:.1} {:.1} {to_x} {to_y}\"/>",
        escaped(axis.name()),
        middle[0],
        middle[1]
    );
}

/// A row for each node and register, a column for each clock.
fn table(trace: &Trace) -> Markup {
    let mut header = vec!["node, register".to_owned(), "before".to_owned()];
    header.extend(trace.steps.iter().map(|step| format!("after {step}")));
    let header: Vec<_> = header.iter().map(String::as_str).collect();
    let nodes = trace.states[0].len();
    let rows = (0..nodes).flat_map(|node| {
        let registers = trace.registers.iter().enumerate();
        registers.map(move |(column, register)| {
            let values = trace
                .states
                .iter()
                .map(|state| state[node][column].to_string());
            let name = Cell::text(format!("{node}, {register}"));
            [name]
                .into_iter()
                .chain(values.map(Cell::Number))
                .collect::<Vec<_>>()
        })
    });
    figures(
        "The registers of all cells, clock by clock",
        &header,
        &rows.collect::<Vec<_>>(),
        |_| false,
    )
}
