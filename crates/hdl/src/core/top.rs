//! The top module of a core.

use std::fmt::Write as _;

use photoncube_spec::{Core, CoreStreams, Leaf, Port};

use super::chain::chain_text;
use super::results::results;
use super::{inputs, rounds};

/// The flags above the fields of a query: `tlast`, and whether a bit without a field is 1.
pub(super) const QUERY_FLAGS: u32 = 2;

/// The bits of each word in the core. A slice's word has the chain's number and the flags of its stream beside the fields, and above
/// all that, where it comes from a port, a bit for each chain.
pub(super) struct Sizes {
    /// A chain's number.
    pub(super) chain: u32,
    /// A group of four photons.
    pub(super) group: u32,
    /// A leaf's facing.
    pub(super) facing: u32,
    /// The number of a leaf in its set.
    pub(super) number: u32,
    /// The word in the slice of photons: a leaf, `tlast`, the chain.
    pub(super) photon_slice: u32,
    /// The word in a stage of the way of leaves: the first group of a leaf, the second of the one before, the facing, `tlast`, whether the
    /// second has a photon, the chain.
    pub(super) photon_stage: u32,
    /// The fields of a query.
    pub(super) query: u32,
    /// The word in the slice of queries: a query, `tlast`, whether a bit without a field is 1, the chain.
    pub(super) query_slice: u32,
    /// The sums and the count of a result.
    pub(super) sums: u32,
    /// The word in the slice of results: the fields, `tlast`, whether the query is outside, the chain, and in a core with rounds whether it
    /// is the query's last.
    pub(super) result_slice: u32,
}

impl Sizes {
    fn of(core: &Core, streams: &CoreStreams) -> Self {
        let chain = core.chain_bits();
        let group = streams.photons.field("facing").low / Leaf::GROUPS as u32;
        let sums = streams.results.field("tag").low;
        let query = streams.queries.end();
        Self {
            chain,
            group,
            facing: Leaf::FACING_BITS,
            number: core.set_leaves().ilog2(),
            photon_slice: streams.photons.end() + 1 + chain,
            photon_stage: streams.photons.end() + 2 + chain,
            query,
            query_slice: query + QUERY_FLAGS + chain,
            sums,
            result_slice: streams.results.end() + 2 + chain + u32::from(core.has_radii()),
        }
    }
}

/// The top module. `machine` is the module of a chain.
pub(super) fn top(core: &Core, machine: &str) -> String {
    let streams = CoreStreams::of(core);
    let sizes = Sizes::of(core, &streams);
    let mut text = head(core);
    text += "    wire reset;\n";
    text += &rounds::wires(core);
    text += &inputs::photons(core, &streams.photons, &sizes);
    text += &inputs::queries(core, &streams.queries, &sizes);
    for chain in 0..core.chains {
        text += &chain_text(core, &streams, &sizes, machine, chain);
    }
    text += &results(core, &streams, &sizes);
    text += &sums_over_chains(core);
    text += &register_instance(core);
    text + "endmodule\n"
}

pub(super) fn range(width: u32) -> String {
    match width {
        1 => String::new(),
        more => format!("[{}:0] ", more - 1),
    }
}

/// The head of the module, with its ports.
fn head(core: &Core) -> String {
    let ports = core.ports();
    let names: Vec<_> = ports.iter().map(|port| port.name.as_str()).collect();
    let names: Vec<_> = names.chunks(4).map(|names| names.join(", ")).collect();
    let mut text = format!("module {}({});\n", core.top(), names.join(",\n    "));
    for Port {
        direction,
        name,
        width,
        ..
    } in &ports
    {
        let _ = writeln!(
            text,
            "    {} wire {}{name};",
            direction.name(),
            range(*width)
        );
    }
    text
}

/// An instance of the slice of a stream. The flags that decide where a word goes are its `head` highest bits.
pub(super) fn slice(
    core: &Core,
    stream: &str,
    [width, head]: [u32; 2],
    [valid, ready, word]: [&str; 3],
    out: [&str; 3],
) -> String {
    let [out_valid, out_ready, out_word] = out;
    format!(
        "    {}_slice #(.WIDTH({width}), .HEAD({head})) {stream}_slice(.clock(aclk), .reset(reset),\n        \
         .in_valid({valid}), .in_ready({ready}), .in_word({word}),\n        \
         .out_valid({out_valid}), .out_ready({out_ready}), .out_word({out_word}));\n",
        core.top()
    )
}

/// What all chains did in the clock before.
fn sums_over_chains(core: &Core) -> String {
    let bits = |most: u32| u32::BITS - most.leading_zeros();
    let sum = |name: &str| {
        let names = (0..core.chains).map(|chain| format!("{name}_before_{chain}"));
        names.collect::<Vec<_>>().join(" + ")
    };
    let wire = |name: &str, most: u32| {
        let width = bits(most);
        format!(
            "    wire {}{name} = reset ? {width}'d0 : {};\n",
            range(width),
            sum(name)
        )
    };
    let (leaves, groups) = (Leaf::PAIR as u32 * core.chains, core.chains);
    format!(
        "\n    // What the chains did in the clock before, for the counters.\n{}{}{}",
        wire("compared", leaves),
        wire("wanted", leaves),
        wire("played", groups)
    )
}

/// The instance of the registers: each of its ports has the name of a wire or port here.
fn register_instance(core: &Core) -> String {
    let ports = core.ports();
    let of_axi = ports.iter().map(|port| port.name.as_str());
    let of_axi = of_axi.filter(|name| {
        (name.starts_with("s_axi_") && !name.ends_with("prot")) || ["aresetn", "irq"].contains(name)
    });
    let wires = [
        "reset",
        "result_moves",
        "result_photons",
        "leaf_given",
        "leaf_refused",
        "set_too_long",
        "query_given",
        "query_refused",
        "query_outside",
        "compared",
        "wanted",
        "played",
    ];
    let of_rounds = ["result_ends", "nearest", "rungs", "radii"];
    let of_rounds = of_rounds.into_iter().filter(|_| core.has_radii());
    let named = of_axi
        .chain(wires)
        .chain(of_rounds)
        .map(|name| (name, name.to_owned()));
    let expressions = [
        ("clock", "aclk"),
        (
            "photon_moves",
            "s_axis_photons_tvalid & s_axis_photons_tready",
        ),
        (
            "photon_waits",
            "s_axis_photons_tvalid & ~s_axis_photons_tready",
        ),
        (
            "query_moves",
            "s_axis_queries_tvalid & s_axis_queries_tready",
        ),
        (
            "query_waits",
            "s_axis_queries_tvalid & ~s_axis_queries_tready",
        ),
        (
            "result_waits",
            "m_axis_results_tvalid & ~m_axis_results_tready",
        ),
        ("leaf_malformed", "leaf_given & leaf_has_gap"),
        ("chain_unknown", "leaf_unknown | query_refused"),
    ];
    let expressions = expressions.map(|(name, text)| (name, text.to_owned()));
    let all = named.chain(expressions);
    let all: Vec<_> = all
        .map(|(name, text)| format!("        .{name}({text})"))
        .collect();
    format!(
        "    {}_registers registers(\n{});\n",
        core.top(),
        all.join(",\n")
    )
}

/// The bits of a word from `low` on.
pub(super) fn part(low: u32, width: u32, word: &str) -> String {
    match width {
        1 => format!("{word}[{low}]"),
        more => format!("{word}[{}:{low}]", low + more - 1),
    }
}
