//! The module with the registers of a core, behind AXI4-Lite.

use std::fmt::Write as _;

use photoncube_spec::{
    Access, Core, CoreCounter, CoreEvent, CoreRegister, CoreRegisterRow, CounterRow, EventRow,
    Widths,
};

/// The fixed part of the module, in which the tables below are put.
const TEMPLATE: &str = include_str!("registers.v");

/// The module of a core whose configuration has this digest.
pub(super) fn registers(core: &Core, digest: u64) -> String {
    let rows = CoreRegister::all(core, digest);
    let sum_bits = |most: u32| u32::BITS - most.leading_zeros();
    let parts = [
        ("TOP", core.top()),
        ("ADDRESS_HIGH", (Core::ADDRESS_BITS - 1).to_string()),
        ("COUNTER_HIGH", (Core::COUNTER_BITS - 1).to_string()),
        ("UNDER_WAY_BITS", Core::UNDER_WAY_BITS.to_string()),
        ("UNDER_WAY_HIGH", (Core::UNDER_WAY_BITS - 1).to_string()),
        ("EVENT_HIGH", (EventRow::ALL.len() - 1).to_string()),
        (
            "COUNT_HIGH",
            (Widths::of(core.machine).count - 1).to_string(),
        ),
        ("LEAVES_HIGH", (sum_bits(2 * core.chains) - 1).to_string()),
        ("GROUPS_HIGH", (sum_bits(core.chains) - 1).to_string()),
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
        ("READS", reads(&rows)),
        ("HIGH_COPIES", high_copies(&rows)),
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

/// What a counter is increased by in a clock.
fn increment(counter: CoreCounter) -> &'static str {
    use CoreCounter as C;
    match counter {
        C::Clocks => "1'b1",
        C::BusyClocks => "busy",
        C::LeavesRead => "leaf_given",
        C::QueriesRead => "query_given",
        C::Results => "result_moves",
        C::LeavesCompared => "seen_compared",
        C::LeavesWanted => "seen_wanted",
        C::GroupsPlayed => "seen_played",
        C::PhotonsInRange => "result_photons",
        C::PhotonStalls => "photon_waits",
        C::QueryStalls => "query_waits",
        C::ResultStalls => "result_waits",
        C::LeavesMalformed => "leaf_malformed",
        C::LeavesRefused => "leaf_refused",
        C::QueriesOutside => "query_outside",
        C::QueriesRefused => "query_refused",
        C::AccessesRefused => "refused",
    }
}

fn counter_lines(line: impl Fn(&CounterRow) -> String) -> String {
    lines(
        CounterRow::ALL
            .iter()
            .map(|row| format!("            {}", line(row))),
    )
}

/// The condition of each event, in the order of their bits.
fn events() -> String {
    use CoreEvent as E;
    let condition = |event| match event {
        E::Done => "ends",
        E::LeafMalformed => "leaf_malformed",
        E::SetTooLong => "set_too_long",
        E::QueryOutside => "query_outside",
        E::ChainUnknown => "chain_unknown",
        E::AccessRefused => "|refused",
        E::Stalled => "stalls",
    };
    lines(EventRow::ALL.iter().map(|row| {
        format!(
            "    assign occurs[{}] = {};",
            row.event as u32,
            condition(row.event)
        )
    }))
}

/// The value of a register when it is read.
fn value(row: &CoreRegisterRow) -> String {
    use CoreRegister as R;
    let counter = |counter: CoreCounter| {
        let row = CounterRow::ALL.iter().find(|row| row.counter == counter);
        format!("counter_{}", row.expect("the table has all counters").name)
    };
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
    }
}

fn reads(rows: &[CoreRegisterRow]) -> String {
    lines(rows.iter().map(|row| {
        format!(
            "            {}: read_word = {};",
            address_name(row),
            value(row)
        )
    }))
}

fn high_copies(rows: &[CoreRegisterRow]) -> String {
    let mut text = String::new();
    for row in rows {
        if let CoreRegister::CounterLow(counter) = row.register {
            let counter = CounterRow::ALL.iter().find(|row| row.counter == counter);
            let name = counter.expect("the table has all counters").name;
            let _ = writeln!(
                text,
                "            {}: counter_high_next = counter_{name}[{}:32];",
                address_name(row),
                Core::COUNTER_BITS - 1
            );
        }
    }
    text.trim_end().to_owned()
}

fn writable(rows: &[CoreRegisterRow]) -> String {
    let rows = rows.iter().filter(|row| row.access != Access::Read);
    lines(rows.map(|row| format!("            {}: write_known = 1'b1;", address_name(row))))
}

fn lines(lines: impl Iterator<Item = String>) -> String {
    lines.collect::<Vec<_>>().join("\n")
}
