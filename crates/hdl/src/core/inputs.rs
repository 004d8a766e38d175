//! The streams of leaves and queries, up to where their words leave for the chains.

use std::fmt::Write as _;

use photoncube_spec::{Core, Spatial, StreamWord};

use super::top::{Sizes, part, range, slice};

/// The photon stream up to the chains.
pub(super) fn photons(core: &Core, word: &StreamWord, sizes: &Sizes) -> String {
    let end = word.end();
    let width = sizes.photon_slice + core.chains;
    let mut text = format!(
        "\n    // Leaves: a slice, then to the chain of their number.\n    wire {}leaf_word;\n    wire leaf_valid;\n    wire leaf_ready;\n    \
         wire photon_slice_ready;\n    \
         // No word is taken in the clock of a reset.\n    \
         assign s_axis_photons_tready = photon_slice_ready & ~reset;\n",
        range(width)
    );
    text += &slice(
        core,
        "photon",
        [width, width - end],
        [
            "s_axis_photons_tvalid",
            "photon_slice_ready",
            &format!(
                "{{{}, s_axis_photons_tdest, s_axis_photons_tlast, s_axis_photons_tdata[{}:0]}}",
                is_for(core, "s_axis_photons_tdest"),
                end - 1
            ),
        ],
        ["leaf_valid", "leaf_ready", "leaf_word"],
    );
    text + &leaf_fields(core, end, sizes) + &photon_ports(core, sizes) + &leaf_out(sizes)
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
         // Which chain it is for, if there is that chain.\n    \
         wire {}leaf_is_for = {};\n",
        range(chain),
        end + chain,
        end + 1,
        range(photons),
        present.join(", "),
        photons - 1,
        photons / 2,
        photons - 1,
        photons - 2,
        vector(core),
        chosen(core, "leaf_word", sizes.photon_slice),
    )
}

/// A module for each chain, which says whether the leaf goes to it.
fn photon_ports(core: &Core, sizes: &Sizes) -> String {
    let mut text = vectors(
        core,
        &[
            "leaf_readies",
            "leaves_given",
            "leaves_refused",
            "sets_too_long",
        ],
    );
    for chain in 0..core.chains {
        let _ = writeln!(text, "    wire leaf_taken_{chain};");
        let _ = writeln!(
            text,
            "    {}_photon_port #(.NUMBER({}), .PLACE({}), .STAGES({})) photon_port_{chain}(.clock(aclk), .reset(reset),\n        \
             .leaf_valid(leaf_valid & leaf_is_for[{chain}]), .leaf_last(leaf_last), .leaf_ready(leaf_readies[{chain}]),\n        \
             .leaf_given(leaves_given[{chain}]), .leaf_refused(leaves_refused[{chain}]), .set_too_long(sets_too_long[{chain}]),\n        \
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
fn leaf_out(sizes: &Sizes) -> String {
    let group = sizes.group;
    format!(
        "    assign leaf_ready = ~(|leaf_is_for) | (|(leaf_is_for & leaf_readies));\n    \
         wire leaf_given = |leaves_given;\n    \
         wire leaf_unknown = leaf_valid & ~(|leaf_is_for);\n    \
         wire leaf_refused = leaf_unknown | (|leaves_refused);\n    \
         wire set_too_long = |sets_too_long;\n    \
         // The second group follows the first by a clock.\n    \
         reg {}second_group;\n    \
         always @(posedge aclk) second_group <= leaf_word[{}:{group}];\n    \
         wire {}leaf_out = {{leaf_chain, leaf_has_second, leaf_last, {},\n        \
         second_group, leaf_word[{}:0]}};\n",
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
        query, query_slice, ..
    } = *sizes;
    let width = query_slice + core.chains;
    let mut text = format!(
        "\n    // Queries: a slice, then to the chain of their number.\n    \
         wire {}query_word;\n    \
         wire query_valid;\n    \
         wire query_ready;\n    \
         wire query_slice_ready;\n    \
         assign s_axis_queries_tready = query_slice_ready & ~reset;\n    \
         // A bit that no field has is 1: the coordinate is too large for the frame.\n    \
         wire query_in_outside = |{{{}}};\n",
        range(width),
        gaps(word).join(", "),
    );
    text += &slice(
        core,
        "query",
        [width, width - query],
        [
            "s_axis_queries_tvalid",
            "query_slice_ready",
            &format!(
                "{{{}, s_axis_queries_tdest, query_in_outside, s_axis_queries_tlast, s_axis_queries_tdata[{}:0]}}",
                is_for(core, "s_axis_queries_tdest"),
                query - 1
            ),
        ],
        ["query_valid", "query_ready", "query_word"],
    );
    text += &vectors(core, &["query_readies", "queries_given"]);
    let _ = write!(
        text,
        "    wire query_is_outside = query_word[{}];\n    \
         wire {}query_is_for = {};\n    \
         assign query_ready = ~(|query_is_for) | (|(query_is_for & query_readies));\n    \
         wire query_given = |queries_given;\n    \
         wire query_refused = query_valid & ~(|query_is_for);\n    \
         wire query_outside = query_given & query_is_outside;\n",
        query + 1,
        vector(core),
        chosen(core, "query_word", query_slice),
    );
    for chain in 0..core.chains {
        let _ = writeln!(
            text,
            "    wire query_taken_{chain};\n    \
             {}_link #(.BITS({}), .STAGES({})) query_link_{chain}(.clock(aclk), .reset(reset),\n        \
             .in_valid(query_valid & query_is_for[{chain}]), .in_ready(query_readies[{chain}]),\n        \
             .moves(queries_given[{chain}]), .taken(query_taken_{chain}));",
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

/// The range of a vector with a bit for each chain. It is one also where there is a single chain, so that a bit can be named.
fn vector(core: &Core) -> String {
    format!("[{}:0] ", core.chains - 1)
}

/// Wires with a bit for each chain.
fn vectors(core: &Core, names: &[&str]) -> String {
    let wires = names.iter();
    wires
        .map(|name| format!("    wire {}{name};\n", vector(core)))
        .collect()
}

/// For each chain whether a number is its own.
fn is_for(core: &Core, number: &str) -> String {
    let bits = core.chain_bits();
    let own = (0..core.chains).rev();
    let own = own.map(|chain| format!("{number} == {bits}'d{chain}"));
    format!("{{{}}}", own.collect::<Vec<_>>().join(", "))
}

/// The bits of all chains in a slice's word, from `low` on.
fn chosen(core: &Core, word: &str, low: u32) -> String {
    format!("{word}[{}:{low}]", low + core.chains - 1)
}
