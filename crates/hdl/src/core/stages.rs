//! The ways of leaves and queries from their slices to the queues in front of the chains.
//!
//! A stream's way has a stage for each chain, one behind the other. Each gives its word to the queue of its chain, if the word is for that, and
//! to the next stage. So no wire is longer than from one chain to the next.

use photoncube_spec::{Core, Leaf};

use super::top::{QUERY_FLAGS, Sizes, part, range};

/// A chain's stage. Its words come from the stage of the chain before; those of the first come from the wire `out`, where they are given.
fn stage(core: &Core, word: &str, out: &str, width: u32, chain: u32) -> String {
    let (valid_in, word_in) = match chain {
        0 => (format!("{word}_given"), out.to_owned()),
        _ => (
            format!("{word}_passes_{}", chain - 1),
            format!("{word}_stage_{}", chain - 1),
        ),
    };
    format!(
        "    wire {word}_passes_{chain};\n    \
         wire {}{word}_stage_{chain};\n    \
         {}_stage #(.WIDTH({width})) {word}_stage_{chain}_register(.clock(aclk), .reset(reset),\n        \
         .in_valid({valid_in}), .in_word({word_in}), .out_valid({word}_passes_{chain}), .out_word({word}_stage_{chain}));\n",
        range(width),
        core.top(),
    )
}

/// Whether the word in a stage is for its chain. The chain's number is above `low`.
fn comes(core: &Core, word: &str, low: u32, chain: u32) -> String {
    let bits = core.chain_bits();
    let number = part(low, bits, &format!("{word}_stage_{chain}"));
    format!("{word}_passes_{chain} & ({number} == {bits}'d{chain})")
}

/// The way of leaves to a chain.
pub(super) fn leaves(core: &Core, sizes: &Sizes, chain: u32) -> String {
    let Sizes {
        group,
        facing,
        photon_stage,
        ..
    } = *sizes;
    let word = format!("leaf_stage_{chain}");
    let last = 2 * group + facing;
    stage(core, "leaf", "leaf_out", photon_stage, chain)
        + &format!(
            "    {}_photon_queue #(.GROUP({group}), .FACING({facing}), .PLACE({})) photon_queue_{chain}(.clock(aclk), .reset(reset),\n        \
             .leaf_valid({}), .leaf_has_second({word}[{}]),\n        \
             .leaf_last({word}[{last}]), .leaf_facing({}), .first({word}[{}:0]), .second({word}[{}:{group}]),\n        \
             .leaf_taken(leaf_taken_{chain}), .group_valid(group_valid_{chain}), .group_ready(group_ready_{chain}),\n        \
             .group_last(group_last_{chain}), .group_facing(group_facing_{chain}), .group(group_{chain}));\n",
            core.top(),
            (Core::LEAF_PLACES * Leaf::GROUPS as u32).ilog2(),
            comes(core, "leaf", last + 2, chain),
            last + 1,
            part(2 * group, facing, &word),
            group - 1,
            2 * group - 1,
        )
}

/// The way of queries to a chain, or to its store of batches.
pub(super) fn queries(core: &Core, sizes: &Sizes, chain: u32) -> String {
    let Sizes {
        query, query_slice, ..
    } = *sizes;
    let fields = query + QUERY_FLAGS;
    let query_word = part(0, query_slice, "query_word");
    stage(core, "query", &query_word, query_slice, chain)
        + &format!(
            "    wire queued_valid_{chain};\n    \
             wire queued_ready_{chain};\n    \
             wire {}queued_{chain};\n    \
             assign query_taken_{chain} = queued_valid_{chain} & queued_ready_{chain};\n    \
             {}_queue #(.WIDTH({fields}), .PLACE({})) query_queue_{chain}(.clock(aclk), .reset(reset),\n        \
             .in_valid({}), .in_word(query_stage_{chain}[{}:0]),\n        \
             .out_valid(queued_valid_{chain}), .out_ready(queued_ready_{chain}), .out_word(queued_{chain}));\n",
            range(fields),
            core.top(),
            Core::QUERY_PLACES.ilog2(),
            comes(core, "query", fields, chain),
            fields - 1,
        )
}
