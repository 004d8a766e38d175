//! The datasheet of cores.

use anyhow::Result;
use photoncube_spec::{
    Access, CORES, Core, CoreField, CoreRegister, CoreRegisterRow, CoreStreams, EventRow, Leaf,
    Port, StreamField, StreamRow, find_machine,
};

use super::document::Document;
use super::family::CORE;
use super::sheet::{areas_of, begun, clock_table, energy, limitations, port_table, timing};
use crate::cores::{self, MeasuredCore};
use crate::table::Table;

/// The rules of the streams, a sentence or two each.
pub const PROTOCOL: [&str; 4] = [
    "A word is taken at a rising edge of `aclk` with `tvalid` and `tready`. A word, once valid, stays as it is until it is taken.",
    "`s_axis_photons`: a word is a leaf for the chain `tdest`, and `tlast` ends the set.",
    "`s_axis_queries`: a word is a query for the chain `tdest`, and `tlast` ends its batch, which also ends where it has as many queries \
     as a chain has engines.",
    "`m_axis_results`: a word is the result of a query of the chain `tid`, with the query's tag and `tlast`. Results of a chain have \
     the order of its queries.",
];

/// How cores are verified.
pub const VERIFIED: &str =
    "`photoncube verify core` compares every pin in every clock with the golden model.";

/// The limits of a core, each with its name.
pub fn facts(core: &Core) -> [(&'static str, String); 6] {
    [
        (
            "chains",
            format!(
                "{}; a core may have 1 to {}",
                core.chains,
                Core::MOST_CHAINS
            ),
        ),
        (
            "leaves of a set",
            format!(
                "at most {} in this core, two sets a chain",
                core.set_leaves()
            ),
        ),
        ("photons of a leaf", format!("up to {}", Core::LEAF_PHOTONS)),
        ("counters", format!("{} bits", Core::COUNTER_BITS)),
        ("registers", format!("{} bits", Core::REGISTER_BITS)),
        ("tag of a query", format!("{} bits", Core::TAG_BITS)),
    ]
}

/// The datasheet of cores, with the ports and words of the core whose Verilog is committed.
///
/// # Errors
/// There is no such core, or a committed figure cannot be read.
pub fn sheet() -> Result<Document> {
    let (chains, machine) = CORES[0];
    let core = Core::new(find_machine(machine)?, chains)?;
    let mut document = begun(&CORE);
    document.text(
        "`photoncube generate --machine M --chains N` writes the Verilog of N leaf machines M as a core. [Cores](../cores.md) has the rules in full.",
    );
    document.heading("Ports");
    document.text(format!(
        "The ports of `{}`. The widths of `tdata`, `tdest` and `tid` depend on the machine and the number of chains; the head of the Verilog \
         has those of another core.",
        core.name()
    ));
    document.table(port_table(&ports(&core)));
    words(&mut document, &core);
    document.heading("Protocol and timing");
    document.list(PROTOCOL.map(str::to_owned));
    timing(&mut document, &CORE);
    registers(&mut document, &core);
    document.heading("Latency and throughput");
    document.text(format!(
        "A word for chain n is in front of that chain n + {} clocks after it leaves its slice; the first chain is 0. A chain takes a leaf in {} clocks \
         and is a [leaf machine](leaf.md) of {} engines in the picture above. How many queries a clock a core does depends on the scene; [cores](../cores.md#a-whole-chip) has \
         figures of whole pictures.",
        core.stages(0) + 1,
        Leaf::GROUPS,
        core.engines()
    ));
    document.heading("Formats and limits");
    document.text(format!("Those of `{}`:", core.name()));
    document.list(facts(&core).map(|(name, value)| format!("{name}: {value}")));
    limitations(&mut document, &core.limitations());
    area_and_clock(&mut document, &cores::measured()?);
    energy(&mut document);
    document.heading("How they are verified");
    document.text(format!(
        "{VERIFIED} [Verification](../verification.md) describes the methods."
    ));
    Ok(document)
}

/// What is measured of the cores that were placed.
fn area_and_clock(document: &mut Document, measured: &[MeasuredCore]) {
    document.heading("Area");
    let areas: Vec<_> = measured.iter().map(|core| core.area.clone()).collect();
    areas_of(document, &areas);
    document.text(
        "The area is before place and route. That of a chain alone is in the [datasheet of leaf machines](leaf.md#area).",
    );
    document.heading("Clock");
    let clocks: Vec<_> = measured.iter().map(|core| core.clock.clone()).collect();
    document.table(clock_table(&clocks));
    let mut sources: Vec<_> = measured.iter().map(|core| core.source.as_str()).collect();
    sources.dedup();
    document.text(format!(
        "{} [Cores](../cores.md#a-whole-chip) has whole pictures at these clocks.",
        sources.join(" ")
    ));
}

/// The ports, each with a meaning. The head of the Verilog says nothing of those that are as the protocols have them.
pub fn ports(core: &Core) -> Vec<Port> {
    let mut ports = core.ports();
    for port in ports.iter_mut().filter(|port| port.meaning.is_empty()) {
        let protocol = match port.name.contains("_axis_") {
            true => "AXI4-Stream",
            false => "AXI4-Lite",
        };
        port.meaning = format!("as {protocol} has it");
    }
    ports
}

/// The fields of the three words.
fn words(document: &mut Document, core: &Core) {
    let streams = CoreStreams::of(core);
    document.text(
        "The fields of the words. The fields of the photons 1 to 7 of a leaf follow in the order of those of photon 0. Bits without a field are not \
         looked at in a leaf. In a query they must be 0: where one is 1, the query is outside of the frame, as the bits above a coordinate are those of a larger one.",
    );
    let rows = streams.rows();
    let rows = rows.iter().flat_map(|row| fields(core, row));
    document.table(Table::new(
        &["port", "field", "bits", "from bit", "means"],
        rows,
    ));
    let facts = core.number_facts().into_iter();
    document.list(facts.map(|fact| format!("{}: {}", fact.name, fact.value)));
}

/// The fields of a word; of the photons of a leaf only the first.
fn fields(core: &Core, row: &StreamRow) -> Vec<Vec<String>> {
    let cells = |(field, meaning): (&StreamField, String)| {
        vec![
            format!("`{}`", row.port),
            field.name.clone(),
            field.width.to_string(),
            field.low.to_string(),
            meaning,
        ]
    };
    row.meanings(core).into_iter().map(cells).collect()
}

fn registers(document: &mut Document, core: &Core) {
    document.heading("Registers");
    document.text("Addresses and values after reset are hexadecimal; a dash stands where the value depends on the core or on the moment.");
    let all = CoreRegister::all(core, 0);
    let rows = all.iter().map(|row| {
        let access = match row.access {
            Access::Read => "read",
            Access::ReadWrite => "read, write",
            Access::WriteOneToClear => "read, 1 clears",
            Access::WriteOneToDo => "write",
        };
        vec![
            format!("{:03x}", row.address),
            format!("`{}`", row.name),
            access.to_owned(),
            reset(row),
            row.about.clone(),
        ]
    });
    document.table(Table::new(
        &["address", "register", "access", "after reset", "means"],
        rows,
    ));
    document.text("The fields of registers that have several, or that do not fill the word; the other bits read as 0:");
    let rows = all
        .iter()
        .filter(|row| !is_of_events(row))
        .flat_map(fields_of_register);
    document.table(Table::new(&["register", "bits", "field", "means"], rows));
    document.text("The events, from bit 0 of `events` and `interrupt_enable` on:");
    let events = EventRow::ALL
        .iter()
        .map(|row| vec![format!("`{}`", row.name), row.about.to_owned()]);
    document.table(Table::new(&["event", "means"], events));
}

/// The value of a register after `aresetn`; a dash where it depends on the moment or on the core.
fn reset(row: &CoreRegisterRow) -> String {
    use CoreRegister as R;
    match row.register {
        R::DigestLow | R::DigestHigh | R::Shape | R::Control => "–".to_owned(),
        _ if row.is_live() => "–".to_owned(),
        _ => format!("{:x}", row.reset),
    }
}

/// Whether the bits of the register are the events, which have a table of their own.
fn is_of_events(row: &CoreRegisterRow) -> bool {
    matches!(
        row.register,
        CoreRegister::Events | CoreRegister::InterruptEnable
    )
}

/// A row for each field of a register; none where one field fills the word.
fn fields_of_register(row: &CoreRegisterRow) -> Vec<Vec<String>> {
    let fills = matches!(row.fields.as_slice(), [field] if field.width == Core::REGISTER_BITS);
    let cells = |field: &CoreField| {
        let high = field.low + field.width - 1;
        let bits = match field.width {
            1 => format!("{high}"),
            _ => format!("{high}:{}", field.low),
        };
        vec![
            format!("`{}`", row.name),
            bits,
            format!("`{}`", field.name),
            field.about.to_owned(),
        ]
    };
    row.fields.iter().filter(|_| !fills).map(cells).collect()
}
