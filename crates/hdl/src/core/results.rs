//! The results of the chains, up to their port.

use std::fmt::Write as _;

use photoncube_spec::{Core, CoreStreams};

use super::top::{Sizes, part, range, slice};

/// The results of the chains up to the port.
pub(super) fn results(core: &Core, streams: &CoreStreams, sizes: &Sizes) -> String {
    let Sizes {
        chain: bits,
        sums,
        result_slice,
        ..
    } = *sizes;
    let end = streams.results.end();
    let count = streams.results.field("count");
    let mut text = String::from(
        "\n    // Results: each chain's are merged with those of the chains behind it, then a slice.\n    wire unused_ready;\n",
    );
    for chain in (0..core.chains).rev() {
        text += &merge(core, sizes, chain);
    }
    let (last, outside) = (end, end + 1);
    let _ = write!(
        text,
        "    // The sums of a query outside of its frame are 0.\n    \
         wire result_outside = result_merged_0[{outside}];\n    \
         wire {}result_seen = result_outside ? {{{sums}{{1'b0}}}} : result_merged_0[{}:0];\n    \
         wire result_waits;\n    \
         wire {}result_word;\n",
        range(sums),
        sums - 1,
        range(result_slice),
    );
    text += &slice(
        core,
        "result",
        [result_slice, result_slice - end],
        [
            "result_comes_0",
            "result_goes_0",
            &format!(
                "{{result_merged_0[{}:{sums}], result_seen}}",
                result_slice - 1
            ),
        ],
        ["result_waits", "m_axis_results_tready", "result_word"],
    );
    let padding = match streams.results.bits - end {
        0 => String::new(),
        bits => format!("{bits}'d0, "),
    };
    let _ = write!(
        text,
        "    // A result of before a reset is not given in the clock of the reset.\n    \
         assign m_axis_results_tvalid = result_waits & ~reset;\n    \
         assign m_axis_results_tdata = {{{padding}result_word[{}:0]}};\n    \
         assign m_axis_results_tlast = result_word[{last}];\n    \
         assign m_axis_results_tuser = result_word[{outside}];\n    \
         assign m_axis_results_tid = result_word[{}:{}];\n    \
         wire result_moves = m_axis_results_tvalid & m_axis_results_tready;\n    \
         wire {}result_photons = result_moves ? {} : {}'d0;\n",
        end - 1,
        end + 1 + bits,
        end + 2,
        range(count.width),
        part(count.low, count.width, "result_word"),
        count.width,
    );
    if core.has_radii() {
        let _ = writeln!(
            text,
            "    wire result_ends = result_moves & result_word[{}];",
            end + 2 + bits
        );
    }
    text
}

/// The results of a chain and of those behind it.
fn merge(core: &Core, sizes: &Sizes, chain: u32) -> String {
    let (bits, width) = (core.chain_bits(), sizes.result_slice);
    let [is_last, radius] = match core.has_radii() {
        true => [
            format!("result_last_{chain}, "),
            format!("result_radius_{chain}, "),
        ],
        false => [String::new(), String::new()],
    };
    let tag = format!("result_tag_{chain}");
    let (last, outside, tag_high) = (Core::LAST_BIT, Core::OUTSIDE_BIT, Core::TAG_BITS - 1);
    let own = format!(
        "{{{is_last}{bits}'d{chain}, {tag}[{outside}], {tag}[{last}], {radius}{tag}[{tag_high}:0], result_sums_{chain}}}"
    );
    let behind = chain + 1;
    let [passing_valid, passing_ready, passing_word] = match behind < core.chains {
        true => [
            format!("result_comes_{behind}"),
            format!("result_goes_{behind}"),
            format!("result_merged_{behind}"),
        ],
        // Lints ask for a wire at each pin, and for no use of one whose name says that it has none.
        false => [
            "1'b0".to_owned(),
            "unused_ready".to_owned(),
            format!("{width}'d0"),
        ],
    };
    format!(
        "    wire result_comes_{chain};\n    \
         wire result_goes_{chain};\n    \
         wire {}result_merged_{chain};\n    \
         {}_merge #(.WIDTH({width})) merge_{chain}(.clock(aclk), .reset(reset),\n        \
         .own_valid(result_valid_{chain}), .own_ready(result_ready_{chain}),\n        \
         .own_word({own}),\n        \
         .passing_valid({passing_valid}), .passing_ready({passing_ready}), .passing_word({passing_word}),\n        \
         .out_valid(result_comes_{chain}), .out_ready(result_goes_{chain}), .out_word(result_merged_{chain}));\n",
        range(width),
        core.top(),
    )
}
