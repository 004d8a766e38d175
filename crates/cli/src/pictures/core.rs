//! A core: the instances of its top module between its ports.

use anyhow::{Context, Result, bail};
use photoncube_hdl::core_instances;
use photoncube_spec::{Core, Port};

use super::canvas::{Canvas, Face, Kind, Place};

/// The size of a box, the first line of chains, the distance of two such lines, and that of a chain's leaves and queries.
const BOX: [i32; 2] = [116, 40];
const FIRST_CHAIN: i32 = 244;
const PITCH: i32 = 128;
const ROW: i32 = 56;
/// The left edges of the columns: ports, slices and flow control, stages of leaves and of queries, queues, chain, place, merge.
const PORTS: i32 = 24;
const CONTROL: i32 = 204;
const LEAVES: i32 = 348;
const QUERIES: i32 = 488;
const QUEUES: i32 = 628;
const CHAIN: i32 = 772;
const RESULT: i32 = 952;
const MERGE: i32 = 1096;
const WIDTH: i32 = 1256;
/// The width of a box of ports, and of a chain.
const OF_PORTS: i32 = 156;
const OF_CHAIN: i32 = 152;
/// The end of the names of stages, which says what their module says too.
const STAGE: &str = "_register";
/// The upper edges of the slices and of the boxes of ports beside them.
const PHOTON_SLICE: i32 = 84;
const QUERY_SLICE: i32 = 164;
const RESULT_SLICE: i32 = 176;

/// An instance of the top module.
struct Instance {
    name: String,
    /// The name of its module, without the core's prefix.
    module: String,
}

/// The picture of a core.
///
/// # Errors
/// The text of the core has an instance that has no place in the picture, or the picture has one that is not in the text.
pub fn core(core: &Core) -> Result<String> {
    let instances = instances(core)?;
    let registers = FIRST_CHAIN + PITCH * core.chains as i32;
    let registers = Place::new(CONTROL, registers, MERGE + BOX[0] - CONTROL, BOX[1]);
    let height = registers.y + 220;
    let description = format!(
        "The modules of {} between its ports. Leaves and queries pass a slice each, then stages, one for each chain, and a queue in front of \
         each of {} chains. Results pass a place behind each chain, are merged, and leave through a slice.",
        core.name(),
        core.chains
    );
    let title = format!("The modules of {}", core.name());
    let mut canvas = Canvas::new([WIDTH, height], &title, &description);
    canvas.text(Face::Head, [PORTS, 30], WIDTH - PORTS, &title);
    canvas.text(
        Face::Note,
        [PORTS, 48],
        WIDTH - PORTS,
        "Each box is an instance of the top module, with its module below its name, or an interface with the bits of its ports. Lines without \
         a tip are credits: the free places of a queue.",
    );
    wires(&mut canvas, core);
    for instance in &instances {
        let Some(place) = place(&instance.name, registers) else {
            bail!(
                "the picture of a core has no place for the instance `{}` of `{}`: give it one in crates/cli/src/pictures/core.rs",
                instance.name,
                instance.module
            );
        };
        let kind = match instance.name.starts_with("chain_") {
            true => Kind::Unit,
            false if ["queue", "photon_queue", "registers"].contains(&instance.module.as_str()) => {
                Kind::Register
            }
            false => Kind::Plain,
        };
        let name = instance.name.trim_end_matches(STAGE);
        let mut lines = vec![(Face::Code, name)];
        if instance.module != instance.name {
            lines.push((Face::Note, &instance.module));
        }
        canvas.labelled(kind, place, &lines);
    }
    ports(&mut canvas, core, registers)?;
    canvas.finish()
}

/// The instances of the top module, by the parser of the built-in evaluator.
fn instances(core: &Core) -> Result<Vec<Instance>> {
    let found = core_instances(core);
    let found = found.with_context(|| format!("the top module of {}", core.name()))?;
    let prefix = format!("{}_", core.top());
    let chain = core.machine.module_prefix();
    let of = |(name, module): (String, String)| {
        let module = match module == chain {
            true => core.machine.name.to_owned(),
            false => module.strip_prefix(&prefix).unwrap_or(&module).to_owned(),
        };
        Instance { name, module }
    };
    Ok(found.into_iter().map(of).collect())
}

/// The number at the end of a name, and what is in front of it.
fn numbered(name: &str) -> Option<(&str, i32)> {
    let (stem, number) = name.trim_end_matches(STAGE).rsplit_once('_')?;
    Some((stem, number.parse().ok()?))
}

/// The place of an instance; `None` for one that is not known.
fn place(name: &str, registers: Place) -> Option<Place> {
    let at = |x, y| Some(Place::new(x, y, BOX[0], BOX[1]));
    match name {
        "photon_slice" => return at(CONTROL, PHOTON_SLICE),
        "query_slice" => return at(CONTROL, QUERY_SLICE),
        "result_slice" => return at(MERGE, RESULT_SLICE),
        "registers" => return Some(registers),
        _ => {}
    }
    let (stem, number) = numbered(name)?;
    let y = FIRST_CHAIN + PITCH * number;
    match stem {
        "photon_port" => at(CONTROL, y),
        "query_link" => at(CONTROL, y + ROW),
        "leaf_stage" => at(LEAVES, y),
        "query_stage" => at(QUERIES, y + ROW),
        "photon_queue" => at(QUEUES, y),
        "query_queue" => at(QUEUES, y + ROW),
        "chain" => Some(Place::new(CHAIN, y, OF_CHAIN, ROW + BOX[1])),
        "result_place" => at(RESULT, y + ROW / 2),
        "merge" => at(MERGE, y + ROW / 2),
        _ => None,
    }
}

/// The wires between the places: words as arrows, and as lines of another colour the way of the credits.
fn wires(canvas: &mut Canvas, core: &Core) {
    let (half, right) = (BOX[1] / 2, CONTROL + BOX[0]);
    let [leaves, queries, merges] = [LEAVES, QUERIES, MERGE].map(|column| column + BOX[0] / 2);
    canvas.arrow(&format!(
        "M{right} {} H{leaves} V{}",
        PHOTON_SLICE + half,
        FIRST_CHAIN - 1
    ));
    canvas.arrow(&format!(
        "M{right} {} H{queries} V{}",
        QUERY_SLICE + half,
        FIRST_CHAIN + ROW - 1
    ));
    for chain in 0..core.chains as i32 {
        let y = FIRST_CHAIN + PITCH * chain;
        let (below, middle) = (y + PITCH, y + ROW / 2 + half);
        if chain + 1 < core.chains as i32 {
            canvas.arrow(&format!("M{leaves} {} V{}", y + BOX[1], below - 1));
            canvas.arrow(&format!(
                "M{queries} {} V{}",
                y + ROW + BOX[1],
                below + ROW - 1
            ));
            canvas.arrow(&format!(
                "M{merges} {} V{}",
                below + ROW / 2,
                y + ROW / 2 + BOX[1] + 1
            ));
        }
        for (stage, y) in [(LEAVES, y), (QUERIES, y + ROW)] {
            canvas.arrow(&format!("M{} {} H{}", stage + BOX[0], y + half, QUEUES - 1));
            canvas.arrow(&format!("M{} {} H{}", QUEUES + BOX[0], y + half, CHAIN - 1));
            canvas.line(
                "z",
                &format!(
                    "M{} {y} V{} H{} V{y}",
                    QUEUES + 20,
                    // Clear of the tips of the arrows.
                    y - 12,
                    CONTROL + BOX[0] - 20
                ),
            );
        }
        canvas.arrow(&format!("M{} {middle} H{}", CHAIN + OF_CHAIN, RESULT - 1));
        canvas.arrow(&format!("M{} {middle} H{}", RESULT + BOX[0], MERGE - 1));
    }
    canvas.arrow(&format!(
        "M{merges} {} V{}",
        FIRST_CHAIN + ROW / 2,
        RESULT_SLICE + BOX[1] + 1
    ));
}

/// An interface, the place of its box, and the way from it or to it.
type Interface = (&'static str, Place, String);

/// The ports, in a box for each interface: the names without the interface's, and the bits where there are several.
///
/// # Errors
/// A port is of no interface.
fn ports(canvas: &mut Canvas, core: &Core, registers: Place) -> Result<()> {
    let half = BOX[1] / 2;
    let [at_photons, at_queries] = [PHOTON_SLICE - 14, QUERY_SLICE - 14];
    let merges = MERGE + BOX[0] / 2;
    let into = |y: i32| format!("M{} {y} H{}", PORTS + OF_PORTS, CONTROL - 1);
    let low = registers.bottom() + 30;
    let interfaces: [Interface; 6] = [
        (
            "s_axis_photons_",
            Place::new(PORTS, at_photons, OF_PORTS, 68),
            into(PHOTON_SLICE + half),
        ),
        (
            "s_axis_queries_",
            Place::new(PORTS, at_queries, OF_PORTS, 68),
            into(QUERY_SLICE + half),
        ),
        (
            "m_axis_results_",
            Place::new(WIDTH - PORTS - OF_PORTS, 66, OF_PORTS, 84),
            format!("M{merges} {RESULT_SLICE} V151"),
        ),
        (
            "s_axi_",
            Place::new(PORTS, registers.y, OF_PORTS, 196),
            into(registers.y + half),
        ),
        (
            "irq",
            Place::new(MERGE, low, BOX[0], BOX[1]),
            format!("M{merges} {} V{}", registers.bottom(), low - 1),
        ),
        (
            "a",
            Place::new(CONTROL, low, BOX[0], BOX[1]),
            format!(
                "M{} {low} V{}",
                CONTROL + BOX[0] / 2,
                registers.bottom() + 1
            ),
        ),
    ];
    let mut left = core.ports();
    for (prefix, place, way) in interfaces {
        let (own, others) = left
            .into_iter()
            .partition(|port| port.name.starts_with(prefix));
        left = others;
        canvas.arrow(&way);
        interface(canvas, prefix, place, &own);
    }
    match left.first() {
        None => Ok(()),
        Some(port) => bail!(
            "the picture of a core has no place for the port `{}`: give it one in crates/cli/src/pictures/core.rs",
            port.name
        ),
    }
}

/// A box of ports: the interface, then the ports in lines as long as the box is wide.
fn interface(canvas: &mut Canvas, prefix: &str, place: Place, ports: &[Port]) {
    let is_bus = prefix.ends_with('_');
    let names = ports.iter().map(|port| match is_bus {
        true => described(port, prefix),
        false => described(port, ""),
    });
    let names: Vec<_> = names.collect();
    let mut lines = vec![prefix.trim_end_matches('_').to_owned()];
    if !is_bus {
        lines.clear();
    }
    lines.extend(filled(&names, 22));
    let lines: Vec<_> = lines
        .iter()
        .map(|line| (Face::Code, line.as_str()))
        .collect();
    canvas.labelled(Kind::Plain, place, &lines);
}

/// The words in lines of at most so many characters.
fn filled(words: &[String], most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if line.len() + 2 + word.len() <= most => *line += &format!(", {word}"),
            _ => lines.push(word.clone()),
        }
    }
    lines
}

/// The name of a port without its interface, and its bits where it has several.
fn described(port: &Port, interface: &str) -> String {
    let name = port.name.strip_prefix(interface).unwrap_or(&port.name);
    match port.width {
        1 => name.to_owned(),
        bits => format!("{name} {bits}"),
    }
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{CORES, find_machine};

    use super::*;

    #[test]
    fn every_instance_of_the_committed_core_is_in_the_picture() {
        let (chains, machine) = CORES[0];
        let of = Core::new(find_machine(machine).unwrap(), chains).unwrap();
        let picture = core(&of).unwrap();
        let instances = instances(&of).unwrap();
        assert!(instances.len() > 8 * chains as usize, "{}", instances.len());
        for Instance { name, module } in instances {
            for text in [name.trim_end_matches(STAGE), &module] {
                assert!(picture.contains(&format!(">{text}<")), "{text}");
            }
        }
        assert!(picture.contains(">tready, tlast, tdest 2<"), "{picture}");
    }

    /// A core whose queries have radii has stores of rounds, which the picture does not draw.
    #[test]
    fn an_instance_without_a_place_is_refused() {
        let machine = find_machine("leaf-5-radii-local7-rgb6d-n64").unwrap();
        let error = core(&Core::new(machine, 2).unwrap())
            .unwrap_err()
            .to_string();
        assert!(error.contains("no place for the instance `"), "{error}");
        assert!(error.contains("_0` of `"), "{error}");
    }
}
