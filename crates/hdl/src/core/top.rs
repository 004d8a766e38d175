//! The top module of a core: the streams to and from the chains.

use std::fmt::Write as _;

use photoncube_spec::{Core, CoreStreams, Leaf, Port, Spatial, StreamWord};

use super::chain::chain_text;
use super::results::results;
use super::rounds;

/// The bits of each word in the core. A slice's word has the chain's number and the flags of its stream beside the fields.
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
            query,
            query_slice: query + 2 + chain,
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
    if core.has_radii() {
        text += &rounds::wires(core);
    }
    text += &photons(core, &streams.photons, &sizes);
    text += &queries(core, &streams.queries, &sizes);
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

/// Whether there is the chain of a number; not asked where every number has one.
fn is_known(core: &Core, number: &str) -> String {
    match core.chains == 1 << core.chain_bits() {
        true => "1'b1".to_owned(),
        false => format!("{number} < {}'d{}", core.chain_bits(), core.chains),
    }
}

/// For each chain an expression, chosen by a number.
fn of_chain(core: &Core, number: &str, expression: impl Fn(u32) -> String) -> String {
    let bits = core.chain_bits();
    let chosen = (0..core.chains)
        .map(|chain| format!("(({number} == {bits}'d{chain}) & {})", expression(chain)));
    chosen.collect::<Vec<_>>().join("\n        | ")
}

/// The expression of an or over all chains.
fn any(core: &Core, name: &str) -> String {
    let names = (0..core.chains).map(|chain| format!("{name}_{chain}"));
    names.collect::<Vec<_>>().join(" | ")
}

/// An instance of the slice of a stream.
pub(super) fn slice(
    core: &Core,
    stream: &str,
    width: u32,
    [valid, ready, word]: [&str; 3],
    out: [&str; 3],
) -> String {
    let [out_valid, out_ready, out_word] = out;
    format!(
        "    {}_slice #(.WIDTH({width})) {stream}_slice(.clock(aclk), .reset(reset),\n        \
         .in_valid({valid}), .in_ready({ready}), .in_word({word}),\n        \
         .out_valid({out_valid}), .out_ready({out_ready}), .out_word({out_word}));\n",
        core.top()
    )
}

/// The photon stream up to the chains.
fn photons(core: &Core, word: &StreamWord, sizes: &Sizes) -> String {
    let end = word.end();
    let Sizes {
        chain,
        group,
        photon_slice,
        ..
    } = *sizes;
    let lane = group / Spatial::LANES as u32;
    let mut text = format!(
        "\n    // Leaves: a slice, then to the chain of their number.\n    wire {}leaf_word;\n    wire leaf_valid;\n    wire leaf_ready;\n",
        range(photon_slice)
    );
    text += &slice(
        core,
        "photon",
        photon_slice,
        [
            "s_axis_photons_tvalid",
            "s_axis_photons_tready",
            &format!(
                "{{s_axis_photons_tdest, s_axis_photons_tlast, s_axis_photons_tdata[{}:0]}}",
                end - 1
            ),
        ],
        ["leaf_valid", "leaf_ready", "leaf_word"],
    );
    let present: Vec<_> = (0..Core::LEAF_PHOTONS as u32)
        .rev()
        .map(|photon| format!("leaf_word[{}]", photon * lane))
        .collect();
    let photons = Core::LEAF_PHOTONS as u32;
    let _ = write!(
        text,
        "    wire leaf_last = leaf_word[{end}];\n    \
         wire {}leaf_chain = leaf_word[{}:{}];\n    \
         wire {}leaf_present = {{{}}};\n    \
         wire leaf_has_second = |leaf_present[{}:{}];\n    \
         // A photon behind an absent one.\n    \
         wire leaf_has_gap = |(leaf_present[{}:1] & ~leaf_present[{}:0]);\n    \
         wire leaf_known = {};\n",
        range(chain),
        end + chain,
        end + 1,
        range(photons),
        present.join(", "),
        photons - 1,
        photons / 2,
        photons - 1,
        photons - 2,
        is_known(core, "leaf_chain"),
    );
    for name in ["leaf_ready", "leaf_given", "leaf_refused", "set_too_long"] {
        for chain in 0..core.chains {
            let _ = writeln!(text, "    wire {name}_{chain};");
        }
    }
    let _ = write!(
        text,
        "    assign leaf_ready = ~leaf_known\n        | {};\n    \
         wire leaf_given = {};\n    \
         wire leaf_unknown = leaf_valid & ~leaf_known;\n    \
         wire leaf_refused = leaf_unknown | {};\n    \
         wire set_too_long = {};\n",
        of_chain(core, "leaf_chain", |chain| format!("leaf_ready_{chain}")),
        any(core, "leaf_given"),
        any(core, "leaf_refused"),
        any(core, "set_too_long"),
    );
    text
}

/// The query stream up to the chains.
fn queries(core: &Core, word: &StreamWord, sizes: &Sizes) -> String {
    let Sizes {
        chain,
        query,
        query_slice,
        ..
    } = *sizes;
    let mut text = format!(
        "\n    // Queries: a slice, then to the chain of their number.\n    \
         wire {}query_word;\n    \
         wire query_valid;\n    \
         wire query_ready;\n    \
         // A bit that no field has is 1: the coordinate is too large for the frame.\n    \
         wire query_in_outside = |{{{}}};\n",
        range(query_slice),
        gaps(word).join(", "),
    );
    text += &slice(
        core,
        "query",
        query_slice,
        [
            "s_axis_queries_tvalid",
            "s_axis_queries_tready",
            &format!(
                "{{s_axis_queries_tdest, query_in_outside, s_axis_queries_tlast, s_axis_queries_tdata[{}:0]}}",
                query - 1
            ),
        ],
        ["query_valid", "query_ready", "query_word"],
    );
    for name in ["query_ready", "query_given"] {
        for chain in 0..core.chains {
            let _ = writeln!(text, "    wire {name}_{chain};");
        }
    }
    let _ = write!(
        text,
        "    wire query_is_outside = query_word[{}];\n    \
         wire {}query_chain = query_word[{}:{}];\n    \
         wire query_known = {};\n    \
         assign query_ready = ~query_known\n        | {};\n    \
         wire query_given = {};\n    \
         wire query_refused = query_valid & ~query_known;\n    \
         wire query_outside = query_given & query_is_outside;\n",
        query + 1,
        range(chain),
        query + 1 + chain,
        query + 2,
        is_known(core, "query_chain"),
        of_chain(core, "query_chain", |chain| format!("query_ready_{chain}")),
        any(core, "query_given"),
    );
    text
}

/// The bits of a query's `tdata` that no field has.
fn gaps(word: &StreamWord) -> Vec<String> {
    let mut gaps = Vec::new();
    let mut next = 0;
    let ends = word
        .fields
        .iter()
        .map(|field| (field.low, field.low + field.width));
    for (low, end) in ends.chain([(word.bits, word.bits)]) {
        if low > next {
            gaps.push(format!("s_axis_queries_tdata[{}:{next}]", low - 1));
        }
        next = end;
    }
    gaps
}

/// What all chains do in a clock.
fn sums_over_chains(core: &Core) -> String {
    let bits = |most: u32| u32::BITS - most.leading_zeros();
    let sum = |name: &str| {
        let names = (0..core.chains).map(|chain| format!("{name}_{chain}"));
        names.collect::<Vec<_>>().join(" + ")
    };
    let wire =
        |name: &str, most: u32| format!("    wire {}{name} = {};\n", range(bits(most)), sum(name));
    let (leaves, groups) = (Leaf::PAIR as u32 * core.chains, core.chains);
    format!(
        "\n    // What happens in a clock, for the counters.\n{}{}{}",
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
