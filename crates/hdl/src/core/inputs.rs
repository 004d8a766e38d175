//! The streams of leaves and queries, up to where their words leave for the chains.

use std::fmt::Write as _;

use photoncube_spec::{Core, Spatial, StreamWord};

use super::top::{Sizes, part, range, slice};

/// The photon stream up to the chains.
pub(super) fn photons(core: &Core, word: &StreamWord, sizes: &Sizes) -> String {
    let end = word.end();
    let photon_slice = sizes.photon_slice;
    let mut text = format!(
        "\n    // Leaves: a slice, then to the chain of their number.\n    wire {}leaf_word;\n    wire leaf_valid;\n    wire leaf_ready;\n    \
         wire photon_slice_ready;\n    \
         // No word is taken in the clock of a reset.\n    \
         assign s_axis_photons_tready = photon_slice_ready & ~reset;\n",
        range(photon_slice)
    );
    text += &slice(
        core,
        "photon",
        photon_slice,
        [
            "s_axis_photons_tvalid",
            "photon_slice_ready",
            &format!(
                "{{s_axis_photons_tdest, s_axis_photons_tlast, s_axis_photons_tdata[{}:0]}}",
                end - 1
            ),
        ],
        ["leaf_valid", "leaf_ready", "leaf_word"],
    );
    text + &leaf_fields(core, end, sizes) + &photon_ports(core, sizes) + &leaf_out(core, sizes)
}

/// The parts of the leaf in the slice, whose last photon ends at `end`.
fn leaf_fields(core: &Core, end: u32, sizes: &Sizes) -> String {
    let chain = sizes.chain;
    let lane = sizes.group / Spatial::LANES as u32;
    let present: Vec<_> = (0..Core::LEAF_PHOTONS as u32)
        .rev()
        .map(|photon| format!("leaf_word[{}]", photon * lane))
        .collect();
    let photons = Core::LEAF_PHOTONS as u32;
    format!(
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
    )
}

/// A module for each chain, which says whether the leaf goes to it.
fn photon_ports(core: &Core, sizes: &Sizes) -> String {
    let bits = sizes.chain;
    let mut text = String::new();
    for chain in 0..core.chains {
        for name in [
            "leaf_ready",
            "leaf_given",
            "leaf_refused",
            "set_too_long",
            "leaf_taken",
        ] {
            let _ = writeln!(text, "    wire {name}_{chain};");
        }
        let _ = writeln!(
            text,
            "    {}_photon_port #(.NUMBER({}), .PLACE({}), .STAGES({})) photon_port_{chain}(.clock(aclk), .reset(reset),\n        \
             .leaf_valid(leaf_valid & (leaf_chain == {bits}'d{chain})), .leaf_last(leaf_last), .leaf_ready(leaf_ready_{chain}),\n        \
             .leaf_given(leaf_given_{chain}), .leaf_refused(leaf_refused_{chain}), .set_too_long(set_too_long_{chain}),\n        \
             .leaf_taken(leaf_taken_{chain}));",
            core.top(),
            sizes.number,
            Core::LEAF_PLACES.ilog2(),
            core.stages(chain),
        );
    }
    text
}

/// The leaf as it leaves the slice for the first stage.
fn leaf_out(core: &Core, sizes: &Sizes) -> String {
    let group = sizes.group;
    format!(
        "    assign leaf_ready = ~leaf_known\n        | {};\n    \
         wire leaf_given = {};\n    \
         wire leaf_unknown = leaf_valid & ~leaf_known;\n    \
         wire leaf_refused = leaf_unknown | {};\n    \
         wire set_too_long = {};\n    \
         // The second group follows the first by a clock.\n    \
         reg {}second_group;\n    \
         always @(posedge aclk) second_group <= leaf_word[{}:{group}];\n    \
         wire {}leaf_out = {{leaf_chain, leaf_has_second, leaf_last, {},\n        \
         second_group, leaf_word[{}:0]}};\n",
        of_chain(core, "leaf_chain", |chain| format!("leaf_ready_{chain}")),
        any(core, "leaf_given"),
        any(core, "leaf_refused"),
        any(core, "set_too_long"),
        range(group),
        2 * group - 1,
        range(sizes.photon_stage),
        part(2 * group, sizes.facing, "leaf_word"),
        group - 1,
    )
}

/// The query stream up to the chains.
pub(super) fn queries(core: &Core, word: &StreamWord, sizes: &Sizes) -> String {
    let Sizes {
        chain: bits,
        query,
        query_slice,
        ..
    } = *sizes;
    let mut text = format!(
        "\n    // Queries: a slice, then to the chain of their number.\n    \
         wire {}query_word;\n    \
         wire query_valid;\n    \
         wire query_ready;\n    \
         wire query_slice_ready;\n    \
         assign s_axis_queries_tready = query_slice_ready & ~reset;\n    \
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
            "query_slice_ready",
            &format!(
                "{{s_axis_queries_tdest, query_in_outside, s_axis_queries_tlast, s_axis_queries_tdata[{}:0]}}",
                query - 1
            ),
        ],
        ["query_valid", "query_ready", "query_word"],
    );
    for chain in 0..core.chains {
        for name in ["query_ready", "query_given", "query_taken"] {
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
        range(bits),
        query + 1 + bits,
        query + 2,
        is_known(core, "query_chain"),
        of_chain(core, "query_chain", |chain| format!("query_ready_{chain}")),
        any(core, "query_given"),
    );
    for chain in 0..core.chains {
        let _ = writeln!(
            text,
            "    {}_link #(.BITS({}), .STAGES({})) query_link_{chain}(.clock(aclk), .reset(reset),\n        \
             .in_valid(query_valid & (query_chain == {bits}'d{chain})), .in_ready(query_ready_{chain}),\n        \
             .moves(query_given_{chain}), .taken(query_taken_{chain}));",
            core.top(),
            Core::QUERY_PLACES.ilog2() + 1,
            core.stages(chain),
        );
    }
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
