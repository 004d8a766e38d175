//! The module with the registers of a core, behind AXI4-Lite.

use photoncube_spec::{
    Access, Core, CoreCounter, CoreEvent, CoreRegister, CoreRegisterRow, CounterRow, EventRow,
    Leaf, Widths,
};

use super::rounds;
use super::top::range;

/// The fixed part of the module, in which the tables below are put.
const TEMPLATE: &str = include_str!("registers.v");

/// The parts in which the word of a read register is found before they are put together.
const READ_PARTS: usize = 4;

/// The module of a core whose configuration has this digest.
pub(super) fn registers(core: &Core, digest: u64) -> String {
    let rows = CoreRegister::all(core, digest);
    let high = |bits: Bits| (bits.number(core) - 1).to_string();
    let parts = [
        ("TOP", core.top()),
        ("ADDRESS_HIGH", (Core::ADDRESS_BITS - 1).to_string()),
        ("COUNTER_HIGH", (Core::COUNTER_BITS - 1).to_string()),
        ("UNDER_WAY_BITS", Core::UNDER_WAY_BITS.to_string()),
        ("UNDER_WAY_HIGH", (Core::UNDER_WAY_BITS - 1).to_string()),
        ("EVENT_HIGH", (EventRow::ALL.len() - 1).to_string()),
        ("COUNT_HIGH", high(Bits::Photons)),
        ("LEAVES_HIGH", high(Bits::Leaves)),
        ("GROUPS_HIGH", high(Bits::Groups)),
        (
            "SEEN",
            seen(core, |wire, bits| {
                format!(
                    "    reg {}seen_{wire};\n    initial seen_{wire} = {bits}'d0;",
                    range(bits)
                )
            }),
        ),
        (
            "SEES",
            seen(core, |wire, _| format!("        seen_{wire} <= {wire};")),
        ),
        (
            "FORGETS",
            seen(core, |wire, bits| {
                format!("            seen_{wire} <= {bits}'d0;")
            }),
        ),
        ("STALL_LIMIT", reset_of(&rows, CoreRegister::StallLimit)),
        ("RESTART", CoreRegister::RESTART.ilog2().to_string()),
        (
            "CLEAR_COUNTERS",
            CoreRegister::CLEAR_COUNTERS.ilog2().to_string(),
        ),
        ("ADDRESSES", addresses(&rows)),
        ("COUNTERS", counters()),
        ("EVENTS", events()),
        (
            "COUNTER_CLEARS",
            counter_lines(|row| format!("counter_{} <= {}'d0;", row.name, Core::COUNTER_BITS)),
        ),
        (
            "COUNTER_ADDS",
            counter_lines(|row| {
                format!(
                    "counter_{0} <= counter_{0} + {1};",
                    row.name,
                    increment(row.counter)
                )
            }),
        ),
        ("ROUND_PORTS", of_rounds(core, |_| rounds::PORTS.to_owned())),
        ("ROUND_DECLARATIONS", of_rounds(core, rounds::declarations)),
        ("ROUND_WRITES", of_rounds(core, rounds::writes)),
        ("ROUND_RESETS", of_rounds(core, rounds::resets)),
        (
            "LAST_RESULT",
            match core.has_radii() {
                true => "result_ends",
                false => "result_moves",
            }
            .to_owned(),
        ),
        (
            "NOT_PLAYED",
            of_rounds(core, |_| " & ~(|played)".to_owned()),
        ),
        ("SELECTED_HIGH", (rows.len() - 1).to_string()),
        ("SELECTS", selects(&rows)),
        ("PARTS", READ_PARTS.to_string()),
        (
            "FOUND_DECLARATIONS",
            lines((0..READ_PARTS).map(|part| format!("    reg [31:0] found_{part};"))),
        ),
        ("FINDS", finds(&rows)),
        (
            "FOUND_WORD",
            (0..READ_PARTS)
                .map(|part| format!("found_{part}"))
                .collect::<Vec<_>>()
                .join(" | "),
        ),
        ("READS_LOW", of_counters(&rows, |_, selected| selected)),
        ("HIGH_COPIES", of_counters(&rows, high_copy)),
        ("WRITABLE", writable(&rows)),
    ];
    let replaced = parts
        .iter()
        .fold(TEMPLATE.to_owned(), |text, (name, part)| {
            text.replace(&format!("@{name}@"), part)
        });
    debug_assert!(
        !replaced.replace("always @(", "").contains('@'),
        "all parts are replaced"
    );
    replaced
}

/// A part of the template that only a core with rounds has.
fn of_rounds(core: &Core, part: impl Fn(&Core) -> String) -> String {
    match core.has_radii() {
        true => part(core),
        false => String::new(),
    }
}

fn reset_of(rows: &[CoreRegisterRow], register: CoreRegister) -> String {
    let row = rows.iter().find(|row| row.register == register);
    format!("32'h{:08x}", row.expect("the map has all registers").reset)
}

/// The parameter that has the address of a register.
fn address_name(row: &CoreRegisterRow) -> String {
    format!("ADDRESS_{}", row.name.to_uppercase())
}

fn addresses(rows: &[CoreRegisterRow]) -> String {
    lines(rows.iter().map(|row| {
        format!(
            "    localparam {} = {}'h{:03x};",
            address_name(row),
            Core::ADDRESS_BITS,
            row.address
        )
    }))
}

fn counters() -> String {
    let declared = CounterRow::ALL.iter().map(|row| {
        format!(
            "    reg [{}:0] counter_{1};\n    initial counter_{1} = {2}'d0;",
            Core::COUNTER_BITS - 1,
            row.name,
            Core::COUNTER_BITS
        )
    });
    lines(declared)
}

/// What a counter counts in a clock: the wire that has it, and the part of the template that has the wire's highest bit; `None`
/// for the clock itself.
fn counted(counter: CoreCounter) -> Option<(&'static str, Bits)> {
    use CoreCounter as C;
    let bit = |wire| Some((wire, Bits::One));
    match counter {
        C::Clocks => None,
        C::BusyClocks => bit("busy"),
        C::LeavesRead => bit("leaf_given"),
        C::QueriesRead => bit("query_given"),
        C::Results => bit("result_moves"),
        C::LeavesCompared => Some(("compared", Bits::Leaves)),
        C::LeavesWanted => Some(("wanted", Bits::Leaves)),
        C::GroupsPlayed => Some(("played", Bits::Groups)),
        C::PhotonsInRange => Some(("result_photons", Bits::Photons)),
        C::PhotonStalls => bit("photon_waits"),
        C::QueryStalls => bit("query_waits"),
        C::ResultStalls => bit("result_waits"),
        C::LeavesMalformed => bit("leaf_malformed"),
        C::LeavesRefused => bit("leaf_refused"),
        C::QueriesOutside => bit("query_outside"),
        C::QueriesRefused => bit("query_refused"),
        C::AccessesRefused => Some((REFUSED, Bits::Accesses)),
    }
}

/// The bits of what is counted in a clock.
#[derive(Copy, Clone)]
enum Bits {
    One,
    /// A read and a write.
    Accesses,
    /// Two leaves of each chain.
    Leaves,
    /// A group of each chain.
    Groups,
    /// The count of a result.
    Photons,
}

impl Bits {
    fn number(self, core: &Core) -> u32 {
        let for_at_most = |most: u32| u32::BITS - most.leading_zeros();
        match self {
            Self::One => 1,
            Self::Accesses => for_at_most(2),
            Self::Leaves => for_at_most(Leaf::PAIR as u32 * core.chains),
            Self::Groups => for_at_most(core.chains),
            Self::Photons => Widths::of(core.machine).count,
        }
    }
}

/// The accesses that are refused. What was refused in the clock before is known from the answers, which are registers.
const REFUSED: &str = "refused";

/// A line for each register of what happened in the clock before, made of the wire's name and its bits.
fn seen(core: &Core, line: impl Fn(&str, u32) -> String) -> String {
    let counted = CounterRow::ALL
        .iter()
        .filter_map(|row| counted(row.counter));
    let mut wires: Vec<_> = counted.filter(|(wire, _)| *wire != REFUSED).collect();
    for row in EventRow::ALL {
        let wire = cause(row.event);
        if wire != REFUSED && wires.iter().all(|(counted, _)| *counted != wire) {
            wires.push((wire, Bits::One));
        }
    }
    lines(
        wires
            .iter()
            .map(|(wire, bits)| line(wire, bits.number(core))),
    )
}

/// What a counter is increased by.
fn increment(counter: CoreCounter) -> String {
    counted(counter).map_or("1'b1".to_owned(), |(wire, _)| format!("seen_{wire}"))
}

fn counter_lines(line: impl Fn(&CounterRow) -> String) -> String {
    lines(
        CounterRow::ALL
            .iter()
            .map(|row| format!("            {}", line(row))),
    )
}

/// The wire by which an event occurs.
fn cause(event: CoreEvent) -> &'static str {
    use CoreEvent as E;
    match event {
        E::Done => "ends",
        E::LeafMalformed => "leaf_malformed",
        E::SetTooLong => "set_too_long",
        E::QueryOutside => "query_outside",
        E::ChainUnknown => "chain_unknown",
        E::AccessRefused => REFUSED,
        E::Stalled => "stalls",
    }
}

/// The condition of each event, in the order of their bits.
fn events() -> String {
    lines(EventRow::ALL.iter().map(|row| {
        let event = row.event;
        format!(
            "    assign occurred[{}] = |seen_{};",
            event as u32,
            cause(event)
        )
    }))
}

/// The value of a register when it is read.
fn value(row: &CoreRegisterRow) -> String {
    use CoreRegister as R;
    let counter = |counter| format!("counter_{}", counter_name(counter));
    match row.register {
        R::Identity | R::Version | R::DigestLow | R::DigestHigh | R::Shape => {
            format!("32'h{:08x}", row.reset)
        }
        R::Control => "32'd0".to_owned(),
        R::Status => "{28'd0, result_waits, query_waits, photon_waits, busy}".to_owned(),
        R::Events => format!(
            "{{{}'d0, events}}",
            u32::BITS as usize - EventRow::ALL.len()
        ),
        R::InterruptEnable => format!(
            "{{{}'d0, interrupt_enable}}",
            u32::BITS as usize - EventRow::ALL.len()
        ),
        R::StallLimit => "stall_limit".to_owned(),
        R::UnderWay => format!(
            "{{{}'d0, under_way}}",
            Core::REGISTER_BITS - Core::UNDER_WAY_BITS
        ),
        R::CounterLow(of) => format!("{}[31:0]", counter(of)),
        R::CounterHigh(_) => format!(
            "{{{}'d0, counter_high}}",
            2 * Core::REGISTER_BITS - Core::COUNTER_BITS
        ),
        R::Nearest | R::Rungs | R::Rung(_) => rounds::value(row),
    }
}

/// For each register, whether a read has its address.
fn selects(rows: &[CoreRegisterRow]) -> String {
    let numbered = rows.iter().enumerate();
    lines(numbered.map(|(number, row)| {
        format!(
            "        selected[{number}] <= read_address == {};",
            address_name(row)
        )
    }))
}

/// The parts of the word of the selected register. Each has registers that follow each other, so it can stand beside them.
fn finds(rows: &[CoreRegisterRow]) -> String {
    let numbered: Vec<_> = rows.iter().enumerate().collect();
    let parts = numbered.chunks(rows.len().div_ceil(READ_PARTS)).enumerate();
    lines(parts.map(|(part, rows)| {
        let terms = rows.iter().map(|(number, row)| {
            format!(
                "\n            | ({{32{{selected[{number}]}}}} & {})",
                value(row)
            )
        });
        format!(
            "        found_{part} <= 32'd0{};",
            terms.collect::<String>()
        )
    }))
}

/// For each low word of a counter a term, made of the counter's name and whether the word is selected.
fn of_counters(rows: &[CoreRegisterRow], term: impl Fn(&str, String) -> String) -> String {
    let numbered = rows.iter().enumerate();
    lines(numbered.filter_map(|(number, row)| {
        let CoreRegister::CounterLow(counter) = row.register else {
            return None;
        };
        let term = term(counter_name(counter), format!("selected[{number}]"));
        Some(format!("        | {term}"))
    }))
}

/// The high bits of a counter, where its low word is selected.
fn high_copy(counter: &str, selected: String) -> String {
    let high = Core::COUNTER_BITS - 1;
    format!(
        "({{{}{{{selected}}}}} & counter_{counter}[{high}:32])",
        Core::COUNTER_BITS - Core::REGISTER_BITS
    )
}

fn counter_name(counter: CoreCounter) -> &'static str {
    let row = CounterRow::ALL.iter().find(|row| row.counter == counter);
    row.expect("the table has all counters").name
}

fn writable(rows: &[CoreRegisterRow]) -> String {
    let rows = rows.iter().filter(|row| row.access != Access::Read);
    lines(rows.map(|row| format!("            {}: write_known = 1'b1;", address_name(row))))
}

fn lines(lines: impl Iterator<Item = String>) -> String {
    lines.collect::<Vec<_>>().join("\n")
}
