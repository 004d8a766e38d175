//! The module that gives a chain each batch several times, and its registers.

use std::fmt::Write as _;

use photoncube_spec::{Core, CoreField, CoreRegister, CoreRegisterRow, CoreStreams, Leaf, Rounds};

use super::top::{QUERY_FLAGS, Sizes, range};

const TEMPLATE: &str = include_str!("rounds.v");

/// The module; nothing where all queries have the format's radius.
pub(super) fn module(core: &Core) -> Option<String> {
    Rounds::of(core)?;
    let parts = [
        ("TOP", core.top()),
        ("PLACES", Rounds::BATCHES.to_string()),
        ("PLACE", Rounds::BATCHES.ilog2().to_string()),
        ("ROUND", Rounds::ROUND_BITS.to_string()),
        ("RUNGS", Rounds::RUNGS.to_string()),
        ("RUNGS_BITS", Rounds::RUNGS_BITS.to_string()),
        ("RUNGS_HIGH", (Rounds::RUNGS_BITS - 1).to_string()),
        ("RUNG_HIGH", (Rounds::RUNGS.ilog2() - 1).to_string()),
    ];
    let replaced = parts
        .iter()
        .fold(TEMPLATE.to_owned(), |text, (name, part)| {
            text.replace(&format!("@{name}@"), part)
        });
    Some(replaced)
}

/// The way of queries from their slice to a chain and of its results to their place, through the store of batches.
pub(super) fn ways(
    core: &Core,
    streams: &CoreStreams,
    sizes: &Sizes,
    chain: u32,
) -> Option<String> {
    let rounds = Rounds::of(core)?;
    let top = core.top();
    let Sizes { query, sums, .. } = *sizes;
    let radius = streams.queries.field("radius_sq");
    let count = streams.results.field("count");
    let last_position = core.engines() as u32 - 1;
    let position = (u32::BITS - last_position.leading_zeros()).max(1);
    let found = sums + Leaf::TAG_BITS;
    let shown = found + radius.width + 1;
    let mut text = String::new();
    for (name, width) in [
        ("given_valid", 1),
        ("given_ready", 1),
        ("given", query + QUERY_FLAGS),
        ("found_valid", 1),
        ("found_ready", 1),
        ("found", found),
        ("shown_valid", 1),
        ("shown_ready", 1),
        ("shown", shown),
        ("result_radius", radius.width),
        ("result_last", 1),
    ] {
        let _ = writeln!(text, "    wire {}{name}_{chain};", range(width));
    }
    text += &format!(
        "    {top}_rounds #(.QUERY({query}), .RADIUS_LOW({}), .RADIUS({}), .SUMS({sums}), .COUNT_LOW({}), .COUNT({}), .TAG({}),\n        \
         .POSITION({position}), .LAST_POSITION({last_position}), .LARGEST({}), .NEAREST_ROUNDS({})) rounds_{chain}(.clock(aclk), .reset(reset),\n        \
         .nearest(nearest), .rungs(rungs), .radii(rung_radii),\n        \
         .query_valid(queued_valid_{chain}), .query_ready(queued_ready_{chain}), .query(queued_{chain}),\n        \
         .given_valid(given_valid_{chain}), .given_ready(given_ready_{chain}), .given(given_{chain}),\n        \
         .found_valid(found_valid_{chain}), .found_ready(found_ready_{chain}), .found(found_{chain}),\n        \
         .result_valid(shown_valid_{chain}), .result_ready(shown_ready_{chain}), .result(shown_{chain}));\n    \
         {top}_slice #(.WIDTH({}), .HEAD({})) query_slice_{chain}(.clock(aclk), .reset(reset),\n        \
         .in_valid(given_valid_{chain}), .in_ready(given_ready_{chain}), .in_word(given_{chain}),\n        \
         .out_valid(chain_query_valid_{chain}), .out_ready(chain_query_ready_{chain}), .out_word(query_{chain}));\n    \
         {top}_place #(.WIDTH({found})) found_place_{chain}(.clock(aclk), .reset(reset),\n        \
         .in_valid(chain_result_valid_{chain}), .in_ready(chain_result_ready_{chain}),\n        \
         .in_word({{chain_tag_{chain}, chain_sums_{chain}}}), .out_valid(found_valid_{chain}),\n        \
         .out_ready(found_ready_{chain}), .out_word(found_{chain}));\n    \
         {top}_place #(.WIDTH({shown})) result_place_{chain}(.clock(aclk), .reset(reset),\n        \
         .in_valid(shown_valid_{chain}), .in_ready(shown_ready_{chain}), .in_word(shown_{chain}),\n        \
         .out_valid(result_valid_{chain}), .out_ready(result_ready_{chain}),\n        \
         .out_word({{result_last_{chain}, result_radius_{chain}, result_tag_{chain}, result_sums_{chain}}}));\n",
        radius.low,
        radius.width,
        count.low,
        count.width,
        Leaf::TAG_BITS,
        rounds.largest,
        rounds.nearest,
        query + QUERY_FLAGS,
        QUERY_FLAGS,
    );
    Some(text)
}

/// The wires of the registers in the top module, and the registers of the rungs' radii that the stores are given. Each of these is at
/// most the largest radius. The comparison is here, once, because it would lengthen the slowest path of each store.
pub(super) fn wires(core: &Core) -> String {
    let Some(rounds) = Rounds::of(core) else {
        return String::new();
    };
    let ports = outputs(core).map(|(name, width)| format!("    wire {}{name};\n", range(width)));
    let mut text: String = ports.collect();
    let width = field(core, CoreRegister::Rung(0)).width;
    let all = range(Rounds::RUNGS * width);
    text += &format!(
        "    localparam LARGEST_RADIUS = {width}'d{};\n    reg {all}rung_radii;\n    initial rung_radii = {}'d0;\n    \
         always @(posedge aclk) begin\n",
        rounds.largest,
        Rounds::RUNGS * width
    );
    for rung in 0..Rounds::RUNGS {
        let bits = format!("[{}:{}]", width * (rung + 1) - 1, width * rung);
        let _ = writeln!(
            text,
            "        rung_radii{bits} <= (radii{bits} > LARGEST_RADIUS) ? LARGEST_RADIUS : radii{bits};"
        );
    }
    text + "    end\n"
}

/// The values of the registers that go to the stores: their names and bits.
fn outputs(core: &Core) -> impl Iterator<Item = (&'static str, u32)> {
    let width = |register| field(core, register).width;
    [
        ("nearest", width(CoreRegister::Nearest)),
        ("rungs", width(CoreRegister::Rungs)),
        ("radii", Rounds::RUNGS * width(CoreRegister::Rung(0))),
    ]
    .into_iter()
}

/// The field of a register.
fn field(core: &Core, register: CoreRegister) -> CoreField {
    // The digest changes no field.
    let rows = CoreRegister::all(core, 0);
    let row = rows.iter().find(|row| row.register == register);
    row.expect("the map of a core with rounds has all registers")
        .fields[0]
}

/// The ports of the module of registers.
pub(super) const PORTS: &str = ",\n    result_ends, nearest, rungs, radii";

/// Their declarations. The registers of the rungs are side by side.
pub(super) fn declarations(core: &Core) -> String {
    let mut text = "\n    input wire result_ends;".to_owned();
    for (name, width) in outputs(core) {
        let _ = write!(
            text,
            "\n    output reg {}{name};\n    initial {name} = {width}'d0;",
            range(width)
        );
    }
    text
}

/// The rows of the registers, each with the text of its bits and their number.
fn bits(core: &Core) -> impl Iterator<Item = (CoreRegisterRow, String, u32)> {
    let rows = CoreRegister::all(core, 0).into_iter();
    rows.filter_map(|row| {
        let width = row.fields.first()?.width;
        bits_of(&row).map(|bits| (row, bits, width))
    })
}

/// The bits of a register of the rounds.
fn bits_of(row: &CoreRegisterRow) -> Option<String> {
    match row.register {
        CoreRegister::Nearest => Some("nearest".to_owned()),
        CoreRegister::Rungs => Some("rungs".to_owned()),
        CoreRegister::Rung(rung) => {
            let width = row.fields[0].width;
            Some(format!(
                "radii[{}:{}]",
                width * (rung + 1) - 1,
                width * rung
            ))
        }
        _ => None,
    }
}

/// The writes of the registers.
pub(super) fn writes(core: &Core) -> String {
    let write = |(row, bits, width): (CoreRegisterRow, String, u32)| {
        let high = width - 1;
        format!(
            "\n        if (writes & (write_address == ADDRESS_{})) {bits} <= ({bits} & ~write_mask[{high}:0]) | write_word[{high}:0];",
            row.name.to_uppercase()
        )
    };
    bits(core).map(write).collect()
}

/// Their values after `aresetn`.
pub(super) fn resets(core: &Core) -> String {
    let reset = |(name, width)| format!("\n            {name} <= {width}'d0;");
    outputs(core).map(reset).collect()
}

/// The value of a register when it is read.
pub(super) fn value(row: &CoreRegisterRow) -> String {
    let bits = bits_of(row).expect("a register of the rounds");
    format!(
        "{{{}'d0, {bits}}}",
        Core::REGISTER_BITS - row.fields[0].width
    )
}
