//! The datasheet of a family of machines.

use anyhow::Result;
use photoncube_spec::{Interface, Limitation, MACHINES, Machine, Port, find_machine};

use super::document::Document;
use super::family::Family;
use crate::chains;
use crate::commands::list::{self, MachineRow, machine_row};
use crate::measured;
use crate::synth::clock::Clock;
use crate::synth::figures::AreaRow;
use crate::synth::tables;
use crate::table::Table;

/// The datasheet of a family.
///
/// # Errors
/// A committed figure cannot be read.
pub fn sheet(family: &Family) -> Result<Document> {
    let example = find_machine(family.example)?;
    let interface = Interface::of(example);
    let members = members(family)?;
    let rows = members.iter().map(|machine| machine_row(machine));
    let rows = rows.collect::<Result<Vec<_>>>()?;
    let mut document = begun(family);
    document.table(Table::new(
        &["machine", "what it is"],
        members
            .iter()
            .map(|m| vec![m.name.to_owned(), m.summary.to_owned()]),
    ));
    ports(&mut document, example, &interface, &members);
    protocol(&mut document, family, &interface.protocol);
    speed(&mut document, &members, &rows);
    facts(&mut document, &members);
    limitations(&mut document, &interface.limitations);
    match MACHINES.contains(example) {
        true => area_and_clock(&mut document, &rows)?,
        false => area_of_chains(&mut document)?,
    }
    energy(&mut document);
    verified(&mut document, example, &rows);
    Ok(document)
}

/// The machines of a family: the named ones, or those whose chains are measured.
fn members(family: &Family) -> Result<Vec<&'static Machine>> {
    let named = MACHINES
        .iter()
        .filter(|m| Family::of(m).name == family.name);
    let named: Vec<_> = named.collect();
    if !named.is_empty() {
        return Ok(named);
    }
    let rows = chains::measured_areas()?.into_iter();
    rows.map(|row| Ok(find_machine(&row.machine)?)).collect()
}

/// The title, what the machines are, and the pictures of their parts.
pub fn begun(family: &Family) -> Document {
    let mut document = Document::new(format!("{}: datasheet", family.title));
    document.text(
        "This page is written by `photoncube datasheet` from the specification and the measurements. A test holds it current.",
    );
    document.text(family.about.join(" "));
    for (name, says) in family.pictures {
        document.picture(name, says);
    }
    document
}

fn ports(document: &mut Document, example: &Machine, interface: &Interface, members: &[&Machine]) {
    document.heading("Ports");
    document.text(format!(
        "The ports of `{}`. Bit 0 is the lowest. `photoncube list MACHINE` prints those of another machine.",
        example.name
    ));
    document.table(port_table(&interface.ports));
    document.text(
        "The bits of the ports of each machine, *power* and *sum* for each channel. A machine has no port whose width is `-`, and one \
         channel has the ports `photon_power` and `result_power`.",
    );
    document.table(list::widths(members.iter().copied()));
}

/// A row for each port.
pub fn port_table(ports: &[Port]) -> Table {
    let row = |port: &Port| {
        vec![
            format!("`{}`", port.name),
            port.direction.name().to_owned(),
            port.width.to_string(),
            port.meaning.clone(),
        ]
    };
    Table::new(
        &["port", "direction", "bits", "means"],
        ports.iter().map(row),
    )
}

fn protocol(document: &mut Document, family: &Family, rules: &[String]) {
    document.heading("Protocol and timing");
    document.list(rules.iter().cloned());
    timing(document, family);
}

/// The timing diagram, and how to read it.
pub fn timing(document: &mut Document, family: &Family) {
    document.picture(
        &family.timing(),
        &format!(
            "Timing diagram of the ports: {}",
            family.title.to_lowercase()
        ),
    );
    document.text(format!(
        "The values are those of the golden model, before the rising edge that ends the clock. A word is taken where valid and ready are both 1. \
         A gap stands for clocks in which nothing changes; the second line has the numbers of the clocks that are shown. \
         [{0}.json](../pictures/{0}.json) has the diagram in WaveJSON, which WaveDrom reads.",
        family.timing()
    ));
}

fn speed(document: &mut Document, members: &[&Machine], rows: &[MachineRow]) {
    document.heading("Latency and throughput");
    document.table(list::clocks(members.iter().copied()));
    document.list([
        "*queries*: the queries of a batch. *lanes*: the photons of a group.".to_owned(),
        "*a group*, *more*, *at least*: with no waiting, a batch of n groups takes n times *a group* and *more* clocks, and at least \
         *at least*. Where two groups are under way at once, n is even."
            .to_owned(),
        "*latency*: clocks from the last group of a batch to its first result. Where there is no number, the result is taken in the last \
         clock of *more*."
            .to_owned(),
    ]);
    if members.iter().any(|machine| machine.leaf().is_some()) {
        document.text(
            "The clocks are those of the chain of engines, for the groups that it is given. How many groups a batch needs depends on the scene; \
             [machines](../machines.md#leaf-machines) has figures of whole pictures.",
        );
        return;
    }
    document.table(list::speed(rows.iter()));
    document.text(
        "*G tests/s* is the peak of photon tests a second, with every lane of every engine at work. *error* is the rms relative error of \
         a picture's pixels against f64. [Machines](../machines.md#speed-and-error) says on which scene.",
    );
}

/// The facts that stand under latency and throughput.
const OF_SPEED: [&str; 2] = ["clocks", "latency"];

fn facts(document: &mut Document, members: &[&Machine]) {
    document.heading("Formats and limits");
    let facts: Vec<_> = members
        .iter()
        .map(|machine| Interface::of(machine).facts)
        .collect();
    let mut names: Vec<&str> = Vec::new();
    for fact in facts.iter().flatten() {
        if !names.contains(&fact.name) && !OF_SPEED.contains(&fact.name) {
            names.push(fact.name);
        }
    }
    // What all members share is said once.
    let value = |of: usize, name: &str| {
        let fact = facts[of].iter().find(|fact| fact.name == name);
        fact.map_or("-", |fact| fact.value.as_str())
    };
    let (shared, own): (Vec<_>, Vec<_>) = names
        .into_iter()
        .partition(|name| (1..members.len()).all(|of| value(of, name) == value(0, name)));
    document.list(
        shared
            .iter()
            .map(|name| format!("{name}: {}", value(0, name))),
    );
    if !own.is_empty() {
        let header = [&["machine"][..], &own].concat();
        let rows = members.iter().enumerate().map(|(of, machine)| {
            let cells = own.iter().map(|name| value(of, name).to_owned());
            [machine.name.to_owned()].into_iter().chain(cells).collect()
        });
        document.table(Table::new(&header, rows));
    }
}

/// What a user must design around, with what to do about it.
pub fn limitations(document: &mut Document, limitations: &[Limitation]) {
    document.heading("Known limitations");
    let row = |row: &Limitation| vec![row.says.clone(), row.remedy.clone()];
    document.table(Table::new(
        &["limitation", "what to do"],
        limitations.iter().map(row),
    ));
}

fn area_and_clock(document: &mut Document, rows: &[MachineRow]) -> Result<()> {
    document.heading("Area");
    let areas = rows.iter().flat_map(|row| row.measured.areas.clone());
    areas_of(document, &areas.collect::<Vec<_>>());
    document.heading("Clock");
    let clocks = rows
        .iter()
        .flat_map(|row| row.measured.fmax_by_grade.clone());
    let clocks: Vec<_> = clocks.collect();
    document.table(clock_table(&clocks));
    document.text(measured::fmax_source()?);
    Ok(())
}

/// A table of areas for each flow.
pub fn areas_of(document: &mut Document, areas: &[AreaRow]) {
    for (flow, table) in tables::areas_by_flow(areas) {
        document.text(format!("{flow}:"));
        document.table(table);
    }
}

fn area_of_chains(document: &mut Document) -> Result<()> {
    document.heading("Area");
    areas_of(document, &chains::measured_areas()?);
    document.text(
        "The area is before place and route. [Machines](../machines.md#leaf-machines) and [cores](../cores.md#a-whole-chip) have the area and the clock of \
         placed ones.",
    );
    Ok(())
}

/// A row for each clock.
pub fn clock_table(clocks: &[Clock]) -> Table {
    let row = |clock: &Clock| {
        vec![
            clock.machine.clone(),
            clock.flow.name.to_owned(),
            clock.grade(),
            format!("{:.1}", clock.fmax_mhz),
            clock.seeds.to_string(),
            format!("{:.1} to {:.1}", clock.fmax_mhz_low, clock.fmax_mhz_high),
            clock
                .path
                .as_ref()
                .map_or("not read", |path| path.binds.words())
                .to_owned(),
        ]
    };
    Table::new(
        &[
            "machine",
            "flow",
            "grade",
            "MHz",
            "seeds",
            "lowest to highest",
            "most of the slowest path",
        ],
        clocks.iter().map(row),
    )
}

/// What is known about energy.
pub fn energy(document: &mut Document) {
    document.heading("Energy");
    document.text("Not measured.");
}

fn verified(document: &mut Document, example: &Machine, rows: &[MachineRow]) {
    document.heading("How they are verified");
    if MACHINES.contains(example) {
        document.text("Every register and pin is compared with the golden model in every clock:");
        document.table(list::proofs(rows.iter()));
    } else {
        document.text(
            "`photoncube verify --machine M` compares every register and pin of a custom machine with the golden model. A leaf machine has no \
             formal properties.",
        );
    }
    document.text(
        "[Verification](../verification.md) describes the methods, and [results](../measured/verification.md) has the results of all of \
         them.",
    );
}
