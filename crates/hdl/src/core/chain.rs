//! A chain, and the way of groups to it.

use std::fmt::Write as _;

use photoncube_spec::{Core, CoreStreams, Leaf};

use super::top::{QUERY_FLAGS, Sizes, part, range};
use super::{rounds, stages};

/// A chain, and the way of groups to it.
pub(super) fn chain_text(
    core: &Core,
    streams: &CoreStreams,
    sizes: &Sizes,
    machine: &str,
    chain: u32,
) -> String {
    let Sizes {
        group,
        facing,
        query,
        sums,
        ..
    } = *sizes;
    let tag = streams.queries.field("tag").low;
    let ways =
        rounds::ways(core, streams, sizes, chain).unwrap_or_else(|| ways(core, sizes, chain));
    let leaves = stages::leaves(core, sizes, chain);
    let queries = stages::queries(core, sizes, chain);
    let mut text = format!(
        "\n    // Chain {chain}.\n    \
         wire group_valid_{chain};\n    \
         wire group_ready_{chain};\n    \
         wire group_last_{chain};\n    \
         wire {}group_facing_{chain};\n    \
         wire {}group_{chain};\n    \
         wire result_valid_{chain};\n    \
         wire result_ready_{chain};\n    \
         wire {}result_sums_{chain};\n    \
         wire {}result_tag_{chain};\n    \
         wire chain_query_valid_{chain};\n    \
         wire chain_query_ready_{chain};\n    \
         wire {}query_{chain};\n    \
         wire chain_result_valid_{chain};\n    \
         wire chain_result_ready_{chain};\n    \
         wire {}chain_sums_{chain};\n    \
         wire {}chain_tag_{chain};\n    \
         wire [1:0] compared_{chain};\n    \
         wire [1:0] wanted_{chain};\n    \
         wire played_{chain};\n    \
         reg [1:0] compared_before_{chain};\n    \
         reg [1:0] wanted_before_{chain};\n    \
         reg played_before_{chain};\n    \
         initial compared_before_{chain} = 2'd0;\n    \
         initial wanted_before_{chain} = 2'd0;\n    \
         initial played_before_{chain} = 1'b0;\n    \
         always @(posedge aclk) begin\n        \
         compared_before_{chain} <= reset ? 2'd0 : compared_{chain};\n        \
         wanted_before_{chain} <= reset ? 2'd0 : wanted_{chain};\n        \
         played_before_{chain} <= reset ? 1'b0 : played_{chain};\n    \
         end\n{leaves}{queries}{ways}    \
         {machine} chain_{chain}(.clock(aclk), .reset(reset),\n        \
         .query_valid(chain_query_valid_{chain}), .query_ready(chain_query_ready_{chain}), .query_last(query_{chain}[{query}]),\n        \
         .query_tag({{query_{chain}[{}:{query}], {}}}),\n",
        range(facing),
        range(group),
        range(sums),
        range(Leaf::TAG_BITS),
        range(query + QUERY_FLAGS),
        range(sums),
        range(Leaf::TAG_BITS),
        query + 1,
        part(tag, Core::TAG_BITS, &format!("query_{chain}")),
    );
    let radius = core.has_radii().then_some(("query_radius_sq", "radius_sq"));
    let pins = [
        ("query_x", "x"),
        ("query_y", "y"),
        ("query_z", "z"),
        ("query_facings", "facings"),
        ("query_release", "release"),
    ];
    for (pin, field) in pins.into_iter().chain(radius) {
        let field = streams.queries.field(field);
        let _ = writeln!(
            text,
            "        .{pin}({}),",
            part(field.low, field.width, &format!("query_{chain}"))
        );
    }
    let _ = writeln!(
        text,
        "        .group_valid(group_valid_{chain}), .group_ready(group_ready_{chain}), .group_last(group_last_{chain}), .group_facing(group_facing_{chain}),"
    );
    for field in streams
        .photons
        .fields
        .iter()
        .filter(|field| field.low < group)
    {
        let _ = writeln!(
            text,
            "        .photon_{}({}),",
            field.name,
            part(field.low, field.width, &format!("group_{chain}"))
        );
    }
    let results = streams
        .results
        .fields
        .iter()
        .filter(|field| field.low < sums);
    for field in results {
        let _ = writeln!(
            text,
            "        .result_{}({}),",
            field.name,
            part(field.low, field.width, &format!("chain_sums_{chain}"))
        );
    }
    text + &format!(
        "        .result_valid(chain_result_valid_{chain}), .result_ready(chain_result_ready_{chain}), .result_tag(chain_tag_{chain}),\n        \
         .compared(compared_{chain}), .wanted(wanted_{chain}), .played(played_{chain}));\n"
    )
}

/// The way of queries to a chain and of its results to their place, where a chain is given each query once.
fn ways(core: &Core, sizes: &Sizes, chain: u32) -> String {
    let sums = sizes.sums;
    let top = core.top();
    format!(
        "    \
         assign chain_query_valid_{chain} = queued_valid_{chain};\n    \
         assign queued_ready_{chain} = chain_query_ready_{chain};\n    \
         assign query_{chain} = queued_{chain};\n    \
         {top}_place #(.WIDTH({})) result_place_{chain}(.clock(aclk), .reset(reset),\n        \
         .in_valid(chain_result_valid_{chain}), .in_ready(chain_result_ready_{chain}),\n        \
         .in_word({{chain_tag_{chain}, chain_sums_{chain}}}), .out_valid(result_valid_{chain}),\n        \
         .out_ready(result_ready_{chain}), .out_word({{result_tag_{chain}, result_sums_{chain}}}));\n",
        sums + Leaf::TAG_BITS,
    )
}
